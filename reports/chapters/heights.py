"""The height of each base above the ground, and of the point where the input acts."""

from __future__ import annotations

from assess.results import MechanismResult, Results
from reports.chapters.check_tables import MECHANISM
from reports.document import Cell, Column, Table
from reports.mechanism_title import mechanism_title

COLUMNS = (
    MECHANISM,
    Column("Base above the ground", "m", "number"),
    Column("Input acts at", "m", "number"),
    Column("Counts as"),
    Column("Histories amplified by"),
    Column("Ground level from"),
)


def table(results: Results) -> Table:
    """Tabulate the heights of the mechanisms whose elevation is known."""
    caption = (
        "Height of each base above the ground. For a mechanism above the ground, the ground motion can "
        "make a check fail but cannot make it pass. The input acts at the height of the supports: the "
        "base, or the mean of base and top where the mechanism is supported at both."
    )
    rows = tuple(_row(mechanism) for mechanism in results.mechanisms if mechanism.base_elevation_m is not None)
    return Table("heights", caption, COLUMNS, rows)


def _row(mechanism: MechanismResult) -> tuple[Cell, ...]:
    counts = "above the ground" if mechanism.above_ground else "on the ground"
    carried = mechanism.amplification.method
    heights = (mechanism.base_elevation_m, mechanism.input_height_m)
    return (mechanism_title(mechanism), *heights, counts, carried, mechanism.ground_known_from)
