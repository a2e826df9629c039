"""The mechanisms of towers, spires, arches, portals, bell cells and apses."""

from __future__ import annotations

from functools import partial

import numpy as np

from assess.messages.message import Quantity, note, whole_number
from assess.model.least_multipliers import Drawing, weakest_arch, weakest_crack, weakest_portal
from assess.model.moving_parts import Seed, Seeds, Unexamined, bends, standing_above, ways_to_fall
from assess.model.structure import IN_LINE, PartKind


def shafts(drawing: Drawing, *, kinds: tuple[PartKind, ...]) -> Seeds:
    """Find the towers and spires that can fall above an inclined crack."""
    for part in drawing.structure.of_kind(*kinds):
        low, high = part.base, part.base + 0.6 * part.height
        parts = (part, *(each for each in standing_above((part,), low, drawing) if each is not part))
        find = partial(weakest_crack, parts, ways_to_fall(part, drawing), drawing, low=low, high=high)
        yield Seed(parts, note("reason-shaft", height=Quantity(part.height, "length", 3)), find)


def arches(drawing: Drawing) -> Seeds:
    """Find the arches on two feet."""
    for part in drawing.structure.of_kind("arch"):
        reason = note("reason-arch", span=Quantity(part.length, "length", 3))
        yield Seed((part,), reason, partial(weakest_arch, part, drawing))


def portals(drawing: Drawing, *, on_tower: bool) -> Seeds:
    """Find two piers that carry the same spandrel or arch: a portal, or a belfry where the piers stand on a tower."""
    structure = drawing.structure
    for over in structure.of_kind("spandrel", "arch"):
        piers = [part for part in structure.below(over.name) if part.kind in ("pier", "tower")]
        below = {part.kind for pier in piers for part in structure.below(pier.name)}
        if len(piers) != 2 or ("tower" in below) != on_tower:
            continue
        top = standing_above((over,), over.base, drawing)
        reason = note("reason-portal", over=over.name, one=piers[0].name, other=piers[1].name)
        yield Seed((*piers, *top), reason, partial(weakest_portal, (piers[0], piers[1]), top, drawing))


def bell_cells(drawing: Drawing) -> Seeds:
    """Find the bell cells: a portal on a tower, or two of its walls that carry all walls above them, drawn bonded.

    On more piers than two the cell as a whole is not examined, whatever is found of two of them.
    """
    yield from portals(drawing, on_tower=True)
    structure = drawing.structure
    for tower in structure.of_kind("tower"):
        piers = [part for part in structure.standing_on(tower.name) if part.kind in ("pier", "wall")]
        in_line = len(piers) == 2 and abs(float(np.dot(piers[0].normal, piers[1].normal))) >= IN_LINE
        if not in_line:
            if any(part.kind == "pier" for part in piers):
                yield Unexamined(tower, note("gap-bell-cell", number=whole_number(len(piers))))
            continue
        over = {part.name: part for part in structure.standing_on(piers[0].name)}
        new = list(over.values())
        while new:
            bonded = [(each, part) for part in new for each in structure.contacts_of(part.name)]
            near = {each.other(part.name) for each, part in bonded if each.relation == "bonded-to"}
            new = [structure.part(name) for name in sorted(near - {*over, *(pier.name for pier in piers)})]
            over |= {part.name: part for part in new}
        first, other = ({part.name for part in structure.standing_on(pier.name)} for pier in piers)
        if over and first <= set(over) and other and other <= set(over):
            top = tuple(over.values())
            names = ", ".join(over)
            reason = note("reason-portal", over=names, one=piers[0].name, other=piers[1].name)
            yield Seed((*piers, *top), reason, partial(weakest_portal, (piers[0], piers[1]), top, drawing))


def apses(drawing: Drawing) -> Seeds:
    """Find the walls that bend in plan, which break outwards above an inclined crack."""
    for wall in drawing.structure.of_kind("wall"):
        if bends(wall):
            low, high = wall.base, wall.base + 0.6 * wall.height
            parts = (wall, *(each for each in standing_above((wall,), low, drawing) if each is not wall))
            find = partial(weakest_crack, parts, ways_to_fall(wall, drawing), drawing, low=low, high=high)
            yield Seed(parts, note("reason-apse", length=Quantity(wall.length, "length", 3)), find)
