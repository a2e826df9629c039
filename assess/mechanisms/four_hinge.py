"""Three blocks between two fixed hinges: portal, frame, arch, side-aisle vault, belfry (thesis 3.2.4)."""

from __future__ import annotations

from collections.abc import Sequence

from assess.errors import MechanismError
from assess.geometry.planar import PlanarBody
from assess.loads.load import Load, Point
from assess.mechanisms.assembly import assemble, loose_hinges
from assess.mechanisms.chain import Chain, RigidBlock, mirror_chain
from assess.mechanisms.mechanism import Mechanism, Sides
from assess.mechanisms.restitution import RestitutionChoice
from assess.messages.message import Message

Hinges = tuple[Point, Point, Point, Point]


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
        "four-hinge",
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


MOST_VOUSSOIRS = 80  # of an arch: all choices of four of its joints are looked at, which takes seconds
