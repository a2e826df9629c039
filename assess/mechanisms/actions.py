"""The forces and ties on the chains of a mechanism: their moments, and up to which rotation they are known to act."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from assess.loads.load import Action, Force, lasts
from assess.mechanisms.chain import Chain, ChainPair
from assess.mechanisms.ends import end_of
from assess.mechanisms.flexible_table import flexible_moments
from assess.mechanisms.stages import Moments, Stages, actions_of, divide_into_stages, rigid_moments
from assess.oscillator import Oscillator


@dataclass(frozen=True)
class ChainActions:
    """A chain with the moments of its actions, and the rotation up to which each is shown to act [rad]."""

    chain: Chain
    moments: Moments
    ends: tuple[float, ...]

    @property
    def actions(self) -> tuple[Action, ...]:
        """The forces and ties on the chain."""
        return actions_of(self.chain)

    @property
    def lasting_ends(self) -> tuple[float, ...]:
        """The ends of the actions that are shown to last, 0 for the others [rad]."""
        return tuple(end if lasts(each) else 0.0 for each, end in zip(self.actions, self.ends, strict=True))

    @property
    def thrusts(self) -> tuple[Force, ...]:
        """The forces that drive the chain at rest."""
        at_rest = self.moments.of(np.zeros(1))[:, 0] if self.ends else ()
        forces = zip(self.actions, at_rest, strict=True)
        return tuple(each for each, moment in forces if isinstance(each, Force) and moment > 0.0)

    def up_to(self, ends: Sequence[float]) -> Stages:
        """Return the stages of the chain with its actions up to given ends [rad]."""
        return divide_into_stages(self.chain, ends, self.moments)

    def ever_resists(self, number: int) -> bool:
        """Return whether an action, by its number, resists at any rotation."""
        return bool((self.moments.of(self.moments.scan)[number] < 0.0).any())

    def resists_at(self, number: int, rotation: float) -> bool:
        """Return whether an action, by its number, resists at a rotation [rad]."""
        return bool(self.moments.of(np.array([rotation]))[number, 0] < 0.0)


def find_actions(pair: ChainPair, starting: Oscillator) -> tuple[ChainActions, ...]:
    """Return the actions on each chain of a mechanism, the positive one first.

    Parameters
    ----------
    pair : the chains of both directions
    starting : the oscillator with every action that is there at rest
    """
    sides = zip((pair.positive, pair.negative), starting.branches, starting.equilibria, strict=False)
    return tuple(
        actions_on(chain, name=pair.name, end=float(branch.rotation[-1]) + rest)
        for chain, branch, rest in sides
        if chain is not None
    )


def actions_on(chain: Chain, *, name: str, end: float) -> ChainActions:
    """Return the actions on one chain, with moments up to the rotation `end` [rad]; name: of the mechanism."""
    actions = actions_of(chain)
    flexible = actions and any(chain.joints)
    moments = flexible_moments(chain, name=name) if flexible else rigid_moments(chain, end=end)
    return ChainActions(chain, moments, tuple(end_of(chain, each) for each in actions))
