"""The equivalent period of a mechanism, used where codes refer to the period of a structure.

A rocking body has no period of its own. It is that of the linear oscillator with the same work at the allowable
rotation of histories, half the overturning rotation: 1/f_e of ASCE 43-05 A.2 (the secant in energy).
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from assess.codes.asce43_05.clauses import HALF, effective_frequency
from assess.codes.italian.curves import curves_of_all_actions
from assess.codes.ntc2018.clauses import capacity_of
from assess.errors import ProjectError
from assess.mechanisms.mechanism import Mechanism
from assess.oscillator import Branch

LARGEST_FC = 1.35  # of LC1, which makes the longest periods
BELOW, ABOVE = 0.2, 1.2  # of the least and the largest equivalent period: range that spectra are fitted over
FITTED_OVER = "0.2 times the least to 1.2 times the largest equivalent period of the mechanisms"


def equivalent_period(branch: Branch) -> float:
    """Return the equivalent period [s] of a branch at the allowable rotation."""
    return float(1.0 / effective_frequency(branch, np.array([HALF * branch.unstable]))[0])


def equivalent_periods(mechanisms: Iterable[Mechanism]) -> dict[str, tuple[float, float]]:
    """Return the shortest and the longest equivalent period [s] of the branches of each mechanism, by name."""
    found = {}
    for mechanism in mechanisms:
        periods = [equivalent_period(branch) for branch in mechanism.variants.deciding.branches]
        found[mechanism.name] = (min(periods), max(periods))
    return found


def limit_state_periods(mechanisms: Iterable[Mechanism], *, state: str) -> dict[str, tuple[float, float]]:
    """Return the shortest and the longest T_SLV or T_SLC [s] of each mechanism (NTC 2018, C8.7.1.10, 11), by name."""
    found = {}
    for mechanism in mechanisms:
        alone = curves_of_all_actions(mechanism.variants.deciding)
        periods = [capacity_of(curves, state=state, confidence_factor=LARGEST_FC).T for curves in alone]
        found[mechanism.name] = (min(periods), max(periods))
    return found


def extreme_periods(periods: dict[str, tuple[float, float]]) -> tuple[float, float]:
    """Return the least and the largest of all periods [s]; raise ProjectError if there are none."""
    if not periods:
        raise ProjectError("mechanisms: none to take periods from; add one, or give records.select periods")
    return min(low for low, _ in periods.values()), max(high for _, high in periods.values())
