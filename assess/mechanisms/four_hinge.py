"""Three blocks between two fixed hinges: portal, frame, arch, side-aisle vault, belfry (thesis 3.2.4).

The hinges are given, or looked for: an arch is cut at its joints into voussoirs, and of all mechanisms over these
joints the one with the least uplift multiplier is taken. By the kinematic theorem of limit analysis (no sliding, no
crushing) every admissible mechanism gives at least the multiplier at which the arch starts to move, and the least is
that one.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, islice, pairwise
from typing import Annotated, Any, ClassVar, Literal

import numpy as np

from assess.declaration import Angle, Evidence, Fault, KeyFault, Name, Number, PlanePoint, Several
from assess.errors import GeometryError, MechanismError
from assess.geometry.cut import Division, Piece, Plane, divide
from assess.geometry.planar import PlanarBody, join_bodies, join_planar, planar_body
from assess.geometry.solid import Solid
from assess.loads.load import Load, Place, Point
from assess.mechanisms.assembly import (
    MechanismKind,
    MechanismPieces,
    assemble,
    common_arguments,
    hinges_in_plane,
    loose_hinges,
)
from assess.mechanisms.chain import Chain, RigidBlock, cross, mirror_chain, mirror_point, point_text
from assess.mechanisms.mechanism import DRAWN_HINGES, BlockMechanism, Mechanism, Sides
from assess.mechanisms.restitution import ImpactRules, RestitutionChoice, chain_rebound, conserve_momentum
from assess.messages.message import Message, Quantity, Value, lengths, message, note, warning, whole_number
from spectra.arrays import ComplexArray, FloatArray, IntArray

Line = tuple[PlanePoint, PlanePoint]
Hinges = tuple[Point, Point, Point, Point]
LEAST_VOUSSOIRS = 3
AS_JOINTED = Evidence("drawn", "either", "as drawn")
MOST_VOUSSOIRS = 80  # of an arch: all choices of four of its joints are looked at, which takes seconds


@dataclass(frozen=True, kw_only=True)
class FourHinge(BlockMechanism):
    """Three blocks between two fixed hinges: portal, frame, arch, side-aisle vault, belfry."""

    kind: ClassVar[str] = "four-hinge"
    number_of_blocks: ClassVar[int] = 3
    blocks: Annotated[tuple[tuple[Name, ...], ...], Evidence("defines", "either", "as drawn")]
    """the bodies A-B, B-C and C-D; or one arch, with joints and hinges = "minimum\""""
    hinges: Annotated[tuple[Place, ...] | Literal["minimum"] | None, DRAWN_HINGES] = None
    """hinges A, B, C, D of positive rotation, or "minimum": where the arch resists least"""
    hinges_negative: Annotated[tuple[Place, ...] | None, DRAWN_HINGES] = None
    """hinges A, B, C, D of negative rotation"""
    joints: RadialJoints | Annotated[tuple[Line, ...], Several(most=MOST_VOUSSOIRS + 1), AS_JOINTED] | None = None
    """of an arch, in order: [[[x, z], [x, z]], …], or { centre, first, last, count } for radial ones"""

    def keys_along(self) -> Iterator[tuple[str | int, ...]]:
        """Name what is given in the plane of motion: two numbers of loads and hinges, and the joints of an arch."""
        yield from super().keys_along()
        if self.joints is not None:
            yield ("joints",)

    def faults(self) -> Iterator[KeyFault]:
        """Yield what does not suit three blocks between given hinges, or one arch whose hinges are sought."""
        if self.hinges != "minimum":
            if len(self.blocks) != 3:
                yield "blocks", f"{len(self.blocks)} of them with four hinges; name three, base first"
            if self.hinges_negative is None and self.sides != "one":
                reason = 'missing; two-sided rocking has hinges of its own each way: give them, or sides = "one"'
                yield "hinges_negative", reason
            if self.hinges_negative is not None and self.sides == "one":
                yield "hinges_negative", "beside one-sided rocking; remove it"
            if self.joints is not None:
                yield "joints", 'are for an arch with hinges = "minimum"; remove one of them'
        elif self.hinges_negative is not None:
            yield "hinges_negative", 'are looked for too with hinges = "minimum"; remove them'
        elif len(self.blocks) != 1 or self.joints is None:
            yield "joints", 'hinges = "minimum" needs one arch in blocks, and joints where it may open'
        elif self.loads:
            yield "loads", 'not with hinges = "minimum"; write the hinges that `assess check` prints'
        if isinstance(self.joints, tuple) and not MOST_VOUSSOIRS >= len(self.joints) - 1 >= LEAST_VOUSSOIRS:
            count = len(self.joints) - 1
            yield "joints", f"{count} voussoirs between them; give {LEAST_VOUSSOIRS} to {MOST_VOUSSOIRS}"
        yield from super().faults()


@dataclass(frozen=True)
class RadialJoints:
    """Joints of an arch that all point to its centre, evenly spaced."""

    centre: Annotated[PlanePoint, AS_JOINTED]
    """[distance along the direction, elevation]"""
    first: Annotated[Angle, AS_JOINTED]
    """angle of the first joint above the direction, like "168.75 deg\""""
    last: Annotated[Angle, AS_JOINTED]
    """angle of the last joint, like "11.25 deg\""""
    count: Annotated[int, Number(least=LEAST_VOUSSOIRS, most=MOST_VOUSSOIRS), AS_JOINTED]
    """number of voussoirs between them"""

    def faults(self) -> Iterator[Fault]:
        """Yield a last joint that is the first."""
        if self.first == self.last:
            yield "last", "is the first joint again; give the angle of the other springing"


def four_hinge(
    name: str,
    bodies: Sequence[PlanarBody],
    *,
    hinges: Hinges,
    hinges_negative: Hinges | None = None,
    label: str = "",
    sides: Sides = "two",
    loads: tuple[Load, ...] = (),
    restitution: tuple[RestitutionChoice, RestitutionChoice] = (None, None),
    warnings: tuple[Message, ...] = (),
) -> Mechanism:
    """Make the mechanism of three bodies A-B, B-C and C-D; negative rotation has hinges of its own.

    Parameters
    ----------
    name : of the mechanism
    bodies : three, from A to D
    hinges, hinges_negative : A to D (x, z) of positive and of negative rotation [m]
    label : for reports; empty: the name
    sides : "one" or "two"
    loads : on the blocks
    restitution : of the impacts that end the positive and the negative branch: a number, a rule, or None for the
        default of the kind
    warnings : on what was given

    Raises
    ------
    MechanismError : hinges of negative rotation are missing, or given for one-sided rocking
    """
    if (sides == "two") != (hinges_negative is not None):
        remedy = "give hinges_negative = { A, B, C, D }" if sides == "two" else "remove hinges_negative"
        raise MechanismError(f'mechanism "{name}": sides = "{sides}": {remedy}')
    outlines = tuple(body.outline for body in bodies)
    blocks = tuple(RigidBlock(body.mass, body.centroid, body.inertia) for body in bodies)
    return assemble(
        name,
        FOUR_HINGE,
        Chain(blocks, hinges, loads),
        None if hinges_negative is None else mirror_chain(blocks, hinges_negative, loads),
        label=label,
        restitution=restitution,
        outlines=outlines,
        warnings=(
            *warnings,
            *loose_hinges(hinges, outlines),
            *loose_hinges(hinges_negative or (), outlines, mark="'"),
        ),
    )


@dataclass(frozen=True)
class ArchHinges:
    """A mechanism of an arch: its four joints, their hinges A to D, and its uplift multiplier [-]."""

    joints: tuple[int, int, int, int]
    hinges: tuple[Point, Point, Point, Point]
    multiplier: float


def weakest_hinges(voussoirs: Sequence[RigidBlock], joints: Sequence[Line], *, name: str) -> ArchHinges:
    """Find the four hinges, at alternate faces, that open under the least horizontal acceleration along +x.

    Parameters
    ----------
    voussoirs : from the springing on the left to that on the right
    joints : before, between and after them, each by its two ends (x, z) [m]; first ends on one face, second ends on
        the other
    name : of the mechanism, for errors

    Raises
    ------
    MechanismError : fewer than three voussoirs, no four joints make a mechanism that resists, or the arch does not
        stand under its own weight
    """
    if len(joints) < 4 or len(joints) != len(voussoirs) + 1:
        raise MechanismError(
            f'mechanism "{name}": {len(voussoirs)} voussoirs with {len(joints)} joints; an arch that hinges has at '
            "least three voussoirs and one joint more than voussoirs"
        )
    ends = np.array([[complex(*end) for end in joint] for joint in joints])
    least, face, chosen = min(_least_multiplier(voussoirs, ends, face=face) for face in (0, 1))
    if least == -np.inf:
        falling = ", ".join(str(joint + 1) for joint in chosen)
        raise MechanismError(
            f'mechanism "{name}": already falling: its own weight opens joints {falling}, counted from the first; '
            "the arch is too thin, or its joints are not those it has"
        )
    if least == np.inf:
        raise MechanismError(
            f'mechanism "{name}": no four of its joints make a mechanism that resists; check the joints'
        )
    places = [ends[joint, (face + number) % 2] for number, joint in enumerate(chosen)]
    a, b, c, d = ((float(at.real), float(at.imag)) for at in places)
    first, second, third, last = chosen
    return ArchHinges((first, second, third, last), (a, b, c, d), least)


def divide_arch(voussoirs: Sequence[PlanarBody], hinging: ArchHinges) -> tuple[list[PlanarBody], Chain]:
    """Divide an arch into the three blocks between its hinges; return the blocks and their chain.

    Parameters
    ----------
    voussoirs : from the springing on the left to that on the right
    hinging : the joints that open and their hinges
    """
    spans = list(pairwise(hinging.joints))
    bodies = [join_planar(voussoirs[a:b], name=f"block {n}") for n, (a, b) in enumerate(spans, start=1)]
    numbers = [next((n for n, (a, b) in enumerate(spans) if a <= i < b), None) for i in range(len(voussoirs))]
    parts = tuple((_rigid_block(part), number) for part, number in zip(voussoirs, numbers, strict=True))
    return bodies, Chain(tuple(_rigid_block(body) for body in bodies), hinging.hinges, parts=parts)


def _build_four_hinge(
    name: str,
    definition: FourHinge,
    pieces: Sequence[Piece],
    *,
    loads: tuple[Load, ...],
) -> MechanismPieces:
    """Build three blocks between given hinges, or an arch whose hinges are searched for."""
    if definition.hinges == "minimum":
        return _arch_mechanism(name, definition, pieces[0], **common_arguments(definition))
    mechanism = four_hinge(
        name,
        [piece.body for piece in pieces],
        hinges=hinges_in_plane(definition.hinge_points, definition),
        hinges_negative=hinges_in_plane(definition.hinges_negative, definition),
        loads=loads,
        **common_arguments(definition),
    )
    return mechanism, pieces


FOUR_HINGE = MechanismKind(
    definition=FourHinge,
    build=_build_four_hinge,
    impacts=ImpactRules(
        two_sided={"thesis": conserve_momentum, "momentum": conserve_momentum}, one_sided={"thesis": chain_rebound}
    ),
    support="hinged",
)
"""A four-hinge mechanism is drawn in its plane: its direction is not sought."""
APART = 1e-6  # of the longest joint: points this near are one
BEYOND = 0.1  # of the arch: more than this beyond its end joints gets a warning
SKEW = 0.35  # rad: a joint farther off square to the arch gets a warning
CHOICES_AT_ONCE = 20_000  # choices of four joints evaluated together: 80 voussoirs have 1.7 million


def _arch_mechanism(
    name: str, definition: FourHinge, piece: Piece, *, sides: Sides, **common: Any
) -> tuple[Mechanism, list[Piece]]:
    """Build the four-hinge mechanism of an arch that opens at the joints where it resists least, in each direction.

    For negative rotation hinge A is at the far springing, so that both directions of a symmetric arch are alike. The
    outlines, and the pieces beside the mechanism, are the voussoirs: each direction joins others of them to blocks.

    Raises MechanismError or GeometryError where a joint misses the body, or no four joints make a mechanism.
    """
    pieces, joints = _cut_into_voussoirs(
        piece, _joint_lines(definition), definition.towards, where=f'mechanism "{name}"'
    )
    warnings = tuple(_joint_warnings(pieces, joints))
    try:
        made = _arch_at_weakest_hinges(name, [each.body for each in pieces], joints, sides=sides, **common)
    except MechanismError as error:
        start = f'mechanism "{name}": '
        raise MechanismError(start + "; ".join((*map(str, warnings), str(error).removeprefix(start)))) from None
    return replace(made, warnings=(*warnings, *made.warnings)), pieces


def _arch_at_weakest_hinges(
    name: str, voussoirs: Sequence[PlanarBody], joints: Sequence[Line], *, sides: Sides, **common: Any
) -> Mechanism:
    """Build the mechanism of an arch of voussoirs that opens at its weakest joints, in each direction."""
    plain = [_rigid_block(body) for body in voussoirs]
    front = weakest_hinges(plain, joints, name=name)
    _, positive = divide_arch(voussoirs, front)
    negative, warnings = None, [_hinges_message("hinges-found-positive", front, len(joints), flip=False)]
    if sides == "two":
        turned = [replace(block, centroid=mirror_point(block.centroid)) for block in plain[::-1]]
        back = weakest_hinges(turned, [(mirror_point(a), mirror_point(b)) for a, b in joints[::-1]], name=name)
        a, b, c, d = (mirror_point(hinge) for hinge in back.hinges)
        negative = _mirror_chain_back(divide_arch(voussoirs[::-1], replace(back, hinges=(a, b, c, d)))[1])
        warnings.append(_hinges_message("hinges-found-negative", back, len(joints), flip=True))
    outlines = tuple(body.outline for body in voussoirs)
    return assemble(name, FOUR_HINGE, positive, negative, outlines=outlines, warnings=warnings, **common)


def _joint_warnings(pieces: Sequence[Piece], joints: Sequence[Line]) -> Iterator[Message]:
    """Warn of joints that hardly belong to this arch: much of it lies beyond them, or they are not square to it."""
    left, whole = (
        sum(solid.mass for solid in solids)
        for solids in (pieces[-1].fixed, [s for piece in pieces for s in (*piece.solids, *piece.fixed)])
    )
    if left > BEYOND * whole:
        yield warning("arch-beyond-joints", share=Quantity(100.0 * left / whole, "percent", 3))
    centres = [np.array(piece.body.centroid) for piece in pieces]
    for number, ((a, b), (one, other)) in enumerate(zip(joints[1:-1], pairwise(centres), strict=True), start=2):
        across, along = np.subtract(b, a), other - one
        off = np.arcsin(min(1.0, abs(across @ along) / (np.hypot(*across) * np.hypot(*along))))
        if off > SKEW:
            yield warning("joint-askew", joint=whole_number(number), angle=Quantity(float(off), "angle", 3))
            return


def _mirror_chain_back(chain: Chain) -> Chain:
    """Return a chain from the far springing in the sign of the negative branch, its parts in order from the near."""
    parts = tuple((replace(part, centroid=mirror_point(part.centroid)), number) for part, number in chain.parts[::-1])
    return replace(mirror_chain(chain.blocks, chain.hinges), parts=parts)


def _hinges_message(key: str, found: ArchHinges, joints: int, *, flip: bool) -> Message:
    """Say which hinges were found, in the axes of the project."""
    places: dict[str, Value] = {}
    for letter, at in zip("abcd", found.hinges, strict=True):
        x, z = mirror_point(at) if flip else at
        places |= lengths(**{f"{letter}x": x, f"{letter}z": z})
    number, multiplier = whole_number(joints), Quantity(found.multiplier)
    return note(key, joints=number, multiplier=multiplier, hinges=message("four-hinges", places))


def _joint_lines(definition: FourHinge) -> list[Line]:
    """Return the joints in the plane of motion, from one springing to the other."""
    joints = definition.joints
    if not isinstance(joints, RadialJoints):
        return list(joints or ())
    x, z = joints.centre
    angles = np.linspace(max(joints.first, joints.last), min(joints.first, joints.last), joints.count + 1)
    return [((x, z), (x + float(np.cos(angle)), z + float(np.sin(angle)))) for angle in angles]


def _cut_into_voussoirs(
    piece: Piece, lines: Sequence[Line], direction: Sequence[float], *, where: str
) -> tuple[list[Piece], list[Line]]:
    """Cut the body at its joints into voussoirs, and find the ends of each joint at its faces.

    The ends of the first joint are those of the first voussoir: the sheet through it may touch the far springing too.
    """
    if not piece.solids:
        raise GeometryError(f"{where}: its body has no geometry to open at joints; give it a mesh, box or profile")
    _require_joints_apart(lines, where=where)
    along = np.append(np.array(direction[:2]) / np.linalg.norm(direction), 0.0)
    normals = _joint_normals(lines)
    near = _divide_at_joint(piece.solids, lines[0], normals[0], along, where=f"{where}: joint 1")
    rest, joints, pieces = near.above, [], []
    for number, (line, normal) in enumerate(zip(lines[1:], normals[1:], strict=True), start=2):
        if not rest:
            raise GeometryError(
                f"{where}: joint {number} lies beyond the end of the body; remove it or mend the joints"
            )
        parts = _divide_at_joint(rest, line, -normal, along, where=f"{where}: joint {number}")
        pieces.append(Piece(_voussoir_body(parts.above, direction, number - 1), parts.above, None))
        joints.append(_joint_ends(parts.foot, line, along))
        rest = parts.below
    springing = _divide_at_joint(pieces[0].solids, lines[0], normals[0], along, where=f"{where}: joint 1").foot
    pieces[-1] = replace(pieces[-1], fixed=(*piece.fixed, *near.below, *rest))
    return pieces, [_joint_ends(springing, lines[0], along), *joints]


def _require_joints_apart(lines: Sequence[Line], *, where: str) -> None:
    """Raise GeometryError for a joint without length, or two of them in one place."""
    middles = [np.add(a, b) / 2.0 for a, b in lines]
    size = max(float(np.hypot(*np.subtract(b, a))) for a, b in lines)
    for number, (a, b) in enumerate(lines, start=1):
        if np.hypot(*np.subtract(b, a)) <= APART * size:
            raise GeometryError(
                f"{where}: joint {number} begins and ends at {point_text(a)}; give two points of its line"
            )
    for number, (one, other) in enumerate(pairwise(middles), start=1):
        if np.hypot(*(other - one)) <= APART * size:
            raise GeometryError(
                f"{where}: joints {number} and {number + 1} have one middle, {point_text(tuple(one))}; move one"
            )


def _divide_at_joint(
    solids: Sequence[Solid], line: Line, normal: FloatArray, along: FloatArray, *, where: str
) -> Division:
    """Divide solids by the upright sheet through a line of the plane of motion."""
    point = line[0][0] * along + np.array([0.0, 0.0, line[0][1]])
    return divide(solids, Plane(point, normal[0] * along + np.array([0.0, 0.0, normal[1]])), where=where)


def _joint_ends(foot: FloatArray, line: Line, along: FloatArray) -> Line:
    """Find the two ends of a joint, the first where its line begins, so that first ends lie on one face."""
    points = np.column_stack([foot @ along, foot[:, 2]])
    way = np.subtract(line[1], line[0])
    reach = points @ way
    first, last = points[reach.argmin()], points[reach.argmax()]
    return (float(first[0]), float(first[1])), (float(last[0]), float(last[1]))


def _joint_normals(lines: Sequence[Line]) -> list[FloatArray]:
    """Return the unit normal of each joint towards the next; of the last joint, away from the one before."""
    middles = [np.add(a, b) / 2.0 for a, b in lines]
    normals = []
    for number, (a, b) in enumerate(lines):
        way = np.subtract(b, a)
        normal = np.array([way[1], -way[0]]) / np.hypot(*way)
        last = number + 1 == len(lines)
        onward = middles[number] - middles[number - 1] if last else middles[number + 1] - middles[number]
        normals.append(normal if normal @ onward > 0.0 else -normal)
    return normals


def _voussoir_body(solids: Sequence[Solid], direction: Sequence[float], number: int) -> PlanarBody:
    """Return the body between two joints."""
    return replace(
        join_bodies([planar_body(solid, direction=direction) for solid in solids]), name=f"voussoir {number}"
    )


def _rigid_block(body: PlanarBody) -> RigidBlock:
    """Return the mass, centroid and inertia of a body."""
    return RigidBlock(body.mass, body.centroid, body.inertia)


def _least_multiplier(
    voussoirs: Sequence[RigidBlock], ends: ComplexArray, *, face: int
) -> tuple[float, int, tuple[int, ...]]:
    """Return the least multiplier with the first hinge on `face`, that face, and the first four joints that have it."""
    least, found = np.inf, tuple(range(4))
    choices = combinations(range(len(ends)), 4)
    while len(chosen := np.array(list(islice(choices, CHOICES_AT_ONCE)))):
        values = _multipliers(voussoirs, ends, chosen, face=face)
        best = int(values.argmin())
        if values[best] < least:
            least, found = float(values[best]), tuple(chosen[best].tolist())
    return least, face, found


def _multipliers(voussoirs: Sequence[RigidBlock], ends: ComplexArray, chosen: IntArray, *, face: int) -> FloatArray:
    """Return the uplift multiplier of each choice of four joints [k, 4], the first hinge on `face`.

    inf if it cannot move that way, or is not driven by a push along +x; -inf if it falls under its own weight.
    """
    hinges = np.stack([ends[chosen[:, n], (face + n) % 2] for n in range(4)], axis=1)
    others = np.stack([ends[chosen[:, n], (face + n + 1) % 2] for n in range(4)], axis=1)
    arms = np.diff(hinges, axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        second = -cross(arms[:, 0], arms[:, 2]) / cross(arms[:, 1], arms[:, 2])
        third = -cross(arms[:, 1], arms[:, 0]) / cross(arms[:, 1], arms[:, 2])
    turning = np.stack([np.ones(len(chosen)), second, third], axis=1)
    mass, moment = _block_sums(voussoirs, chosen)
    at_start = np.concatenate([np.zeros((len(chosen), 1)), np.cumsum(-1j * arms * turning, axis=1)], axis=1)[:, :3]
    momentum = mass * at_start - 1j * turning * (moment - mass * hinges[:, :3])
    work = momentum.sum(axis=1)
    still = np.zeros((len(chosen), 1))
    relative = np.diff(np.concatenate([still, turning, still], axis=1), axis=1)
    opening = -1j * relative * (others - hinges)
    ahead = _vectors_across(voussoirs, ends)[chosen]
    opens = np.all((opening * np.conj(ahead)).real > 0.0, axis=1) & np.isfinite(work)
    admissible = opens & (work.real > 0.0)
    values = np.full(len(chosen), np.inf)
    values[admissible] = work.imag[admissible] / work.real[admissible]
    values[opens & (work.imag <= 0.0)] = -np.inf
    return values


def _block_sums(voussoirs: Sequence[RigidBlock], chosen: IntArray) -> tuple[FloatArray, ComplexArray]:
    """Return mass and first moment (x + iz) of the three blocks between the joints of each choice [k, 3]."""
    mass = np.concatenate([[0.0], np.cumsum([part.mass for part in voussoirs])])
    moment = np.concatenate([[0.0], np.cumsum([part.mass * complex(*part.centroid) for part in voussoirs])])
    return np.diff(mass[chosen], axis=1), np.diff(moment[chosen], axis=1)


def _vectors_across(voussoirs: Sequence[RigidBlock], ends: ComplexArray) -> ComplexArray:
    """Return a vector across each joint from the voussoir before it to the one after [joints]."""
    centres = np.array([complex(*part.centroid) for part in voussoirs])
    middles = ends.mean(axis=1)
    before = np.concatenate([[2 * middles[0] - centres[0]], centres])
    after = np.concatenate([centres, [2 * middles[-1] - centres[-1]]])
    return np.asarray(after - before)
