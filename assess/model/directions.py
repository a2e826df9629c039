"""Mechanisms whose direction is sought on a whole circle: `direction = "sweep"`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np

from assess.errors import AssessError, MechanismError
from assess.geometry.cut import divide
from assess.geometry.footprint import edge_normals
from assess.geometry.piece import Piece
from assess.geometry.planar import base_of_section, lowest_corners, planar_body_without_outline
from assess.geometry.solid import Solid
from assess.loads.body_loads import BlockContact, Surroundings, find_block_contact
from assess.loads.definitions import BodyLoad
from assess.mechanisms.directions import Directions, Vector, towards
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.table import branch
from assess.messages.message import Message, warning
from assess.model.assembly import Built, mechanism_of, of_one_block
from assess.model.body import Bodies
from assess.model.definitions import BlockMechanism, Chained, CutAngle, SingleBlock
from assess.model.loading import loads_of
from assess.model.pieces import ASKEW, LEVEL, as_one, cut_of
from assess.oscillator import multiplier
from spectra.arrays import FloatArray

S = TypeVar("S", bound=Chained)

STEP = 5.0  # deg between directions, besides those that the edges of the base face
BESIDE = 0.01  # deg: of the normal of an edge that rises
SAME = 1e-6  # deg: directions this near are one
TIE = 1e-9  # multipliers this near the least are as weak


def sweep_directions(name: str, definition: BlockMechanism, bodies: Bodies) -> Built:
    """Build the mechanism in the weakest of directions all around."""
    standing = solids_of_blocks(name, definition, bodies)
    corner: tuple[Message, ...] = ()
    if isinstance(definition, SingleBlock) and not isinstance(definition.cut, CutAngle):
        block = block_above_cut(name, definition, standing)
        found = directions(block_by_direction(name, definition, block, bodies), angles(normals_of(block.foot)))
        corner = (warning("turns-about-corner"),) if has_slope(block.foot) else ()
    else:  # the crack turns with the direction, and with it the blocks
        plan = np.concatenate([solid.vertices for solid in standing])
        found = directions(
            lambda way: mechanism_of(name, turn_towards(definition, way), bodies).mechanism,
            angles(edge_normals(plan)),
        )
    built = mechanism_of(name, turn_towards(definition, towards(found.weakest)), bodies)
    kept = (each for each in built.mechanism.warnings if each.key != ASKEW)  # every direction has been looked at
    return replace(built, mechanism=replace(built.mechanism, directions=found, warnings=(*kept, *corner)))


def solids_of_blocks(name: str, definition: Chained, bodies: Bodies) -> tuple[Solid, ...]:
    """Return the solids of all blocks; raise MechanismError for a body without geometry, which has one plane only."""
    found = []
    for body in (body for block in definition.blocks for body in block):
        solid = bodies[body].solid
        if solid is None:
            raise MechanismError(
                f'mechanism "{name}": direction = "sweep", but body "{body}" has no geometry; give it a mesh, box or '
                "profile, or give the direction"
            )
        found.append(solid)
    return tuple(found)


def angles(normals: FloatArray) -> tuple[float, ...]:
    """Return the directions [deg] to evaluate: even steps, and the normals [k] of the edges of the base.

    Where the multiplier of a block has a minimum, the hinge passes from one corner to the next: over an edge, or
    in every direction of a round base.
    """
    even = np.arange(0.0, 360.0, STEP)
    apart = np.abs((normals[:, None] - even[None, :] + 180.0) % 360.0 - 180.0).min(axis=1, initial=360.0) > SAME
    return tuple(np.sort(np.concatenate([even, normals[apart]])).tolist())


def has_slope(foot: FloatArray) -> bool:
    """Return whether the corners [k, 3] of a base lie at different elevations."""
    return float(np.ptp(foot[:, 2])) > LEVEL


def normals_of(foot: FloatArray) -> FloatArray:
    """Return the normals of the edges between corners [k, 3] [deg]; on a slope also just beside.

    There the lower end has the larger height to the centroid over it, and so the least multiplier.
    """
    normals = edge_normals(foot)
    beside = [normals + turn for turn in (-BESIDE, 0.0, BESIDE)]
    return np.unique(np.concatenate(beside) % 360.0) if has_slope(foot) else normals


@dataclass(frozen=True)
class Standing:
    """A block above its cut, before a direction is chosen.

    solids : what it is made of; foot : corners it stands on [k, 3] [m]; fixed : what lies below the cut and stays
    """

    solids: tuple[Solid, ...]
    foot: FloatArray
    fixed: tuple[Solid, ...] = ()


def block_above_cut(name: str, definition: SingleBlock, solids: tuple[Solid, ...]) -> Standing:
    """Return the block above its cut, which is the same in every direction."""
    plane = cut_of(definition, where=f'mechanism "{name}"')
    if plane is None:
        return Standing(solids, lowest_corners(solids))
    parts = divide(solids, plane, where=f'mechanism "{name}"')
    return Standing(parts.above, parts.foot, parts.below)


def block_by_direction(
    name: str, definition: SingleBlock, standing: Standing, bodies: Bodies
) -> Callable[[Vector], Mechanism]:
    """Return a function of the direction that builds the single block; it is cut once and its loads are found once."""
    known: dict[str, BlockContact] = {}

    def find(load: BodyLoad, body: Solid | None, around: Surroundings) -> BlockContact:
        if load.body not in known:
            known[load.body] = find_block_contact(load, body, around)
        return known[load.body]

    def block(direction: Vector) -> Mechanism:
        body = as_one([planar_body_without_outline(solid, direction=direction) for solid in standing.solids])
        body = replace(body, base=base_of_section(standing.foot, direction=direction))
        pieces = [Piece(body, standing.solids, None, fixed=standing.fixed)]
        faced = turn_towards(definition, direction)
        load_set = loads_of(name, faced, pieces, bodies, find=find)
        return of_one_block(name, faced, pieces, bodies, loads=load_set.loads)[0]

    return block


def turn_towards(definition: S, direction: Vector) -> S:
    """Return the definition with a direction."""
    return replace(definition, direction=direction)


def directions(mechanism_towards: Callable[[Vector], Mechanism], around: Sequence[float]) -> Directions:
    """Find the resistance to positive rotation towards each of the angles `around` [n] [deg], rising.

    The smallest angle of the least multiplier is the weakest; opposite angles are the two signs of one plane.

    Raises
    ------
    AssessError : towards one of them it cannot rock as described; the angle is named
    """
    rows = []
    for angle in around:
        try:
            mechanism = mechanism_towards(towards(angle))
            leading = branch(mechanism.positive, restitution=mechanism.restitution[0], name=mechanism.name)
        except AssessError as error:
            raise type(error)(f'{error} (direction = "sweep", here {angle:.6g} deg from +x)') from None
        rows.append((float(multiplier(leading)[0]), leading.linearised.p, leading.overturning))
    multipliers, p, overturning = zip(*rows, strict=True)
    weakest = next(a for a, value in zip(around, multipliers, strict=True) if value <= min(multipliers) + TIE)
    return Directions(tuple(around), multipliers, p, overturning, weakest)
