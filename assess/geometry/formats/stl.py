"""STL files. Those in plain binary form, which most programs write, are read at once; text is read line by line."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from assess.geometry.formats.mesh_file import Element, ElementMesh, MeshFile, file_from_meshes, make_element_mesh
from assess.geometry.formats.text_blocks import TextBlock, join_lines, parse_numbers, read_blocks, rest_of_line
from spectra.arrays import BoolArray, FloatArray

RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
TITLE = 80  # bytes before the number of facets
START = 1024  # bytes in which a binary file has a zero and a text has none
BIT = 0x20  # between a letter and its capital
VERTEX, FACET, SOLID, END_LINE = b"vfse"


def read_stl(file: Path) -> MeshFile:
    """Read an STL file, text or binary."""
    with file.open("rb") as content:
        head = content.read(START)
    if b"\0" not in head:
        return read_text_stl(file)
    data = file.read_bytes()
    found = parse_binary_stl(data)
    if found is None:
        count = int.from_bytes(head[TITLE : TITLE + 4], "little")
        raise ValueError(
            f"it announces {count} facets of {RECORD.itemsize} bytes and has {len(data)} bytes; is it whole?"
        )
    return found


def parse_binary_stl(data: bytes) -> MeshFile | None:
    """Return the mesh of a binary STL file; None where its number of facets does not match its size."""
    start = TITLE + 4
    count = int.from_bytes(data[TITLE:start], "little")
    if not count or len(data) != start + count * RECORD.itemsize:
        return None
    corners = np.frombuffer(data, RECORD, offset=start)["corners"]
    columns = np.empty((3, count, 3))  # x of all corners, then y, then z: they are worked through so
    for axis in range(3):
        columns[axis] = corners[:, :, axis]
    return file_from_meshes(
        [make_element_mesh(Element(), columns.reshape(3, -1).T, np.arange(3 * count).reshape(-1, 3))]
    )


def read_text_stl(file: Path) -> MeshFile:
    """Read the solids of a text STL file.

    Raises
    ------
    ValueError : it has no facets, or one without three corners
    """
    corners, names, starts = [np.empty((0, 3))], [""], [0]
    count = facets = ends = 0
    for block in read_blocks(file):
        kind = block.first | BIT
        at = kind == VERTEX
        seen = count + np.cumsum(at)
        for line in np.flatnonzero(kind == SOLID).tolist():
            names.append(rest_of_line(block, line))
            starts.append(int(seen[line]))
        corners.append(_corners(block, at))
        facets += int(np.count_nonzero(kind == FACET))
        ends += int(np.count_nonzero(kind == END_LINE))
        count += len(corners[-1])
    if not facets:
        raise ValueError("it has no facets")
    if count != 3 * facets:
        raise ValueError(f"it has {facets} facets and {count} corners, not three for each")
    if ends <= 2 * facets:
        raise ValueError("its last solid has no end, is it whole?")
    return file_from_meshes(_solids(np.concatenate(corners), names, [*starts, count]))


def _corners(block: TextBlock, chosen: BoolArray) -> FloatArray:
    """Return the corners [n, 3] of a block."""
    lines = int(np.count_nonzero(chosen))
    if not lines:
        return np.empty((0, 3))
    if (block.words[chosen] != 4).any():
        raise ValueError("a corner has not three coordinates")
    text = join_lines(block, chosen).lower().replace(b"vertex", b" ")
    return parse_numbers(text, count=3 * lines).reshape(-1, 3)


def _solids(corners: FloatArray, names: list[str], starts: list[int]) -> list[ElementMesh]:
    """Return the solids that have corners."""
    found = []
    for name, start, end in zip(names, starts[:-1], starts[1:], strict=True):
        if end > start:
            own = corners[start:end]
            found.append(ElementMesh(Element((name,) if name else ()), own, np.arange(len(own)).reshape(-1, 3)))
    return found
