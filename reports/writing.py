"""Every file of the report, from the results alone."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Literal

from assess.results import Results
from reports.asked import as_asked
from reports.assessment import assessment
from reports.csv import write_csv
from reports.document import Document
from reports.html import write_html
from reports.pdf import write_pdf
from reports.png import write_png
from reports.spreadsheet import write_xlsx
from reports.svg import Picture, picture, write_svg
from reports.vector import Traced, traced

Form = Literal["svg", "png"]


def write_all(
    results: Results,
    folder: Path,
    *,
    figures: Sequence[Form] = ("svg",),
    progress: Callable[[str], None] | None = None,
) -> Path:
    """Write report.pdf, report.html, tables.xlsx, tables/*.csv and figures/* into the empty `folder`.

    figures : in which forms they are written
    Returns the path of the PDF.
    """
    return write_document(assessment(results), folder, name="report.pdf", figures=figures, progress=progress)


def write_document(
    document: Document,
    folder: Path,
    *,
    name: str,
    figures: Sequence[Form] = ("svg",),
    progress: Callable[[str], None] | None = None,
) -> Path:
    """Write a document into the empty `folder` in every form, its PDF called `name`, its page alike; the PDF's path."""
    document, say = as_asked(document), progress or (lambda _: None)
    for name_of_folder in ("tables", "figures"):
        (folder / name_of_folder).mkdir(exist_ok=True)
    say("tables")
    write_csv(document, folder / "tables")
    write_xlsx(document, folder / "tables.xlsx")
    say("figures")
    drawings = traced(document)
    pictures = {figure: picture(drawing) for figure, drawing in drawings.items()}
    _write_figures(drawings, pictures, folder / "figures", forms=figures, creator=document.program)
    say("report")
    write_html(document, (folder / name).with_suffix(".html"), pictures=pictures)
    return write_pdf(document, folder / name, drawings=drawings)


def _write_figures(
    drawings: Mapping[str, Traced],
    pictures: Mapping[str, Picture],
    folder: Path,
    *,
    forms: Sequence[Form],
    creator: str,
) -> None:
    for name, drawing in drawings.items():
        if "svg" in forms:
            write_svg(pictures[name], folder / f"{name}.svg", creator=creator)
        if "png" in forms:
            write_png(drawing, folder / f"{name}.png", creator=creator)
