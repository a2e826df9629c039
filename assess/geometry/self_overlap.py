"""Self-overlap of a surface that intersects itself: where parallel rays find space enclosed twice or negatively."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from assess.errors import GeometryError
from assess.geometry.surface import Surface, place_values, point_text
from assess.geometry.winding_number import SHEAR
from assess.messages.message import Message, Quantity, note
from spectra.arrays import FloatArray, IntArray

RAYS = 48  # across the body, each way
OFFSET = np.array([0.5317, 0.4619])  # place of a line in its cell
LARGEST = 0.01  # of the volume: more than this counted wrongly is refused
NEGLIGIBLE = 1e-6  # of the volume: less than this counted wrongly gets no warning
SHORTEST = 1e-6  # of the body's size: shorter stretches are rounding where shells touch


@dataclass(frozen=True)
class SelfOverlap:
    """The part of a surface's volume that is counted wrongly, found by casting rays.

    Attributes
    ----------
    share : length counted wrongly, times how often too many, over the length in material [-]
    place : the middle of the longest segment counted wrongly [3] [m]; None where there is none
    """

    share: float
    place: FloatArray | None


def self_overlap_warnings(surface: Surface, *, where: str) -> tuple[Message, ...]:
    """Warn where a closed surface intersects itself a little; which side is meant cannot be known.

    Raises
    ------
    GeometryError : more than a hundredth of its volume is counted wrongly
    """
    found = measure_self_overlap(surface)
    if found.place is None or found.share < NEGLIGIBLE:
        return ()
    percent = 100.0 * found.share
    if found.share > LARGEST:
        raise GeometryError(
            f"{where}: its surface intersects itself near {point_text(found.place)} m, so that about {percent:.2g} % "
            "of its volume counts twice or not at all; repair it where it was made, or split it into bodies"
        )
    return (note("self-overlap", share=Quantity(percent, "percent", 2), **place_values(found.place)),)


def measure_self_overlap(surface: Surface) -> SelfOverlap:
    """Measure the space that a closed surface encloses more than once or negatively, on rays 1/48 of its width apart.

    A region smaller than the spacing of the rays may be missed; it changes no result.
    """
    vertices, triangles = surface
    middle = (vertices.min(axis=0) + vertices.max(axis=0)) / 2.0
    x, y, z = (vertices - middle).T
    flat = np.stack([x + SHEAR[2, 0] * z, y + SHEAR[2, 1] * z, z]).T  # by SHEAR: products of many rows are slow
    line, at, step = _ray_crossings(flat, triangles)
    whole = np.bincount(line, weights=step, minlength=RAYS**2)[line] == 0.0  # else a line ran through an edge
    order = np.flatnonzero(whole)[np.lexsort((at[whole, 2], line[whole]))]
    at, inside = at[order], np.cumsum(step[order])[:-1]
    length = np.where(np.diff(line[order]) == 0, np.diff(at[:, 2]), 0.0)
    surplus = np.where(length > SHORTEST * np.ptp(flat), np.abs(inside - np.clip(inside, 0, 1)), 0) * length
    if not surplus.any():
        return SelfOverlap(0.0, None)
    longest = int(np.argmax(surplus))
    point = at[longest : longest + 2].mean(axis=0) @ np.linalg.inv(SHEAR) + middle
    return SelfOverlap(float(surplus.sum() / length[inside > 0].sum()), point)


def _ray_crossings(flat: FloatArray, triangles: IntArray) -> tuple[IntArray, FloatArray, IntArray]:
    """Intersect upright rays with triangles: ray [c], point [c, 3], +1 upwards into material, else -1."""
    line, face, at = _rays_over(flat, triangles)
    a, b, c = (flat[triangles[face, i]] for i in range(3))
    sides = np.stack(
        [
            (u[:, 0] - at[:, 0]) * (v[:, 1] - at[:, 1]) - (u[:, 1] - at[:, 1]) * (v[:, 0] - at[:, 0])
            for u, v in ((b, c), (c, a), (a, b))
        ]
    )
    meets = np.abs(np.sign(sides).sum(axis=0)) == 3.0
    weight = sides[:, meets] / sides[:, meets].sum(axis=0)
    height = weight[0] * a[meets, 2] + weight[1] * b[meets, 2] + weight[2] * c[meets, 2]
    step = -np.sign(sides[0, meets]).astype(np.int64)
    return line[meets], np.column_stack([at[meets], height]), step


def _rays_over(flat: FloatArray, triangles: IntArray) -> tuple[IntArray, IntArray, FloatArray]:
    """Return the rays through the box of each triangle: number of the ray [c], of the triangle [c], position [c, 2].

    The rays form a square pattern, off the middle of its cells, where bodies have no edges.
    """
    corner, pitch = flat[:, :2].min(axis=0), np.ptp(flat[:, :2], axis=0) / RAYS
    scaled = (flat[:, :2] - corner) / pitch - OFFSET
    low = _extreme(np.ceil(scaled), triangles, np.minimum).clip(0)
    high = _extreme(np.floor(scaled), triangles, np.maximum).clip(None, RAYS - 1)
    some = np.flatnonzero((high[0] >= low[0]) & (high[1] >= low[1]))
    low, wide = low[:, some].astype(np.int64), (high - low + 1)[:, some].astype(np.int64)
    count = wide[0] * wide[1]
    each = np.repeat(np.arange(len(some)), count)
    k = np.arange(len(each)) - np.repeat(np.cumsum(count) - count, count)
    face, (i, j), width = some[each], low[:, each], wide[1, each]
    cell = np.column_stack([i + k // width, j + k % width])
    return cell[:, 0] * RAYS + cell[:, 1], face, corner + (cell + OFFSET) * pitch


def _extreme(cells: FloatArray, triangles: IntArray, of: np.ufunc) -> NDArray[np.int16]:
    """Return the least or the largest cell of the three corners of each triangle, each way [2, m]."""
    corners = [triangles[:, i] for i in range(3)]
    ways = [way.astype(np.int16) for way in cells.T]  # -1 to LINES
    return np.stack([of(of(*(way[at] for at in corners[:2])), way[corners[2]]) for way in ways])
