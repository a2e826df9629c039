"""Thesis eqs. 3.44-3.46 and what stands behind them, against an impact solved with its impulses.

3.46 is the ratio of the angular momenta of the whole wall about the new base hinge. That leaves out the impulse of
the support at the top; where supports and hinges may give impulses, much less is left.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from math import atan2, cos, hypot, sin, tan

import numpy as np
import pytest

from assess.mechanisms.chain import mirror_point
from assess.mechanisms.four_hinge import four_hinge
from assess.mechanisms.single_block import single_block
from assess.mechanisms.two_block import two_block
from tests.support.bodies import planar_box

BOTH = ("momentum", "momentum")
body = partial(planar_box, length=2.0)


def after_impact(bodies, old, new, *, top="pinned"):
    """|phi'| of the lead block after over before, by impulses at the new hinges and supports.

    Blocks have centroid velocities and rates (x', z', clockwise), 3 each. Before: one unit of clockwise rotation about
    the first old hinge, compatible with the old hinges. After: M (v - v_0) = G^T p and G v = 0 with the new ones.
    """
    G, count = constraints(bodies, new, top=top), len(bodies)
    before = velocities(constraints(bodies, old, top=top), count)
    M = np.diag([value for each in bodies for value in (each.mass, each.mass, each.inertia)])
    whole = np.block([[M, -G.T], [G, np.zeros((len(G), len(G)))]])
    after = np.linalg.solve(whole, np.concatenate([M @ before, np.zeros(len(G))]))
    return float(after[2] / before[2])


def velocities(G, count):
    """The velocities that satisfy G v = 0 with the first block at one unit of rotation."""
    lead = np.zeros(3 * count)
    lead[2] = 1.0
    return np.linalg.solve(np.vstack([G, lead]), np.append(np.zeros(len(G)), 1.0))


def constraints(bodies, hinges, *, top):
    """Rows of zero velocity: the first hinge of block 1, both sides of each hinge between, the last one's support."""
    rows = []

    def velocity(number, at):
        x, z = at[0] - bodies[number].centroid[0], at[1] - bodies[number].centroid[1]
        both = np.zeros((2, 3 * len(bodies)))
        both[:, 3 * number : 3 * number + 3] = [[1, 0, z], [0, 1, -x]]
        return both

    rows.append(velocity(0, hinges[0]))
    for number in range(len(bodies) - 1):
        rows.append(velocity(number, hinges[number + 1]) - velocity(number + 1, hinges[number + 1]))
    if len(bodies) > 1:
        last = velocity(len(bodies) - 1, hinges[-1])
        rows.append(last if top == "pinned" else last[:1])
    return np.vstack(rows)


@pytest.mark.parametrize(("thickness", "height"), [(0.4, 4.0), (1.0, 2.5), (1.9, 2.0)])
def test_housner_3_44(thickness, height):
    wall = body(thickness, height)
    alpha, R = atan2(thickness, height), hypot(thickness, height) / 2
    I_O = wall.inertia + wall.mass * R**2
    expected = 1 - 2 * wall.mass * R**2 / I_O * sin(alpha) ** 2
    assert single_block("w", wall).restitution == pytest.approx((expected, expected), rel=1e-12)
    hinges = [(thickness / 2, 0.0)], [(-thickness / 2, 0.0)]
    assert after_impact([wall], *hinges) == pytest.approx(expected, rel=1e-12)


def test_sorrentino_3_45_is_two_impacts_at_the_base_and_one_at_the_wall_behind():
    """The factors are 1 - 2k sin^2: toe to toe, and 1 - 2k cos^2: base toe to top corner of one face."""
    T, H = 0.8, 5.0
    wall = body(T, H)
    base, corner, other = [(T / 2, 0.0)], [(-T / 2, H)], [(-T / 2, 0.0)]
    toes, face = after_impact([wall], base, other), after_impact([wall], other, corner)
    signed = toes**2 * face
    assert signed < 0
    one_sided = single_block("w", wall, sides="one").restitution[0]
    assert one_sided == pytest.approx(-signed, rel=1e-12)
    k, alpha = 0.75, atan2(T, H)
    printed = (1 - 2 * k * sin(alpha) ** 2) ** 2 * (1 - 2 * k * cos(alpha) ** 2)
    assert one_sided == pytest.approx(-printed, rel=1e-12)


def printed_3_46(thickness, crack, height):
    """As printed, for a plain wall per metre and unit density."""
    (m1, R1, a1), (m2, R2, a2) = (
        (thickness * h, hypot(thickness, h) / 2, atan2(thickness, h)) for h in (crack, height - crack)
    )
    I1, I2 = (4 / 3 * m * R**2 for m, R in ((m1, R1), (m2, R2)))
    s, c = sin(a1), cos(a1)
    shared = I1 - I2 * tan(a2) / tan(a1)
    inner = s * c * (1 / (sin(a2) * cos(a2)) + 1 / tan(a2) - tan(a2))
    outer = s * c * (1 / (sin(a2) * cos(a2)) + 1 / tan(a2) + tan(a2))
    over = shared - 2 * m1 * R1**2 * s**2 + m2 * R1**2 * (2 - 4 * s**2 + inner)
    return over / (shared + m2 * R1**2 * (2 + outer))


@pytest.mark.parametrize(("crack", "kept"), [(2.2, 0.77276), (2.4, 0.79630)])
def test_two_blocks_3_46_and_what_impulses_at_the_top_leave(crack, kept):
    """Wall 0.4 x 4 m: the thesis' formula, and the projection onto the new mechanism."""
    bodies = (body(0.4, crack), body(0.4, 4.0 - crack, base=crack))
    printed = printed_3_46(0.4, crack, 4.0)
    assert two_block("w", *bodies).restitution == pytest.approx((printed, printed), rel=1e-12)
    assert two_block("w", *bodies, restitution=BOTH).restitution == pytest.approx((kept, kept), abs=5e-6)
    old, new = ((0.2, 0.0), (-0.2, crack), (0.2, 4.0)), ((-0.2, 0.0), (0.2, crack), (-0.2, 4.0))
    solved = after_impact(bodies, old, new, top="slider")
    assert two_block("w", *bodies, restitution=BOTH).restitution[0] == pytest.approx(solved, rel=1e-12)
    assert f"{kept:.3f}" in two_block("w", *bodies).restitution_source


def test_two_blocks_3_46_by_the_angular_momenta_about_the_new_base_hinge():
    """The sum over the blocks of J theta' + r x m v about (-0.2, 0), from velocities solved above."""
    bodies = (body(0.4, 2.6), body(0.4, 4.0 - 2.6, base=2.6))
    old, new = ((0.2, 0.0), (-0.2, 2.6), (0.2, 4.0)), ((-0.2, 0.0), (0.2, 2.6), (-0.2, 4.0))

    def momentum(hinges):
        v = velocities(constraints(bodies, hinges, top="slider"), 2).reshape(2, 3)
        arms = [(each.centroid[0] + 0.2, each.centroid[1]) for each in bodies]
        return sum(
            each.inertia * w + each.mass * (z * vx - x * vz)
            for each, (vx, vz, w), (x, z) in zip(bodies, v, arms, strict=True)
        )

    assert two_block("w", *bodies).restitution[0] == pytest.approx(momentum(old) / momentum(new), rel=1e-12)
    assert printed_3_46(0.4, 2.6, 4.0) == pytest.approx(momentum(old) / momentum(new), rel=1e-12)


PORTAL = (body(0.9, 4.0), body(5.0, 0.6, x=2.3, base=4.0, density=2200.0), body(0.7, 4.0, x=4.4))
FRONT = ((0.45, 0.0), (-0.45, 4.0), (4.05, 4.0), (4.75, 0.0))
BACK = ((-0.45, 0.0), (0.45, 4.0), (4.75, 4.0), (4.05, 0.0))


def test_four_hinges_by_impulses():
    """The rule of the thesis for one block (3.44) applied to a portal of two unlike columns."""
    found = four_hinge("p", PORTAL, hinges=FRONT, hinges_negative=BACK).restitution
    assert found[0] == pytest.approx(after_impact(PORTAL, FRONT, BACK), rel=1e-12)
    assert found[1] == pytest.approx(after_impact(PORTAL, BACK, FRONT), rel=1e-12)
    assert found[0] != pytest.approx(found[1], rel=1e-3)


def test_restitution_mirrors_with_the_mechanism():
    flipped = tuple(replace(each, centroid=mirror_point(each.centroid), outline=(), base=None) for each in PORTAL)
    ahead, behind = (tuple(mirror_point(hinge) for hinge in hinges) for hinges in (BACK, FRONT))
    one = four_hinge("p", PORTAL, hinges=FRONT, hinges_negative=BACK).restitution
    two = four_hinge("p", flipped, hinges=ahead, hinges_negative=behind).restitution
    assert one == pytest.approx(two[::-1], rel=1e-13)
