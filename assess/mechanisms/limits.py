"""Rotations at which actions of a mechanism end and floors lose their seats, and how high the mechanism is held."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import inf
from typing import Literal

import numpy as np

from assess.loads.load import PointMass, Tie, lasts
from assess.mechanisms.actions import ChainActions
from assess.mechanisms.ends import scan_rotations, travel_on_seat, unseating_rotation
from assess.mechanisms.mechanism import Mechanism
from assess.oscillator import Oscillator
from spectra.arrays import FloatArray

Kind = Literal["break", "seat"]
BranchName = Literal["positive", "negative"]

SAME = 1e-9  # of a rotation: a jump of a table this near an end is that end
BRANCHES: tuple[BranchName, BranchName] = ("positive", "negative")


@dataclass(frozen=True)
class Limit:
    """A rotation of a branch [rad], counted as its table: an action ends ("break"), or a load loses its seat ("seat").

    what : name of the load
    """

    kind: Kind
    what: str
    branch: BranchName
    rotation: float


def limits(mechanism: Mechanism) -> tuple[Limit, ...]:
    """Return where resisting actions end and loads lose their seats, on the branches of the breaking variant."""
    rocker = mechanism.variants.breaking
    return () if rocker is None else tuple(_limits(rocker, mechanism.actions))


def _limits(rocker: Oscillator, acting: Sequence[ChainActions]) -> Iterator[Limit]:
    """Yield the limits of each branch of an oscillator."""
    sides = zip(acting, rocker.branches, BRANCHES, rocker.equilibria, strict=False)
    for one, branch, name, rest in sides:
        jumps = branch.rotation[1:][np.diff(branch.rotation) == 0.0]
        ends = [(k, end - rest) for k, end in enumerate(one.ends) if 0.0 < end < inf and one.resists_at(k, end)]
        found = [Limit("break", one.actions[k].name, name, end) for k, end in ends if _among(end, jumps)]
        masses = [load for load in one.chain.loads if isinstance(load, PointMass) and load.bearing]
        found += [Limit("seat", mass.name, name, unseating_rotation(one.chain, mass) - rest) for mass in masses]
        yield from (limit for limit in found if limit.rotation <= branch.rotation[-1])


def _among(rotation: float, jumps: FloatArray) -> bool:
    """Return whether a table jumps at a rotation [rad]; jumps : of the table [n]."""
    return bool(np.isclose(jumps, rotation, rtol=SAME, atol=0.0).any())


@dataclass(frozen=True)
class SeatTravel:
    """How far the point of a load moves on its seat [m] over the rotation of a branch, counted as its table [rad] [n].

    what : name of the load
    """

    what: str
    branch: BranchName
    rotation: FloatArray
    travel: FloatArray


def open_seats(mechanism: Mechanism) -> tuple[SeatTravel, ...]:
    """Return the movement of each bearing mass (floor, beam) whose length of seat is not given, in each branch."""
    return tuple(_open_seats(mechanism))


def _open_seats(mechanism: Mechanism) -> Iterator[SeatTravel]:
    rocker = mechanism.variants.deciding
    chains = [chain for chain in (mechanism.positive, mechanism.negative) if chain is not None]
    for chain, name, rest in zip(chains, BRANCHES, rocker.equilibria, strict=False):
        for mass in (each for each in chain.loads if isinstance(each, PointMass) and each.bearing):
            if mass.seat is None:
                rotation = scan_rotations(chain)
                yield SeatTravel(mass.name, name, rotation - rest, travel_on_seat(chain, mass, rotation))


def height_of_support(mechanism: Mechanism) -> float:
    """Return the height of the far support or of a lasting tie above the base [m]; 0 without either."""
    return held_above(mechanism) if mechanism.kind == "single-block" else mechanism.rise


def held_above(mechanism: Mechanism) -> float:
    """Return the height of the highest tie that holds the mechanism above the base hinge [m]; 0 without ties.

    A tie counts if it is shown to last or its end is given: it stiffens the curve up to there.
    """
    heights = [
        action.at[1] - one.chain.hinges[0][1]
        for one in mechanism.actions
        for number, action in enumerate(one.actions)
        if isinstance(action, Tie)
        and one.resists_at(number, 0.0)
        and (lasts(action) or isinstance(action.until, float))
    ]
    return max(heights, default=0.0)
