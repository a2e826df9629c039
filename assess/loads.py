"""What a block carries or is pulled by besides itself: point masses, given forces, ties.

Places and forces are in the plane of motion, (distance along the direction, elevation); a load is fixed to its block.
`source` says in a sentence how a load was found; it is empty where the user gave its numbers.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import hypot

from scipy.constants import g

Point = tuple[float, float]


@dataclass(frozen=True)
class PointMass:
    """A floor, roof or wall that moves with the block at one point.

    mass [kg]; bearing: the block carries its weight, and it shares all its motion; not bearing: its weight is carried
    elsewhere, and only its horizontal inertia acts on the block (thesis 3.2.2, M_i and M_j).
    """

    name: str
    mass: float
    at: Point
    bearing: bool
    block: int = 0
    source: str = ""


@dataclass(frozen=True)
class Force:
    """A dead force (x, z) [N] of constant size and direction: the thrust of a vault or roof."""

    name: str
    force: Point
    at: Point
    block: int = 0
    source: str = ""


@dataclass(frozen=True)
class Tie:
    """A tie of constant pretension `pull` [N] along `direction` (a unit vector), or always towards `anchor`.

    It is slack on the branch where it shortens, unless `both`.
    """

    name: str
    pull: float
    at: Point
    direction: Point | None = None
    anchor: Point | None = None
    both: bool = False
    block: int = 0
    source: str = ""


Load = PointMass | Force | Tie


def pull_at_rest(tie: Tie) -> Point:
    """The force (x, z) [N] of a taut tie before anything moves."""
    if tie.anchor is None:
        along, up = tie.direction or (0.0, 0.0)
        return (tie.pull * along, tie.pull * up)
    to_x, to_z = tie.anchor[0] - tie.at[0], tie.anchor[1] - tie.at[1]
    length = hypot(to_x, to_z)
    return (tie.pull * to_x / length, tie.pull * to_z / length)


def upward(load: Load) -> float:
    """The vertical force of a load at rest, up [N]."""
    if isinstance(load, PointMass):
        return -g * load.mass * load.bearing
    return (load.force if isinstance(load, Force) else pull_at_rest(load))[1]


def mirrored(load: Load) -> Load:
    """The load as the negative branch sees it."""
    at = _mirrored(load.at)
    if isinstance(load, PointMass):
        return replace(load, at=at)
    if isinstance(load, Force):
        return replace(load, at=at, force=_mirrored(load.force))
    return replace(
        load,
        at=at,
        direction=None if load.direction is None else _mirrored(load.direction),
        anchor=None if load.anchor is None else _mirrored(load.anchor),
    )


def _mirrored(vector: Point) -> Point:
    return (-vector[0], vector[1])
