"""The share of the index of each mechanism that the tolerance of the survey may take.

Each surveyed number is varied alone, to its unfavourable end; the losses of index are added up. Answers by histories
have a scatter of their own and are left out.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from assess.codes.check import Check
from assess.codes.families import uses_histories
from assess.codes.verdict import Answer, Decision, MechanismVerdict, Question, Verdict, find_deciding_check
from assess.errors import AssessError
from assess.results import MechanismResult
from assess.study.sensitivity import check_case
from assess.study.study import Variable
from spectra.errors import SpectrumError
from spectra.spectrum import Spectrum

FAR = 0.5  # of the threshold: an index farther from it is not "at the limit", whatever the survey's tolerance
Survey = Callable[[str], tuple[Variable, ...]]


def tolerances(
    survey: Survey,
    spectrum: Spectrum,
    question: Question,
    found: Verdict,
    mechanisms: Sequence[MechanismResult],
) -> dict[str, float]:
    """Find the loss of index by the tolerance of the survey, for each mechanism whose index is near its threshold."""
    checks = {mechanism.name: mechanism.checks for mechanism in mechanisms}
    falls: dict[str, float] = {}
    for one in found.mechanisms:
        near = [answer for answer in one.answers if _matters(answer, found.target)]
        if near:
            known = checks[one.mechanism]
            falls[one.mechanism] = max(_fall(survey, spectrum, question, one, answer, known) for answer in near)
    return falls


def _matters(answer: Answer, target: float | None) -> bool:
    if answer.outcome == Decision.INCOMPLETE or uses_histories(answer.procedure) or target is None:
        return False
    good = _goodness(answer)
    return good is not None and abs(good / target - 1.0) <= FAR


def _goodness(answer: Answer) -> float | None:
    """Return capacity over demand: the index, or its inverse."""
    if answer.index is None or answer.index.value == 0.0:
        return None
    return 1.0 / answer.index.value if answer.index.name == "D/C" else answer.index.value


def _fall(
    survey: Survey,
    spectrum: Spectrum,
    question: Question,
    one: MechanismVerdict,
    answer: Answer,
    checks: Sequence[Check],
) -> float:
    """Return the share of the index that the tolerance takes, over all numbers."""
    base = find_deciding_check(checks, answer, question.basis, question.action)
    if base is None:
        return 0.0
    total = 0.0
    for variable in survey(one.mechanism):
        ends = [_at(variable, value, spectrum, question, answer) for value in (variable.low, variable.high)]
        worst = min((_share(end, base) for end in ends), default=1.0)
        total += max(0.0, 1.0 - worst)
    return total


def _share(end: Check | None, base: Check) -> float:
    """Return capacity over demand of a case over that of the base; 0 if the case has no answer."""
    if end is None:
        return 0.0
    if end.capacity_pga_g is not None and base.capacity_pga_g:
        return end.capacity_pga_g / base.capacity_pga_g
    return base.ratio / end.ratio if base.ratio and end.ratio else 1.0


def _at(variable: Variable, value: float, spectrum: Spectrum, question: Question, answer: Answer) -> Check | None:
    """Return the deciding check with one value of a number; None if the mechanism cannot be assessed there."""
    try:
        study = replace(variable.study_at(value), procedures=(answer.procedure,), levels=(spectrum.pga,))
        found = check_case(study, spectrum, (), jobs=1)
    except (AssessError, SpectrumError):
        return None
    return find_deciding_check(found, answer, question.basis, question.action)
