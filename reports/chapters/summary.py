"""The summary: conclusions, and the answer of every procedure for every mechanism at the site's own action."""

from __future__ import annotations

from assess.codes.check import Check
from assess.results import MechanismResult, Results
from reports import governing
from reports.chapters import check_tables, conclusions, inputs
from reports.document import Block, Cell, Column, Items, Section, Table, Text, nonempty
from reports.language.lists import list_names
from reports.mechanism_title import mechanism_title

REFERENCE = "SLV"  # the limit state whose PGA is the level's


def section(results: Results) -> Section:
    """Return the chapter: conclusions in words, answers of all procedures at the site's own action, warnings."""
    found = conclusions.conclusions(results)
    warned: list[Block] = nonempty(inputs.warnings(results)) or [Text(("The run gave no warnings.",))]
    answers = nonempty(governing_checks(results)) or [Text(("No code procedure gave a result.",))]
    blocks = (*((Items(found),) if found else ()), *answers, *own_pga_note(results), *warned)
    return Section("Summary", 0, blocks)


def own_pga_note(results: Results) -> tuple[Text, ...]:
    """Name the limit states that have a PGA of their own, where the site has a hazard for them."""
    every = (check for mechanism in results.mechanisms for check in governing.code_checks(mechanism.checks))
    checks = [check for check in every if check.return_period_years is not None]
    states = dict.fromkeys(check.limit_state for check in checks if check.limit_state != REFERENCE)
    if not states:
        return ()
    sentence = (
        "The PGA in the tables is that of the level. "
        f"Limit states {list_names(list(states))} have their own PGA and "
        "spectrum by the hazard of the site; their calculation sheets give them."
    )
    return (Text((sentence,)),)


def governing_checks(results: Results) -> Table:
    """Tabulate every mechanism by every procedure at the site's own action."""
    columns = (
        check_tables.MECHANISM,
        check_tables.PROCEDURE,
        Column("Role"),
        *check_tables.DEMAND_COLUMNS,
        Column("PGA at uplift", "g", "number"),
        Column("PGA at capacity", "g", "number"),
        Column("Outcome", kind="verdict"),
    )
    pairs = [
        (mechanism, check)
        for mechanism in results.mechanisms
        for check in governing.worst_per_procedure(governing.code_checks(governing.at_site(results, mechanism)))
    ]
    caption = (
        "Every mechanism by every code procedure at the site’s own action. One procedure decides each "
        "limit state of a mechanism; the others are for comparison."
    )
    rows = tuple(_row(mechanism, check) for mechanism, check in pairs)
    return Table("governing-checks", caption, columns, rows)


def _row(mechanism: MechanismResult, check: Check) -> tuple[Cell, ...]:
    named, quantity, demand, capacity, ratio = check_tables.demand_cells(check, mechanism.checks)
    accelerations = (check_tables.uplift_cell(check.uplift_pga_g), check.capacity_pga_g)
    return (
        mechanism_title(mechanism),
        named,
        check.role,
        quantity,
        demand,
        capacity,
        check.unbounded or ratio,
        *accelerations,
        check.verdict,
    )
