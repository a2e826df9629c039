"""Where a mechanism moves masonry: a box, and the planes of its cracks."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from assess.results import MechanismResult, View
from reports.figures.solids import Plane, box_of, plane_of
from spectra.arrays import BoolArray, FloatArray

NEAR = 1e-2  # of a body's size: boxes nearer are one


@dataclass(frozen=True)
class Region:
    """Where a mechanism moves: a box [2, 3] [m], and its sections, each with the side on which all of it lies."""

    mechanism: MechanismResult
    view: View
    box: FloatArray
    sides: tuple[tuple[Plane, float], ...]

    @property
    def slack(self) -> float:
        """The distance [m] within which places are one."""
        return NEAR * float(max(self.view.size))

    @property
    def volume(self) -> float:
        """The volume of its box [m3]."""
        return float(np.prod(np.maximum(self.box[1] - self.box[0], NEAR)))

    def holds(self, points: FloatArray) -> BoolArray:
        """Return whether points [m, 3] lie in it."""
        inside = ((points >= self.box[0] - self.slack) & (points <= self.box[1] + self.slack)).all(axis=1)
        for plane, side in self.sides:
            inside &= side * plane.heights(points) > -1e-6
        return np.asarray(inside)

    def is_like(self, other: Region) -> bool:
        """Return whether two mechanisms move the same part about the same axes."""
        mine, its = (np.array([region.box, *(axis.ends for axis in region.view.axes)]) for region in (self, other))
        return mine.shape == its.shape and np.allclose(mine, its, rtol=0.0, atol=self.slack)


def region_of(mechanism: MechanismResult, view: View) -> Region:
    """Return where a mechanism moves masonry of its view."""
    triangles, moves = np.array(view.triangles), np.array(view.block_of) >= 0
    points = np.array(view.vertices)[np.unique(triangles[moves] if moves.any() else triangles)]
    return Region(mechanism, view, box_of(points), tuple(_sides(points, view)))


def _sides(points: FloatArray, view: View) -> Iterator[tuple[Plane, float]]:
    """Yield the planes of the sections that have all points on one side, and which: 1 for that of the normal."""
    slack = 0.2 * NEAR * float(max(view.size))
    for plane in (plane_of(np.array(ring)) for ring in view.sections):
        heights = plane.heights(points)
        if heights.min() >= -slack or heights.max() <= slack:
            yield plane, 1.0 if heights.min() >= -slack else -1.0


def cuts(regions: Sequence[Region]) -> list[Plane]:
    """Return the planes by which parts that move are divided from the rest: of cracks, or level below a part."""
    upright, lowest = np.array([0.0, 0.0, 1.0]), min(float(region.box[0, 2]) for region in regions)
    rings = dict.fromkeys(ring for region in regions for ring in region.view.sections)
    whole = [region.box[0] for region in regions if not region.view.sections and region.box[0, 2] > lowest + NEAR]
    return [*(plane_of(np.array(ring)) for ring in rings), *(Plane(corner, upright) for corner in whole)]
