"""The scan of one mechanism over rising PGA.

The PGA of the target rises in steps of SCAN_STEP until records overturn the mechanism in more than 84 % of the draws
among their runs. The scan gives the curve of the response-history method and its PGA at collapse. On joints that
vibrate about rest a history takes ten times as many steps of integration, so there the scan has half as many levels.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import log

from scipy.constants import g

from assess.codes.numerical_spread import LOW, share_upright
from assess.codes.suite import Suite
from assess.oscillator import linear_multiplier
from assess.study.history_levels import level_solver, suites_of
from assess.study.motions import ScaledRecord
from assess.study.rocking_case import RockingCase, vibrates

SCAN_STEP, JOINTS_STEP = 1.025, 1.05  # ratio of two PGAs of the scan, and where joints vibrate about rest
SCAN_START = 0.4  # of the smaller uplift acceleration, or of what a flexible joint resists at most
MOST_LEVELS, MOST_ON_JOINTS = 204, 102


def scan_levels(
    case: RockingCase, motions: Sequence[ScaledRecord], *, site_pga: float, threads: int
) -> tuple[Suite, ...]:
    """Run suites at rising PGA, up to the first one in which so many draws overturn that no rule can hold in 16 %.

    Parameters
    ----------
    case : RockingCase
        The oscillator and the motions at its base.
    motions : sequence of ScaledRecord
        The records with their factors, in the order of `case.base`.
    site_pga : float
        PGA of the target that the factors refer to [m/s2].
    threads : int
        Number of threads; 0 for all cores.

    Returns
    -------
    tuple of Suite
        At rising PGA, the last one that which ends the scan.
    """
    strongest = max(m.scaling.factor * at.record.pga for m, at in zip(motions, case.base, strict=True)) / site_pga
    uplift = g * min(linear_multiplier(branch) for branch in case.oscillator.branches)
    start = SCAN_START * uplift / max(1.0, strongest)
    step, most = (JOINTS_STEP, MOST_ON_JOINTS) if vibrates(case.oscillator) else (SCAN_STEP, MOST_LEVELS)
    solve = level_solver(case, motions, site_pga=site_pga, threads=threads)
    below = round(log(1.0 / SCAN_START) / log(step))  # levels short of uplift, which do not overturn
    suites = list(suites_of(solve([start * step**k for k in range(below)], "where they matter")))
    for k in range(below, most):
        suites += suites_of(solve([start * step**k], "where they matter"))
        if share_upright(suites[-1]) < LOW:
            break
    return tuple(suites)
