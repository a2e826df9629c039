"""The closed shells of a surface, and the one volume that they represent.

Shells beside one another and cavities (inner shells that face inwards) are fine. A shell that cuts another or lies
inside the material of another counts the common volume twice: two overlapping closed boxes are a closed surface too.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from assess.geometry.boolean import unite
from assess.geometry.intersection_segments import OVERLAP, points_beside_intersections
from assess.geometry.solid import THINNEST
from assess.geometry.surface import (
    Edges,
    Surface,
    area_vectors,
    connected_groups,
    connected_groups_across,
    find_edges,
    merge_vertices,
    neighbours,
    place_values,
    volume,
    volume_change,
)
from assess.geometry.winding_number import winding_numbers
from assess.messages.message import Message, note, whole_number
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
    for step in (_drop_flat, _reverse_inverted, _unite_overlapping):
        shells, more = step(shells, where=where)
        done = (*done, *more)
    return (_join_shells(shells) if done else surface), done


def separate_shells(surface: Surface, across: NDArray[np.int32] | None = None) -> list[Surface]:
    """Separate the closed shells of a closed surface; across : its `adjacent_triangles`, where they are known.

    Triangles that alone share an edge share a shell. At an edge of more triangles those shells stay together that are
    not closed there by themselves: boxes that touch along an edge are two.
    """
    vertices, triangles = surface
    group = connected_groups_across(across) if across is not None else _group_by_edges(triangles)
    if group.max() == 0:
        return [surface]
    ends = np.cumsum(np.bincount(group))[:-1]
    return [(vertices, part) for part in np.split(triangles[np.argsort(group, kind="stable")], ends)]


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
    good = [shell for shell in shells if not _flat(shell)]
    if len(good) in (0, len(shells)):
        return shells, ()
    return good, (note("flat-shells-removed", number=whole_number(len(shells) - len(good))),)


def _flat(shell: Surface) -> bool:
    corners = shell[0][shell[1]]
    return abs(volume(*shell)) <= THINNEST * float(np.ptp(corners, axis=(0, 1)).max()) ** 3


def _reverse_inverted(shells: list[Surface], *, where: str) -> tuple[list[Surface], tuple[Message, ...]]:
    """Reverse the shells that face inwards but lie in no material."""
    solid = [shell for shell in shells if volume(*shell) > 0.0]
    parts, boxes = _parts(solid)
    alone = [k for k, shell in enumerate(shells) if volume(*shell) < 0.0 and not _lies_in_material(shell, parts, boxes)]
    if not alone:
        return shells, ()
    centre = shells[alone[0]][0][shells[alone[0]][1]].mean(axis=(0, 1))
    after = sum(abs(volume(*shell)) if k in alone else volume(*shell) for k, shell in enumerate(shells))
    change = volume_change(sum(volume(*shell) for shell in shells), after)
    done = note("shells-reversed", number=whole_number(len(alone)), change=change, **place_values(centre))
    return [(v, t[:, ::-1]) if k in alone else (v, t) for k, (v, t) in enumerate(shells)], (done,)


def _lies_in_material(shell: Surface, parts: list[FloatArray], boxes: FloatArray) -> bool:
    """Return whether most of what an inward shell encloses near its faces lies inside others."""
    vertices, triangles = shell
    corners = vertices[triangles[:: max(1, len(triangles) // SAMPLES)]]
    normals = area_vectors(corners)
    depth = OVERLAP * float(np.ptp(vertices[triangles], axis=(0, 1)).max())
    inside = corners.mean(axis=1) + depth * normals / np.linalg.norm(normals, axis=1, keepdims=True).clip(1e-300)
    return bool(np.mean(winding_numbers(inside, parts, boxes) > 0) > 0.5)


def _unite_overlapping(shells: list[Surface], *, where: str) -> tuple[list[Surface], tuple[Message, ...]]:
    """Unite the shells where the material of some would count twice."""
    at = _find_overlap(shells)
    if at is None:
        return shells, ()
    whole = unite(shells, where=where)
    before = sum(volume(*shell) for shell in shells)
    change = volume_change(before, volume(*whole))
    done = note("shells-united", number=whole_number(len(shells)), change=change, **place_values(at))
    return [whole], (done,)


def _find_overlap(shells: list[Surface]) -> FloatArray | None:
    """Find a point [3] that the shells together enclose twice, or less than never; None where there is none.

    Shells that overlap by less than `OVERLAP` of the body's size are in contact only.
    """
    parts, boxes = _parts(shells)
    size = float(np.ptp(boxes, axis=(0, 1)).max())
    behind = np.array([_point_behind(part, depth=OVERLAP * size) for part in parts])
    hidden = winding_numbers(behind, parts, boxes) != 1
    if hidden.any():
        return np.asarray(behind[hidden][0], dtype=np.float64)
    beside = points_beside_intersections(parts, boxes, size=size)
    found = winding_numbers(beside, parts, boxes)
    wrong = (found < 0) | (found > 1)
    return np.asarray(beside[wrong][0], dtype=np.float64) if wrong.any() else None


def _point_behind(part: FloatArray, *, depth: float) -> FloatArray:
    """Return the point [3] at a depth [m] behind the middle of the largest triangle of a shell [m, 3, 3]."""
    normals = area_vectors(part)
    area = np.linalg.norm(normals, axis=1)
    largest = int(np.argmax(area))
    return np.asarray(part[largest].mean(axis=0) - depth * normals[largest] / area[largest], dtype=np.float64)


def _parts(shells: list[Surface]) -> tuple[list[FloatArray], FloatArray]:
    """Return the corners of the triangles of each shell [m, 3, 3], and their boxes [n, 2, 3]."""
    parts = [vertices[triangles] for vertices, triangles in shells]
    boxes = [[part.min(axis=(0, 1)), part.max(axis=(0, 1))] for part in parts]
    return parts, np.array(boxes).reshape(-1, 2, 3)


def _join_shells(shells: list[Surface]) -> Surface:
    """Join the shells into one surface; all have the same vertices."""
    return merge_vertices(shells[0][0], np.concatenate([triangles for _, triangles in shells]))
