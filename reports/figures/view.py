"""The bodies of a mechanism in space, with the axes they turn about: a parallel projection, farthest faces first."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import cos, radians, sin
from typing import Any, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from assess.results import View
from reports.figures.faces import Faces, front_faces, painting_order, visible_edges
from reports.figures.style import (
    BLOCKS,
    FIXED,
    INK,
    NEGATIVE,
    POSITIVE,
    STONE_EDGE,
    WIDTH,
    bare_sheet,
    label,
    report_style,
)
from spectra.arrays import BoolArray, FloatArray

INCH = 72.0  # pt
TALLEST, WIDEST = 3.3, 5.2  # of the picture [in]
TURNED, RAISED = radians(38), radians(22)  # the eye, off the normal of the plane of motion and above the horizon
LIGHT = (0.35, 0.75, 0.55)  # to the right, up and towards the eye
DARKEST = 0.62  # of its colour: a face turned away from the light
BEYOND = 0.07  # of the bodies' size: how far an axis is drawn beyond them
SHARP, SHARP_IN_SCANS = radians(35), radians(65)  # angle between faces from which on their common edge is drawn
NAME = (11.0, 8.5)  # room of the name of an axis [pt]
LINE = 0.6  # width of the line around a face in its own colour, and of a sharp edge [pt]


@dataclass(frozen=True)
class Camera:
    """A parallel projection: the unit vectors to the right, up and to the eye [3, 3], and inches to the metre."""

    frame: FloatArray
    origin: FloatArray
    scale: float

    def project(self, points: FloatArray) -> FloatArray:
        """Project points [k, 3] [m]: right and up from the lower left corner [pt], and towards the eye [m]."""
        placed = points @ self.frame.T
        return np.column_stack([(placed[:, :2] - self.origin) * self.scale * INCH, placed[:, 2]])


def draw(view: View, positive: int) -> Figure:
    """Draw the bodies, their sections, the axes of rotation and the direction of motion."""
    vertices = np.array(view.vertices)
    size = float(max(view.size))
    lines = [extend_line(np.array(axis.ends), BEYOND * size) for axis in view.axes]
    arrow = direction_arrow(vertices, np.array(view.direction), size)
    camera, (wide, high) = fit_camera(np.array(view.direction), [vertices, arrow, *lines])
    with report_style():
        figure = bare_sheet(high)
        axes = figure.add_axes((0.5 * (1.0 - wide / WIDTH), 0.0, wide / WIDTH, 1.0))
        axes.set(xlim=(0.0, wide * INCH), ylim=(0.0, high * INCH))
        axes.set_axis_off()
        _bodies(axes, view, camera)
        for ring in view.sections:
            axes.plot(*camera.project(np.array(ring))[:, :2].T, color=INK, linewidth=0.8, linestyle=(0, (2, 1.5)))
        _axes(axes, view, camera, lines, positive)
        _arrow(axes, *camera.project(arrow)[:, :2], colour=INK, width=1.6)
        _triad(axes, camera)
        return figure


def fit_camera(direction: FloatArray, sets: Sequence[FloatArray]) -> tuple[Camera, tuple[float, float]]:
    """Return the camera that shows all points of the sets as large as possible, and the picture's size [in]."""
    along, up = direction, np.array([0.0, 0.0, 1.0])
    across = np.array([-along[1], along[0], 0.0])
    level = sin(TURNED) * along - cos(TURNED) * across
    eye = cos(RAISED) * level + sin(RAISED) * up
    right = cos(TURNED) * along + sin(TURNED) * across
    frame = np.array([right, np.cross(eye, right), eye])
    placed = np.concatenate(sets) @ frame[:2].T
    low, high = placed.min(axis=0), placed.max(axis=0)
    margin, triad = 0.25, 0.75  # in
    scale = float(min((WIDEST - 2 * margin - triad) / (high[0] - low[0]), (TALLEST - 2 * margin) / (high[1] - low[1])))
    wide, tall = (high - low) * scale + 2 * margin
    return Camera(frame, low - np.array([margin + triad, margin]) / scale, scale), (float(wide) + triad, float(tall))


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


def _bodies(axes: Axes, view: View, camera: Camera) -> None:
    """Draw the faces that look at the eye, farthest first, each with the edges that belong to it."""
    vertices, triangles = np.array(view.vertices), np.array(view.triangles)
    sharp = SHARP if len(triangles) == view.given else SHARP_IN_SCANS
    edges = visible_edges(vertices, triangles, eye=camera.frame[2], sharp=sharp)
    every = Faces(vertices[triangles], edges, np.array(view.block_of))
    faces = front_faces(every, camera.frame[2])
    seen = camera.project(faces.corners.reshape(-1, 3))[:, :2].reshape(-1, 3, 2)
    order = painting_order(faces.corners @ camera.frame.T)
    shapes, inks = paint_faces(seen[order], faces.edges[order], shade_faces(faces, camera)[order])
    faced = PolyCollection(cast("Any", shapes), facecolors=inks, edgecolors=inks, linewidths=LINE, joinstyle="round")
    axes.add_collection(faced, autolim=False)


def paint_faces(corners: FloatArray, drawn: BoolArray, colours: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return triangles [k, 3, 2] and their colours [k, 3]: each face, then its edges as triangles without area.

    Shapes of equal length in one array are what matplotlib makes paths of fastest.
    """
    ends = np.roll(corners, -1, axis=1)
    edges = np.stack([corners, ends, ends], axis=2)  # [m, 3, 3, 2]
    inks = np.broadcast_to(to_rgb(STONE_EDGE), edges.shape[:3])
    there = np.column_stack([np.ones(len(drawn), dtype=np.bool_), drawn])
    shapes = np.concatenate([corners[:, None], edges], axis=1)
    return shapes[there], np.concatenate([colours[:, None], inks], axis=1)[there]


def shade_faces(faces: Faces, camera: Camera) -> FloatArray:
    """Return the colour [m, 3] of each face: of its block, darker the less it looks to the light."""
    light = np.array(LIGHT) / np.linalg.norm(LIGHT) @ camera.frame
    bright = DARKEST + (1.0 - DARKEST) * np.clip(faces.normals @ light, 0.0, 1.0)
    stones = np.array([to_rgb(colour) for colour in (*BLOCKS, FIXED)])
    plain = stones[np.where(faces.owner < 0, len(BLOCKS), faces.owner % len(BLOCKS))]
    return np.asarray(np.round(plain * bright[:, None], 4))


def _axes(axes: Axes, view: View, camera: Camera, lines: Sequence[FloatArray], positive: int) -> None:
    """Draw the axes of rotation, those of the negative branch dashed, with names at the end nearer the eye."""
    named: list[FloatArray] = []
    for place, (axis, line) in enumerate(zip(view.axes, lines, strict=True)):
        colour, dash = (POSITIVE, "-") if place < positive else (NEGATIVE, "--")
        seen = camera.project(line)
        far, near = seen[np.argsort(seen[:, 2]), :2]
        axes.plot(*seen[:, :2].T, color=colour, linestyle=dash, linewidth=1.5)
        out = (near - far) / (float(np.linalg.norm(near - far)) or 1.0)
        name = label(axis.name, 14)
        named.append(avoid_names(near + (5.0 + 2.0 * len(name)) * out, named))
        axes.annotate(name, tuple(named[-1]), ha="center", va="center", color=colour, fontsize=7.5)


def avoid_names(at: FloatArray, taken: Sequence[FloatArray]) -> FloatArray:
    """Return the place of a name [pt], lowered where one of those taken is too near to read both."""
    while any((np.abs(at - other) < NAME).all() for other in taken):
        at = at - np.array([0.0, 1.0])
    return at


def _arrow(axes: Axes, start: FloatArray, end: FloatArray, *, colour: str, width: float) -> None:
    style = {"arrowstyle": "-|>", "color": colour, "linewidth": width, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", tuple(end), xytext=tuple(start), arrowprops=style, annotation_clip=False)


def _triad(axes: Axes, camera: Camera) -> None:
    """Draw the axes of the project in the lower left corner."""
    origin = np.array([26.0, 20.0])
    for place, name in enumerate("xyz"):
        way = camera.frame[:2, place]
        _arrow(axes, origin, origin + 20.0 * way, colour=INK, width=0.8)
        axes.annotate(name, tuple(origin + 27.0 * way), ha="center", va="center", fontsize=7)
