"""The closed surface of a body: every edge shared by two triangles that run along it in opposite directions.

Then the volume integrals mean what they say, if besides no shell of the surface overlaps another: two overlapping
closed boxes are a closed surface too, with the common part counted twice.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import shapely
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from assess.errors import GeometryError
from assess.geometry.solid import THINNEST

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.int64]

OVERLAP = 1e-6  # of the body's size: shells that enter one another by less are taken to touch
SEAMS_EXAMINED = 20_000  # longest lines where two shells meet that are looked at for overlap

_TURNS = np.linspace(0.0, 2.0 * np.pi, 17)[:-1] + np.pi / 16.0
_AROUND = np.column_stack([np.cos(_TURNS), np.sin(_TURNS)])  # directions around a seam [16, 2]
_SHEAR = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-0.21372, -0.13187, 1.0]])  # sets the ray's direction upright


def merged(vertices: FloatArray, triangles: IntArray) -> tuple[FloatArray, IntArray]:
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
    faces = group[(np.cumsum(used) - 1)[triangles]]
    a, b, c = faces.T
    return kept, faces[(a != b) & (b != c) & (c != a)]


def check_closed(vertices: FloatArray, triangles: IntArray, *, where: str) -> None:
    """Raise unless every edge belongs to two triangles, which run along it in opposite directions.

    Parameters
    ----------
    vertices, triangles : a merged surface [n, 3] [m], [m, 3]
    where : what the error names

    Raises
    ------
    GeometryError : an open surface, an edge of three or more triangles, neighbours wound in opposite senses
    """
    edges, order, first = _edges(triangles)
    count = np.diff(np.append(first, len(order)))
    balance = np.add.reduceat(np.where(edges[:, 0] < edges[:, 1], 1, -1)[order], first)
    problems = {
        "it is open: {n} boundary {edges}; close the surface": count == 1,
        "{n} {edges} shared by three or more triangles; separate touching parts into bodies of their own, and "
        "remove inner faces": count > 2,
        "its triangles are not wound alike at {n} {edges}; unify the normals": (count == 2) & (balance != 0),
    }
    for text, wrong in problems.items():
        if wrong.any():
            told = text.format(n=int(wrong.sum()), edges="edges" if wrong.sum() > 1 else "edge")
            start, end = vertices[edges[order[first][wrong].min()]]
            raise GeometryError(f"{where}: {told} (the first runs from {_place(start)} to {_place(end)} m)")


def check_shells(vertices: FloatArray, triangles: IntArray, *, where: str) -> None:
    """Raise unless the closed shells of a closed surface bound one volume, counted once.

    Shells beside one another and cavities (inner shells that face inwards) are well; a shell that cuts another, lies
    inside the material of another, or faces inwards on its own is not.

    Raises
    ------
    GeometryError : shells overlap, or one is inside out
    """
    shell = _shells(triangles)
    if shell.max() == 0:
        return
    size = float(np.ptp(vertices, axis=0).max())
    ends = np.cumsum(np.bincount(shell))[:-1]
    parts = [vertices[part] for part in np.split(triangles[np.argsort(shell, kind="stable")], ends)]
    boxes = np.array([[part.min(axis=(0, 1)), part.max(axis=(0, 1))] for part in parts])
    for k, part in enumerate(parts):
        _refuse_flat(part, shell=k, where=where)
    behind = np.array([_behind(part, depth=OVERLAP * size) for part in parts])
    for k, enclosed in enumerate(_layers(behind, parts, boxes)):
        _refuse_layers(int(enclosed), shell=k, part=parts[k], where=where)
    beside = _beside_seams(parts, boxes, size=size)
    layers = _layers(beside, parts, boxes)
    wrong = (layers < 0) | (layers > 1)
    if wrong.any():
        raise GeometryError(
            f"{where}: some of its {len(parts)} closed shells overlap, near {_place(beside[wrong][0])} m, and what "
            "they share would count twice; unite them, or make them bodies of their own that do not overlap"
        )


def _edges(triangles: IntArray) -> tuple[IntArray, IntArray, IntArray]:
    """Directed edges [3 m, 2]; their order by place, either direction [3 m]; where in it each place begins [k]."""
    edges = triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    key = edges.min(axis=1) * (triangles.max() + 1) + edges.max(axis=1)
    order = np.argsort(key, kind="stable")
    new = np.diff(key[order]) != 0
    return edges, order, np.flatnonzero(np.concatenate([[True], new]))


def _shells(triangles: IntArray) -> IntArray:
    """Number, from 0, of each triangle's shell [m]: triangles that share an edge of a closed surface share a shell."""
    pairs = _edges(triangles)[1].reshape(-1, 2) // 3
    n = len(triangles)
    links = coo_array((np.ones(len(pairs), dtype=np.int8), (pairs[:, 0], pairs[:, 1])), shape=(n, n))
    return np.asarray(connected_components(links, directed=False)[1], dtype=np.int64)


def _refuse_flat(part: FloatArray, *, shell: int, where: str) -> None:
    """Raise where a shell [m, 3, 3] encloses nothing."""
    corners = part - part.mean(axis=(0, 1))
    volume = np.einsum("mi,mi->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6.0
    if abs(volume) <= THINNEST * float(np.ptp(part, axis=(0, 1)).max()) ** 3:
        place = _place(part.mean(axis=(0, 1)))
        raise GeometryError(f"{where}: closed shell {shell + 1}, around {place} m, encloses no volume; remove it")


def _layers(points: FloatArray, parts: list[FloatArray], boxes: FloatArray) -> IntArray:
    """How often all shells together enclose each point [k, 3]: 1 in material, 0 elsewhere [k]."""
    layers = np.zeros(len(points), dtype=np.int64)
    for part, (low, high) in zip(parts, boxes, strict=True):
        near = np.flatnonzero(np.all((low <= points) & (points <= high), axis=1))
        if len(near):
            layers[near] += _winding(points[near], part)
    return layers


def _behind(part: FloatArray, *, depth: float) -> FloatArray:
    """The point [3] at a depth [m] behind the middle of the largest triangle of a shell [m, 3, 3]."""
    normals = np.cross(part[:, 1] - part[:, 0], part[:, 2] - part[:, 0])
    area = np.linalg.norm(normals, axis=1)
    largest = int(np.argmax(area))
    return np.asarray(part[largest].mean(axis=0) - depth * normals[largest] / area[largest], dtype=np.float64)


def _refuse_layers(layers: int, *, shell: int, part: FloatArray, where: str) -> None:
    """Raise unless the material behind a shell is there once."""
    place = f"closed shell {shell + 1}, around {_place(part.mean(axis=(0, 1)))} m,"
    if layers > 1:
        raise GeometryError(
            f"{where}: {place} lies inside another, and its volume would count twice; "
            "remove it, or turn its normals inwards if it is a cavity"
        )
    if layers < 1:
        raise GeometryError(f"{where}: {place} is inside out; flip its normals")


def _neighbours(boxes: FloatArray, *, margin: float) -> Iterator[tuple[int, int]]:
    """Pairs of boxes [n, 2, 3] that enter one another by more than the margin."""
    for i in range(len(boxes) - 1):
        low = np.maximum(boxes[i, 0], boxes[i + 1 :, 0])
        high = np.minimum(boxes[i, 1], boxes[i + 1 :, 1])
        for j in np.flatnonzero(np.all(high - low > margin, axis=1)):
            yield i, i + 1 + int(j)


def _beside_seams(parts: list[FloatArray], boxes: FloatArray, *, size: float) -> FloatArray:
    """Points [k, 3] that would show an overlap of shells.

    Where two volumes overlap and neither holds the other, the border of the common part turns from one surface to
    the other along a seam, a line where two triangles meet at an angle; the points lie around the middle of each
    seam, longest seams first. Shells that only touch have seams too, but no common point beside them.
    """
    reach = OVERLAP * size
    found = [_seams(parts[i], parts[j], shortest=reach) for i, j in _neighbours(boxes, margin=reach)]
    if not found:
        return np.empty((0, 3))
    middle, frame, length = (np.concatenate(each) for each in zip(*found, strict=True))
    longest = np.argsort(-length, kind="stable")[:SEAMS_EXAMINED]
    around = np.einsum("di,sij->sdj", _AROUND, frame[longest]) * (2.0 * reach)
    return np.asarray((middle[longest, None] + around).reshape(-1, 3), dtype=np.float64)


def _seams(one: FloatArray, other: FloatArray, *, shortest: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Where triangles of two shells meet at an angle: middle [s, 3], two unit vectors across [s, 2, 3], length [s]."""
    i, j = _candidates(one, other)
    A, B = one[i], other[j]
    n, m = _normals(A), _normals(B)
    D = np.cross(n, m)
    sine = np.linalg.norm(D, axis=1)
    angled = sine > OVERLAP
    A, B, n, m, D = A[angled], B[angled], n[angled], m[angled], D[angled] / sine[angled, None]
    origin = A[:, 0]
    along = np.cross(n, D)  # in the plane of A, square to the common line
    reach = np.einsum("si,si->s", B[:, 0] - origin, m) / np.einsum("si,si->s", along, m)
    line = origin + reach[:, None] * along
    low_a, high_a = _clip(line, D, A, n)
    low_b, high_b = _clip(line, D, B, m)
    low, high = np.maximum(low_a, low_b), np.minimum(high_a, high_b)
    meet = high - low > shortest
    frame = np.stack([n, np.cross(D, n)], axis=1)
    return (line + ((low + high) / 2.0)[:, None] * D)[meet], frame[meet], (high - low)[meet]


def _candidates(one: FloatArray, other: FloatArray) -> tuple[IntArray, IntArray]:
    """Index pairs of triangles [m, 3, 3], [k, 3, 3] whose bounding boxes meet."""
    low_a, high_a = one.min(axis=1), one.max(axis=1)
    low_b, high_b = other.min(axis=1), other.max(axis=1)
    in_a = np.flatnonzero(np.all((high_a >= low_b.min(axis=0)) & (low_a <= high_b.max(axis=0)), axis=1))
    in_b = np.flatnonzero(np.all((high_b >= low_a.min(axis=0)) & (low_b <= high_a.max(axis=0)), axis=1))
    tree = shapely.STRtree(shapely.box(low_a[in_a, 0], low_a[in_a, 2], high_a[in_a, 0], high_a[in_a, 2]))
    b, a = tree.query(shapely.box(low_b[in_b, 0], low_b[in_b, 2], high_b[in_b, 0], high_b[in_b, 2]))
    i, j = in_a[a], in_b[b]
    meet = (high_a[i, 1] >= low_b[j, 1]) & (low_a[i, 1] <= high_b[j, 1])
    return i[meet], j[meet]


def _normals(triangles: FloatArray) -> FloatArray:
    """Unit normals [s, 3] of triangles [s, 3, 3]; of one without area, zero."""
    normal = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    return np.asarray(normal / np.where(length > 0.0, length, 1.0), dtype=np.float64)


def _clip(
    line: FloatArray, along: FloatArray, triangles: FloatArray, normals: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """First and last parameter [s] on lines (point and unit vector [s, 3]) where they lie in their triangles."""
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


def _winding(points: FloatArray, triangles: FloatArray) -> IntArray:
    """How often a closed shell [m, 3, 3] encloses points [k, 3]: faces left less faces entered along a ray [k].

    The ray runs in a direction in which masonry has no edges, so that it meets faces, not their borders.
    """
    flat, at = triangles @ _SHEAR, points @ _SHEAR
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


def _place(point: FloatArray) -> str:
    """A point for an error, to a tenth of a millimetre: (x, y, z)."""
    return "(" + ", ".join(f"{round(float(value), 4) + 0.0:.12g}" for value in point) + ")"
