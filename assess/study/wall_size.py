"""The wall that a mechanism is part of: its size and gravity moments, for the clauses on walls."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import pairwise

import numpy as np
from scipy.constants import g

from assess.codes.check import BranchName
from assess.codes.context import Gravity, Support, Wall
from assess.geometry.outline import Outline
from assess.loads.load import Force, Load, PointMass, upward
from assess.mechanisms.chain import Chain, Point
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.virtual_work import virtual_work

SUPPORTS: Mapping[str, Support] = {
    "single-block": "free",
    "equivalent-block": "free",
    "two-block": "spanning",
    "four-hinge": "hinged",
}
JUST_ABOVE = 1e-3  # of the height: where the thickness of a wall that rocks to one side is measured


def wall_of(mechanism: Mechanism) -> Wall | None:
    """Return the wall across its plane; None for mechanisms that are not walls, or without geometry.

    The height is from the base hinge to the hinge at the top, or to the top of a free-standing wall. The thickness is
    the distance along the direction between the hinges of both branches, at the base or the crack; of a wall that rocks
    to one side only, the width of its outline just above.
    """
    hinges = mechanism.positive.hinges
    if mechanism.kind == "two-block":
        size = _wall(mechanism, height=hinges[2][1] - hinges[0][1], at=1)
        return None if size is None else replace(size, gravity=gravity_of(mechanism))
    if mechanism.kind != "single-block" or not mechanism.outlines[0]:
        return None
    top = max(z for ring in mechanism.outlines[0] for _, z in ring)
    return _wall(mechanism, height=top - hinges[0][1], at=0)


def carries_floors(mechanism: Mechanism) -> bool:
    """Return whether a floor, roof or vault presses on a mechanism or moves with it, bearing or not."""
    return any(isinstance(load, PointMass) or upward(load) < 0.0 for load in mechanism.positive.loads)


def gravity_of(mechanism: Mechanism) -> Mapping[BranchName, Gravity]:
    """Return the gravity moments of a wall and of the loads that press on it, by branch."""
    rocker = mechanism.variants.deciding
    found: dict[BranchName, Gravity] = {"positive": _gravity(mechanism.positive, rocker.positive.unstable)}
    if mechanism.negative is not None and rocker.negative is not None:
        found["negative"] = _gravity(mechanism.negative, rocker.negative.unstable)
    return found


def _gravity(chain: Chain, instability: float) -> Gravity:
    """Return the gravity moments of one branch, whose restoring moment falls to zero at `instability` [rad].

    Bearing masses and the vertical part of applied forces press; ties and horizontal forces are ignored.
    """
    pressing = tuple(pressed for load in chain.loads if (pressed := _pressing(load)) is not None)
    at = np.array([0.0, instability])
    own = virtual_work(replace(chain, loads=(), joints=()), at)
    both = virtual_work(replace(chain, loads=pressing, joints=()), at)
    weight = g * sum(block.mass for block in chain.blocks)
    return Gravity(
        overburden_ratio=sum(-upward(load) for load in pressing) / weight,
        own_moment=float(own.restoring[0]),
        moment=float(both.restoring[0] - own.restoring[0]),
        own_slope=float(own.restoring[0] - own.restoring[1]) / instability,
        own_inertia=float(own.inertia[0]),
        inertia=float(both.inertia[0] - own.inertia[0]),
        own_excitation=float(own.excitation[0]),
    )


def _pressing(load: Load) -> Load | None:
    """Return the part of a load that presses on the wall; None if there is none."""
    if upward(load) >= 0.0 or not isinstance(load, PointMass | Force):
        return None
    return load if isinstance(load, PointMass) else replace(load, force=(0.0, load.force[1]))


def _wall(mechanism: Mechanism, *, height: float, at: int) -> Wall | None:
    hinge = mechanism.positive.hinges[at]
    if mechanism.negative is not None:
        thickness = abs(hinge[0] + mechanism.negative.hinges[at][0])  # the negative chain is mirrored
    else:
        thickness = _width(mechanism.outlines[at], hinge[1] + JUST_ABOVE * height)
    return Wall(height, thickness) if height > 0.0 and thickness > 0.0 else None


def _width(rings: Outline, level: float) -> float:
    """Return the extent along x of closed rings at an elevation [m]; 0 if they do not reach it."""
    crossed = [x for ring in rings for a, b in pairwise(ring) for x in _crossing(a, b, level)]
    return max(crossed) - min(crossed) if crossed else 0.0


def _crossing(a: Point, b: Point, level: float) -> list[float]:
    if (a[1] - level) * (b[1] - level) > 0.0 or a[1] == b[1]:
        return []
    return [a[0] + (b[0] - a[0]) * (level - a[1]) / (b[1] - a[1])]
