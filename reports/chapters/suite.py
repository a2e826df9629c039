"""The suite of records: its selection, its requirements, and its amplification."""

from __future__ import annotations

from functools import partial

from assess.results import GroundMotionResult, RequirementResult, Results
from reports.document import Block, Column, Figure, Table, Text
from reports.figures import suite
from reports.language.numerals import SIGNS, numeral
from reports.mechanism_title import mechanism_title

VERDICTS = {"met": "yes", "not met": "no", "not answered": "not answered"}


def blocks(results: Results) -> list[Block]:
    """Return the suite's part of the site chapter; none without records."""
    motion = results.ground_motion
    if motion is None:
        return []
    caption = (
        "Mean of the scaled records beside the target (as thesis Fig. 8.14b), with 90 % and 130 % of the target, "
        "limits of codes on the mean, over the periods that the records were fitted to."
    )
    found = (periods(results, motion), selection_steps(motion), amplification(results), requirements(motion))
    return [
        Text(sentences(motion)),
        Figure("suite", caption, partial(suite.draw, motion)),
        *(table for table in found if table.rows),
    ]


def sentences(motion: GroundMotionResult) -> tuple[str, ...]:
    """Return the range of periods, and the rules of the selection."""
    over = (
        f"The records are compared with the target from {motion.from_s:.4g} s to {motion.to_s:.4g} s, both ends "
        f"included ({motion.source}). The mean squared difference of the logarithms of their mean and the target is "
        f"{numeral(motion.misfit)}."
    )
    chosen = motion.selection
    if chosen is None:
        return (over,)
    fits = "the mean of the suite" if chosen.fit == "suite" else "each record by itself"
    kept = "; components of a recording are kept together with one factor" if chosen.components == "together" else ""
    events = "no two of one earthquake" if chosen.one_per_event else "several of one earthquake allowed"
    rule = (
        f"They were chosen so that {fits} fits best, with scale factors from {chosen.least_factor:.4g} to "
        f"{chosen.largest_factor:.4g}, {events}{kept}."
    )
    return (over, rule)


def periods(results: Results, motion: GroundMotionResult) -> Table:
    """Tabulate the equivalent periods of the mechanisms."""
    columns = (Column("Mechanism"), Column("Shortest", "s", "number"), Column("Longest", "s", "number"))
    called = {mechanism.name: mechanism_title(mechanism) for mechanism in results.mechanisms}
    rows = tuple(
        (called.get(one.mechanism, one.mechanism), one.shortest_s, one.longest_s) for one in motion.equivalent_periods
    )
    caption = (
        "Equivalent periods, used as T₁ in the clauses on records because a rocking body has no natural "
        "period: the period of equal work at half the overturning rotation (1/fₑ of ASCE 43-05 A.2), over "
        "both branches."
    )
    return Table("equivalent-periods", caption, columns, rows)


def selection_steps(motion: GroundMotionResult) -> Table:
    """Tabulate the number of records left after each step of the selection."""
    steps = () if motion.selection is None else motion.selection.remaining
    columns = (Column("Records"), Column("Number", kind="number"))
    rows = tuple((one.step, one.number) for one in steps)
    return Table("selection", "Records left after each step of the selection.", columns, rows)


def amplification(results: Results) -> Table:
    """Tabulate the amplification factor of each record at each mechanism (as thesis Table 8.9)."""
    raised = [m for m in results.mechanisms if m.amplification.height_m is not None and m.amplification.factors]
    factors = [{one.record: one.factor for one in m.amplification.factors} for m in raised]
    rows = tuple((r.id, r.event, *(of.get(r.id) for of in factors)) for r in results.records) if raised else ()
    columns = (Column("Record"), Column("Event"), *(Column(mechanism_title(m), "-", "number") for m in raised))
    caption = (
        "Scale factors for the amplification up to the base of each mechanism above the ground (as thesis Table 8.9): "
        "peak acceleration there over that of the ground."
    )
    return Table("amplification", caption, columns, rows)


def requirements(motion: GroundMotionResult) -> Table:
    """Tabulate the requirements of each code on the suite."""
    columns = (
        Column("Code"),
        Column("Clause"),
        Column("Requirement"),
        Column("Found", kind="number"),
        Column("Limit"),
        Column("Periods [s]"),
        Column("Met"),
        Column("Remark"),
    )
    caveats = "; ".join(dict.fromkeys(one.caveat for one in motion.requirements if one.caveat))
    caption = (
        "Requirements of codes on the suite. Histories by ASCE 43-05 and NTC 2018 are evaluated only "
        "where their requirements are met; the others are for information. T₁ is replaced by the smallest "
        f"and the largest equivalent period. Clauses: {caveats}."
    )
    return Table("requirements", caption, columns, tuple(_row(one) for one in motion.requirements))


def _row(one: RequirementResult) -> tuple[str | float | None, ...]:
    unit = "" if one.unit == "-" else f" {one.unit}"
    limit = f"{SIGNS[one.sense]} {one.limit:.4g}{unit}"
    over = "" if one.from_s is None or one.to_s is None else f"{one.from_s:.3g} to {one.to_s:.3g}"
    found = one.value if one.value is None or one.value % 1.0 else int(one.value)
    return (one.code, one.clause, one.what, found, limit, over, VERDICTS[one.verdict], one.remark)
