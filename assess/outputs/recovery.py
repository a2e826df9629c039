"""Recovery of a folder in which a command was stopped: its last moves are finished, or taken back."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from assess.messages.message import Message, note
from assess.outputs import journal
from assess.outputs.lock import hold_lock
from assess.outputs.signals import defer_signals
from assess.outputs.stage import JOURNAL, MADE, OLD, files_in, left_behind, remove

Tell = Callable[[Message], None]


def recover_for_reading(folder: Path, *, tell: Tell) -> None:
    """Recover a folder for a command that only reads in it.

    Waits for a command that is moving files at this moment; does nothing if no command was stopped there.

    Parameters
    ----------
    folder : Path
        The folder.
    tell : callable
        Called with a message on what was recovered.
    """
    if any((each / JOURNAL).is_file() for each in _stages(folder)):
        with hold_lock(folder, command="a command that reads there", patient=True):
            recover(folder, tell=tell)


def recover(folder: Path, *, tell: Tell) -> None:
    """Recover a folder whose lock the caller holds; remove stages that are left behind."""
    for stage in left_behind(folder, alone=True):
        if (stage / JOURNAL).is_file() and not stage.is_symlink():
            with defer_signals():
                tell(_finish_or_take_back(stage, folder))
        remove(stage)


def keep_beside(stage: Path, folder: Path) -> Path:
    """Move the files of a stage into a new folder beside `folder`, or within it, and return the new folder.

    Old files whose place is taken by others go with them.
    """
    if (stage / OLD).is_dir() and files_in(stage / OLD):
        (stage / OLD).rename(stage / MADE / OLD)
    beside = folder.absolute()
    for parent, name in ((beside.parent, f"{beside.name}-new"), (beside, "new")):
        number = next(n for n in range(1, 10_000) if not (parent / f"{name}-{n}").exists())
        try:
            return (stage / MADE).rename(parent / f"{name}-{number}")
        except OSError:
            continue
    return stage / MADE


def _finish_or_take_back(stage: Path, folder: Path) -> Message:
    moves = journal.read_moves(stage)
    if moves is not None and journal.can_finish(stage, folder, moves):
        journal.finish(stage, folder, moves)
        return note("writing-finished", str(folder))
    journal.take_back(stage, folder, journal.guess_moves(stage, folder) if moves is None else moves)
    left = any((stage / each).is_dir() and files_in(stage / each) for each in (MADE, OLD))
    place = keep_beside(stage, folder) if left else folder
    return note("writing-taken-back", str(folder), place=str(place))


def _stages(folder: Path) -> list[Path]:
    try:
        return list(folder.glob(".assess-partial-*"))
    except OSError:
        return []
