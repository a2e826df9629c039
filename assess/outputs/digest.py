"""The SHA-256 of a file, which tells whether it was changed."""

from __future__ import annotations

import hashlib
from pathlib import Path


def digest(path: Path) -> str | None:
    """Return the SHA-256 of a file; None if there is no such file, "" if it is not a regular file or cannot be read."""
    try:
        with path.open("rb") as opened:
            return hashlib.file_digest(opened, "sha256").hexdigest()
    except FileNotFoundError:
        return "" if path.is_symlink() else None
    except OSError:
        return ""
