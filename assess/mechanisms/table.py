"""From a rigid chain to the table of its branch."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import fields

import numpy as np
from scipy.optimize import brentq

from assess.errors import MechanismError
from assess.mechanisms.chain import Chain
from assess.mechanisms.ends import STATIONS
from assess.mechanisms.motion import FLAT, limit
from assess.mechanisms.stages import Stages, single_stage
from assess.mechanisms.virtual_work import Work, require_stable, virtual_work
from assess.oscillator import Branch
from spectra.arrays import FloatArray, IntArray

NODES = 257  # of a branch table; a block's cubic splines are then exact to 1e-11 of their largest value
REACH = 1.5  # tables end at this many overturning rotations
FEWEST = 4  # nodes of a piece between two changes: a cubic


def first_fall(values: FloatArray, rotation: FloatArray, value_at: Callable[[float, int], float]) -> float | None:
    """Return the first rotation [rad] at which `values` [n] over `rotation` [n] go from + to -; None if never.

    value_at : of a rotation between a node, by its number, and the next
    """
    falling = np.flatnonzero((values[:-1] > 0) & (values[1:] <= 0))
    if not falling.size:
        return None
    first = int(falling[0])
    if rotation[first] == rotation[first + 1]:  # it falls at the end of a stage
        return float(rotation[first])
    found = brentq(lambda phi: value_at(phi, first), rotation[first], rotation[first + 1], xtol=1e-15, rtol=1e-14)
    return float(found)


def branch(chain: Chain, *, restitution: float, name: str) -> Branch:
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
    reach = limit(chain) * (1.0 - FLAT)
    scan, number = nodes(stages, reach, STATIONS)
    scanned = integrate_work(stages, scan, number)
    _require_numbers(scanned, reach, name=name)

    def at(phi: float, node: int) -> Work:
        return virtual_work(
            stages[number[node]].chain, np.array([0.0, phi])
        )  # rest first: whether a tie is slack depends on it

    overturning = first_fall(scanned.restoring, scan, lambda phi, node: float(at(phi, node).restoring[1]))
    critical = first_fall(scanned.weight, scan, lambda phi, node: float(at(phi, node).weight[1]))
    edge = first_fall(scanned.excitation, scan, lambda phi, node: float(at(phi, node).excitation[1])) or reach
    if overturning is None or critical is None or max(overturning, critical) >= edge:
        last = "the body lies level with its hinge" if len(chain.blocks) == 1 else "its blocks can turn no further"
        raise MechanismError(
            f'mechanism "{name}": the restoring moment does not fall to zero before {last}, at {edge:.3g} rad; it '
            "cannot overturn as described: check hinges and loads"
        )
    end = min(max(REACH * overturning, 1.05 * critical), 0.5 * (max(overturning, critical) + edge))
    rotation, number = nodes(stages, end, NODES)
    work = integrate_work(stages, rotation, number)
    _require_numbers(work, end, name=name)
    columns = (rotation, work.inertia, work.restoring, work.excitation, work.participation, work.lift)
    for column in columns:
        column.flags.writeable = False
    return Branch(*columns, restitution=restitution, overturning=overturning, critical=critical)


def _require_numbers(work: Work, end: float, *, name: str) -> None:
    """Raise MechanismError if a sum up to the rotation `end` [rad] is not finite."""
    if not (np.isfinite(end) and all(np.isfinite(getattr(work, each.name)).all() for each in fields(Work))):
        raise MechanismError(
            f'mechanism "{name}": its hinges, blocks and loads are so far apart, or of so unlike sizes, that nothing '
            "can be worked out; check their coordinates and units"
        )


def nodes(stages: Stages, end: float, count: int) -> tuple[FloatArray, IntArray]:
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


def integrate_work(stages: Stages, rotation: FloatArray, number: IntArray) -> Work:
    """Return the sums of virtual work at rotations [n], each by the stage of its number [n]."""
    found = []
    for stage in np.unique(number):
        here = rotation[number == stage]
        work = virtual_work(stages[stage].chain, here if here[0] == 0.0 else np.concatenate([[0.0], here]))
        skip = 0 if here[0] == 0.0 else 1  # rest first: whether a tie is slack depends on it
        found.append([getattr(work, each.name)[skip:] for each in fields(Work)])
    return Work(*(np.concatenate(column) for column in zip(*found, strict=True)))
