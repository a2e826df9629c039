"""What the engineer should know before reading any result."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from assess.codes.italian.confidence import LEAST_KNOWN
from assess.codes.verdict import Question
from assess.geometry.formats.readers import WITHOUT_UNIT
from assess.geometry.plausibility import size_warning
from assess.geometry.solid import Solid
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity, locate, note, warning
from assess.model.gaps import gaps_of
from assess.model.overlaps import overlaps_of
from assess.project import sections
from assess.project.bodies import bodies_of
from assess.project.definitions import definitions_of
from assess.project.plausible_numbers import implausible_numbers
from assess.project.procedures import procedures_of
from assess.study.endurance import load_messages
from assess.study.study import Amplified, Equation, Study
from assess.study.verdict import by_motion

CIRCULARS = {"dmi2008": "Circolare 617/2009", "ntc2018": "Circolare 7/2019"}
SAME_MODE = 0.05  # by how much two first modes of one building may differ


def project_messages(
    content: sections.Content,
    solids: Mapping[str, Solid | None],
    study: Study,
) -> Iterator[Message]:
    """Yield what the engineer should know before reading any result."""
    mechanisms = study.mechanisms
    yield from implausible_numbers(content)
    for name, solid in solids.items():
        if solid is not None:
            yield from _of_body(name, solid, content.bodies[name])
    definitions, bodies = definitions_of(content), bodies_of(content, solids)
    yield from overlaps_of(definitions, bodies)
    yield from gaps_of(definitions, bodies)
    for mechanism in mechanisms:
        yield from locate(mechanism.warnings, f"mechanisms.{mechanism.name}")
        yield from load_messages(mechanism)
        yield from mechanism.messages
    yield from _of_equation(content.analysis.equation, mechanisms)
    raised = [mechanism.name for mechanism in mechanisms if study.grounded[mechanism.name].above]
    yield from _of_amplification(raised, study.amplified, study.question)
    yield from _of_two_first_modes(content)
    for code, circular in CIRCULARS.items():
        if any(name.startswith(code) for name in procedures_of(content)):
            yield from _of_crushing(code, circular, getattr(content.procedures, code), mechanisms)


def _of_amplification(
    raised: Sequence[str], amplified: Mapping[str, Amplified], question: Question
) -> Iterator[Message]:
    """List mechanisms above the ground whose input is the ground's motion, and the assumptions for the others."""
    without = [name for name in raised if amplified[name].height is None]
    if without:
        bears = warning if by_motion(question) else note
        yield bears("not-amplified", "mechanisms", mechanisms=", ".join(without))
    for name, one in amplified.items():
        yield from locate(one.assumptions, f"mechanisms.{name}")


def _of_two_first_modes(content: sections.Content) -> Iterator[Message]:
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


def _of_equation(equation: Equation | None, mechanisms: Sequence[Mechanism]) -> Iterator[Message]:
    """Warn that the linearised equation leaves out the flexibility of joints."""
    soft = [mechanism.name for mechanism in mechanisms if mechanism.yielding]
    if equation == "linearised" and soft:
        yield warning("equation", "analysis.equation", mechanisms=", ".join(soft))


def _of_crushing(
    code: str, circular: str, options: sections.Italian, mechanisms: Sequence[Mechanism]
) -> Iterator[Message]:
    """Warn of levels of knowledge and factors that have no effect, as the mechanism does not model crushing."""
    without = [mechanism.name for mechanism in mechanisms if not mechanism.crushing]
    better = [name for name in without if options.knowledge_levels.get(name, options.knowledge_level) in ("LC2", "LC3")]
    lower = options.confidence_factor is not None and options.confidence_factor < LEAST_KNOWN
    for key, names in (("knowledge_level", better), ("confidence_factor", without if lower else [])):
        if names:
            yield warning(
                "confidence-factor",
                f"procedures.{code}.{key}",
                mechanisms=", ".join(names),
                circular=circular,
                least=f"{LEAST_KNOWN:.2f}",
            )


def _of_body(name: str, solid: Solid, body: sections.Body) -> Iterator[Message]:
    """Report what was done to the mesh of a body, and an implausible size or place."""
    if isinstance(body, sections.MeshBody) and solid.history:
        yield from (note("mesh", f"bodies.{name}", file=body.mesh.name, step=step) for step in solid.history)
    about_size = size_warning(solid, unit=mesh_unit_of(body))
    yield from locate(() if about_size is None else (about_size,), f"bodies.{name}")


def mesh_unit_of(body: sections.Body) -> float | None:
    """Return the unit in which a mesh was read [m], if it is stated by the project or taken as metre; else None."""
    if not isinstance(body, sections.MeshBody):
        return None
    return body.mesh_unit or (1.0 if body.mesh.suffix.lower() in WITHOUT_UNIT else None)
