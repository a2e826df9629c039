"""The weakest crack of a block that is known: elevation and inclination of the cut at which it starts to rock first."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import inf

import numpy as np

from assess.errors import AssessError, MechanismError
from assess.mechanisms.chain import Chain, uplift_multiplier
from assess.mechanisms.least import find_least
from assess.mechanisms.mechanism import CutAngle
from assess.mechanisms.single_block import SingleBlock
from assess.model.assembly import on_rigid_hinges
from assess.model.bodies import Bodies
from assess.model.directions import edge_towards
from assess.model.least_multipliers import STEEP

STATIONS, HALVINGS = (6, 6), 5  # of the search: elevations and angles on its grid, halvings of their distance
TOP = 0.98  # of the height of the bodies: the highest crack
AT_END = 0.01  # of a range: a crack nearer to its end is there
TIE, APART = 1e-3, 0.05  # of the multiplier, of the heights: cracks as weak that lie apart
SLIVER = 0.02  # of the mass: less is hardly a part, and is left out


@dataclass(frozen=True)
class WeakestCrack:
    """The crack of least multiplier.

    cut : the crack, by a point ahead of the block and the angle at which it falls towards the direction
    multiplier : with rigid joints [-]
    share : of the mass of the bodies that moves above it [-]
    ends : of which ranges it is at an end, such as "the top": a weaker one may lie beyond
    tied : least and greatest elevation [m] of cracks that were tried and are as weak within `TIE`; None where they lie
        within `APART` of the heights
    """

    cut: CutAngle
    multiplier: float
    share: float
    ends: tuple[str, ...]
    tied: tuple[float, float] | None = None


def find_weakest_crack(
    name: str, definition: SingleBlock, bodies: Bodies, *, progress: Callable[[int], object] = bool
) -> WeakestCrack:
    """Find the crack of least uplift multiplier of a block in its direction, with its loads, on rigid joints.

    The crack begins ahead of the block, at any elevation from its foot to near its top, and falls towards the direction
    by 0 to 75 degrees. One at which the part above would fall at rest is left out, as the building stands, and one that
    cuts off less than 2 % of its mass.

    Parameters
    ----------
    name : of the mechanism
    definition : with a direction
    bodies : of the building, by name
    progress : called with the number of cracks that have been tried

    Raises
    ------
    MechanismError : no crack parts it
    """
    solids = [solid for each in definition.bodies if (solid := bodies[each].solid) is not None]
    if not solids:
        raise MechanismError(f'mechanism "{name}": no geometry to be cracked; give its bodies a mesh, box or profile')
    corners = np.concatenate([each.vertices for each in solids])
    low, high = float(corners[:, 2].min()), float(corners[:, 2].max())
    x, y, _ = edge_towards(definition.towards, corners)
    whole, tried = sum(each.mass for each in solids), 0
    known: list[tuple[float, float]] = []

    def chain_of(at: tuple[float, ...]) -> Chain:
        cracked = replace(definition, cut=CutAngle((x, y, at[0]), at[1]))
        return on_rigid_hinges(name, cracked, bodies)[0].positive

    def share_of(chain: Chain) -> float:
        return sum(each.mass for each in chain.blocks) / whole

    def multiplier(at: tuple[float, ...]) -> float:
        nonlocal tried
        tried += 1
        progress(tried)
        try:
            chain = chain_of(at)
            found = uplift_multiplier(chain)
        except AssessError:
            return inf
        if found <= 0.0 or share_of(chain) < SLIVER:
            return inf
        known.append((found, at[0]))
        return found

    ranges = {"the foot": (low, 0), "the top": (low + TOP * (high - low), 0), "the steepest angle": (STEEP, 1)}
    bounds = ((low, ranges["the top"][0]), (0.0, STEEP))
    least = find_least(multiplier, bounds=bounds, stations=STATIONS, starts=2, halvings=HALVINGS)
    if least.value == inf:
        raise MechanismError(f'mechanism "{name}": no crack parts it')
    share = share_of(chain_of(least.at))
    ends = [
        word
        for word, (end, axis) in ranges.items()
        if abs(least.at[axis] - end) <= AT_END * (bounds[axis][1] - bounds[axis][0])
    ]
    ends += ["the least part that is looked at, 2 % of the mass"] if share < 1.2 * SLIVER else []
    alike = [elevation for found, elevation in known if found <= least.value * (1.0 + TIE)]
    tied = (min(alike), max(alike)) if max(alike) - min(alike) > APART * (high - low) else None
    return WeakestCrack(CutAngle((x, y, least.at[0]), least.at[1]), least.value, share, tuple(ends), tied)
