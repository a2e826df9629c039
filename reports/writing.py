"""Every file of the report, from the results alone."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from assess.results import Results
from reports.assessment import assessment
from reports.csv import write_csv
from reports.document import Document
from reports.html import write_html
from reports.pdf import write_pdf
from reports.spreadsheet import write_xlsx
from reports.svg import picture, write_svg
from reports.vector import traced


def write_all(results: Results, folder: Path, *, progress: Callable[[str], None] | None = None) -> Path:
    """Write report.pdf, report.html, tables.xlsx, tables/*.csv and figures/*.svg into the empty `folder`.

    Returns the path of the PDF.
    """
    return write_document(assessment(results), folder, name="report.pdf", progress=progress)


def write_document(
    document: Document, folder: Path, *, name: str, progress: Callable[[str], None] | None = None
) -> Path:
    """Write a document into the empty `folder` in every form, its PDF called `name`, its page alike; the PDF's path."""
    say = progress or (lambda _: None)
    for name_of_folder in ("tables", "figures"):
        (folder / name_of_folder).mkdir(exist_ok=True)
    say("tables")
    write_csv(document, folder / "tables")
    write_xlsx(document, folder / "tables.xlsx")
    say("figures")
    drawings = traced(document)
    pictures = {figure: picture(drawing) for figure, drawing in drawings.items()}
    for figure, drawn in pictures.items():
        write_svg(drawn, folder / "figures" / f"{figure}.svg", creator=document.program)
    say("report")
    write_html(document, (folder / name).with_suffix(".html"), pictures=pictures)
    return write_pdf(document, folder / name, drawings=drawings)
