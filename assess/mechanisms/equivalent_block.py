"""A single block defined by its rocking parameters alone, so that published tables can be assessed too."""

from __future__ import annotations

from math import cos, sin

from scipy.constants import g

from assess.loads.load import Point
from assess.mechanisms.assembly import assemble
from assess.mechanisms.chain import Chain, RigidBlock
from assess.mechanisms.mechanism import Mechanism, Sides
from assess.mechanisms.restitution import RestitutionChoice
from assess.messages.message import Quantity, warning


def equivalent_block(
    name: str,
    *,
    p: float,
    uplift: float,
    radius: float,
    mass: float = 1.0,
    label: str = "",
    sides: Sides = "two",
    elevation: float = 0.0,
    restitution: tuple[RestitutionChoice, RestitutionChoice] = (None, None),
) -> Mechanism:
    """Make a single block from its rocking parameters.

    Its inertia about the hinge is M g R / p^2. It is symmetric, with its base centred on the origin, and drawn as the
    rectangle with the same slenderness and radius.

    Parameters
    ----------
    name : of the mechanism
    p : frequency parameter [1/s]
    uplift : slenderness [rad]
    radius : from hinge to centroid [m]
    mass : [kg]
    label : for reports; empty: the name
    sides : "one" or "two"
    elevation : of the base [m]
    restitution : of the impacts that end the positive and the negative branch: a number, a rule, or None for the
        default of the kind
    """
    half, height = radius * sin(uplift), radius * cos(uplift)
    block = RigidBlock(mass, (0.0, elevation + height), mass * g * radius / p**2 - mass * radius**2)
    chain = Chain((block,), ((half, elevation),))
    top = elevation + 2 * height
    k = g / (p**2 * radius)
    impossible = warning("no-such-body", ratio=Quantity(k, figures=3))
    outline: tuple[Point, ...] = ((-half, elevation), (half, elevation), (half, top), (-half, top))
    return assemble(
        name,
        "equivalent-block",
        chain,
        chain if sides == "two" else None,
        label=label,
        restitution=restitution,
        outlines=((outline,),),
        warnings=(impossible,) if k < 1.0 else (),
    )


INERTIA_RATIOS = (1e-4, 1e4)  # I_O / (M R^2) = g / (p^2 R): 4/3 of a slender block, less of a wall that spans
