"""All bodies of a project in space, each once, with the part that each mechanism moves."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Literal

import numpy as np

from assess.codes.verdict.outcome import Decision, worst
from assess.geometry.simplify import simplify
from assess.results import Results, View
from reports.figures.projection import eye_of
from reports.figures.region import NEAR, Region, cuts, region_of
from reports.figures.solids import Surface, are_one_in_the_other, body_numbers, box_of, cut, weld
from reports.titles import mechanism_number
from spectra.arrays import FloatArray, IntArray

Outcome = Literal["pass", "fail", "incomplete"]
MOST_TRIANGLES = 400  # of a body
BESIDE, MOST = 0.3, 8  # bodies drawn apart: the gap, of the widest, and how many stand in a row


@dataclass(frozen=True)
class Moving:
    """The part of the masonry that a mechanism moves; several mechanisms may move the same.

    names : of the mechanisms; title : their numbers, "M1, M2"
    group : of bodies that hang together by shared ones, from 0
    triangles : of the surface, all that move; middle : of their box [3] [m]
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

    @property
    def mechanisms(self) -> frozenset[str]:
        """The names of the mechanisms that are drawn."""
        return frozenset(name for moving in self.moving for name in moving.names)


def building_of(results: Results) -> Building | None:
    """Return the bodies of all mechanisms; None where none has geometry."""
    seen = [(each, each.view) for each in results.mechanisms if each.view is not None and each.view.triangles]
    if not seen:
        return None
    groups = _sharing(results, [region_of(*each) for each in seen])
    surfaces = [_bodies(regions) for regions in groups]
    directions = [np.array(view.direction) for _, view in seen]
    direction = max(directions, key=lambda one: sum(abs(float(one @ other)) for other in directions))
    apart = any(are_one_in_the_other(*pair) for pair in combinations(surfaces, 2))
    steps = _side_by_side(surfaces, direction) if apart else [np.zeros(3)] * len(surfaces)
    moving: list[Moving] = []
    owners: list[IntArray] = []
    for number, (regions, surface, step) in enumerate(zip(groups, surfaces, steps, strict=True)):
        owner, middles = np.full(len(surface.triangles), -1), surface.corners.mean(axis=1)
        for alike in _alike(regions):
            held = alike[0].holds(middles)
            owner[held & (owner < 0)] = len(moving)
            triangles = np.flatnonzero(held) + sum(map(len, owners))
            moving.append(_moving(results, alike, number, triangles, step))
        owners.append(owner)
    group = np.repeat(np.arange(len(groups)), [len(owner) for owner in owners])
    return Building(_joined(surfaces, steps), np.concatenate(owners), group, tuple(moving), apart, direction)


def _joined(surfaces: Sequence[Surface], steps: Sequence[FloatArray]) -> Surface:
    """Return all surfaces as one, each moved by its step [3] [m]."""
    starts = np.cumsum([0, *(len(surface.vertices) for surface in surfaces)])
    vertices = [surface.vertices + step for surface, step in zip(surfaces, steps, strict=True)]
    triangles = [surface.triangles + start for surface, start in zip(surfaces, starts, strict=False)]
    return Surface(np.concatenate(vertices), np.concatenate(triangles))


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


def _sharing(results: Results, regions: Sequence[Region]) -> list[list[Region]]:
    """Return the regions in groups that are connected by shared bodies, each from the smallest on."""
    groups: list[tuple[set[str], list[int]]] = []
    for place, region in enumerate(regions):
        bodies = set(bodies_of(results, region.mechanism.name))
        touched = [group for group in groups if group[0] & bodies]
        rest = [group for group in groups if not group[0] & bodies]
        together = [each for group in touched for each in group[1]]
        groups = [*rest, (bodies.union(*(group[0] for group in touched)), [*together, place])]
    places = sorted((group[1] for group in groups), key=min)
    return [sorted((regions[place] for place in group), key=lambda region: region.volume) for group in places]


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


def _bodies(regions: Sequence[Region]) -> Surface:
    """Return the bodies of mechanisms, each once, cut where they crack."""
    corners = np.concatenate(list(_distinct([region.view for region in regions])))
    for plane in cuts(regions):
        corners = cut(corners, plane)
    return weld(corners)


def _alike(regions: Sequence[Region]) -> list[list[Region]]:
    """Return the regions in groups that are the same to the eye."""
    groups: list[list[Region]] = []
    for region in regions:
        same = next((group for group in groups if group[0].is_like(region)), None)
        if same is None:
            groups.append([region])
        else:
            same.append(region)
    return groups


def _distinct(views: Sequence[View]) -> Iterator[FloatArray]:
    """Yield the connected bodies [m, 3, 3] of the views, largest view first, without those inside one before."""
    boxes: list[FloatArray] = []
    for view in sorted(views, key=lambda view: (-float(np.prod(view.size)), len(view.sections))):
        surface, slack = Surface(np.array(view.vertices), np.array(view.triangles)), NEAR * float(max(view.size))
        found, before = body_numbers(surface), tuple(boxes)
        for body in np.unique(found):
            used, index = np.unique(surface.triangles[found == body], return_inverse=True)
            part = Surface(surface.vertices[used], index.reshape(-1, 3))
            box = box_of(part.vertices)
            if not any((box[0] >= other[0] - slack).all() and (box[1] <= other[1] + slack).all() for other in before):
                boxes.append(box)
                yield _coarse(part)


def _coarse(surface: Surface) -> FloatArray:
    """Return the triangles of a body, fewer where it is a scan: the picture is small."""
    vertices, triangles = simplify(surface.vertices, surface.triangles, limit=MOST_TRIANGLES)
    return np.asarray(vertices[triangles])


def _moving(results: Results, alike: Sequence[Region], group: int, triangles: IntArray, step: FloatArray) -> Moving:
    names, view = tuple(region.mechanism.name for region in alike), alike[0].view
    return Moving(
        names,
        ", ".join(sorted((mechanism_number(results, name) for name in names), key=lambda number: int(number[1:]))),
        group,
        _outcome(results, names),
        triangles,
        alike[0].box.mean(axis=0) + step,
        np.array(view.direction),
        tuple(np.array(axis.ends) + step for axis in view.axes),
        tuple(np.array(ring) + step for ring in view.sections),
    )


def _outcome(results: Results, names: Sequence[str]) -> Outcome:
    """Return the worst verdict of the mechanisms; incomplete where there is none."""
    verdicts = () if results.verdict is None else results.verdict.mechanisms
    found = [each.outcome for each in verdicts if each.mechanism in names]
    return (worst(found) if found else Decision.INCOMPLETE).value


def _side_by_side(surfaces: Sequence[Surface], direction: FloatArray) -> list[FloatArray]:
    """Return the steps that place bodies apart from left to right as they are looked at, in rows one below another."""
    across, _, towards = eye_of(direction)
    back = towards * [1.0, 1.0, 0.0] / float(np.hypot(*towards[:2]))
    boxes = [box_of(surface.vertices) for surface in surfaces]
    reach = [surface.vertices @ across for surface in surfaces]
    wide, tall = max(float(np.ptp(each)) for each in reach), max(float(box[1, 2] - box[0, 2]) for box in boxes)
    steps = []
    for place, (box, along) in enumerate(zip(boxes, reach, strict=True)):
        row, column = divmod(place, MOST)
        step = column * (1.0 + BESIDE) * wide - float(along.min())
        lift = -box[0, 2] - row * (1.0 + 2 * BESIDE) * tall
        steps.append(step * across - float(box.mean(axis=0) @ back) * back + np.array([0.0, 0.0, lift]))
    return steps
