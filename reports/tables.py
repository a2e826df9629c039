"""The tables of the checks: every number is taken from the results as it stands there."""

from __future__ import annotations

import re

from assess.codes.check import Check, Reason
from assess.results import MechanismResult, Results
from reports import governing
from reports.document import Cell, Column, Table
from reports.numerals import bounded

UNLASTING = (Reason.NO_LASTING, Reason.ON_JOINTS)
OVERTURNED, NO_ROCKING, NO_LASTING, NONE = "overturned", "no rocking", "none lasting", "none"
_INDEX, _YEARS = Column("Safety index", "-", "number"), Column("Return period", "years", "number")
MECHANISM, LEVEL, PROCEDURE = Column("Mechanism"), Column("PGA", "g", "number"), Column("Procedure")

ANSWER = (
    Column("Quantity, unit"),
    Column("Demand", kind="number"),
    Column("Allowable", kind="number"),
    Column("Ratio", "-", "number"),
)


def name_of(mechanism: MechanismResult) -> str:
    """What the mechanism is called in the report: its label, or its name."""
    return mechanism.label or mechanism.name


def brief(results: Results) -> Table:
    """One line per mechanism and level: the verdict of each procedure that decides, and the largest ratio."""
    deciding = dict.fromkeys(c.procedure for m in results.mechanisms for c in governing.of_code(m.checks))
    columns = (MECHANISM, LEVEL, *(Column(broken(name), kind="verdict") for name in deciding))
    columns += (Column("Largest ratio", "-", "number"), Column("Verdict", kind="verdict"))
    rows: list[tuple[Cell, ...]] = []
    for mechanism in results.mechanisms:
        for level in governing.levels(mechanism.checks):
            checks = governing.of_code(governing.at_level(mechanism.checks, level))
            each = (governing.verdict(tuple(c for c in checks if c.procedure == name)) for name in deciding)
            asked = {check.procedure for check in checks}
            cells = tuple(v if name in asked else None for name, v in zip(deciding, each, strict=True))
            rows.append((name_of(mechanism), level, *cells, _largest(checks), governing.verdict(checks)))
    caption = "Verdicts of the code procedures; the largest ratio is demand over allowable of the worst of them."
    return Table("summary", caption, columns, tuple(rows))


def verdicts(results: Results) -> Table:
    """Every check of every mechanism: demand, allowable, ratio, verdict."""
    pairs = [(mechanism, check) for mechanism in results.mechanisms for check in mechanism.checks]
    columns = (
        MECHANISM,
        LEVEL,
        PROCEDURE,
        *ANSWER,
        Column("Verdict", kind="verdict"),
        Column("Role"),
        Column("Input at"),
    )
    rows = tuple(
        (name_of(mechanism), check.level_pga_g, *_answer(check, mechanism.checks)) for mechanism, check in pairs
    )
    muted = frozenset(place for place, (_, check) in enumerate(pairs) if check.reading == "thesis")
    caption = "Demand, allowable, ratio and verdict of every check. Informative readings (grey) decide nothing."
    return Table("verdicts", caption, columns, rows, muted)


def procedures(results: Results) -> Table:
    """Each procedure with its edition, role, where its input acts, damping, and what could not be compared, once."""
    checks = (check for mechanism in results.mechanisms for check in mechanism.checks)
    rows = dict.fromkeys(
        (check.procedure, check.edition, check.limit_state, check.role, check.input_at, _remark(check))
        for check in checks
    )
    columns = (
        PROCEDURE,
        Column("Edition"),
        Column("Limit state"),
        Column("Role"),
        Column("Input at"),
        Column("Remark"),
    )
    return Table("procedures", "Procedures, their editions and roles.", columns, tuple(rows))


def demands(mechanism: MechanismResult, *, name: str) -> Table:
    """Every check of one mechanism: demand, allowable, ratio and verdict, and the accelerations it stands up to."""
    ratings = [_rating(check) for check in mechanism.checks]
    rated = [column for column in (_INDEX, _YEARS) if any(rating[column] is not None for rating in ratings)]
    columns = (
        LEVEL,
        PROCEDURE,
        *ANSWER,
        Column("Rotation φ/φₒᵥ", "-", "number"),
        Column("PGA at uplift", "g", "number"),
        Column("PGA at capacity", "g", "number"),
        *rated,
        Column("Verdict", kind="verdict"),
    )
    rows = tuple(
        (*_demand(check, mechanism.checks), *(rating[column] for column in rated), check.verdict)
        for check, rating in zip(mechanism.checks, ratings, strict=True)
    )
    muted = frozenset(place for place, check in enumerate(mechanism.checks) if check.reading == "thesis")
    soft = any(check.uplift_pga_g is None for check in mechanism.checks)
    rating = " Safety index: PGA at capacity over that demanded; return period: of the capacity." if rated else ""
    return Table(
        name,
        "Demand, allowable, ratio and verdict of every check; the peak ground acceleration at uplift"
        f"{' (none: its joints answer to any motion)' * soft} and at capacity. "
        f"Informative readings (grey) decide nothing.{rating}",
        columns,
        rows,
        muted,
    )


def _rating(check: Check) -> dict[Column, Cell]:
    """What a check has where the code and the site know it."""
    return {_INDEX: check.safety_index, _YEARS: bounded(check.return_period_years, check.return_period_bound)}


def reasons(mechanism: MechanismResult, *, name: str) -> Table:
    """Why a check did not pass, for those that say so."""
    columns = (PROCEDURE, Column("PGA", "g", "number"), Column("Verdict", kind="verdict"), Column("Reason"))
    rows = tuple(
        (governing.named(c, mechanism.checks), c.level_pga_g, c.verdict, c.reason.text)
        for c in mechanism.checks
        if c.verdict != "pass"
    )
    return Table(name, "Checks that fail or do not apply, and why.", columns, rows)


def turned(check: Check) -> Cell:
    """Its rotation; a body that lifts off without a lasting rotation is not at rest."""
    if check.unbounded:
        return check.unbounded
    return NO_LASTING if check.reason.key in UNLASTING else rocking(check.rotation_ratio)


def broken(name: str) -> str:
    """A procedure's name that breaks between words in a narrow column."""
    return re.sub(r"-(?=[a-z])", " ", name)


def pga_curves(results: Results) -> Table:
    """The PGA-rotation curves of every mechanism and procedure, point by point."""
    columns = (MECHANISM, PROCEDURE, Column("Limit state"), Column("Rotation φ/φₒᵥ", "-", "number"), LEVEL)
    rows = tuple(
        (mechanism.name, check.procedure, check.limit_state, ratio, pga)
        for mechanism in results.mechanisms
        for check in _curved(mechanism.checks)
        for ratio, pga in zip(check.pga_curve.rotation_ratio, check.pga_curve.pga_g, strict=True)
    )
    return Table("pga-rotation-curves", "Peak ground acceleration over rotation, by each procedure.", columns, rows)


def _curved(checks: tuple[Check, ...]) -> tuple[Check, ...]:
    first: dict[tuple[str, str], Check] = {}
    for check in checks:
        first.setdefault((check.procedure, check.limit_state), check)
    return tuple(first.values())


def _largest(checks: tuple[Check, ...]) -> Cell:
    worst = governing.worst(checks)
    if worst is None:
        return None
    return worst.unbounded or worst.ratio


def _answer(check: Check, among: tuple[Check, ...]) -> tuple[Cell, ...]:
    return (*numbers(check, among), check.verdict, check.role, check.input_at)


def numbers(check: Check, among: tuple[Check, ...]) -> tuple[Cell, Cell, Cell, Cell, Cell]:
    """Procedure, quantity with unit, demand, allowable, ratio."""
    quantity = f"{check.quantity}, {check.unit}" if check.unit not in ("", "-") else check.quantity
    demand = check.unbounded or check.demand
    return (governing.named(check, among), quantity, demand, check.capacity, check.ratio)


def _demand(check: Check, among: tuple[Check, ...]) -> tuple[Cell, ...]:
    rotation = turned(check)
    accelerations = (uplift(check.uplift_pga_g), check.capacity_pga_g)
    return (check.level_pga_g, *numbers(check, among), rotation, *accelerations)


def _remark(check: Check) -> str:
    return "; ".join(text for text in (check.damping_rule, check.caveat) if text)


def rocking(rotation: float | None) -> Cell:
    return NO_ROCKING if rotation == 0 else rotation


def uplift(at: float | None) -> Cell:
    """Multiplier [-] or PGA [g] at uplift; "none" where a joint answers to any motion: no threshold."""
    return NONE if at is None else at
