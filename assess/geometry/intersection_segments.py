"""The segments along which the surfaces of two shells intersect at an angle."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import shapely

from assess.geometry.surface import areas_and_normals
from spectra.arrays import FloatArray, IntArray

OVERLAP = 1e-6  # of the body's size: shells that enter one another by less are taken to touch
MAX_SEGMENTS = 20_000  # longest lines where two shells meet that are looked at for overlap

_TURNS = np.linspace(0.0, 2.0 * np.pi, 17)[:-1] + np.pi / 16.0
_AROUND = np.column_stack([np.cos(_TURNS), np.sin(_TURNS)])  # directions around a seam [16, 2]


def points_beside_intersections(parts: list[FloatArray], boxes: FloatArray, *, size: float) -> FloatArray:
    """Return points [k, 3] that would reveal an overlap of shells.

    Where two volumes overlap and neither contains the other, the border of the common part passes from one surface to
    the other along segments where two triangles meet at an angle. The points lie around the middle of each segment,
    longest segments first. Shells that only touch have such segments too, but no common point beside them.

    Parameters
    ----------
    parts : corners of the triangles of each shell [m, 3, 3]
    boxes : bounding box of each shell [n, 2, 3]
    size : of the body [m]
    """
    reach = OVERLAP * size
    found = [
        _intersection_segments(parts[i], parts[j], shortest=reach) for i, j in _overlapping_boxes(boxes, margin=reach)
    ]
    if not found:
        return np.empty((0, 3))
    middle, frame, length = (np.concatenate(each) for each in zip(*found, strict=True))
    longest = np.argsort(-length, kind="stable")[:MAX_SEGMENTS]
    around = np.einsum("di,sij->sdj", _AROUND, frame[longest]) * (2.0 * reach)
    return np.asarray((middle[longest, None] + around).reshape(-1, 3), dtype=np.float64)


def _overlapping_boxes(boxes: FloatArray, *, margin: float) -> Iterator[tuple[int, int]]:
    """Yield pairs of boxes [n, 2, 3] that overlap by more than the margin."""
    for i in range(len(boxes) - 1):
        low = np.maximum(boxes[i, 0], boxes[i + 1 :, 0])
        high = np.minimum(boxes[i, 1], boxes[i + 1 :, 1])
        for j in np.flatnonzero(np.all(high - low > margin, axis=1)):
            yield i, i + 1 + int(j)


def _intersection_segments(
    one: FloatArray, other: FloatArray, *, shortest: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Intersect two shells: middle [s, 3], two unit vectors across [s, 2, 3], length [s] of each segment."""
    i, j = _candidate_pairs(one, other)
    A, B = one[i], other[j]
    n, m = areas_and_normals(A)[1], areas_and_normals(B)[1]
    D = np.cross(n, m)
    sine = np.linalg.norm(D, axis=1)
    angled = sine > OVERLAP
    A, B, n, m, D = A[angled], B[angled], n[angled], m[angled], D[angled] / sine[angled, None]
    origin = A[:, 0]
    along = np.cross(n, D)  # in the plane of A, square to the common line
    reach = np.einsum("si,si->s", B[:, 0] - origin, m) / np.einsum("si,si->s", along, m)
    line = origin + reach[:, None] * along
    low_a, high_a = _clip_lines(line, D, A, n)
    low_b, high_b = _clip_lines(line, D, B, m)
    low, high = np.maximum(low_a, low_b), np.minimum(high_a, high_b)
    meet = high > low + shortest  # infinite where a line is beside a triangle
    frame = np.stack([n, np.cross(D, n)], axis=1)
    low, high = low[meet], high[meet]
    return line[meet] + ((low + high) / 2.0)[:, None] * D[meet], frame[meet], high - low


def _candidate_pairs(one: FloatArray, other: FloatArray) -> tuple[IntArray, IntArray]:
    """Return index pairs of triangles [m, 3, 3], [k, 3, 3] whose bounding boxes meet."""
    low_a, high_a = one.min(axis=1), one.max(axis=1)
    low_b, high_b = other.min(axis=1), other.max(axis=1)
    in_a = np.flatnonzero(np.all((high_a >= low_b.min(axis=0)) & (low_a <= high_b.max(axis=0)), axis=1))
    in_b = np.flatnonzero(np.all((high_b >= low_a.min(axis=0)) & (low_b <= high_a.max(axis=0)), axis=1))
    tree = shapely.STRtree(shapely.box(low_a[in_a, 0], low_a[in_a, 2], high_a[in_a, 0], high_a[in_a, 2]))
    b, a = tree.query(shapely.box(low_b[in_b, 0], low_b[in_b, 2], high_b[in_b, 0], high_b[in_b, 2]))
    i, j = in_a[a], in_b[b]
    meet = (high_a[i, 1] >= low_b[j, 1]) & (low_a[i, 1] <= high_b[j, 1])
    return i[meet], j[meet]


def _clip_lines(
    line: FloatArray, along: FloatArray, triangles: FloatArray, normals: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return the first and last parameter [s] of lines (point and unit vector [s, 3]) in their triangles."""
    low, high = np.full(len(line), -np.inf), np.full(len(line), np.inf)
    for k in range(3):
        corner, side = triangles[:, k], triangles[:, (k + 1) % 3] - triangles[:, k]
        inwards = np.cross(normals, side)
        inwards /= np.linalg.norm(inwards, axis=1, keepdims=True)
        rate = np.einsum("si,si->s", inwards, along)
        offset = np.einsum("si,si->s", inwards, line - corner)
        parallel = np.abs(rate) < 1e-12
        crossing = -offset / np.where(parallel, 1.0, rate)
        low = np.where(~parallel & (rate > 0.0), np.maximum(low, crossing), low)
        high = np.where(~parallel & (rate < 0.0), np.minimum(high, crossing), high)
        reach = np.abs(side).max(axis=1)
        high = np.where(parallel & (offset < -1e-9 * reach), -np.inf, high)
    return low, high
