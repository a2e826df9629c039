"""Rayleigh's method against closed forms of cantilevers, and published towers."""

import numpy as np
import pytest
from scipy.integrate import quad

from assess.amplification import Slices, rayleigh_mode, self_weight_deflection, slice_cantilever
from assess.errors import GeometryError
from assess.examples.surfaces import prismatic_tower, tapered_tower
from assess.geometry.solid import box, polyhedron


def uniform(n: int = 100, *, EI: float = 1.0, GA: float = np.inf) -> Slices:
    """A cantilever of unit length and mass."""
    return Slices(*(np.full(n, value) for value in (1 / n, 1 / n, EI, GA)))


def test_bending_is_rayleigh_s_closed_form() -> None:
    """omega^2 = 162/13 EI / (m L^4) for the deflection under the own weight; h_e = 13/18 L. Exact: 1.8751^4."""
    found = rayleigh_mode(uniform())
    assert (2 * np.pi * found.frequency) ** 2 == pytest.approx(162 / 13, rel=1e-4)
    assert found.effective_height == pytest.approx(13 / 18, rel=1e-4)
    assert 1.0 < 2 * np.pi * found.frequency / 1.875104**2 < 1.005


def test_shear_is_rayleigh_s_closed_form() -> None:
    """u = x - x^2/2: omega^2 = 5/2 GA / (m L^2), h_e = 5/8 L. Exact: pi/2."""
    found = rayleigh_mode(uniform(EI=1e12, GA=1.0))
    assert (2 * np.pi * found.frequency) ** 2 == pytest.approx(2.5, rel=1e-4)
    assert found.effective_height == pytest.approx(5 / 8, rel=1e-4)
    assert 1.0 < 2 * np.pi * found.frequency / (np.pi / 2) < 1.01


@pytest.mark.parametrize("GA", [3.0, 30.0])
def test_bending_and_shear_together(GA: float) -> None:
    """Timoshenko's cantilever under an even load, its integrals by quadrature."""

    def u(x: float) -> float:
        return (x**4 - 4 * x**3 + 6 * x**2) / 24 + (x - x**2 / 2) / GA

    one, two, lever = (quad(f, 0, 1)[0] for f in (u, lambda x: u(x) ** 2, lambda x: x * u(x)))
    found = rayleigh_mode(uniform(GA=GA))
    assert (2 * np.pi * found.frequency) ** 2 == pytest.approx(one / two, rel=2e-4)
    assert found.effective_height == pytest.approx(lever / one, rel=2e-4)


def test_a_heavy_top_is_a_mass_on_a_spring() -> None:
    """omega^2 = 3 EI / (M L^3)."""
    found = rayleigh_mode(uniform(), top_mass=1e5)
    assert (2 * np.pi * found.frequency) ** 2 == pytest.approx(3e-5, rel=1e-4)
    assert found.effective_height == pytest.approx(1.0, rel=1e-4)


def test_slices_converge_at_the_second_order() -> None:
    errors = [abs(rayleigh_mode(uniform(n)).frequency * 2 * np.pi - np.sqrt(162 / 13)) for n in (10, 20, 40)]
    np.testing.assert_allclose(np.divide(errors[:-1], errors[1:]), 4.0, rtol=0.1)
    assert self_weight_deflection(uniform(7))[-1] == pytest.approx(
        9.80665 / 8, rel=1e-12
    )  # w L^4 / (8 EI), whatever the slices


def test_slices_of_a_wall_bend_in_the_direction_of_motion() -> None:
    wall = box(thickness=0.6, length=3.0, height=8.0, base=[5.0, 1.0, 2.0], density=1800.0, name="wall")
    for direction, depth, width in (([1, 0, 0], 0.6, 3.0), ([0, 1, 0], 3.0, 0.6)):
        slices = slice_cantilever([wall], [2e9], direction=direction)
        np.testing.assert_allclose(slices.bending, 2e9 * width * depth**3 / 12, rtol=1e-9)
        np.testing.assert_allclose(slices.mass, wall.mass / 100, rtol=1e-12)
        np.testing.assert_allclose(slices.shear, 0.4 * 2e9 * 5 / 6 * 1.8, rtol=1e-12)


def test_two_halves_are_the_whole() -> None:
    """Half walls side by side across the direction, each of its own modulus, share one deflection."""
    whole = box(thickness=1.0, length=2.0, height=6.0, base=[0, 0, 0], density=1.0, name="whole")
    halves = [
        box(thickness=0.5, length=2.0, height=6.0, base=[x, 0, 0], density=1.0, name="half") for x in (-0.25, 0.25)
    ]
    one, two = (
        slice_cantilever([whole], [3e9], direction=[1, 0, 0]),
        slice_cantilever(halves, [3e9, 3e9], direction=[1, 0, 0]),
    )
    np.testing.assert_allclose(two.bending, one.bending, rtol=1e-12)
    np.testing.assert_allclose(two.mass, one.mass, rtol=1e-12)
    uneven = slice_cantilever(halves, [3e9, 1e9], direction=[1, 0, 0]).bending  # neutral axis at -0.125 m
    parts = [E * (2 * 0.5**3 / 12 + 1.0 * (x + 0.125) ** 2) for E, x in ((3e9, -0.25), (1e9, 0.25))]
    np.testing.assert_allclose(uneven, sum(parts), rtol=1e-12)


def test_the_dharahara_tower_lies_in_the_published_range() -> None:
    """Mehrotra 4.3.3: 0.64-0.83 Hz by Lord Rayleigh's principle, E = 4.75 GPa, "a range of density values".

    Our two readings of its shape enclose the range's middle; 1600 to 2000 kg/m3 are taken for the range.
    """
    found = {
        (make.__name__, density): rayleigh_mode(
            slice_cantilever(
                [polyhedron((s := make()).points, s.triangles, density=density, name="tower")],
                [4.75e9],
                direction=[1, 0, 0],
            )
        ).frequency
        for make in (tapered_tower, prismatic_tower)
        for density in (1600.0, 2000.0)
    }
    assert 0.60 < min(found.values()) < 0.67
    assert 0.73 < max(found.values()) < 0.83


def test_a_slice_without_masonry_is_refused() -> None:
    low = box(thickness=1.0, length=1.0, height=2.0, base=[0, 0, 0], density=1.0, name="low")
    high = box(thickness=1.0, length=1.0, height=2.0, base=[0, 0, 4], density=1.0, name="high")
    with pytest.raises(GeometryError, match=r"no mass at 1\.98 m above the foot; give natural_frequency"):
        rayleigh_mode(slice_cantilever([low, high], [1e9, 1e9], direction=[1, 0, 0]))
