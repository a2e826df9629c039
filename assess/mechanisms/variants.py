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
from assess.mechanisms.actions import ChainActions, actions_on
from assess.mechanisms.chain import Chain, ChainPair
from assess.mechanisms.oscillation import make_oscillator
from assess.mechanisms.stages import Signature, Stage, Stages, signature, single_stage
from assess.mechanisms.table import staged_branch
from assess.mechanisms.virtual_work import virtual_work
from assess.oscillator import Branch, Oscillator

CLEARLY = 1.0 + 1e-6  # two rotations that differ by less are one
SAME = 1e-9  # of a rotation: an end this near overturning comes with it


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


def find_variants(pair: ChainPair, starting: Oscillator, acting: Sequence[ChainActions]) -> Variants:
    """Return the oscillators of a mechanism as it starts, as its actions end, and as it collapses.

    Parameters
    ----------
    pair : the chains of both directions
    starting : the oscillator with every action that is there at rest
    acting : the actions on each chain
    """
    known: dict[tuple[Signature, ...], Oscillator | None] = {
        tuple(signature(single_stage(each.chain)) for each in acting): starting
    }

    def of(sides: Sequence[Stages]) -> Oscillator | None:
        key = tuple(map(signature, sides))
        if key not in known:
            known[key] = _oscillator_or_none(pair, sides)
        return known[key]

    def no_later(sides: Sequence[Stages]) -> Oscillator | None:
        """Keep actions that crush a joint by their weight: without them the mechanism would fall too late."""
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
    ends = [each.lasting_ends for each in acting]
    sides = [each.up_to(each.lasting_ends) for each in acting]
    collapse = no_later(sides)
    if collapse is not None:
        ends = [_kept(each, fall) for each, fall in zip(acting, overturning_rotations(collapse), strict=True)]
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


def _falls_before(one: Oscillator, other: Oscillator) -> bool:
    """Return whether a mechanism first falls at a smaller rotation than another of its variants.

    On soft joints one that loses a tie may fall to the equilibrium without it: then the curve without it is used.
    """
    return any(
        first < then * (1.0 - SAME)
        for first, then in zip(overturning_rotations(one), overturning_rotations(other), strict=True)
    )


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
    end = float(staged_branch(single_stage(rigid), restitution=0.0, name=name).rotation[-1])
    acting = actions_on(rigid, name=name, end=end)
    found = staged_branch(acting.up_to(acting.lasting_ends), restitution=0.0, name=name)
    return staged_branch(acting.up_to(_kept(acting, found.overturning)), restitution=0.0, name=name)


def _oscillator_or_none(pair: ChainPair, sides: Sequence[Stages]) -> Oscillator | None:
    """Return the oscillator of a mechanism with the stages of its chains; None if it falls at rest."""
    try:
        return make_oscillator(pair, sides[0], sides[-1])
    except (MechanismError, InterfaceError):
        return None


def _kept(acting: ChainActions, overturning: float) -> tuple[float, ...]:
    """Return the ends of the actions that act up to overturning [rad]; 0 for the others."""
    return tuple(end if end >= overturning * (1.0 - SAME) else 0.0 for end in acting.lasting_ends)


def _depends_on(acting: Sequence[ChainActions], sides: Sequence[Stages]) -> tuple[str, ...]:
    """Return the names of the actions missing at rest where a side falls; if none does at once, of all missing."""
    both = list(zip(acting, sides, strict=True))
    falling = [one.actions[number].name for one, side in both if _falls(side[0]) for number in side[0].absent]
    missing = [one.actions[number].name for one, side in both for stage in side for number in stage.absent]
    return tuple(dict.fromkeys(falling or missing))


def _falls(stage: Stage) -> bool:
    """Return whether a chain falls at rest as its blocks rotate about their hinges."""
    rigid = replace(stage.chain, joints=())
    return bool(virtual_work(rigid, np.zeros(1)).restoring[0] <= 0.0)
