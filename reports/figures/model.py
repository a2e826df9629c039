"""The bodies of a mechanism as a model that a reader can turn: the scene of view.py, from any side."""

from __future__ import annotations

from math import atan2

import numpy as np

from assess.results import View
from reports.document import Model, Part, Place, Wire
from reports.figures.projection import RAISED, eye_of
from reports.figures.style import BLOCKS, FIXED, INK, NEGATIVE, POSITIVE, STONE_EDGE, label
from reports.figures.view import BEYOND, SHARP, SHARP_IN_SCANS, direction_arrow, extend_line


def model_of_view(view: View, *, positive: int) -> Model:
    """Return the model of a view, the first `positive` of whose axes are those of the positive branch."""
    along, size = np.array(view.direction), float(max(view.size))
    arrow = direction_arrow(np.array(view.vertices), along, size)
    wires = [Wire(ring, INK, dashed=True) for ring in view.sections]
    for place, axis in enumerate(view.axes):
        colour = POSITIVE if place < positive else NEGATIVE
        ends = _places(extend_line(np.array(axis.ends), BEYOND * size))
        wires.append(Wire(ends, colour, label(axis.name, 14), dashed=place >= positive))
    wires.append(Wire(_places(arrow), INK, arrow=True))
    sharp = SHARP if len(view.triangles) == view.given else SHARP_IN_SCANS
    towards = eye_of(along)[2]
    eye = (atan2(float(towards[1]), float(towards[0])), RAISED)
    return Model(view.vertices, _parts(view), tuple(wires), STONE_EDGE, sharp, eye)


def _parts(view: View) -> tuple[Part, ...]:
    """Return the faces of each block, and of what does not move."""
    faces: dict[int, list[tuple[int, int, int]]] = {}
    for block, triangle in zip(view.block_of, view.triangles, strict=True):
        faces.setdefault(block, []).append(triangle)
    return tuple(
        Part(FIXED if block < 0 else BLOCKS[block % len(BLOCKS)], tuple(triangles))
        for block, triangles in faces.items()
    )


def _places(points: np.ndarray) -> tuple[Place, ...]:
    return tuple((x, y, z) for x, y, z in np.round(points, 4).tolist())
