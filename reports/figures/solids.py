"""Surfaces of triangles: cut by planes, divided into connected bodies, and compared by the ground they stand on."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from spectra.arrays import BoolArray, FloatArray, IntArray

WELD = 6  # decimals [m] to which vertices are one
FLAT = 1e-9  # of its plane: a vertex nearer is on it [m]
SHARED = 0.3  # of the smaller: bodies that share more of their ground and height cannot both stand there
SAMPLES = 15  # points along the ground of a body, in either direction


@dataclass(frozen=True)
class Surface:
    """Vertices [n, 3] [m] and triangles [m, 3], anticlockwise seen from outside."""

    vertices: FloatArray
    triangles: IntArray

    @property
    def corners(self) -> FloatArray:
        """The corners of each triangle [m, 3, 3]."""
        return self.vertices[self.triangles]


@dataclass(frozen=True)
class Plane:
    """A plane through a point [3] with a unit normal [3]."""

    point: FloatArray
    normal: FloatArray

    def heights(self, points: FloatArray) -> FloatArray:
        """Return the distance of points [..., 3] on the side of the normal [m]."""
        return np.asarray((points - self.point) @ self.normal)


def box_of(points: FloatArray) -> FloatArray:
    """Return the least and the largest coordinates [2, 3] of points [k, 3]."""
    return np.array([points.min(axis=0), points.max(axis=0)])


def plane_of(ring: FloatArray) -> Plane:
    """Return the plane of a ring of points [k, 3], its normal upwards where it is not upright."""
    middle = ring.mean(axis=0)
    normal = np.linalg.svd(ring - middle)[2][2]
    return Plane(middle, normal if normal[2] >= 0.0 else -normal)


def weld(corners: FloatArray) -> Surface:
    """Return the surface of loose triangles [m, 3, 3]: vertices in one place are one, triangles without area go."""
    vertices, index = np.unique(np.round(corners.reshape(-1, 3), WELD), axis=0, return_inverse=True)
    triangles = index.reshape(-1, 3)
    return Surface(vertices, triangles[(triangles != np.roll(triangles, 1, axis=1)).all(axis=1)])


def cut(corners: FloatArray, plane: Plane) -> FloatArray:
    """Cut triangles [m, 3, 3] by a plane: those that cross it become three each."""
    heights = plane.heights(corners)
    heights[np.abs(heights) < FLAT] = 0.0
    crossed = (heights.min(axis=1) < 0.0) & (heights.max(axis=1) > 0.0)
    whole, parts, heights = corners[~crossed], corners[crossed], heights[crossed]
    upper = (heights > 0.0).sum(axis=1) == 1
    alone = np.where(upper, heights.argmax(axis=1), heights.argmin(axis=1))
    turned = (alone[:, None] + np.arange(3)) % 3
    a, b, c = np.take_along_axis(parts, turned[..., None], axis=1).swapaxes(0, 1)
    h, i, j = np.take_along_axis(heights, turned, axis=1).T[..., None]
    p, q = a + (b - a) * h / (h - i), a + (c - a) * h / (h - j)
    return np.concatenate([whole, *(np.stack(three, axis=1) for three in ((a, p, q), (p, b, c), (p, c, q)))])


def body_numbers(surface: Surface) -> IntArray:
    """Return the number of the connected body that each triangle [m] belongs to."""
    a, b, c = surface.triangles.T
    start, end = np.concatenate([a, b]), np.concatenate([b, c])
    size = len(surface.vertices)
    _, body = connected_components(coo_array((np.ones(len(start)), (start, end)), shape=(size, size)), directed=False)
    return np.asarray(body[a])


def are_one_in_the_other(one: Surface, other: Surface) -> bool:
    """Return whether two surfaces share so much ground and height that they cannot both stand there."""
    boxes = np.array([box_of(one.vertices), box_of(other.vertices)])
    low, high = boxes[:, 0].max(axis=0), boxes[:, 1].min(axis=0)
    if (high <= low).any() or high[2] - low[2] <= SHARED * np.ptp(boxes[..., 2], axis=1).min():
        return False
    return shared_ground(one, other) > SHARED or shared_ground(other, one) > SHARED


def shared_ground(one: Surface, other: Surface) -> float:
    """Return the part of the ground under a surface that is under another too [-], by points on a grid."""
    low, high = box_of(one.vertices[:, :2])
    sides = np.linspace(low, high, SAMPLES + 2)[1:-1].T
    points = np.asarray(shapely.points(np.stack(np.meshgrid(*sides), axis=-1).reshape(-1, 2)))
    mine, its = (are_above(surface, points) for surface in (one, other))
    return float((mine & its).sum() / max(mine.sum(), 1))


def are_above(surface: Surface, points: FloatArray) -> BoolArray:
    """Return whether each point of the ground [k] lies under a surface."""
    faces = surface.corners[:, :, :2]
    (x, y), (u, v) = (faces[:, 1] - faces[:, 0]).T, (faces[:, 2] - faces[:, 0]).T
    tree = shapely.STRtree(np.asarray(shapely.polygons(faces[x * v - y * u > FLAT])))
    return np.isin(np.arange(len(points)), tree.query(points, predicate="intersects")[0])
