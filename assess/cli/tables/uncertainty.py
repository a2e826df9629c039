"""What `assess run` prints of uncertain numbers: how likely each deciding answer fails, and what that hangs on."""

from __future__ import annotations

from collections.abc import Iterator

from assess.cli.tables.text_table import on_one_line
from assess.messages.plural import count_noun
from assess.project.key_text import escape_text
from assess.results.uncertainty import UncertainAnswer, UncertaintyResult


def uncertainty_lines(found: UncertaintyResult | None) -> Iterator[str]:
    """Yield the number of samples, a line for each answer that decides, and the notes; nothing without samples."""
    if found is None:
        return
    groups = count_noun(len({each.group for each in found.inputs}), "group")
    numbers = count_noun(len(found.inputs), "uncertain number")
    yield f"uncertainty: {found.samples} samples of {numbers} in {groups}"
    yield from (_answer(each) for each in found.answers if each.role == "deciding")
    yield from (f"note: {each.where or 'uncertainty'}: {each.text}" for each in found.notes)


def _answer(answer: UncertainAnswer) -> str:
    name = on_one_line(escape_text(answer.mechanism), 40)
    of = f"{name}: {answer.procedure} {answer.limit_state}".strip()
    if answer.probability is None or answer.interval is None:
        return f"{of}: not answered in any sample"
    low, high = (f"{100.0 * each:.3g}" for each in answer.interval)
    without = f", {answer.unanswered} not answered" if answer.unanswered else ""
    return f"{of}: fails in {100.0 * answer.probability:.3g} % of samples ({low} to {high} %){without}{_most(answer)}"


def _most(answer: UncertainAnswer) -> str:
    """Name the group that explains most of the ratio; empty where none explains any."""
    known = [(each.share, each.group) for each in answer.influences if each.share is not None]
    if not known:
        return ""
    share, group = max(known)
    return f"; most by {on_one_line(escape_text(group), 40)} (share {share:.2g})"
