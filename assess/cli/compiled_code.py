"""What --verbose says of the machine code that is kept on disk."""

from __future__ import annotations

import sys


def compiled_since(begin: float) -> str:
    """Return where the code of the kernels is kept and how much of it is new; empty where no kernel was used.

    begin : time in seconds of the epoch
    """
    kernel = sys.modules.get("records.compilation.kernel")
    if kernel is None:
        return ""
    folder = kernel.code_folder()
    if folder is None:
        return "machine code: no folder to keep it in; every process compiles for itself"
    files = list(folder.glob("*.code"))
    new = sum(file.stat().st_mtime >= begin for file in files)
    return f"machine code: {len(files)} kernels in {folder}, {new} compiled now"
