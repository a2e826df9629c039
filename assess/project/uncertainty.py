"""Which uncertain numbers of a project are sampled, and the study of a mechanism at their values.

The values are put at their keys and the whole is read through the schema again, as a sweep does. The direction and the
sides that were found at the means are kept.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial, reduce
from typing import NamedTuple

from pydantic import ValidationError

from assess.errors import ProjectError
from assess.geometry.solid import Solid, Solids
from assess.messages.message import Message, Term, note, warning
from assess.project import sections
from assess.project.dependents import dependents
from assess.project.key_text import error_line, key_text
from assess.project.keys import Key, with_value
from assess.project.schema import Project
from assess.project.uncertain_values import UncertainValue
from assess.project.variables import SWEPT, Alone, Foot, Subject, foot_of, key_of_thickness, thick_blocks, turn_towards
from assess.results.uncertainty import UncertainInput
from assess.study.study import Sampled, Sampling, Study

GROUP = "thickness"
"""The group of the sizes that [analysis.uncertainty] thickness varies."""
WHERE = "analysis.uncertainty"


class Cases(NamedTuple):
    """The bodies of a case by name, and what builds the study of one mechanism with some of them replaced."""

    solids: Solids
    build: Callable[[str, Mapping[str, Solid]], Study]


CasesOf = Callable[[sections.Content], Cases]


@dataclass(frozen=True)
class Thick:
    """The blocks of a mechanism whose thickness is sampled: the table, and the base that they are scaled about."""

    section: sections.Chained
    foot: Foot


def sampling_of(project: Project, study: Study, solids: Solids, cases_of: CasesOf) -> Sampling | None:
    """Return how the uncertain numbers of a project are sampled; None if it does not ask for that.

    Raises ProjectError if it asks and has none.
    """
    asked = project.content.analysis.uncertainty
    if asked is None:
        return None
    varied = {name for each in project.variations for name in dependents(project.content, each.path)}
    swept = [mechanism.name for mechanism in study.mechanisms if mechanism.name in varied]
    faced = reduce(turn_towards, (each for each in study.mechanisms if each.name not in swept), project)
    beside = {mechanism.name: mechanism.beside for mechanism in study.mechanisms}
    numbers = [
        Sampled(
            value.given,
            value.least,
            value.most,
            tuple(name for name in dependents(faced.content, value.path, beside=beside) if name not in swept),
        )
        for value in project.uncertain
    ]
    thick: dict[str, Thick] = {}

    def study_alone(name: str, content: sections.Content, replaced: Mapping[str, Solid]) -> Study:
        return cases_of(content).build(name, replaced)

    notes = [note("uncertainty-left-out", f"mechanisms.{name}", why=Term(SWEPT)) for name in swept]
    if asked.thickness is not None:
        found = dict(_thick(faced, study, solids, study_alone, swept))
        thick = {name: each for name, each in found.items() if isinstance(each, Thick)}
        for name, each in found.items():
            if isinstance(each, str):
                notes.append(note("uncertainty-thickness-left-out", f"mechanisms.{name}", why=Term(each)))
            else:
                key, mean = key_of_thickness(each.section), each.foot.width
                given = UncertainInput(key, "m", mean, asked.thickness, "lognormal", GROUP)
                numbers.append(Sampled(given, 0.0, float("inf"), (name,)))
    if not numbers:
        remedy = "write numbers as { mean, cov }, or thickness = 0.05 here"
        raise ProjectError(f"{WHERE}: no number of the project is uncertain; {remedy}")
    study_at = partial(_study_at, faced, project.uncertain, thick, cases_of)
    return Sampling(asked.samples, asked.seed, tuple(numbers), study_at, tuple(notes))


def _thick(
    project: Project, study: Study, solids: Solids, study_alone: Alone, swept: Sequence[str]
) -> Iterator[tuple[str, Thick | str]]:
    """Yield the mechanisms whose thickness no number of the file varies, or why it cannot be varied."""
    own = {value.path[1] for value in project.uncertain if value.path[0] == "bodies"}
    for mechanism in study.mechanisms:
        section = project.content.mechanisms[mechanism.name]
        if mechanism.name in swept or not isinstance(section, sections.Chained):
            continue
        if own & {name for block in section.blocks for name in block}:
            continue
        subject = Subject(mechanism, study.amplified[mechanism.name], project, solids, study_alone)
        foot = foot_of(subject, section)
        yield mechanism.name, foot if isinstance(foot, str) else Thick(section, foot)


def _study_at(
    project: Project,
    uncertain: Sequence[UncertainValue],
    thick: Mapping[str, Thick],
    cases_of: CasesOf,
    values: Sequence[float],
) -> Callable[[str], Study]:
    """Return what builds the study of each mechanism at values of the numbers; those of `thick` come last.

    Raises ProjectError if the schema refuses the values.
    """
    at_keys, widths = values[: len(uncertain)], dict(zip(thick, values[len(uncertain) :], strict=True))
    raw = project.raw
    for number, value in zip(uncertain, at_keys, strict=True):
        raw = with_value(raw, number.path, value, project.content)
    try:
        content = sections.Content.model_validate(raw, context={"folder": project.folder})
    except ValidationError as error:
        raise ProjectError(error_line(error, raw=raw)) from None
    cases = cases_of(content)

    def build(name: str) -> Study:
        if name not in thick:
            return cases.build(name, {})
        section, foot = thick[name].section, thick[name].foot
        factor = widths[name] / foot.width
        return cases.build(name, thick_blocks(section, cases.solids, factor=factor, middle=foot.middle))

    return build


def uncertainty_messages(project: Project) -> Iterator[Message]:
    """Report uncertain numbers that are used at their means, and hinges that stay while faces move."""
    content = project.content
    if project.uncertain and content.analysis.uncertainty is None:
        keys = ", ".join(value.given.key for value in project.uncertain)
        yield note("uncertainty-means", WHERE, keys=keys)
        return
    for value in project.uncertain:
        if value.path[0] == "bodies" and value.path[-1] == "thickness":
            yield from (
                warning("uncertainty-hinges-stay", key_text(path), key=value.given.key)
                for path in _given_hinges(content, str(value.path[1]))
            )


def _given_hinges(content: sections.Content, body: str) -> Iterator[Key]:
    """Yield the keys of hinges given as points of mechanisms that a body is a block of."""
    for name, section in content.mechanisms.items():
        if isinstance(section, sections.Chained) and any(body in block for block in section.blocks):
            yield from (("mechanisms", name, key) for key, points in section.points().items() if points is not None)
