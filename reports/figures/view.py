"""The bodies of a mechanism in space, with the axes they turn about: as a figure, and as a model that a reader can
turn.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import atan2, radians

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from assess.results import View
from reports.document import ColouredFaces, Point, SpatialModel, Wire
from reports.figures.projection import (
    RAISED,
    Appearance,
    Camera,
    PictureSize,
    TriangleSurface,
    draw_arrow,
    eye_of,
    fit_camera,
    paint_bodies,
    scene_sheet,
)
from reports.figures.style import INK, NEGATIVE, POSITIVE, STONE_EDGE, WIDTH, label, report_style, shade
from reports.language.locale import Locale
from spectra.arrays import FloatArray, IntArray

VIEW_SIZE = PictureSize(wide=5.2, tall=3.0, left=0.75, around=0.25)
AXIS_BEYOND = 0.07  # of the bodies' size: how far an axis is drawn beyond them
AXIS_NAME_BOX = (11.0, 8.5)  # room of the name of an axis [pt]


def draw_view(view: View, positive: int, locale: Locale) -> Figure:
    """Draw the bodies, their sections, the axes of rotation and the direction of motion.

    positive : of the axes, how many from the first on are those of the positive side
    """
    surface = TriangleSurface(np.array(view.vertices), np.array(view.triangles))
    along, size = np.array(view.direction), float(max(view.size))
    lines = [extend_line(np.array(axis.ends), AXIS_BEYOND * size) for axis in view.axes]
    arrow = direction_arrow(surface.vertices, along, size)
    camera = fit_camera(along, np.concatenate([surface.vertices, arrow, *lines]), VIEW_SIZE)
    with report_style():
        figure, axes = scene_sheet(camera, WIDTH, locale)
        look = Appearance({block: shade(block) for block in view.block_of}, {}, sharp_angle(view))
        paint_bodies(axes, surface, np.array(view.block_of), camera, look)
        for ring in view.sections:
            axes.plot(*camera.project(np.array(ring))[:, :2].T, color=INK, linewidth=0.8, linestyle=(0, (2, 1.5)))
        _draw_rotation_axes(axes, view, camera, lines, positive)
        draw_arrow(axes, camera.project(arrow), width=1.6)
        return figure


def sharp_angle(view: View) -> float:
    """Return the angle between faces from which on their common edge is drawn [rad], larger for scans."""
    return radians(35 if len(view.triangles) == view.given else 65)


def extend_line(ends: FloatArray, length: float) -> FloatArray:
    """Extend a line, given by its ends [2, 3], by a length [m] at both."""
    way = ends[1] - ends[0]
    step = way * length / (float(np.linalg.norm(way)) or 1.0)
    return np.array([ends[0] - step, ends[1] + step])


def direction_arrow(vertices: FloatArray, along: FloatArray, size: float) -> FloatArray:
    """Return the ends [2, 3] of the arrow along the direction of motion, out of the leading face."""
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    middle = 0.5 * (low + high)
    start = middle + (float((vertices @ along).max()) - middle @ along) * along
    start[2] = low[2] + 0.75 * (high[2] - low[2])
    return np.array([start, start + 0.25 * size * along])


def _draw_rotation_axes(axes: Axes, view: View, camera: Camera, lines: Sequence[FloatArray], positive: int) -> None:
    """Draw the axes of rotation, those of the negative side dashed, with names at the end nearer the eye."""
    named: list[FloatArray] = []
    for place, (axis, line) in enumerate(zip(view.axes, lines, strict=True)):
        colour, dash = (POSITIVE, "-") if place < positive else (NEGATIVE, "--")
        seen = camera.project(line)
        far, near = seen[np.argsort(seen[:, 2]), :2]
        axes.plot(*seen[:, :2].T, color=colour, linestyle=dash, linewidth=1.5)
        out = (near - far) / (float(np.linalg.norm(near - far)) or 1.0)
        name = label(axis.name, 14)
        named.append(avoid_names(near + (5.0 + 2.0 * len(name)) * out, named))
        axes.annotate(name, tuple(named[-1]), ha="center", va="center", color=colour, fontsize=7)


def avoid_names(at: FloatArray, taken: Sequence[FloatArray]) -> FloatArray:
    """Return the place of a name [pt], lowered where one of those taken is too near to read both."""
    while any((np.abs(at - other) < AXIS_NAME_BOX).all() for other in taken):
        at = at - np.array([0.0, 1.0])
    return at


def model_of_view(view: View, *, positive: int) -> SpatialModel:
    """Return the model of a view, the first `positive` of whose axes are those of the positive branch."""
    surface = TriangleSurface(np.array(view.vertices), np.array(view.triangles))
    colours = {block: shade(block) for block in view.block_of}
    wires = tuple(_wires_of_view(view, surface, positive))
    return scene_model(surface, np.array(view.block_of), colours, wires, sharp_angle(view), np.array(view.direction))


def scene_model(
    surface: TriangleSurface,
    owner: IntArray,
    colours: Mapping[int, str],
    wires: tuple[Wire, ...],
    sharp: float,
    direction: FloatArray,
) -> SpatialModel:
    """Return bodies in the colours of their owners, first seen as the figure shows them for a direction of motion."""
    parts = (ColouredFaces(colour, _indices(surface.triangles[owner == each])) for each, colour in colours.items())
    east, north, _ = eye_of(direction)[2].tolist()
    return SpatialModel(
        rounded_points(surface.vertices), tuple(parts), wires, STONE_EDGE, sharp, (atan2(north, east), RAISED)
    )


def _indices(triangles: IntArray) -> tuple[tuple[int, int, int], ...]:
    return tuple((a, b, c) for a, b, c in triangles.tolist())


def rounded_points(points: FloatArray) -> tuple[Point, ...]:
    """Return points [k, 3] to a tenth of a millimetre."""
    return tuple((x, y, z) for x, y, z in np.round(points, 4).tolist())


def _wires_of_view(view: View, surface: TriangleSurface, positive: int) -> Iterator[Wire]:
    """Yield the sections of a view, its axes of rotation with their names, and the direction of motion."""
    size = float(max(view.size))
    yield from (Wire(rounded_points(np.array(ring)), INK, dashed=True) for ring in view.sections)
    for place, axis in enumerate(view.axes):
        colour, ends = POSITIVE if place < positive else NEGATIVE, extend_line(np.array(axis.ends), AXIS_BEYOND * size)
        yield Wire(rounded_points(ends), colour, label(axis.name, 14), dashed=place >= positive)
    yield Wire(rounded_points(direction_arrow(surface.vertices, np.array(view.direction), size)), INK, arrow=True)
