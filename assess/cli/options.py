"""Arguments and options that several commands share, checked as they are parsed, whether or not a file needs them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

FIGURE_ENDINGS = (".svg", ".pdf", ".png")


def limit_jobs(asked: int | None) -> int | None:
    """Limit the number of processes to the cores of the machine; more would only wait for each other."""
    from assess.workers import available_cores

    return None if asked is None else min(asked, available_cores())


ProjectPath = Annotated[
    Path, typer.Argument(metavar="PROJECT", help="The project file, or the folder that contains project.toml.")
]
FigurePath = Annotated[
    Path | None, typer.Option("-o", "--output", metavar="FIGURE", help="Draw a figure: a .svg, .pdf or .png file.")
]
Jobs = Annotated[
    int | None,
    typer.Option(
        "--jobs",
        metavar="N",
        min=1,
        callback=limit_jobs,
        help="Number of processor cores to use, at most those of the machine (default: all).",
    ),
]


def folder_option(words: str) -> Any:
    """Return the option -o of a command that writes into a folder."""
    return typer.Option("-o", "--output", metavar="DIR", help=words)


def flag(name: str, words: str) -> Any:
    """Return an option that is given or not."""
    return typer.Option(name, help=words)


def refuse_both(*, as_json: bool, as_csv: bool) -> None:
    """Raise BadParameter where two formats are requested."""
    if as_json and as_csv:
        raise typer.BadParameter("--json and --csv exclude each other")


def refuse_figure(output: Path | None) -> None:
    """Raise BadParameter for a figure's path with another extension, or in a folder that does not exist."""
    if output is not None and output.suffix.lower() not in FIGURE_ENDINGS:
        raise typer.BadParameter(f"{output}: a figure is written as {', '.join(FIGURE_ENDINGS)}; use one of these")
    if output is not None and not output.parent.is_dir():
        raise typer.BadParameter(f"{output}: the folder {output.parent} does not exist; create it first")


def check_share(number: float) -> float:
    """Return a number; raise BadParameter unless it is from 0 to 1."""
    if not 0.0 <= number <= 1.0:
        raise typer.BadParameter(f"{number:g}; it must be from 0 to 1")
    return number


def check_damping(damping: float) -> float:
    """Return a damping ratio; raise BadParameter for one that is impossible."""
    if not 0.0 <= damping < 1.0:
        raise typer.BadParameter(f"{damping:g}; it must be at least 0 and below 1")
    return damping
