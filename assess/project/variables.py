"""Which numbers of each mechanism its sensitivity varies, between which values.

A number of the project file is varied at its key, and the whole is read through the schema again, as a sweep does; the
thickness is varied on the bodies themselves.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from math import inf
from typing import Any, NamedTuple

from assess.geometry.affine import scale_along
from assess.geometry.solid import Solid, Solids
from assess.mechanisms.chain import hinge_names
from assess.mechanisms.mechanism import Mechanism
from assess.model.definitions import Chained
from assess.model.pieces import pieces_of
from assess.project import sections
from assess.project.bodies import bodies_of
from assess.project.definitions import definition_of
from assess.project.dependents import dependents
from assess.project.key_text import key_text
from assess.project.keys import Key, value_at, with_value
from assess.project.schema import Project
from assess.project.variations import read_case
from assess.study.study import Amplified, Study, Unvaried, Variable

Alone = Callable[[str, sections.Content, Mapping[str, Solid]], Study]
FULL = "at most 1: more would add velocity at the impact"
SWEPT = "a parametric study changes the mechanism; write the value of its controlling case in its place"


@dataclass(frozen=True)
class Number:
    """A number of the project file: what it is to the mechanism, its key, its unit in SI."""

    parameter: str
    path: Key
    unit: str = "-"


@dataclass(frozen=True)
class Subject:
    """A mechanism as built, with what the project says of it, its direction included where that was sought."""

    mechanism: Mechanism
    amplified: Amplified
    project: Project
    solids: Solids
    alone: Alone

    @property
    def name(self) -> str:
        """The name of the mechanism."""
        return self.mechanism.name

    @property
    def section(self) -> sections.Mechanism:
        """The table of the mechanism."""
        return self.project.content.mechanisms[self.name]

    @property
    def materials(self) -> tuple[str, ...]:
        """The materials of its bodies, and of those that load it."""
        content = self.project.content
        return tuple(name for name in content.materials if self.name in dependents(content, ("materials", name)))


def variables_of(project: Project, study: Study, solids: Solids, alone: Alone) -> tuple[Variable | Unvaried, ...]:
    """Return every variable of every mechanism of a study; none if no sensitivity is requested.

    alone : builds the study of one mechanism from other content, with some bodies replaced
    """
    asked = project.content.analysis.sensitivity
    if asked is None:
        return ()
    swept = {name for each in project.variations for name in dependents(project.content, each.path)}
    found: list[Variable | Unvaried] = []
    for mechanism in study.mechanisms:
        if mechanism.name in swept:
            found.append(Unvaried(mechanism.name, "", SWEPT))
        else:
            faced = turn_towards(project, mechanism)
            found += of_mechanism(Subject(mechanism, study.amplified[mechanism.name], faced, solids, alone), asked)
    return tuple(found)


def turn_towards(project: Project, mechanism: Mechanism) -> Project:
    """Fix the direction and the sides that were found for a mechanism, so that they stay the same."""
    section = project.content.mechanisms[mechanism.name]
    if isinstance(section, sections.EquivalentBlock):
        return project
    raw = project.raw
    if section.direction in (None, "sweep") and mechanism.direction is not None:
        raw = with_value(raw, ("mechanisms", mechanism.name, "direction"), list(mechanism.direction), project.content)
    if section.sides is None:
        raw = with_value(raw, ("mechanisms", mechanism.name, "sides"), mechanism.sides, project.content)
    return replace(project, raw=raw, content=sections.Content.model_validate(raw, context={"folder": project.folder}))


def of_mechanism(subject: Subject, asked: sections.Sensitivity) -> Iterator[Variable | Unvaried]:
    """Yield the variables of one mechanism that are requested."""
    if asked.thickness is not None and isinstance(subject.section, sections.Chained):
        yield thickness(subject, subject.section, asked.thickness)
    for number in dict.fromkeys(numbers_of(subject)):
        change = asked.entries()[number.parameter]
        if change is not None:
            yield at_key(subject, number, change)
    if asked.restitution is not None:
        yield restitution(subject, asked.restitution)


def numbers_of(subject: Subject) -> Iterator[Number]:
    """Yield the numbers of the project file that a mechanism depends on and that are seldom well known."""
    section, materials = subject.section, subject.project.content.materials
    if isinstance(section, sections.EquivalentBlock):
        yield Number("uplift", ("mechanisms", subject.name, "uplift"))
        yield Number("p", ("mechanisms", subject.name, "p"), "1/s")
        return
    for name in subject.materials:
        yield Number("density", ("materials", name, "density"), "kg/m^3")
    yield from of_joints(subject, section)
    if subject.amplified.by_stiffness:
        for name in subject.materials:
            if materials[name].young_modulus is not None:
                yield Number("stiffness", ("materials", name, "young_modulus"), "Pa")
    for name in subject.materials:
        if materials[name].friction:
            yield Number("friction", ("materials", name, "friction"))
    yield from of_loads(subject, section)


def of_joints(subject: Subject, section: sections.Chained) -> Iterator[Number]:
    """Yield strength and stiffness of the joints, each at the key that gives it."""
    content = subject.project.content
    bodies = (content.bodies[name] for block in section.blocks for name in block)
    name = next((body.material for body in bodies if not isinstance(body, sections.DirectBody)), None)
    material = None if name is None else content.materials[name]
    definition = definition_of(section)
    for letter in hinge_names(subject.mechanism.positive):
        joint = definition.interface_at(letter)
        own = ("interfaces", letter) if letter in section.interfaces else ("interface",)
        table = ("mechanisms", subject.name, *own)
        if joint.strength is not None and joint.strength < inf:
            yield Number("compressive_strength", (*table, "strength"), "Pa")
        elif joint.strength is None and joint.model != "rigid" and material and material.compressive_strength:
            yield Number("compressive_strength", ("materials", str(name), "compressive_strength"), "Pa")
        if joint.stiffness is not None and joint.stiffness < inf:
            yield Number("stiffness", (*table, "stiffness"), "Pa/m")
        elif joint.course_thickness is not None:
            yield Number("stiffness", ("materials", str(name), "young_modulus"), "Pa")


def of_loads(subject: Subject, section: sections.Chained) -> Iterator[Number]:
    """Yield the loads given as numbers; a force given by two components is two of them."""
    for place, load in enumerate(section.loads):
        path = ("mechanisms", subject.name, "loads", place)
        if isinstance(load, sections.TieLoad):
            yield Number("tie_force", (*path, "force"), "N")
        elif isinstance(load, sections.MassLoad | sections.BodyLoad) and load.mass is not None:
            yield Number("loads", (*path, "mass"), "kg")
        elif isinstance(load, sections.ForceLoad) and isinstance(load.force, tuple):
            yield from (Number("loads", (*path, "force", i), "N") for i in (0, 1) if load.force[i])
        elif isinstance(load, sections.ForceLoad | sections.OverburdenLoad) and load.force is not None:
            yield Number("loads", (*path, "force"), "N")


def at_key(subject: Subject, number: Number, change: sections.Change) -> Variable | Unvaried:
    """Vary a number at its key."""
    base = float(value_at(subject.project.content, number.path))
    return vary_between(
        Variable(
            mechanism=subject.name,
            parameter=number.parameter,
            key=key_text(number.path),
            unit=number.unit,
            base=base,
            low=base,
            high=base,
            study_at=partial(with_number, subject, number.path),
        ),
        change,
    )


def with_number(subject: Subject, path: Key, value: Any) -> Study:
    """Return the study of the mechanism with another value at a key of the project."""
    project = subject.project
    raw = with_value(project.raw, path, value, project.content)
    content = read_case(raw, project.folder, path, value, name=key_text(path))
    return subject.alone(subject.name, content, {})


def vary_between(at_base: Variable, change: sections.Change) -> Variable | Unvaried:
    """Set the range of a variable: its base minus the change to its base plus the change."""
    base = at_base.base
    by = change.by * (abs(base) if change.of == sections.SHARE else 1.0)
    if by >= abs(base):
        return Unvaried(at_base.mechanism, at_base.parameter, "a change as large as the value itself leaves nothing")
    return replace(at_base, low=base - by, high=base + by)


def restitution(subject: Subject, change: sections.Change) -> Variable | Unvaried:
    """Vary the restitution of both branches in proportion, up to 1 at most."""
    first, second = subject.mechanism.restitution
    if first == 0.0:
        return Unvaried(subject.name, "restitution", "it is 0: there is no rebound")
    path = ("mechanisms", subject.name, "restitution")

    def study_at(value: float) -> Study:
        both = {"positive": value, "negative": min(1.0, second * value / first)}
        return with_number(subject, path, both)

    made = vary_between(
        Variable(subject.name, "restitution", key_text(path), "-", first, first, first, study_at),
        change,
    )
    if isinstance(made, Unvaried) or made.high <= 1.0:
        return made
    return replace(made, high=max(1.0, first), remark=FULL)


def thickness(subject: Subject, section: sections.Chained, change: sections.Change) -> Variable | Unvaried:
    """Vary the size of the blocks along the direction about the middle of the base, whose thickness names it."""
    foot = foot_of(subject, section)
    if isinstance(foot, str):
        return Unvaried(subject.name, "thickness", foot)
    study_at = partial(thicken, subject, section, width=foot.width, middle=foot.middle)
    return vary_between(
        Variable(subject.name, "thickness", key_of_thickness(section), "m", *(foot.width,) * 3, study_at), change
    )


class Foot(NamedTuple):
    """The base of the blocks along the direction of motion: its width and the place of its middle [m]."""

    width: float
    middle: float


def foot_of(subject: Subject, section: sections.Chained) -> Foot | str:
    """Return the base about whose middle the blocks are scaled; or say why their thickness cannot be varied."""
    why = stiff_geometry(subject, section)
    if why:
        return why
    definition: Chained = definition_of(section)
    foot = pieces_of(subject.name, definition, bodies_of(subject.project.content, subject.solids))[0].body.base
    assert foot is not None  # every body has geometry
    (low, _), (high, _) = foot
    return Foot(high - low, (low + high) / 2.0) if high > low else "it stands on an edge"


def key_of_thickness(section: sections.Chained) -> str:
    """Name the thickness of all blocks of a mechanism, which is no single number of the file."""
    return f"thickness of {', '.join(name for block in section.blocks for name in block)}"


def stiff_geometry(subject: Subject, section: sections.Chained) -> str:
    """Say why the thickness of a mechanism's blocks cannot be varied; empty if it can."""
    direct = [name for block in section.blocks for name in block if subject.solids[name] is None]
    if direct:
        return f'body "{direct[0]}" has no geometry'
    if isinstance(section, sections.FourHinge) and section.joints is not None:
        return "the thickness of an arch is not its size along the direction"
    hinges = (getattr(section, key, None) for key in ("hinges", "hinges_negative"))
    if any(each is not None for each in hinges):
        return "its hinges are given as points, which do not move with the faces"
    definition: Chained = definition_of(section)
    joints = (definition.interface_at(letter) for letter in hinge_names(subject.mechanism.positive))
    if any(joint.shape != "outline" for joint in joints):
        return "the shape of a joint is given by its sizes, which do not follow"
    return ""


def thicken(subject: Subject, section: sections.Chained, value: float, *, width: float, middle: float) -> Study:
    """Return the study of the mechanism with blocks as thick as `value` [m] at a base of width `width` [m]."""
    thick = thick_blocks(section, subject.solids, factor=value / width, middle=middle)
    return subject.alone(subject.name, subject.project.content, thick)


def thick_blocks(section: sections.Chained, solids: Solids, *, factor: float, middle: float) -> dict[str, Solid]:
    """Return the blocks of a mechanism scaled along its direction about `middle` [m]."""
    bodies = {name: solid for block in section.blocks for name in block if (solid := solids[name]) is not None}
    towards = definition_of(section).towards
    return {name: scale_along(each, direction=towards, middle=middle, factor=factor) for name, each in bodies.items()}
