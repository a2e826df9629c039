"""The key plan: all bodies in space, and the part that each mechanism moves, numbered, in the colour of its verdict.

The same bodies in grey show the place of one mechanism in the building. Each body is drawn once. Where a mechanism
moves masonry is a box and the planes of its cracks; surfaces are cut by these planes, divided into connected bodies,
and compared by the ground they stand on.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from math import radians
from typing import Any, Literal

import numpy as np
import shapely
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from assess.codes.verdict import Decision, worst_outcome
from assess.geometry.surface import simplify
from assess.results import MechanismResult, Results, TieOutcome, View
from reports.document import SpatialModel, Wire
from reports.figures.projection import (
    Appearance,
    Camera,
    Hatching,
    Occluders,
    PictureSize,
    TriangleSurface,
    draw_arrow,
    fit_camera,
    paint_bodies,
    project_faces,
    scene_sheet,
    split_line,
    viewing_frame,
    visible_middle,
)
from reports.figures.sketch import direction_arrow, rounded_points, scene_model
from reports.figures.style import FIXED, HALF, INK, VERDICT, WIDTH, Label, report_style, write_tags
from reports.language.locale import Locale
from reports.language.texts import Paragraph, Phrase, Text, say
from reports.mechanisms import mechanism_number, tie_number
from spectra.arrays import BoolArray, FloatArray, IntArray

KEY_PLAN_SIZE = PictureSize(wide=WIDTH, tall=3.6, left=0.8, around=0.2)
SHARP_ANGLE = radians(40)  # angle between faces from which on their common edge is drawn
LEGEND_HEIGHT = 0.24  # height [in]
HINGE_COLOUR = "#101820"
BESIDE = "#3b6ea5"  # of the edges of bodies of no mechanism
CRACK_DASHES = (0, (2, 1.5))
TIE_COLOURS: Mapping[TieOutcome, str] = {
    "elastic": "#00694c",
    "holds": "#00694c",
    "yields": "#b06a00",
    "gone": "#b3380e",
    "slack": "#6b4c9a",
    "not counted": "#6b7680",
    "not known": "#6b7680",
}
TIE_WORDS: Mapping[TieOutcome, Phrase] = {
    "elastic": say("tie, elastic at the demand"),
    "holds": say("tie, of given force, holds at the demand"),
    "yields": say("tie, yields at the demand"),
    "gone": say("tie, gone at the demand"),
    "slack": say("tie, slack at the demand"),
    "not counted": say("tie, not counted"),
    "not known": say("tie, not known"),
}
MOST_NAMED_TIES = 12  # of more, names would cover the picture

HATCHINGS: Mapping[WallOutcome, Hatching] = {
    "fail": Hatching(3.2, radians(45), "#8a2a0c"),
    "incomplete": Hatching(5.5, radians(-45), "#8a6100"),
}
VERDICT_WORDS: Mapping[WallOutcome, Phrase] = {
    "pass": say("pass"),
    "fail": say("fail"),
    "incomplete": say("incomplete"),
}


def draw_key_plan(building: BuildingScene, locale: Locale) -> Figure:
    """Draw all bodies."""
    ends = [tie.ends for tie in building.ties]
    points = np.concatenate([_scene_points(building, building.moving_parts), building.beside.reshape(-1, 3), *ends])
    camera = fit_camera(building.direction, points, KEY_PLAN_SIZE)
    with report_style():
        figure, axes = scene_sheet(camera, WIDTH, locale, below=LEGEND_HEIGHT)
        _paint_building(axes, building, camera, dict(enumerate(building.moving_parts)))
        occluders, owner = project_faces(building.surface, building.owner, camera)
        through = len(building.moving_parts) <= MOST_SEEN_THROUGH
        for edge in building.beside:
            _draw_line(axes, camera.project(edge), occluders, through, colour=BESIDE, width=0.6, dash="-")
        tags = []
        for place, part in enumerate(building.moving_parts):
            _draw_lines(axes, part, camera, occluders, through=through)
            seen = visible_middle(occluders.faces[owner == place], occluders)
            x, y, _ = (camera.project(part.middle) if seen is None else seen).tolist()
            tags.append(Label(part.title, (x, y)))
        for tie in building.ties:
            _draw_tie(axes, tie, camera)
            x, y, _ = camera.project(tie.ends[:1])[0].tolist()
            tags += [Label(tie.title, (x, y))] if len(building.ties) <= MOST_NAMED_TIES else []
        write_tags(axes, tags)
        _legend(figure, axes, building, locale)
        return figure


MOST_SEEN_THROUGH = 8  # moving parts: of more, what is hidden of their lines would cover those that are seen


def key_plan_caption(building: BuildingScene) -> Text:
    """Return what the key plan shows."""
    shows: list[Phrase] = [
        say(
            "Key plan: the bodies in one view, the moving part of each mechanism with its number and in the colour of "
            "its verdict, with its axes of rotation and cracks."
        )
    ]
    if len(building.beside):
        shows.append(say("Blue lines: the edges of bodies that belong to no mechanism, such as floors."))
    if building.ties:
        shows.append(
            say("Ties in the colour of what becomes of them at the action; one that holds several mechanisms is one.")
        )
    if building.apart:
        shows.append(say("The bodies are drawn apart: the project gives them no common position."))
    return Paragraph(tuple(shows))


def model_of_key_plan(building: BuildingScene) -> SpatialModel:
    """Return the scene for renderers on which a reader can turn it."""
    colours = {
        owner: FIXED if owner < 0 else VERDICT[building.moving_parts[owner].outcome]
        for owner in np.unique(building.owner).tolist()
    }
    wires = (
        *(wire for part in building.moving_parts for wire in _wires_of_part(part)),
        *(Wire(rounded_points(edge), BESIDE) for edge in building.beside),
        *(Wire(rounded_points(tie.ends), TIE_COLOURS[tie.outcome], tie.title) for tie in building.ties),
    )
    return scene_model(building.surface, building.owner, colours, wires, SHARP_ANGLE, building.direction)


PLACE_SIZE = PictureSize(wide=HALF, tall=2.3, left=0.7, around=0.1)


def draw_place(building: BuildingScene, mechanism: str, locale: Locale) -> Figure:
    """Draw all bodies grey, the part that a mechanism moves in the colour of its verdict, and its direction.

    Where bodies have no common position, those of the mechanism alone. Raises ValueError for one without geometry.
    """
    place = next((k for k, each in enumerate(building.moving_parts) if mechanism in each.names), None)
    if place is None:
        raise ValueError(f'mechanism "{mechanism}" has no geometry that can be drawn in space')
    part, shown = building.moving_parts[place], building_of_mechanism(building, place)
    corners, points = building.surface.corners[part.triangles].reshape(-1, 3), _scene_points(shown, [part])
    arrow = direction_arrow(corners, part.direction, 0.6 * float(np.ptp(points, axis=0).max()))
    for direction in (building.direction, -building.direction):
        camera = fit_camera(direction, np.concatenate([points, arrow]), PLACE_SIZE)
        occluders, owner = project_faces(shown.surface, shown.owner, camera)
        if visible_middle(occluders.faces[owner == place], occluders) is not None:
            break
    with report_style():
        figure, axes = scene_sheet(camera, HALF, locale)
        _paint_building(axes, shown, camera, {place: part})
        _draw_lines(axes, part, camera, occluders)
        draw_arrow(axes, camera.project(arrow), width=1.4)
        return figure


WallOutcome = Literal["pass", "fail", "incomplete"]
MOST_TRIANGLES = 400  # of a body
GAP_APART, MOST_IN_ROW = 0.3, 8  # bodies drawn apart: the gap, of the widest, and how many stand in a row


@dataclass(frozen=True)
class MovingPart:
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
    outcome: WallOutcome
    triangles: IntArray
    middle: FloatArray
    direction: FloatArray
    hinges: tuple[FloatArray, ...]
    cracks: tuple[FloatArray, ...]


@dataclass(frozen=True)
class DrawnTie:
    """A tie in space: its ends [2, 3] [m], what becomes of it, and its number."""

    title: str
    ends: FloatArray
    outcome: TieOutcome


@dataclass(frozen=True)
class BuildingScene:
    """All bodies.

    owner : place in `moving_parts` of the part that each triangle [m] belongs to, -1 for what no mechanism moves
    group : of bodies that each triangle [m] belongs to
    apart : whether bodies that the project places one in the other are drawn side by side
    direction : horizontal, of motion, towards which the picture looks best [3]
    beside : edges of bodies of no mechanism, by their two ends [k, 2, 3] [m]; none where bodies are drawn apart, and
        none of drawn ties, which are among `ties`
    """

    surface: TriangleSurface
    owner: IntArray
    group: IntArray
    moving_parts: tuple[MovingPart, ...]
    apart: bool
    direction: FloatArray
    beside: FloatArray
    ties: tuple[DrawnTie, ...] = ()

    @property
    def mechanisms(self) -> frozenset[str]:
        """The names of the mechanisms that are drawn."""
        return frozenset(name for part in self.moving_parts for name in part.names)


def building_of(results: Results) -> BuildingScene | None:
    """Return the bodies of all mechanisms; None where none has geometry."""
    seen = [(each, each.view) for each in results.mechanisms if each.view is not None and each.view.triangles]
    if not seen:
        return None
    groups = _group_by_shared_bodies(results, [_region_of(*each) for each in seen])
    surfaces = [_bodies_cut_at_cracks(regions) for regions in groups]
    directions = [np.array(view.direction) for _, view in seen]
    direction = max(directions, key=lambda one: sum(abs(float(one @ other)) for other in directions))
    apart = any(_occupy_same_space(*pair) for pair in combinations(surfaces, 2))
    steps = _side_by_side(surfaces, direction) if apart else [np.zeros(3)] * len(surfaces)
    moving_parts: list[MovingPart] = []
    owners: list[IntArray] = []
    for number, (regions, surface, step) in enumerate(zip(groups, surfaces, steps, strict=True)):
        owner, middles = np.full(len(surface.triangles), -1), surface.corners.mean(axis=1)
        for alike in _group_alike(regions):
            held = alike[0].holds(middles)
            owner[held & (owner < 0)] = len(moving_parts)
            triangles = np.flatnonzero(held) + sum(map(len, owners))
            moving_parts.append(_moving_part(results, alike, number, triangles, step))
        owners.append(owner)
    group = np.repeat(np.arange(len(groups)), [len(owner) for owner in owners])
    edges = [] if apart else [edge for body in results.beside if not body.kind for edge in body.edges]
    beside = np.array(edges, dtype=np.float64).reshape(-1, 2, 3)
    joined, owner = _join_surfaces(surfaces, steps), np.concatenate(owners)
    ties = () if apart else tuple(_drawn_ties(results))
    return BuildingScene(joined, owner, group, tuple(moving_parts), apart, direction, beside, ties)


def _drawn_ties(results: Results) -> Iterator[DrawnTie]:
    for place, tie in enumerate(results.ties, start=1):
        yield DrawnTie(tie_number(place), np.array(tie.ends), tie.outcome)


def building_of_mechanism(building: BuildingScene, place: int) -> BuildingScene:
    """Return the building with what one mechanism moves marked, and nothing that only others move.

    Where bodies have no common position, only the group of bodies that it belongs to.
    """
    part = building.moving_parts[place]
    owner = np.full(len(building.owner), -1)
    owner[part.triangles] = place
    kept = (building.group == part.group) | (not building.apart)
    surface = TriangleSurface(building.surface.vertices, building.surface.triangles[kept])
    return replace(building, surface=surface, owner=owner[kept], group=building.group[kept])


def bodies_of(results: Results, mechanism: str) -> tuple[str, ...]:
    """Return the names of the bodies of a mechanism as the project gives them; its own name where it gives none."""
    found = results.project.get(f"mechanisms.{mechanism}.blocks")
    return tuple(_body_names(found.value)) if found is not None else (f"mechanism {mechanism}",)


NEAR = 1e-2  # of a body's size: boxes nearer are one


@dataclass(frozen=True)
class CrackPlane:
    """A plane through a point [3] with a unit normal [3]."""

    point: FloatArray
    normal: FloatArray

    def heights(self, points: FloatArray) -> FloatArray:
        """Return the distance of points [..., 3] on the side of the normal [m]."""
        return np.asarray((points - self.point) @ self.normal)


@dataclass(frozen=True)
class MovingRegion:
    """Where a mechanism moves: a box [2, 3] [m], and its sections, each with the side on which all of it lies."""

    mechanism: MechanismResult
    view: View
    box: FloatArray
    sides: tuple[tuple[CrackPlane, float], ...]

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

    def is_like(self, other: MovingRegion) -> bool:
        """Return whether two mechanisms move the same part about the same axes."""
        mine, its = (np.array([region.box, *(axis.ends for axis in region.view.axes)]) for region in (self, other))
        return mine.shape == its.shape and np.allclose(mine, its, rtol=0.0, atol=self.slack)


def plane_of(ring: FloatArray) -> CrackPlane:
    """Return the plane of a ring of points [k, 3], its normal upwards where it is not upright."""
    middle = ring.mean(axis=0)
    normal = np.linalg.svd(ring - middle)[2][2]
    return CrackPlane(middle, normal if normal[2] >= 0.0 else -normal)


def weld(corners: FloatArray) -> TriangleSurface:
    """Return the surface of loose triangles [m, 3, 3]: vertices in one place are one, triangles without area go."""
    vertices, index = np.unique(np.round(corners.reshape(-1, 3), WELD_DECIMALS), axis=0, return_inverse=True)
    triangles = index.reshape(-1, 3)
    return TriangleSurface(vertices, triangles[(triangles != np.roll(triangles, 1, axis=1)).all(axis=1)])


def cut_triangles(corners: FloatArray, plane: CrackPlane) -> FloatArray:
    """Cut triangles [m, 3, 3] by a plane: those that cross it become three each."""
    heights = plane.heights(corners)
    heights[np.abs(heights) < ON_PLANE] = 0.0
    crossed = (heights.min(axis=1) < 0.0) & (heights.max(axis=1) > 0.0)
    whole, parts, heights = corners[~crossed], corners[crossed], heights[crossed]
    upper = (heights > 0.0).sum(axis=1) == 1
    lone = np.where(upper, heights.argmax(axis=1), heights.argmin(axis=1))
    turned = (lone[:, None] + np.arange(3)) % 3
    a, b, c = np.take_along_axis(parts, turned[..., None], axis=1).swapaxes(0, 1)
    h, i, j = np.take_along_axis(heights, turned, axis=1).T[..., None]
    p, q = a + (b - a) * h / (h - i), a + (c - a) * h / (h - j)
    return np.concatenate([whole, *(np.stack(three, axis=1) for three in ((a, p, q), (p, b, c), (p, c, q)))])


def body_numbers(surface: TriangleSurface) -> IntArray:
    """Return the number of the connected body that each triangle [m] belongs to."""
    a, b, c = surface.triangles.T
    start, end = np.concatenate([a, b]), np.concatenate([b, c])
    size = len(surface.vertices)
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    _, body = connected_components(coo_array((np.ones(len(start)), (start, end)), shape=(size, size)), directed=False)
    return np.asarray(body[a])


def _wires_of_part(part: MovingPart) -> Iterator[Wire]:
    """Yield the cracks of a part and its axes of rotation, the first of these named."""
    yield from (Wire(rounded_points(ring), INK, dashed=True) for ring in part.cracks)
    for place, line in enumerate(part.hinges):
        yield Wire(rounded_points(line), HINGE_COLOUR, part.title if place == 0 else "")


def _scene_points(building: BuildingScene, shown: Sequence[MovingPart]) -> FloatArray:
    """Return all points [k, 3] [m] of a picture with the axes of rotation of the parts shown."""
    hinges = [line for part in shown for line in part.hinges]
    used = np.unique(building.surface.triangles)
    return np.concatenate([building.surface.vertices[used], *hinges])


def _paint_building(axes: Axes, building: BuildingScene, camera: Camera, shown: Mapping[int, MovingPart]) -> None:
    """Draw the bodies: the parts of `shown` in the colours of their verdicts, everything else grey."""
    colours = dict.fromkeys(range(-1, len(building.moving_parts)), FIXED)
    colours |= {place: VERDICT[part.outcome] for place, part in shown.items()}
    hatched = {place: HATCHINGS[part.outcome] for place, part in shown.items() if part.outcome in HATCHINGS}
    paint_bodies(axes, building.surface, building.owner, camera, Appearance(colours, hatched, SHARP_ANGLE))


def _draw_lines(axes: Axes, part: MovingPart, camera: Camera, occluders: Occluders, *, through: bool = True) -> None:
    """Draw the axes of rotation of a part, thick, and its cracks, dashed; `through`: dotted where they are hidden."""
    for ring in part.cracks:
        _draw_line(axes, camera.project(ring), occluders, through, colour=INK, width=0.7, dash=CRACK_DASHES)
    for line in part.hinges:
        _draw_line(axes, camera.project(line), occluders, through, colour=HINGE_COLOUR, width=1.8, dash="-")


def _draw_tie(axes: Axes, tie: DrawnTie, camera: Camera) -> None:
    """Draw a tie through what hides it, with a plate at what it holds; one that does not count is dashed."""
    ink, ends = TIE_COLOURS[tie.outcome], camera.project(tie.ends)
    axes.plot(*ends[:, :2].T, color=ink, linewidth=1.2, linestyle=_tie_dash(tie.outcome), zorder=5)
    axes.plot(*ends[:1, :2].T, color=ink, marker="s", markersize=2.6, zorder=5)


def _tie_dash(outcome: TieOutcome) -> Any:
    return (0, (3, 2)) if outcome in ("not counted", "not known") else "-"


def _draw_line(
    axes: Axes, line: FloatArray, occluders: Occluders, through: bool, *, colour: str, width: float, dash: Any
) -> None:
    for piece, hidden in split_line(line, occluders):
        if hidden and not through:
            continue
        stroke = {"linewidth": 0.5, "linestyle": (0, (1, 1.5))} if hidden else {"linewidth": width, "linestyle": dash}
        axes.plot(*piece[:, :2].T, color=colour, solid_capstyle="round", **stroke)


def _legend(figure: Figure, axes: Axes, building: BuildingScene, locale: Locale) -> None:
    """Explain the colours that appear, hinges and cracks."""
    found = {part.outcome for part in building.moving_parts}
    colours = [(VERDICT[outcome], word) for outcome, word in VERDICT_WORDS.items() if outcome in found]
    if (building.owner < 0).any():
        colours.append((FIXED, say("does not move")))
    patches = [Patch(facecolor=ink, edgecolor=INK, linewidth=0.5, label=locale.text(word)) for ink, word in colours]
    lines = axes.plot([], [], color=HINGE_COLOUR, linewidth=1.8, label=locale.text(say("axis of rotation")))
    if len(building.beside):
        lines += axes.plot([], [], color=BESIDE, linewidth=0.6, label=locale.text(say("body of no mechanism")))
    if any(part.cracks for part in building.moving_parts):
        lines += axes.plot([], [], color=INK, linewidth=0.7, linestyle=CRACK_DASHES, label=locale.text(say("crack")))
    for outcome in dict.fromkeys(tie.outcome for tie in building.ties):
        word = locale.text(TIE_WORDS[outcome])
        lines += axes.plot([], [], color=TIE_COLOURS[outcome], linewidth=1.2, linestyle=_tie_dash(outcome), label=word)
    figure.legend(handles=[*patches, *lines], loc="lower center", ncols=6, borderaxespad=0.1)


def _join_surfaces(surfaces: Sequence[TriangleSurface], steps: Sequence[FloatArray]) -> TriangleSurface:
    """Return all surfaces as one, each moved by its step [3] [m]."""
    starts = np.cumsum([0, *(len(surface.vertices) for surface in surfaces)])
    vertices = [surface.vertices + step for surface, step in zip(surfaces, steps, strict=True)]
    triangles = [surface.triangles + start for surface, start in zip(surfaces, starts, strict=False)]
    return TriangleSurface(np.concatenate(vertices), np.concatenate(triangles))


def _group_by_shared_bodies(results: Results, regions: Sequence[MovingRegion]) -> list[list[MovingRegion]]:
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


def _body_names(value: object) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, Iterable):
        for each in value:
            yield from _body_names(each)


def _bodies_cut_at_cracks(regions: Sequence[MovingRegion]) -> TriangleSurface:
    """Return the bodies of mechanisms, each once, cut where they crack."""
    corners = np.concatenate(list(_distinct_bodies([region.view for region in regions])))
    for plane in _dividing_planes(regions):
        corners = cut_triangles(corners, plane)
    return weld(corners)


def _group_alike(regions: Sequence[MovingRegion]) -> list[list[MovingRegion]]:
    """Group the regions that would look the same."""
    groups: list[list[MovingRegion]] = []
    for region in regions:
        same = next((group for group in groups if group[0].is_like(region)), None)
        if same is None:
            groups.append([region])
        else:
            same.append(region)
    return groups


def _distinct_bodies(views: Sequence[View]) -> Iterator[FloatArray]:
    """Yield the connected bodies [m, 3, 3] of the views, largest view first, without those inside one before."""
    boxes: list[FloatArray] = []
    for view in sorted(views, key=lambda view: (-float(np.prod(view.size)), len(view.sections))):
        surface, slack = (
            TriangleSurface(np.array(view.vertices), np.array(view.triangles)),
            NEAR * float(max(view.size)),
        )
        found, earlier = body_numbers(surface), tuple(boxes)
        for body in np.unique(found):
            used, index = np.unique(surface.triangles[found == body], return_inverse=True)
            part = TriangleSurface(surface.vertices[used], index.reshape(-1, 3))
            box = _box_of(part.vertices)
            if not any((box[0] >= other[0] - slack).all() and (box[1] <= other[1] + slack).all() for other in earlier):
                boxes.append(box)
                yield _coarsen(part)


def _coarsen(surface: TriangleSurface) -> FloatArray:
    """Return the triangles of a body, fewer where it is a scan: the picture is small."""
    vertices, triangles = simplify(surface.vertices, surface.triangles, limit=MOST_TRIANGLES)
    return np.asarray(vertices[triangles])


def _moving_part(
    results: Results, alike: Sequence[MovingRegion], group: int, triangles: IntArray, step: FloatArray
) -> MovingPart:
    names, view = tuple(region.mechanism.name for region in alike), alike[0].view
    return MovingPart(
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


def _outcome(results: Results, names: Sequence[str]) -> WallOutcome:
    """Return the worst verdict of the mechanisms; incomplete where there is none."""
    verdicts = () if results.verdict is None else results.verdict.mechanisms
    found = [each.outcome for each in verdicts if each.mechanism in names]
    return (worst_outcome(found) if found else Decision.INCOMPLETE).value


def _side_by_side(surfaces: Sequence[TriangleSurface], direction: FloatArray) -> list[FloatArray]:
    """Return the shifts [m] that place bodies side by side as the viewer sees them, in rows one below another."""
    across, _, towards = viewing_frame(direction)
    back = towards * [1.0, 1.0, 0.0] / float(np.hypot(*towards[:2]))
    boxes = [_box_of(surface.vertices) for surface in surfaces]
    reach = [surface.vertices @ across for surface in surfaces]
    wide, tall = max(float(np.ptp(each)) for each in reach), max(float(box[1, 2] - box[0, 2]) for box in boxes)
    steps = []
    for place, (box, along) in enumerate(zip(boxes, reach, strict=True)):
        row, column = divmod(place, MOST_IN_ROW)
        step = column * (1.0 + GAP_APART) * wide - float(along.min())
        lift = -box[0, 2] - row * (1.0 + 2 * GAP_APART) * tall
        steps.append(step * across - float(box.mean(axis=0) @ back) * back + np.array([0.0, 0.0, lift]))
    return steps


def _region_of(mechanism: MechanismResult, view: View) -> MovingRegion:
    """Return where a mechanism moves masonry of its view."""
    triangles, moves = np.array(view.triangles), np.array(view.block_of) >= 0
    points = np.array(view.vertices)[np.unique(triangles[moves] if moves.any() else triangles)]
    return MovingRegion(mechanism, view, _box_of(points), tuple(_sides_of_sections(points, view)))


def _sides_of_sections(points: FloatArray, view: View) -> Iterator[tuple[CrackPlane, float]]:
    """Yield the planes of the sections that have all points on one side, and which: 1 for that of the normal."""
    slack = 0.2 * NEAR * float(max(view.size))
    for plane in (plane_of(np.array(ring)) for ring in view.sections):
        heights = plane.heights(points)
        if heights.min() >= -slack or heights.max() <= slack:
            yield plane, 1.0 if heights.min() >= -slack else -1.0


def _dividing_planes(regions: Sequence[MovingRegion]) -> list[CrackPlane]:
    """Return the planes by which parts that move are divided from the rest: of cracks, or level below a part."""
    upright, lowest = np.array([0.0, 0.0, 1.0]), min(float(region.box[0, 2]) for region in regions)
    rings = dict.fromkeys(ring for region in regions for ring in region.view.sections)
    whole = [region.box[0] for region in regions if not region.view.sections and region.box[0, 2] > lowest + NEAR]
    return [*(plane_of(np.array(ring)) for ring in rings), *(CrackPlane(corner, upright) for corner in whole)]


WELD_DECIMALS = 6  # decimals [m] to which vertices are one
ON_PLANE = 1e-9  # of its plane: a vertex nearer is on it [m]
LARGEST_SHARED = 0.3  # of the smaller: bodies that share more of their ground and height cannot both stand there
GROUND_SAMPLES = 15  # points along the ground of a body, in either direction


def _box_of(points: FloatArray) -> FloatArray:
    """Return the least and the largest coordinates [2, 3] of points [k, 3]."""
    return np.array([points.min(axis=0), points.max(axis=0)])


def _occupy_same_space(one: TriangleSurface, other: TriangleSurface) -> bool:
    """Return whether two surfaces share so much ground and height that they cannot both stand there."""
    boxes = np.array([_box_of(one.vertices), _box_of(other.vertices)])
    low, high = boxes[:, 0].max(axis=0), boxes[:, 1].min(axis=0)
    if (high <= low).any() or high[2] - low[2] <= LARGEST_SHARED * np.ptp(boxes[..., 2], axis=1).min():
        return False
    return _shared_ground(one, other) > LARGEST_SHARED or _shared_ground(other, one) > LARGEST_SHARED


def _shared_ground(one: TriangleSurface, other: TriangleSurface) -> float:
    """Return the part of the ground under a surface that is under another too [-], by points on a grid."""
    low, high = _box_of(one.vertices[:, :2])
    sides = np.linspace(low, high, GROUND_SAMPLES + 2)[1:-1].T
    points = np.asarray(shapely.points(np.stack(np.meshgrid(*sides), axis=-1).reshape(-1, 2)))
    mine, its = (_are_above(surface, points) for surface in (one, other))
    return float((mine & its).sum() / max(mine.sum(), 1))


def _are_above(surface: TriangleSurface, points: FloatArray) -> BoolArray:
    """Return whether each point of the ground [k] lies under a surface."""
    faces = surface.corners[:, :, :2]
    (x, y), (u, v) = (faces[:, 1] - faces[:, 0]).T, (faces[:, 2] - faces[:, 0]).T
    tree = shapely.STRtree(np.asarray(shapely.polygons(faces[x * v - y * u > ON_PLANE])))
    return np.isin(np.arange(len(points)), tree.query(points, predicate="intersects")[0])
