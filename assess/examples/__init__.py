"""Runnable projects shipped with the program: a folder each in projects/, and a module for what is made by code."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path

from assess.errors import ProjectError
from assess.examples import casa_grande, house, street, surfaces
from assess.examples.surfaces import ClosedSurface, ply
from assess.outputs.writing import new_folder

SCHEMA = "project.schema.json"
"""The schema of project files, beside that of an example: editors that know `#:schema` check and complete with it."""
Meshes = Callable[[], Mapping[str, ClosedSurface]]


@dataclass(frozen=True)
class Example:
    """A project, or a table of projects, that the program ships.

    about : what it shows, in one line
    meshes : makes its meshes, each by its path in the folder
    tables : makes its tables, each by its path in the folder
    models : makes its models as text files, each by its path in the folder
    file : the project file, or the template of the table
    """

    about: str
    meshes: Meshes = dict
    tables: Callable[[], Mapping[str, str]] = dict
    models: Callable[[], Mapping[str, str]] = dict
    file: str = "project.toml"


EXAMPLES: dict[str, Example] = {
    "casa_grande": Example(
        "Great House of Casa Grande, Arizona: eight mechanisms of eroded walls, two also on flexible joints",
        casa_grande.meshes,
    ),
    "casa_grande_flexible": Example(
        "the same eight mechanisms with rigid and with flexible joints, by spectra", casa_grande.meshes
    ),
    "casa_grande_table": Example("the same eight mechanisms by the parameters of a published table"),
    "chiesa": Example(
        "a small church of our own making: six mechanisms, and the list of the 28 possible", surfaces.facade_meshes
    ),
    "facade": Example(
        "a façade before works and with ties: project.toml, then with-ties.toml, both states on one page"
    ),
    "house": Example(
        "a house as an IFC model: its street front with ties, a gable; the tutorial ends with it",
        models=lambda: {"house.ifc": house.model()},
    ),
    "lnec_houses": Example("brick and stone house of the LNEC shaking-table tests: six mechanisms by a table"),
    "nepal_monuments": Example(
        "columns, tower and temple in the Gorkha earthquake of 2015, the tower also from meshes",
        surfaces.tower_meshes,
    ),
    "san_leonardo_church": Example(
        "church of San Leonardo Limosino, Emilia: apse and façade by tables, a side-aisle vault"
    ),
    "san_leonardo_spire": Example(
        "its spire from a mesh: inclined cracks by height, and a sweep over their angle", surfaces.spire_meshes
    ),
    "san_leonardo_tower": Example(
        "its bell tower: spire, corners and belfry, eleven mechanisms by tables and a frame of blocks"
    ),
    "single_wall": Example("one free-standing wall, as small as a project can be"),
    "street": Example(
        "forty façades of a street: a table with a row for each, and its template, for `assess batch`",
        tables=lambda: {"street.csv": street.table()},
        file="template.toml",
    ),
}


def copy_example(name: str, folder: Path) -> Path:
    """Write an example into a folder, completely or not at all.

    Parameters
    ----------
    name : of the example
    folder : to create

    Returns
    -------
    path of its project file, or of its template
    """
    if name not in EXAMPLES:
        near = get_close_matches(name, EXAMPLES, n=1)
        hint = f'did you mean "{near[0]}"?' if near else f"known: {', '.join(EXAMPLES)}"
        raise ProjectError(f'example "{name}" is not known; {hint}')
    with new_folder(folder, command="assess new") as made:
        _fill(name, made)
    return folder / EXAMPLES[name].file


def source(name: str) -> Path:
    """Return the folder of the example within the program, without its meshes."""
    return Path(__file__).parent / "projects" / name


def _fill(name: str, made: Path) -> None:
    shutil.copytree(source(name), made, dirs_exist_ok=True)
    for path, surface in EXAMPLES[name].meshes().items():
        (made / path).parent.mkdir(exist_ok=True)
        (made / path).write_bytes(ply(surface))
    for path, text in {**EXAMPLES[name].tables(), **EXAMPLES[name].models()}.items():
        (made / path).write_text(text, encoding="utf-8", newline="")
    name_schema(made, EXAMPLES[name].file)


def name_schema(folder: Path, file: str) -> None:
    """Write the schema beside a project file, and name it in the file's first line, where editors look for it.

    Parameters
    ----------
    folder : of the project
    file : its project file
    """
    from assess.project.project_file import schema_text

    (folder / SCHEMA).write_text(schema_text(), encoding="utf-8", newline="\n")
    project = folder / file
    project.write_bytes(f"#:schema ./{SCHEMA}\n".encode() + project.read_bytes())
