"""Mechanisms from what an engineer states: bodies cut into blocks, their loads, and the joints under their hinges."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import dist, inf

import numpy as np
import shapely

from assess.errors import CrackError, GeometryError, MechanismError
from assess.geometry.cut import Piece, Scene, heading
from assess.interfaces.contact import Interface, JointLaw, contact, out_of_plane_warning
from assess.interfaces.section import ContactSection, Shape, annulus, circle, hollow_rectangle, polygon, rectangle
from assess.loads.bearing import UPPER, overburden_name
from assess.loads.load import Load, LoadDefinition, OverburdenLoad, Through, stretches
from assess.mechanisms.arch_in_plan import HorizontalArch
from assess.mechanisms.assembly import OUTSIDE, HingeBeside, MechanismPieces, add_joints, hinges_in_plane
from assess.mechanisms.chain import Chain, Joint, hinge_names, top_loads
from assess.mechanisms.flexible_chain import FlexibleChain, JointedChain
from assess.mechanisms.hinge_forces import is_top_support
from assess.mechanisms.kinds import MECHANISM_KINDS, Definition
from assess.mechanisms.mechanism import BlockMechanism, Mechanism
from assess.mechanisms.restitution import RestitutionChoice
from assess.mechanisms.two_block import TwoBlock
from assess.mechanisms.wedged_block import WedgedBlock
from assess.messages.message import Message, Quantity, distinct, warning
from assess.model.arch_panels import arch_of_panel
from assess.model.bodies import (
    Bodies,
    Material,
    blocks_side_by_side,
    contradictions_in_blocks,
    contradictions_of_blocks,
    materials_of,
    pieces_of,
    scene_of,
)
from assess.model.joint_planes import DOWN, UP, JointPlane, MotionPlane, Vector, faces_of, find_joint_plane
from assess.model.loading import loads_of
from assess.model.walls import Crack, blocks_at, crack_of, require_as_found
from assess.model.wedges import wedged_piece


@dataclass(frozen=True)
class Built:
    """A mechanism, and its bodies in space where it has any."""

    mechanism: Mechanism
    scene: Scene | None


def mechanism_of(name: str, definition: Definition, bodies: Bodies) -> Built:
    """Build the mechanism of a definition."""
    if not isinstance(definition, BlockMechanism):
        mechanism, _ = MECHANISM_KINDS[definition.kind].build(name, definition, (), loads=())
        return Built(mechanism, None)
    rigid, members = on_rigid_hinges(name, definition, bodies)
    if definition.sides == "one":
        _require_anchors_behind(rigid)
    if isinstance(definition, HorizontalArch):
        return Built(replace(rigid, direction=definition.towards), scene_of(members, definition.towards))
    jointed = _place_on_joints(rigid, definition, members, bodies, restitution=definition.restitution.choices)
    faces = faces_of(jointed, definition, members, bodies)
    return Built(replace(jointed, faces=faces, direction=definition.towards), scene_of(members, definition.towards))


def _require_anchors_behind(mechanism: Mechanism) -> None:
    """Raise MechanismError for a tie that stretches to an anchor towards which a one-sided mechanism moves.

    It is looked at once the direction is settled: a search may try to turn a wall away from what holds it.
    """
    for tie in filter(stretches, mechanism.positive.loads):
        if tie.anchor is not None and tie.anchor[0] - tie.at[0] > abs(tie.anchor[1] - tie.at[1]):
            raise MechanismError(
                f'mechanism "{mechanism.name}": loads[{tie.name.removeprefix("tie ")}].anchor: '
                f"{tie.anchor[0] - tie.at[0]:.4g} m in front of the wall, which shortens the tie as it overturns, so "
                "that it never holds; give an anchor behind it"
            )


def on_rigid_hinges(name: str, definition: BlockMechanism, bodies: Bodies) -> MechanismPieces:
    """Build the mechanism on rigid hinges, before it is placed on its joints."""
    if isinstance(definition, HorizontalArch):
        return arch_of_panel(name, definition, bodies)
    try:
        pieces, crack = _cut_into_blocks(name, definition, bodies)
        load_set = loads_of(name, definition, pieces, bodies)
        require_as_found(crack, load_set.loads)
        mechanism, members = MECHANISM_KINDS[definition.kind].build(name, definition, pieces, loads=load_set.loads)
    except CrackError as error:
        raise MechanismError(f'mechanism "{name}": {error}') from None
    warnings = mechanism.warnings if crack is None else (*crack.warnings, *mechanism.warnings)
    wrong = [*contradictions_in_blocks(definition, bodies)]
    wrong += contradictions_of_blocks(members) if len(definition.blocks) > 1 else ()
    if isinstance(definition, TwoBlock) and len(definition.blocks) > 1:
        wrong += blocks_side_by_side(*members, along=definition.along)
    return replace(mechanism, warnings=(*warnings, *load_set.warnings, *wrong)), members


@dataclass(frozen=True)
class PressedHinge:
    """A hinge of one branch, and what it presses on.

    number : of the hinge; name : of the mechanism; sign : -1 for the branch that is mirrored
    """

    number: int
    chain: Chain
    name: str
    definition: BlockMechanism
    interface: Interface
    pieces: tuple[Piece, ...]
    sign: float

    @property
    def hinge_name(self) -> str:
        """The interface, as messages name it."""
        return hinge_names(self.chain)[self.number] + "'" * (self.sign < 0)

    @property
    def is_stated(self) -> bool:
        """Whether its place is stated, not found on the bodies."""
        definition = self.definition
        return (definition.hinge_points if self.sign > 0.0 else definition.hinges_negative) is not None

    @property
    def where(self) -> str:
        """The mechanism and the interface, as errors name them."""
        return f'mechanism "{self.name}": interface {self.hinge_name}'

    @property
    def point(self) -> tuple[float, float]:
        """The place of the hinge (x, z) [m]."""
        return self.chain.hinges[self.number]

    @property
    def motion_plane(self) -> MotionPlane:
        """The plane of motion of the branch."""
        return MotionPlane.towards(self.definition.towards, sign=self.sign)

    def plane(self) -> JointPlane:
        """Find the plane of the joint; raise GeometryError if no faces meet at the hinge."""
        return find_joint_plane(
            self.number, self.point, self.definition, self.pieces, self.motion_plane, where=self.where
        )


def _cut_into_blocks(name: str, definition: BlockMechanism, bodies: Bodies) -> tuple[Sequence[Piece], Crack | None]:
    """Cut the bodies into blocks; a wall of one body is cut at its crack, which is returned too."""
    if isinstance(definition, WedgedBlock):
        return (wedged_piece(name, definition, bodies),), None
    pieces = pieces_of(name, definition, bodies)
    if not isinstance(definition, TwoBlock) or len(pieces) == 2:
        return pieces, None
    front = hinges_in_plane(definition.hinge_points, definition)
    found = crack_of(definition, pieces[0], bodies, lambda: loads_of(name, definition, pieces, bodies), front=front)
    return blocks_at(found.elevation, name, definition, pieces[0]), found


NEAR = 0.02  # of the depth of a contact: a hinge farther from its edge gets a warning
TURNED = 0.05  # rad: where the resultant of an unsymmetric contact is looked at


def _place_on_joints(
    mechanism: Mechanism,
    definition: BlockMechanism,
    pieces: Sequence[Piece],
    bodies: Bodies,
    *,
    restitution: tuple[RestitutionChoice, RestitutionChoice],
) -> Mechanism:
    """Place a mechanism on its interfaces; it is returned unchanged if all are rigid and of unlimited strength.

    Raises GeometryError where a contact is not found, MechanismError or InterfaceError where one cannot carry its load.
    """
    chains = [chain for chain in (mechanism.positive, mechanism.negative) if chain is not None]
    interfaces = [definition.interface_at(hinge_name) for hinge_name in hinge_names(mechanism.positive)]
    found = [
        [
            _joint_at(PressedHinge(number, chain, mechanism.name, definition, interface, tuple(pieces), sign), bodies)
            for number, interface in enumerate(interfaces)
        ]
        for chain, sign in zip(chains, (1.0, -1.0), strict=False)
    ]
    warnings = [each for side in found for _, messages in side for each in messages]
    joints = [tuple(joint for joint, _ in side) for side in found]
    through = _through_of(definition.loads)
    moved = [_move_loads_to_joint(chain, side[-1], through) for chain, side in zip(chains, joints, strict=True)]
    joints = [_joints_under_loads(chain, side, through) for chain, side in zip(moved, joints, strict=True)]
    loaded = replace(mechanism, positive=moved[0], negative=moved[1] if len(moved) > 1 else None)
    if not any(joint for side in joints for joint in side):
        return loaded
    if loaded.positive.loads != mechanism.positive.loads and "joint" not in through.values():
        warnings.append(warning("load-through-top"))
    warnings += _contact_offset_warnings(mechanism, joints)
    made = add_joints(loaded, joints[0], joints[-1] if len(joints) > 1 else (), restitution=restitution)
    warnings = [*made.warnings, *warnings, *_eccentricity_warnings(made)]
    return replace(made, warnings=distinct(warnings))


def _contact_offset_warnings(mechanism: Mechanism, joints: Sequence[Sequence[Joint | None]]) -> Iterator[Message]:
    """Warn if the contacts at the base lie in different places for the two directions."""
    if mechanism.negative is None or len(mechanism.positive.blocks) == 3:
        return
    front, back = joints[0][0], joints[1][0]
    if front is None or back is None:
        return
    ahead = mechanism.positive.hinges[0][0] + front.section.centroid * front.inward[0]
    behind = mechanism.negative.hinges[0][0] + back.section.centroid * back.inward[0]
    if abs(ahead + behind) > NEAR * front.section.depth:
        distance, depth = (Quantity(each, "length", 3) for each in (abs(ahead + behind), front.section.depth))
        yield warning("contacts-apart", distance=distance, depth=depth)


def _joint_at(hinge: PressedHinge, bodies: Bodies) -> tuple[Joint | None, tuple[Message, ...]]:
    """Return the joint under a hinge, with warnings; None if it is rigid or carries nothing."""
    interface = hinge.interface
    law = _law_of(interface, next(materials_of(hinge.definition.bodies, bodies), None), where=hinge.where)
    if law is None:
        return None, ()
    endless = interface.model != "rigid" and law.strength == inf and interface.strength is None
    hinge_name = hinge_names(hinge.chain)[hinge.number]
    warnings = (warning("never-crushes", interface=hinge_name),) if endless else ()
    shape, sense = interface.shape, float(JointedChain(hinge.chain, hinge.name).sense[hinge.number])
    if isinstance(shape, Shape):
        joint, more = _shaped_joint(hinge, law, shape, sense=sense)
    else:
        joint, more = _outlined_joint(hinge, law, sense=sense)
    return joint, (*warnings, *more)


def _shaped_joint(
    hinge: PressedHinge, law: JointLaw, shape: Shape, *, sense: float
) -> tuple[Joint, tuple[Message, ...]]:
    """Return a joint of given sizes in the plane of the faces that meet, level if there are none."""
    warnings: tuple[Message, ...] = ()
    try:
        normal = hinge.plane().normal
    except GeometryError:
        normal = DOWN if is_top_support(hinge.chain, hinge.number) else UP
        warnings = (warning("joint-taken-level", interface=hinge.hinge_name),)
    return Joint(
        _inward(normal, sense), _section_of_shape(shape, hinge.motion_plane), law, hinge.interface.model
    ), warnings


def _outlined_joint(hinge: PressedHinge, law: JointLaw, *, sense: float) -> tuple[Joint, tuple[Message, ...]]:
    """Return the joint of the outline where faces meet; warn if the hinge is not at its edge."""
    joint_plane, view = hinge.plane(), hinge.motion_plane
    inward = _inward(joint_plane.normal, sense)
    out = heading(joint_plane.plane, -view.world(inward), axis=view.axis)
    found = polygon(joint_plane.region, direction=out)
    aside = joint_plane.beyond(view.world(hinge.point), out)
    joint = Joint(inward, found, law, hinge.interface.model)
    if abs(aside) <= NEAR * found.depth:
        return joint, ()
    key = "hinge-inside-contact" if aside > 0.0 else "hinge-outside-contact"
    if -aside > OUTSIDE * found.depth and hinge.is_stated:
        key = HingeBeside.CONTACT
    distance, depth = (Quantity(each, "length", 3) for each in (abs(aside), found.depth))
    return joint, (warning(key, interface=hinge.hinge_name, distance=distance, depth=depth),)


def _law_of(interface: Interface, material: Material | None, *, where: str) -> JointLaw | None:
    """Return stiffness and strength; None for a rigid joint of unlimited strength."""
    strength = interface.strength
    if interface.model == "rigid":
        return None if strength in (None, inf) else JointLaw(strength=strength or inf)
    if strength is None:
        strength = (material and material.compressive_strength) or inf
    if interface.stiffness is not None:
        return JointLaw(interface.stiffness, strength)
    if material is None or material.young_modulus is None:
        raise MechanismError(
            f"{where}: course_thickness needs young_modulus of the material; give it, or stiffness instead"
        )
    return JointLaw(material.young_modulus / (interface.course_thickness or inf), strength)


def _section_of_shape(shape: Shape, view: MotionPlane) -> ContactSection:
    """Return a contact of given sizes, seen in the direction of motion."""
    if shape.rectangle is not None:
        return rectangle(*shape.rectangle)
    if shape.hollow_rectangle is not None:
        thickness, length, *inner = shape.hollow_rectangle
        return hollow_rectangle(thickness, length, inner=(inner[0], inner[1]))
    if shape.circle is not None:
        return circle(shape.circle)
    if shape.annulus is not None:
        return annulus(shape.annulus[0], inner=shape.annulus[1])
    return polygon(shapely.Polygon(shape.polygon), direction=view.along[:2])


def _inward(normal: Vector, sense: float) -> Vector:
    """Return the direction from a hinge to where its joint opens, by the normal of the held face and the sense."""
    return (-sense * normal[1] + 0.0, sense * normal[0] + 0.0)


def _eccentricity_warnings(mechanism: Mechanism) -> Iterator[Message]:
    """Warn of contacts that are not symmetric about the plane of motion."""
    for chain, mark in ((mechanism.positive, ""), (mechanism.negative, "'")):
        if chain is None:
            continue
        forces = FlexibleChain(chain, mechanism.name).solve_joints(np.zeros(1)).normal_force[:, 0]
        for hinge_name, joint, force in zip(hinge_names(chain), chain.joints, forces, strict=True):
            if joint is None:
                continue
            found = contact(joint.section, joint.law, normal_force=float(force), rotation=[0.0, TURNED])
            warned = out_of_plane_warning(joint.section, found, interface=f"{hinge_name}{mark}")
            if warned is not None:
                yield warned


ON_MIDDLE = 1e-3  # of the depth of a joint: a load this near its middle acts through it unless the load says otherwise


def _move_loads_to_joint(chain: Chain, joint: Joint | None, through: Mapping[str, Through]) -> Chain:
    """Move the loads that act through the joint at the top of a wall to its hinge.

    On a joint their resultant is still in the middle at rest, and moves to the edge as the wall rotates; on a rigid
    top they press at the hinge of each direction.

    Parameters
    ----------
    chain : of the wall
    joint : at its top, None if rigid
    through : what each load says, by its name
    """
    if len(chain.blocks) != 2:
        return chain
    loads = [
        replace(load, at=chain.hinges[2]) if _acts_through_joint(load, chain, joint, through.get(load.name)) else load
        for load in chain.loads
    ]
    return replace(chain, loads=tuple(loads))


def _acts_through_joint(load: Load, chain: Chain, joint: Joint | None, through: Through) -> bool:
    """Return whether a load acts through the joint at the top: as it says, else if it is on the middle."""
    if through is not None:
        return through == "joint"
    if joint is None or load.block != UPPER:
        return False
    inside = joint.section.centroid
    middle = tuple(at + inside * way for at, way in zip(chain.hinges[2], joint.inward, strict=True))
    return dist(load.at, middle) <= ON_MIDDLE * joint.section.depth


def _joints_under_loads(
    chain: Chain, joints: tuple[Joint | None, ...], through: Mapping[str, Through]
) -> tuple[Joint | None, ...]:
    """Return the joints of a chain, without the one at the top of a wall if all loads at its hinge are fixed there.

    Parameters
    ----------
    chain : of the wall
    joints : under its hinges
    through : what each load says, by its name
    """
    if len(chain.blocks) != 2:
        return joints
    at_hinge = top_loads(chain)
    fixed = bool(at_hinge) and all(through.get(load.name) == "fixed" for load in at_hinge)
    return (*joints[:2], None) if fixed else joints


def _through_of(loads: Sequence[LoadDefinition]) -> dict[str, Through]:
    """Return how each overburden presses on its wall, by the name of its force."""
    entries = enumerate(loads, start=1)
    return {overburden_name(number): load.through for number, load in entries if isinstance(load, OverburdenLoad)}
