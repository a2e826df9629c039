"""Livesley 1978: arches by the static theorem, a linear programme over the forces in their joints.

The multiplier at which an arch starts to move is the largest one for which forces in all joints balance every voussoir,
none of them in tension and none outside its joint. No sliding: the force along a joint is free.
"""

from __future__ import annotations

from itertools import pairwise
from math import cos, pi, radians, sin

import numpy as np
from scipy.optimize import linprog

from assess.mechanisms.chain import RigidBlock


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
    return RigidBlock(abs(cross.sum()) / 2 * density, (float(centre[0]), float(centre[1])), 1.0)


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
        RigidBlock(each.mass * (1 + 0.2 * abs(each.centroid[0])), (each.centroid[0], each.centroid[1] + 0.3), 1.0)
        for each in voussoirs
    ], joints


def sectors(count, *, radius=10.0, thickness=1.5, opening=157.5):
    """Sectors of a ring, per metre and unit density, from left to right, and their joints from inside to outside."""
    inner, outer, whole = radius - thickness / 2, radius + thickness / 2, radians(opening)
    angles = pi / 2 + np.linspace(whole / 2, -whole / 2, count + 1)
    half = whole / count / 2
    mass = half * (outer**2 - inner**2)
    reach = 2 / 3 * (outer**3 - inner**3) / (outer**2 - inner**2) * sin(half) / half
    polar = half * (outer**4 - inner**4) / 2 - mass * reach**2
    middles = (angles[1:] + angles[:-1]) / 2
    voussoirs = [RigidBlock(mass, (reach * cos(a), reach * sin(a)), polar) for a in middles]
    return voussoirs, [((inner * cos(a), inner * sin(a)), (outer * cos(a), outer * sin(a))) for a in angles]


def mirrored(voussoirs, joints):
    """Return the arch pushed the other way."""
    image = [RigidBlock(each.mass, (-each.centroid[0], each.centroid[1]), 1.0) for each in voussoirs[::-1]]
    return image, [tuple((-x, z) for x, z in joint) for joint in joints[::-1]]


def oppenheim():
    """An arch of 157.5 degrees, R = 10 m, t / R = 0.15, of 7, 8 and 16 voussoirs."""
    return {"uplift multiplier": {f"{n} voussoirs": largest_multiplier(*sectors(n)) for n in (7, 8, 16)}}


def lopsided_arches():
    """Arches without symmetry, pushed to the right and to the left."""
    arches = {f"arch {seed}": lopsided(seed) for seed in (3, 5, 8)}
    return {
        "uplift multiplier, to the right": {name: largest_multiplier(*arch) for name, arch in arches.items()},
        "uplift multiplier, to the left": {name: largest_multiplier(*mirrored(*arch)) for name, arch in arches.items()},
    }


VALUES = {"oppenheim_1992/arch": oppenheim, "livesley_1978/arches": lopsided_arches}
