"""The key plan: all bodies in space, and the part that each mechanism moves, numbered, in the colour of its verdict."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import atan2, radians
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from assess.results import MechanismResult, Results
from reports.document import Model, Part, Place, Wire
from reports.figures.building import Building, Moving, Outcome, building_of
from reports.figures.labels import Label, write_tags
from reports.figures.projection import (
    INCH,
    RAISED,
    Camera,
    Hatching,
    Room,
    draw_triad,
    eye_of,
    fit_camera,
    paint_bodies,
)
from reports.figures.scale_bar import round_length, write_arm
from reports.figures.sight import project_faces, split_line, visible_middle
from reports.figures.style import FIXED, INK, STONE_EDGE, VERDICT, WIDTH, bare_sheet, report_style
from reports.language.locale import Locale
from reports.language.texts import Paragraph, Phrase, Text, say
from spectra.arrays import FloatArray, IntArray

ROOM = Room(wide=WIDTH, tall=3.6, left=0.8, around=0.2)
SHARP = radians(40)  # angle between faces from which on their common edge is drawn
LEGEND = 0.24  # height [in]
HINGE = "#101820"
HATCHED: Mapping[Outcome, Hatching] = {
    "fail": Hatching(3.2, radians(45), "#8a2a0c"),
    "incomplete": Hatching(5.5, radians(-45), "#8a6100"),
}
WORDS: Mapping[Outcome, Phrase] = {"pass": say("pass"), "fail": say("fail"), "incomplete": say("incomplete")}


def draw(results: Results, locale: Locale) -> Figure:
    """Draw all bodies; raises ValueError where no mechanism has geometry."""
    building = building_of(results)
    if building is None:
        raise ValueError("no mechanism has geometry that can be drawn in space")
    camera, (wide, high) = fit_camera(building.direction, scene_points(building, building.moving), ROOM)
    with report_style():
        figure = bare_sheet(high + LEGEND, locale)
        share = high / (high + LEGEND)
        axes = figure.add_axes((0.5 * (1.0 - wide / WIDTH), 1.0 - share, wide / WIDTH, share))
        axes.set(xlim=(0.0, wide * INCH), ylim=(0.0, high * INCH))
        axes.set_axis_off()
        paint_building(axes, building, camera, dict(enumerate(building.moving)))
        faces, owner = project_faces(building.surface, building.owner, camera)
        for moving in building.moving:
            draw_lines(axes, moving, camera, faces)
        _tags(axes, building, camera, faces, owner)
        arm = round_length(0.35 / camera.scale, locale)
        draw_triad(axes, camera, at=(2.0, 10.0), arm=arm)
        write_arm(axes, arm, at=(2.0, 2.0), locale=locale)
        _legend(figure, building, locale)
        return figure


def has_place(mechanism: MechanismResult) -> bool:
    """Return whether a mechanism has geometry that can be drawn in space."""
    return mechanism.view is not None and bool(mechanism.view.triangles)


def caption(results: Results) -> Text:
    """Return what the key plan shows."""
    shows = say(
        "Key plan: the bodies in one view, the moving part of each mechanism with its number and in the colour of its "
        "verdict, with its axes of rotation and cracks."
    )
    building = building_of(results)
    if building is None or not building.apart:
        return shows
    return Paragraph((shows, say("The bodies are drawn apart: the project gives them no common position.")))


def model_of_key_plan(results: Results) -> Model | None:
    """Return the scene for renderers on which a reader can turn it; None where no mechanism has geometry."""
    building = building_of(results)
    if building is None:
        return None
    parts = []
    for owner in np.unique(building.owner).tolist():
        colour = FIXED if owner < 0 else VERDICT[building.moving[owner].outcome]
        triangles = building.surface.triangles[building.owner == owner].tolist()
        parts.append(Part(colour, tuple((a, b, c) for a, b, c in triangles)))
    eye = eye_of(building.direction)[2]
    seen = (atan2(float(eye[1]), float(eye[0])), RAISED)
    wires = tuple(wire for moving in building.moving for wire in _wires(moving))
    return Model(_places(building.surface.vertices), tuple(parts), wires, STONE_EDGE, SHARP, seen)


def _wires(moving: Moving) -> Iterator[Wire]:
    """Yield the cracks of a part and its axes of rotation, the first of these named."""
    yield from (Wire(_places(ring), INK, dashed=True) for ring in moving.cracks)
    for place, line in enumerate(moving.hinges):
        yield Wire(_places(line), HINGE, moving.title if place == 0 else "")


def _places(points: FloatArray) -> tuple[Place, ...]:
    return tuple((x, y, z) for x, y, z in np.round(points, 4).tolist())


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
    paint_bodies(axes, building.surface, building.owner, camera, colours=colours, sharp=SHARP, hatched=hatched)


def draw_lines(axes: Axes, moving: Moving, camera: Camera, faces: FloatArray) -> None:
    """Draw the axes of rotation of a part, thick, and its cracks, dashed; what `faces` hide of them is dotted."""
    for ring in moving.cracks:
        _draw_line(axes, camera.project(ring), faces, colour=INK, width=0.7, dash=(0, (2, 1.5)))
    for line in moving.hinges:
        _draw_line(axes, camera.project(line), faces, colour=HINGE, width=1.8, dash="-")


def _draw_line(axes: Axes, line: FloatArray, faces: FloatArray, *, colour: str, width: float, dash: Any) -> None:
    for piece, hidden in split_line(line, faces):
        look = {"linewidth": 0.5, "linestyle": (0, (1, 1.5))} if hidden else {"linewidth": width, "linestyle": dash}
        axes.plot(*piece[:, :2].T, color=colour, solid_capstyle="round", **look)


def _tags(axes: Axes, building: Building, camera: Camera, faces: FloatArray, owner: IntArray) -> None:
    """Number the parts where they are seen."""
    tags = []
    for place, moving in enumerate(building.moving):
        seen = visible_middle(faces[owner == place], faces)
        at = camera.project(moving.middle[None])[0] if seen is None else seen
        tags.append(Label(moving.title, (float(at[0]), float(at[1]))))
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    write_tags(axes, tags, window=(right - left, high - low))


def _legend(figure: Figure, building: Building, locale: Locale) -> None:
    """Explain the colours that appear, hinges and cracks."""
    handles: list[Patch] = []
    for outcome, word in WORDS.items():
        if any(moving.outcome == outcome for moving in building.moving):
            handles.append(Patch(facecolor=VERDICT[outcome], edgecolor=INK, linewidth=0.5, label=locale.text(word)))
    if (building.owner < 0).any():
        name = locale.text(say("does not move"))
        handles.append(Patch(facecolor=FIXED, edgecolor=INK, linewidth=0.5, label=name))
    axes = figure.axes[0]
    lines = axes.plot([], [], color=HINGE, linewidth=1.8, label=locale.text(say("axis of rotation")))
    if any(moving.cracks for moving in building.moving):
        name = locale.text(say("crack"))
        lines += axes.plot([], [], color=INK, linewidth=0.7, linestyle=(0, (2, 1.5)), label=name)
    figure.legend(handles=[*handles, *lines], loc="lower center", ncols=6, borderaxespad=0.1)
