"""The bodies of a building and their masonry, and the blocks of a mechanism that are cut from them.

Blocks are seen in the plane of motion. What the bodies of one block share counts once; bodies of a block that touch
nowhere, and blocks that share space, get a warning.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, pairwise, product
from math import cos, sin
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from numpy.typing import ArrayLike

from assess.declaration import (
    UNCERTAIN,
    Evidence,
    MasonryStrength,
    NotAKey,
    NotNegativeRatio,
    NotNegativeStress,
    PlanePoint,
    PositiveDensity,
    PositiveInertia,
    PositiveLength,
    PositiveMass,
    PositiveStress,
    Range,
    Safe,
    SpacePoint,
    Tried,
)
from assess.errors import GeometryError
from assess.faults import argument_problems, declared_problems
from assess.geometry import mesh as meshes
from assess.geometry import solid as solids
from assess.geometry.boolean import count_once, intersect, overlap_warnings, shortest_distance
from assess.geometry.contact import CONTACT_TOLERANCE
from assess.geometry.cut import Division, Piece, Plane, Scene, divide, inclined_plane, level_plane
from assess.geometry.mesh import read_selected_meshes
from assess.geometry.planar import (
    PlanarBody,
    base_of_section,
    join_bodies,
    lowest_corners,
    planar_body,
    planar_body_from_values,
)
from assess.geometry.solid import Solid
from assess.geometry.surface import connected_groups, volume
from assess.mechanisms.mechanism import BlockMechanism, CutAngle, CutPlane
from assess.messages.message import Message, Quantity, Value, warning, whole_number
from spectra.arrays import FloatArray

DENSITY = Evidence(
    "defines",
    "either",
    "as stated, within the range of the type of masonry",
    judged="weight holds a wall against thrusts and drives one that crushes; alone on a rigid base it changes nothing",
)
MODULUS = Evidence(
    "measured",
    "either",
    "where it gives the stiffness of joints or a first mode, the worst from 0.15 to 15 GPa",
    judged="it sets the stiffness of joints and the first mode of the building, and a softer one may rock more or less",
    safe=Range((Tried("0.15 GPa"), Tried("1.5 GPa"), Tried("15 GPa"))),
)
LEAST_STRENGTH = 1.0e6  # Pa: the lower bound of disordered rubble, the least of Circolare 7/2019, Table C8.5.I
COMPRESSION = Evidence(
    "measured",
    "up",
    "where joints crush by it, 1 MPa, the least of Table C8.5.I; never above 50 MPa",
    safe=LEAST_STRENGTH,
)
TENSION = Evidence(
    "measured",
    "either",
    "the worse of 0 and what is stated",
    judged="no procedure counts on it; eq. 3.27 places a crack by it, which may be the weaker or the stronger place",
    safe=Range((Tried(0.0),)),
)
FRICTION = Evidence("measured", "up", "absent: whether anything slides is not answered", safe=Safe.ABSENT)
AS_GIVEN = Evidence("defines", "either", "as stated")
INERTIA = Evidence(
    "defines",
    "either",
    "as stated",
    judged="more of it slows the wall, which records overturn less easily, and lets an impact take less from it",
)


@dataclass(frozen=True, kw_only=True)
class Material:
    """A masonry."""

    name: Annotated[str, NotAKey()]
    """by which bodies call it"""
    density: Annotated[PositiveDensity, UNCERTAIN, DENSITY]
    """mass per volume, like "2240 kg/m^3\""""
    young_modulus: Annotated[PositiveStress | None, UNCERTAIN, MODULUS] = None
    """modulus of elasticity, like "6.89 GPa\""""
    compressive_strength: Annotated[MasonryStrength | None, UNCERTAIN, COMPRESSION] = None
    """strength in compression, like "1.0 MPa\""""
    tensile_strength: Annotated[NotNegativeStress | None, UNCERTAIN, TENSION] = None
    """strength of the mortar in tension"""
    friction: Annotated[NotNegativeRatio | None, UNCERTAIN, FRICTION] = None
    """coefficient of friction"""


@dataclass(frozen=True, kw_only=True)
class PointValues:
    """A body without geometry."""

    mass: Annotated[PositiveMass, UNCERTAIN, AS_GIVEN]
    """mass, like "12000 kg\""""
    centroid: Annotated[PlanePoint, AS_GIVEN]
    """centre of mass [x, z]"""
    inertia: Annotated[PositiveInertia, UNCERTAIN, INERTIA]
    """moment of inertia about the centroid, like "5200 kg*m^2\""""


@dataclass(frozen=True, kw_only=True, repr=False)
class Body:
    """One body: a solid of a material, or values without geometry."""

    name: str
    solid: Solid | None = None
    material: Material | None = None
    values: PointValues | None = None

    def __repr__(self) -> str:
        masonry = "" if self.material is None else f", {self.material.name!r}, {self.material.density:.6g} kg/m3"
        return f"Body({self.name!r}, {self.mass:.6g} kg{masonry})"

    @property
    def mass(self) -> float:
        """The mass of its solid, or as given [kg]."""
        if self.solid is not None:
            return self.solid.mass
        assert self.values is not None
        return self.values.mass

    def in_plane(self, direction: Sequence[float]) -> PlanarBody:
        """Return the body seen in the vertical plane of a direction [3]."""
        if self.solid is not None:
            return planar_body(self.solid, direction=direction)
        assert self.values is not None
        given = self.values
        return planar_body_from_values(mass=given.mass, centroid=given.centroid, inertia=given.inertia, name=self.name)


Bodies = Mapping[str, Body]


def solids_of(bodies: Bodies) -> dict[str, Solid | None]:
    """Return the solid of each body, None of those without geometry."""
    return {name: body.solid for name, body in bodies.items()}


def materials_of(block: Sequence[str], bodies: Bodies) -> Iterator[Material]:
    """Return the materials of the bodies of a block that have geometry."""
    for name in block:
        material = bodies[name].material
        if material is not None:
            yield material


def box(
    *,
    thickness: PositiveLength,
    length: PositiveLength,
    height: PositiveLength,
    density: PositiveDensity | Material,
    base: SpacePoint = (0.0, 0.0, 0.0),
    name: str = "box",
) -> Body:
    """Return a rectangular body.

    Parameters
    ----------
    thickness : size along x [m]
    length : size along y [m]
    height : size along z [m]
    density : mass per volume [kg/m3], or the masonry
    base : centre of the base face (x, y, z) [m]
    name : what errors and mechanisms call it

    Raises
    ------
    GeometryError : a size or the density is none that a structure has
    """
    masonry = _masonry(density, name)
    place = tuple(base) if isinstance(base, Sequence | np.ndarray) else base
    given = {"thickness": thickness, "length": length, "height": height, "base": place}
    if problem := next(argument_problems(box, given), ""):
        raise GeometryError(f'body "{name}": {problem}')
    made = solids.box(thickness=thickness, length=length, height=height, base=base, density=masonry.density, name=name)
    return Body(name=name, solid=made, material=masonry)


def profile(
    corners: ArrayLike, *, length: PositiveLength, density: PositiveDensity | Material, name: str = "profile"
) -> Body:
    """Return a polygon in the x-z plane, extruded along y and centred on y = 0.

    Parameters
    ----------
    corners : (x, z) of the polygon in order [n, 2] [m]
    length : of the extrusion [m]
    density : mass per volume [kg/m3], or the masonry
    name : what errors and mechanisms call it

    Raises
    ------
    GeometryError : the polygon crosses itself or has no area, or a number is none that a structure has
    """
    masonry = _masonry(density, name)
    if problem := next(argument_problems(profile, {"length": length}), ""):
        raise GeometryError(f'body "{name}": {problem}')
    made = solids.profile(corners, length=length, density=masonry.density, name=name)
    return Body(name=name, solid=made, material=masonry)


def mesh(
    path: str | Path,
    *,
    density: float | Material,
    unit: float | None = None,
    up: Literal["y", "z"] | None = None,
    element: str | None = None,
    name: str = "mesh",
) -> Body:
    """Return a body bounded by the triangle mesh of a file, mended where it is not closed.

    Parameters
    ----------
    path : STL, OBJ, PLY, OFF, GLB, glTF or 3MF; STEP, Rhino .3dm or IFC with the extra packages
    density : mass per volume [kg/m3], or the masonry
    unit : of the file's coordinates [m]; the file's own where None, metres where it states none
    up : axis of the file that points up, "y" or "z"; "y" for glTF and "z" for all others where None
    element : only elements of the file: a name, a GlobalId, a class like "IfcWall", or a pattern; all where None
    name : what errors and mechanisms call it

    Raises
    ------
    GeometryError : the file cannot be read, or its mesh cannot be closed
    """
    if not isinstance(path, str | Path):
        raise GeometryError(f'body "{name}": path = {path!r:.60}: give the path of one file')
    if element is not None and not isinstance(element, str):
        raise GeometryError(f'body "{name}": element = {element!r:.60}: give a text')
    if up not in ("y", "z", None):
        raise GeometryError(f'body "{name}": up = {up!r}: write "y" or "z"')
    masonry, selection = _masonry(density, name), (Path(path), element)
    model = read_selected_meshes({name: selection})[selection]
    made = meshes.solid_from_meshes(model, density=masonry.density, name=name, scale=unit, up=up)
    return Body(name=name, solid=made, material=masonry)


def pieces_of(name: str, definition: BlockMechanism, bodies: Bodies) -> tuple[Piece, ...]:
    """Return the blocks of a mechanism, base first, each above the cut if there is one.

    Parameters
    ----------
    name : of the mechanism
    definition : the mechanism as stated
    bodies : of the building, by name

    Raises
    ------
    GeometryError : the cut misses all of them, or crosses a body without geometry
    """
    plane = cut_of(definition, where=f'mechanism "{name}": cut')
    if plane is None:
        return tuple(_uncut_block(block, definition.towards, bodies) for block in definition.blocks)
    crossed = [_crosses_plane(block, plane, bodies) for block in definition.blocks]
    if len(definition.blocks) == 1 or not any(crossed):
        crossed = [True, *crossed[1:]]  # one must be: `divide` says why it is not
    return tuple(
        _block_above_cut(name, block, plane, definition.towards, bodies)
        if cut
        else _uncut_block(block, definition.towards, bodies)
        for block, cut in zip(definition.blocks, crossed, strict=True)
    )


def piece_above_cut(parts: Division, direction: Sequence[float]) -> Piece:
    """Return the upper side of a cut as a block."""
    body = join_bodies([planar_body(solid, direction=direction) for solid in parts.above])
    body = replace(body, base=base_of_section(parts.foot, direction=direction))
    return Piece(body, parts.above, parts.foot, True, parts.section)


def scene_of(pieces: Sequence[Piece], direction: Sequence[float]) -> Scene | None:
    """Return the blocks of a mechanism in space; None if none of them has geometry."""
    if not any(piece.solids for piece in pieces):
        return None
    return Scene(
        members=tuple(piece.solids for piece in pieces),
        fixed=tuple(solid for piece in pieces for solid in piece.fixed),
        sections=tuple(ring for piece in pieces for ring in piece.section),
        direction=np.array(direction) / np.linalg.norm(direction),
    )


def cut_of(definition: BlockMechanism, *, where: str) -> Plane | None:
    """Return the plane of the cut; raise GeometryError if its normal does not point up.

    A crack inclined by a positive angle falls towards the direction.
    """
    cut = definition.cut
    if isinstance(cut, CutPlane):
        return inclined_plane(cut.point, cut.normal, where=where)
    if isinstance(cut, CutAngle):
        x, y, _ = definition.along
        return inclined_plane(cut.point, (sin(cut.angle) * x, sin(cut.angle) * y, cos(cut.angle)), where=where)
    return None if cut is None else level_plane(cut)


Gap = dict[str, Value]
"""The values of a warning of two bodies that lie apart."""


def solids_of_block(block: Sequence[str], bodies: Bodies) -> tuple[Solid, ...]:
    """Return the solids of the bodies of a block, so that what they share belongs to the first of them alone.

    Parameters
    ----------
    block : names of its bodies, which move as one
    bodies : of the building, by name
    """
    return count_once(_known_solids(block, bodies))


def contradictions_in_blocks(definition: BlockMechanism, bodies: Bodies) -> Iterator[Message]:
    """Warn of bodies of one block that overlap, where their common volume counts once, and of a gap between them.

    Bodies are compared whole, even if a cut leaves their base behind.
    """
    for block in definition.blocks:
        if len(block) > 1:
            yield from overlap_warnings(_known_solids(block, bodies))
            yield from (warning("gap", **each) for each in gaps_in_block(_block_solids(block, bodies)))


def gaps_in_block(block: Sequence[Solid]) -> Iterator[Gap]:
    """Find each gap that would have to be closed for the bodies of a block to touch one another."""
    pairs = list(combinations(range(len(block)), 2))
    joined = [(i, j) for i, j in pairs if _in_contact(block[i], block[j])]
    while len(block) > 1:
        group = connected_groups(np.array(joined, dtype=np.int64).reshape(-1, 2), count=len(block))
        across = [(shortest_distance(block[i], block[j]), (i, j)) for i, j in pairs if group[i] != group[j]]
        if not across:
            return
        distance, (i, j) = min(across)
        joined.append((i, j))
        yield _gap_values(block[i], block[j], distance)


def gaps_at_hinge(one: Sequence[Solid], other: Sequence[Solid]) -> Iterator[Gap]:
    """Find the gap between two blocks with a hinge between them that touch nowhere."""
    pairs = list(product(one, other))
    if not pairs or any(_in_contact(*pair) for pair in pairs):
        return
    distances = [shortest_distance(*pair) for pair in pairs]
    yield _gap_values(*pairs[int(np.argmin(distances))], min(distances))


BLOCKS_OVERLAP = 0.01  # of the mass of the lighter block: what moves apart may share no more


def contradictions_of_blocks(pieces: Sequence[Piece]) -> Iterator[Message]:
    """Warn of two blocks that overlap, so that neither can be where it is drawn, and of a block in the air.

    Parameters
    ----------
    pieces : the blocks of a mechanism, as they are cut, each with a hinge to the next
    """
    for (number, one), (place, other) in combinations(enumerate(pieces, start=1), 2):
        shared = [(a, each) for a in one.solids for b in other.solids if (each := intersect(a, b)) is not None]
        mass = sum(each.volume * a.mass / volume(a.vertices, a.triangles) for a, each in shared)
        share = mass / min(sum(solid.mass for solid in piece.solids) for piece in (one, other)) if shared else 0.0
        if share > BLOCKS_OVERLAP:
            yield warning(
                "blocks-overlap",
                first=whole_number(number),
                second=whole_number(place),
                mass=Quantity(mass, "mass", 3),
                share=Quantity(100.0 * share, "percent", 3),
            )
    for number, (one, other) in enumerate(pairwise(pieces), start=1):
        for gap in gaps_at_hinge(one.solids, other.solids):
            yield warning("blocks-apart", first=whole_number(number), second=whole_number(number + 1), **gap)


def blocks_side_by_side(lower: Piece, upper: Piece, *, along: FloatArray) -> Iterator[Message]:
    """Warn of an upper block of a wall that begins beside the lower one and not on it.

    A joint that rises by more than the thickness is steeper than any crack across a wall.

    Parameters
    ----------
    lower, upper : the blocks
    along : unit vector of the motion [3]
    """
    corners = [np.concatenate([solid.vertices for solid in each.solids]) for each in (lower, upper) if each.solids]
    if len(corners) < 2:
        return
    below, above = corners
    beside = float(below[:, 2].max() - above[:, 2].min())
    if beside > float(np.ptp(below @ along)):
        yield warning("blocks-beside", depth=Quantity(beside, "length", 3))


def _masonry(density: float | Material, name: str) -> Material:
    """Return the masonry of a body; raise GeometryError for a name that mechanisms cannot call it by."""
    if not isinstance(name, str) or not name:
        raise GeometryError(f"name = {name!r:.60}: give a text, by which mechanisms call the body")
    masonry = density if isinstance(density, Material) else Material(name=name, density=density)
    if problem := next(declared_problems(masonry), ""):
        raise GeometryError(f'body "{name}": {problem}')
    return masonry


def _uncut_block(block: Sequence[str], direction: Sequence[float], bodies: Bodies) -> Piece:
    """Return the bodies of a block uncut."""
    standing = solids_of_block(block, bodies)
    seen = [planar_body(solid, direction=direction) for solid in standing]
    seen += [bodies[body].in_plane(direction) for body in block if bodies[body].solid is None]
    return Piece(join_bodies(seen), standing, lowest_corners(standing) if standing else None)


def _block_above_cut(
    name: str, block: Sequence[str], plane: Plane, direction: Sequence[float], bodies: Bodies
) -> Piece:
    """Return the part of a block above a cut."""
    parts = divide(solids_to_cut(name, block, bodies), plane, where=f'mechanism "{name}": cut')
    return replace(piece_above_cut(parts, direction), fixed=parts.below)


def _crosses_plane(block: Sequence[str], plane: Plane, bodies: Bodies) -> bool:
    """Return whether a body of the block reaches below the plane."""
    corners = [solid.vertices for body in block if (solid := bodies[body].solid) is not None]
    return any(bool(((points - plane.point) @ plane.normal < 0.0).any()) for points in corners)


def solids_to_cut(name: str, block: Sequence[str], bodies: Bodies) -> tuple[Solid, ...]:
    """Return the solids of a block; raise GeometryError for a body without geometry."""
    for body in block:
        if bodies[body].solid is None:
            raise GeometryError(
                f'mechanism "{name}": cut: body "{body}" has no geometry to cut; give it a mesh, box or profile, or '
                "remove the cut and give the values of what lies above"
            )
    return solids_of_block(block, bodies)


def _known_solids(block: Sequence[str], bodies: Bodies) -> list[Solid]:
    """Return the solids of the bodies of a block that have geometry, each whole."""
    return [solid for body in dict.fromkeys(block) if (solid := bodies[body].solid) is not None]


def _block_solids(block: Sequence[str], bodies: Bodies) -> list[Solid]:
    """Return the solids of a block; none if a body has no geometry, as its extent is not known."""
    found = _known_solids(block, bodies)
    return found if len(found) == len(set(block)) else []


def _in_contact(one: Solid, other: Solid) -> bool:
    """Return whether two bodies are closer than the thickness of a joint."""
    return shortest_distance(one, other, limit=CONTACT_TOLERANCE) < CONTACT_TOLERANCE


def _gap_values(one: Solid, other: Solid, distance: float) -> Gap:
    """Return the values of a warning: which two bodies are apart, and by how much [m]."""
    return {"one": one.name, "other": other.name, "distance": Quantity(distance, "length", 3)}
