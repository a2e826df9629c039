"""`assess new`: an example to start from."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer


def new(
    folder: Annotated[
        Path | None, typer.Argument(metavar="DIR", help="The folder to make; it must not exist yet, or be empty.")
    ] = None,
    example: Annotated[
        str, typer.Option("--example", metavar="NAME", help="Which example; --list shows them.")
    ] = "casa_grande",
    list_examples: Annotated[bool, typer.Option("--list", help="List the examples and end.")] = False,
) -> None:
    """Make a runnable example project to start from."""
    from assess.examples import EXAMPLES, copy_example

    if list_examples:
        for name, each in EXAMPLES.items():
            print(f"{name:20} {each.about}")
        return
    if folder is None:
        raise typer.BadParameter("give the folder to make, or --list")
    print(copy_example(example, folder))
