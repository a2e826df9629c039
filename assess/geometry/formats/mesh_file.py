"""A geometry file as data: its elements with their names and meshes, its unit and its vertical axis.

Elements are selected by name, identifier, class or pattern.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches
from fnmatch import fnmatchcase
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from assess.errors import GeometryError
from assess.messages.message import Message
from spectra.arrays import FloatArray, IntArray

Up = Literal["y", "z"]
MAX_INSTANCES = 100_000  # of meshes in a scene, which blocks within blocks multiply
MAX_TRIANGLES = 100_000_000  # of a scene with all its instances
POINT_CLOUD = "it holds {count} points and no faces; make a closed surface of the points first"


@dataclass(frozen=True)
class Element:
    """One object of a file, as the file names it.

    names : its name; none where the format has no names
    identifier : unique in the file, as the GlobalId of an IFC element; empty where there is none
    kinds : its class and the superclasses, as IfcWallStandardCase, IfcWall, ...
    storey : in which it is
    within : names, identifiers and classes of what it is part of, as an assembly or a block instance
    predefined : further type that the class has, as ROOF of an IfcSlab
    layers : what it is made of, from one face to the other: the name of each material and its thickness [m], which is
        None where it is not known
    density : of its thickest layer, where the file states it [kg/m3]
    """

    names: tuple[str, ...] = ()
    identifier: str = ""
    kinds: tuple[str, ...] = ()
    storey: str = ""
    within: tuple[str, ...] = ()
    predefined: str = ""
    layers: tuple[tuple[str, float | None], ...] = ()
    density: float | None = None

    @property
    def shown(self) -> str:
        """The name to use in a sentence."""
        return next((name for name in (*self.names, *self.within, self.identifier) if name), "without name")


@dataclass(frozen=True)
class ElementMesh:
    """The mesh of one element, in its place.

    element : whose mesh it is
    vertices : [n, 3] in the file's unit
    triangles : indices into vertices [m, 3]
    fault : why there is no mesh, a sentence; empty where there is one
    warning : why the mesh may be incomplete; None where it is complete
    """

    element: Element
    vertices: FloatArray
    triangles: IntArray
    fault: str = ""
    warning: Message | None = None


@dataclass(frozen=True)
class MeshFile:
    """A file that was read.

    elements : all objects that can have a mesh
    mesh : returns the meshes of the elements at given indices; an element that turns out to have no body is left out
    unit : length of the file's unit [m]; None where the format does not say
    up : which axis points up; None where the format does not say
    storeys : name and elevation [m] of each storey of the building, from the lowest up
    """

    elements: tuple[Element, ...]
    mesh: Callable[[Sequence[int]], tuple[ElementMesh, ...]]
    unit: float | None = None
    up: Up | None = None
    storeys: tuple[tuple[str, float], ...] = ()

    @property
    def meshes(self) -> tuple[ElementMesh, ...]:
        """The meshes of all elements."""
        return self.mesh(range(len(self.elements)))


def file_from_meshes(meshes: Sequence[ElementMesh], *, unit: float | None = None, up: Up | None = None) -> MeshFile:
    """Return a file whose meshes are all there already."""
    found = tuple(meshes)
    return MeshFile(tuple(each.element for each in found), lambda places: tuple(found[i] for i in places), unit, up)


def make_element_mesh(element: Element, vertices: ArrayLike, faces: ArrayLike) -> ElementMesh:
    """Make the mesh of an element of vertices [n, 3] and faces of k corners [m, k], which become fans of triangles."""
    return ElementMesh(element, np.asarray(vertices, dtype=np.float64).reshape(-1, 3), fan_triangles(faces))


def element_without_mesh(element: Element, fault: str) -> ElementMesh:
    """Make an element without a mesh, with the reason."""
    return ElementMesh(element, np.empty((0, 3)), np.empty((0, 3), dtype=np.int64), fault)


def fan_triangles(faces: ArrayLike) -> IntArray:
    """Split faces of k corners [m, k] into fans of triangles [m (k - 2), 3] from the first corner."""
    corners = np.asarray(faces, dtype=np.int64)
    if corners.shape[1] == 3:
        return corners
    triangles = [corners[:, [0, i, i + 1]] for i in range(1, corners.shape[1] - 1)]
    return np.concatenate([np.empty((0, 3), dtype=np.int64), *triangles])


def transform(shape: ElementMesh, matrix: ArrayLike) -> ElementMesh:
    """Apply a transformation [4, 4] of homogeneous coordinates; a reflection reverses the triangles."""
    A = np.asarray(matrix, dtype=np.float64)
    triangles = shape.triangles if np.linalg.det(A[:3, :3]) >= 0.0 else shape.triangles[:, ::-1]
    return replace(shape, vertices=shape.vertices @ A[:3, :3].T + A[:3, 3], triangles=triangles)


def join_meshes(meshes: Sequence[ElementMesh]) -> tuple[FloatArray, IntArray]:
    """Join meshes into one: vertices [n, 3] and triangles [m, 3]."""
    if len(meshes) == 1:
        return meshes[0].vertices, meshes[0].triangles
    starts = np.cumsum([0, *(len(each.vertices) for each in meshes)])[: len(meshes)]
    triangles = [each.triangles + start for each, start in zip(meshes, starts, strict=True)]
    nothing = np.empty((0, 3))
    return (
        np.concatenate([nothing, *(each.vertices for each in meshes)]),
        np.concatenate([nothing.astype(np.int64), *triangles]),
    )


LONGEST_NAME = 40  # letters of a name that came with a file
MAX_LISTED = 8  # names that a sentence lists
WILDCARDS = "*?["  # letters that make a pattern
CLASS_PREFIX = "ifc"  # of the names of classes


def select_elements(elements: Sequence[Element], selection: str | None, *, where: str) -> tuple[int, ...]:
    """Return the indices of the elements that a selection means; all where none is given.

    The first of these that matches counts: the identifier of one element; its name; its class or a superclass, such as
    "IfcWall", or what it is part of; a pattern such as "Wand-*" (`*` any letters, `?` one letter, `[ab]` one of these).

    Raises
    ------
    GeometryError : nothing matches, or several elements with identifiers of their own have exactly this name
    """
    if selection is None:
        return tuple(range(len(elements)))
    selection = one_line(selection)
    named = _indices(elements, [selection in map(one_line, each.names) for each in elements])
    for found in (
        _indices(elements, [selection == each.identifier for each in elements]),
        _refuse_ambiguous(elements, named, selection, where=where),
        _indices(elements, [selection in map(one_line, (*each.within, *each.kinds)) for each in elements]),
        _indices(elements, [_matches_pattern(each, selection) for each in elements]),
    ):
        if found:
            return found
    raise GeometryError(f'{where}: it has no element "{short_name(selection)}"; {_describe_known(elements, selection)}')


def one_line(name: str) -> str:
    """Collapse line breaks and other white space of a name to single spaces, as tables show it."""
    return " ".join("".join(letter if letter.isprintable() else " " for letter in name).split())


def short_name(name: str) -> str:
    """Return a file's name for an element on one line, shortened to fit a sentence."""
    line = one_line(name)
    return line if len(line) <= LONGEST_NAME else f"{line[: LONGEST_NAME - 1]}…"


def list_names(names: Sequence[str]) -> str:
    """List the first names of many for a sentence."""
    more = f" and {len(names) - MAX_LISTED} more" if len(names) > MAX_LISTED else ""
    return ", ".join(short_name(name) for name in names[:MAX_LISTED]) + more


def _indices(elements: Sequence[Element], fit: Sequence[bool]) -> tuple[int, ...]:
    return tuple(i for i in range(len(elements)) if fit[i])


def _matches_pattern(element: Element, selection: str) -> bool:
    """Return whether a pattern matches a name of the element, or of what it is part of."""
    names = map(one_line, (*element.names, *element.within))
    return any(letter in selection for letter in WILDCARDS) and any(fnmatchcase(name, selection) for name in names)


def _refuse_ambiguous(
    elements: Sequence[Element], named: tuple[int, ...], selection: str, *, where: str
) -> tuple[int, ...]:
    """Return the elements of a name; raise where several have identifiers that distinguish them."""
    identifiers = [elements[i].identifier for i in named]
    if len(named) > 1 and all(identifiers):
        raise GeometryError(
            f'{where}: {len(named)} elements are called "{short_name(selection)}": {list_names(identifiers)}; '
            f'give the identifier (GlobalId) of one, or a pattern as "{short_name(selection)}*" for all of them'
        )
    return named


def _describe_known(elements: Sequence[Element], selection: str) -> str:
    """Describe the available names, those similar to the one given first."""
    known = list(dict.fromkeys(each.shown for each in elements if each.names or each.within or each.identifier))
    if not known:
        return "its parts have no names; remove the key"
    if any(each.kinds for each in elements) and selection.lower().startswith(CLASS_PREFIX):
        return _known_classes(elements, selection)
    words = dict.fromkeys(word for each in elements for word in (*each.names, *each.within))
    near = get_close_matches(selection, words, n=MAX_LISTED)
    return f"did you mean {list_names(near)}?" if near else f"known: {list_names(known)}"


def _known_classes(elements: Sequence[Element], selection: str) -> str:
    """Describe the available classes, those spelt similarly to the one given first."""
    short = {kind[len(CLASS_PREFIX) :].lower(): kind for each in elements for kind in each.kinds}
    near = get_close_matches(selection[len(CLASS_PREFIX) :].lower(), short, n=MAX_LISTED, cutoff=0.75)
    classes = sorted({each.kinds[0] for each in elements if each.kinds})
    return (
        f"did you mean {list_names([short[word] for word in near])}?"
        if near
        else f"its classes are {list_names(classes)}"
    )
