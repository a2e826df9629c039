"""Which walls carry a floor or roof: what the drawing leaves open, taken for each mechanism as it is worse.

Rafters bring a roof to the walls under its eaves, purlins to its gables and cross walls; joists run one way. Where a
covering bears on walls both ways, its weight may go by either, or by both. One that is drawn on walls of one side alone
rests on something else too, which is not drawn: half of it then, or all.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from assess.geometry.contact import ContactArea
from assess.loads.bearing import shares
from assess.loads.load import BodyLoad, LoadDefinition, OverburdenLoad
from assess.mechanisms.mechanism import BlockMechanism
from assess.model.least_multipliers import Drawing, Found, built
from assess.model.structure import IN_LINE, Part, PartContact

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

    def on(self, bodies: Sequence[str]) -> float:
        """Return the share that some parts carry together."""
        return sum(self.shares.get(body, 0.0) for body in bodies)


def load_paths(covering: Part, drawing: Drawing) -> tuple[LoadPath, ...]:
    """Return the ways in which the weight of a covering may go down: one where the drawing leaves none open.

    Walls of one direction carry it alone where they stand on both sides of its centroid; else all that it bears on do.
    """
    structure = drawing.structure
    carried = [each for each in structure.contacts_of(covering.name) if each.first == covering.name]
    bearing = [each for each in carried if each.relation == "bears-on"]
    if not bearing:
        return ()
    whole = _path(bearing, covering)
    if whole.off > BALANCED:
        return whole, LoadPath({name: share / 2.0 for name, share in whole.shares.items()}, whole.off)
    normals = [np.array(structure.part(each.second).normal) for each in bearing]
    cosines = [abs(float(normals[0] @ normal)) for normal in normals]
    alone: list[LoadPath] = []
    for group in ([c > IN_LINE for c in cosines], [c < ACROSS for c in cosines]):
        own = [each for each, inside in zip(bearing, group, strict=True) if inside]
        if 1 < len(own) < len(bearing):
            alone += [path for path in (_path(own, covering),) if path.off <= BALANCED]
    return whole, *alone


def is_drawn_in_part(covering: Part, drawing: Drawing) -> bool:
    """Return whether a covering rests on something that is not drawn: all that carries it is on one side of it."""
    paths = load_paths(covering, drawing)
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


def by_worst_paths(found: Found, drawing: Drawing) -> tuple[Found, tuple[str, ...]]:
    """Return a mechanism with each covering on it by the path of its weight that is worst, and the coverings left open.

    Shares are stated, and those of two mechanisms may count one covering twice; one that puts nothing on it is no load.
    What presses on a wall that bends stays as drawn: where nothing does, the wall turns as a cantilever instead.
    """
    definition = found.definition
    if definition is None or found.multiplier is None:
        return found, ()
    loads = [load for load in definition.loads if isinstance(load, BodyLoad | OverburdenLoad)]
    bodies = [body for load in loads for body in ((load.body,) if isinstance(load, BodyLoad) else load.bodies)]
    paths = {body: load_paths(drawing.structure.part(body), drawing) for body in dict.fromkeys(bodies)}
    unsure = tuple(body for body, each in paths.items() if len(each) > 1)
    best = found
    for body in unsure:
        if any(isinstance(load, BodyLoad) and load.body == body for load in loads):
            assert best.definition is not None
            shares_on = sorted({round(path.on(definition.bodies), 3) for path in paths[body]}, reverse=True)
            options = [_with_share(best.definition, body, share) for share in shares_on]
            tried = [built(each, drawing.around(definition), found.parameters) for each in options]
            known = [each for each in tried if each.multiplier is not None]
            worst = min(known, key=lambda each: each.multiplier or 0.0, default=best)
            best = replace(best, definition=worst.definition, multiplier=worst.multiplier)
    return best, unsure


def _with_share(definition: BlockMechanism, body: str, share: float) -> BlockMechanism:
    """Return a mechanism with a share of a covering on it; without it where that is nothing."""
    loads: list[LoadDefinition] = []
    for load in definition.loads:
        if isinstance(load, BodyLoad) and load.body == body:
            loads += [replace(load, share=min(share, 1.0))] if share >= NO_SHARE else []
        else:
            loads.append(load)
    return replace(definition, loads=tuple(loads))
