"""Artificial records: what they promise of spectrum, peak, baseline, envelope and seed."""

import hashlib
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.constants import g
from scipy.integrate import solve_ivp

from records import synthetic
from records.errors import RecordError
from records.record import Record
from records.response import response_spectrum
from records.selection import target_mark
from records.synthetic import artificial_records, end_weights, envelope, seed_of_target, with_peak
from spectra.asce7 import design_spectrum
from spectra.table import table_spectrum
from tests.support.artificial import make_artificial

TARGET = design_spectrum(s_ds=0.1667 * g, s_d1=0.0533 * g, t_l=6.0)


@pytest.fixture(autouse=True)
def _each_is_made(monkeypatch: pytest.MonkeyPatch) -> None:
    """Records are made again in each test, so that two can be compared."""
    monkeypatch.setattr(synthetic, "_make_artificial", make_artificial)
    make_artificial.cache_clear()


@pytest.fixture(scope="module")
def seven() -> tuple[Record, ...]:
    return artificial_records(TARGET, count=7, seed=1)


def test_a_set_is_made_once_a_process_and_never_another_in_its_place(monkeypatch: pytest.MonkeyPatch) -> None:
    """Whatever a set follows from makes another one: target, seed, duration, step, band, the name of the code."""
    made: list[int] = []
    make = synthetic._fit_rounds
    monkeypatch.setattr(synthetic, "_fit_rounds", lambda *one, **more: made.append(1) or make(*one, **more))
    usual = {"spectrum": TARGET, "count": 1, "seed": 3, "duration": 12.0, "band": (0.04, 2.0)}
    (first,) = artificial_records(**usual)
    (again, second) = artificial_records(**usual | {"count": 2})
    assert again is first
    assert second.id == "artificial-2"
    assert len(made) == 2
    others = [
        {"spectrum": design_spectrum(s_ds=0.1667 * g, s_d1=0.0534 * g, t_l=6.0)},
        {"spectrum": replace(TARGET, code="another")},
        {"seed": 4},
        {"duration": 12.01},
        {"dt": 0.005},
        {"band": (0.04, 2.01)},
    ]
    for number, change in enumerate(others, start=3):
        (other,) = artificial_records(**usual | change)
        assert len(made) >= number
        assert other.processing_history != first.processing_history or other.dt != first.dt


def test_every_record_follows_the_target(seven: tuple[Record, ...]) -> None:
    T = np.geomspace(0.04, 5.0, 170)  # the band at 80 periods a decade
    for record in seven:
        ratio = response_spectrum(record, T) / TARGET.acceleration(T) - 1
        assert ratio.min() >= -0.10
        assert np.sqrt(np.mean(ratio**2)) <= 0.05


def test_between_the_fitted_periods_nothing_gapes(seven: tuple[Record, ...]) -> None:
    T = np.geomspace(0.04, 5.0, 997)
    ratio = np.array([response_spectrum(record, T) / TARGET.acceleration(T) - 1 for record in seven])
    assert ratio.min() >= -0.15
    assert ratio.max() <= 0.20
    assert np.sqrt(np.mean(ratio**2)) <= 0.05


def test_the_peak_is_the_zero_period_ordinate(seven: tuple[Record, ...]) -> None:
    for record in seven:
        assert record.pga == pytest.approx(TARGET.pga, rel=1e-12)


def test_the_ground_comes_to_rest_where_it_started(seven: tuple[Record, ...]) -> None:
    """Velocity and displacement are exact for acceleration linear between samples."""
    for record in seven:
        a, h = record.acceleration, record.dt
        v = np.concatenate([[0.0], np.cumsum(0.5 * h * (a[1:] + a[:-1]))])
        d = np.concatenate([[0.0], np.cumsum(h * v[:-1] + h * h / 6 * (2 * a[:-1] + a[1:]))])
        assert abs(v[-1]) < 1e-10 * np.abs(v).max()
        assert abs(d[-1]) < 1e-10 * np.abs(d).max()
        assert abs(d.mean()) < 1e-3 * np.abs(d).max()
        assert np.abs(d).max() < float(TARGET.acceleration(4.0)) * (4.0 / (2 * np.pi)) ** 2


def test_motion_begins_and_ends_quietly(seven: tuple[Record, ...]) -> None:
    for record in seven:
        energy = np.cumsum(record.acceleration**2) / np.sum(record.acceleration**2)
        five, ninety_five = record.time[np.searchsorted(energy, [0.05, 0.95])]
        assert record.acceleration[0] == record.acceleration[-1] == 0.0
        assert 1.25 < five < 6.25
        assert 13.75 < ninety_five < 21.25


def test_the_seed_settles_everything_and_the_count_nothing(seven: tuple[Record, ...]) -> None:
    three = artificial_records(TARGET, count=3, seed=1)
    for record, same in zip(three, seven, strict=False):
        assert record.id == same.id
        assert record.processing_history == same.processing_history
        np.testing.assert_array_equal(record.acceleration, same.acceleration)
    other = artificial_records(TARGET, count=1, seed=2)[0]
    for record in seven:
        assert abs(np.corrcoef(record.acceleration, other.acceleration)[0, 1]) < 0.3
    assert [record.id for record in seven] == [f"artificial-{k}" for k in range(1, 8)]


def test_a_seed_that_nobody_states_is_the_hash_of_shape_and_duration() -> None:
    """By sha256sum of the shape's SHA-256, a blank and the duration: the first eight hexadecimal digits."""
    text = f"{target_mark(TARGET).sha256} 25".encode()
    seed = int.from_bytes(hashlib.sha256(text).digest()[:4], "big")
    assert seed_of_target(TARGET, duration=25.0) == seed
    (made,), (stated,) = (artificial_records(TARGET, count=1, seed=each) for each in (None, seed))
    np.testing.assert_array_equal(made.acceleration, stated.acceleration)
    assert f"seed {seed}, number 1" in made.processing_history[0].text
    assert seed_of_target(replace(TARGET, factor=2.0), duration=25.0) == seed
    other = design_spectrum(s_ds=0.1667 * g, s_d1=0.06 * g, t_l=6.0)
    assert len({seed, seed_of_target(TARGET, duration=24.0), seed_of_target(other, duration=25.0)}) == 3


def test_threads_change_nothing(seven: tuple[Record, ...]) -> None:
    for record, same in zip(artificial_records(TARGET, count=7, seed=1, threads=3), seven, strict=True):
        assert record.id == same.id
        np.testing.assert_array_equal(record.acceleration, same.acceleration)


def test_a_record_knows_that_it_was_made_and_how_long_it_is_stationary(seven: tuple[Record, ...]) -> None:
    for record in seven:
        assert record.artificial
        assert record.stationary == pytest.approx(12.5)


@pytest.mark.parametrize("longest", [5.0, 7.5, 10.0])
def test_a_longer_band_is_followed_as_far_as_half_of_the_duration(longest: float) -> None:
    (record,) = artificial_records(TARGET, count=1, seed=1, duration=2.0 * longest + 5.0, band=(0.04, longest))
    T = np.geomspace(0.04, longest, 300)
    assert (response_spectrum(record, T) / TARGET.acceleration(T)).min() >= 0.88  # 0.90 at the periods fitted


def test_the_trail_states_the_fit(seven: tuple[Record, ...]) -> None:
    text = " ".join(map(str, seven[0].processing_history))
    for words in ("seed 1, number 1", "asce7-16", "0.04 s to 5 s", "rms", "12.5 s stationary", "baseline"):
        assert words in text


@pytest.mark.parametrize(("duration", "dt"), [(10.0, 0.01), (40.0, 0.01), (20.0, 0.005)])
def test_length_and_step_are_as_asked(duration: float, dt: float) -> None:
    (record,) = artificial_records(TARGET, count=1, seed=4, duration=duration, dt=dt)
    assert (record.dt, record.npts) == (dt, round(duration / dt) + 1)


def test_a_table_is_matched_as_far_as_it_goes() -> None:
    table = table_spectrum([0.0, 0.1, 0.5, 2.0], [1.0, 2.5, 2.5, 0.6])
    (record,) = artificial_records(table, count=1, seed=1)
    T = np.geomspace(0.05, 2.0, 129)
    assert (response_spectrum(record, T) / table.acceleration(T)).min() >= 0.90
    assert "to 2 s" in str(record.processing_history[1])


def test_a_target_that_no_motion_has_is_refused() -> None:
    """Ordinates of a hundredth of the peak acceleration at 0.05 s, beside twice the peak at 0.06 s."""
    jagged = table_spectrum([0.0, 0.05, 0.06, 0.07, 4.0], [1.0, 0.01, 2.0, 0.01, 0.01])
    with pytest.raises(RecordError, match="sets of phases"):
        artificial_records(jagged, count=1, seed=1)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"count": 0}, "count = 0"),
        ({"seed": -1}, "seed = -1"),
        ({"duration": 5.0}, "duration = 5.0"),
        ({"duration": float("nan")}, "duration = nan"),
        ({"duration": 1e12}, r"duration = 1000000000000\.0"),
        ({"dt": 0.0}, "dt = 0.0"),
        ({"dt": 0.02}, "dt = 0.02"),
        ({"dt": float("nan")}, "dt = nan"),
        ({"band": (2.0, 1.0)}, "band"),
        ({"band": (0.0, 1.0)}, "band"),
    ],
)
def test_arguments_that_make_no_record_are_refused(change: dict[str, object], words: str) -> None:
    with pytest.raises(RecordError, match=words):
        artificial_records(TARGET, **{"count": 1, "seed": 1, **change})


def test_the_end_weights_integrate_exactly() -> None:
    a, h = np.random.default_rng(1).normal(size=12), 0.1
    time = h * np.arange(12)
    state = np.zeros(3)
    for start, end in pairwise(time):
        step = solve_ivp(lambda t, y: [np.interp(t, time, a), y[0], y[1]], (start, end), state, rtol=1e-12, atol=1e-14)
        state = step.y[:, -1]
    np.testing.assert_allclose(end_weights(12, dt=h) @ a, state, rtol=1e-9)


def test_the_envelope_rises_stands_and_falls() -> None:
    level = envelope(np.array([0.0, 1.0, 2.0, 7.0, 12.0, 16.0, 20.0]), duration=20.0)
    np.testing.assert_allclose(level, [0.0, 0.25, 1.0, 1.0, 1.0, 0.05**0.5, 0.0], rtol=1e-12, atol=1e-15)


def test_a_peak_is_lowered_or_raised_by_whole_half_cycles() -> None:
    wave = np.sin(np.linspace(0.0, 4 * np.pi, 400)) * np.linspace(0.5, 1.5, 400)
    for pga in (0.8, 3.0):
        peaked = with_peak(wave, pga=pga)
        assert np.abs(peaked).max() == pytest.approx(pga, rel=1e-12)
        np.testing.assert_array_equal(np.sign(peaked), np.sign(wave))
    assert np.count_nonzero(with_peak(wave, pga=3.0) != wave) <= 101
