"""Panels of walls between cross walls, with the thrust that they are left with as arches in plan."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from assess.errors import FallingError, MechanismError
from assess.geometry.cut import Piece, Plane, level_plane
from assess.geometry.planar import join_bodies, lowest_corners, planar_body
from assess.geometry.solid import Solid
from assess.geometry.surface import volume
from assess.mechanisms.arch_in_plan import (
    DEEPEST,
    HorizontalArch,
    along_wall,
    build_horizontal_arch,
    thrust_held_beyond,
)
from assess.mechanisms.assembly import MechanismPieces
from assess.model.bodies import LEAST_STRENGTH, Bodies, materials_of, solids_to_cut
from assess.model.loading import loads_of
from assess.model.wedges import front_of, left_behind
from spectra.arrays import FloatArray
from spectra.gravity import g

SLICES = 16  # of a panel along the wall: the least of them is its weakest section


def arch_of_panel(name: str, definition: HorizontalArch, bodies: Bodies) -> MechanismPieces:
    """Build the arch of a panel between the inner faces of two cross walls.

    Raises
    ------
    MechanismError : a cross wall is not known or leaves no span, or nothing holds an end
    GeometryError : a body has no geometry
    """
    where, run = f'mechanism "{name}"', along_wall(definition)
    standing: Sequence[Solid] = solids_to_cut(name, definition.blocks[0], bodies)
    fixed: list[Solid] = []
    if isinstance(definition.cut, float):
        standing, below, _ = front_of(standing, level_plane(definition.cut), where=f"{where}: cut")
        fixed += below
    walls = _cross_walls(where, definition, bodies, run)
    (near, start), (end, far) = walls
    onwards, first = _part(standing, run, start, where)
    panel, last = _part(onwards, -run, -end, where)
    fixed += left_behind((*first, *last))
    if not panel:
        raise MechanismError(f"{where}: between: nothing of the wall lies between them above the cut; name others")
    corners = np.concatenate([solid.vertices for solid in panel])
    thickness, height = float(np.ptp(corners @ definition.along)), float(np.ptp(corners[:, 2]))
    solid_height = _least_section(panel, run, (start, end), where) / thickness
    strength = definition.strength or LEAST_STRENGTH
    beyond = (_part(standing, -run, -near, where)[0], _part(standing, run, far, where)[0])
    ends = definition.ends or _end_thrusts(where, definition, beyond, bodies, run, lever=height)
    thrust = min(strength * DEEPEST * thickness * solid_height, *ends)
    whole = Piece(
        join_bodies([planar_body(solid, direction=definition.towards) for solid in panel]),
        tuple(panel),
        lowest_corners(panel),
        True,
        fixed=tuple(fixed),
    )
    loads = loads_of(name, definition, (whole,), bodies)
    back, ahead = _part(panel, -run, -(start + end) / 2.0, where)
    halves = tuple(
        Piece(
            join_bodies([planar_body(solid, direction=definition.towards) for solid in half]),
            tuple(half),
            lowest_corners(half),
            True,
            fixed=tuple(fixed) if number == 0 else (),
        )
        for number, half in enumerate((back, ahead))
    )
    return build_horizontal_arch(
        name, definition, halves, loads=loads.loads, thrust=thrust, depth=thrust / (strength * solid_height)
    )


Faces = tuple[tuple[float, float], tuple[float, float]]
"""Of both cross walls, the least and the largest place along the wall [m]."""


def _cross_walls(where: str, definition: HorizontalArch, bodies: Bodies, run: FloatArray) -> Faces:
    places = []
    for wall in definition.between:
        if wall not in bodies:
            raise MechanismError(f'{where}: between: "{wall}" is no body; known: {", ".join(bodies)}')
        solid = bodies[wall].solid
        if solid is None:
            raise MechanismError(f'{where}: between: "{wall}" has no geometry; give it a mesh, box or profile')
        along = solid.vertices @ run
        places.append((float(along.min()), float(along.max())))
    one, other = sorted(places)
    if one[1] >= other[0]:
        raise MechanismError(
            f"{where}: between: no span is left between them, as one reaches to {one[1]:.4g} m along the wall and the "
            f"other begins at {other[0]:.4g} m; name two cross walls that stand apart"
        )
    return one, other


def _part(
    solids: Sequence[Solid], normal: FloatArray, place: float, where: str
) -> tuple[Sequence[Solid], Sequence[Solid]]:
    """Return what lies beyond a place along a horizontal unit vector [m], and what lies before it."""
    front, behind, _ = front_of(solids, Plane(place * normal, normal), where=f"{where}: between")
    return front, behind


def _least_section(panel: Sequence[Solid], run: FloatArray, span: tuple[float, float], where: str) -> float:
    """Return the least area of a panel across its wall, by slices [m2]: openings take of it."""
    left, areas = panel, []
    places = np.linspace(*span, SLICES + 1)
    for place in places[1:-1].tolist():
        left, cut_off = _part(left, run, place, where)
        areas.append(_volume(cut_off))
    return min(*areas, _volume(left)) / float(places[1] - places[0])


def _volume(solids: Sequence[Solid]) -> float:
    return sum(volume(solid.vertices, solid.triangles) for solid in solids)


def _end_thrusts(
    where: str,
    definition: HorizontalArch,
    beyond: Sequence[Sequence[Solid]],
    bodies: Bodies,
    run: FloatArray,
    *,
    lever: float,
) -> tuple[float, ...]:
    """Return the thrust that the masonry of the wall beyond each cross wall holds [N]."""
    given = [material.friction for material in materials_of(definition.bodies, bodies)]
    friction = min((each for each in given if each is not None), default=None) if None not in given else None
    found = []
    for part in beyond:
        if not part:
            raise FallingError(  # no thrust, no arch: also where thrusts that no source vouches for are left out
                f"{where}: ends: nothing of the wall lies beyond a cross wall to hold the thrust of an arch; give what "
                'each end holds, as of a tie, like ["20 kN", "20 kN"]'
            )
        places = np.concatenate([solid.vertices for solid in part]) @ run
        weight = g * sum(solid.mass for solid in part)
        found.append(thrust_held_beyond(weight=weight, length=float(np.ptp(places)), lever=lever, friction=friction))
    return tuple(found)
