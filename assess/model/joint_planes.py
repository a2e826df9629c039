"""Where the hinges of a mechanism press: the faces that meet there, found on the geometry, and their friction."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import shapely

from assess.errors import GeometryError
from assess.geometry.cut import Piece, Plane, divide, heading, project_on_plane
from assess.geometry.solid import Solid
from assess.geometry.surface import areas_and_normals
from assess.loads.load import Point
from assess.mechanisms.chain import FACING_BLOCKS, Chain
from assess.mechanisms.flexible_chain import JointedChain
from assess.mechanisms.mechanism import BlockMechanism, Face, Mechanism
from assess.messages.message import Message, Term, message
from assess.model.bodies import Bodies, cut_of, materials_of
from spectra.arrays import FloatArray

Vector = tuple[float, float]
UP, DOWN = (0.0, 1.0), (0.0, -1.0)
TOUCH = 0.01  # m: faces this near a plane lie in it; joints are as thick, and drawings no better
ACROSS = 0.05  # part of a unit normal along the axis of rotation: a face turned aside by more is no joint
SAME_NORMAL = 1e-3  # faces whose unit normals differ by less are one
EDGE = 0.02  # of the depth of a contact: a hinge this near its edge is on it
NOT_UPRIGHT = 0.26  # vertical part of a unit normal: a face within 15 degrees of upright carries nothing
SLIVER = 1e-6  # m2: less is no contact


@dataclass(frozen=True)
class MotionPlane:
    """The plane of motion of one branch in space.

    along : unit vector of its motion [3]; sign : -1 where that is against the direction
    """

    along: FloatArray
    sign: float

    @classmethod
    def towards(cls, direction: Sequence[float], *, sign: float) -> MotionPlane:
        """Return the plane of a direction, or of its opposite."""
        return cls(sign * np.array(direction) / np.linalg.norm(direction), sign)

    @property
    def axis(self) -> FloatArray:
        """The axis of rotation, horizontal across the motion [3]."""
        return np.array([-self.along[1], self.along[0], 0.0])

    def world(self, vector: Vector) -> FloatArray:
        """Return a vector or point (x, z) of the branch in space [3]."""
        return np.asarray(vector[0] * self.along + vector[1] * np.array([0.0, 0.0, 1.0]))

    def project_vector(self, vector: FloatArray) -> Vector:
        """Return the unit vector (x, z) of a vector in space [3] in the plane of motion."""
        x, z = float(vector @ self.along), float(vector[2])
        length = float(np.hypot(x, z))
        return (x / length, z / length)


@dataclass(frozen=True)
class JointPlane:
    """The plane of a joint, and where the faces touch there.

    normal : from the held face to the pressing block, in the plane of motion; region : in coordinates of the plane
    """

    normal: Vector
    plane: Plane
    region: shapely.MultiPolygon

    def beyond(self, hinge: FloatArray, out: FloatArray) -> float:
        """Return how far the contact reaches beyond a hinge [3] in a direction of the plane [2] [m]."""
        at = project_on_plane(self.plane, hinge - self.plane.point) @ out
        return float((shapely.get_coordinates(self.region) @ out).max() - at)


def find_joint_plane(
    number: int, hinge: Point, definition: BlockMechanism, pieces: Sequence[Piece], view: MotionPlane, *, where: str
) -> JointPlane:
    """Find the joint plane at a hinge: on the ground or the cut, at the support at the top, or between blocks.

    Raises GeometryError where no faces meet at the hinge.
    """
    blocks = definition.number_of_blocks
    face, pressing = FACING_BLOCKS[blocks][number]
    ordered = pieces if view.sign > 0.0 or len(pieces) == blocks else pieces[::-1]
    if not all(piece.solids for piece in ordered):
        raise GeometryError(
            f"{where}: its body has no geometry, so its contact is not known; give shape, like "
            "{ rectangle = [thickness, length] }"
        )
    if face is not None:
        return _joint_plane_between(number, hinge, ordered, blocks, view, where=where)
    piece = ordered[-1 if pressing == blocks - 1 else 0]
    if blocks == number == 2:
        return _joint_plane_on_face(piece.solids, hinge, view, UP, where=where)
    plane = cut_of(definition, where=where) if piece.cut and len(pieces) == blocks else None
    if plane is None:
        return _joint_plane_on_face(piece.solids, hinge, view, DOWN, where=where)
    return JointPlane(view.project_vector(plane.normal), plane, divide(piece.solids, plane, where=where).region)


STEEP = 0.5  # vertical part of a unit normal: of a face 60 degrees off level


def faces_of(
    mechanism: Mechanism, definition: BlockMechanism, pieces: Sequence[Piece], bodies: Bodies
) -> tuple[tuple[Face, ...], ...]:
    """Return the faces at the hinges of the positive and of the negative branch, each in its own sign."""
    frictions = [_friction_at(number, definition, bodies) for number in range(len(mechanism.positive.hinges))]
    chains = [chain for chain in (mechanism.positive, mechanism.negative) if chain is not None]
    return tuple(
        tuple(
            Face(
                *_hinge_normal(number, chain, definition, pieces, MotionPlane.towards(definition.towards, sign=sign)),
                *frictions[number],
            )
            for number in range(len(chain.hinges))
        )
        for chain, sign in zip(chains, (1.0, -1.0), strict=False)
    )


def _normal_at(
    number: int, hinge: Point, definition: BlockMechanism, pieces: Sequence[Piece], view: MotionPlane, *, where: str
) -> Vector:
    """Return the normal of the joint plane at a hinge, from the held face to the pressing block; a known cut is reused.

    Raises GeometryError where no faces meet at the hinge.
    """
    face, pressing = FACING_BLOCKS[definition.number_of_blocks][number]
    piece = pieces[min(pressing, len(pieces) - 1)]
    if (
        face is None
        and not (definition.number_of_blocks == number == 2)
        and piece.cut
        and len(pieces) == definition.number_of_blocks
    ):
        plane = cut_of(definition, where=where)
        if plane is not None:
            return view.project_vector(plane.normal)
    if face is None and piece.solids and len(pieces) == definition.number_of_blocks:
        side = UP if definition.number_of_blocks == number == 2 else DOWN
        plane = _plane_of_face(piece.solids, hinge, view, side)
        lying = _corners_in(piece.solids, plane)
        _require_contact(sum(float(areas_and_normals(corners)[0].sum()) for corners in lying), hinge, where)
        return view.project_vector(-plane.normal)
    return find_joint_plane(number, hinge, definition, pieces, view, where=where).normal


def _joint_plane_on_face(
    solids: Sequence[Solid], hinge: Point, view: MotionPlane, side: Vector, *, where: str
) -> JointPlane:
    """Find the face of a block on the ground, or of a wall under the support at its top.

    Raises GeometryError where none lies at the hinge.
    """
    plane = _plane_of_face(solids, hinge, view, side)
    region = _parts_with_area(_faces_in(solids, plane))
    _require_contact(region.area, hinge, where)
    return JointPlane(view.project_vector(-plane.normal), plane, region)


def _require_contact(area: float, hinge: Point, where: str) -> None:
    """Raise GeometryError where the faces at a hinge have no area [m2]."""
    if area <= SLIVER:
        raise GeometryError(
            f"{where}: no face of its block lies at the hinge ({hinge[0]:.4g}, {hinge[1]:.4g}) m; give shape"
        )


def _plane_of_face(solids: Sequence[Solid], hinge: Point, view: MotionPlane, side: Vector) -> Plane:
    """Return the plane of the face through the hinge that looks most to a side; where none does, the last level there.

    Its normal points out of the block.
    """
    at = view.world(hinge)
    found = [normal for normal in _normals_at(solids, at, view) if normal[2] * side[1] >= NOT_UPRIGHT]
    if found:
        return Plane(at, max(found, key=lambda normal: float(normal[2] * side[1])))
    heights = np.concatenate([solid.vertices[:, 2] for solid in solids])
    level = float(heights.max() if side == UP else heights.min())
    return Plane(view.world((hinge[0], level)), np.array([0.0, 0.0, side[1]]))


def _joint_plane_between(
    number: int, hinge: Point, pieces: Sequence[Piece], blocks: int, view: MotionPlane, *, where: str
) -> JointPlane:
    """Find where two blocks, or two voussoirs of an arch, touch with an edge of the contact at the hinge."""
    at = view.world(hinge)
    for over, under in _neighbours(number, pieces, blocks):
        for outward in _normals_at(over, at, view):
            plane = Plane(at, outward)
            facing = _faces_in(under, Plane(at, -outward), seen_in=plane)
            region = _parts_with_area(shapely.intersection(_faces_in(over, plane), facing))
            if region.area <= SLIVER:
                continue
            joint_plane = JointPlane(view.project_vector(-outward), plane, region)
            way = heading(plane, view.world((outward[2], -float(outward @ view.along))), axis=view.axis)
            ends = abs(joint_plane.beyond(at, way)), abs(joint_plane.beyond(at, -way))
            if min(ends) <= max(EDGE * max(ends), TOUCH):
                return joint_plane
    raise GeometryError(
        f"{where}: no faces of its blocks touch with an edge at the hinge ({hinge[0]:.4g}, {hinge[1]:.4g}) m; mend the "
        "hinge, or give shape"
    )


def _neighbours(
    number: int, pieces: Sequence[Piece], blocks: int
) -> Iterator[tuple[tuple[Solid, ...], tuple[Solid, ...]]]:
    """Return the solids that press and those that hold the face at a hinge; of an arch all neighbours may."""
    face, pressing = FACING_BLOCKS[blocks][number]
    assert face is not None
    if len(pieces) == blocks:
        yield pieces[pressing].solids, pieces[face].solids
        return
    for one, other in pairwise(pieces):
        yield (other.solids, one.solids) if pressing > face else (one.solids, other.solids)


def _normals_at(solids: Sequence[Solid], at: FloatArray, view: MotionPlane) -> list[FloatArray]:
    """Return the outward unit normals of the faces that contain the axis through a point [3], largest face first."""
    there: list[tuple[FloatArray, FloatArray]] = []
    for solid in solids:
        corners = solid.vertices[solid.triangles]
        area, normal = areas_and_normals(corners)
        off = np.abs(np.einsum("ij,ij->i", corners[:, 0] - at, normal))
        lying = (area > 0.0) & (off <= TOUCH) & (np.abs(normal @ view.axis) <= ACROSS)
        there.append((normal[lying], area[lying]))
    normals, areas = (np.concatenate(each) for each in zip(*there, strict=True))
    found = []
    while len(normals):
        alike = np.abs(normals - normals[0]).max(axis=1) <= SAME_NORMAL
        found.append((normals[0], areas[alike].sum()))
        normals, areas = normals[~alike], areas[~alike]
    return [normal for normal, _ in sorted(found, key=lambda each: -each[1])]


def _faces_in(solids: Sequence[Solid], plane: Plane, *, seen_in: Plane | None = None) -> shapely.Geometry:
    """Return the faces of solids that lie in a plane and face along its normal, in the coordinates of `seen_in`."""
    shown, pieces = seen_in or plane, []
    axes = np.column_stack([project_on_plane(shown, unit) for unit in np.eye(3)])
    for corners in _corners_in(solids, plane):
        pieces += [shapely.polygons(each) for each in (corners - shown.point) @ axes.T]
    return shapely.union_all([piece for piece in pieces if piece.area > 0.0])


def _corners_in(solids: Sequence[Solid], plane: Plane) -> Iterator[FloatArray]:
    """Yield the corners [k, 3, 3] of the triangles of each solid that lie in a plane and face along its normal."""
    for solid in solids:
        near = np.abs((solid.vertices - plane.point) @ plane.normal) <= TOUCH
        corners = solid.vertices[solid.triangles[near[solid.triangles].all(axis=1)]]
        area, normal = areas_and_normals(corners)
        yield corners[(area > 0.0) & (normal @ plane.normal >= 1.0 - SAME_NORMAL)]


def _parts_with_area(region: shapely.Geometry) -> shapely.MultiPolygon:
    """Return the parts of a region that have area."""
    return shapely.MultiPolygon([part for part in shapely.get_parts(region) if part.area > SLIVER])


def _hinge_normal(
    number: int, chain: Chain, definition: BlockMechanism, pieces: Sequence[Piece], view: MotionPlane
) -> tuple[Vector, bool]:
    """Return the normal at a hinge, to the pressing block, and whether the geometry shows it; otherwise it is vertical.

    What a block stands on is not part of the geometry: a face steeper than STEEP, as the intrados of a vault, is no
    joint plane.
    """
    ground = FACING_BLOCKS[len(chain.blocks)][number][0] is None
    if chain.joints and chain.joints[number] is not None:
        normal = complex(JointedChain(chain, "").normal[number])
        return (normal.real, normal.imag), True
    upright = DOWN if len(chain.blocks) == number == 2 else UP
    try:
        found = _normal_at(number, chain.hinges[number], definition, pieces, view, where="")
    except GeometryError:
        return upright, False
    return (upright, False) if ground and found[1] * upright[1] < STEEP else (found, True)


def _friction_at(number: int, definition: BlockMechanism, bodies: Bodies) -> tuple[float | None, Term | Message]:
    """Return the least friction of the blocks that meet at a hinge, None if one has none, with the remedy."""
    least: float | None = None
    for block in FACING_BLOCKS[definition.number_of_blocks][number]:
        if block is None:
            continue
        materials = dict.fromkeys(materials_of(definition.blocks[min(block, len(definition.blocks) - 1)], bodies))
        given = [mu for material in materials if (mu := material.friction) is not None]
        if not given:
            keys = " / ".join(f"materials.{material.name}.friction" for material in materials)
            none = Term("give its bodies geometry and a material with friction")
            return None, message("remedy-keys", {"keys": keys}) if keys else none
        least = min(given) if least is None else min(least, *given)
    return least, Term("")
