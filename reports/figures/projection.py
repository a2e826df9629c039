"""Bodies in space on paper: a parallel projection, faces drawn one over the other, and what an eye sees behind them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from heapq import heapify, heappop, heappush
from math import ceil, cos, floor, log10, radians, sin
from typing import Any, cast

import numpy as np
import shapely
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure

from reports.figures.style import INK, STONE_EDGE, bare_sheet
from reports.language.locale import Locale
from reports.language.texts import quantity, say
from spectra.arrays import BoolArray, FloatArray, IntArray

INCH = 72.0  # pt
TURNED, RAISED = radians(38), radians(22)  # the eye, off the normal of the plane of motion and above the horizon
AXIS_NAME_ROOM = 8.0  # room for the name of an axis [pt]
ARM = 0.3  # longest arm of the axes of the project [in]


@dataclass(frozen=True)
class TriangleSurface:
    """Vertices [n, 3] [m] and triangles [m, 3], anticlockwise seen from outside."""

    vertices: FloatArray
    triangles: IntArray

    @property
    def corners(self) -> FloatArray:
        """The corners of each triangle [m, 3, 3]."""
        return self.vertices[self.triangles]


@dataclass(frozen=True)
class PictureSize:
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


def viewing_frame(direction: FloatArray) -> FloatArray:
    """Return the unit vectors to the right, up and to the eye [3, 3] for a horizontal direction of motion [3]."""
    across = np.array([-direction[1], direction[0], 0.0])
    level = sin(TURNED) * direction - cos(TURNED) * across
    eye = cos(RAISED) * level + sin(RAISED) * np.array([0.0, 0.0, 1.0])
    right = cos(TURNED) * direction + sin(TURNED) * across
    return np.array([right, np.cross(eye, right), eye])


def fit_camera(direction: FloatArray, points: FloatArray, room: PictureSize) -> Camera:
    """Return the camera that shows all points [k, 3] as large as the room allows."""
    frame = viewing_frame(direction)
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


EDGE_ON = 1e-3  # of a unit normal: a face turned to the eye by less is not drawn
NEGLIGIBLE_OVERLAP = 1e-6  # of the bodies' size: faces that overlap by less do not cover one another
LIGHT = (0.35, 0.75, 0.55)  # to the right, up and towards the eye
DARKEST = 0.68  # of its colour: a face turned away from the light
LINE_WIDTH = 0.5  # width of the line around a face in its own colour, of a sharp edge, and of hatching [pt]


@dataclass(frozen=True)
class Hatching:
    """Lines over faces: their distance [pt], their angle from the horizontal [rad], and their colour."""

    gap: float
    angle: float
    colour: str


@dataclass(frozen=True)
class Appearance:
    """How bodies look: colours and hatchings by owner, and the angle [rad] from which on an edge is sharp."""

    colours: Mapping[int, str]
    hatched: Mapping[int, Hatching]
    sharp: float


def paint_bodies(axes: Axes, surface: TriangleSurface, owner: IntArray, camera: Camera, appearance: Appearance) -> None:
    """Draw the faces that look at the eye, farthest first, each with its hatching and its edges.

    Lines are triangles without area: shapes of equal length are what matplotlib makes paths of fastest.
    """
    corners, eye = surface.corners, camera.frame[2]
    front = np.flatnonzero(unit_normals(corners) @ eye > EDGE_ON)
    order = front[painting_order(corners[front] @ camera.frame.T)]
    seen = camera.project(corners[order])[..., :2]
    drawn = visible_edges(surface, eye, appearance.sharp)[order]
    shapes, inks = [], []
    shades = _shades(corners[order], owner[order], camera, appearance)
    for face, edges, ink, own in zip(seen, drawn, shades, owner[order].tolist(), strict=True):
        lines = hatch_lines(face, appearance.hatched[own]) if own in appearance.hatched else []
        rims = [face[[place, (place + 1) % 3, (place + 1) % 3]] for place in np.flatnonzero(edges)]
        shapes += [face, *lines, *rims]
        inks += [ink, *[to_rgb(appearance.hatched[own].colour) for _ in lines], *[to_rgb(STONE_EDGE) for _ in rims]]
    painted = PolyCollection(
        cast("Any", np.array(shapes)), facecolors=inks, edgecolors=inks, linewidths=LINE_WIDTH, joinstyle="round"
    )
    axes.add_collection(painted, autolim=False)


def hatch_lines(corners: FloatArray, lines: Hatching) -> list[FloatArray]:
    """Return the lines of a hatching within a triangle [3, 2], each as a triangle without area."""
    way, up = np.array([[cos(lines.angle), sin(lines.angle)], [-sin(lines.angle), cos(lines.angle)]])
    along, across = corners @ way, corners @ up / lines.gap
    heights = np.arange(ceil(across.min()), floor(across.max()) + 1) * lines.gap
    rows = [[along.min() * way + height * up, along.max() * way + height * up] for height in heights]
    if not rows:
        return []
    pieces = shapely.intersection(np.asarray(shapely.linestrings(rows)), shapely.polygons(corners))
    return [shapely.get_coordinates(piece)[[0, -1, -1]] for piece in pieces if piece.length > 0.0]


def unit_normals(corners: FloatArray) -> FloatArray:
    """Return unit normals [m, 3] of triangles [m, 3, 3]; of one without area, zero."""
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    return np.asarray(normal / np.where(length > 0.0, length, 1.0), dtype=np.float64)


def visible_edges(surface: TriangleSurface, eye: FloatArray, sharp: float) -> BoolArray:
    """Find the edges [m, 3] of a surface to draw: sharp ones, rims, and those at which it turns away from the eye.

    eye : unit vector towards it [3]
    sharp : the angle between neighbours from which on their common edge is drawn [rad]
    """
    triangles = surface.triangles
    edges = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=-1), axis=-1).reshape(-1, 2)
    key = edges[:, 0] * len(surface.vertices) + edges[:, 1]
    _, index, count = np.unique(key, return_inverse=True, return_counts=True)
    each = np.repeat(unit_normals(surface.corners), 3, axis=0)
    total = np.column_stack([np.bincount(index, weights=n) for n in each.T])[index]  # of a pair: n1 + n2
    cosine = np.einsum("ei,ei->e", total, each) - 1.0
    other = (total - each) @ eye
    pair = count[index] == 2
    drawn = (count[index] == 1) | (pair & ((cosine < cos(sharp)) | (other <= EDGE_ON)))
    return np.asarray(drawn.reshape(-1, 3))


def painting_order(corners: FloatArray) -> list[int]:
    """Return the order in which to draw triangles [m, 3, 3] so that none hides a nearer one.

    Where faces cover each other in a ring, the one whose middle is farthest is drawn first.
    """
    behind, in_front = occluding_pairs(corners)
    covers: dict[int, list[int]] = {}
    for far, near in zip(behind.tolist(), in_front.tolist(), strict=True):
        covers.setdefault(far, []).append(near)
    waiting = np.bincount(in_front, minlength=len(corners)).tolist()
    depth = corners[:, :, 2].mean(axis=1).tolist()
    rest = sorted(range(len(corners)), key=depth.__getitem__, reverse=True)
    free = [(depth[face], face) for face in rest if not waiting[face]]
    heapify(free)
    order: dict[int, None] = {}
    while rest or free:
        face = heappop(free)[1] if free else rest.pop()
        if face in order:
            continue
        order[face] = None
        for near in covers.get(face, ()):
            waiting[near] -= 1
            if not waiting[near]:
                heappush(free, (depth[near], near))
    return list(order)


def occluding_pairs(corners: FloatArray) -> tuple[IntArray, IntArray]:
    """Return overlapping pairs of triangles [m, 3, 3]: the one behind [k] and the one in front [k]."""
    flat = corners[:, :, :2]
    shrunk = np.asarray(shapely.polygons(flat + 1e-6 * (flat.mean(axis=1, keepdims=True) - flat)))
    one, other = shapely.STRtree(shrunk).query(shrunk, predicate="intersects")  # neighbours that only touch do not
    one, other = one[one < other], other[one < other]
    common = shapely.intersection(shrunk[one], shrunk[other])
    size = float(np.ptp(corners.reshape(-1, 3), axis=0).max())
    at = shapely.get_coordinates(shapely.centroid(common))
    gap = _plane_heights(corners[other], at) - _plane_heights(corners[one], at)
    meet = (shapely.area(common) > NEGLIGIBLE_OVERLAP * size**2) & (np.abs(gap) > NEGLIGIBLE_OVERLAP * size)
    one, other, gap = one[meet], other[meet], gap[meet]
    return np.where(gap > 0.0, one, other), np.where(gap > 0.0, other, one)


LINE_PIECES = 60  # pieces of a line
FEW_TRIANGLES = 200  # of a part, up to which points are taken on a grid over each
GRID_POINTS = 5  # of such a grid, along each side of a triangle
BEHIND = 0.02  # of the bodies' depth: what is nearer to a face is on it


@dataclass(frozen=True)
class Occluders:
    """Faces [m, 3, 3] that hide what is behind them, and the tree by which they are found."""

    faces: FloatArray
    tree: shapely.STRtree

    def hides(self, points: FloatArray) -> BoolArray:
        """Return whether each of points [k, 3] lies behind one of the faces."""
        slack = BEHIND * float(np.ptp(self.faces[:, :, 2]))
        point, face = self.tree.query(np.asarray(shapely.points(points[:, :2])), predicate="intersects")
        nearer = _plane_heights(self.faces[face], points[point, :2]) > points[point, 2] + slack
        return np.isin(np.arange(len(points)), point[nearer])


def occluding_faces(faces: FloatArray) -> Occluders:
    """Return faces [m, 3, 3], as the camera sees them, as occluders."""
    return Occluders(faces, shapely.STRtree(np.asarray(shapely.polygons(faces[:, :, :2]))))


def project_faces(surface: TriangleSurface, owner: IntArray, camera: Camera) -> tuple[Occluders, IntArray]:
    """Return the faces that look at the eye as the camera sees them, and the owner of each [m]."""
    corners = surface.corners
    front = unit_normals(corners) @ camera.frame[2] > EDGE_ON
    return occluding_faces(camera.project(corners[front])), owner[front]


def split_line(line: FloatArray, occluders: Occluders) -> Iterator[tuple[FloatArray, bool]]:
    """Yield the pieces [j, 3] of a line of points [k, 3], each with whether it is hidden."""
    along = np.linspace(0.0, len(line) - 1.0, LINE_PIECES * (len(line) - 1) if len(line) < 4 else 4 * len(line))
    points = np.column_stack([np.interp(along, np.arange(len(line)), line[:, axis]) for axis in range(3)])
    hidden = occluders.hides(points)
    turns = np.flatnonzero(np.diff(hidden)) + 1
    for start, end in zip([0, *turns], [*turns, len(points)], strict=True):
        yield points[start : end + 1], bool(hidden[start])


def visible_middle(own: FloatArray, occluders: Occluders) -> FloatArray | None:
    """Return the point [3] of a part's faces [j, 3, 3] nearest to the middle of what is seen; None if nothing is."""
    if not len(own):
        return None
    shares = _grid() if len(own) <= FEW_TRIANGLES else np.full((1, 3), 1.0 / 3.0)
    points = np.einsum("sc,jci->jsi", shares, own).reshape(-1, 3)
    weight = np.repeat(shapely.area(shapely.polygons(own[..., :2])), len(shares))
    seen = ~occluders.hides(points) & (weight > 0.0)
    if not seen.any():
        return None
    middle = np.average(points[seen, :2], axis=0, weights=weight[seen])
    return np.asarray(points[seen][np.linalg.norm(points[seen, :2] - middle, axis=1).argmin()])


def _draw_triad(axes: Axes, camera: Camera, arm: float, locale: Locale) -> None:
    """Draw the axes of the project at the lower left, each with the length `arm` [m] to scale, which is written."""
    arms = camera.frame[:2].T * arm * camera.scale * INCH
    origin = np.array([2.0, 10.0]) - np.minimum(arms.min(axis=0), 0.0) + AXIS_NAME_ROOM
    for way, name in zip(arms, "xyz", strict=True):
        draw_arrow(axes, np.array([origin, origin + way]), width=0.8)
        out = way / (float(np.linalg.norm(way)) or 1.0)
        axes.annotate(name, tuple(origin + way + 5.0 * out), ha="center", va="center", fontsize=6.5)
    axes.annotate(locale.text(say("arms {length}", length=quantity(arm, "length", 3))), (2.0, 2.0), fontsize=6.5)


def _shades(corners: FloatArray, owner: IntArray, camera: Camera, appearance: Appearance) -> list[tuple[float, ...]]:
    """Return the colour of each face: of its owner, darker the less it looks to the light."""
    light = np.array(LIGHT) / np.linalg.norm(LIGHT) @ camera.frame
    bright = DARKEST + (1.0 - DARKEST) * np.clip(unit_normals(corners) @ light, 0.0, 1.0)
    plain = np.array([to_rgb(appearance.colours[each]) for each in owner.tolist()]).reshape(-1, 3)
    return [tuple(ink) for ink in np.round(plain * bright[:, None], 4).tolist()]


def _plane_heights(corners: FloatArray, at: FloatArray) -> FloatArray:
    """Return the third coordinate [k] of the planes of triangles [k, 3, 3] at points [k, 2]."""
    normal = unit_normals(corners)
    away = np.einsum("ki,ki->k", normal[:, :2], at - corners[:, 0, :2])
    return np.asarray(corners[:, 0, 2] - away / normal[:, 2], dtype=np.float64)


def _grid() -> FloatArray:
    """Return shares of the corners [s, 3] of points over a triangle, none on its sides."""
    at = np.arange(GRID_POINTS) + 1.0 / 3.0
    first, second = (each.ravel() / GRID_POINTS for each in np.meshgrid(at, at))
    shares = np.column_stack([first, second, 1.0 - first - second])
    return np.asarray(shares[shares[:, 2] > 0.0])
