"""What a geometry file holds: triangle meshes, each with its names, and what the file says of unit and axes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
Up = Literal["y", "z"]


@dataclass(frozen=True)
class Part:
    """One mesh of a file, in its place.

    names : what the file calls it: its name, its identifier; none where the format has no names
    vertices : [n, 3] in the file's unit
    triangles : indices into vertices [m, 3]; none where the file holds a surface without its mesh
    """

    names: tuple[str, ...]
    vertices: FloatArray
    triangles: IntArray


@dataclass(frozen=True)
class MeshFile:
    """All meshes of a file.

    unit : length of the file's unit [m]; None where the format does not say
    up : which axis points up; None where the format does not say
    """

    parts: tuple[Part, ...]
    unit: float | None = None
    up: Up | None = None


def part(names: Sequence[str], vertices: ArrayLike, faces: ArrayLike) -> Part:
    """A part of vertices [n, 3] and faces of k corners [m, k], which become fans of triangles."""
    points = np.asarray(vertices, dtype=np.float64).reshape(-1, 3)
    return Part(tuple(name for name in names if name), points, fans(faces))


def fans(faces: ArrayLike) -> IntArray:
    """Triangles [m (k - 2), 3] of faces of k corners [m, k]: fans from the first corner."""
    corners = np.asarray(faces, dtype=np.int64)
    if corners.shape[1] == 3:
        return corners
    triangles = [corners[:, [0, i, i + 1]] for i in range(1, corners.shape[1] - 1)]
    return np.concatenate([np.empty((0, 3), dtype=np.int64), *triangles])


def moved(shape: Part, matrix: ArrayLike) -> Part:
    """The part after a transformation [4, 4] of homogeneous coordinates; a reflection turns its triangles."""
    A = np.asarray(matrix, dtype=np.float64)
    triangles = shape.triangles if np.linalg.det(A[:3, :3]) >= 0.0 else shape.triangles[:, ::-1]
    return Part(shape.names, shape.vertices @ A[:3, :3].T + A[:3, 3], triangles)


def together(parts: Sequence[Part]) -> tuple[FloatArray, IntArray]:
    """Vertices [n, 3] and triangles [m, 3] of all parts as one mesh."""
    if len(parts) == 1:
        return parts[0].vertices, parts[0].triangles
    starts = np.cumsum([0, *(len(each.vertices) for each in parts)])[: len(parts)]
    triangles = [each.triangles + start for each, start in zip(parts, starts, strict=True)]
    nothing = np.empty((0, 3))
    return (
        np.concatenate([nothing, *(each.vertices for each in parts)]),
        np.concatenate([nothing.astype(np.int64), *triangles]),
    )
