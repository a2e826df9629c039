"""Bodies in space on paper: a parallel projection, farthest faces first."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import ceil, cos, floor, radians, sin
from typing import Any, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb

from reports.figures.faces import Faces, front_faces, painting_order, visible_edges
from reports.figures.solids import Surface
from reports.figures.style import INK, STONE_EDGE
from spectra.arrays import BoolArray, FloatArray, IntArray

INCH = 72.0  # pt
TURNED, RAISED = radians(38), radians(22)  # the eye, off the normal of the plane of motion and above the horizon
LIGHT = (0.35, 0.75, 0.55)  # to the right, up and towards the eye
DARKEST = 0.68  # of its colour: a face turned away from the light
NAME = 8.0  # room for the name of an axis [pt]
LINE = 0.5  # width of the line around a face in its own colour, of a sharp edge, and of hatching [pt]


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


@dataclass(frozen=True)
class Room:
    """The greatest size of a picture, and what stays free on its left and around it [in]."""

    wide: float
    tall: float
    left: float = 0.0
    around: float = 0.12


@dataclass(frozen=True)
class Hatching:
    """Lines over faces: their distance [pt], their angle from the horizontal [rad], and their colour."""

    gap: float
    angle: float
    colour: str


def eye_of(direction: FloatArray) -> FloatArray:
    """Return the unit vectors to the right, up and to the eye [3, 3] for a horizontal direction of motion [3]."""
    across = np.array([-direction[1], direction[0], 0.0])
    level = sin(TURNED) * direction - cos(TURNED) * across
    eye = cos(RAISED) * level + sin(RAISED) * np.array([0.0, 0.0, 1.0])
    right = cos(TURNED) * direction + sin(TURNED) * across
    return np.array([right, np.cross(eye, right), eye])


def fit_camera(direction: FloatArray, points: FloatArray, room: Room) -> tuple[Camera, tuple[float, float]]:
    """Return the camera that shows all points [k, 3] as large as the room allows, and the picture's size [in]."""
    frame = eye_of(direction)
    placed = points @ frame[:2].T
    low, high = placed.min(axis=0), placed.max(axis=0)
    size = np.maximum(high - low, 1e-6)
    free = np.array([room.wide - room.left - 2 * room.around, room.tall - 2 * room.around])
    scale = float((free / size).min())
    wide, tall = size * scale + 2 * room.around
    return Camera(frame, low - np.array([room.around + room.left, room.around]) / scale, scale), (
        float(wide) + room.left,
        float(tall),
    )


def paint_bodies(
    axes: Axes,
    surface: Surface,
    owner: IntArray,
    camera: Camera,
    *,
    colours: Mapping[int, str],
    sharp: float,
    hatched: Mapping[int, Hatching] | None = None,
) -> None:
    """Draw the faces that look at the eye, farthest first, each with its hatching and the edges that belong to it.

    Parameters
    ----------
    owner : of each triangle [m]
    colours : of each owner; hatched : owners with lines over their faces
    sharp : angle between faces from which on their common edge is drawn [rad]
    """
    edges = visible_edges(surface.vertices, surface.triangles, eye=camera.frame[2], sharp=sharp)
    faces = front_faces(Faces(surface.corners, edges, owner), camera.frame[2])
    order = painting_order(faces.corners @ camera.frame.T)
    seen = camera.project(faces.corners.reshape(-1, 3))[:, :2].reshape(-1, 3, 2)[order]
    shapes, inks = paint_faces(
        seen, faces.edges[order], shade_faces(faces, camera, colours)[order],
        [(hatched or {}).get(int(each)) for each in faces.owner[order]],
    )  # fmt: skip
    drawn = PolyCollection(cast("Any", shapes), facecolors=inks, edgecolors=inks, linewidths=LINE, joinstyle="round")
    axes.add_collection(drawn, autolim=False)


def paint_faces(
    corners: FloatArray, drawn: BoolArray, colours: FloatArray, hatched: Sequence[Hatching | None] = ()
) -> tuple[FloatArray, FloatArray]:
    """Return triangles [k, 3, 2] and their colours [k, 3]: each face, then its lines as triangles without area.

    Shapes of equal length in one array are what matplotlib makes paths of fastest.
    """
    start, end = corners[drawn], np.roll(corners, -1, axis=1)[drawn]
    shapes = [corners, np.stack([start, end, end], axis=1)]
    inks = [colours, np.broadcast_to(to_rgb(STONE_EDGE), (len(start), 3))]
    rank = [np.arange(len(corners)), np.nonzero(drawn)[0] + 0.5]
    for face, lines in enumerate(hatched):
        made = [] if lines is None else hatch(corners[face], lines)
        if lines is not None and made:
            shapes.append(np.array(made))
            inks.append(np.broadcast_to(to_rgb(lines.colour), (len(made), 3)))
            rank.append(np.full(len(made), face + 0.25))
    order = np.argsort(np.concatenate(rank), kind="stable")
    return np.concatenate(shapes)[order], np.concatenate(inks)[order]


def hatch(corners: FloatArray, lines: Hatching) -> list[FloatArray]:
    """Return the lines of a hatching within a triangle [3, 2], each as a triangle without area."""
    way = np.array([cos(lines.angle), sin(lines.angle)])
    across = (corners @ np.array([-way[1], way[0]])) / lines.gap
    made = []
    for place in range(ceil(across.min()), floor(across.max()) + 1):
        ends = [
            corners[i] + (corners[j] - corners[i]) * (place - across[i]) / (across[j] - across[i])
            for i, j in ((0, 1), (1, 2), (2, 0))
            if min(across[i], across[j]) <= place <= max(across[i], across[j]) and across[i] != across[j]
        ]
        if len(ends) >= 2:
            ends.sort(key=lambda end: float(end @ way))
            made.append(_line(ends[0], ends[-1]))
    return made


def _line(start: FloatArray, end: FloatArray) -> FloatArray:
    return np.array([start, end, end])


def shade_faces(faces: Faces, camera: Camera, colours: Mapping[int, str]) -> FloatArray:
    """Return the colour [m, 3] of each face: of its owner, darker the less it looks to the light."""
    light = np.array(LIGHT) / np.linalg.norm(LIGHT) @ camera.frame
    bright = DARKEST + (1.0 - DARKEST) * np.clip(faces.normals @ light, 0.0, 1.0)
    owners, index = np.unique(faces.owner, return_inverse=True)
    plain = np.array([to_rgb(colours[owner]) for owner in owners.tolist()]).reshape(-1, 3)[index]
    return np.asarray(np.round(plain * bright[:, None], 4))


def draw_arrow(axes: Axes, start: FloatArray, end: FloatArray, *, width: float) -> None:
    """Draw an arrow between two points [pt]."""
    style = {"arrowstyle": "-|>", "color": INK, "linewidth": width, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 7}
    axes.annotate("", tuple(end), xytext=tuple(start), arrowprops=style, annotation_clip=False)


def draw_triad(axes: Axes, camera: Camera, *, at: tuple[float, float], arm: float) -> None:
    """Draw the axes of the project right of and above a point [pt], each with the length `arm` [m] to scale."""
    ways = camera.frame[:2].T * arm * camera.scale * INCH
    origin = np.array(at) - np.minimum(ways.min(axis=0), 0.0) + NAME
    for way, name in zip(ways, "xyz", strict=True):
        draw_arrow(axes, origin, origin + way, width=0.8)
        out = way / (float(np.linalg.norm(way)) or 1.0)
        axes.annotate(name, tuple(origin + way + 5.0 * out), ha="center", va="center", fontsize=6.5)
