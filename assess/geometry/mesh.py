"""Bodies from model files: the selected elements read, oriented and scaled, repaired where necessary, and listed.

Each file is read once, and only the selected elements are meshed. Sizes and coordinates that no masonry has are refused
or get a warning, with the unit that was probably meant.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
import shapely

from assess.errors import Faults, GeometryError
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
from assess.geometry.surface import Surface, area_vectors, merge_vertices, total_area, volume
from assess.messages.message import Message, Quantity, Value, first_names, note, warning, whole_number
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
    element : only elements of this name, identifier, class or pattern (`select_elements`); all if absent

    Raises
    ------
    GeometryError : the file is missing, of another kind, unreadable, without triangles or such an element; the mesh
        cannot be closed or has no volume; a coordinate is not finite; scale or density is not positive
    """
    file = Path(path)
    selected = read_selected_meshes({name: (file, element)})[file, element]
    return solid_from_meshes(selected, density=density, name=name, scale=scale, up=up)


def solid_from_meshes(
    selected: SelectedMeshes, *, density: float, name: str, scale: float | None = None, up: Up | None = None
) -> Solid:
    """Return the solid inside the meshes taken from a file.

    Parameters
    ----------
    selected : the meshes
    density : [kg/m3]
    name : the body's name in the project
    scale, up : as in `load_solid`

    Raises
    ------
    GeometryError : as in `load_solid`; where one of several elements is at fault, it is named
    """
    where = f'body "{name}": mesh {selected.file.name}'
    try:
        return _solid(selected, selected.meshes, density=density, name=name, scale=scale, up=up, where=where)
    except GeometryError as problem:
        raise (
            _error_of_element(selected, density=density, name=name, scale=scale, up=up, where=where) or problem
        ) from None


@dataclass(frozen=True)
class SelectedMeshes:
    """What a body takes of a file.

    file : where it was read from
    meshes : of the elements that it takes
    unit : length of the file's unit [m]; None where the format does not say
    up : which axis points up; None where the format does not say
    warnings : which elements became one body, and what may be missing
    """

    file: Path
    meshes: tuple[ElementMesh, ...]
    unit: float | None = None
    up: Up | None = None
    warnings: tuple[Message, ...] = ()


FileSelection = tuple[
    Path, str | None
]  # a file, and which of its elements: a name, identifier, class or pattern; None: all
MeshesBySelection = Mapping[FileSelection, SelectedMeshes]


def read_selected_meshes(selections: Mapping[str, FileSelection], *, faults: Faults | None = None) -> MeshesBySelection:
    """Read what each body takes of its file; every file is read once.

    Parameters
    ----------
    selections : file and elements by name of the body
    faults : gathers the errors of all; those of one file are raised if None

    Raises
    ------
    GeometryError : a file cannot be read, has no such elements, or has no mesh for one of those selected
    """
    found: dict[FileSelection, SelectedMeshes] = {}
    for file in dict.fromkeys(path for path, _ in selections.values()):
        gathered = Faults() if faults is None else faults
        with gathered.gather():
            elements = {name: element for name, (path, element) in selections.items() if path == file}
            found |= _read_file(elements, file, gathered)
        if faults is None:
            gathered.raise_all()
    return found


Sizes = tuple[float, float, float]


@dataclass(frozen=True)
class InventoryEntry:
    """One part of a model.

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
    solid : the closed body, of density 1 kg/m3; None where it is none
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
    solid: Solid | None = field(default=None, repr=False, compare=False)


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
    meshes = mesh_elements(content, places, file=file, where=str(file))
    return tuple(
        _inventory_entry(
            SelectedMeshes(file, (mesh,), content.unit, content.up, () if mesh.warning is None else (mesh.warning,)),
            mesh,
            scale=scale,
            up=up,
        )
        for mesh in meshes
    )


ROUNDING = 1e-6  # of single precision, in a direction
SQUARE_PLAN = 0.05  # by how much the two sides of a plan must differ for one to be the thin one


def thin_direction(vertices: FloatArray, triangles: IntArray) -> FloatArray | None:
    """Return the horizontal unit vector [2] along the thickness of a wall: where most of its surface faces, either way.

    The principal axis of the sum of a a^T / |a| over the horizontal parts a of the triangles' area vectors: of a box
    its shorter side in plan, whatever projects from its faces at right angles. None where no direction is preferred,
    as in a square or round tower. Its first component that is not zero is positive.

    Parameters
    ----------
    vertices : [n, 3] [m]
    triangles : indices into vertices [m, 3]
    """
    return _thin_direction_of(area_vectors(vertices[triangles]))


def _thin_direction_of(vectors: FloatArray) -> FloatArray | None:
    """Return the `thin_direction` of a surface by the area vectors of its triangles [m, 3]."""
    vectors = vectors[:, :2]
    size = np.hypot(*vectors.T)
    tensor = (vectors / np.where(size > 0.0, size, 1.0)[:, None]).T @ vectors
    (low, high), axes = np.linalg.eigh(tensor)
    if not high > 0.0 or high - low < SQUARE_PLAN * high:
        return None
    return _normalise_sign(axes[:, 1])


def extents(vertices: FloatArray, thin: FloatArray | None) -> tuple[float, float, float]:
    """Return the extents along the thin direction, across it and upright [m].

    Parameters
    ----------
    vertices : [n, 3] [m]
    thin : horizontal unit vector [2]; the shorter side of the smallest rectangle in plan where None
    """
    along = _shorter_side(vertices) if thin is None else thin
    across = np.array([-along[1], along[0]])
    sides = [float(np.ptp(vertices[:, :2] @ axis)) for axis in (along, across)]
    return sides[0], sides[1], float(np.ptp(vertices[:, 2]))


def size_warning(solid: Solid, *, unit: float | None = None) -> Message | None:
    """Return a warning where size or coordinates of a body suggest a slip, None otherwise.

    Parameters
    ----------
    solid : the body
    unit : length that the mesh was read in [m]; None for a body that is not a mesh
    """
    size = _longest_side(solid)
    values: dict[str, Value] = {"body": solid.name, "size": Quantity(size, "length")}
    likely = None if unit is None else _likely_unit(solid, unit=unit)
    if likely is not None:
        values |= {"unit": likely.name, "other": Quantity(likely.size, "length")}
    behind = "" if likely is None else "-in-unit"
    if not SHORTEST_BODY <= size <= LONGEST_BODY:
        return warning(f"size{behind}", **values)
    if size > VERY_LONG and (thickness := _thickness(solid)) > WALL_THICKNESS[1]:
        return warning(f"size-thick{behind}", thickness=Quantity(thickness, "length", 3), **values)
    resolution = _single_precision_spacing(solid, unit=unit or 1.0)
    if resolution > COARSE * size:
        distance, finest = float(np.abs(solid.vertices).max()), Quantity(resolution, "length", 2)
        return warning("far-from-origin", body=solid.name, distance=Quantity(distance, "length"), resolution=finest)
    return None


@dataclass(frozen=True)
class _LikelyUnit:
    """The unit that was probably meant, and the longest side of the body in it [m]."""

    name: str
    size: float


def _solid(
    selected: SelectedMeshes,
    meshes: Sequence[ElementMesh],
    *,
    density: float,
    name: str,
    scale: float | None,
    up: Up | None,
    where: str,
) -> Solid:
    """Return the solid inside some of a model's meshes."""
    _, about_unit = _resolve_unit(selected, scale, where=where)
    surface = merge_vertices(*assemble_mesh(selected, meshes, scale=scale, up=up, where=where))
    if not len(surface[1]):
        raise GeometryError(f"{where}: all its triangles have shrunk to lines or points; export it with more digits")
    surface, repairs = repair(surface, where=where)
    solid = polyhedron(*surface, density=density, name=name)
    unit = scale or selected.unit or 1.0
    _refuse_implausible(
        solid, unit=unit, given=scale is not None, single=_is_single_precision(selected.file), where=where
    )
    history = (
        *selected.warnings,
        *about_unit,
        *_axis_warnings(selected, given=up),
        *repairs,
        *self_overlap_warnings(surface, where=where),
    )
    return replace(solid, history=history)


def assemble_mesh(
    selected: SelectedMeshes, meshes: Sequence[ElementMesh], *, scale: float | None, up: Up | None, where: str
) -> Surface:
    """Assemble some of a model's meshes into one, oriented with z up and in metres.

    Parameters
    ----------
    selected : what is taken of a file
    meshes : those of it to assemble
    scale, up : as in `load_solid`
    where : named in errors

    Returns
    -------
    vertices [n, 3] [m], as they are; triangles [m, 3]

    Raises
    ------
    GeometryError : there is no triangle, or one of a corner that is missing or not finite; scale is not positive
    """
    unit, _ = _resolve_unit(selected, scale, where=where)
    vertices, triangles = join_meshes(meshes)
    sound = _check_vertices(vertices, triangles, where=where)
    return _rotate_upright(sound if unit == 1.0 else sound * unit, up=up or selected.up or "z"), triangles


def _error_of_element(
    selected: SelectedMeshes, *, density: float, name: str, scale: float | None, up: Up | None, where: str
) -> GeometryError | None:
    """Return the error of the first of several elements that is no body by itself; None if none or all are."""
    wrong = []
    for mesh in selected.meshes if len(selected.meshes) > 1 else ():
        at = f'{where}: element "{short_name(mesh.element.shown)}"'
        try:
            _solid(selected, [mesh], density=density, name=name, scale=scale, up=up, where=at)
        except GeometryError as problem:
            wrong.append(problem)
    return wrong[0] if 0 < len(wrong) < len(selected.meshes) else None


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


def _axis_warnings(selected: SelectedMeshes, *, given: Up | None) -> tuple[Message, ...]:
    """Warn where a mesh is rotated because its format prescribes y up, which exporters do not always follow."""
    turned = given is None and selected.up == "y"
    return (note("read-with-y-up"),) if turned else ()


def _resolve_unit(selected: SelectedMeshes, given: float | None, *, where: str) -> tuple[float, tuple[Message, ...]]:
    """Return the length of the mesh's unit [m]: the given, the file's own or the metre; warn where they differ."""
    if given is not None and not is_number(given):
        raise GeometryError(f"{where}: its unit is {given!r}; give its length in metres, such as 0.001")
    if given is not None and not (np.isfinite(given) and given > 0.0):
        raise GeometryError(f"{where}: its unit is {given:g} m; give a positive finite length")
    if given is None and selected.unit is None and selected.file.suffix.lower() not in WITHOUT_UNIT:
        raise GeometryError(f"{where}: the file states no unit; give {UNIT_OF_FILE}")
    if given is None:
        return selected.unit or 1.0, ()
    if selected.unit is None or abs(selected.unit / given - 1.0) < SAME_UNIT:
        return given, ()
    stated = Quantity(selected.unit, "length", 6)
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


def _read_file(elements: Mapping[str, str | None], file: Path, faults: Faults) -> MeshesBySelection:
    """Read what bodies take of one file.

    elements : those selected, by name of the body; faults : gathers those of each body
    """
    places_named = {name: f'body "{name}": mesh {file.name}' for name in elements}
    first = next(iter(places_named.values()))
    content = read_mesh_file(file, where=first)
    places: dict[str, Sequence[int]] = {}
    for name, element in elements.items():
        with faults.gather():
            places[name] = select_elements(content.elements, element, where=places_named[name])
    selected = sorted({place for each in places.values() for place in each})
    meshes = dict(zip(selected, mesh_elements(content, selected, file=file, where=first), strict=True))
    found = {}
    for name in places:
        element, taken = elements[name], tuple(meshes[place] for place in places[name])
        with faults.gather():
            _refuse_unmeshed(taken, where=places_named[name])
            found[file, element] = SelectedMeshes(
                file,
                taken,
                content.unit,
                content.up,
                (*(() if element is None else _join_warnings(taken)), *_class_warnings(taken), *_mesh_warnings(taken)),
            )
    return found


def _join_warnings(meshes: Sequence[ElementMesh]) -> tuple[Message, ...]:
    """Note where several elements become one body."""
    if len(meshes) < 2:
        return ()
    names = first_names([short_name(each.element.shown) for each in meshes], MAX_LISTED)
    return (note("elements-joined", number=whole_number(len(meshes)), names=names),)


def _class_warnings(meshes: Sequence[ElementMesh]) -> tuple[Message, ...]:
    """Note where elements of several classes, as walls and slabs of an IFC file, become one body."""
    kinds = [kind for each in meshes for kind in each.element.kinds[:1] if kind.startswith("Ifc")]
    classes = dict.fromkeys(CASES.sub("", kind) for kind in kinds)
    if len(classes) < 2:
        return ()
    return (note("several-classes", number=whole_number(len(meshes)), classes=first_names(list(classes), MAX_LISTED)),)


CASES = re.compile("(Standard|Elemented)Case$")  # of IFC classes: the same element, drawn more simply


def _mesh_warnings(meshes: Sequence[ElementMesh]) -> tuple[Message, ...]:
    """Warn of what may be missing of elements."""
    return tuple(
        note("element-incomplete", element=short_name(each.element.shown), what=each.warning)
        for each in meshes
        if each.warning is not None
    )


def _refuse_unmeshed(meshes: Sequence[ElementMesh], *, where: str) -> None:
    """Raise where a selected element has no mesh."""
    bare = [each for each in meshes if each.fault]
    if bare:
        one = bare[0].element
        known = f" ({one.identifier})" if one.identifier and one.shown != one.identifier else ""
        more = (
            f" (and {len(bare) - 1} more: {list_names([each.element.shown for each in bare[1:]])})" if bare[1:] else ""
        )
        raise GeometryError(f'{where}: element "{short_name(one.shown)}"{known}{more}: {bare[0].fault}')


def _inventory_entry(
    selected: SelectedMeshes, mesh: ElementMesh, *, scale: float | None, up: Up | None
) -> InventoryEntry:
    """Describe one part."""
    name, element = selected.file.name, mesh.element
    if mesh.fault:
        return InventoryEntry(name, element, why_not=mesh.fault)
    try:
        vertices, triangles = assemble_mesh(selected, selected.meshes, scale=scale, up=up, where="")
    except GeometryError as problem:
        return InventoryEntry(name, element, len(mesh.triangles), why_not=fault_of(problem, name))
    thin, used = thin_direction(vertices, triangles), vertices[np.unique(triangles)]
    low, high = used.min(axis=0), used.max(axis=0)
    middle = (low + high) / 2.0
    try:
        solid = solid_from_meshes(selected, density=1.0, name="", scale=scale, up=up)
        found = size_warning(replace(solid, name=element.shown), unit=scale or (1.0 if selected.unit is None else None))
        about_size = [] if found is None else [found]
        warnings, why, body = (*solid.history, *about_size), "", solid
    except GeometryError as problem:
        warnings, why, body = (), fault_of(problem, name), None
    return InventoryEntry(
        name,
        element,
        len(triangles),
        size=extents(used, thin),
        place=(float(middle[0]), float(middle[1]), float(low[2])),
        volume=None if body is None else body.mass,
        closed=body is not None,
        why_not=why,
        warnings=warnings,
        thin=None if thin is None else (float(thin[0]), float(thin[1])),
        solid=body,
    )


def fault_of(problem: GeometryError, file: str) -> str:
    """Return an error about an unnamed body, without the subject of its sentence.

    Parameters
    ----------
    problem : the error
    file : name of the file that the body was read from
    """
    sentence = str(problem)
    for start in ('body ""', f": mesh {file}", ": "):
        sentence = sentence.removeprefix(start)
    return sentence.strip()


def _shorter_side(vertices: FloatArray) -> FloatArray:
    """Return the direction [2] of the shorter side of the smallest rectangle in plan; x where there is none."""
    around = shapely.MultiPoint(vertices[:, :2]).minimum_rotated_rectangle
    if not isinstance(around, shapely.Polygon):
        return np.array([1.0, 0.0])
    sides = np.diff(shapely.get_coordinates(around)[:3], axis=0)
    lengths = np.hypot(*sides.T)
    shorter = int(np.argmin(lengths))
    return _normalise_sign(sides[shorter] / lengths[shorter]) if lengths[shorter] > 0.0 else np.array([1.0, 0.0])


def _normalise_sign(axis: FloatArray) -> FloatArray:
    """Return the axis without rounding, towards +x, or +y where it lies along y."""
    clean = np.where(np.abs(axis) < ROUNDING, 0.0, axis)
    clean = clean / np.hypot(*clean)
    return np.asarray(clean if tuple(clean) > (0.0, 0.0) else -clean + 0.0, dtype=np.float64)


LONGEST_BODY = 300.0  # m: no masonry body is longer
SHORTEST_BODY = 0.03  # m: none is shorter
USUAL_LENGTH = 5.0  # m: a body's usual length
UNITS = {"mm": 1e-3, "cm": 1e-2, "in": 0.0254, "ft": 0.3048, "m": 1.0, "km": 1e3}  # m
WALL_LENGTH = (1.0, 100.0)  # m: of the longest side of a usual wall
WALL_THICKNESS = (0.1, 3.0)  # m
VERY_LONG = 50.0  # m: a body that is longer and thicker than a usual wall suggests another unit
COARSE = 1e-4  # of the body's size: rounding of coordinates that moves results
TOO_COARSE = 0.01  # of its thickness: rounding that spoils them
UNIT_ROUNDING = 1e-12  # of the farthest coordinate: rounding of a change of units


UNIT_OF_FILE = "mesh_unit (--unit), the unit of its coordinates"


def _refuse_implausible(solid: Solid, *, unit: float, given: bool, single: bool, where: str) -> None:
    """Raise where a mesh cannot be a masonry body, by its size or by the precision of its coordinates.

    A small specimen is accepted where the project gives its unit.

    Parameters
    ----------
    solid : the body
    unit : length that the mesh was read in [m]
    given : whether the project gives that unit
    single : whether the file holds single precision; another with such numbers may have been drawn so
    where : named in errors

    Raises
    ------
    GeometryError : the body is longer than 300 m, or shorter than 3 cm without a given unit; its coordinates are in
        single precision that resolves no better than a hundredth of its thickness
    """
    size = _longest_side(solid)
    if size > LONGEST_BODY or (size < SHORTEST_BODY and not given):
        limit = f"more than {LONGEST_BODY:g}" if size > LONGEST_BODY else f"less than {SHORTEST_BODY:g}"
        remedy = "give another mesh_unit (--unit)" if given else f"give {UNIT_OF_FILE}"
        likely = _likely_unit(solid, unit=unit)
        hint = "No usual unit makes it a wall; check the model"
        if likely is not None:
            hint = f'With mesh_unit = "{likely.name}" (--unit) it would measure {likely.size:.4g} m'
        raise GeometryError(
            f"{where}: it measures {size:.4g} m at its longest, {limit} m, which no masonry body does; {remedy}. {hint}"
        )
    resolution = _single_precision_spacing(solid, unit=unit) if single else 0.0
    if resolution > 0.0 and resolution > TOO_COARSE * (thickness := _thickness(solid)):
        raise GeometryError(
            f"{where}: its coordinates are in single precision, which {np.abs(solid.vertices).max():.4g} m from the "
            f"origin resolves {resolution:.2g} m, more than 1 % of its thickness of {thickness:.3g} m; move the model "
            "near the origin before exporting it, or export it in double precision or as text"
        )


def _longest_side(solid: Solid) -> float:
    """Return the longest side of the box around a body [m]."""
    return float(np.ptp(solid.vertices, axis=0).max())


def _thickness(solid: Solid) -> float:
    """Return the thickness of a body [m]: its least extent, or 1.5 times that of a plate of its volume and surface.

    The latter is less for walls that bend, and for several walls in one.
    """
    vectors = area_vectors(solid.vertices[solid.triangles])
    sides = extents(solid.vertices, _thin_direction_of(vectors))
    plate = 2.0 * volume(solid.vertices, solid.triangles) / total_area(vectors)
    return min(*sides, 1.5 * plate)


def _single_precision_spacing(solid: Solid, *, unit: float) -> float:
    """Return the spacing of single-precision numbers at a body's farthest coordinate [m].

    0 where coordinates hold more digits, and where they are so fine that they never matter.
    """
    farthest = float(np.abs(solid.vertices).max()) / unit
    spacing = float(np.spacing(np.float32(farthest)))
    if spacing * unit <= COARSE * _longest_side(solid):
        return 0.0
    read = solid.vertices / unit
    single = np.abs(read - read.astype(np.float32)).max() <= UNIT_ROUNDING * farthest
    return spacing * unit if single else 0.0


def _likely_unit(solid: Solid, *, unit: float) -> _LikelyUnit | None:
    """Return the unit that makes a body a usual wall, or else gives it the size of one; None where none does."""
    length, thickness = _longest_side(solid) / unit, _thickness(solid) / unit
    walls = [
        name
        for name, one in UNITS.items()
        if WALL_LENGTH[0] <= length * one <= WALL_LENGTH[1]
        and WALL_THICKNESS[0] <= thickness * one <= WALL_THICKNESS[1]
    ]
    likely = min(walls or UNITS, key=lambda name: abs(np.log(length * UNITS[name] / USUAL_LENGTH)))
    size = length * UNITS[likely]
    same = abs(UNITS[likely] / unit - 1.0) < UNIT_ROUNDING
    return None if same or not SHORTEST_BODY <= size <= LONGEST_BODY else _LikelyUnit(likely, size)
