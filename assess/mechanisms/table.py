"""From a rigid chain to the table of its branch."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from assess.errors import MechanismError
from assess.mechanisms.chain import Chain
from assess.mechanisms.motion import limit
from assess.mechanisms.virtual_work import Work, require_stable, virtual_work
from assess.oscillator import Branch

FloatArray = NDArray[np.float64]

NODES = 257  # of a branch table; a block's cubic splines are then exact to 1e-11 of their largest value
FLAT = 1e-6  # of the geometric limit: a loop is never taken quite to it, where its rates grow without bound
REACH = 1.5  # tables end at this many overturning rotations


def first_fall(values: FloatArray, rotation: FloatArray, value_at: Callable[[float], float]) -> float | None:
    """The first rotation [rad] where `values` [n] over `rotation` [n] go from + to -; None where they never do."""
    falling = np.flatnonzero((values[:-1] > 0) & (values[1:] <= 0))
    if not falling.size:
        return None
    first = int(falling[0])
    return float(brentq(value_at, rotation[first], rotation[first + 1], xtol=1e-15, rtol=1e-14))


def branch(chain: Chain, *, restitution: float, name: str) -> Branch:
    """The table of one chain, from rest to REACH times its overturning rotation, and at least to phi_cr.

    Raises MechanismError for a chain that falls by itself, or that never overturns before it can turn no further.
    """
    require_stable(chain, name=name)
    reach = limit(chain) * (1.0 - FLAT)
    scan = np.linspace(0.0, reach, 2001)
    whole = virtual_work(chain, scan)

    def at(phi: float) -> Work:
        return virtual_work(chain, np.array([0.0, phi]))  # rest first: it tells whether a tie is slack

    overturning = first_fall(whole.restoring, scan, lambda phi: float(at(phi).restoring[1]))
    critical = first_fall(whole.weight, scan, lambda phi: float(at(phi).weight[1]))
    edge = first_fall(whole.excitation, scan, lambda phi: float(at(phi).excitation[1])) or reach
    if overturning is None or critical is None or max(overturning, critical) >= edge:
        last = "the body lies level with its hinge" if len(chain.blocks) == 1 else "its blocks can turn no further"
        raise MechanismError(
            f'mechanism "{name}": the restoring moment does not fall to zero before {last}, at {edge:.3g} rad; it '
            "cannot overturn as described: check hinges and loads"
        )
    end = min(max(REACH * overturning, 1.05 * critical), 0.5 * (max(overturning, critical) + edge))
    rotation = np.linspace(0.0, end, NODES)
    work = virtual_work(chain, rotation)
    columns = (rotation, work.inertia, work.restoring, work.excitation, work.participation, work.lift)
    for column in columns:
        column.flags.writeable = False
    return Branch(*columns, restitution=restitution, overturning=overturning, critical=critical)
