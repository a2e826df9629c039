"""The verdict of each mechanism: the deciding answer of each limit state, its procedure and reason."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from assess.codes.verdict import Answer, MechanismVerdict, Verdict
from assess.codes.verdict_text import index_text, margin_text, outcome_text
from assess.results import Results
from reports.document import Cell, Column, Table
from reports.language.message_text import message_text
from reports.mechanism_title import mechanism_title

ANSWER = Column("Answer", kind="verdict")
COLUMNS = (
    Column("Mechanism"),
    Column("Verdict", kind="verdict"),
    Column("Limit state"),
    ANSWER,
    Column("Decided by"),
    Column("Index"),
    Column("Holds up to"),
    Column("Why"),
)


def table(results: Results) -> Table:
    """Tabulate the verdict, a line for each mechanism and limit state that decides."""
    caption = (
        "The verdict of each mechanism at the site’s own action: the procedure that decides each limit "
        "state, its index, and the peak ground acceleration up to which the mechanism holds."
    )
    found = results.verdict
    assert found is not None  # the page has none without a verdict
    names = {mechanism.name: mechanism_title(mechanism) for mechanism in results.mechanisms}
    rows = tuple(row for one in found.mechanisms for row in _rows(one, found, names))
    place = COLUMNS.index(ANSWER)
    if any(row[place] != row[1] for row in rows):
        return Table("verdict", caption, COLUMNS, rows)
    columns = tuple(column for column in COLUMNS if column is not ANSWER)
    return Table("verdict", caption, columns, tuple((*row[:place], *row[place + 1 :]) for row in rows))


def _rows(one: MechanismVerdict, found: Verdict, names: Mapping[str, str]) -> Iterator[tuple[Cell, ...]]:
    """Yield the lines of a mechanism, one for each limit state."""
    name, outcome = names.get(one.mechanism, one.mechanism), outcome_text(one.outcome, near=one.at_the_limit)
    for answer in one.answers:
        decided = outcome_text(answer.outcome, near=answer.at_the_limit)
        index = index_text(answer.index).replace("zeta_E", "ζ_E")
        cells = (
            answer.limit_state,
            decided,
            answer.procedure,
            index,
            margin_text(one, found.action),
            _why(answer, one),
        )
        yield (name, outcome, *cells)


def _why(answer: Answer, one: MechanismVerdict) -> str:
    """Return the reason, and the missing inputs where they alone prevent an answer."""
    if answer.outcome == one.outcome or not one.missing:
        return message_text(answer.reason)
    return f"{message_text(answer.reason)}; missing: {', '.join(each.key for each in one.missing)}"
