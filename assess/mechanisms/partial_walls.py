r"""The corner of two walls by boxes and triangles, as the search for its least multiplier tries it.

        +----------+---+           a crack rises at an angle β from the vertical; the wedge in front of it begins at the
         \  wedge  |   |           inner face of the other wall
          \        |   |  -->
           \  β    |   |           weight of a wedge    t_s w h^2 tan(β) / 2, at h tan(β) / 3 behind the inner face
            \      |   |                                                      and 2 h / 3 above the hinge
             +----+---A

A corner takes a wedge of both its walls and turns about its foot, over any direction between the two outward ones.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import cos, inf, radians, sin, tan

import numpy as np

from assess.loads.load import Force, Load, PointMass
from assess.mechanisms.chain import Chain, RigidBlock

STEEPEST = radians(30.0)  # of a crack in rubble, from the vertical


@dataclass(frozen=True, kw_only=True)
class SideWall:
    """A wall that runs back from a corner.

    thickness [m]; density [kg/m3]
    reach : from the inner face of the other wall to an opening or a cross wall, where a wedge stops [m]
    """

    thickness: float
    density: float
    reach: float = inf


@dataclass(frozen=True, kw_only=True)
class CornerLoad:
    """What stands on a corner: mass [kg], where it stands (x, y, z) [m], its thrust (x, y) [N]."""

    name: str
    at: tuple[float, float, float]
    mass: float = 0.0
    thrust: tuple[float, float] = (0.0, 0.0)


def corner(
    walls: tuple[SideWall, SideWall],
    *,
    top: float,
    height: float,
    angles: tuple[float, float],
    direction: float,
    loads: Sequence[CornerLoad] = (),
) -> Chain:
    """Return the corner of two walls that turns outwards about its foot, in the vertical plane of a direction.

    The outer edge of the corner is at x = y = 0. The first wall runs back along -x with its outer face at y = 0, the
    second along -y with its outer face at x = 0.

    Parameters
    ----------
    walls : the two, as they run back from the corner
    top : elevation of their top over the foot of the corner [m]
    height : of what turns, from the top down [m]
    angles : of the crack in each wall, from the vertical [rad]
    direction : from +x to +y, in [0, π/2] [rad]
    loads : on the corner
    """
    first, second = walls
    along, base = (cos(direction), sin(direction)), top - height
    column = _box(
        (-second.thickness, 0.0), (-first.thickness, 0.0), (base, top), (first.density + second.density) / 2.0
    )
    parts = [column]
    for axis, (wall, other, angle) in enumerate(((first, second, angles[0]), (second, first, angles[1]))):
        parts += _wedge(
            wall,
            height=height,
            angle=angle,
            start=-other.thickness,
            base=base,
            axis=axis,
            middle=-wall.thickness / 2.0,
        )
    carried: list[Load] = []
    for each in loads:
        at = (each.at[0] * along[0] + each.at[1] * along[1], each.at[2])
        push = each.thrust[0] * along[0] + each.thrust[1] * along[1]
        if each.at[2] <= base:
            continue
        if each.mass > 0.0:
            carried.append(PointMass(each.name, each.mass, at, True))
        if push != 0.0:
            carried.append(Force(f"{each.name}, thrust", (push, 0.0), at))
    return Chain((_seen(parts, along),), ((0.0, base),), tuple(carried))


@dataclass(frozen=True)
class _Part:
    """Masonry in space: mass [kg], negative for what is missing; centroid [3] [m]; variance along the axes [3] [m2]."""

    mass: float
    centroid: tuple[float, float, float]
    variance: tuple[float, float, float]


def _box(x: tuple[float, float], y: tuple[float, float], z: tuple[float, float], density: float) -> _Part:
    """Return an upright box between two x, two y and two z [m]."""
    sides = np.diff([x, y, z])[:, 0]
    middle = np.mean([x, y, z], axis=1)
    return _Part(density * float(sides.prod()), tuple(middle.tolist()), tuple((sides**2 / 12.0).tolist()))


def _wedge(
    wall: SideWall, *, height: float, angle: float, start: float, base: float, axis: int, middle: float
) -> tuple[_Part, ...]:
    """Return the wedge of a wall that runs back along -x (axis 0) or -y (axis 1): a triangle less what it lacks.

    start : where it begins along the axis; base : elevation of its point; middle : of the wall across [m]
    """
    slope = tan(angle)
    if slope <= 0.0:
        return ()
    whole = _triangle(wall, height, slope, start, base, axis, middle)
    beyond = height - wall.reach / slope
    if beyond <= 0.0:
        return (whole,)
    missing = _triangle(wall, beyond, slope, start - wall.reach, base + height - beyond, axis, middle)
    return (whole, _Part(-missing.mass, missing.centroid, missing.variance))


def _triangle(
    wall: SideWall, height: float, slope: float, start: float, base: float, axis: int, middle: float
) -> _Part:
    width = height * slope
    along, across = start - width / 3.0, middle
    spread_along, spread_across = width**2 / 18.0, wall.thickness**2 / 12.0
    plan, spread = ((along, across), (spread_along, spread_across))
    if axis == 1:
        plan, spread = plan[::-1], spread[::-1]
    mass = wall.density * wall.thickness * width * height / 2.0
    return _Part(mass, (*plan, base + 2.0 * height / 3.0), (*spread, height**2 / 18.0))


def _seen(parts: Sequence[_Part], along: tuple[float, float]) -> RigidBlock:
    """Return parts that move as one in the vertical plane of a direction: mass, centroid, inertia about it."""
    mass = np.array([part.mass for part in parts])
    centroid, variance = np.array([part.centroid for part in parts]), np.array([part.variance for part in parts])
    x, z = centroid[:, :2] @ np.array(along), centroid[:, 2]
    total = mass.sum()
    middle = (float(mass @ x / total), float(mass @ z / total))
    own = variance[:, :2] @ np.array(along) ** 2 + variance[:, 2]
    inertia = float(mass @ (own + (x - middle[0]) ** 2 + (z - middle[1]) ** 2))
    return RigidBlock(float(total), middle, inertia)
