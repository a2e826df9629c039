"""The faces of bodies in space, drawn one over the other."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from heapq import heapify, heappop, heappush
from math import ceil, cos, floor, sin
from typing import Any, cast

import numpy as np
import shapely
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgb

from reports.figures.projection import Camera
from reports.figures.solids import Surface
from reports.figures.style import STONE_EDGE
from spectra.arrays import BoolArray, FloatArray, IntArray

EDGE_ON = 1e-3  # of a unit normal: a face turned to the eye by less is not drawn
BESIDE = 1e-6  # of the bodies' size: faces that overlap by less do not cover one another
LIGHT = (0.35, 0.75, 0.55)  # to the right, up and towards the eye
DARKEST = 0.68  # of its colour: a face turned away from the light
LINE = 0.5  # width of the line around a face in its own colour, of a sharp edge, and of hatching [pt]


@dataclass(frozen=True)
class Hatching:
    """Lines over faces: their distance [pt], their angle from the horizontal [rad], and their colour."""

    gap: float
    angle: float
    colour: str


@dataclass(frozen=True)
class Look:
    """How bodies look: colours and hatchings by owner, and the angle [rad] from which on an edge is sharp."""

    colours: Mapping[int, str]
    hatched: Mapping[int, Hatching]
    sharp: float


def paint_bodies(axes: Axes, surface: Surface, owner: IntArray, camera: Camera, look: Look) -> None:
    """Draw the faces that look at the eye, farthest first, each with its hatching and its edges.

    Lines are triangles without area: shapes of equal length are what matplotlib makes paths of fastest.
    """
    corners, eye = surface.corners, camera.frame[2]
    front = np.flatnonzero(normals(corners) @ eye > EDGE_ON)
    order = front[painting_order(corners[front] @ camera.frame.T)]
    seen = camera.project(corners[order])[..., :2]
    drawn = visible_edges(surface, eye, look.sharp)[order]
    shapes, inks = [], []
    shades = _shades(corners[order], owner[order], camera, look)
    for face, edges, ink, own in zip(seen, drawn, shades, owner[order].tolist(), strict=True):
        lines = hatch(face, look.hatched[own]) if own in look.hatched else []
        rims = [face[[place, (place + 1) % 3, (place + 1) % 3]] for place in np.flatnonzero(edges)]
        shapes += [face, *lines, *rims]
        inks += [ink, *[to_rgb(look.hatched[own].colour) for _ in lines], *[to_rgb(STONE_EDGE) for _ in rims]]
    painted = PolyCollection(
        cast("Any", np.array(shapes)), facecolors=inks, edgecolors=inks, linewidths=LINE, joinstyle="round"
    )
    axes.add_collection(painted, autolim=False)


def _shades(corners: FloatArray, owner: IntArray, camera: Camera, look: Look) -> list[tuple[float, ...]]:
    """Return the colour of each face: of its owner, darker the less it looks to the light."""
    light = np.array(LIGHT) / np.linalg.norm(LIGHT) @ camera.frame
    bright = DARKEST + (1.0 - DARKEST) * np.clip(normals(corners) @ light, 0.0, 1.0)
    plain = np.array([to_rgb(look.colours[each]) for each in owner.tolist()]).reshape(-1, 3)
    return [tuple(ink) for ink in np.round(plain * bright[:, None], 4).tolist()]


def hatch(corners: FloatArray, lines: Hatching) -> list[FloatArray]:
    """Return the lines of a hatching within a triangle [3, 2], each as a triangle without area."""
    way, up = np.array([[cos(lines.angle), sin(lines.angle)], [-sin(lines.angle), cos(lines.angle)]])
    along, across = corners @ way, corners @ up / lines.gap
    heights = np.arange(ceil(across.min()), floor(across.max()) + 1) * lines.gap
    rows = [[along.min() * way + height * up, along.max() * way + height * up] for height in heights]
    if not rows:
        return []
    pieces = shapely.intersection(np.asarray(shapely.linestrings(rows)), shapely.polygons(corners))
    return [shapely.get_coordinates(piece)[[0, -1, -1]] for piece in pieces if piece.length > 0.0]


def normals(corners: FloatArray) -> FloatArray:
    """Return unit normals [m, 3] of triangles [m, 3, 3]; of one without area, zero."""
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    return np.asarray(normal / np.where(length > 0.0, length, 1.0), dtype=np.float64)


def visible_edges(surface: Surface, eye: FloatArray, sharp: float) -> BoolArray:
    """Find the edges [m, 3] of a surface to draw: sharp ones, rims, and those at which it turns away from the eye.

    eye : unit vector towards it [3]
    sharp : the angle between neighbours from which on their common edge is drawn [rad]
    """
    triangles = surface.triangles
    edges = np.sort(np.stack([triangles, np.roll(triangles, -1, axis=1)], axis=-1), axis=-1).reshape(-1, 2)
    key = edges[:, 0] * len(surface.vertices) + edges[:, 1]
    _, index, count = np.unique(key, return_inverse=True, return_counts=True)
    each = np.repeat(normals(surface.corners), 3, axis=0)
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
    behind, before = occluding_pairs(corners)
    covers: dict[int, list[int]] = {}
    for far, near in zip(behind.tolist(), before.tolist(), strict=True):
        covers.setdefault(far, []).append(near)
    waiting = np.bincount(before, minlength=len(corners)).tolist()
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
    gap = plane_heights(corners[other], at) - plane_heights(corners[one], at)
    meet = (shapely.area(common) > BESIDE * size**2) & (np.abs(gap) > BESIDE * size)
    one, other, gap = one[meet], other[meet], gap[meet]
    return np.where(gap > 0.0, one, other), np.where(gap > 0.0, other, one)


def plane_heights(corners: FloatArray, at: FloatArray) -> FloatArray:
    """Return the third coordinate [k] of the planes of triangles [k, 3, 3] at points [k, 2]."""
    normal = normals(corners)
    away = np.einsum("ki,ki->k", normal[:, :2], at - corners[:, 0, :2])
    return np.asarray(corners[:, 0, 2] - away / normal[:, 2], dtype=np.float64)
