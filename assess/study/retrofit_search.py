"""The least layout of works on a grid: all of a small grid, else coarse to fine from three starts.

What a layout reaches need not rise with it: a soft restraint can overturn a wall that stands free, and a thicker bar
may tear its anchor where a thinner one yields. So nothing is bisected; what was not examined is not taken to hold.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import product
from math import inf, prod

import numpy as np

from assess.results.retrofit import Layout, Place, Target, round_off

FULL = 400
"""Layouts of a grid up to which all of them are examined."""
COARSE = 200
STARTS = 3


def merit(layout: Layout, target: Target) -> tuple[float, ...]:
    """Return what the best of layouts has the least of.

    Those worth a proof come first, in the order of the objective, of what they reach and of steel; then those that fall
    short, the nearest first; then those that are refused.
    """
    reached = layout.reached
    if layout.refused is not None or reached is None or reached.value is None:
        return (2.0, inf, inf, inf)
    objective, beyond = round_off(layout.objective), round_off(target.beyond(layout))
    if target.may_hold(reached):
        return (0.0, objective, beyond, layout.steel)
    return (1.0, float(reached.overturned), beyond, objective)


Examine = Callable[[Sequence[Place]], Sequence[Layout]]
"""Examines layouts by their places, in their order."""


def search_grid(sizes: Sequence[int], examine: Examine, target: Target, *, full: int = FULL) -> dict[Place, Layout]:
    """Return the layouts of a grid that were examined, the least of which is that of the grid but for its finest steps.

    Parameters
    ----------
    sizes : number of values on each axis
    examine : examines layouts
    target : what they are to reach
    full : layouts up to which all are examined
    """
    if prod(sizes) <= full:
        every = list(product(*map(range, sizes)))
        return dict(zip(every, examine(every), strict=True))
    most = max(each for each in range(2, max(sizes) + 1) if each == 2 or _coarse_size(sizes, each) <= COARSE)
    axes = [sorted({round(k) for k in np.linspace(0, size - 1, min(size, most))}) for size in sizes]
    coarse = list(product(*axes))
    known = dict(zip(coarse, examine(coarse), strict=True))
    strides = [max(np.diff(axis, prepend=axis[0]).max(), 1) for axis in axes]
    starts = _starts(known, strides, target)
    while True:
        around = [place for start in starts for place in _around(start, strides, sizes) if place not in known]
        new = list(dict.fromkeys(around))
        known |= dict(zip(new, examine(new), strict=True)) if new else {}
        moved = [_best_near(start, strides, sizes, known, target) for start in starts]
        if moved == starts:
            if max(strides) == 1:
                return known
            strides = [max(1, stride // 2) for stride in strides]
        starts = moved


def _coarse_size(sizes: Sequence[int], most: int) -> int:
    return prod(min(size, most) for size in sizes)


def _starts(known: dict[Place, Layout], strides: Sequence[int], target: Target) -> list[Place]:
    """Return the best places of a coarse grid that are no neighbours, as far as there are several."""
    found: list[Place] = []
    for place in sorted(known, key=lambda place: merit(known[place], target)):
        if all(any(abs(a - b) > s for a, b, s in zip(place, other, strides, strict=True)) for other in found):
            found.append(place)
        if len(found) == STARTS:
            break
    return found


def _around(place: Place, strides: Sequence[int], sizes: Sequence[int]) -> Iterator[Place]:
    """Yield the places a stride away along any axes; of many axes along one or two at a time."""
    for steps in product((-1, 0, 1), repeat=len(sizes)):
        if len(sizes) > 3 and sum(map(abs, steps)) > 2:
            continue
        at = tuple(p + step * stride for p, step, stride in zip(place, steps, strides, strict=True))
        if all(0 <= each < size for each, size in zip(at, sizes, strict=True)):
            yield at


def _best_near(
    place: Place, strides: Sequence[int], sizes: Sequence[int], known: dict[Place, Layout], target: Target
) -> Place:
    return min((place, *_around(place, strides, sizes)), key=lambda each: merit(known[each], target))
