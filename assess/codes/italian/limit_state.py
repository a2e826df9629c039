"""A limit state of the Italian codes: the spectrum it is checked on, its PGA, and what the capacity is worth there.

Where the site gives its hazard over return periods, each limit state has a spectrum and a PGA of its own, and a level
multiplies them all alike: level / PGA of the site. Elsewhere every limit state is checked at the PGA of the level.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from math import exp, log

import numpy as np
from scipy.constants import g

from assess.codes.check import Bound, BranchName, Check, Step
from assess.codes.context import Context, Hazard
from assess.codes.governing import governing
from assess.oscillator import Branch, Oscillator
from spectra.spectrum import Spectrum

INDEX_CLAUSE = "NTC 2018 8.4"
HAZARD_CLAUSE = "NTC Annex A"


@dataclass(frozen=True)
class Case:
    """One branch of a mechanism in a limit state at one level.

    context : with the spectrum of the limit state; level : of the project [m/s2]
    pga : of the limit state at that level [m/s2]; pga_step : how it follows from the level
    """

    oscillator: Oscillator
    branch: Branch
    name: BranchName
    state: str
    context: Context
    level: float
    pga: float
    pga_step: Step

    @property
    def mass(self) -> float:
        """Total moved mass [kg]."""
        return self.oscillator.mass


OneCase = Callable[[Case], Check]


def at_each(oscillator: Oscillator, context: Context, states: Iterable[str], one: OneCase) -> tuple[Check, ...]:
    """For each limit state and level the worse branch by `one`."""
    checks: list[Check] = []
    for state in states:

        def of(branch: Branch, name: BranchName, level: float, state: str = state) -> Check:
            return one(case_of(oscillator, branch, name, context, state=state, level=level))

        checks.extend(governing(oscillator, context.levels, of))
    return tuple(checks)


def case_of(
    oscillator: Oscillator, branch: Branch, name: BranchName, context: Context, *, state: str, level: float
) -> Case:
    """The case on the spectrum of its limit state, or on that of the site at the level's PGA."""
    own = own_spectrum(context.hazard, state)
    used = context if own is None else replace(context, spectrum=own)
    pga = level * share(context.hazard, context.spectrum, state)
    step = pga_step(context, state=state, level=level, pga=pga)
    return Case(oscillator, branch, name, state, used, level, pga, step)


def own_spectrum(hazard: Hazard | None, state: str) -> Spectrum | None:
    """The spectrum of a limit state, None where the site does not give it."""
    return None if hazard is None else hazard.spectra.get(state)


def share(hazard: Hazard | None, spectrum: Spectrum, state: str) -> float:
    """PGA of a limit state over that of the site's `spectrum` [-]; 1 where the limit state has none of its own."""
    own = own_spectrum(hazard, state)
    return 1.0 if own is None else own.pga / spectrum.pga


def pga_step(context: Context, *, state: str, level: float, pga: float) -> Step:
    """The PGA of a limit state at a level, as the calculation sheets print it."""
    own, symbol = own_spectrum(context.hazard, state), f"PGA_{state}"
    if own is None:
        said = "no hazard of this limit state: the level's" if context.hazard is not None else "the level's"
        return Step(
            symbol, f"peak ground acceleration, {said}", HAZARD_CLAUSE, "level", f"{level / g:.5g} g", pga, "m/s2"
        )
    said = f"peak ground acceleration of {state}: the level multiplies every limit state"
    numbers = f"{level:.5g} · {own.pga:.5g} / {context.spectrum.pga:.5g}"
    return Step(symbol, said, HAZARD_CLAUSE, f"level · PGA_{state} / PGA of the site", numbers, pga, "m/s2")


def rated_on_hazard(checks: tuple[Check, ...], context: Context) -> tuple[Check, ...]:
    """The `checks` of the older edition: rated where the site gives its hazard."""
    return checks if context.hazard is None else tuple(rated(check, context) for check in checks)


def rated(check: Check, context: Context) -> Check:
    """The check with its safety index zeta_E, capacity over demand as PGA, and the return period of its capacity."""
    capacity = check.capacity_pga_g
    if capacity is None:
        return check
    demanded = check.level_pga_g * share(context.hazard, context.spectrum, check.limit_state)
    index = capacity / demanded
    numbers = f"{capacity:.5g} / {demanded:.5g}"
    words = f"safety index at {check.limit_state}: PGA at capacity over PGA demanded"
    step = Step("ζ_E", words, INDEX_CLAUSE, "PGA_C / PGA", numbers, index, "-")
    indexed = replace(check, safety_index=index, steps=(*check.steps, step))
    return indexed if context.hazard is None else _with_years(indexed, context.hazard, capacity)


def _with_years(check: Check, hazard: Hazard, capacity_g: float) -> Check:
    years, bound = return_period(hazard, capacity_g * g)
    ends = {
        "<=": f", or less: the hazard begins at {years:.4g} years",
        ">=": f", or more: the hazard ends at {years:.4g} years",
    }
    words = f"return period of the capacity{ends.get(bound, '')}"
    formula, numbers = "log T_R linear in log PGA between rows of the hazard, S a_g", f"PGA_C = {capacity_g:.5g} g"
    step = Step("T_R,C", words, HAZARD_CLAUSE, formula, numbers, years, "years", bound)
    return replace(check, return_period_years=years, return_period_bound=bound, steps=(*check.steps, step))


def return_period(hazard: Hazard, pga: float) -> tuple[float, Bound]:
    """The least return period [years] at which the site reaches a PGA [m/s2], between rows linear in logarithms.

    Beyond the rows of the hazard it is that of the first or the last one, and a bound: "<=" or ">=". On soft soils
    S a_g may fall while a_g rises, so the least is not the only one.
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
