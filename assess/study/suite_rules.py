"""The rules of codes for suites of records: over which periods, and for which spectrum.

One suite serves the whole building, so the range reaches the slowest of all its mechanisms.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Protocol

from assess.codes.families import SUITE_CODES, uses_histories
from assess.codes.ntc2018.clauses import ULTIMATE
from assess.codes.verdict import methods_of
from assess.mechanisms.mechanism import Mechanism
from assess.study.periods import equivalent_periods, extreme_periods, limit_state_periods
from assess.study.study import Study
from assess.study.verdict import states_of
from records.compliance import asce43_05, ntc2018
from records.compliance.registry import Requirements
from records.compliance.suite import FINE
from records.synthetic import BAND
from spectra.spectrum import Spectrum

Range = tuple[float, float]

HELD = 3.0  # artificial records hold periods up to their duration over this, well within what can be fitted


class FittedRange(Protocol):
    """The range of periods over which artificial records have to fit the target [s]."""

    def __call__(self, *, longest: float) -> Range:
        """Return the range for the longest period of the mechanisms [s]."""


class PeriodsOf(Protocol):
    """The periods at the limit state, used as T_1 in the clauses of a code [s]."""

    def __call__(self, study: Study) -> Range:
        """Return the shortest and the longest of all mechanisms."""


@dataclass(frozen=True)
class SuiteRules:
    """The rules of one code: its requirements, the range of periods to be fitted, and the periods of the mechanisms."""

    code: str
    requirements: Requirements
    fitted: FittedRange
    periods: PeriodsOf


def at_allowable(study: Study) -> Range:
    """Return the periods of equal work at half the overturning rotation [s], for ASCE 43-05."""
    return extreme_periods(equivalent_periods(study.mechanisms))


def at_limit_state(study: Study) -> Range:
    """Return T_SLV or T_SLC, and the building's T_1 if a mechanism is above the ground [s], for NTC 2018."""
    state = deciding_state(study)
    low, high = extreme_periods(limit_state_periods(study.mechanisms, state=state))
    if study.building is None or not any(is_above_ground(each, study) for each in study.mechanisms):
        return low, high
    return min(low, study.building.period), max(high, study.building.period)


def is_above_ground(mechanism: Mechanism, study: Study) -> bool:
    """Return whether the base of a mechanism is above the ground, even if only on a plinth."""
    return study.grounded[mechanism.name].base > 0.0


def deciding_state(study: Study) -> str:
    """Return the ultimate limit state that decides by the Italian code; SLV if another code decides."""
    return next((state for state in states_of(study.question) if state in ULTIMATE), "SLV")


RULES: Mapping[str, SuiteRules] = {
    "asce43-05": SuiteRules(asce43_05.CODE, asce43_05.requirements, asce43_05.fit_periods, at_allowable),
    "ntc2018": SuiteRules(ntc2018.CODE, ntc2018.requirements, ntc2018.fit_periods, at_limit_state),
}
"""By the code of a procedure, as `assess.codes.families.CODES` names it."""


def codes_of_histories(study: Study) -> tuple[str, ...]:
    """Return the codes whose procedures by histories are requested."""
    return tuple(dict.fromkeys(SUITE_CODES[name] for name in study.procedures if uses_histories(name)))


def codes_that_decide(study: Study) -> tuple[str, ...]:
    """Return the codes whose procedures by histories may decide; if none may, those requested."""
    deciding = [SUITE_CODES[name] for name in methods_of(study.question) if uses_histories(name)]
    return tuple(dict.fromkeys(deciding)) or codes_of_histories(study)


def spectrum_of_rules(code: str, study: Study, spectrum: Spectrum) -> Spectrum:
    """Return the target of a suite: for the Italian code, the spectrum of the limit state that decides, if known.

    Parameters
    ----------
    code : str
        Of a procedure, as in `RULES`.
    study : Study
        The hazard and what decides.
    spectrum : Spectrum
        The site's.
    """
    if code != "ntc2018" or study.hazard is None:
        return spectrum
    return study.hazard.spectra.get(deciding_state(study), spectrum)


def made_band(study: Study, spectrum: Spectrum, *, duration: float) -> Range:
    """Return the range of periods over which artificial records are made to fit [s]: as the rules require, if possible.

    A record holds periods up to a share of its duration; further than the target or 10 s nothing is compared.

    Parameters
    ----------
    study : Study
        The mechanisms, and the codes that decide.
    spectrum : Spectrum
        The target.
    duration : float
        Of the records [s].
    """
    ranges = [RULES[code].fitted(longest=RULES[code].periods(study)[1]) for code in codes_that_decide(study)]
    longest = max([BAND[1], *(high for _, high in ranges)])
    return BAND[0], min(longest, duration / HELD, float(FINE[-1]), spectrum.longest_period)
