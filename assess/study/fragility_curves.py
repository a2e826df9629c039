"""Fragility curves of one mechanism, and the annual rate of a state that they give with the hazard of the site.

Curves are the shares of records, the lognormal through them, and that of first exceedance. Lognormal curves have
bootstrap intervals, by earthquake. Curves in a measure that is proportional to another are the same ones in other
units.

Measures of intensity are compared by how little the records scatter, and by whether what is left depends on them. A
measure is efficient where the dispersion is small, and sufficient where the residuals of ln intensity do not depend on
magnitude and distance; scaling is harmless where they do not depend on the scale factor (Luco & Cornell 2007,
Earthquake Spectra 23, 357-392).

For the rate it is the share of records that reach the state at each intensity that counts; the lognormal is beside it,
and the curve of first exceedance bounds it. A cloud has a share for every ten records only, so that the curve of its
regression counts. A target is compared with the rate of the curve widened by the epistemic dispersion.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from math import isclose, isfinite
from typing import Literal

import numpy as np
from scipy.special import ndtr

from assess.messages.message import Message, Quantity, message, note, warning, whole_number
from assess.results.fragility import (
    FIVE_PERCENT,
    LARGE_SCALE,
    CurveBand,
    CurveName,
    EmpiricalPoint,
    FragilityCurve,
    HazardResult,
    LognormalResult,
    MeasureComparison,
    MeasureResult,
    RiskResult,
    StateResult,
    Trend,
)
from assess.risk.estimates import (
    LEAST_EVENTS,
    EmpiricalCurve,
    Lognormal,
    UnboundedReason,
    equivalent_lognormals,
    event_counts,
    fit_first_exceedances,
    fit_lognormals,
    holm,
    mirrored_draws,
    trend,
    unbounded_reason,
    widened_quantiles,
    wilson_interval,
)
from assess.risk.hazard import HazardCurve, Probability, probability_of, rate
from assess.short_repr import ShortRepr
from assess.study.fragility_runs import FragilityRuns, Intensities, StateOutcomes, first_bounds, reaches, state_outcomes
from assess.study.study import FragilityQuestion
from records.record import Record
from spectra.arrays import BoolArray, FloatArray

PER_POINT = 10
"""Records of a cloud that share a point of the empirical curve, at least."""
MOST_POINTS = 10

LEAST_DISPERSION = 1e-3
"""Of a cloud; smaller ones are those of a step."""


def fragility_curve(
    runs: FragilityRuns,
    intensities: Intensities,
    state: StateResult,
    events: Sequence[str],
    question: FragilityQuestion,
) -> FragilityCurve:
    """Return the fragility curve of a mechanism in one state by one measure.

    Parameters
    ----------
    runs : of all records
    intensities : the measure
    state : to be reached
    events : earthquake of each record [records]
    question : method, seed and draws
    """
    make = _cloud_curve if question.method == "cloud" else _level_curve
    return make(runs, intensities, state, events, question)


def curve_outcomes(
    runs: FragilityRuns, intensities: Intensities, state: StateResult, question: FragilityQuestion
) -> StateOutcomes:
    """Return which records reach a state at the intensities of a curve; arguments are those of `fragility_curve`."""
    reached = reaches(runs, state)
    if question.method == "cloud":
        return _outcomes_in_groups(runs.scale[:, 0] * intensities.unit, reached[:, 0], runs.scale[:, 0])
    return state_outcomes(runs, intensities.unit, reached, primary=intensities.primary)


Fits = Callable[[FloatArray], tuple[FloatArray, FloatArray]]
"""Takes how often each record counts [draws, records]; returns medians and dispersions [draws], nan where unbounded."""

MOST_UNBOUNDED = 0.05
"""Share of draws that need not bound a curve."""
BAND_POINTS = 25

BAND_REACH = 2.5
"""Dispersions to each side of the median over which the band of a curve is given."""


def lognormal_result(fits: Fits, events: Sequence[str], *, seed: int, draws: int) -> LognormalResult | None:
    """Return the lognormal of all records with its intervals; None where they do not bound one.

    Intervals are None where more than 5 % of the draws do not bound a curve, or earthquakes are fewer than three.

    Parameters
    ----------
    fits : of the curve
    events : earthquake of each record [records]
    seed : of the random draws
    draws : how many
    """
    (median,), (dispersion,) = fits(np.ones((1, len(events))))
    if np.isnan(median + dispersion):
        return None
    plain = LognormalResult(float(median), float(dispersion))
    number = len(set(events))
    if number < LEAST_EVENTS:
        return plain
    medians, dispersions = fits(event_counts(events, seed=seed, draws=draws))
    good = np.isfinite(medians) & np.isfinite(dispersions)
    if np.count_nonzero(~good) > MOST_UNBOUNDED * draws:
        return plain
    return _with_intervals(plain, medians[good], dispersions[good], number)


ROUNDING = 1e-9
"""Relative difference below which the ratios of two measures are one number."""


def factor_between(one: FloatArray, other: FloatArray) -> float | None:
    """Return the number that intensities of one measure are times those of another [records]; None if it varies."""
    ratio = other / one
    return float(ratio[0]) if np.ptp(ratio) <= ROUNDING * ratio[0] else None


def convert_curve(curve: FragilityCurve, measure: MeasureResult, factor: float) -> FragilityCurve:
    """Return a curve in another measure.

    Parameters
    ----------
    curve : in its own measure
    measure : the other one
    factor : intensity of the other measure over that of its own
    """
    return replace(
        curve,
        measure=measure,
        empirical=tuple(replace(point, intensity=factor * point.intensity) for point in curve.empirical),
        lognormal=_scaled_lognormal(curve.lognormal, factor),
        first=_scaled_lognormal(curve.first, factor),
        least_run=None if curve.least_run is None else factor * curve.least_run,
        largest_run=None if curve.largest_run is None else factor * curve.largest_run,
    )


LEAST_SCATTER = 1e-6
"""Standard deviation of residuals below which they are rounding, and no trend is sought."""
RecordProperty = Literal["magnitude", "distance", "scale"]


@dataclass(frozen=True, repr=False)
class Origins(ShortRepr):
    """What is known of the records [records]: magnitude and ln distance, nan where not known, and the earthquake."""

    magnitude: FloatArray
    log_distance: FloatArray
    event: tuple[str, ...]


def origins_of(records: Sequence[Record]) -> Origins:
    """Return what is known of the records."""
    magnitude = [each.earthquake.magnitude for each in records]
    distance = [each.distance if each.distance and each.distance > 0.0 else None for each in records]
    return Origins(
        np.array([np.nan if one is None else one for one in magnitude]),
        np.array([np.nan if one is None else np.log(one) for one in distance]),
        tuple(map(_event_of, records)),
    )


def compare_measure(
    runs: FragilityRuns, intensities: Intensities, curve: FragilityCurve, origins: Origins
) -> MeasureComparison:
    """Return how well a measure explains a state.

    Residuals are those of records that reach the state, at their first exceedance; a cloud has none.

    Parameters
    ----------
    runs : of all records
    intensities : the measure
    curve : of the measure, in the state
    origins : of the records
    """
    fitted = curve.lognormal or curve.first
    trends = () if curve.method == "cloud" else tuple(_trends(runs, intensities, curve, origins))
    return MeasureComparison(intensities.measure, curve.state, None if fitted is None else fitted.dispersion, trends)


def correct_trends(comparison: Sequence[MeasureComparison]) -> tuple[MeasureComparison, ...]:
    """Return comparisons with the p-values of their trends corrected for the number of all of them."""
    p_values = iter(holm([trend.p_value for each in comparison for trend in each.trends]).tolist())
    return tuple(
        replace(each, trends=tuple(replace(trend, p_value=next(p_values)) for trend in each.trends))
        for each in comparison
    )


ExceedanceCurve = EmpiricalCurve | Lognormal

NOTABLE = 0.05
"""Share of the rate from which a warning says what may be missing of it."""

INTENSITY_RANGES = 32
"""Ranges of intensity that contributions are given for."""

FAR_FROM_SITE = 10.0
"""Distance of the hazard from the site from which there is a warning [km]."""


def risks(
    curves: Sequence[FragilityCurve], question: FragilityQuestion, *, epistemic: float | None, motion_known: bool
) -> Iterator[RiskResult]:
    """Yield the rate of each state by each curve in the measure of the hazard.

    Parameters
    ----------
    curves : of one mechanism
    question : its hazard and target
    epistemic : dispersion that curves are widened by to compare with the target [-]; None where it is not given
    motion_known : whether the records are those of the base of the mechanism
    """
    if question.hazard is None:
        return
    hazard = HazardCurve(np.array(question.hazard.intensity), np.array(question.hazard.annual_rate))
    for curve in curves:
        if _same_measure(curve.measure, question.hazard.measure) and curve.empirical:
            for found in _risks_of_curve(curve, hazard, question, epistemic):
                yield replace(found, motion_known=motion_known)


def hazard_messages(measures: Sequence[MeasureResult], hazard: HazardResult | None) -> Iterator[Message]:
    """Yield warnings if the hazard is in a measure that is not requested, or of a place far from the site."""
    if hazard is None:
        return
    if not any(_same_measure(each, hazard.measure) for each in measures):
        yield warning("fragility-no-hazard-measure", "analysis.risk", measure=measure_key_text(hazard.measure))
    if hazard.distance_km is not None and hazard.distance_km > FAR_FROM_SITE:
        distance = Quantity(1000.0 * hazard.distance_km, "distance", 2)
        yield warning("fragility-hazard-far", "analysis.risk.curve", distance=distance)


def epistemic_messages(question: FragilityQuestion) -> Iterator[Message]:
    """Yield a warning where a target is set, and no dispersion of what is not known of the mechanisms."""
    if question.target_rate is not None and question.hazard is not None and not question.epistemic:
        yield warning("fragility-no-epistemic", "analysis.fragility.epistemic")


def measure_key_text(measure: MeasureResult) -> str:
    """Return a measure as the project names it."""
    periods = ", ".join(f"{period:g} s" for period in measure.periods_s)
    return f"{measure.key}({periods})" if periods else measure.key


def _level_curve(
    runs: FragilityRuns,
    intensities: Intensities,
    state: StateResult,
    events: Sequence[str],
    question: FragilityQuestion,
) -> FragilityCurve:
    """Return the curve of records at many scales; arguments are those of `fragility_curve`."""
    reached = reaches(runs, state)
    found = curve_outcomes(runs, intensities, state, question)
    stands, falls = first_bounds(runs, intensities.unit, reached)
    of_first = None if runs.stripe is not None else partial(fit_first_exceedances, stands, falls)

    reaching, known = found.reached.astype(np.float64), found.known.astype(np.float64)

    def counts_at_levels(counts: FloatArray) -> tuple[FloatArray, FloatArray]:
        return fit_lognormals(found.intensity, counts @ reaching, counts @ known)

    yes, n = found.reached.sum(axis=0), found.known.sum(axis=0)
    return _curve(
        runs,
        intensities,
        state,
        events,
        question,
        points=_empirical_points(found),
        lognormal=counts_at_levels,
        first=of_first,
        why=unbounded_reason(found.intensity, yes, n),
    )


def _cloud_curve(
    runs: FragilityRuns,
    intensities: Intensities,
    state: StateResult,
    events: Sequence[str],
    question: FragilityQuestion,
) -> FragilityCurve:
    """Return the curve of records that are run once; arguments are those of `fragility_curve`.

    The lognormal is the one equivalent to the regression of the cloud (see `assess.risk.estimates`); there is none
    where a single intensity parts the records that reach the state from the others.
    """
    at, ratio, reached = runs.scale[:, 0] * intensities.unit, runs.ratio[:, 0], reaches(runs, state)
    threshold = {"rocking": 0.0, "overturning": np.inf}.get(state.name, state.share or 0.0)

    def equivalent(counts: FloatArray) -> tuple[FloatArray, FloatArray]:
        median, dispersion = equivalent_lognormals(at, ratio, counts, threshold)
        return median, np.where(dispersion > LEAST_DISPERSION, dispersion, np.nan)

    why = unbounded_reason(at, reached[:, 0], np.ones(at.size))
    found = _curve(
        runs,
        intensities,
        state,
        events,
        question,
        points=_empirical_points(curve_outcomes(runs, intensities, state, question)),
        lognormal=equivalent,
        first=None,
        why="cloud-separated" if why is UnboundedReason.SEPARATED else why or "no-cloud",
    )
    return replace(found, least_run=float(at.min()), largest_run=float(at.max()))


def _curve(
    runs: FragilityRuns,
    intensities: Intensities,
    state: StateResult,
    events: Sequence[str],
    question: FragilityQuestion,
    *,
    points: tuple[EmpiricalPoint, ...],
    lognormal: Fits,
    first: Fits | None,
    why: str | None,
) -> FragilityCurve:
    fitted = _fitted(lognormal, events, question)
    return FragilityCurve(
        measure=intensities.measure,
        state=state,
        method=question.method,
        records=len(events),
        events=len(set(events)),
        censored=0
        if runs.stripe is not None
        else int(np.count_nonzero(~reaches(runs, state)[np.arange(len(events)), runs.last])),
        hollow=int(np.count_nonzero(runs.scale > LARGE_SCALE)),
        empirical=points,
        lognormal=fitted,
        first=None if first is None else _fitted(first, events, question),
        notes=tuple(_curve_notes(fitted, why, events)),
    )


def _fitted(fits: Fits, events: Sequence[str], question: FragilityQuestion) -> LognormalResult | None:
    return lognormal_result(fits, events, seed=question.seed, draws=question.draws)


def _empirical_points(found: StateOutcomes) -> tuple[EmpiricalPoint, ...]:
    """Return the share of records that reach a state at each intensity at which any is known."""
    some = found.known.any(axis=0)
    yes, n, hollow = (each.sum(axis=0)[some] for each in (found.reached, found.known, found.hollow & found.known))
    low, high = wilson_interval(yes, n)
    rows = zip(found.intensity[some], n, yes, low, high, hollow, strict=True)
    return tuple(
        EmpiricalPoint(float(at), int(all_), int(some_), float(some_ / all_), float(below), float(above), int(far))
        for at, all_, some_, below, above, far in rows
    )


def _outcomes_in_groups(at: FloatArray, reached: BoolArray, scale: FloatArray) -> StateOutcomes:
    """Return the outcomes of records in groups of similar intensity, each at the geometric mean of its group.

    Parameters
    ----------
    at : intensity of each record [records]
    reached : whether each reaches the state [records]
    scale : factor on each [records]
    """
    count = int(np.clip(at.size // PER_POINT, 1, MOST_POINTS))
    groups = np.array_split(np.argsort(at, kind="stable"), count)
    known = np.zeros((at.size, count), dtype=bool)
    for place, group in enumerate(groups):
        known[group, place] = True
    middle = np.array([np.exp(np.mean(np.log(at[group]))) for group in groups])
    return StateOutcomes(middle, known & reached[:, None], known, known & (scale > LARGE_SCALE)[:, None])


def _curve_notes(fitted: LognormalResult | None, why: str | None, events: Sequence[str]) -> Iterator[Message]:
    """Yield why there is no lognormal, or no interval of it."""
    if fitted is None:
        if why is not None:
            yield message(f"fragility-{why}")
    elif fitted.median_interval is None:
        number = len(set(events))
        if number < LEAST_EVENTS:
            yield note("fragility-interval-events", events=whole_number(number), least=whole_number(LEAST_EVENTS))
        else:
            yield note("fragility-interval-draws")


def _with_intervals(
    plain: LognormalResult, medians: FloatArray, dispersions: FloatArray, events: int
) -> LognormalResult:
    """Return a lognormal with the quantiles of the curves of mirrored draws.

    Medians and dispersions are mirrored, and not the standard normal variable ln(im / m) / beta: draws of small
    dispersion make that so skewed that its basic interval reaches far below the curve above the median. So the band is
    at 50 % and at 5 % where the intervals of these intensities end.
    """
    m, beta = mirrored_draws(medians, plain.median), mirrored_draws(dispersions, plain.dispersion)

    def ends(draws: FloatArray) -> tuple[float, float]:
        low, high = np.exp(widened_quantiles(np.log(draws), events=events)).tolist()
        return low, high

    normal = np.linspace(-BAND_REACH, BAND_REACH, BAND_POINTS)
    at = plain.median * np.exp(normal * plain.dispersion)
    band = ndtr(widened_quantiles(np.log(at / m[:, None]) / beta[:, None], events=events))
    return LognormalResult(
        median=plain.median,
        dispersion=plain.dispersion,
        median_interval=ends(m),
        dispersion_interval=ends(beta),
        five_percent_interval=ends(m * np.exp(FIVE_PERCENT * beta)),
        band=CurveBand(*(tuple(each.tolist()) for each in (at, *band))),
    )


def _scaled_lognormal(fitted: LognormalResult | None, factor: float) -> LognormalResult | None:
    if fitted is None:
        return None
    band = fitted.band
    return replace(
        fitted,
        median=factor * fitted.median,
        median_interval=_scaled_interval(fitted.median_interval, factor),
        five_percent_interval=_scaled_interval(fitted.five_percent_interval, factor),
        band=None if band is None else CurveBand(tuple(factor * at for at in band.intensity), band.low, band.high),
    )


def _scaled_interval(found: tuple[float, float] | None, factor: float) -> tuple[float, float] | None:
    return None if found is None else (factor * found[0], factor * found[1])


def _event_of(record: Record) -> str:
    """Return the earthquake of a record; a record that names none counts as one of its own."""
    return record.event or record.earthquake.time or record.id


def _trends(runs: FragilityRuns, intensities: Intensities, curve: FragilityCurve, origins: Origins) -> Iterator[Trend]:
    lower, upper = first_bounds(runs, intensities.unit, reaches(runs, curve.state))
    reached = np.isfinite(upper) & (lower > 0.0)
    log = 0.5 * np.log(lower[reached] * upper[reached])
    if log.size == 0 or np.std(log) < LEAST_SCATTER:
        return
    properties: Mapping[RecordProperty, FloatArray] = {
        "magnitude": origins.magnitude[reached],
        "distance": origins.log_distance[reached],
        "scale": log - np.log(intensities.unit[reached]),
    }
    event = [each for each, counts in zip(origins.event, reached, strict=True) if counts]
    for name, values in properties.items():
        known = np.isfinite(values)
        own = [each for each, counts in zip(event, known, strict=True) if counts]
        found = trend(log[known] - log.mean(), values[known], event=own) if known.any() else None
        if found is not None:
            yield Trend(name, found.slope, found.p_value, found.n)


def _same_measure(one: MeasureResult, other: MeasureResult) -> bool:
    """Return whether two measures are one, at the same place and of the same periods."""
    if (one.key, one.at, len(one.periods_s)) != (other.key, other.at, len(other.periods_s)):
        return False
    return all(isclose(a, b, rel_tol=1e-6) for a, b in zip(one.periods_s, other.periods_s, strict=True))


def _risks_of_curve(
    curve: FragilityCurve, hazard: HazardCurve, question: FragilityQuestion, epistemic: float | None
) -> Iterator[RiskResult]:
    counts = "lognormal" if curve.method == "cloud" else "empirical"
    for name, exceedance in _exceedance_curves(curve):
        risk = _risk(curve, name, exceedance, hazard, question)
        if epistemic is not None:
            risk = _with_epistemic(risk, curve, exceedance, hazard, epistemic)
        yield replace(risk, notes=_risk_notes(curve, risk, hazard, exceedance.probability)) if name == counts else risk


def _exceedance_curves(curve: FragilityCurve) -> Iterator[tuple[CurveName, ExceedanceCurve]]:
    """Yield each curve that a rate is found with, by its name."""
    if curve.method != "cloud":
        at, share = np.array([(point.intensity, point.share) for point in curve.empirical]).T
        yield "empirical", EmpiricalCurve(at, share)
    if curve.lognormal is not None:
        yield "lognormal", Lognormal(curve.lognormal.median, curve.lognormal.dispersion)
    if curve.first is not None:
        yield "first", Lognormal(curve.first.median, curve.first.dispersion)


def _risk(
    curve: FragilityCurve,
    name: CurveName,
    exceedance: ExceedanceCurve,
    hazard: HazardCurve,
    question: FragilityQuestion,
) -> RiskResult:
    edges = np.geomspace(hazard.intensity[0], hazard.intensity[-1], INTENSITY_RANGES + 1)
    found = rate(exceedance.probability, hazard, breaks=_kinks(exceedance), edges=edges)
    return RiskResult(
        measure=curve.measure,
        state=curve.state,
        curve=name,
        annual_rate=found.annual_rate,
        probability_50_years=probability_of(found.annual_rate),
        intensity=tuple(edges.tolist()),
        contribution=tuple(found.shares.tolist()),
        beyond=found.beyond,
        below=_finite(found.below),
        target_rate=question.target_rate,
        above_runs=_above_runs(curve, exceedance.probability, hazard),
    )


def _kinks(exceedance: ExceedanceCurve) -> FloatArray:
    return exceedance.intensity if isinstance(exceedance, EmpiricalCurve) else np.empty(0)


def _finite(below: float) -> float | None:
    return below if isfinite(below) else None


def _with_epistemic(
    risk: RiskResult, curve: FragilityCurve, exceedance: ExceedanceCurve, hazard: HazardCurve, epistemic: float
) -> RiskResult:
    """Return a risk with the rate of its widened curve, and with what that may lack at most.

    What is run ends at one intensity, but under the factor of the epistemic dispersion a motion below it counts as one
    above it with the probability Phi(ln(im / end) / epistemic). There the state may be likelier than the curve says by
    one less its value at the end.
    """
    if not epistemic:
        return replace(
            risk,
            with_epistemic=risk.annual_rate,
            below_with_epistemic=risk.below,
            above_runs_with_epistemic=risk.above_runs,
        )
    wide, kinks = exceedance.convolve(epistemic).probability, _kinks(exceedance)
    left = 1.0 - float(exceedance.probability(curve.end))

    def lacking(at: FloatArray) -> FloatArray:
        return np.minimum(left * ndtr(np.log(at / curve.end) / epistemic), 1.0 - wide(at))

    found, more = rate(wide, hazard, breaks=kinks), rate(lacking, hazard, breaks=(curve.end,))
    return replace(
        risk,
        with_epistemic=found.annual_rate,
        below_with_epistemic=_finite(found.below + more.below),
        above_runs_with_epistemic=more.annual_rate,
    )


def _above_runs(curve: FragilityCurve, probability: Probability, hazard: HazardCurve) -> float:
    """Return what the rate lacks if all motions above the largest intensity that was run reach the state [1/year]."""
    return _rate_above(curve.end, lambda at: 1.0 - probability(at), hazard)


def _rate_above(top: float, probability: Probability, hazard: HazardCurve) -> float:
    """Return what motions stronger than `top` add to a rate [1/year]."""
    if top >= hazard.intensity[-1]:
        return 0.0
    return rate(lambda at: np.where(at > top, probability(at), 0.0), hazard, breaks=(top,)).annual_rate


def _risk_notes(
    curve: FragilityCurve, risk: RiskResult, hazard: HazardCurve, probability: Probability
) -> tuple[Message, ...]:
    """Return warnings where the hazard or the runs end too soon for the rate."""
    first, last = float(hazard.intensity[0]), float(hazard.intensity[-1])
    starts, ends = (Quantity(float(probability(np.array([at]))[0]), "ratio", 2) for at in (first, last))
    dimension, notes = curve.measure.dimension, []
    if risk.beyond > NOTABLE * risk.annual_rate:
        beyond = Quantity(risk.beyond, "ratio", 2)
        notes.append(
            warning("fragility-hazard-ends", intensity=Quantity(last, dimension, 3), share=ends, beyond=beyond)
        )
    if risk.below is None or risk.below > NOTABLE * risk.annual_rate:
        notes.append(warning("fragility-hazard-starts", intensity=Quantity(first, dimension, 3), share=starts))
    notes.extend(_beyond_runs(curve, risk, hazard, probability))
    if risk.gap == "epistemic" and risk.with_epistemic is not None:
        notes.append(warning("fragility-epistemic-above", rate=Quantity(risk.with_epistemic, "ratio", 2)))
    return tuple(notes)


def _beyond_runs(
    curve: FragilityCurve, risk: RiskResult, hazard: HazardCurve, probability: Probability
) -> Iterator[Message]:
    """Yield a warning if motions of the hazard are stronger than any run, for a cloud with their share of the rate."""
    at, lacking = Quantity(curve.end, curve.measure.dimension, 3), Quantity(risk.above_runs, "ratio", 2)
    if curve.method == "cloud":
        yield from _below_runs(curve, risk, hazard, probability)
        above = _rate_above(curve.end, probability, hazard)
        if above + risk.above_runs > NOTABLE * risk.annual_rate:
            share = Quantity(above / risk.annual_rate if risk.annual_rate else 0.0, "ratio", 2)
            yield warning("fragility-cloud-ends", intensity=at, share=share, lacking=lacking)
    elif risk.above_runs > NOTABLE * risk.annual_rate:
        share = Quantity(curve.empirical[-1].share, "ratio", 2)
        yield warning("fragility-runs-end", intensity=at, share=share, lacking=lacking)


def _below_runs(
    curve: FragilityCurve, risk: RiskResult, hazard: HazardCurve, probability: Probability
) -> Iterator[Message]:
    """Yield a warning with the share of the rate of a cloud that is of motions weaker than any record."""
    least = curve.least_run
    if least is None or least <= hazard.intensity[0]:
        return
    below = rate(lambda at: np.where(at < least, probability(at), 0.0), hazard, breaks=(least,)).annual_rate
    if below > NOTABLE * risk.annual_rate:
        share = Quantity(below / risk.annual_rate, "ratio", 2)
        yield warning("fragility-cloud-starts", intensity=Quantity(least, curve.measure.dimension, 3), share=share)
