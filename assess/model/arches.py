"""Arches whose hinges are looked for: a body cut at its joints into voussoirs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np

from assess.errors import GeometryError, MechanismError
from assess.geometry.cut import Division, Plane, divide
from assess.geometry.piece import Piece
from assess.geometry.planar import PlanarBody, planar_body
from assess.geometry.solid import Solid
from assess.mechanisms.arch import ArchHinges, Joint, block_of, divide_arch, weakest_hinges
from assess.mechanisms.assembly import assemble
from assess.mechanisms.chain import Chain, Point, format_point, mirror_chain, mirror_point
from assess.mechanisms.mechanism import Mechanism, Sides
from assess.messages.message import Message, Quantity, Value, lengths, message, note, warning, whole_number
from assess.model.definitions import FourHinge, RadialJoints
from assess.model.pieces import as_one
from spectra.arrays import FloatArray

Line = tuple[Point, Point]

APART = 1e-6  # of the longest joint: points this near are one
BEYOND = 0.1  # of the arch: more than this beyond its end joints gets a warning
SKEW = 0.35  # rad: a joint farther off square to the arch gets a warning


def arch_mechanism(
    name: str, definition: FourHinge, piece: Piece, *, sides: Sides, **common: Any
) -> tuple[Mechanism, list[Piece]]:
    """Build the four-hinge mechanism of an arch that opens at the joints where it resists least, in each direction.

    For negative rotation hinge A is at the far springing, so that both directions of a symmetric arch are alike. The
    outlines, and the pieces beside the mechanism, are the voussoirs: each direction joins others of them to blocks.

    Raises MechanismError or GeometryError where a joint misses the body, or no four joints make a mechanism.
    """
    pieces, joints = voussoirs_of(piece, lines_of(definition), definition.towards, where=f'mechanism "{name}"')
    warnings = tuple(joint_warnings(pieces, joints))
    try:
        made = arch_at_weakest_hinges(name, [each.body for each in pieces], joints, sides=sides, **common)
    except MechanismError as error:
        start = f'mechanism "{name}": '
        raise MechanismError(start + "; ".join((*map(str, warnings), str(error).removeprefix(start)))) from None
    return replace(made, warnings=(*warnings, *made.warnings)), pieces


def arch_at_weakest_hinges(
    name: str, voussoirs: Sequence[PlanarBody], joints: Sequence[Joint], *, sides: Sides, **common: Any
) -> Mechanism:
    """Build the mechanism of an arch of voussoirs that opens at its weakest joints, in each direction."""
    plain = [block_of(body) for body in voussoirs]
    front = weakest_hinges(plain, joints, name=name)
    _, positive = divide_arch(voussoirs, front)
    negative, warnings = None, [hinges_message("hinges-found-positive", front, len(joints), flip=False)]
    if sides == "two":
        turned = [replace(block, centroid=mirror_point(block.centroid)) for block in plain[::-1]]
        back = weakest_hinges(turned, [(mirror_point(a), mirror_point(b)) for a, b in joints[::-1]], name=name)
        a, b, c, d = (mirror_point(hinge) for hinge in back.hinges)
        negative = mirror_chain_back(divide_arch(voussoirs[::-1], replace(back, hinges=(a, b, c, d)))[1])
        warnings.append(hinges_message("hinges-found-negative", back, len(joints), flip=True))
    outlines = tuple(body.outline for body in voussoirs)
    return assemble(name, "four-hinge", positive, negative, outlines=outlines, warnings=warnings, **common)


def joint_warnings(pieces: Sequence[Piece], joints: Sequence[Joint]) -> Iterator[Message]:
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


def mirror_chain_back(chain: Chain) -> Chain:
    """Return a chain from the far springing in the sign of the negative branch, its parts in order from the near."""
    parts = tuple((replace(part, centroid=mirror_point(part.centroid)), number) for part, number in chain.parts[::-1])
    return replace(mirror_chain(chain.blocks, chain.hinges), parts=parts)


def hinges_message(key: str, found: ArchHinges, joints: int, *, flip: bool) -> Message:
    """Say which hinges were found, in the axes of the project."""
    places: dict[str, Value] = {}
    for letter, at in zip("abcd", found.hinges, strict=True):
        x, z = mirror_point(at) if flip else at
        places |= lengths(**{f"{letter}x": x, f"{letter}z": z})
    number, multiplier = whole_number(joints), Quantity(found.multiplier)
    return note(key, joints=number, multiplier=multiplier, hinges=message("four-hinges", places))


def lines_of(definition: FourHinge) -> list[Line]:
    """Return the joints in the plane of motion, from one springing to the other."""
    joints = definition.joints
    if not isinstance(joints, RadialJoints):
        return list(joints or ())
    x, z = joints.centre
    angles = np.linspace(max(joints.first, joints.last), min(joints.first, joints.last), joints.count + 1)
    return [((x, z), (x + float(np.cos(angle)), z + float(np.sin(angle)))) for angle in angles]


def voussoirs_of(
    piece: Piece, lines: Sequence[Line], direction: Sequence[float], *, where: str
) -> tuple[list[Piece], list[Joint]]:
    """Cut the body at its joints into voussoirs, and find the ends of each joint at its faces.

    The ends of the first joint are those of the first voussoir: the sheet through it may touch the far springing too.
    """
    if not piece.solids:
        raise GeometryError(f"{where}: its body has no geometry to open at joints; give it a mesh, box or profile")
    require_apart(lines, where=where)
    along = np.append(np.array(direction[:2]) / np.linalg.norm(direction), 0.0)
    normals = ahead(lines)
    near = side(piece.solids, lines[0], normals[0], along, where=f"{where}: joint 1")
    rest, joints, pieces = near.above, [], []
    for number, (line, normal) in enumerate(zip(lines[1:], normals[1:], strict=True), start=2):
        if not rest:
            raise GeometryError(
                f"{where}: joint {number} lies beyond the end of the body; remove it or mend the joints"
            )
        parts = side(rest, line, -normal, along, where=f"{where}: joint {number}")
        pieces.append(Piece(voussoir_body(parts.above, direction, number - 1), parts.above, None))
        joints.append(ends_of(parts.foot, line, along))
        rest = parts.below
    springing = side(pieces[0].solids, lines[0], normals[0], along, where=f"{where}: joint 1").foot
    pieces[-1] = replace(pieces[-1], fixed=(*piece.fixed, *near.below, *rest))
    return pieces, [ends_of(springing, lines[0], along), *joints]


def require_apart(lines: Sequence[Line], *, where: str) -> None:
    """Raise GeometryError for a joint without length, or two of them in one place."""
    middles = [np.add(a, b) / 2.0 for a, b in lines]
    size = max(float(np.hypot(*np.subtract(b, a))) for a, b in lines)
    for number, (a, b) in enumerate(lines, start=1):
        if np.hypot(*np.subtract(b, a)) <= APART * size:
            raise GeometryError(
                f"{where}: joint {number} begins and ends at {format_point(a)}; give two points of its line"
            )
    for number, (one, other) in enumerate(pairwise(middles), start=1):
        if np.hypot(*(other - one)) <= APART * size:
            raise GeometryError(
                f"{where}: joints {number} and {number + 1} have one middle, {format_point(tuple(one))}; move one"
            )


def side(solids: Sequence[Solid], line: Line, normal: FloatArray, along: FloatArray, *, where: str) -> Division:
    """Divide solids by the upright sheet through a line of the plane of motion."""
    point = line[0][0] * along + np.array([0.0, 0.0, line[0][1]])
    return divide(solids, Plane(point, normal[0] * along + np.array([0.0, 0.0, normal[1]])), where=where)


def ends_of(foot: FloatArray, line: Line, along: FloatArray) -> Joint:
    """Find the two ends of a joint, the first where its line begins, so that first ends lie on one face."""
    points = np.column_stack([foot @ along, foot[:, 2]])
    way = np.subtract(line[1], line[0])
    reach = points @ way
    first, last = points[reach.argmin()], points[reach.argmax()]
    return (float(first[0]), float(first[1])), (float(last[0]), float(last[1]))


def ahead(lines: Sequence[Line]) -> list[FloatArray]:
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


def voussoir_body(solids: Sequence[Solid], direction: Sequence[float], number: int) -> PlanarBody:
    """Return the body between two joints."""
    return replace(as_one([planar_body(solid, direction=direction) for solid in solids]), name=f"voussoir {number}")
