"""Bodies from model files: the selected elements read, oriented and scaled, repaired where necessary, and listed.

Each file is read once, and only the selected elements are meshed.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from assess.errors import GeometryError
from assess.geometry.dimensions import extents, refuse_implausible, size_warning, thin_direction
from assess.geometry.formats.mesh_file import (
    MAX_LISTED,
    Element,
    ElementMesh,
    Up,
    join_meshes,
    list_names,
    select_elements,
    short_name,
)
from assess.geometry.formats.readers import WITHOUT_UNIT, mesh_elements, read_mesh_file
from assess.geometry.repair import repair
from assess.geometry.shells import self_overlap_warnings
from assess.geometry.solid import Solid, polyhedron
from assess.geometry.surface import Surface, merge_vertices
from assess.messages.message import Message, Quantity, first_names, note, whole_number
from spectra.arrays import FloatArray, IntArray, is_number

FARTHEST = 1e12  # of any unit: no coordinate of a map in any unit is larger
SINGLE_PRECISION = (".glb", ".gltf", ".3dm")  # formats of single precision, beside binary STL and some PLY
HEAD = 2000  # bytes of a file that say which numbers follow
SAME_UNIT = 1e-6  # of a unit: units that differ by less are one


def load_solid(
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
    model = read_selected_meshes({name: (file, element)})[file, element]
    return solid_from_meshes(model, density=density, name=name, scale=scale, up=up)


def solid_from_meshes(
    model: SelectedMeshes, *, density: float, name: str, scale: float | None = None, up: Up | None = None
) -> Solid:
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
    model: SelectedMeshes,
    parts: Sequence[ElementMesh],
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


def assemble_mesh(
    model: SelectedMeshes, parts: Sequence[ElementMesh], *, scale: float | None, up: Up | None, where: str
) -> Surface:
    """Assemble some of a model's meshes into one, oriented with z up and in metres.

    Returns
    -------
    vertices [n, 3] [m], as they are; triangles [m, 3]

    Raises
    ------
    GeometryError : there is no triangle, or one of a corner that is missing or not finite; scale is not positive
    """
    unit, _ = _resolve_unit(model, scale, where=where)
    vertices, triangles = join_meshes(parts)
    sound = _check_vertices(vertices, triangles, where=where)
    return _rotate_upright(sound if unit == 1.0 else sound * unit, up=up or model.up or "z"), triangles


def _error_of_element(
    model: SelectedMeshes, *, density: float, name: str, scale: float | None, up: Up | None, where: str
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
    return ending in SINGLE_PRECISION or (
        ending == ".ply" and re.search(rb"property\s+float(32)?\s+x\s", head) is not None
    )


def _rotate_upright(vertices: FloatArray, *, up: Up) -> FloatArray:
    """Rotate the vertices [n, 3] so that z points up: a quarter turn about x."""
    return vertices if up == "z" else vertices[:, [0, 2, 1]] * [1.0, -1.0, 1.0]


def _axis_warnings(content: SelectedMeshes, *, given: Up | None) -> tuple[Message, ...]:
    """Warn where a mesh is rotated because its format prescribes y up, which exporters do not always follow."""
    turned = given is None and content.up == "y"
    return (note("read-with-y-up"),) if turned else ()


def _resolve_unit(content: SelectedMeshes, given: float | None, *, where: str) -> tuple[float, tuple[Message, ...]]:
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


@dataclass(frozen=True)
class SelectedMeshes:
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
    parts: tuple[ElementMesh, ...]
    unit: float | None = None
    up: Up | None = None
    warnings: tuple[Message, ...] = ()


Selection = tuple[
    Path, str | None
]  # a file, and which of its elements: a name, identifier, class or pattern; None: all
MeshesBySelection = Mapping[Selection, SelectedMeshes]


def read_selected_meshes(asked: Mapping[str, Selection]) -> MeshesBySelection:
    """Read what each body takes of its file; every file is read once.

    Parameters
    ----------
    asked : file and elements by name of the body

    Raises
    ------
    GeometryError : a file cannot be read, has no such elements, or has no mesh for one of those selected
    """
    found: dict[Selection, SelectedMeshes] = {}
    for file in dict.fromkeys(path for path, _ in asked.values()):
        found |= _read_file({name: element for name, (path, element) in asked.items() if path == file}, file)
    return found


def _read_file(elements: Mapping[str, str | None], file: Path) -> MeshesBySelection:
    """Read what bodies take of one file; elements: those selected, by name of the body."""
    places_named = {name: f'body "{name}": mesh {file.name}' for name in elements}
    first = next(iter(places_named.values()))
    content = read_mesh_file(file, where=first)
    places = {
        name: select_elements(content.elements, element, where=places_named[name]) for name, element in elements.items()
    }
    wanted = sorted({place for each in places.values() for place in each})
    parts = dict(zip(wanted, mesh_elements(content, wanted, file=file, where=first), strict=True))
    found = {}
    for name, element in elements.items():
        taken = tuple(parts[place] for place in places[name])
        _refuse_unmeshed(taken, where=places_named[name])
        found[file, element] = SelectedMeshes(
            file,
            taken,
            content.unit,
            content.up,
            (*(() if element is None else _join_warnings(taken)), *_mesh_warnings(taken)),
        )
    return found


def _join_warnings(parts: Sequence[ElementMesh]) -> tuple[Message, ...]:
    """Note where several elements become one body."""
    if len(parts) < 2:
        return ()
    names = first_names([short_name(each.element.shown) for each in parts], MAX_LISTED)
    return (note("elements-joined", number=whole_number(len(parts)), names=names),)


def _mesh_warnings(parts: Sequence[ElementMesh]) -> tuple[Message, ...]:
    """Warn of what may be missing of elements."""
    return tuple(
        note("element-incomplete", element=short_name(each.element.shown), what=each.warning)
        for each in parts
        if each.warning is not None
    )


def _refuse_unmeshed(parts: Sequence[ElementMesh], *, where: str) -> None:
    """Raise where a selected element has no mesh."""
    bare = [each for each in parts if each.fault]
    if bare:
        one = bare[0].element
        known = f" ({one.identifier})" if one.identifier and one.shown != one.identifier else ""
        more = (
            f" (and {len(bare) - 1} more: {list_names([each.element.shown for each in bare[1:]])})" if bare[1:] else ""
        )
        raise GeometryError(f'{where}: element "{short_name(one.shown)}"{known}{more}: {bare[0].fault}')


Sizes = tuple[float, float, float]


@dataclass(frozen=True)
class InventoryEntry:
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
) -> tuple[InventoryEntry, ...]:
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
    content = read_mesh_file(file, where=str(file))
    places = select_elements(content.elements, element, where=str(file))
    if not places:
        raise GeometryError(f"{file}: there are no meshes in it, and no solids or surfaces to mesh")
    parts = mesh_elements(content, places, file=file, where=str(file))
    return tuple(
        _inventory_entry(
            SelectedMeshes(file, (part,), content.unit, content.up, () if part.warning is None else (part.warning,)),
            part,
            scale=scale,
            up=up,
        )
        for part in parts
    )


def _inventory_entry(model: SelectedMeshes, part: ElementMesh, *, scale: float | None, up: Up | None) -> InventoryEntry:
    """Describe one part."""
    name, element = model.file.name, part.element
    if part.fault:
        return InventoryEntry(name, element, why_not=part.fault)
    try:
        vertices, triangles = assemble_mesh(model, model.parts, scale=scale, up=up, where="")
    except GeometryError as problem:
        return InventoryEntry(name, element, len(part.triangles), why_not=_reason(problem, name))
    thin, used = thin_direction(vertices, triangles), vertices[np.unique(triangles)]
    low, high = used.min(axis=0), used.max(axis=0)
    middle = (low + high) / 2.0
    try:
        solid = solid_from_meshes(model, density=1.0, name="", scale=scale, up=up)
        found = size_warning(replace(solid, name=element.shown), unit=scale or (1.0 if model.unit is None else None))
        about_size = [] if found is None else [found]
        warnings, why, volume = (*solid.history, *about_size), "", solid.mass
    except GeometryError as problem:
        warnings, why, volume = (), _reason(problem, name), None
    return InventoryEntry(
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
