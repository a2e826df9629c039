"""The closed surface of a body: along every edge as many triangles run one way as the other.

The volume integrals then hold, provided no part of space is enclosed twice (`shells`).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from assess.messages.message import Quantity, Value, lengths
from spectra.arrays import BoolArray, FloatArray, IntArray

HASH_WEIGHTS = (1.6180339887, 2.7182818284)  # weights that keep different points apart
HASH_FACTOR = np.uint64(0x9E3779B97F4A7C15)  # 2^64 / golden ratio: times it, a number's lower bits reach its upper ones
BATCH = 1 << 13  # triangles: what is computed of them then stays in the processor's cache
Surface = tuple[FloatArray, IntArray]  # vertices [n, 3] [m], triangles as indices into them [m, 3]


@dataclass(frozen=True)
class Edges:
    """The edges of a surface of m triangles, grouped by place: those between the same two vertices, either way.

    directed : from vertex, to vertex, as the triangles have them: edge i belongs to triangle i // 3 [3 m, 2]
    order : edges sorted by place [3 m]
    first : where in `order` each of the k places begins [k]
    count : edges at each place [k]
    balance : those that run to the higher vertex less those that run to the lower [k]
    """

    directed: IntArray
    order: IntArray
    first: IntArray
    count: IntArray
    balance: IntArray

    @property
    def closed(self) -> bool:
        """Whether the surface is closed."""
        return not self.balance.any()

    @property
    def plain(self) -> bool:
        """Whether it is closed and every edge belongs to exactly two triangles."""
        return self.closed and not (self.count != 2).any()


def merge_vertices(vertices: FloatArray, triangles: IntArray) -> Surface:
    """Merge vertices of equal position, and drop unused vertices and degenerate triangles.

    Positions are equal when their coordinates are; nothing is moved. They are numbered by z, then y, then x.

    Parameters
    ----------
    vertices : [n, 3] [m]
    triangles : indices into vertices [m, 3]
    """
    used = np.zeros(len(vertices), dtype=np.bool_)
    used[triangles] = True
    if not used.all():
        vertices, triangles = vertices[used], (np.cumsum(used) - 1)[triangles]
    columns = [np.ascontiguousarray(vertices[:, axis]) for axis in range(3)]
    first, group = _group_equal(columns)
    kept = [values[first] + 0.0 for values in columns]  # -0.0 becomes 0.0
    by_place = _order_points(kept)
    rank = np.empty(len(first), dtype=np.int64)
    rank[by_place] = np.arange(len(first))
    return np.stack([values[by_place] for values in kept]).T, drop_degenerate(rank[group[triangles]])


def differs_from_previous(values: NDArray[np.generic]) -> BoolArray:
    """Return which values [n] differ from the one before; the first does."""
    new = np.ones(len(values), dtype=np.bool_)
    np.not_equal(values[1:], values[:-1], out=new[1:])
    return new


def drop_degenerate(triangles: IntArray) -> IntArray:
    """Return the triangles that use three different vertices."""
    a, b, c = triangles.T
    real = (a != b) & (b != c) & (c != a)
    return triangles if real.all() else np.asarray(triangles[real], dtype=np.int64)


def adjacent_triangles(triangles: IntArray) -> NDArray[np.int32] | None:
    """Return the triangle across each edge [m, 3] of a surface whose edges all belong to two opposite triangles.

    None for any other surface. Edges are sorted by a number that packs lower vertex, higher vertex, sense and edge.
    """
    start, end = triangles.ravel(), triangles[:, [1, 2, 0]].ravel()
    count = int(triangles.max()) + 1
    key = np.minimum(start, end)
    key *= count
    key += np.maximum(start, end)
    key *= 2
    key += start < end
    edge, order = _sort_packed(key, bits=2 * count.bit_length() + 1)
    down, up = edge[:-1:2], edge[1::2]
    if len(key) % 2 or (down & 1).any() or (up - down != 1).any() or (down[1:] == down[:-1]).any():
        return None
    triangle = (order // 3).astype(np.int32)
    across = np.empty(len(key), dtype=np.int32)
    across[order[::2]], across[order[1::2]] = triangle[1::2], triangle[::2]
    return across.reshape(-1, 3)


def find_edges(triangles: IntArray) -> Edges:
    """Return the edges of at least one triangle."""
    directed = triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    start, end = directed.T
    key = np.minimum(start, end) * (triangles.max() + 1) + np.maximum(start, end)
    order = np.argsort(key, kind="stable")
    first = np.flatnonzero(differs_from_previous(key[order]))
    count = np.diff(np.append(first, len(order)))
    way = np.where(start < end, 1, -1)
    return Edges(directed, order, first, count, np.add.reduceat(way[order], first))


def open_edges(edges: Edges) -> IntArray:
    """Return the directed edges [b, 2] that belong to one triangle only."""
    return np.asarray(edges.directed[edges.order[edges.first[edges.count == 1]]], dtype=np.int64)


def neighbours(edges: Edges) -> tuple[IntArray, BoolArray]:
    """Return pairs of triangles [e, 2] that alone share an edge, and whether they run along it oppositely [e]."""
    two = edges.count == 2
    first = edges.first[two]
    pairs = np.column_stack([edges.order[first], edges.order[first + 1]]) // 3
    return pairs, edges.balance[two] == 0


def connected_groups(pairs: IntArray, *, count: int) -> IntArray:
    """Return the connected group of each of `count` items when pairs of them are linked.

    Parameters
    ----------
    pairs : of linked items [e, 2]
    count : number of items

    Returns
    -------
    number of the group, from 0 [count]
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    links = coo_array((np.ones(len(pairs), dtype=np.int8), (pairs[:, 0], pairs[:, 1])), shape=(count, count))
    return np.asarray(connected_components(links, directed=False)[1], dtype=np.int64)


def connected_groups_across(across: NDArray[np.int32]) -> IntArray:
    """Return the connected group [m] of each triangle, from 0, by their neighbours [m, 3]."""
    m = len(across)
    starts = np.arange(0, 3 * m + 1, 3, dtype=np.int32)
    from scipy.sparse import csr_array
    from scipy.sparse.csgraph import connected_components

    links = csr_array((np.ones(3 * m), across.ravel(), starts), shape=(m, m))
    return np.asarray(connected_components(links, directed=False)[1], dtype=np.int64)


def volume(vertices: FloatArray, triangles: IntArray) -> float:
    """Return the signed volume inside a surface [m3]; an open one is closed by cones to the middle of its box.

    Parameters
    ----------
    vertices : [n, 3] [m]
    triangles : numbers of their vertices [m, 3]
    """
    middle = _middle(vertices, triangles)
    return sum((float(D.sum()) for _, D in tetrahedra(vertices, triangles, middle)), start=0.0) / 6.0


def tetrahedra(
    vertices: FloatArray, triangles: IntArray, origin: FloatArray
) -> Iterator[tuple[FloatArray, FloatArray]]:
    """Yield the tetrahedra from a point to each triangle, some at a time.

    Parameters
    ----------
    vertices : [n, 3] [m]
    triangles : indices into vertices [m, 3]
    origin : the point [3] [m]

    Yields
    ------
    corners : seen from the point: axis, corner, triangle [3, 3, k] [m]
    D : a . (b x c), six times the signed volume [k] [m3]
    """
    for start in range(0, len(triangles), BATCH):
        at = triangles[start : start + BATCH].T
        x, y, z = corners = np.stack([vertices[:, axis][at] - origin[axis] for axis in range(3)])
        turn = (y[1] * z[2] - z[1] * y[2], z[1] * x[2] - x[1] * z[2], x[1] * y[2] - y[1] * x[2])
        yield corners, x[0] * turn[0] + y[0] * turn[1] + z[0] * turn[2]


def area(vertices: FloatArray, triangles: IntArray) -> float:
    """Return the area of the triangles [m2].

    Parameters
    ----------
    vertices : [n, 3] [m]
    triangles : numbers of their vertices [m, 3]
    """
    return total_area(area_vectors(vertices[triangles]))


def total_area(vectors: FloatArray) -> float:
    """Return the area of triangles [m2] by their `area_vectors` [m, 3]."""
    return float((np.linalg.norm(vectors, axis=1) / 2.0).sum())


def area_vectors(corners: FloatArray) -> FloatArray:
    """Return outward normals [m, 3] of triangles [m, 3, 3], each as long as twice its area [m2].

    By columns this takes a tenth of the time of `np.cross`, for the same numbers.
    """
    return cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])


def cross(one: FloatArray, other: FloatArray) -> FloatArray:
    """Return the cross products of vectors [m, 3] and [m, 3]."""
    (ax, ay, az), (bx, by, bz) = one.T, other.T
    found = np.empty((len(one), 3))
    found[:, 0], found[:, 1], found[:, 2] = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
    return found


def areas_and_normals(corners: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return area [m] [m2] and unit normal [m, 3] of triangles [m, 3, 3]; zero without area."""
    normals = area_vectors(corners)
    length = np.linalg.norm(normals, axis=1)
    return length / 2.0, normals / np.where(length > 0.0, length, 1.0)[:, None]


def point_text(point: FloatArray) -> str:
    """Write a point for a sentence, to a tenth of a millimetre: (x, y, z)."""
    return "(" + ", ".join(f"{round(float(value), 4) + 0.0:.12g}" for value in point) + ")"


def coordinate_values(point: FloatArray) -> dict[str, Value]:
    """Return the coordinates of a point [3] [m] as values x, y, z of a message."""
    x, y, z = point
    return lengths(x=x, y=y, z=z)


def volume_change(before: float, after: float) -> Quantity:
    """Return by how much a repair changed the volume [m3], as a share of the new volume [%]."""
    return Quantity(100.0 * (after - before) / after if after else -100.0, "percent", 3)


COARSER = 1.15  # each grid that still leaves too many triangles is followed by one this much coarser
SHARP = 0.05  # of a cell's largest curvature: flatter directions do not move its vertex


def simplify(vertices: FloatArray, triangles: IntArray, *, limit: int) -> tuple[FloatArray, IntArray]:
    """Reduce a surface to at most `limit` triangles; one that has no more is returned unchanged.

    Each cell's vertex lies where the squared distance to the planes of its triangles is least, so that faces stay
    flat and edges sharp. The result is for the eye: thin parts may close, and its volume differs.

    Parameters
    ----------
    vertices, triangles : of the surface [n, 3] [m], indices [m, 3]
    limit : four or more
    """
    size = float(np.ptp(vertices, axis=0).max())
    cell = size * np.sqrt(2.0 / limit)  # about as many cells on a cube's face as there may be triangles
    if len(triangles) <= limit:
        return vertices, triangles
    group, faces = _cluster_vertices(vertices, triangles, cell=cell)
    while len(faces) > limit:
        cell *= COARSER
        group, faces = _cluster_vertices(vertices, triangles, cell=cell)
    used, index = np.unique(faces, return_inverse=True)
    return _cluster_points(vertices, triangles, group, cell=cell)[used], index.reshape(-1, 3)


def _group_equal(columns: list[FloatArray]) -> tuple[IntArray, IntArray]:
    """Group equal points x, y, z [n]: the first of each group [k], and the group of every point [n].

    Points are grouped by one number hashed from the three. Those that share it with a different point are grouped again
    among themselves.
    """
    first, group = _group_by_hash(columns)
    kept = [values[first] for values in columns]
    (x, y, z), (u, v, w) = columns, (values[group] for values in kept)
    other = np.flatnonzero((x != u) | (y != v) | (z != w))
    if not len(other):
        return first, group
    second, again = _group_equal([values[other] for values in columns])
    group[other] = len(first) + again
    return np.concatenate([first, other[second]]), group


def _group_by_hash(columns: list[FloatArray]) -> tuple[IntArray, IntArray]:
    """Group points by hash: their numbers are packed into its lower bits, and all are sorted."""
    x, y, z = columns
    bits = np.uint64(len(x).bit_length())
    lower = (np.uint64(1) << bits) - np.uint64(1)
    key = (y * HASH_WEIGHTS[0] + x + z * HASH_WEIGHTS[1] + 0.0).view(np.uint64)
    key *= HASH_FACTOR
    key &= ~lower
    key |= np.arange(len(x), dtype=np.uint64)
    key.sort()
    order = (key & lower).astype(np.int64)
    new = differs_from_previous(key >> bits)
    group = np.empty(len(order), dtype=np.int64)
    group[order] = np.cumsum(new) - 1
    return order[new], group


def _order_points(columns: list[FloatArray]) -> IntArray:
    """Return the order [n] of distinct points x, y, z [n] by z, then y, then x, faster than lexsort."""
    x, y, z = columns
    upper = _ranks(_ranks(z) * len(z) + _ranks(y))
    return np.asarray(np.argsort(upper * len(x) + _ranks(x)), dtype=np.int64)


def _ranks(values: NDArray[np.float64] | IntArray) -> IntArray:
    """Return the rank [n] of each value among the distinct values, from 0."""
    order = np.argsort(values)
    rank = np.empty(len(order), dtype=np.int64)
    rank[order] = np.cumsum(differs_from_previous(values[order])) - 1
    return rank


def _sort_packed(key: IntArray, *, bits: int) -> tuple[IntArray, IntArray]:
    """Sort whole numbers [n] of so many bits with their indices packed in; return them and their order."""
    places = len(key).bit_length()
    if bits + places > 63:
        order = np.argsort(key)
        return key[order], order
    key = (key << places) | np.arange(len(key))
    key.sort()
    return key >> places, key & ((1 << places) - 1)


def _middle(vertices: FloatArray, triangles: IntArray) -> FloatArray:
    """Return the middle of the box around triangles [3] [m]; the origin where there are none."""
    if not len(triangles):
        return np.zeros(3)
    if len(vertices) > len(triangles):  # one shell of many
        values = vertices[triangles.ravel()]
    else:
        used = np.zeros(len(vertices), dtype=np.bool_)
        used[triangles] = True
        values = vertices if used.all() else vertices[used]
    return np.array([(each.min() + each.max()) / 2.0 for each in values.T])


def _cluster_vertices(vertices: FloatArray, triangles: IntArray, *, cell: float) -> tuple[IntArray, IntArray]:
    """Return the group of each vertex, one to an occupied cell of a grid of a width [m], and the faces of groups."""
    column = np.floor((vertices - vertices.min(axis=0)) / cell).astype(np.int64)
    across = column.max(axis=0) + 1
    _, group = np.unique((column[:, 0] * across[1] + column[:, 1]) * across[2] + column[:, 2], return_inverse=True)
    return group, _drop_duplicates(drop_degenerate(group[triangles]))


def _drop_duplicates(faces: IntArray) -> IntArray:
    """Keep each triangle [m, 3] once, without those back to back, as where a thin part has closed."""
    first = np.argmin(faces, axis=1)[:, None] if len(faces) else np.empty((0, 1), dtype=np.int64)
    turned = np.take_along_axis(faces, (first + np.arange(3)) % 3, axis=1)  # the least corner first
    alike, index = np.unique(np.sort(faces, axis=1), axis=0, return_inverse=True)
    weights = np.where(turned[:, 1] < turned[:, 2], 1.0, -1.0)
    sense = np.bincount(index.reshape(-1), weights=weights, minlength=len(alike))
    either = np.where(sense[:, None] > 0.0, alike, alike[:, ::-1])
    return np.asarray(either[sense != 0.0], dtype=np.int64)


def _cluster_points(vertices: FloatArray, triangles: IntArray, group: IntArray, *, cell: float) -> FloatArray:
    """Return the vertex of each group [k, 3]: nearest the planes of its triangles, within a cell of its mean."""
    count = np.bincount(group)
    mean = np.column_stack([np.bincount(group, weights=x) for x in vertices.T]) / count[:, None]
    corners = vertices[triangles]
    normal = area_vectors(corners)  # weighs by area squared
    A, b = np.zeros((len(count), 3, 3)), np.zeros((len(count), 3))
    for corner in range(3):
        owner = group[triangles[:, corner]]
        height = np.einsum("mi,mi->m", normal, corners[:, corner] - mean[owner])
        for i in range(3):
            b[:, i] += np.bincount(owner, weights=normal[:, i] * height, minlength=len(count))
            for j in range(i, 3):
                A[:, i, j] += np.bincount(owner, weights=normal[:, i] * normal[:, j], minlength=len(count))
    for i, j in ((1, 0), (2, 0), (2, 1)):
        A[:, i, j] = A[:, j, i]
    shift = np.einsum("kij,kj->ki", np.linalg.pinv(A, rcond=SHARP, hermitian=True), b)
    length = np.linalg.norm(shift, axis=1, keepdims=True)
    return np.asarray(mean + shift * np.minimum(1.0, cell / np.maximum(length, cell)), dtype=np.float64)


def parallel_sections(corners: FloatArray, *, normal: FloatArray, spacing: float) -> FloatArray:
    """Return the segments [k, 2, 3] in which parallel planes cut triangles, as they hatch a surface.

    Parameters
    ----------
    corners : of the triangles [m, 3, 3] [m]
    normal : of the planes [3]
    spacing : from one plane to the next, one of them through the origin [m]
    """
    height = corners @ (normal / np.linalg.norm(normal)) / spacing
    first = np.ceil(height.min(axis=1))
    count = np.maximum(0, np.floor(height.max(axis=1)) - first + 1).astype(np.int64)
    cut = np.repeat(np.arange(len(corners)), count)
    level = first[cut] + np.arange(cut.size) - (np.cumsum(count) - count)[cut]
    start, end = corners[cut], np.roll(corners[cut], -1, axis=1)
    below, above = height[cut] - level[:, None], np.roll(height[cut], -1, axis=1) - level[:, None]
    crossed = (below < 0.0) != (above < 0.0)  # a corner in the plane is above it: of no edge or of two
    share = np.where(crossed, below, 0.0) / np.where(crossed, below - above, 1.0)
    points = start + share[:, :, None] * (end - start)
    both = crossed.sum(axis=1) == 2
    return np.asarray(points[both][crossed[both]].reshape(-1, 2, 3))
