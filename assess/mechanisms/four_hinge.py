"""Three blocks between two fixed hinges: portal, frame, arch, side-aisle vault, belfry (thesis 3.2.4)."""

from __future__ import annotations

from collections.abc import Sequence

from assess.errors import MechanismError
from assess.geometry.planar import PlanarBody
from assess.loads.load import Load
from assess.mechanisms.assembly import assemble
from assess.mechanisms.chain import Block, Chain, Point, mirror_chain
from assess.mechanisms.impact import RestitutionChoice
from assess.mechanisms.mechanism import Mechanism, Sides
from assess.mechanisms.warnings import loose_hinges

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
    notices: tuple[str, ...] = (),
) -> Mechanism:
    """The mechanism of three bodies A-B, B-C and C-D, and for negative rotation about hinges of its own.

    Raises MechanismError where hinges of negative rotation are missing, or given for one-sided rocking.
    """
    if (sides == "two") != (hinges_negative is not None):
        remedy = "give hinges_negative = { A, B, C, D }" if sides == "two" else "remove hinges_negative"
        raise MechanismError(f'mechanism "{name}": sides = "{sides}": {remedy}')
    outlines = tuple(body.outline for body in bodies)
    blocks = tuple(Block(body.mass, body.centroid, body.inertia) for body in bodies)
    return assemble(
        name,
        "four-hinge",
        Chain(blocks, hinges, loads),
        None if hinges_negative is None else mirror_chain(blocks, hinges_negative, loads),
        label=label,
        restitution=restitution,
        outlines=outlines,
        notices=(
            *notices,
            *loose_hinges(hinges, outlines),
            *loose_hinges(hinges_negative or (), outlines, mark="'"),
        ),
    )
