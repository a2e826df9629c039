"""The bodies of a mechanism in space, simplified for the results and for drawing."""

from __future__ import annotations

from collections.abc import Sequence
from math import floor, log10

import numpy as np

from assess.geometry.scene import Scene
from assess.geometry.simplify import simplify
from assess.geometry.solid import Solid
from assess.mechanisms.mechanism import Mechanism
from assess.results import Axis, Place, View
from assess.study.drawing import FIXED, block_numbers, hinges_of
from spectra.arrays import FloatArray, IntArray

LIMIT = 4000  # triangles of a view
FIGURES = 5  # of a coordinate, counted from the first of the bodies' size
CORNERS = 300  # of a section's ring


def view(mechanism: Mechanism, scene: Scene) -> View:
    """Return the bodies with their axes of rotation, at rest."""
    members = [*zip(scene.members, block_numbers(mechanism.positive), strict=True), (scene.fixed, FIXED)]
    surfaces = [(*surface(solids), owner) for solids, owner in members if solids]
    corners = np.concatenate([vertices for vertices, _, _ in surfaces])
    size = np.ptp(corners, axis=0)
    decimals = FIGURES - 1 - floor(log10(float(size.max())))
    drawn = simplify_surfaces(surfaces)
    starts = np.cumsum([0, *(len(vertices) for vertices, _, _ in drawn)])
    return View(
        vertices=places(np.concatenate([vertices for vertices, _, _ in drawn]), decimals),
        triangles=tuple(
            (a, b, c)
            for start, (_, triangles, _) in zip(starts, drawn, strict=False)
            for a, b, c in (triangles + start).tolist()
        ),
        block_of=tuple(owner for _, triangles, owner in drawn for _ in range(len(triangles))),
        axes=axes(mechanism, scene, decimals),
        sections=tuple(places(thin_ring(ring), decimals) for ring in scene.sections),
        direction=as_place(scene.direction),
        size=places(size[None], decimals)[0],
        given=sum(len(triangles) for _, triangles, _ in surfaces),
    )


def surface(solids: Sequence[Solid]) -> tuple[FloatArray, IntArray]:
    """Return the surfaces of several solids as one."""
    starts = np.cumsum([0, *(len(solid.vertices) for solid in solids[:-1])])
    triangles = [solid.triangles + start for solid, start in zip(solids, starts, strict=True)]
    return np.concatenate([solid.vertices for solid in solids]), np.concatenate(triangles)


def simplify_surfaces(surfaces: Sequence[tuple[FloatArray, IntArray, int]]) -> list[tuple[FloatArray, IntArray, int]]:
    """Simplify surfaces to no more than LIMIT triangles in all, shared by area."""
    if sum(len(triangles) for _, triangles, _ in surfaces) <= LIMIT:
        return list(surfaces)
    areas = np.array([area(vertices[triangles]) for vertices, triangles, _ in surfaces])
    shares = np.maximum(12, (LIMIT * areas / areas.sum()).astype(np.int64))
    return [
        (*simplify(vertices, triangles, limit=int(share)), owner)
        for (vertices, triangles, owner), share in zip(surfaces, shares, strict=True)
    ]


def area(corners: FloatArray) -> float:
    """Return the total area of triangles [m, 3, 3] [m2]."""
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return float(np.linalg.norm(normals, axis=1).sum()) / 2.0


def axes(mechanism: Mechanism, scene: Scene, decimals: int) -> tuple[Axis, ...]:
    """Return the axis of each hinge, across the direction, over the width of the moving bodies."""
    along, up = scene.direction, np.array([0.0, 0.0, 1.0])
    across = np.array([-along[1], along[0], 0.0])
    reach = np.concatenate([solid.vertices for member in scene.members for solid in member]) @ across
    made = []
    for hinge in hinges_of(mechanism):
        middle = hinge.at[0] * along + hinge.at[1] * up
        first, last = places(np.array([middle + reach.min() * across, middle + reach.max() * across]), decimals)
        made.append(Axis(hinge.name, (first, last)))
    return tuple(made)


def thin_ring(ring: FloatArray) -> FloatArray:
    """Thin a closed ring [k, 3] evenly to no more than CORNERS corners."""
    step = -(-(len(ring) - 1) // CORNERS)
    return np.concatenate([ring[:-1:step], ring[:1]])


def places(points: FloatArray, decimals: int) -> tuple[Place, ...]:
    """Return points [k, 3] as plain numbers, rounded."""
    return tuple(as_place(point) for point in np.round(points, decimals) + 0.0)


def as_place(point: FloatArray) -> Place:
    """Return a point [3] as plain numbers."""
    x, y, z = point.tolist()
    return (x, y, z)
