"""What the engineer should know of a project's input before reading any result: bodies, joints, motion, numbers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from assess.codes.bases import BASES
from assess.codes.check import Family
from assess.codes.italian_limit_states import LARGEST_FACTOR, ItalianOptions
from assess.codes.procedures import KNOWLEDGE_CODES, PROCEDURES
from assess.codes.question import methods_of
from assess.dynamics.packing import Equation
from assess.geometry.formats.readers import WITHOUT_UNIT
from assess.geometry.mesh import size_warning
from assess.geometry.solid import Solid
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity, locate, note, warning
from assess.project import sections
from assess.project.bars import bars_of
from assess.project.key_errors import key_text
from assess.project.keys import stated_values
from assess.project.question import procedures_of
from assess.project.section import ProjectSection
from assess.project.sections.content import TO_FILL_IN
from assess.results.provenance import count_from_0, tables_that_hold
from assess.study.mechanism_results import load_messages
from assess.study.study import Study, follows_motion
from spectra.gravity import g
from spectra.spectrum import LARGEST_PLAUSIBLE

SAME_MODE = 0.05  # by how much two first modes of one building may differ
LIGHTEST, DENSEST = 100.0, 3500.0  # kg/m3: straw and cork, basalt; metals are denser, and no wall is made of them
ROUGHEST = 2.0  # coefficient of friction of masonry on masonry: tests give 0.3 to 1.2
SHORTEST_CORNER, LONGEST_CORNER = 0.1, 1.0  # s: T_C* of NTC 2018 is between them everywhere in Italy


def project_messages(
    content: sections.Content,
    solids: Mapping[str, Solid | None],
    study: Study,
) -> Iterator[Message]:
    """Yield what the engineer should know before reading any result."""
    mechanisms = study.mechanisms
    yield from _implausible_numbers(content)
    yield from _one_bar_twice(content)
    yield from _sources_of_too_much(content)
    for name, solid in solids.items():
        if solid is not None:
            yield from _body_messages(name, solid, content.bodies[name])
    for mechanism in mechanisms:
        yield from locate(mechanism.warnings, f"mechanisms.{mechanism.name}")
        yield from load_messages(mechanism)
        yield from mechanism.messages
    yield from _equation_messages(content.analysis.equation, mechanisms)
    raised = [mechanism.name for mechanism in mechanisms if study.heights[mechanism.name].above]
    yield from _amplification_messages(raised, study)
    yield from _first_mode_messages(content)
    with_options = {PROCEDURES[name].options for name in procedures_of(content)}
    for code in KNOWLEDGE_CODES:
        if code in with_options:
            yield from _crushing_messages(code, BASES[code].circular, getattr(content.procedures, code), mechanisms)


def _sources_of_too_much(content: sections.Content) -> Iterator[Message]:
    """Yield each source that vouches for no value: of a table that is too large for one, or still to be filled in."""
    if not content.report.sources:
        return
    values = (each for each in stated_values(content) if not isinstance(each.value, ProjectSection))
    stated = [".".join(map(str, each.path)) for each in values]
    held = {table for key in stated for table in tables_that_hold(key)}
    for named, text in content.report.sources.items():
        if any(dots in text for dots in TO_FILL_IN):
            yield warning("source-to-fill-in", "report.sources", key=named, text=text)
        key = count_from_0(named)
        if key not in held and any(each.startswith(f"{key}.") for each in stated):
            yield warning("source-of-too-much", "report.sources", key=named)


def _body_messages(name: str, solid: Solid, body: sections.BodySection) -> Iterator[Message]:
    """Report what was done to the mesh of a body, and an implausible size or place."""
    if isinstance(body, sections.MeshBody) and solid.history:
        yield from (_mesh_message(name, body.mesh.name, step) for step in solid.history)
    about_size = size_warning(solid, unit=_mesh_unit_of(body))
    yield from locate(() if about_size is None else (about_size,), f"bodies.{name}")


MUCH_CHANGED = 2.0  # % of its volume: a mesh that is mended by more may be another body


def _mesh_message(name: str, file: str, step: Message) -> Message:
    """Report one step of mending a mesh: a warning where it changes the volume by more than MUCH_CHANGED."""
    change = step.values.get("change")
    much = isinstance(change, Quantity) and abs(change.value) > MUCH_CHANGED
    return (warning if much else note)("mesh", f"bodies.{name}", file=file, step=step)


def _mesh_unit_of(body: sections.BodySection) -> float | None:
    """Return the unit in which a mesh was read [m], if it is stated by the project or taken as metre; else None."""
    if not isinstance(body, sections.MeshBody):
        return None
    return body.mesh_unit or (1.0 if body.mesh.suffix.lower() in WITHOUT_UNIT else None)


def _equation_messages(equation: Equation | None, mechanisms: Sequence[Mechanism]) -> Iterator[Message]:
    """Warn that the linearised equation leaves out the flexibility of joints."""
    soft = [mechanism.name for mechanism in mechanisms if mechanism.yielding]
    if equation == "linearised" and soft:
        yield warning("equation", "analysis.equation", mechanisms=", ".join(soft))


def _amplification_messages(raised: Sequence[str], study: Study) -> Iterator[Message]:
    """List mechanisms above the ground where the ground's motion would decide, and the assumptions for the others.

    Without a basis any procedure that runs may be taken for the answer. The spectrum of ASCE 43-05 has that of a floor
    where the building's storeys are known.
    """
    without = [name for name in raised if study.amplified[name].height is None]
    has_floor = study.building is not None and study.building.storeys is not None
    deciding = [
        each
        for each in methods_of(study.question) or study.procedures
        if follows_motion(each) and not (has_floor and PROCEDURES[each].family == Family.ENERGY)
    ]
    if without and deciding:
        procedures = ", ".join(deciding)
        yield warning("not-amplified", "mechanisms", mechanisms=", ".join(without), procedures=procedures)
    for name, one in study.amplified.items():
        yield from locate(one.assumptions, f"mechanisms.{name}")


def _first_mode_messages(content: sections.Content) -> Iterator[Message]:
    """Warn if the natural frequency of [building] is not the reciprocal of its period."""
    building = content.building
    if building is None or building.natural_frequency is None or building.period is None:
        return
    if abs(building.period * building.natural_frequency - 1.0) > SAME_MODE:
        yield warning(
            "two-first-modes",
            "building",
            frequency=Quantity(building.natural_frequency, "frequency"),
            period=Quantity(building.period, "time"),
            reciprocal=Quantity(1.0 / building.natural_frequency),
        )


def _crushing_messages(
    code: str, circular: str, options: ItalianOptions, mechanisms: Sequence[Mechanism]
) -> Iterator[Message]:
    """Warn of levels of knowledge and factors that have no effect, as the mechanism does not model crushing."""
    without = [mechanism.name for mechanism in mechanisms if not mechanism.crushing]
    better = [name for name in without if options.knowledge_levels.get(name, options.knowledge_level) in ("LC2", "LC3")]
    lower = options.confidence_factor is not None and options.confidence_factor < LARGEST_FACTOR
    for key, names in (("knowledge_level", better), ("confidence_factor", without if lower else [])):
        if names:
            yield warning(
                "confidence-factor",
                f"procedures.{code}.{key}",
                mechanisms=", ".join(names),
                circular=circular,
                least=f"{LARGEST_FACTOR:.2f}",
            )


OF_A_BAR = (
    "area", "young_modulus", "yield_stress", "length", "fracture_strain", "stiffness", "strength", "force", "slack",
)  # fmt: skip


def _one_bar_twice(content: sections.Content) -> Iterator[Message]:
    """Yield a warning for each tie that two mechanisms have, one bar by its ends, with other numbers in each."""
    for first, *others in bars_of(content):
        for tie in others:
            differing = ", ".join(key for key in OF_A_BAR if getattr(tie.load, key) != getattr(first.load, key))
            if differing:
                yield warning("one-bar-twice", key_text(tie.path), other=key_text(first.path), keys=differing)


def _implausible_numbers(content: sections.Content) -> Iterator[Message]:
    """Yield a warning for each number that is beyond what masonry and sites have.

    Parameters
    ----------
    content : of the project file
    """
    for name, material in content.materials.items():
        if not LIGHTEST <= material.density <= DENSEST:
            least, most = Quantity(LIGHTEST, "density"), Quantity(DENSEST, "density")
            given = Quantity(material.density, "density")
            yield warning("density-odd", f"materials.{name}.density", given=given, least=least, most=most)
        if material.friction is not None and material.friction > ROUGHEST:
            where, given = f"materials.{name}.friction", Quantity(material.friction, "ratio")
            yield warning("friction-large", where, given=given, most=Quantity(ROUGHEST, "ratio"))
    for level in content.analysis.levels or ():
        if level > LARGEST_PLAUSIBLE * g:
            given, most = Quantity(level / g, "ground acceleration"), Quantity(LARGEST_PLAUSIBLE, "ground acceleration")
            yield warning("level-large", "analysis.levels", given=given, most=most)
    for where, corner in _corners(content):
        given, least, most = (Quantity(each, "time") for each in (corner, SHORTEST_CORNER, LONGEST_CORNER))
        if corner > LONGEST_CORNER:
            yield warning("corner-long", where, given=given, most=most)
        if corner < SHORTEST_CORNER:
            yield warning("corner-short", where, given=given, least=least)


def _corners(content: sections.Content) -> Iterator[tuple[str, float]]:
    """Yield each T_C* of an Italian spectrum with its key: the one, or those of the rows of its hazard."""
    spectrum = None if content.site is None else content.site.spectrum
    corner = getattr(spectrum, "t_c_star", None)
    if corner is not None:
        yield "site.spectrum.t_c_star", corner
    for place, row in enumerate(getattr(spectrum, "hazard", None) or (), start=1):
        if (corner := getattr(row, "t_c_star", None)) is not None:
            yield f"site.spectrum.hazard[{place}].t_c_star", corner
