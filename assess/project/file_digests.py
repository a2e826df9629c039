"""The SHA-256 of input files, read again only where size or time of the file have changed."""

from __future__ import annotations

import hashlib
from functools import lru_cache
from pathlib import Path


def file_sha256(path: Path) -> str:
    """Return the SHA-256 of a file.

    Raises
    ------
    OSError : there is no such file, or it cannot be read
    """
    status = path.stat()
    return _sha256(path.absolute(), status.st_size, status.st_mtime_ns, status.st_ino)


@lru_cache(maxsize=4096)
def _sha256(path: Path, size: int, mtime: int, number: int) -> str:
    """Return the SHA-256 of a file of this size, time of change [ns] and number on its disk."""
    with path.open("rb") as opened:
        return hashlib.file_digest(opened, "sha256").hexdigest()
