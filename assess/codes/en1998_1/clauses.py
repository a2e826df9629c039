"""EN 1998-1:2004, 4.3.5: a non-structural element under a static force at its centre of mass.

    F_a = S_a W_a gamma_a / q_a                                                              (4.24)
    S_a = alpha S [3 (1 + z/H) / (1 + (1 - T_a/T_1)^2) - 0.5], at least alpha S              (4.25)

alpha S is the peak acceleration of the surface over g, the PGA of the level. Formulas and Table 4.4 are from memory,
not checked against the printed standard. One function for each formula.
"""

from __future__ import annotations

from dataclasses import dataclass

from scipy.constants import g

from assess.codes.context import Context, Support
from assess.oscillator import Branch, elastic_frequency, threshold
from spectra.floor import ec8_floor_factor

EDITION = "EN 1998-1:2004"
CAVEAT = (
    "(4.24), (4.25) and Table 4.4 are from memory, not checked against the printed standard; the clause covers "
    "non-structural elements, and its force check has no reserve beyond uplift but q_a"
)
BEHAVIOUR: dict[Support, float] = {"free": 1.0, "spanning": 2.0, "hinged": 1.0}  # q_a, Table 4.4
ELEMENTS: dict[Support, str] = {
    "free": "stands free, as cantilever parapets",
    "spanning": "held at base and top, as walls and facades",
    "hinged": "chain of hinges, not in Table 4.4: the smallest value",
}
RESONANCE = 1.0  # T_a / T_1 where the building is not known: the worst


@dataclass(frozen=True)
class Options:
    """Options of EN 1998-1, 4.3.5.

    behaviour_factor : q_a [-], None for that of Table 4.4; importance_factor : gamma_a [-] of the element
    alpha_s : alpha S at the site's own PGA [g]; None where the spectrum is of a code, and begins with it
    """

    behaviour_factor: float | None = None
    importance_factor: float = 1.0
    alpha_s: float | None = None


def element_period(branch: Branch) -> float:
    """Return T_a [s]: 0 for an element that does not move before uplift, else of small motions on its joints."""
    frequency = elastic_frequency(branch)
    return 1.0 / frequency if frequency else 0.0


def period_ratio(branch: Branch, context: Context) -> float:
    """Return T_a / T_1 [-]; 1, the worst, for an element that vibrates where the building is not known."""
    T_a = element_period(branch)
    if T_a == 0.0 or context.building is None:
        return RESONANCE if T_a > 0.0 else 0.0
    return T_a / context.building.period


def height_ratio(context: Context) -> float:
    """Return z / H of the supports [-]: 0 where the building is not known, and at most 1.

    At the ground H plays no part; above the building the check may only fail.
    """
    if context.building is None:
        return 0.0
    return min(context.support_height / context.building.height, 1.0)


def amplification(ratio: float, context: Context) -> float:
    """Return S_a / (alpha S) = 3 (1 + z/H) / (1 + (1 - T_a/T_1)^2) - 0.5, at least 1 (4.25).

    Parameters
    ----------
    ratio : T_a / T_1 [-]
    context : height of the supports and of the building

    Returns
    -------
    float [-]
    """
    return ec8_floor_factor(height_ratio(context), building_height=1.0, period_ratio=ratio)


def force_over_weight(S_a: float, *, behaviour_factor: float, importance_factor: float) -> float:
    """Return F_a / W_a = S_a gamma_a / q_a (4.24).

    Parameters
    ----------
    S_a : seismic coefficient [-]
    behaviour_factor : q_a [-]
    importance_factor : gamma_a [-]

    Returns
    -------
    float [-]
    """
    return S_a * importance_factor / behaviour_factor


def uplift_pga(branch: Branch, amplified: float) -> float | None:
    """Return the PGA at which S_a reaches the multiplier at rest.

    Parameters
    ----------
    branch : the direction of rocking
    amplified : S_a over PGA [-]

    Returns
    -------
    float or None
        PGA [m/s2]; None without a threshold.
    """
    at_rest = threshold(branch)
    return None if at_rest is None else at_rest * g / amplified
