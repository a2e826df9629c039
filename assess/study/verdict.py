"""The verdict on a study: which answers decide, and at which level of the ground's motion."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from math import isclose
from typing import Protocol

from assess.codes.check import Check, Family
from assess.codes.families import FAMILIES
from assess.codes.verdict import (
    MechanismChecks,
    Question,
    Verdict,
    find_limit_states,
    mark_deciding,
    methods_of,
    verdict,
)
from assess.results import MechanismResult
from assess.study.study import Study


class Checked(Protocol):
    """A mechanism that has been checked, in results or alone."""

    @property
    def name(self) -> str:
        """Its name."""

    @property
    def checks(self) -> tuple[Check, ...]:
        """The answers of every procedure."""


def by_motion(question: Question) -> bool:
    """Return whether a method by histories or energy may decide, or no method is named."""
    methods = methods_of(question)
    return not methods or any(FAMILIES[name] in (Family.HISTORY, Family.ENERGY) for name in methods)


def states_of(question: Question) -> tuple[str, ...]:
    """Return the limit states that decide, as checks name them."""
    return tuple(state.checked_as for state in find_limit_states(question)[0])


def decide(study: Study, mechanisms: Sequence[Checked], tolerance: Mapping[str, float] | None = None) -> Verdict:
    """Decide on the checks of the mechanisms; tolerance: loss of index by the survey, by name."""
    near = tolerance or {}
    judged = [
        MechanismChecks(m.name, m.checks, *study.facts.get(m.name, ((), ())), near.get(m.name, 0.0)) for m in mechanisms
    ]
    return verdict(study.question, judged)


def mark_result(found: Verdict, question: Question, mechanism: MechanismResult) -> MechanismResult:
    """Return the mechanism with the checks that decide marked as such."""
    one = next(each for each in found.mechanisms if each.mechanism == mechanism.name)
    return replace(mechanism, checks=mark_deciding(mechanism.checks, one, question.basis, question.action))


def levels_with_site(levels: tuple[float, ...], site_pga: float) -> tuple[float, ...]:
    """Return the levels of the study, including the site's own action, rising.

    Parameters
    ----------
    levels : tuple of float
        PGA of the levels [m/s2].
    site_pga : float
        PGA of the site [m/s2].

    Returns
    -------
    tuple of float
        Levels [m/s2]; one equal to the site's PGA but for rounding is replaced by it.
    """
    if any(isclose(level, site_pga, rel_tol=1e-9) for level in levels):
        return tuple(site_pga if isclose(level, site_pga, rel_tol=1e-9) else level for level in levels)
    return tuple(sorted((*levels, site_pga)))
