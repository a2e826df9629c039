"""Every file of the report, from the results alone."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from assess.results import Results
from reports.assessment import assessment
from reports.csv import write_csv
from reports.document import Document
from reports.pdf import write_pdf
from reports.spreadsheet import write_xlsx
from reports.svg import write_svg
from reports.vector import Traced, traced


def write_all(results: Results, folder: Path, *, progress: Callable[[str], None] | None = None) -> Path:
    """Write report.pdf, tables.xlsx, tables/*.csv and figures/*.svg into the empty `folder`; the path of the PDF."""
    return write_document(assessment(results), folder, name="report.pdf", progress=progress)


def write_document(
    document: Document, folder: Path, *, name: str, progress: Callable[[str], None] | None = None
) -> Path:
    """Write a document into the empty `folder` in every form, its PDF called `name`; the path of the PDF."""
    say = progress or (lambda _: None)
    for name_of_folder in ("tables", "figures"):
        (folder / name_of_folder).mkdir(exist_ok=True)
    say("tables")
    write_csv(document, folder / "tables")
    write_xlsx(document, folder / "tables.xlsx")
    say("figures")
    drawings = traced(document)
    write_figures(drawings, folder / "figures", creator=document.program)
    say("report")
    return write_pdf(document, folder / name, drawings=drawings)


def write_figures(drawings: Mapping[str, Traced], folder: Path, *, creator: str) -> tuple[Path, ...]:
    """Write every figure into `folder` as name.svg; the paths written."""
    return tuple(write_svg(traced, folder / f"{name}.svg", creator=creator) for name, traced in drawings.items())
