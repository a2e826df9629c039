"""The compiled contact: moments of a disc against scipy's incomplete beta function, entry points as Python."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
import shapely
from numpy.polynomial import Polynomial
from scipy.integrate import quad
from scipy.special import beta, betainc

from assess.interfaces.kernel import discs, equilibrium, moments
from assess.interfaces.kernel.discs import disc_upto
from assess.interfaces.kernel.equilibrium import CLOSURE, RESULTANT, crushing_depth, touch
from assess.interfaces.section import annulus, circle, polygon, rectangle

U = shapely.Polygon([(0, 0), (3, 0), (3, 2), (2.2, 2.1), (2, 0.7), (1, 0.6), (0.8, 2.3), (0, 2)])
SECTIONS = {
    "U": polygon(U, direction=(1.0, 0.3)),
    "rectangle": rectangle(1.2, 3.0),
    "circle": circle(1.5),
    "ring": annulus(1.5, inner=1.1),
}
every_section = pytest.mark.parametrize("section", SECTIONS.values(), ids=SECTIONS.keys())
K, F = 3e8, 2.5e6


def moment(x: float, order: int) -> float:
    """Integral of depth^order times the width of a disc of radius 1 up to the depth x."""
    p, q = order + 1.5, 1.5
    return 4 * 2.0 ** (order + 1) * beta(p, q) * betainc(p, q, x / 2)


@pytest.mark.parametrize("x", [1e-12, 1e-6, 1e-3, 0.1, 0.3, 0.499999, 0.500001, 0.7, 1.0, 1.5, 1.99, 2.0])
def test_moments_of_a_disc(x):
    area, first, area_sum, first_sum = disc_upto.py_func(x)
    A, S, second = (moment(x, n) for n in range(3))
    assert (area, first) == pytest.approx((A, S), rel=2e-14, abs=0.0)
    assert (area_sum, first_sum) == pytest.approx((x * A - S, x * S - second), rel=1e-13, abs=0.0)


def test_moments_of_a_disc_from_series_and_closed_form_meet():
    """At the depth where the one takes over from the other, to rounding."""
    below, above = disc_upto.py_func(0.5), disc_upto.py_func(np.nextafter(0.5, 1.0))
    np.testing.assert_allclose(below, above, rtol=1e-14)


@every_section
def test_entry_points_as_python_give_the_same(section):
    phi = np.geomspace(1e-6, 0.3, 12)
    force = F * section.area * np.linspace(0.05, 0.95, 12)
    for k in (K, np.inf):
        compiled, plain = np.empty((12, 9)), np.empty((12, 9))
        touch(section.table, k, F, force, phi, compiled)
        touch.py_func(section.table, k, F, force, phi, plain)
        np.testing.assert_allclose(plain, compiled, rtol=1e-13, atol=1e-15)
    share = 0.2 * section.area
    assert crushing_depth.py_func(section.table, share) == pytest.approx(
        crushing_depth(section.table, share), rel=1e-14
    )


def test_compiled_functions_have_names_of_their_own():
    """numba names machine code after the function and its types: of two closures of one factory in the caches of two
    entry points, the one loaded second was taken for the first, once both had been compiled in different processes.
    """
    parts = [vars(part) for part in (discs, moments, equilibrium)]
    names = [each.py_func.__qualname__ for part in parts for each in part.values() if hasattr(each, "py_func")]
    assert len(names) > 10
    assert not [name for name in names if "<locals>" in name]


@every_section
def test_crushing_depth_carries_the_force(section):
    """Force over strength is the mean over its depth of the area under a triangle of stress."""
    for share in section.area * np.array([1e-6, 0.01, 0.2, 0.45]):
        z = crushing_depth(section.table, share)
        assert triangle_of_stress(section, z) == pytest.approx(share, rel=1e-11, abs=0.0)


def triangle_of_stress(section, z):
    """Integral of the width times 1 - x / z up to z."""
    total = 0.0
    for radius, edge, sign in section.discs:
        end = 2 * np.arcsin(np.sqrt(np.clip((z - edge) / radius / 2, 0.0, 1.0)))

        def carried(t, r=radius, e=edge):
            return (1 - (e + 2 * r * np.sin(t / 2) ** 2) / z) * 2 * (r * np.sin(t)) ** 2

        total += sign * quad(carried, 0.0, end, epsabs=0.0, epsrel=1e-13)[0]
    for row, end in zip(section.pieces[:-1], section.pieces[1:, 0], strict=True):
        width = Polynomial(row[1:3])(Polynomial([-row[0], 1.0]))
        inside = (width * Polynomial([1.0, -1.0 / z])).integ()
        total += inside(min(max(z, row[0]), end)) - inside(row[0])
    return total


@every_section
def test_order_of_the_rotations_does_not_matter(section):
    """What is known of the rotation before is only where to look."""
    phi = np.geomspace(1e-7, 1.0, 300)
    force = np.full(300, 0.4 * F * section.area)
    order = np.random.default_rng(3).permutation(300)
    straight, shuffled = np.empty((300, 9)), np.empty((300, 9))
    touch(section.table, K, F, force, phi, straight)
    touch(section.table, K, F, force[order], phi[order], shuffled)
    np.testing.assert_allclose(shuffled[:, [RESULTANT, CLOSURE]], straight[order][:, [RESULTANT, CLOSURE]], rtol=1e-13)


TEETH = [(1.0 - 2e-7 * n, 1.0 + 0.1 * (n % 2)) for n in range(20)]  # closer together than single precision rounds
ROUGH = polygon(shapely.Polygon([(0, 0), (2, 0), (2, 1), *TEETH, (0, 1)]), direction=(1.0, 0.0))
ANGLES = np.linspace(0, 2 * np.pi, 2000, endpoint=False)  # of corners: the pieces near the ends are short
MANY_SIDED = polygon(shapely.Polygon(np.column_stack([np.cos(ANGLES), np.sin(ANGLES)])), direction=(1.0, 0.3))


@pytest.mark.parametrize("thickness", [1e-2, 1e-5, 1e-6, 1e-8])
@pytest.mark.parametrize(("section", "share"), [(MANY_SIDED, 0.01), (MANY_SIDED, 0.9), (ROUGH, 1.000002 / ROUGH.area)])
def test_thin_elastic_zone_loses_no_digits(section, share, thickness):
    """Against rational arithmetic; thickness: of the zone over the depth, share: force over what can be carried."""
    N = F * section.area * share
    phi = F / K / (thickness * section.depth)
    found = np.empty((1, 9))
    touch(section.table, K, F, np.array([N]), np.array([phi]), found)
    a = Fraction(found[0, CLOSURE]) / Fraction(phi)
    a_2 = (Fraction(found[0, CLOSURE]) - Fraction(F) / Fraction(K)) / Fraction(phi)
    assert 0 < a_2 < a < Fraction(section.depth)
    stress = Fraction(K) * Fraction(phi)
    carried, moment = (stress * (p - q) for p, q in zip(exactly(section, a), exactly(section, a_2), strict=True))
    assert float(carried / Fraction(N)) == pytest.approx(1.0, rel=1e-14)
    assert float(moment / carried) == pytest.approx(found[0, RESULTANT], rel=1e-14, abs=0.0)


def exactly(section, z):
    """Integrals of (z - x) and (z - x) x over the section up to z, of the widths of its pieces, without rounding."""
    total = [Fraction(0), Fraction(0)]
    for row, end in zip(section.pieces[:-1], section.pieces[1:, 0], strict=True):
        x0, w0, w1 = (Fraction(each) for each in row[:3])
        d = min(z, Fraction(end)) - x0
        if d <= 0:
            break
        one, two, three, four = (d**n / n for n in (1, 2, 3, 4))
        first = x0 * w0 * one + (w0 + x0 * w1) * two + w1 * three
        second = x0**2 * w0 * one + (2 * x0 * w0 + x0**2 * w1) * two + (w0 + 2 * x0 * w1) * three + w1 * four
        total[0] += z * (w0 * one + w1 * two) - first
        total[1] += z * first - second
    return total
