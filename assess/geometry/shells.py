"""The closed shells of a surface, where they overlap or intersect themselves, and the one volume that they represent.

Shells beside one another and cavities (inner shells that face inwards) are fine. A shell that cuts another or lies
inside the material of another counts the common volume twice: two overlapping closed boxes are a closed surface too.
Whether a point is enclosed twice is found by casting rays in a direction in which masonry has no edges.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray

from assess.errors import GeometryError
from assess.geometry.boolean import unite
from assess.geometry.solid import THINNEST
from assess.geometry.surface import (
    Edges,
    Surface,
    area_vectors,
    areas_and_normals,
    connected_groups,
    connected_groups_across,
    coordinate_values,
    find_edges,
    merge_vertices,
    neighbours,
    point_text,
    volume,
    volume_change,
)
from assess.messages.message import Message, Quantity, note, whole_number
from spectra.arrays import FloatArray, IntArray

SAMPLES = 64  # triangles of a shell beside which the others are looked up


def unify_shells(
    surface: Surface, across: NDArray[np.int32] | None = None, *, where: str
) -> tuple[Surface, tuple[Message, ...]]:
    """Return a closed surface that counts its material once, and what was done; a good one is returned unchanged.

    A shell without volume is dropped. A shell that faces inwards is a cavity where it lies in material, else it is
    reversed. Shells that overlap, or lie inside the material of another, are united.

    Parameters
    ----------
    surface : closed
    across : its `adjacent_triangles`, where they are known
    where : named in errors

    Raises
    ------
    GeometryError : shells cannot be united
    """
    done: tuple[Message, ...] = ()
    if volume(*surface) < -THINNEST * float(np.prod(np.ptp(surface[0], axis=0))):  # two shells may be opposite
        surface, done = (
            (surface[0], surface[1][:, ::-1]),
            (note("body-reversed"),),
        )
    shells = separate_shells(surface, across)
    if len(shells) == 1:
        return surface, done
    number = len(shells)
    for step in (_drop_flat, _reverse_inverted, _unite_overlapping):
        shells, more = step(shells, where=where)
        done = (*done, *more)
    counted = (note("many-shells", number=whole_number(number)),) if number > MANY_SHELLS else ()
    return (_join_shells(shells) if done else surface), (*done, *counted)


def separate_shells(surface: Surface, across: NDArray[np.int32] | None = None) -> list[Surface]:
    """Separate the closed shells of a closed surface.

    Triangles that alone share an edge share a shell. At an edge of more triangles those shells stay together that are
    not closed there by themselves: boxes that touch along an edge are two.

    Parameters
    ----------
    surface : closed
    across : its `adjacent_triangles`, where they are known
    """
    vertices, triangles = surface
    group = connected_groups_across(across) if across is not None else _group_by_edges(triangles)
    if group.max() == 0:
        return [surface]
    ends = np.cumsum(np.bincount(group))[:-1]
    return [(vertices, part) for part in np.split(triangles[np.argsort(group, kind="stable")], ends)]


RAYS = 48  # across the body, each way
RAY_OFFSET = np.array([0.5317, 0.4619])  # place of a line in its cell
MANY_SHELLS = 20  # closed shells of one body: more are likely those of a building
LARGEST_SELF_OVERLAP = 0.01  # of the volume: more than this counted wrongly is refused
NEGLIGIBLE_SELF_OVERLAP = 1e-6  # of the volume: less than this counted wrongly gets no warning
SHORTEST_STRETCH = 1e-6  # of the body's size: shorter stretches are rounding where shells touch


@dataclass(frozen=True)
class SelfOverlap:
    """The part of a surface's volume that is counted wrongly, found by casting rays.

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
    if found.place is None or found.share < NEGLIGIBLE_SELF_OVERLAP:
        return ()
    percent = 100.0 * found.share
    if found.share > LARGEST_SELF_OVERLAP:
        raise GeometryError(
            f"{where}: its surface intersects itself near {point_text(found.place)} m, so that about {percent:.2g} % "
            "of its volume counts twice or not at all; repair it where it was made, or split it into bodies"
        )
    return (note("self-overlap", share=Quantity(percent, "percent", 2), **coordinate_values(found.place)),)


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
    surplus = np.where(length > SHORTEST_STRETCH * np.ptp(flat), np.abs(inside - np.clip(inside, 0, 1)), 0) * length
    if not surplus.any():
        return SelfOverlap(0.0, None)
    longest = int(np.argmax(surplus))
    point = at[longest : longest + 2].mean(axis=0) @ np.linalg.inv(SHEAR) + middle
    return SelfOverlap(float(surplus.sum() / length[inside > 0].sum()), point)


def _group_by_edges(triangles: IntArray) -> IntArray:
    """Return the shell [m] of each triangle of any closed surface."""
    edges = find_edges(triangles)
    group = connected_groups(neighbours(edges)[0], count=len(triangles))
    return group if edges.plain else _rejoin(group, edges)


def _rejoin(group: IntArray, edges: Edges) -> IntArray:
    """Join groups of triangles in pairs at edges of more than two where they are not closed by themselves.

    Groups are paired in their order in the file, where parts stand one after another.
    """
    many = np.repeat(edges.count > 2, edges.count)
    edge = edges.order[many]
    at = np.repeat(np.arange(len(edges.count)), edges.count)[many]
    way = np.where(edges.directed[edge, 0] < edges.directed[edge, 1], 1, -1)
    pairs, index = np.unique(np.column_stack([at, group[edge // 3]]), axis=0, return_inverse=True)
    excess = np.bincount(index.ravel(), weights=way, minlength=len(pairs)).astype(np.int64)
    ups, downs = (np.repeat(pairs[:, 1], (sign * excess).clip(0)) for sign in (1, -1))
    return connected_groups(np.column_stack([ups, downs]), count=int(group.max()) + 1)[group]


def _drop_flat(shells: list[Surface], *, where: str) -> tuple[list[Surface], tuple[Message, ...]]:
    """Drop shells that enclose nothing; keep all where none encloses anything."""
    good = [shell for shell in shells if not _is_flat(shell)]
    if len(good) in (0, len(shells)):
        return shells, ()
    return good, (note("flat-shells-removed", number=whole_number(len(shells) - len(good))),)


def _is_flat(shell: Surface) -> bool:
    corners = shell[0][shell[1]]
    return abs(volume(*shell)) <= THINNEST * float(np.ptp(corners, axis=(0, 1)).max()) ** 3


def _reverse_inverted(shells: list[Surface], *, where: str) -> tuple[list[Surface], tuple[Message, ...]]:
    """Reverse the shells that face inwards but lie in no material."""
    solid = [shell for shell in shells if volume(*shell) > 0.0]
    parts, boxes = _corners_and_boxes(solid)
    inverted = [
        k for k, shell in enumerate(shells) if volume(*shell) < 0.0 and not _lies_in_material(shell, parts, boxes)
    ]
    if not inverted:
        return shells, ()
    centre = shells[inverted[0]][0][shells[inverted[0]][1]].mean(axis=(0, 1))
    after = sum(abs(volume(*shell)) if k in inverted else volume(*shell) for k, shell in enumerate(shells))
    change = volume_change(sum(volume(*shell) for shell in shells), after)
    done = note("shells-reversed", number=whole_number(len(inverted)), change=change, **coordinate_values(centre))
    return [(v, t[:, ::-1]) if k in inverted else (v, t) for k, (v, t) in enumerate(shells)], (done,)


def _lies_in_material(shell: Surface, parts: list[FloatArray], boxes: FloatArray) -> bool:
    """Return whether most of what an inward shell encloses near its faces lies inside others."""
    vertices, triangles = shell
    corners = vertices[triangles[:: max(1, len(triangles) // SAMPLES)]]
    normals = area_vectors(corners)
    depth = OVERLAP * float(np.ptp(vertices[triangles], axis=(0, 1)).max())
    inside = corners.mean(axis=1) + depth * normals / np.linalg.norm(normals, axis=1, keepdims=True).clip(1e-300)
    return bool(np.mean(_winding_numbers(inside, parts, boxes) > 0) > 0.5)


def _unite_overlapping(shells: list[Surface], *, where: str) -> tuple[list[Surface], tuple[Message, ...]]:
    """Unite the shells where the material of some would count twice."""
    at = _find_overlap(shells)
    if at is None:
        return shells, ()
    whole = unite(shells, where=where)
    before = sum(volume(*shell) for shell in shells)
    change = volume_change(before, volume(*whole))
    done = note("shells-united", number=whole_number(len(shells)), change=change, **coordinate_values(at))
    return [whole], (done,)


def _find_overlap(shells: list[Surface]) -> FloatArray | None:
    """Find a point [3] that the shells together enclose twice, or less than never; None where there is none.

    Shells that overlap by less than `OVERLAP` of the body's size are in contact only.
    """
    parts, boxes = _corners_and_boxes(shells)
    size = float(np.ptp(boxes, axis=(0, 1)).max())
    behind = np.array([_point_behind(part, depth=OVERLAP * size) for part in parts])
    hidden = _winding_numbers(behind, parts, boxes) != 1
    if hidden.any():
        return np.asarray(behind[hidden][0], dtype=np.float64)
    beside = _points_beside_intersections(parts, boxes, size=size)
    found = _winding_numbers(beside, parts, boxes)
    wrong = (found < 0) | (found > 1)
    return np.asarray(beside[wrong][0], dtype=np.float64) if wrong.any() else None


def _point_behind(part: FloatArray, *, depth: float) -> FloatArray:
    """Return the point [3] at a depth [m] behind the middle of the largest triangle of a shell [m, 3, 3]."""
    normals = area_vectors(part)
    area = np.linalg.norm(normals, axis=1)
    largest = int(np.argmax(area))
    return np.asarray(part[largest].mean(axis=0) - depth * normals[largest] / area[largest], dtype=np.float64)


def _corners_and_boxes(shells: list[Surface]) -> tuple[list[FloatArray], FloatArray]:
    """Return the corners of the triangles of each shell [m, 3, 3], and their boxes [n, 2, 3]."""
    parts = [vertices[triangles] for vertices, triangles in shells]
    boxes = [[part.min(axis=(0, 1)), part.max(axis=(0, 1))] for part in parts]
    return parts, np.array(boxes).reshape(-1, 2, 3)


def _join_shells(shells: list[Surface]) -> Surface:
    """Join the shells into one surface; all have the same vertices."""
    return merge_vertices(shells[0][0], np.concatenate([triangles for _, triangles in shells]))


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
    scaled = (flat[:, :2] - corner) / pitch - RAY_OFFSET
    low = _extreme(np.ceil(scaled), triangles, np.minimum).clip(0)
    high = _extreme(np.floor(scaled), triangles, np.maximum).clip(None, RAYS - 1)
    some = np.flatnonzero((high[0] >= low[0]) & (high[1] >= low[1]))
    low, wide = low[:, some].astype(np.int64), (high - low + 1)[:, some].astype(np.int64)
    count = wide[0] * wide[1]
    each = np.repeat(np.arange(len(some)), count)
    k = np.arange(len(each)) - np.repeat(np.cumsum(count) - count, count)
    face, (i, j), width = some[each], low[:, each], wide[1, each]
    cell = np.column_stack([i + k // width, j + k % width])
    return cell[:, 0] * RAYS + cell[:, 1], face, corner + (cell + RAY_OFFSET) * pitch


def _extreme(cells: FloatArray, triangles: IntArray, of: np.ufunc) -> NDArray[np.int16]:
    """Return the least or the largest cell of the three corners of each triangle, each way [2, m]."""
    corners = [triangles[:, i] for i in range(3)]
    axes = [axis.astype(np.int16) for axis in cells.T]  # -1 to RAYS
    return np.stack([of(of(*(axis[at] for at in corners[:2])), axis[corners[2]]) for axis in axes])


OVERLAP = 1e-6  # of the body's size: shells that enter one another by less are taken to touch
MAX_SEGMENTS = 20_000  # segments examined for overlap, the longest first
_TURNS = np.linspace(0.0, 2.0 * np.pi, 17)[:-1] + np.pi / 16.0
_AROUND = np.column_stack([np.cos(_TURNS), np.sin(_TURNS)])  # directions around a seam [16, 2]


def _points_beside_intersections(parts: list[FloatArray], boxes: FloatArray, *, size: float) -> FloatArray:
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


SHEAR = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-0.21372, -0.13187, 1.0]])
"""Sets upright a direction in which masonry has no edges: rays along it meet faces, not their borders."""


def _winding_numbers(points: FloatArray, parts: list[FloatArray], boxes: FloatArray) -> IntArray:
    """Return how often all shells together enclose each point.

    Parameters
    ----------
    points : [k, 3] [m]
    parts : corners of the triangles of each shell [m, 3, 3] [m]
    boxes : bounding box of each shell [n, 2, 3] [m]

    Returns
    -------
    1 in material, 0 elsewhere [k]
    """
    found = np.zeros(len(points), dtype=np.int64)
    for part, (low, high) in zip(parts, boxes, strict=True):
        near = np.flatnonzero(np.all((low <= points) & (points <= high), axis=1))
        if len(near):
            found[near] += _winding_of_shell(points[near], part)
    return found


def _winding_of_shell(points: FloatArray, triangles: FloatArray) -> IntArray:
    """Return the winding number [k] of a closed shell [m, 3, 3] around points [k, 3], by casting rays."""
    flat, at = triangles @ SHEAR, points @ SHEAR
    low, high = flat.min(axis=1), flat.max(axis=1)
    tree = shapely.STRtree(shapely.box(low[:, 0], low[:, 1], high[:, 0], high[:, 1]))
    point, face = tree.query(shapely.points(at[:, :2]))
    a, b, c = (flat[face, i] - at[point] for i in range(3))
    sides = np.stack([u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0] for u, v in ((b, c), (c, a), (a, b))])
    doubled_area = sides.sum(axis=0)
    height = sides[0] * a[:, 2] + sides[1] * b[:, 2] + sides[2] * c[:, 2]  # of the face over the point, times its area
    meets = (np.abs(np.sign(sides).sum(axis=0)) == 3.0) & (height * doubled_area > 0.0)
    crossings = np.bincount(point[meets], weights=np.sign(doubled_area[meets]), minlength=len(points))
    return np.asarray(crossings.astype(np.int64))
