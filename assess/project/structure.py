"""The tables [bodies], [materials], [mechanisms] and [building] as plain data of the model: one translator for each."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from typing import Any, TypeVar

from assess.geometry import mesh
from assess.geometry.mesh import MeshesBySelection, read_selected_meshes
from assess.geometry.solid import Solid, Solids, box, profile
from assess.interfaces.contact import Interface
from assess.interfaces.section import Shape
from assess.loads.load import BodyLoad, ForceLoad, LoadDefinition, MassLoad, OverburdenLoad, TieLoad
from assess.mechanisms.four_hinge import FourHinge, RadialJoints
from assess.mechanisms.kinds import Definition
from assess.mechanisms.mechanism import BlockMechanism, CutAngle, CutPlane, Mechanism
from assess.mechanisms.restitution import Restitution
from assess.mechanisms.single_block import EquivalentBlock, SingleBlock
from assess.mechanisms.two_block import TwoBlock
from assess.model.bodies import Bodies, Body, Material, PointValues
from assess.project import sections
from assess.project.question import source_of
from assess.project.section import ProjectSection
from assess.study.amplification import (
    AmplificationChoice,
    GroundLevel,
    HeightAboveGround,
    Structure,
    find_height,
    lowest_body,
)

D = TypeVar("D")

LOADS: dict[type[ProjectSection], type[LoadDefinition]] = {
    sections.MassLoad: MassLoad,
    sections.ForceLoad: ForceLoad,
    sections.TieLoad: TieLoad,
    sections.OverburdenLoad: OverburdenLoad,
    sections.BodyLoad: BodyLoad,
}

CHAINED: dict[type[ProjectSection], type[BlockMechanism]] = {
    sections.SingleBlock: SingleBlock,
    sections.TwoBlock: TwoBlock,
    sections.FourHinge: FourHinge,
}

SHOWN = (ForceLoad, TieLoad)
"""The loads that count up to collapse only where somebody shows that they last."""


def definitions_of(content: sections.Content) -> dict[str, Definition]:
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
        return fill(EquivalentBlock, section, restitution=restitution_of(section))
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


def fill(kind: type[D], section: ProjectSection, **given: Any) -> D:
    """Return plain data of a kind with the values that a table has under the same names, and those given beside."""
    own = {field.name for field in fields(kind)} - set(given)  # type: ignore[arg-type]
    return kind(**{name: getattr(section, name) for name in own if hasattr(section, name)}, **given)


def load_of(load: ProjectSection, *, evidence: str = "") -> LoadDefinition:
    """Return one entry of `loads`."""
    kind = LOADS[type(load)]
    return fill(kind, load, **({"evidence": evidence} if kind in SHOWN else {}))


def restitution_of(section: sections.Chained | sections.EquivalentBlock) -> Restitution:
    """Return the key `restitution`."""
    return Restitution(section.restitution.positive, section.restitution.negative)


def interface_of(interface: sections.Interface) -> Interface:
    """Return a table `interface`."""
    shape = interface.shape
    return fill(Interface, interface, shape=shape if shape == "outline" else fill(Shape, shape))


def cut_of(cut: float | sections.CutPlane | sections.CutAngle | None) -> float | CutPlane | CutAngle | None:
    """Return the key `cut`."""
    if isinstance(cut, sections.CutPlane):
        return CutPlane(cut.point, cut.normal)
    return CutAngle(cut.point, cut.angle) if isinstance(cut, sections.CutAngle) else cut


def hinges_of(hinges: Any) -> Any:
    """Return the hinges of a table, from A on; "minimum" and None as they are."""
    return tuple(at for _, at in hinges) if isinstance(hinges, sections.Hinges) else hinges


def joints_of(joints: Any) -> Any:
    """Return the key `joints` of an arch."""
    if isinstance(joints, sections.RadialJoints):
        return RadialJoints(joints.centre, joints.first, joints.last, joints.count)
    return joints


def models_of(bodies: Mapping[str, sections.Body], *, known: MeshesBySelection) -> MeshesBySelection:
    """Read what the bodies take from model files, each file once; `known` has been read already."""
    asked = {name: (body.mesh, body.element) for name, body in bodies.items() if isinstance(body, sections.MeshBody)}
    return {**known, **read_selected_meshes({name: one for name, one in asked.items() if one not in known})}


def solid_of(
    name: str, body: sections.Body, materials: Mapping[str, sections.Material], models: MeshesBySelection
) -> Solid | None:
    """Return the solid of a body; None if it has direct values."""
    if isinstance(body, sections.DirectBody):
        return None
    density = materials[body.material].density
    if isinstance(body, sections.MeshBody):
        model = models[body.mesh, body.element]
        return mesh.solid_from_meshes(model, density=density, name=name, scale=body.mesh_unit, up=body.mesh_up)
    if isinstance(body, sections.BoxBody):
        return box(**body.box.model_dump(), density=density, name=name)
    return profile(body.profile, length=body.length, density=density, name=name)


def bodies_of(content: sections.Content, solids: Mapping[str, Solid | None]) -> Bodies:
    """Return the bodies of a project, each with its solid and its material."""
    return {name: _body(name, body, content, solids[name]) for name, body in content.bodies.items()}


def _body(name: str, body: sections.Body, content: sections.Content, solid: Solid | None) -> Body:
    if isinstance(body, sections.DirectBody):
        values = PointValues(mass=body.mass, centroid=body.centroid, inertia=body.inertia)
        return Body(name=name, solid=solid, values=values)
    return Body(name=name, solid=solid, material=material_of(body.material, content))


def material_of(name: str, content: sections.Content) -> Material:
    """Return one of the materials of a project."""
    given = content.materials[name]
    return Material(
        name=name,
        density=given.density,
        young_modulus=given.young_modulus,
        compressive_strength=given.compressive_strength,
        tensile_strength=given.tensile_strength,
        friction=given.friction,
    )


def ground_of(building: sections.Building | None, definitions: Mapping[str, Definition], solids: Solids) -> GroundLevel:
    """Return what the project says of the ground."""
    lowest = lowest_body(definitions, solids)
    if building is None:
        return GroundLevel(lowest=lowest)
    return GroundLevel(building.ground_elevation, lowest, building.height or 0.0)


def base_elevation_of(section: sections.Mechanism) -> float | None:
    """Return the elevation of the base above the ground [m] that the table of a mechanism gives for it alone."""
    return section.base_elevation if isinstance(section, sections.Chained) else None


def ground_mechanism(section: sections.Mechanism, mechanism: Mechanism, ground: GroundLevel) -> HeightAboveGround:
    """Return where a mechanism stands over the ground."""
    by_table = isinstance(section, sections.EquivalentBlock) and section.has_key("elevation")
    return find_height(ground, mechanism, base_elevation=base_elevation_of(section), by_table=by_table)


def amplification_method_of(section: sections.Mechanism) -> AmplificationChoice | None:
    """Return the key `amplification` of a mechanism; None for the ground's motion as it is."""
    asked = section.amplification
    return None if isinstance(asked, sections.NoAmplification) else fill(AmplificationChoice, asked)


def structure_of(building: sections.Building | None) -> Structure:
    """Return what the table [building] says of the structure below a mechanism; its period only where it is given."""
    if building is None:
        return Structure()
    return fill(Structure, building, period=building.period if building.has_key("period") else None)
