"""The curves of one direction of a mechanism, one for each set of actions that the Italian clauses count."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from assess.codes.check import BranchName
from assess.codes.context import Context, LocalLimit
from assess.codes.worst_branch import NAMES, branch_of
from assess.oscillator import Branch, Oscillator


@dataclass(frozen=True)
class Curves:
    """The branches of one name, by the actions in them (C8.7.1.2.1.6).

    lasting : those shown to be there up to collapse, and all that drive: d0*
    starting : every action there at rest: alpha0
    breaking : actions until they end: a(d), for the period
    limits : rotations at which actions end or seats are lost
    mass : total moved mass [kg]
    """

    name: BranchName
    lasting: Branch
    starting: Branch
    breaking: Branch
    limits: tuple[LocalLimit, ...]
    mass: float

    @property
    def at_ultimate(self) -> Curves:
        """Return the curves at an ultimate limit state, where at rest too only the actions shown to last count.

        No wall is kept from moving by a tie that is gone after a millimetre.
        """
        return replace(self, starting=self.lasting)


def curves_of(oscillator: Oscillator, context: Context) -> tuple[Curves, ...]:
    """Return the curves of each branch; of one only where both ways are alike.

    Branches are paired by name: a mechanism that is symmetric without its ties need not be so with them.
    """
    states = (oscillator, context.starting or oscillator, context.breaking or oscillator)
    alike = all(each.negative is None or each.symmetric for each in states) and not context.limits
    names = NAMES[:1] if alike or oscillator.negative is None else NAMES
    return tuple(_of(name, states, context.limits, oscillator.mass) for name in names)


def curves_of_all_actions(oscillator: Oscillator) -> tuple[Curves, ...]:
    """Return the curves of each branch of an oscillator that is the same for every set of actions."""
    names = NAMES[:1] if oscillator.negative is None or oscillator.symmetric else NAMES
    return tuple(_of(name, (oscillator,) * 3, (), oscillator.mass) for name in names)


def branch_curves(oscillator: Oscillator, context: Context, name: BranchName) -> Curves:
    """Return the curves of the branch of a name; those of the positive one where there is no other."""
    found = curves_of(oscillator, context)
    return next((each for each in found if each.name == name), found[0])


def _of(name: BranchName, states: Sequence[Oscillator], limits: Sequence[LocalLimit], mass: float) -> Curves:
    lasting, starting, breaking = (branch_of(each, name) for each in states)
    return Curves(name, lasting, starting, breaking, tuple(each for each in limits if each.branch == name), mass)
