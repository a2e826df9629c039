"""One figure as a file of its own: SVG, PDF or PNG by its ending."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from matplotlib.figure import Figure

from assess.outputs.single import write_file
from reports.figures.style import report_style
from reports.render.png import write_png
from reports.render.svg import picture, write_svg
from reports.render.vector import trace_figure


def _svg(figure: Figure, path: Path, creator: str) -> None:
    write_svg(picture(trace_figure(figure)), path, creator=creator)


def _pdf(figure: Figure, path: Path, creator: str) -> None:
    with report_style():
        figure.savefig(path, format="pdf", metadata={"Creator": creator, "CreationDate": None})


def _png(figure: Figure, path: Path, creator: str) -> None:
    write_png(trace_figure(figure), path, creator=creator)


WRITERS: Mapping[str, Callable[[Figure, Path, str], None]] = {".svg": _svg, ".pdf": _pdf, ".png": _png}


def write_figure(figure: Figure, path: Path, *, creator: str) -> Path:
    """Write a figure to a file, whole or not at all.

    Parameters
    ----------
    figure : drawn in the report's style
    path : its ending names the form: a key of WRITERS
    creator : name and version of the program, for the properties of the file

    Returns
    -------
    Path
        the path written
    """
    with write_file(path, command="a command that draws a figure") as made:
        WRITERS[path.suffix.lower()](figure, made, creator)
    return path
