"""The annual rate of a state: fragility with the hazard of the site.

The share of records that reach the state at each intensity is what counts; the lognormal is beside it, and the curve
of first exceedance bounds it. A cloud has shares at a few intensities only, one for ten records, so that the curve of
its regression counts.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import hypot, isclose, isfinite

import numpy as np

from assess.messages.message import Message, Quantity, note, warning
from assess.results.fragility import CurveName, FragilityCurve, HazardResult, LognormalResult, MeasureResult, RiskResult
from assess.risk.empirical import Empirical
from assess.risk.hazard import HazardCurve, Probability, Rate, probability_of, rate
from assess.risk.lognormal import Lognormal
from assess.study.fragility.question import FragilityQuestion

NOTABLE = 0.05
"""Share of the rate from which what may be missing of it is told."""


def risks(
    curves: Sequence[FragilityCurve], question: FragilityQuestion, *, epistemic: float | None
) -> Iterator[RiskResult]:
    """Yield the rate of each state by each curve in the measure of the hazard.

    Parameters
    ----------
    curves : of one mechanism
    question : its hazard and target
    epistemic : dispersion that is added for comparison [-]
    """
    if question.hazard is None:
        return
    hazard = HazardCurve(np.array(question.hazard.intensity), np.array(question.hazard.annual_rate))
    for curve in curves:
        if same_measure(curve.measure, question.hazard.measure) and curve.empirical:
            yield from _of_curve(curve, hazard, question, epistemic)


def same_measure(one: MeasureResult, other: MeasureResult) -> bool:
    """Return whether two measures are one, at the same place and of the same periods."""
    if (one.key, one.at, len(one.periods_s)) != (other.key, other.at, len(other.periods_s)):
        return False
    return all(isclose(a, b, rel_tol=1e-6) for a, b in zip(one.periods_s, other.periods_s, strict=True))


def _of_curve(
    curve: FragilityCurve, hazard: HazardCurve, question: FragilityQuestion, epistemic: float | None
) -> Iterator[RiskResult]:
    if curve.method != "cloud":
        at = np.array([point.intensity for point in curve.empirical])
        empirical = Empirical(at, np.array([point.share for point in curve.empirical]))
        found = rate(empirical.probability, hazard, breaks=at)
        notes = (*_notes(curve, found, hazard, empirical.probability), *_end(curve, hazard))
        yield _risk(curve, "empirical", found, hazard, question, notes)
    fitted: tuple[tuple[CurveName, LognormalResult | None], ...] = (
        ("lognormal", curve.lognormal),
        ("first", curve.first),
    )
    for name, one in fitted:
        if one is None:
            continue
        drawn = Lognormal(one.median, one.dispersion)
        found = rate(drawn.probability, hazard)
        notes = _notes(curve, found, hazard, drawn.probability) if curve.method == "cloud" else ()
        risk = _risk(curve, name, found, hazard, question, notes)
        if epistemic:
            wide = Lognormal(one.median, hypot(one.dispersion, epistemic))
            risk = replace(risk, with_epistemic=rate(wide.probability, hazard).annual_rate)
        yield risk


def _risk(
    curve: FragilityCurve,
    name: CurveName,
    found: Rate,
    hazard: HazardCurve,
    question: FragilityQuestion,
    notes: tuple[Message, ...],
) -> RiskResult:
    return RiskResult(
        measure=curve.measure,
        state=curve.state,
        curve=name,
        annual_rate=found.annual_rate,
        probability_50_years=probability_of(found.annual_rate),
        intensity=tuple(hazard.intensity.tolist()),
        contribution=tuple(found.shares.tolist()),
        beyond=found.beyond,
        below=found.below if isfinite(found.below) else None,
        target_rate=question.target_rate,
        notes=notes,
    )


def _notes(curve: FragilityCurve, found: Rate, hazard: HazardCurve, probability: Probability) -> tuple[Message, ...]:
    """Tell where the hazard ends too soon for the rate."""
    first, last = float(hazard.intensity[0]), float(hazard.intensity[-1])
    starts, ends = (float(probability(np.array([at]))[0]) for at in (first, last))
    dimension, said = curve.measure.dimension, []
    if found.beyond > NOTABLE * found.annual_rate:
        beyond = Quantity(found.beyond, "ratio", 2)
        at = Quantity(last, dimension, 3)
        said.append(warning("fragility-hazard-ends", intensity=at, share=Quantity(ends, "ratio", 2), beyond=beyond))
    if found.below > NOTABLE * found.annual_rate:
        at = Quantity(first, dimension, 3)
        said.append(warning("fragility-hazard-starts", intensity=at, share=Quantity(starts, "ratio", 2)))
    return tuple(said)


def _end(curve: FragilityCurve, hazard: HazardCurve) -> tuple[Message, ...]:
    """Tell where the shares that were counted end below the hazard."""
    top = curve.empirical[-1]
    if top.intensity >= float(hazard.intensity[-1]) or top.share >= 1.0:
        return ()
    return (note("fragility-curve-ends", intensity=Quantity(top.intensity, curve.measure.dimension, 3)),)


def without_measure(measures: Sequence[MeasureResult], hazard: HazardResult | None) -> tuple[Message, ...]:
    """Return a warning if the hazard is in a measure that is not asked."""
    if hazard is None or any(same_measure(each, hazard.measure) for each in measures):
        return ()
    return (warning("fragility-no-hazard-measure", "analysis.risk", measure=measure_name(hazard.measure)),)


def measure_name(measure: MeasureResult) -> str:
    """Return a measure as the project names it."""
    periods = ", ".join(f"{period:g} s" for period in measure.periods_s)
    return f"{measure.key}({periods})" if periods else measure.key
