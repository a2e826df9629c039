"""The faces at the hinges of a mechanism: which way they look, and the friction of the materials that meet there."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from assess.errors import GeometryError
from assess.geometry.piece import Piece
from assess.mechanisms.chain import Chain
from assess.mechanisms.face import Face
from assess.mechanisms.joint import PAIRS
from assess.mechanisms.jointed_chain import JointedChain
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Term, message
from assess.model.body import Bodies, Material
from assess.model.definitions import Chained
from assess.model.joint_planes import DOWN, UP, Vector, View, normal_at

STEEP = 0.5  # vertical part of a unit normal: of a face 60 degrees off level


def faces_of(
    mechanism: Mechanism, definition: Chained, pieces: Sequence[Piece], bodies: Bodies
) -> tuple[tuple[Face, ...], ...]:
    """Return the faces at the hinges of the positive and of the negative branch, each in its own sign."""
    frictions = [friction_at(number, definition, bodies) for number in range(len(mechanism.positive.hinges))]
    chains = [chain for chain in (mechanism.positive, mechanism.negative) if chain is not None]
    return tuple(
        tuple(
            Face(
                *normal_of(number, chain, definition, pieces, View.of(definition.towards, sign=sign)),
                *frictions[number],
            )
            for number in range(len(chain.hinges))
        )
        for chain, sign in zip(chains, (1.0, -1.0), strict=False)
    )


def normal_of(
    number: int, chain: Chain, definition: Chained, pieces: Sequence[Piece], view: View
) -> tuple[Vector, bool]:
    """Return the normal at a hinge, to the pressing block, and whether the geometry shows it; otherwise it is vertical.

    What a block stands on is not part of the geometry: a face steeper than STEEP is no bed, as the intrados of a vault.
    """
    ground = PAIRS[len(chain.blocks)][number][0] is None
    if chain.joints and chain.joints[number] is not None:
        normal = complex(JointedChain(chain, "").normal[number])
        return (normal.real, normal.imag), True
    upright = DOWN if len(chain.blocks) == number == 2 else UP
    try:
        found = normal_at(number, chain.hinges[number], definition, pieces, view, where="")
    except GeometryError:
        return upright, False
    return (upright, False) if ground and found[1] * upright[1] < STEEP else (found, True)


def friction_at(number: int, definition: Chained, bodies: Bodies) -> tuple[float | None, Term | Message]:
    """Return the least friction of the blocks that meet at a hinge, None if one has none, with the remedy."""
    least: float | None = None
    for block in PAIRS[definition.moving][number]:
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


def materials_of(block: Sequence[str], bodies: Bodies) -> Iterator[Material]:
    """Return the materials of the bodies of a block that have geometry."""
    for name in block:
        material = bodies[name].material
        if material is not None:
            yield material
