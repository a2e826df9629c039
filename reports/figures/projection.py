"""Space on paper: a parallel projection, with the axes of the project and a round length by which it is read."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, floor, log10, radians, sin

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from reports.figures.style import INK, bare_sheet
from reports.language.locale import Locale
from reports.language.texts import quantity, say
from spectra.arrays import FloatArray

INCH = 72.0  # pt
TURNED, RAISED = radians(38), radians(22)  # the eye, off the normal of the plane of motion and above the horizon
NAME = 8.0  # room for the name of an axis [pt]
ARM = 0.3  # longest arm of the axes of the project [in]


@dataclass(frozen=True)
class Room:
    """The greatest size of a picture, and what stays free on its left and around it [in]."""

    wide: float
    tall: float
    left: float
    around: float


@dataclass(frozen=True)
class Camera:
    """A parallel projection onto a picture.

    frame : unit vectors to the right, up and to the eye [3, 3]
    origin : lower left corner of the picture [2] [m]; size : its width and height [in]
    scale : inches to the metre
    """

    frame: FloatArray
    origin: FloatArray
    size: tuple[float, float]
    scale: float

    def project(self, points: FloatArray) -> FloatArray:
        """Project points [..., 3] [m]: right and up from the lower left corner [pt], and towards the eye [m]."""
        placed = points @ self.frame.T
        placed[..., :2] = (placed[..., :2] - self.origin) * self.scale * INCH
        return placed


def eye_of(direction: FloatArray) -> FloatArray:
    """Return the unit vectors to the right, up and to the eye [3, 3] for a horizontal direction of motion [3]."""
    across = np.array([-direction[1], direction[0], 0.0])
    level = sin(TURNED) * direction - cos(TURNED) * across
    eye = cos(RAISED) * level + sin(RAISED) * np.array([0.0, 0.0, 1.0])
    right = cos(TURNED) * direction + sin(TURNED) * across
    return np.array([right, np.cross(eye, right), eye])


def fit_camera(direction: FloatArray, points: FloatArray, room: Room) -> Camera:
    """Return the camera that shows all points [k, 3] as large as the room allows."""
    frame = eye_of(direction)
    placed = points @ frame[:2].T
    low = placed.min(axis=0)
    size = np.maximum(np.ptp(placed, axis=0), 1e-6)
    beside = np.array([room.left + room.around, room.around])
    scale = float(((np.array([room.wide, room.tall]) - beside - room.around) / size).min())
    wide, tall = (size * scale + beside + room.around).tolist()
    return Camera(frame, low - beside / scale, (wide, tall), scale)


def scene_sheet(camera: Camera, width: float, locale: Locale, *, below: float = 0.0) -> tuple[Figure, Axes]:
    """Return a figure of this width and its axes in points, with the axes of the project; below: left free [in]."""
    wide, high = camera.size
    figure = bare_sheet(high + below, locale, width=width)
    tall = high / (high + below)
    axes = figure.add_axes((0.5 * (1.0 - wide / width), 1.0 - tall, wide / width, tall))
    axes.set(xlim=(0.0, wide * INCH), ylim=(0.0, high * INCH))
    axes.set_axis_off()
    _draw_triad(axes, camera, round_length(ARM / camera.scale, locale), locale)
    return figure, axes


def _draw_triad(axes: Axes, camera: Camera, arm: float, locale: Locale) -> None:
    """Draw the axes of the project at the lower left, each with the length `arm` [m] to scale, which is written."""
    ways = camera.frame[:2].T * arm * camera.scale * INCH
    origin = np.array([2.0, 10.0]) - np.minimum(ways.min(axis=0), 0.0) + NAME
    for way, name in zip(ways, "xyz", strict=True):
        draw_arrow(axes, np.array([origin, origin + way]), width=0.8)
        out = way / (float(np.linalg.norm(way)) or 1.0)
        axes.annotate(name, tuple(origin + way + 5.0 * out), ha="center", va="center", fontsize=6.5)
    axes.annotate(locale.text(say("arms {length}", length=quantity(arm, "length", 3))), (2.0, 2.0), fontsize=6.5)


def draw_arrow(axes: Axes, ends: FloatArray, *, width: float) -> None:
    """Draw an arrow from the first of two points [pt] to the other."""
    style = {"arrowstyle": "-|>", "color": INK, "linewidth": width, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 7}
    start, end = ends[:, :2].tolist()
    axes.annotate("", end, xytext=start, arrowprops=style, annotation_clip=False)


def round_length(near: float, locale: Locale) -> float:
    """Return a length [m] of 1, 2 or 5 with zeros in the unit of the locale, the largest up to `near` [m]."""
    size = locale.table_unit("length").size
    power = 10.0 ** floor(log10(near / size))
    return size * power * next(digit for digit in (5, 2, 1) if digit * power <= near / size * (1 + 1e-9))
