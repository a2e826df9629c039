"""STL and PLY files in the plain binary forms that most programs write, read without trimesh, whose import takes 0.4 s.

What is not of just that form, trimesh reads, or refuses.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from assess.geometry.formats import by_trimesh
from assess.geometry.formats.parts import MeshFile, part

FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
TITLE = 80  # bytes before the number of facets
PLY = re.compile(
    rb"ply\r?\nformat binary_little_endian 1\.0\r?\n(?:(?:comment|obj_info)[^\n]*\n)*"
    rb"element vertex (\d{1,9})\r?\n((?:property \w+ \w+\r?\n)+)"
    rb"element face (\d{1,9})\r?\n"
    rb"property list (u?(?:char|short|int)\d*) (u?(?:char|short|int)\d*) vertex_ind(?:ices|ex)\r?\nend_header\r?\n"
)
TYPES = {
    b"char": "<i1",
    b"uchar": "<u1",
    b"short": "<i2",
    b"ushort": "<u2",
    b"int": "<i4",
    b"uint": "<u4",
    b"float": "<f4",
    b"double": "<f8",
    b"int8": "<i1",
    b"uint8": "<u1",
    b"int16": "<i2",
    b"uint16": "<u2",
    b"int32": "<i4",
    b"uint32": "<u4",
    b"float32": "<f4",
    b"float64": "<f8",
}


def read_stl(file: Path) -> MeshFile:
    """STL, text or binary."""
    return stl(file.read_bytes()) or by_trimesh.read_stl(file)


def read_ply(file: Path) -> MeshFile:
    """PLY, text or binary."""
    return ply(file.read_bytes()) or by_trimesh.read_ply(file)


def stl(data: bytes) -> MeshFile | None:
    """The mesh of a binary STL file; None where the number of facets it says is not that of its bytes."""
    start = TITLE + 4
    count = int.from_bytes(data[TITLE:start], "little")
    if not count or len(data) != start + count * FACET.itemsize:
        return None
    corners = np.frombuffer(data, FACET, offset=start)["corners"]
    columns = np.empty((3, count, 3))  # x of all corners, then y, then z: they are worked through so
    for axis in range(3):
        columns[axis] = corners[:, :, axis]
    return _of_one(columns.reshape(3, -1).T, np.arange(3 * count).reshape(-1, 3))


def ply(data: bytes) -> MeshFile | None:
    """The mesh of a PLY file of little-endian numbers: vertices, then triangles of which only the corners are said.

    None for any other.
    """
    header = PLY.match(data)
    types = None if header is None else _types(header)
    if header is None or types is None:
        return None
    (vertex, face), vertices, faces = types, int(header[1]), int(header[3])
    middle = header.end() + vertices * vertex.itemsize
    if not faces or len(data) != middle + faces * face.itemsize:
        return None
    points = np.frombuffer(data, vertex, count=vertices, offset=header.end())
    polygons = np.frombuffer(data, face, offset=middle)
    if not (polygons["size"] == 3).all():
        return None
    return _of_one(np.column_stack([points[axis] for axis in "xyz"]), polygons["corners"])


def _types(header: re.Match[bytes]) -> tuple[np.dtype[np.void], np.dtype[np.void]] | None:
    """How a vertex and a triangle are written; None where that is not plain."""
    rows = [line.split()[1:] for line in header[2].splitlines()]
    names = {name.decode() for _, name in rows}
    known = {header[4], header[5], *(kind for kind, _ in rows)} <= set(TYPES)
    if not known or len(names) < len(rows) or not {"x", "y", "z"} <= names:
        return None
    vertex = np.dtype([(name.decode(), TYPES[kind]) for kind, name in rows])
    return vertex, np.dtype([("size", TYPES[header[4]]), ("corners", TYPES[header[5]], 3)])


def _of_one(vertices: ArrayLike, triangles: ArrayLike) -> MeshFile:
    """A file of one nameless mesh."""
    return MeshFile((part([], vertices, triangles),))
