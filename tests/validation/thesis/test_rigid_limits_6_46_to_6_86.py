"""Thesis eqs. 6.46-6.86 where the hinges do not move: kinetic energy, potential, excitation of each mechanism.

T = I phi'^2 / 2, V, B and M as printed, with hinges at the edges or shifted inwards by fixed amounts, which is what
the semi-flexible model (6.55, 6.66, 6.71, 6.79, 6.86) makes of them. Misprint: 6.53 has -(1/g) R' phi'^2, where
Lagrange's equation 6.46 gives +.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from math import atan2, hypot

import numpy as np
import pytest
from scipy.constants import g
from scipy.integrate import solve_ivp

from assess.dynamics.history import free_rocking
from assess.loads.load import Force
from assess.mechanisms.chain import Chain, RigidBlock, mirror_chain, virtual_work
from assess.mechanisms.four_hinge import four_hinge
from assess.mechanisms.single_block import single_block
from assess.mechanisms.two_block import two_block
from assess.oscillator import Branch, Oscillator
from tests.support.bodies import body_of_block, rectangle_block
from tests.support.differences import slope

ROTATION = np.array([0.02, 0.06, 0.11])
RHO = 1900.0
block_of = partial(rectangle_block, density=RHO)


def polar(hinge, at, *, side=1.0):
    """R and alpha of a point from a hinge: alpha > 0 where the point is behind it, as the block leans back."""
    x, z = side * (hinge[0] - at[0]), at[1] - hinge[1]
    return hypot(x, z), atan2(x, z)


def same(found, expected):
    np.testing.assert_allclose(found, expected, rtol=1e-9, atol=1e-9 * np.abs(expected).max())


def sizes(blocks):
    """W and I_G of blocks."""
    return [(block.mass * g, block.inertia) for block in blocks]


@pytest.mark.parametrize("shift", [0.0, 0.07])
def test_single_block_6_47_to_6_52_and_6_55_to_6_60(shift):
    block, hinge = block_of(-0.5, 0.0, 1.0, 4.4), (0.5 - shift, 0.0)
    R_0, alpha_0 = polar((0.5, 0.0), block.centroid)
    R = np.sqrt((R_0 * np.cos(alpha_0)) ** 2 + (R_0 * np.sin(alpha_0) - shift) ** 2)  # 6.51, 6.57
    alpha = np.arccos(R_0 * np.cos(alpha_0) / R)  # 6.52, 6.58
    ((W, I_C),) = sizes([block])
    I_O = I_C + W / g * R**2  # 6.50, 6.56
    work = virtual_work(Chain((block,), (hinge,)), ROTATION)
    same(work.inertia, I_O)  # 6.47, 6.55
    same(work.weight, slope(lambda phi: W * R * np.cos(alpha - phi), ROTATION))  # 6.48
    same(work.excitation, W / g * R * np.cos(alpha - ROTATION))  # 6.49
    eta = 1 - 2 * block.mass * R**2 / I_O * np.sin(alpha) ** 2  # 6.60
    found = single_block("w", body_of_block(block), hinge=hinge, hinge_negative=(-hinge[0], 0.0)).restitution
    assert found == pytest.approx((eta, eta), rel=1e-12)


def test_inertial_term_of_6_53_has_the_other_sign():
    """A block on a hinge that moves, R(phi) and alpha(phi) by 6.51 and 6.52, free from 0.6 phi_ov to its impact.

    The program's equation has I' phi'^2 / 2 = (W / g) R R' phi'^2 from Lagrange; so has 6.53 with a plus.
    """
    mass, b, h = 4000.0, 0.5, 2.2  # half thickness, half height
    I_C = mass * (b**2 + h**2) / 3

    def shift(phi):
        return 0.12 / (1 + 12 * phi)

    def R(phi):
        return np.sqrt(h**2 + (b - shift(phi)) ** 2)

    def alpha(phi):
        return np.arctan2(b - shift(phi), h)

    def inertia(phi):
        return I_C + mass * R(phi) ** 2

    def acceleration(phi, rate, sign):  # 6.53 on still ground
        growth, turn = slope(R, phi), slope(alpha, phi)
        angle = alpha(phi) - phi
        bracket = growth * rate**2 * sign / g + growth * np.cos(angle) / R(phi) - np.sin(angle) * (turn - 1)
        return -mass * g * R(phi) / inertia(phi) * bracket

    phi = np.linspace(0.0, 0.3, 513)
    restoring = slope(lambda x: mass * g * R(x) * np.cos(alpha(x) - x), phi)
    one = np.ones_like(phi)
    overturning = float(phi[np.flatnonzero(restoring > 0)[-1]])
    side = Branch(phi, inertia(phi), restoring, one, one, one, 0.9, overturning, overturning)
    body = Oscillator(side, side, mass)
    found = free_rocking(body, rotation=0.6 * overturning, duration=3.0).impact_time[0]

    def impact(sign):
        event = lambda t, y: y[0]  # noqa: E731
        event.terminal = True
        done = solve_ivp(
            lambda t, y: (y[1], acceleration(y[0], y[1], sign)), (0.0, 5.0), (0.6 * overturning, 0.0),
            method="DOP853", rtol=1e-12, atol=1e-13, events=event,
        )  # fmt: skip
        return done.t_events[0][0]

    assert found == pytest.approx(impact(+1.0), rel=1e-8)
    assert abs(found / impact(-1.0) - 1) > 1e-4


WALL = block_of(0.0, 0.0, 0.5, 2.6), block_of(0.0, 2.6, 0.5, 1.6)
FORCE, PLACE = 21000.0, 0.3  # overburden [N], xi


@pytest.mark.parametrize("shift", [0.0, 0.06])
def test_two_blocks_6_61_to_6_66(shift):
    """A shift of hinge 2 alone: 6.65 keeps O and the top corner, so that other shifts do not agree with 6.61."""
    o, two, top = (0.5, 0.0), (0.0 + shift, 2.6), (0.5, 4.2)
    load = (0.5 * (1 - PLACE), 4.2)
    (W1, I1), (W2, I2) = sizes(WALL)
    (R1, a1), (R12, a12) = polar(o, WALL[0].centroid), polar(o, two)
    (R2, a2), (R2H, a2H) = (polar(two, at, side=-1.0) for at in (WALL[1].centroid, top))
    R23, a23 = polar(two, load, side=-1.0)

    def other(phi):  # 6.65
        return a2H - np.arcsin(R12 / R2H * np.sin(a12 - phi))

    phi2, rate = other(ROTATION), slope(other, ROTATION)
    I = (  # 6.61, 6.66  # noqa: E741
        I1 + I2 * rate**2 + W1 / g * R1**2 + W2 / g * (R2**2 * rate**2 + R12**2)
        - 2 * W2 / g * R12 * R2 * np.cos(a12 - ROTATION + a2 - phi2) * rate
    )  # fmt: skip

    def V(phi):  # 6.62
        return W1 * R1 * np.cos(a1 - phi) + W2 * (R12 * np.cos(a12 - phi) + R2 * np.cos(a2 - other(phi)))

    B = W1 / g * R1 * np.cos(a1 - ROTATION) + W2 / g * (  # 6.63
        R12 * np.cos(a12 - ROTATION) - R2 * np.cos(a2 - phi2) * rate
    )
    M = -FORCE * (R12 * np.sin(a12 - ROTATION) + R23 * np.sin(a23 - phi2) * rate)  # 6.64
    chain = Chain(WALL, (o, two, top), (Force("F", (0.0, -FORCE), load, block=1),))
    work = virtual_work(chain, ROTATION)
    for found, expected in zip((work.inertia, work.weight, work.excitation, work.moment),
                               (I, slope(V, ROTATION), B, M), strict=True):  # fmt: skip
        same(found, expected)


@pytest.mark.parametrize("shifts", [(0.0, 0.0, 0.0), (0.05, 0.08, 0.03), (0.1, 0.02, 0.0)])
def test_two_blocks_restitution_6_67(shifts):
    """With hinges 1, 2, 3 shifted inwards; dphi_2 / dphi at rest is the ratio of the heights, as the top slides."""
    a, b, c = shifts
    one, two = (0.5 - a, 0.0), (b, 2.6)
    (R1, a1), (R12, a12) = polar(one, WALL[0].centroid), polar(one, two)
    R2, a2 = polar(two, WALL[1].centroid, side=-1.0)
    m1, m2, rate = WALL[0].mass, WALL[1].mass, 2.6 / 1.6
    (I1, I2) = (block.inertia for block in WALL)
    rise = m2 * R2 * np.cos(a2) * (R12 * np.cos(a12) + R2 * np.cos(a2)) * rate
    aside = m2 * (R12 * np.sin(a12) + R2 * np.sin(a2) * rate) * (R12 * np.sin(a12) - R2 * np.sin(a2))
    over = I1 + m1 * (R1 * np.cos(a1)) ** 2 - m1 * (R1 * np.sin(a1)) ** 2 - I2 * rate + rise - aside
    eta = over / (I1 + m1 * R1**2 - I2 * rate + rise + aside)
    mechanism = two_block(
        "w", body_of_block(WALL[0]), body_of_block(WALL[1]),
        hinges=(one, two, (0.5 - c, 4.2)), hinges_negative=((a, 0.0), (0.5 - b, 2.6), (c, 4.2)),
    )  # fmt: skip
    assert mechanism.restitution == pytest.approx((eta, eta), rel=1e-12)


@pytest.mark.parametrize("shifts", [(0.0, 0.0), (0.06, 0.09)])
def test_symmetric_frame_6_68_to_6_72(shifts):
    a, b = shifts
    blocks = block_of(0.0, 0.0, 0.8, 4.0), block_of(0.0, 4.0, 4.6, 0.7), block_of(3.8, 0.0, 0.8, 4.0)
    front = ((0.8 - a, 0.0), (b, 4.0), (3.8 + b, 4.0), (4.6 - a, 0.0))
    back = ((a, 0.0), (0.8 - b, 4.0), (4.6 - b, 4.0), (3.8 + a, 0.0))
    (W1, I1), (W2, _), _ = sizes(blocks)
    (R1, a1), (R12, a12) = polar(front[0], blocks[0].centroid), polar(front[0], front[1])
    work = virtual_work(Chain(blocks, front), ROTATION)
    same(work.inertia, 2 * (I1 + W1 / g * R1**2 + W2 / (2 * g) * R12**2) * np.ones(3))  # 6.68, 6.71

    def V(phi):  # 6.69
        return 2 * W1 * R1 * np.cos(a1 - phi) + W2 * (R12 * np.cos(a12 - phi) + 0.35)

    same(work.weight, slope(V, ROTATION))
    same(work.excitation, 2 * W1 / g * R1 * np.cos(a1 - ROTATION) + W2 / g * R12 * np.cos(a12 - ROTATION))  # 6.70
    m1, m2 = W1 / g, W2 / g
    over = I1 + m1 * R1**2 * (1 - 2 * np.sin(a1) ** 2) + m2 * R12**2 / 2 * (1 - 2 * np.sin(a12) ** 2)
    eta = over / (I1 + m1 * R1**2 + m2 * R12**2 / 2)  # 6.72
    found = four_hinge("p", [body_of_block(each) for each in blocks], hinges=front, hinges_negative=back).restitution
    assert found == pytest.approx((eta, eta), rel=1e-12)


@dataclass(frozen=True)
class Asymmetric:
    """6.73-6.79: sign is +1 for the hinges of phi > 0, -1 for those of phi < 0."""

    blocks: tuple
    hinges: tuple
    sign: float

    def arm(self, hinge, at):
        """R and alpha > 0 of a point above a base hinge, on its inner side."""
        return polar(hinge, at, side=self.sign)

    def far(self):
        a, d = self.hinges[0], self.hinges[3]
        return hypot(d[0] - a[0], d[1] - a[1]), atan2(d[1] - a[1], d[0] - a[0])

    def column(self, phi):  # 6.77, 6.78
        a, b, c, d = self.hinges
        (RA2, aA2), (R3D, a3D), (RAD, fAD) = self.arm(a, b), self.arm(d, c), self.far()
        R23 = hypot(c[0] - b[0], c[1] - b[1])
        R2D = np.sqrt(RA2**2 + RAD**2 - 2 * RA2 * RAD * np.cos(aA2 * self.sign + np.pi / 2 - phi - fAD))
        aside = RA2 * np.sin(aA2 * self.sign - phi) + RAD * np.cos(fAD)
        up = RA2 * np.cos(aA2 * self.sign - phi) - RAD * np.sin(fAD)
        inside = np.arccos((R2D**2 + R3D**2 - R23**2) / (2 * R3D * R2D))
        return a3D * self.sign - np.arctan2(aside, up) + inside

    def beam(self, phi):  # 6.76
        a, b, c, d = self.hinges
        (RA2, aA2), (R3D, a3D), (RAD, fAD) = self.arm(a, b), self.arm(d, c), self.far()
        one, other = aA2 * self.sign - phi, a3D * self.sign - self.column(phi)
        up = -RA2 * np.cos(one) + RAD * np.sin(fAD) + R3D * np.cos(other)
        return np.arctan2(up, RA2 * np.sin(one) + RAD * np.cos(fAD) - R3D * np.sin(other))

    def parts(self):
        """(W, I_G) of the blocks, R_1, a_1, R_12, a_12, R_2, psi_2, R_3, a_3."""
        a, b, c, d = self.hinges
        first, over, last = (block.centroid for block in self.blocks)
        x, z = over[0] - b[0], over[1] - b[1]
        line = atan2(c[1] - b[1], c[0] - b[0])
        return (
            sizes(self.blocks), *self.arm(a, first), *self.arm(a, b), hypot(x, z), atan2(z, x) - line,
            *self.arm(d, last),
        )  # fmt: skip

    def inertia(self, phi):  # 6.73, 6.79
        ((W1, I1), (W2, I2), (W3, I3)), R1, _, R12, a12, R2, psi, R3, _ = self.parts()
        f23, f4 = slope(self.beam, phi), slope(self.column, phi)
        crossed = -2 * R12 * R2 * np.sin(phi - a12 * self.sign + self.beam(phi) + psi) * f23
        legs = I1 + W1 / g * R1**2 + (I3 + W3 / g * R3**2) * f4**2
        return legs + I2 * f23**2 + W2 / g * (R12**2 + R2**2 * f23**2 + crossed)

    def potential(self, phi):  # 6.74 where the hinges do not move
        ((W1, _), (W2, _), (W3, _)), R1, a1, R12, a12, R2, psi, R3, a3 = self.parts()
        RAD, fAD = self.far()
        over = W2 * (R12 * np.cos(a12 * self.sign - phi) + R2 * np.sin(self.beam(phi) + psi))
        leg = W3 * (R3 * np.cos(a3 * self.sign - self.column(phi)) + RAD * np.sin(fAD))
        return W1 * R1 * np.cos(a1 * self.sign - phi) + over + leg

    def excitation(self, phi):  # 6.75
        ((W1, _), (W2, _), (W3, _)), R1, a1, R12, a12, R2, psi, R3, a3 = self.parts()
        f23, f4 = slope(self.beam, phi), slope(self.column, phi)
        over = W2 * (R12 * np.cos(a12 * self.sign - phi) - R2 * np.sin(self.beam(phi) + psi) * f23)
        leg = W3 * R3 * np.cos(a3 * self.sign - self.column(phi)) * f4
        return (W1 * R1 * np.cos(a1 * self.sign - phi) + over + leg) / g


def frames(shift=0.0):
    """Columns of two heights on bases at two levels under a wedge of a beam, for both signs; hinges 2, 3 shifted."""
    blocks = (
        block_of(0.0, 0.0, 0.8, 4.0),
        RigidBlock(7000.0, (2.4, 4.9), 15000.0),
        block_of(3.6, 1.2, 1.0, 3.4),
    )
    front = ((0.8, 0.0), (shift, 4.0), (3.6 + shift, 4.6), (4.6, 1.2))
    back = ((0.0, 0.0), (0.8 - shift, 4.0), (4.6 - shift, 4.6), (3.6, 1.2))
    return Asymmetric(blocks, front, 1.0), Asymmetric(blocks, back, -1.0)


@pytest.mark.parametrize("shift", [0.0, 0.07])
@pytest.mark.parametrize("which", [0, 1])
def test_asymmetric_frame_6_73_to_6_79(which, shift):
    frame = frames(shift)[which]
    phi = frame.sign * ROTATION
    of = Chain if frame.sign > 0 else mirror_chain
    work = virtual_work(of(frame.blocks, frame.hinges), ROTATION)
    same(work.inertia, frame.inertia(phi))
    same(work.weight, frame.sign * slope(frame.potential, phi))
    same(work.excitation, frame.excitation(phi))


A, B, C, D = (0.0, 7.0), (2.6, 8.3), (4.8, 6.9), (6.2, 0.0)
VAULT = RigidBlock(2600.0, (1.15, 7.9), 1500.0), RigidBlock(2300.0, (3.8, 7.85), 1200.0), block_of(4.8, 0.0, 1.4, 7.4)


def test_side_aisle_vault_6_80_to_6_86():
    """Two halves of a vault, A B and B C, and the wall C D: phi_23 counter-clockwise, phi and phi_4 clockwise."""
    (W1, I1), (W2, I2), (W3, I3) = sizes(VAULT)
    (R1, a1), (RA2, aA2) = (polar(A, at, side=-1.0) for at in (VAULT[0].centroid, B))
    (R3, a3), (R3D, a3D) = (polar(D, at) for at in (VAULT[2].centroid, C))
    hanging = [(at[0] - B[0], B[1] - at[1]) for at in (VAULT[1].centroid, C)]  # angles from the downward vertical
    (R2, a2), (R23, a23) = ((hypot(*each), atan2(*each)) for each in hanging)
    RAD, fAD = hypot(D[0] - A[0], D[1] - A[1]), atan2(D[1] - A[1], D[0] - A[0])

    def wall(phi):  # 6.84, 6.85
        R2D = np.sqrt(RA2**2 + RAD**2 - 2 * RA2 * RAD * np.cos(np.pi / 2 - aA2 - phi - fAD))
        aside, up = -RA2 * np.sin(aA2 + phi) + RAD * np.cos(fAD), RA2 * np.cos(aA2 + phi) - RAD * np.sin(fAD)
        return a3D - np.arctan2(aside, up) + np.arccos((R2D**2 + R3D**2 - R23**2) / (2 * R3D * R2D))

    def half(phi):  # 6.83
        aside = -RA2 * np.sin(aA2 + phi) + RAD * np.cos(fAD) - R3D * np.sin(a3D - wall(phi))
        down = RA2 * np.cos(aA2 + phi) - RAD * np.sin(fAD) - R3D * np.cos(a3D - wall(phi))
        return -a23 + np.arctan2(aside, down)

    def V(phi):  # 6.81
        over = W2 * (RA2 * np.cos(aA2 + phi) - R2 * np.cos(a2 + half(phi)))
        return W1 * R1 * np.cos(a1 + phi) + over + W3 * (R3 * np.cos(a3 - wall(phi)) + RAD * np.sin(fAD))

    f23, f4 = slope(half, ROTATION), slope(wall, ROTATION)
    crossed = 2 * RA2 * R2 * np.cos(ROTATION + aA2 + half(ROTATION) + a2) * f23
    I = (  # 6.80, 6.86  # noqa: E741
        I1 + W1 / g * R1**2 + I2 * f23**2 + (I3 + W3 / g * R3**2) * f4**2
        + W2 / g * (RA2**2 + R2**2 * f23**2 + crossed)
    )  # fmt: skip
    over = W2 * (RA2 * np.cos(aA2 + ROTATION) + R2 * np.cos(a2 + half(ROTATION)) * f23)
    excitation = W1 * R1 * np.cos(a1 + ROTATION) + over + W3 * R3 * np.cos(a3 - wall(ROTATION)) * f4  # 6.82, times g
    work = virtual_work(Chain(VAULT, (A, B, C, D)), ROTATION)
    same(work.inertia, I)
    same(work.weight, slope(V, ROTATION))
    same(work.excitation, excitation / g)
    assert (f23 > 0).all()  # as the figure has it
    assert (f4 > 0).all()
