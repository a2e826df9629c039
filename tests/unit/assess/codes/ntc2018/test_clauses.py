"""Circolare 7/2019, C8.7.1.2 and C7.2.3: every formula on a straight capacity curve, by hand (g = 9.80665 m/s2).

The floor of the tests: gamma psi = 9/7 x 6/9 = 0.857143, xi_1 = 5 %: A = 1.1 / sqrt(0.05) = 4.919350 at 5 %, and
a_Z = S_e(T_1) 0.857143 sqrt(1 + 0.0004 x 25) = 0.861418 S_e(T_1).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.constants import g

from assess.codes import ntc2018_clauses
from assess.codes.context import FreePeriod, StatedFirstMode
from assess.codes.italian_limit_states import Demands, Floor
from assess.codes.ntc2018_clauses import FirstModes
from assess.codes.toothing import toothing_friction
from assess.oscillator import LocalLimit
from spectra.table import table_spectrum
from tests.support.straight import CURVES, GROUND, HOUSE, RAISED, SOFT, STRAIGHT

HAND = 2e-5  # hand values have six figures
FLOOR = Floor(psi=6.0 / 9.0, gamma=9.0 / 7.0, T1=0.5, damping=0.05)
ONE = FirstModes(shortest=1.0, longest=1.0, damping=0.05, floor=FLOOR)  # a_Z = 0.861418 x 0.2 g = 1.689525 m/s2
SHORT = replace(RAISED, spectrum=table_spectrum([0.0, 0.4], [1.0, 2.0]))  # ends before the building's period


@pytest.mark.parametrize(
    ("state", "FC", "T0", "a", "T"),
    [
        ("SLV", 1.0, 0.0, 1.470998, 1.946118),  # d = 0.2, phi = 0.08: 0.12 g / 0.8; 1.68 pi sqrt(d / a)
        ("SLV", 1.35, 0.0, 1.089628, 2.261179),  # times sqrt(1.35)
        ("SLV", 1.0, 1.5, 1.470998, 1.946118),  # the elastic branch is above: 3.509 m/s2
        ("SLV", 1.0, 3.0, 0.877298, 2.52),  # on the elastic branch: T = 0.84 T0
        ("SLC", 1.0, 0.0, 0.980665, 2.710652),  # d = 0.3, phi = 0.12: 0.08 g / 0.8; 1.56 pi sqrt(d / a)
    ],
)
def test_capacity_of(state: str, FC: float, T0: float, a: float, T: float) -> None:
    found = ntc2018_clauses.capacity_of(CURVES, state=state, confidence_factor=FC, T0=T0)
    assert (found.e, found.d0, found.d) == pytest.approx((0.8, 0.5, 0.2 if state == "SLV" else 0.3), rel=1e-9)
    assert (found.a0, found.a, found.T) == pytest.approx((0.25 * g / FC, a, T), rel=HAND)


@pytest.mark.parametrize(("d", "T0", "a"), [(0.02, 0.5, 3.158273), (0.2, 3.0, 0.877298), (0.2, 1.5, 3.509193)])
def test_elastic_branch(d: float, T0: float, a: float) -> None:
    """4 pi^2 d / T0^2 (C8.7.1.6)."""
    assert ntc2018_clauses.elastic_branch(d, T0=T0) == pytest.approx(a, rel=HAND)


@pytest.mark.parametrize(
    ("support", "length", "period"),
    # kappa L^2 / t sqrt(1800 / 1e9), L = 3 m: 6.2 x 30 x 0.001341641
    [("cantilever", 3.0, 0.249545), ("supported", 3.0, 0.0885483), ("cantilever", 6.0, 0.998181)],
)
def test_free_period(support, length: float, period: float) -> None:
    element = ntc2018_clauses.FreeElement(length, thickness=0.3, young_modulus=1e9, density=1800.0, support=support)
    found = ntc2018_clauses.free_period(element)
    assert found.value == pytest.approx(period, rel=HAND)


@pytest.mark.parametrize(
    ("branch", "given", "T0"), [(STRAIGHT, None, 0.0), (SOFT, None, 1.0), (STRAIGHT, FreePeriod(0.3), 0.3)]
)
def test_period_of(branch, given: FreePeriod | None, T0: float) -> None:
    assert ntc2018_clauses.period_before_uplift(branch, replace(GROUND, free_period=given)) == pytest.approx(
        T0, rel=1e-9
    )


@pytest.mark.parametrize(
    ("modes", "T0", "ground", "floor"),
    [
        ((), 0.0, 1.0, 0.0),
        ((), 0.2, 2.5, 0.0),  # 0.5 g / 0.2 g
        ((), 1.0, 1.0, 0.0),
        ((ONE,), 0.0, 1.0, 0.861418),  # a_Z
        ((ONE,), 1.0, 1.0, 4.237616),  # A a_Z on the plateau
        ((ONE,), 0.4, 2.5, 1.848144),  # A a_Z / (1 + (A - 1) 0.5^1.6), 0.5 = 1 - 0.4 / 0.8
    ],
)
def test_acceleration_demands(modes: tuple[FirstModes, ...], T0: float, ground: float, floor: float) -> None:
    found = ntc2018_clauses.acceleration_demands(RAISED, modes, T0=T0)
    assert found is not None
    assert (found.ground, found.floor) == pytest.approx((ground, floor), rel=HAND)


@pytest.mark.parametrize(
    ("modes", "T", "ground", "floor"),
    [
        (None, 2.0, 0.0506606, 0.0),  # (T / 2 pi)^2 / T
        (ONE, 1.0, 0.0253303, 0.107340),  # 4.237616 / 4 pi^2
        (ONE, 2.0, 0.0506606, 0.129881),  # the bound: 4.237616 (1.1 / 2 pi)^2 above 1.038482 (2 / 2 pi)^2 = 0.105220
        (ONE, 1.2, 0.0303964, 0.129881),  # the bound again: 4.237616 / 1.220 (1.2 / 2 pi)^2 = 0.126700
    ],
)
def test_displacement_demands(modes: FirstModes | None, T: float, ground: float, floor: float) -> None:
    found = ntc2018_clauses.displacement_demands(RAISED, modes, T0=0.0, T=T, damping=0.05)
    assert found is not None
    assert (found.ground, found.floor) == pytest.approx((ground, floor), rel=HAND)


@pytest.mark.parametrize("demands", [ntc2018_clauses.acceleration_demands, ntc2018_clauses.displacement_demands])
def test_a_spectrum_that_ends_before_the_building_gives_no_demand(demands) -> None:
    given, more = ONE, {"T": 0.2, "damping": 0.05}
    if demands is ntc2018_clauses.acceleration_demands:
        given, more = (ONE,), {}
    assert demands(SHORT, given, T0=0.1, **more) is None


@pytest.mark.parametrize(
    ("stated", "T0", "floor"),
    [
        # Rigid: a_Z falls as 1 / T_1', and 10 % of damping lowers it, so that the elastic building decides
        ({}, 0.0, 1.722836),  # 0.861418 / 0.5
        # T0 = 1.0 s: the elastic building gives A a_Z / (1 + (A - 1) (1 / 0.55 - 1)^1.2) = 4.91935 x 1.722836 / 4.0805
        # = 2.077, the softened one of 1 / 1.1 s its plateau: 1.1 / sqrt(0.1) x 1.1 x 0.857143 sqrt(1.04) / 1.2
        ({}, 1.0, 2.787270),
        # A period stated for the limit state, 0.6 s at 12 %, ends the range: A a_Z / (1 + (A - 1) (1 / 0.66 - 1)^1.2)
        # = 3.175426 x 1.185 / 1.983 there, below the elastic building's
        ({"SLV": StatedFirstMode(0.6, 0.12, "pushover")}, 1.0, 2.076993),
    ],
)
def test_activation_modes(stated, T0: float, floor: float) -> None:
    context = replace(RAISED, building=replace(HOUSE, limit_states=stated))
    modes = ntc2018_clauses.activation_modes(context, "SLV")
    assert max(ntc2018_clauses.floor_acceleration(context, each, T0)[1] for each in modes) / (0.2 * g) == (
        pytest.approx(floor, rel=2e-3)  # the plateau's corner lies beside the scan
    )
    assert ntc2018_clauses.activation_modes(GROUND, "SLV") == ()


@pytest.mark.parametrize(
    ("branch", "context", "FC", "in_g"),
    [
        (STRAIGHT, GROUND, 1.0, 0.2),
        (STRAIGHT, GROUND, 1.25, 0.16),
        (STRAIGHT, RAISED, 1.0, 0.116087),  # T1 = 0.5 s: a_Z / PGA = 2 x 0.861418
        (SOFT, GROUND, 1.0, None),
        (STRAIGHT, SHORT, 1.0, None),
    ],
)
def test_uplift(branch, context, FC: float, in_g: float | None) -> None:
    found = ntc2018_clauses.uplift_on_floor(branch, context, confidence_factor=FC)
    assert found == (None if in_g is None else pytest.approx(in_g * g, rel=HAND))


@pytest.mark.parametrize(("ground", "floor", "pga"), [(1.0, 0.0, 2.0), (1.0, 1.6, 1.25), (2.5, 1.6, 0.8)])
def test_activation_pga(ground: float, floor: float, pga: float) -> None:
    assert ntc2018_clauses.activation_pga(2.0, Demands(ground, floor)) == pytest.approx(pga, rel=1e-12)


@pytest.mark.parametrize(("damping", "counted"), [(0.05, 0.05), (0.08, 0.05), (0.03, 0.03)])  # at most 5 %
def test_elastic_modes(damping: float, counted: float) -> None:
    found = ntc2018_clauses.elastic_modes(replace(RAISED, building=replace(HOUSE, damping=damping)))
    assert found is not None
    assert (found.shortest, found.longest, found.damping) == (0.5, 0.5, counted)
    assert found.share == pytest.approx(0.857143, rel=HAND)
    assert ntc2018_clauses.elastic_modes(GROUND) is None


@pytest.mark.parametrize(
    ("stated", "state", "modes"),
    [
        ({}, "SLV", (0.75, 1.0, 0.10)),  # 1.5 and 2.0 times 0.5 s, at 10 %
        ({"SLV": StatedFirstMode(0.9, 0.12, "pushover")}, "SLV", (0.9, 0.9, 0.12)),
        ({"SLV": StatedFirstMode(0.9, 0.12, "pushover")}, "SLC", (0.75, 1.0, 0.10)),
    ],
)
def test_modes_at(stated, state: str, modes: tuple[float, float, float]) -> None:
    found = ntc2018_clauses.ultimate_modes(replace(RAISED, building=replace(HOUSE, limit_states=stated)), state)
    assert found is not None
    assert (found.shortest, found.longest, found.damping) == modes
    assert ntc2018_clauses.ultimate_modes(GROUND, state) is None


@pytest.mark.parametrize(("first", "a_Z"), [(1.0, 1.689525), (0.5, 3.379050), (2.0, 0.844763)])  # S_e = 0.2 g / T
def test_peak_acceleration(first: float, a_Z: float) -> None:
    assert ntc2018_clauses.peak_acceleration(RAISED, ONE, first) == pytest.approx(a_Z, rel=HAND)


@pytest.mark.parametrize(
    ("T", "S_eZ"),
    [
        (0.0, 1.689525),  # a_Z
        (0.4, 3.624820),  # A a_Z / 2.292904
        (0.8, 8.311365),  # A a_Z, from 0.8 to 1.1 of T_1
        (1.0, 8.311365),
        (2.0, 2.036805),  # A a_Z / (1 + (A - 1) (2 / 1.1 - 1)^1.2) = A a_Z / 4.080590
    ],
)
def test_ordinate(T: float, S_eZ: float) -> None:
    assert ntc2018_clauses.floor_ordinate(RAISED, ONE, 1.0, T, damping=0.05) == pytest.approx(S_eZ, rel=HAND)
    both = ntc2018_clauses.floor_ordinates(RAISED, ONE, np.array([1.0, 1.0]), np.array([T, 1.0]), damping=0.05)
    assert both == pytest.approx([S_eZ, 8.311365], rel=HAND)


@pytest.mark.parametrize(
    ("T0", "first", "acceleration"),
    # over T_1' from 0.75 to 1.0 s a_Z falls as 1 / T_1': rigid 0.75 s; T0 = 1.0 on the plateau from T_1' = 1 / 1.1 on
    [(0.0, 0.75, 2.252700), (1.0, 1.0 / 1.1, 9.142502)],
)
def test_floor_acceleration(T0: float, first: float, acceleration: float) -> None:
    modes = replace(ONE, shortest=0.75)
    found = ntc2018_clauses.floor_acceleration(RAISED, modes, T0)
    assert found == pytest.approx((first, acceleration), rel=2e-3)  # the very top lies beside the corner of the plateau
    assert found[1] >= acceleration * (1.0 - HAND)


@pytest.mark.parametrize(
    ("T", "moved", "least"),
    [(1.0, 0.210529, 0.0), (2.0, 0.206372, 0.254740)],  # 8.311365 / 4 pi^2; 2.036805 / pi^2, 8.311365 1.21 / 4 pi^2
)
def test_floor_demand(T: float, moved: float, least: float) -> None:
    found = ntc2018_clauses.floor_demand(RAISED, ONE, T0=0.0, T=T, damping=0.05)
    assert (found.first, found.period) == (1.0, T)
    assert (found.displacement, found.least, found.largest) == pytest.approx(
        (moved, least, max(moved, least)), rel=HAND
    )


FALLING = table_spectrum([0.0, 0.1, 1.0, 2.0], [4.0, 10.0, 10.0, 1.0])


@pytest.mark.parametrize(
    ("context", "T", "period"),
    [
        (GROUND, 1.5, 1.5),
        (GROUND, 5.0, 5.0),
        (replace(GROUND, spectrum=FALLING), 1.2, 1.2),
        (replace(GROUND, spectrum=FALLING), 2.0, 1.407407),  # (19 - 9 T) T^2 is largest at T = 38 / 27
    ],
)
def test_ground_period(context, T: float, period: float) -> None:
    found = ntc2018_clauses.ground_period(context, T0=0.0, T=T, damping=0.05)
    assert found == pytest.approx(period, abs=0.004)  # one step of the scan


@pytest.mark.parametrize(("modes", "T", "longest"), [(None, 2.0, 2.0), (ONE, 0.9, 1.1), (ONE, 3.0, 3.0)])  # b = 1.1
def test_longest_period_used(modes: FirstModes | None, T: float, longest: float) -> None:
    assert ntc2018_clauses.longest_period_used(modes, T) == pytest.approx(longest, rel=1e-12)


@pytest.mark.parametrize(
    ("height", "unit_height", "overlap", "thickness", "unit_weight", "force"),
    [
        (6.0, 0.25, 0.15, 0.5, 19e3, 49333.5),  # 0.4 x 24 x 25 x (0.25 / 0.15) x 0.577 x 0.15^2 x 0.5 x 19000
        (2.0, 0.20, 0.20, 0.4, 20e3, 8124.16),  # 0.4 x 10 x 11 x 1 x 0.577 x 0.2^2 x 0.4 x 20000
    ],
)
def test_toothing_friction(height, unit_height, overlap, thickness, unit_weight, force) -> None:
    found = toothing_friction(
        height=height, unit_height=unit_height, overlap=overlap, thickness=thickness, unit_weight=unit_weight
    )
    assert found == pytest.approx(force, rel=1e-9)


@pytest.mark.parametrize(("kind", "rotation", "d"), [("seat", 0.04, 0.1), ("seat", 0.1, 0.2), ("break", 0.04, 0.2)])
def test_local_limits_of_slv(kind, rotation: float, d: float) -> None:
    """A seat at 2.5 x 0.04 m; a break there leaves 0.16 of 0.2, more than half, and limits nothing."""
    curves = replace(CURVES, limits=(LocalLimit(kind, "floor", "positive", rotation),))
    assert ntc2018_clauses.capacity_of(curves, state="SLV", confidence_factor=1.0).d == pytest.approx(d, rel=1e-9)
