"""Which parts of a building touch, and what each does with the other: the edges of the structure's graph.

Only parts whose boxes meet are compared. What two upright parts share at a corner belongs to the larger of them, so
that they meet in a face; a floor keeps its built-in end, on whose underside it bears.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from assess.geometry.boolean import intersect, shortest_distance, subtract
from assess.geometry.contact import ContactArea, FacePatches, facing_patches, find_contact
from assess.geometry.solid import Solid
from assess.geometry.surface import volume
from assess.mechanisms.mechanism import Vector
from assess.model.structure import COVERINGS, IN_LINE, Part, PartContact, Relation
from spectra.arrays import FloatArray

REACH = 0.05  # m: faces this near touch; surveyed faces are 20 mm uneven, and so are those they meet
ABOVE = 0.25  # of the lower height of two upright parts: one that begins no farther below the other's top is above it
LEAST_SEAT = 0.05  # m: a covering that overlaps a wall by less than an uneven face does not bear on it
EVEN = 0.1  # of a contact's normal: of two walls end to end the smaller one leans
LEAST_AREA = 0.02  # m2: a smaller contact is a splinter of a corner
TIE_REACH = 0.05  # m: from a bar to what it holds
SANDWICHED = 0.7  # m: the thickest floor between two walls that stand over one another
OVER = 0.3  # of the smaller footprint: walls in line share more of their plans where one stands over the other


@dataclass(frozen=True)
class Contacts:
    """The contacts of parts, and the volume [m3] of each that another part counts already."""

    contacts: tuple[PartContact, ...]
    shared: Mapping[str, float]


def find_contacts(parts: Sequence[Part]) -> Contacts:
    """Find which parts touch.

    Parameters
    ----------
    parts : of a building, with names of their own
    """
    pairs = tuple(_pairs_near(parts))
    trimmed, shared = _count_once(parts, pairs)
    found = [contact for one, other in pairs for contact in _contacts(one, other, trimmed)]
    found += _through_coverings(parts, found)
    return Contacts(tuple(found), shared)


def _pairs_near(parts: Sequence[Part]) -> Iterator[tuple[Part, Part]]:
    """Yield the pairs of parts whose boxes meet within reach, the larger part first."""
    if not parts:
        return
    low, high = (np.array([end(part.solid.vertices, axis=0) for part in parts]) for end in (np.min, np.max))
    low, high = low - REACH / 2.0, high + REACH / 2.0
    tree = shapely.STRtree(shapely.box(low[:, 0], low[:, 1], high[:, 0], high[:, 1]))
    one, other = tree.query(tree.geometries)
    meet = (one < other) & (low[one, 2] <= high[other, 2]) & (low[other, 2] <= high[one, 2])
    for i, j in zip(one[meet].tolist(), other[meet].tolist(), strict=True):
        pair = (parts[i], parts[j])
        yield pair if pair[0].mass >= pair[1].mass else pair[::-1]


def _count_once(
    parts: Sequence[Part], pairs: Sequence[tuple[Part, Part]]
) -> tuple[Mapping[str, Solid], Mapping[str, float]]:
    """Return each part less what larger upright parts count already, and the volumes that others count [m3].

    Coverings and ties are not trimmed: their built-in ends say where they bear.
    """
    larger: dict[str, list[Part]] = {}
    for one, other in pairs:
        if _is_covering(one) and not _is_covering(other):
            one, other = other, one
        met = intersect(one.solid, other.solid)
        if met is not None and met.volume > 0.0:
            larger.setdefault(other.name, []).append(one)
    trimmed = {part.name: part.solid for part in parts}
    shared = {part.name: 0.0 for part in parts}
    for part in parts:
        if part.name not in larger:
            continue
        rest = subtract(part.solid, [each.solid for each in larger[part.name]])
        kept = 0.0 if rest is None else volume(rest.vertices, rest.triangles)
        shared[part.name] = part.volume - kept
        upright = [each.solid for each in larger[part.name] if not _is_covering(each)]
        if rest is not None and upright and _is_upright(part):
            trimmed[part.name] = rest
    return trimmed, shared


def _is_covering(part: Part) -> bool:
    return part.kind in COVERINGS


def _is_upright(part: Part) -> bool:
    return part.kind not in (*COVERINGS, "tie")


def _contacts(one: Part, other: Part, solids: Mapping[str, Solid]) -> Iterator[PartContact]:
    """Return the contact of two parts, none where they do not touch."""
    kinds = (one.kind, other.kind)
    if "tie" in kinds:
        bar, held = (one, other) if one.kind == "tie" else (other, one)
        if held.kind != "tie":
            yield from _tie(bar, held)
    elif _is_covering(one) != _is_covering(other):
        covering, carrier = (one, other) if _is_covering(one) else (other, one)
        yield from _covering(covering, carrier, solids)
    elif _is_upright(one):
        upper, lower = (one, other) if one.base >= other.base else (other, one)
        if upper.base >= lower.top - max(REACH, ABOVE * min(one.height, other.height)):
            yield from _standing(upper, lower, solids)
        else:
            yield from _leaning(one, other, solids)


def _covering(covering: Part, carrier: Part, solids: Mapping[str, Solid]) -> Iterator[PartContact]:
    """Return how a covering meets an upright part: it bears on it, carries it, or leans on it."""
    slab, wall = solids[covering.name], solids[carrier.name]
    above, below = carrier.base >= covering.base - REACH, carrier.base < covering.top - REACH
    bears = find_contact(wall, slab, tolerance=REACH) if below else None
    carries = find_contact(slab, wall, tolerance=REACH) if above else None
    borne, carried = (each.area if each is not None and each.bearing else 0.0 for each in (bears, carries))
    seat = LEAST_SEAT * _shared_length(carrier, slab)
    on_edge = covering.kind == "roof" and borne >= LEAST_AREA and _shared_plan(covering, carrier) >= seat
    if bears is not None and seat > 0.0 and borne >= carried and (borne >= seat or on_edge):
        yield _contact(covering, carrier, "bears-on", bears, gap=0.0)
        return
    if carries is not None and carried >= LEAST_AREA:
        yield _contact(carrier, covering, "stands-on", carries, gap=0.0)
        return
    yield from _facing(covering, carrier, solids)


def _shared_plan(covering: Part, carrier: Part) -> float:
    """Return the area that a roof and what may carry it share in plan [m2]; a slope may bear on an edge alone."""
    plans = [shapely.MultiPoint(part.solid.vertices[:, :2]).convex_hull for part in (covering, carrier)]
    return float(shapely.intersection(plans[0], plans[1]).area)


def _shared_length(carrier: Part, slab: Solid) -> float:
    """Return the length along a wall over which a slab may bear [m]."""
    along = np.array(carrier.along)
    places = [solid.vertices @ along for solid in (carrier.solid, slab)]
    return max(0.0, float(min(each.max() for each in places) - max(each.min() for each in places)))


def _standing(upper: Part, lower: Part, solids: Mapping[str, Solid]) -> Iterator[PartContact]:
    found = find_contact(solids[lower.name], solids[upper.name], tolerance=REACH)
    if found is not None and found.area >= LEAST_AREA:
        relation: Relation = "leans-on" if not found.bearing else "bears-on" if upper.kind == "arch" else "stands-on"
        yield _contact(upper, lower, relation, found, gap=max(0.0, upper.base - lower.top) if found.bearing else 0.0)


def _leaning(one: Part, other: Part, solids: Mapping[str, Solid]) -> Iterator[PartContact]:
    """Return the contact of two upright parts side by side; the first is that whose end meets the second."""
    patches = facing_patches(solids[one.name], solids[other.name], tolerance=REACH)
    if float(patches.area.sum()) < LEAST_AREA:
        return
    normal = np.abs(patches.area @ patches.normal)
    ends = [float(normal @ np.abs(np.array(part.along))) for part in (one, other)]
    first, second = (one, other) if ends[0] > ends[1] + EVEN * float(np.linalg.norm(normal)) else (other, one)
    yield from _facing(first, second, solids)


def _facing(first: Part, second: Part, solids: Mapping[str, Solid]) -> Iterator[PartContact]:
    patches = facing_patches(solids[second.name], solids[first.name], tolerance=REACH)
    area = float(patches.area.sum())
    if area >= LEAST_AREA:
        gap = max(0.0, float(patches.distance.min()))
        yield _contact(first, second, "leans-on", _joined(patches, area), gap=gap)


def _joined(patches: FacePatches, area: float) -> ContactArea:
    normal = patches.area @ patches.normal
    return ContactArea(area, patches.area @ patches.centroid / area, normal / np.linalg.norm(normal), False)


def _tie(bar: Part, held: Part) -> Iterator[PartContact]:
    """Return where a bar holds a part: at its nearer end, or where it passes through."""
    if shortest_distance(bar.solid, held.solid, limit=TIE_REACH) >= TIE_REACH:
        return
    along, corners = np.array(bar.along), bar.solid.vertices
    place = corners @ along
    span = held.solid.vertices @ along
    at = float(np.clip((span.min() + span.max()) / 2.0, place.min(), place.max()))
    middle = corners.mean(axis=0)
    point = middle + (at - float(middle @ along)) * along
    area = bar.thickness * bar.height
    yield _contact(held, bar, "held-by", ContactArea(area, point, along, False), gap=0.0)


def _contact(first: Part, second: Part, relation: Relation, found: ContactArea, *, gap: float) -> PartContact:
    away = float(found.centroid @ np.array(second.normal)) - second.middle
    elevation = float(found.centroid[2])
    at, normal = _vector(found.centroid), _vector(found.normal)
    return PartContact(first.name, second.name, relation, found.area, gap, away, elevation, at, normal)


def _through_coverings(parts: Sequence[Part], found: Sequence[PartContact]) -> Iterator[PartContact]:
    """Return the contacts of walls that stand over one another with a floor between them, as wide as their plans share.

    The gap of such a contact is the floor's thickness.
    """
    by_name = {part.name: part for part in parts}
    carried: dict[str, list[Part]] = {}
    standing: dict[str, list[Part]] = {}
    for each in found:
        first, second = by_name[each.first], by_name[each.second]
        if each.relation == "bears-on" and _is_covering(first):
            carried.setdefault(first.name, []).append(second)
        elif each.relation == "stands-on" and _is_covering(second):
            standing.setdefault(second.name, []).append(first)
    done = {(each.first, each.second) for each in found}
    for name, uppers in standing.items():
        for upper in uppers:
            for lower in carried.get(name, ()):
                gap = upper.base - lower.top
                in_line = abs(float(np.dot(upper.normal, lower.normal))) > IN_LINE
                if (upper.name, lower.name) in done or not in_line or not -REACH <= gap <= SANDWICHED:
                    continue
                plans = [shapely.MultiPoint(part.solid.vertices[:, :2]).convex_hull for part in (upper, lower)]
                shared = shapely.intersection(plans[0], plans[1])
                if shared.area < OVER * min(plan.area for plan in plans):
                    continue
                done.add((upper.name, lower.name))
                x, y = shapely.get_coordinates(shapely.centroid(shared))[0]
                area = ContactArea(float(shared.area), np.array([x, y, upper.base]), np.array([0.0, 0.0, 1.0]), True)
                yield _contact(upper, lower, "stands-on", area, gap=max(0.0, gap))


def _vector(values: FloatArray) -> Vector:
    x, y, z = values.tolist()
    return (x, y, z)
