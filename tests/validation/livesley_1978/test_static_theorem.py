"""Livesley 1978, IJNME 12:1853: limit analysis of blocks as a linear programme over the forces in their joints.

Static theorem: the multiplier at which an arch starts to move is the largest one for which forces in all joints balance
every voussoir, none of them in tension and none outside its joint (Heyman 1966). The program searches mechanisms
instead, the kinematic theorem: both must agree. No sliding: the force along a joint is free.
"""

from __future__ import annotations

from itertools import pairwise
from math import cos, pi, radians, sin

import numpy as np
import pytest
from scipy.optimize import linprog

from assess.errors import MechanismError
from assess.mechanisms.arch import weakest_hinges
from assess.mechanisms.chain import Block
from assess.mechanisms.statics import incipient_motion
from assess.project.build import build
from assess.project.schema import load


def largest_multiplier(voussoirs, joints):
    """The programme: two compressions at the ends of each joint, one force along it, and the multiplier."""
    count, size = len(voussoirs), 3 * len(joints) + 1
    rows, right = np.zeros((3 * count, size)), np.zeros(3 * count)
    total = sum(each.mass for each in voussoirs)
    for number, (a, b) in enumerate(np.array(joints)):
        along = (b - a) / np.hypot(*(b - a))
        onward = np.array([along[1], -along[0]])
        before, after = (voussoirs[k].centroid if 0 <= k < count else None for k in (number - 1, number))
        way = np.subtract(after, (a + b) / 2) if after is not None else np.subtract((a + b) / 2, before)
        onward = onward * np.sign(onward @ way)  # from the voussoir before to the one after
        for column, (point, force) in enumerate(((a, onward), (b, onward), (a, along))):
            acts = np.array([*force, point[0] * force[1] - point[1] * force[0]])
            if after is not None:
                rows[3 * number : 3 * number + 3, 3 * number + column] = acts
            if before is not None:
                rows[3 * number - 3 : 3 * number, 3 * number + column] = -acts
    for number, each in enumerate(voussoirs):
        (x, z), weight = each.centroid, each.mass / total
        rows[3 * number : 3 * number + 3, -1] = [weight, 0.0, -z * weight]
        right[3 * number : 3 * number + 3] = [0.0, weight, x * weight]
    bounds = [(0, None), (0, None), (None, None)] * len(joints) + [(0, None)]
    found = linprog(-np.eye(size)[-1], A_eq=rows, b_eq=right, bounds=bounds, method="highs")
    assert found.status in (0, 2), found.message
    return float(found.x[-1]) if found.status == 0 else None  # 2: nothing balances it, not even at rest


def pointed(inner, outer, angles):
    """Quadrilateral voussoirs between rays at angles from the left, with radii of both faces at each joint."""
    joints = [
        ((r * cos(a), r * sin(a)), (s * cos(a), s * sin(a)))
        for r, s, a in zip(inner, outer, angles, strict=True)
    ]  # fmt: skip
    return [quadrilateral(*a, *b) for a, b in pairwise(joints)], joints


def quadrilateral(a, b, c, d, density=2000.0):
    """Mass and centroid of the polygon a b d c, per metre."""
    ring = np.array([a, b, d, c, a])
    cross = ring[:-1, 0] * ring[1:, 1] - ring[1:, 0] * ring[:-1, 1]
    centre = (ring[:-1] + ring[1:]).T @ cross / (3 * cross.sum())
    return Block(abs(cross.sum()) / 2 * density, (float(centre[0]), float(centre[1])), 1.0)


def ring(count, *, thickness=0.15, opening=157.5):
    angles = pi / 2 + radians(opening) * np.linspace(0.5, -0.5, count + 1)
    return pointed(np.full(count + 1, 10 - 5 * thickness), np.full(count + 1, 10 + 5 * thickness), angles)


def lopsided(seed, count=9):
    """An arch of uneven thickness, joints, springings and rise, leaning on one side."""
    rng = np.random.default_rng(seed)
    angles = np.linspace(pi * rng.uniform(0.8, 0.97), pi * rng.uniform(0.05, 0.25), count + 1)
    angles[1:-1] += rng.uniform(-0.3, 0.3, count - 1) * (angles[1] - angles[0])
    inner = 4.0 * (1 + 0.15 * rng.uniform(-1, 1) * np.cos(angles) + 0.1 * np.sin(angles))
    return pointed(inner, inner + rng.uniform(0.9, 1.6, count + 1), angles)


def filled(count=10):
    """A ring whose voussoirs carry fill: heavier to the springings, their centroids moved."""
    voussoirs, joints = ring(count, thickness=0.12)
    return [
        Block(each.mass * (1 + 0.2 * abs(each.centroid[0])), (each.centroid[0], each.centroid[1] + 0.3), 1.0)
        for each in voussoirs
    ], joints


ARCHES = {
    "7 voussoirs": ring(7),
    "16 voussoirs": ring(16),
    "thick": ring(12, thickness=0.3),
    "shallow": ring(9, opening=100),
    "semicircle": ring(11, thickness=0.18, opening=180),
    "filled": filled(),
    "stilted": pointed([5, 4.2, 4, 4, 4, 4.2, 6.0], [6, 5.2, 5, 5, 5, 5.3, 7.4], np.linspace(pi - 0.1, 0.2, 7)),
    **{f"lopsided {seed}": lopsided(seed) for seed in range(12)},
}


@pytest.mark.parametrize(("voussoirs", "joints"), ARCHES.values(), ids=ARCHES)
def test_least_mechanism_is_the_largest_balanced_multiplier(voussoirs, joints):
    expected = largest_multiplier(voussoirs, joints)
    assert expected > 0.01
    assert weakest_hinges(voussoirs, joints, name="arch").multiplier == pytest.approx(expected, rel=1e-9)


def test_the_other_way_too():
    """Pushed to the left: the programme on the mirror image."""
    for seed in range(6):
        voussoirs, joints = lopsided(seed)
        image = [Block(each.mass, (-each.centroid[0], each.centroid[1]), 1.0) for each in voussoirs[::-1]]
        turned = [tuple((-x, z) for x, z in joint) for joint in joints[::-1]]
        expected = largest_multiplier(image, turned)
        assert weakest_hinges(image, turned, name="arch").multiplier == pytest.approx(expected, rel=1e-9)
        assert abs(expected / largest_multiplier(voussoirs, joints) - 1) > 1e-3


@pytest.mark.parametrize("thickness", [0.02, 0.07, 0.1])
def test_an_arch_that_does_not_stand_is_refused(thickness):
    """Semicircles below 0.1075 R fall by their own weight (Heyman 1966): no forces balance them at multiplier 0."""
    voussoirs, joints = ring(24, thickness=thickness, opening=180)
    assert largest_multiplier(voussoirs, joints) is None
    with pytest.raises(MechanismError, match='"arch": already falling: its own weight opens joints'):
        weakest_hinges(voussoirs, joints, name="arch")


def test_an_arch_that_barely_stands():
    """A little above 0.1075 R; many joints, as with few of them it stands thinner."""
    voussoirs, joints = ring(48, thickness=0.109, opening=180)
    expected = largest_multiplier(voussoirs, joints)
    assert 0.0 < expected < 0.01
    assert weakest_hinges(voussoirs, joints, name="arch").multiplier == pytest.approx(expected, rel=1e-7)


def test_arch_of_a_project_beside_the_programme_on_its_profile(tmp_path):
    """Straight sides between the joints, which are given one by one: the voussoirs are those of the programme."""
    voussoirs, joints = lopsided(3)
    outline = [b for _, b in joints] + [a for a, _ in joints[::-1]]
    lines = ", ".join(f"[{list(map(float, a))}, {list(map(float, b))}]" for a, b in joints)
    (tmp_path / "project.toml").write_text(f"""
[materials.m]
density = 2000
[bodies.arch]
material = "m"
length = 1.0
profile = {[[float(x), float(z)] for x, z in outline]!r}
[mechanisms.arch]
kind = "four-hinge"
blocks = ["arch"]
hinges = "minimum"
restitution = 0.8
joints = [{lines}]
""")
    (mechanism,) = build(load(tmp_path)).mechanisms
    assert incipient_motion(mechanism.positive).multiplier == pytest.approx(
        largest_multiplier(voussoirs, joints), rel=1e-9
    )
    image = [Block(each.mass, (-each.centroid[0], each.centroid[1]), 1.0) for each in voussoirs[::-1]]
    turned = [tuple((-x, z) for x, z in joint) for joint in joints[::-1]]
    assert incipient_motion(mechanism.negative).multiplier == pytest.approx(largest_multiplier(image, turned), rel=1e-9)
