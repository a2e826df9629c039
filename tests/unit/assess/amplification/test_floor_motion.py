"""Amplification of records and pulses: published formulas, limits, and that records and pulses agree."""

import numpy as np
import pytest

from assess.amplification import (
    FirstMode,
    FloorFactor,
    ModalFilter,
    Srss,
    SrssRelative,
    Unamplified,
    base_motion,
    first_mode,
    pulse_factor,
)
from assess.errors import MechanismError
from records.errors import RecordError
from records.record import Record, make_record, scale
from tests.support.motions import white_noise

MODE = FirstMode(frequency=2.5, effective_height=6.01)  # Wall 6, thesis Table 8.3
EVERY = [
    Unamplified(),
    FloorFactor(1.8, "a clause"),
    Srss(MODE, 4.77),
    SrssRelative(MODE, 4.77),
    ModalFilter(MODE, 4.77),
]


def one_sine(frequency: float, *, samples: int = 2000) -> Record:
    """A pulse of one sine as a record that ends in rest."""
    time = np.arange(samples + 1) / samples / frequency
    return make_record("pulse", np.append(np.sin(2 * np.pi * frequency * time), np.zeros(samples)), time[1])


def test_relative_srss_of_pulses_is_3_47() -> None:
    """Per a_g at h = h_e, by an event-exact integrator."""
    ratio = np.array([0.05, 0.2, 0.5, 0.8, 1.0, 1.5, 2.0, 4.0, 10.0])
    expected = [1.001, 1.019, 1.273, 2.529, 2.873, 2.078, 1.996, 1.646, 1.460]
    found = pulse_factor(SrssRelative(MODE, MODE.effective_height), ratio * MODE.frequency)
    np.testing.assert_allclose(found, expected, atol=6e-4)


@pytest.mark.parametrize(("ratio", "expected"), [(0.5, 1.907), (1.0, 2.891), (2.0, 1.525), (4.0, 1.052)])
def test_srss_of_records_is_3_48(ratio: float, expected: float) -> None:
    """The same with S_a in the place of a_r; S_a is the pseudo-acceleration here, the total one there."""
    found = base_motion(Srss(MODE, MODE.effective_height), one_sine(ratio * MODE.frequency)).factor
    assert found == pytest.approx(expected, rel=5e-3)


def test_3_48_is_root_two_for_a_rigid_structure_and_one_at_its_foot() -> None:
    stiff = FirstMode(frequency=90.0, effective_height=5.0)
    assert base_motion(Srss(stiff, 5.0), one_sine(0.5)).factor == pytest.approx(np.sqrt(2.0), rel=1e-3)
    assert base_motion(Srss(stiff, 0.0), one_sine(0.5)).factor == 1.0


@pytest.mark.parametrize("height", [0.0, 2.0, 4.77, 9.0])
@pytest.mark.parametrize("frequency", [0.6, 2.5, 6.0])
@pytest.mark.parametrize("method", [Srss, ModalFilter])
def test_a_pulse_as_a_record_is_carried_as_the_pulse(method, frequency: float, height: float) -> None:
    amplification = method(MODE, height)
    record = base_motion(amplification, one_sine(frequency))
    assert record.factor == pytest.approx(float(pulse_factor(amplification, frequency)), rel=1e-4)


@pytest.mark.parametrize("amplification", EVERY)
def test_carried_motions_grow_with_the_ground_s(amplification) -> None:
    """A factor does not depend on how strong the record is, nor on its sign."""
    noise = white_noise(npts=500)
    one, other = base_motion(amplification, noise), base_motion(amplification, scale(noise, -2.5))
    assert other.factor == pytest.approx(one.factor, rel=1e-12)
    np.testing.assert_allclose(other.record.acceleration, -2.5 * one.record.acceleration, atol=1e-12)
    assert one.record.pga == pytest.approx(one.factor * noise.pga, rel=1e-12)
    assert one.record.id == "noise"


@pytest.mark.parametrize(
    "amplification", [Srss(MODE, 0.0), ModalFilter(MODE, 0.0), Unamplified(), FloorFactor(1.0, "")]
)
def test_at_the_ground_nothing_is_amplified(amplification) -> None:
    assert base_motion(amplification, white_noise(npts=500)).factor == pytest.approx(1.0, rel=1e-12)
    np.testing.assert_allclose(pulse_factor(amplification, np.geomspace(0.2, 10, 7)), 1.0, rtol=1e-6)


@pytest.mark.parametrize("amplification", EVERY)
def test_factors_keep_the_shape_of_the_frequencies(amplification) -> None:
    assert pulse_factor(amplification, np.ones((2, 3))).shape == (2, 3)
    assert pulse_factor(amplification, 1.0).shape == ()


def test_a_linear_shape_is_one_at_the_effective_height_whatever_the_masses() -> None:
    rng = np.random.default_rng(3)
    z, m = np.sort(rng.uniform(0, 9, 8)), rng.uniform(1, 5, 8)
    participation = (m @ z) / (m @ z**2)
    mode = FirstMode(1.0, effective_height=(m @ z**2) / (m @ z))
    for height in (1.0, 4.0, 9.0):
        assert mode.shape(height) == pytest.approx(participation * height, rel=1e-12)


@pytest.mark.parametrize("amplification", [Srss(MODE, 4.77), ModalFilter(MODE, 4.77)])
def test_a_record_without_motion_is_refused(amplification) -> None:
    with pytest.raises(RecordError, match="no motion"):
        base_motion(amplification, make_record("still", np.zeros(10), 0.01))


@pytest.mark.parametrize(("frequency", "height", "damping"), [(0.0, 5, 0.05), (2.5, np.nan, 0.05), (2.5, 5, 1.0)])
def test_modes_that_no_structure_has_are_refused(frequency, height, damping) -> None:
    with pytest.raises(MechanismError, match="first mode"):
        first_mode(frequency=frequency, effective_height=height, damping=damping)
