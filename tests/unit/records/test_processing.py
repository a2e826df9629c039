"""Processing of records against closed forms, and the rotation of two components."""

from collections.abc import Callable

import numpy as np
import pytest
from scipy.signal.windows import tukey

from assess.messages.message import Quantity
from records.errors import RecordError
from records.processing import butterworth, correct_baseline, resample, rotate_to_azimuth, rotd, rotd_spectrum, trim
from records.record import Record, make_record
from records.response import displacement, integrate_absolute, integrate_squared, response_spectrum, velocity
from tests.support.motions import white_noise

DT = 0.01
TIME = DT * np.arange(4001)
NOISE = white_noise(1, npts=TIME.size)


def sine(frequency: float, *, dt: float = DT) -> Record:
    """Twenty seconds of a sine that grows and fades smoothly."""
    time = dt * np.arange(round(40.0 / dt) + 1)
    return make_record("sine", np.exp(-(((time - 20.0) / 5.0) ** 2)) * np.sin(2 * np.pi * frequency * time), dt)


def test_velocity_and_displacement_of_a_line() -> None:
    record = make_record("line", 2.0 + 3.0 * TIME, DT)
    np.testing.assert_allclose(velocity(record), 2.0 * TIME + 1.5 * TIME**2, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(displacement(record), TIME**2 + 0.5 * TIME**3, rtol=1e-12, atol=1e-12)


def test_integrals_over_a_step_that_changes_sign() -> None:
    record = make_record("line", [-1.0, 3.0], 1.0)  # zero at 1/4: triangles of 1/8 and 9/8; squared (1 - 3 + 9) / 3
    assert integrate_absolute(record)[-1] == pytest.approx(1.25, rel=1e-15)
    assert integrate_squared(record)[-1] == pytest.approx(7.0 / 3.0, rel=1e-15)


@pytest.mark.parametrize("degree", [0, 1, 2, 5])
def test_a_baseline_of_its_degree_goes_and_leaves_the_trail(degree: int) -> None:
    drift = np.polynomial.Polynomial(np.random.default_rng(degree).normal(size=degree + 1))(TIME / 40.0)
    record = make_record("drift", drift + 1e-30 * TIME, DT)
    corrected = correct_baseline(record, degree=degree)
    np.testing.assert_allclose(corrected.acceleration, 0.0, rtol=0, atol=1e-12)
    (step,) = corrected.processing_history
    assert str(step) == f"baseline of degree {degree} taken off"
    assert np.max(np.abs(record.acceleration)) > 1e-3  # the record itself is as it was


def test_a_corrected_record_has_no_baseline_left() -> None:
    once = correct_baseline(NOISE, degree=3)
    np.testing.assert_allclose(correct_baseline(once, degree=3).acceleration, once.acceleration, rtol=0, atol=1e-12)
    assert np.mean(once.acceleration) == pytest.approx(0.0, abs=1e-12)


@pytest.mark.parametrize(
    ("frequency", "low", "high", "gain"),
    [
        (2.0, 0.1, 25.0, 1.0),  # inside the band, untouched and not shifted
        (2.0, 2.0, None, 0.5),  # at a corner of two passes: half
        (2.0, None, 2.0, 0.5),
        (2.0, None, 1.0, 1.0 / (1.0 + 2.0**8)),  # two passes of order 4 an octave off
        (2.0, 4.0, None, 1.0 / (1.0 + 2.0**8)),
    ],
)
def test_the_filter_has_the_gain_of_butterworth_twice_and_no_phase(
    frequency: float, low: float | None, high: float | None, gain: float
) -> None:
    time = DT * np.arange(10_001)  # tapered over 20 s at both ends
    record = make_record("steady", tukey(time.size, 0.4) * np.sin(2 * np.pi * frequency * time), DT)
    filtered = butterworth(record, low=low, high=high, order=4)
    inner = slice(4500, 5500)  # long after the ends
    np.testing.assert_allclose(
        filtered.acceleration[inner], gain * record.acceleration[inner], rtol=0, atol=0.04 * gain
    )  # the bilinear transform bends the ratio of frequencies by 0.4 %, to the 8th power
    assert (filtered.npts, filtered.dt) == (record.npts, record.dt)
    assert "acausal Butterworth of order 4" in str(filtered.processing_history[-1])


def test_the_filter_reads_the_same_backwards() -> None:
    record = NOISE
    backwards = make_record("backwards", record.acceleration[::-1], DT)
    forwards = butterworth(record, low=0.2, high=20.0).acceleration
    np.testing.assert_allclose(
        butterworth(backwards, low=0.2, high=20.0).acceleration[::-1], forwards, rtol=0, atol=1e-8
    )


@pytest.mark.parametrize("dt", [0.005, 0.02, 0.004, 0.0125, 1.0 / 128.0])
def test_what_both_steps_can_show_stays(dt: float) -> None:
    slow, wanted = sine(3.0), sine(3.0, dt=dt)
    found = resample(slow, dt=dt)
    shared = min(found.npts, wanted.npts)
    np.testing.assert_allclose(found.acceleration[:shared], wanted.acceleration[:shared], rtol=0, atol=2e-4)
    assert found.dt == dt
    assert str(found.processing_history[-1]).startswith("resampled from 0.01 s to")


def test_what_the_new_step_cannot_show_is_gone_and_not_folded_back() -> None:
    assert resample(sine(40.0), dt=0.02).pga < 1e-3  # 40 Hz would come back as 10 Hz
    assert np.abs(sine(40.0).acceleration[::2]).max() > 0.9


def test_the_same_step_changes_nothing() -> None:
    record = NOISE
    assert resample(record, dt=DT) is record


def test_trimming_keeps_the_shares_of_arias_intensity() -> None:
    record = NOISE
    kept = trim(record, start=0.05, end=0.95)
    whole = integrate_squared(record)[-1]
    assert integrate_squared(kept)[-1] / whole == pytest.approx(0.9, abs=2e-3)  # to a sample at each end
    assert trim(record).npts == record.npts
    assert "0.05-0.95 of its Arias intensity" in str(kept.processing_history[-1])


def test_zeros_at_both_ends_are_trimmed_away() -> None:
    samples = np.zeros(1000)
    samples[300:700] = np.sin(np.arange(400) / 10.0)
    kept = trim(make_record("zeros", samples, DT))
    assert 398 <= kept.npts <= 402


def pair() -> tuple[Record, Record]:
    """North and east of a motion along 30 degrees."""
    motion = sine(2.0).acceleration
    north = make_record("n", motion * np.cos(np.pi / 6), DT, component="N", azimuth=0.0)
    return north, make_record("e", motion * np.sin(np.pi / 6), DT, component="E", azimuth=np.pi / 2)


def test_a_motion_along_an_azimuth_is_whole_there_and_nothing_across() -> None:
    north, east = pair()
    np.testing.assert_allclose(
        rotate_to_azimuth(north, east, azimuth=np.pi / 6).acceleration, sine(2.0).acceleration, rtol=0, atol=1e-12
    )
    assert rotate_to_azimuth(east, north, azimuth=np.pi / 6 + np.pi / 2).pga == pytest.approx(0.0, abs=1e-12)


def test_components_at_any_angle_give_the_same_north() -> None:
    a, b = white_noise(1, npts=4001).acceleration, white_noise(2, npts=4001).acceleration
    first = make_record("a", a, DT, azimuth=0.0)
    second = make_record("b", a * np.cos(1.0) + b * np.sin(1.0), DT, azimuth=1.0)
    np.testing.assert_allclose(rotate_to_azimuth(first, second, azimuth=np.pi / 2).acceleration, b, rtol=0, atol=1e-12)
    turned = rotate_to_azimuth(first, second, azimuth=0.3)
    assert turned.azimuth == pytest.approx(0.3)
    assert turned.processing_history[-1].values["azimuth"] == Quantity(0.3, "angle", 6)


def test_rotd_of_a_straight_motion_is_its_cosine() -> None:
    """Peaks over directions are |cos|, whose median over half a turn is cos 45 degrees."""
    north, east = pair()
    assert rotd(north, east, percentile=100).pga == pytest.approx(sine(2.0).pga, rel=1e-12)
    assert rotd(north, east, percentile=50).pga == pytest.approx(sine(2.0).pga * np.cos(np.pi / 4), rel=0.02)
    largest = rotd(north, east, percentile=100)
    assert largest.azimuth == pytest.approx(np.pi / 6)
    assert largest.component == "RotD100"


@pytest.mark.parametrize("percentile", [0.0, 16.0, 50.0, 84.0, 100.0])
@pytest.mark.parametrize("seed", range(4))
def test_the_peak_of_rotd_is_the_percentile_of_the_peaks(seed: int, percentile: float) -> None:
    """Of 180 directions, of which none need have the median; each direction by a matrix here."""
    first, second = (make_record("rotd", white_noise(2 * seed + i, npts=40).acceleration * (1 + i), DT) for i in (0, 1))
    angle = np.radians(np.arange(180.0))[:, np.newaxis]
    peaks = np.abs(np.cos(angle) * first.acceleration + np.sin(angle) * second.acceleration).max(axis=1)
    found = rotd(first, second, percentile=percentile)
    assert found.pga == pytest.approx(np.percentile(peaks, percentile), rel=1e-12)
    assert found.pga == pytest.approx(float(rotd_spectrum(first, second, 0.0, percentile=percentile)), rel=1e-12)


def test_rotd_of_no_motion_and_of_a_circle_has_any_direction() -> None:
    still = make_record("still", np.zeros(9), DT)
    assert rotd(still, still, percentile=50).pga == 0.0
    turn = np.radians(np.arange(720.0))
    circle = (make_record("a", np.cos(turn), DT), make_record("b", np.sin(turn), DT))
    assert rotd(*circle, percentile=50).pga == pytest.approx(1.0, rel=1e-12)


def test_the_spectrum_over_directions_of_a_straight_motion() -> None:
    north, east = pair()
    period = np.array([0.2, 0.5, 1.0])
    straight = response_spectrum(sine(2.0), period)
    np.testing.assert_allclose(rotd_spectrum(north, east, period, percentile=100), straight, rtol=1e-9)
    np.testing.assert_allclose(
        rotd_spectrum(north, east, period, percentile=50), straight * np.cos(np.pi / 4), rtol=0.01
    )


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (lambda: correct_baseline(NOISE, degree=-1), "degree -1"),
        (lambda: correct_baseline(NOISE, degree=99), "degree 99"),
        (
            lambda: butterworth(NOISE, low=10.0, high=1.0),
            "low corner 10 Hz, high corner 1 Hz; .* below half the rate, 50 Hz, and the low one",
        ),
        (lambda: butterworth(NOISE, low=60.0), "below half the rate, 50 Hz"),
        (lambda: butterworth(NOISE, low=np.nan), ": low corner nan Hz; .* half the rate, 50 Hz$"),
        (lambda: butterworth(NOISE, low=0.0), ": low corner 0 Hz"),
        (lambda: butterworth(NOISE, low=1.0, order=0), "order 0"),
        (lambda: butterworth(NOISE, low=1e-9), "samples would be needed"),
        (lambda: resample(NOISE, dt=0.0), "step 0.0 s"),
        (lambda: resample(NOISE, dt=np.inf), "step inf s"),
        (lambda: resample(NOISE, dt=1e-9), "whole numbers"),
        (lambda: resample(NOISE, dt=DT / np.pi), "whole numbers"),
        (lambda: resample(white_noise(npts=4_000_000), dt=DT / 1000), "samples would be needed"),
        (lambda: trim(NOISE, start=0.9, end=0.1), "trimmed from 0.9 to 0.1"),
        (lambda: trim(NOISE, end=np.nan), "trimmed from 0.0 to nan"),
        (lambda: rotd(*pair(), percentile=101.0), "percentile 101.0"),
        (lambda: rotd(pair()[0], pair()[0], percentile=50.0), "must be perpendicular"),
        (lambda: rotate_to_azimuth(pair()[0], pair()[0], azimuth=1.0), "at least 10 deg apart"),
        (lambda: rotate_to_azimuth(pair()[0], NOISE, azimuth=1.0), "azimuth of its component .* is not known"),
        (lambda: rotd(NOISE, sine(1.0, dt=0.02), percentile=50.0), "resample one to the other"),
    ],
)
def test_what_cannot_be_done_is_one_line(wrong: Callable[[], Record], words: str) -> None:
    with pytest.raises(RecordError, match=words) as caught:
        wrong()
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("other", [{"station": "AOM004", "event": "one"}, {"station": "KNG001", "event": "two"}])
def test_components_of_two_recordings_are_not_turned_together(other: dict[str, str]) -> None:
    first = make_record("a", np.sin(np.arange(50.0)), 0.01, azimuth=0.0, station="KNG001", event="one")
    second = make_record("b", np.cos(np.arange(50.0)), 0.01, azimuth=0.5 * np.pi, **other)
    with pytest.raises(RecordError, match="of one recording"):
        rotate_to_azimuth(first, second, azimuth=0.3)
