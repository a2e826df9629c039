"""The spectrum at the base of a mechanism upstairs: envelope of its motions, peaks widened, or C7.2.5."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.constants import g

from assess.amplification import FirstMode, ModalFilter, base_motion
from assess.codes.context import Building
from assess.study.checks import broaden, floor_spectrum
from assess.study.study import ScaledRecord
from records.record import scale
from records.response import response_spectrum
from records.scaling import Scaling
from records.synthetic import artificial_records
from spectra.asce7 import design_spectrum

GROUND = design_spectrum(s_ds=0.5 * g, s_d1=0.2 * g, t_l=6.0)
MODE = FirstMode(frequency=3.0, effective_height=6.0)
FILTER = ModalFilter(MODE, height=8.0)
HOUSE = Building(height=9.0, storeys=3, period=0.3, damping=0.05)


@pytest.fixture(scope="module")
def motions() -> tuple[ScaledRecord, ...]:
    records = artificial_records(GROUND, count=5, seed=2, duration=12.0, threads=1)
    return tuple(ScaledRecord(record, Scaling(1.0 + 0.1 * place, 0.0)) for place, record in enumerate(records))


def floor_of(motions, *, filtered=FILTER, building=None, height=8.0):
    base = tuple(base_motion(FILTER, motion.record) for motion in motions)
    return floor_spectrum(GROUND, height=height, filtered=filtered, base=base, motions=motions, building=building)


@pytest.mark.parametrize("damping", [0.02, 0.05, 1.0])
def test_no_motion_of_the_suite_and_no_ground_reaches_above_it(motions, damping) -> None:
    """At the building's period and away from it; the scale factors count."""
    floor, periods = floor_of(motions), np.array([0.0, 0.05, 0.2, 1.0 / 3.0, 0.4, 0.9, 2.0, 5.0, 20.0])
    found = floor.acceleration(periods, damping=damping)
    for motion in motions:
        at = scale(base_motion(FILTER, motion.record).record, motion.scaling.factor)
        assert np.all(response_spectrum(at, periods[:-1], damping=min(damping, 0.99)) <= found[:-1] * 1.001)
    assert np.all(GROUND.acceleration(periods, damping=damping) <= found * (1 + 1e-12))


def test_the_peak_is_as_wide_as_what_is_not_known_of_the_building(motions) -> None:
    floor, T_1 = floor_of(motions), 1.0 / MODE.frequency
    records = [scale(base_motion(FILTER, each.record).record, each.scaling.factor) for each in motions]
    peak = max(float(response_spectrum(record, T_1, damping=0.05)) for record in records)
    for share in (0.87, 1.0, 1.14):
        assert float(floor.acceleration(share * T_1, damping=0.05)) >= 0.999 * peak


def test_peaks_broadened_by_hand() -> None:
    """A peak of one period covers all from 0.85 of it to it over 0.85."""
    period = np.array([0.5, 0.84, 0.86, 1.0, 1.17, 1.18])
    assert broaden(period, np.array([1.0, 1.0, 1.0, 5.0, 2.0, 1.0])).tolist() == [1.0, 1.0, 5.0, 5.0, 5.0, 2.0]


def test_where_no_suite_holds_it_is_the_circulars(motions) -> None:
    """At T_1: A a_Z with A = 1.1 xi^-0.5, a_Z = S_a(T_1) gamma Z/H sqrt(1 + 0.0004 xi^2), gamma = 9/7."""
    a_z = 0.5 * g * 9.0 / 7.0 * 8.0 / 9.0 * (1.0 + 0.0004 * 25.0) ** 0.5
    for few, filtered in ((motions, None), (motions[:4], FILTER)):
        floor = floor_of(few, filtered=filtered, building=HOUSE)
        assert float(floor.acceleration(0.3, damping=0.05)) == pytest.approx(1.1 * 0.05**-0.5 * a_z, rel=1e-9)
        assert float(floor.acceleration(9.0)) >= float(GROUND.acceleration(9.0))
        assert float(floor.acceleration(0.3 * 1.14 * 1.1, damping=0.05)) >= 0.999 * 1.1 * 0.05**-0.5 * a_z


def test_nothing_gives_none(motions) -> None:
    assert floor_of(motions[:4]) is None
    assert floor_of(motions, filtered=None) is None
    assert floor_of(motions, filtered=None, building=replace(HOUSE, storeys=None)) is None
    assert floor_of(motions, filtered=None, building=HOUSE, height=9.5) is None
