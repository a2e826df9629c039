"""What acts on a chain at rest, listed from its masses and loads: the weights, the given forces, and the taut ties."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.constants import g

from assess.loads.load import Force, Point, PointMass, Tie, pull_at_rest
from assess.mechanisms.chain import Chain
from assess.mechanisms.motion import move, trace_point


@dataclass(frozen=True)
class Acting:
    """One mass or load at rest.

    block : number of the block it acts on, from 0 at the base; at : its place (x, z) [m]
    force : (x, z) at rest [N]; shaken : its mass times g, the horizontal force of a multiplier of one [N]
    """

    block: int
    at: Point
    force: Point
    shaken: float


def acting_on(chain: Chain) -> list[Acting]:
    """Return every mass and load of a chain.

    A mass that is not bearing has horizontal inertia and no weight here; a tie that shortens as rocking starts is
    slack, unless it acts both ways.
    """
    found = [Acting(n, b.centroid, (0.0, -b.mass * g), b.mass * g) for n, b in enumerate(chain.blocks)]
    for load in chain.loads:
        if isinstance(load, PointMass):
            weight = load.mass * g
            found.append(Acting(load.block, load.at, (0.0, -weight if load.bearing else 0.0), weight))
        elif isinstance(load, Force):
            found.append(Acting(load.block, load.at, load.force, 0.0))
        elif load.both or not _shortens(load, chain):
            found.append(Acting(load.block, load.at, pull_at_rest(load), 0.0))
    return found


def _shortens(tie: Tie, chain: Chain) -> bool:
    """Return whether the point of a tie starts to move along its pull."""
    along, up = pull_at_rest(tie)
    leaving = trace_point(move(chain, np.zeros(1)), block=tie.block, at=tie.at)
    return bool(along * leaving.dx[0] + up * leaving.dz[0] > 0.0)
