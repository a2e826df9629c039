"""Thesis 6.55-6.60, 6.66-6.67 and 6.71-6.72: hinges fixed at a_SF, the resultant's place when crushing starts.

For a rectangle a_SF = 2 N / (3 f_m l), whatever the stiffness. N by Tables 6.1 and 6.2.
"""

from __future__ import annotations

from dataclasses import replace
from math import atan2, cos, hypot, sin

import numpy as np
import pytest
from scipy.constants import g

from assess.interfaces.contact import JointLaw
from assess.interfaces.section import rectangle
from assess.loads.load import Force
from assess.mechanisms.assembly import add_joints
from assess.mechanisms.chain import Joint
from assess.mechanisms.flexible_chain import FlexibleChain
from assess.mechanisms.four_hinge import four_hinge
from assess.mechanisms.single_block import single_block
from assess.mechanisms.two_block import two_block
from tests.support.bodies import PORTAL_HINGES, body_of_block, portal_blocks, rectangle_block

F_M, RHO, PHI = 1.28e6, 1800.0, np.array([0.004, 0.02, 0.05])
STIFFNESS = pytest.mark.parametrize("stiffness", [85e6, 340e6, 13500e6])


def bed(way, depth, stiffness):
    return Joint((float(way), 0.0), rectangle(depth, 1.0), JointLaw(stiffness, F_M), "semi-flexible")


def a_SF(N):
    return 2 * N / (3 * F_M)


def polar(along, up):
    return hypot(along, up), atan2(along, up)


@STIFFNESS
def test_single_block_6_55_to_6_60(stiffness):
    block = rectangle_block(-0.5, 0.0, 1.0, 6.0)
    M, I_C = block.mass, block.inertia
    R_0, alpha_0 = polar(0.5, 3.0)
    a = a_SF(M * g)
    R_P = np.sqrt((R_0 * cos(alpha_0)) ** 2 + (R_0 * sin(alpha_0) - a) ** 2)  # 6.57
    alpha_P = np.arccos(R_0 * cos(alpha_0) / R_P)  # 6.58
    I_SF = I_C + M * R_P**2  # 6.56
    eta = 1 - 2 * M * R_P**2 / I_SF * sin(alpha_P) ** 2  # 6.60
    rigid = single_block("w", body_of_block(block), hinge=(0.5, 0.0), hinge_negative=(-0.5, 0.0))
    joints = (bed(-1, 1.0, stiffness),)
    found = add_joints(rigid, joints, joints, restitution=("thesis", "thesis"))
    assert found.restitution == pytest.approx((eta, eta), rel=1e-12)
    assert found.restitution[0] > rigid.restitution[0]
    side = found.oscillator.positive
    np.testing.assert_allclose(side.inertia, I_SF, rtol=1e-12)
    assert side.restitution == found.restitution[0]


@STIFFNESS
def test_two_blocks_6_66_and_6_67(stiffness):
    """The wall of 7.3: 0.4 x 3 m, cracked at 2 m, under twice its weight."""
    blocks = rectangle_block(-0.2, 0.0, 0.4, 2.0), rectangle_block(-0.2, 2.0, 0.4, 1.0)
    (m1, I1), (m2, I2) = ((each.mass, each.inertia) for each in blocks)
    F = 2 * (m1 + m2) * g
    a, b, c = (a_SF(N) for N in (F + (m1 + m2) * g, F + m2 * g, F))  # Table 6.1
    rigid = two_block("w", *map(body_of_block, blocks), hinges=((0.2, 0.0), (-0.2, 2.0), (0.2, 3.0)),
                      hinges_negative=((-0.2, 0.0), (0.2, 2.0), (-0.2, 3.0)))  # fmt: skip
    load = (Force("overburden", (0.0, -F), (0.2, 3.0), 1),)
    rigid = replace(rigid, positive=replace(rigid.positive, loads=load), negative=replace(rigid.negative, loads=load))
    joints = tuple(bed(way, 0.4, stiffness) for way in (-1, 1, -1))
    found = add_joints(rigid, joints, joints, restitution=("thesis", "thesis"))
    fixed = FlexibleChain(found.positive, "w").fixed_hinge_chain.hinges
    np.testing.assert_allclose(fixed, ((0.2 - a, 0.0), (-0.2 + b, 2.0), (0.2 - c, 3.0)), rtol=1e-12)

    (R1, a1), (R12, a12), (R2, a2) = polar(0.2 - a, 1.0), polar(0.4 - a - b, 2.0), polar(0.2 - b, 0.5)
    rate = 2.0  # of the upper block at rest: the ratio of the heights, as the top slides
    rise = m2 * R2 * cos(a2) * (R12 * cos(a12) + R2 * cos(a2)) * rate
    aside = m2 * (R12 * sin(a12) + R2 * sin(a2) * rate) * (R12 * sin(a12) - R2 * sin(a2))
    over = I1 + m1 * (R1 * cos(a1)) ** 2 - m1 * (R1 * sin(a1)) ** 2 - I2 * rate + rise - aside
    eta = over / (I1 + m1 * R1**2 - I2 * rate + rise + aside)  # 6.67
    assert found.restitution == pytest.approx((eta, eta), rel=1e-12)
    assert found.restitution[0] > rigid.restitution[0]

    span, l2 = hypot(0.4 - b - c, 1.0), 0.4 - b - c  # hinge 2 to 3
    phi2 = np.arccos((l2 - R12 * (np.sin(a12) - np.sin(a12 - PHI))) / span) - np.arccos(l2 / span)
    turned = np.arccos(l2 / span) + phi2
    rate = R12 * np.cos(a12 - PHI) / (span * np.sin(turned))
    crossed = np.cos(a12 - PHI + a2 - phi2)
    I_SF = I1 + m1 * R1**2 + I2 * rate**2 + m2 * (R2**2 * rate**2 + R12**2 - 2 * R12 * R2 * crossed * rate)  # 6.66
    np.testing.assert_allclose(FlexibleChain(found.positive, "w").solve_equilibrium(PHI).work.inertia, I_SF, rtol=1e-9)


@STIFFNESS
def test_symmetric_frame_6_71_and_6_72(stiffness):
    blocks, (front, back) = portal_blocks(), PORTAL_HINGES
    (m1, I1), (m2, _), _ = ((each.mass, each.inertia) for each in blocks)
    a, b = a_SF((m1 + m2 / 2) * g), a_SF(m2 / 2 * g)  # Table 6.2
    rigid = four_hinge("p", [body_of_block(each) for each in blocks], hinges=front, hinges_negative=back)
    joints = tuple(bed(way, 0.8, stiffness) for way in (-1, 1, 1, -1))
    found = add_joints(rigid, joints, joints, restitution=("thesis", "thesis"))
    (R1, a1), (R12, a12) = polar(0.4 - a, 2.0), polar(0.8 - a - b, 4.0)
    I_SF = 2 * (I1 + m1 * R1**2 + m2 * R12**2 / 2)  # 6.71
    over = I1 + m1 * R1**2 * (1 - 2 * sin(a1) ** 2) + m2 * R12**2 / 2 * (1 - 2 * sin(a12) ** 2)
    eta = over / (I1 + m1 * R1**2 + m2 * R12**2 / 2)  # 6.72
    assert found.restitution == pytest.approx((eta, eta), rel=1e-12)
    assert found.restitution[0] > rigid.restitution[0]
    np.testing.assert_allclose(FlexibleChain(found.positive, "p").solve_equilibrium(PHI).work.inertia, I_SF, rtol=1e-9)
