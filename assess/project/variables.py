"""Which numbers of each mechanism are varied, and its study at other values of them.

The sensitivity varies one number at a time, the survey's tolerance bears on thicknesses, given hinges and loads, and
uncertain numbers are sampled together: each says by a `Setting` which numbers differ, and `Variants.at` builds the
study with these. A number of the project file is set at its key, and the whole is read through the schema again, as a
sweep does; the thickness is set on the bodies themselves. The direction and the sides that were found at the values
given are kept.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import chain
from math import inf
from typing import Any, NamedTuple, cast

from assess.declaration import Number, annotations_of, marks_of
from assess.errors import ProjectError
from assess.geometry.solid import Solid, Solids, scale_along
from assess.loads.load import LOADS
from assess.mechanisms.chain import hinge_names
from assess.mechanisms.mechanism import BlockMechanism, Mechanism
from assess.messages.message import Message, Term, note, warning
from assess.model.bodies import pieces_of
from assess.project import sections
from assess.project.bars import same_bar, with_bars
from assess.project.key_errors import KeyPath, key_text
from assess.project.keys import Setting, UncertainValue, dependents, read_case, value_at, with_values
from assess.project.project_file import Project
from assess.project.site_and_structure import bodies_of
from assess.project.units import KINDS
from assess.results.run import UncertainInput
from assess.study.amplification import MechanismAmplification
from assess.study.study import SampledNumber, Sampling, Study, UnvariedNumber, Variable
from assess.study.variations import Survey

AT_MOST_1 = "at most 1: more would add velocity at the impact"
SWEPT = "a parametric study changes the mechanism; write the value of its controlling case in its place"


class Cases(NamedTuple):
    """The bodies of a case by name, and what builds the study of one mechanism with some of them replaced."""

    solids: Solids
    build: Callable[[str, Mapping[str, Solid]], Study]


class Stretch(NamedTuple):
    """The factor on the size of a mechanism's blocks along its direction, and the place that stays where it is [m]."""

    factor: float
    middle: float


@dataclass(frozen=True)
class Variants:
    """A project that can be built again with other numbers.

    solids : its bodies by name, None without geometry
    cases_of : returns the bodies and the builder that other content of the project leads to
    """

    project: Project
    solids: Solids
    cases_of: Callable[[sections.Content], Cases]

    def at(self, setting: Setting, *, name: str = "") -> Callable[[str], Study]:
        """Return what builds the study of each mechanism by its name, with other numbers.

        setting : values by their keys, and a `Stretch` at the thickness of a mechanism
        name : of the case, for errors; these say key and value if it is empty

        Raises ProjectError if the schema refuses the values.
        """
        content, project = self.project.content, self.project
        at_keys = {path: value for path, value in setting.items() if not isinstance(value, Stretch)}
        if at_keys:
            content = read_case(with_bars(at_keys, content), content, project.raw, project.folder, name=name)
        cases = self.cases_of(content)

        def build(mechanism: str) -> Study:
            stretch = setting.get(_thickness_path(mechanism))
            section = content.mechanisms[mechanism]
            if stretch is None or not isinstance(section, sections.ChainSection):
                return cases.build(mechanism, {})
            return cases.build(mechanism, _stretched_blocks(section, cases.solids, stretch))

        return build

    def with_directions(self, mechanisms: Iterable[Mechanism]) -> Variants:
        """Fix the direction and the sides that were found for mechanisms, so that they stay the same."""
        project, found = self.project, dict[KeyPath, Any]()
        for mechanism in mechanisms:
            section, path = project.content.mechanisms[mechanism.name], ("mechanisms", mechanism.name)
            if section.kind == "equivalent-block":
                continue
            if section.direction in (None, "sweep") and mechanism.direction is not None:
                found[*path, "direction"] = list(mechanism.direction)
            if section.sides is None:
                found[*path, "sides"] = mechanism.sides
        if not found:
            return self
        raw = with_values(project.raw, found, project.content)
        content = sections.Content.model_validate(raw, context={"folder": project.folder})
        return replace(self, project=replace(project, raw=raw, content=content))


class VariedNumber(NamedTuple):
    """A number of the project file: what it is to the mechanism, its key, its unit in SI."""

    parameter: str
    path: KeyPath
    unit: str = "-"


@dataclass(frozen=True)
class VariedMechanism:
    """A mechanism as built, and the project that it is varied in, with its direction fixed."""

    mechanism: Mechanism
    amplified: MechanismAmplification
    variants: Variants

    @property
    def name(self) -> str:
        """The name of the mechanism."""
        return self.mechanism.name

    @property
    def content(self) -> sections.Content:
        """The tables of the project."""
        return self.variants.project.content

    @property
    def section(self) -> sections.MechanismSection:
        """The table of the mechanism."""
        return self.content.mechanisms[self.name]

    @property
    def materials(self) -> tuple[str, ...]:
        """The materials of its bodies, and of those that load it."""
        content = self.content
        return tuple(name for name in content.materials if self.name in dependents(content, ("materials", name)))


def variables_of(variants: Variants, study: Study) -> tuple[Variable | UnvariedNumber, ...]:
    """Return every variable of every mechanism of a study; none if no sensitivity is requested."""
    sensitivity = variants.project.content.analysis.sensitivity
    if sensitivity is None:
        return ()
    swept = _mechanisms_in_sweeps(variants.project)
    directed = variants.with_directions(each for each in study.mechanisms if each.name not in swept)
    found: list[Variable | UnvariedNumber] = []
    for mechanism in study.mechanisms:
        if mechanism.name in swept:
            found.append(UnvariedNumber(mechanism.name, "", SWEPT))
        else:
            subject = VariedMechanism(mechanism, study.amplified[mechanism.name], directed)
            found += _variables_of_mechanism(subject, sensitivity)
    return tuple(found)


def numbers_of(subject: VariedMechanism) -> Iterator[VariedNumber]:
    """Yield the numbers of the project file that a mechanism depends on and that are seldom well known."""
    section, materials = subject.section, subject.content.materials
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

    def stretch_to(self, mechanism: str, width: float) -> Setting:
        """Set the width of the base, and with it the size of all blocks of the mechanism along its direction."""
        return {_thickness_path(mechanism): Stretch(width / self.width, self.middle)}


def fixed_thickness_reason(subject: VariedMechanism, section: sections.ChainSection) -> str:
    """Say why the thickness of a mechanism's blocks cannot be varied; empty if it can."""
    direct = [name for name in _blocks_of(section) if subject.variants.solids[name] is None]
    if direct:
        return f'body "{direct[0]}" has no geometry'
    if section.kind == "four-hinge" and section.joints is not None:
        return "the thickness of an arch is not its size along the direction"
    hinges = (getattr(section, key, None) for key in ("hinges", "hinges_negative"))
    if any(each is not None for each in hinges):
        return "its hinges are given as points, which do not move with the faces"
    definition: BlockMechanism = section.plain
    joints = (definition.interface_at(hinge_name) for hinge_name in hinge_names(subject.mechanism.positive))
    if any(joint.shape != "outline" for joint in joints):
        return "the shape of a joint is given by its sizes, which do not follow"
    return ""


LOAD_TOLERANCE = 0.05  # share


def survey_of(variants: Variants, study: Study) -> Survey:
    """Return what gives the numbers of a mechanism that the survey's tolerance bears on, by its name."""
    mechanisms = {mechanism.name: mechanism for mechanism in study.mechanisms}
    tolerance = variants.project.content.verdict.survey_tolerance

    def variables(name: str) -> tuple[Variable, ...]:
        directed = variants.with_directions([mechanisms[name]])
        subject = VariedMechanism(mechanisms[name], study.amplified[name], directed)
        return tuple(_surveyed_variables(subject, tolerance=tolerance))

    return variables


THICKNESS_GROUP = "thickness"
"""The group of the sizes that [analysis.uncertainty] thickness varies."""
UNCERTAINTY_KEY = "analysis.uncertainty"


def sampling_of(variants: Variants, study: Study) -> Sampling | None:
    """Return how the uncertain numbers of a project are sampled; None if it does not ask for that.

    Raises ProjectError if it asks and has none.
    """
    project = variants.project
    section = project.content.analysis.uncertainty
    if section is None:
        return None
    swept = _mechanisms_in_sweeps(project)
    sampled = [mechanism for mechanism in study.mechanisms if mechanism.name not in swept]
    directed = variants.with_directions(sampled)
    content = directed.project.content
    touching = {mechanism.name: mechanism.adjacent_bodies for mechanism in study.mechanisms}
    uncertain: list[UncertainValue] = []
    for value in project.uncertain:  # of a bar that several mechanisms state, once
        if {each.path for each in uncertain}.isdisjoint(same_bar(value.path, content)):
            uncertain.append(value)
    numbers = [
        SampledNumber(
            value.given,
            value.least,
            value.most,
            tuple(name for name in dependents(content, value.path, touching=touching) if name not in swept),
        )
        for value in uncertain
    ]
    settings: list[Callable[[float], Setting]] = [partial(_set_at_key, value.path) for value in uncertain]
    notes = [
        note("uncertainty-left-out", f"mechanisms.{mechanism.name}", why=Term(SWEPT))
        for mechanism in study.mechanisms
        if mechanism.name in swept
    ]
    if section.thickness is not None:
        for name, key, base in _sampled_bases(directed, study, sampled):
            if isinstance(base, str):
                notes.append(note("uncertainty-thickness-left-out", f"mechanisms.{name}", why=Term(base)))
                continue
            given = UncertainInput(key, "m", base.width, section.thickness, "lognormal", THICKNESS_GROUP)
            numbers.append(SampledNumber(given, 0.0, inf, (name,)))
            settings.append(partial(base.stretch_to, name))
    if not numbers:
        remedy = "write numbers as { mean, cov }, or thickness = 0.05 here"
        raise ProjectError(f"{UNCERTAINTY_KEY}: no number of the project is uncertain; {remedy}")

    def study_at(values: Sequence[float]) -> Callable[[str], Study]:
        found = (setting(value).items() for setting, value in zip(settings, values, strict=True))
        return directed.at(dict(chain.from_iterable(found)))

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


def _blocks_of(section: sections.ChainSection) -> tuple[str, ...]:
    """Return the bodies that the blocks of a mechanism are made of."""
    return tuple(name for block in section.blocks for name in block)


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
    content = subject.content
    bodies = (content.bodies[name] for name in _blocks_of(section))
    name = next((body.material for body in bodies if not isinstance(body, sections.DirectBody)), None)
    material = None if name is None else content.materials[name]
    definition = section.plain
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
        key, parameter = LOADS[load.kind].varied
        value, unit = getattr(load, key), _unit_of_load(load.kind, key)
        if isinstance(value, tuple):
            yield from (VariedNumber(parameter, (*path, key, i), unit) for i, each in enumerate(value) if each)
        elif value is not None:
            yield VariedNumber(parameter, (*path, key), unit)


def _unit_of_load(kind: str, key: str) -> str:
    """Return the SI unit of a number of a kind of load, by its declared dimension."""
    marks = marks_of(annotations_of(cast(Any, LOADS[kind]))[key])
    return next(KINDS[mark.dimension].symbol for mark in marks if isinstance(mark, Number))


def _set_at_key(path: KeyPath, value: Any) -> Setting:
    """Set the number at a key."""
    return {path: value}


def _thickness_path(mechanism: str) -> KeyPath:
    """Name the thickness of the blocks of a mechanism, which is no key of the file."""
    return ("thickness", mechanism)


def _variable(
    subject: VariedMechanism,
    parameter: str,
    key: str,
    unit: str,
    base: float,
    setting: Callable[[float], Setting],
    change: sections.Change,
) -> Variable | UnvariedNumber:
    """Vary a number between its base minus the change and its base plus the change."""
    by = change.by * (abs(base) if change.of == sections.SHARE else 1.0)
    if by >= abs(base):
        return UnvariedNumber(subject.name, parameter, "a change as large as the value itself leaves nothing")
    study_at = partial(_study_at, subject, key, setting)
    return Variable(subject.name, parameter, key, unit, base, base - by, base + by, study_at)


def _study_at(subject: VariedMechanism, key: str, setting: Callable[[float], Setting], value: float) -> Study:
    """Return the study of a mechanism alone with another value of a number."""
    return subject.variants.at(setting(value), name=key)(subject.name)


def _vary_at_key(subject: VariedMechanism, number: VariedNumber, change: sections.Change) -> Variable | UnvariedNumber:
    """Vary a number at its key."""
    parameter, path, unit = number
    base = float(value_at(subject.content, path))
    return _variable(subject, parameter, key_text(path), unit, base, partial(_set_at_key, path), change)


def _vary_restitution(subject: VariedMechanism, change: sections.Change) -> Variable | UnvariedNumber:
    """Vary the restitution of both branches in proportion, up to 1 at most."""
    first, second = subject.mechanism.restitution
    if first == 0.0:
        return UnvariedNumber(subject.name, "restitution", "it is 0: there is no rebound")
    path = ("mechanisms", subject.name, "restitution")

    def setting(value: float) -> Setting:
        return {path: {"positive": value, "negative": min(1.0, second * value / first)}}

    made = _variable(subject, "restitution", key_text(path), "-", first, setting, change)
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
    setting = partial(base.stretch_to, subject.name)
    return _variable(subject, "thickness", _key_of_thickness(section), "m", base.width, setting, change)


def _block_base(subject: VariedMechanism, section: sections.ChainSection) -> BlockBase | str:
    """Return the base about whose middle the blocks are scaled; or say why their thickness cannot be varied."""
    reason = fixed_thickness_reason(subject, section)
    if reason:
        return reason
    definition: BlockMechanism = section.plain
    base = pieces_of(subject.name, definition, bodies_of(subject.content, subject.variants.solids))[0].body.base
    assert base is not None  # every body has geometry
    (low, _), (high, _) = base
    return BlockBase(high - low, (low + high) / 2.0) if high > low else "it stands on an edge"


def _key_of_thickness(section: sections.ChainSection) -> str:
    """Name the thickness of all blocks of a mechanism, which is no single number of the file."""
    return f"thickness of {', '.join(_blocks_of(section))}"


def _stretched_blocks(section: sections.ChainSection, solids: Solids, stretch: Stretch) -> dict[str, Solid]:
    """Return the blocks of a mechanism scaled along its direction."""
    bodies = {name: solid for name in _blocks_of(section) if (solid := solids[name]) is not None}
    factor, middle = stretch
    towards = section.plain.towards
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
    towards = section.plain.towards
    for table in ("hinges", "hinges_negative"):
        given = getattr(section, table, None)
        if not isinstance(given, sections.HingesSection):
            continue
        for hinge_name, place in given.entries().items():
            path: KeyPath = ("mechanisms", subject.name, table, hinge_name)
            study_at = partial(_study_at, subject, key_text(path), partial(_move_hinge, path, place, towards))
            yield Variable(subject.name, "hinge", key_text(path), "m", 0.0, -tolerance, tolerance, study_at)


def _move_hinge(path: KeyPath, place: tuple[float, ...], direction: Sequence[float], shift: float) -> Setting:
    """Move a hinge by `shift` [m] along the direction."""
    length = sum(each**2 for each in direction) ** 0.5
    way = (1.0, 0.0) if len(place) == 2 else tuple(each / length for each in direction)
    return {path: [at + shift * each for at, each in zip(place, way, strict=True)]}


def _sampled_bases(
    directed: Variants, study: Study, mechanisms: Iterable[Mechanism]
) -> Iterator[tuple[str, str, BlockBase | str]]:
    """Yield the mechanisms whose thickness no number of the file varies: name, key, and base or why it cannot vary."""
    own = {value.path[1] for value in directed.project.uncertain if value.path[0] == "bodies"}
    for mechanism in mechanisms:
        subject = VariedMechanism(mechanism, study.amplified[mechanism.name], directed)
        section = subject.section
        if isinstance(section, sections.ChainSection) and own.isdisjoint(_blocks_of(section)):
            yield subject.name, _key_of_thickness(section), _block_base(subject, section)


def _given_hinges(content: sections.Content, body: str) -> Iterator[KeyPath]:
    """Yield the keys of hinges given as points of mechanisms that a body is a block of."""
    for name, section in content.mechanisms.items():
        if isinstance(section, sections.ChainSection) and body in _blocks_of(section):
            given = (
                key
                for key in ("hinges", "hinges_negative")
                if isinstance(getattr(section, key), sections.HingesSection)
            )
            yield from (("mechanisms", name, key) for key in given)
