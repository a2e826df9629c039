"""The models that bodies are taken from: each file read once, only the selected elements meshed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from assess.errors import GeometryError
from assess.geometry.formats.element_selection import MAX_LISTED, list_names, select_elements, short_name
from assess.geometry.formats.mesh_file import Part, Up
from assess.geometry.formats.readers import mesh_elements, read
from assess.messages.message import Message, note, whole_number
from assess.messages.plural import first_names


@dataclass(frozen=True)
class Model:
    """What a body takes of a file.

    Attributes
    ----------
    file : where it was read from
    parts : the meshes of the elements that it takes
    unit : length of the file's unit [m]; None where the format does not say
    up : which axis points up; None where the format does not say
    warnings : which elements became one body, and what may be missing
    """

    file: Path
    parts: tuple[Part, ...]
    unit: float | None = None
    up: Up | None = None
    warnings: tuple[Message, ...] = ()


Selection = tuple[
    Path, str | None
]  # a file, and which of its elements: a name, identifier, class or pattern; None: all
Models = Mapping[Selection, Model]


def read_models(asked: Mapping[str, Selection]) -> Models:
    """Read what each body takes of its file; every file is read once.

    Parameters
    ----------
    asked : file and elements by name of the body

    Raises
    ------
    GeometryError : a file cannot be read, has no such elements, or has no mesh for one of those selected
    """
    found: dict[Selection, Model] = {}
    for file in dict.fromkeys(path for path, _ in asked.values()):
        found |= _read_one({name: element for name, (path, element) in asked.items() if path == file}, file)
    return found


def _read_one(elements: Mapping[str, str | None], file: Path) -> Models:
    """Read what bodies take of one file; elements: those selected, by name of the body."""
    places_named = {name: f'body "{name}": mesh {file.name}' for name in elements}
    first = next(iter(places_named.values()))
    content = read(file, where=first)
    places = {
        name: select_elements(content.elements, element, where=places_named[name]) for name, element in elements.items()
    }
    wanted = sorted({place for each in places.values() for place in each})
    parts = dict(zip(wanted, mesh_elements(content, wanted, file=file, where=first), strict=True))
    found = {}
    for name, element in elements.items():
        taken = tuple(parts[place] for place in places[name])
        _refuse_unmeshed(taken, where=places_named[name])
        found[file, element] = Model(
            file,
            taken,
            content.unit,
            content.up,
            (*(() if element is None else _join_warnings(taken)), *_mesh_warnings(taken)),
        )
    return found


def _join_warnings(parts: Sequence[Part]) -> tuple[Message, ...]:
    """Note where several elements become one body."""
    if len(parts) < 2:
        return ()
    names = first_names([short_name(each.element.shown) for each in parts], MAX_LISTED)
    return (note("elements-joined", number=whole_number(len(parts)), names=names),)


def _mesh_warnings(parts: Sequence[Part]) -> tuple[Message, ...]:
    """Warn of what may be missing of elements."""
    return tuple(
        note("element-incomplete", element=short_name(each.element.shown), what=each.warning)
        for each in parts
        if each.warning is not None
    )


def _refuse_unmeshed(parts: Sequence[Part], *, where: str) -> None:
    """Raise where a selected element has no mesh."""
    bare = [each for each in parts if each.fault]
    if bare:
        one = bare[0].element
        known = f" ({one.identifier})" if one.identifier and one.shown != one.identifier else ""
        more = (
            f" (and {len(bare) - 1} more: {list_names([each.element.shown for each in bare[1:]])})" if bare[1:] else ""
        )
        raise GeometryError(f'{where}: element "{short_name(one.shown)}"{known}{more}: {bare[0].fault}')
