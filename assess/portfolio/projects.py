"""The projects of a portfolio: those below a folder, or one for each row of a table that changes a template."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class Task(ShortRepr):
    """One project of a portfolio.

    Attributes
    ----------
    key : str
        The path below the folder, or the row's id in the table; any text, not fit for a path.
    title : str
        What the project is called.
    path : Path
        The project file, or the template that the row changes; absolute.
    content : str or None
        What the row changes in the template, as JSON text; None for a project file. `project_tree` applies it.
    sha256 : str
        Of everything the project is made of: its file or template, the row, and the files they name.
    """

    key: str
    title: str
    path: Path
    content: str | None
    sha256: str


def find_tasks(source: Path, template: Path | None = None) -> tuple[Task, ...]:
    """Return the projects below a folder, or those that the rows of a table make of a template.

    Parameters
    ----------
    source : Path
        A folder, or a table as CSV.
    template : Path or None
        The project file whose values the table changes; None for a folder.

    Raises
    ------
    ProjectError
        If the folder holds no project, or the table's header or the template cannot be used.
    """
    raise NotImplementedError


def project_tree(task: Task) -> dict[str, Any]:
    """Return what the project file of a task says, with the values of its row.

    Raises
    ------
    ProjectError
        If the row has a value that cannot stand there.
    """
    raise NotImplementedError
