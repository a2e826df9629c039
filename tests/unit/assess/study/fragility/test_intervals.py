"""Intervals by drawing earthquakes: what is drawn, and how often they cover the truth."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.special import ndtr, ndtri
from scipy.stats import t

from assess.results.fragility import FIVE_PERCENT
from assess.risk.estimates import event_counts, fit_lognormals, mirrored_draws, widened_quantiles
from assess.study.fragility_curves import lognormal_result

STRIPES = np.geomspace(0.1, 1.6, 15)
MEDIAN = 0.4
SHARES = np.array([0.05, 0.5, 0.9])
NORMAL = ndtri(SHARES)


def thresholds(events, per_event, between, within, rng):
    """Intensities at which records overturn [records], with what those of one event share."""
    event = np.repeat(np.arange(events), per_event)
    logs = between * rng.standard_normal(events)[event] + within * rng.standard_normal(event.size)
    return MEDIAN * np.exp(logs), [str(each) for each in event]


def result(level, event, *, seed=1, draws=500, at=STRIPES):
    reached = (level[:, None] <= at).astype(float)
    return lognormal_result(
        lambda counts: fit_lognormals(at, counts @ reached, counts @ np.ones_like(reached)),
        event, seed=seed, draws=draws,
    )  # fmt: skip


def covers(ends, truth):
    return ends is None or ends[0] <= truth <= ends[1]


def coverage(events, per_event, between, within, trials, *, draws):
    """Share of trials whose intervals cover the true median, dispersion, 5 % intensity, and shares of 5, 50, 90 %."""
    rng, inside = np.random.default_rng(3), []
    beta = np.hypot(between, within)
    for trial in range(trials):
        level, event = thresholds(events, per_event, between, within, rng)
        found = result(level, event, seed=trial, draws=draws)
        if found.band is None:  # of ten records, less than 1 % of the trials
            continue
        band, at = found.band, MEDIAN * np.exp(NORMAL * beta)
        low, high = (np.interp(at, band.intensity, side) for side in (band.low, band.high))
        inside.append([
            covers(found.median_interval, MEDIAN),
            covers(found.dispersion_interval, beta),
            covers(found.five_percent_interval, MEDIAN * np.exp(FIVE_PERCENT * beta)),
            *((low <= SHARES) & (high >= SHARES)),
        ])  # fmt: skip
    return np.mean(inside, axis=0)


def test_intervals_cover_the_truth():
    """Of 400 trials 95 % +- 1.1 % would; the bootstrap of 15 earthquakes of three records each comes to 93 or 94 %."""
    found = coverage(15, 3, 0.3, 0.35, 400, draws=200)
    assert found == pytest.approx(np.full(6, 0.95), abs=0.035)


def test_the_band_of_the_curve_is_at_5_and_50_percent_where_their_intervals_end():
    """Above the median it is hardly lower than the curve of largest median and dispersion in their intervals."""
    for seed in range(5):
        level, event = thresholds(12, 1, 0.0, 0.5, np.random.default_rng(seed))
        found = result(level, event)
        for side, normal, bound in (
            ("high", ndtri(0.05), found.five_percent_interval[0]), ("low", ndtri(0.05), found.five_percent_interval[1]),
            ("high", 0.0, found.median_interval[0]), ("low", 0.0, found.median_interval[1]),
        ):  # fmt: skip
            edge = ndtri(getattr(found.band, side))
            if found.band.intensity[0] < bound < found.band.intensity[-1]:
                assert np.interp(np.log(bound), np.log(found.band.intensity), edge) == pytest.approx(normal, abs=0.03)
        top = found.band.intensity[-1]
        least = ndtr(np.log(top / found.median_interval[1]) / found.dispersion_interval[1])
        assert least - 0.01 <= found.band.low[-1] < found.band.high[-1]
        assert (np.diff(found.band.low) >= 0.0).all()
        assert (np.diff(found.band.high) >= 0.0).all()


@pytest.mark.study
@pytest.mark.parametrize(
    ("events", "per_event", "between", "within"), [(10, 1, 0.0, 0.45), (20, 1, 0.0, 0.45), (40, 1, 0.0, 0.45),
                                                    (15, 3, 0.3, 0.35), (30, 3, 0.3, 0.35), (100, 1, 0.0, 0.45)]
)  # fmt: skip
def test_intervals_cover_the_truth_with_few_and_many_earthquakes(events, per_event, between, within):
    found = coverage(events, per_event, between, within, 2000, draws=500)
    assert found == pytest.approx(np.full(6, 0.95), abs=0.04)


def test_records_drawn_one_by_one_would_be_too_sure():
    """Three records of one event are not three events: intervals by record are narrower than those by earthquake."""
    level, event = thresholds(15, 3, 0.45, 0.05, np.random.default_rng(5))
    by_event, by_record = result(level, event), result(level, [str(at) for at in range(45)])
    assert np.ptp(np.log(by_record.median_interval)) < 0.75 * np.ptp(np.log(by_event.median_interval))


def test_records_of_an_event_are_drawn_together_and_events_as_often_as_there_are():
    counts = event_counts(["b", "a", "b", "c"], seed=4, draws=1000)
    np.testing.assert_array_equal(counts[:, 0], counts[:, 2])
    np.testing.assert_array_equal(counts[:, 0] + counts[:, 1] + counts[:, 3], 3.0)
    np.testing.assert_allclose(counts.mean(axis=0), 1.0, atol=0.1)


def test_same_seed_same_intervals():
    level, event = thresholds(12, 1, 0.0, 0.4, np.random.default_rng(8))
    one, same, other = (result(level, event, seed=seed) for seed in (1, 1, 2))
    assert one == same != other


def test_too_few_earthquakes_or_too_many_failures_give_no_interval():
    level, _ = thresholds(12, 1, 0.0, 0.4, np.random.default_rng(8))
    few = result(level, ["a", "b"] * 6)
    failing = result(np.array([0.25, 0.15, 0.25, 0.15, 0.35]), list("abcde"), at=np.array([0.1, 0.2, 0.3]))
    for each in (few, failing):
        assert each.median > 0.0
        assert (each.median_interval, each.dispersion_interval, each.band) == (None, None, None)


def test_interval_of_a_mean_is_about_students():
    """The median of logarithms that are all known is their mean, whose interval is Student's."""
    logs = np.random.default_rng(2).standard_normal(20)
    means = event_counts([str(at) for at in range(20)], seed=1, draws=20_000) @ logs / 20
    found = widened_quantiles(mirrored_draws(np.exp(means), float(np.exp(logs.mean()))), events=20)
    half = t.ppf(0.975, 19) * logs.std(ddof=1) / np.sqrt(20)
    np.testing.assert_allclose(np.log(found), [logs.mean() - half, logs.mean() + half], atol=0.06 * half)
