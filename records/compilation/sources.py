"""What machine code depends on: the sources of all kernels, and what translates them."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from hashlib import sha256
from pathlib import Path

ROOT = Path(__file__).parents[2]
PACKAGES = ("assess", "records")


def sources(root: Path = ROOT) -> list[Path]:
    """List every file named kernel.py or in a folder named kernel, of the packages below `root`, sorted.

    A kernel contains the constants and functions of others, so that a change of any may change them all.
    """
    return sorted(path for package in PACKAGES for path in _kernels(root / package))


def key(versions: tuple[str, ...], root: Path = ROOT) -> str | None:
    """Hash the sources, Python's and the compilers' `versions`; None where the sources cannot be read."""
    digest = sha256(repr((sys.implementation.cache_tag, sys.version, versions)).encode())
    try:
        for path in (found := sources(root)):
            content = path.read_bytes()
            digest.update(f"\n{path.relative_to(root).as_posix()} {len(content)}\n".encode())
            digest.update(content)
    except OSError:
        return None
    return digest.hexdigest()[:32] if found else None


def _kernels(folder: Path) -> Iterator[Path]:
    with os.scandir(folder) as entries:
        for entry in entries:
            if entry.is_dir():
                yield from _kernels(folder / entry.name) if entry.name != "__pycache__" else ()
            elif entry.name == "kernel.py" or (folder.name == "kernel" and entry.name.endswith(".py")):
                yield folder / entry.name
