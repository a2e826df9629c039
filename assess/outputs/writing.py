"""Files written whole or not at all: a set of files into a folder, or one file that the user names.

One command at a time writes into a folder, and files of others are never touched.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path

from assess.errors import OutputError
from assess.messages.message import Message
from assess.outputs import journal
from assess.outputs.journal import MADE, Move, Tell, files_in, flush, keep_beside, make_stage, recover, remove_abandoned
from assess.outputs.lock import hold_lock
from assess.outputs.manifest import MANIFEST, RESULTS, Manifest, digest, link_above, read, state
from assess.outputs.signals import defer_signals

_MOST_NAMES = 5  # of files in an error


def _ignore(_: Message) -> None:
    pass


@contextmanager
def output_folder(
    folder: Path,
    *,
    command: str,
    owner: str = RESULTS,
    expected: Sequence[str] = (),
    tell: Tell = _ignore,
    patient: bool = False,
) -> Iterator[Path]:
    """Give a temporary folder; after the block, its files are moved into `folder`, unless the block raised.

    Parameters
    ----------
    folder : Path
        The folder to write into; made if absent.
    command : str
        The command that writes there, named to other commands meanwhile.
    owner : str
        The set that the files make up, of `assess.outputs.manifest`. Files of the set that are not made again are
        removed, except the results it is named after.
    expected : sequence of str
        Names of files that are certain to come.
    tell : callable
        Called with a message on what was recovered in the folder.
    patient : bool
        Whether to wait a while for another command that is writing there.

    Yields
    ------
    Path
        The temporary folder.

    Raises
    ------
    OutputError
        At once, if the folder cannot be written or holds files that may not be replaced.
    """
    with make_folder(folder), hold_lock(folder, command=command, patient=patient):
        recover(folder, tell=tell)
        manifest = read(folder)
        refuse_obstacles(folder, manifest, owner, expected)
        with make_stage(folder, command=command) as place:
            yield place / MADE
            _commit(place, folder, manifest, owner)


def refuse_obstacles(folder: Path, manifest: Manifest, owner: str, expected: Sequence[str]) -> None:
    """Raise OutputError if a folder holds files that may not be replaced or removed.

    Parameters
    ----------
    folder : Path
        The folder.
    manifest : Manifest
        Of the folder.
    owner : str
        The set of files to be written.
    expected : sequence of str
        Names of files that are certain to come.
    """
    _refuse(folder, _obstacles(folder, manifest, owner, expected))


@contextmanager
def make_folder(folder: Path) -> Iterator[None]:
    """Make the folder and its parents if absent; remove again those that stay empty."""
    if folder.exists() and not folder.is_dir():
        raise OutputError(f"{folder}: is a file; give a folder for the output")
    absent = [place for place in (folder, *folder.parents) if not place.exists()]
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OutputError(f"{folder}: cannot be made ({error.strerror}); give another folder") from None
    try:
        yield
    finally:
        with suppress(OSError):
            for place in absent:
                place.rmdir()


def _obstacles(folder: Path, manifest: Manifest, owner: str, expected: Sequence[str]) -> dict[str, str]:
    """Return why files in the folder cannot be replaced or removed, by name.

    expected : files to be written; other files of the set are to be removed, except its results
    """
    ours = manifest.files_of(owner)
    found = {}
    for name in [*expected, *(name for name in ours if name not in expected and name != owner)]:
        path = folder / name
        if path.is_dir():
            found[name] = "is a folder where a file is to be written"
        elif link_above(path, folder):
            found[name] = "is to be written where a link leads out of the folder"
        elif name not in ours and (path.exists() or path.is_symlink()):
            found[name] = "was not written by assess, or by another of its commands"
        elif name in ours and state(path, ours[name]) == "changed":
            found[name] = "was changed since assess wrote it"
    return found


def _refuse(folder: Path, obstacles: Mapping[str, str], *, kept: str = "") -> None:
    if not obstacles:
        return
    why = next(iter(obstacles.values()))
    names = [str(folder / name) for name, each in obstacles.items() if each == why]
    more = f" and {len(names) - _MOST_NAMES} more" if len(names) > _MOST_NAMES else ""
    listed = ", ".join(names[:_MOST_NAMES])
    raise OutputError(f"{listed}{more}: {why}; move it away, or give another folder with -o{kept}")


def _commit(place: Path, folder: Path, manifest: Manifest, owner: str) -> None:
    """Move what was made into the folder; if that is not possible, leave it beside the folder."""
    made = place / MADE
    files = {name: digest(made / name) for name in files_in(made)}
    kept = {name: old for name, old in manifest.files_of(owner).items() if name == owner and name not in files}
    listed = Manifest({**manifest.sets, owner: {**files, **kept}}).with_present_digests(folder)
    obstacles = _obstacles(folder, manifest, owner, list(files))
    written = listed if not obstacles else Manifest({owner: files})
    (made / MANIFEST).write_text(written.text(), encoding="utf-8", newline="\n")
    if obstacles:
        left = keep_beside(place, folder)
        _refuse(folder, obstacles, kept=f"; nothing there was touched, and what was made is in {left}")
    gone = [name for name in manifest.files_of(owner) if name not in files and name != owner]
    _move_into_place([*files, *gone, *manifest.earlier, MANIFEST], place, folder)


def _move_into_place(names: Sequence[str], place: Path, folder: Path) -> None:
    made = place / MADE
    moves = [Move(name, digest(made / name), digest(folder / name)) for name in names]
    moves = [move for move in moves if move.new != move.old or move.new is not None]
    with defer_signals():  # from here on it is all or nothing
        try:
            for path in (made / name for name in names):
                if path.exists():
                    flush(path)
            journal.begin(place, moves)
            journal.finish(place, folder, moves)
        except OSError as error:
            journal.take_back(place, folder, moves)
            left = keep_beside(place, folder)
            where = error.filename2 or error.filename or folder
            raise OutputError(
                f"{where}: cannot be written ({error.strerror}); nothing in {folder} was changed, and what was made is "
                f"in {left}: close what holds the files there, make room, or give another folder with -o"
            ) from None


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
    with _staged_file(path, command=command) as made:
        yield made
        flush(made)
        _name_finished_file(made, path)


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
    with _staged_file(path, command=command) as made:
        yield made
        flush(made)
        if path.is_file() and is_replaceable(path):
            os.replace(made, path)
            flush(path.parent)
        else:
            _name_finished_file(made, path)


@contextmanager
def _staged_file(path: Path, *, command: str) -> Iterator[Path]:
    """Give a path in a stage beside `path`; raise OutputError where no file can come to be there."""
    if not path.parent.is_dir():
        raise OutputError(f"{path}: there is no folder {path.parent}; make it first")
    if path.is_dir():
        raise OutputError(f"{path}: is a folder; give the name of a file")
    remove_abandoned(path.parent)
    with make_stage(path.parent, command=command) as place:
        yield place / MADE / path.name


def _name_finished_file(made: Path, path: Path) -> None:
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
