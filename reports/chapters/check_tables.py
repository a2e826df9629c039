"""The tables of the checks, with the numbers of the results."""

from __future__ import annotations

import re

from assess.codes.check import Check, Outcome, Reason
from assess.results import MechanismResult, Results
from reports import governing
from reports.document import Cell, Column, Table
from reports.language import message_text
from reports.language.numerals import with_bound
from reports.mechanism_title import mechanism_title

NO_LASTING_ROTATION = (Reason.NO_LASTING, Reason.ON_JOINTS)
OVERTURNED, NO_ROCKING, NO_LASTING, NONE = "overturned", "no rocking", "none lasting", "none"
_INDEX, _YEARS = Column("Safety index", "-", "number"), Column("Return period", "years", "number")
MECHANISM, LEVEL, PROCEDURE = Column("Mechanism"), Column("PGA", "g", "number"), Column("Procedure")

DEMAND_COLUMNS = (
    Column("Quantity, unit"),
    Column("Demand", kind="number"),
    Column("Allowable", kind="number"),
    Column("Ratio", "-", "number"),
)


OUTCOME_COLUMNS = (
    Column("Outcome", kind="verdict"),
    Column("Role"),
    Column("Reading"),
    Column("Input at"),
    Column("Why"),
    Column("Conditions and remarks"),
)


def verdicts(results: Results) -> Table:
    """Tabulate every check of every mechanism: demand, allowable, ratio, outcome, role and reason."""
    pairs = [(mechanism, check) for mechanism in results.mechanisms for check in mechanism.checks]
    columns = (MECHANISM, LEVEL, PROCEDURE, *DEMAND_COLUMNS, *OUTCOME_COLUMNS)
    rows = tuple(
        (mechanism_title(mechanism), check.level_pga_g, *demand_cells(check, mechanism.checks), *outcome_cells(check))
        for mechanism, check in pairs
    )
    muted = frozenset(place for place, (_, check) in enumerate(pairs) if check.reading == "thesis")
    caption = "Demand, allowable, ratio and outcome of every check. Readings of the thesis (grey) never decide."
    return Table("verdicts", caption, columns, rows, muted)


def procedures(results: Results) -> Table:
    """Tabulate each procedure once: edition, reading, place of the input, damping, and open comparisons."""
    checks = (check for mechanism in results.mechanisms for check in mechanism.checks)
    rows = dict.fromkeys(
        (check.procedure, check.edition, check.limit_state, check.reading, check.input_at, _remark(check))
        for check in checks
    )
    columns = (
        PROCEDURE,
        Column("Edition"),
        Column("Limit state"),
        Column("Reading"),
        Column("Input at"),
        Column("Remark"),
    )
    return Table("procedures", "Procedures and their editions.", columns, tuple(rows))


def demands(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate every check of one mechanism: demand, allowable, ratio, outcome, PGA at uplift and at capacity."""
    ratings = [_rating(check) for check in mechanism.checks]
    rated = [column for column in (_INDEX, _YEARS) if any(rating[column] is not None for rating in ratings)]
    columns = (
        LEVEL,
        PROCEDURE,
        *DEMAND_COLUMNS,
        Column("Rotation φ/φₒᵥ", "-", "number"),
        Column("PGA at uplift", "g", "number"),
        Column("PGA at capacity", "g", "number"),
        *rated,
        Column("Outcome", kind="verdict"),
    )
    rows = tuple(
        (*_demand_row(check, mechanism.checks), *(rating[column] for column in rated), check.verdict.value)
        for check, rating in zip(mechanism.checks, ratings, strict=True)
    )
    muted = frozenset(place for place, check in enumerate(mechanism.checks) if check.reading == "thesis")
    soft = any(check.uplift_pga_g is None for check in mechanism.checks)
    rating = " Safety index: PGA at capacity over that demanded; return period: of the capacity." if rated else ""
    return Table(
        name,
        "Demand, allowable, ratio and outcome of every check; the peak ground acceleration at uplift"
        f"{' (none: its joints respond to any motion)' * soft} and at capacity. "
        f"Readings of the thesis (grey) never decide.{rating}",
        columns,
        rows,
        muted,
    )


def _rating(check: Check) -> dict[Column, Cell]:
    """Return safety index and return period of a check, where code and site have them."""
    return {_INDEX: check.safety_index, _YEARS: with_bound(check.return_period_years, check.return_period_bound)}


def answers(mechanism: MechanismResult, site_pga: float | None, *, name: str) -> Table:
    """Tabulate outcomes and reasons: all at the site's own action, at other levels those that do not pass.

    site_pga : of the site's own action [g], None for all levels alike
    """
    own = mechanism.checks if site_pga is None else governing.at_level(mechanism.checks, site_pga)
    shown = [check for check in mechanism.checks if check in own or check.verdict != Outcome.PASS]
    rows = tuple(
        (check.level_pga_g, governing.procedure_label(check, mechanism.checks), *outcome_cells(check))
        for check in shown
    )
    muted = frozenset(place for place, check in enumerate(shown) if check.reading == "thesis")
    caption = (
        "Outcome of each check and the reason: all checks at the site’s own action, at other levels those "
        "that do not pass."
    )
    return Table(name, caption, (LEVEL, PROCEDURE, *OUTCOME_COLUMNS), rows, muted)


def rotation_cell(check: Check) -> Cell:
    """Return the rotation of a check; a body that lifts off without a lasting rotation is not at rest."""
    if check.unbounded:
        return check.unbounded
    return NO_LASTING if check.reason.key in NO_LASTING_ROTATION else rocking_cell(check.rotation_ratio)


def breakable_name(name: str) -> str:
    """Return a procedure's name that breaks between words in a narrow column."""
    return re.sub(r"-(?=[a-z])", " ", name)


def pga_curves(results: Results) -> Table:
    """Tabulate the PGA-rotation curves of every mechanism and procedure, point by point."""
    columns = (MECHANISM, PROCEDURE, Column("Limit state"), Column("Rotation φ/φₒᵥ", "-", "number"), LEVEL)
    rows = tuple(
        (mechanism.name, check.procedure, check.limit_state, ratio, pga)
        for mechanism in results.mechanisms
        for check in _checks_with_curve(mechanism.checks)
        for ratio, pga in zip(check.pga_curve.rotation_ratio, check.pga_curve.pga_g, strict=True)
    )
    return Table("pga-rotation-curves", "Peak ground acceleration over rotation, by each procedure.", columns, rows)


def _checks_with_curve(checks: tuple[Check, ...]) -> tuple[Check, ...]:
    first: dict[tuple[str, str], Check] = {}
    for check in checks:
        first.setdefault((check.procedure, check.limit_state), check)
    return tuple(first.values())


def outcome_cells(check: Check) -> tuple[Cell, ...]:
    """Return outcome, role, reading, place of the input, reason, and conditions and remarks of a check."""
    beside = "; ".join(dict.fromkeys(message_text.message_text(each) for each in (*check.conditions, *check.remarks)))
    return (
        check.verdict.value,
        check.role,
        check.reading,
        check.input_at,
        message_text.message_text(check.reason),
        beside,
    )


def demand_cells(check: Check, among: tuple[Check, ...]) -> tuple[Cell, Cell, Cell, Cell, Cell]:
    """Return procedure, quantity with unit, demand, allowable and ratio."""
    quantity = f"{check.quantity}, {check.unit}" if check.unit not in ("", "-") else check.quantity
    demand = check.unbounded or check.demand
    return (governing.procedure_label(check, among), quantity, demand, check.capacity, check.ratio)


def _demand_row(check: Check, among: tuple[Check, ...]) -> tuple[Cell, ...]:
    rotation = rotation_cell(check)
    accelerations = (uplift_cell(check.uplift_pga_g), check.capacity_pga_g)
    return (check.level_pga_g, *demand_cells(check, among), rotation, *accelerations)


def _remark(check: Check) -> str:
    return "; ".join(text for text in (check.damping_rule, check.caveat) if text)


def rocking_cell(rotation: float | None) -> Cell:
    return NO_ROCKING if rotation == 0 else rotation


def uplift_cell(at: float | None) -> Cell:
    """Return the multiplier [-] or PGA [g] at uplift; "none" where joints have no threshold of uplift."""
    return NONE if at is None else at
