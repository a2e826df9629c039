"""The rotations of a mechanism at which a force or tie ends, or a floor loses its seat.

Displacements are those of the load's own point from rest, by the motion of the blocks about their hinges.
"""

from __future__ import annotations

from collections.abc import Callable
from math import inf

import numpy as np
from scipy.optimize import brentq

from assess.loads.load import Action, PointMass, Tie, lasts
from assess.mechanisms.chain import Chain
from assess.mechanisms.motion import FLAT, Path, limit, move, trace_point
from spectra.arrays import FloatArray

STATIONS = 2001  # of a scan from rest to the geometric limit


def scan_rotations(chain: Chain) -> FloatArray:
    """Return the rotations of a scan from rest to the geometric limit of a chain [n] [rad]."""
    return np.linspace(0.0, limit(chain) * (1.0 - FLAT), STATIONS)


def end_of(chain: Chain, action: Action) -> float:
    """Return the rotation up to which a force or tie is shown to act [rad]; 0 if nothing is shown, inf if it lasts."""
    broken = breaking_rotation(chain, action) if isinstance(action, Tie) else inf
    if isinstance(action.until, float | int):
        return min(broken, rotation_reaching(chain, action, float(action.until), _moved))
    return broken if lasts(action) else 0.0


def breaking_rotation(chain: Chain, tie: Tie) -> float:
    """Return the rotation at which a tie reaches its fracture strain [rad]; inf if never, or if none is known."""
    if tie.elongation is None:
        return inf
    return rotation_reaching(chain, tie, tie.elongation, lambda path: _lengthened(tie, path))


def unseating_rotation(chain: Chain, mass: PointMass) -> float:
    """Return the rotation at which the point of a load has moved horizontally by its seat [rad]; inf if never."""
    if mass.seat is None:
        return inf
    return rotation_reaching(chain, mass, mass.seat, _on_seat)


def travel_on_seat(chain: Chain, mass: PointMass, rotation: FloatArray) -> FloatArray:
    """Return how far the point of a load has moved horizontally [n] [m].

    rotation : of the leading block, from 0 on [n] [rad]
    """
    return _on_seat(trace_point(move(chain, rotation), block=mass.block, at=mass.at))


def _on_seat(path: Path) -> FloatArray:
    moved: FloatArray = np.abs(path.x - path.x[0])
    return moved


def rotation_reaching(
    chain: Chain, load: Action | PointMass, amount: float, measure: Callable[[Path], FloatArray]
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
    found = brentq(lambda phi: float(over(np.array([0.0, phi]))[1]), scan[last - 1], scan[last], xtol=1e-15, rtol=1e-14)
    return float(found)


def displacement_at(chain: Chain, load: Action, rotation: float) -> float:
    """Return the displacement of the point of a load from rest [m].

    Parameters
    ----------
    chain : the chain that carries the load
    load : a force or tie
    rotation : of the leading block [rad]
    """
    path = trace_point(move(chain, np.array([0.0, rotation])), block=load.block, at=load.at)
    return float(_moved(path)[1])


def _moved(path: Path) -> FloatArray:
    """Return the displacement from rest [n] [m]."""
    return np.asarray(np.hypot(path.x - path.x[0], path.z - path.z[0]))


def _lengthened(tie: Tie, path: Path) -> FloatArray:
    """Return the elongation of a tie from rest [n] [m]: of its distance to the anchor, or against its direction."""
    if tie.anchor is not None:
        far = np.hypot(tie.anchor[0] - path.x, tie.anchor[1] - path.z)
        return np.asarray(far - far[0])
    along, up = tie.direction or (0.0, 0.0)
    return np.asarray(along * (path.x[0] - path.x) + up * (path.z[0] - path.z))
