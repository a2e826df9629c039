"""What the survey's tolerance may change: the numbers it bears on, and the index at their bad ends.

Thicknesses and the places of given hinges are known to `[verdict] survey_tolerance`, loads to 5 %. Each is varied
alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import partial

from assess.geometry.solid import Solid
from assess.mechanisms.mechanism import Mechanism
from assess.project import sections
from assess.project.definitions import definition_of
from assess.project.key_text import key_text
from assess.project.keys import Key, with_value
from assess.project.schema import Project
from assess.project.variables import Alone, Subject, at_key, of_loads, thickness, turn_towards
from assess.study.study import Study, Variable
from assess.study.survey import Survey

OF_LOADS = 0.05  # share


def survey_of(project: Project, study: Study, solids: Mapping[str, Solid | None], alone: Alone) -> Survey:
    """Return what gives the numbers of a mechanism that the survey's tolerance bears on, by its name."""
    mechanisms = {mechanism.name: mechanism for mechanism in study.mechanisms}

    def variables(name: str) -> tuple[Variable, ...]:
        mechanism = mechanisms[name]
        subject = Subject(mechanism, study.amplified[name], turn_towards(project, mechanism), solids, alone)
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
    """Yield each given hinge, moved along the direction of motion."""
    for table in ("hinges", "hinges_negative"):
        given = getattr(section, table, None)
        if not isinstance(given, sections.Hinges):
            continue
        for letter, place in given.entries().items():
            path: Key = ("mechanisms", subject.name, table, letter)
            move = partial(_moved, subject, path, place, definition_of(section).towards)
            yield Variable(subject.name, "hinge", key_text(path), "m", 0.0, -tolerance, tolerance, move)


def _moved(subject: Subject, path: Key, place: tuple[float, ...], direction: Sequence[float], shift: float) -> Study:
    """Return the study with a hinge moved by `shift` [m] along the direction."""
    length = sum(each**2 for each in direction) ** 0.5
    way = (1.0, 0.0) if len(place) == 2 else tuple(each / length for each in direction)
    project, moved = subject.project, [at + shift * each for at, each in zip(place, way, strict=True)]
    raw = with_value(project.raw, path, moved, project.content)
    content = sections.Content.model_validate(raw, context={"folder": project.folder})
    return subject.alone(subject.name, content, {})
