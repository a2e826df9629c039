"""Measures of intensity compared: how little the records scatter, and whether what is left depends on them.

A measure is efficient where the dispersion is small, and sufficient where the residuals of ln intensity do not depend
on magnitude and distance; scaling is harmless where they do not depend on the scale factor (Luco & Cornell 2007,
Earthquake Spectra 23, 357-392).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from assess.results.fragility import FragilityCurve, MeasureComparison, Trend
from assess.risk.regression import trend
from assess.short_repr import ShortRepr
from assess.study.fragility.curves import Intensities
from assess.study.fragility.runs import Runs
from assess.study.fragility.states import first_bounds, reaches
from records.record import Record
from spectra.arrays import FloatArray

LEAST_SCATTER = 1e-6
"""Standard deviation of residuals below which they are rounding, and no trend is sought."""
Property = Literal["magnitude", "distance", "scale"]


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
        tuple(map(event_of, records)),
    )


def event_of(record: Record) -> str:
    """Return the earthquake of a record; a record that names none counts as one of its own."""
    return record.event or record.earthquake.time or record.id


def compare(runs: Runs, by: Intensities, curve: FragilityCurve, origins: Origins) -> MeasureComparison:
    """Return how well a measure explains a state.

    Residuals are those of records that reach the state, at their first exceedance; a cloud has none.

    Parameters
    ----------
    runs : of all records
    by : the measure
    curve : of the measure, in the state
    origins : of the records
    """
    fitted = curve.lognormal or curve.first
    trends = () if curve.method == "cloud" else tuple(_trends(runs, by, curve, origins))
    return MeasureComparison(by.measure, curve.state, None if fitted is None else fitted.dispersion, trends)


def _trends(runs: Runs, by: Intensities, curve: FragilityCurve, origins: Origins) -> Iterator[Trend]:
    lower, upper = first_bounds(runs, by.unit, reaches(runs, curve.state))
    reached = np.isfinite(upper) & (lower > 0.0)
    log = 0.5 * np.log(lower[reached] * upper[reached])
    if log.size == 0 or np.std(log) < LEAST_SCATTER:
        return
    properties: Mapping[Property, FloatArray] = {
        "magnitude": origins.magnitude[reached],
        "distance": origins.log_distance[reached],
        "scale": log - np.log(by.unit[reached]),
    }
    event = [each for each, counts in zip(origins.event, reached, strict=True) if counts]
    for name, values in properties.items():
        known = np.isfinite(values)
        own = [each for each, counts in zip(event, known, strict=True) if counts]
        found = trend(log[known] - log.mean(), values[known], event=own) if known.any() else None
        if found is not None:
            yield Trend(name, found.slope, found.p_value, found.n)
