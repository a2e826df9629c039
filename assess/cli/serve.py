"""The command that serves the page in the browser: `serve`."""

from __future__ import annotations

import threading
from functools import partial
from pathlib import Path
from typing import Annotated

import typer

from assess.cli.options import flag, folder_option
from assess.cli.stderr import on_interruption, print_note, progress


def serve(
    source: Annotated[
        Path, typer.Argument(metavar="PROJECT|MODEL", help="A project, or an IFC or mesh to make one from.")
    ],
    output: Annotated[
        Path | None,
        folder_option("Of a model: folder to create for its project (default: NAME-project beside the model)."),
    ] = None,
    port: Annotated[int, typer.Option(metavar="N", min=0, max=65535, help="Port of the address; 0: any free one.")] = 0,
    no_open: Annotated[bool, flag("--no-open", "Print the address only, and open no browser.")] = False,
) -> None:
    """Show a building and its mechanisms in the browser, and what changes as cracks and values move.

    The page is on this machine alone, at the address printed, which holds a secret. It ends with Ctrl-C; what was
    written to the project file stays.
    """
    from assess.page.page import open_page

    with on_interruption("what was written to the project file stays"):
        with progress() as shown:
            shown.step("building")
            project = _project_of(source, output)
        with open_page(project, port=port, tell=partial(_tell, opens=not no_open)):
            threading.Event().wait()


def _tell(address: str, *, opens: bool) -> None:
    """Print the address of the page, and open it in a browser."""
    print(address, flush=True)
    if opens:
        import webbrowser

        webbrowser.open(address)


def _project_of(source: Path, output: Path | None) -> Path:
    """Return the project to be shown; of a model, one that is made for it."""
    from assess.geometry.formats.readers import READERS

    if not (source.is_file() and source.suffix.lower() in READERS):
        if output is not None:
            raise typer.BadParameter("-o is of a model; a project is written where it is")
        return source
    from assess.project.drawn_project import PROJECT, write_project

    folder = output or source.parent / f"{source.stem}-project"
    write_project([source], folder)
    print_note(f"made {folder / PROJECT} of {source.name}")
    return folder
