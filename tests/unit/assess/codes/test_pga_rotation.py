"""Demand and capacity on a PGA-rotation curve of known shape."""

from __future__ import annotations

import numpy as np
import pytest

from assess.codes.pga_rotation import floor_pga_rotation, pga_capacity, pga_rotation, rotation_demand


def falling_then_rising(phi):
    """4 at rest, down to 1 at phi = 0.01, then up with slope 10."""
    return np.where(phi < 0.01, 4 - 300 * phi, 1 + 10 * (phi - 0.01))


def test_demand_is_where_the_curve_rises_through_the_level():
    curve = pga_rotation(falling_then_rising, overturning=1.0)
    assert rotation_demand(curve, 2.0) == pytest.approx(0.11, abs=1e-12)


def test_below_the_whole_curve_nothing_rocks():
    assert rotation_demand(pga_rotation(falling_then_rising, overturning=1.0), 0.9) == 0.0


def test_above_the_whole_rising_stretch_the_body_overturns():
    assert rotation_demand(pga_rotation(falling_then_rising, overturning=1.0), 11.0) is None


def test_capacity_is_reached_at_the_allowable_rotation():
    curve = pga_rotation(falling_then_rising, overturning=1.0)
    assert pga_capacity(curve, 0.5) == pytest.approx(5.9, rel=1e-12)


def test_capacity_ignores_the_unstable_start_and_keeps_uplift():
    assert pga_capacity(pga_rotation(falling_then_rising, overturning=1.0), 0.05) == pytest.approx(1.4, rel=1e-12)
    assert pga_capacity(pga_rotation(falling_then_rising, overturning=1.0, uplift=3.0), 0.05) == 3.0


def test_below_uplift_nothing_rocks_and_above_it_the_demand_jumps():
    curve = pga_rotation(falling_then_rising, overturning=1.0, uplift=3.0)
    assert rotation_demand(curve, 3.0) == 0.0
    assert rotation_demand(curve, 3.0001) == pytest.approx(0.21, abs=1e-4)


def test_while_the_curve_still_falls_at_the_allowable_its_bottom_is_the_capacity():
    curve = pga_rotation(lambda phi: 2 - phi + np.maximum(phi - 0.8, 0) * 5, overturning=1.0)
    assert pga_capacity(curve, 0.5) == pytest.approx(1.2, rel=1e-2)  # the bottom, at 0.8, to the grid's step
    assert rotation_demand(curve, 1.3) > 0.5


def test_where_the_spectrum_ends_nothing_is_claimed():
    curve = pga_rotation(falling_then_rising, overturning=1.0, period_of=lambda phi: 4 * phi, longest_period=2.0)
    assert not curve.complete
    assert rotation_demand(curve, 2.0) == pytest.approx(0.11, abs=1e-12)
    assert rotation_demand(curve, 7.0) is None
    assert pga_capacity(curve, 0.7) is None
    assert pga_capacity(curve, 0.3) == pytest.approx(3.9, rel=1e-12)


def test_a_hump_before_the_allowable_governs():
    curve = pga_rotation(lambda phi: 1 + 2 * np.sin(np.pi * phi), overturning=1.0)
    assert pga_capacity(curve, 0.9) == pytest.approx(3.0, rel=1e-4)  # grid of 1 % around the summit
    assert rotation_demand(curve, 2.999) < 0.5


def falling_twice(phi):
    """From 4 down to 1 at 0.1, up to 3 at 0.3, down to 2 at 0.5, up to 6 at 1."""
    return np.interp(phi, [0.0, 0.1, 0.3, 0.5, 1.0], [4.0, 1.0, 3.0, 2.0, 6.0])


@pytest.mark.parametrize(
    ("level", "rotation"), [(0.9, 0.0), (1.5, 0.15), (2.5, 0.5625), (3.5, 0.6875), (5.0, 0.875), (6.1, None)]
)
def test_on_a_curve_that_falls_again_the_last_rotation_that_reaches_the_level_counts(level, rotation):
    curve = floor_pga_rotation(
        falling_twice, overturning=1.0, uplift=0.0, period_of=lambda phi: phi, longest_period=np.inf
    )
    found = rotation_demand(curve, level)
    assert found == (rotation if not rotation else pytest.approx(rotation, abs=1e-9))


@pytest.mark.parametrize(("allowable", "pga"), [(0.15, 1.5), (0.2, 2.0), (0.3, 2.0), (0.5, 2.0), (0.75, 4.0)])
def test_its_capacity_is_the_least_pga_that_takes_it_beyond(allowable, pga):
    curve = floor_pga_rotation(
        falling_twice, overturning=1.0, uplift=0.0, period_of=lambda phi: phi, longest_period=np.inf
    )
    assert pga_capacity(curve, allowable) == pytest.approx(pga, abs=1e-9)
