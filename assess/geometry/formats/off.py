"""Object File Format, text: positions, then faces; colours and normals are ignored."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from assess.geometry.formats.mesh_file import Element, MeshFile, fan_triangles, file_from_meshes, make_element_mesh
from assess.geometry.formats.text_blocks import TextBlock, join_lines, parse_numbers, read_blocks, rows_by_length
from spectra.arrays import BoolArray, FloatArray, IntArray

HEADER = re.compile(
    rb"\A(?:\xef\xbb\xbf)?(?:\s|#[^\n]*\n)*(?:ST)?C?N?OFF(?![A-Za-z])(?:\s|#[^\n]*\n)*"
    rb"(\d{1,12})\s+(\d{1,12})(?:[ \t]+\d+)?[^\n]*\n"
)
LONGEST = 1 << 16  # bytes before the first vertex
LEAST = 3  # corners of a face, coordinates of a vertex


def read_off(file: Path) -> MeshFile:
    """Read the mesh of an OFF file.

    Raises
    ------
    ValueError : it is another file, or has fewer vertices or faces than it announces
    """
    with file.open("rb") as content:
        start = content.read(LONGEST).replace(b"\r\n", b" \n")
    header = HEADER.match(start)
    if header is None:
        raise ValueError("it does not begin as text of the Object File Format: OFF, then numbers of vertices and faces")
    vertices, faces = int(header[1]), int(header[2])
    points, triangles = [np.empty((0, 3))], [np.empty((0, 3), dtype=np.int64)]
    widths: set[int] = set()
    lines = 0
    for block in read_blocks(file, skip=header.end(), comments=True):
        content_lines = block.words > 0
        place = lines + np.cumsum(content_lines) - 1
        positions = content_lines & (place < vertices)
        widths |= set(block.words[positions].tolist())
        points.append(_points(block, positions))
        triangles += _faces(block, content_lines & (place >= vertices) & (place < vertices + faces))
        lines += int(np.count_nonzero(content_lines))
    if lines < vertices + faces:
        raise ValueError(f"it announces {vertices} vertices and {faces} faces and has {lines} lines of them")
    if len(widths) > 1:
        raise ValueError(f"some vertices have {min(widths)} numbers, others {max(widths)}; is a decimal lost?")
    return file_from_meshes([make_element_mesh(Element(), np.concatenate(points), np.concatenate(triangles))])


def _points(block: TextBlock, chosen: BoolArray) -> FloatArray:
    """Return the vertices [n, 3] of a block."""
    sizes = block.words[chosen]
    if not len(sizes):
        return np.empty((0, 3))
    if sizes.min() < LEAST:
        raise ValueError(f"a vertex has {sizes.min()} coordinates")
    values = parse_numbers(join_lines(block, chosen), count=int(sizes.sum()))
    found = np.empty((len(sizes), 3))
    for places, rows in rows_by_length(values, sizes):
        found[places] = rows[:, :3]
    return found


def _faces(block: TextBlock, chosen: BoolArray) -> list[IntArray]:
    """Return the triangles [m, 3] of the faces of a block: number of corners, corners, possibly a colour."""
    sizes = block.words[chosen]
    if not len(sizes):
        return []
    values = parse_numbers(join_lines(block, chosen), count=int(sizes.sum()))
    found = []
    for _, rows in rows_by_length(values, sizes):
        for corners in np.unique(rows[:, 0]).tolist():
            own = rows[rows[:, 0] == corners]
            if corners != int(corners) or not 0 <= corners < rows.shape[1]:
                raise ValueError(f"a face of {corners:g} corners has {rows.shape[1] - 1} numbers")
            if corners >= LEAST:
                found.append(fan_triangles(own[:, 1 : int(corners) + 1].astype(np.int64)))
    return found
