"""Every file of the report, from the results alone."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Literal

from assess.results import Results
from assess.workers import available_cores
from reports.assessment import Detail, assessment, locale_of
from reports.document import Document
from reports.render.csv import write_csv
from reports.render.html import write_html
from reports.render.pdf import write_pdf
from reports.render.spreadsheet import write_xlsx
from reports.render.table_text import program_and_stamp
from reports.render.vector import document_processes, svg_picture, trace_figures, write_png, write_svg

Form = Literal["svg", "png"]


def write_all(
    results: Results,
    folder: Path,
    *,
    language: str | None = None,
    detail: Detail | None = None,
    figures: Sequence[Form] = ("svg",),
    jobs: int = 0,
    progress: Callable[[str], None] | None = None,
) -> Path:
    """Write report.pdf, report.html, tables.xlsx, tables/*.csv and figures/* into the empty `folder`; return the PDF.

    Parameters
    ----------
    results : of a run
    folder : an empty one
    language : "en" or "it"; that of the project if None
    detail : "main", or "full" with the annexes; that of the project if None
    figures : forms in which they are written
    jobs : processes to use, 0 for as many as there are cores; the files are the same
    progress : called with the name of each stage as it begins
    """
    document = replace(assessment(results, detail=detail), locale=locale_of(results, language))
    return write_document(document, folder, name="report.pdf", figures=figures, jobs=jobs, progress=progress)


def write_document(
    document: Document,
    folder: Path,
    *,
    name: str,
    figures: Sequence[Form] = ("svg",),
    jobs: int = 0,
    progress: Callable[[str], None] | None = None,
) -> Path:
    """Write a document in its locale into the empty `folder` in every form; return the PDF.

    Parameters
    ----------
    document : of any chapters
    folder : an empty one
    name : of the PDF
    figures, jobs, progress : as of `write_all`
    """
    report_stage = progress or (lambda _: None)
    for part in ("tables", "figures"):
        (folder / part).mkdir(exist_ok=True)
    creator = document.locale.text(program_and_stamp(document))
    with document_processes(jobs or available_cores(), document) as submit:
        report_stage("figures")
        drawings = trace_figures(document, submit)
        tables = submit(_write_tables, folder)
        report_stage("report")
        path = write_pdf(document, folder / name, drawings=drawings)
        pictures = {figure: svg_picture(drawing.result()) for figure, drawing in drawings.items()}
        for figure in pictures if "svg" in figures else ():
            write_svg(pictures[figure], folder / "figures" / f"{figure}.svg", creator=creator)
        pngs = [submit(_write_png, place, folder / "figures", creator) for place in _places(document, figures)]
        write_html(document, path.with_suffix(".html"), pictures=pictures)
        report_stage("tables")
        for each in (tables, *pngs):
            each.result()
    return path


def write_pages(document: Document, folder: Path, *, name: str, jobs: int = 0) -> Path:
    """Write a document in its locale into `folder` as PDF and HTML alone; return the PDF.

    Parameters
    ----------
    document : of any chapters
    folder : to write into
    name : of the PDF
    jobs : processes to use, 0 for as many as there are cores; the files are the same
    """
    with document_processes(jobs or available_cores(), document) as submit:
        drawings = trace_figures(document, submit)
        path = write_pdf(document, folder / name, drawings=drawings)
        pictures = {figure: svg_picture(drawing.result()) for figure, drawing in drawings.items()}
    write_html(document, path.with_suffix(".html"), pictures=pictures)
    return path


def _write_tables(document: Document, folder: Path) -> None:
    write_csv(document, folder / "tables")
    write_xlsx(document, folder / "tables.xlsx")


def _places(document: Document, forms: Sequence[Form]) -> range:
    """Return the places of the figures of which there is to be a PNG file."""
    return range(len(document.figures) if "png" in forms else 0)


def _write_png(document: Document, place: int, folder: Path, creator: str) -> None:
    figure = document.figures[place]
    write_png(figure.draw(document.writer), folder / f"{figure.name}.png", creator)
