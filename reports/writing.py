"""Every file of the report, from the results alone."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from assess.results import Results
from reports.assessment import assessment
from reports.csv import write_csv
from reports.document import Document
from reports.pdf import write_pdf
from reports.spreadsheet import write_xlsx
from reports.style import styled


def write_all(results: Results, folder: Path, *, progress: Callable[[str], None] | None = None) -> Path:
    """Write report.pdf, tables.xlsx, tables/*.csv and figures/*.svg into the empty `folder`; the path of the PDF."""
    say = progress or (lambda _: None)
    document = assessment(results)
    for name in ("tables", "figures"):
        (folder / name).mkdir(exist_ok=True)
    say("tables")
    write_csv(document, folder / "tables")
    write_xlsx(document, folder / "tables.xlsx")
    say("figures")
    write_svg(document, folder / "figures")
    say("report")
    return write_pdf(document, folder / "report.pdf")


def write_svg(document: Document, folder: Path) -> tuple[Path, ...]:
    """Write every figure into `folder` as name.svg, without dates; the paths written."""
    paths = []
    for figure in document.figures:
        path = folder / f"{figure.name}.svg"
        with styled():
            figure.draw().savefig(path, format="svg", metadata={"Date": None, "Creator": document.program})
        paths.append(path)
    return tuple(paths)
