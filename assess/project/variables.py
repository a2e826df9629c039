"""Which numbers of each mechanism are varied, and its study at other values of them.

The sensitivity varies one number at a time, the survey's tolerance bears on thicknesses, given hinges and loads, and
uncertain numbers are sampled together. A number of the project file is varied at its key, and the whole is read through
the schema again, as a sweep does; the thickness is varied on the bodies themselves. The direction and the sides that
were found at the values given are kept.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial, reduce
from math import inf
from typing import Any, NamedTuple

from pydantic import ValidationError

from assess.errors import ProjectError
from assess.geometry.solid import Solid, Solids, scale_along
from assess.mechanisms.chain import hinge_names
from assess.mechanisms.mechanism import BlockMechanism, Mechanism
from assess.messages.message import Message, Term, note, warning
from assess.model.bodies import pieces_of
from assess.project import sections
from assess.project.keys import UncertainValue, dependents, error_line, read_case, value_at, with_value
from assess.project.project_file import Project
from assess.project.section import KeyPath, key_text
from assess.project.site_and_structure import bodies_of, definition_of
from assess.results.run import UncertainInput
from assess.study.amplification import MechanismAmplification
from assess.study.study import SampledNumber, Sampling, Study, UnvariedNumber, Variable
from assess.study.variations import Survey

StudyOfMechanism = Callable[[str, sections.Content, Mapping[str, Solid]], Study]
AT_MOST_1 = "at most 1: more would add velocity at the impact"
SWEPT = "a parametric study changes the mechanism; write the value of its controlling case in its place"


@dataclass(frozen=True)
class VariedNumber:
    """A number of the project file: what it is to the mechanism, its key, its unit in SI."""

    parameter: str
    path: KeyPath
    unit: str = "-"


@dataclass(frozen=True)
class VariedMechanism:
    """A mechanism as built, with what the project says of it, its direction included where that was sought."""

    mechanism: Mechanism
    amplified: MechanismAmplification
    project: Project
    solids: Solids
    build_study: StudyOfMechanism

    @property
    def name(self) -> str:
        """The name of the mechanism."""
        return self.mechanism.name

    @property
    def section(self) -> sections.MechanismSection:
        """The table of the mechanism."""
        return self.project.content.mechanisms[self.name]

    @property
    def materials(self) -> tuple[str, ...]:
        """The materials of its bodies, and of those that load it."""
        content = self.project.content
        return tuple(name for name in content.materials if self.name in dependents(content, ("materials", name)))


def variables_of(
    project: Project, study: Study, solids: Solids, build_study: StudyOfMechanism
) -> tuple[Variable | UnvariedNumber, ...]:
    """Return every variable of every mechanism of a study; none if no sensitivity is requested.

    build_study : builds the study of one mechanism from other content, with some bodies replaced
    """
    sensitivity = project.content.analysis.sensitivity
    if sensitivity is None:
        return ()
    swept = _mechanisms_in_sweeps(project)
    found: list[Variable | UnvariedNumber] = []
    for mechanism in study.mechanisms:
        if mechanism.name in swept:
            found.append(UnvariedNumber(mechanism.name, "", SWEPT))
        else:
            directed = _fix_direction(project, mechanism)
            found += _variables_of_mechanism(
                VariedMechanism(mechanism, study.amplified[mechanism.name], directed, solids, build_study), sensitivity
            )
    return tuple(found)


def numbers_of(subject: VariedMechanism) -> Iterator[VariedNumber]:
    """Yield the numbers of the project file that a mechanism depends on and that are seldom well known."""
    section, materials = subject.section, subject.project.content.materials
    if not isinstance(section, sections.ChainSection):
        yield VariedNumber("uplift", ("mechanisms", subject.name, "uplift"))
        yield VariedNumber("p", ("mechanisms", subject.name, "p"), "1/s")
        return
    for name in subject.materials:
        yield VariedNumber("density", ("materials", name, "density"), "kg/m^3")
    yield from _joint_numbers(subject, section)
    if subject.amplified.by_stiffness:
        for name in subject.materials:
            if materials[name].young_modulus is not None:
                yield VariedNumber("stiffness", ("materials", name, "young_modulus"), "Pa")
    for name in subject.materials:
        if materials[name].friction:
            yield VariedNumber("friction", ("materials", name, "friction"))
    yield from _load_numbers(subject, section)


class BlockBase(NamedTuple):
    """The base of the blocks along the direction of motion: its width and the place of its middle [m]."""

    width: float
    middle: float


def fixed_thickness_reason(subject: VariedMechanism, section: sections.ChainSection) -> str:
    """Say why the thickness of a mechanism's blocks cannot be varied; empty if it can."""
    direct = [name for block in section.blocks for name in block if subject.solids[name] is None]
    if direct:
        return f'body "{direct[0]}" has no geometry'
    if section.kind == "four-hinge" and section.joints is not None:
        return "the thickness of an arch is not its size along the direction"
    hinges = (getattr(section, key, None) for key in ("hinges", "hinges_negative"))
    if any(each is not None for each in hinges):
        return "its hinges are given as points, which do not move with the faces"
    definition: BlockMechanism = definition_of(section)
    joints = (definition.interface_at(hinge_name) for hinge_name in hinge_names(subject.mechanism.positive))
    if any(joint.shape != "outline" for joint in joints):
        return "the shape of a joint is given by its sizes, which do not follow"
    return ""


LOAD_TOLERANCE = 0.05  # share


def survey_of(
    project: Project, study: Study, solids: Mapping[str, Solid | None], build_study: StudyOfMechanism
) -> Survey:
    """Return what gives the numbers of a mechanism that the survey's tolerance bears on, by its name."""
    mechanisms = {mechanism.name: mechanism for mechanism in study.mechanisms}

    def variables(name: str) -> tuple[Variable, ...]:
        mechanism = mechanisms[name]
        subject = VariedMechanism(
            mechanism, study.amplified[name], _fix_direction(project, mechanism), solids, build_study
        )
        return tuple(_surveyed_variables(subject, tolerance=project.content.verdict.survey_tolerance))

    return variables


THICKNESS_GROUP = "thickness"
"""The group of the sizes that [analysis.uncertainty] thickness varies."""
UNCERTAINTY_KEY = "analysis.uncertainty"


class Cases(NamedTuple):
    """The bodies of a case by name, and what builds the study of one mechanism with some of them replaced."""

    solids: Solids
    build: Callable[[str, Mapping[str, Solid]], Study]


CasesOf = Callable[[sections.Content], Cases]


@dataclass(frozen=True)
class SampledThickness:
    """The blocks of a mechanism whose thickness is sampled: the table, and the base that they are scaled about."""

    section: sections.ChainSection
    base: BlockBase


def sampling_of(project: Project, study: Study, solids: Solids, cases_of: CasesOf) -> Sampling | None:
    """Return how the uncertain numbers of a project are sampled; None if it does not ask for that.

    Raises ProjectError if it asks and has none.
    """
    section = project.content.analysis.uncertainty
    if section is None:
        return None
    changed = _mechanisms_in_sweeps(project)
    swept = [mechanism.name for mechanism in study.mechanisms if mechanism.name in changed]
    directed = reduce(_fix_direction, (each for each in study.mechanisms if each.name not in swept), project)
    beside = {mechanism.name: mechanism.adjacent_bodies for mechanism in study.mechanisms}
    numbers = [
        SampledNumber(
            value.given,
            value.least,
            value.most,
            tuple(name for name in dependents(directed.content, value.path, beside=beside) if name not in swept),
        )
        for value in project.uncertain
    ]
    thicknesses: dict[str, SampledThickness] = {}

    def build_study(name: str, content: sections.Content, replaced: Mapping[str, Solid]) -> Study:
        return cases_of(content).build(name, replaced)

    notes = [note("uncertainty-left-out", f"mechanisms.{name}", why=Term(SWEPT)) for name in swept]
    if section.thickness is not None:
        found = dict(_sampled_thicknesses(directed, study, solids, build_study, swept))
        thicknesses = {name: each for name, each in found.items() if isinstance(each, SampledThickness)}
        for name, each in found.items():
            if isinstance(each, str):
                notes.append(note("uncertainty-thickness-left-out", f"mechanisms.{name}", why=Term(each)))
            else:
                key, mean = _key_of_thickness(each.section), each.base.width
                given = UncertainInput(key, "m", mean, section.thickness, "lognormal", THICKNESS_GROUP)
                numbers.append(SampledNumber(given, 0.0, float("inf"), (name,)))
    if not numbers:
        remedy = "write numbers as { mean, cov }, or thickness = 0.05 here"
        raise ProjectError(f"{UNCERTAINTY_KEY}: no number of the project is uncertain; {remedy}")
    study_at = partial(_study_at_samples, directed, project.uncertain, thicknesses, cases_of)
    return Sampling(section.samples, section.seed, tuple(numbers), study_at, tuple(notes))


def uncertainty_messages(project: Project) -> Iterator[Message]:
    """Report uncertain numbers that are used at their means, and hinges that stay while faces move."""
    content = project.content
    if project.uncertain and content.analysis.uncertainty is None:
        keys = ", ".join(value.given.key for value in project.uncertain)
        yield note("uncertainty-means", UNCERTAINTY_KEY, keys=keys)
        return
    for value in project.uncertain:
        if value.path[0] == "bodies" and value.path[-1] == "thickness":
            yield from (
                warning("uncertainty-hinges-stay", key_text(path), key=value.given.key)
                for path in _given_hinges(content, str(value.path[1]))
            )


def _mechanisms_in_sweeps(project: Project) -> set[str]:
    """Return the mechanisms that a parametric study of the project changes."""
    return {name for each in project.sweeps for name in dependents(project.content, each.path)}


def _fix_direction(project: Project, mechanism: Mechanism) -> Project:
    """Fix the direction and the sides that were found for a mechanism, so that they stay the same."""
    section = project.content.mechanisms[mechanism.name]
    if section.kind == "equivalent-block":
        return project
    raw = project.raw
    if section.direction in (None, "sweep") and mechanism.direction is not None:
        raw = with_value(raw, ("mechanisms", mechanism.name, "direction"), list(mechanism.direction), project.content)
    if section.sides is None:
        raw = with_value(raw, ("mechanisms", mechanism.name, "sides"), mechanism.sides, project.content)
    return replace(project, raw=raw, content=sections.Content.model_validate(raw, context={"folder": project.folder}))


def _variables_of_mechanism(
    subject: VariedMechanism, sensitivity: sections.Sensitivity
) -> Iterator[Variable | UnvariedNumber]:
    """Yield the variables of one mechanism that are requested."""
    if sensitivity.thickness is not None and isinstance(subject.section, sections.ChainSection):
        yield _vary_thickness(subject, subject.section, sensitivity.thickness)
    for number in dict.fromkeys(numbers_of(subject)):
        change = sensitivity.entries()[number.parameter]
        if change is not None:
            yield _vary_at_key(subject, number, change)
    if sensitivity.restitution is not None:
        yield _vary_restitution(subject, sensitivity.restitution)


def _joint_numbers(subject: VariedMechanism, section: sections.ChainSection) -> Iterator[VariedNumber]:
    """Yield strength and stiffness of the joints, each at the key that gives it."""
    content = subject.project.content
    bodies = (content.bodies[name] for block in section.blocks for name in block)
    name = next((body.material for body in bodies if not isinstance(body, sections.DirectBody)), None)
    material = None if name is None else content.materials[name]
    definition = definition_of(section)
    for hinge_name in hinge_names(subject.mechanism.positive):
        joint = definition.interface_at(hinge_name)
        own = ("interfaces", hinge_name) if hinge_name in section.interfaces else ("interface",)
        table = ("mechanisms", subject.name, *own)
        if joint.strength is not None and joint.strength < inf:
            yield VariedNumber("compressive_strength", (*table, "strength"), "Pa")
        elif joint.strength is None and joint.model != "rigid" and material and material.compressive_strength:
            yield VariedNumber("compressive_strength", ("materials", str(name), "compressive_strength"), "Pa")
        if joint.stiffness is not None and joint.stiffness < inf:
            yield VariedNumber("stiffness", (*table, "stiffness"), "Pa/m")
        elif joint.course_thickness is not None:
            yield VariedNumber("stiffness", ("materials", str(name), "young_modulus"), "Pa")


def _load_numbers(subject: VariedMechanism, section: sections.ChainSection) -> Iterator[VariedNumber]:
    """Yield the loads given as numbers; a force given by two components is two of them."""
    for place, load in enumerate(section.loads):
        path = ("mechanisms", subject.name, "loads", place)
        if load.kind == "tie":
            yield VariedNumber("tie_force", (*path, "force"), "N")
        elif (load.kind == "mass" or load.kind == "body") and load.mass is not None:
            yield VariedNumber("loads", (*path, "mass"), "kg")
        elif load.kind == "force" and isinstance(load.force, tuple):
            yield from (VariedNumber("loads", (*path, "force", i), "N") for i in (0, 1) if load.force[i])
        elif (load.kind == "force" or load.kind == "overburden") and load.force is not None:
            yield VariedNumber("loads", (*path, "force"), "N")


def _vary_at_key(subject: VariedMechanism, number: VariedNumber, change: sections.Change) -> Variable | UnvariedNumber:
    """Vary a number at its key."""
    base = float(value_at(subject.project.content, number.path))
    return _vary_between(
        Variable(
            mechanism=subject.name,
            parameter=number.parameter,
            key=key_text(number.path),
            unit=number.unit,
            base=base,
            low=base,
            high=base,
            study_at=partial(_study_with_number, subject, number.path),
        ),
        change,
    )


def _study_with_number(subject: VariedMechanism, path: KeyPath, value: Any) -> Study:
    """Return the study of the mechanism with another value at a key of the project."""
    project = subject.project
    raw = with_value(project.raw, path, value, project.content)
    content = read_case(raw, project.folder, path, value, name=key_text(path))
    return subject.build_study(subject.name, content, {})


def _vary_between(at_base: Variable, change: sections.Change) -> Variable | UnvariedNumber:
    """Set the range of a variable: its base minus the change to its base plus the change."""
    base = at_base.base
    by = change.by * (abs(base) if change.of == sections.SHARE else 1.0)
    if by >= abs(base):
        return UnvariedNumber(
            at_base.mechanism, at_base.parameter, "a change as large as the value itself leaves nothing"
        )
    return replace(at_base, low=base - by, high=base + by)


def _vary_restitution(subject: VariedMechanism, change: sections.Change) -> Variable | UnvariedNumber:
    """Vary the restitution of both branches in proportion, up to 1 at most."""
    first, second = subject.mechanism.restitution
    if first == 0.0:
        return UnvariedNumber(subject.name, "restitution", "it is 0: there is no rebound")
    path = ("mechanisms", subject.name, "restitution")

    def study_at(value: float) -> Study:
        both = {"positive": value, "negative": min(1.0, second * value / first)}
        return _study_with_number(subject, path, both)

    made = _vary_between(
        Variable(subject.name, "restitution", key_text(path), "-", first, first, first, study_at),
        change,
    )
    if isinstance(made, UnvariedNumber) or made.high <= 1.0:
        return made
    return replace(made, high=max(1.0, first), remark=AT_MOST_1)


def _vary_thickness(
    subject: VariedMechanism, section: sections.ChainSection, change: sections.Change
) -> Variable | UnvariedNumber:
    """Vary the size of the blocks along the direction about the middle of the base, whose thickness names it."""
    base = _block_base(subject, section)
    if isinstance(base, str):
        return UnvariedNumber(subject.name, "thickness", base)
    study_at = partial(_study_with_thickness, subject, section, width=base.width, middle=base.middle)
    return _vary_between(
        Variable(subject.name, "thickness", _key_of_thickness(section), "m", *(base.width,) * 3, study_at), change
    )


def _block_base(subject: VariedMechanism, section: sections.ChainSection) -> BlockBase | str:
    """Return the base about whose middle the blocks are scaled; or say why their thickness cannot be varied."""
    reason = fixed_thickness_reason(subject, section)
    if reason:
        return reason
    definition: BlockMechanism = definition_of(section)
    base = pieces_of(subject.name, definition, bodies_of(subject.project.content, subject.solids))[0].body.base
    assert base is not None  # every body has geometry
    (low, _), (high, _) = base
    return BlockBase(high - low, (low + high) / 2.0) if high > low else "it stands on an edge"


def _key_of_thickness(section: sections.ChainSection) -> str:
    """Name the thickness of all blocks of a mechanism, which is no single number of the file."""
    return f"thickness of {', '.join(name for block in section.blocks for name in block)}"


def _study_with_thickness(
    subject: VariedMechanism, section: sections.ChainSection, value: float, *, width: float, middle: float
) -> Study:
    """Return the study of the mechanism with blocks as thick as `value` [m] at a base of width `width` [m]."""
    blocks = _thick_blocks(section, subject.solids, factor=value / width, middle=middle)
    return subject.build_study(subject.name, subject.project.content, blocks)


def _thick_blocks(section: sections.ChainSection, solids: Solids, *, factor: float, middle: float) -> dict[str, Solid]:
    """Return the blocks of a mechanism scaled along its direction about `middle` [m]."""
    bodies = {name: solid for block in section.blocks for name in block if (solid := solids[name]) is not None}
    towards = definition_of(section).towards
    return {name: scale_along(each, direction=towards, middle=middle, factor=factor) for name, each in bodies.items()}


def _surveyed_variables(subject: VariedMechanism, *, tolerance: float) -> Iterator[Variable]:
    section = subject.section
    if not isinstance(section, sections.ChainSection) or tolerance == 0.0:
        return
    found = [_vary_thickness(subject, section, sections.Change(tolerance, "m"))]
    found += [
        _vary_at_key(subject, number, sections.Change(LOAD_TOLERANCE)) for number in _load_numbers(subject, section)
    ]
    yield from (each for each in found if isinstance(each, Variable))
    yield from _hinge_variables(subject, section, tolerance)


def _hinge_variables(subject: VariedMechanism, section: sections.ChainSection, tolerance: float) -> Iterator[Variable]:
    """Yield each given hinge, moved along the direction of motion."""
    for table in ("hinges", "hinges_negative"):
        given = getattr(section, table, None)
        if not isinstance(given, sections.HingesSection):
            continue
        for hinge_name, place in given.entries().items():
            path: KeyPath = ("mechanisms", subject.name, table, hinge_name)
            move = partial(_study_with_moved_hinge, subject, path, place, definition_of(section).towards)
            yield Variable(subject.name, "hinge", key_text(path), "m", 0.0, -tolerance, tolerance, move)


def _study_with_moved_hinge(
    subject: VariedMechanism, path: KeyPath, place: tuple[float, ...], direction: Sequence[float], shift: float
) -> Study:
    """Return the study with a hinge moved by `shift` [m] along the direction."""
    length = sum(each**2 for each in direction) ** 0.5
    way = (1.0, 0.0) if len(place) == 2 else tuple(each / length for each in direction)
    project, moved = subject.project, [at + shift * each for at, each in zip(place, way, strict=True)]
    raw = with_value(project.raw, path, moved, project.content)
    content = sections.Content.model_validate(raw, context={"folder": project.folder})
    return subject.build_study(subject.name, content, {})


def _sampled_thicknesses(
    project: Project, study: Study, solids: Solids, build_study: StudyOfMechanism, swept: Sequence[str]
) -> Iterator[tuple[str, SampledThickness | str]]:
    """Yield the mechanisms whose thickness no number of the file varies, or why it cannot be varied."""
    own = {value.path[1] for value in project.uncertain if value.path[0] == "bodies"}
    for mechanism in study.mechanisms:
        section = project.content.mechanisms[mechanism.name]
        if mechanism.name in swept or not isinstance(section, sections.ChainSection):
            continue
        if own & {name for block in section.blocks for name in block}:
            continue
        subject = VariedMechanism(mechanism, study.amplified[mechanism.name], project, solids, build_study)
        base = _block_base(subject, section)
        yield mechanism.name, base if isinstance(base, str) else SampledThickness(section, base)


def _study_at_samples(
    project: Project,
    uncertain: Sequence[UncertainValue],
    thicknesses: Mapping[str, SampledThickness],
    cases_of: CasesOf,
    values: Sequence[float],
) -> Callable[[str], Study]:
    """Return what builds the study of each mechanism at values of the numbers; those of `thicknesses` come last.

    Raises ProjectError if the schema refuses the values.
    """
    at_keys, widths = values[: len(uncertain)], dict(zip(thicknesses, values[len(uncertain) :], strict=True))
    raw = project.raw
    for number, value in zip(uncertain, at_keys, strict=True):
        raw = with_value(raw, number.path, value, project.content)
    try:
        content = sections.Content.model_validate(raw, context={"folder": project.folder})
    except ValidationError as error:
        raise ProjectError(error_line(error, raw=raw)) from None
    cases = cases_of(content)

    def build(name: str) -> Study:
        if name not in thicknesses:
            return cases.build(name, {})
        section, base = thicknesses[name].section, thicknesses[name].base
        factor = widths[name] / base.width
        return cases.build(name, _thick_blocks(section, cases.solids, factor=factor, middle=base.middle))

    return build


def _given_hinges(content: sections.Content, body: str) -> Iterator[KeyPath]:
    """Yield the keys of hinges given as points of mechanisms that a body is a block of."""
    for name, section in content.mechanisms.items():
        if isinstance(section, sections.ChainSection) and any(body in block for block in section.blocks):
            given = (
                key
                for key in ("hinges", "hinges_negative")
                if isinstance(getattr(section, key), sections.HingesSection)
            )
            yield from (("mechanisms", name, key) for key in given)
