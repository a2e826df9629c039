"""Files written whole or not at all: a set of files into a folder, or one file that the user names.

One command at a time writes into a folder, and files of others are never touched. The files are made in a stage, a
hidden folder on the same disk, which holds the new ones in `made`. A journal written there lists every move with the
SHA-256 of the new and of the old file; only then are files moved, replaced ones into `old`. Every step can be repeated:
the next command that finds a stage with a journal finishes the moves, or takes them back if the folder was changed
meanwhile. A stage without a journal was never finished, or is done with.
"""

from __future__ import annotations

import errno
import json
import os
import shutil
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from secrets import token_hex

from assess.errors import FullDiskError, OutputError, ProjectError
from assess.messages.message import Message, note
from assess.outputs.lock import LOCK, hold_lock, is_abandoned
from assess.outputs.manifest import MANIFEST, RESULTS, Manifest, digest, link_above, read, state, stays_inside
from assess.outputs.signals import defer_signals

PREFIX = ".assess-partial-"
MADE, OLD, JOURNAL = "made", "old", "journal.json"
FULL = (errno.ENOSPC, errno.EDQUOT)
_MOST_NAMES = 5  # of files in an error
_DAY = 86400.0  # s
TellMessage = Callable[[Message], None]


def _ignore(_: Message) -> None:
    pass


@contextmanager
def output_folder(
    folder: Path,
    *,
    command: str,
    owner: str = RESULTS,
    expected: Sequence[str] = (),
    tell: TellMessage = _ignore,
    patient: bool = False,
) -> Iterator[Path]:
    """Give a temporary folder; after the block, its files are moved into `folder`, unless the block raised.

    Parameters
    ----------
    folder : the folder to write into; made if absent
    command : the command that writes there, named to other commands meanwhile
    owner : the set that the files make up, of `assess.outputs.manifest`. Files of the set that are not made again are
        removed, except the results it is named after.
    expected : names of files that are certain to come
    tell : called with a message on what was recovered in the folder
    patient : whether to wait a while for another command that is writing there

    Yields
    ------
    Path
        The temporary folder.

    Raises
    ------
    OutputError : at once, if the folder cannot be written or holds files that may not be replaced
    """
    with make_folder(folder), tell_full_disk(folder), hold_lock(folder, command=command, patient=patient):
        _recover(folder, tell=tell)
        manifest = read(folder)
        refuse_obstacles(folder, manifest, owner, expected)
        with make_stage(folder, command=command) as place:
            yield place / MADE
            _commit(place, folder, manifest, owner)


@contextmanager
def write_file(path: Path, *, command: str) -> Iterator[Path]:
    """Give a path to write to; after the block the file is moved to `path`, unless the block raised.

    A file that exists already stays; it is an error if its content differs.

    Parameters
    ----------
    path : the file to be written
    command : the command that writes it, named to other commands meanwhile

    Yields
    ------
    Path
        Where to write the file.

    Raises
    ------
    OutputError : if the folder is absent, or `path` exists with another content
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
    path : the file to be written
    command : the command that writes it, named to other commands meanwhile
    is_replaceable : returns whether the file that exists at `path` is one that this command wrote

    Yields
    ------
    Path
        Where to write the file.

    Raises
    ------
    OutputError : if the folder is absent, or `path` exists and may not be replaced
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
def make_folder(folder: Path) -> Iterator[None]:
    """Make the folder and its parents if absent; remove again those that stay empty."""
    if folder.exists() and not folder.is_dir():
        raise OutputError(f"{folder}: is a file; give a folder for the output")
    absent = [place for place in (folder, *folder.parents) if not place.exists()]
    try:
        with tell_full_disk(folder):
            folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OutputError(f"{folder}: cannot be made ({error.strerror}); give another folder") from None
    try:
        yield
    finally:
        with suppress(OSError):
            for place in absent:
                place.rmdir()


@contextmanager
def new_folder(folder: Path, *, command: str) -> Iterator[Path]:
    """Give a folder to fill, which is `folder` after the block, completely or not at all.

    Parameters
    ----------
    folder : to create; it may exist if it is empty
    command : that writes it, named to other commands meanwhile

    Raises
    ------
    ProjectError : it is a file, or not empty
    """
    if folder.exists() and not folder.is_dir():
        raise ProjectError(f"{folder}: is a file; give the name of a new folder")
    if folder.is_dir() and any(folder.iterdir()):
        raise ProjectError(f"{folder}: is not empty; give the name of a new folder")
    folder = folder.absolute()
    folder.parent.mkdir(parents=True, exist_ok=True)
    remove_abandoned_stages(folder.parent)
    with make_stage(folder.parent, command=command) as place:
        yield place / MADE
        if folder.exists():
            folder.rmdir()  # it is empty
        (place / MADE).rename(folder)


def refuse_obstacles(folder: Path, manifest: Manifest, owner: str, expected: Sequence[str]) -> None:
    """Raise OutputError if a folder holds files that may not be replaced or removed.

    Parameters
    ----------
    folder : the folder
    manifest : of the folder
    owner : the set of files to be written
    expected : names of files that are certain to come
    """
    _raise_output_error(folder, _find_obstacles(folder, manifest, owner, expected))


def recover_for_reading(folder: Path, *, tell: TellMessage) -> None:
    """Recover a folder for a command that only reads in it.

    Waits for a command that is moving files at this moment; does nothing if no command was stopped there.

    Parameters
    ----------
    folder : the folder
    tell : called with a message on what was recovered
    """
    if any((each / JOURNAL).is_file() for each in _stages(folder)):
        with hold_lock(folder, command="a command that reads there", patient=True):
            _recover(folder, tell=tell)


@dataclass(frozen=True)
class Move:
    """The move of one file: `name` below the folder, SHA-256 of the new and of the old file, None for no file."""

    name: str
    new: str | None
    old: str | None


def write_journal(stage: Path, moves: Sequence[Move]) -> None:
    """Write the journal, once all files it lists are on the disk."""
    for folder in [stage / MADE, *(path for path in (stage / MADE).rglob("*") if path.is_dir())]:
        flush(folder)
    draft = stage / f"{JOURNAL}.draft"
    with draft.open("w", encoding="utf-8") as file:
        json.dump({"format": 1, "moves": [asdict(move) for move in moves]}, file)
        file.flush()
        os.fsync(file.fileno())
    os.replace(draft, stage / JOURNAL)
    flush(stage)


@contextmanager
def make_stage(place: Path, *, command: str) -> Iterator[Path]:
    """Give a new hidden folder in `place`, with an empty folder `made`; it is removed unless its journal is open.

    Parameters
    ----------
    place : the folder to make it in
    command : the command that uses it, named in its lock

    Yields
    ------
    Path
        The stage.

    Raises
    ------
    OutputError : if nothing can be written in `place`
    """
    folder = place / f"{PREFIX}{token_hex(6)}"
    try:
        with tell_full_disk(place):
            _make_hidden_folder(folder)
            with hold_lock(folder, command=command):
                try:
                    (folder / MADE).mkdir()
                    yield folder
                finally:
                    with defer_signals():
                        _empty_stage(folder)
    finally:
        with defer_signals():
            if not (folder / JOURNAL).exists():
                _remove_stage(folder)


@contextmanager
def tell_full_disk(place: Path) -> Iterator[None]:
    """Turn what a full disk leads to within the block into one line.

    Parameters
    ----------
    place : where is written, whole or not at all

    Raises
    ------
    FullDiskError : if an error within the block is that of a full disk, or came of one
    """
    try:
        yield
    except OutputError:
        raise
    except Exception as error:
        full = next((each for each in _with_causes(error) if is_full(each)), None)
        if full is None:
            raise
        where = getattr(full, "filename", None) or place
        kept = f"; what was begun in {place} is removed" if place.exists() else ""
        raise FullDiskError(f"{where}: no space is left on the disk{kept}; make room, or write elsewhere") from None


def is_full(error: BaseException) -> bool:
    """Return whether an error is that of a disk without space, for anyone or for this user."""
    if isinstance(error, shutil.Error):  # of a copied folder: it has the errors of all files as text
        return any(os.strerror(number) in str(error) for number in FULL)
    return isinstance(error, OSError) and error.errno in FULL


def remove_abandoned_stages(place: Path) -> None:
    """Remove the abandoned stages in `place` that hold no old files."""
    for each in _left_behind(place):
        if not (each / OLD).exists():
            _remove_stage(each)


def flush(path: Path) -> None:
    """Flush a file, or the names in a folder, to the disk."""
    if os.name == "nt" and path.is_dir():
        return  # Windows opens no folders
    handle = os.open(path, os.O_RDONLY if path.is_dir() else os.O_RDWR)
    try:
        os.fsync(handle)
    except OSError:
        if not path.is_dir():  # some network disks flush files only
            raise
    finally:
        os.close(handle)


def _find_obstacles(folder: Path, manifest: Manifest, owner: str, expected: Sequence[str]) -> dict[str, str]:
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


def _raise_output_error(folder: Path, obstacles: Mapping[str, str], *, kept: str = "") -> None:
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
    files = {name: digest(made / name) for name in _files_in(made)}
    kept = {name: old for name, old in manifest.files_of(owner).items() if name == owner and name not in files}
    listed = Manifest({**manifest.sets, owner: {**files, **kept}}).with_present_digests(folder)
    obstacles = _find_obstacles(folder, manifest, owner, list(files))
    written = listed if not obstacles else Manifest({owner: files})
    (made / MANIFEST).write_text(written.text(), encoding="utf-8", newline="\n")
    if obstacles:
        left = _keep_beside(place, folder)
        _raise_output_error(folder, obstacles, kept=f"; nothing there was touched, and what was made is in {left}")
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
            write_journal(place, moves)
            _finish_moves(place, folder, moves)
        except OSError as error:
            _take_back_moves(place, folder, moves)
            left = _keep_beside(place, folder)
            where = error.filename2 or error.filename or folder
            raise OutputError(
                f"{where}: cannot be written ({error.strerror}); nothing in {folder} was changed, and what was made is "
                f"in {left}: close what holds the files there, make room, or give another folder with -o"
            ) from None


@contextmanager
def _staged_file(path: Path, *, command: str) -> Iterator[Path]:
    """Give a path in a stage beside `path`; raise OutputError where no file can come to be there."""
    if not path.parent.is_dir():
        raise OutputError(f"{path}: there is no folder {path.parent}; make it first")
    if path.is_dir():
        raise OutputError(f"{path}: is a folder; give the name of a file")
    remove_abandoned_stages(path.parent)
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


def _recover(folder: Path, *, tell: TellMessage) -> None:
    """Recover a folder whose lock the caller holds; remove stages that are left behind."""
    for stage in _left_behind(folder, locked=True):
        if (stage / JOURNAL).is_file() and not stage.is_symlink():
            with defer_signals():
                tell(_finish_or_take_back(stage, folder))
        _remove_stage(stage)


def _finish_or_take_back(stage: Path, folder: Path) -> Message:
    moves = _read_moves(stage)
    if moves is not None and _can_finish(stage, folder, moves):
        _finish_moves(stage, folder, moves)
        return note("writing-finished", str(folder))
    _take_back_moves(stage, folder, _guess_moves(stage, folder) if moves is None else moves)
    left = any((stage / each).is_dir() and _files_in(stage / each) for each in (MADE, OLD))
    place = _keep_beside(stage, folder) if left else folder
    return note("writing-taken-back", str(folder), place=str(place))


def _keep_beside(stage: Path, folder: Path) -> Path:
    """Move the files of a stage into a new folder beside `folder`, or within it, and return the new folder.

    Old files whose place is taken by others go with them.
    """
    if (stage / OLD).is_dir() and _files_in(stage / OLD):
        (stage / OLD).rename(stage / MADE / OLD)
    beside = folder.absolute()
    for parent, name in ((beside.parent, f"{beside.name}-new"), (beside, "new")):
        number = next(n for n in range(1, 10_000) if not (parent / f"{name}-{n}").exists())
        try:
            return (stage / MADE).rename(parent / f"{name}-{number}")
        except OSError:
            continue
    return stage / MADE


def _finish_moves(stage: Path, folder: Path, moves: Sequence[Move]) -> None:
    """Carry out the moves that are not done yet."""
    for move in moves:
        made, saved, target = _made_saved_target(stage, folder, move)
        if made.exists() or move.new is None:
            _save_old_file(target, saved)
        if made.exists():
            target.parent.mkdir(parents=True, exist_ok=True)
            os.replace(made, target)
        elif move.new is None:
            target.unlink(missing_ok=True)
    _remove_empty(folder, [move.name for move in moves if move.new is None])
    _close_journal(stage, folder, moves)


def _take_back_moves(stage: Path, folder: Path, moves: Sequence[Move]) -> None:
    """Undo the moves that are done; files whose place is taken stay in the stage."""
    for move in reversed(moves):
        made, saved, target = _made_saved_target(stage, folder, move)
        now = digest(target)
        if now is not None and now == move.new and not made.exists():
            made.parent.mkdir(parents=True, exist_ok=True)
            os.replace(target, made)
            now = None
        if saved.exists() and now is None:
            target.parent.mkdir(parents=True, exist_ok=True)
            os.replace(saved, target)
        elif saved.exists() and now == move.old:
            saved.unlink()
    _remove_empty(folder, [move.name for move in moves if move.old is None])
    _close_journal(stage, folder, moves)


def _read_moves(stage: Path) -> list[Move] | None:
    """Return the moves in the journal of a stage; None if it cannot be read."""
    try:
        content = json.loads((stage / JOURNAL).read_text(encoding="utf-8"))
        moves = [Move(str(each["name"]), each["new"], each["old"]) for each in content["moves"]]
    except (OSError, ValueError, TypeError, KeyError, RecursionError):
        return None
    return moves if content.get("format") == 1 and all(stays_inside(move.name) for move in moves) else None


def _can_finish(stage: Path, folder: Path, moves: Sequence[Move]) -> bool:
    """Return whether all new files are whole, and no unknown file is in their place."""
    for move in moves:
        made, _, target = _made_saved_target(stage, folder, move)
        now = digest(target)
        if now not in (None, move.new, move.old):
            return False
        if move.new is not None and move.new not in (digest(made), now):
            return False
    return True


def _guess_moves(stage: Path, folder: Path) -> list[Move]:
    """Return the moves as the files show them, for a damaged journal: files in `old` were in the folder."""
    moves = []
    for name in _files_in(stage / OLD) if (stage / OLD).is_dir() else []:
        was = digest(stage / OLD / name)
        now = digest(folder / name)
        moves.append(Move(name, None if now == was else now, was))
    return moves


def _made_saved_target(stage: Path, folder: Path, move: Move) -> tuple[Path, Path, Path]:
    """Return where a file is made, saved and wanted; raise OutputError if a link leads out of the folder."""
    places = stage / MADE / move.name, stage / OLD / move.name, folder / move.name
    for root, place in zip((stage, stage, folder), places, strict=True):
        if link := link_above(place, root):
            raise OutputError(f"{link}: is a link, which leads out of {root}; remove it")
    return places


def _save_old_file(target: Path, saved: Path) -> None:
    """Save the file in the folder; it also stays there if the disk has links, so that readers never miss it."""
    if saved.exists() or not target.exists():
        return
    saved.parent.mkdir(parents=True, exist_ok=True)
    try:
        os.link(target, saved)
    except OSError:
        os.replace(target, saved)


def _close_journal(stage: Path, folder: Path, moves: Sequence[Move]) -> None:
    """Flush the folders and remove the journal: from now on the stage is done with."""
    for place in sorted({(folder / move.name).parent for move in moves} | {folder}):
        if place.is_dir():
            flush(place)
    (stage / JOURNAL).unlink(missing_ok=True)
    flush(stage)


def _remove_empty(folder: Path, names: Sequence[str]) -> None:
    """Remove the empty folders below `folder` that held, or were to hold, `names`."""
    for parent in sorted({(folder / name).parent for name in names} - {folder}, reverse=True):
        with suppress(OSError):
            parent.rmdir()


def _make_hidden_folder(folder: Path) -> None:
    try:
        folder.mkdir(mode=0o700)
    except OSError as error:
        if is_full(error):
            raise
        raise OutputError(
            f"{folder.parent}: nothing can be written there ({error.strerror}); give another place"
        ) from None


def _empty_stage(folder: Path) -> None:
    """Remove the files of a stage except its lock, which goes last; none while moves are unfinished."""
    for each in () if (folder / JOURNAL).exists() else folder.iterdir():
        if each.name != LOCK:
            _remove_stage(each)


def _stages(place: Path) -> list[Path]:
    try:
        return sorted(place.glob(f"{PREFIX}*"))
    except OSError:
        return []


def _left_behind(place: Path, *, locked: bool = False) -> list[Path]:
    """Return the stages in `place` that no command uses; locked: no other command can begin one there now."""
    return [each for each in _stages(place) if _is_left_behind(each, locked=locked)]


def _is_left_behind(found: Path, *, locked: bool) -> bool:
    """Return whether a stage is abandoned; one without a signed lock may just be beginning, or was stopped then."""
    lock = found / LOCK
    try:
        if lock.is_file():
            return is_abandoned(lock, unsigned=locked or _is_older_than_a_day(lock))
        return locked or _is_older_than_a_day(found)
    except OSError:
        return False


def _is_older_than_a_day(path: Path) -> bool:
    return time.time() - path.lstat().st_mtime > _DAY


def _remove_stage(found: Path) -> None:
    """Remove a stage; a link is removed, not followed."""
    if found.is_dir() and not found.is_symlink():
        shutil.rmtree(found, ignore_errors=True)
        return
    with suppress(OSError):
        found.unlink()


def _files_in(folder: Path) -> list[str]:
    """Return every file below `folder`, as a sorted list of paths with slashes."""
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if not path.is_dir())


def _with_causes(error: BaseException | None) -> Iterator[BaseException]:
    """Yield an error, and those during which it came."""
    while error is not None:
        yield error
        error = error.__cause__ or error.__context__
