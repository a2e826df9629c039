"""What a project uses of the program, in the words of `assess.results.uses`: to be held against the solved cases."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from assess.codes.families import uses_histories
from assess.mechanisms.impact import ABOUT_BASE, HOUSNER, MOMENTUM
from assess.mechanisms.mechanism import Mechanism
from assess.project import sections
from assess.project.section import Section
from assess.project.sections.bodies import ProfileBody
from assess.results.uses import USES
from assess.study.study import Study

BODIES: Mapping[type[Section], str] = {
    sections.MeshBody: "mesh",
    sections.BoxBody: "box",
    ProfileBody: "profile",
}
RESTITUTIONS: Mapping[str, str] = {
    str(HOUSNER[0]): "restitution housner",
    str(MOMENTUM[0]): "restitution momentum",
    str(ABOUT_BASE[0]): "restitution sorrentino",
}
SAME_SHAPE: Mapping[str, str] = {"ibc2009": "asce7-05"}  # codes whose spectrum is that of another


def uses_of(content: sections.Content, study: Study) -> tuple[str, ...]:
    """Return what a project uses, each word once, in the order of the table.

    Parameters
    ----------
    content : of the project file
    study : built from it
    """
    found = {
        *_of_bodies(content),
        *(word for section in content.mechanisms.values() for word in _of_section(section)),
        *(word for mechanism in study.mechanisms for word in _of_mechanism(mechanism)),
        *_of_site(content, study),
        *_of_motion(content, study),
        *study.procedures,
        *study.offered,
        *_of_analysis(content),
    }
    if unknown := found - set(USES):
        raise KeyError(f"no word of assess.results.uses: {', '.join(sorted(unknown))}")
    return tuple(word for word in USES if word in found)


def _of_bodies(content: sections.Content) -> Iterator[str]:
    chained = (each for each in content.mechanisms.values() if isinstance(each, sections.Chained))
    names = {name for each in chained for block in each.blocks for name in block}
    yield from (BODIES[type(body)] for name, body in content.bodies.items() if name in names and type(body) in BODIES)


def _of_section(section: sections.Mechanism) -> Iterator[str]:
    yield section.kind
    if not isinstance(section, sections.Chained):
        return
    yield from (str(getattr(load, "kind", "")) for load in section.loads)
    for joint in (section.interface, *section.interfaces.values()):
        if joint.model != "rigid" or joint.strength is not None:
            yield from ("outline",) if isinstance(joint.shape, str) else _sizes(joint.shape)
    if section.cut is not None:
        yield "cut"
    if isinstance(section, sections.TwoBlock) and isinstance(section.crack, str):
        yield f"crack {section.crack}"
    if isinstance(section, sections.FourHinge) and section.hinges == "minimum":
        yield "arch"


def _sizes(shape: Section) -> Iterator[str]:
    yield from (name for name, size in shape.entries().items() if size is not None)


def _of_mechanism(mechanism: Mechanism) -> Iterator[str]:
    """Yield sides, joints and the rule of restitution, as they came out with all defaults."""
    said = set(map(str, mechanism.restitution_said))
    if mechanism.sides == "one":
        yield "one-sided"
        if any(getattr(each, "key", "") == "restitution-3-45" for each in mechanism.restitution_said):
            yield "restitution one-sided"
    yield from (word for rule, word in RESTITUTIONS.items() if rule in said)
    joints = [joint for chain in (mechanism.positive, mechanism.negative) if chain for joint in chain.joints]
    if not joints or None in joints:
        yield "rigid"
    for joint in joints:
        if joint is not None:
            yield "crushing" if joint.model == "rigid" else joint.model
            if joint.law.strength < float("inf"):
                yield "crushing"


def _of_site(content: sections.Content, study: Study) -> Iterator[str]:
    if content.site is None:
        return
    code = content.site.spectrum.code
    yield SAME_SHAPE.get(code, code)
    if study.hazard is not None:
        yield "hazard over return periods"


def _of_motion(content: sections.Content, study: Study) -> Iterator[str]:
    """Yield what histories and envelopes use; nothing where there are none."""
    histories = any(map(uses_histories, (*study.procedures, *study.offered)))
    if study.pulses is not None:
        yield "pulses"
    if not histories and study.pulses is None:
        return
    yield from study.equations.values()
    yield from _amplification(study)
    if not histories:
        return
    if study.records:
        yield "records"
    if study.artificial is not None:
        yield "synthetic"
    if study.scale_to == "spectrum":
        yield "scaling"
    if content.records.selection is not None:
        yield "selection"


def _amplification(study: Study) -> Iterable[str]:
    return (f"amplification {each.method}" for each in study.amplified.values() if each.method != "none")


def _of_analysis(content: sections.Content) -> Iterator[str]:
    asked = content.analysis
    for word in ("sensitivity", "uncertainty", "fragility", "risk"):
        if getattr(asked, word) not in (None, False):
            yield word
