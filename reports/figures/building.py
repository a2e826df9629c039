"""All bodies of a project in space, each once, with the part that each mechanism moves."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Literal

import numpy as np

from assess.codes.verdict.outcome import Decision, worst
from assess.geometry.simplify import simplify
from assess.results import MechanismResult, Results, View
from reports.figures.common_ground import are_one_in_the_other
from reports.figures.projection import eye_of
from reports.figures.region import NEAR, Region, cuts, middle_of, region_of
from reports.figures.solids import Surface, body_numbers, box_of, cut, weld
from reports.titles import mechanism_number
from spectra.arrays import FloatArray, IntArray

Outcome = Literal["pass", "fail", "incomplete"]
MOST_TRIANGLES = 1000  # of a body
BESIDE, MOST = 0.3, 8  # bodies drawn apart: the gap, of the widest, and how many stand in a row


@dataclass(frozen=True)
class Moving:
    """The part of the masonry that a mechanism moves; several mechanisms may move the same.

    names : of the mechanisms; title : their numbers, "M1, M2"
    group : of bodies that hang together by shared ones, from 0
    triangles : of the surface, all that move; middle : of the part that no smaller one has [3] [m]
    direction : horizontal, of its motion [3]
    hinges : ends of the axes of rotation [2, 3] [m]; cracks : closed rings [k, 3] [m]
    """

    names: tuple[str, ...]
    title: str
    group: int
    outcome: Outcome
    triangles: IntArray
    middle: FloatArray
    direction: FloatArray
    hinges: tuple[FloatArray, ...]
    cracks: tuple[FloatArray, ...]


@dataclass(frozen=True)
class Building:
    """All bodies.

    owner : place in `moving` of the part that each triangle [m] belongs to, -1 for what no mechanism moves
    group : of bodies that each triangle [m] belongs to
    apart : whether bodies that the project places one in the other are drawn side by side
    direction : horizontal, of motion, towards which the picture looks best [3]
    """

    surface: Surface
    owner: IntArray
    group: IntArray
    moving: tuple[Moving, ...]
    apart: bool
    direction: FloatArray


@dataclass(frozen=True)
class _Group:
    """Mechanisms whose bodies hang together by a shared one, and their bodies, coarse and cut."""

    surface: Surface
    owner: IntArray
    moving: tuple[Moving, ...]

    def shift(self, by: FloatArray) -> _Group:
        """Return the group shifted by a vector [3] [m]."""
        moving = tuple(
            replace(
                each,
                middle=each.middle + by,
                hinges=tuple(line + by for line in each.hinges),
                cracks=tuple(ring + by for ring in each.cracks),
            )
            for each in self.moving
        )
        return _Group(Surface(self.surface.vertices + by, self.surface.triangles), self.owner, moving)


def building_of(results: Results) -> Building | None:
    """Return the bodies of all mechanisms; None where none has geometry."""
    seen = [each for each in results.mechanisms if each.view is not None and each.view.triangles]
    if not seen:
        return None
    groups = [_group(results, mechanisms, place) for place, mechanisms in enumerate(_sharing(results, seen))]
    directions = [np.array(each.view.direction) for each in seen if each.view is not None]
    direction = max(directions, key=lambda one: sum(abs(float(one @ other)) for other in directions))
    apart = any(are_one_in_the_other(one.surface, other.surface) for one, other in combinations(groups, 2))
    placed = list(_side_by_side(groups, direction)) if apart else groups
    return _joined(placed, apart=apart, direction=direction)


def _joined(groups: Sequence[_Group], *, apart: bool, direction: FloatArray) -> Building:
    triangles, owners, moving, start, first, before = [], [], [], 0, 0, 0
    for group in groups:
        moving += [replace(each, triangles=each.triangles + before) for each in group.moving]
        before += len(group.owner)
        triangles.append(group.surface.triangles + start)
        owners.append(np.where(group.owner < 0, -1, group.owner + first))
        start, first = start + len(group.surface.vertices), first + len(group.moving)
    surface = Surface(np.concatenate([group.surface.vertices for group in groups]), np.concatenate(triangles))
    kept = np.repeat(np.arange(len(groups)), [len(group.owner) for group in groups])
    return Building(surface, np.concatenate(owners), kept, tuple(moving), apart, direction)


def moved_by(building: Building, place: int) -> Building:
    """Return the building with all that one mechanism moves as its own, and nothing as others'.

    Where bodies have no common position, only the group of bodies that it belongs to.
    """
    moving = building.moving[place]
    owner = np.full(len(building.owner), -1)
    owner[moving.triangles] = place
    kept = (building.group == moving.group) | (not building.apart)
    surface = Surface(building.surface.vertices, building.surface.triangles[kept])
    return replace(building, surface=surface, owner=owner[kept], group=building.group[kept])


def _sharing(results: Results, seen: Sequence[MechanismResult]) -> list[list[MechanismResult]]:
    """Return the mechanisms in groups that are connected by shared bodies."""
    groups: list[tuple[set[str], list[MechanismResult]]] = []
    for mechanism in seen:
        bodies = set(bodies_of(results, mechanism.name))
        touched = [group for group in groups if group[0] & bodies]
        rest = [group for group in groups if not group[0] & bodies]
        merged = [each for group in touched for each in group[1]]
        groups = [*rest, (bodies.union(*(group[0] for group in touched)), [*merged, mechanism])]
    order = {each.name: place for place, each in enumerate(seen)}
    return sorted((group[1] for group in groups), key=lambda group: order[group[0].name])


def bodies_of(results: Results, mechanism: str) -> tuple[str, ...]:
    """Return the names of the bodies of a mechanism as the project gives them; its own name where it gives none."""
    found = results.project.get(f"mechanisms.{mechanism}.blocks")
    return tuple(_flat(found.value)) if found is not None else (f"mechanism {mechanism}",)


def _flat(value: object) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, Iterable):
        for each in value:
            yield from _flat(each)


def _group(results: Results, mechanisms: Sequence[MechanismResult], number: int) -> _Group:
    """Return the bodies of the mechanisms, each once, cut where they crack, with the parts that move."""
    views = [(each, each.view) for each in mechanisms if each.view is not None]
    corners = np.concatenate(list(_distinct([view for _, view in views])))
    regions = sorted((region_of(each, view) for each, view in views), key=lambda region: region.volume)
    for plane in cuts(regions):
        corners = cut(corners, plane)
    surface = weld(corners)
    alike: list[list[Region]] = []
    for region in regions:
        same = next((group for group in alike if group[0].is_like(region)), None)
        if same is None:
            alike.append([region])
        else:
            same.append(region)
    middles = surface.corners.mean(axis=1)
    owner = np.full(len(middles), -1)
    for place, group in enumerate(alike):
        owner[(owner < 0) & group[0].holds(middles)] = place
    moving = tuple(
        replace(
            _moving(results, group, number),
            middle=middle_of(surface.corners[owner == place], group[0].box),
            triangles=np.flatnonzero(group[0].holds(middles)),
        )
        for place, group in enumerate(alike)
    )
    return _Group(surface, owner, moving)


def _distinct(views: Sequence[View]) -> Iterator[FloatArray]:
    """Yield the connected bodies [m, 3, 3] of the views, largest view first, without those inside one before."""
    boxes: list[FloatArray] = []
    for view in sorted(views, key=lambda view: (-float(np.prod(view.size)), len(view.sections))):
        surface = Surface(np.array(view.vertices), np.array(view.triangles))
        before = tuple(boxes)
        for body in range(int((found := body_numbers(surface)).max()) + 1):
            part = surface.corners[found == body]
            box, slack = box_of(part.reshape(-1, 3)), NEAR * float(max(view.size))
            if any((box[0] >= other[0] - slack).all() and (box[1] <= other[1] + slack).all() for other in before):
                continue
            boxes.append(box)
            yield _coarse(part)


def _coarse(corners: FloatArray) -> FloatArray:
    """Return the triangles of a body, fewer where it is a scan: the picture is small."""
    surface = weld(corners)
    vertices, triangles = simplify(surface.vertices, surface.triangles, limit=MOST_TRIANGLES)
    return np.asarray(vertices[triangles])


def _moving(results: Results, alike: Sequence[Region], group: int) -> Moving:
    names = tuple(region.mechanism.name for region in alike)
    view = alike[0].view
    return Moving(
        names,
        ", ".join(sorted((mechanism_number(results, name) for name in names), key=lambda number: int(number[1:]))),
        group,
        _outcome(results, names),
        np.arange(0),
        alike[0].box.mean(axis=0),
        np.array(view.direction),
        tuple(np.array(axis.ends) for axis in view.axes),
        tuple(np.array(ring) for ring in view.sections),
    )


def _outcome(results: Results, names: Sequence[str]) -> Outcome:
    """Return the worst verdict of the mechanisms; incomplete where there is none."""
    verdicts = () if results.verdict is None else results.verdict.mechanisms
    found = [each.outcome for each in verdicts if each.mechanism in names]
    return (worst(found) if found else Decision.INCOMPLETE).value


def _side_by_side(groups: Sequence[_Group], direction: FloatArray) -> Iterator[_Group]:
    """Yield the groups moved apart from left to right as they are looked at, in rows one below the other."""
    across, _, towards = eye_of(direction)
    back = towards * [1.0, 1.0, 0.0] / float(np.hypot(*towards[:2]))
    boxes = [box_of(group.surface.vertices) for group in groups]
    reach = [group.surface.vertices @ across for group in groups]
    wide, tall = max(float(np.ptp(each)) for each in reach), max(float(box[1, 2] - box[0, 2]) for box in boxes)
    for place, (group, box, along) in enumerate(zip(groups, boxes, reach, strict=True)):
        row, column = divmod(place, MOST)
        step = column * (1.0 + BESIDE) * wide - float(along.min())
        lift = -box[0, 2] - row * (1.0 + 2 * BESIDE) * tall
        yield group.shift(step * across - float(box.mean(axis=0) @ back) * back + np.array([0.0, 0.0, lift]))
