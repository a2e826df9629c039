"""The arguments that several commands share."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from assess.cli.processes import cores

ProjectPath = Annotated[
    Path, typer.Argument(metavar="PROJECT", help="The project file, or the folder that holds project.toml.")
]


def _within_the_machine(asked: int | None) -> int | None:
    """As many processes as the machine has cores, where more are asked for: more would only wait for each other."""
    return None if asked is None else min(asked, cores())


Jobs = Annotated[
    int | None,
    typer.Option(
        "--jobs",
        metavar="N",
        min=1,
        callback=_within_the_machine,
        help="Processor cores to use, at most those of the machine; all if absent.",
    ),
]
