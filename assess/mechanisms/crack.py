"""Where a wall that is held at its base and at its top cracks between: eq. 3.27, its general form, and by search."""

from __future__ import annotations

from collections.abc import Callable
from math import sqrt

import numpy as np
from scipy.optimize import minimize_scalar

from assess.errors import CrackError

STATIONS = 41  # of the search, before it is refined
MARGIN = 0.02  # of the height: no crack is looked for nearer to base or top
FINE = 1e-6  # of the height: how near the search comes
ARM = 0.5  # of the thickness: lever arm of the tensile block at the crack, in eq. 3.27


def crack_ratio(*, load: float, tension: float, place: float, arm: float = ARM) -> float:
    """Height of the crack over the height of the wall for the least uplift multiplier of a plain rectangular wall.

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
    CrackError : neither load nor tension holds the wall, so that the crack would be at the top
    """
    a, c = 1.0 + load + arm * tension, (1.0 - place) * load + arm * tension
    if c <= 0.0:
        raise CrackError(
            "eq. 3.27 puts the crack at the very top, for there is neither load nor tensile strength to hold it lower"
        )
    return sqrt(a) / (sqrt(a) + sqrt(c))


def least(multiplier: Callable[[float], float], *, low: float, high: float) -> float:
    """The elevation [m] between those of base and top at which `multiplier` of the cracked wall is least.

    Raises CrackError where it is least at the end, for then there is no crack between.
    """
    stations = np.linspace(low + MARGIN * (high - low), high - MARGIN * (high - low), STATIONS)
    values = [multiplier(float(each)) for each in stations]
    best = int(np.argmin(values))
    if best in (0, STATIONS - 1):
        raise CrackError(
            f'crack = "minimum": the least multiplier is at an end, at z = {stations[best]:.4g} m, so no crack between '
            "base and top controls; give an overburden load, the material's tensile_strength, a crack elevation, or "
            "hinges"
        )
    found = minimize_scalar(
        multiplier,
        bounds=(stations[best - 1], stations[best + 1]),
        method="bounded",
        options={"xatol": FINE * (high - low)},
    )
    return float(found.x)
