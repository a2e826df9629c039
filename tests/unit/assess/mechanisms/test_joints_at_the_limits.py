"""Mechanisms on joints where rigid ones set no example: forces, unlike hinges, very soft joints, eccentric loads."""

from __future__ import annotations

from dataclasses import replace
from math import sqrt

import numpy as np
import pytest
from scipy.constants import g

from assess.codes.asce43_05 import thesis_limit
from assess.codes.calculation_sheet import multiplier_step
from assess.dynamics.history import Jobs, peaks
from assess.errors import MechanismError
from assess.geometry.planar import planar_body_from_values
from assess.interfaces.contact import JointLaw
from assess.interfaces.section import rectangle
from assess.loads.load import Force, PointMass
from assess.mechanisms.assembly import add_joints
from assess.mechanisms.chain import Joint
from assess.mechanisms.single_block import single_block
from assess.oscillator import linear_multiplier, multiplier
from assess.study.joint_results import interface_curves
from assess.study.mechanism_results import rigid_branches
from records.record import Record
from tests.support.bodies import wall_on_joints

B, H, L, RHO = 1.0, 6.0, 2.0, 1800.0
MASS = B * H * L * RHO
W = MASS * g
STIFF, SOFT = JointLaw(2e8, 1.5e6), JointLaw(4.3e6, float("inf"))


def wall(*, law=STIFF, choice="momentum", **more):
    return wall_on_joints(B, H, law, length=L, restitution=(choice, choice), **more)


def test_a_force_that_takes_half_of_the_resistance_still_has_a_table_up_to_phi_cr():
    """phi_cr of the weights alone lies beyond 1.5 phi_ov."""
    push = Force("F", (0.5 * W * B / 2 / 5.0, 0.0), (0.0, 5.0))
    side = wall(law=JointLaw(1e14, float("inf")), loads=(push,)).oscillator.positive
    assert side.critical > 1.5 * side.unstable
    assert side.critical < side.rotation[-1]
    assert side.unstable == pytest.approx(side.overturning, rel=1e-3)  # as stiff as rigid
    assert side.linearised.critical == side.critical


@pytest.mark.parametrize("model", ["flexible", "semi-flexible"])
def test_an_impact_between_unlike_hinges_keeps_its_share_of_energy(model):
    """Of the energy as much is left as momentum keeps between the edges, whatever inertia the branches begin with."""
    found = wall(model=model, rises=(0.3, -0.3), law=JointLaw(2e8, float("inf")))  # a_SF = 0: hinges at the edges
    x, z, J = B / 2, H / 2, MASS * (B**2 + H**2) / 12
    ahead, behind = J + MASS * (x**2 + (z - 0.3) ** 2), J + MASS * (x**2 + (z + 0.3) ** 2)
    between = J + MASS * (-(x**2) + (z - 0.3) * (z + 0.3))
    share = between / sqrt(ahead * behind)
    first, second = (branch.inertia[0] for branch in found.oscillator.branches)
    alike = np.array(found.restitution) * np.sqrt([second / first, first / second])
    np.testing.assert_allclose(alike, share, rtol=1e-4)
    if model == "flexible":  # about the middle of the joint, both ways
        assert first == pytest.approx(second, rel=1e-4)
        assert not found.warnings


def test_a_given_coefficient_stays_what_it_is():
    assert wall(rises=(0.3, -0.3), choice=0.9).restitution == (0.9, 0.9)


def test_what_resists_does_not_drop_where_a_wall_just_leans_on_its_support():
    """A load off the middle by little gives a threshold at rest; the mechanism still needs the top of its curve."""
    plumb, leaning = (
        wall(sides="one", choice="thesis", loads=(PointMass("m", 3000.0, (at, 5.0), bearing=True),)).oscillator
        for at in (0.0, -0.01)
    )
    assert 0.0 < multiplier(leaning.positive)[0] < 0.01
    assert linear_multiplier(leaning.positive) == pytest.approx(linear_multiplier(plumb.positive), rel=0.02)


def test_the_sheet_says_where_its_multiplier_comes_from():
    side = wall().oscillator.positive
    largest = multiplier_step("λ", "multiplier", "clause", side)
    assert (largest.formula, largest.remark) == ("R_m / (g B_m)", "largest of all points of the table")
    assert largest.value == multiplier(side).max()
    rigid = replace(side, overturning_flexible=None, restoring=side.restoring + 1e4)
    at_rest = multiplier_step("λ", "multiplier", "clause", rigid)
    assert at_rest.formula == "(V'(0) − M) / (g B0)"
    assert at_rest.value == pytest.approx(1e4 / (g * side.excitation[0]), rel=1e-12)
    assert at_rest.substituted.startswith("(10000) /")


def test_the_limit_of_rotation_of_the_thesis_on_a_joint_hardly_stiff_enough_to_stand():
    made = wall(law=SOFT).oscillator
    assert thesis_limit(made.positive, mass=made.mass) == made.positive.unstable


def test_ratios_are_of_rigid_overturning_whatever_the_equation():
    made = wall().oscillator
    time = np.arange(200) * 0.01
    pulse = Record("p", 3.0 * np.sin(np.pi * time), 0.01)
    once = Jobs(np.zeros(1, np.int64), np.zeros(1, np.int64), np.ones(1))
    for equation in ("exact", "linearised"):
        found = peaks([made], [pulse], once, equation=equation)
        side = made.positive if found.max_rotation[0] > 0 else made.negative
        assert found.max_ratio[0] > 0.0
        assert found.max_ratio[0] == pytest.approx(abs(found.max_rotation[0]) / side.overturning, rel=1e-9)


def test_a_wall_that_stands_though_its_fixed_hinge_would_let_it_fall():
    """The centre of all weights lies between the middle of the crushed part at last, and a_SF, 4/3 of it."""
    load = PointMass("m", 15000.0, (0.5, 5.0), bearing=True)
    law = JointLaw(2e9, 4e5)
    arm = B / 2 - 15000.0 * 0.5 / (MASS + 15000.0)
    crushed = (MASS + 15000.0) * g / (law.strength * L) / 2
    assert crushed < arm < 4 / 3 * crushed
    found = wall(loads=(load,), law=law)
    made = found.oscillator
    assert [branch.restoring[0] for branch in made.branches] == [0.0, 0.0]  # at rest, to rounding
    rigid = rigid_branches(found, made)
    shown = interface_curves(found, rigid).fixed_hinges
    assert shown.restoring_n_m[0] == pytest.approx((MASS + 15000.0) * g * (arm - 4 / 3 * crushed), rel=1e-9)


def test_hinges_inside_the_edges_of_their_contact_are_named():
    inertia = MASS * (B**2 + H**2) / 12
    body = planar_body_from_values(mass=MASS, centroid=(0.0, H / 2), inertia=inertia, name="b")
    rigid = single_block("w", body, hinge=(0.4, 0.0), hinge_negative=(-0.4, 0.0), sides="two")
    joint = (Joint((-1.0, 0.0), rectangle(B, L), STIFF, "flexible"),)
    with pytest.raises(MechanismError, match=r"pushed off its rest both ways.*hinge inside the edge of its contact"):
        _ = add_joints(rigid, joint, joint, restitution=("thesis", "thesis")).oscillator
