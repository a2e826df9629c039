"""A mechanism by what is shown of its ties and forces: as it starts, as they break, and as it collapses.

    starting     every action that is there at rest: multipliers
    breaking     each up to its end; one that nobody shows to last does not resist: the acceleration on the curve
    collapse     only what is shown to be there up to collapse resists: displacements and histories

A force or tie that drives never leaves. A tie that would break before the mechanism collapses is no part of the curve
of collapse: once gone it does not come back as the mechanism returns. Source: Circolare 7/2019, C8.7.1.2.1.6.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from math import inf
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from assess.errors import InterfaceError, MechanismError
from assess.loads.load import Action, Force, PointMass, Tie, lasts
from assess.mechanisms.chain import Chain
from assess.mechanisms.ends import end_of, unseating_rotation
from assess.mechanisms.flexible_table import flexible_moments
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.oscillation import make_oscillator, oscillator
from assess.mechanisms.stages import (
    Moments,
    Signature,
    Stage,
    Stages,
    actions_of,
    divide_into_stages,
    rigid_moments,
    signature,
    single_stage,
)
from assess.mechanisms.table import staged_branch
from assess.mechanisms.virtual_work import virtual_work
from assess.oscillator import Branch, Oscillator

Kind = Literal["break", "seat"]
BranchName = Literal["positive", "negative"]

CLEARLY = 1.0 + 1e-6  # two rotations that differ by less are one
SAME = 1e-9  # of a rotation: an end this near overturning comes with it
BRANCHES: tuple[BranchName, BranchName] = ("positive", "negative")


@dataclass(frozen=True)
class Variants:
    """The oscillators of a mechanism, one object where they are the same.

    breaking, collapse : None where the mechanism falls at rest without what is not shown to last
    standing_by : names of the actions that it then stands by; empty where it stands without them
    ends : up to where each action of each chain resists on the way to collapse [rad]; 0 where it does not last
    """

    starting: Oscillator
    breaking: Oscillator | None
    collapse: Oscillator | None
    standing_by: tuple[str, ...]
    ends: tuple[tuple[float, ...], ...]

    @property
    def deciding(self) -> Oscillator:
        """What displacements and histories are asked of; the mechanism as it starts where it cannot stand otherwise."""
        return self.starting if self.collapse is None else self.collapse


@dataclass(frozen=True)
class Limit:
    """A rotation of a branch, as the branch counts [rad]: an action ends ("break"), or a load loses its seat ("seat").

    what : the load, by its name
    """

    kind: Kind
    what: str
    branch: BranchName
    rotation: float


@dataclass(frozen=True)
class ChainActions:
    """A chain with the moments of its actions, and the rotation up to which each is shown to be there [rad]."""

    chain: Chain
    moments: Moments
    ends: tuple[float, ...]

    @property
    def actions(self) -> tuple[Action, ...]:
        """The forces and ties on the chain."""
        return actions_of(self.chain)

    @property
    def lasting(self) -> tuple[float, ...]:
        """The same ends of those that are shown to last, 0 of the others."""
        return tuple(end if lasts(each) else 0.0 for each, end in zip(self.actions, self.ends, strict=True))

    @property
    def thrusts(self) -> tuple[Force, ...]:
        """The forces that drive the chain at rest."""
        at_rest = self.moments.of(np.zeros(1))[:, 0] if self.ends else ()
        forces = zip(self.actions, at_rest, strict=True)
        return tuple(each for each, moment in forces if isinstance(each, Force) and moment > 0.0)

    def up_to(self, ends: Sequence[float]) -> Stages:
        """The chain with its actions up to given ends [rad]."""
        return divide_into_stages(self.chain, ends, self.moments)

    def ever_resists(self, number: int) -> bool:
        """Whether an action, by its number, resists at any rotation."""
        return bool((self.moments.of(self.moments.scan)[number] < 0.0).any())

    def resists_at(self, number: int, rotation: float) -> bool:
        """Whether an action, by its number, resists at a rotation [rad]."""
        return bool(self.moments.of(np.array([rotation]))[number, 0] < 0.0)


@lru_cache(maxsize=256)
def variants(mechanism: Mechanism) -> Variants:
    """The oscillators of a mechanism, each found once."""
    starting, acting = oscillator(mechanism), acting_of(mechanism)
    known: dict[tuple[Signature, ...], Oscillator | None] = {
        tuple(signature(single_stage(each.chain)) for each in acting): starting
    }

    def of(sides: Sequence[Stages]) -> Oscillator | None:
        key = tuple(map(signature, sides))
        if key not in known:
            known[key] = _standing(mechanism, sides)
        return known[key]

    def no_later(sides: Sequence[Stages]) -> Oscillator | None:
        """Keep what crushes a joint by its weight, without which the mechanism would fall later than it starts to."""
        made = of(sides)
        later = (
            [False]
            if made is None
            else [
                a > b * CLEARLY
                for a, b in zip(overturning_rotations(made), overturning_rotations(starting), strict=True)
            ]
        )
        if not any(later):
            return made
        return of([single_stage(one.chain) if on else side for one, on, side in zip(acting, later, sides, strict=True)])

    breaking = no_later([each.up_to(each.ends) for each in acting])
    ends = [each.lasting for each in acting]
    sides = [each.up_to(each.lasting) for each in acting]
    collapse = no_later(sides)
    if collapse is not None:
        ends = [_kept(each, fall) for each, fall in zip(acting, overturning_rotations(collapse), strict=True)]
        sides = [each.up_to(kept) for each, kept in zip(acting, ends, strict=True)]
        collapse = no_later(sides)
    if collapse is not None and (breaking is None or _falls_before(breaking, collapse)):
        breaking = collapse
    missing = () if collapse is not None else _standing_by(acting, sides)
    return Variants(starting, breaking, collapse, missing, tuple(ends))


def overturning_rotations(rocker: Oscillator) -> tuple[float, ...]:
    """Where each branch of an oscillator overturns, counted from the geometry [rad]."""
    sides = zip(rocker.branches, equilibria(rocker), strict=False)
    return tuple(branch.unstable + rest for branch, rest in sides)


def _falls_before(one: Oscillator, other: Oscillator) -> bool:
    """Whether a mechanism first falls at a smaller rotation than another of its variants.

    On soft joints one that loses a tie may fall over to where it stands without: then the curve without it is taken.
    """
    return any(
        first < then * (1.0 - SAME)
        for first, then in zip(overturning_rotations(one), overturning_rotations(other), strict=True)
    )


def collapse_branch(chain: Chain, *, name: str) -> Branch:
    """The table of a chain on rigid hinges with what is shown to last to collapse, and what drives; no restitution.

    Raises MechanismError for one that never overturns, FallingError for one that falls, or stands by the rest alone.
    """
    rigid = replace(chain, joints=())
    end = float(staged_branch(single_stage(rigid), restitution=0.0, name=name).rotation[-1])
    acting = _acting(rigid, name=name, end=end)
    found = staged_branch(acting.up_to(acting.lasting), restitution=0.0, name=name)
    return staged_branch(acting.up_to(_kept(acting, found.overturning)), restitution=0.0, name=name)


def equilibria(rocker: Oscillator) -> tuple[float, float]:
    """Where each branch of an oscillator counts from [rad]."""
    return rocker.equilibrium, rocker.equilibrium_negative


def limits(mechanism: Mechanism) -> tuple[Limit, ...]:
    """Where actions that resist end and loads lose their seats, on the branches as the mechanism breaks."""
    rocker = variants(mechanism).breaking
    return () if rocker is None else tuple(_limits(rocker, acting_of(mechanism)))


def _limits(rocker: Oscillator, acting: Sequence[ChainActions]) -> Iterator[Limit]:
    sides = zip(acting, rocker.branches, BRANCHES, equilibria(rocker), strict=False)
    for one, branch, name, rest in sides:
        jumps = branch.rotation[1:][np.diff(branch.rotation) == 0.0]
        ends = [(k, end - rest) for k, end in enumerate(one.ends) if 0.0 < end < inf and one.resists_at(k, end)]
        found = [Limit("break", one.actions[k].name, name, end) for k, end in ends if _among(end, jumps)]
        masses = [load for load in one.chain.loads if isinstance(load, PointMass) and load.bearing]
        found += [Limit("seat", mass.name, name, unseating_rotation(one.chain, mass) - rest) for mass in masses]
        yield from (limit for limit in found if limit.rotation <= branch.rotation[-1])


def _among(rotation: float, jumps: NDArray[np.float64]) -> bool:
    """Whether a table jumps at a rotation [rad]; jumps : all that it has [n]."""
    return bool(np.isclose(jumps, rotation, rtol=SAME, atol=0.0).any())


@lru_cache(maxsize=256)
def acting_of(mechanism: Mechanism) -> tuple[ChainActions, ...]:
    """The actions on each chain of a mechanism, the positive one first."""
    starting = oscillator(mechanism)
    sides = zip((mechanism.positive, mechanism.negative), starting.branches, equilibria(starting), strict=False)
    return tuple(
        _acting(chain, name=mechanism.name, end=float(branch.rotation[-1]) + rest)
        for chain, branch, rest in sides
        if chain is not None
    )


def height_of_support(mechanism: Mechanism) -> float:
    """Height over its base of what else holds the mechanism [m]: the far support or a lasting tie; 0 without either."""
    return held_above(mechanism) if mechanism.kind == "single-block" else mechanism.rise


def held_above(mechanism: Mechanism) -> float:
    """Height over the base hinge of the highest tie that holds the mechanism [m]; 0 without.

    Those count that are shown to last, or whose end is given: they stiffen the curve up to there.
    """
    heights = [
        action.at[1] - one.chain.hinges[0][1]
        for one in acting_of(mechanism)
        for number, action in enumerate(one.actions)
        if isinstance(action, Tie)
        and one.resists_at(number, 0.0)
        and (lasts(action) or isinstance(action.until, float))
    ]
    return max(heights, default=0.0)


def _acting(chain: Chain, *, name: str, end: float) -> ChainActions:
    actions = actions_of(chain)
    flexible = actions and any(chain.joints)
    moments = flexible_moments(chain, name=name) if flexible else rigid_moments(chain, end=end)
    return ChainActions(chain, moments, tuple(end_of(chain, each) for each in actions))


def _standing(mechanism: Mechanism, sides: Sequence[Stages]) -> Oscillator | None:
    """The oscillator of a mechanism with the stages of its chains; None where it falls at rest."""
    try:
        return make_oscillator(mechanism, sides[0], sides[-1])
    except (MechanismError, InterfaceError):
        return None


def _kept(acting: ChainActions, overturning: float) -> tuple[float, ...]:
    """The ends of the actions that are there up to overturning [rad]; 0 of those that are not."""
    return tuple(end if end >= overturning * (1.0 - SAME) else 0.0 for end in acting.lasting)


def _standing_by(acting: Sequence[ChainActions], sides: Sequence[Stages]) -> tuple[str, ...]:
    """Names of the actions that are missing at rest where a side falls, or where none does at once, of all missing."""
    both = list(zip(acting, sides, strict=True))
    falling = [one.actions[number].name for one, side in both if _falls(side[0]) for number in side[0].absent]
    missing = [one.actions[number].name for one, side in both for stage in side for number in stage.absent]
    return tuple(dict.fromkeys(falling or missing))


def _falls(stage: Stage) -> bool:
    """Whether a chain falls at rest as its blocks turn about their hinges."""
    rigid = replace(stage.chain, joints=())
    return bool(virtual_work(rigid, np.zeros(1)).restoring[0] <= 0.0)
