"""A suite of records for the terminal, as CSV, as JSON and as a figure."""

from __future__ import annotations

from pathlib import Path

from assess.cli.tables import messages_text, text_table
from assess.project.suites import ScaledSuite
from assess.results import RecordResult
from assess.results.json import dumps_suite
from assess.results.provenance import origin
from reports.chapters.suite import event_name, requirements_table, selection_sentences
from reports.document import Cell, Column
from reports.figures.spectrum import draw_beside_target
from reports.figures.style import WIDTH
from reports.language.locale import Locale
from reports.language.texts import Verbatim
from reports.render.csv import csv_lines
from reports.render.table_text import cell_text
from reports.render.vector import write_figure

SUITE_HEADER = ("record", "event", "NGA", "M", "comp.", "misfit", "factor", "PGA [g]")


def suite_table(suite: ScaledSuite) -> str:
    """Write the records as in thesis Table 8.8, how they were selected, and the code rules of the suite."""
    motion = suite.motion
    steps = () if motion.selection is None else motion.selection.remaining
    left = "; ".join(f"{one.number} {one.step}" for one in steps)
    written = "\n".join([*map(Locale().text, selection_sentences(motion)), *([f"Candidates: {left}."] if left else [])])
    requirements = [_requirement_row(row) for row in requirements_table(motion).rows]
    columns = ("requirement", "clause", "code", "found", "limit", "periods", "met")
    return (
        "\n".join(
            (
                text_table(SUITE_HEADER, [_row(record) for record in suite.records]),
                f"{written}\n",
                text_table(columns, requirements),
                messages_text(suite.messages),
            )
        ).rstrip("\n")
        + "\n"
    )


def suite_csv(suite: ScaledSuite) -> str:
    """Write the records at full precision, under their names of results.json."""
    names = (
        "id", "path", "event", "date", "station", "component", "nga", "magnitude", "distance_km", "vs30_m_per_s",
        "dt_s", "npts", "mse", "scale_factor", "pga_g",
    )  # fmt: skip
    return csv_lines([names, *([getattr(record, name) for name in names] for record in suite.records)])


def suite_json(suite: ScaledSuite) -> str:
    """Write `records` and `ground_motion` of results.json."""
    return dumps_suite(suite.records, suite.motion)


def draw_suite(suite: ScaledSuite, path: Path) -> None:
    """Draw target, records and their mean to `path`."""
    write_figure(
        draw_beside_target(suite.motion, suite.records, (), Locale(), width=WIDTH),
        path,
        creator=origin("records select", suite_json(suite)),
    )


def _row(record: RecordResult) -> list[str]:
    known = ["-" if each is None else f"{each:g}" for each in (record.nga, record.magnitude)]
    numbers = [f"{record.mse:.4f}", f"{record.scale_factor:.4g}", f"{record.pga_g:.4g}"]
    return [record.id, event_name(record), *known, record.component, *numbers]


def _requirement_row(row: tuple[Cell, ...]) -> list[str]:
    """Return a requirement without its remark."""
    code, clause, what, *found, _ = (cell_text(cell, Column(Verbatim("")), Locale()) for cell in row)
    return [what, clause, code, *found]
