"""From the project file's tables to the field's own objects; the only module that knows both."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from assess.codes.context import Building
from assess.codes.dmi2008.clauses import ON_GROUND
from assess.codes.dmi2008.clauses import Options as Dmi2008Options
from assess.codes.registry import CodeOptions
from assess.errors import AssessError, GeometryError
from assess.geometry import mesh
from assess.geometry.cut import Plane, above, inclined, level
from assess.geometry.planar import (
    FloatArray,
    PlanarBody,
    base_of_section,
    lowest_corners,
    planar,
    planar_direct,
    planar_joined,
    slope_across,
    turns_about_a_corner,
)
from assess.geometry.solid import Solid, box, profile
from assess.loads import Force, Load, PointMass, Tie
from assess.mechanisms.chain import Point
from assess.mechanisms.equivalent_block import equivalent_block
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.single_block import single_block
from assess.project import sections
from assess.project.schema import Project, relative, resolved
from assess.project.study import Artificial, Equation, Study
from assess.results import Input, Notice
from records.reading import read
from records.record import Record
from spectra.asce7 import design_spectrum
from spectra.errors import SpectrumError
from spectra.spectrum import Spectrum, scaled_to_pga
from spectra.table import read_table

LEVEL = 0.01  # m: an extreme line that rises by less is level


def build(project: Project) -> Study:
    """The study that `project` describes, with every file it names read.

    Raises AssessError, SpectrumError or RecordError, each one line with the file, for what cannot be assessed.
    """
    try:
        return study_of(project)
    except (AssessError, SpectrumError) as error:
        raise type(error)(f"{project.path}: {error}") from None


def study_of(project: Project) -> Study:
    """The same, with errors that do not name the project file."""
    content = project.content
    site, building = content.site, content.building
    spectrum = None if site is None else spectrum_of(site)
    solids = {name: solid_of(name, body, content.materials) for name, body in content.bodies.items()}
    mechanisms = tuple(mechanism_of(name, section, content, solids) for name, section in content.mechanisms.items())
    synthetic = content.records.synthetic
    return Study(
        spectrum=spectrum,
        vertical_ratio=0.0 if site is None else site.vertical_ratio,
        building=None if building is None else Building(**building.model_dump()),
        records=records_of(project),
        artificial=None if synthetic is None else Artificial(synthetic.count, synthetic.seed, synthetic.duration),
        scale_to=content.records.scale_to,
        levels=levels_of(content.analysis.levels, spectrum),
        procedures=content.analysis.procedures,
        options=CodeOptions(dmi2008=Dmi2008Options(**content.procedures.dmi2008.model_dump())),
        mechanisms=mechanisms,
        equations={name: equation_of(section, content) for name, section in content.mechanisms.items()},
        inputs=tuple(inputs_of(project)),
        resolved=resolved(project),
        notices=tuple(notices_of(content, solids, mechanisms)),
    )


def spectrum_of(site: sections.Site) -> Spectrum:
    """The site's spectrum, scaled to the PGA the project gives."""
    section = site.spectrum
    if isinstance(section, sections.TableSpectrum):
        spectrum = read_table(section.file, damping=section.damping, pga=site.pga)
    else:
        spectrum = design_spectrum(
            s_ds=section.s_ds, s_d1=section.s_d1, t_l=section.t_l, code=section.code, hazard=section.hazard
        )
        spectrum = replace(spectrum, damping=section.damping)
    return spectrum if site.pga is None else scaled_to_pga(spectrum, site.pga)


def levels_of(given: tuple[float, ...] | None, spectrum: Spectrum | None) -> tuple[float, ...]:
    """The levels [m/s2], rising: those given, or the site's own PGA."""
    if given is not None:
        return tuple(sorted(given))
    return () if spectrum is None else (spectrum.pga,)


def solid_of(name: str, body: sections.Body, materials: Mapping[str, sections.Material]) -> Solid | None:
    """The solid of a body with geometry, None for direct values."""
    if isinstance(body, sections.DirectBody):
        return None
    density = materials[body.material].density
    if isinstance(body, sections.MeshBody):
        return mesh.load(body.mesh, density=density, name=name, scale=body.mesh_unit)
    if isinstance(body, sections.BoxBody):
        return box(**body.box.model_dump(), density=density, name=name)
    return profile(body.profile, length=body.length, density=density, name=name)


def mechanism_of(
    name: str,
    section: sections.Mechanism,
    content: sections.Content,
    solids: Mapping[str, Solid | None],
) -> Mechanism:
    """The mechanism of one table [mechanisms.NAME]."""
    restitution = (section.restitution.positive, section.restitution.negative)
    if isinstance(section, sections.EquivalentBlock):
        own = section.model_dump(include={"p", "uplift", "radius", "mass", "elevation"})
        return equivalent_block(name, **own, label=section.label, sides=section.sides, restitution=restitution)
    body, foot = block_in_plane(name, section, content, solids)
    mechanism = single_block(
        name,
        body,
        hinge=in_plane(section.hinges, section.direction),
        hinge_negative=in_plane(section.hinges_negative, section.direction),
        label=section.label,
        sides=section.sides,
        loads=tuple(load_of(i, load, section.direction) for i, load in enumerate(section.loads, start=1)),
        restitution=restitution,
    )
    return replace(mechanism, notices=(*mechanism.notices, *doubts_of(section, foot)))


def block_in_plane(
    name: str, section: sections.SingleBlock, content: sections.Content, solids: Mapping[str, Solid | None]
) -> tuple[PlanarBody, FloatArray | None]:
    """The block in the vertical plane of motion, and the corners [k, 3] that it stands on, None without geometry."""
    plane = cut_of(section.cut, where=f'mechanism "{name}"')
    if plane is None:
        standing = [solid for body in section.blocks[0] if (solid := solids[body]) is not None]
        bodies = [body_in_plane(body, content, solids, section.direction) for body in section.blocks[0]]
        return as_one(bodies), lowest_corners(standing) if standing else None
    upper = above(solids_to_cut(name, section, solids), plane, where=f'mechanism "{name}"')
    block = as_one([planar(solid, direction=section.direction) for solid in upper.bodies])
    return replace(block, base=base_of_section(upper.foot, direction=section.direction)), upper.foot


def cut_of(cut: float | sections.CutPlane | None, *, where: str) -> Plane | None:
    """The plane of the key `cut`; raises GeometryError where its normal does not point up."""
    if isinstance(cut, sections.CutPlane):
        return inclined(cut.point, cut.normal, where=where)
    return None if cut is None else level(cut)


def solids_to_cut(name: str, section: sections.SingleBlock, solids: Mapping[str, Solid | None]) -> list[Solid]:
    """The solids of the block; raises GeometryError for a body of direct values."""
    found = []
    for body in section.blocks[0]:
        solid = solids[body]
        if solid is None:
            raise GeometryError(
                f'mechanism "{name}": body "{body}" has no geometry to cut; give it a mesh, box or profile, or remove '
                "the cut and give the values of what lies above"
            )
        found.append(solid)
    return found


def as_one(bodies: Sequence[PlanarBody]) -> PlanarBody:
    """One body as it is, several joined."""
    return bodies[0] if len(bodies) == 1 else planar_joined(bodies, name=" + ".join(body.name for body in bodies))


def load_of(number: int, load: sections.LoadTable, direction: Sequence[float]) -> Load:
    """One entry of `loads` in the plane of motion, named by its kind and number."""
    name, at = f"{load.kind} {number}", point_in_plane(load.at, direction)
    if isinstance(load, sections.MassLoad):
        return PointMass(name, load.mass, at, load.bearing, load.block)
    way = None if load.direction is None else unit_in_plane(load.direction, direction)
    if isinstance(load, sections.TieLoad):
        anchor = None if load.anchor is None else point_in_plane(load.anchor, direction)
        return Tie(name, load.force, at, way, anchor, load.both, load.block)
    if isinstance(load.force, tuple):
        return Force(name, load.force, at, load.block)
    assert way is not None  # the schema asks for it
    return Force(name, (load.force * way[0], load.force * way[1]), at, load.block)


def unit_in_plane(vector: Sequence[float], direction: Sequence[float]) -> Point:
    """The part in the plane of motion of the unit vector of [x, y, z] or (along, up)."""
    x, z = point_in_plane(vector, direction)
    return (x / float(np.linalg.norm(vector)), z / float(np.linalg.norm(vector)))


def body_in_plane(
    name: str, content: sections.Content, solids: Mapping[str, Solid | None], direction: Sequence[float]
) -> PlanarBody:
    """One body seen in the vertical plane of `direction` [3]."""
    solid, body = solids[name], content.bodies[name]
    if solid is not None:
        return planar(solid, direction=direction)
    assert isinstance(body, sections.DirectBody)
    return planar_direct(mass=body.mass, centroid=body.centroid, inertia=body.inertia, name=name)


def in_plane(hinges: sections.Hinges | None, direction: Sequence[float]) -> Point | None:
    """Hinge A as (distance along `direction` from the origin, elevation) [m]."""
    return None if hinges is None else point_in_plane(hinges.A, direction)


def point_in_plane(at: Sequence[float], direction: Sequence[float]) -> Point:
    """[x, y, z] as (distance along `direction` from the origin, elevation); two numbers are that already."""
    if len(at) == 2:
        return (at[0], at[1])
    along = np.asarray(direction) / np.linalg.norm(direction)
    return (float(np.asarray(at) @ along), at[2])


def equation_of(section: sections.Mechanism, content: sections.Content) -> Equation:
    """The equation of motion asked for, or the default of the kind: linearised for equivalent blocks, else exact."""
    default: Equation = "linearised" if isinstance(section, sections.EquivalentBlock) else "exact"
    return content.analysis.equation or default


def records_of(project: Project) -> tuple[Record, ...]:
    """The records of every file, each with its path as the project file would write it."""
    section = project.content.records
    found = [record for path in section.files for record in read(path, unit=section.unit)]
    return uniquely_named([replace(one, path=relative(Path(one.path), project.folder)) for one in found])


def uniquely_named(records: Sequence[Record]) -> tuple[Record, ...]:
    """The records, a second one of the same id numbered "id (2)", and so on."""
    seen: dict[str, int] = {}
    named = []
    for record in records:
        seen[record.id] = seen.get(record.id, 0) + 1
        again = seen[record.id]
        named.append(record if again == 1 else replace(record, id=f"{record.id} ({again})"))
    return tuple(named)


def inputs_of(project: Project) -> Iterator[Input]:
    """The project file and every file it names, with their hashes."""
    yield Input(project.path.name, project.sha256)
    content = project.content
    bodies = [body.mesh for body in content.bodies.values() if isinstance(body, sections.MeshBody)]
    table = content.site.spectrum if content.site is not None else None
    tables = [table.file] if isinstance(table, sections.TableSpectrum) else []
    for path in dict.fromkeys([*bodies, *tables, *content.records.files]):
        yield Input(relative(path, project.folder), hashlib.sha256(path.read_bytes()).hexdigest())


def doubts_of(section: sections.SingleBlock, foot: FloatArray | None) -> Iterator[str]:
    """Sentences where the default hinge is a corner of the base, so that the wall may stand askew, or is not level."""
    if foot is None or section.hinges is not None:
        return
    if turns_about_a_corner(foot, direction=section.direction):
        yield (
            "the base touches its extreme line in the direction of motion at a point, not along an edge; if the body "
            "stands askew to `direction`, turn one to the other: a corner as hinge overestimates the resistance"
        )
    rise = 0.0 if section.cut is None else slope_across(foot, direction=section.direction)
    if rise > LEVEL:
        yield (
            f"the cut slopes across the direction of motion and its extreme line rises by {rise:.3g} m; the hinge is "
            "taken level at the middle of that line: turn `direction` to the slope of the crack"
        )


def notices_of(
    content: sections.Content, solids: Mapping[str, Solid | None], mechanisms: Sequence[Mechanism]
) -> Iterator[Notice]:
    """What the engineer should know before reading any result."""
    for name, solid in solids.items():
        doubt = None if solid is None else mesh.suspicious(solid)
        if doubt:
            yield Notice("size", f"bodies.{name}", doubt)
    for mechanism in mechanisms:
        for text in mechanism.notices:
            yield Notice("mechanism", f"mechanisms.{mechanism.name}", text)
    ground = content.building.ground_elevation if content.building is not None else 0.0
    raised = [mechanism.name for mechanism in mechanisms if mechanism.elevation > ground + ON_GROUND]
    if raised:
        yield Notice(
            "amplification",
            "mechanisms",
            f"above the ground, yet histories and ASCE 43-05 use the ground's motion as it is: {', '.join(raised)}; "
            "only dmi2008 asks for the floor's motion",
        )
    italian = any(name.startswith("dmi2008") for name in content.analysis.procedures)
    if italian and content.procedures.dmi2008.confidence_factor == 1.0:
        yield Notice(
            "confidence-factor",
            "procedures.dmi2008",
            "FC = 1.00 stands for knowledge level LC3; where crushing of the masonry is not modelled, as here, "
            "Circolare 617/2009 asks for the FC of LC1, 1.35",
        )
