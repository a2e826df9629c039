"""The chapter on levels other than the site's own: results of the accepted methods there, without a verdict."""

from __future__ import annotations

from assess.codes.check import Check, Outcome
from assess.results import MechanismResult, Results
from reports import governing
from reports.chapters import conclusions
from reports.chapters.check_tables import LEVEL, MECHANISM, breakable_name
from reports.document import Cell, Column, Items, Section, Table, Text
from reports.language.lists import list_names
from reports.mechanism_title import mechanism_title

TITLE = "Study at other peak ground accelerations"
NOT_A_VERDICT = (
    "Parametric study: results of the methods that may decide, at other peak ground accelerations. It is "
    "not part of the verdict, which is given at the site’s own action only."
)
RANKED = (Outcome.FAIL, Outcome.NOT_ANSWERED, Outcome.PASS, Outcome.NOT_APPLICABLE)


def chapter(results: Results) -> list[Section]:
    """Return the study; none where the site's own action is the only level."""
    if not governing.other_levels(results):
        return []
    paragraphs = (NOT_A_VERDICT, *passes_beyond_capacity(results))
    points = tuple(conclusions.disagreements(results, governing.other_levels(results)))
    blocks = (Text(paragraphs), table(results), *((Items(points),) if points else ()))
    return [Section(TITLE, 0, blocks)]


def methods(results: Results) -> tuple[str, ...]:
    """Return the procedures that may decide; without a basis, all by the letter of a code."""
    accepted = () if results.verdict is None else results.verdict.methods
    procedures = dict.fromkeys(c.procedure for m in results.mechanisms for c in governing.code_checks(m.checks))
    return tuple(name for name in procedures if name in accepted) or tuple(procedures)


def table(results: Results) -> Table:
    """Tabulate the outcome of each method and the largest ratio, a line for each mechanism and level."""
    names = methods(results)
    columns = (
        MECHANISM,
        LEVEL,
        *(Column(breakable_name(name), kind="verdict") for name in names),
        Column("Largest ratio", "-", "number"),
    )
    levels = governing.other_levels(results)
    rows = tuple(_row(results, mechanism, level, names) for mechanism in results.mechanisms for level in levels)
    caption = "Results of the methods at other peak ground accelerations; the largest ratio is demand over allowable."
    return Table("study", caption, columns, rows)


def _row(results: Results, mechanism: MechanismResult, level: float, names: tuple[str, ...]) -> tuple[Cell, ...]:
    checks = governing.code_checks(governing.at_level(mechanism.checks, level))
    by_name = {name: _deciding_states(tuple(c for c in checks if c.procedure == name), results) for name in names}
    worst = governing.worst(tuple(check for found in by_name.values() for check in found))
    ratio = None if worst is None else worst.unbounded or worst.ratio
    return (mechanism_title(mechanism), level, *(_outcome(found) for found in by_name.values()), ratio)


def _deciding_states(checks: tuple[Check, ...], results: Results) -> tuple[Check, ...]:
    """Return the checks of one procedure at the deciding limit states, where it has them by name."""
    states = () if results.verdict is None else results.verdict.limit_states
    return tuple(check for check in checks if check.limit_state in states) or checks


def _outcome(checks: tuple[Check, ...]) -> str | None:
    found = {check.verdict for check in checks}
    return next((each.value for each in RANKED if each in found), None)


def passes_beyond_capacity(results: Results) -> tuple[str, ...]:
    """Explain why mechanisms pass at a level above their PGA at capacity, where some do."""
    names = [
        conclusions.short_title(m)
        for m in results.mechanisms
        if any(map(_passes_beyond, governing.code_checks(m.checks)))
    ]
    if not names:
        return ()
    return (
        f"{list_names(names)}: records that overturn the mechanism, or rotate it too far, at "
        "one PGA can be survived at a higher one. The PGA at capacity is the last before the suite first "
        "fails; a pass at a higher level is not a margin.",
    )


def _passes_beyond(check: Check) -> bool:
    capacity = check.capacity_pga_g
    return check.verdict == Outcome.PASS and capacity is not None and check.level_pga_g > 1.000001 * capacity
