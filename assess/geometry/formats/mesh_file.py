"""A geometry file as data: its elements with their names and meshes, its unit and its vertical axis."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from assess.messages.message import Message
from spectra.arrays import FloatArray, IntArray

Up = Literal["y", "z"]
POINT_CLOUD = "it holds {count} points and no faces; make a closed surface of the points first"


@dataclass(frozen=True)
class Element:
    """One object of a file, as the file names it.

    Attributes
    ----------
    names : its name; none where the format has no names
    identifier : unique in the file, as the GlobalId of an IFC element; empty where there is none
    kinds : its class and the superclasses, as IfcWallStandardCase, IfcWall, ...
    storey : in which it is
    within : names, identifiers and classes of what it is part of, as an assembly or a block instance
    """

    names: tuple[str, ...] = ()
    identifier: str = ""
    kinds: tuple[str, ...] = ()
    storey: str = ""
    within: tuple[str, ...] = ()

    @property
    def shown(self) -> str:
        """The name to use in a sentence."""
        return next((name for name in (*self.names, *self.within, self.identifier) if name), "without name")


@dataclass(frozen=True)
class Part:
    """The mesh of one element, in its place.

    Attributes
    ----------
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

    Attributes
    ----------
    elements : all objects that can have a mesh
    mesh : returns the parts of the elements at given indices; an element that turns out to have no body is left out
    unit : length of the file's unit [m]; None where the format does not say
    up : which axis points up; None where the format does not say
    """

    elements: tuple[Element, ...]
    mesh: Callable[[Sequence[int]], tuple[Part, ...]]
    unit: float | None = None
    up: Up | None = None

    @property
    def parts(self) -> tuple[Part, ...]:
        """The meshes of all elements."""
        return self.mesh(range(len(self.elements)))


def file_from_parts(parts: Sequence[Part], *, unit: float | None = None, up: Up | None = None) -> MeshFile:
    """Return a file whose meshes are all there already."""
    found = tuple(parts)
    return MeshFile(tuple(each.element for each in found), lambda places: tuple(found[i] for i in places), unit, up)


def make_part(element: Element, vertices: ArrayLike, faces: ArrayLike) -> Part:
    """Make a part of vertices [n, 3] and faces of k corners [m, k], which become fans of triangles."""
    return Part(element, np.asarray(vertices, dtype=np.float64).reshape(-1, 3), fan_triangles(faces))


def part_without_mesh(element: Element, fault: str) -> Part:
    """Make the part of an element that has no mesh, with the reason."""
    return Part(element, np.empty((0, 3)), np.empty((0, 3), dtype=np.int64), fault)


def fan_triangles(faces: ArrayLike) -> IntArray:
    """Split faces of k corners [m, k] into fans of triangles [m (k - 2), 3] from the first corner."""
    corners = np.asarray(faces, dtype=np.int64)
    if corners.shape[1] == 3:
        return corners
    triangles = [corners[:, [0, i, i + 1]] for i in range(1, corners.shape[1] - 1)]
    return np.concatenate([np.empty((0, 3), dtype=np.int64), *triangles])


def transform(shape: Part, matrix: ArrayLike) -> Part:
    """Apply a transformation [4, 4] of homogeneous coordinates; a reflection reverses the triangles."""
    A = np.asarray(matrix, dtype=np.float64)
    triangles = shape.triangles if np.linalg.det(A[:3, :3]) >= 0.0 else shape.triangles[:, ::-1]
    return replace(shape, vertices=shape.vertices @ A[:3, :3].T + A[:3, 3], triangles=triangles)


def join_parts(parts: Sequence[Part]) -> tuple[FloatArray, IntArray]:
    """Join parts into one mesh: vertices [n, 3] and triangles [m, 3]."""
    if len(parts) == 1:
        return parts[0].vertices, parts[0].triangles
    starts = np.cumsum([0, *(len(each.vertices) for each in parts)])[: len(parts)]
    triangles = [each.triangles + start for each, start in zip(parts, starts, strict=True)]
    nothing = np.empty((0, 3))
    return (
        np.concatenate([nothing, *(each.vertices for each in parts)]),
        np.concatenate([nothing.astype(np.int64), *triangles]),
    )
