"""A mechanism in the cases of a sweep."""

from __future__ import annotations

from dataclasses import dataclass

from assess.codes.verdict import MechanismVerdict
from assess.results import MechanismResult
from assess.study.study import Case, Sweep


@dataclass(frozen=True)
class CaseResult:
    """One mechanism in one case, with its verdict."""

    result: MechanismResult
    verdict: MechanismVerdict


@dataclass(frozen=True)
class MechanismSweep:
    """One mechanism in all cases of one sweep.

    judged : the mechanism in each case, with its verdict [n]; controlling : the case that controls, counted from 0
    """

    sweep: Sweep
    judged: tuple[CaseResult, ...]
    controlling: int

    @property
    def results(self) -> tuple[MechanismResult, ...]:
        """The mechanism in each case."""
        return tuple(each.result for each in self.judged)

    @property
    def mechanism(self) -> str:
        """The name of the mechanism."""
        return self.results[0].name

    @property
    def worst(self) -> MechanismResult:
        """The mechanism in the controlling case."""
        return self.results[self.controlling]

    @property
    def case(self) -> Case:
        """The controlling case."""
        return self.sweep.cases[self.controlling]
