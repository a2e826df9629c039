"""The oscillators of a mechanism: as it starts, as its ties and forces end, and as it collapses.

    starting     every action at rest: multipliers
    breaking     each action up to its end; one not shown to last does not resist: the acceleration on the curve
    collapse     only actions shown to act up to collapse resist: displacements and histories

A force or tie that drives never ends. A tie that would break before the mechanism collapses is not part of the curve of
collapse: once broken it does not act again as the mechanism returns. Source: Circolare 7/2019, C8.7.1.2.1.6.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from assess.errors import InterfaceError, MechanismError
from assess.loads.load import Force, ForceOrTie, lasts
from assess.mechanisms.branch_table import (
    ActionMoments,
    ChainStage,
    Signature,
    Stages,
    divide_into_stages,
    ends_of,
    rigid_moments,
    single_stage,
    stage_signature,
    staged_branch,
)
from assess.mechanisms.chain import Chain, ChainPair, virtual_work
from assess.mechanisms.flexible_oscillator import flexible_moments, flexible_oscillator, same_stages
from assess.mechanisms.tied_oscillator import memory_of_ties, oscillator_on_joints, stretching_ties, without_ties
from assess.oscillator import Branch, Oscillator

CLEARLY = 1.0 + 1e-6  # two rotations that differ by less are one
AT_OVERTURNING = 1e-9  # of a rotation: an end this near overturning comes with it


@dataclass(frozen=True)
class Variants:
    """The oscillators of a mechanism, one object where they are equal.

    breaking, collapse : None if the mechanism falls at rest without the actions that are not shown to last
    depends_on : names of the actions without which it falls at rest; empty if there are none
    ends : rotation up to which each action of each chain resists on the way to collapse [rad]; 0 if it does not last
    """

    starting: Oscillator
    breaking: Oscillator | None
    collapse: Oscillator | None
    depends_on: tuple[str, ...]
    ends: tuple[tuple[float, ...], ...]

    @property
    def deciding(self) -> Oscillator:
        """The oscillator of displacements and histories; the starting one if it falls at rest without its actions."""
        return self.starting if self.collapse is None else self.collapse

    @property
    def of_histories(self) -> tuple[Oscillator, ...]:
        """The oscillators that histories follow, the deciding one first; the worst response counts.

        What resists and is not shown to last is left out of the deciding one. That is not always worse: a vertical
        force moves the frequency of rocking and the impacts' velocities, so histories run with it as well. A tie that
        stretches is followed through yield and rupture, so where it is shown to be there histories have it.
        """
        each: dict[int, Oscillator] = {}
        stretching = self.breaking is not None and self.breaking.memory is not None
        for oscillator in (None if stretching else self.deciding, self.breaking, self.starting):
            if oscillator is not None and (self.collapse is not None or not each):
                each.setdefault(id(oscillator), oscillator)
        return tuple(each.values())


def find_variants(pair: ChainPair, starting: Oscillator, acting: Sequence[ChainActions]) -> Variants:
    """Return the oscillators of a mechanism as it starts, as its actions end, and as it collapses.

    Parameters
    ----------
    pair : the chains of both directions
    starting : the oscillator with every action that is there at rest
    acting : the actions on each chain
    """
    known: dict[tuple[Signature, ...], Oscillator | None] = {
        tuple(stage_signature(single_stage(each.chain)) for each in acting): starting
    }

    def oscillator_of(sides: Sequence[Stages]) -> Oscillator | None:
        key = tuple(map(stage_signature, sides))
        if key not in known:
            known[key] = _oscillator_or_none(pair, sides)
        return known[key]

    def no_later(sides: Sequence[Stages]) -> Oscillator | None:
        """Keep actions that crush a joint by their weight: without them the mechanism would fall too late."""
        made = oscillator_of(sides)
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
        return oscillator_of(
            [single_stage(one.chain) if on else side for one, on, side in zip(acting, later, sides, strict=True)]
        )

    breaking = no_later([each.up_to(each.ends) for each in acting])
    ends = [each.lasting_ends for each in acting]
    sides = [each.up_to(each.lasting_ends) for each in acting]
    collapse = no_later(sides)
    if collapse is not None:
        ends = [
            _lasting_to_collapse(each, fall) for each, fall in zip(acting, overturning_rotations(collapse), strict=True)
        ]
        sides = [each.up_to(kept) for each, kept in zip(acting, ends, strict=True)]
        collapse = no_later(sides)
    if collapse is not None and (breaking is None or _falls_before(breaking, collapse)):
        breaking = collapse
    missing = () if collapse is not None else _depends_on(acting, sides)
    return Variants(starting, breaking, collapse, missing, tuple(ends))


def overturning_rotations(rocker: Oscillator) -> tuple[float, ...]:
    """Return the overturning rotation of each branch, counted from the geometry [rad]."""
    sides = zip(rocker.branches, rocker.equilibria, strict=False)
    return tuple(branch.unstable + rest for branch, rest in sides)


def collapse_branch(chain: Chain, *, name: str) -> Branch:
    """Tabulate a chain on rigid hinges with the actions that drive or are shown to last to collapse; no restitution.

    Parameters
    ----------
    chain : with all its actions; its joints are ignored
    name : of the mechanism, for errors

    Raises
    ------
    MechanismError : a chain that never overturns
    FallingError : a chain that falls at rest, or depends on the other actions
    """
    rigid = replace(chain, joints=())
    starting = staged_branch(single_stage(rigid), restitution=0.0, name=name)
    if not rigid.actions:
        return starting
    acting = _chain_actions(rigid, name=name, end=float(starting.rotation[-1]))
    found = staged_branch(acting.up_to(acting.lasting_ends), restitution=0.0, name=name)
    return staged_branch(acting.up_to(_lasting_to_collapse(acting, found.overturning)), restitution=0.0, name=name)


ROUNDING = 1e-12
"""Largest difference, relative to the largest value of a column, between the two ways of a symmetric body."""
COLUMNS = ("rotation", "inertia", "restoring", "excitation", "participation", "lift")
NUMBERS = ("restitution", "overturning", "critical", "unstable")


def oscillator_at_start(pair: ChainPair) -> Oscillator:
    """Return the oscillator with every action that is there at rest."""
    return _make_oscillator(pair, single_stage(pair.positive), single_stage(pair.negative or pair.positive))


@dataclass(frozen=True)
class ChainActions:
    """A chain with the moments of its actions, and the rotation up to which each is shown to act [rad]."""

    chain: Chain
    moments: ActionMoments
    ends: tuple[float, ...]

    @property
    def actions(self) -> tuple[ForceOrTie, ...]:
        """The forces and ties on the chain."""
        return self.chain.actions

    @property
    def lasting_ends(self) -> tuple[float, ...]:
        """The ends of the actions that are shown to last, 0 for the others [rad]."""
        return tuple(end if lasts(each) else 0.0 for each, end in zip(self.actions, self.ends, strict=True))

    @property
    def thrusts(self) -> tuple[Force, ...]:
        """The forces that drive the chain at rest."""
        at_rest = self.moments.at_rotations(np.zeros(1))[:, 0] if self.ends else ()
        forces = zip(self.actions, at_rest, strict=True)
        return tuple(each for each, moment in forces if isinstance(each, Force) and moment > 0.0)

    def up_to(self, ends: Sequence[float]) -> Stages:
        """Return the stages of the chain with its actions up to given ends [rad]."""
        return divide_into_stages(self.chain, ends, self.moments)

    def ever_resists(self, number: int) -> bool:
        """Return whether an action, by its number, resists at any rotation."""
        return bool((self.moments.at_rotations(self.moments.scan)[number] < 0.0).any())

    def resists_at(self, number: int, rotation: float) -> bool:
        """Return whether an action, by its number, resists at a rotation [rad]."""
        return bool(self.moments.at_rotations(np.array([rotation]))[number, 0] < 0.0)


def mechanism_actions(pair: ChainPair, starting: Oscillator) -> tuple[ChainActions, ...]:
    """Return the actions on each chain of a mechanism, the positive one first.

    Parameters
    ----------
    pair : the chains of both directions
    starting : the oscillator with every action that is there at rest
    """
    sides = zip((pair.positive, pair.negative), starting.branches, starting.equilibria, strict=False)
    return tuple(
        _chain_actions(chain, name=pair.name, end=float(branch.rotation[-1]) + rest)
        for chain, branch, rest in sides
        if chain is not None
    )


def _falls_before(one: Oscillator, other: Oscillator) -> bool:
    """Return whether a mechanism first falls at a smaller rotation than another of its variants.

    On soft joints one that loses a tie may fall to the equilibrium without it: then the curve without it is used.
    """
    return any(
        first < then * (1.0 - AT_OVERTURNING)
        for first, then in zip(overturning_rotations(one), overturning_rotations(other), strict=True)
    )


def _oscillator_or_none(pair: ChainPair, sides: Sequence[Stages]) -> Oscillator | None:
    """Return the oscillator of a mechanism with the stages of its chains; None if it falls at rest."""
    try:
        return _make_oscillator(pair, sides[0], sides[-1])
    except (MechanismError, InterfaceError):
        return None


def _lasting_to_collapse(acting: ChainActions, overturning: float) -> tuple[float, ...]:
    """Return the ends of the actions that act up to overturning [rad]; 0 for the others."""
    return tuple(end if end >= overturning * (1.0 - AT_OVERTURNING) else 0.0 for end in acting.lasting_ends)


def _depends_on(acting: Sequence[ChainActions], sides: Sequence[Stages]) -> tuple[str, ...]:
    """Return the names of the actions missing at rest where a side falls; if none does at once, of all missing."""
    both = list(zip(acting, sides, strict=True))
    falling = [one.actions[number].name for one, side in both if _falls_at_rest(side[0]) for number in side[0].absent]
    missing = [one.actions[number].name for one, side in both for stage in side for number in stage.absent]
    return tuple(dict.fromkeys(falling or missing))


def _falls_at_rest(stage: ChainStage) -> bool:
    """Return whether a chain falls at rest as its blocks rotate about their hinges."""
    rigid = replace(stage.chain, joints=())
    return bool(virtual_work(rigid, np.zeros(1)).restoring[0] <= 0.0)


def _make_oscillator(pair: ChainPair, front: Stages, back: Stages) -> Oscillator:
    """Return the oscillator of a mechanism whose actions end.

    Directions that are the same but for ROUNDING share one branch, so that both directions and both polarities of a
    motion are computed once, and no result depends on the last digits of a mesh.

    Parameters
    ----------
    pair : the chains of both directions
    front, back : the stages of the positive and of the negative chain; back is ignored for one-sided rocking
    """
    ties = stretching_ties(front) | stretching_ties(back)
    if ties and pair.has_joints:
        return oscillator_on_joints(pair, front, back)
    if ties:
        bare = _make_oscillator(pair, without_ties(front, ties), without_ties(back, ties))
        chains = (front[0].chain, back[0].chain)[: len(bare.branches)]
        return _capped(replace(_rigid_oscillator(pair, front, back), memory=memory_of_ties(ties, bare, chains)))
    made = flexible_oscillator(pair, front, back) if pair.has_joints else _rigid_oscillator(pair, front, back)
    if made.negative is None or not _same_branch(made.positive, made.negative):
        return made
    return replace(made, negative=made.positive)


def _capped(made: Oscillator) -> Oscillator:
    """Return an oscillator that has overturned where it would without its ties: beyond, they alone would hold it."""
    positive, negative = (
        None
        if branch is None or bare is None
        else replace(branch, overturning=min(branch.overturning, bare.overturning))
        for branch, bare in ((made.positive, made.bare.positive), (made.negative, made.bare.negative))
    )
    return replace(made, positive=positive or made.positive, negative=negative)


def _rigid_oscillator(pair: ChainPair, front: Stages, back: Stages) -> Oscillator:
    """Return the oscillator of chains on rigid hinges."""
    first, second = pair.restitution
    positive = staged_branch(front, restitution=first, name=pair.name)
    if pair.negative is None:
        return Oscillator(positive, None, pair.positive.mass)
    same = same_stages(front, back) and first == second
    return Oscillator(
        positive=positive,
        negative=positive if same else staged_branch(back, restitution=second, name=pair.name),
        mass=pair.positive.mass,
    )


def _same_branch(one: Branch, other: Branch) -> bool:
    """Return whether two branches are the same but for ROUNDING."""
    shape = [(branch.rotation.size, branch.overturning_flexible is None) for branch in (one, other)]
    pairs = [(getattr(one, name), getattr(other, name)) for name in (*NUMBERS, *COLUMNS)]
    return shape[0] == shape[1] and all(np.abs(a - b).max() <= ROUNDING * np.abs(a).max() for a, b in pairs)


def _chain_actions(chain: Chain, *, name: str, end: float) -> ChainActions:
    """Return the actions on one chain, with moments up to the rotation `end` [rad]; name: of the mechanism."""
    actions = chain.actions
    flexible = actions and any(chain.joints)
    moments = flexible_moments(chain, name=name) if flexible else rigid_moments(chain, end=end)
    return ChainActions(chain, moments, ends_of(chain))
