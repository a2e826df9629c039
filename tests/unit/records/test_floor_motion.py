"""A record up a building, against scipy's integrators and what must hold at the limits."""

import numpy as np
import pytest
from scipy.signal import lsim

from assess.amplification import floor_motion
from records.errors import RecordError
from records.kernel import relative_accelerations
from records.record import make_record
from records.response import response_spectrum
from tests.support.motions import white_noise


@pytest.mark.parametrize("shape", [0.0, 0.6, 1.4])
@pytest.mark.parametrize("frequency", [0.7, 2.5, 7.7])
def test_it_is_ground_and_mode_added_in_time(frequency: float, shape: float) -> None:
    record, omega = white_noise(npts=300), 2 * np.pi * frequency
    at = floor_motion(record, frequency=frequency, shape=shape)
    parts = round(record.dt / at.dt)
    time = at.time[: (record.npts - 1) * parts + 1]
    ground = np.interp(time, record.time, record.acceleration)
    system = ([[0, 1], [-(omega**2), -0.1 * omega]], [[0], [-1]], [[-(omega**2), -0.1 * omega]], [[-1]])
    _, relative, _ = lsim(system, ground, time)  # first-order hold: exact for lines between samples
    np.testing.assert_allclose(at.acceleration[: time.size], ground + shape * relative, atol=1e-9)
    assert at.dt * frequency <= 1 / 100 + 1e-12


def test_it_goes_on_until_the_free_vibration_has_faded() -> None:
    record = make_record("sine", np.sin(2 * np.pi * np.arange(2000) * 0.01), 0.01)
    at = floor_motion(record, frequency=1.0, shape=1.0)
    assert np.abs(at.acceleration[-50:]).max() < 0.015 * at.pga
    assert at.time[-1] > record.time[-1] + 10.0


def test_a_rigid_building_moves_with_the_ground() -> None:
    time = 0.01 * np.arange(1200)
    record = make_record("slow", np.sin(np.pi * time / 4.0) ** 2, 0.01)  # begins without a jump of its slope
    at = floor_motion(record, frequency=80.0, shape=1.0)
    np.testing.assert_allclose(np.interp(time, at.time, at.acceleration), record.acceleration, atol=2e-3)
    assert at.pga == pytest.approx(1.0, rel=2e-3)


def test_at_the_effective_height_its_peak_is_the_spectral_acceleration() -> None:
    """Total acceleration of the oscillator; without damping it equals the pseudo-acceleration, at 1 % nearly."""
    record = white_noise(npts=1500)
    at = floor_motion(record, frequency=2.0, shape=1.0, damping=0.01)
    assert at.pga == pytest.approx(float(response_spectrum(record, 0.5, damping=0.01)), rel=5e-3)


@pytest.mark.parametrize("frequency", [0.7, 2.5, 7.7])
def test_its_peak_is_that_of_the_motion_between_its_samples(frequency: float) -> None:
    """Against a step thirty times finer: its lines cut off no more than 1 - cos(pi / 100) of a sine."""
    record, omega = white_noise(npts=300), 2 * np.pi * frequency
    at = floor_motion(record, frequency=frequency, shape=1.4)
    time = np.linspace(0.0, record.time[-1], (record.npts - 1) * 30 * round(record.dt / at.dt) + 1)
    ground = np.interp(time, record.time, record.acceleration)
    system = ([[0, 1], [-(omega**2), -0.1 * omega]], [[0], [-1]], [[-(omega**2), -0.1 * omega]], [[-1]])
    _, relative, _ = lsim(system, ground, time)
    assert 1 - 5e-4 <= at.pga / np.abs(ground + 1.4 * relative).max() <= 1 + 1e-9


def test_what_was_done_stands_in_the_trail() -> None:
    assert "first mode of 2.5 Hz" in str(
        floor_motion(white_noise(npts=300), frequency=2.5, shape=1.0).processing_history[-1]
    )


def test_the_kernel_is_the_same_compiled_and_plain() -> None:
    given = (white_noise(npts=60).acceleration, 0.01, 3, 0.4, 0.05)
    np.testing.assert_allclose(relative_accelerations(*given), relative_accelerations.py_func(*given), rtol=1e-11)


@pytest.mark.parametrize(
    ("frequency", "shape", "damping", "words"),
    [
        (0.0, 1.0, 0.05, "natural frequency 0.0 Hz"),
        (np.nan, 1.0, 0.05, "natural frequency nan Hz"),
        (1e6, 1.0, 0.05, "too coarse"),
        (1.0, np.inf, 0.05, "counts inf"),
        (1.0, 1.0, 0.0, "damping ratio 0.0"),
        (1.0, 1.0, 1.0, "damping ratio 1.0"),
        (1.0, 1.0, 1.5, "damping ratio 1.5"),
        (1.0, 1.0, np.nan, "damping ratio nan"),
    ],
)
def test_impossible_buildings_are_refused(frequency: float, shape: float, damping: float, words: str) -> None:
    with pytest.raises(RecordError, match=words):
        floor_motion(white_noise(npts=300), frequency=frequency, shape=shape, damping=damping)
