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
    points = vertices[used] + 0.0  # -0.0 becomes 0.0
    order = np.lexsort(points.T)
    new = np.any(np.diff(points[order], axis=0) != 0.0, axis=1)
    group = np.empty(len(points), dtype=np.int64)
    group[order] = np.concatenate([[0], np.cumsum(new)])
    kept = points[order[np.concatenate([[True], new])]]
    return kept, without_lines(group[(np.cumsum(used) - 1)[triangles]])


def without_lines(triangles: IntArray) -> IntArray:
    """The triangles that use three different vertices."""
    a, b, c = triangles.T
    return np.asarray(triangles[(a != b) & (b != c) & (c != a)], dtype=np.int64)


def edges_of(triangles: IntArray) -> Edges:
    """The edges of at least one triangle."""
    directed = triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    key = directed.min(axis=1) * (triangles.max() + 1) + directed.max(axis=1)
    order = np.argsort(key, kind="stable")
    first = np.flatnonzero(np.concatenate([[True], np.diff(key[order]) != 0]))
    count = np.diff(np.append(first, len(order)))
    way = np.where(directed[:, 0] < directed[:, 1], 1, -1)
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
    used = vertices[triangles]
    a, b, c = (used[:, i] - (used.min(axis=(0, 1)) + used.max(axis=(0, 1))) / 2.0 for i in range(3))
    return float(np.einsum("mi,mi->", a, np.cross(b, c))) / 6.0


def area(vertices: FloatArray, triangles: IntArray) -> float:
    """Area of the triangles [m2]."""
    a, b, c = (vertices[triangles[:, i]] for i in range(3))
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()) / 2.0


def place(point: FloatArray) -> str:
    """A point for a sentence, to a tenth of a millimetre: (x, y, z)."""
    return "(" + ", ".join(f"{round(float(value), 4) + 0.0:.12g}" for value in point) + ")"


def counted(number: int, noun: str) -> str:
    """A number with its noun: 1 shell, 2 shells."""
    return f"{number} {noun}" + ("" if number == 1 else "s")


def moved_by(before: float, after: float) -> str:
    """By how much a repair moved the volume [m3], as a share of what it is now."""
    return f"volume {100.0 * (after - before) / after:+.3g} %" if after else "no volume left"
