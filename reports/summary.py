"""The summary: what the numbers say, and every procedure's answer for every mechanism."""

from __future__ import annotations

from assess.codes.check import Check
from assess.results import MechanismResult, Results
from reports import findings, governing, inputs, sentences, tables
from reports.document import Block, Cell, Column, Items, Section, Table, Text, filled
from reports.tables import name_of

REFERENCE = "SLV"  # the limit state whose PGA is the level's


def section(results: Results) -> Section:
    """Outcome and findings in words, then the verdicts level by level and the check that governs each procedure."""
    found = findings.findings(results)
    warned: list[Block] = filled(inputs.warnings(results)) or [Text(("The run gave no warnings.",))]
    blocks = (
        Text(sentences.outcome(results)),
        *((Items(found),) if found else ()),
        *filled(governing_checks(results)),
        *own_accelerations(results),
        *filled(tables.brief(results)),
        *warned,
    )
    return Section("Summary", 0, blocks)


def own_accelerations(results: Results) -> tuple[Text, ...]:
    """Which limit states are not checked at the level in the table, where the site has a hazard of its own for them."""
    checks = [check for check in governing.of_all(results) if check.return_period_years is not None]
    states = dict.fromkeys(check.limit_state for check in checks if check.limit_state != REFERENCE)
    if not states:
        return ()
    said = (
        f"The PGA in the tables is that of the level. Limit states {findings.listed(list(states))} have their own PGA "
        "and spectrum by the hazard of the site; their calculation sheets give them."
    )
    return (Text((said,)),)


def governing_checks(results: Results) -> Table:
    """Every mechanism by every procedure, at the level that governs: demand, allowable, ratio, PGA, verdict."""
    columns = (
        tables.MECHANISM,
        tables.PROCEDURE,
        Column("at PGA", "g", "number"),
        *tables.ANSWER,
        Column("PGA at uplift", "g", "number"),
        Column("PGA at capacity", "g", "number"),
        Column("Verdict", kind="verdict"),
    )
    pairs = [(mechanism, check) for mechanism in results.mechanisms for check in _worst_of_code(mechanism)]
    caption = "Every mechanism by every code procedure, at the level that governs."
    rows = tuple(_row(mechanism, check) for mechanism, check in pairs)
    return Table("governing-checks", caption, columns, rows)


def _worst_of_code(mechanism: MechanismResult) -> tuple[Check, ...]:
    return governing.of_code(governing.worst_per_procedure(mechanism))


def _row(mechanism: MechanismResult, check: Check) -> tuple[Cell, ...]:
    named, quantity, demand, capacity, ratio = tables.numbers(check, mechanism.checks)
    accelerations = (tables.uplift(check.uplift_pga_g), check.capacity_pga_g)
    return (
        name_of(mechanism),
        named,
        check.level_pga_g,
        quantity,
        demand,
        capacity,
        check.unbounded or ratio,
        *accelerations,
        check.verdict,
    )
