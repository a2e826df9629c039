"""The stages of a chain whose forces and ties end: which of them act from which rotation on.

An action that drives never ends, whatever is known of it; one that resists acts up to its end only. So an action that
has ended contributes max(M, 0) at each rotation, M its generalised moment.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import hypot

import numpy as np
from scipy.optimize import brentq

from assess.loads.load import Action, Force, PointMass
from assess.mechanisms.chain import Chain
from assess.mechanisms.ends import STATIONS
from assess.mechanisms.flexible import top_loads
from assess.mechanisms.motion import move, trace_point
from assess.mechanisms.virtual_work import generalised_moment
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray

NONE = 1e-12  # of the size of an action times that of its chain: a smaller moment is zero
AT_REST = 1e-9  # of a scan: a stage that begins this near rest begins at rest


@dataclass(frozen=True)
class Stage:
    """A chain from the rotation `start` [rad] on, without the actions that are absent, by their number."""

    start: float
    chain: Chain
    absent: tuple[int, ...] = ()


Stages = tuple[Stage, ...]
Signature = tuple[tuple[float, tuple[int, ...]], ...]


@dataclass(frozen=True, repr=False)
class Moments(ShortRepr):
    """The generalised moment of every action of a chain; positive drives.

    scan : rotations from rest on [n] [rad]
    of : moments of all actions at rotations, with rounding counted as driving [n] [rad] -> [actions, n] [N m]
    """

    scan: FloatArray
    of: Callable[[FloatArray], FloatArray]


def actions_of(chain: Chain) -> tuple[Action, ...]:
    """Return the forces and ties on a chain."""
    return tuple(load for load in chain.loads if not isinstance(load, PointMass))


def rigid_moments(chain: Chain, *, end: float) -> Moments:
    """Return the moments of the actions as the blocks rotate about their hinges, up to the rotation `end` [rad]."""
    actions = actions_of(chain)

    def of(rotation: FloatArray) -> FloatArray:
        motion = move(chain, np.concatenate([[0.0], rotation]))  # rest first: whether a tie is slack depends on it
        works = [generalised_moment(each, trace_point(motion, block=each.block, at=each.at)) for each in actions]
        return np.array(works).reshape(len(actions), -1)[:, 1:] + zero_moments(chain)

    return Moments(np.linspace(0.0, end, STATIONS), of)


def zero_moments(chain: Chain) -> FloatArray:
    """Return the moment of each action that counts as zero [actions, 1] [N m]."""
    actions = actions_of(chain)
    points = np.array([*chain.hinges, *(block.centroid for block in chain.blocks), *(each.at for each in actions)])
    forces = [hypot(*each.force) if isinstance(each, Force) else each.tension for each in actions]
    return NONE * hypot(*np.ptp(points, axis=0)) * np.array(forces)[:, None]


def single_stage(chain: Chain) -> Stages:
    """Return the chain with every action at every rotation."""
    return (Stage(0.0, chain),)


def signature(found: Stages) -> Signature:
    """Return what distinguishes stages of one chain."""
    return tuple((stage.start, stage.absent) for stage in found)


def divide_into_stages(chain: Chain, ends: Sequence[float], moments: Moments) -> Stages:
    """Divide the motion of a chain into stages: each action resists up to its end [rad] and drives everywhere.

    ends : of each of `actions_of(chain)`: 0 if it never resists, inf if it always does
    """
    if not ends:
        return single_stage(chain)
    values = moments.of(moments.scan)
    ended = [number for number, end in enumerate(ends) if end < moments.scan[-1] and values[number].min() < 0.0]
    if not ended:
        return single_stage(chain)
    marks = {0.0}
    for number in ended:
        marks |= {ends[number], *_turnings(number, values[number], moments, after=ends[number])}
    least = AT_REST * moments.scan[-1]
    starts = [0.0, *sorted(mark for mark in marks if mark > least)]
    found: list[Stage] = []
    for start, stop in pairwise([*starts, float(moments.scan[-1])]):
        middle = 0.5 * (start + stop)
        now = moments.of(np.array([middle]))[:, 0]
        absent = tuple(number for number in ended if middle > ends[number] and now[number] < 0.0)
        if not found or found[-1].absent != absent:
            found.append(Stage(start, remove_actions(chain, absent), absent))
    return tuple(found)


def remove_actions(chain: Chain, absent: Sequence[int]) -> Chain:
    """Remove actions from a chain, by their number; a joint at its top without load becomes rigid."""
    if not absent:
        return chain
    actions = actions_of(chain)
    gone = [id(actions[number]) for number in absent]
    left = replace(chain, loads=tuple(load for load in chain.loads if id(load) not in gone))
    if len(chain.blocks) == 2 and chain.joints and not top_loads(left):
        return replace(left, joints=(*left.joints[:2], None))
    return left


def _turnings(number: int, moment: FloatArray, moments: Moments, *, after: float) -> set[float]:
    """Return the rotations after one at which the moment of an action changes its sign [rad]."""
    scan = moments.scan
    changes = np.flatnonzero((moment[:-1] < 0.0) != (moment[1:] < 0.0))

    def at(phi: float) -> float:
        return float(moments.of(np.array([phi]))[number, 0])

    roots = (float(brentq(at, scan[k], scan[k + 1], xtol=1e-15, rtol=1e-14)) for k in changes if scan[k + 1] > after)
    return {root for root in roots if root > after}
