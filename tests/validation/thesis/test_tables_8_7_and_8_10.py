"""Thesis Tables 8.7 and 8.10 (spectrum rows): the eight walls of Casa Grande on joints of 10 GPa/m and 1 MPa.

The walls are plain boxes with Table 8.2's R0 and slenderness; the thesis' are irregular, its joints rectangles known
only from a figure, its numbers have two digits. All sixteen PGA come out within 6 %.

Rows of Table 8.10 are printed in steps of 0.005, so read from a diagram, over phi_ov on the joint. Those of ASCE 43-05
are reproduced to that; of the Italian code only the one at the allowable rotation, by the reading that makes Table 8.7:
elsewhere the diagram lies higher, and at 0.10 g lower, as if it began at uplift, which that reading does not know.
"""

from __future__ import annotations

from math import cos, sin

import pytest
from scipy.constants import g

from assess.codes.context import Context
from assess.codes.registry import CodeOptions, procedure
from assess.geometry.planar import planar_body_from_values
from assess.interfaces.law import JointLaw
from assess.interfaces.shapes import rectangle
from assess.mechanisms.assembly import add_joints
from assess.mechanisms.joint import Joint
from assess.mechanisms.single_block import single_block
from spectra.asce7 import design_spectrum

DENSITY, JOINT = 2240.0, JointLaw(stiffness=1e10, strength=1e6)  # Table 8.1; 6.89 GPa / 0.69 m is about 10 GPa/m
ASCE, ITALIAN = "asce43-05-spectrum-thesis", "dmi2008-nonlinear-thesis"

# Table 8.2: R0 [m], lambda [rad]; Table 8.7: PGA [g] by ASCE 43-05, rigid and flexible, and the Italian code
WALLS = {
    "W0a": ((2.84, 0.14), (0.68, 0.58), (0.35, 0.30)),
    "W0b": ((0.62, 0.54), (1.43, 1.39), (0.62, 0.60)),
    "W1": ((1.75, 0.25), (0.89, 0.86), (0.49, 0.47)),
    "W2": ((2.88, 0.23), (1.12, 1.00), (0.58, 0.52)),
    "W3": ((2.71, 0.20), (0.96, 0.86), (0.48, 0.43)),
    "W4": ((1.04, 0.34), (1.01, 0.97), (0.50, 0.48)),
    "W5": ((2.72, 0.24), (1.11, 1.01), (0.56, 0.51)),
    "W6": ((1.46, 0.21), (0.70, 0.65), (0.36, 0.34)),
}
EVERY = pytest.mark.parametrize("wall", WALLS)


def box(wall, *, law=JOINT, model="flexible"):
    """The wall as a box, for each metre of its length."""
    radius, slenderness = WALLS[wall][0]
    b, h = 2 * radius * sin(slenderness), 2 * radius * cos(slenderness)
    mass = DENSITY * b * h
    body = planar_body_from_values(mass=mass, centroid=(0.0, h / 2), inertia=mass * (b**2 + h**2) / 12, name=wall)
    rigid = single_block(wall, body, hinge=(b / 2, 0.0), hinge_negative=(-b / 2, 0.0))
    if law is None:
        return rigid.oscillator
    joints = (Joint((-1.0, 0.0), rectangle(b, 1.0), law, model),)
    return add_joints(rigid, joints, joints, restitution=("thesis", "thesis")).oscillator


def answer(name, rocker, *, level=0.3):
    spectrum = design_spectrum(s_ds=0.25 * 2 / 3 * g, s_d1=0.08 * 2 / 3 * g, t_l=6.0, code="asce7-05")  # Table 8.4
    (check,) = procedure(name, CodeOptions())(rocker, Context(spectrum, (level * g,), 0.0, 0.0, None))
    return check


@EVERY
@pytest.mark.parametrize(("name", "column"), [(ASCE, 1), (ITALIAN, 2)])
def test_table_8_7_flexible(wall, name, column):
    assert answer(name, box(wall)).capacity_pga_g == pytest.approx(WALLS[wall][column][1], rel=0.06)


@EVERY
@pytest.mark.parametrize(("name", "column"), [(ASCE, 1), (ITALIAN, 2)])
def test_table_8_7_less_than_rigid_by_what_is_printed(wall, name, column):
    """The ratio of the columns needs no p of an irregular wall: within the rounding of both and 6 %."""
    rigid, flexible = WALLS[wall][column]
    ours = answer(name, box(wall)).capacity_pga_g / answer(name, box(wall, law=None)).capacity_pga_g
    assert ours == pytest.approx(flexible / rigid, rel=0.05)
    assert ours < 1.0


@EVERY
def test_table_8_7_does_not_depend_on_how_inertia_is_taken(wall):
    """Semi-flexible is within 1 % of flexible, where crushing governs."""
    for name in (ASCE, ITALIAN):
        ours, theirs = (answer(name, box(wall, model=model)).capacity_pga_g for model in ("flexible", "semi-flexible"))
        assert theirs == pytest.approx(ours, rel=0.01)


ROWS = {  # Table 8.10: phi / phi_ov at 0.10, 0.20, 0.30 g; None: no rocking
    ("W0a", ASCE): (0.010, 0.060, 0.130),
    ("W6", ASCE): (None, 0.045, 0.100),
    ("W0a", ITALIAN): (0.010, 0.175, 0.400),
    ("W6", ITALIAN): (None, 0.140, 0.310),
}


def over_flexible(wall, name, level):
    rocker = box(wall)
    return answer(name, rocker, level=level).demand / rocker.positive.overturning_flexible


@pytest.mark.parametrize("wall", ["W0a", "W6"])
def test_table_8_10_asce_43(wall):
    for level, printed in zip((0.1, 0.2, 0.3), ROWS[wall, ASCE], strict=True):
        assert over_flexible(wall, ASCE, level) == pytest.approx(printed or 0.0, abs=0.005)


def test_table_8_10_italian_code():
    assert over_flexible("W0a", ITALIAN, 0.3) == pytest.approx(0.400, abs=0.005)
    for wall, level, printed in (("W0a", 0.2, 0.175), ("W6", 0.2, 0.140), ("W6", 0.3, 0.310)):
        found = over_flexible(wall, ITALIAN, level)
        assert 0.01 < printed - found < 0.025  # the difference is the print's, and stated
    assert over_flexible("W0a", ITALIAN, 0.1) > 0.03  # printed 0.010
    assert over_flexible("W6", ITALIAN, 0.1) > 0.02  # printed N/A
