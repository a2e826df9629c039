"""The option of commands that draw one figure."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

ENDINGS = (".svg", ".pdf", ".png")
FigurePath = Annotated[
    Path | None, typer.Option("-o", "--output", metavar="FIGURE", help="Draw it: a name in .svg, .pdf or .png.")
]


def refuse_figure(output: Path | None) -> None:
    """Raise BadParameter for a name that does not end as a figure does, and for a folder that is not there."""
    if output is not None and output.suffix.lower() not in ENDINGS:
        raise typer.BadParameter(f"{output}: a figure is written as {', '.join(ENDINGS)}; end its name so")
    if output is not None and not output.parent.is_dir():
        raise typer.BadParameter(f"{output}: there is no folder {output.parent}; make it first")
