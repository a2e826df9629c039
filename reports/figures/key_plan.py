"""The key plan: all bodies in space, and the part that each mechanism moves, numbered, in the colour of its verdict.

The same bodies in grey show the place of one mechanism in the building.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import radians
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from reports.document import SpatialModel, Wire
from reports.figures.building import BuildingScene, MovingPart, Outcome, building_of_mechanism
from reports.figures.projection import (
    Appearance,
    Camera,
    Hatching,
    Occluders,
    PictureSize,
    draw_arrow,
    fit_camera,
    paint_bodies,
    project_faces,
    scene_sheet,
    split_line,
    visible_middle,
)
from reports.figures.style import FIXED, HALF, INK, VERDICT, WIDTH, Label, report_style, write_tags
from reports.figures.view import direction_arrow, rounded_points, scene_model
from reports.language.locale import Locale
from reports.language.texts import Paragraph, Phrase, Text, say
from spectra.arrays import FloatArray

KEY_PLAN_SIZE = PictureSize(wide=WIDTH, tall=3.6, left=0.8, around=0.2)
SHARP_ANGLE = radians(40)  # angle between faces from which on their common edge is drawn
LEGEND_HEIGHT = 0.24  # height [in]
HINGE_COLOUR = "#101820"
CRACK_DASHES = (0, (2, 1.5))

HATCHINGS: Mapping[Outcome, Hatching] = {
    "fail": Hatching(3.2, radians(45), "#8a2a0c"),
    "incomplete": Hatching(5.5, radians(-45), "#8a6100"),
}
VERDICT_WORDS: Mapping[Outcome, Phrase] = {"pass": say("pass"), "fail": say("fail"), "incomplete": say("incomplete")}


def draw_key_plan(building: BuildingScene, locale: Locale) -> Figure:
    """Draw all bodies."""
    camera = fit_camera(building.direction, scene_points(building, building.moving), KEY_PLAN_SIZE)
    with report_style():
        figure, axes = scene_sheet(camera, WIDTH, locale, below=LEGEND_HEIGHT)
        paint_building(axes, building, camera, dict(enumerate(building.moving)))
        before, owner = project_faces(building.surface, building.owner, camera)
        tags = []
        for place, moving in enumerate(building.moving):
            draw_lines(axes, moving, camera, before)
            seen = visible_middle(before.faces[owner == place], before)
            x, y, _ = (camera.project(moving.middle) if seen is None else seen).tolist()
            tags.append(Label(moving.title, (x, y)))
        write_tags(axes, tags)
        _legend(figure, axes, building, locale)
        return figure


def key_plan_caption(building: BuildingScene) -> Text:
    """Return what the key plan shows."""
    shows = say(
        "Key plan: the bodies in one view, the moving part of each mechanism with its number and in the colour of its "
        "verdict, with its axes of rotation and cracks."
    )
    if not building.apart:
        return shows
    return Paragraph((shows, say("The bodies are drawn apart: the project gives them no common position.")))


def model_of_key_plan(building: BuildingScene) -> SpatialModel:
    """Return the scene for renderers on which a reader can turn it."""
    colours = {owner: _colour(building, owner) for owner in np.unique(building.owner).tolist()}
    wires = tuple(wire for moving in building.moving for wire in _wires_of_part(moving))
    return scene_model(building.surface, building.owner, colours, wires, SHARP_ANGLE, building.direction)


def _colour(building: BuildingScene, owner: int) -> str:
    return FIXED if owner < 0 else VERDICT[building.moving[owner].outcome]


def _wires_of_part(moving: MovingPart) -> Iterator[Wire]:
    """Yield the cracks of a part and its axes of rotation, the first of these named."""
    yield from (Wire(rounded_points(ring), INK, dashed=True) for ring in moving.cracks)
    for place, line in enumerate(moving.hinges):
        yield Wire(rounded_points(line), HINGE_COLOUR, moving.title if place == 0 else "")


def scene_points(building: BuildingScene, shown: Sequence[MovingPart]) -> FloatArray:
    """Return all points [k, 3] [m] of a picture with the axes of rotation of the parts shown."""
    hinges = [line for moving in shown for line in moving.hinges]
    used = np.unique(building.surface.triangles)
    return np.concatenate([building.surface.vertices[used], *hinges])


def paint_building(axes: Axes, building: BuildingScene, camera: Camera, shown: Mapping[int, MovingPart]) -> None:
    """Draw the bodies: the parts of `shown` in the colours of their verdicts, everything else grey."""
    colours = dict.fromkeys(range(-1, len(building.moving)), FIXED)
    colours |= {place: VERDICT[moving.outcome] for place, moving in shown.items()}
    hatched = {place: HATCHINGS[moving.outcome] for place, moving in shown.items() if moving.outcome in HATCHINGS}
    paint_bodies(axes, building.surface, building.owner, camera, Appearance(colours, hatched, SHARP_ANGLE))


def draw_lines(axes: Axes, moving: MovingPart, camera: Camera, before: Occluders) -> None:
    """Draw the axes of rotation of a part, thick, and its cracks, dashed; what is hidden of them is dotted."""
    for ring in moving.cracks:
        _draw_line(axes, camera.project(ring), before, colour=INK, width=0.7, dash=CRACK_DASHES)
    for line in moving.hinges:
        _draw_line(axes, camera.project(line), before, colour=HINGE_COLOUR, width=1.8, dash="-")


def _draw_line(axes: Axes, line: FloatArray, before: Occluders, *, colour: str, width: float, dash: Any) -> None:
    for piece, hidden in split_line(line, before):
        look = {"linewidth": 0.5, "linestyle": (0, (1, 1.5))} if hidden else {"linewidth": width, "linestyle": dash}
        axes.plot(*piece[:, :2].T, color=colour, solid_capstyle="round", **look)


def _legend(figure: Figure, axes: Axes, building: BuildingScene, locale: Locale) -> None:
    """Explain the colours that appear, hinges and cracks."""
    found = {moving.outcome for moving in building.moving}
    colours = [(VERDICT[outcome], word) for outcome, word in VERDICT_WORDS.items() if outcome in found]
    if (building.owner < 0).any():
        colours.append((FIXED, say("does not move")))
    patches = [Patch(facecolor=ink, edgecolor=INK, linewidth=0.5, label=locale.text(word)) for ink, word in colours]
    lines = axes.plot([], [], color=HINGE_COLOUR, linewidth=1.8, label=locale.text(say("axis of rotation")))
    if any(moving.cracks for moving in building.moving):
        lines += axes.plot([], [], color=INK, linewidth=0.7, linestyle=CRACK_DASHES, label=locale.text(say("crack")))
    figure.legend(handles=[*patches, *lines], loc="lower center", ncols=6, borderaxespad=0.1)


PLACE_SIZE = PictureSize(wide=HALF, tall=2.3, left=0.7, around=0.1)


def draw_place(building: BuildingScene, mechanism: str, locale: Locale) -> Figure:
    """Draw all bodies grey, the part that a mechanism moves in the colour of its verdict, and its direction.

    Where bodies have no common position, those of the mechanism alone. Raises ValueError for one without geometry.
    """
    place = next((k for k, each in enumerate(building.moving) if mechanism in each.names), None)
    if place is None:
        raise ValueError(f'mechanism "{mechanism}" has no geometry that can be drawn in space')
    moving, shown = building.moving[place], building_of_mechanism(building, place)
    corners, points = building.surface.corners[moving.triangles].reshape(-1, 3), scene_points(shown, [moving])
    arrow = direction_arrow(corners, moving.direction, 0.6 * float(np.ptp(points, axis=0).max()))
    for direction in (building.direction, -building.direction):
        camera = fit_camera(direction, np.concatenate([points, arrow]), PLACE_SIZE)
        before, owner = project_faces(shown.surface, shown.owner, camera)
        if visible_middle(before.faces[owner == place], before) is not None:
            break
    with report_style():
        figure, axes = scene_sheet(camera, HALF, locale)
        paint_building(axes, shown, camera, {place: moving})
        draw_lines(axes, moving, camera, before)
        draw_arrow(axes, camera.project(arrow), width=1.4)
        return figure
