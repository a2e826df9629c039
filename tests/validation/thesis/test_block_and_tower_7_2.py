"""Thesis 7.2: the block of Fig. 7.1 and the Dharahara tower (Table 7.1), beyond the solved cases of chapter 7.

Table 7.1 contradicts itself: R0 sin alpha0 = 3.795 m, yet the edge is at R_O = 3.99 m. With alpha0 as printed a tower
on a joint has a moment other than zero when upright; asin(R_O / R0) = 0.13146 rad makes it stand.
"""

from __future__ import annotations

from functools import partial
from math import asin, cos, inf, sin

import numpy as np
import pytest
from scipy.constants import g

from assess.errors import MechanismError
from assess.geometry.planar import planar_body_from_values
from assess.interfaces.contact import JointLaw, thresholds
from assess.interfaces.section import annulus
from assess.mechanisms.assembly import add_joints
from assess.mechanisms.chain import Chain, Joint, RigidBlock
from assess.mechanisms.flexible_chain import FlexibleChain
from assess.mechanisms.single_block import single_block
from tests.support.bodies import wall_on_joints

R_O, R_I, W, R_0, ALPHA_0 = 3.99, 2.12, 24003.94e3, 30.44, 0.125  # Table 7.1
CONSISTENT = asin(R_O / R_0)


def tower(law, *, alpha=CONSISTENT):
    """Of unknown inertia about its centroid, which moments do not need: of a slender rod."""
    mass, half, height = W / g, R_0 * sin(alpha), R_0 * cos(alpha)
    body = planar_body_from_values(mass=mass, centroid=(0.0, height), inertia=mass * height**2 / 3, name="tower")
    rigid = single_block("tower", body, hinge=(half, 0.0), hinge_negative=(-half, 0.0))
    joints = (Joint((-1.0, 0.0), annulus(2 * R_O, inner=2 * R_I), law, "flexible"),)
    return add_joints(rigid, joints, joints, restitution=(0.98, 0.98))


block_on = partial(wall_on_joints, 1.0, 6.0, length=2.0, restitution=("thesis", "thesis"))


def test_table_7_1_contradicts_itself():
    assert R_0 * sin(ALPHA_0) == pytest.approx(3.795, abs=5e-4)
    upright = FlexibleChain(tower(JointLaw(1e9, inf)).positive, "t").solve_equilibrium(np.zeros(1)).work.restoring[0]
    assert abs(upright) < 1e-9 * W * R_O
    printed = Chain((RigidBlock(W / g, (0.0, R_0 * cos(ALPHA_0)), 1e9),), ((R_0 * sin(ALPHA_0), 0.0),), joints=(
        Joint((-1.0, 0.0), annulus(2 * R_O, inner=2 * R_I), JointLaw(1e9, inf), "flexible"),))  # fmt: skip
    assert FlexibleChain(printed, "t").solve_equilibrium(np.zeros(1)).work.restoring[0] == pytest.approx(
        -4678e3, rel=1e-3
    )
    with pytest.raises(MechanismError, match="pushed off its rest both ways"):
        _ = tower(JointLaw(1e9, inf), alpha=ALPHA_0).oscillator


def test_figure_7_6_which_joints_of_15_mpa_stay_elastic():
    """The text says those of 85 and 170 MPa/m; the second would just crush before it overturns (errata 6)."""
    section = annulus(2 * R_O, inner=2 * R_I)
    for stiffness in (85e6, 170e6):
        law = JointLaw(stiffness, 15e6)
        crushing = thresholds(section, law, normal_force=W)[1]
        over = tower(law).oscillator.positive.overturning_flexible
        assert (over < crushing) == (stiffness == 85e6)
    first, second = (thresholds(section, JointLaw(k, 15e6), normal_force=W)[1] for k in (170e6, 1700e6))
    assert first == pytest.approx(10 * second, rel=1e-9)  # phi_c goes with 1 / k_n


# ------------------------------------------------------------------- the block b = 1, l = 2, H = 6 m, 1800 kg/m3


def test_figure_7_2_e_capacity_grows_with_stiffness_and_strength():
    by_stiffness = [block_on(JointLaw(k, 1.28e6)).oscillator.positive for k in (85e6, 170e6, 340e6, 680e6, 1350e6)]
    by_strength = [block_on(JointLaw(340e6, f)).oscillator.positive for f in (0.32e6, 0.64e6, 1.28e6)]
    for sides in (by_stiffness, by_strength):
        assert (np.diff([side.restoring.max() for side in sides]) > 0).all()
        assert (np.diff([side.overturning_flexible for side in sides]) > 0).all()
    stronger = block_on(JointLaw(340e6, 2.56e6)).oscillator.positive.restoring.max()
    assert stronger == pytest.approx(by_strength[-1].restoring.max(), rel=1e-4)  # the peak is elastic from 1.28 MPa on
