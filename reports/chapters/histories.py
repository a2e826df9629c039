"""Tables of the time histories of a mechanism: each record, and the suite at each level."""

from __future__ import annotations

from assess.results import HistoryResult, MechanismResult, SuiteResult
from reports.chapters.check_tables import LEVEL, OVERTURNED, rocking_cell
from reports.document import Cell, Column, Table


def suites(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the statistics of the suite of records at each level."""
    columns = (
        LEVEL,
        Column("Records", kind="number"),
        Column("Overturned", kind="number"),
        Column("Mean φ/φₒᵥ", "-", "number"),
        Column("Median", "-", "number"),
        Column("84 % of records", "-", "number"),
        Column("Largest without overturning", "-", "number"),
    )
    rows = tuple(_statistics(suite) for suite in mechanism.suites)
    caption = (
        "Time histories: the suite of records at each level, the worse polarity of each. Half of the "
        "records do not exceed the median, and 84 % do not exceed the next column; a record that "
        "overturns counts as the largest."
    )
    return Table(name, caption, columns, rows)


def _statistics(suite: SuiteResult) -> tuple[Cell, ...]:
    ratios = (suite.mean_ratio, suite.median_ratio, suite.p84_ratio)
    return (
        suite.level_pga_g,
        suite.n,
        suite.overturned,
        *(_mean(r, suite.overturned) for r in ratios),
        suite.max_ratio,
    )


def _mean(mean_ratio: float | None, overturned: int) -> Cell:
    return OVERTURNED if mean_ratio is None and overturned else mean_ratio


def histories(mechanism: MechanismResult, *, name: str) -> Table:
    """Tabulate the largest response to each record at each level."""
    columns = (
        Column("Record"),
        LEVEL,
        Column("Polarity", kind="number"),
        Column("Scale factor", "-", "number"),
        Column("Amplification", "-", "number"),
        Column("Largest φ", "rad", "number"),
        Column("Largest φ/φₒᵥ", "-", "number"),
        Column("At", "s", "number"),
        Column("Impacts", kind="number"),
        Column("Overturns at", "s", "number"),
    )
    rows = tuple(_history(history) for history in mechanism.histories)
    return Table(name, "Time histories: the largest response to each record, in the worse polarity.", columns, rows)


def _history(history: HistoryResult) -> tuple[Cell, ...]:
    fell = history.overturned
    rotation = OVERTURNED if fell else rocking_cell(history.max_rotation_rad)
    ratio = OVERTURNED if fell else rocking_cell(history.max_rotation_ratio)
    scaling = (history.scale_factor, history.amplification)
    times = (history.time_of_max_s, history.impacts, history.overturning_time_s)
    return (history.record, history.level_pga_g, history.polarity, *scaling, rotation, ratio, *times)
