"""The key plan: all bodies in space, and the part that each mechanism moves, numbered, in the colour of its verdict."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import radians
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from reports.document import Model, Wire
from reports.figures.building import Building, Moving, Outcome
from reports.figures.faces import Hatching, Look, paint_bodies
from reports.figures.labels import Label, write_tags
from reports.figures.model import places, scene_model
from reports.figures.projection import Camera, Room, fit_camera, scene_sheet
from reports.figures.sight import Curtain, project_faces, split_line, visible_middle
from reports.figures.style import FIXED, INK, VERDICT, WIDTH, report_style
from reports.language.locale import Locale
from reports.language.texts import Paragraph, Phrase, Text, say
from spectra.arrays import FloatArray

ROOM = Room(wide=WIDTH, tall=3.6, left=0.8, around=0.2)
SHARP = radians(40)  # angle between faces from which on their common edge is drawn
LEGEND = 0.24  # height [in]
HINGE = "#101820"
CRACK = (0, (2, 1.5))
HATCHED: Mapping[Outcome, Hatching] = {
    "fail": Hatching(3.2, radians(45), "#8a2a0c"),
    "incomplete": Hatching(5.5, radians(-45), "#8a6100"),
}
WORDS: Mapping[Outcome, Phrase] = {"pass": say("pass"), "fail": say("fail"), "incomplete": say("incomplete")}


def draw(building: Building, locale: Locale) -> Figure:
    """Draw all bodies."""
    camera = fit_camera(building.direction, scene_points(building, building.moving), ROOM)
    with report_style():
        figure, axes = scene_sheet(camera, WIDTH, locale, below=LEGEND)
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


def caption(building: Building) -> Text:
    """Return what the key plan shows."""
    shows = say(
        "Key plan: the bodies in one view, the moving part of each mechanism with its number and in the colour of its "
        "verdict, with its axes of rotation and cracks."
    )
    if not building.apart:
        return shows
    return Paragraph((shows, say("The bodies are drawn apart: the project gives them no common position.")))


def model_of_key_plan(building: Building) -> Model:
    """Return the scene for renderers on which a reader can turn it."""
    colours = {owner: _colour(building, owner) for owner in np.unique(building.owner).tolist()}
    wires = tuple(wire for moving in building.moving for wire in _wires(moving))
    return scene_model(building.surface, building.owner, colours, wires, SHARP, building.direction)


def _colour(building: Building, owner: int) -> str:
    return FIXED if owner < 0 else VERDICT[building.moving[owner].outcome]


def _wires(moving: Moving) -> Iterator[Wire]:
    """Yield the cracks of a part and its axes of rotation, the first of these named."""
    yield from (Wire(places(ring), INK, dashed=True) for ring in moving.cracks)
    for place, line in enumerate(moving.hinges):
        yield Wire(places(line), HINGE, moving.title if place == 0 else "")


def scene_points(building: Building, shown: Sequence[Moving]) -> FloatArray:
    """Return all points [k, 3] [m] of a picture with the axes of rotation of the parts shown."""
    hinges = [line for moving in shown for line in moving.hinges]
    used = np.unique(building.surface.triangles)
    return np.concatenate([building.surface.vertices[used], *hinges])


def paint_building(axes: Axes, building: Building, camera: Camera, shown: Mapping[int, Moving]) -> None:
    """Draw the bodies: the parts of `shown` in the colours of their verdicts, everything else grey."""
    colours = dict.fromkeys(range(-1, len(building.moving)), FIXED)
    colours |= {place: VERDICT[moving.outcome] for place, moving in shown.items()}
    hatched = {place: HATCHED[moving.outcome] for place, moving in shown.items() if moving.outcome in HATCHED}
    paint_bodies(axes, building.surface, building.owner, camera, Look(colours, hatched, SHARP))


def draw_lines(axes: Axes, moving: Moving, camera: Camera, before: Curtain) -> None:
    """Draw the axes of rotation of a part, thick, and its cracks, dashed; what is hidden of them is dotted."""
    for ring in moving.cracks:
        _draw_line(axes, camera.project(ring), before, colour=INK, width=0.7, dash=CRACK)
    for line in moving.hinges:
        _draw_line(axes, camera.project(line), before, colour=HINGE, width=1.8, dash="-")


def _draw_line(axes: Axes, line: FloatArray, before: Curtain, *, colour: str, width: float, dash: Any) -> None:
    for piece, hidden in split_line(line, before):
        look = {"linewidth": 0.5, "linestyle": (0, (1, 1.5))} if hidden else {"linewidth": width, "linestyle": dash}
        axes.plot(*piece[:, :2].T, color=colour, solid_capstyle="round", **look)


def _legend(figure: Figure, axes: Axes, building: Building, locale: Locale) -> None:
    """Explain the colours that appear, hinges and cracks."""
    found = {moving.outcome for moving in building.moving}
    colours = [(VERDICT[outcome], word) for outcome, word in WORDS.items() if outcome in found]
    if (building.owner < 0).any():
        colours.append((FIXED, say("does not move")))
    patches = [Patch(facecolor=ink, edgecolor=INK, linewidth=0.5, label=locale.text(word)) for ink, word in colours]
    lines = axes.plot([], [], color=HINGE, linewidth=1.8, label=locale.text(say("axis of rotation")))
    if any(moving.cracks for moving in building.moving):
        lines += axes.plot([], [], color=INK, linewidth=0.7, linestyle=CRACK, label=locale.text(say("crack")))
    figure.legend(handles=[*patches, *lines], loc="lower center", ncols=6, borderaxespad=0.1)
