"""The bootstrap by earthquake: what is drawn, and how often its intervals cover the truth."""

from __future__ import annotations

import numpy as np
import pytest

from assess.risk.bootstrap import bootstrap, bootstrap_cloud, bootstrap_first, bootstrap_lognormal, event_counts
from assess.risk.lognormal import fit_lognormal

STRIPES = np.geomspace(0.1, 1.6, 15)
MEDIAN = 0.4


def thresholds(events, per_event, between, within, rng):
    """Intensities at which records overturn [records], with what those of one event share."""
    event = np.repeat(np.arange(events), per_event)
    logs = between * rng.standard_normal(events)[event] + within * rng.standard_normal(event.size)
    return MEDIAN * np.exp(logs), [str(each) for each in event]


def coverage(events, per_event, between, within, trials, *, draws):
    """Share of trials whose intervals cover the true median, and the true dispersion."""
    rng, inside = np.random.default_rng(3), []
    truth = np.hypot(between, within)
    for trial in range(trials):
        level, event = thresholds(events, per_event, between, within, rng)
        found = bootstrap_lognormal(STRIPES, level[:, None] <= STRIPES, event, seed=trial, draws=draws)
        median, dispersion = found.median or (0.0, np.inf), found.dispersion or (0.0, np.inf)
        inside.append([median[0] <= MEDIAN <= median[1], dispersion[0] <= truth <= dispersion[1]])
    return np.mean(inside, axis=0)


def test_bands_cover_the_truth():
    """Of 400 trials 95 % +- 1.1 % would; the bootstrap of 15 earthquakes of three records each comes to 93 or 94 %."""
    median, dispersion = coverage(15, 3, 0.3, 0.35, 400, draws=200)
    assert median == pytest.approx(0.95, abs=0.035)
    assert dispersion == pytest.approx(0.95, abs=0.035)


@pytest.mark.study
@pytest.mark.parametrize(
    ("events", "per_event", "between", "within"), [(10, 1, 0.0, 0.45), (20, 1, 0.0, 0.45), (40, 1, 0.0, 0.45),
                                                    (15, 3, 0.3, 0.35), (30, 3, 0.3, 0.35), (100, 1, 0.0, 0.45)]
)  # fmt: skip
def test_bands_cover_the_truth_with_few_and_many_earthquakes(events, per_event, between, within):
    median, dispersion = coverage(events, per_event, between, within, 2000, draws=500)
    assert median == pytest.approx(0.95, abs=0.03)
    assert dispersion == pytest.approx(0.95, abs=0.04)


def test_records_drawn_one_by_one_would_be_too_sure():
    """Three records of one event are not three events: intervals by record are narrower than those by earthquake."""
    level, event = thresholds(15, 3, 0.45, 0.05, np.random.default_rng(5))
    reached = level[:, None] <= STRIPES
    by_event = bootstrap_lognormal(STRIPES, reached, event, seed=1)
    by_record = bootstrap_lognormal(STRIPES, reached, [str(at) for at in range(45)], seed=1)
    assert np.ptp(np.log(by_record.median)) < 0.75 * np.ptp(np.log(by_event.median))


def test_records_of_an_event_are_drawn_together_and_events_as_often_as_there_are():
    counts = event_counts(["b", "a", "b", "c"], seed=4, draws=1000)
    np.testing.assert_array_equal(counts[:, 0], counts[:, 2])
    np.testing.assert_array_equal(counts[:, 0] + counts[:, 1] + counts[:, 3], 3.0)
    np.testing.assert_allclose(counts.mean(axis=0), 1.0, atol=0.1)


def test_same_seed_same_intervals():
    level, event = thresholds(12, 1, 0.0, 0.4, np.random.default_rng(8))
    reached = level[:, None] <= STRIPES
    one, same, other = (bootstrap_lognormal(STRIPES, reached, event, seed=seed) for seed in (1, 1, 2))
    assert one == same != other


def test_intensities_of_each_record_give_what_stripes_give():
    level, event = thresholds(12, 2, 0.2, 0.4, np.random.default_rng(8))
    reached = level[:, None] <= STRIPES
    stripes = bootstrap_lognormal(STRIPES, reached, event, seed=1, draws=50)
    each = bootstrap_lognormal(np.tile(STRIPES, (24, 1)), reached, event, seed=1, draws=50)
    np.testing.assert_allclose([*each.median, *each.dispersion], [*stripes.median, *stripes.dispersion], rtol=1e-8)


def test_runs_that_were_not_made_do_not_count():
    level, event = thresholds(12, 2, 0.2, 0.4, np.random.default_rng(8))
    reached = level[:, None] <= STRIPES
    run = np.ones_like(reached)
    run[:, -3:] = False
    cut = bootstrap_lognormal(STRIPES[:-3], reached[:, :-3], event, seed=1, draws=50)
    marked = bootstrap_lognormal(STRIPES, reached, event, seed=1, draws=50, run=run)
    np.testing.assert_allclose([*marked.median, *marked.dispersion], [*cut.median, *cut.dispersion], rtol=1e-8)


def test_too_few_earthquakes_or_too_many_failures_give_no_interval():
    level, _ = thresholds(12, 1, 0.0, 0.4, np.random.default_rng(8))
    assert bootstrap_lognormal(STRIPES, level[:, None] <= STRIPES, ["a", "b"] * 6, seed=1).median is None
    few = bootstrap_lognormal([0.1, 0.2, 0.3], [[0, 0, 1], [0, 1, 1], [0, 0, 1], [0, 1, 0]], list("abcd"), seed=1)
    assert few.median is None
    assert few.unbounded > 25


def test_interval_of_a_mean_is_about_students():
    """The median of logarithms that are all known is their mean, whose interval is Student's."""
    from scipy.stats import t

    logs = np.random.default_rng(2).standard_normal(20)

    def mean_of(counts):
        mean = counts @ logs / counts.sum(axis=1)
        return np.exp(mean), np.ones(len(counts))

    found = bootstrap(mean_of, [str(at) for at in range(20)], seed=1, draws=20_000)
    half = t.ppf(0.975, 19) * logs.std(ddof=1) / np.sqrt(20)
    np.testing.assert_allclose(np.log(found.median), [logs.mean() - half, logs.mean() + half], atol=0.06 * half)


def test_intervals_hold_the_fit_of_first_exceedances_and_of_clouds():
    level, event = thresholds(20, 2, 0.2, 0.4, np.random.default_rng(9))
    first = np.searchsorted(STRIPES, level)
    reaches = np.append(STRIPES, np.inf)[first]
    stands = np.append(0.0, STRIPES)[first]
    found = bootstrap_first(stands, reaches, event, seed=1, draws=200)
    fit = fit_lognormal(STRIPES, (level[:, None] <= STRIPES).sum(axis=0), np.full(15, 40))
    assert found.median[0] < fit.median < found.median[1]
    rng = np.random.default_rng(10)
    im = np.exp(rng.normal(-1.0, 0.7, 60))
    ratio = 0.5 * (im / 0.3) * np.exp(0.4 * rng.standard_normal(60))
    cloud = bootstrap_cloud(im, np.where(ratio > 1.0, np.inf, ratio), [str(at) for at in range(60)], threshold=0.5,
                            seed=1, draws=200)  # fmt: skip
    assert cloud.median[0] < 0.3 < cloud.median[1]
