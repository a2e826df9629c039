"""The crack of a wall held at its base and its top: eq. 3.27, its general form, and a search."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from math import inf, sqrt

import numpy as np
from scipy.optimize import minimize_scalar

from assess.errors import CrackError

STATIONS = 41  # of the search, before it is refined
MARGIN = 0.02  # of the height: least distance of a crack from base or top
FINE = 1e-6  # of the height: accuracy of the search
ARM = 0.5  # of the thickness: lever arm of the tensile block at the crack, in eq. 3.27


def crack_ratio(*, load: float, tension: float, place: float, arm: float = ARM) -> float:
    """Return the height of the crack over that of a plain rectangular wall, for the least uplift multiplier.

    h_c / h = sqrt(a) / (sqrt(a) + sqrt(c)) with a = 1 + n + arm t and c = (1 - xi) n + arm t. With the load at
    mid-thickness (xi = 1/2) and arm = 1/2 it is thesis eq. 3.27 (Sorrentino et al. 2008).

    Parameters
    ----------
    load : n, vertical load over the weight of the wall [-]
    tension : t, tensile strength of the mortar times the area of the base over the weight of the wall [-]
    place : xi, distance of the load from the edge support over the thickness [-]; see two_block
    arm : lever arm of the tensile block over the thickness [-]

    Raises
    ------
    CrackError : there is neither load nor tension, so that the crack would be at the top
    """
    a, c = 1.0 + load + arm * tension, (1.0 - place) * load + arm * tension
    if c <= 0.0:
        raise CrackError(
            "eq. 3.27 puts the crack at the very top, for there is neither load nor tensile strength to hold it lower"
        )
    return sqrt(a) / (sqrt(a) + sqrt(c))


def find_least(
    multiplier: Callable[[float], float], *, low: float, high: float, jumps: Sequence[float] = (), apart: float = 0.0
) -> float:
    """Find the elevation of the crack at which the multiplier of a wall is least [m].

    Parameters
    ----------
    multiplier : of the wall cracked at an elevation [m] -> [-]
    low, high : elevations of base and top [m]
    jumps : elevations at which the multiplier jumps [m]
    apart : least distance of the crack from a jump [m]

    Raises
    ------
    CrackError : the multiplier is least at an end, so that no crack between controls
    """
    ends = (low + MARGIN * (high - low), high - MARGIN * (high - low))
    parts = list(split_range(ends, jumps, apart=apart))
    best, at, bounds = inf, low, ends
    for start, end in parts:
        stations = np.linspace(start, end, STATIONS)
        values = [multiplier(float(each)) for each in stations]
        lowest = int(np.argmin(values))
        if values[lowest] < best:
            best, at = values[lowest], float(stations[lowest])
            bounds = (float(stations[max(lowest - 1, 0)]), float(stations[min(lowest + 1, STATIONS - 1)]))
    if not parts or at in (parts[0][0], parts[-1][1]):
        raise CrackError(
            f'crack = "minimum": the least multiplier is at an end, at z = {at:.4g} m, so no crack between '
            "base and top controls; give an overburden load, the material's tensile_strength, a crack elevation, or "
            "hinges"
        )
    found = minimize_scalar(multiplier, bounds=bounds, method="bounded", options={"xatol": FINE * (high - low)})
    return float(found.x)


def split_range(ends: tuple[float, float], jumps: Sequence[float], *, apart: float) -> Iterator[tuple[float, float]]:
    """Split a range at jumps, leaving out what is nearer than `apart` to one."""
    start = ends[0]
    for jump in sorted(each for each in set(jumps) if ends[0] < each + apart and each - apart < ends[1]):
        if jump - apart > start:
            yield start, jump - apart
        start = max(start, jump + apart)
    if start < ends[1]:
        yield start, ends[1]
