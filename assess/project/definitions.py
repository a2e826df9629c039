"""The tables [mechanisms.NAME] as plain definitions of mechanisms, joints and loads: one translator for each kind."""

from __future__ import annotations

from dataclasses import fields
from typing import Any, TypeVar

from assess.interfaces.definition import Interface, Shape
from assess.loads import definitions as loads
from assess.model import definitions as model
from assess.project import sections
from assess.project.section import Section
from assess.project.sources import source_of

D = TypeVar("D")

LOADS: dict[type[Section], type[loads.LoadDefinition]] = {
    sections.MassLoad: loads.MassLoad,
    sections.ForceLoad: loads.ForceLoad,
    sections.TieLoad: loads.TieLoad,
    sections.OverburdenLoad: loads.OverburdenLoad,
    sections.BodyLoad: loads.BodyLoad,
}
CHAINED: dict[type[Section], type[model.Chained]] = {
    sections.SingleBlock: model.SingleBlock,
    sections.TwoBlock: model.TwoBlock,
    sections.FourHinge: model.FourHinge,
}
SHOWN = (loads.ForceLoad, loads.TieLoad)
"""The loads that count up to collapse only where somebody shows that they last."""


def definitions_of(content: sections.Content) -> dict[str, model.Definition]:
    """Return the definition of each mechanism of a project, with the evidence of its loads by [report.sources]."""
    return {
        name: definition_of(section, evidence=source_of(content, f"mechanisms.{name}.loads"))
        for name, section in content.mechanisms.items()
    }


def definition_of(section: Any, *, evidence: str = "") -> Any:
    """Return the plain definition of one table [mechanisms.NAME].

    Parameters
    ----------
    section : the table, of any kind
    evidence : where it is shown that its forces and ties last; empty where it is not shown
    """
    if isinstance(section, sections.EquivalentBlock):
        return fill(model.EquivalentBlock, section, restitution=restitution_of(section))
    kind = CHAINED[type(section)]
    return fill(
        kind,
        section,
        cut=cut_of(section.cut),
        loads=tuple(load_of(load, evidence=evidence) for load in section.loads),
        restitution=restitution_of(section),
        interface=interface_of(section.interface),
        interfaces={str(letter): interface_of(each) for letter, each in section.interfaces.items()},
        hinges=hinges_of(section.hinges),
        hinges_negative=hinges_of(section.hinges_negative),
        **({"joints": joints_of(section.joints)} if isinstance(section, sections.FourHinge) else {}),
    )


def fill(kind: type[D], section: Section, **given: Any) -> D:
    """Return plain data of a kind with the values that a table has under the same names, and those given beside."""
    own = {field.name for field in fields(kind)} - set(given)  # type: ignore[arg-type]
    return kind(**{name: getattr(section, name) for name in own if hasattr(section, name)}, **given)


def load_of(load: Section, *, evidence: str = "") -> loads.LoadDefinition:
    """Return one entry of `loads`."""
    kind = LOADS[type(load)]
    return fill(kind, load, **({"evidence": evidence} if kind in SHOWN else {}))


def restitution_of(section: sections.Chained | sections.EquivalentBlock) -> model.Restitution:
    """Return the key `restitution`."""
    return model.Restitution(section.restitution.positive, section.restitution.negative)


def interface_of(interface: sections.Interface) -> Interface:
    """Return a table `interface`."""
    shape = interface.shape
    return fill(Interface, interface, shape=shape if shape == "outline" else fill(Shape, shape))


def cut_of(cut: float | sections.CutPlane | sections.CutAngle | None) -> float | model.CutPlane | model.CutAngle | None:
    """Return the key `cut`."""
    if isinstance(cut, sections.CutPlane):
        return model.CutPlane(cut.point, cut.normal)
    return model.CutAngle(cut.point, cut.angle) if isinstance(cut, sections.CutAngle) else cut


def hinges_of(hinges: Any) -> Any:
    """Return the hinges of a table, from A on; "minimum" and None as they are."""
    return tuple(at for _, at in hinges) if isinstance(hinges, sections.Hinges) else hinges


def joints_of(joints: Any) -> Any:
    """Return the key `joints` of an arch."""
    if isinstance(joints, sections.RadialJoints):
        return model.RadialJoints(joints.centre, joints.first, joints.last, joints.count)
    return joints
