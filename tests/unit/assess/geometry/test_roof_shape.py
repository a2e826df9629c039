"""Shapes of roofs and vaults against closed forms, turned and shifted."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from assess.geometry.solid import Solid, box, polyhedron, profile
from assess.loads.roofs_and_vaults import extent_along, intrados_area, mean_lever_arm, overall_height, roof_slope
from tests.support.solids import moved_solid
from tests.support.vaults import barrel_section, groined_vault, thicken

GABLE = profile(  # a pair of slabs of even thickness: their undersides lie under their tops by 0.2 m, upright
    [[-3, 0], [0, 2.5], [3, 0], [3, 0.2], [0, 2.7], [-3, 0.2]], length=4.0, density=500.0, name="roof"
)


def ring(*, parts=240, **form) -> Solid:
    """A barrel vault of circular section."""
    return profile(barrel_section(parts=parts, **form), length=5.0, density=1800.0, name="vault")


def turned(solid: Solid, degrees: float) -> Solid:
    return moved_solid(solid, Rotation.from_euler("z", degrees, degrees=True), [500.0, -300.0, 40.0])


@pytest.mark.parametrize("degrees", [0.0, 35.0, 90.0, 200.0])
@pytest.mark.parametrize("covering", [GABLE, ring(parts=24), ring(half_angle=0.6, parts=24)])
def test_the_axis_runs_across_the_ridge(covering, degrees):
    found = roof_slope(turned(covering, degrees))
    across = (np.cos(np.radians(degrees)), np.sin(np.radians(degrees)), 0.0)
    assert abs(found.axis @ across) == pytest.approx(1.0, rel=1e-9)
    assert not found.both_ways
    assert found.one_sided == pytest.approx(0.0, abs=1e-9)


def test_a_groined_vault_and_a_hipped_roof_slope_both_ways():
    assert roof_slope(turned(polyhedron(*groined_vault(), density=1800.0, name="vault"), 20.0)).both_ways
    x, y = np.meshgrid(np.linspace(-2, 2, 9), np.linspace(-2, 2, 9), indexing="ij")
    hipped = thicken(x, y, 2 - np.maximum(np.abs(x), np.abs(y)), thickness=0.2)
    assert roof_slope(polyhedron(*hipped, density=1800.0, name="roof")).both_ways


def test_a_single_slope_and_a_flat_roof():
    shed = profile([[0, 0], [4, 1], [4, 1.2], [0, 0.2]], length=3.0, density=500.0, name="roof")
    assert roof_slope(shed).one_sided == pytest.approx(1.0, rel=1e-12)
    flat = box(thickness=4.0, length=3.0, height=0.2, base=(0, 0, 0), density=500.0, name="roof")
    assert roof_slope(flat).axis is None


def test_span_and_rise_along_an_axis():
    axis = np.array([np.cos(0.5), np.sin(0.5), 0.0])
    solid = turned(GABLE, np.degrees(0.5))
    low, high = extent_along(solid, axis=axis)
    assert high - low == pytest.approx(6.0, rel=1e-9)
    assert overall_height(solid) == pytest.approx(2.7, rel=1e-9)


@pytest.mark.parametrize("degrees", [0.0, 35.0])
def test_lever_of_slabs_of_even_thickness_is_a_quarter_of_the_span(degrees):
    axis = np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees)), 0.0])
    assert mean_lever_arm(turned(GABLE, degrees), axis=axis) == pytest.approx(6.0 / 4, rel=1e-9)


@pytest.mark.parametrize("half_angle", [0.3, 0.9, np.pi / 2])
def test_lever_of_a_circular_ring(half_angle):
    """The centroid of half an annular sector of radii a, b lies 2/3 (b^3 - a^3)/(b^2 - a^2) (1 - cos t)/t off."""
    a, b = 2.925, 3.075
    off = 2 / 3 * (b**3 - a**3) / (b**2 - a**2) * (1 - np.cos(half_angle)) / half_angle
    found = mean_lever_arm(ring(half_angle=half_angle), axis=np.array([1.0, 0.0, 0.0]))
    assert found == pytest.approx(b * np.sin(half_angle) - off, rel=2e-4)  # 240 chords stand for the circle


def test_lever_tends_to_a_quarter_of_the_span_as_a_vault_flattens():
    flat = ring(radius=60.0, half_angle=0.05)
    low, high = extent_along(flat, axis=np.array([1.0, 0.0, 0.0]))
    assert mean_lever_arm(flat, axis=np.array([1.0, 0.0, 0.0])) == pytest.approx((high - low) / 4, rel=1e-2)


def test_intrados_of_a_semicircle_and_its_plan():
    area, plan = intrados_area(ring())
    assert area == pytest.approx(np.pi * 2.925 * 5.0, rel=1e-3)
    assert plan == pytest.approx(2 * 2.925 * 5.0, rel=1e-3)


def test_intrados_of_a_groined_vault():
    """Its plan is the bay; its surface that of the two crossing parabolas, one of which rules each quarter."""
    area, plan = intrados_area(polyhedron(*groined_vault(cells=96), density=1800.0, name="vault"))
    assert plan == pytest.approx(36.0, rel=1e-9)
    s = np.linspace(0.0, 3.0, 20001)
    ring_of = 8 * (s[1] - s[0]) * np.sum((3.0 - s) * np.sqrt(1 + (2 * 2.0 * s / 9.0) ** 2))  # strips of length 3 - s
    assert area == pytest.approx(ring_of, rel=2e-3)
