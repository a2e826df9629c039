"""Writing a set of files into a folder: whole or not at all, alone, and nothing that is not ours touched."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path

from assess.errors import OutputError
from assess.messages.message import Message
from assess.outputs import journal
from assess.outputs.digest import digest
from assess.outputs.journal import Move
from assess.outputs.lock import hold_lock
from assess.outputs.manifest import MANIFEST, RESULTS, Manifest, link_above, read, state
from assess.outputs.recovery import Tell, keep_beside, recover
from assess.outputs.signals import defer_signals
from assess.outputs.stage import MADE, files_in, flush, stage

_TOLD = 5  # names of files in a line


def _silent(_: Message) -> None:
    pass


@contextmanager
def output_folder(
    folder: Path, *, command: str, owner: str = RESULTS, wanted: Sequence[str] = (), tell: Tell = _silent
) -> Iterator[Path]:
    """A temporary folder; what the block leaves in it stands in `folder` afterwards, if the block raised nothing.

    command : what writes there, for others to be told while it does
    owner : the set that the files make up, of `assess.outputs.manifest`; those of the set that are not made again are
    removed, but for the results after which it is called
    wanted : files that are known to come
    tell : is told what was made good there
    Raises OutputError at once where the folder cannot be written or holds files that may not be replaced.
    """
    if folder.exists() and not folder.is_dir():
        raise OutputError(f"{folder}: is a file; give a folder for the output")
    with _make_folder(folder), hold_lock(folder, command=command):
        recover(folder, tell=tell)
        manifest = read(folder)
        _refuse(folder, _obstacles(folder, manifest, owner, wanted))
        with stage(folder, command=command) as place:
            yield place / MADE
            _commit(place, folder, manifest, owner)


@contextmanager
def _make_folder(folder: Path) -> Iterator[None]:
    """The folder, made with those above it where there is none; such as nothing came into are removed again."""
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


def _obstacles(folder: Path, manifest: Manifest, owner: str, wanted: Sequence[str]) -> dict[str, str]:
    """Why files in the folder cannot be replaced or removed, by their names.

    wanted : files to be written; those of the set that are not among them go, but for its results
    """
    ours = manifest.of(owner)
    found = {}
    for name in [*wanted, *(name for name in ours if name not in wanted and name != owner)]:
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


def _refuse(folder: Path, wrong: Mapping[str, str], *, kept: str = "") -> None:
    if not wrong:
        return
    why = next(iter(wrong.values()))
    names = [str(folder / name) for name, each in wrong.items() if each == why]
    more = f" and {len(names) - _TOLD} more" if len(names) > _TOLD else ""
    raise OutputError(f"{', '.join(names[:_TOLD])}{more}: {why}; move it away, or give another folder with -o{kept}")


def _commit(place: Path, folder: Path, manifest: Manifest, owner: str) -> None:
    """Move what was made into the folder; what cannot go there is left beside it."""
    made = place / MADE
    files = {name: digest(made / name) for name in files_in(made)}
    kept = {name: old for name, old in manifest.of(owner).items() if name == owner and name not in files}
    listed = Manifest({**manifest.sets, owner: {**files, **kept}}).known(folder)
    wrong = _obstacles(folder, manifest, owner, list(files))
    _write(listed if not wrong else Manifest({owner: files}), made / MANIFEST)
    if wrong:
        left = keep_beside(place, folder)
        _refuse(folder, wrong, kept=f"; nothing there was touched, and what was made is in {left}")
    gone = [name for name in manifest.of(owner) if name not in files and name != owner]
    _move([*files, *gone, *manifest.earlier, MANIFEST], place, folder)


def _write(manifest: Manifest, path: Path) -> None:
    path.write_text(manifest.text(), encoding="utf-8", newline="\n")


def _move(names: Sequence[str], place: Path, folder: Path) -> None:
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
