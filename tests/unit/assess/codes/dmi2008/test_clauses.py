"""Circolare 617/2009, C8A.4: every formula on a straight capacity curve, worked by hand (g = 9.80665 m/s2)."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.constants import g

from assess.codes import dmi2008
from assess.codes.dmi2008 import thesis_pga_rotation
from assess.codes.italian_limit_states import Floor
from assess.oscillator import LocalLimit
from spectra.table import table_spectrum
from tests.support.straight import CURVES, GROUND, HOUSE, MASS, RAISED, SOFT, STRAIGHT

HAND = 2e-5  # hand values have six figures


@pytest.mark.parametrize(
    ("FC", "a0", "a_s", "T_s"),
    # d0* = 0.5, du* = 0.2, ds* = 0.08 m: phi = 0.032, a_s* = 0.168 g / 0.8; T_s = 2 pi sqrt(0.08 / 2.059397)
    [(1.0, 2.451663, 2.059397, 1.238385), (1.35, 1.816046, 1.525479, 1.438874)],
)
def test_capacity_of(FC: float, a0: float, a_s: float, T_s: float) -> None:
    found = dmi2008.capacity_of(CURVES, confidence_factor=FC)
    assert (found.e, found.d0, found.du, found.ds) == pytest.approx((0.8, 0.5, 0.2, 0.08), rel=1e-9)
    assert (found.a0, found.as_, found.Ts) == pytest.approx((a0, a_s, T_s), rel=HAND)


@pytest.mark.parametrize(("rotation", "du"), [(0.04, 0.1), (0.08, 0.2), (0.1, 0.2)])  # d* = 2.5 phi, at most 0.4 d0*
def test_a_seat_that_is_lost_before_limits_the_capacity(rotation: float, du: float) -> None:
    curves = replace(CURVES, limits=(LocalLimit("seat", "floor", "positive", rotation),))
    assert dmi2008.capacity_of(curves, confidence_factor=1.0).du == pytest.approx(du, rel=1e-9)


@pytest.mark.parametrize(
    ("T_s", "moved"), [(0.3, 0.0111783), (1.0, 0.0496811), (2.0, 0.0993621)]
)  # S_e = 0.5 g, 0.2 g, 0.1 g times (T / 2 pi)^2
def test_ground_displacement(T_s: float, moved: float) -> None:
    assert dmi2008.ground_displacement(GROUND, T_s) == pytest.approx(moved, rel=HAND)


FLOOR = Floor(psi=2.0 / 3.0, gamma=9.0 / 7.0, T1=0.5, damping=0.05)


@pytest.mark.parametrize(
    ("T_s", "moved"),
    # S_De(T1) = 0.4 g (0.5 / 2 pi)^2 = 0.0248405 m, psi gamma = 6/7; r = 1: 1 / sqrt(0.02); 2: 4 / sqrt(1.04)
    [(0.5, 0.150557), (1.0, 0.0835138), (2.5, 0.132660)],  # 5: 25 / sqrt(16.1)
)
def test_floor_displacement(T_s: float, moved: float) -> None:
    assert dmi2008.floor_displacement(RAISED, FLOOR, T_s) == pytest.approx(moved, rel=HAND)


@pytest.mark.parametrize(
    ("floor", "acceleration"),
    [(FLOOR, 3.362280), (replace(FLOOR, psi=1.0), 5.043420), (replace(FLOOR, T1=1.0), 1.681140)],  # S_e 0.4 g, 0.2 g
)
def test_floor_acceleration(floor: Floor, acceleration: float) -> None:
    assert dmi2008.floor_acceleration(RAISED, floor) == pytest.approx(acceleration, rel=HAND)


@pytest.mark.parametrize(
    ("branch", "context", "FC", "pga"),
    [
        (STRAIGHT, GROUND, 1.0, 1.961330),  # 0.2 g
        (STRAIGHT, GROUND, 1.25, 1.569064),
        (STRAIGHT, RAISED, 1.0, 1.144109),  # S_e(T1) psi gamma / PGA = 2 x 6/7
        (SOFT, GROUND, 1.0, None),
        (STRAIGHT, replace(RAISED, spectrum=table_spectrum([0.0, 0.4], [1.0, 2.0])), 1.0, None),  # ends before T1
    ],
)
def test_uplift(branch, context, FC: float, pga: float | None) -> None:
    found = dmi2008.uplift_on_floor(branch, context, confidence_factor=FC)
    assert found == (None if pga is None else pytest.approx(pga, rel=HAND))


@pytest.mark.parametrize(
    ("rotation", "in_g"),
    # a_s = 0.2 g (1 - 0.4 x), T = 2 pi sqrt(0.4 x / a_s), S_a / PGA = 1 / T: x = 1: 0.12 g, 3.663189 s
    [(0.2, 0.439583), (0.1, 0.358913)],  # x = 0.5: 0.16 g, 2.243207 s
)
def test_thesis_pga_rotation(rotation: float, in_g: float) -> None:
    curve = thesis_pga_rotation(STRAIGHT, GROUND, mass=MASS)
    assert curve.pga_of(np.array([rotation])) / g == pytest.approx([in_g], rel=HAND)


def test_the_house_of_these_tests() -> None:
    """psi = 6/9 and gamma = 9/7 are those of three storeys at 6 m of 9 m."""
    assert (FLOOR.psi, FLOOR.gamma) == pytest.approx((6.0 / HOUSE.height, 9.0 / 7.0), rel=1e-12)
