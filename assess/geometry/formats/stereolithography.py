"""Text STL: facets of three corners, in solids that may have names."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from assess.geometry.formats.lines import Block, blocks, numbers, text_of, words_of
from assess.geometry.formats.parts import Element, MeshFile, Part, file_of
from spectra.arrays import BoolArray, FloatArray

BIT = 0x20  # between a letter and its capital
VERTEX, FACET, SOLID, END = b"vfse"


def read_text_stl(file: Path) -> MeshFile:
    """The solids of a text STL file.

    Raises
    ------
    ValueError : it has no facets, or one without three corners
    """
    corners, names, starts = [np.empty((0, 3))], [""], [0]
    count = facets = ends = 0
    for block in blocks(file):
        kind = block.first | BIT
        at = kind == VERTEX
        seen = count + np.cumsum(at)
        for line in np.flatnonzero(kind == SOLID).tolist():
            names.append(words_of(block, line))
            starts.append(int(seen[line]))
        corners.append(_corners(block, at))
        facets += int(np.count_nonzero(kind == FACET))
        ends += int(np.count_nonzero(kind == END))
        count += len(corners[-1])
    if not facets:
        raise ValueError("it has no facets")
    if count != 3 * facets:
        raise ValueError(f"it has {facets} facets and {count} corners, not three for each")
    if ends <= 2 * facets:
        raise ValueError("its last solid has no end, is it whole?")
    return file_of(_parts(np.concatenate(corners), names, [*starts, count]))


def _corners(block: Block, chosen: BoolArray) -> FloatArray:
    """The corners [n, 3] of a block."""
    lines = int(np.count_nonzero(chosen))
    if not lines:
        return np.empty((0, 3))
    if (block.words[chosen] != 4).any():
        raise ValueError("a corner has not three coordinates")
    text = text_of(block, chosen).lower().replace(b"vertex", b" ")
    return numbers(text, count=3 * lines).reshape(-1, 3)


def _parts(corners: FloatArray, names: list[str], starts: list[int]) -> list[Part]:
    """The solids that have corners."""
    found = []
    for name, start, end in zip(names, starts[:-1], starts[1:], strict=True):
        if end > start:
            own = corners[start:end]
            found.append(Part(Element((name,) if name else ()), own, np.arange(len(own)).reshape(-1, 3)))
    return found
