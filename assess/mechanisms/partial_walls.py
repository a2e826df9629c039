r"""Parts of walls that fail together: a façade with wedges of its side walls, a corner, an arch between cross walls.

A façade takes with it, of each side wall, the wedge in front of a crack that rises at an angle β from the vertical:

        +----------+---+           x = 0 at the outer face, where the hinge A is; the wedge begins at the inner face
         \  wedge  |   |
          \        |   |  -->      weight of a wedge    t_s w h^2 tan(β) / 2, at h tan(β) / 3 behind the inner face
           \  β    |   |                                                      and 2 h / 3 above the hinge
            \      |   |           toothing             F_0 = μ w t_s h^2 / 2 tan(β_b), at h / 3; tan(β_b) = l / h_b
             \     |   |           along the crack      F_0 (1 - tan(β) / tan(β_b))
              +----+---A

The units that stay and those that move away rub on their beds: at the depth h - z the weight w (h - z) t_s presses on
overlaps l of one course in h_b, which adds up to F_0; a crack along the steps of the bond, at β_b, meets none of them.
A corner takes a wedge of both its walls and turns about its foot, over any direction between the two outward ones.

The multiplier of an arch between cross walls follows from the virtual work of its thrust H at the ends, which move
apart by 4 r δ / L where the middle moves out by δ, and the weight W by δ / 2: α_0 = 8 H r / (W L).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import atan, cos, inf, radians, sin, tan

import numpy as np

from assess.errors import MechanismError
from assess.loads.load import Force, Load, PointMass
from assess.mechanisms.chain import Chain, RigidBlock, uplift_multiplier
from assess.mechanisms.least import Least, find_least
from spectra.arrays import FloatArray
from spectra.gravity import g

STEEPEST = radians(30.0)  # of a crack in rubble, from the vertical
STATIONS = 7  # of each parameter of a search, on a grid
LOWEST = 0.1  # of the height of a wall: the least height of what turns


@dataclass(frozen=True, kw_only=True)
class SideWall:
    """A wall that runs back from a façade or a corner.

    thickness [m]; density [kg/m3]
    reach : from the inner face of the façade to an opening or a cross wall, where a wedge stops [m]
    course, overlap : height of the units, and length over which one lies on the next in the bond [m]; 0 for rubble
    friction : between them [-]; 0 where nothing is known of the bond
    """

    thickness: float
    density: float
    reach: float = inf
    course: float = 0.0
    overlap: float = 0.0
    friction: float = 0.0

    @property
    def steepest(self) -> float:
        """The largest angle of a crack from the vertical [rad]: along the steps of the bond, 30 degrees in rubble."""
        return atan(self.overlap / self.course) if self.course > 0.0 else STEEPEST

    def toothing_friction(self, *, height: float, angle: float) -> float:
        """Return the friction along a crack [N]; it acts at a third of the height.

        F_0 (1 - tan β / tan β_b): Szabó et al. 2023 (PSI 44:1342), after Casapulla et al. 2021.
        """
        if not self.course > 0.0:
            return 0.0
        slope = self.overlap / self.course
        pressing = g * self.density * self.thickness * height**2 / 2.0
        return self.friction * pressing * max(slope - tan(angle), 0.0)


@dataclass(frozen=True, kw_only=True)
class UprightWall:
    """A façade of constant thickness: length, thickness, height [m], density [kg/m3]."""

    length: float
    thickness: float
    height: float
    density: float


@dataclass(frozen=True, kw_only=True)
class CornerLoad:
    """What stands on a corner: mass [kg], where it stands (x, y, z) [m], its thrust (x, y) [N]."""

    name: str
    at: tuple[float, float, float]
    mass: float = 0.0
    thrust: tuple[float, float] = (0.0, 0.0)


def facade_with_wedges(
    wall: UprightWall, side_walls: Sequence[SideWall], *, height: float, angle: float, loads: Sequence[Load] = ()
) -> Chain:
    """Return the upper part of a façade that turns outwards with a wedge of each side wall.

    Parameters
    ----------
    wall : the façade, whose outer face is at x = 0 and whose foot at z = 0
    side_walls : those that run back from it
    height : of what turns, from its top down [m]
    angle : of the cracks from the vertical, at most that of each bond [rad]
    loads : on the wall, in the plane of motion; those below what turns are left out
    """
    base = wall.height - height
    masonry = _box((-wall.thickness, 0.0), (0.0, wall.length), (base, wall.height), wall.density)
    wedges = [
        part
        for each in side_walls
        for part in _wedge(each, height=height, angle=angle, start=-wall.thickness, base=base, axis=0, middle=0.0)
    ]
    rubbing = [
        Force(
            f"toothing {number}", (-each.toothing_friction(height=height, angle=angle), 0.0), (0.0, base + height / 3.0)
        )
        for number, each in enumerate(side_walls, start=1)
        if each.friction > 0.0
    ]
    carried = tuple(load for load in loads if load.at[1] > base)
    return Chain((_seen([masonry, *wedges], (1.0, 0.0)),), ((0.0, base),), (*carried, *rubbing))


def least_facade_with_wedges(wall: UprightWall, side_walls: Sequence[SideWall], *, loads: Sequence[Load] = ()) -> Least:
    """Find the height and the angle of the cracks (height [m], angle [rad]) of the least multiplier of a façade."""
    steepest = min((each.steepest for each in side_walls), default=0.0)
    return find_least(
        lambda at: uplift_multiplier(facade_with_wedges(wall, side_walls, height=at[0], angle=at[1], loads=loads)),
        bounds=((LOWEST * wall.height, wall.height), (0.0, steepest)),
        stations=(2 * STATIONS, STATIONS),
    )


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
    second along -y with its outer face at x = 0. Toothing counts only with the part of the motion along its wall.

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
    rubbing: list[Load] = []
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
        rub = wall.toothing_friction(height=height, angle=angle) * along[axis]
        if rub > 0.0:
            rubbing.append(Force(f"toothing {axis + 1}", (-rub, 0.0), (0.0, base + height / 3.0)))
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
    return Chain((_seen(parts, along),), ((0.0, base),), (*carried, *rubbing))


def least_corner(walls: tuple[SideWall, SideWall], *, top: float, loads: Sequence[CornerLoad] = ()) -> Least:
    """Find (height [m], angles of both cracks [rad], direction [rad]) of the least multiplier of a corner.

    What resists and what drives vary with the direction as A cos(θ) + B sin(θ): where both resist, the least lies at
    an end, and the corner turns with one of its walls; between lies the least of a corner that thrusts push over.
    """
    return find_least(
        lambda at: uplift_multiplier(
            corner(walls, top=top, height=at[0], angles=(at[1], at[2]), direction=at[3], loads=loads)
        ),
        bounds=((LOWEST * top, top), (0.0, walls[0].steepest), (0.0, walls[1].steepest), (0.0, np.pi / 2.0)),
        stations=(STATIONS, 4, 4, 4),
    )


DEEPEST = 0.1  # of the thickness: depth of an arch within a wall (EN 1996-1-1 6.3.2)


@dataclass(frozen=True)
class HorizontalArch:
    """A panel that bulges out between two cross walls: upright hinges at its ends and its middle.

    weight W [N]; span L [m]; thrust H [N]; rise r [m], between the resultants at the ends and in the middle
    multiplier : α_0 = 8 H r / (W L) [-]; 0 where an end holds nothing
    displacement, capacity : that of the middle [n] [m], from 0 to r where the thrust is lost, and α there [n] [-]
    """

    weight: float
    span: float
    thrust: float
    rise: float
    multiplier: float
    displacement: FloatArray
    capacity: FloatArray


def horizontal_arch(
    *, weight: float, span: float, thickness: float, height: float, ends: tuple[float, float], strength: float
) -> HorizontalArch:
    """Return the arch that forms in a panel between cross walls.

    With l^2 = (L/2)^2 + r^2 the ends stand sqrt(l^2 - (r - d)^2) from the middle once it has moved out by d, so that
    α(d) = 4 H (r - d) / (W sqrt(l^2 - (r - d)^2)). An end that yields by u lowers the rise by u L / (2 r).

    Parameters
    ----------
    weight : of the panel and of what moves with it [N]
    span : clear, between cross walls [m]
    thickness, height : of the panel [m]
    ends : thrust that each end holds [N]: that of the masonry beyond it or of a tie, 0 where there is neither
    strength : of the masonry along the wall, f_d [Pa]

    Raises
    ------
    MechanismError : a size, the weight or the strength is not positive, or an end holds less than nothing
    """
    given = {"weight": weight, "span": span, "thickness": thickness, "height": height, "strength": strength}
    for name, value in given.items():
        if not value > 0.0:
            raise MechanismError(f"horizontal arch: {name} = {value:.4g}: give a number above 0")
    if min(ends) < 0.0:
        raise MechanismError(f"horizontal arch: ends = {min(ends):.4g} N: give 0 where an end holds nothing")
    thrust = min(strength * DEEPEST * thickness * height, *ends)
    rise = thickness - thrust / (strength * height)
    moved = np.linspace(0.0, rise, 101)
    left = rise - moved
    chord = (span / 2.0) ** 2 + rise**2
    capacity = 4.0 * thrust * left / (weight * np.sqrt(chord - left**2))
    moved.flags.writeable = capacity.flags.writeable = False
    return HorizontalArch(weight, span, thrust, rise, float(capacity[0]), moved, capacity)


def thrust_held_beyond(*, weight: float, length: float, lever: float, friction: float | None = None) -> float:
    """Return the thrust that the masonry beyond an end of an arch holds [N]: until it rocks in its plane, or slides.

    Parameters
    ----------
    weight : of the wall beyond the end and of what it carries [N]
    length : of that wall in plan [m]
    lever : of the thrust over its foot [m]
    friction : at its foot [-]; None where it is not known
    """
    rocking = weight * length / (2.0 * lever)
    return rocking if friction is None else min(rocking, friction * weight)


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
