"""Measures of harmonic motions and pulses against their closed forms."""

import numpy as np
import pytest
from scipy.constants import g

from records.record import make_record
from records.response import (
    HOUSNER_PERIODS,
    arias,
    cav,
    displacement,
    housner,
    mean_period,
    measures,
    pgd,
    pgv,
    response_spectrum,
    significant_duration,
    velocity,
)

A, CYCLES, F = 3.0, 20, 2.0  # m/s2, cycles, Hz
STEPS = 400  # a cycle


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("npts", [2, 3, 40])
def test_peaks_between_samples_count(npts: int, seed: int) -> None:
    """Against a thousand points to a step, on which the record has the same lines."""
    a = np.random.default_rng(seed).normal(size=npts)
    fine = np.interp(np.arange(1000 * (npts - 1) + 1) / 1000.0, np.arange(npts), a)
    coarse, dense = make_record("coarse", a, 1.0), make_record("dense", fine, 1e-3)
    assert pgv(coarse) == pytest.approx(np.abs(velocity(dense)).max(), rel=2e-6)
    assert pgd(coarse) == pytest.approx(np.abs(displacement(dense)).max(), rel=2e-6)


def test_peaks_of_a_triangle_lie_between_its_samples() -> None:
    """From 1 to -1 m/s2 in 1 s: the velocity is largest in the middle, 1/4 m/s; the displacement at the end, 1/6 m."""
    record = make_record("line", [1.0, -1.0], 1.0)
    assert pgv(record) == pytest.approx(0.25, rel=1e-14)
    assert pgd(record) == pytest.approx(1 / 6, rel=1e-14)
    assert pgv(make_record("still", [0.0, 0.0], 1.0)) == pgd(make_record("still", [0.0, 0.0], 1.0)) == 0.0


def test_a_harmonic_motion() -> None:
    duration, omega = CYCLES / F, 2.0 * np.pi * F
    time = np.arange(CYCLES * STEPS + 1) / (STEPS * F)
    record = make_record("harmonic", A * np.cos(omega * time), 1.0 / (STEPS * F))  # whole cycles
    assert record.pga == A
    assert pgv(record) == pytest.approx(A / omega, rel=1e-4)
    assert pgd(record) == pytest.approx(2.0 * A / omega**2, rel=1e-4)  # (A / omega^2) (1 - cos)
    assert arias(record) == pytest.approx(np.pi / (2.0 * g) * A**2 * duration / 2.0, rel=1e-4)
    assert cav(record) == pytest.approx(A * duration * 2.0 / np.pi, rel=1e-4)
    assert significant_duration(record, start=0.05, end=0.95) == pytest.approx(0.9 * duration, rel=1e-2)
    assert significant_duration(record, start=0.05, end=0.75) == pytest.approx(0.7 * duration, rel=1e-2)
    assert mean_period(record) == pytest.approx(1.0 / F, rel=0.02)  # leaks to both sides of F


def test_a_pulse_of_two_rectangles() -> None:
    """A for 1 s, -A for 1 s, zero for 1 s; the jumps are one step of 1e-4 s long."""
    time = 1e-4 * np.arange(30_001)
    record = make_record("rectangle", np.where(time < 1.0, A, np.where(time < 2.0, -A, 0.0)), 1e-4)
    assert pgv(record) == pytest.approx(A, rel=2e-4)
    assert pgd(record) == pytest.approx(A, rel=4e-4)  # A t^2 / 2 twice
    assert arias(record) == pytest.approx(np.pi / (2.0 * g) * 2.0 * A**2, rel=2e-4)
    assert cav(record) == pytest.approx(2.0 * A, rel=2e-4)
    assert significant_duration(record, start=0.05, end=0.95) == pytest.approx(1.8, rel=1e-3)
    assert significant_duration(record, start=0.05, end=0.75) == pytest.approx(1.4, rel=1e-3)


def test_the_mean_period_of_two_harmonics_weighs_by_power() -> None:
    time = 0.005 * np.arange(40_000)
    record = make_record("two", np.sin(2 * np.pi * time) + 2.0 * np.sin(2 * np.pi * 5.0 * time), 0.005)
    assert mean_period(record) == pytest.approx((1.0 * 1.0 + 4.0 * 0.2) / 5.0, rel=5e-3)


def test_frequencies_outside_the_band_do_not_count() -> None:
    time = 0.005 * np.arange(40_000)
    inside = np.sin(2 * np.pi * 5.0 * time)
    with_others = inside + 5.0 * np.sin(2 * np.pi * 0.1 * time) + 5.0 * np.sin(2 * np.pi * 40.0 * time)
    assert mean_period(make_record("all", with_others, 0.005)) == pytest.approx(0.2, rel=2e-2)


def test_housner_intensity_of_a_velocity_step_is_its_pseudo_velocity_times_the_band() -> None:
    """A short blow leaves undamped oscillators with the velocity A dt, whatever their period."""
    samples = np.zeros(6000)
    samples[1] = 100.0  # a triangle of 100 x 0.001 m/s
    record = make_record("blow", samples, 0.001)
    assert housner(record, damping=0.0) == pytest.approx(0.1 * 2.4, rel=2e-3)


def test_housner_intensity_converges() -> None:
    record = make_record("noise", np.random.default_rng(2).normal(size=2000), 0.01)
    fine = np.linspace(0.1, 2.5, 1201)
    PSV = response_spectrum(record, fine) * fine / (2.0 * np.pi)
    assert housner(record) == pytest.approx(float(np.trapezoid(PSV, fine)), rel=5e-3)
    assert (HOUSNER_PERIODS[0], HOUSNER_PERIODS[-1]) == (0.1, 2.5)


def test_all_measures_scale_with_the_motion_but_durations_and_the_mean_period() -> None:
    record = make_record("noise", np.random.default_rng(2).normal(size=2000), 0.01)
    one, two = measures(record), measures(make_record("twice", 2.0 * record.acceleration, 0.01))
    for name, factor in {"pga": 2, "pgv": 2, "pgd": 2, "arias": 4, "cav": 2, "housner": 2}.items():
        assert getattr(two, name) == pytest.approx(factor * getattr(one, name), rel=1e-9)
    for name in ("d5_75", "d5_95", "mean_period"):
        assert getattr(two, name) == pytest.approx(getattr(one, name), rel=1e-9)


def test_a_motion_below_the_band_has_no_mean_period() -> None:
    still = make_record("still", np.zeros(100), 0.01)
    assert (mean_period(still), significant_duration(still, start=0.05, end=0.95)) == (0.0, 0.0)
