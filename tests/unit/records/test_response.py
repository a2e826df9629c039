"""Response spectra against scipy's integrators and closed forms, compiled and as plain Python."""

from itertools import accumulate

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from scipy.signal import lsim

from records.errors import RecordError
from records.kernel import advance, peak_displacements
from records.reading import read_records
from records.record import Record, make_record, scale
from records.response import displacement_spectrum, response_spectrum
from tests.support.motions import white_noise
from tests.support.places import PEER, needs_real_records


def exact_peak(record: Record, *, period: float, damping: float) -> float:
    """Largest displacement by matrix exponentials at points 0.005 rad apart, and the parabola at the largest of them.

    The state is displacement, velocity, acceleration of the ground and its slope; two periods of rest after the end.
    """
    omega, dt = 2 * np.pi / period, record.dt
    rest = int(np.ceil(2 * period / np.sqrt(1 - damping**2) / dt)) + 1
    slope = np.append(np.diff(record.acceleration) / dt, np.zeros(rest))
    a = np.append(record.acceleration[:-1], np.zeros(rest))
    system = np.array([[0, 1, 0, 0], [-(omega**2), -2 * damping * omega, -1, 0], [0, 0, 0, 1], [0, 0, 0, 0]])
    points = int(np.ceil(omega * dt / 0.005)) + 1
    part = expm(system * dt / points)
    within = np.array(list(accumulate([part] * points, np.matmul)))
    state, found = np.zeros(2), []
    for now, rise in zip(a, slope, strict=True):
        found.append(within @ np.array([*state, now, rise]))
        state = found[-1][-1, :2]
    u, v, ground = np.concatenate(found)[:, :3].T
    at = int(np.argmax(np.abs(u)))
    bend = -ground[at] - 2 * damping * omega * v[at] - omega**2 * u[at]
    inside = abs(v[at]) < abs(bend) * dt / points  # else it is at a sample, where the ground's slope changes
    return float(max(np.abs(u).max(), abs(u[at] - 0.5 * v[at] ** 2 / bend) if inside else 0.0))


@pytest.mark.parametrize("damping", [0.0, 0.05, 0.4])
@pytest.mark.parametrize("period", [0.004, 0.008, 0.013, 0.03, 0.2, 0.5, 3.0])
@pytest.mark.parametrize("seed", range(2))
def test_displacements_are_those_of_matrix_exponentials(seed: int, period: float, damping: float) -> None:
    """Of noise, and of noise that grows and dies, at periods from 0.4 to 300 steps."""
    record = white_noise(seed, npts=200)
    bell = np.sin(np.linspace(0.0, np.pi, record.npts)) ** 4 if seed % 2 else 1.0
    record = make_record("noise", record.acceleration * bell, record.dt)
    ours = displacement_spectrum(record, period, damping=damping)
    assert ours == pytest.approx(exact_peak(record, period=period, damping=damping), rel=1e-7)


@pytest.mark.parametrize("shape", ["smooth", "spike", "step", "one"])
def test_a_maximum_between_samples_of_any_motion_is_found(shape: str) -> None:
    """Smooth motion has its maxima anywhere in a step, a spike in the free vibration after the end."""
    motion = {
        "smooth": np.sin(np.linspace(0.0, 31.4, 300)) * np.sin(np.linspace(0.0, np.pi, 300)),
        "spike": np.r_[np.zeros(37), 1.0, np.zeros(3)],
        "step": np.ones(90),
        "one": np.array([0.0, 1.0]),
    }[shape]
    record = make_record(shape, motion, 0.02)
    periods = np.geomspace(0.01, 4.0, 15)
    expected = [exact_peak(record, period=T, damping=0.05) for T in periods]
    np.testing.assert_allclose(displacement_spectrum(record, periods), expected, rtol=1e-7)


@needs_real_records
def test_real_records_and_what_maxima_at_samples_would_be() -> None:
    """At periods of twenty samples and less, where spectra at samples and at a twentieth of the period were low."""
    files = sorted(PEER.glob("RSN*.AT2"))[:3]
    low = []
    for (record,) in map(read_records, files):
        period = record.dt * np.array([1.7, 8.0, 20.0, 33.0])
        found = displacement_spectrum(record, period)
        strongest = int(np.argmax(np.abs(record.acceleration)))
        part = make_record("part", record.acceleration[max(strongest - 200, 0) : strongest + 40], record.dt)
        for T in period:
            assert displacement_spectrum(part, T) == pytest.approx(exact_peak(part, period=T, damping=0.05), rel=1e-7)
        for T, S_d in zip(period, found, strict=True):  # at the samples, by scipy's first-order hold
            omega = 2 * np.pi / T
            system = ([[0.0, 1.0], [-(omega**2), -0.1 * omega]], [[0.0], [-1.0]], [[1.0, 0.0]], [[0.0]])
            low.append(np.abs(lsim(system, record.acceleration, record.time)[1]).max() / S_d - 1)
    assert -0.2 < min(low) < -0.002
    assert max(low) <= 1e-9


def test_records_of_any_length_and_oscillators_of_any_company_agree() -> None:
    """Steps are marched in blocks, oscillators side by side: neither may show."""
    periods = np.geomspace(0.01, 3.0, 23)
    for npts in range(2, 36):
        record = white_noise(npts=npts)
        together = displacement_spectrum(record, periods)
        np.testing.assert_allclose(together, [displacement_spectrum(record, T) for T in periods], rtol=1e-12)
        longer = make_record("rest first", np.append(np.zeros(7), record.acceleration * (np.arange(npts) > 0)), 0.01)
        shorter = make_record("rest", record.acceleration * (np.arange(npts) > 0), 0.01)
        np.testing.assert_allclose(
            displacement_spectrum(longer, periods), displacement_spectrum(shorter, periods), rtol=1e-12
        )


@pytest.mark.parametrize("period", [0.03, 0.1, 0.7])
def test_maxima_are_those_of_dop853(period: float) -> None:
    """Dense between samples; the record ends in rest so that one period of free motion can be appended."""
    shaken = np.append(white_noise(npts=100).acceleration, 0.0)
    acceleration = np.concatenate([shaken, np.zeros(round(period / 0.01))])
    time, omega = 0.01 * np.arange(acceleration.size), 2 * np.pi / period
    peak, state = 0.0, np.zeros(2)
    for start, end, a, b in zip(time[:-1], time[1:], acceleration[:-1], acceleration[1:], strict=True):

        def motion(t: float, y: np.ndarray) -> list[float]:
            return [y[1], -(a + (b - a) * (t - start) / 0.01) - 0.1 * omega * y[1] - omega**2 * y[0]]  # noqa: B023

        piece = solve_ivp(motion, (start, end), state, method="DOP853", rtol=1e-10, atol=1e-14, dense_output=True)
        peak, state = max(peak, np.abs(piece.sol(np.linspace(start, end, 200))[0]).max()), piece.y[:, -1]
    ours = float(displacement_spectrum(make_record("noise", shaken, 0.01), period))
    assert ours / peak == pytest.approx(1.0, rel=(omega * 0.01 / 200) ** 2 / 8 + 1e-8)


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
    record = white_noise()
    periods = np.array([[0.0, 0.3], [1.0, 0.0]])
    spectrum = response_spectrum(record, periods)
    assert spectrum.shape == (2, 2)
    assert spectrum[0, 0] == spectrum[1, 1] == record.pga
    assert spectrum[1, 0] == response_spectrum(record, 1.0)
    assert displacement_spectrum(record, 0.0) == 0.0
    assert response_spectrum(record, 1e-4)[()] == pytest.approx(record.pga, rel=0.02)


def test_the_spectrum_is_linear_and_blind_to_sign() -> None:
    record, periods = white_noise(), np.geomspace(0.05, 3.0, 20)
    np.testing.assert_allclose(
        response_spectrum(scale(record, -2.5), periods), 2.5 * response_spectrum(record, periods), rtol=1e-12
    )


def test_the_kernel_is_the_same_compiled_and_plain() -> None:
    record, periods = white_noise(npts=120), np.array([0.03, 0.4, 2.0])
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
        response_spectrum(white_noise(), period, damping=damping)
