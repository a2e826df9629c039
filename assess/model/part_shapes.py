"""The shape of one body, seen by itself: a plate, upright or level, a covering, an arch, a shaft, a bar or a block.

A plate is a body whose volume is its silhouette across the thin direction times the distance of its two faces. So a
ring of four walls in one closed surface is no plate, and a wall with windows is one.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
import shapely

from assess.geometry.mesh import extents, thin_direction
from assess.geometry.solid import Solid
from assess.geometry.surface import areas_and_normals, volume
from assess.mechanisms.mechanism import Vector
from assess.model.structure import Opening
from spectra.arrays import BoolArray, FloatArray

Region = Any  # a plane region of shapely, whose types lack areas and bounds
ShapeKind = Literal["upright", "level", "sloped", "curved", "arch", "shaft", "bar", "block"]


@dataclass(frozen=True)
class Shape:
    """What a body looks like.

    kind : an upright or level plate; a covering, of sloped planes or curved; an arch; a shaft; a bar; none of them
    thickness : between the faces of a plate, the depth of a level one; else the shorter side in plan [m]
    length : along `along` [m]
    width : of the shorter side in plan [m]
    height : of the box around it [m]
    normal, along : horizontal unit vectors (x, y, 0), the second a quarter turn anticlockwise from the first
    plan : area of its shadow on the ground [m2]
    eaves : elevation at which a pitched top begins; None where the top is level [m]
    tapers : whether it narrows upwards
    hollow : whether it encloses a void
    openings : holes through an upright plate
    """

    kind: ShapeKind
    thickness: float
    length: float
    width: float
    height: float
    normal: Vector
    along: Vector
    plan: float
    eaves: float | None = None
    tapers: bool = False
    hollow: bool = False
    openings: tuple[Opening, ...] = ()


LEVEL = 0.985  # vertical part of the mean normal of a level covering's upper faces: within 10 degrees
FACING = 0.9  # cosine with the normal of a plate: a battered or uneven face still counts as its face
PLANE = 0.6  # of the silhouette, that the face of a plate takes: of a wall that bends in plan it takes less
STEEP, SIDEWAYS = 0.26, 0.02  # vertical part of a normal: of a plate that leans by 15 degrees; of an upright end
FACE_SPREAD = 0.1  # m: what is farther than this from the middle of a face projects from it
FILL = (0.7, 1.3)  # volume over silhouette times thickness: pilasters add to it, recesses take away
SLENDER = 2.0  # least ratio of the sides of a plate
SLAB_DEPTH, VAULT_DEPTH = 1.0, 1.5  # m: mean depth of a covering over the ground that it covers
FLAT = 0.35  # of the square root of its plan: a deeper body is no covering
BAR = 5.0  # length over the second side
SHAFT = 1.2  # height over the longer side in plan
TAPER = 0.42  # height of the centroid over the height: 0.50 of a prism, 0.44 of a frustum of 0.7, 0.25 of a pyramid
HOLLOW = 0.7  # volume over that of the hull
PITCH = 0.4  # m: a top that rises by less is level
FULL_WIDTH, NARROW = 0.97, 0.5  # of the widest: a pitched top begins below the first and ends within the second
ARCH_FILL = 0.62  # of its box: a half ring fills less, a wall around an opening more
UP = np.array([0.0, 0.0, 1.0])


def shape_of(solid: Solid) -> Shape:
    """Return the shape of a body."""
    vertices, faces = solid.vertices, _faces(solid)
    thin = thin_direction(vertices, solid.triangles)
    normal = _plan_normal(vertices, thin)
    along = np.array([-normal[1], normal[0], 0.0])
    width, length, height = (float(np.ptp(vertices @ axis)) for axis in (normal, along, UP))
    whole, plan = volume(vertices, solid.triangles), faces.silhouette(UP).area
    upright = faces.plate(normal, whole) if length >= SLENDER * width else None
    level, tilted = faces.plate(UP, whole), faces.tilted_plate(whole)
    curved = _has_curved_underside(faces)

    def shape(kind: ShapeKind, thickness: float = width, **more: object) -> Shape:
        found = {"normal": _vector(normal), "along": _vector(along), "plan": float(plan)} | more
        return Shape(kind, thickness, length, width, height, **found)  # type: ignore[arg-type]

    if max(width, height) <= SLENDER * min(width, height) and max(width, height) * BAR <= length:
        return shape("bar")
    flat = [plate[0] for plate in (level, tilted) if plate is not None and width >= SLENDER * plate[0]]
    if upright is not None and upright[0] < min(flat, default=np.inf):
        thickness, silhouette = upright
        if curved and silhouette.area < ARCH_FILL * shapely.envelope(silhouette).area:
            return shape("arch", thickness)
        return shape("upright", thickness, eaves=_eaves(silhouette), openings=openings_of(silhouette))
    depth = whole / plan
    if curved and depth <= min(VAULT_DEPTH, FLAT * plan**0.5):
        return shape("curved", 2.0 * whole / faces.shell_area)
    if level is not None and width >= SLENDER * level[0] and depth <= SLAB_DEPTH:
        return shape("level", level[0])
    if depth <= min(SLAB_DEPTH, FLAT * plan**0.5):
        slope = _mean_slope(faces)
        return shape("level" if slope > LEVEL else "sloped", depth * slope)
    hull = shapely.MultiPoint(vertices[:, :2]).convex_hull.area
    if length < SLENDER * width and height >= SHAFT * length:
        tapers = (solid.centroid[2] - vertices[:, 2].min()) < TAPER * height
        hollow = not tapers and whole < HOLLOW * hull * height
        plane = None if tapers else faces.plate(normal, whole)  # a round one has no plane faces
        return shape("shaft", width if plane is None else plane[0], tapers=bool(tapers), hollow=bool(hollow))
    return shape("block", hollow=bool(whole < HOLLOW * hull * height))


def openings_of(silhouette: Region) -> tuple[Opening, ...]:
    """Return the holes through a wall, from its start on: those that reach neither its ends nor its top.

    Parameters
    ----------
    silhouette : of the wall, along it and up [m]
    """
    x0, _, x1, z1 = silhouette.bounds
    gap = shapely.difference(shapely.envelope(silhouette), silhouette)
    opened = shapely.buffer(shapely.buffer(gap, -UNEVEN, join_style="mitre"), UNEVEN, join_style="mitre")
    found = []
    for piece in shapely.get_parts(opened):
        left, base, right, top = piece.bounds
        inside = left > x0 + UNEVEN and right < x1 - UNEVEN and top < z1 - UNEVEN
        if inside and piece.area >= LEAST_OPENING:
            found.append(Opening(left - x0, right - x0, base, top))
    return tuple(sorted(found, key=lambda each: (each.left, each.base)))


def core_of(solid: Solid, shape: Shape) -> FloatArray:
    """Return the extent of a body without its slivers, across it, along it and up: least and largest [2, 3] [m].

    Parameters
    ----------
    solid : the body
    shape : of it
    """
    faces, axes = _faces(solid), np.array([shape.normal, shape.along, UP])
    low, high = np.full(3, -np.inf), np.full(3, np.inf)
    for k in range(3):
        seen = shapely.buffer(
            shapely.buffer(faces.silhouette(axes[k]), -UNEVEN / 2.0), UNEVEN / 2.0, join_style="mitre"
        )
        if seen.is_empty:
            continue
        places = shapely.get_coordinates(seen) @ _frame(axes[k]).T @ axes.T
        for j in (j for j in range(3) if j != k):
            low[j], high[j] = max(low[j], places[:, j].min()), min(high[j], places[:, j].max())
    return np.array([low, high])


UNEVEN = 0.05  # m: borders of walls are no straighter
LEAST_OPENING = 0.1  # m2: smaller ones are holes of beams and pipes


@dataclass(frozen=True)
class Faces:
    """The triangles of a body: corners [m, 3, 3] [m], area [m] [m2] and outward unit normal [m, 3]."""

    corners: FloatArray
    area: FloatArray
    normal: FloatArray

    def silhouette(self, axis: FloatArray) -> Region:
        """Return the shadow along an axis [3], in coordinates along it horizontally and up."""
        facing = self.normal @ axis > SEEN
        return shapely.union_all(shapely.polygons(self.corners[facing] @ _frame(axis)))

    def plate(self, axis: FloatArray, whole: float) -> tuple[float, Region] | None:
        """Return the distance of the two faces across an axis [m] and the silhouette; None where it is no plate.

        Parameters
        ----------
        axis : unit vector [3]
        whole : volume [m3]
        """
        thickness = self.distance(axis)
        if thickness <= 0.0:
            return None
        silhouette = self.silhouette(axis)
        sides = [float(self.area[side * (self.normal @ axis) > FACING].sum()) for side in (1.0, -1.0)]
        plane = min(sides) >= PLANE * silhouette.area
        return (
            (thickness, silhouette) if plane and FILL[0] <= whole / (silhouette.area * thickness) <= FILL[1] else None
        )

    def tilted_plate(self, whole: float) -> tuple[float, Region] | None:
        """Return the same across the axis that most of the surface faces; None where that is level or upright."""
        tensor = (self.normal * self.area[:, None]).T @ self.normal
        axis = np.linalg.eigh(tensor)[1][:, -1]
        axis = axis if axis[2] > 0.0 else -axis
        return self.plate(axis, whole) if STEEP < axis[2] < LEVEL else None

    @property
    def shell_area(self) -> float:
        """The area of the two sides of a curved covering, without its upright ends [m2]."""
        return float(self.area[np.abs(self.normal[:, 2]) > SIDEWAYS].sum())

    def distance(self, axis: FloatArray) -> float:
        """Return the distance of the two faces across an axis [3] [m]; 0 where there are not two."""
        cosine, place = self.normal @ axis, self.corners.mean(axis=1) @ axis
        front, back = cosine > FACING, cosine < -FACING
        if not (front.any() and back.any()):
            return 0.0
        return _level_of(place[front], self.area[front]) - _level_of(place[back], self.area[back])


def _frame(axis: FloatArray) -> FloatArray:
    """Return two unit vectors square to an axis [3, 2], the first of them horizontal."""
    side = np.array([-axis[1], axis[0], 0.0])
    side = side / np.linalg.norm(side) if side.any() else np.array([1.0, 0.0, 0.0])
    return np.column_stack([side, np.cross(axis, side)])


SEEN = 1e-6  # cosine: faces that lie along the axis cast no shadow


def _faces(solid: Solid) -> Faces:
    corners = solid.vertices[solid.triangles]
    return Faces(corners, *areas_and_normals(corners))


def _level_of(place: FloatArray, area: FloatArray) -> float:
    """Return where a face lies [m]: the mean place of the triangles near its median, weighed by area."""
    order = np.argsort(place)
    median = place[order[np.searchsorted(np.cumsum(area[order]), area.sum() / 2.0)]]
    near = np.abs(place - median) <= FACE_SPREAD
    return float(np.average(place[near], weights=area[near]))


def _plan_normal(vertices: FloatArray, thin: FloatArray | None) -> FloatArray:
    """Return the horizontal unit vector [3] along the shorter side in plan."""
    if thin is not None:
        width, length, _ = extents(vertices, thin)
        x, y = thin if width <= length else (-thin[1], thin[0])
        return np.array([x, y, 0.0])
    ring = shapely.get_coordinates(shapely.MultiPoint(vertices[:, :2]).minimum_rotated_rectangle)
    sides = np.diff(ring[:3], axis=0)
    x, y = sides[int(np.argmin(np.hypot(*sides.T)))]
    return np.asarray(np.array([x, y, 0.0]) / np.hypot(x, y), dtype=np.float64)


def _eaves(silhouette: Region) -> float | None:
    """Return the elevation at which the pitched top of a wall begins; None where the top is level [m]."""
    hull = silhouette.convex_hull
    x0, _, x1, top = hull.bounds
    levels = np.unique(shapely.get_coordinates(hull)[:, 1])

    def width(z: float) -> float:
        return float(shapely.intersection(hull, shapely.LineString([(x0 - 1.0, z), (x1 + 1.0, z)])).length)

    widths = np.array([width(z) for z in levels])
    eaves = float(levels[np.flatnonzero(widths >= FULL_WIDTH * widths.max())[-1]])
    rise = top - eaves
    return eaves if rise >= PITCH and width(eaves + 0.9 * rise) <= NARROW * widths.max() else None


def _mean_slope(faces: Faces) -> float:
    """Return the mean vertical part of the normals of the faces that look up, weighed by area [-]."""
    up: BoolArray = faces.normal[:, 2] > FLATTEST
    return float(np.average(faces.normal[up, 2], weights=faces.area[up]))


FLATTEST = 0.1  # vertical part of a normal: a steeper face looks sideways
DIRECTIONS, ROUND_TO = 4, 0.15  # of the underside of a vault, which a folded roof has not; how normals are told apart
LEAST_SHARE = 0.02  # of the underside that a direction takes
RISE = 0.15  # m: by which the steep parts of a vault's underside lie below the flat ones


def _has_curved_underside(faces: Faces) -> bool:
    """Return whether the faces that look down turn from steep and low to flat and high, as of a vault or an arch."""
    down = faces.normal[:, 2] < -FLATTEST
    area, normal, z = faces.area[down], faces.normal[down], faces.corners[down].mean(axis=1)[:, 2]
    if len(area) < DIRECTIONS:
        return False
    directions, index = np.unique(np.round(normal / ROUND_TO), axis=0, return_inverse=True)
    shares = np.bincount(index.ravel(), weights=area, minlength=len(directions)) / area.sum()
    real = shares > LEAST_SHARE
    steep = normal[:, 2] > -0.8
    if int(real.sum()) < DIRECTIONS or steep.all() or not steep.any():
        return False
    return bool(np.average(z[~steep], weights=area[~steep]) - np.average(z[steep], weights=area[steep]) >= RISE)


def _vector(axis: FloatArray) -> Vector:
    return (float(axis[0]) + 0.0, float(axis[1]) + 0.0, float(axis[2]) + 0.0)
