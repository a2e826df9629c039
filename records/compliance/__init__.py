"""What codes ask of a suite of records beside its target spectrum, and what each lets one choose to meet it.

One module for each code, one function for each set of requirements. A rocking body has no period T_1: its place is
taken by the least and the largest equivalent period of the mechanisms. None of these clauses was compared with its
printed standard; what the modules say of them is from memory.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import inf, log
from types import MappingProxyType
from typing import Literal, Protocol

import numpy as np

from records.compliance import asce7_16, asce43_05, en1998_1, ntc2018, nzs1170_5
from records.compliance.suite import Requirement, Suite, common_factor
from spectra.arrays import BoolArray, FloatArray

CodeName = Literal["asce7-16", "asce43-05", "ec8", "ntc2018", "nzs1170.5"]


class PeriodsOfInterest(Protocol):
    """The range of periods over which a code compares a suite with its target [s]."""

    def __call__(self, *, shortest: float, longest: float) -> tuple[float, float]:
        """Return the range for the shortest and the longest period of the mechanisms [s]."""


class UnfitRecords(Protocol):
    """Which records break a rule of a code by themselves [n]."""

    def __call__(self, suite: Suite, *, shortest: float, longest: float) -> BoolArray:
        """Return true for each record that has to be replaced."""


class ScaleFactors(Protocol):
    """The factors on a suite with which it meets a code, if any do [n]."""

    def __call__(self, suite: Suite, *, shortest: float, longest: float) -> FloatArray | None:
        """Return the scale factor of each record, None where there are none."""


@dataclass(frozen=True)
class SelectionRules:
    """What a code lets one choose of a suite.

    code : as in `REQUIREMENTS`; least : number of records; periods_of_interest : periods over which records are fitted
    unfit_records : which records break a rule by themselves; factors : with which the suite meets the code
    own_factors : whether the code finds the factor of each record itself, over the period and not its logarithm
    record_factors : least and largest factor of a record; record_misfit : of a record, mean square of ln [-]
    """

    code: str
    least: int
    periods_of_interest: PeriodsOfInterest
    unfit_records: UnfitRecords
    factors: ScaleFactors
    own_factors: bool = False
    record_factors: tuple[float, float] = (0.0, inf)
    record_misfit: float = inf

    def requirements(self, suite: Suite, *, shortest: float, longest: float) -> tuple[Requirement, ...]:
        """Return the requirements of the code on a suite."""
        return REQUIREMENTS[self.code](suite, shortest=shortest, longest=longest)


def unusable_records(suite: Suite, *, shortest: float, longest: float) -> BoolArray:
    """Return which records are not usable up to the longest period [n]."""
    return np.asarray(suite.usable < longest)


def any_record(suite: Suite, *, shortest: float, longest: float) -> BoolArray:
    """Return that every record may be used [n]."""
    return np.zeros(suite.count, dtype=np.bool_)


def _one_factor(code: str) -> ScaleFactors:
    """Return the search for one further factor on all records, nearest to 1, with which the mean meets a code."""

    def factors(suite: Suite, *, shortest: float, longest: float) -> FloatArray | None:
        further_factor = common_factor(REQUIREMENTS[code](suite, shortest=shortest, longest=longest))
        return None if further_factor is None else suite.factor * further_factor

    return factors


def _rules_on_mean(
    code: str, least: int, periods_of_interest: PeriodsOfInterest, unfit_records: UnfitRecords
) -> SelectionRules:
    return SelectionRules(code, least, periods_of_interest, unfit_records, _one_factor(code))


class Requirements(Protocol):
    """A code's requirements; shortest, longest: equivalent periods [s] in place of T_1."""

    def __call__(self, suite: Suite, *, shortest: float, longest: float) -> tuple[Requirement, ...]:
        """Return each requirement with its number and verdict."""


REQUIREMENTS: Mapping[str, Requirements] = {
    asce7_16.CODE: asce7_16.requirements,
    en1998_1.CODE: en1998_1.requirements,
    ntc2018.CODE: ntc2018.requirements,
    nzs1170_5.CODE: nzs1170_5.requirements,
    asce43_05.CODE: asce43_05.requirements,
}

SELECTION_RULES: Mapping[CodeName, SelectionRules] = {
    "asce7-16": _rules_on_mean(asce7_16.CODE, asce7_16.LEAST_RECORDS, asce7_16.periods_of_interest, any_record),
    "asce43-05": _rules_on_mean(
        asce43_05.CODE, asce43_05.LEAST_RECORDS, asce43_05.periods_of_interest, unusable_records
    ),
    "ec8": _rules_on_mean(en1998_1.CODE, en1998_1.LEAST_RECORDS, en1998_1.periods_of_interest, any_record),
    "ntc2018": _rules_on_mean(ntc2018.CODE, ntc2018.LEAST_RECORDS, ntc2018.periods_of_interest, unusable_records),
    "nzs1170.5": SelectionRules(
        nzs1170_5.CODE,
        nzs1170_5.LEAST_RECORDS,
        nzs1170_5.periods_of_interest,
        nzs1170_5.unfit_records,
        nzs1170_5.scale_factors,
        own_factors=True,
        record_factors=(nzs1170_5.LEAST_FACTOR, nzs1170_5.LARGEST_FACTOR),
        record_misfit=(nzs1170_5.LOG_FIT * log(10.0)) ** 2,
    ),
}
"""By the names of `select.for`."""


def linear_weights(period: Sequence[float]) -> tuple[tuple[float, float], ...]:
    """Return (period [s], weight [-]) with which a mean over periods is one over the period, not its logarithm."""
    T = np.asarray(period, dtype=np.float64)
    weight = np.convolve(np.diff(T), [0.5, 0.5]) if T.size > 1 else np.ones(1)
    return tuple(zip(T.tolist(), weight.tolist(), strict=True))


def all_requirements(
    suite: Suite, *, shortest: float, longest: float, own: Mapping[str, tuple[float, float]] = MappingProxyType({})
) -> tuple[Requirement, ...]:
    """Check the suite against every code.

    Parameters
    ----------
    suite : scaled records beside their target
    shortest, longest : equivalent periods of the mechanisms [s]
    own : shortest and longest period [s] of the codes that define their own, by code
    """
    requirements: list[Requirement] = []
    for code, check in REQUIREMENTS.items():
        low, high = own.get(code, (shortest, longest))
        requirements += check(suite, shortest=low, longest=high)
    return tuple(requirements)
