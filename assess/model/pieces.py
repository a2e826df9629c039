"""The tables [bodies.NAME] as solids, and blocks of them in the plane of motion."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import cos, sin

import numpy as np

from assess.errors import GeometryError
from assess.geometry import mesh
from assess.geometry.cut import Division, Plane, divide, inclined_plane, level_plane
from assess.geometry.models import Models, read_models
from assess.geometry.planar import (
    PlanarBody,
    base_of_section,
    join_planar,
    lowest_corners,
    planar_body,
    planar_body_from_values,
    slope_across,
    turns_about_a_corner,
)
from assess.geometry.scene import Scene
from assess.geometry.solid import Solid, box, profile
from assess.project import sections
from spectra.arrays import FloatArray

ASKEW = (
    "the base touches its extreme line in the direction of motion at a point, not along an edge; if the body stands "
    "askew to `direction`, turn one to the other: a corner as hinge overestimates the resistance"
)
LEVEL = 0.01  # m: an extreme line that rises by less is level
UNEVEN = 0.05  # of its width: by how much a base may be narrower than the body just above it
Solids = Mapping[str, Solid | None]


@dataclass(frozen=True)
class Piece:
    """One block of a mechanism, as cut.

    body : in the plane of motion; solids : what it is made of, none for direct values; foot : corners of the face it
    stands on [k, 3] [m], None without geometry; cut : whether that face is a cut; section : its rings [k, 3] [m];
    fixed : what lies beyond the cut and stays
    """

    body: PlanarBody
    solids: tuple[Solid, ...]
    foot: FloatArray | None
    cut: bool = False
    section: tuple[FloatArray, ...] = ()
    fixed: tuple[Solid, ...] = ()


def models_of(bodies: Mapping[str, sections.Body], *, known: Models) -> Models:
    """What the bodies take of model files, each file read once; `known`: what has been read already."""
    asked = {name: (body.mesh, body.element) for name, body in bodies.items() if isinstance(body, sections.MeshBody)}
    return {**known, **read_models({name: one for name, one in asked.items() if one not in known})}


def solid_of(
    name: str, body: sections.Body, materials: Mapping[str, sections.Material], models: Models
) -> Solid | None:
    """The solid of a body with geometry, None for direct values."""
    if isinstance(body, sections.DirectBody):
        return None
    density = materials[body.material].density
    if isinstance(body, sections.MeshBody):
        model = models[body.mesh, body.element]
        return mesh.solid_of(model, density=density, name=name, scale=body.mesh_unit, up=body.mesh_up)
    if isinstance(body, sections.BoxBody):
        return box(**body.box.model_dump(), density=density, name=name)
    return profile(body.profile, length=body.length, density=density, name=name)


def body_in_plane(name: str, content: sections.Content, solids: Solids, direction: Sequence[float]) -> PlanarBody:
    """One body seen in the vertical plane of `direction` [3]."""
    solid, body = solids[name], content.bodies[name]
    if solid is not None:
        return planar_body(solid, direction=direction)
    assert isinstance(body, sections.DirectBody)
    return planar_body_from_values(mass=body.mass, centroid=body.centroid, inertia=body.inertia, name=name)


def pieces_of(name: str, section: sections.Chained, content: sections.Content, solids: Solids) -> tuple[Piece, ...]:
    """The blocks of a mechanism, base first, each above the cut if there is one.

    Raises GeometryError where the cut misses all of them, or crosses a body without geometry.
    """
    plane = cut_of(section, where=f'mechanism "{name}"')
    if plane is None:
        return tuple(whole(block, section.towards, content, solids) for block in section.blocks)
    crossed = [crosses(block, plane, solids) for block in section.blocks]
    if len(section.blocks) == 1 or not any(crossed):
        crossed = [True, *crossed[1:]]  # one must be: `divide` says why it is not
    return tuple(
        upper(name, block, plane, section.towards, solids) if cut else whole(block, section.towards, content, solids)
        for block, cut in zip(section.blocks, crossed, strict=True)
    )


def whole(block: Sequence[str], direction: Sequence[float], content: sections.Content, solids: Solids) -> Piece:
    """The bodies of a block as they are."""
    standing = tuple(solid for body in block if (solid := solids[body]) is not None)
    bodies = [body_in_plane(body, content, solids, direction) for body in block]
    return Piece(as_one(bodies), standing, lowest_corners(standing) if standing else None)


def upper(name: str, block: Sequence[str], plane: Plane, direction: Sequence[float], solids: Solids) -> Piece:
    """What of a block lies above a cut."""
    parts = divide(solids_to_cut(name, block, solids), plane, where=f'mechanism "{name}"')
    return replace(standing_on(parts, direction), fixed=parts.below)


def standing_on(parts: Division, direction: Sequence[float]) -> Piece:
    """The upper side of a cut as a block."""
    body = as_one([planar_body(solid, direction=direction) for solid in parts.above])
    body = replace(body, base=base_of_section(parts.foot, direction=direction))
    return Piece(body, parts.above, parts.foot, True, parts.section)


def scene_of(pieces: Sequence[Piece], direction: Sequence[float]) -> Scene | None:
    """The blocks of a mechanism in space, None where none of them has geometry."""
    if not any(piece.solids for piece in pieces):
        return None
    return Scene(
        members=tuple(piece.solids for piece in pieces),
        fixed=tuple(solid for piece in pieces for solid in piece.fixed),
        sections=tuple(ring for piece in pieces for ring in piece.section),
        direction=np.array(direction) / np.linalg.norm(direction),
    )


def crosses(block: Sequence[str], plane: Plane, solids: Solids) -> bool:
    """Whether a body of the block reaches below the plane."""
    corners = [solid.vertices for body in block if (solid := solids[body]) is not None]
    return any(bool(((points - plane.point) @ plane.normal < 0.0).any()) for points in corners)


def as_one(bodies: Sequence[PlanarBody]) -> PlanarBody:
    """One body as it is, several joined."""
    return bodies[0] if len(bodies) == 1 else join_planar(bodies, name=" + ".join(body.name for body in bodies))


def cut_of(section: sections.Chained, *, where: str) -> Plane | None:
    """The plane of the key `cut`; raises GeometryError where its normal does not point up.

    A crack inclined by a positive angle falls towards the direction.
    """
    cut = section.cut
    if isinstance(cut, sections.CutPlane):
        return inclined_plane(cut.point, cut.normal, where=where)
    if isinstance(cut, sections.CutAngle):
        x, y, _ = np.asarray(section.towards) / np.linalg.norm(section.towards)
        return inclined_plane(cut.point, (sin(cut.angle) * x, sin(cut.angle) * y, cos(cut.angle)), where=where)
    return None if cut is None else level_plane(cut)


def solids_to_cut(name: str, block: Sequence[str], solids: Solids) -> list[Solid]:
    """The solids of a block; raises GeometryError for a body of direct values."""
    found = []
    for body in block:
        solid = solids[body]
        if solid is None:
            raise GeometryError(
                f'mechanism "{name}": body "{body}" has no geometry to cut; give it a mesh, box or profile, or remove '
                "the cut and give the values of what lies above"
            )
        found.append(solid)
    return found


def doubts_of(piece: Piece, direction: Sequence[float]) -> Iterator[str]:
    """Sentences where a hinge taken from the geometry is a corner, so that a wall may stand askew, or not level."""
    if piece.foot is None:
        return
    if turns_about_a_corner(piece.foot, direction=direction):
        yield ASKEW
    rise = slope_across(piece.foot, direction=direction) if piece.cut else 0.0
    if rise > LEVEL:
        yield (
            f"the cut slopes across the direction of motion and its extreme line rises by {rise:.3g} m; the hinge is "
            "taken level at the middle of that line: turn `direction` to the slope of the crack"
        )
    if not piece.cut:
        yield from uneven(piece.solids, direction)


def uneven(solids: Sequence[Solid], direction: Sequence[float]) -> Iterator[str]:
    """A sentence where the lowest face is much narrower than what lies hardly higher: a base that is not plane."""
    faces = (lowest_corners(solids), lowest_corners(solids, within=LEVEL))
    ends = [base_of_section(face, direction=direction) for face in faces]
    width, wide = (high[0] - low[0] for low, high in ends)
    if width < (1.0 - UNEVEN) * wide:
        yield (
            f"the base is the lowest face alone, {width:.3g} m wide, yet within {1e3 * LEVEL:.3g} mm above it the body "
            f"is {wide:.3g} m wide; if it stands on all of that, make it plane by a cut"
        )
