"""The tables [bodies.NAME] as solids, and blocks of them in the plane of motion."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from assess.errors import GeometryError
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
from assess.project import sections

LEVEL = 0.01  # m: an extreme line that rises by less is level


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


def body_in_plane(
    name: str, content: sections.Content, solids: Mapping[str, Solid | None], direction: Sequence[float]
) -> PlanarBody:
    """One body seen in the vertical plane of `direction` [3]."""
    solid, body = solids[name], content.bodies[name]
    if solid is not None:
        return planar(solid, direction=direction)
    assert isinstance(body, sections.DirectBody)
    return planar_direct(mass=body.mass, centroid=body.centroid, inertia=body.inertia, name=name)


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


def as_one(bodies: Sequence[PlanarBody]) -> PlanarBody:
    """One body as it is, several joined."""
    return bodies[0] if len(bodies) == 1 else planar_joined(bodies, name=" + ".join(body.name for body in bodies))


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
