"""Where machine code is kept between runs: one folder for all kernels, here because each of them can reach it.

The folder is the user's own, as machine code is run as it is found: nobody else may own it or write to it. Its name is
the hash of what the code depends on: the sources of all kernels, and what translates them.
"""

from __future__ import annotations

import os
import re
import shutil
import stat
import sys
import tempfile
import time
from collections.abc import Iterator
from hashlib import sha256
from pathlib import Path

CACHE_NAME = "rocking-assess"
CACHE_KEY = re.compile(r"[0-9a-f]{32}")
UNUSED = 30 * 86400.0  # s, after which the code of another version is deleted


def find_folder(key: str, *, given: str, user: str) -> Path | None:
    """Find the private folder for the code of `key`, made if there is none; None where no place is private.

    given : by NUMBA_CACHE_DIR, "" if not set; user : the user's folder for caches. Then the one for temporary files.
    """
    for place in _possible_folders(given, user):
        if not is_private(place):
            continue
        folder = place / key
        new = not folder.exists()
        if is_private(folder):
            if new:
                remove_unused(place)
            os.utime(folder)  # in use, for other versions that look for folders to delete
            return folder
    return None


def is_private(folder: Path) -> bool:
    """Return whether `folder`, made if need be, is a folder of the user's, writable by no one else."""
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        folder.mkdir(mode=0o700, exist_ok=True)
        status = folder.lstat()
        if not stat.S_ISDIR(status.st_mode) or not os.access(folder, os.R_OK | os.W_OK | os.X_OK):
            return False
        if os.name == "posix":
            if status.st_uid != os.getuid() or status.st_mode & 0o022:
                return False
            if status.st_mode & 0o077:
                folder.chmod(0o700)
    except OSError:
        return False
    return True


def remove_unused(place: Path) -> None:
    """Delete code in `place` that no process has started with for a month.

    A process that still uses it finds its files missing, compiles again, and cannot write: none of that is an error.
    """
    try:
        for folder in place.iterdir():
            if CACHE_KEY.fullmatch(folder.name) and time.time() - folder.lstat().st_mtime > UNUSED:
                shutil.rmtree(folder, ignore_errors=True)
    except OSError:
        return


def _possible_folders(given: str, user: str) -> Iterator[Path]:
    if given:
        yield Path(given).absolute() / CACHE_NAME
    if os.path.isabs(user) and _is_users(Path(user)):
        yield Path(user)
    try:
        yield Path(tempfile.gettempdir()) / (f"{CACHE_NAME}-{os.getuid()}" if os.name == "posix" else CACHE_NAME)
    except OSError:  # no folder for temporary files
        return


def _is_users(folder: Path) -> bool:
    """Return whether the nearest folder that exists is the user's: not so in the home of another, as under sudo."""
    there = next(one for one in (folder, *folder.parents) if one.exists())
    return os.name != "posix" or there.stat().st_uid == os.getuid()


ROOT = Path(__file__).parents[2]
PACKAGES = ("assess", "records")


def sources(root: Path = ROOT) -> list[Path]:
    """List every file named kernel.py or in a folder named kernel, of the packages below `root`, sorted.

    A kernel contains the constants and functions of others, so that a change of any may change them all.
    """
    return sorted(path for package in PACKAGES for path in _kernels(root / package))


def sources_key(versions: tuple[str, ...], root: Path = ROOT) -> str | None:
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
