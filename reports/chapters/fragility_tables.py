"""The tables of a report on fragility."""

from __future__ import annotations

from collections.abc import Iterator

from assess.results.fragility import (
    FragilityCurve,
    FragilityResults,
    LognormalResult,
    MeasureComparison,
    MechanismFragility,
    RecordRuns,
    RiskResult,
    Trend,
)
from reports.chapters import fragility_words as words
from reports.document import Cell, Column, Graded, Table
from reports.language.texts import Text, Verbatim, quantity, say
from reports.measures import (
    FIGURES,
    PERCENT,
    RATE_FIGURES,
    curves_by,
    first_measure,
    intensity,
    last_state,
    main_curve,
    main_risk,
    measure_text,
    state_text,
    unit_intensity,
)

MECHANISM, STATE, MEASURE = Column(say("Mechanism")), Column(say("State")), Column(say("Measure"))
FIVE, HALF = Column(say("5 % of records")), Column(say("50 % of records (median)"))
DISPERSION = Column(say("Dispersion β"))
RATE = Column(say("Annual rate"), "annual rate", RATE_FIGURES)
PROBABILITY = Column(say("In 50 years"), "percent", RATE_FIGURES)
TARGET = Column(say("Target rate"), "annual rate", FIGURES)
BEYOND = Column(say("Beyond the hazard"), "annual rate", RATE_FIGURES)
ABOVE_RUNS = Column(say("Above the runs"), "annual rate", RATE_FIGURES)
WITH_EPISTEMIC = Column(say("With epistemic dispersion"), "annual rate", RATE_FIGURES)
RISK = (STATE, MEASURE, Column(say("Curve")), RATE, PROBABILITY, TARGET, BEYOND, ABOVE_RUNS)
SIGNIFICANT = 0.05
MOST = 6
"""Islands on a page; the tables of the spreadsheet have all."""


def numbered_name(results: FragilityResults, mechanism: MechanismFragility) -> Verbatim:
    """Return number and title of a mechanism: "M1 Front wall"."""
    return Verbatim(f"{number_of(results, mechanism)} {mechanism.label or mechanism.name}")


def number_of(results: FragilityResults, mechanism: MechanismFragility) -> str:
    """Return the number of a mechanism: "M1"."""
    return f"M{[each.name for each in results.mechanisms].index(mechanism.name) + 1}"


def overview(results: FragilityResults) -> Table:
    """Tabulate what is found of every mechanism in its last state, with the rate beside the target."""
    risks = [main_risk(each) for each in results.mechanisms]
    with_rate, with_target = any(risks), any(risk is not None and risk.target_rate is not None for risk in risks)
    columns = [MECHANISM, MEASURE, FIVE, HALF, DISPERSION, *([RATE, PROBABILITY] if with_rate else [])]
    columns += [WITH_EPISTEMIC, TARGET, Column(say("Outcome"))] if with_target else []
    rows = tuple(tuple(_overview(results, each))[: len(columns)] for each in results.mechanisms)
    caption = say("Every mechanism: intensity at which 5 % and 50 % of the records overturn it, with 95 % intervals.")
    if any(state is not None and state.name != "overturning" for state in map(last_state, results.mechanisms)):
        caption = say("Every mechanism: intensity at which 5 % and 50 % of the records bring it to its last state.")
    return Table("fragility", caption, tuple(columns), rows, small=True)


OUTCOMES = {
    "pass": Graded("pass", say("within the target")),
    "fail": Graded("fail", say("more than the target")),
}
ONLY_WITH = Graded("fail", say("more than the target with the epistemic dispersion"))
GAPS = {
    "motion": Graded("incomplete", say("not known: ground motion at a height")),
    "runs": Graded("incomplete", say("not known: the runs end too soon")),
    "hazard": Graded("incomplete", say("not known: the hazard ends too soon")),
    "epistemic": Graded("incomplete", say("not known: no epistemic dispersion")),
}


def _overview(results: FragilityResults, mechanism: MechanismFragility) -> Iterator[Cell]:
    measure, curve, risk = first_measure(mechanism), main_curve(mechanism), main_risk(mechanism)
    yield numbered_name(results, mechanism)
    yield None if measure is None else measure_text(measure)
    yield from (None, None, None) if curve is None else _fitted(curve)
    yield None if risk is None else risk.annual_rate
    yield None if risk is None else PERCENT * risk.probability_50_years
    yield None if risk is None else risk.with_epistemic
    yield None if risk is None else risk.target_rate
    yield None if risk is None or risk.outcome is None else _graded(risk)


def _graded(risk: RiskResult) -> Graded:
    """Return the outcome of a rate beside its target, with what is missing."""
    if risk.outcome == "incomplete" and risk.gap is not None:
        return GAPS[risk.gap]
    if risk.outcome == "fail" and risk.gap == "epistemic":
        return ONLY_WITH
    return OUTCOMES[risk.outcome or "pass"]


def _fitted(curve: FragilityCurve) -> tuple[Cell, Cell, Cell]:
    """Return the cells of a lognormal: 5 %, median and dispersion with their intervals."""
    fitted = curve.lognormal
    if fitted is None:
        return say("not bounded"), say("not bounded"), None
    five = words.value_with_interval(fitted.five_percent, fitted.five_percent_interval, curve.measure)
    half = words.value_with_interval(fitted.median, fitted.median_interval, curve.measure)
    return five, half, words.dispersion_text(fitted)


def curves(mechanism: MechanismFragility, name: str) -> Table:
    """Tabulate the curves of a mechanism by its first measure, a row for each state."""
    measure = first_measure(mechanism)
    dimension = "ratio" if measure is None else measure.dimension
    low, high = say("from"), say("to")
    columns = (
        STATE,
        *(Column(label, dimension, FIGURES) for label in (say("5 %"), low, high, say("50 %"), low, high)),
        *(Column(label, "ratio", 2) for label in (DISPERSION.label, low, high)),
        Column(say("Bound, median"), dimension, FIGURES),
        Column(Verbatim("n")),
        Column(say("Not reached")),
    )
    found = curves_by(mechanism, measure)
    rows = tuple(
        (
            state_text(curve.state),
            *((None,) * 9 if curve.lognormal is None else lognormal_numbers(curve.lognormal)),
            None if curve.first is None else curve.first.median,
            curve.records,
            curve.censored,
        )
        for curve in found
    )
    caption = say(
        "Lognormal curves by {measure}: where 5 % and 50 % of n records reach the state, with 95 % intervals "
        "(from, to) by bootstrap of the earthquakes. Bound: of the first intensity that reaches it. Not reached: "
        "records that do not reach it at their largest scale.",
        measure=say("no measure") if measure is None else measure_text(measure),
    )
    return Table(name, caption, columns, rows, small=True)


def lognormal_numbers(fitted: LognormalResult) -> Iterator[Cell]:
    """Yield 5 %, median and dispersion of a lognormal, each followed by the ends of its interval."""
    for value, ends in (
        (fitted.five_percent, fitted.five_percent_interval),
        (fitted.median, fitted.median_interval),
        (fitted.dispersion, fitted.dispersion_interval),
    ):
        yield value
        yield from ends or (None, None)


def comparison(mechanism: MechanismFragility, name: str) -> Table:
    """Compare the measures in the last state by dispersion, and by the trends of what is left."""
    state = last_state(mechanism)
    columns = (
        MEASURE,
        Column(say("Dispersion β"), "ratio", 2),
        *(Column(label) for label in (say("Trend on magnitude"), say("on ln distance"), say("on ln scale factor"))),
    )
    rows = tuple(_compared(each) for each in mechanism.comparison if each.state == state)
    caption = say(
        "How well each measure explains {state}: the less the dispersion, the better. Trends: slope of what is left, "
        "with its p-value; significant below 0.05, where the measure misses what the records differ in.",
        state=say("no state") if state is None else state_text(state),
    )
    return Table(name, caption, columns, rows, small=True)


def _compared(each: MeasureComparison) -> tuple[Cell, ...]:
    found = {trend.on: trend for trend in each.trends}
    trends = (trend_text(found.get(on)) for on in ("magnitude", "distance", "scale"))
    return measure_text(each.measure), each.dispersion, *trends


def trend_text(trend: Trend | None) -> Text | None:
    """Return a trend with its p-value and whether it is significant, in words; None where it is not known."""
    if trend is None:
        return None
    values = {"slope": quantity(trend.slope, figures=2), "p": quantity(trend.p_value, figures=2)}
    if trend.p_value < SIGNIFICANT:
        return say("{slope}, p = {p}: significant", **values)
    return say("{slope}, p = {p}: not significant", **values)


def islands(mechanism: MechanismFragility, name: str, *, most: int | None = None) -> Table:
    """Tabulate the islands of the records. most: rows; all of them if None."""
    measure = first_measure(mechanism)
    columns = (
        Column(say("Record")),
        Column(say("Earthquake")),
        Column(say("Stands again from scale"), "ratio", FIGURES),
        Column(say("To scale"), "ratio", FIGURES),
        Column(say("Intensity")),
    )
    rows = []
    for run in mechanism.runs:
        unit = None if measure is None else unit_intensity(mechanism, measure, run)
        for low, high in run.islands:
            over = None if unit is None or measure is None else say(
                "{measure} {low} to {high}",
                measure=measure_text(measure),
                low=intensity(low * unit, measure),
                high=intensity(high * unit, measure),
            )  # fmt: skip
            rows.append((Verbatim(run.record), Verbatim(run.event), low, high, over))
    shown = tuple(rows[:most])
    caption = say("Islands: scales at which a record leaves it standing although a lower one overturns it.")
    if len(shown) < len(rows):
        caption = say(
            "Islands, the first {shown} of {all}: scales at which a record leaves it standing although a lower one "
            "overturns it.",
            shown=quantity(len(shown)),
            all=quantity(len(rows)),
        )
    return Table(name, caption, columns, shown, small=True)


def risks(mechanism: MechanismFragility, name: str) -> Table:
    """Tabulate the annual rates of a mechanism, a row for each state, measure and curve."""
    spread = any(risk.with_epistemic is not None for risk in mechanism.risks)
    columns = (*RISK, *([WITH_EPISTEMIC] if spread else []))
    rows = tuple(risk_cells(risk)[: len(columns)] for risk in mechanism.risks)
    muted = frozenset(place for place, risk in enumerate(mechanism.risks) if risk.curve == "first")
    caption = say(
        "Annual rates and probabilities in 50 years. Beyond the hazard: what the rate can lack, if every motion "
        "stronger than the last row of the hazard reaches the state. Above the runs: the same of motions within the "
        "hazard that are stronger than any run."
    )
    return Table(name, caption, columns, rows, muted, small=True)


def risk_cells(risk: RiskResult) -> tuple[Cell, ...]:
    """Return the cells of a rate."""
    return (
        state_text(risk.state),
        measure_text(risk.measure),
        words.RATES[risk.curve],
        risk.annual_rate,
        PERCENT * risk.probability_50_years,
        risk.target_rate,
        risk.beyond,
        risk.above_runs,
        risk.with_epistemic,
    )


def records(results: FragilityResults) -> Table:
    """Tabulate the records with event, magnitude, distance and the range of scale over all mechanisms."""
    columns = (
        Column(say("Record"), share=0.3),
        Column(say("Earthquake")),
        Column(say("Magnitude M"), "ratio", 2),
        Column(say("Distance R"), "distance", 3),
        Column(say("Least scale"), "ratio", FIGURES),
        Column(say("Largest scale"), "ratio", FIGURES),
    )
    found: dict[str, list[RecordRuns]] = {}
    for mechanism in results.mechanisms:
        for run in mechanism.runs:
            found.setdefault(run.record, []).append(run)
    rows = tuple(_record(runs) for runs in found.values())
    return Table(
        "fragility-records", say("Records, with the scale factors at which they were run."), columns, rows, small=True
    )


def _record(runs: list[RecordRuns]) -> tuple[Cell, ...]:
    scales = [scale for run in runs for scale in run.scale]
    far = runs[0].distance_km
    return (
        Verbatim(runs[0].record),
        Verbatim(runs[0].event),
        runs[0].magnitude,
        None if far is None else 1000.0 * far,
        min(scales, default=None),
        max(scales, default=None),
    )
