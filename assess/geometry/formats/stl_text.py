"""Text STL: facets of three corners, in solids that may have names."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from assess.geometry.formats.mesh_file import Element, MeshFile, Part, file_from_parts
from assess.geometry.formats.text_blocks import Block, join_lines, parse_numbers, read_blocks, rest_of_line
from spectra.arrays import BoolArray, FloatArray

BIT = 0x20  # between a letter and its capital
VERTEX, FACET, SOLID, END_LINE = b"vfse"


def read_text_stl(file: Path) -> MeshFile:
    """The solids of a text STL file.

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
    return file_from_parts(_solids(np.concatenate(corners), names, [*starts, count]))


def _corners(block: Block, chosen: BoolArray) -> FloatArray:
    """The corners [n, 3] of a block."""
    lines = int(np.count_nonzero(chosen))
    if not lines:
        return np.empty((0, 3))
    if (block.words[chosen] != 4).any():
        raise ValueError("a corner has not three coordinates")
    text = join_lines(block, chosen).lower().replace(b"vertex", b" ")
    return parse_numbers(text, count=3 * lines).reshape(-1, 3)


def _solids(corners: FloatArray, names: list[str], starts: list[int]) -> list[Part]:
    """The solids that have corners."""
    found = []
    for name, start, end in zip(names, starts[:-1], starts[1:], strict=True):
        if end > start:
            own = corners[start:end]
            found.append(Part(Element((name,) if name else ()), own, np.arange(len(own)).reshape(-1, 3)))
    return found
