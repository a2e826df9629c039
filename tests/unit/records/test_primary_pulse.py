from __future__ import annotations

import numpy as np
import pytest
from scipy.constants import g

from records.errors import RecordError
from records.pulses import (
    PERIODS,
    PULSE_SHAPES,
    PulseShape,
    mavroeidis_papageorgiou,
    primary_pulses,
    pulse_record,
    pulse_shape,
)
from records.reading import read_records
from records.record import Record, make_record, scale
from tests.support.motions import pulse_id
from tests.support.places import PEER, needs_real_records

EVERY = [*PULSE_SHAPES.values(), mavroeidis_papageorgiou(gamma=1.4, nu=1.0)]


def buried(
    one: PulseShape, *, frequency: float, amplitude: float, noise: float, seed: int = 3, at: int = 800
) -> Record:
    """A pulse from sample `at` of a record of 4,000 steps of 0.01 s, in noise of standard deviation `noise`."""
    pulse = pulse_record(one, frequency=frequency, amplitude=amplitude, dt=0.01).acceleration
    a = noise * np.random.default_rng(seed).normal(size=4000)
    a[at : at + pulse.size] += pulse
    return make_record("buried", a, 0.01)


def violent(seed: int = 5) -> Record:
    """Noise in a band about 2 Hz that grows and dies away."""
    t = 0.01 * np.arange(3000)
    a = np.random.default_rng(seed).normal(size=3000)
    smooth = np.convolve(a, np.hanning(25), mode="same")
    return make_record("violent", 4.0 * smooth * t * np.exp(-0.4 * t), 0.01)


@pytest.mark.parametrize("one", EVERY, ids=pulse_id)
def test_a_pulse_alone_is_all_of_the_energy(one: PulseShape) -> None:
    record = pulse_record(one, frequency=1.3, amplitude=2.5, dt=0.005)
    best = primary_pulses(record, shape=one)[0]
    assert best.energy_share == pytest.approx(1.0, rel=0, abs=1e-6)
    assert best.index == pytest.approx(1.0, rel=0, abs=1e-6)
    assert best.frequency == pytest.approx(1.3, rel=1e-4)
    assert best.amplitude == pytest.approx(2.5, rel=1e-4)
    assert best.start == pytest.approx(0.0, rel=0, abs=0.0051)  # the cosine begins after a step of ramp
    assert best.polarity == 1
    np.testing.assert_allclose(best.acceleration(record.time)[2:-2], record.acceleration[2:-2], rtol=0, atol=2e-3)


@pytest.mark.parametrize("one", EVERY, ids=pulse_id)
@pytest.mark.parametrize("frequency", [0.35, 1.1])
def test_a_pulse_in_noise_is_found(one: PulseShape, frequency: float) -> None:
    """With noise of a tenth of its amplitude in every sample."""
    record = buried(one, frequency=frequency, amplitude=2.0, noise=0.2)
    best = primary_pulses(record, shape=one)[0]
    assert best.frequency == pytest.approx(frequency, rel=0.02)
    assert best.amplitude == pytest.approx(2.0, rel=0.05)
    assert best.start == pytest.approx(8.0, rel=0, abs=0.05 / frequency)


def test_reversed_record_reversed_pulse() -> None:
    record = violent()
    for one, other in zip(primary_pulses(record), primary_pulses(scale(record, -1.0)), strict=True):
        assert other.polarity == -one.polarity
        assert (other.frequency, other.amplitude, other.start) == (one.frequency, one.amplitude, one.start)


def test_scale_changes_the_amplitude_alone() -> None:
    record = violent()
    for one, other in zip(primary_pulses(record), primary_pulses(scale(record, 7.3)), strict=True):
        assert other.amplitude == pytest.approx(7.3 * one.amplitude, rel=1e-5)
        assert other.frequency == pytest.approx(one.frequency, rel=1e-5)
        assert other.energy_share == pytest.approx(one.energy_share, rel=1e-9)
        assert other.polarity == one.polarity


def test_a_delay_of_the_record_delays_the_pulse() -> None:
    record = violent()
    late = make_record("late", np.concatenate([np.zeros(317), record.acceleration]), record.dt)
    for one, other in zip(primary_pulses(record), primary_pulses(late), strict=True):
        assert other.start == pytest.approx(one.start + 3.17, rel=0, abs=1e-4)
        assert other.energy_share == pytest.approx(one.energy_share, rel=1e-8)


def test_least_squares_leaves_the_rest_of_the_energy() -> None:
    """With rest before and after the record, where long pulses reach."""
    record = violent()
    a = np.pad(record.acceleration, 4000)
    t = record.dt * np.arange(-4000, a.size - 4000)
    for pulse in primary_pulses(record, count=99):
        rest = a - pulse.acceleration(t)
        left = float(rest @ rest) / float(a @ a)
        assert left == pytest.approx(1.0 - pulse.energy_share, rel=1e-9)


def test_nothing_matches_better_by_brute_force() -> None:
    """Every sine of 200 periods at every sample, by plain sums: Pearson's correlation without the mean."""
    record = violent()
    a, dt = record.acceleration, record.dt
    best = 0.0
    for T in np.geomspace(0.1, 20.0, 200):
        s = np.sin(2 * np.pi * dt / T * np.arange(int(T / dt) + 1))
        best = max(best, float(np.max(np.abs(np.correlate(a, s, "full")))) / np.sqrt(float(s @ s) * float(a @ a)))
    found = primary_pulses(record)[0].index
    assert best <= found * (1 + 1e-12)
    assert found < 1.02 * best


def test_two_pulses_are_two_candidates() -> None:
    """A short strong one and a long weak one of a third of the amplitude, apart in time."""
    a = np.zeros(4000)
    for start, frequency, amplitude in ((500, 2.5, 3.0), (1500, 0.2, -1.0)):
        pulse = pulse_record(pulse_shape("sine"), frequency=frequency, amplitude=amplitude, dt=0.01).acceleration
        a[start : start + pulse.size] = pulse
    found = primary_pulses(make_record("two", a, 0.01))
    by_frequency = sorted(found[:2], key=lambda pulse: -pulse.frequency)
    for pulse, values in zip(by_frequency, [(2.5, 3.0, 5.0, 1), (0.2, 1.0, 15.0, -1)], strict=True):
        assert (pulse.frequency, pulse.amplitude, pulse.start) == pytest.approx(values[:3], rel=1e-3)
        assert pulse.polarity == values[3]
    assert sum(pulse.energy_share for pulse in found[:2]) == pytest.approx(1.0, rel=0, abs=1e-6)
    assert found[0].energy_share > found[1].energy_share
    assert primary_pulses(make_record("two", a, 0.01), count=1) == found[:1]


def test_a_pulse_may_begin_before_the_record() -> None:
    whole = pulse_record(pulse_shape("ricker"), frequency=1.0, amplitude=2.0, dt=0.01)
    cut = make_record("cut", whole.acceleration[110:], 0.01)  # 0.76 of a period before the peak
    best = primary_pulses(cut, shape=pulse_shape("ricker"))[0]
    assert best.start == pytest.approx(-1.10, rel=0, abs=0.01)
    assert (best.frequency, best.amplitude) == pytest.approx((1.0, 2.0), rel=0.01)


@pytest.mark.parametrize(("ends", "at"), [((0.8, 2.0), 0.8), ((0.1, 0.5), 0.5)])
def test_a_match_that_grows_beyond_the_grid_is_told(ends: tuple[float, float], at: float) -> None:
    record = buried(pulse_shape("sine"), frequency=1.5, amplitude=2.0, noise=0.1)
    best = primary_pulses(record, period=np.geomspace(*ends, 20))[0]
    assert best.at_end
    assert 1.0 / best.frequency == pytest.approx(at, rel=1e-6)
    assert not primary_pulses(record)[0].at_end


def test_an_offset_is_the_longest_pulse() -> None:
    record = make_record("offset", 0.5 + violent().acceleration, 0.01)
    longest = primary_pulses(record, shape=pulse_shape("half-sine"), count=99)
    assert any(pulse.at_end and pulse.frequency == pytest.approx(0.05, rel=1e-6) for pulse in longest)


@pytest.mark.parametrize(
    ("samples", "dt", "period", "text"),
    [
        (np.zeros(1000), 0.01, PERIODS, "no motion"),
        (np.ones(1000), 0.01, [1.0, 0.9, 0.8], "positive and rising"),
        (np.ones(1000), 0.01, [-1.0, 1.0, 1.1], "positive and rising"),
        (np.ones(1000), 0.01, [0.9, np.nan, 1.1], "positive and rising"),
        (np.ones(1000), 0.01, [1.0, 1.2, 2.0], "over 25 %"),
        (np.ones(1000), 0.01, [1.0e9, 1.1e9, 1.2e9], "too many steps"),
        (np.ones(1000), 10.0, PERIODS, "0 periods of at least 50 s"),
    ],
)
def test_refused(samples: np.ndarray, dt: float, period: list[float], text: str) -> None:
    with pytest.raises(RecordError, match=text):
        primary_pulses(make_record("bad", samples, dt), period=period)


@pytest.mark.parametrize("one", EVERY, ids=pulse_id)
@pytest.mark.parametrize("count", [1, 3])
def test_the_best_are_the_first_of_all(one: PulseShape, count: int) -> None:
    """A maximum that is not refined could not have become one of them."""
    for seed in (1, 2, 3):
        assert (
            primary_pulses(violent(seed), shape=one, count=count)
            == primary_pulses(violent(seed), shape=one, count=99)[:count]
        )


@needs_real_records
@pytest.mark.parametrize(
    ("name", "low", "high"),
    [
        ("Rinaldi228.AT2", 1.0, 1.4),  # fault normal: velocity pulse of about 1.2 s (Baker 2007; M & P 2003)
        ("RSN77_SFERN_PUL164.AT2", 1.1, 1.7),  # Pacoima Dam: about 1.5 s (M & P 2003)
    ],
)
def test_periods_of_well_known_pulses(name: str, low: float, high: float) -> None:
    (record,) = read_records(PEER / name)
    pulse = primary_pulses(record, shape=pulse_shape("mavroeidis-papageorgiou"))[0]
    assert low < 1.0 / pulse.frequency < high
    assert 0.3 < pulse.index < 1.0
    assert pulse.amplitude < record.pga
    assert 0.2 * g < pulse.amplitude
