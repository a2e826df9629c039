from __future__ import annotations

import math
import pickle

import numpy as np
import pytest
from scipy.integrate import quad, simpson
from scipy.special import eval_hermitenorm

from records.errors import RecordError
from records.pulses import PULSE_SHAPES, PulseShape, mavroeidis_papageorgiou, pulse_record, pulse_shape
from tests.support.motions import pulse_id

FAMILY = [
    mavroeidis_papageorgiou(gamma=gamma, nu=nu) for gamma in (1.01, 1.5, 2.0, 5.0, 31.7) for nu in (0.0, 0.6, -2.0)
]
EVERY = [*PULSE_SHAPES.values(), *FAMILY]
CONTINUOUS = [one for one in EVERY if one.name != "cosine"]


@pytest.mark.parametrize("one", EVERY, ids=pulse_id)
def test_each_derivative_is_that_of_the_one_before(one: PulseShape) -> None:
    margin = 0.3 * (one.end - one.start) if "ricker" in one.name else 0.01  # beyond it a Ricker is negligible
    theta, h = np.linspace(one.start + margin, one.end - margin, 101), 2e-3
    ahead = [one.derivatives(theta + k * h) for k in (-2, -1, 1, 2)]
    slope = (ahead[0] - 8 * ahead[1] + 8 * ahead[2] - ahead[3]) / (12 * h)  # of fourth order in h
    np.testing.assert_allclose(slope[:5], one.derivatives(theta)[1:], rtol=0, atol=2e-9)


@pytest.mark.parametrize("one", EVERY, ids=pulse_id)
def test_the_largest_value_is_one(one: PulseShape) -> None:
    theta = np.linspace(one.start, one.end, 200_001)
    assert np.max(np.abs(one.value(theta))) == pytest.approx(1.0, rel=0, abs=2e-7)
    assert np.max(np.abs(one.value(theta))) <= 1.0 + 1e-14


@pytest.mark.parametrize("one", EVERY, ids=pulse_id)
def test_nothing_outside_and_limits_from_within_at_the_ends(one: PulseShape) -> None:
    np.testing.assert_array_equal(one.derivatives([one.start - 1e-9, one.end + 1e-9, 1e9, -1e9]), 0.0)
    ends, near = one.derivatives([one.start, one.end]), one.derivatives([one.start + 1e-9, one.end - 1e-9])
    np.testing.assert_allclose(ends, near, rtol=0, atol=1e-7)


def test_sine_cosine_and_half_sine() -> None:
    theta = np.linspace(0.0, 2 * math.pi, 50)
    np.testing.assert_allclose(pulse_shape("sine").value(theta), np.sin(theta), rtol=0, atol=1e-15)
    np.testing.assert_allclose(pulse_shape("cosine").value(theta), np.cos(theta), rtol=0, atol=1e-15)
    half = pulse_shape("half-sine").value(theta)
    np.testing.assert_allclose(half, np.maximum(np.sin(theta), 0.0), rtol=0, atol=1e-15)
    assert pulse_shape("cosine").value([0.0, 2 * math.pi]) == pytest.approx([1.0, 1.0], rel=1e-15)


def test_symmetric_ricker_as_written_over_time() -> None:
    f, t = 1.7, np.linspace(-1.0, 1.0, 400)
    b = (np.pi * f * t) ** 2
    np.testing.assert_allclose(
        pulse_shape("ricker").value(2 * np.pi * f * t), (1 - 2 * b) * np.exp(-b), rtol=0, atol=1e-15
    )


def test_antisymmetric_ricker_is_the_third_derivative_of_the_gaussian() -> None:
    """As Vassiliou and Makris write it, beta = 1.38; its larger positive half comes first."""
    one, x = pulse_shape("ricker-antisymmetric"), np.linspace(-5.0, 5.0, 301)
    value = one.value(math.sqrt(3) * x)
    bell = eval_hermitenorm(3, x) * np.exp(-0.5 * x**2)
    assert np.max(np.abs(bell)) == pytest.approx(1.38, rel=0, abs=0.002)
    np.testing.assert_allclose(value, bell / 1.3801, rtol=0, atol=1e-4)
    assert np.argmax(value) < np.argmin(value)


@pytest.mark.parametrize("name", ["ricker", "ricker-antisymmetric"])
def test_rickers_dominant_frequency_is_that_of_the_pulse(name: str) -> None:
    f, dt, n = 2.0, 0.01, 2**16
    spectrum = np.abs(np.fft.rfft(pulse_record(pulse_shape(name), frequency=f, amplitude=1.0, dt=dt).acceleration, n))
    assert np.fft.rfftfreq(n, dt)[np.argmax(spectrum)] == pytest.approx(f, rel=0, abs=1.0 / (n * dt))


@pytest.mark.parametrize("name", ["ricker", "ricker-antisymmetric"])
def test_rickers_are_cut_where_nothing_is_left(name: str) -> None:
    one = pulse_shape(name)
    assert np.max(np.abs(one.value([one.start, one.end]))) < 1e-12


@pytest.mark.parametrize("one", FAMILY, ids=pulse_id)
def test_acceleration_integrates_to_the_published_velocity_pulse(one: PulseShape) -> None:
    theta = np.linspace(one.start, one.end, 20_001)
    carrier = np.cos(theta + one.nu)
    velocity = 0.5 * (1 + np.cos(theta / one.gamma)) * carrier
    slope = np.gradient(velocity, theta, edge_order=2)
    scale = 1.0 / np.max(np.abs(slope))
    np.testing.assert_allclose(
        one.value(theta), scale * slope, rtol=0, atol=2e-4
    )  # differences at a step of 5e-4 to 0.01


@pytest.mark.parametrize(
    ("one", "area"),
    [(one, 2.0 if one.name == "half-sine" else 0.0) for one in EVERY],
    ids=[pulse_id(one) for one in EVERY],
)
def test_net_velocity(one: PulseShape, area: float) -> None:
    theta = np.linspace(one.start, one.end, 40_001)
    assert simpson(one.value(theta), x=theta) == pytest.approx(area, rel=0, abs=1e-9)


def test_net_displacement_of_sine_and_ricker() -> None:
    """Of one sine 2 pi amplitude / (2 pi f_p)^2; of the symmetric Ricker, second derivative of a Gaussian, none."""
    for name, expected in (("sine", 2 * math.pi), ("ricker", 0.0)):
        one = pulse_shape(name)
        moment = quad(lambda x, one=one: (one.end - x) * one.value([x])[0], one.start, one.end, epsabs=1e-10)[0]
        assert moment == pytest.approx(expected, rel=0, abs=1e-8)


def test_first_large_half_is_positive() -> None:
    for one in (
        pulse_shape("sine"),
        pulse_shape("half-sine"),
        pulse_shape("ricker-antisymmetric"),
        pulse_shape("mavroeidis-papageorgiou"),
    ):
        theta = np.linspace(one.start, one.end, 10_001)
        value = one.value(theta)
        assert value[np.flatnonzero(np.abs(value) > 0.9)[0]] > 0.0, one.name


def test_shape_by_name_and_parameters() -> None:
    assert pulse_shape("sine") is PULSE_SHAPES["sine"]
    assert pulse_shape("mavroeidis-papageorgiou", nu=0.5) == mavroeidis_papageorgiou(gamma=2.0, nu=0.5)
    assert pulse_shape("mavroeidis-papageorgiou").gamma == 2.0
    assert pulse_shape("mavroeidis-papageorgiou", gamma=3.0).duration(2.0) == pytest.approx(1.5, rel=1e-14)
    for one in EVERY:
        assert pickle.loads(pickle.dumps(one)) == one


@pytest.mark.parametrize(
    ("name", "values", "text"),
    [
        ("square", {}, "no such shape; known are sine, cosine, half-sine, ricker"),
        ("sine", {"gamma": 2.0}, "of mavroeidis-papageorgiou alone"),
        ("mavroeidis-papageorgiou", {"gamma": 1.0}, "above 1 and at most 50"),
        ("mavroeidis-papageorgiou", {"gamma": 1e9}, "above 1 and at most 50"),
        ("mavroeidis-papageorgiou", {"gamma": math.nan}, "gamma = nan"),
        ("mavroeidis-papageorgiou", {"nu": math.inf}, "nu = inf"),
    ],
)
def test_shapes_refused(name: str, values: dict[str, float], text: str) -> None:
    with pytest.raises(RecordError, match=text):
        pulse_shape(name, **values)


@pytest.mark.parametrize("one", EVERY, ids=pulse_id)
@pytest.mark.parametrize("dt", [0.01, 0.0123])
def test_a_record_begins_and_ends_at_zero(one: PulseShape, dt: float) -> None:
    record = pulse_record(one, frequency=0.8, amplitude=-3.0, dt=dt)
    assert record.acceleration[0] == record.acceleration[-1] == 0.0
    assert record.pga == pytest.approx(3.0, rel=0.02)
    assert abs(record.time[-1] - one.duration(0.8)) <= 2 * dt + 1e-12
    assert one.name in str(record.processing_history[0])


@pytest.mark.parametrize("one", CONTINUOUS, ids=pulse_id)
def test_a_continuous_pulse_starts_with_the_record(one: PulseShape) -> None:
    record = pulse_record(one, frequency=0.8, amplitude=3.0, dt=0.01)
    expected = 3.0 * one.value(one.start + 2 * np.pi * 0.8 * record.time)
    np.testing.assert_allclose(record.acceleration, expected, rtol=0, atol=1e-11)


@pytest.mark.parametrize("n", [12, 40, 400])
def test_lines_between_samples_lower_the_first_harmonic(n: int) -> None:
    record = pulse_record(pulse_shape("sine"), frequency=1.0, amplitude=1.0, dt=1.0 / n)
    t = np.linspace(0.0, 1.0, 240_001)
    harmonic = 2 * simpson(np.interp(t, record.time, record.acceleration) * np.sin(2 * np.pi * t), x=t)
    assert harmonic == pytest.approx(np.sinc(1.0 / n) ** 2, rel=1e-9)


@pytest.mark.parametrize(
    ("values", "text"),
    [
        ({"frequency": 0.0}, "frequency 0.0 Hz"),
        ({"frequency": math.inf}, "must be positive"),
        ({"dt": -0.01}, "must be positive"),
        ({"dt": math.nan}, "must be positive"),
        ({"amplitude": 0.0}, "other than zero"),
        ({"amplitude": math.nan}, "other than zero"),
        ({"dt": 0.11}, "9.09 samples per period"),
        ({"dt": 1e-9}, "more than 10,000,000 samples"),
        ({"amplitude": 1e4}, "check the unit"),
    ],
)
def test_records_refused(values: dict[str, float], text: str) -> None:
    with pytest.raises(RecordError, match=text):
        pulse_record(pulse_shape("sine"), **({"frequency": 1.0, "amplitude": 1.0, "dt": 0.01} | values))
