"""Meshes that are no closed surface, mended where what is meant is plain; each step says what it did."""

from __future__ import annotations

import numpy as np
from scipy.spatial import KDTree

from assess.errors import GeometryError
from assess.geometry.holes import DOUBT, LARGEST, Hole, holes_of
from assess.geometry.shells import counted_once
from assess.geometry.surface import (
    Surface,
    area,
    border,
    edges_of,
    linked,
    moved_by,
    neighbours,
    neighbours_across,
    place,
    volume,
    without_lines,
)
from assess.messages.plural import counted
from spectra.arrays import FloatArray, IntArray

NEAR = 1e-4  # of the body's size: corners of an open border nearer than this are one

Told = tuple[str, ...]


def mended(surface: Surface, *, where: str) -> tuple[Surface, Told]:
    """The closed surface that a mesh stands for, and what was done to it, in sentences; a good one comes back as it is.

    Triangles are turned to run alike; double ones left out; open borders joined where they touch; plane holes of
    at most a fifth of the surface closed; shells that are inside out turned, overlapping ones united. What remains
    open is refused.

    Parameters
    ----------
    surface : merged: each position once
    where : what an error names

    Raises
    ------
    GeometryError : the surface cannot be closed
    """
    told: Told = ()
    across = neighbours_across(surface[1])
    if across is None:
        for step in (_wound_alike, _single, _welded, _split, _wound_alike, _filled):
            surface, more = step(surface)
            told = (*told, *more)
        _refuse_open(surface, where=where)
    surface, more = counted_once(surface, across, where=where)
    return surface, (*told, *more)


def _wound_alike(surface: Surface) -> tuple[Surface, Told]:
    """Neighbours made to run along their common edge in opposite directions; of each sheet the fewer are turned.

    Each triangle stands in a graph twice, as it is and turned; neighbours are linked in the senses that agree. The two
    parts a sheet falls into are its two windings. A sheet with one side only (Möbius') is left.
    """
    vertices, triangles = surface
    n = len(triangles)
    (i, j), alike = (array.T for array in neighbours(edges_of(triangles)))
    across = np.where(alike, j, j + n)
    sense = linked(np.column_stack([np.r_[i, i + n], np.r_[across, (across + n) % (2 * n)]]), count=2 * n)
    here, there = sense[:n], sense[n:]
    many = np.bincount(here, minlength=2 * n)
    turn = (many[there] > many[here]) | ((many[there] == many[here]) & (there < here))
    if not turn.any():
        return surface, ()
    faces = np.where(turn[:, None], triangles[:, ::-1], triangles)
    return (vertices, faces), (
        f"{counted(int(turn.sum()), 'triangle')} turned to run like their neighbours (volume +0 %)",
    )


def _single(surface: Surface) -> tuple[Surface, Told]:
    """Each triangle once, and none that lies against another which faces the other way, if that leaves fewer gaps."""
    vertices, triangles = surface
    order = np.argsort(triangles, axis=1)
    odd = np.isin(order @ [9, 3, 1], [0 * 9 + 2 * 3 + 1, 1 * 9 + 0 * 3 + 2, 2 * 9 + 1 * 3 + 0])
    kinds, first, index = np.unique(np.sort(triangles, axis=1), axis=0, return_index=True, return_inverse=True)
    if len(kinds) == len(triangles):
        return surface, ()
    net = np.bincount(index.ravel(), weights=np.where(odd, -1, 1), minlength=len(kinds))
    each = (vertices, triangles[np.sort(first)])
    without_films = (vertices, np.where(net[:, None] > 0, kinds, kinds[:, ::-1])[net != 0])
    best = without_films if len(without_films[1]) and _gaps(without_films) <= _gaps(_wound_alike(each)[0]) else each
    if _gaps(best) > _gaps(surface):  # they belong to different shells
        return surface, ()
    gone = counted(len(triangles) - len(best[1]), "double triangle")
    return best, (f"{gone} left out ({moved_by(volume(*surface), volume(*best))})",)


def _gaps(surface: Surface) -> int:
    """Places where the surface is not closed."""
    return int(np.count_nonzero(edges_of(surface[1]).balance))


def _welded(surface: Surface) -> tuple[Surface, Told]:
    """Corners of open borders that lie almost at one place made one."""
    vertices, triangles = surface
    rim = np.unique(border(edges_of(triangles)))
    reach = NEAR * float(np.ptp(vertices, axis=0).max())
    pairs = np.array(sorted(KDTree(vertices[rim]).query_pairs(reach)) if len(rim) else [], dtype=np.int64)
    if not len(pairs):
        return surface, ()
    group = linked(pairs, count=len(rim))
    kept = rim[np.unique(group, return_index=True)[1]][group]
    target = np.arange(len(vertices))
    target[rim] = kept
    new = (vertices, without_lines(target[triangles]))
    gone = counted(int((kept != rim).sum()), "corner")
    told = (
        f"{gone} of open borders, at most {1e3 * reach:.2g} mm off, joined ({moved_by(volume(*surface), volume(*new))})"
    )
    return new, (told,)


def _split(surface: Surface) -> tuple[Surface, Told]:
    """Triangles split where corners of an open border lie on their open edge."""
    vertices, triangles = surface
    total = 0
    for _ in range(3):  # a triangle has three edges, split one after another
        triangles, number = _split_once(vertices, triangles)
        total += number
    if not total:
        return surface, ()
    told = f"{counted(total, 'edge')} split at the corners of others that lie on them (volume +0 %)"
    return (vertices, triangles), (told,)


def _split_once(vertices: FloatArray, triangles: IntArray) -> tuple[IntArray, int]:
    """The triangles, each split along one open edge at most, and how many were."""
    edges = edges_of(triangles)
    rim = np.unique(border(edges))
    if not len(rim):
        return triangles, 0
    tree = KDTree(vertices[rim])
    reach = NEAR * float(np.ptp(vertices, axis=0).max())
    new: dict[int, IntArray] = {}
    for edge in edges.order[edges.first[edges.count == 1]].tolist():
        if edge // 3 in new:
            continue
        a, b = edges.directed[edge]
        way = _on_the_way(vertices, a, b, rim, tree, reach=reach)
        if len(way):
            steps = np.concatenate([[a], way, [b]])
            apex = np.full(len(steps) - 1, triangles[edge // 3].sum() - a - b)
            new[edge // 3] = np.column_stack([steps[:-1], steps[1:], apex])
    return np.concatenate([np.delete(triangles, list(new), axis=0), *new.values()]), len(new)


def _on_the_way(vertices: FloatArray, a: int, b: int, rim: IntArray, tree: KDTree, *, reach: float) -> IntArray:
    """Those of the vertices `rim` that lie between a and b on their line, in order."""
    along = vertices[b] - vertices[a]
    length = float(np.linalg.norm(along))
    near = rim[tree.query_ball_point((vertices[a] + vertices[b]) / 2.0, length / 2.0 + reach)]
    off = vertices[near] - vertices[a]
    at = off @ along / length
    aside = np.linalg.norm(off - np.outer(at / length, along), axis=1)
    on = (aside < reach) & (at > reach) & (at < length - reach)
    return np.asarray(near[on][np.argsort(at[on])], dtype=np.int64)


def _filled(surface: Surface) -> tuple[Surface, Told]:
    """All holes closed by planes, if they are nearly plane and no large part of the surface; else none."""
    vertices, triangles = surface
    holes = holes_of(surface)
    if not holes or _unclosable(surface, holes):
        return surface, ()
    new = (vertices, np.concatenate([triangles, *(hole.triangles for hole in holes)]))
    closed = sum(hole.area for hole in holes)
    size = f"{closed:.3g} m2, {100.0 * closed / area(*new):.3g} % of the surface"
    edges = counted(sum(hole.edges for hole in holes), "edge")
    moved = moved_by(volume(*surface), volume(*new))
    first = f"the first around {place(holes[0].centre)} m"
    return new, (
        f"{counted(len(holes), 'hole')} of {edges}, {size}, closed by planes ({first}; {moved} against the open mesh, "
        "holes taken as cones to the middle of its box)",
    )


def _unclosable(surface: Surface, holes: list[Hole]) -> str:
    """Why the holes cannot be closed by planes; empty where they can."""
    if not all(len(hole.triangles) for hole in holes):
        return "its border crosses itself"
    vertices, triangles = surface
    whole = np.concatenate([triangles, *(hole.triangles for hole in holes)])
    share = sum(hole.area for hole in holes) / area(vertices, whole)
    if share > LARGEST:
        return f"{100.0 * share:.3g} % of the surface, too much to close by a guess"
    doubt = sum(hole.area * hole.deviation for hole in holes)
    if doubt > DOUBT * abs(volume(vertices, whole)):
        return f"up to {max(hole.deviation for hole in holes):.2g} m off a plane, too uneven to close by a guess"
    return ""


def _refuse_open(surface: Surface, *, where: str) -> None:
    """Raise where the surface is still not closed."""
    vertices, triangles = surface
    edges = edges_of(triangles)
    if edges.closed:
        return
    holes = holes_of(surface)
    if holes:
        number = counted(int((edges.count == 1).sum()), "open edge")
        why = _unclosable(surface, holes) or "besides edges of three triangles"
        raise GeometryError(
            f"{where}: it is open: {number} around {counted(len(holes), 'hole')}, the largest around "
            f"{place(holes[0].centre)} m, {why}; close the surface"
        )
    wrong = edges.balance != 0
    start, end = vertices[edges.directed[edges.order[edges.first[wrong]].min()]]
    what = "shared by three or more triangles" if (edges.count[wrong] > 2).any() else "where triangles cannot run alike"
    raise GeometryError(
        f"{where}: {counted(int(wrong.sum()), 'edge')} {what} (the first from {place(start)} to {place(end)} m); "
        "separate touching parts into bodies of their own, and remove inner faces"
    )
