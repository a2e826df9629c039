"""Height and thickness of the wall that a mechanism is of, for the clauses that judge walls by them."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise

from assess.codes.context import Support, Wall
from assess.geometry.outline import Outline
from assess.mechanisms.chain import Point
from assess.mechanisms.mechanism import Mechanism

SUPPORTS: Mapping[str, Support] = {
    "single-block": "free",
    "equivalent-block": "free",
    "two-block": "spanning",
    "four-hinge": "hinged",
}
JUST_ABOVE = 1e-3  # of the height: where the thickness of a wall that rocks to one side is measured


def wall_of(mechanism: Mechanism) -> Wall | None:
    """The wall across its plane; None for what is no wall, or has no geometry that tells its size.

    The height goes from the base hinge to the hinge at the top, or to the top of what stands free. The thickness is
    the distance along the direction between the hinges of both branches, at the base or the crack; of a wall that rocks
    to one side only, the width of its outline just above.
    """
    hinges = mechanism.positive.hinges
    if mechanism.kind == "two-block":
        return _wall(mechanism, height=hinges[2][1] - hinges[0][1], at=1)
    if mechanism.kind != "single-block" or not mechanism.outlines[0]:
        return None
    top = max(z for ring in mechanism.outlines[0] for _, z in ring)
    return _wall(mechanism, height=top - hinges[0][1], at=0)


def _wall(mechanism: Mechanism, *, height: float, at: int) -> Wall | None:
    hinge = mechanism.positive.hinges[at]
    if mechanism.negative is not None:
        thickness = abs(hinge[0] + mechanism.negative.hinges[at][0])  # the negative chain is mirrored
    else:
        thickness = _width(mechanism.outlines[at], hinge[1] + JUST_ABOVE * height)
    return Wall(height, thickness) if height > 0.0 and thickness > 0.0 else None


def _width(rings: Outline, level: float) -> float:
    """Extent along x of closed rings at an elevation [m]; 0 where they do not reach it."""
    crossed = [x for ring in rings for a, b in pairwise(ring) for x in _crossing(a, b, level)]
    return max(crossed) - min(crossed) if crossed else 0.0


def _crossing(a: Point, b: Point, level: float) -> list[float]:
    if (a[1] - level) * (b[1] - level) > 0.0 or a[1] == b[1]:
        return []
    return [a[0] + (b[0] - a[0]) * (level - a[1]) / (b[1] - a[1])]
