"""Façades, corners and arches by closed formulas, with the friction of toothed side walls along their cracks.

The units that stay and those that move away rub on their beds: at the depth h - z the weight w (h - z) t_s presses on
overlaps l of one course in h_b, which adds up to F_0 = μ w t_s h^2 / 2 tan(β_b), at h / 3, with tan(β_b) = l / h_b. A
crack at an angle β meets F_0 (1 - tan(β) / tan(β_b)) of it: Szabó et al. 2023 (PSI 44:1342), after Casapulla 2021.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import atan, cos, sin, tan

import numpy as np

from assess.loads.load import Force, Load
from assess.mechanisms import partial_walls as plain
from assess.mechanisms.arch_in_plan import DEEPEST
from assess.mechanisms.chain import Chain, uplift_multiplier
from assess.mechanisms.least import Least, find_least
from assess.mechanisms.partial_walls import STEEPEST, CornerLoad
from spectra.arrays import FloatArray
from spectra.gravity import g

STATIONS = 7  # of each parameter of a search, on a grid
LOWEST = 0.1  # of the height of a wall: the least height of what turns


@dataclass(frozen=True, kw_only=True)
class SideWall(plain.SideWall):
    """A side wall and its bond: height of the units, how far one lies on the next, and the friction between them."""

    course: float = 0.0
    overlap: float = 0.0
    friction: float = 0.0

    @property
    def steepest(self) -> float:
        """The largest angle of a crack from the vertical [rad]: along the steps of the bond, 30 degrees in rubble."""
        return atan(self.overlap / self.course) if self.course > 0.0 else STEEPEST

    def toothing_friction(self, *, height: float, angle: float) -> float:
        """Return the friction along a crack [N]; it acts at a third of the height."""
        if not self.course > 0.0:
            return 0.0
        slope = self.overlap / self.course
        pressing = g * self.density * self.thickness * height**2 / 2.0
        return self.friction * pressing * max(slope - tan(angle), 0.0)


def corner(
    walls: tuple[SideWall, SideWall],
    *,
    top: float,
    height: float,
    angles: tuple[float, float],
    direction: float,
    loads: Sequence[CornerLoad] = (),
) -> Chain:
    """Return a corner whose toothing counts with the part of the motion along each wall."""
    chain = plain.corner(walls, top=top, height=height, angles=angles, direction=direction, loads=loads)
    at = (0.0, top - height + height / 3.0)
    rubbing = [
        Force(f"toothing {number}", (-wall.toothing_friction(height=height, angle=angle) * along, 0.0), at)
        for number, (wall, angle, along) in enumerate(zip(walls, angles, (cos(direction), sin(direction)), strict=True))
    ]
    return replace(chain, loads=(*chain.loads, *(each for each in rubbing if each.force[0] < 0.0)))


@dataclass(frozen=True, kw_only=True)
class UprightWall:
    """A façade of constant thickness: length, thickness, height [m], density [kg/m3]."""

    length: float
    thickness: float
    height: float
    density: float


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
    masonry = plain._box((-wall.thickness, 0.0), (0.0, wall.length), (base, wall.height), wall.density)
    wedges = [
        part
        for each in side_walls
        for part in plain._wedge(each, height=height, angle=angle, start=-wall.thickness, base=base, axis=0, middle=0.0)
    ]
    rubbing = [
        Force(
            f"toothing {number}", (-each.toothing_friction(height=height, angle=angle), 0.0), (0.0, base + height / 3.0)
        )
        for number, each in enumerate(side_walls, start=1)
        if each.friction > 0.0
    ]
    carried = tuple(load for load in loads if load.at[1] > base)
    return Chain((plain._seen([masonry, *wedges], (1.0, 0.0)),), ((0.0, base),), (*carried, *rubbing))


def least_facade_with_wedges(wall: UprightWall, side_walls: Sequence[SideWall], *, loads: Sequence[Load] = ()) -> Least:
    """Find the height and the angle of the cracks (height [m], angle [rad]) of the least multiplier of a façade."""
    steepest = min((each.steepest for each in side_walls), default=0.0)
    return find_least(
        lambda at: uplift_multiplier(facade_with_wedges(wall, side_walls, height=at[0], angle=at[1], loads=loads)),
        bounds=((LOWEST * wall.height, wall.height), (0.0, steepest)),
        stations=(2 * STATIONS, STATIONS),
    )


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
    """
    thrust = min(strength * DEEPEST * thickness * height, *ends)
    rise = thickness - thrust / (strength * height)
    moved = np.linspace(0.0, rise, 101)
    left = rise - moved
    chord = (span / 2.0) ** 2 + rise**2
    capacity = 4.0 * thrust * left / (weight * np.sqrt(chord - left**2))
    moved.flags.writeable = capacity.flags.writeable = False
    return HorizontalArch(weight, span, thrust, rise, float(capacity[0]), moved, capacity)
