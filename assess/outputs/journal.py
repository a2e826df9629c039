"""Moves of finished files from their stage into a folder, which can be recovered from a stop at any moment.

The stage holds the new files in `made`. A journal written there lists every move with the SHA-256 of the new and of the
old file; only then are files moved, replaced ones into `old`. Every step can be repeated: the next command that finds a
stage with a journal finishes the moves, or takes them back if the folder was changed meanwhile. A stage without a
journal was never finished, or is done with.
"""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path

from assess.errors import OutputError
from assess.outputs.digest import digest
from assess.outputs.manifest import link_above, stays_inside
from assess.outputs.stage import JOURNAL, MADE, OLD, files_in, flush


@dataclass(frozen=True)
class Move:
    """The move of one file: `name` below the folder, SHA-256 of the new and of the old file, None for no file."""

    name: str
    new: str | None
    old: str | None


def begin(stage: Path, moves: Sequence[Move]) -> None:
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


def finish(stage: Path, folder: Path, moves: Sequence[Move]) -> None:
    """Carry out the moves that are not done yet."""
    for move in moves:
        made, saved, target = _places(stage, folder, move)
        if made.exists() or move.new is None:
            _save(target, saved)
        if made.exists():
            target.parent.mkdir(parents=True, exist_ok=True)
            os.replace(made, target)
        elif move.new is None:
            target.unlink(missing_ok=True)
    _remove_empty(folder, [move.name for move in moves if move.new is None])
    _close(stage, folder, moves)


def take_back(stage: Path, folder: Path, moves: Sequence[Move]) -> None:
    """Undo the moves that are done; files whose place is taken stay in the stage."""
    for move in reversed(moves):
        made, saved, target = _places(stage, folder, move)
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
    _close(stage, folder, moves)


def read_moves(stage: Path) -> list[Move] | None:
    """Return the moves in the journal of a stage; None if it cannot be read."""
    try:
        content = json.loads((stage / JOURNAL).read_text(encoding="utf-8"))
        moves = [Move(str(each["name"]), each["new"], each["old"]) for each in content["moves"]]
    except (OSError, ValueError, TypeError, KeyError, RecursionError):
        return None
    return moves if content.get("format") == 1 and all(stays_inside(move.name) for move in moves) else None


def can_finish(stage: Path, folder: Path, moves: Sequence[Move]) -> bool:
    """Return whether all new files are whole, and no unknown file is in their place."""
    for move in moves:
        made, _, target = _places(stage, folder, move)
        now = digest(target)
        if now not in (None, move.new, move.old):
            return False
        if move.new is not None and move.new not in (digest(made), now):
            return False
    return True


def guess_moves(stage: Path, folder: Path) -> list[Move]:
    """Return the moves as the files show them, for a damaged journal: files in `old` were in the folder."""
    moves = []
    for name in files_in(stage / OLD) if (stage / OLD).is_dir() else []:
        was = digest(stage / OLD / name)
        now = digest(folder / name)
        moves.append(Move(name, None if now == was else now, was))
    return moves


def _places(stage: Path, folder: Path, move: Move) -> tuple[Path, Path, Path]:
    """Return where a file is made, saved and wanted; raise OutputError if a link leads out of the folder."""
    places = stage / MADE / move.name, stage / OLD / move.name, folder / move.name
    for root, place in zip((stage, stage, folder), places, strict=True):
        if link := link_above(place, root):
            raise OutputError(f"{link}: is a link, which leads out of {root}; remove it")
    return places


def _save(target: Path, saved: Path) -> None:
    """Save the file in the folder; it also stays there if the disk has links, so that readers never miss it."""
    if saved.exists() or not target.exists():
        return
    saved.parent.mkdir(parents=True, exist_ok=True)
    try:
        os.link(target, saved)
    except OSError:
        os.replace(target, saved)


def _close(stage: Path, folder: Path, moves: Sequence[Move]) -> None:
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
