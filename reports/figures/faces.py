"""The faces of bodies in space, sorted for drawing one over the other."""

from __future__ import annotations

from dataclasses import dataclass
from heapq import heapify, heappop, heappush

import numpy as np
import shapely

from spectra.arrays import BoolArray, FloatArray, IntArray

EDGE_ON = 1e-3  # of a unit normal: a face turned to the eye by less is not drawn
BESIDE = 1e-6  # of the bodies' size: faces that overlap by less do not cover one another


@dataclass(frozen=True)
class Faces:
    """Triangles in space.

    Attributes
    ----------
    corners : anticlockwise seen from outside [m, 3, 3] [m]
    edges : whether the edge from each corner to the next is drawn [m, 3]
    owner : block of each [m]
    """

    corners: FloatArray
    edges: BoolArray
    owner: IntArray

    @property
    def normals(self) -> FloatArray:
        """Outward unit normals [m, 3]; of a triangle without area, zero."""
        return normals(self.corners)


def normals(corners: FloatArray) -> FloatArray:
    """Return unit normals [m, 3] of triangles [m, 3, 3]; of one without area, zero."""
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    return np.asarray(normal / np.where(length > 0.0, length, 1.0), dtype=np.float64)


def visible_edges(vertices: FloatArray, triangles: IntArray, *, eye: FloatArray, sharp: float) -> BoolArray:
    """Find the edges [m, 3] of a surface to draw: sharp ones, rims, and those at which it turns away from the eye.

    Parameters
    ----------
    eye : unit vector towards it [3]
    sharp : the angle between neighbours from which on their common edge is drawn [rad]
    """
    edges = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=-1), axis=-1).reshape(-1, 2)
    key = edges[:, 0] * len(vertices) + edges[:, 1]
    _, index, count = np.unique(key, return_inverse=True, return_counts=True)
    each = np.repeat(normals(vertices[triangles]), 3, axis=0)
    total = np.column_stack([np.bincount(index, weights=n) for n in each.T])[index]  # of a pair: n1 + n2
    cosine = np.einsum("ei,ei->e", total, each) - 1.0
    other = (total - each) @ eye
    pair = count[index] == 2
    drawn = (count[index] == 1) | (pair & ((cosine < np.cos(sharp)) | (other <= EDGE_ON)))
    return np.asarray(drawn.reshape(-1, 3))


def front_faces(faces: Faces, eye: FloatArray) -> Faces:
    """Return the faces that look towards the eye, a unit vector [3], and are not seen edge-on."""
    which = faces.normals @ eye > EDGE_ON
    return Faces(faces.corners[which], faces.edges[which], faces.owner[which])


def painting_order(corners: FloatArray) -> list[int]:
    """Return the order in which to draw triangles [m, 3, 3] so that none hides a nearer one.

    Where faces cover each other in a ring, the one whose middle is farthest is drawn first.
    """
    behind, before = occluding_pairs(corners)
    covers: dict[int, list[int]] = {}
    for far, near in zip(behind.tolist(), before.tolist(), strict=True):
        covers.setdefault(far, []).append(near)
    waiting = np.bincount(before, minlength=len(corners)).tolist()
    depth = corners[:, :, 2].mean(axis=1).tolist()
    rest = sorted(range(len(corners)), key=depth.__getitem__, reverse=True)
    free = [(depth[face], face) for face in rest if not waiting[face]]
    heapify(free)
    drawn = [False] * len(corners)
    order: list[int] = []
    while rest or free:
        face = heappop(free)[1] if free else rest.pop()
        if drawn[face]:
            continue
        drawn[face] = True
        order.append(face)
        for near in covers.get(face, ()):
            waiting[near] -= 1
            if not waiting[near]:
                heappush(free, (depth[near], near))
    return order


def occluding_pairs(corners: FloatArray) -> tuple[IntArray, IntArray]:
    """Return overlapping pairs of triangles [m, 3, 3]: the one behind [k] and the one in front [k]."""
    flat = np.asarray(shapely.polygons(corners[:, :, :2]), dtype=np.object_)
    one, other = shapely.STRtree(flat).query(flat)
    first = one < other
    one, other = one[first], other[first]
    size = float(np.ptp(corners.reshape(-1, 3), axis=0).max())
    near = ~are_separated(corners[one, :, :2], corners[other, :, :2], by=-0.5 * BESIDE * size)
    one, other = one[near], other[near]
    common = shapely.intersection(flat[one], flat[other])
    meet = shapely.area(common) > BESIDE * size**2
    one, other = one[meet], other[meet]
    at = shapely.get_coordinates(shapely.centroid(common[meet]))
    gap = plane_heights(corners[other], at) - plane_heights(corners[one], at)
    apart = np.abs(gap) > BESIDE * size
    one, other, gap = one[apart], other[apart], gap[apart]
    return np.where(gap > 0.0, one, other), np.where(gap > 0.0, other, one)


def are_separated(one: FloatArray, other: FloatArray, *, by: float) -> BoolArray:
    """Return whether an edge of either of two triangles in a plane [k, 3, 2] lies between them [k].

    by : the gap from which on they are; a negative one lets them overlap by that much
    """
    found = edge_separates(one, other, by=by)
    rest = ~found
    found[rest] = edge_separates(other[rest], one[rest], by=by)
    return found


def edge_separates(these: FloatArray, those: FloatArray, *, by: float) -> BoolArray:
    """Return whether an edge of the first of two triangles in a plane [k, 3, 2] lies between them [k]."""
    edge = np.roll(these, -1, axis=1) - these
    outward = np.stack([edge[..., 1], -edge[..., 0]], axis=-1)
    outward /= np.maximum(np.linalg.norm(edge, axis=-1, keepdims=True), np.finfo(np.float64).tiny)
    outward *= np.sign(edge[:, 0, 0] * edge[:, 1, 1] - edge[:, 0, 1] * edge[:, 1, 0])[:, None, None]
    gap = (outward @ those.swapaxes(1, 2)).min(axis=2) - np.einsum("ked,ked->ke", these, outward)
    return np.asarray((gap > by).any(axis=1))


def plane_heights(corners: FloatArray, at: FloatArray) -> FloatArray:
    """Return the third coordinate [k] of the planes of triangles [k, 3, 3] at points [k, 2]."""
    normal = normals(corners)
    away = np.einsum("ki,ki->k", normal[:, :2], at - corners[:, 0, :2])
    return np.asarray(corners[:, 0, 2] - away / normal[:, 2], dtype=np.float64)
