"""Intensity measures and states of fragility in the notation of the field, and which of them a report shows first."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from assess.messages.message import Quantity
from assess.results.fragility import (
    FragilityCurve,
    HazardResult,
    LognormalResult,
    MeasureResult,
    MechanismFragility,
    RecordRunsResult,
    RiskResult,
    StateResult,
)
from reports.language.texts import Phrase, Text, Verbatim, quantity, say

FIGURES = 3

RATE_FIGURES = 2
"""Of rates and their probabilities, which are known no better."""
PERCENT = 100.0

DIMENSION_WORDS: Mapping[str, str] = {"ground acceleration": "acceleration", "velocity": "velocity", "ratio": "ratio"}
"""What tables of each dimension are called."""

SYMBOLS: Mapping[str, str] = {
    "pga": "PGA",
    "pgv": "PGV",
    "pga/(g tan alpha)": "PGA/(g tan α)",
    "p pgv/(g tan alpha)": "p·PGV/(g tan α)",
}
STATES: Mapping[str, Phrase] = {"rocking": say("rocking"), "overturning": say("overturning")}


def measure_text(measure: MeasureResult) -> Text:
    """Return a measure in the usual notation: "PGA", "Sa(0.5 s)", "averaged Sa"; with "at the base" where it is."""
    return say("{measure} at the base", measure=_symbol(measure)) if measure.at == "base" else _symbol(measure)


def state_text(state: StateResult) -> Text:
    """Return a state: "rocking", "50 % of the rotation that overturns", "overturning"."""
    if state.share is None:
        return STATES.get(state.name, Verbatim(state.name))
    return say("{share} of the rotation that overturns", share=percent(state.share))


def intensity(value: float, measure: MeasureResult) -> Quantity:
    """Return an intensity with the unit of its measure."""
    return quantity(value, measure.dimension, FIGURES)


def percent(share: float) -> Quantity:
    """Return a share in percent."""
    return quantity(PERCENT * share, "percent", FIGURES)


def interval(ends: tuple[float, float] | None, dimension: str) -> Text | None:
    """Return an interval: "0.17 g to 0.26 g"; None where there is none."""
    if ends is None:
        return None
    low, high = (quantity(end, dimension, FIGURES) for end in ends)
    return say("{low} to {high}", low=low, high=high)


RATE_CURVES: Mapping[str, Phrase] = {
    "empirical": say("from the shares counted"),
    "lognormal": say("from the lognormal"),
    "first": say("bound, from the first intensity"),
}


def value_with_interval(value: float, ends: tuple[float, float] | None, measure: MeasureResult) -> Text:
    """Return an intensity with its interval in brackets, where it has one."""
    within = interval(ends, measure.dimension)
    shown = intensity(value, measure)
    return shown if within is None else say("{value} ({interval})", value=shown, interval=within)


def dispersion_text(fitted: LognormalResult) -> Text:
    """Return a dispersion with its interval."""
    shown = quantity(fitted.dispersion, figures=2)
    if fitted.dispersion_interval is None:
        return shown
    low, high = (quantity(end, figures=2) for end in fitted.dispersion_interval)
    return say("{value} ({interval})", value=shown, interval=say("{low} to {high}", low=low, high=high))


def measures_of(mechanism: MechanismFragility) -> tuple[MeasureResult, ...]:
    """Return the measures of a mechanism, the one of the project's choice first."""
    return mechanism.measures or tuple(dict.fromkeys(curve.measure for curve in mechanism.curves))


def first_measure(mechanism: MechanismFragility) -> MeasureResult | None:
    """Return the measure that the report shows first: that of the hazard, else the first of the project."""
    found = [risk.measure for risk in mechanism.risks] or list(measures_of(mechanism))
    return found[0] if found else None


def last_state(mechanism: MechanismFragility) -> StateResult | None:
    """Return overturning, or the last state where that was not asked for."""
    found = _states_of(mechanism)
    return next((state for state in found if state.name == "overturning"), found[-1] if found else None)


def curves_by(mechanism: MechanismFragility, measure: MeasureResult | None) -> tuple[FragilityCurve, ...]:
    """Return the curves of a mechanism by one measure, one for each state."""
    return tuple(curve for curve in mechanism.curves if curve.measure == measure)


def main_curve(mechanism: MechanismFragility) -> FragilityCurve | None:
    """Return the curve that the report shows first; None without any."""
    state = last_state(mechanism)
    return next((each for each in curves_by(mechanism, first_measure(mechanism)) if each.state == state), None)


def main_risk(mechanism: MechanismFragility) -> RiskResult | None:
    """Return the risk that the report shows first: by the shares counted if there is one; None without a hazard."""
    state = last_state(mechanism)
    found = sorted(
        (risk for risk in mechanism.risks if risk.state == state and risk.measure == first_measure(mechanism)),
        key=lambda risk: ("empirical", "lognormal", "first").index(risk.curve),
    )
    return found[0] if found else None


def hazard_of(risk: RiskResult, hazards: Sequence[HazardResult]) -> HazardResult | None:
    """Return the hazard that a risk is found with."""
    return next((hazard for hazard in hazards if hazard.measure == risk.measure), None)


def unit_intensity(mechanism: MechanismFragility, measure: MeasureResult, run: RecordRunsResult) -> float | None:
    """Return the intensity of a record at scale 1 by a measure; None where it is not known."""
    known = dict(zip(measures_of(mechanism), run.intensity, strict=False))
    return known.get(measure)


def _symbol(measure: MeasureResult) -> Text:
    if measure.key == "sa" and measure.periods_s:
        return say("Sa({period})", period=quantity(measure.periods_s[0], "time"))
    if measure.key == "sa-average":
        return say("averaged Sa")
    return Verbatim(SYMBOLS.get(measure.key, measure.key))


def _states_of(mechanism: MechanismFragility) -> tuple[StateResult, ...]:
    """Return the states of a mechanism, in the order of its curves."""
    return tuple(dict.fromkeys(curve.state for curve in mechanism.curves))
