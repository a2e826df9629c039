"""The forces of hinges at incipient motion, by equilibrium of every block, without virtual work."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.constants import g

from assess.loads.load import Force, PointMass, Tie, pull_at_rest
from assess.mechanisms.chain import Chain, Point
from assess.mechanisms.motion import move, trace_point
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray


@dataclass(frozen=True, repr=False)
class IncipientMotion(ShortRepr):
    """A chain at incipient motion, under horizontal forces of `multiplier` times all weights along the direction.

    forces : (x, z) of each hinge on the block above it [hinges, 2] [N]; of D on the ground
    """

    multiplier: float
    forces: FloatArray


def incipient_motion(chain: Chain) -> IncipientMotion:
    """Solve the equilibrium of every block at incipient motion: as many equations as unknowns."""
    count, hinges = len(chain.blocks), len(chain.hinges)
    rows, right = np.zeros((3 * count, 2 * hinges + 1)), np.zeros(3 * count)
    for number in range(count):
        own = slice(3 * number, 3 * number + 3)
        rows[own, 2 * number : 2 * number + 2] = _moment_arms(chain.hinges[number])
        if number + 1 < hinges:
            rows[own, 2 * number + 2 : 2 * number + 4] = -_moment_arms(chain.hinges[number + 1])
    for number, at, force, shaken in _loads(chain):
        own = slice(3 * number, 3 * number + 3)
        rows[own, -1] += _moment_arms(at) @ (shaken, 0.0)
        right[own] -= _moment_arms(at) @ force
    known = [2 * hinges - 1] if count == 2 else []  # C slides: it has no vertical reaction
    free = [column for column in range(2 * hinges + 1) if column not in known]
    solved = np.zeros(2 * hinges + 1)
    solved[free] = np.linalg.solve(rows[:, free], right)
    return IncipientMotion(float(solved[-1]), solved[:-1].reshape(-1, 2))


def force_at_rest(chain: Chain) -> Point:
    """Return the force (x, z) of the hinge on a single block at rest [N]."""
    x, z = (-sum(force[i] for _, _, force, _ in _loads(chain)) + 0.0 for i in (0, 1))
    return (x, z)


def compressions(chain: Chain) -> tuple[float, ...]:
    """Return the vertical compression between the blocks that each hinge joins [N]; negative for tension.

    Of two blocks the one with the higher centroid rests on the other; the ground carries both A and D.
    """
    ground = float("-inf")
    heights = [ground, *(block.centroid[1] for block in chain.blocks), ground]
    up = incipient_motion(chain).forces[:, 1]
    return tuple(float(u if high >= low else -u) + 0.0 for u, (low, high) in zip(up, pairwise(heights), strict=False))


def _moment_arms(at: Point) -> FloatArray:
    """Return the matrix from a force (x, z) at a point to (x, z, clockwise moment about the origin) [3, 2]."""
    return np.array([[1.0, 0.0], [0.0, 1.0], [at[1], -at[0]]])


def _loads(chain: Chain) -> list[tuple[int, Point, Point, float]]:
    """List all weights and loads: block, place, force at rest, and horizontal force for a multiplier of one [N]."""
    acting = [(n, b.centroid, (0.0, -b.mass * g), b.mass * g) for n, b in enumerate(chain.blocks)]
    for load in chain.loads:
        if isinstance(load, PointMass):
            acting.append((load.block, load.at, (0.0, -load.mass * g * load.bearing), load.mass * g))
        elif isinstance(load, Force):
            acting.append((load.block, load.at, load.force, 0.0))
        else:
            acting.append((load.block, load.at, _pull(load, chain), 0.0))
    return acting


def _pull(tie: Tie, chain: Chain) -> Point:
    """Return the force of a tie at rest (x, z) [N]; zero if it slackens."""
    along, up = pull_at_rest(tie)
    leaving = trace_point(move(chain, np.zeros(1)), block=tie.block, at=tie.at)
    shortens = along * leaving.dx[0] + up * leaving.dz[0] > 0.0
    return (0.0, 0.0) if shortens and not tie.both else (along, up)
