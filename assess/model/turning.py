"""Bodies that turn as one above a crack: by the virtual work of a small turn, without the shape of what moves."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from assess.geometry.cut import Plane, divide
from assess.geometry.planar import base_of_section, lowest_corners
from assess.geometry.solid import Solid
from assess.loads.load import Load, point_in_plane
from assess.mechanisms.chain import Chain, RigidBlock
from assess.mechanisms.mechanism import Vector

NEAR_LEVEL = 0.02  # m: elevations this near are one


@dataclass(frozen=True)
class TurningStack:
    """Bodies that turn as one above a crack, with their loads found once.

    solids : of the bodies, what they share counted once; loads : in the plane of motion
    """

    solids: tuple[Solid, ...]
    loads: tuple[Load, ...]
    direction: Vector

    def above(self, plane: Plane | None) -> Chain:
        """Return what stands above a plane, or all of it, on the edge of its foot; raise GeometryError if none does."""
        along = np.array(self.direction)
        if plane is None:
            foot, standing, kept = lowest_corners(self.solids), self.solids, self.loads
        else:
            parts = divide(self.solids, plane, where="crack")
            foot, standing = parts.foot, parts.above
            kept = tuple(load for load in self.loads if _is_above(load, plane, along))
        hinge = base_of_section(foot, direction=self.direction)[1]
        return Chain((static_block(standing, self.direction),), (hinge,), kept)


def static_block(solids: Sequence[Solid], direction: Sequence[float]) -> RigidBlock:
    """Return solids that move as one as a block for statics: mass and centroid in the plane of motion."""
    masses = np.array([solid.mass for solid in solids])
    centre = masses @ np.array([solid.centroid for solid in solids]) / masses.sum()
    return RigidBlock(float(masses.sum()), point_in_plane(centre.tolist(), direction), 0.0)


def _is_above(load: Load, plane: Plane, along: np.ndarray) -> bool:
    x, z = load.at
    normal = float(plane.normal @ along), float(plane.normal[2])
    return (x - float(plane.point @ along)) * normal[0] + (z - float(plane.point[2])) * normal[1] > NEAR_LEVEL
