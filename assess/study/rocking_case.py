"""What the time histories of one mechanism are run for, and what they give."""

from __future__ import annotations

from dataclasses import dataclass

from assess.amplification.floor_motion import BaseMotion
from assess.codes.suite import Suite
from assess.oscillator import Oscillator, elastic_frequency
from assess.results import HistoryResult
from assess.short_repr import ShortRepr
from assess.study.study import Equation


@dataclass(frozen=True, repr=False)
class RockingCase(ShortRepr):
    """One oscillator, the equation its histories solve, and every ground motion as it acts at its base.

    rebounds : factors on its restitution, its own value (1) first; the worst of them counts
    """

    name: str
    oscillator: Oscillator
    equation: Equation
    base: tuple[BaseMotion, ...]
    rebounds: tuple[float, ...] = (1.0,)


@dataclass(frozen=True, repr=False)
class RockingHistories(ShortRepr):
    """The histories of one mechanism.

    histories : in the worse polarity [level][record]; suites : their maxima, by level
    besides : suites at further levels; scan : suites at rising PGA, up to overturning
    """

    histories: tuple[tuple[HistoryResult, ...], ...]
    suites: tuple[Suite, ...]
    besides: tuple[Suite, ...] = ()
    scan: tuple[Suite, ...] = ()


def vibrates(oscillator: Oscillator) -> bool:
    """Return whether the oscillator vibrates about rest, on joints without a threshold of uplift."""
    return any(elastic_frequency(branch) is not None for branch in oscillator.branches)
