"""Thesis eqs. 3.34-3.43 (DeJong & Dimitrakopoulos 2014): three blocks between four hinges.

varphi is the angle of AB above +x, so that the rotation is varphi_0 - varphi. I_AB is about A, I_BC about B, I_CD
about D; psi are the angles from AB, BC and DC to the centroids. Misprints and ambiguities of the print:

3.43  the last term has f_BC instead of f_CD = (AB / CD) sin(varphi - varphi_BC) / sin(varphi_CD - varphi_BC)
3.37  the rotation phi_cr = varphi_0AB - varphi_cr has the sign of the angle varphi_cr on both sides
3.36  has the sign of the rotation, not of varphi
3.38-3.40  arctan is atan2, as directions go beyond 90 degrees
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from math import atan2, hypot, pi

import numpy as np
import pytest
from scipy.constants import g
from scipy.optimize import brentq

from assess.mechanisms.branch_table import rigid_branch
from assess.mechanisms.chain import Chain, RigidBlock, mirror_chain, virtual_work
from assess.project.build import build
from assess.project.project_file import load
from tests.support.bodies import rectangle_block
from tests.support.differences import bend, slope


@dataclass(frozen=True)
class Frame:
    """The thesis' formulas for a frame of blocks AB, BC, CD and hinges A, B, C, D."""

    blocks: tuple[RigidBlock, RigidBlock, RigidBlock]
    hinges: tuple
    turn: float = 1.0  # +1 where rotation lessens varphi, towards +x; -1 for the hinges of negative rotation

    def turned(self, rotation):
        """varphi at a rotation >= 0."""
        return self.angle(*"AB") - self.turn * rotation

    def length(self, one, other):
        a, b = (self.hinges["ABCD".index(each)] for each in (one, other))
        return hypot(b[0] - a[0], b[1] - a[1])

    def angle(self, one, other):
        a, b = (self.hinges["ABCD".index(each)] for each in (one, other))
        return atan2(b[1] - a[1], b[0] - a[0])

    def polar(self, number):
        """m, r and psi of a block from its hinge: A, B, D."""
        hinge, line = (("A", "AB"), ("B", "BC"), ("D", "DC"))[number]
        at, centre = self.hinges["ABCD".index(hinge)], self.blocks[number].centroid
        x, z = centre[0] - at[0], centre[1] - at[1]
        return self.blocks[number].mass, hypot(x, z), atan2(z, x) - self.angle(*line)

    def bd(self, phi):  # 3.38
        AB, AD = self.length(*"AB"), self.length(*"AD")
        return np.sqrt(AB**2 + AD**2 - 2 * AB * AD * np.cos(phi - self.angle(*"AD")))

    def cd(self, phi):  # 3.40
        AB, AD, BC, CD = (self.length(*pair) for pair in ("AB", "AD", "BC", "CD"))
        up = AB * np.sin(phi) - AD * np.sin(self.angle(*"AD"))
        along = AB * np.cos(phi) - AD * np.cos(self.angle(*"AD"))
        return np.arctan2(up, along) - np.arccos((self.bd(phi) ** 2 + CD**2 - BC**2) / (2 * CD * self.bd(phi)))

    def bc(self, phi):  # 3.39
        AB, AD, CD = (self.length(*pair) for pair in ("AB", "AD", "CD"))
        far, leg = self.angle(*"AD"), self.cd(phi)
        up = -AB * np.sin(phi) + AD * np.sin(far) + CD * np.sin(leg)
        return np.arctan2(up, -AB * np.cos(phi) + AD * np.cos(far) + CD * np.cos(leg))

    def f_bc(self, phi):  # 3.41
        ratio = self.length(*"AB") / self.length(*"BC")
        return ratio * np.sin(phi - self.cd(phi)) / np.sin(self.cd(phi) - self.bc(phi))

    def f_cd(self, phi):  # 3.42
        ratio = self.length(*"AB") / self.length(*"CD")
        return ratio * np.sin(phi - self.bc(phi)) / np.sin(self.cd(phi) - self.bc(phi))

    def slope_of_potential(self, phi, *, last):
        """3.43, dV / d varphi, with the factor `last` in its last term."""
        (m1, r1, s1), (m2, r2, s2), (m3, r3, s3) = (self.polar(k) for k in range(3))
        lifted = m1 * r1 * np.cos(phi + s1) + m2 * self.length(*"AB") * np.cos(phi)
        beam = m2 * r2 * np.cos(self.bc(phi) + s2) * self.f_bc(phi)
        return g * (lifted + beam + m3 * r3 * np.cos(self.cd(phi) + s3) * last(phi))

    def critical(self):
        """varphi_cr, where 3.43 as corrected is zero."""
        stations = self.turned(np.linspace(0.0, 0.6, 601))
        values = [self.slope_of_potential(x, last=self.f_cd) for x in stations]
        change = next(i for i in range(600) if values[i] * values[i + 1] <= 0)
        return brentq(
            lambda x: self.slope_of_potential(x, last=self.f_cd), stations[change], stations[change + 1],
            xtol=1e-15, rtol=1e-14,
        )  # fmt: skip

    def inertia(self, phi):  # 3.34
        (m1, r1, _), (m2, r2, s2), (m3, r3, _) = (self.polar(k) for k in range(3))
        about = [each.inertia + m * r**2 for each, m, r in zip(self.blocks, (m1, m2, m3), (r1, r2, r3), strict=True)]
        AB, f = self.length(*"AB"), self.f_bc(phi)
        return (
            about[0]
            + about[2] * self.f_cd(phi) ** 2
            + about[1] * f**2
            + m2 * AB * (AB + 2 * r2 * np.cos(phi - self.bc(phi) - s2) * f)
        )

    def stiffness(self, phi):  # 3.35
        (m1, r1, s1), (m2, r2, s2), (m3, r3, s3) = (self.polar(k) for k in range(3))
        beam, leg = self.bc(phi) + s2, self.cd(phi) + s3
        return -g * (
            m2 * r2 * (np.cos(beam) * bend(self.bc, phi) - np.sin(beam) * slope(self.bc, phi) ** 2)
            + m3 * r3 * (np.cos(leg) * bend(self.cd, phi) - np.sin(leg) * slope(self.cd, phi) ** 2)
            - m1 * r1 * np.sin(phi + s1)
            - m2 * self.length(*"AB") * np.sin(phi)
        )

    def excitation(self, phi):  # 3.36
        (m1, r1, s1), (m2, r2, s2), (m3, r3, s3) = (self.polar(k) for k in range(3))
        return (
            m1 * r1 * np.sin(phi + s1)
            + m3 * r3 * np.sin(self.cd(phi) + s3) * self.f_cd(phi)
            + m2 * r2 * np.sin(self.bc(phi) + s2) * self.f_bc(phi)
            + m2 * self.length(*"AB") * np.sin(phi)
        )

    @property
    def chain(self):
        """As the branch sees it."""
        return Chain(self.blocks, self.hinges) if self.turn > 0 else mirror_chain(self.blocks, self.hinges)


block_of = partial(rectangle_block, density=2000.0)


def portal(left, right, *, beam=0.7, step=0.0):
    """A frame of two columns (width, height), 3 m apart, the right one on a step, under a wedge of a beam."""
    (b1, h1), (b3, h3) = left, right
    columns = block_of(0.0, 0.0, b1, h1), block_of(3.0 + b1, step, b3, h3)
    over = block_of(0.0, max(h1, step + h3), 3.0 + b1 + b3, beam)
    blocks = (columns[0], over, columns[1])
    front = ((b1, 0.0), (0.0, h1), (3.0 + b1, step + h3), (3.0 + b1 + b3, step))
    back = ((0.0, 0.0), (b1, h1), (3.0 + b1 + b3, step + h3), (3.0 + b1, step))
    return Frame(blocks, front), Frame(blocks, back, turn=-1.0)


CASES = {
    "symmetric": portal((0.8, 4.0), (0.8, 4.0)),
    "asymmetric": portal((0.8, 4.0), (1.1, 5.0)),
    "heavy right": portal((0.6, 4.0), (1.6, 3.6), beam=0.3),
    "stepped": portal((0.8, 4.0), (0.7, 3.0), step=1.4),
}
FRAMES = {f"{name}, {side}": frame for name, both in CASES.items() for side, frame in zip("+-", both, strict=True)}
EVERY = pytest.mark.parametrize("frame", FRAMES.values(), ids=FRAMES)


@EVERY
def test_closed_factors_3_41_and_3_42_are_the_derivatives_of_3_39_and_3_40(frame):
    for phi in frame.turned(np.array([0.0, 0.07, 0.15])):
        assert frame.f_bc(phi) == pytest.approx(slope(frame.bc, phi), rel=1e-9, abs=1e-10)
        assert frame.f_cd(phi) == pytest.approx(slope(frame.cd, phi), rel=1e-9)


@EVERY
def test_inertia_excitation_and_slope_of_the_potential_at_any_rotation(frame):
    """3.34, 3.36 and 3.43 hold not only at phi_cr; 3.36 is for the rotation, 3.43 for the angle varphi."""
    rotation = np.array([0.0, 0.03, 0.08, 0.17])
    work = virtual_work(frame.chain, rotation)
    np.testing.assert_allclose(work.inertia, frame.inertia(frame.turned(rotation)), rtol=1e-12)
    np.testing.assert_allclose(work.excitation, frame.excitation(frame.turned(rotation)), rtol=1e-12)
    expected = -frame.turn * frame.slope_of_potential(frame.turned(rotation), last=frame.f_cd)
    np.testing.assert_allclose(work.weight, expected, rtol=1e-11, atol=1e-11 * np.abs(expected).max())


@EVERY
def test_constants_of_the_linearised_equation(frame):
    side, angle = rigid_branch(frame.chain, restitution=0.9, name="p"), frame.critical()
    form = side.linearised
    assert form.critical == pytest.approx(frame.turn * (frame.angle(*"AB") - angle), rel=1e-11)  # 3.37, as it is meant
    assert (side.overturning, form.overturning) == pytest.approx((form.critical, form.critical), rel=1e-11)
    assert form.inertia == pytest.approx(frame.inertia(angle), rel=1e-8)  # 3.34
    assert form.stiffness == pytest.approx(frame.stiffness(angle), rel=1e-8)  # 3.35; slope of a table
    assert form.excitation == pytest.approx(frame.excitation(angle), rel=1e-8)  # 3.36
    assert form.moment == pytest.approx(0.0, abs=1e-8 * form.stiffness)


def test_last_term_of_3_43_is_misprinted():
    """An asymmetric frame: the print is a third short of the slope at rest, and not zero at phi_cr.

    Where the columns are alike f_BC = 0: then the print would leave the second column out.
    """
    frame = FRAMES["asymmetric, +"]
    start, angle = frame.angle(*"AB"), frame.critical()
    exact = virtual_work(frame.chain, np.array([0.0, start - angle])).weight
    right = [frame.slope_of_potential(x, last=frame.f_cd) for x in (start, angle)]
    wrong = [frame.slope_of_potential(x, last=frame.f_bc) for x in (start, angle)]
    assert -right[0] == pytest.approx(exact[0], rel=1e-12)
    assert abs(right[1]) < 1e-9 * exact[0]
    assert abs(exact[1]) < 1e-9 * exact[0]
    assert -wrong[0] < 0.67 * exact[0]
    assert abs(wrong[1]) > 0.04 * exact[0]
    alike = FRAMES["symmetric, +"]
    assert alike.f_bc(alike.angle(*"AB")) == pytest.approx(0.0, abs=1e-12)


def test_arctan_of_3_40_is_atan2():
    """B lies to the left of D, so the direction from D to B is beyond 90 degrees: arctan would be off by pi."""
    frame = FRAMES["asymmetric, +"]
    a, b, _, d = frame.hinges
    assert np.arctan((b[1] - d[1]) / (b[0] - d[0])) == pytest.approx(atan2(b[1] - d[1], b[0] - d[0]) - pi)
    assert frame.cd(frame.angle(*"AB")) == pytest.approx(frame.angle(*"DC"), rel=1e-12)
    assert a[0] < d[0]


def test_a_portal_of_a_project_has_these_constants_each_way(tmp_path):
    front, back = CASES["asymmetric"]
    (tmp_path / "project.toml").write_text("""
[materials.m]
density = 2000
[bodies.left]
material = "m"
box = { thickness = 0.8, length = 1.0, height = 4.0, base = [0.4, 0.0, 0.0] }
[bodies.beam]
material = "m"
box = { thickness = 4.9, length = 1.0, height = 0.7, base = [2.45, 0.0, 5.0] }
[bodies.right]
material = "m"
box = { thickness = 1.1, length = 1.0, height = 5.0, base = [4.35, 0.0, 0.0] }
[mechanisms.p]
kind = "four-hinge"
blocks = ["left", "beam", "right"]
hinges = { A = [0.8, 0.0], B = [0.0, 0.0, 4.0], C = [3.8, 5.0], D = [4.9, 0, 0] }
hinges_negative = { A = [0.0, 0.0], B = [0.8, 4.0], C = [4.9, 5.0], D = [3.8, 0.0] }
""")
    (mechanism,) = build(load(tmp_path)).mechanisms
    for chain, frame in ((mechanism.positive, front), (mechanism.negative, back)):
        form = rigid_branch(chain, restitution=0.9, name="p").linearised
        angle = frame.critical()
        assert form.critical == pytest.approx(frame.turn * (frame.angle(*"AB") - angle), rel=1e-10)
        assert form.inertia == pytest.approx(frame.inertia(angle), rel=1e-8)
        assert form.stiffness == pytest.approx(frame.stiffness(angle), rel=1e-8)
