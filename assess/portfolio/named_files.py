"""The hash of a project with every file that it names."""

from __future__ import annotations

import hashlib
import tomllib
from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache
from glob import escape, glob
from pathlib import Path
from typing import Any

LONGEST = 1000  # characters of a text that may be a path
LOCK = ".toml"  # how a file of [records] ends that names files itself: the lock of a suite
FilesHash = Callable[[Mapping[str, Any], Path], str]


def files_hash() -> FilesHash:
    """Return a function of a project's tables and folder: the hash of the files that they name.

    Each file is read once, however many projects name it.
    """
    digest = lru_cache(maxsize=None)(_digest)

    @lru_cache(maxsize=100_000)
    def named(text: str, folder: Path, of_records: bool) -> bytes:
        files = _files(text, folder, of_records=of_records)
        locked = (each for file in files if of_records and file.suffix == LOCK for each in _files_of_lock(file))
        return b"".join(map(digest, (*files, *locked)))

    def hash_of(tables: Mapping[str, Any], folder: Path) -> str:
        found = hashlib.sha256()
        for text, of_records in _texts(tables):
            found.update(named(text, folder, of_records))
        return found.hexdigest()

    return hash_of


def _texts(tables: Mapping[str, Any]) -> Iterator[tuple[str, bool]]:
    """Yield every text of a project, and whether it stands in [records]."""
    for name, value in tables.items():
        for text in _leaves(value):
            if text and len(text) <= LONGEST and "\0" not in text and "\n" not in text:
                yield text, name == "records"


def _leaves(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, Mapping):
        for each in value.values():
            yield from _leaves(each)
    elif isinstance(value, list):
        for each in value:
            yield from _leaves(each)


def _files(text: str, folder: Path, *, of_records: bool) -> list[Path]:
    """Return the files that a text names; only [records] has patterns and folders."""
    path = folder / text
    try:
        if path.is_file():
            return [path]
    except OSError:  # too long for a name, or in a folder that may not be read
        return []
    if not of_records:
        return []
    if path.is_dir():
        below = (each for each in path.rglob("*") if not each.name.startswith("."))
        return sorted(each for each in below if each.is_file())
    return sorted(each for each in map(Path, glob(str(Path(escape(str(folder))) / text), recursive=True)))


def _files_of_lock(lock: Path) -> list[Path]:
    """Return the files that a lock names, beside it; none if it cannot be read, which the run of the project tells."""
    try:
        tables = tomllib.loads(lock.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError):
        return []
    return [file for text, _ in _texts(tables) for file in _files(text, lock.parent, of_records=False)]


def _digest(path: Path) -> bytes:
    """Return the name and the hash of a file; of the name alone if it cannot be read."""
    try:
        with path.open("rb") as file:
            content = hashlib.file_digest(file, "sha256").digest()
    except OSError:
        content = b""
    return hashlib.sha256(str(path).encode("utf-8", "surrogateescape") + b"\0" + content).digest()
