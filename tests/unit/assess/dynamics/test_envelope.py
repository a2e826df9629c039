"""Maps and lower bounds: amplification, polarity, likeness of branches, nothing overturned, no threshold."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
from scipy.constants import g

from assess.dynamics.packing import Equation
from assess.dynamics.pulses import (
    MARGIN,
    Envelope,
    PulseJobs,
    envelope,
    polarities,
    pulse_outcomes,
    safe_amplitude,
    uplift_acceleration,
)
from assess.errors import MechanismError
from assess.oscillator import Oscillator, RockingBlock, multiplier, plain_branch
from records.pulses import PULSE_SHAPES

EQUATIONS: tuple[Equation, ...] = ("exact", "linearised")
BOTH = pytest.mark.parametrize("equation", EQUATIONS)
FREQUENCY, AMPLITUDE = np.array([0.3, 0.6, 1.0, 1.7]), np.linspace(0.0, 12.0, 41)

ONE = plain_branch(RockingBlock(1.0, 1.0, 0.2, g / 4.0), restitution=0.9)
OTHER = plain_branch(RockingBlock(1.0, 1.0, 0.14, g / 3.0), restitution=0.8)
BLOCK, UNLIKE, ONE_SIDED = Oscillator(ONE, ONE, 1.0), Oscillator(ONE, OTHER, 1.0), Oscillator(ONE, None, 1.0)


def mapped(body: Oscillator, equation: Equation, shape: str = "sine", **more: object) -> Envelope:
    return envelope(body, PULSE_SHAPES[shape], FREQUENCY, AMPLITUDE, equation=equation, **more)  # type: ignore[arg-type]


def falls(body: Oscillator, equation: Equation, shape: str, frequency: float, amplitude: object) -> np.ndarray:
    """Outcomes of signed amplitudes at one frequency."""
    signed = np.atleast_1d(np.asarray(amplitude, dtype=float))
    none = np.zeros(signed.size, dtype=np.int64)
    run = pulse_outcomes(
        [body], PULSE_SHAPES[shape], np.array([frequency]), PulseJobs(none, none, signed), equation=equation
    )
    return run.overturned


@BOTH
@pytest.mark.parametrize("body", [BLOCK, UNLIKE, ONE_SIDED], ids=["alike", "unlike", "one-sided"])
def test_the_map_is_the_worse_outcome_of_both_polarities(body: Oscillator, equation: Equation) -> None:
    found = mapped(body, equation, "cosine")
    for i, f in enumerate(FREQUENCY):
        ahead, back = (falls(body, equation, "cosine", float(f), sign * AMPLITUDE) for sign in (1.0, -1.0))
        np.testing.assert_array_equal(found.overturned[i], ahead | back)


@BOTH
@pytest.mark.parametrize("shape", PULSE_SHAPES)
def test_the_bound_is_an_edge_and_nothing_below_overturns(shape: str, equation: Equation) -> None:
    found = mapped(UNLIKE, equation, shape)
    assert np.isfinite(found.lower_bound).any()
    for i, (f, bound, sign) in enumerate(zip(FREQUENCY, found.lower_bound, found.polarity, strict=True)):
        if np.isnan(bound):
            assert sign == 0
            assert not found.overturned[i].any()
            continue
        edge = sign * bound * np.array([1 - 1e-9, 1 + 1e-10])
        assert falls(UNLIKE, equation, shape, float(f), edge).tolist() == [False, True]
        assert not found.overturned[i, bound * (1 - 1e-9) > AMPLITUDE].any()
        assert bound >= found.uplift[i]


@BOTH
def test_amplification_divides_bound_and_uplift_and_stretches_the_map(equation: Equation) -> None:
    factor = np.array([1.0, 2.0, 2.5, 0.8])
    plain, amplified = mapped(UNLIKE, equation), mapped(UNLIKE, equation, factor=factor)
    known = np.isfinite(plain.lower_bound * amplified.lower_bound)
    assert known.sum() >= 3
    np.testing.assert_allclose((amplified.lower_bound * factor)[known], plain.lower_bound[known], rtol=1e-11)
    np.testing.assert_allclose(amplified.uplift * factor, plain.uplift, rtol=1e-15)
    np.testing.assert_array_equal(amplified.factor, factor)
    for i, f in enumerate(FREQUENCY):
        stretched = envelope(UNLIKE, PULSE_SHAPES["sine"], np.array([f]), AMPLITUDE * factor[i], equation=equation)
        np.testing.assert_array_equal(amplified.overturned[i], stretched.overturned[0])


@BOTH
def test_a_mirrored_oscillator_has_the_same_bound_in_the_other_polarity(equation: Equation) -> None:
    mirrored = Oscillator(OTHER, ONE, 1.0)
    ours, theirs = mapped(UNLIKE, equation), mapped(mirrored, equation)
    np.testing.assert_array_equal(ours.lower_bound, theirs.lower_bound)
    np.testing.assert_array_equal(ours.polarity, -theirs.polarity)
    np.testing.assert_array_equal(ours.overturned, theirs.overturned)
    assert (ours.polarity != 0).all()


@BOTH
def test_an_oscillator_that_is_the_same_both_ways_needs_one_polarity(equation: Equation) -> None:
    same = Oscillator(ONE, ONE, 1.0)
    nearly = Oscillator(ONE, replace(ONE, inertia=ONE.inertia * (1 + 1e-11)), 1.0)
    assert [polarities(each) for each in (same, nearly, ONE_SIDED)] == [(1,), (1, -1), (1, -1)]
    ours, theirs = mapped(same, equation), mapped(nearly, equation)
    np.testing.assert_allclose(ours.lower_bound, theirs.lower_bound, rtol=1e-10)
    np.testing.assert_array_equal(ours.overturned, theirs.overturned)


@BOTH
@pytest.mark.parametrize("highest", [0.0, 1.0, 1.99])
def test_nothing_overturned_by_pulses_that_are_too_weak(highest: float, equation: Equation) -> None:
    """Up to and below uplift, and for no pulse at all."""
    amplitude = np.linspace(0.0, highest, 5)
    found = envelope(BLOCK, PULSE_SHAPES["sine"], FREQUENCY, amplitude, equation=equation)
    assert not found.overturned.any()
    assert np.isnan(found.lower_bound).all()
    assert found.polarity.tolist() == [0] * FREQUENCY.size


def test_uplift_is_lambda_g() -> None:
    assert uplift_acceleration(BLOCK, "exact") == pytest.approx(g * np.tan(0.2), rel=1e-12)
    assert uplift_acceleration(UNLIKE, "exact") == pytest.approx(g * np.tan(0.14), rel=1e-12)
    assert uplift_acceleration(UNLIKE, "linearised") == pytest.approx(g * OTHER.linearised.multiplier, rel=1e-12)


def test_without_a_threshold_the_scan_begins_below_what_is_resisted() -> None:
    """A slow cosine overturns it as soon as it exceeds what any rotation holds; uplift is zero."""
    soft = ONE.restoring * -np.expm1(-3.0 * ONE.rotation / (0.05 * ONE.overturning))  # grows from nothing to its peak
    side = replace(ONE, restoring=soft, overturning_flexible=ONE.overturning)
    body = Oscillator(side, side, 1.0)
    found = envelope(body, PULSE_SHAPES["cosine"], np.array([0.02]), np.array([0.0, 6.0]), equation="exact")
    assert found.uplift.tolist() == [0.0]
    most = g * float(multiplier(body.positive).max())
    assert 0.4 * most < found.lower_bound[0] < most  # applied at once it acts up to twice as a static load


@BOTH
def test_the_same_bytes_on_any_number_of_threads(equation: Equation) -> None:
    one, two = (mapped(UNLIKE, equation, threads=n) for n in (1, 2))
    for name in ("overturned", "lower_bound", "polarity"):
        assert getattr(one, name).tobytes() == getattr(two, name).tobytes()


@pytest.mark.parametrize(
    ("equation", "restoring", "wrong"),
    [("exact", -ONE.restoring, "already falling"), ("linearised", 1.0 + ONE.rotation, "stiffness K .* positive")],
)
def test_a_body_that_cannot_rock_is_told(equation: Equation, restoring: np.ndarray, wrong: str) -> None:
    branch = replace(ONE, restoring=restoring)
    with pytest.raises(MechanismError, match=wrong):
        mapped(Oscillator(branch, branch, 1.0), equation)


@BOTH
def test_froude_similarity(equation: Equation) -> None:
    """p half, pulses half as quick: the same envelope."""
    slow = plain_branch(RockingBlock(1.0, 1.0, 0.2, g), restitution=0.9)
    large = envelope(Oscillator(slow, slow, 1.0), PULSE_SHAPES["sine"], FREQUENCY / 2, AMPLITUDE, equation=equation)
    small = mapped(BLOCK, equation)
    np.testing.assert_allclose(large.lower_bound, small.lower_bound, rtol=1e-10)
    np.testing.assert_array_equal(large.overturned, small.overturned)


def test_the_impulse_of_a_half_sine_that_a_linearised_block_stands() -> None:
    """2 A / w of the ground gives B / I times that velocity; p phi_ov reaches overturning: A = g lambda w / (2 p)."""
    form, frequency = ONE.linearised, np.array([1.0, 300.0])
    found = safe_amplitude(BLOCK, PULSE_SHAPES["half-sine"], frequency, equation="linearised")
    needed = g * form.multiplier * 2 * np.pi * frequency / (2 * form.p)
    np.testing.assert_allclose(found, MARGIN * needed, rtol=1e-6)
    bound = envelope(BLOCK, PULSE_SHAPES["half-sine"], frequency, needed * 1.1, equation="linearised").lower_bound
    assert found[1] < bound[1] < 1.003 * needed[1]  # a pulse so short is an impulse


@BOTH
@pytest.mark.parametrize("shape", PULSE_SHAPES)
@pytest.mark.parametrize("body", [UNLIKE, ONE_SIDED], ids=["unlike", "one-sided"])
def test_nothing_overturns_that_is_called_safe(body: Oscillator, shape: str, equation: Equation) -> None:
    """Up to ten times of it something does: it is no empty promise."""
    frequency = np.array([0.4, 0.8, 6.0])
    weak = safe_amplitude(body, PULSE_SHAPES[shape], frequency, equation=equation)
    for f, amplitude in zip(frequency, weak, strict=True):
        below = amplitude * np.linspace(0.02, 1.0, 60)
        assert not falls(body, equation, shape, float(f), np.r_[below, -below]).any()
    more = weak[1] * np.geomspace(1.0, 10.0, 40)
    assert falls(body, equation, shape, 0.8, np.r_[more, -more]).any()


def test_an_impact_that_adds_energy_lowers_what_is_safe() -> None:
    """From a branch of large inertia to one of small, without loss of rate; the way back loses as much."""
    heavy = replace(ONE, inertia=4.0 * ONE.inertia, restitution=0.9)
    one = np.array([1.0])
    plain, gaining = (
        safe_amplitude(Oscillator(ONE, other, 1.0), PULSE_SHAPES["sine"], one, equation="exact")[0]
        for other in (ONE, heavy)
    )
    assert gaining == pytest.approx(plain / (0.9 * 2.0), rel=1e-12)


PROGRAM = """
import json, sys
sys.path.insert(0, {folder!r})
from test_envelope import COARSE, coarse
print(json.dumps([[f.overturned.tolist(), f.lower_bound.tolist(), f.polarity.tolist()] for f in map(coarse, COARSE)]))
"""
COARSE: tuple[tuple[str, Equation], ...] = (("cosine", "exact"), ("cosine", "linearised"), ("sine", "linearised"))


def coarse(case: tuple[str, Equation]) -> Envelope:
    """A map of three amplitudes, and its bound."""
    return envelope(UNLIKE, PULSE_SHAPES[case[0]], np.array([0.4]), np.array([1.0, 2.0, 3.0]), equation=case[1])


def test_without_numba() -> None:
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM.format(folder=os.path.dirname(__file__))],
        env={**os.environ, "NUMBA_DISABLE_JIT": "1", "PYTHONPATH": os.pathsep.join(sys.path)},
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    for case, (overturned, bound, polarity) in zip(COARSE, json.loads(done.stdout), strict=True):
        found = coarse(case)
        assert overturned == found.overturned.tolist()
        assert polarity == found.polarity.tolist() != [0]
        np.testing.assert_allclose(bound, found.lower_bound, rtol=1e-9)
