"""Bodies from mesh files. The only door to trimesh, which reads the files; it is not asked to mend anything."""

from __future__ import annotations

import io
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from assess.errors import GeometryError
from assess.geometry.solid import Solid, polyhedron
from assess.geometry.surface import check_closed, check_shells, merged

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]

LARGEST = 500.0  # m: no masonry body is longer
SMALLEST = 0.01  # m: none is shorter
COARSE = 1e-4  # of the body's size: rounding of coordinates that moves results


def load(path: Path | str, *, density: float, name: str, scale: float = 1.0) -> Solid:
    """The solid inside the closed triangle mesh of a file, STL (text or binary), OBJ or PLY.

    Vertices at equal positions are merged; nothing is repaired. Several shells are well when they do not overlap.

    Parameters
    ----------
    path : of the file
    density : [kg/m3]
    name : the body's name in the project
    scale : length of the file's unit [m]

    Raises
    ------
    GeometryError : the file is missing, of another kind, unreadable or without triangles; the mesh is open, has edges
        of three triangles or more, is not wound alike, is inside out, without volume, or has overlapping shells; a
        coordinate is not finite; scale or density is not positive
    """
    file = Path(path)
    where = f'body "{name}": mesh {file.name}'
    if not (np.isfinite(scale) and scale > 0.0):
        raise GeometryError(f"{where}: its unit is {scale:g} m; give a positive finite length")
    vertices, triangles = _read(file, where=where)
    points, faces = merged(_sound(vertices, triangles, where=where) * scale, triangles)
    if not len(faces):
        raise GeometryError(f"{where}: all its triangles have shrunk to lines or points; export it with more digits")
    check_closed(points, faces, where=where)
    solid = polyhedron(points, faces, density=density, name=name)
    check_shells(points, faces, where=where)
    return solid


def suspicious(solid: Solid) -> str | None:
    """A sentence for the warnings where size or coordinates of a mesh suggest a slip; None where nothing does."""
    size = float(np.ptp(solid.vertices, axis=0).max())
    if not SMALLEST <= size <= LARGEST:
        return f'body "{solid.name}" measures {size:.4g} m at its longest; is the unit of the mesh right?'
    farthest = float(np.abs(solid.vertices).max())
    rounding = farthest * float(np.finfo(np.float32).eps)
    if rounding > COARSE * size and np.array_equal(solid.vertices, solid.vertices.astype(np.float32)):
        return (
            f'body "{solid.name}" lies {farthest:.4g} m from the origin in single precision, which there resolves '
            f"{rounding:.2g} m; move the mesh near the origin before exporting it"
        )
    return None


def _read(file: Path, *, where: str) -> tuple[FloatArray, IntArray]:
    """Vertices [n, 3] and triangles [m, 3] as the file has them, all its parts together."""
    readers = _readers()
    if file.suffix.lower() not in readers:
        known = ", ".join(readers)
        raise GeometryError(f'{where}: files of kind "{file.suffix}" are not read; export it as one of {known}')
    try:
        content = file.read_bytes()
    except OSError as problem:
        raise GeometryError(f"{where}: {problem.strerror or problem} ({file}); check the path") from None
    try:
        loaded = readers[file.suffix.lower()](io.BytesIO(content))
        parts = list(loaded["geometry"].values()) if "geometry" in loaded else [loaded]
        return _together([part for part in parts if len(part.get("faces", ()))])
    except Exception as problem:  # the readers raise whatever a broken file leads them to
        reason = f" ({problem})" if str(problem) else ""
        kind = file.suffix[1:].upper()
        text = f"{where}: it cannot be read as {kind}{reason:.120}; export it again as STL, OBJ or PLY"
        raise GeometryError(" ".join(text.split())) from None


def _readers() -> dict[str, Callable[[io.BytesIO], dict[str, Any]]]:
    """Reader of each file kind. The format readers are called themselves: trimesh's own objects merge and drop."""
    from trimesh.exchange.obj import load_obj
    from trimesh.exchange.ply import load_ply
    from trimesh.exchange.stl import load_stl

    return {
        ".stl": load_stl,
        ".obj": lambda content: load_obj(content, skip_materials=True),
        ".ply": lambda content: load_ply(content, skip_materials=True),
    }


def _together(parts: list[dict[str, Any]]) -> tuple[FloatArray, IntArray]:
    """The parts of a file as one mesh."""
    vertices = [np.asarray(part["vertices"], dtype=np.float64).reshape(-1, 3) for part in parts]
    starts = np.cumsum([0, *(len(each) for each in vertices)])[: len(parts)]
    triangles = [_fans(part["faces"]) + start for part, start in zip(parts, starts, strict=True)]
    nothing = np.empty((0, 3))
    return np.concatenate([nothing, *vertices]), np.concatenate([nothing.astype(np.int64), *triangles])


def _fans(faces: ArrayLike) -> IntArray:
    """Triangles [m (k - 2), 3] of faces of k corners [m, k]: fans from the first corner."""
    corners = np.asarray(faces, dtype=np.int64)
    fans = [corners[:, [0, i, i + 1]] for i in range(1, corners.shape[1] - 1)]
    return np.concatenate([np.empty((0, 3), dtype=np.int64), *fans])


def _sound(vertices: FloatArray, triangles: IntArray, *, where: str) -> FloatArray:
    """The vertices, if there are triangles, all between vertices that are there and finite."""
    if not len(triangles):
        raise GeometryError(f"{where}: no triangles found; is it a closed triangle mesh, and whole?")
    if triangles.min() < 0 or triangles.max() >= len(vertices):
        wrong = int(triangles[(triangles < 0) | (triangles >= len(vertices))][0])
        raise GeometryError(f"{where}: a triangle uses vertex {wrong} of {len(vertices)}; export the mesh again")
    used = np.zeros(len(vertices), dtype=np.bool_)
    used[triangles] = True
    bad = np.flatnonzero(used & ~np.isfinite(vertices).all(axis=1))
    if len(bad):
        at = ", ".join(f"{value:g}" for value in vertices[bad[0]])
        raise GeometryError(f"{where}: {len(bad)} vertices are not finite, the first at ({at}); export the mesh again")
    return vertices
