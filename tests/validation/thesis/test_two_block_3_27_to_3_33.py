"""Thesis eqs. 3.27-3.33: the wall held at base and top.

3.27 is the least uplift multiplier over the height of the crack for a load at mid-thickness and a tensile block with
lever arm b/2 at the crack alone. For another place xi of the load and another arm kappa b,
h_c / h = sqrt(A) / (sqrt(A) + sqrt(C)) with A = 1 + n + kappa t, C = (1 - xi) n + kappa t.
3.28-3.33 hold for any N and any xi, not only for the N = 0 or xi = 0 that the sources derive them for.
"""

from __future__ import annotations

from math import atan2, cos, hypot, sin, sqrt

import numpy as np
import pytest
from scipy.constants import g
from scipy.optimize import minimize_scalar

from assess.errors import MechanismError
from assess.loads.load import Force
from assess.mechanisms.branch_table import rigid_branch
from assess.mechanisms.chain import Chain, RigidBlock
from assess.model.walls import crack_ratio
from assess.oscillator import multiplier
from tests.support.projects import block, lines, mechanism_of, tables_toml, wall

TABLE = 1e-8  # K is the slope of the branch's table
B, L, H, RHO = 0.4, 3.0, 4.0, 1800.0
W = RHO * B * L * H * g
PLAIN = f"box = {{ thickness = {B}, length = {L}, height = {H}, base = [1.0, 0.0, 2.0] }}"
TAPERED = "profile = [[0.0, 0.0], [0.7, 0.0], [0.35, 6.0], [0.1, 6.0]]\nlength = 2.0"


def wall_of(folder, *, body=PLAIN, tensile="0 Pa", mechanism=""):
    """The one mechanism of a project with a wall that cracks."""
    material = {"density": RHO, "tensile_strength": tensile}
    own = lines(block("w", kind="two-block", direction=[1, 0, 0]), mechanism)
    bodies = {"w": f'material = "m"\n{body}'}
    return mechanism_of(folder, tables_toml(materials={"m": material}, bodies=bodies, mechanisms={"w": own}))


def pressed(force, *, place, thickness=B):
    """The entry of an overburden at xi = `place`."""
    return f'loads = [{{ kind = "overburden", force = {force!r}, eccentricity = {thickness * (0.5 - place)!r} }}]'


def multiplier_by_statics(ratio, *, n, t, place, arm):
    """lambda h / b of a plain wall cracked at `ratio` of its height, by moments alone.

    The upper block about the crack's hinge: H h_2 = lambda W_2 h_2 / 2 + W_2 b / 2 + N (1 - xi) b + T kappa b.
    The whole wall about the base hinge: lambda W h / 2 = H h + W b / 2 + N xi b. H: of the top support.
    """
    above = 1.0 - ratio
    upper = above / 2 + n * (1 - place) + t * arm  # over W b
    whole = (1 / 2 + n * place) * above  # over W b h_2 / h
    return 2 * (upper + whole) / (above * ratio)


@pytest.mark.parametrize("tension", [0.0, 0.05, 0.4, 3.0])
@pytest.mark.parametrize("load_ratio", [0.0, 0.02, 0.3, 1.0, 8.0])
def test_crack_3_27_as_printed(load_ratio, tension):
    n, t = load_ratio, tension
    if n == t == 0.0:
        with pytest.raises(MechanismError, match="at the very top"):
            crack_ratio(load=n, tension=t, place=0.5)
        return
    printed = 1 + (n + t - sqrt((2 + t + 2 * n) * (n + t))) / (2 + n)
    assert crack_ratio(load=n, tension=t, place=0.5) == pytest.approx(printed, rel=1e-13)


@pytest.mark.parametrize("arm", [1 / 6, 0.5])
@pytest.mark.parametrize("place", [-0.2, 0.0, 0.5, 0.8, 1.0, 1.1])
@pytest.mark.parametrize(("n", "t"), [(0.02, 0.1), (0.3, 0.4), (2.0, 3.0)])
def test_crack_is_the_least_multiplier_over_its_height(n, t, place, arm):
    found = crack_ratio(load=n, tension=t, place=place, arm=arm)
    stations = np.linspace(0.01, 0.9999, 2001)
    values = multiplier_by_statics(stations, n=n, t=t, place=place, arm=arm)
    near = stations[[max(values.argmin() - 1, 0), min(values.argmin() + 1, 2000)]]
    least = minimize_scalar(lambda x: multiplier_by_statics(x, n=n, t=t, place=place, arm=arm), bounds=near,
                            method="bounded", options={"xatol": 1e-12})  # fmt: skip
    assert found == pytest.approx(least.x, abs=3e-8)  # a minimum shows only half the digits of its place
    at_least = multiplier_by_statics(found, n=n, t=t, place=place, arm=arm)
    assert at_least == pytest.approx(least.fun, rel=1e-13)
    a, c = 1 + n + arm * t, (1 - place) * n + arm * t
    assert at_least == pytest.approx(2 * (sqrt(a) + sqrt(c)) ** 2, rel=1e-13)


@pytest.mark.parametrize("ratio", [0.2, 0.55, 0.9])
@pytest.mark.parametrize("place", [0.0, 0.5, 0.8])
def test_multiplier_of_the_chain_by_statics(ratio, place):
    chain, *_ = chain_of(ratio * H, n=0.35, place=place)
    side = rigid_branch(chain, restitution=0.9, name="w")
    assert multiplier(side)[0] == pytest.approx(
        B / H * multiplier_by_statics(ratio, n=0.35, t=0.0, place=place, arm=0.5), rel=1e-12
    )


@pytest.mark.parametrize(
    ("tensile", "force", "place", "sides"),
    [
        (0.0, 20000.0, 0.5, "two"),
        (0.0, 20000.0, 0.8, "one"),
        (0.0, 20000.0, 0.8, "two"),
        (0.0, 20000.0, 0.2, "two"),  # then the load is at 0.8 from the support of the negative branch
        (30000.0, 20000.0, 0.5, "two"),
        (30000.0, 5000.0, 0.1, "one"),
        (30000.0, None, 0.5, "two"),
    ],
)
def test_cracks_of_a_project_are_3_27_or_its_general_form_and_the_search_finds_them(
    tmp_path, tensile, force, place, sides
):
    n, t = (force or 0.0) / W, tensile * B * L / W
    worse = max(place, 1 - place) if sides == "two" else place
    a, c = 1 + n + t / 2, (1 - worse) * n + t / 2
    crack = 2.0 + H * sqrt(a) / (sqrt(a) + sqrt(c))
    if place == 0.5:
        assert crack == pytest.approx(2 + H + H * (n + t - sqrt((2 + t + 2 * n) * (n + t))) / (2 + n), rel=1e-13)
    more = f'sides = "{sides}"\n' + (pressed(force, place=place) if force else "")
    by_formula = wall_of(tmp_path, tensile=f"{tensile} Pa", mechanism=more)
    searched = wall_of(tmp_path, tensile=f"{tensile} Pa", mechanism=more + '\ncrack = "minimum"')
    assert by_formula.positive.hinges[1] == pytest.approx((0.8, crack), rel=1e-12)
    assert searched.positive.hinges[1][1] == pytest.approx(crack, abs=2e-5)  # xatol of the search
    least = B / H * multiplier_by_statics((crack - 2.0) / H, n=n, t=t, place=worse, arm=0.5)
    assert f"least, {least:.4g}" + (" with the mortar" if tensile else "") in str(searched.warnings[0])


def polygon(points):
    """Area and centroid of a polygon, counter-clockwise, by the shoelace formulas."""
    x, z = np.array([*points, points[0]]).T
    cross = x[:-1] * z[1:] - x[1:] * z[:-1]
    area = cross.sum() / 2
    return area, ((x[:-1] + x[1:]) @ cross / (6 * area), (z[:-1] + z[1:]) @ cross / (6 * area))


def uplift_of_tapered(crack, *, N, tension):
    """Least lambda over both directions of the tapered wall cracked at `crack`, by moments; tension: force [N]."""
    left, right = crack * 0.1 / 6, 0.7 - crack * 0.35 / 6
    low, high = polygon([(0, 0), (0.7, 0), (right, crack), (left, crack)]), polygon(
        [(left, crack), (right, crack), (0.35, 6), (0.1, 6)]
    )  # fmt: skip
    W1, W2 = (area * 2.0 * RHO * g for area, _ in (low, high))
    (x1, z1), (x2, z2) = low[1], high[1]
    found = []
    x_load = 0.225  # the middle of the top
    for a, b, sign in ((0.7, left, 1.0), (0.0, right, -1.0)):
        # top reaction H as h0 + h1 lambda: upper block about b; then the whole wall about a
        held = sign * (W2 * (x2 - b) + N * (x_load - b)) + tension * 0.35
        h0, h1 = held / (6 - crack), W2 * (z2 - crack) / (6 - crack)
        resist = sign * (W1 * (a - x1) + W2 * (a - x2) + N * (a - x_load)) + 6 * h0
        found.append(resist / (W1 * z1 + W2 * z2 - 6 * h1))
    return min(found)


def test_crack_search_on_a_tapered_wall_by_brute_force(tmp_path):
    """No closed form: the search over cut solids against moments of polygons; the arm is half the box's thickness."""
    N, strength = 9000.0, 20000.0
    more = f'crack = "minimum"\nloads = [{{ kind = "overburden", force = {N} }}]'
    mechanism = wall_of(tmp_path, body=TAPERED, tensile=f"{strength} Pa", mechanism=more)
    tension = strength * 0.7 * 2.0
    least = minimize_scalar(lambda z: uplift_of_tapered(z, N=N, tension=tension), bounds=(0.5, 5.5), method="bounded",
                            options={"xatol": 1e-10})  # fmt: skip
    assert mechanism.positive.hinges[1][1] == pytest.approx(least.x, abs=3e-5)
    assert f"is least, {least.fun:.4g} with" in str(mechanism.warnings[0])
    bare = wall_of(tmp_path, body=TAPERED, tensile="0 Pa", mechanism=more).warnings[0].text
    assert "the uplift multiplier is least" in bare
    assert "tension" not in bare
    grid = [uplift_of_tapered(z, N=N, tension=tension) for z in np.linspace(0.2, 5.8, 561)]
    assert min(grid) >= least.fun * (1 - 1e-12)


def chain_of(crack, *, n, place):
    """The positive chain of the plain wall cracked at `crack` above its base, and the numbers of the thesis."""
    h1, h2 = crack, H - crack
    m1, m2 = (RHO * B * L * h for h in (h1, h2))
    N = n * W
    blocks = (
        RigidBlock(m1, (B / 2, h1 / 2), m1 * (B**2 + h1**2) / 12),
        RigidBlock(m2, (B / 2, h1 + h2 / 2), m2 * (B**2 + h2**2) / 12),
    )
    loads = (Force("N", (0.0, -N), (B * (1 - place), H), block=1),) if N else ()
    return Chain(blocks, ((B, 0.0), (0.0, h1), (B, H)), loads), (h1, m1), (h2, m2), N


@pytest.mark.parametrize("n", [0.0, 0.4, 2.0])
@pytest.mark.parametrize("place", [0.0, 0.3, 0.5, 0.8, 1.0])
@pytest.mark.parametrize("crack", [1.0, 2.0, 3.1])
def test_constants_3_28_to_3_33(crack, place, n):
    chain, (h1, m1), (h2, m2), N = chain_of(crack, n=n, place=place)
    (R1, a1), (R2, a2) = ((hypot(B, h) / 2, atan2(B, h)) for h in (h1, h2))
    q, xi = sin(a2) / sin(a1), place
    I1, I2 = (m * hypot(B, h) ** 2 / 3 for m, h in ((m1, h1), (m2, h2)))
    K = R2 * q * (g * (m1 + m2 * (2 + q)) + 2 * N * q * (cos(a2) ** 2 + (1 - xi) * sin(a2) ** 2 + 1 / q))
    M = xi * N * sin(2 * a2) * R2 * q
    side = rigid_branch(chain, restitution=0.9, name="w")
    form = side.linearised
    assert R1 * sin(a1) == pytest.approx(R2 * sin(a2), rel=1e-14)  # one thickness: what the formulas rest on
    assert form.inertia == pytest.approx(I1 + I2 * q**2, rel=1e-9)  # 3.28
    assert form.stiffness == pytest.approx(K, rel=TABLE)  # 3.29
    assert form.excitation == pytest.approx((m1 + m2) * R2 * q, rel=1e-9)  # 3.30
    assert form.moment == pytest.approx(M, rel=TABLE, abs=1e-9 * K)  # 3.31
    assert form.critical == pytest.approx(a1, rel=1e-12)  # 3.32
    if N:  # printed with g m2 / 2N; where N = 0 it is alpha_1
        inner = 2 * N + g * (m1 + 2 * m2) + 2 * N * q * (cos(a2) ** 2 + (1 - xi) * sin(a2) ** 2 + g * m2 / (2 * N))
        assert form.overturning == pytest.approx(a1 - xi * N * sin(2 * a2) / inner, rel=TABLE)  # 3.33
        assert 0 <= side.overturning / form.overturning - 1 < 0.07  # one step of Newton: 6 % short for 2 W at xi = 1
    else:
        assert side.overturning == pytest.approx(a1, rel=1e-12)


def test_a_wall_of_a_project_has_the_constants_on_both_sides(tmp_path):
    """Load at 0.3 from the support ahead, so at 0.7 from the one behind."""
    N = 0.4 * W
    mechanism = wall_of(tmp_path, mechanism=f"crack = 4.2\n{pressed(N, place=0.3)}")
    rocker = mechanism.oscillator
    for side, place in ((rocker.positive, 0.3), (rocker.negative, 0.7)):
        chain, *_ = chain_of(2.2, n=0.4, place=place)
        alike = rigid_branch(chain, restitution=0.9, name="w")
        assert side.overturning == pytest.approx(alike.overturning, rel=1e-9)
        for name in ("inertia", "restoring", "excitation", "participation"):
            expected = getattr(alike, name)
            np.testing.assert_allclose(getattr(side, name), expected, rtol=1e-8, atol=1e-9 * np.abs(expected).max())


def test_two_bodies_are_the_same_as_one_that_cracks(tmp_path):
    one = wall_of(tmp_path, mechanism=f"crack = 4.2\n{pressed(9000.0, place=0.3)}").oscillator
    bodies = {
        "low": wall(B, L, 2.2, base=[1.0, 0.0, 2.0], material="m"),
        "high": wall(B, L, 1.8, base=[1.0, 0.0, 4.2], material="m"),
    }
    own = lines(block("low", "high", kind="two-block", direction=[1, 0, 0]), pressed(9000.0, place=0.3))
    text = tables_toml(materials={"m": {"density": RHO}}, bodies=bodies, mechanisms={"w": own})
    two = mechanism_of(tmp_path, text).oscillator
    for side in ("positive", "negative"):
        a, b = getattr(one, side), getattr(two, side)
        assert a.restitution == pytest.approx(b.restitution, rel=1e-12)
        for name in ("rotation", "inertia", "restoring", "excitation", "participation", "lift"):
            scale = np.abs(getattr(a, name)).max()
            np.testing.assert_allclose(getattr(a, name), getattr(b, name), rtol=1e-11, atol=1e-11 * scale)
