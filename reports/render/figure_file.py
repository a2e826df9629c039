"""One figure as a file of its own: SVG, PDF or PNG by its ending."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from matplotlib.figure import Figure

from assess.outputs.writing import write_file
from reports.figures.style import report_style
from reports.render.vector import svg_picture, trace_figure, write_svg

DPI = 200


def _svg(figure: Figure, path: Path, creator: str) -> None:
    write_svg(svg_picture(trace_figure(figure)), path, creator=creator)


def _pdf(figure: Figure, path: Path, creator: str) -> None:
    with report_style():
        figure.savefig(path, metadata={"Creator": creator, "CreationDate": None})


def write_png(figure: Figure, path: Path, creator: str) -> None:
    """Write a figure as pixels. creator: name and version of the program."""
    with report_style():
        figure.savefig(path, dpi=DPI, metadata={"Software": creator})


WRITERS: Mapping[str, Callable[[Figure, Path, str], None]] = {".svg": _svg, ".pdf": _pdf, ".png": write_png}


def write_figure(figure: Figure, path: Path, *, creator: str) -> Path:
    """Write a figure in the report's style to a file, whole or not at all.

    Parameters
    ----------
    figure : of matplotlib
    path : its ending names the form
    creator : for the metadata of the file

    Returns
    -------
    Path
        The path written.
    """
    with write_file(path, command="a command that draws a figure") as made:
        WRITERS[path.suffix.lower()](figure, made, creator)
    return path
