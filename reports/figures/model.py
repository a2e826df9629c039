"""The scenes of view.py and key_plan.py as models that a reader can turn."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import atan2

import numpy as np

from assess.results import View
from reports.document import Model, Part, Place, Wire
from reports.figures.projection import RAISED, eye_of
from reports.figures.solids import Surface
from reports.figures.style import INK, NEGATIVE, POSITIVE, STONE_EDGE, label, shade
from reports.figures.view import BEYOND, direction_arrow, extend_line, sharp_angle
from spectra.arrays import FloatArray, IntArray


def model_of_view(view: View, *, positive: int) -> Model:
    """Return the model of a view, the first `positive` of whose axes are those of the positive branch."""
    surface = Surface(np.array(view.vertices), np.array(view.triangles))
    colours = {block: shade(block) for block in view.block_of}
    wires = tuple(_wires(view, surface, positive))
    return scene_model(surface, np.array(view.block_of), colours, wires, sharp_angle(view), np.array(view.direction))


def scene_model(
    surface: Surface,
    owner: IntArray,
    colours: Mapping[int, str],
    wires: tuple[Wire, ...],
    sharp: float,
    direction: FloatArray,
) -> Model:
    """Return bodies in the colours of their owners, first seen as the figure shows them for a direction of motion."""
    parts = (Part(colour, _indices(surface.triangles[owner == each])) for each, colour in colours.items())
    east, north, _ = eye_of(direction)[2].tolist()
    return Model(places(surface.vertices), tuple(parts), wires, STONE_EDGE, sharp, (atan2(north, east), RAISED))


def _indices(triangles: IntArray) -> tuple[tuple[int, int, int], ...]:
    return tuple((a, b, c) for a, b, c in triangles.tolist())


def places(points: FloatArray) -> tuple[Place, ...]:
    """Return points [k, 3] to a tenth of a millimetre."""
    return tuple((x, y, z) for x, y, z in np.round(points, 4).tolist())


def _wires(view: View, surface: Surface, positive: int) -> Iterator[Wire]:
    """Yield the sections of a view, its axes of rotation with their names, and the direction of motion."""
    size = float(max(view.size))
    yield from (Wire(places(np.array(ring)), INK, dashed=True) for ring in view.sections)
    for place, axis in enumerate(view.axes):
        colour, ends = POSITIVE if place < positive else NEGATIVE, extend_line(np.array(axis.ends), BEYOND * size)
        yield Wire(places(ends), colour, label(axis.name, 14), dashed=place >= positive)
    yield Wire(places(direction_arrow(surface.vertices, np.array(view.direction), size)), INK, arrow=True)
