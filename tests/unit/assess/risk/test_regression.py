"""Clouds and trends against closed forms and scipy."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.special import expit, ndtr
from scipy.stats import linregress

from assess.risk.estimates import cloud_probability, equivalent_lognormals, fit_clouds, holm, trend


def records(seed, number=200, sigma=0.4):
    """Intensity and demand of which the median is 0.5 (im / 0.3)^1.2."""
    rng = np.random.default_rng(seed)
    im = np.exp(rng.normal(-1.2, 0.7, number))
    return im, 0.5 * (im / 0.3) ** 1.2 * np.exp(sigma * rng.standard_normal(number))


def fit(im, d):
    """Intercept, slope, sigma, and both logistic curves of one cloud [7]."""
    im, d = np.asarray(im), np.asarray(d)
    return fit_clouds(im, d, np.ones((1, im.size)))[0]


def probability(cloud, im, threshold):
    return cloud_probability(cloud[None], np.log(np.atleast_2d(im)), threshold)[0]


def equivalent(im, d, threshold):
    (median,), (dispersion,) = equivalent_lognormals(im, d, np.ones((1, im.size)), threshold)
    return median, dispersion


def test_line_is_scipys_where_all_rock():
    im, d = records(1)
    line = linregress(np.log(im), np.log(d))
    left = np.log(d) - line.intercept - line.slope * np.log(im)
    np.testing.assert_allclose(fit(im, d)[:3], [line.intercept, line.slope, np.sqrt(left @ left / 198)], rtol=1e-10)


def test_equivalent_of_a_line_alone_is_cornells_lognormal():
    """Median exp((ln threshold - a) / b), dispersion sigma / b; 16 % and 84 % stand for one standard deviation."""
    im, d = records(2)
    a, b, sigma = fit(im, d)[:3]
    median, dispersion = equivalent(im, d, 0.5)
    assert median == pytest.approx(np.exp((np.log(0.5) - a) / b), rel=1e-9)
    assert dispersion == pytest.approx(0.99446 * sigma / b, rel=1e-4)
    assert median == pytest.approx(0.3, rel=0.06)


def test_overturning_is_the_logistic_curve_of_greatest_likelihood():
    im, d = records(3)
    over = d > 1.0
    cloud = fit(im, np.where(over, np.inf, d))
    x = np.log(im)

    def loss(at):
        p = expit(at[0] + at[1] * x)
        return -np.sum(np.log(np.where(over, p, 1.0 - p)))

    found = minimize(loss, [0.0, 1.0], method="Nelder-Mead", options={"xatol": 1e-10, "fatol": 1e-13, "maxiter": 2000})
    np.testing.assert_allclose(cloud[5:], found.x, rtol=1e-6)
    np.testing.assert_allclose(probability(cloud, im, np.inf), expit(found.x[0] + found.x[1] * x), atol=1e-7)


def test_probability_is_the_total_one_over_still_rocking_and_overturned():
    im, d = records(4)
    cloud = fit(im, np.where(d > 1.0, np.inf, np.where(d < 0.15, 0.0, d)))
    a, b, sigma, a_r, b_r, a_o, b_o = cloud
    at = np.log(0.25)
    over, rocks = expit(a_o + b_o * at), expit(a_r + b_r * at)
    above = ndtr((a + b * at - np.log(0.5)) / sigma)
    assert probability(cloud, 0.25, 0.5)[0] == pytest.approx(over + (1 - over) * rocks * above, rel=1e-12)
    assert probability(cloud, 0.25, 0.0)[0] == pytest.approx(over + (1 - over) * rocks, rel=1e-12)


def test_classes_that_do_not_overlap_are_a_step():
    cloud = fit([0.1, 0.2, 0.3, 0.4, 0.5], [0.1, 0.25, 0.3, np.inf, np.inf])
    np.testing.assert_allclose(probability(cloud, [0.30, 0.34, 0.35, 0.4], np.inf), [0.0, 0.0, 1.0, 1.0], atol=1e-9)


def test_nothing_overturns():
    im, d = records(5)
    assert probability(fit(im, d), 100.0, np.inf) == 0.0
    assert np.isnan(equivalent(im, d, np.inf)[0])


@pytest.mark.parametrize("demand", [[0.1, 0.2, np.inf, np.inf], [0.0, 0.0, 0.0, 0.3], [np.inf] * 4])
def test_too_few_that_rock_make_no_cloud(demand):
    assert np.isnan(fit([0.1, 0.2, 0.3, 0.4], demand)[:3]).any()


def test_trend_is_scipys():
    rng = np.random.default_rng(6)
    x, y = rng.uniform(5, 8, 30), rng.standard_normal(30)
    found, oracle = trend(y + 0.2 * x, x), linregress(x, y + 0.2 * x)
    np.testing.assert_allclose([found.slope, found.p_value], [oracle.slope, oracle.pvalue], rtol=1e-9)
    assert found.n == 30


def test_holm_is_the_hand_calculation():
    """0.005 x 4, 0.01 x 3, then 0.03 x 2 = 0.06, and 0.04 x 1, which may not be less than the one before."""
    np.testing.assert_allclose(holm([0.01, 0.04, 0.03, 0.005]), [0.03, 0.06, 0.06, 0.02], rtol=1e-15)
    np.testing.assert_array_equal(holm([0.9, 0.8]), [1.0, 1.0])
    assert holm([]).size == 0


def test_trend_by_event_is_not_fooled_by_its_records():
    """Records of one event share magnitude and residual: of 400 trials without a trend 5 % should find one at 5 %."""
    rng, plain, robust = np.random.default_rng(7), 0, 0
    event = np.repeat(np.arange(30), 5)
    for _ in range(400):
        x = rng.uniform(5, 8, 30)[event]
        y = 0.4 * rng.standard_normal(30)[event] + 0.2 * rng.standard_normal(150)
        plain += trend(y, x).p_value < 0.05
        robust += trend(y, x, event=[str(each) for each in event]).p_value < 0.05
    assert plain / 400 > 0.25
    assert robust / 400 == pytest.approx(0.05, abs=0.04)


def test_cluster_variance_is_the_published_formula():
    """CR1: (X'X)^-1 sum X_g' u_g u_g' X_g (X'X)^-1 times G/(G-1) (N-1)/(N-K), p-value by t of G - 1."""
    from scipy.stats import t

    rng = np.random.default_rng(8)
    event = np.repeat(np.arange(8), [1, 2, 3, 4, 5, 6, 7, 8])
    x, y = rng.standard_normal(36), rng.standard_normal(36)
    X = np.stack([np.ones(36), x], axis=1)
    bread = np.linalg.inv(X.T @ X)
    slope = bread @ X.T @ y
    u = y - X @ slope
    scores = [X[event == each].T @ u[event == each] for each in range(8)]
    V = bread @ sum(np.outer(s, s) for s in scores) @ bread * 8 / 7 * 35 / 34
    p = 2 * t.sf(abs(slope[1]) / np.sqrt(V[1, 1]), 7)
    found = trend(y, x, event=[str(each) for each in event])
    np.testing.assert_allclose([found.slope, found.p_value], [slope[1], p], rtol=1e-9)


@pytest.mark.parametrize(("x", "event"), [([6, 7], None), ([6, 6, 6], None), ([6, 7, 8], ["a", "a", "b"]), ([], None)])
def test_no_trend_of_too_few(x, event):
    assert trend(np.arange(len(x)), x, event=event) is None
