"""The codes whose requirements on suites are known."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

from records.compliance import asce7_16, asce43_05, en1998_1, ntc2018, nzs1170_5
from records.compliance.requirement import Requirement
from records.compliance.suite import Suite


class Requirements(Protocol):
    """A code's requirements; shortest, longest: equivalent periods [s] in place of T_1."""

    def __call__(self, suite: Suite, *, shortest: float, longest: float) -> tuple[Requirement, ...]:
        """Each requirement with its number and verdict."""


RECORDED: Mapping[str, Requirements] = {
    asce7_16.CODE: asce7_16.requirements,
    en1998_1.CODE: en1998_1.requirements,
    ntc2018.CODE: ntc2018.natural,
    nzs1170_5.CODE: nzs1170_5.requirements,
    asce43_05.CODE: asce43_05.requirements,
}
ARTIFICIAL: Mapping[str, Requirements] = {**RECORDED, ntc2018.CODE: ntc2018.artificial}


def all_requirements(suite: Suite, *, shortest: float, longest: float, artificial: bool) -> tuple[Requirement, ...]:
    """Those of every code, for a suite of recorded or of artificial motions."""
    codes = ARTIFICIAL if artificial else RECORDED
    return tuple(one for check in codes.values() for one in check(suite, shortest=shortest, longest=longest))
