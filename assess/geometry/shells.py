"""The closed shells of a surface, and the one volume that they stand for, counted once.

Shells beside one another and cavities (inner shells that face inwards) are well. A shell that cuts another or lies
inside the material of another counts what they share twice: two overlapping closed boxes are a closed surface too.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from assess.geometry.boolean import united
from assess.geometry.seams import OVERLAP, beside_seams
from assess.geometry.solid import THINNEST
from assess.geometry.surface import (
    Edges,
    Surface,
    area_vectors,
    edges_of,
    linked,
    linked_across,
    merged,
    moved_by,
    neighbours,
    place,
    volume,
)
from assess.geometry.winding import layers
from assess.messages.plural import counted
from spectra.arrays import FloatArray, IntArray

ASKED = 64  # triangles of a shell beside which the others are looked up


def counted_once(
    surface: Surface, across: NDArray[np.int32] | None = None, *, where: str
) -> tuple[Surface, tuple[str, ...]]:
    """The closed surface with its material counted once, and what was done to it; a good one comes back as it is.

    A shell without volume is left out. A shell that faces inwards is a cavity where it lies in material, else it is
    turned. Shells that overlap, or lie inside the material of another, are united.

    Parameters
    ----------
    across : its `neighbours_across`, where they are known
    where : what an error names

    Raises
    ------
    GeometryError : shells cannot be united
    """
    told: tuple[str, ...] = ()
    if volume(*surface) < -THINNEST * float(np.prod(np.ptp(surface[0], axis=0))):  # two shells may be opposite
        surface, told = (
            (surface[0], surface[1][:, ::-1]),
            ("its triangles faced inwards and were turned (volume +0 %)",),
        )
    shells = separated(surface, across)
    if len(shells) == 1:
        return surface, told
    for step in (_without_flat, _turned, _overlaps_united):
        shells, more = step(shells, where=where)
        told = (*told, *more)
    return (_together(shells) if told else surface), told


def separated(surface: Surface, across: NDArray[np.int32] | None = None) -> list[Surface]:
    """The closed shells of a closed surface; across : its `neighbours_across`, where they are known.

    Triangles that alone share an edge share a shell. At an edge of more triangles those shells stay together that are
    not closed there by themselves: boxes that touch along an edge are two.
    """
    vertices, triangles = surface
    group = linked_across(across) if across is not None else _linked_at_edges(triangles)
    if group.max() == 0:
        return [surface]
    ends = np.cumsum(np.bincount(group))[:-1]
    return [(vertices, part) for part in np.split(triangles[np.argsort(group, kind="stable")], ends)]


def _linked_at_edges(triangles: IntArray) -> IntArray:
    """The shell [m] of each triangle of any closed surface."""
    edges = edges_of(triangles)
    group = linked(neighbours(edges)[0], count=len(triangles))
    return group if edges.plain else _rejoined(group, edges)


def _rejoined(group: IntArray, edges: Edges) -> IntArray:
    """The groups of triangles, linked in pairs at edges of more than two where by themselves they are not closed.

    Groups are paired in their order in the file, where parts stand one after another.
    """
    many = np.repeat(edges.count > 2, edges.count)
    edge = edges.order[many]
    at = np.repeat(np.arange(len(edges.count)), edges.count)[many]
    way = np.where(edges.directed[edge, 0] < edges.directed[edge, 1], 1, -1)
    pairs, index = np.unique(np.column_stack([at, group[edge // 3]]), axis=0, return_inverse=True)
    excess = np.bincount(index.ravel(), weights=way, minlength=len(pairs)).astype(np.int64)
    ups, downs = (np.repeat(pairs[:, 1], (sign * excess).clip(0)) for sign in (1, -1))
    return linked(np.column_stack([ups, downs]), count=int(group.max()) + 1)[group]


def _without_flat(shells: list[Surface], *, where: str) -> tuple[list[Surface], tuple[str, ...]]:
    """The shells that enclose something; all where none does."""
    good = [shell for shell in shells if not _flat(shell)]
    if len(good) in (0, len(shells)):
        return shells, ()
    return good, (f"{counted(len(shells) - len(good), 'closed shell')} without volume left out (volume +0 %)",)


def _flat(shell: Surface) -> bool:
    corners = shell[0][shell[1]]
    return abs(volume(*shell)) <= THINNEST * float(np.ptp(corners, axis=(0, 1)).max()) ** 3


def _turned(shells: list[Surface], *, where: str) -> tuple[list[Surface], tuple[str, ...]]:
    """The shells, with those that face inwards turned where they lie in no material."""
    solid = [shell for shell in shells if volume(*shell) > 0.0]
    parts, boxes = _parts(solid)
    alone = [k for k, shell in enumerate(shells) if volume(*shell) < 0.0 and not _within(shell, parts, boxes)]
    if not alone:
        return shells, ()
    centre = place(shells[alone[0]][0][shells[alone[0]][1]].mean(axis=(0, 1)))
    after = sum(abs(volume(*shell)) if k in alone else volume(*shell) for k, shell in enumerate(shells))
    moved = moved_by(sum(volume(*shell) for shell in shells), after)
    told = f"{counted(len(alone), 'closed shell')} inside out turned (the first around {centre} m; {moved})"
    return [(v, t[:, ::-1]) if k in alone else (v, t) for k, (v, t) in enumerate(shells)], (told,)


def _within(shell: Surface, parts: list[FloatArray], boxes: FloatArray) -> bool:
    """Whether most of what an inward shell encloses at its faces lies inside others."""
    vertices, triangles = shell
    corners = vertices[triangles[:: max(1, len(triangles) // ASKED)]]
    normals = area_vectors(corners)
    depth = OVERLAP * float(np.ptp(vertices[triangles], axis=(0, 1)).max())
    inside = corners.mean(axis=1) + depth * normals / np.linalg.norm(normals, axis=1, keepdims=True).clip(1e-300)
    return bool(np.mean(layers(inside, parts, boxes) > 0) > 0.5)


def _overlaps_united(shells: list[Surface], *, where: str) -> tuple[list[Surface], tuple[str, ...]]:
    """The shells, united where the material of some would count twice."""
    at = _counted_wrongly(shells)
    if at is None:
        return shells, ()
    whole = united(shells, where=where)
    before = sum(volume(*shell) for shell in shells)
    told = (
        f"its {len(shells)} closed shells, some of which overlap (near {place(at)} m), united, so that what they share "
        f"counts once; a cavity would face inwards ({moved_by(before, volume(*whole))})"
    )
    return [whole], (told,)


def _counted_wrongly(shells: list[Surface]) -> FloatArray | None:
    """A point [3] that the shells together enclose twice, or less than never; None where there is none.

    Shells that enter one another by less than `OVERLAP` of the body's size touch.
    """
    parts, boxes = _parts(shells)
    size = float(np.ptp(boxes, axis=(0, 1)).max())
    behind = np.array([_behind(part, depth=OVERLAP * size) for part in parts])
    hidden = layers(behind, parts, boxes) != 1
    if hidden.any():
        return np.asarray(behind[hidden][0], dtype=np.float64)
    beside = beside_seams(parts, boxes, size=size)
    found = layers(beside, parts, boxes)
    wrong = (found < 0) | (found > 1)
    return np.asarray(beside[wrong][0], dtype=np.float64) if wrong.any() else None


def _behind(part: FloatArray, *, depth: float) -> FloatArray:
    """The point [3] at a depth [m] behind the middle of the largest triangle of a shell [m, 3, 3]."""
    normals = area_vectors(part)
    area = np.linalg.norm(normals, axis=1)
    largest = int(np.argmax(area))
    return np.asarray(part[largest].mean(axis=0) - depth * normals[largest] / area[largest], dtype=np.float64)


def _parts(shells: list[Surface]) -> tuple[list[FloatArray], FloatArray]:
    """Corners of the triangles of each shell [m, 3, 3], and their boxes [n, 2, 3]."""
    parts = [vertices[triangles] for vertices, triangles in shells]
    boxes = [[part.min(axis=(0, 1)), part.max(axis=(0, 1))] for part in parts]
    return parts, np.array(boxes).reshape(-1, 2, 3)


def _together(shells: list[Surface]) -> Surface:
    """The shells as one surface; all have the same vertices."""
    return merged(shells[0][0], np.concatenate([triangles for _, triangles in shells]))
