"""STL files. Those in plain binary form, which most programs write, are read at once; text is read line by line."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from assess.geometry.formats.mesh_file import Element, MeshFile, file_from_parts, make_part
from assess.geometry.formats.stl_text import read_text_stl

FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
TITLE = 80  # bytes before the number of facets
START = 1024  # bytes in which a binary file has a zero and a text has none


def read_stl(file: Path) -> MeshFile:
    """STL, text or binary."""
    with file.open("rb") as content:
        head = content.read(START)
    if b"\0" not in head:
        return read_text_stl(file)
    data = file.read_bytes()
    found = parse_binary_stl(data)
    if found is None:
        count = int.from_bytes(head[TITLE : TITLE + 4], "little")
        raise ValueError(
            f"it announces {count} facets of {FACET.itemsize} bytes and has {len(data)} bytes; is it whole?"
        )
    return found


def parse_binary_stl(data: bytes) -> MeshFile | None:
    """The mesh of a binary STL file; None where the number of facets it says is not that of its bytes."""
    start = TITLE + 4
    count = int.from_bytes(data[TITLE:start], "little")
    if not count or len(data) != start + count * FACET.itemsize:
        return None
    corners = np.frombuffer(data, FACET, offset=start)["corners"]
    columns = np.empty((3, count, 3))  # x of all corners, then y, then z: they are worked through so
    for axis in range(3):
        columns[axis] = corners[:, :, axis]
    return _unnamed_mesh(columns.reshape(3, -1).T, np.arange(3 * count).reshape(-1, 3))


def _unnamed_mesh(vertices: ArrayLike, triangles: ArrayLike) -> MeshFile:
    """A file of one nameless mesh."""
    return file_from_parts([make_part(Element(), vertices, triangles)])
