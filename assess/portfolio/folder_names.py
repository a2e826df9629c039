"""Names of folders made of keys, which may hold any text."""

from __future__ import annotations

import hashlib
import re

LONGEST = 48  # characters of a key that are kept: paths have an end on Windows
_FIT = re.compile(rf"[a-z0-9][a-z0-9_-]{{0,{LONGEST - 1}}}")
_NOT_KEPT = re.compile(r"[^A-Za-z0-9_]+")
_LIKE_ANOTHER = re.compile(r".*-[0-9a-f]{10}")
_DEVICE = re.compile(r"con|prn|aux|nul|com\d|lpt\d")  # which Windows takes for devices
LOGS = "logs"


def folder_name(key: str) -> str:
    """Return the name of the folder for the outputs of a project.

    A key that is a name on every system stays as it is; any other is shortened to letters, digits and hyphens, and gets
    the beginning of its SHA-256, so that two keys never share a folder, not even on disks that ignore case. The name
    depends on the key alone.

    Parameters
    ----------
    key : str
        Of the project: any text.
    """
    if _FIT.fullmatch(key) and not (_LIKE_ANOTHER.fullmatch(key) or _DEVICE.fullmatch(key) or key == LOGS):
        return key
    kept = _NOT_KEPT.sub("-", key)[:LONGEST].strip("-") or "project"
    return f"{kept}-{hashlib.sha256(key.encode('utf-8', 'surrogatepass')).hexdigest()[:10]}"
