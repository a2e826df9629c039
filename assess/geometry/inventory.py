"""The parts of a model file, with size and place, and whether each can be a body."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from assess.errors import GeometryError
from assess.geometry.formats.element_selection import select_elements
from assess.geometry.formats.mesh_file import Element, Part, Up
from assess.geometry.formats.readers import mesh_elements, read
from assess.geometry.mesh import assemble_mesh, solid_of
from assess.geometry.models import Model
from assess.geometry.plausibility import size_warning
from assess.geometry.thickness import extents, thin_direction
from assess.messages.message import Message

Sizes = tuple[float, float, float]


@dataclass(frozen=True)
class Entry:
    """One part of a model.

    Attributes
    ----------
    file : name of the file
    element : what the file calls it
    triangles : how many it has
    size : thickness along `thin`, length across it, height [m]; None without a mesh
    place : middle of its box in plan and its lowest point, x, y, z [m]; None without a mesh
    volume : enclosed [m3]; None unless closed
    closed : whether it is a closed body, or was made one
    why_not : why it is none; empty where it is one
    warnings : what was done to close it, and what to look at
    thin : horizontal unit vector along the thickness, either way; None where the plan has none
    """

    file: str
    element: Element
    triangles: int = 0
    size: Sizes | None = None
    place: Sizes | None = None
    volume: float | None = None
    closed: bool = False
    why_not: str = ""
    warnings: tuple[Message, ...] = ()
    thin: tuple[float, float] | None = None


def inventory(
    file: Path, *, scale: float | None = None, up: Up | None = None, element: str | None = None
) -> tuple[Entry, ...]:
    """List the parts of a model file in order; what is wrong with a part is recorded in its entry.

    Parameters
    ----------
    file : of any known format
    scale : length of the file's unit [m]; the file's own if absent, the metre where it has none
    up : the axis of the file that points up; the format's if absent
    element : only elements of this name, identifier, class or pattern

    Raises
    ------
    GeometryError : the file as a whole cannot be read, has no parts, or no such element
    """
    content = read(file, where=str(file))
    places = select_elements(content.elements, element, where=str(file))
    if not places:
        raise GeometryError(f"{file}: there are no meshes in it, and no solids or surfaces to mesh")
    parts = mesh_elements(content, places, file=file, where=str(file))
    return tuple(
        _entry(
            Model(file, (part,), content.unit, content.up, () if part.warning is None else (part.warning,)),
            part,
            scale=scale,
            up=up,
        )
        for part in parts
    )


def _entry(model: Model, part: Part, *, scale: float | None, up: Up | None) -> Entry:
    """Describe one part."""
    name, element = model.file.name, part.element
    if part.fault:
        return Entry(name, element, why_not=part.fault)
    try:
        vertices, triangles = assemble_mesh(model, model.parts, scale=scale, up=up, where="")
    except GeometryError as problem:
        return Entry(name, element, len(part.triangles), why_not=_reason(problem, name))
    thin, used = thin_direction(vertices, triangles), vertices[np.unique(triangles)]
    low, high = used.min(axis=0), used.max(axis=0)
    middle = (low + high) / 2.0
    try:
        solid = solid_of(model, density=1.0, name="", scale=scale, up=up)
        found = size_warning(replace(solid, name=element.shown), unit=scale or (1.0 if model.unit is None else None))
        about_size = [] if found is None else [found]
        warnings, why, volume = (*solid.history, *about_size), "", solid.mass
    except GeometryError as problem:
        warnings, why, volume = (), _reason(problem, name), None
    return Entry(
        name,
        element,
        len(triangles),
        size=extents(used, thin),
        place=(float(middle[0]), float(middle[1]), float(low[2])),
        volume=volume,
        closed=volume is not None,
        why_not=why,
        warnings=warnings,
        thin=None if thin is None else (float(thin[0]), float(thin[1])),
    )


def _reason(problem: GeometryError, file: str) -> str:
    return _plain(str(problem), file)


def _plain(sentence: str, file: str) -> str:
    """Remove the subject from a sentence about an unnamed body."""
    for start in ('body ""', f": mesh {file}", ": "):
        sentence = sentence.removeprefix(start)
    return sentence.strip()
