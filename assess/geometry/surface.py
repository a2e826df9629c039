"""The closed surface of a body: along every edge as many triangles run one way as the other.

Then the volume integrals mean what they say, if besides no part of space is enclosed twice (`shells`, `sounding`).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]
BoolArray = NDArray[np.bool_]
MIX = (1.6180339887, 2.7182818284)  # weights that keep different points apart
Surface = tuple[FloatArray, IntArray]  # vertices [n, 3] [m], triangles as indices into them [m, 3]


@dataclass(frozen=True)
class Edges:
    """The edges of a surface of m triangles, gathered by place: those between the same two vertices, either way.

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
        """Whether, besides, every edge belongs to two triangles only."""
        return self.closed and not (self.count != 2).any()


def merged(vertices: FloatArray, triangles: IntArray) -> Surface:
    """The same surface with each position once, no unused vertices, no triangle that uses one position twice.

    Positions are one when their coordinates are equal; nothing is moved.

    Parameters
    ----------
    vertices : [n, 3] [m]
    triangles : indices into vertices [m, 3]
    """
    used = np.zeros(len(vertices), dtype=np.bool_)
    used[triangles] = True
    columns = [values + 0.0 for values in vertices[used].T]  # -0.0 becomes 0.0
    order, new = _alike_together(columns)
    group = np.empty(len(order), dtype=np.int64)
    group[order] = np.cumsum(new) - 1
    kept = np.column_stack([values[order[new]] for values in columns])
    by_place = np.lexsort(kept.T)
    rank = np.empty(len(kept), dtype=np.int64)
    rank[by_place] = np.arange(len(kept))
    return kept[by_place], without_lines(rank[group[(np.cumsum(used) - 1)[triangles]]])


def _alike_together(columns: list[FloatArray]) -> tuple[IntArray, BoolArray]:
    """An order [n] of points x, y, z [n] in which equal ones stand together, and where one differs from the last [n].

    By one number mixed from the three, which is quicker; by all three where it is the same for different points.
    """
    x, y, z = columns
    mixed = x + MIX[0] * y + MIX[1] * z
    order = np.argsort(mixed)
    new = _changes(columns, order)
    if np.any(new[1:] & (np.diff(mixed[order]) == 0.0)):
        order = np.lexsort(columns)
        new = _changes(columns, order)
    return np.asarray(order, dtype=np.int64), new


def _changes(columns: list[FloatArray], order: NDArray[np.intp]) -> BoolArray:
    """Which points [n], in an order, differ from the one before; the first does."""
    steps = [np.diff(values[order]) != 0.0 for values in columns]
    return np.concatenate([[True], steps[0] | steps[1] | steps[2]])


def without_lines(triangles: IntArray) -> IntArray:
    """The triangles that use three different vertices."""
    a, b, c = triangles.T
    return np.asarray(triangles[(a != b) & (b != c) & (c != a)], dtype=np.int64)


def edges_of(triangles: IntArray) -> Edges:
    """The edges of at least one triangle."""
    directed = triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    start, end = directed.T
    key = np.minimum(start, end) * (triangles.max() + 1) + np.maximum(start, end)
    order = np.argsort(key, kind="stable")
    first = np.flatnonzero(np.concatenate([[True], np.diff(key[order]) != 0]))
    count = np.diff(np.append(first, len(order)))
    way = np.where(start < end, 1, -1)
    return Edges(directed, order, first, count, np.add.reduceat(way[order], first))


def border(edges: Edges) -> IntArray:
    """The directed edges [b, 2] that have no counterpart: of one triangle only."""
    return np.asarray(edges.directed[edges.order[edges.first[edges.count == 1]]], dtype=np.int64)


def neighbours(edges: Edges) -> tuple[IntArray, BoolArray]:
    """Pairs of triangles [e, 2] that alone share an edge, and whether they run along it in opposite directions [e]."""
    two = edges.count == 2
    first = edges.first[two]
    pairs = np.column_stack([edges.order[first], edges.order[first + 1]]) // 3
    return pairs, edges.balance[two] == 0


def linked(pairs: IntArray, *, count: int) -> IntArray:
    """Number, from 0, of the group [count] to which each of `count` things belongs when pairs [e, 2] are linked."""
    links = coo_array((np.ones(len(pairs), dtype=np.int8), (pairs[:, 0], pairs[:, 1])), shape=(count, count))
    return np.asarray(connected_components(links, directed=False)[1], dtype=np.int64)


def volume(vertices: FloatArray, triangles: IntArray) -> float:
    """Signed volume inside a closed surface [m3]; of an open one, closed by cones to the middle of its box."""
    x, y, z = (_centred(vertices[:, axis][triangles]) for axis in range(3))
    turn = (
        y[:, 1] * z[:, 2] - z[:, 1] * y[:, 2],
        z[:, 1] * x[:, 2] - x[:, 1] * z[:, 2],
        x[:, 1] * y[:, 2] - y[:, 1] * x[:, 2],
    )
    return float(x[:, 0] @ turn[0] + y[:, 0] @ turn[1] + z[:, 0] @ turn[2]) / 6.0


def _centred(values: FloatArray) -> FloatArray:
    """The values about the middle of their range."""
    return np.asarray(values - (values.min() + values.max()) / 2.0, dtype=np.float64)


def area(vertices: FloatArray, triangles: IntArray) -> float:
    """Area of the triangles [m2]."""
    return float(areas_and_normals(vertices[triangles])[0].sum())


def area_vectors(corners: FloatArray) -> FloatArray:
    """Outward normals [m, 3] of triangles [m, 3, 3], each as long as twice its area [m2]."""
    return np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])


def areas_and_normals(corners: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Area [m] [m2] and unit normal [m, 3] of triangles [m, 3, 3]; of one without area, zero."""
    normals = area_vectors(corners)
    length = np.linalg.norm(normals, axis=1)
    return length / 2.0, normals / np.where(length > 0.0, length, 1.0)[:, None]


def place(point: FloatArray) -> str:
    """A point for a sentence, to a tenth of a millimetre: (x, y, z)."""
    return "(" + ", ".join(f"{round(float(value), 4) + 0.0:.12g}" for value in point) + ")"


def moved_by(before: float, after: float) -> str:
    """By how much a repair moved the volume [m3], as a share of what it is now."""
    return f"volume {100.0 * (after - before) / after:+.3g} %" if after else "no volume left"
