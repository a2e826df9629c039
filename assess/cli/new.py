"""`assess new`: an example to start from."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from assess.cli.completions import examples


def new(
    folder: Annotated[
        Path | None, typer.Argument(metavar="DIR", help="Folder to create; it must be empty or not exist yet.")
    ] = None,
    example: Annotated[
        str,
        typer.Option(
            "--example", metavar="NAME", autocompletion=examples, help="Name of the example; --list shows them."
        ),
    ] = "casa_grande",
    list_examples: Annotated[bool, typer.Option("--list", help="List the examples and exit.")] = False,
) -> None:
    """Create a runnable example project to start from."""
    from assess.examples import EXAMPLES, copy_example

    if list_examples:
        for name, each in EXAMPLES.items():
            print(f"{name:20} {each.about}")
        return
    if folder is None:
        raise typer.BadParameter("give the folder to create, or --list")
    file = copy_example(example, folder)
    print(file)
    for table in EXAMPLES[example].tables():
        print(f"assess batch {file.parent / table} --template {file}")
