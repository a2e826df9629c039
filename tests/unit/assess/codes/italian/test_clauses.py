"""The formulas that both Italian circulars have, on a straight capacity curve, by hand."""

from __future__ import annotations

from dataclasses import replace

import pytest
from scipy.constants import g

from assess.codes import italian_kinematic
from assess.codes.check import Outcome
from assess.codes.context import Building, SiteHazard
from assess.codes.italian_kinematic import DisplacementLimit, displacement_capacity
from assess.codes.italian_limit_states import (
    ItalianOptions,
    confidence_factors,
    floor_of,
    outcome_of,
    pga_ratio,
    return_period,
)
from assess.oscillator import LocalLimit
from spectra.asce7 import design_spectrum
from tests.support.straight import CURVES, GROUND, HOUSE, MASS, PHI, RAISED, SOFT, SPECTRUM, STRAIGHT

LC1, LC2, LC3 = 1.35, 1.20, 1.00


@pytest.mark.parametrize(("FC", "in_g"), [(1.0, 0.25), (1.25, 0.2), (LC1, 0.185185)])  # 0.2 / (0.8 FC)
def test_activation(FC: float, in_g: float) -> None:
    assert italian_kinematic.activation(STRAIGHT, mass=MASS, confidence_factor=FC) / g == pytest.approx(in_g, rel=1e-5)


@pytest.mark.parametrize(("branch", "d0"), [(STRAIGHT, 0.5), (replace(STRAIGHT, overturning_flexible=0.16), 0.4)])
def test_displacement_at_collapse(branch, d0: float) -> None:
    assert italian_kinematic.displacement_at_collapse(branch, mass=MASS) == pytest.approx(d0, rel=1e-9)


@pytest.mark.parametrize(("rotation", "moved"), [(0.0, 0.0), (0.04, 0.1), (0.08, 0.2), (0.2, 0.5)])  # 2.5 phi
def test_displacement_at(rotation: float, moved: float) -> None:
    assert italian_kinematic.displacement_at(STRAIGHT, rotation, mass=MASS) == pytest.approx(moved, abs=1e-12)


@pytest.mark.parametrize(
    ("moved", "rotation"), [(0.08, 0.04), (0.16, 0.08), (0.39, 0.195)]
)  # of the control point: 2 phi
def test_rotation_at(moved: float, rotation: float) -> None:
    assert italian_kinematic.rotation_at(STRAIGHT, moved, mass=MASS) == pytest.approx(rotation, rel=1e-9)


@pytest.mark.parametrize(("rotation", "multiplier"), [(0.0, 0.2), (0.05, 0.15), (0.2, 0.0)])
def test_multiplier_at(rotation: float, multiplier: float) -> None:
    assert italian_kinematic.multiplier_at(STRAIGHT, rotation) == pytest.approx(multiplier, abs=1e-12)


@pytest.mark.parametrize(("moved", "FC", "in_g"), [(0.2, 1.0, 0.15), (0.2, 1.5, 0.1), (0.3, 1.0, 0.1)])
def test_acceleration_at(moved: float, FC: float, in_g: float) -> None:
    """(0.2 - d / 2.5) / (0.8 FC)."""
    found = italian_kinematic.acceleration_at(STRAIGHT, moved, mass=MASS, confidence_factor=FC)
    assert found / g == pytest.approx(in_g, rel=1e-8)  # read 1e-9 before the rotation


@pytest.mark.parametrize(
    ("branch", "FC", "amplified", "in_g"),
    [(STRAIGHT, 1.0, 1.0, 0.2), (STRAIGHT, 1.25, 0.5, 0.16), (STRAIGHT, 1.25, 2.0, 0.08), (SOFT, 1.0, 1.0, None)],
)
def test_uplift_pga(branch, FC: float, amplified: float, in_g: float | None) -> None:
    found = italian_kinematic.uplift_pga(branch, confidence_factor=FC, amplified=amplified)
    assert found == (None if in_g is None else pytest.approx(in_g * g, rel=1e-12))


WEAK = replace(STRAIGHT, restoring=STRAIGHT.restoring * (1.0 - 0.7 * (PHI > 0.0799)))  # loses 70 % at 0.08 rad


@pytest.mark.parametrize(
    ("share", "breaks", "kind", "rotation", "breaking", "moved"),
    [
        (0.4, True, None, 0.0, STRAIGHT, 0.2),
        (0.6, True, None, 0.0, STRAIGHT, 0.3),
        (0.4, True, "seat", 0.04, STRAIGHT, 0.1),
        (0.4, True, "seat", 0.1, STRAIGHT, 0.2),
        (0.6, True, "break", 0.05, STRAIGHT, 0.3),  # 0.15 left of 0.2: more than half
        (0.6, True, "break", 0.12, STRAIGHT, 0.3),  # 0.08 left: limits at 0.3, which the share is too
        (0.9, True, "break", 0.12, STRAIGHT, 0.3),
        (0.9, False, "break", 0.12, STRAIGHT, 0.45),  # where breaks do not limit
        (0.9, True, "break", 0.08, WEAK, 0.2),  # 0.036 left of 0.2
    ],
)
def test_threshold_of(share: float, breaks: bool, kind, rotation: float, breaking, moved: float) -> None:
    limits = () if kind is None else (LocalLimit(kind, "tie", "positive", rotation),)
    curves = replace(CURVES, breaking=breaking, limits=limits)
    found = displacement_capacity(curves, DisplacementLimit(share, breaks=breaks, clause=""))
    assert (found.displacement, found.collapse) == pytest.approx((moved, 0.5), rel=1e-9)


@pytest.mark.parametrize(
    ("crushing", "level", "given", "factors"),
    [
        (False, None, None, [LC1]),
        (False, "LC3", None, [LC1]),  # without crushing that of LC1, whatever is known
        (True, "LC1", None, [1.35]),
        (True, "LC2", None, [1.20]),
        (True, "LC3", None, [1.00]),
        (True, None, None, [LC1]),
        (True, "LC2", 1.5, [1.5]),  # a larger one decides
        (True, "LC2", 1.1, [LC2, 1.1]),  # a lower one is for comparison
        (True, "LC2", 1.2, [LC2]),
    ],
)
def test_confidence_factors(crushing: bool, level: str | None, given: float | None, factors: list[float]) -> None:
    found = confidence_factors(ItalianOptions(confidence_factor=given), crushing=crushing, level=level)
    assert [each.factor for each in found] == factors
    assert [each.instead_of for each in found[1:]] == [factors[0]] * (len(factors) - 1)


@pytest.mark.parametrize(
    ("elevation", "rise", "building", "psi", "gamma"),
    [
        (6.0, 0.0, HOUSE, 0.666667, 1.285714),  # 3 N / (2 N + 1): 9 / 7
        (3.0, 3.0, HOUSE, 0.5, 1.285714),  # mean of base and top
        (9.0, 0.0, replace(HOUSE, storeys=1), 1.0, 1.0),
        (0.0, 0.0, HOUSE, None, None),
        (6.0, 0.0, None, None, None),
        (6.0, 0.0, replace(HOUSE, storeys=None), None, None),
    ],
)
def test_floor_of(elevation: float, rise: float, building: Building | None, psi, gamma) -> None:
    found = floor_of(replace(RAISED, elevation=elevation, rise=rise, building=building))
    if psi is None:
        assert found is None
    else:
        assert found is not None
        assert (found.psi, found.gamma, found.T1) == pytest.approx((psi, gamma, 0.5), rel=1e-6)


@pytest.mark.parametrize(("ratio", "outcome"), [(0.999, Outcome.PASS), (1.0, Outcome.PASS), (1.001, Outcome.FAIL)])
def test_outcome_of(ratio: float, outcome: Outcome) -> None:
    assert outcome_of(ratio) == outcome


HALF = design_spectrum(s_ds=0.25 * g, s_d1=0.1 * g, t_l=6.0)
HAZARD = SiteHazard({"SLD": HALF, "SLV": SPECTRUM}, (50.0, 475.0, 975.0), (0.1 * g, 0.25 * g, 0.33 * g))


@pytest.mark.parametrize(
    ("hazard", "state", "ratio"), [(HAZARD, "SLD", 0.5), (HAZARD, "SLV", 1.0), (HAZARD, "SLC", 1.0), (None, "SLD", 1.0)]
)
def test_pga_ratio(hazard: SiteHazard | None, state: str, ratio: float) -> None:
    assert pga_ratio(hazard, GROUND.spectrum, state) == pytest.approx(ratio, rel=1e-12)


@pytest.mark.parametrize(
    ("in_g", "years", "bound"),
    [
        (0.1, 50.0, ""),
        (0.25, 475.0, ""),
        (0.158114, 154.1103, ""),  # sqrt(0.1 x 0.25) lies at sqrt(50 x 475) years
        (0.287228, 680.5329, ""),  # sqrt(0.25 x 0.33), sqrt(475 x 975)
        (0.05, 50.0, "<="),
        (0.4, 975.0, ">="),
    ],
)
def test_return_period(in_g: float, years: float, bound: str) -> None:
    found, marked = return_period(HAZARD, in_g * g)
    assert (found, marked) == (pytest.approx(years, rel=2e-5), bound)
