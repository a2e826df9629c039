"""One file that the user names, written whole or not at all, and never over another."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from assess.errors import OutputError
from assess.outputs.digest import digest
from assess.outputs.stage import MADE, clear, flush, stage


@contextmanager
def write_file(path: Path, *, command: str) -> Iterator[Path]:
    """Give a path to write to; after the block the file is moved to `path`, unless the block raised.

    A file that exists already stays; it is an error if its content differs.

    Parameters
    ----------
    path : Path
        The file to be written.
    command : str
        The command that writes it, named to other commands meanwhile.

    Yields
    ------
    Path
        Where to write the file.

    Raises
    ------
    OutputError
        If the folder is absent, or `path` exists with another content.
    """
    with _made(path, command=command) as made:
        yield made
        flush(made)
        _put(made, path)


@contextmanager
def replace_file(path: Path, *, command: str, is_replaceable: Callable[[Path], bool]) -> Iterator[Path]:
    """Give a path to write to; after the block the file takes the place of the one at `path`, unless the block raised.

    Parameters
    ----------
    path : Path
        The file to be written.
    command : str
        The command that writes it, named to other commands meanwhile.
    is_replaceable : callable
        Returns whether the file that exists at `path` is one that this command wrote.

    Yields
    ------
    Path
        Where to write the file.

    Raises
    ------
    OutputError
        If the folder is absent, or `path` exists and may not be replaced.
    """
    with _made(path, command=command) as made:
        yield made
        flush(made)
        if path.is_file() and is_replaceable(path):
            os.replace(made, path)
            flush(path.parent)
        else:
            _put(made, path)


@contextmanager
def _made(path: Path, *, command: str) -> Iterator[Path]:
    """Give a path in a stage beside `path`; raise OutputError where no file can come to be there."""
    if not path.parent.is_dir():
        raise OutputError(f"{path}: there is no folder {path.parent}; make it first")
    if path.is_dir():
        raise OutputError(f"{path}: is a folder; give the name of a file")
    clear(path.parent)
    with stage(path.parent, command=command) as place:
        yield place / MADE / path.name


def _put(made: Path, path: Path) -> None:
    """Give a finished file its name, unless another has it."""
    try:
        os.link(made, path)  # fails where a file is there, even one that came a moment ago
    except FileExistsError:
        _refuse_another(made, path)
    except OSError:  # a disk without links
        if path.exists() or path.is_symlink():
            _refuse_another(made, path)
        else:
            os.replace(made, path)
    flush(path.parent)


def _refuse_another(made: Path, path: Path) -> None:
    if digest(path) != digest(made):
        raise OutputError(f"{path}: is there already and holds something else; move it away, or give another name")
