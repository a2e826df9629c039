"""The tables of a report on fragility: those printed, then every number for the spreadsheet and the CSV files.

The spreadsheet has a table for each dimension of the intensity measures.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from operator import attrgetter

from assess.results.fragility import (
    FragilityCurve,
    FragilityResults,
    LognormalResult,
    MeasureComparison,
    MechanismFragility,
    RecordRunsResult,
    RiskResult,
)
from reports.document import Cell, Column, Field, OutcomeCell, Table, tabulate, tabulate_parts
from reports.intensity_measures import (
    DIMENSION_WORDS,
    FIGURES,
    PERCENT,
    RATE_CURVES,
    RATE_FIGURES,
    curves_by,
    dispersion_text,
    first_measure,
    intensity,
    last_state,
    main_curve,
    main_risk,
    measure_text,
    measures_of,
    state_text,
    unit_intensity,
    value_with_interval,
)
from reports.language.texts import Phrase, Text, Verbatim, quantity, say

MECHANISM, STATE, MEASURE = Column(say("Mechanism")), Column(say("State")), Column(say("Measure"))
FIVE, HALF = Column(say("5 % of records")), Column(say("50 % of records (median)"))
DISPERSION = Column(say("Dispersion β"))
RECORD, EVENT = Column(say("Record")), Column(say("Earthquake"))

RATE: Field[RiskResult] = (Column(say("Annual rate"), "annual rate", RATE_FIGURES), lambda risk: risk.annual_rate)
PROBABILITY: Field[RiskResult] = (
    Column(say("In 50 years"), "percent", RATE_FIGURES),
    lambda risk: PERCENT * risk.probability_50_years,
)
TARGET: Field[RiskResult] = (Column(say("Target rate"), "annual rate", FIGURES), lambda risk: risk.target_rate)
WITH_EPISTEMIC: Field[RiskResult] = (
    Column(say("With epistemic dispersion"), "annual rate", RATE_FIGURES),
    lambda risk: risk.with_epistemic,
)
OUTCOME: Field[RiskResult] = (Column(say("Outcome")), lambda risk: risk.outcome and _outcome_cell(risk))
RATE_FIELDS: tuple[Field[RiskResult], ...] = (
    (STATE, lambda risk: state_text(risk.state)),
    (MEASURE, lambda risk: measure_text(risk.measure)),
    (Column(say("Curve")), lambda risk: RATE_CURVES[risk.curve]),
    RATE,
    PROBABILITY,
    TARGET,
    (Column(say("Beyond the hazard"), "annual rate", RATE_FIGURES), lambda risk: risk.beyond),
    (Column(say("Above the runs"), "annual rate", RATE_FIGURES), lambda risk: risk.above_runs),
)
SIGNIFICANT = 0.05

MAX_ISLANDS = 6
"""Islands on a page; the tables of the spreadsheet have all."""


def numbered_name(results: FragilityResults, mechanism: MechanismFragility) -> Verbatim:
    """Return number and title of a mechanism: "M1 Front wall"."""
    return Verbatim(f"{number_of(results, mechanism)} {mechanism.label or mechanism.name}")


def number_of(results: FragilityResults, mechanism: MechanismFragility) -> str:
    """Return the number of a mechanism: "M1"."""
    return f"M{[each.name for each in results.mechanisms].index(mechanism.name) + 1}"


def overview_table(results: FragilityResults) -> Table:
    """Tabulate what is found of every mechanism in its last state, with the rate beside the target."""
    risks = [main_risk(each) for each in results.mechanisms]
    with_rate, with_target = any(risks), any(risk is not None and risk.target_rate is not None for risk in risks)
    fields: tuple[Field[MechanismFragility], ...] = (
        (MECHANISM, lambda each: numbered_name(results, each)),
        (MEASURE, lambda each: None if (measure := first_measure(each)) is None else measure_text(measure)),
        *((column, partial(_fitted_cell, place)) for place, column in enumerate((FIVE, HALF, DISPERSION))),
        *map(_of_main_risk, (RATE, PROBABILITY) if with_rate else ()),
        *map(_of_main_risk, (WITH_EPISTEMIC, TARGET, OUTCOME) if with_target else ()),
    )
    caption = say("Every mechanism: intensity at which 5 % and 50 % of the records overturn it, with 95 % intervals.")
    if any(state is not None and state.name != "overturning" for state in map(last_state, results.mechanisms)):
        caption = say("Every mechanism: intensity at which 5 % and 50 % of the records bring it to its last state.")
    return tabulate("fragility", caption, fields, results.mechanisms, small=True)


def curves_table(mechanism: MechanismFragility, name: str) -> Table:
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
            *((None,) * 9 if curve.lognormal is None else _lognormal_numbers(curve.lognormal)),
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


def measures_table(mechanism: MechanismFragility, name: str) -> Table:
    """Compare the measures in the last state by dispersion, and by the trends of what is left."""
    state = last_state(mechanism)
    fields: tuple[Field[MeasureComparison], ...] = (
        (MEASURE, lambda each: measure_text(each.measure)),
        (Column(DISPERSION.label, "ratio", 2), lambda each: each.dispersion),
        (Column(say("Trend on magnitude")), partial(_trend_text, "magnitude")),
        (Column(say("on ln distance")), partial(_trend_text, "distance")),
        (Column(say("on ln scale factor")), partial(_trend_text, "scale")),
    )
    found = (each for each in mechanism.comparison if each.state == state)
    caption = say(
        "How well each measure explains {state}: the less the dispersion, the better. Trends: slope of what is left, "
        "with its p-value, corrected for the number of trends by Holm; significant below 0.05, where the measure "
        "misses what the records differ in.",
        state=say("no state") if state is None else state_text(state),
    )
    return tabulate(name, caption, fields, found, small=True)


def islands_table(mechanism: MechanismFragility, name: str, *, most: int | None = None) -> Table:
    """Tabulate the islands of the records. most: rows; all of them if None."""
    measure = first_measure(mechanism)
    scales = (Column(label, "ratio", FIGURES) for label in SCALES)
    columns = (RECORD, EVENT, *scales, Column(say("Intensity")))
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


def rates_table(mechanism: MechanismFragility, name: str) -> Table:
    """Tabulate the annual rates of a mechanism, a row for each state, measure and curve."""
    has_epistemic = any(risk.with_epistemic is not None for risk in mechanism.risks)
    fields = (*RATE_FIELDS, WITH_EPISTEMIC) if has_epistemic else RATE_FIELDS
    caption = say(
        "Annual rates and probabilities in 50 years. Beyond the hazard: what the rate can lack, if every motion "
        "stronger than the last row of the hazard reaches the state. Above the runs: the same of motions within the "
        "hazard that are stronger than any run."
    )
    return tabulate(name, caption, fields, mechanism.risks, muted=lambda risk: risk.curve == "first", small=True)


def fragility_records_table(results: FragilityResults) -> Table:
    """Tabulate the records with event, magnitude, distance and the range of scale over all mechanisms."""
    found: dict[str, list[RecordRunsResult]] = {}
    for mechanism in results.mechanisms:
        for run in mechanism.runs:
            found.setdefault(run.record, []).append(run)
    caption = say("Records, with the scale factors at which they were run.")
    return tabulate("fragility-records", caption, RECORD_FIELDS, found.values(), small=True)


RECORD_FIELDS: tuple[Field[list[RecordRunsResult]], ...] = (
    (replace(RECORD, share=0.3), lambda runs: Verbatim(runs[0].record)),
    (EVENT, lambda runs: Verbatim(runs[0].event)),
    (Column(say("Magnitude M"), "ratio", 2), lambda runs: runs[0].magnitude),
    (Column(say("Distance R"), "distance", 3), lambda runs: runs[0].distance_km and 1000.0 * runs[0].distance_km),
    (Column(say("Least scale"), "ratio", FIGURES), lambda runs: min(_scales(runs), default=None)),
    (Column(say("Largest scale"), "ratio", FIGURES), lambda runs: max(_scales(runs), default=None)),
)
SCALES = (say("Stands again from scale"), say("To scale"))
LEAD = (MECHANISM, STATE, MEASURE)
LARGE = say("Scaled by more than 4")
Rows = list[tuple[Cell, ...]]


def data_tables(results: FragilityResults) -> Iterator[Table]:
    """Yield every table that has rows."""
    made = (
        *_by_dimension(results, "curves", say("Lognormal curves; bounds are of the first intensity."), _curve_rows),
        *_by_dimension(results, "points", say("Records that reach each state at each intensity."), _point_rows),
        *_by_dimension(results, "risk", say("Hazard of the site and contributions to the rates."), _contribution_rows),
        *_by_dimension(results, "intensities", say("Intensity of each record at scale 1."), _intensity_rows),
        _union_table(results),
        _all_runs_table(results),
        _all_trends_table(results),
        _all_islands_table(results),
        _all_rates_table(results),
        _remarks_table(results),
    )
    yield from (table for table in made if table.rows)


OUTCOMES = {
    "pass": OutcomeCell("pass", say("within the target")),
    "fail": OutcomeCell("fail", say("more than the target")),
}
ONLY_WITH = OutcomeCell("fail", say("more than the target with the epistemic dispersion"))

GAPS = {
    "motion": OutcomeCell("incomplete", say("not known: ground motion at a height")),
    "runs": OutcomeCell("incomplete", say("not known: the runs end too soon")),
    "hazard": OutcomeCell("incomplete", say("not known: the hazard ends too soon")),
    "epistemic": OutcomeCell("incomplete", say("not known: no epistemic dispersion")),
}


def _of_main_risk(field: Field[RiskResult]) -> Field[MechanismFragility]:
    """Return the column of the rate that represents a mechanism."""
    column, cell = field
    return column, lambda each: None if (risk := main_risk(each)) is None else cell(risk)


def _outcome_cell(risk: RiskResult) -> OutcomeCell:
    """Return the outcome of a rate beside its target, with what is missing."""
    if risk.outcome == "incomplete" and risk.gap is not None:
        return GAPS[risk.gap]
    if risk.outcome == "fail" and risk.gap == "epistemic":
        return ONLY_WITH
    return OUTCOMES[risk.outcome or "pass"]


def _fitted_cell(place: int, mechanism: MechanismFragility) -> Cell:
    """Return 5 %, median or dispersion, by its place, of the curve that represents a mechanism, with its interval."""
    curve = main_curve(mechanism)
    fitted = None if curve is None else curve.lognormal
    if curve is None or fitted is None:
        return None if curve is None or place > 1 else say("not bounded")
    if place > 1:
        return dispersion_text(fitted)
    value, ends = ((fitted.five_percent, fitted.five_percent_interval), (fitted.median, fitted.median_interval))[place]
    return value_with_interval(value, ends, curve.measure)


def _lognormal_numbers(fitted: LognormalResult) -> Iterator[Cell]:
    """Yield 5 %, median and dispersion of a lognormal, each followed by the ends of its interval."""
    for value, ends in (
        (fitted.five_percent, fitted.five_percent_interval),
        (fitted.median, fitted.median_interval),
        (fitted.dispersion, fitted.dispersion_interval),
    ):
        yield value
        yield from ends or (None, None)


def _trend_text(on: str, compared: MeasureComparison) -> Text | None:
    """Return a trend with its p-value and whether it is significant, in words; None where it is not known."""
    trend = next((each for each in compared.trends if each.on == on), None)
    if trend is None:
        return None
    values = {"slope": quantity(trend.slope, figures=2), "p": quantity(trend.p_value, figures=2)}
    if trend.p_value < SIGNIFICANT:
        return say("{slope}, p = {p}: significant", **values)
    return say("{slope}, p = {p}: not significant", **values)


def _scales(runs: list[RecordRunsResult]) -> list[float]:
    return [scale for run in runs for scale in run.scale]


Maker = Callable[[FragilityResults, str], tuple[tuple[Column, ...], Rows]]


def _by_dimension(results: FragilityResults, name: str, caption: Phrase, make: Maker) -> Iterator[Table]:
    for dimension, word in DIMENSION_WORDS.items():
        columns, rows = make(results, dimension)
        yield Table(f"fragility-{name}-{word}", caption, columns, tuple(rows))


def _lead(
    results: FragilityResults, mechanism: MechanismFragility, of: FragilityCurve | RiskResult | MeasureComparison
) -> tuple[Cell, ...]:
    return numbered_name(results, mechanism), state_text(of.state), measure_text(of.measure)


def _curves_of(results: FragilityResults, dimension: str) -> Iterator[tuple[FragilityCurve, tuple[Cell, ...]]]:
    for mechanism in results.mechanisms:
        for curve in mechanism.curves:
            if curve.measure.dimension == dimension:
                yield curve, _lead(results, mechanism, curve)


def _curve_rows(results: FragilityResults, dimension: str) -> tuple[tuple[Column, ...], Rows]:
    low, high = say("from"), say("to")
    columns = (
        *LEAD,
        Column(say("Curve")),
        *(Column(each, dimension) for each in (FIVE.label, low, high, HALF.label, low, high)),
        *(Column(each, "ratio") for each in (DISPERSION.label, low, high)),
        *(Column(each) for each in (say("Records"), say("Earthquakes"), say("Not reached"), LARGE)),
    )
    rows: Rows = []
    for curve, lead in _curves_of(results, dimension):
        counts = (curve.records, curve.events, curve.censored, curve.hollow)
        for word, fitted in ((say("lognormal"), curve.lognormal), (say("bound"), curve.first)):
            if fitted is not None:
                rows.append((*lead, word, *_lognormal_numbers(fitted), *counts))
    return columns, rows


def _point_rows(results: FragilityResults, dimension: str) -> tuple[tuple[Column, ...], Rows]:
    columns = (
        *LEAD,
        Column(say("Intensity"), dimension),
        *(Column(label) for label in (say("Records"), say("Reached"), LARGE)),
        *(Column(label, "ratio") for label in (say("Share"), say("from"), say("to"))),
    )
    rows: Rows = [
        (*lead, p.intensity, p.records, p.reached, p.hollow, p.share, p.low, p.high)
        for curve, lead in _curves_of(results, dimension)
        for p in curve.empirical
    ]
    return columns, rows


def _contribution_rows(results: FragilityResults, dimension: str) -> tuple[tuple[Column, ...], Rows]:
    columns = (
        *LEAD,
        Column(say("Curve")),
        *(Column(label, dimension) for label in (say("From"), say("To"))),
        Column(say("Share of the rate"), "ratio"),
    )
    rows: Rows = [
        (*_lead(results, mechanism, risk), RATE_CURVES[risk.curve], *each)
        for mechanism in results.mechanisms
        for risk in mechanism.risks
        if risk.measure.dimension == dimension
        for each in zip(risk.intensity[:-1], risk.intensity[1:], risk.contribution, strict=True)
    ]
    return columns, rows


def _intensity_rows(results: FragilityResults, dimension: str) -> tuple[tuple[Column, ...], Rows]:
    columns = (MECHANISM, MEASURE, RECORD, Column(say("Intensity"), dimension))
    rows: Rows = [
        (numbered_name(results, each), measure_text(measure), Verbatim(run.record), unit_intensity(each, measure, run))
        for each in results.mechanisms
        for measure in measures_of(each)
        if measure.dimension == dimension
        for run in each.runs
    ]
    return columns, rows


def _all_runs_table(results: FragilityResults) -> Table:
    numbers = (Column(label, "ratio") for label in (say("Scale"), say("Rotation φ/φₒᵥ")))
    columns = (MECHANISM, RECORD, EVENT, *numbers, Column(say("Overturned")))
    rows = tuple(
        (numbered_name(results, each), Verbatim(run.record), Verbatim(run.event), scale, ratio, ratio is None)
        for each in results.mechanisms
        for run in each.runs
        for scale, ratio in zip(run.scale, run.ratio, strict=True)
    )
    return Table("fragility-runs", say("Every run: largest rotation over that which overturns."), columns, rows)


def _union_table(results: FragilityResults) -> Table:
    union = results.union
    points = () if union is None else union.curve.empirical
    dimension = "ratio" if union is None else union.curve.measure.dimension
    columns = (
        Column(say("Intensity"), dimension),
        *(Column(label) for label in (say("Records"), say("Reached"))),
        *(Column(label, "ratio") for label in (say("Share"), say("from"), say("to"), say("If independent"))),
    )
    rows = tuple(
        (p.intensity, p.records, p.reached, p.share, p.low, p.high, independent)
        for p, independent in zip(points, () if union is None else union.if_independent, strict=True)
    )
    caption = say("Records that overturn at least one mechanism at each intensity.")
    return Table("fragility-union", caption, columns, rows)


def _all_trends_table(results: FragilityResults) -> Table:
    on = {"magnitude": say("magnitude"), "distance": say("ln distance"), "scale": say("ln scale factor")}
    numbers = (Column(label, "ratio") for label in (DISPERSION.label, say("Slope"), say("p-value")))
    columns = (*LEAD, Column(say("Trend on")), *numbers, Column(say("Records")))
    rows = tuple(
        (*_lead(results, mechanism, each), on[trend.on], each.dispersion, trend.slope, trend.p_value, trend.n)
        for mechanism in results.mechanisms
        for each in mechanism.comparison
        for trend in each.trends
    )
    return Table("fragility-trends", say("Trends of what each measure leaves unexplained."), columns, rows)


def _all_islands_table(results: FragilityResults) -> Table:
    columns = (MECHANISM, RECORD, EVENT, *(Column(label, "ratio") for label in SCALES))
    rows = tuple(
        (numbered_name(results, each), Verbatim(run.record), Verbatim(run.event), *ends)
        for each in results.mechanisms
        for run in each.runs
        for ends in run.islands
    )
    return Table("fragility-islands", say("Islands of every record."), columns, rows)


def _remarks_table(results: FragilityResults) -> Table:
    columns = (*LEAD, Column(say("Remark")))
    rows: Rows = [
        (numbered_name(results, each), None, None, note) for each in results.mechanisms for note in each.notes
    ]
    for each in results.mechanisms:
        found: tuple[FragilityCurve | RiskResult, ...] = (*each.curves, *each.risks)
        for one in found:
            rows += [(*_lead(results, each, one), note) for note in one.notes]
    return Table("fragility-remarks", say("Remarks on curves and rates."), columns, tuple(dict.fromkeys(rows)))


def _all_rates_table(results: FragilityResults) -> Table:
    mechanisms: tuple[Field[MechanismFragility], ...] = ((MECHANISM, lambda each: numbered_name(results, each)),)
    caption = say("Annual rates and probabilities in 50 years.")
    risks = ((*RATE_FIELDS, WITH_EPISTEMIC), attrgetter("risks"))
    return tabulate_parts("fragility-rates", caption, (mechanisms, results.mechanisms), risks)
