"""A chain of one block at rest, as the plain block that formulas of the field are written for."""

from __future__ import annotations

from math import atan2, hypot

from assess.loads.load import PointMass
from assess.mechanisms.chain import Chain
from assess.oscillator import SingleBlock


def plain_block(chain: Chain) -> SingleBlock:
    """Return mass, radius, slenderness and hinge inertia of a chain of one block with its bearing masses.

    These enter 3.44 and 3.45; non-bearing masses and applied forces are ignored.
    """
    (block,), (hinge,) = chain.blocks, chain.hinges
    carried = [load for load in chain.loads if isinstance(load, PointMass) and load.bearing]
    points = [(block.mass, block.centroid), *((load.mass, load.at) for load in carried)]
    arms = [(mass, hinge[0] - at[0], at[1] - hinge[1]) for mass, at in points]
    total = sum(mass for mass, _, _ in arms)
    behind, height = (sum(arm[0] * arm[i] for arm in arms) / total for i in (1, 2))
    about_hinge = block.inertia + sum(mass * (b**2 + h**2) for mass, b, h in arms)
    return SingleBlock(total, hypot(behind, height), atan2(behind, height), about_hinge)
