"""Walls cut to the wedges that move with a façade or a corner, and the weakest direction of a corner."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import cos, sin

import numpy as np
import shapely

from assess.errors import GeometryError, MechanismError
from assess.geometry.cut import Piece, Plane, divide, level_plane
from assess.geometry.planar import BASE_TOLERANCE, base_of_section, join_bodies, lowest_corners, planar_body
from assess.geometry.solid import Solid, keep_of_bodies
from assess.mechanisms.mechanism import Vector
from assess.mechanisms.wedged_block import Corner, Wedge, WedgedBlock
from assess.model.bodies import Bodies, solids_to_cut
from spectra.arrays import FloatArray

INWARDS = 1e-3  # cosine: a direction that turns no further inwards is along a wall
SQUAT = 1.5  # times its thickness: a shorter wall may run either way
BACKWARDS = 0.5  # cosine: a wall that runs back from a façade does so within 60 degrees of square to it
BEHIND = " (2)"  # after the name of what stays behind a crack
WAYS = 7  # between the outward directions of the walls of a corner


def wedged_piece(name: str, definition: WedgedBlock, bodies: Bodies) -> Piece:
    """Return the block of a façade or a corner with its wedges.

    Raises
    ------
    GeometryError : a body has no geometry, a wall does not run back, or nothing of it is left
    MechanismError : a corner is to turn inwards
    """
    where = f'mechanism "{name}"'
    standing = solids_to_cut(name, definition.blocks[0], bodies)
    cracks = [_crack_of(where, number, definition, standing) for number in range(len(definition.wedges))]
    if isinstance(definition, Corner):
        _require_outwards(where, definition, cracks)
    kept, fixed, rings = list[Solid](), list[Solid](), list[FloatArray]()
    foot = _foot_of(definition, standing)
    for solid in standing:
        moving, below, rings_below = front_of((solid,), level_plane(foot), where=f"{where}: cut")
        fixed += below
        rings += rings_below
        for wedge, (run, start) in zip(definition.wedges, cracks, strict=True):
            if solid.name in wedge.walls:
                for plane in _planes_of(wedge, run, start, foot):
                    moving, behind, section = front_of(moving, plane, where=f"{where}: wedges")
                    fixed += left_behind(behind)
                    rings += section
        kept += moving
    if not kept:
        raise GeometryError(f"{where}: cut: nothing of its bodies lies above z = {foot:.4g} m; give a lower elevation")
    corners = lowest_corners(kept)
    body = join_bodies([planar_body(solid, direction=definition.towards) for solid in kept])
    body = replace(body, base=base_of_section(corners, direction=definition.towards))
    return Piece(body, tuple(kept), corners, bool(fixed), tuple(rings), tuple(fixed))


def outward_directions(name: str, definition: Corner, bodies: Bodies) -> tuple[Vector, ...]:
    """Return directions of a corner from the outward one of one wall to that of the other."""
    where, standing = f'mechanism "{name}"', solids_to_cut(name, definition.blocks[0], bodies)
    (one, _), (other, _) = (_crack_of(where, number, definition, standing) for number in range(2))
    found = []
    for share in np.linspace(0.0, 1.0, WAYS):
        way = -(cos(share * np.pi / 2.0) * one + sin(share * np.pi / 2.0) * other)
        way /= np.linalg.norm(way)
        found.append((float(way[0]) + 0.0, float(way[1]) + 0.0, 0.0))
    return tuple(found)


Run = tuple[FloatArray, float]
"""The way in which a wall runs back, a horizontal unit vector [2], and how far along it its wedge begins [m]."""


def _crack_of(where: str, number: int, definition: WedgedBlock, standing: Sequence[Solid]) -> Run:
    """Return how the wall of a wedge runs, and where: behind the face of what it runs back from."""
    walls = definition.wedges[number].walls
    own = _plan([solid for solid in standing if solid.name in walls])
    front = definition.in_front if not isinstance(definition, Corner) else definition.wedges[1 - number].walls
    others = _plan([solid for solid in standing if solid.name in front])
    if not len(own) or not len(others):
        raise GeometryError(f"{where}: wedges[{number + 1}]: its masonry is that of other bodies in `blocks`")
    along, across, length_over_thickness = _axes_of(own)
    if not isinstance(definition, Corner):
        if length_over_thickness < SQUAT:  # a buttress, which may be wider than it is deep
            along = max((along, across), key=lambda way: abs(float(way @ definition.along[:2])))
        if abs(float(along @ definition.along[:2])) < BACKWARDS:
            raise GeometryError(f"{where}: wedges[{number + 1}]: the wall does not run back from the one that falls")
    middles = [shapely.MultiPoint(points).convex_hull.centroid for points in (own, others)]
    way = np.array([middles[0].x - middles[1].x, middles[0].y - middles[1].y])
    run = along if float(way @ along) > 0.0 else -along
    return run, float((others @ run).max())


def _axes_of(plan: FloatArray) -> tuple[FloatArray, FloatArray, float]:
    """Return unit vectors along the sides of the least rectangle about a plan, the longer first; their ratio [-]."""
    corners = shapely.get_coordinates(shapely.minimum_rotated_rectangle(shapely.MultiPoint(plan)))
    sides = np.diff(corners[:3], axis=0)
    lengths = np.linalg.norm(sides, axis=1)
    first, second = (sides / lengths[:, None])[np.argsort(-lengths)]
    return first, second, float(lengths.max() / lengths.min())


def _plan(solids: Sequence[Solid]) -> FloatArray:
    return np.concatenate([np.empty((0, 2)), *(solid.vertices[:, :2] for solid in solids)])


def _foot_of(definition: WedgedBlock, standing: Sequence[Solid]) -> float:
    """Return the level of the foot: that of the cut, else where all that turns begins [m]."""
    if isinstance(definition.cut, float):
        return definition.cut
    groups = [definition.in_front] if definition.in_front else [wedge.walls for wedge in definition.wedges]
    low = [[float(s.vertices[:, 2].min()) for s in standing if s.name in group] for group in groups]
    return max(min(each) for each in low)


def _planes_of(wedge: Wedge, run: FloatArray, start: float, foot: float) -> list[Plane]:
    """Return the crack of a wedge and, where its reach ends, an upright plane; both face what moves."""
    crack = Plane(np.array([*(start * run), foot]), np.array([*(-cos(wedge.angle) * run), sin(wedge.angle)]))
    if wedge.reach is None:
        return [crack]
    return [crack, Plane(np.array([*((start + wedge.reach) * run), foot]), np.array([*-run, 0.0]))]


def left_behind(solids: Sequence[Solid]) -> list[Solid]:
    """Return what stays behind a crack under names of their own, as others that carry floors beside what moves."""
    return [_renamed((solid,), f"{solid.name}{BEHIND}") for solid in solids]


@keep_of_bodies
def _renamed(solids: tuple[Solid, ...], name: str) -> Solid:
    return replace(solids[0], name=name)


def front_of(
    solids: Sequence[Solid], plane: Plane, *, where: str
) -> tuple[Sequence[Solid], Sequence[Solid], Sequence[FloatArray]]:
    """Return what lies in front of a plane, what lies behind it, and the rings of the section between."""
    front, behind, rings = list[Solid](), list[Solid](), list[FloatArray]()
    for solid in solids:
        ahead = (solid.vertices - plane.point) @ plane.normal
        near = BASE_TOLERANCE * float(np.ptp(solid.vertices, axis=0).max())
        if ahead.min() >= -near:
            front.append(solid)
        elif ahead.max() <= near:
            behind.append(solid)
        else:
            parts = divide((solid,), plane, where=where)
            front += parts.above
            behind += parts.below
            rings += parts.section
    return front, behind, rings


def _require_outwards(where: str, definition: Corner, cracks: Sequence[Run]) -> None:
    """Raise MechanismError for a direction that is not between the outward ones of both walls."""
    if any(float(definition.along[:2] @ run) > INWARDS for run, _ in cracks):
        ways = " and ".join(f"[{-run[0] + 0.0:.3g}, {-run[1] + 0.0:.3g}, 0]" for run, _ in cracks)
        raise MechanismError(f"{where}: direction: turns into the building; give one between {ways}")
