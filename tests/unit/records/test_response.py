"""Response spectra against scipy's integrators and closed forms, compiled and as plain Python."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.signal import lsim

from records.errors import RecordError
from records.kernel import advance, peak_displacements
from records.record import Record, make_record, scaled
from records.response import displacement_spectrum, response_spectrum


def noise(npts: int = 400, dt: float = 0.01, seed: int = 5) -> Record:
    return make_record("noise", np.random.default_rng(seed).normal(size=npts), dt)


def lsim_peak(record: Record, *, period: float, damping: float, dt: float) -> float:
    """Largest displacement by scipy's first-order-hold simulation at step `dt`, two periods of rest after the end."""
    omega = 2 * np.pi / period
    end = record.time[-1]
    during = np.linspace(0.0, end, round(end / dt) + 1)
    system = ([[0.0, 1.0], [-(omega**2), -2 * damping * omega]], [[0.0], [-1.0]], np.eye(2), np.zeros((2, 1)))
    _, out, _ = lsim(system, np.interp(during, record.time, record.acceleration), during)
    after = np.arange(0.0, 2 * period, dt)
    _, rest, _ = lsim(system, np.zeros_like(after), after, X0=out[-1])
    return float(max(np.abs(out[:, 0]).max(), np.abs(rest[:, 0]).max()))


@pytest.mark.parametrize("damping", [0.0, 0.05, 0.4])
@pytest.mark.parametrize("period", [0.2, 0.5, 1.0, 3.0])
def test_displacements_are_those_of_scipy(period: float, damping: float) -> None:
    record = noise()
    ours = displacement_spectrum(record, period, damping=damping)
    assert ours == pytest.approx(lsim_peak(record, period=period, damping=damping, dt=record.dt), rel=1e-9)


@pytest.mark.parametrize("damping", [0.0, 0.05, 0.4])
@pytest.mark.parametrize("period", [0.008, 0.013, 0.03, 0.05, 0.09, 0.19])
@pytest.mark.parametrize("seed", range(4))
def test_a_short_period_divides_the_step(seed: int, period: float, damping: float) -> None:
    """Every step is divided for scipy; ours are where the maximum may be. Noise, and noise that grows and dies."""
    record = noise(seed=seed)
    bell = np.sin(np.linspace(0.0, np.pi, record.npts)) ** 4 if seed % 2 else 1.0
    record = make_record("noise", record.acceleration * bell, record.dt)
    dt = record.dt / np.ceil(20 * record.dt / period - 1e-9)
    ours = displacement_spectrum(record, period, damping=damping)
    assert ours == pytest.approx(lsim_peak(record, period=period, damping=damping, dt=dt), rel=1e-9)


def test_records_of_any_length_and_oscillators_of_any_company_agree() -> None:
    """Steps are marched in blocks, oscillators side by side: neither may show."""
    periods = np.geomspace(0.01, 3.0, 23)
    for npts in range(2, 36):
        record = noise(npts)
        together = displacement_spectrum(record, periods)
        np.testing.assert_allclose(together, [displacement_spectrum(record, T) for T in periods], rtol=1e-12)
        longer = make_record("rest first", np.append(np.zeros(7), record.acceleration * (np.arange(npts) > 0)), 0.01)
        shorter = make_record("rest", record.acceleration * (np.arange(npts) > 0), 0.01)
        np.testing.assert_allclose(
            displacement_spectrum(longer, periods), displacement_spectrum(shorter, periods), rtol=1e-12
        )


@pytest.mark.parametrize("period", [0.03, 0.1, 0.7])
def test_maxima_at_samples_lie_at_most_their_share_below_those_between(period: float) -> None:
    """DOP853, dense between samples; the record ends in rest so that one period of free motion can be appended."""
    shaken = np.append(noise(200).acceleration, 0.0)
    acceleration = np.concatenate([shaken, np.zeros(round(period / 0.01))])
    time, omega = 0.01 * np.arange(acceleration.size), 2 * np.pi / period
    peak, state = 0.0, np.zeros(2)
    for start, end, a, b in zip(time[:-1], time[1:], acceleration[:-1], acceleration[1:], strict=True):

        def motion(t: float, y: np.ndarray) -> list[float]:
            return [y[1], -(a + (b - a) * (t - start) / 0.01) - 0.1 * omega * y[1] - omega**2 * y[0]]  # noqa: B023

        piece = solve_ivp(motion, (start, end), state, method="DOP853", rtol=1e-9, atol=1e-12, dense_output=True)
        peak, state = max(peak, np.abs(piece.sol(np.linspace(start, end, 20))[0]).max()), piece.y[:, -1]
    ours = float(displacement_spectrum(make_record("noise", shaken, 0.01), period))
    assert np.cos(np.pi / 20) <= ours / peak <= 1 + 1e-3  # 20 looks a step leave the dense peak itself 1e-3 short


def test_free_vibration_after_the_end_counts() -> None:
    """A pulse of area A that is short beside the period: S_v = A, undamped, and the peak comes a quarter period on."""
    record = make_record("pulse", [0.0, 1.0, 0.0], 0.001)
    assert displacement_spectrum(record, 2.0, damping=0.0) == pytest.approx(0.001 / np.pi, rel=1e-3)


def test_a_steady_acceleration_from_rest_doubles_the_static_displacement() -> None:
    record = make_record("step", np.ones(2000), 0.005)
    static = 1.0 / (2 * np.pi / 0.5) ** 2
    peak = 1 + np.exp(-np.pi * 0.05 / np.sqrt(1 - 0.05**2))
    assert displacement_spectrum(record, 0.5, damping=0.0) == pytest.approx(2 * static, rel=1e-6)
    assert displacement_spectrum(record, 0.5) == pytest.approx(peak * static, rel=1e-4)


def test_resonance_grows_to_one_over_twice_the_damping() -> None:
    time = 0.005 * np.arange(20000)
    record = make_record("sine", np.sin(2 * np.pi * time), 0.005)
    assert response_spectrum(record, 1.0) == pytest.approx(10.0, rel=2e-3)  # sqrt(1 + 4 xi^2) beside it is 0.5 %


def test_zero_period_is_the_peak_acceleration_and_shapes_are_kept() -> None:
    record = noise()
    periods = np.array([[0.0, 0.3], [1.0, 0.0]])
    spectrum = response_spectrum(record, periods)
    assert spectrum.shape == (2, 2)
    assert spectrum[0, 0] == spectrum[1, 1] == record.pga
    assert spectrum[1, 0] == response_spectrum(record, 1.0)
    assert displacement_spectrum(record, 0.0) == 0.0
    assert response_spectrum(record, 1e-4)[()] == pytest.approx(record.pga, rel=0.02)


def test_the_spectrum_is_linear_and_blind_to_sign() -> None:
    record, periods = noise(), np.geomspace(0.05, 3.0, 20)
    np.testing.assert_allclose(
        response_spectrum(scaled(record, -2.5), periods), 2.5 * response_spectrum(record, periods), rtol=1e-12
    )


def test_the_kernel_is_the_same_compiled_and_plain() -> None:
    record, periods = noise(120), np.array([0.03, 0.4, 2.0])
    compiled = peak_displacements(record.acceleration, record.dt, periods, 0.05)
    plain = peak_displacements.py_func(record.acceleration, record.dt, periods, 0.05)
    np.testing.assert_allclose(compiled, plain, rtol=1e-11)
    state = (0.1, -0.2, 0.3, 4.0, 0.05, 7.0, 0.05)
    np.testing.assert_allclose(advance(*state), advance.py_func(*state), rtol=1e-14)


@pytest.mark.parametrize(
    ("period", "damping", "words"),
    [
        (-1.0, 0.05, "not negative"),
        (float("nan"), 0.05, "period nan"),
        (float("inf"), 0.05, "period inf"),
        (1.0, 1.0, "damping ratio 1.0"),
        (1.0, -0.1, "damping ratio -0.1"),
        (1.0, float("nan"), "damping ratio nan"),
        (1e-9, 0.05, "too coarse"),
    ],
)
def test_impossible_oscillators_are_refused(period: float, damping: float, words: str) -> None:
    with pytest.raises(RecordError, match=words):
        response_spectrum(noise(), period, damping=damping)
