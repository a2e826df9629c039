"""Thesis Tables 4.1, 4.4, 5.1-5.6 and 7.1: the published parameters among themselves, and the examples made for them.

Mehrotra (2019). What the program computes is in solved cases, "table_4_1" to "table_5_5" and "table_7_1". The radius is
not tabled. It follows from the restitution by 3.44 (two-sided) or 3.45 (one-sided), and what then comes out must be a
body: k = I / (M R^2) > 1.
"""

from __future__ import annotations

from itertools import pairwise
from math import atan2, cos, sin
from pathlib import Path

import numpy as np
import pytest
from scipy.constants import g
from scipy.optimize import brentq, least_squares

from assess.examples import EXAMPLES
from assess.examples.surfaces import SPIRE_RADIUS, SPIRE_WALL, spire
from assess.geometry.cut import divide, inclined_plane
from assess.geometry.planar import base_of_section, planar_body
from assess.geometry.solid import polyhedron
from assess.oscillator import equivalent_block
from tests.support.examples import example_study

# p [1/s], lambda [rad], restitution (negative: rebound; None: not given)
TABLE_4_1 = {
    "BH_M1": (5.77, 0.61, 0.54),
    "BH_M2": (4.16, 0.26, 0.89),
    "SH_M1": (4.77, 0.94, 0.07),
    "SH_M2": (3.84, 0.49, 0.65),
    "SH_M3": (2.24, 0.14, -0.70),
    "SH_M4": (2.28, 0.17, -0.63),
}
TABLE_4_4 = {
    "basantapur": (2.06, 0.16, 0.96),
    "patan": (1.84, 0.15, 0.96),
    "dharahara": (0.50, 0.12, 0.98),
    "narayan": (1.39, 0.24, 0.91),
}
TABLE_5_5 = {"side-aisle-base": 1.11, "side-aisle-midpoint": 4.82}  # lambda [-]
DEPTHS = {"spire-whole": 1, "spire-two-thirds": 2 / 3, "spire-third": 1 / 3}  # h_c / H; the others 1 / 2
TRANSCRIPT = Path(__file__).parents[4] / "shared" / "reference" / "goldens" / "table_5_1.csv"
TABLE_5_1 = {  # h_c = H/2 at 45 deg stands in it twice; the last row is h_c = H/3
    "spire-45": (3.17, 0.42, 0.72),
    "spire-60": (3.04, 0.34, 0.81),
    "spire-75": (2.75, 0.23, 0.90),
    "spire-whole": (2.19, 0.40, 0.75),
    "spire-two-thirds": (2.73, 0.41, 0.73),
    "spire-third": (3.88, 0.43, 0.72),
}
TABLE_5_2 = {
    "apse-base-45": (1.39, 0.29, None),
    "apse-base-60": (1.37, 0.24, None),
    "apse-base-75": (1.35, 0.16, None),
    "apse-window-45": (1.74, 0.41, None),
    "apse-window-60": (1.85, 0.27, None),
    "apse-window-75": (1.96, 0.13, None),
}
TABLE_5_3 = {
    "facade-1": (3.25, 0.29, None),
    "facade-2": (2.19, 0.12, None),
    "facade-3": (1.38, 0.06, None),
    "facade-4": (1.39, 0.02, None),
    "facade-5": (1.39, 0.06, None),
}
TABLE_5_4 = {
    "corner-midpoint": (1.04, 0.15, 0.98),
    "corner-midpoint-1s": (1.04, 0.15, None),
    "corner-window": (1.32, 0.27, 0.93),
    "corner-window-1s": (1.32, 0.27, None),
    "portal-frame": (2.21, 0.21, 0.92),
}
ELEVATIONS = {  # h of Tables 5.1 to 5.4 [m], 4.60 m of section 4.5; 0 where nothing stands here
    "basantapur": 4.60,
    "patan": 4.60,
    "spire-45": 20.25,
    "spire-60": 20.25,
    "spire-75": 20.25,
    "spire-whole": 18.25,
    "spire-two-thirds": 19.58,
    "spire-third": 20.92,
    "apse-window-45": 3.0,
    "apse-window-60": 3.0,
    "apse-window-75": 3.0,
    "facade-1": 9.70,
    "facade-2": 7.75,
    "facade-3": 3.0,
    "facade-4": 3.0,
    "facade-5": 3.0,
    "corner-midpoint": 9.0,
    "corner-midpoint-1s": 9.0,
    "corner-window": 13.0,
    "corner-window-1s": 13.0,
    "portal-frame": 13.0,
}
EQUIVALENT = {
    "lnec_houses": TABLE_4_1,
    "nepal_monuments": TABLE_4_4,
    "san_leonardo_tower": TABLE_5_1 | TABLE_5_4,
    "san_leonardo_church": TABLE_5_2 | TABLE_5_3,
}
BY_3_44 = {name: row for name, row in (TABLE_4_1 | TABLE_4_4 | TABLE_5_1).items() if row[2] > 0}
OFF = 0.005  # half a unit of the last digit


@pytest.fixture(scope="module")
def mechanisms():
    """The mechanisms of each example that stands on these tables."""
    names = [*EQUIVALENT, "san_leonardo_spire"]
    assert set(names) < set(EXAMPLES)
    studies = {n: example_study(n) for n in names}
    found = {n: {m.name: m for m in study.mechanisms} for n, study in studies.items()}
    (sweep,) = studies["san_leonardo_spire"].sweeps  # the spire's crack at H/2 at each angle
    assert (sweep.key, sweep.unit) == ("mechanisms.spire-half.cut.angle", "deg")
    found["san_leonardo_spire"] |= {f"spire-{case.value:.0f}": case.study.mechanisms[0] for case in sweep.cases}
    return found


def parameters(mechanism):
    """p [1/s], slenderness [rad], restitution by 3.44, radius [m] of the positive branch."""
    rocker = mechanism.oscillator
    branch = rocker.positive
    block = equivalent_block(branch, mass=rocker.mass)
    k = block.inertia / (block.mass * block.radius**2)
    return branch.linearised.p, block.slenderness, 1 - 2 / k * sin(block.slenderness) ** 2, block.radius


@pytest.mark.parametrize(("example", "name"), [(e, n) for e, table in EQUIVALENT.items() for n in table])
def test_an_example_has_the_published_row(example, name, mechanisms):
    mechanism = mechanisms[example][name]
    p, slenderness, restitution = EQUIVALENT[example][name]
    branch = mechanism.oscillator.positive
    assert branch.linearised.p == pytest.approx(p, rel=1e-6)
    assert branch.overturning == pytest.approx(slenderness, rel=0.05 if name == "dharahara" else 1e-9)  # 0.125: 7.1
    assert mechanism.elevation == ELEVATIONS.get(name, 0.0)
    if restitution is not None:
        assert branch.restitution == pytest.approx(abs(restitution), abs=OFF)
    assert mechanism.sides == ("one" if restitution is None or restitution < 0 else "two")


@pytest.mark.parametrize("name", BY_3_44)
def test_restitution_and_slenderness_are_those_of_a_body(name):
    """k = 2 sin^2 lambda / (1 - eta) by 3.44; a plain wall has 4/3."""
    _, slenderness, restitution = BY_3_44[name]
    assert 1.03 < 2 * sin(slenderness) ** 2 / (1 - restitution) < 1.44


@pytest.mark.parametrize(("name", "k"), [("SH_M3", 1.12), ("SH_M4", 1.14)])
def test_rebound_and_slenderness_are_those_of_a_body(name, k):
    """3.45 solved for k."""
    _, slenderness, restitution = TABLE_4_1[name]
    s, c = sin(slenderness) ** 2, cos(slenderness) ** 2
    found = brentq(lambda k: (1 - 2 / k * s) ** 2 * (1 - 2 / k * c) - restitution, 1.0, 1.9)
    assert found == pytest.approx(k, abs=OFF)


@pytest.mark.parametrize("name", ["corner-midpoint", "corner-window"])
def test_the_corners_of_table_5_4_do_not_follow_3_44(name):
    """Their restitution would mean k of about 2, which no wall has: so it is given to the program, not computed."""
    _, slenderness, restitution = TABLE_5_4[name]
    assert 2 * sin(slenderness) ** 2 / (1 - restitution) > 1.9


def test_dharahara_of_table_4_4_is_that_of_table_7_1(mechanisms):
    """R0 30.44 m, alpha0 0.125; lambda is alpha0 cut short."""
    p, slenderness, _, radius = parameters(mechanisms["nepal_monuments"]["dharahara"])
    assert (radius, slenderness) == (pytest.approx(30.44), pytest.approx(0.125))
    assert int(slenderness * 100) / 100 == TABLE_4_4["dharahara"][1]
    assert 1.26 < g / (p**2 * radius) < 4 / 3


@pytest.mark.parametrize(
    ("reading", "p", "slenderness", "radius"),
    [("even", -0.0145, 0.0578, -0.0058), ("tapered", 0.0617, 0.367, -0.2291)],
)
def test_the_two_readings_of_the_dharahara_tower(reading, p, slenderness, radius, mechanisms):
    """Regression: distances from p = 0.50 (Table 4.4), alpha0 and R0 (Table 7.1) that the example's README states."""
    mechanism = mechanisms["nepal_monuments"][f"dharahara-{reading}"]
    found = parameters(mechanism)
    assert found[0] / 0.50 - 1 == pytest.approx(p, abs=5e-4)
    assert found[1] / 0.125 - 1 == pytest.approx(slenderness, abs=5e-4)
    assert found[3] / 30.44 - 1 == pytest.approx(radius, abs=5e-4)
    assert mechanism.oscillator.mass * g == pytest.approx(24003.94e3, rel=1e-9)
    assert mechanism.positive.hinges[0][0] == pytest.approx(3.99, rel=1e-12)


def test_a_solid_of_the_ring_of_table_7_1_would_be_too_heavy():
    ring = np.pi * (3.99**2 - 2.12**2) * 60.0 * 2000.0 * g
    assert ring / 24003.94e3 == pytest.approx(1.76, abs=0.01)


@pytest.mark.skipif(not TRANSCRIPT.is_file(), reason="the transcripts of the thesis' tables are not there")
def test_the_transcript_of_table_5_1_ends_before_the_last_row_of_the_print():
    """It repeats h_c = H/2, as the print does, but lacks H/3: p 3.88, lambda 0.43, eta 0.72, h 20.92 m."""
    rows = np.genfromtxt(TRANSCRIPT, delimiter=",", skip_header=2)
    printed = [*TABLE_5_1.values()]
    np.testing.assert_array_equal(rows[:, 2:5], [*printed[:5], printed[0]])
    heights = [ELEVATIONS[name] for name in TABLE_5_1]
    np.testing.assert_array_equal(rows[:, 7], [*heights[:5], heights[0]])
    assert (*TABLE_5_1["spire-third"], ELEVATIONS["spire-third"]) == (3.88, 0.43, 0.72, 20.92)


def test_the_spire_is_4_m_high():
    """h + h_c is the tip of the spire for every crack of Table 5.1."""
    for name in TABLE_5_1:
        assert ELEVATIONS[name] + 4.0 * DEPTHS.get(name, 0.5) == pytest.approx(22.25, abs=OFF)


@pytest.mark.parametrize("name", TABLE_5_1)
def test_restitution_of_the_mesh_of_the_spire_against_table_5_1(name, mechanisms):
    """Not fitted; the table takes the spire as rocking both ways, so by 3.44."""
    assert parameters(mechanisms["san_leonardo_spire"][name])[2] == pytest.approx(TABLE_5_1[name][2], abs=0.009)


@pytest.mark.parametrize("name", [name for name in TABLE_5_1 if name != "spire-75"])
def test_the_radius_from_the_restitution_is_that_of_the_mesh(name, mechanisms):
    """Two ways that share nothing but p and lambda; of the crack at 75 deg two digits of 0.90 leave 5 %."""
    by_table = parameters(mechanisms["san_leonardo_tower"][name])[3]
    assert by_table == pytest.approx(parameters(mechanisms["san_leonardo_spire"][name])[3], rel=0.035)


def test_radius_and_wall_of_the_spire_are_the_least_squares_fit():
    angles = {"spire-60": 60.0, "spire-75": 75.0}

    def distances(sizes):
        solid = polyhedron(*vars(spire(radius=sizes[0], wall=sizes[1])).values(), density=1.0, name="spire")
        out = []
        for name, (p, slenderness, _) in TABLE_5_1.items():
            depth = DEPTHS.get(name, 0.5)
            normal = [np.tan(np.radians(angles.get(name, 45.0))), 0.0, 1.0]
            plane = inclined_plane([sizes[0] * depth, 0.0, 22.25 - 4.0 * depth], normal, where=name)
            part = divide([solid], plane, where=name)
            body = planar_body(part.above[0], direction=(1, 0, 0))
            hinge = base_of_section(part.foot, direction=(1, 0, 0))[1]
            x, z = hinge[0] - body.centroid[0], body.centroid[1] - hinge[1]
            R = np.hypot(x, z)
            out += [np.sqrt(g * R / (body.inertia / body.mass + R**2)) / p - 1, np.arctan2(x, z) / slenderness - 1]
        return np.array(out)

    found = least_squares(distances, [0.8, 0.25], diff_step=1e-3)
    assert found.x == pytest.approx([SPIRE_RADIUS, SPIRE_WALL], abs=OFF)


@pytest.mark.parametrize(
    ("name", "multiplier", "by_angle"),
    [("side-aisle-base", 0.108, 1.04), ("side-aisle-midpoint", 0.184, 4.66)],
)
def test_the_side_aisle_of_three_blocks_against_table_5_5(name, multiplier, by_angle, mechanisms):
    """Its lambda is not K phi_cr / (g B) of blocks like these, but is within 7 % of
    that with the angle of the half vault AB in the place of its rotation phi_cr, as 3.37 can be read; sizes chosen so.
    """
    mechanism = mechanisms["san_leonardo_church"][name]
    found = mechanism.oscillator.positive.linearised
    (xa, za), (xb, zb) = mechanism.positive.hinges[:2]
    angle = atan2(zb - za, xb - xa) - found.critical
    assert found.multiplier == pytest.approx(multiplier, abs=5e-4)
    assert found.stiffness * angle / (g * found.excitation) == pytest.approx(by_angle, abs=5e-3)
    assert by_angle == pytest.approx(TABLE_5_5[name], rel=0.07)


def test_the_steepest_crack_of_the_spire_controls(mechanisms):
    """Table 5.6 takes the crack at 75 deg; p and slenderness fall from angle to angle."""
    spire = [parameters(mechanisms["san_leonardo_spire"][f"spire-{angle}"]) for angle in range(45, 80, 5)]
    assert all(before[0] > after[0] and before[1] > after[1] for before, after in pairwise(spire))


def test_table_5_6_repeats_the_controlling_rows():
    controlling = {
        "spire-75": (2.75, 0.23, 0.90),
        "corner-midpoint": (1.04, 0.15, 0.98),
        "facade-2": (2.19, 0.12, None),
        "portal-frame": (2.21, 0.21, 0.92),
        "apse-window-75": (1.96, 0.13, None),
        "facade-4": (1.39, 0.02, None),
    }
    rows = TABLE_5_1 | TABLE_5_2 | TABLE_5_3 | TABLE_5_4
    assert {name: rows[name] for name in controlling} == controlling


def test_the_temple_is_twice_as_stocky_as_the_tower_and_1_5_times_as_the_columns():
    """Section 4.3, of Table 4.4."""
    stocky = {name: row[1] for name, row in TABLE_4_4.items()}
    assert stocky["narayan"] / stocky["dharahara"] == pytest.approx(2.0, rel=1e-9)
    assert stocky["narayan"] / stocky["basantapur"] == pytest.approx(1.5, rel=1e-9)
