"""Every file of the report, from the results alone."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path

from matplotlib.figure import Figure as Drawn

from assess.results import Results
from reports.assessment import assessment
from reports.csv import write_csv
from reports.document import Block, Document, Figure
from reports.pdf import write_pdf
from reports.spreadsheet import write_xlsx
from reports.style import settled, styled


def write_all(results: Results, folder: Path, *, progress: Callable[[str], None] | None = None) -> Path:
    """Write report.pdf, tables.xlsx, tables/*.csv and figures/*.svg into the empty `folder`; the path of the PDF."""
    say = progress or (lambda _: None)
    document = drawn(assessment(results))
    for name in ("tables", "figures"):
        (folder / name).mkdir(exist_ok=True)
    say("tables")
    write_csv(document, folder / "tables")
    write_xlsx(document, folder / "tables.xlsx")
    say("figures")
    write_svg(document, folder / "figures")
    say("report")
    return write_pdf(document, folder / "report.pdf")


def drawn(document: Document) -> Document:
    """The document with its figures drawn: each is made once for all renderers, when it is first asked for."""
    return replace(document, sections=tuple(replace(part, blocks=_drawn(part.blocks)) for part in document.sections))


def _drawn(blocks: tuple[Block, ...]) -> tuple[Block, ...]:
    return tuple(replace(each, draw=_once(each.draw)) if isinstance(each, Figure) else each for each in blocks)


def _once(draw: Callable[[], Drawn]) -> Callable[[], Drawn]:
    @cache
    def made() -> Drawn:
        with styled():
            return settled(draw())

    return made


def write_svg(document: Document, folder: Path) -> tuple[Path, ...]:
    """Write every figure into `folder` as name.svg, without dates; the paths written."""
    paths = []
    for figure in document.figures:
        path = folder / f"{figure.name}.svg"
        with styled():
            figure.draw().savefig(path, format="svg", metadata={"Date": None, "Creator": document.program})
        paths.append(path)
    return tuple(paths)
