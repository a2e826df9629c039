"""Fragility for the terminal and as CSV."""

from __future__ import annotations

from collections.abc import Iterator

from assess.cli.tables.messages import messages_text
from assess.cli.tables.text_table import text_table
from assess.messages.message import UNITS, Message, locate
from assess.results.fragility import (
    CurveName,
    FragilityCurve,
    FragilityResults,
    LognormalResult,
    MeasureResult,
    MechanismFragility,
    RiskResult,
    StateResult,
)
from reports.render.csv import csv_lines

HEADER = ["mechanism", "state", "measure", "median", "95 %", "dispersion", "95 %"]
RISK_HEADER = [
    "mechanism",
    "state",
    "curve",
    "rate [1/year]",
    "at most",
    "in 50 years",
    "with epistemic",
    "target",
    "outcome",
]
OUTCOMES = {None: "", "pass": "within", "fail": "more", "incomplete": "not known"}


def table_text(results: FragilityResults) -> str:
    """Write median and dispersion of each curve, the rates where the hazard is known, and the messages."""
    rows = [_row(each, curve) for each in results.mechanisms for curve in each.curves]
    risks = [_risk_row(each, risk) for each in results.mechanisms for risk in each.risks]
    tables = [text_table(HEADER, rows)] if rows else ["no mechanism has a fragility curve\n"]
    if risks:
        tables.append(text_table(RISK_HEADER, risks))
    notes = (each for mechanism in results.mechanisms for each in mechanism.notes)
    said = (note for each in results.mechanisms for note in _notes(each))
    return "\n".join(tables) + messages_text((*results.warnings, *notes, *said))


def _notes(mechanism: MechanismFragility) -> Iterator[Message]:
    """Yield what is told of the curves and of the rates, once for all measures that it is told of."""
    told: list[tuple[StateResult, Message, list[str]]] = []
    found: tuple[FragilityCurve | RiskResult, ...] = (*mechanism.curves, *mechanism.risks)
    for one in found:
        for note in one.notes:
            measures = next((each[2] for each in told if each[:2] == (one.state, note)), None)
            if measures is None:
                told.append((one.state, note, measures := []))
            measures.append(measure_name(one.measure))
    for state, note, measures in told:
        yield from locate([note], f"mechanisms.{mechanism.name}, {state_name(state)} by {', '.join(measures)}")


def _row(mechanism: MechanismFragility, curve: FragilityCurve) -> list[str]:
    fitted, unit = curve.lognormal, UNITS[curve.measure.dimension]
    head = [mechanism.name, state_name(curve.state), measure_name(curve.measure)]
    if fitted is None:
        return [*head, "none", *[""] * 3]
    median = f"{fitted.median:.3g}" + ("" if unit == "-" else f" {unit}")
    return [
        *head,
        median,
        _interval(fitted.median_interval),
        f"{fitted.dispersion:.2f}",
        _interval(fitted.dispersion_interval),
    ]


def _interval(found: tuple[float, float] | None) -> str:
    return "" if found is None else f"{found[0]:.3g} to {found[1]:.3g}"


def _risk_row(mechanism: MechanismFragility, risk: RiskResult) -> list[str]:
    target = "" if risk.target_rate is None else f"{risk.target_rate:.3g}"
    rate, probability = f"{risk.annual_rate:.2g}", f"{100.0 * risk.probability_50_years:.2g} %"
    most = "no bound" if risk.at_most is None else f"{risk.at_most:.2g}"
    wide = "not given" if risk.with_epistemic is None else f"{risk.with_epistemic:.2g}"
    head = [mechanism.name, state_name(risk.state), risk.curve, rate, most, probability, wide]
    return [*head, target, OUTCOMES[risk.outcome]]


def state_name(state: StateResult) -> str:
    """Return a state in words of the project file."""
    return state.name if state.share is None else f"{state.share:g} of overturning"


def measure_name(measure: MeasureResult) -> str:
    """Return a measure as the project names it, with the place where that is not the ground."""
    periods = f"({measure.periods_s[0]:g} s)" if measure.key == "sa" else ""
    return f"{measure.key}{periods}" + (" at the base" if measure.at == "base" else "")


def csv_text(results: FragilityResults) -> str:
    """Write a line for each curve, at full precision: its lognormals with their intervals, and its rates."""
    header: list[str | float | None] = ["mechanism", "state", "share", "measure", "at", "period [s]", "unit"]
    header += ["records", "events", "censored", "median", "median low", "median high", "dispersion"]
    header += ["dispersion low", "dispersion high", "first median", "first dispersion"]
    kinds = ("rate", "lognormal rate", "first rate")
    header += [f"{kind}{which} [1/year]" for which in ("", " with epistemic") for kind in kinds]
    rows = [_csv_row(each, curve) for each in results.mechanisms for curve in each.curves]
    return csv_lines([header, *rows])


def _csv_row(mechanism: MechanismFragility, curve: FragilityCurve) -> list[str | float | None]:
    measure = curve.measure
    period = measure.periods_s[0] if measure.key == "sa" else None
    risks = [_risk(mechanism, curve, name) for name in ("empirical", "lognormal", "first")]
    rates = [None if each is None else each.annual_rate for each in risks]
    rates += [None if each is None else each.with_epistemic for each in risks]
    first = (None, None) if curve.first is None else (curve.first.median, curve.first.dispersion)
    head = [mechanism.name, curve.state.name, curve.state.share, measure.key, measure.at, period]
    counts = [curve.records, curve.events, curve.censored]
    return [*head, UNITS[measure.dimension], *counts, *_numbers(curve.lognormal), *first, *rates]


def _numbers(fitted: LognormalResult | None) -> list[float | None]:
    if fitted is None:
        return [None] * 6
    median, dispersion = fitted.median_interval or (None, None), fitted.dispersion_interval or (None, None)
    return [fitted.median, *median, fitted.dispersion, *dispersion]


def _risk(mechanism: MechanismFragility, curve: FragilityCurve, name: CurveName) -> RiskResult | None:
    same = (curve.measure, curve.state, name)
    return next((each for each in mechanism.risks if (each.measure, each.state, each.curve) == same), None)
