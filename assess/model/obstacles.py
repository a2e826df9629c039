"""Bodies beside a mechanism that would stop its motion: return walls, a building behind, a buttress."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from assess.geometry.contact import TOLERANCE, Patches, facing_patches
from assess.geometry.solid import Solid
from assess.loads.definitions import bodies_of
from assess.mechanisms.directions import Vector
from assess.model.body import Bodies
from assess.model.definitions import Chained, TwoBlock

FOOT = 0.1  # of the height of the masonry: what touches it lower, as a pavement does, does not stop it
AHEAD = 0.7  # cosine between a touched face and the motion that the contact stops: within 45 degrees
SMALLEST = 0.01  # m2: less contact is a slip of drawing


@dataclass(frozen=True)
class Obstacle:
    """A body that touches the part of a mechanism above its hinge, and the faces of that part which it touches."""

    body: str
    faces: Patches

    def stops(self, way: Vector) -> bool:
        """Return whether it stops a motion towards `way`, a horizontal unit vector."""
        ahead = self.faces.normal @ np.array(way) > AHEAD
        return float(self.faces.area[ahead].sum()) > SMALLEST


def obstacles_of(definition: Chained, standing: Sequence[Solid], bodies: Bodies) -> tuple[Obstacle, ...]:
    """Find the bodies that touch what moves (`standing`), other than those of the mechanism and its loads."""
    low = min(float(solid.vertices[:, 2].min()) for solid in standing)
    high = max(float(solid.vertices[:, 2].max()) for solid in standing)
    foot = low + FOOT * (high - low)
    head = high - FOOT * (high - low) if isinstance(definition, TwoBlock) else np.inf  # held there by what touches
    own = set(definition.bodies)
    own |= {body for load in definition.loads for body in bodies_of(load)}
    others = [each.solid for name, each in bodies.items() if each.solid is not None and name not in own]
    found = ((other, _touched(standing, other, foot=foot, head=head)) for other in others if _near(standing, other))
    return tuple(Obstacle(other.name, faces) for other, faces in found if float(faces.area.sum()) > SMALLEST)


def bodies_that_stop(obstacles: Sequence[Obstacle], way: Vector) -> tuple[str, ...]:
    """Return the bodies that stop a motion towards `way`."""
    return tuple(obstacle.body for obstacle in obstacles if obstacle.stops(way))


def _near(standing: Sequence[Solid], other: Solid) -> bool:
    """Whether the bounding box of a body reaches one of those that move."""
    low, high = other.vertices.min(axis=0) - TOLERANCE, other.vertices.max(axis=0) + TOLERANCE
    return any(
        bool(np.all((solid.vertices.max(axis=0) >= low) & (solid.vertices.min(axis=0) <= high))) for solid in standing
    )


def _touched(standing: Sequence[Solid], other: Solid, *, foot: float, head: float) -> Patches:
    """Return the upright faces of what moves that a body touches between two elevations [m].

    A body drawn in the same place, in another state or simply put at the origin too, is not beside it.
    """
    met = [facing_patches(solid, other) for solid in standing]
    area, centroid, normal = (
        np.concatenate([getattr(each, key) for each in met]) for key in ("area", "centroid", "normal")
    )
    kept = (centroid[:, 2] > foot) & (centroid[:, 2] < head)
    return Patches(area[kept], centroid[kept], normal[kept])
