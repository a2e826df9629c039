"""From a chain on rigid hinges to the table of its branch, in stages as its forces and ties end.

An action that drives never ends, whatever is known of it; one that resists acts up to its end only. So an action that
has ended contributes max(M, 0) at each rotation, M its generalised moment. A force or tie ends, and a floor loses its
seat, at a displacement of the load's own point from rest, by the motion of the blocks about their hinges.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields, replace
from functools import partial
from itertools import pairwise
from math import hypot, inf
from typing import TypeVar

import numpy as np

from assess.errors import MechanismError
from assess.loads.load import Force, ForceOrTie, PointMass, Tie, lasts, length_to_anchor, stretches
from assess.mechanisms.chain import (
    FLAT,
    Chain,
    PointPath,
    Work,
    generalised_moment,
    geometric_limit,
    move,
    require_stable,
    top_loads,
    trace_point,
    virtual_work,
)
from assess.oscillator import Branch
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray, IntArray

Found = TypeVar("Found")

NODES = 257  # of a branch table; a block's cubic splines are then exact to 1e-11 of their largest value
REACH = 1.5  # tables end at this many overturning rotations
FEWEST = 4  # nodes of a piece between two changes: a cubic


def rigid_branch(chain: Chain, *, restitution: float, name: str) -> Branch:
    """Tabulate one chain, from rest to REACH times its overturning rotation, and at least to phi_cr.

    Parameters
    ----------
    chain : on rigid hinges
    restitution : of the impact that ends the branch [-]
    name : of the mechanism, for errors

    Raises
    ------
    MechanismError : a chain that falls by itself, or reaches its geometric limit before it overturns
    """
    return staged_branch(single_stage(chain), restitution=restitution, name=name)


def staged_branch(stages: Stages, *, restitution: float, name: str) -> Branch:
    """Tabulate a chain whose actions end: a jump is two nodes at one rotation."""
    chain = stages[0].chain
    require_stable(chain, name=name)
    reach = geometric_limit(chain) * (1.0 - FLAT)
    scan, number = _table_nodes(stages, reach, STATIONS)
    scanned = _integrate_work(stages, scan, number)
    _require_numbers(scanned, reach, name=name)

    def work_at(phi: float, node: int) -> Work:
        return virtual_work(
            stages[number[node]].chain, np.array([0.0, phi])
        )  # rest first: whether a tie is slack depends on it

    overturning = _first_downward_crossing(
        scanned.restoring, scan, lambda phi, node: float(work_at(phi, node).restoring[1])
    )
    critical = overturning  # where no action has a moment, or weights do no work
    if chain.actions and not chain.level:
        critical = _first_downward_crossing(scanned.weight, scan, lambda phi, node: float(work_at(phi, node).weight[1]))
    edge = (
        _first_downward_crossing(scanned.excitation, scan, lambda phi, node: float(work_at(phi, node).excitation[1]))
        or reach
    )
    if overturning is None or critical is None or max(overturning, critical) >= edge:
        last = "the body lies level with its hinge" if len(chain.blocks) == 1 else "its blocks can turn no further"
        raise MechanismError(
            f'mechanism "{name}": the restoring moment does not fall to zero before {last}, at {edge:.3g} rad; it '
            "cannot overturn as described: check hinges and loads"
        )
    end = min(max(REACH * overturning, 1.05 * critical), 0.5 * (max(overturning, critical) + edge))
    rotation, number = _table_nodes(stages, end, NODES)
    work = _integrate_work(stages, rotation, number)
    _require_numbers(work, end, name=name)
    columns = (rotation, work.inertia, work.restoring, work.excitation, work.participation, work.lift)
    for column in columns:
        column.flags.writeable = False
    return Branch(*columns, restitution=restitution, overturning=overturning, critical=critical)


NEGLIGIBLE = 1e-12  # of the size of an action times that of its chain: a smaller moment is zero
AT_REST = 1e-9  # of a scan: a stage that begins this near rest begins at rest


@dataclass(frozen=True)
class ChainStage:
    """A chain from the rotation `start` [rad] on, without the actions that are absent, by their number."""

    start: float
    chain: Chain
    absent: tuple[int, ...] = ()


Stages = tuple[ChainStage, ...]
Signature = tuple[tuple[float, tuple[int, ...]], ...]


@dataclass(frozen=True, repr=False)
class ActionMoments(ShortRepr):
    """The generalised moment of every action of a chain; positive drives.

    scan : rotations from rest on [n] [rad]
    at_rotations : moments of all actions at rotations, with rounding counted as driving [n] [rad] -> [actions, n] [N m]
    """

    scan: FloatArray
    at_rotations: Callable[[FloatArray], FloatArray]


def rigid_moments(chain: Chain, *, end: float) -> ActionMoments:
    """Return the moments of the actions as the blocks rotate about their hinges, up to the rotation `end` [rad]."""
    actions = chain.actions

    def moments_at(rotation: FloatArray) -> FloatArray:
        motion = move(chain, np.concatenate([[0.0], rotation]))  # rest first: whether a tie is slack depends on it
        works = [generalised_moment(each, trace_point(motion, block=each.block, at=each.at)) for each in actions]
        return np.array(works).reshape(len(actions), -1)[:, 1:] + negligible_moments(chain)

    return ActionMoments(np.linspace(0.0, end, STATIONS), moments_at)


def negligible_moments(chain: Chain) -> FloatArray:
    """Return the moment of each action that counts as zero [actions, 1] [N m]."""
    actions = chain.actions
    points = np.array([*chain.hinges, *(block.centroid for block in chain.blocks), *(each.at for each in actions)])
    forces = [hypot(*each.force) if isinstance(each, Force) else each.tension for each in actions]
    return NEGLIGIBLE * hypot(*np.ptp(points, axis=0)) * np.array(forces)[:, None]


def single_stage(chain: Chain) -> Stages:
    """Return the chain with every action at every rotation, but for ties that stretch, which break.

    A stage begins where such a tie begins to yield, is slack or breaks.
    """
    broken = _of_ties(chain, partial(_breaking_rotation, chain))
    ends = {number: end for number, end in broken.items() if stretches(chain.actions[number])}
    found = []
    for start in sorted({0.0, *_kinks(chain), *(end for end in ends.values() if end < inf)}):
        absent = tuple(number for number, end in ends.items() if end <= start)
        found.append(ChainStage(start, _remove_actions(chain, absent), absent))
    return tuple(found)


def _kinks(chain: Chain) -> list[float]:
    """Return the rotations at which the bars of ties begin to pull, to yield, or are slack [rad]."""

    def of_one(tie: Tie) -> list[float]:
        if tie.stiffness is None:
            return []
        marks = ((1.0, tie.slack), (1.0, tie.elastic_elongation), (-1.0, tie.tension / tie.stiffness))
        return [rotation_reaching(chain, tie, amount, partial(_signed_elongation, tie, sign)) for sign, amount in marks]

    found = {each for kinks in _of_ties(chain, of_one).values() for each in kinks}
    return sorted(each for each in found if 0.0 < each < inf)


def _of_ties(chain: Chain, find: Callable[[Tie], Found]) -> dict[int, Found]:
    """Return what is found of each tie by its number; ties alike in the plane of motion, as along a wall, share it."""
    known: dict[tuple[object, ...], Found] = {}
    found = {}
    for number, tie in enumerate(chain.actions):
        if isinstance(tie, Tie):
            place = (tie.block, tie.at, tie.anchor, tie.aside, tie.direction)
            law = (*place, tie.stiffness, tie.tension, tie.slack, tie.most, tie.elongation)
            if law not in known:
                known[law] = find(tie)
            found[number] = known[law]
    return found


def stage_signature(found: Stages) -> Signature:
    """Return what distinguishes stages of one chain."""
    return tuple((stage.start, stage.absent) for stage in found)


def divide_into_stages(chain: Chain, ends: Sequence[float], moments: ActionMoments) -> Stages:
    """Divide the motion of a chain into stages: each action resists up to its end [rad] and drives everywhere.

    ends : of each of `chain.actions`: 0 if it never resists, inf if it always does
    """
    if not ends:
        return single_stage(chain)
    values = moments.at_rotations(moments.scan)
    ended = [number for number, end in enumerate(ends) if end < moments.scan[-1] and values[number].min() < 0.0]
    if not ended:
        return single_stage(chain)
    kinks = {0.0, *_kinks(chain)}
    marks = set(kinks)
    for number in ended:
        marks |= {ends[number], *_sign_changes(number, values[number], moments, after=ends[number])}
    least = AT_REST * moments.scan[-1]
    starts = [0.0, *sorted(mark for mark in marks if mark > least)]
    found: list[ChainStage] = []
    for start, stop in pairwise([*starts, float(moments.scan[-1])]):
        middle = 0.5 * (start + stop)
        now = moments.at_rotations(np.array([middle]))[:, 0]
        absent = tuple(number for number in ended if middle > ends[number] and now[number] < 0.0)
        if not found or found[-1].absent != absent or start in kinks:
            found.append(ChainStage(start, _remove_actions(chain, absent), absent))
    return tuple(found)


STATIONS = 2001  # of a scan from rest to the geometric limit


def scan_rotations(chain: Chain) -> FloatArray:
    """Return the rotations of a scan from rest to the geometric limit of a chain [n] [rad]."""
    return np.linspace(0.0, geometric_limit(chain) * (1.0 - FLAT), STATIONS)


def ends_of(chain: Chain) -> tuple[float, ...]:
    """Return the rotations up to which forces and ties are shown to act [rad].

    0 of one of which nothing is shown, inf of one that lasts.
    """
    broken = _of_ties(chain, partial(_breaking_rotation, chain))
    return tuple(_end_of(chain, action, broken.get(number, inf)) for number, action in enumerate(chain.actions))


def _end_of(chain: Chain, action: ForceOrTie, broken: float) -> float:
    """Return the rotation up to which an action is shown to act [rad]; broken: at which it breaks [rad]."""
    if isinstance(action.until, float | int):
        return min(broken, rotation_reaching(chain, action, float(action.until), _displacement))
    return broken if lasts(action) else 0.0


def unseating_rotation(chain: Chain, mass: PointMass) -> float:
    """Return the rotation at which the point of a load has moved horizontally by its seat [rad]; inf if never."""
    if mass.seat is None:
        return inf
    return rotation_reaching(chain, mass, mass.seat, _horizontal_travel)


def travel_on_seat(chain: Chain, mass: PointMass, rotation: FloatArray) -> FloatArray:
    """Return how far the point of a load has moved horizontally [n] [m].

    rotation : of the leading block, from 0 on [n] [rad]
    """
    return _horizontal_travel(trace_point(move(chain, rotation), block=mass.block, at=mass.at))


def rotation_reaching(
    chain: Chain, load: ForceOrTie | PointMass, amount: float, measure: Callable[[PointPath], FloatArray]
) -> float:
    """Return the first rotation at which a measure of the path of a load reaches an amount [m]; inf if never [rad].

    measure : path over rotations that begin at rest [n] -> [n] [m]
    """

    def over(rotation: FloatArray) -> FloatArray:
        return measure(trace_point(move(chain, rotation), block=load.block, at=load.at)) - amount

    scan = scan_rotations(chain)
    beyond = np.flatnonzero(over(scan) >= 0.0)
    if not beyond.size:
        return inf
    last = int(beyond[0])
    if last == 0:
        return 0.0
    from scipy.optimize import brentq

    found = brentq(lambda phi: float(over(np.array([0.0, phi]))[1]), scan[last - 1], scan[last], xtol=1e-15, rtol=1e-14)
    return float(found)


def load_displacement(chain: Chain, load: ForceOrTie, rotation: float) -> float:
    """Return the displacement of the point of a load from rest [m].

    Parameters
    ----------
    chain : the chain that carries the load
    load : a force or tie
    rotation : of the leading block [rad]
    """
    path = trace_point(move(chain, np.array([0.0, rotation])), block=load.block, at=load.at)
    return float(_displacement(path)[1])


def tie_elongation(chain: Chain, tie: Tie, rotation: float) -> float:
    """Return the elongation of a tie from rest [m], negative where it shortens.

    Parameters
    ----------
    chain : the chain that carries it
    tie : the tie
    rotation : of the leading block [rad]
    """
    path = trace_point(move(chain, np.array([0.0, rotation])), block=tie.block, at=tie.at)
    return float(_elongation(tie, path)[1])


def _first_downward_crossing(
    values: FloatArray, rotation: FloatArray, value_at: Callable[[float, int], float]
) -> float | None:
    """Return the first rotation [rad] at which `values` [n] over `rotation` [n] go from + to -; None if never.

    value_at : of a rotation between a node, by its number, and the next
    """
    falling = np.flatnonzero((values[:-1] > 0) & (values[1:] <= 0))
    if not falling.size:
        return None
    first = int(falling[0])
    if rotation[first] == rotation[first + 1]:  # it falls at the end of a stage
        return float(rotation[first])
    from scipy.optimize import brentq

    found = brentq(lambda phi: value_at(phi, first), rotation[first], rotation[first + 1], xtol=1e-15, rtol=1e-14)
    return float(found)


def _require_numbers(work: Work, end: float, *, name: str) -> None:
    """Raise MechanismError if a sum up to the rotation `end` [rad] is not finite."""
    if not (np.isfinite(end) and all(np.isfinite(getattr(work, each.name)).all() for each in fields(Work))):
        raise MechanismError(
            f'mechanism "{name}": its hinges, blocks and loads are so far apart, or of so unlike sizes, that nothing '
            "can be worked out; check their coordinates and units"
        )


def _table_nodes(stages: Stages, end: float, count: int) -> tuple[FloatArray, IntArray]:
    """Return about `count` rotations from 0 to `end` [rad], two at the end of a stage, and the stage of each [n]."""
    starts = [stage.start for stage in stages if stage.start < end]
    if len(starts) == 1:
        return np.linspace(0.0, end, count), np.zeros(count, dtype=np.int64)
    stops = [*starts[1:], end]
    pieces = [
        np.linspace(start, stop, max(FEWEST, 1 + int(np.ceil((count - 1) * (stop - start) / end))))
        for start, stop in zip(starts, stops, strict=True)
    ]
    return np.concatenate(pieces), np.repeat(np.arange(len(pieces)), [piece.size for piece in pieces])


def _integrate_work(stages: Stages, rotation: FloatArray, number: IntArray) -> Work:
    """Return the sums of virtual work at rotations [n], each by the stage of its number [n]."""
    found = []
    for stage in np.unique(number):
        here = rotation[number == stage]
        work = virtual_work(stages[stage].chain, here if here[0] == 0.0 else np.concatenate([[0.0], here]))
        skip = 0 if here[0] == 0.0 else 1  # rest first: whether a tie is slack depends on it
        found.append([getattr(work, each.name)[skip:] for each in fields(Work)])
    return Work(*(np.concatenate(column) for column in zip(*found, strict=True)))


def _remove_actions(chain: Chain, absent: Sequence[int]) -> Chain:
    """Remove actions from a chain, by their number; a joint at its top without load becomes rigid."""
    if not absent:
        return chain
    actions = chain.actions
    gone = [id(actions[number]) for number in absent]
    left = replace(chain, loads=tuple(load for load in chain.loads if id(load) not in gone))
    if len(chain.blocks) == 2 and chain.joints and not top_loads(left):
        return replace(left, joints=(*left.joints[:2], None))
    return left


def _sign_changes(number: int, moment: FloatArray, moments: ActionMoments, *, after: float) -> set[float]:
    """Return the rotations after one at which the moment of an action changes its sign [rad]."""
    from scipy.optimize import brentq

    scan = moments.scan
    changes = np.flatnonzero((moment[:-1] < 0.0) != (moment[1:] < 0.0))

    def moment_at(phi: float) -> float:
        return float(moments.at_rotations(np.array([phi]))[number, 0])

    roots = (
        float(brentq(moment_at, scan[k], scan[k + 1], xtol=1e-15, rtol=1e-14)) for k in changes if scan[k + 1] > after
    )
    return {root for root in roots if root > after}


def _breaking_rotation(chain: Chain, tie: Tie) -> float:
    """Return the rotation at which a tie reaches its fracture strain [rad]; inf if never, or if none is known."""
    if tie.elongation is None:
        return inf
    return rotation_reaching(chain, tie, tie.elongation, lambda path: _elongation(tie, path))


def _horizontal_travel(path: PointPath) -> FloatArray:
    moved: FloatArray = np.abs(path.x - path.x[0])
    return moved


def _displacement(path: PointPath) -> FloatArray:
    """Return the displacement from rest [n] [m]."""
    return np.asarray(np.hypot(path.x - path.x[0], path.z - path.z[0]))


def _signed_elongation(tie: Tie, sign: float, path: PointPath) -> FloatArray:
    return sign * _elongation(tie, path)


def _elongation(tie: Tie, path: PointPath) -> FloatArray:
    """Return the elongation of a tie from rest [n] [m]: of its distance to the anchor, or against its direction."""
    if tie.anchor is not None:
        far = length_to_anchor(tie, tie.anchor[0] - path.x, tie.anchor[1] - path.z)
        return np.asarray(far - far[0])
    along, up = tie.direction or (0.0, 0.0)
    return np.asarray(along * (path.x[0] - path.x) + up * (path.z[0] - path.z))
