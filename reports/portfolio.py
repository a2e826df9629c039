"""The ranked table of a portfolio: which of many projects comes first, as a page, a workbook and a CSV file."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path

from assess.portfolio.tasks import ProjectRow, rank
from assess.results.provenance import describe_program
from reports.chapters.cells import LIMIT_STATE, METHOD, OUTCOME, OUTCOMES, RATIO
from reports.document import Column, Document, Field, Figure, Link, OutcomeCell, Prose, Section, Table, tabulate
from reports.figures.portfolio import draw_margins
from reports.language.locale import Locale, System
from reports.language.texts import Phrase, Text, Verbatim, count, say
from reports.mechanisms import short_title
from reports.render.html import write_html
from reports.render.spreadsheet import write_xlsx
from reports.render.table_text import plain_tables, write_csv
from reports.render.vector import svg_picture, trace_figure

NAME = "ranked"
FILES = (f"{NAME}.csv", f"{NAME}.xlsx", f"{NAME}.html")
FIGURES = 3
LEAST_DRAWN = 5  # known margins, from which their spread is drawn
COUNTS: Mapping[str, Phrase] = {
    "fail": say("Fail"),
    "incomplete": say("Incomplete"),
    "pass": say("Pass"),
    "broken": say("Broken"),
}
ORDER = say(
    "Projects that fail come first, then those without an answer, then those that pass; within each of these the one "
    "of the least margin first. The margin is the PGA at capacity over that of the action, of the mechanism with the "
    "least; where it is not known, the order follows the inverse of D/C."
)
BROKEN = say(
    "Broken projects could not be assessed: they stand at the end, each with its reason, and are neither a pass nor a "
    "fail."
)
FIELDS: tuple[Field[ProjectRow], ...] = (
    (Column(say("Project")), lambda row: Verbatim(row.key)),
    (Column(say("Title")), lambda row: _name(row.title)),
    (OUTCOME, lambda row: _outcome(row)),
    (Column(say("Margin"), "ratio", FIGURES), lambda row: row.margin),
    (RATIO, lambda row: row.demand_capacity),
    (Column(say("Mechanism")), lambda row: _name(row.worst_mechanism)),
    (LIMIT_STATE, lambda row: _name(row.limit_state)),
    (METHOD, lambda row: short_title(row.procedure) if row.procedure else None),
    (Column(say("Missing inputs")), lambda row: row.missing or None),
    (Column(say("Without a source")), lambda row: _name(row.unsourced)),
    (Column(say("Warnings")), lambda row: row.warnings or None),
    (Column(say("Report")), lambda row: Link(say("report"), row.report) if row.report else None),
    (Column(say("Results")), lambda row: Link(say("results"), row.results) if row.results else None),
    (Column(say("Reason")), lambda row: _name(row.reason)),
)
"""The columns, each with its cell of a row; one without any cell is left out."""


def write_ranking(
    rows: Sequence[ProjectRow], stage: Path, *, language: str | None = None, units: System = "SI"
) -> tuple[Path, ...]:
    """Write the ranked table of a portfolio as CSV, workbook and page.

    Parameters
    ----------
    rows : one for each project, in any order
    stage : an existing folder, to which the links of the rows are relative
    language : "en" or "it"; English where None
    units : "SI" or "US"

    Returns
    -------
    The paths of ranked.csv, ranked.xlsx and ranked.html
    """
    document = _portfolio_report(rows, locale=Locale(system=units) if language is None else Locale(language, units))
    plain = plain_tables(document)
    pictures = {figure.name: svg_picture(trace_figure(figure.draw(document.locale))) for figure in document.figures}
    (table,) = write_csv(document, stage, plain)
    return (
        table,
        write_xlsx(document, stage / f"{NAME}.xlsx", plain),
        write_html(document, stage / f"{NAME}.html", pictures=pictures),
    )


def _portfolio_report(rows: Sequence[ProjectRow], *, locale: Locale) -> Document:
    """Return the ranked table of a portfolio as a document, in a locale."""
    program = describe_program()
    numbers = Counter("broken" if row.status == "broken" else row.outcome or "incomplete" for row in rows)
    facts: list[tuple[Text, Text]] = [(say("Projects"), count(len(rows)))]
    facts += [(label, count(numbers[name])) for name, label in COUNTS.items() if numbers[name]]
    paragraphs = (ORDER, BROKEN) if numbers["broken"] else (ORDER,)
    return Document(
        title=say("Portfolio, ranked"),
        subject=say("Seismic assessment of masonry by rocking dynamics"),
        author="",
        program=f"{program.name} {program.version}",
        paper="A4",
        facts=tuple(facts),
        sections=(Section(say("Ranking"), 0, (Prose(paragraphs), *_margins(rows), _ranked_table(rows))),),
        locale=locale,
    )


def _margins(rows: Sequence[ProjectRow]) -> Iterator[Figure]:
    """Yield the figure of the margins that are known, where there are several."""
    margins = [row.margin for row in rows if row.margin is not None and row.status == "done"]
    if len(margins) >= LEAST_DRAWN:
        caption = say(
            "Projects by their margins, the PGA at capacity over that of the action; the last bar holds all of 2 and "
            "more."
        )
        yield Figure("margins", caption, partial(draw_margins, margins))


def _ranked_table(rows: Sequence[ProjectRow]) -> Table:
    """Return the table of the rows in their order, with what their own table carries beside D/C."""
    ranked = rank(rows)
    beside = 1 + next(place for place, (column, _) in enumerate(FIELDS) if column is RATIO)
    headings = dict.fromkeys(heading for row in rows for heading, _ in row.carried)
    carried: list[Field[ProjectRow]] = [(Column(Verbatim(each)), partial(_carried_cell, each)) for each in headings]
    fields = (*FIELDS[:beside], *carried, *FIELDS[beside:])
    kept = [(column, cell) for column, cell in fields if any(cell(row) is not None for row in ranked)]
    caption = say("Projects in the order of their margins")
    if not kept:
        return Table(NAME, caption, (), (), sifted=True)
    table = tabulate(NAME, caption, kept, ranked)
    numbered = tuple((place, *cells) for place, cells in enumerate(table.rows, start=1))
    return replace(table, columns=(Column(say("Rank")), *table.columns), rows=numbered, sifted=True)


def _carried_cell(heading: str, row: ProjectRow) -> Verbatim | None:
    return _name(dict(row.carried).get(heading, ""))


def _name(text: str) -> Verbatim | None:
    return Verbatim(text) if text else None


def _outcome(row: ProjectRow) -> OutcomeCell:
    """Return the outcome, coloured; a project without a verdict is incomplete."""
    if row.status == "broken":
        return OutcomeCell("comparison", say("broken"))
    outcome = row.outcome or "incomplete"
    return OutcomeCell(outcome, OUTCOMES[outcome])
