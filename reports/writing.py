"""Every file of the report, from the results alone."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Literal

from assess.results import Results
from reports.assessment import Detail, assessment, locale_of
from reports.document import Document
from reports.render.csv import write_csv
from reports.render.frame_words import origin
from reports.render.html import write_html
from reports.render.pdf import write_pdf
from reports.render.png import write_png
from reports.render.processes import processes
from reports.render.spreadsheet import write_xlsx
from reports.render.svg import Picture, picture, write_svg
from reports.render.vector import FigureMarks, trace_figures

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
    """Write report.pdf, report.html, tables.xlsx, tables/*.csv and figures/* into the empty `folder`.

    Parameters
    ----------
    results : of a run
    folder : an empty one
    language : of the report, "en" or "it"; that of the project if None
    detail : "main", or "full" with the annexes; that of the project if None
    figures : forms in which they are written
    jobs : processes to use, 0 for as many as there are cores; the files are the same
    progress : called with the name of each stage as it begins

    Returns
    -------
    Path
        of the PDF
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
    """Write a document in its locale into the empty `folder` in every form.

    Parameters
    ----------
    document : of any chapters
    folder : an empty one
    name : of the PDF
    figures : forms in which they are written
    jobs : processes to use, 0 for as many as there are cores; the files are the same
    progress : called with the name of each stage as it begins

    Returns
    -------
    Path
        of the PDF
    """
    report_stage = progress or (lambda _: None)
    for part in ("tables", "figures"):
        (folder / part).mkdir(exist_ok=True)
    with processes(jobs or os.cpu_count() or 1, document) as pool:
        report_stage("figures")
        drawings = trace_figures(document, pool=pool)
        tables = pool.submit(_write_tables, folder)
        report_stage("report")
        path = write_pdf(document, folder / name, drawings=drawings)
        creator = document.locale.text(origin(document))
        pictures = {figure: picture(drawing) for figure, drawing in drawings.items()}
        _write_figures(drawings, pictures, folder / "figures", forms=figures, creator=creator)
        write_html(document, path.with_suffix(".html"), pictures=pictures)
        report_stage("tables")
        tables.result()
    return path


def _write_tables(document: Document, folder: Path) -> None:
    write_csv(document, folder / "tables")
    write_xlsx(document, folder / "tables.xlsx")


def _write_figures(
    drawings: Mapping[str, FigureMarks],
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
