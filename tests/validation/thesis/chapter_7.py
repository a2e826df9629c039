"""Cases of thesis 7.2.2, 7.3 and 7.4.1: a wall, a storey of a wall that cracks, frames; f_m = 1.28 MPa, 1800 kg/m3.

Dimensions of the frames of 7.4 are only in its Fig. 7.17, a picture: here are other ones.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache, partial
from math import atan2, cos, hypot, sin, sqrt

import numpy as np
from scipy.constants import g

from assess.dynamics.history import peaks, product
from assess.interfaces.contact import JointLaw
from assess.interfaces.section import rectangle
from assess.loads.load import Force
from assess.mechanisms.assembly import add_joints
from assess.mechanisms.chain import Joint
from assess.mechanisms.four_hinge import four_hinge
from assess.mechanisms.single_block import single_block
from assess.mechanisms.two_block import two_block
from tests.support.bodies import PORTAL_HINGES, UNEVEN_HINGES, body_of_block, portal_blocks, rectangle_block
from tests.support.motions import noise

F_M = 1.28e6  # Pa
MODELS = ("flexible", "semi-flexible", "rigid")
STIFFNESSES = (85e6, 170e6, 340e6, 680e6, 1350e6)  # Pa/m, of Fig. 7.3
SLENDERNESSES = (0.12, 0.16, 0.20, 0.24, 0.28)  # rad, of Fig. 7.4
RELEASE = 0.8  # of the slenderness
SEEDS, SCALES = range(16), (1.6, 2.4)  # of the noise that frames are judged by, peak 1 m/s2 times the scale


def standing(rigid, beds, *, stiffness, model):
    """The mechanism on joints [(way, depth, length)], or as it is."""
    if model == "rigid":
        return rigid.oscillator
    joints = tuple(Joint((float(w), 0.0), rectangle(d, n), JointLaw(stiffness, F_M), model) for w, d, n in beds)
    choice = rigid.restitution if rigid.restitution_source == "given" else ("thesis", "thesis")
    return add_joints(rigid, joints, joints, restitution=choice).oscillator


def wall(stiffness, model, *, slenderness=None):
    """1 x 2 x 6 m, or of its radius and another slenderness."""
    radius, alpha = hypot(0.5, 3.0), slenderness or atan2(0.5, 3.0)
    b, h = 2 * radius * sin(alpha), 2 * radius * cos(alpha)
    rigid = single_block(
        "w", body_of_block(rectangle_block(-b / 2, 0.0, b, h, length=2.0)), hinge=(b / 2, 0), hinge_negative=(-b / 2, 0)
    )
    return standing(rigid, [(-1, b, 2.0)], stiffness=stiffness, model=model)


def storey(stiffness, model, *, over=2.0):
    """7.3: 0.4 x 1 x 3 m under `over` times its weight, cracked by 3.27 without tension, the load at the edge."""
    crack = 3.0 * (1 + (over - sqrt((2 + 2 * over) * over)) / (2 + over))
    halves = (
        body_of_block(rectangle_block(-0.2, 0.0, 0.4, crack)),
        body_of_block(rectangle_block(-0.2, crack, 0.4, 3.0 - crack)),
    )
    rigid = two_block("w", *halves, hinges=((0.2, 0.0), (-0.2, crack), (0.2, 3.0)),
                      hinges_negative=((-0.2, 0.0), (0.2, crack), (-0.2, 3.0)))  # fmt: skip
    load = (Force("overburden", (0.0, -over * 1800 * 1.2 * g), (0.2, 3.0), 1),)
    rigid = replace(rigid, positive=replace(rigid.positive, loads=load), negative=replace(rigid.negative, loads=load))
    found = standing(rigid, [(w, 0.4, 1.0) for w in (-1, 1, -1)], stiffness=stiffness, model=model)
    return found, float(np.arctan2(0.4, crack))


@cache
def frame(stiffness, model, *, even=True):
    """Columns of 0.8 x 4 m under a beam, or of two heights on bases at two levels, with 0.90 as in the thesis."""
    blocks, (front, back) = portal_blocks(uneven=not even), PORTAL_HINGES if even else UNEVEN_HINGES
    depths, kept = ((0.8,) * 4, "thesis") if even else ((0.8, 0.8, 1.0, 1.0), 0.90)
    rigid = four_hinge("f", [body_of_block(each) for each in blocks], hinges=front, hinges_negative=back,
                       restitution=(kept, kept))  # fmt: skip
    beds = [(w, d, 1.0) for w, d in zip((-1, 1, 1, -1), depths, strict=True)]
    return standing(rigid, beds, stiffness=stiffness, model=model)


motion = partial(noise, peak=1.0, npts=1200, dt=0.01, smooth=60, bell=1.0)
"""Smoothed noise under a half sine, peak 1 m/s2, by its seed."""


def suites(motions, scales, *, even):
    """Over three stiffnesses and all motions and scales: largest ratios and overturning by both models [2, n]."""
    ratio, over = [], []
    for model in ("flexible", "semi-flexible"):
        rockers = [frame(k, model, even=even) for k in (170e6, 680e6, 2700e6)]
        found = peaks(rockers, motions, product(len(rockers), len(motions), scales), equation="exact", threads=1)
        ratio.append(found.max_ratio)
        over.append(found.overturned)
    return np.array(ratio), np.array(over)
