"""Bodies from mesh files: read, oriented and scaled, repaired where necessary."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from assess.errors import GeometryError
from assess.geometry.formats.element_selection import short_name
from assess.geometry.formats.mesh_file import Part, Up, join_parts
from assess.geometry.formats.readers import WITHOUT_UNIT
from assess.geometry.models import Model, read_models
from assess.geometry.plausibility import refuse_implausible
from assess.geometry.repair import repair
from assess.geometry.self_overlap import self_overlap_warnings
from assess.geometry.solid import Solid, polyhedron
from assess.geometry.surface import Surface, merge_vertices
from assess.messages.message import Message, Quantity, note
from spectra.arrays import FloatArray, IntArray, is_number

FARTHEST = 1e12  # of any unit: no coordinate of a map in any unit is larger
SINGLE = (".glb", ".gltf", ".3dm")  # formats of single precision, beside binary STL and some PLY
HEAD = 2000  # bytes of a file that say which numbers follow
SAME_UNIT = 1e-6  # of a unit: units that differ by less are one


def load(
    path: Path | str,
    *,
    density: float,
    name: str,
    scale: float | None = None,
    up: Up | None = None,
    element: str | None = None,
) -> Solid:
    """Load the solid inside the triangle meshes of a file; its `history` says how they were made one closed surface.

    Vertices at equal positions are merged. A good mesh is not changed otherwise.

    Parameters
    ----------
    path : of the file; its extension gives the format
    density : [kg/m3]
    name : the body's name in the project
    scale : length of the file's unit [m]; the file's own if absent, the metre where it has none
    up : the axis of the file that points up; the format's if absent, z where it has none
    element : only elements of this name, identifier, class or pattern (`formats.element_selection`); all if absent

    Raises
    ------
    GeometryError : the file is missing, of another kind, unreadable, without triangles or such an element; the mesh
        cannot be closed or has no volume; a coordinate is not finite; scale or density is not positive
    """
    file = Path(path)
    model = read_models({name: (file, element)})[file, element]
    return solid_of(model, density=density, name=name, scale=scale, up=up)


def solid_of(model: Model, *, density: float, name: str, scale: float | None = None, up: Up | None = None) -> Solid:
    """Return the solid inside the meshes taken from a file.

    Parameters
    ----------
    model : the meshes
    density : [kg/m3]
    name : the body's name in the project
    scale, up : as in `load`

    Raises
    ------
    GeometryError : as in `load`; where one of several elements is at fault, it is named
    """
    where = f'body "{name}": mesh {model.file.name}'
    try:
        return _solid(model, model.parts, density=density, name=name, scale=scale, up=up, where=where)
    except GeometryError as problem:
        raise _error_of_element(model, density=density, name=name, scale=scale, up=up, where=where) or problem from None


def _solid(
    model: Model,
    parts: Sequence[Part],
    *,
    density: float,
    name: str,
    scale: float | None,
    up: Up | None,
    where: str,
) -> Solid:
    """Return the solid inside some of a model's meshes."""
    _, about_unit = _resolve_unit(model, scale, where=where)
    surface = merge_vertices(*assemble_mesh(model, parts, scale=scale, up=up, where=where))
    if not len(surface[1]):
        raise GeometryError(f"{where}: all its triangles have shrunk to lines or points; export it with more digits")
    surface, repairs = repair(surface, where=where)
    solid = polyhedron(*surface, density=density, name=name)
    unit = scale or model.unit or 1.0
    refuse_implausible(solid, unit=unit, given=scale is not None, single=_is_single_precision(model.file), where=where)
    history = (
        *model.warnings,
        *about_unit,
        *_axis_warnings(model, given=up),
        *repairs,
        *self_overlap_warnings(surface, where=where),
    )
    return replace(solid, history=history)


def assemble_mesh(model: Model, parts: Sequence[Part], *, scale: float | None, up: Up | None, where: str) -> Surface:
    """Assemble some of a model's meshes into one, oriented with z up and in metres.

    Returns
    -------
    vertices [n, 3] [m], as they are; triangles [m, 3]

    Raises
    ------
    GeometryError : there is no triangle, or one of a corner that is missing or not finite; scale is not positive
    """
    unit, _ = _resolve_unit(model, scale, where=where)
    vertices, triangles = join_parts(parts)
    sound = _check_vertices(vertices, triangles, where=where)
    return _rotate_upright(sound if unit == 1.0 else sound * unit, up=up or model.up or "z"), triangles


def _error_of_element(
    model: Model, *, density: float, name: str, scale: float | None, up: Up | None, where: str
) -> GeometryError | None:
    """Return the error of the first of several elements that is no body by itself; None if none or all are."""
    wrong = []
    for part in model.parts if len(model.parts) > 1 else ():
        at = f'{where}: element "{short_name(part.element.shown)}"'
        try:
            _solid(model, [part], density=density, name=name, scale=scale, up=up, where=at)
        except GeometryError as problem:
            wrong.append(problem)
    return wrong[0] if 0 < len(wrong) < len(model.parts) else None


def _is_single_precision(file: Path) -> bool:
    """Return whether a file holds its coordinates in single precision."""
    with file.open("rb") as content:
        head = content.read(HEAD)
    ending = file.suffix.lower()
    if ending == ".stl":
        return b"\0" in head  # text has none
    return ending in SINGLE or (ending == ".ply" and re.search(rb"property\s+float(32)?\s+x\s", head) is not None)


def _rotate_upright(vertices: FloatArray, *, up: Up) -> FloatArray:
    """Rotate the vertices [n, 3] so that z points up: a quarter turn about x."""
    return vertices if up == "z" else vertices[:, [0, 2, 1]] * [1.0, -1.0, 1.0]


def _axis_warnings(content: Model, *, given: Up | None) -> tuple[Message, ...]:
    """Warn where a mesh is rotated because its format prescribes y up, which exporters do not always follow."""
    turned = given is None and content.up == "y"
    return (note("read-with-y-up"),) if turned else ()


def _resolve_unit(content: Model, given: float | None, *, where: str) -> tuple[float, tuple[Message, ...]]:
    """Return the length of the mesh's unit [m]: the given, the file's own or the metre; warn where they differ."""
    if given is not None and not is_number(given):
        raise GeometryError(f"{where}: its unit is {given!r}; give its length in metres, such as 0.001")
    if given is not None and not (np.isfinite(given) and given > 0.0):
        raise GeometryError(f"{where}: its unit is {given:g} m; give a positive finite length")
    if given is None and content.unit is None and content.file.suffix.lower() not in WITHOUT_UNIT:
        raise GeometryError(f"{where}: the file states no unit; give mesh_unit, the unit of its coordinates")
    if given is None:
        return content.unit or 1.0, ()
    if content.unit is None or abs(content.unit / given - 1.0) < SAME_UNIT:
        return given, ()
    stated = Quantity(content.unit, "length", 6)
    return given, (note("read-in-units", given=Quantity(given, "length", 6), stated=stated),)


def _check_vertices(vertices: FloatArray, triangles: IntArray, *, where: str) -> FloatArray:
    """Return the vertices; raise unless there are triangles, all between existing, finite vertices."""
    if not len(triangles):
        raise GeometryError(f"{where}: no triangles found; is it a closed triangle mesh, and whole?")
    if triangles.min() < 0 or triangles.max() >= len(vertices):
        wrong = int(triangles[(triangles < 0) | (triangles >= len(vertices))][0])
        raise GeometryError(f"{where}: a triangle uses vertex {wrong} of {len(vertices)}; export the mesh again")
    if vertices.min() > -FARTHEST and vertices.max() < FARTHEST:
        return vertices
    used = np.zeros(len(vertices), dtype=np.bool_)
    used[triangles] = True
    bad = np.flatnonzero(used & ~np.all(np.abs(vertices) < FARTHEST, axis=1))
    if len(bad):
        at = ", ".join(f"{value:g}" for value in vertices[bad[0]])
        raise GeometryError(
            f"{where}: {len(bad)} vertices are not finite or beyond {FARTHEST:g}, the first at ({at}); "
            "export the mesh again"
        )
    return vertices
