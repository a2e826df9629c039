"""The codes whose requirements on suites are known."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Protocol

from records.compliance import asce7_16, asce43_05, en1998_1, ntc2018, nzs1170_5
from records.compliance.requirement import Requirement
from records.compliance.suite import Suite


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
    found: list[Requirement] = []
    for code, check in REQUIREMENTS.items():
        low, high = own.get(code, (shortest, longest))
        found += check(suite, shortest=low, longest=high)
    return tuple(found)
