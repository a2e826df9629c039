"""A limit state of the Italian codes: the spectrum it is checked on, its PGA, and the safety index of its capacity.

Where the site gives its hazard over return periods, each limit state has a spectrum and a PGA of its own, and a level
multiplies them all alike: level / PGA of the site. Elsewhere every limit state is checked at the PGA of the level.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import exp, log

import numpy as np
from scipy.constants import g

from assess.codes.check import Bound, Check, Step, step
from assess.codes.context import Context, Hazard
from assess.codes.italian.confidence import Confidence, confidence_factors, mark_informative
from assess.codes.italian.curves import Curves, curves_of
from assess.codes.italian.edition import Edition, Options
from assess.codes.worst_branch import worst_branch_check
from assess.oscillator import Oscillator
from spectra.spectrum import Spectrum

INDEX_CLAUSE = "NTC 8.3"
HAZARD_CLAUSE = "NTC Annex A"


@dataclass(frozen=True)
class Case:
    """One branch of a mechanism in a limit state at one level, with one confidence factor.

    context : with the spectrum of the limit state; level : of the project [m/s2]
    pga : of the limit state at that level [m/s2]; pga_step : how it follows from the level
    """

    curves: Curves
    confidence: Confidence
    state: str
    context: Context
    level: float
    pga: float
    pga_step: Step

    @property
    def at_ultimate(self) -> Case:
        """Return the case with the curves of an ultimate limit state."""
        return replace(self, curves=self.curves.at_ultimate)


OneCase = Callable[[Case], Check]


def check_each_limit_state(
    oscillator: Oscillator,
    context: Context,
    edition: Edition,
    options: Options,
    *,
    known: tuple[str, ...],
    one: OneCase,
) -> tuple[Check, ...]:
    """Return the check of the worse branch for each limit state that is known and asked for, and each level.

    Checks with the confidence factor that decides come first, then those with one for comparison.
    """
    branches, states = curves_of(oscillator, context), options.among(known)
    checks: list[Check] = []
    known_level = context.knowledge.get(edition.code)
    for confidence in confidence_factors(options, crushing=context.crushing, level=known_level):
        for state in states:
            for level in context.levels:
                cases = [case_of(curves, confidence, context, state=state, level=level) for curves in branches]
                checks.append(mark_informative(worst_branch_check([one(case) for case in cases]), confidence))
    return tuple(checks)


def case_of(curves: Curves, confidence: Confidence, context: Context, *, state: str, level: float) -> Case:
    """Return the case on the spectrum of its limit state, or on that of the site at the level's PGA."""
    own = own_spectrum(context.hazard, state)
    used = context if own is None else replace(context, spectrum=own)
    pga = level * pga_ratio(context.hazard, context.spectrum, state)
    line = pga_step(context, state=state, level=level, pga=pga)
    return Case(curves, confidence, state, used, level, pga, line)


def own_spectrum(hazard: Hazard | None, state: str) -> Spectrum | None:
    """Return the spectrum of a limit state; None where the site does not give it."""
    return None if hazard is None else hazard.spectra.get(state)


def pga_ratio(hazard: Hazard | None, spectrum: Spectrum, state: str) -> float:
    """Return the PGA of a limit state over that of the site's `spectrum` [-]; 1 where it has none of its own."""
    own = own_spectrum(hazard, state)
    return 1.0 if own is None else own.pga / spectrum.pga


def pga_step(context: Context, *, state: str, level: float, pga: float) -> Step:
    """Write the PGA of a limit state at a level."""
    own, symbol = own_spectrum(context.hazard, state), f"PGA_{state}"
    if own is None:
        remark = "" if context.hazard is None else "no hazard of this limit state"
        said, given = "peak ground acceleration, that of the level", {"PGA_L": (level, "m/s2")}
        return step(symbol, said, HAZARD_CLAUSE, "PGA_L", pga, "m/s2", given=given, remark=remark)
    said = "peak ground acceleration of the limit state: the level multiplies every limit state"
    given = {"PGA_L": (level, "m/s2"), f"S a_g,{state}": (own.pga, "m/s2"), "PGA": (context.spectrum.pga, "m/s2")}
    return step(symbol, said, HAZARD_CLAUSE, f"PGA_L · S a_g,{state} / PGA", pga, "m/s2", given=given)


def add_safety_index(check: Check, context: Context) -> Check:
    """Return the check with its safety index zeta_E, capacity over demand as PGA, and its return period."""
    capacity = check.capacity_pga_g
    if capacity is None:
        return check
    demanded = check.level_pga_g * pga_ratio(context.hazard, context.spectrum, check.limit_state)
    index, given = capacity / demanded, {"PGA_C": (capacity, "g"), "PGA": (demanded, "g")}
    words = "safety index of the limit state: PGA at capacity over PGA demanded"
    line = step("ζ_E", words, INDEX_CLAUSE, "PGA_C / PGA", index, given=given)
    indexed = replace(check, safety_index=index, steps=(*check.steps, line))
    return indexed if context.hazard is None else _with_years(indexed, context.hazard, capacity)


def _with_years(check: Check, hazard: Hazard, capacity_g: float) -> Check:
    years, bound = return_period(hazard, capacity_g * g)
    line = _years_step(hazard, capacity_g * g, years, bound)
    return replace(check, return_period_years=years, return_period_bound=bound, steps=(*check.steps, line))


def _years_step(hazard: Hazard, pga: float, years: float, bound: Bound) -> Step:
    """Write the return period of a capacity [m/s2]: between two rows of the hazard, or at its first or last one."""
    symbol, words = "T_R,C", "return period of the capacity"
    rows = rows_around(hazard, pga)
    if rows is None:
        ends = {"<=": "or less: the hazard begins there", ">=": "or more: the hazard ends there"}
        at = {"PGA_C": (pga, "m/s2"), "T_R": (years, "years")}
        formula = "first or last row of the hazard"
        return step(
            symbol, words, HAZARD_CLAUSE, formula, years, "years", remark=ends.get(bound, ""), bound=bound, at=at
        )
    low, high = rows
    given = {
        "T_1": (hazard.return_period[low], "years"),
        "T_2": (hazard.return_period[high], "years"),
        "PGA_C": (pga, "m/s2"),
        "PGA_1": (float(np.maximum.accumulate(hazard.pga)[low]), "m/s2"),
        "PGA_2": (float(np.maximum.accumulate(hazard.pga)[high]), "m/s2"),
    }
    formula = "exp(ln(T_1) + ln(PGA_C / PGA_1) / ln(PGA_2 / PGA_1) ln(T_2 / T_1))"
    remark = "linear in logarithms between the neighbouring rows of the hazard"
    return step(symbol, words, HAZARD_CLAUSE, formula, years, "years", given=given, remark=remark)


def rows_around(hazard: Hazard, pga: float) -> tuple[int, int] | None:
    """Return the rows between which the site first reaches a PGA [m/s2]; None before the first and after the last."""
    reached = np.maximum.accumulate(hazard.pga)
    above = int(np.searchsorted(reached, pga))
    return None if above in (0, reached.size) else (above - 1, above)


def return_period(hazard: Hazard, pga: float) -> tuple[float, Bound]:
    """Return the least return period at which the site reaches a PGA, linear in logarithms between rows.

    Beyond the rows it is that of the first or the last one, and a bound. On soft soils S a_g may fall while a_g
    rises, so the least is not the only one.

    Parameters
    ----------
    hazard : of the site
    pga : [m/s2]

    Returns
    -------
    tuple of float and Bound
        Return period [years], and "<=" or ">=" where it is a bound, else "".
    """
    reached = np.maximum.accumulate(hazard.pga)
    above = int(np.searchsorted(reached, pga))
    if above == 0:
        return hazard.return_period[0], "<=" if pga < reached[0] else ""
    if above == reached.size:
        return hazard.return_period[-1], ">="
    between = log(pga / reached[above - 1]) / log(reached[above] / reached[above - 1])
    low, high = hazard.return_period[above - 1 : above + 1]
    return exp(log(low) + between * log(high / low)), ""
