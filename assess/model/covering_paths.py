"""Which walls carry a floor or roof: the ways in which its weight may go down, as far as the drawing leaves them open.

Rafters bring a roof to the walls under its eaves, purlins to its gables and cross walls; joists run one way. Where a
covering bears on walls both ways, its weight may go by either, or by both. One that is drawn on walls of one side alone
rests on something else too, which is not drawn: half of it then, or all.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from assess.geometry.contact import ContactArea
from assess.loads.bearing import shares
from assess.model.structure import IN_LINE, Part, PartContact, Structure

ACROSS = 0.34  # cosine: walls whose normals are more than 70 degrees apart are across one another
NO_SHARE = 0.01  # less of a covering is no load
BALANCED = 0.3  # m: half a wall, by which the centroid of a covering lies beside what carries it, in plan


@dataclass(frozen=True)
class LoadPath:
    """One way in which the weight of a covering may go down.

    shares : on each part that carries it, by name [-]
    off : of the centroid of the covering from the resultant of what carries it, in plan [m]
    """

    shares: Mapping[str, float]
    off: float

    def on(self, moved: Mapping[str, float]) -> float:
        """Return the share that some parts carry together, of each as much as moves."""
        return sum(self.shares.get(body, 0.0) * moves for body, moves in moved.items())

    @property
    def half(self) -> LoadPath:
        """The same of half of the weight."""
        return LoadPath({name: share / 2.0 for name, share in self.shares.items()}, self.off)


def load_paths(covering: Part, structure: Structure) -> tuple[LoadPath, ...]:
    """Return the ways in which the weight of a covering may go down: one where the drawing leaves none open.

    Walls of one direction may carry it alone where they stand on both sides of its centroid; where they stand on one
    side, half of it, as something on the other side that it does not bear on as drawn may carry the rest: a gable
    beside a party wall that the purlins enter.
    """
    carried = [each for each in structure.contacts_of(covering.name) if each.first == covering.name]
    bearing = [each for each in carried if each.relation == "bears-on"]
    if not bearing:
        return ()
    whole = _path(bearing, covering)
    if whole.off > BALANCED:
        return whole, whole.half
    normals = [np.array(structure.part(each.second).normal) for each in bearing]
    cosines = [abs(float(normals[0] @ normal)) for normal in normals]
    alone: list[LoadPath] = []
    for group in ([c > IN_LINE for c in cosines], [c < ACROSS for c in cosines]):
        own = [each for each, inside in zip(bearing, group, strict=True) if inside]
        if 0 < len(own) < len(bearing):
            path = _path(own, covering)
            alone.append(path if path.off <= BALANCED else path.half)
    return whole, *alone


def is_drawn_in_part(covering: Part, structure: Structure) -> bool:
    """Return whether a covering rests on something that is not drawn: all that carries it is on one side of it."""
    paths = load_paths(covering, structure)
    return bool(paths) and paths[0].off > BALANCED


def _path(contacts: Sequence[PartContact], covering: Part) -> LoadPath:
    """Return the shares of a covering by statics on some contacts; those that would hold it down have none."""
    at = np.array([each.centroid for each in contacts])
    areas = [
        ContactArea(each.area, place, np.array(each.normal), True) for each, place in zip(contacts, at, strict=True)
    ]
    found = np.maximum(shares(areas, centroid=covering.solid.centroid), 0.0)
    found /= found.sum()
    off = float(np.linalg.norm((found @ at - covering.solid.centroid)[:2]))
    summed: dict[str, float] = {}
    for contact, share in zip(contacts, found.tolist(), strict=True):
        summed[contact.second] = summed.get(contact.second, 0.0) + share
    return LoadPath(summed, off)
