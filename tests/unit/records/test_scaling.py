"""Scale factors: the optimum against a numerical search, invariants, refusals."""

import numpy as np
import pytest
from scipy.constants import g
from scipy.optimize import minimize_scalar

from records.errors import RecordError
from records.record import Record, make_record, scale
from records.response import response_spectrum
from records.scaling import SCALING_PERIODS, misfit, scale_to_pga, scale_to_spectrum
from spectra.asce7 import design_spectrum

TARGET = design_spectrum(s_ds=0.1667 * g, s_d1=0.0533 * g, t_l=6.0)


@pytest.fixture(scope="module")
def record() -> Record:
    return make_record("noise", np.random.default_rng(3).normal(size=1000), 0.01)


def test_the_band_is_log_spaced_from_a_tenth_to_two_seconds() -> None:
    assert (SCALING_PERIODS[0], SCALING_PERIODS[-1]) == pytest.approx((0.1, 2.0), rel=1e-12)
    np.testing.assert_allclose(np.diff(np.log(SCALING_PERIODS)), np.log(20.0) / (len(SCALING_PERIODS) - 1), rtol=1e-9)


def test_the_factor_minimises_the_mean_squared_log_difference(record: Record) -> None:
    own, target = response_spectrum(record, SCALING_PERIODS), TARGET.acceleration(SCALING_PERIODS)
    best = minimize_scalar(lambda x: np.mean((np.log(target) - np.log(np.exp(x) * own)) ** 2), tol=1e-12)
    scaling = scale_to_spectrum(record, TARGET)
    assert scaling.factor == pytest.approx(np.exp(best.x), rel=1e-6)
    assert scaling.mse == pytest.approx(best.fun, rel=1e-9)
    assert scaling.mse == pytest.approx(misfit(record, TARGET, factor=scaling.factor), rel=1e-12)
    assert misfit(scale(record, scaling.factor), TARGET) == pytest.approx(scaling.mse, rel=1e-9)


def test_a_scaled_record_needs_no_more_scaling(record: Record) -> None:
    first = scale_to_spectrum(record, TARGET)
    again = scale_to_spectrum(scale(record, first.factor), TARGET)
    assert again.factor == pytest.approx(1.0, rel=1e-12)
    assert again.mse == pytest.approx(first.mse, rel=1e-9)


def test_one_period_is_met_exactly(record: Record) -> None:
    scaling = scale_to_spectrum(record, TARGET, period=0.5)
    assert scaling.factor * response_spectrum(record, 0.5) == pytest.approx(float(TARGET.acceleration(0.5)), rel=1e-12)
    assert scaling.mse == 0.0


def test_scaling_to_a_peak_acceleration(record: Record) -> None:
    assert scale(record, scale_to_pga(record, 0.3 * g)).pga == pytest.approx(0.3 * g, rel=1e-14)


@pytest.mark.parametrize("pga", [0.0, -1.0, float("nan"), float("inf")])
def test_a_peak_acceleration_that_is_none_is_refused(record: Record, pga: float) -> None:
    with pytest.raises(RecordError, match="must be positive"):
        scale_to_pga(record, pga)


def test_a_record_without_motion_cannot_be_scaled() -> None:
    still = make_record("still", np.zeros(100), 0.01)
    with pytest.raises(RecordError, match=r'record "still": no motion at a period of 0\.1 s'):
        scale_to_spectrum(still, TARGET)
    with pytest.raises(RecordError, match='record "still": no motion'):
        scale_to_pga(still, 1.0)
