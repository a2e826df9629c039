"""The annual rate of a state: fragility with the hazard of the site.

The share of records that reach the state at each intensity is what counts; the lognormal is beside it, and the curve
of first exceedance bounds it. A cloud has a share for every ten records only, so that the curve of its regression
counts. A target is compared with the rate of the curve widened by the epistemic dispersion.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import isclose, isfinite

import numpy as np
from scipy.special import ndtr

from assess.messages.message import Message, Quantity, warning
from assess.results.fragility import CurveName, FragilityCurve, HazardResult, MeasureResult, RiskResult
from assess.risk.empirical import EmpiricalCurve
from assess.risk.hazard import HazardCurve, Probability, probability_of, rate
from assess.risk.lognormal import Lognormal
from assess.study.study import FragilityQuestion
from spectra.arrays import FloatArray

ExceedanceCurve = EmpiricalCurve | Lognormal

NOTABLE = 0.05
"""Share of the rate from which what may be missing of it is told."""

INTENSITY_RANGES = 32
"""Ranges of intensity that contributions are told of."""

FAR_FROM_SITE = 10.0
"""Distance of the hazard from the site from which it is told [km]."""


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
        if same_measure(curve.measure, question.hazard.measure) and curve.empirical:
            for found in _risks_of_curve(curve, hazard, question, epistemic):
                yield replace(found, motion_known=motion_known)


def same_measure(one: MeasureResult, other: MeasureResult) -> bool:
    """Return whether two measures are one, at the same place and of the same periods."""
    if (one.key, one.at, len(one.periods_s)) != (other.key, other.at, len(other.periods_s)):
        return False
    return all(isclose(a, b, rel_tol=1e-6) for a, b in zip(one.periods_s, other.periods_s, strict=True))


def _risks_of_curve(
    curve: FragilityCurve, hazard: HazardCurve, question: FragilityQuestion, epistemic: float | None
) -> Iterator[RiskResult]:
    counts = "lognormal" if curve.method == "cloud" else "empirical"
    for name, drawn in _exceedance_curves(curve):
        risk = _risk(curve, name, drawn, hazard, question)
        if epistemic is not None:
            risk = _with_epistemic(risk, curve, drawn, hazard, epistemic)
        yield replace(risk, notes=_risk_notes(curve, risk, hazard, drawn.probability)) if name == counts else risk


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
    curve: FragilityCurve, name: CurveName, drawn: ExceedanceCurve, hazard: HazardCurve, question: FragilityQuestion
) -> RiskResult:
    edges = np.geomspace(hazard.intensity[0], hazard.intensity[-1], INTENSITY_RANGES + 1)
    found = rate(drawn.probability, hazard, breaks=_kinks(drawn), edges=edges)
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
        above_runs=_above_runs(curve, drawn.probability, hazard),
    )


def _kinks(drawn: ExceedanceCurve) -> FloatArray:
    return drawn.intensity if isinstance(drawn, EmpiricalCurve) else np.empty(0)


def _finite(below: float) -> float | None:
    return below if isfinite(below) else None


def _with_epistemic(
    risk: RiskResult, curve: FragilityCurve, drawn: ExceedanceCurve, hazard: HazardCurve, epistemic: float
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
    wide, kinks = drawn.convolve(epistemic).probability, _kinks(drawn)
    left = 1.0 - float(drawn.probability(curve.end))

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
    """Tell where the hazard or the runs end too soon for the rate."""
    first, last = float(hazard.intensity[0]), float(hazard.intensity[-1])
    starts, ends = (Quantity(float(probability(np.array([at]))[0]), "ratio", 2) for at in (first, last))
    dimension, said = curve.measure.dimension, []
    if risk.beyond > NOTABLE * risk.annual_rate:
        beyond = Quantity(risk.beyond, "ratio", 2)
        said.append(warning("fragility-hazard-ends", intensity=Quantity(last, dimension, 3), share=ends, beyond=beyond))
    if risk.below is None or risk.below > NOTABLE * risk.annual_rate:
        said.append(warning("fragility-hazard-starts", intensity=Quantity(first, dimension, 3), share=starts))
    said.extend(_beyond_runs(curve, risk, hazard, probability))
    if risk.gap == "epistemic" and risk.with_epistemic is not None:
        said.append(warning("fragility-epistemic-above", rate=Quantity(risk.with_epistemic, "ratio", 2)))
    return tuple(said)


def _beyond_runs(
    curve: FragilityCurve, risk: RiskResult, hazard: HazardCurve, probability: Probability
) -> Iterator[Message]:
    """Tell where motions of the hazard are stronger than any run, and of a cloud what the rate has of them."""
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
    """Tell of a cloud which share of the rate is of motions weaker than any record."""
    least = curve.least_run
    if least is None or least <= hazard.intensity[0]:
        return
    below = rate(lambda at: np.where(at < least, probability(at), 0.0), hazard, breaks=(least,)).annual_rate
    if below > NOTABLE * risk.annual_rate:
        share = Quantity(below / risk.annual_rate, "ratio", 2)
        yield warning("fragility-cloud-starts", intensity=Quantity(least, curve.measure.dimension, 3), share=share)


def hazard_messages(measures: Sequence[MeasureResult], hazard: HazardResult | None) -> Iterator[Message]:
    """Yield a warning if the hazard is in a measure that is not asked, and if it is of a place far from the site."""
    if hazard is None:
        return
    if not any(same_measure(each, hazard.measure) for each in measures):
        yield warning("fragility-no-hazard-measure", "analysis.risk", measure=measure_name(hazard.measure))
    if hazard.distance_km is not None and hazard.distance_km > FAR_FROM_SITE:
        distance = Quantity(1000.0 * hazard.distance_km, "distance", 2)
        yield warning("fragility-hazard-far", "analysis.risk.curve", distance=distance)


def epistemic_messages(question: FragilityQuestion) -> Iterator[Message]:
    """Yield a warning where a target is set, and no dispersion of what is not known of the mechanisms."""
    if question.target_rate is not None and question.hazard is not None and not question.epistemic:
        yield warning("fragility-no-epistemic", "analysis.fragility.epistemic")


def measure_name(measure: MeasureResult) -> str:
    """Return a measure as the project names it."""
    periods = ", ".join(f"{period:g} s" for period in measure.periods_s)
    return f"{measure.key}({periods})" if periods else measure.key
