"""Every number of fragility for the spreadsheet and the CSV files; a table for each dimension of the measures."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from assess.results.fragility import (
    FragilityCurve,
    FragilityResults,
    MechanismFragility,
    RiskResult,
)
from reports.chapters import fragility_tables as printed
from reports.chapters.fragility_words import RATES
from reports.document import Cell, Column, Table
from reports.language.texts import Phrase, Verbatim, say
from reports.measures import BELOW, measure_text, measures_of, state_text, unit_intensity

LEAD = (printed.MECHANISM, printed.STATE, printed.MEASURE)
LARGE = say("Scaled by more than 4")
Rows = list[tuple[Cell, ...]]


def tables(results: FragilityResults) -> Iterator[Table]:
    """Yield every table that has rows."""
    made = (
        *_by_dimension(results, "curves", say("Lognormal curves; bounds are of the first intensity."), _curves),
        *_by_dimension(results, "points", say("Records that reach each state at each intensity."), _points),
        *_by_dimension(results, "risk", say("Hazard of the site and contributions to the rates."), _contributions),
        *_by_dimension(results, "intensities", say("Intensity of each record at scale 1."), _intensities),
        _runs(results),
        _trends(results),
        _islands(results),
        _risks(results),
        _notes(results),
    )
    yield from (table for table in made if table.rows)


Maker = Callable[[FragilityResults, str], tuple[tuple[Column, ...], Rows]]


def _by_dimension(results: FragilityResults, name: str, caption: Phrase, make: Maker) -> Iterator[Table]:
    for dimension, word in BELOW.items():
        columns, rows = make(results, dimension)
        yield Table(f"fragility-{name}-{word}", caption, columns, tuple(rows))


def _curves_of(
    results: FragilityResults, dimension: str
) -> Iterator[tuple[MechanismFragility, FragilityCurve, tuple[Cell, ...]]]:
    for mechanism in results.mechanisms:
        for curve in mechanism.curves:
            if curve.measure.dimension == dimension:
                lead = printed.numbered_name(results, mechanism), state_text(curve.state), measure_text(curve.measure)
                yield mechanism, curve, lead


def _curves(results: FragilityResults, dimension: str) -> tuple[tuple[Column, ...], Rows]:
    low, high = say("from"), say("to")
    columns = (
        *LEAD,
        Column(say("Curve")),
        *(Column(each, dimension) for each in (printed.FIVE.label, low, high, printed.HALF.label, low, high)),
        *(Column(each, "ratio") for each in (printed.DISPERSION.label, low, high)),
        *(Column(each) for each in (say("Records"), say("Earthquakes"), say("Not reached"), LARGE)),
    )
    rows: Rows = []
    for _, curve, lead in _curves_of(results, dimension):
        counts = (curve.records, curve.events, curve.censored, curve.hollow)
        for word, fitted in ((say("lognormal"), curve.lognormal), (say("bound"), curve.first)):
            if fitted is not None:
                rows.append((*lead, word, *printed.lognormal_numbers(fitted), *counts))
    return columns, rows


def _points(results: FragilityResults, dimension: str) -> tuple[tuple[Column, ...], Rows]:
    columns = (
        *LEAD,
        Column(say("Intensity"), dimension),
        *(Column(label) for label in (say("Records"), say("Reached"), LARGE)),
        *(Column(label, "ratio") for label in (say("Share"), say("from"), say("to"))),
    )
    rows: Rows = [
        (*lead, p.intensity, p.records, p.reached, p.hollow, p.share, p.low, p.high)
        for _, curve, lead in _curves_of(results, dimension)
        for p in curve.empirical
    ]
    return columns, rows


def _contributions(results: FragilityResults, dimension: str) -> tuple[tuple[Column, ...], Rows]:
    columns = (
        *LEAD,
        Column(say("Curve")),
        Column(say("From"), dimension),
        Column(say("To"), dimension),
        Column(say("Share of the rate"), "ratio"),
    )
    rows: Rows = [
        (
            printed.numbered_name(results, mechanism),
            state_text(risk.state),
            measure_text(risk.measure),
            RATES[risk.curve],
            *each,
        )
        for mechanism in results.mechanisms
        for risk in mechanism.risks
        if risk.measure.dimension == dimension
        for each in zip(risk.intensity[:-1], risk.intensity[1:], risk.contribution, strict=True)
    ]
    return columns, rows


def _intensities(results: FragilityResults, dimension: str) -> tuple[tuple[Column, ...], Rows]:
    columns = (printed.MECHANISM, printed.MEASURE, Column(say("Record")), Column(say("Intensity"), dimension))
    rows: Rows = [
        (
            printed.numbered_name(results, each),
            measure_text(measure),
            Verbatim(run.record),
            unit_intensity(each, measure, run),
        )
        for each in results.mechanisms
        for measure in measures_of(each)
        if measure.dimension == dimension
        for run in each.runs
    ]
    return columns, rows


def _runs(results: FragilityResults) -> Table:
    columns = (
        printed.MECHANISM,
        Column(say("Record")),
        Column(say("Earthquake")),
        Column(say("Scale"), "ratio"),
        Column(say("Rotation φ/φₒᵥ"), "ratio"),
        Column(say("Overturned")),
    )
    rows = tuple(
        (printed.numbered_name(results, each), Verbatim(run.record), Verbatim(run.event), scale, ratio, ratio is None)
        for each in results.mechanisms
        for run in each.runs
        for scale, ratio in zip(run.scale, run.ratio, strict=True)
    )
    return Table("fragility-runs", say("Every run: largest rotation over that which overturns."), columns, rows)


def _trends(results: FragilityResults) -> Table:
    on = {"magnitude": say("magnitude"), "distance": say("ln distance"), "scale": say("ln scale factor")}
    numbers = (Column(label, "ratio") for label in (say("Dispersion β"), say("Slope"), say("p-value")))
    columns = (*LEAD, Column(say("Trend on")), *numbers, Column(say("Records")))
    rows = tuple(
        (
            printed.numbered_name(results, mechanism),
            state_text(each.state),
            measure_text(each.measure),
            on[trend.on],
            each.dispersion,
            trend.slope,
            trend.p_value,
            trend.n,
        )
        for mechanism in results.mechanisms
        for each in mechanism.comparison
        for trend in each.trends
    )
    return Table("fragility-trends", say("Trends of what each measure leaves unexplained."), columns, rows)


def _islands(results: FragilityResults) -> Table:
    columns = (
        printed.MECHANISM,
        Column(say("Record")),
        Column(say("Earthquake")),
        Column(say("Stands again from scale"), "ratio"),
        Column(say("To scale"), "ratio"),
    )
    rows = tuple(
        (printed.numbered_name(results, each), Verbatim(run.record), Verbatim(run.event), *ends)
        for each in results.mechanisms
        for run in each.runs
        for ends in run.islands
    )
    return Table("fragility-islands", say("Islands of every record."), columns, rows)


def _notes(results: FragilityResults) -> Table:
    columns = (printed.MECHANISM, printed.STATE, printed.MEASURE, Column(say("Remark")))
    rows: Rows = [
        (printed.numbered_name(results, each), None, None, note) for each in results.mechanisms for note in each.notes
    ]
    for each in results.mechanisms:
        found: tuple[FragilityCurve | RiskResult, ...] = (*each.curves, *each.risks)
        for one in found:
            lead = printed.numbered_name(results, each), state_text(one.state), measure_text(one.measure)
            rows += [(*lead, note) for note in one.notes]
    return Table("fragility-remarks", say("Remarks on curves and rates."), columns, tuple(dict.fromkeys(rows)))


def _risks(results: FragilityResults) -> Table:
    rows = tuple(
        (printed.numbered_name(results, each), *printed.risk_cells(risk))
        for each in results.mechanisms
        for risk in each.risks
    )
    columns = (printed.MECHANISM, *printed.RISK, printed.WITH_EPISTEMIC)
    return Table("fragility-rates", say("Annual rates and probabilities in 50 years."), columns, rows)
