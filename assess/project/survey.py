"""What the survey's tolerance may change: the numbers it bears on, and the index at their bad ends.

Thicknesses and the places of given hinges are known to `[verdict] survey_tolerance`, loads to 5 %. Each is varied
alone; what they take from the index is added up. Answers by histories have a spread of their own and are left out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial

from assess.codes.check import Check
from assess.codes.families import uses_histories
from assess.codes.verdict import Answer, Decision, MechanismVerdict, Question, Verdict, find_deciding_check
from assess.errors import AssessError
from assess.geometry.solid import Solid
from assess.mechanisms.mechanism import Mechanism
from assess.project import sections
from assess.project.keys import Key, with_value
from assess.project.messages import written
from assess.project.schema import Project
from assess.project.variables import Alone, Subject, at_key, facing, of_loads, thickness
from assess.results import MechanismResult
from assess.study.sensitivity import check_case
from assess.study.study import Study, Variable
from spectra.errors import SpectrumError
from spectra.spectrum import Spectrum

OF_LOADS = 0.05  # share
FAR = 0.5  # of the threshold: an index farther from it is not "at the limit", whatever the survey's tolerance
Survey = Callable[[str], tuple[Variable, ...]]


def survey_of(project: Project, study: Study, solids: Mapping[str, Solid | None], alone: Alone) -> Survey:
    """Return what gives the numbers of a mechanism that the survey's tolerance bears on, by its name."""
    mechanisms = {mechanism.name: mechanism for mechanism in study.mechanisms}

    def variables(name: str) -> tuple[Variable, ...]:
        mechanism = mechanisms[name]
        subject = Subject(mechanism, study.amplified[name], facing(project, mechanism), solids, alone)
        return tuple(_of(subject, mechanism, tolerance=project.content.verdict.survey_tolerance))

    return variables


def _of(subject: Subject, mechanism: Mechanism, *, tolerance: float) -> Iterator[Variable]:
    section = subject.section
    if not isinstance(section, sections.Chained) or tolerance == 0.0:
        return
    found = [thickness(subject, section, sections.Change(tolerance, "m"))]
    found += [at_key(subject, number, sections.Change(OF_LOADS)) for number in of_loads(subject, section)]
    yield from (each for each in found if isinstance(each, Variable))
    yield from _hinges(subject, section, tolerance)


def _hinges(subject: Subject, section: sections.Chained, tolerance: float) -> Iterator[Variable]:
    """Each given hinge, moved along the direction of motion."""
    for table in ("hinges", "hinges_negative"):
        given = getattr(section, table, None)
        if not isinstance(given, sections.Hinges):
            continue
        for letter, place in given.entries().items():
            path: Key = ("mechanisms", subject.name, table, letter)
            move = partial(_moved, subject, path, place, section.towards)
            yield Variable(subject.name, "hinge", written(path), "m", 0.0, -tolerance, tolerance, move)


def _moved(subject: Subject, path: Key, place: tuple[float, ...], direction: Sequence[float], shift: float) -> Study:
    """The study with a hinge moved by `shift` [m] along the direction."""
    length = sum(each**2 for each in direction) ** 0.5
    way = (1.0, 0.0) if len(place) == 2 else tuple(each / length for each in direction)
    project, moved = subject.project, [at + shift * each for at, each in zip(place, way, strict=True)]
    raw = with_value(project.raw, path, moved, project.content)
    content = sections.Content.model_validate(raw, context={"folder": project.folder})
    return subject.alone(subject.name, content, {})


def tolerances(
    survey: Survey,
    spectrum: Spectrum,
    question: Question,
    found: Verdict,
    mechanisms: Sequence[MechanismResult],
) -> dict[str, float]:
    """Find, for each mechanism whose index is not far from its threshold, what the tolerance takes from the index."""
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
    """The larger the better: the index, or capacity over demand."""
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
    """The share of the index that the tolerance takes, all numbers together."""
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
    """Capacity over demand of a case over that of the base; 0 where the case has no answer any more."""
    if end is None:
        return 0.0
    if end.capacity_pga_g is not None and base.capacity_pga_g:
        return end.capacity_pga_g / base.capacity_pga_g
    return base.ratio / end.ratio if base.ratio and end.ratio else 1.0


def _at(variable: Variable, value: float, spectrum: Spectrum, question: Question, answer: Answer) -> Check | None:
    """The deciding check with one value of a number; None where the mechanism cannot be assessed there."""
    try:
        study = replace(variable.study_at(value), procedures=(answer.procedure,), levels=(spectrum.pga,))
        found = check_case(study, spectrum, (), jobs=1)
    except (AssessError, SpectrumError):
        return None
    return find_deciding_check(found, answer, question.basis, question.action)
