"""One mechanism drawn: in its plane of motion, at rest and displaced, and in space with the axes it turns about.

Its bodies in space are a figure, and a model that a reader can turn.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import atan2, hypot, radians

import numpy as np
import shapely
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.patches import Polygon
from matplotlib.ticker import MaxNLocator

from assess.results import DisplacedDrawing, Drawing, DrawnLoad, LoadResult, MechanismResult, NamedPoint, Point, View
from reports.document import ColouredFaces, SpatialModel, Wire
from reports.document import Point as PointInSpace
from reports.figures.projection import (
    RAISED,
    Appearance,
    Camera,
    PictureSize,
    TriangleSurface,
    draw_arrow,
    fit_camera,
    paint_bodies,
    scene_sheet,
    viewing_frame,
)
from reports.figures.style import (
    FIXED,
    HALF,
    INK,
    LOAD,
    MUTED,
    NEGATIVE,
    POSITIVE,
    STONE_EDGE,
    WIDTH,
    Label,
    Scale,
    bare_sheet,
    label,
    report_style,
    shade,
    table_scale,
    write_labels,
)
from reports.language.locale import Locale
from reports.language.texts import Phrase, Verbatim, quantity, say
from spectra.arrays import FloatArray, IntArray
from spectra.gravity import g

TALLEST, LOWEST = 2.5, 0.9  # of the figure, of a panel [in]
LEFT, BOTTOM, TOP, GAP = 0.42, 0.36, 0.2, 0.08  # around and between the panels [in]
MASONRY_BESIDE = 0.35  # of the mechanism's size: what is shown of the masonry that stays, at either side
SEEN_FROM_ABOVE = frozenset({"horizontal-arch"})  # kinds that move in a level plane
TICK_ROOM = 0.06  # of a panel: a number nearer to its side runs into that of the next
_ARROW = {"arrowstyle": "-|>", "linewidth": 1.1, "shrinkA": 0, "shrinkB": 0}
LOAD_ARROW = 0.16  # length of a load's arrow, as a part of the mechanism's size


@dataclass(frozen=True)
class SketchWindow:
    """What every panel shows: lower left and upper right corner [m], and the length of a load's arrow [m]."""

    low: Point
    high: Point
    arrow: float

    @property
    def size(self) -> tuple[float, float]:
        """Width and height [m]."""
        return self.high[0] - self.low[0], self.high[1] - self.low[1]


def draw_sketch(mechanism: MechanismResult, locale: Locale) -> Figure:
    """Draw the mechanism at rest, hinges, loads and centroids named, and beside it displaced to its positive side.

    The outline to which it is displaced on its negative side is dashed.
    """
    drawing = mechanism.drawing
    window = common_window(drawing)
    panel = panel_size(window.size)
    metres = table_scale("length", locale)
    with report_style():
        figure = bare_sheet(panel[1] + BOTTOM + TOP, locale, width=HALF)
        upwards = say("along the wall, s") if mechanism.kind in SEEN_FROM_ABOVE else say("elevation z")
        rest, turned = (_add_panel(figure, column, panel, window, metres, upwards) for column in (0, 1))
        _draw_at_rest(rest, mechanism, window, locale)
        _draw_displaced(turned, mechanism, window, locale)
        return figure


def common_window(drawing: Drawing) -> SketchWindow:
    """Return the window that holds the mechanism at rest and displaced, the masonry beside it, and room for names."""
    scenes = [each for each in (drawing, drawing.displaced, drawing.displaced_negative) if each is not None]
    points = np.array([point for scene in scenes for point in _drawn_points(scene)])
    arrow = LOAD_ARROW * float(np.ptp(points, axis=0).max())
    ends = [end for scene in scenes for load in scene.loads for end in _arrow_ends(load, arrow)]
    ends += [(x, z - arrow) for x, z in drawing.centroids if drawing.masses_kg]
    points = np.concatenate([points, np.array(ends).reshape(-1, 2)])
    size = float(np.ptp(points, axis=0).max())
    (left, low), (right, high) = points.min(axis=0).tolist(), points.max(axis=0).tolist()
    beside = [x for ring in drawing.fixed for x in extent_between(ring, low, high)]
    left = max(min([left, *beside]), left - MASONRY_BESIDE * size)
    right = min(max([right, *beside]), right + MASONRY_BESIDE * size)
    return SketchWindow((left - 0.1 * size, low - 0.09 * size), (right + 0.1 * size, high + 0.06 * size), arrow)


def extent_between(ring: Sequence[Point], low: float, high: float) -> tuple[float, ...]:
    """Return how far [m] a ring reaches to both sides between two elevations [m]; empty where it does not."""
    part = shapely.intersection(shapely.Polygon(ring), shapely.box(-1e9, low, 1e9, high))
    return () if part.is_empty else (part.bounds[0], part.bounds[2])


def panel_size(size: tuple[float, float]) -> tuple[float, float]:
    """Return the size [in] of each of two panels in which a window of a size [m] is drawn largest side by side."""
    wide, high = size
    room = 0.5 * (HALF - LEFT - 2 * GAP)
    scale = min(room / wide, (TALLEST - BOTTOM - TOP) / high)
    return room, max(scale * high, LOWEST)


VIEW_SIZE = PictureSize(wide=5.2, tall=3.0, left=0.75, around=0.25)
AXIS_BEYOND = 0.07  # of the bodies' size: how far an axis is drawn beyond them
AXIS_NAME_BOX = (11.0, 8.5)  # room of the name of an axis [pt]


def draw_view(view: View, positive: int, locale: Locale) -> Figure:
    """Draw the bodies, their sections, the axes of rotation and the direction of motion.

    positive : of the axes, how many from the first on are those of the positive side
    """
    surface = TriangleSurface(np.array(view.vertices), np.array(view.triangles))
    along, size = np.array(view.direction), float(max(view.size))
    lines = [_extend_line(np.array(axis.ends), AXIS_BEYOND * size) for axis in view.axes]
    arrow = direction_arrow(surface.vertices, along, size)
    camera = fit_camera(along, np.concatenate([surface.vertices, arrow, *lines]), VIEW_SIZE)
    with report_style():
        figure, axes = scene_sheet(camera, WIDTH, locale)
        appearance = Appearance({block: shade(block) for block in view.block_of}, {}, _sharp_angle(view))
        paint_bodies(axes, surface, np.array(view.block_of), camera, appearance)
        for ring in view.sections:
            axes.plot(*camera.project(np.array(ring))[:, :2].T, color=INK, linewidth=0.8, linestyle=(0, (2, 1.5)))
        _draw_rotation_axes(axes, view, camera, lines, positive)
        draw_arrow(axes, camera.project(arrow), width=1.6)
        return figure


def direction_arrow(vertices: FloatArray, along: FloatArray, size: float) -> FloatArray:
    """Return the ends [2, 3] of the arrow along the direction of motion, out of the leading face."""
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    middle = 0.5 * (low + high)
    start = middle + (float((vertices @ along).max()) - middle @ along) * along
    start[2] = low[2] + 0.75 * (high[2] - low[2])
    return np.array([start, start + 0.25 * size * along])


def avoid_names(at: FloatArray, taken: Sequence[FloatArray]) -> FloatArray:
    """Return the place of a name [pt], lowered where one of those taken is too near to read both."""
    while any((np.abs(at - other) < AXIS_NAME_BOX).all() for other in taken):
        at = at - np.array([0.0, 1.0])
    return at


def model_of_view(view: View, *, positive: int) -> SpatialModel:
    """Return the model of a view, the first `positive` of whose axes are those of the positive branch."""
    surface = TriangleSurface(np.array(view.vertices), np.array(view.triangles))
    colours = {block: shade(block) for block in view.block_of}
    wires = tuple(_wires_of_view(view, surface, positive))
    return scene_model(surface, np.array(view.block_of), colours, wires, _sharp_angle(view), np.array(view.direction))


def scene_model(
    surface: TriangleSurface,
    owner: IntArray,
    colours: Mapping[int, str],
    wires: tuple[Wire, ...],
    sharp: float,
    direction: FloatArray,
) -> SpatialModel:
    """Return bodies in the colours of their owners, first seen as the figure shows them for a direction of motion."""
    parts = (ColouredFaces(colour, _indices(surface.triangles[owner == each])) for each, colour in colours.items())
    east, north, _ = viewing_frame(direction)[2].tolist()
    return SpatialModel(
        rounded_points(surface.vertices), tuple(parts), wires, STONE_EDGE, sharp, (atan2(north, east), RAISED)
    )


def rounded_points(points: FloatArray) -> tuple[PointInSpace, ...]:
    """Return points [k, 3] to a tenth of a millimetre."""
    return tuple((x, y, z) for x, y, z in np.round(points, 4).tolist())


def _drawn_points(scene: Drawing | DisplacedDrawing) -> Iterator[Point]:
    """Yield every point that is drawn, except of arrows."""
    yield from (point for ring in scene.blocks for point in ring)
    yield from (hinge.at for hinge in scene.hinges)
    yield from (load.at for load in scene.loads)
    yield from scene.centroids


def _arrow_ends(load: DrawnLoad, length: float) -> tuple[Point, ...]:
    """Return tail and head [m] of a load's arrow: a force pushes onto its point, a tie or a weight pulls from it."""
    if load.towards is None:
        return ()
    (x, z), (along, up) = load.at, load.towards
    sign = -1.0 if load.kind == "force" else 1.0
    far = (x + sign * length * along, z + sign * length * up)
    return (far, load.at) if load.kind == "force" else (load.at, far)


def _add_panel(
    figure: Figure, column: int, panel: tuple[float, float], window: SketchWindow, metres: Scale, upwards: Phrase
) -> Axes:
    """Add the axes of one panel: equal scale, data in metres, ticks in the unit of the locale."""
    wide, high = panel
    tall = high + BOTTOM + TOP
    axes = figure.add_axes(((LEFT + column * (wide + GAP)) / HALF, BOTTOM / tall, wide / HALF, high / tall))
    middle, level = (0.5 * (low + up) for low, up in zip(window.low, window.high, strict=True))
    scale = min(wide / window.size[0], high / window.size[1])
    across, up = 0.5 * wide / scale, 0.5 * high / scale
    axes.set(xlim=(middle - across, middle + across), ylim=(level - up, level + up))
    axes.grid(visible=False)
    for axis, steps, beside in ((axes.xaxis, 3, TICK_ROOM), (axes.yaxis, 6, 0.0)):
        low, top = (float(end) / metres.unit.size for end in axis.get_view_interval())
        low, top = low + beside * (top - low), top - beside * (top - low)
        ticks = [each for each in MaxNLocator(steps, steps=[1, 2, 5, 10]).tick_values(low, top) if low <= each <= top]
        names = [metres.locale.number(each, figures=3) for each in ticks]
        axis.set_ticks([each * metres.unit.size for each in ticks], labels=names)
    axes.tick_params(labelleft=column == 0)
    axes.set(xlabel=metres.heading(Verbatim("x")), ylabel=metres.heading(upwards) if column == 0 else "")
    return axes


def force_text(newtons: float, locale: Locale) -> str:
    """Return a force in the unit of tables, kN or kip."""
    scale = table_scale("force", locale)
    return locale.with_unit(locale.number(newtons / scale.unit.size, figures=3), scale.unit)


def _draw_at_rest(axes: Axes, mechanism: MechanismResult, window: SketchWindow, locale: Locale) -> None:
    drawing = mechanism.drawing
    axes.set_title(locale.text(say("at rest")), loc="left")
    _draw_support(axes, drawing, window)
    _draw_outlines(axes, drawing, linewidth=0.9)
    _draw_centroids(axes, drawing.centroids)
    if len(drawing.centroids) > 1:
        axes.plot(*drawing.centroid, marker="x", markersize=5, markeredgewidth=1.2, color=INK)
    _draw_loads(axes, drawing.loads, window)
    weights = [((x, z), (x, z - window.arrow)) for x, z in drawing.centroids if drawing.masses_kg]
    for tail, head in weights:
        axes.annotate("", head, xytext=tail, arrowprops={**_ARROW, "color": INK}, annotation_clip=False)
    for hinge, colour in _hinges_with_colour(drawing):
        _draw_hinge(axes, hinge, colour)
    _draw_direction(axes)
    arrows = [_arrow_ends(load, window.arrow) for load in drawing.loads if load.towards is not None]
    write_labels(axes, [*_point_names(mechanism, window, locale), *_shafts([*arrows, *weights])])


def _shafts(arrows: Sequence[Sequence[Point]]) -> list[Label]:
    """Return what keeps names off arrows, each given by its ends."""
    return [Label("", (x, z)) for tail, head in arrows for x, z in np.linspace(tail, head, 5).tolist()]


def _hinges_with_colour(drawing: Drawing) -> list[tuple[NamedPoint, str]]:
    """Return the hinges, each with the colour of its branch."""
    count = len(drawing.displaced.hinges)
    colours = [POSITIVE] * count + [NEGATIVE] * (len(drawing.hinges) - count)
    return list(zip(drawing.hinges, colours, strict=True))


def _point_names(mechanism: MechanismResult, window: SketchWindow, locale: Locale) -> list[Label]:
    """Return the names of hinges, centroids and loads at rest with their forces, that of an arrow at its free end."""
    drawing = mechanism.drawing
    masses = drawing.masses_kg or (None,) * len(drawing.centroids)
    weights = ["" if mass is None else f" {force_text(mass * g, locale)}" for mass in masses]
    made = [Label(label(hinge.name, 14), hinge.at, colour) for hinge, colour in _hinges_with_colour(drawing)]
    if len(drawing.centroids) > 1:
        made += [
            Label(f"G{place}{weight}", at)
            for place, (at, weight) in enumerate(zip(drawing.centroids, weights, strict=True), start=1)
        ]
    made.append(Label(f"G{weights[0] if len(weights) == 1 else ''}", drawing.centroid))
    for load, used in zip(drawing.loads, mechanism.loads, strict=False):
        tail, head = _arrow_ends(load, window.arrow) or (load.at, load.at)
        at = {"force": tail, "tie": head, "mass": load.at}[load.kind]
        made.append(Label(f"{label(load.name, 18)}: {_load_text(used, locale)}", at, LOAD))
    return made


def _load_text(load: LoadResult, locale: Locale) -> str:
    """Return the force of a load at rest; of one that has none its mass."""
    if load.force_n is not None:
        return force_text(hypot(*load.force_n), locale)
    mass = load.mass_kg or 0.0
    return force_text(mass * g, locale) if load.bearing else locale.text(quantity(mass, "mass", 3))


def _draw_displaced(axes: Axes, mechanism: MechanismResult, window: SketchWindow, locale: Locale) -> None:
    """Draw the mechanism displaced to its positive side over its outlines at rest and on its negative side.

    At its hinges are the reactions with which it starts to move.
    """
    drawing = mechanism.drawing
    displaced, back = drawing.displaced, drawing.displaced_negative
    angle = quantity(displaced.rotation_rad, "rotation", 2)
    axes.set_title(locale.text(say("displaced, φ = {angle}", angle=angle)), loc="left")
    _draw_support(axes, drawing, window)
    for ring in () if back is None else back.blocks:
        axes.add_artist(Polygon(ring, fill=False, edgecolor=NEGATIVE, linewidth=0.7, linestyle=(0, (4, 2))))
    _draw_outlines(axes, displaced, linewidth=0.8)
    for ring in drawing.blocks:
        axes.add_artist(Polygon(ring, fill=False, edgecolor=MUTED, linewidth=0.6, linestyle=(0, (1, 1.5))))
    _draw_centroids(axes, displaced.centroids)
    _draw_loads(axes, displaced.loads, window)
    reactions, arrows = dict(_reactions(mechanism)), []
    for hinge in displaced.hinges:
        size = hypot(*reactions.get(hinge.name, (0.0, 0.0)))
        if size > 0.0:
            along, up = (window.arrow * part / size for part in reactions[hinge.name])
            arrows.append(((hinge.at[0] - along, hinge.at[1] - up), hinge.at))
            axes.annotate(
                "", hinge.at, xytext=arrows[-1][0], arrowprops={**_ARROW, "color": POSITIVE}, annotation_clip=False
            )
        _draw_hinge(axes, hinge, POSITIVE)
    named = [
        Label(f"{label(hinge.name, 14)}{f' {force_text(hypot(*force), locale)}' if force else ''}", hinge.at, POSITIVE)
        for hinge, force in ((each, reactions.get(each.name)) for each in displaced.hinges)
    ]
    write_labels(axes, [*named, *_shafts(arrows)])


def _reactions(mechanism: MechanismResult) -> Iterator[tuple[str, Point]]:
    """Yield the force of each hinge of the positive side on the block that presses there, as motion starts [N]."""
    for force in mechanism.hinge_forces:
        if force.branch == "positive":
            yield force.hinge, (force.horizontal_n, force.vertical_n)


def _draw_outlines(axes: Axes, scene: Drawing | DisplacedDrawing, *, linewidth: float) -> None:
    for ring, block in zip(scene.blocks, scene.block_of, strict=True):
        axes.add_artist(Polygon(ring, facecolor=shade(block), edgecolor=STONE_EDGE, linewidth=linewidth))


def _draw_support(axes: Axes, drawing: Drawing, window: SketchWindow) -> None:
    """Draw the support of the mechanism: masonry that does not move, or level ground, hatched below."""
    for ring in drawing.fixed:
        axes.add_artist(Polygon(ring, facecolor=FIXED, edgecolor=MUTED, linewidth=0.6, zorder=0.6))
    if drawing.fixed:
        return
    low = min(z for _, z in (*(hinge.at for hinge in drawing.hinges), *(p for ring in drawing.blocks for p in ring)))
    left, right = axes.get_xlim()
    step = 0.025 * max(window.size)
    starts = np.arange(left + step, right, step)
    strokes = [((x, low), (x - step, low - step)) for x in starts.tolist()]
    axes.add_collection(LineCollection(strokes, colors=MUTED, linewidths=0.4, zorder=0.5), autolim=False)
    axes.plot([left, right], [low, low], color=INK, linewidth=1.0, zorder=1)


def _draw_hinge(axes: Axes, hinge: NamedPoint, colour: str) -> None:
    axes.plot(*hinge.at, marker="o", markersize=4, color="white", markeredgecolor=colour, markeredgewidth=1.1)


def _draw_centroids(axes: Axes, centroids: Sequence[Point]) -> None:
    for at in centroids:
        axes.plot(*at, marker="+", markersize=6, markeredgewidth=1.0, color=INK)


def _draw_loads(axes: Axes, loads: Sequence[DrawnLoad], window: SketchWindow) -> None:
    """Draw a dot for a mass, an arrow for what has a direction."""
    for load in loads:
        if load.kind == "mass":
            axes.plot(*load.at, marker="o", markersize=4.5, color=LOAD)
        if load.towards is not None:
            tail, head = _arrow_ends(load, window.arrow)
            axes.annotate("", head, xytext=tail, arrowprops={**_ARROW, "color": LOAD}, annotation_clip=False)


def _draw_direction(axes: Axes) -> None:
    """Draw the direction of motion, along +x, as an arrow above the panel."""
    end = 1.0, 1.0 + 7.0 / axes.get_window_extent().height
    axes.annotate(
        "",
        end,
        (-26.0, 0.0),
        "axes fraction",
        "offset points",
        arrowprops={**_ARROW, "color": INK},
        annotation_clip=False,
    )


def _sharp_angle(view: View) -> float:
    """Return the angle between faces from which on their common edge is drawn [rad], larger for scans."""
    return radians(35 if len(view.triangles) == view.given else 65)


def _extend_line(ends: FloatArray, length: float) -> FloatArray:
    """Extend a line, given by its ends [2, 3], by a length [m] at both."""
    way = ends[1] - ends[0]
    step = way * length / (float(np.linalg.norm(way)) or 1.0)
    return np.array([ends[0] - step, ends[1] + step])


def _draw_rotation_axes(axes: Axes, view: View, camera: Camera, lines: Sequence[FloatArray], positive: int) -> None:
    """Draw the axes of rotation, those of the negative side dashed, with names at the end nearer the eye."""
    named: list[FloatArray] = []
    for place, (axis, line) in enumerate(zip(view.axes, lines, strict=True)):
        colour, dash = (POSITIVE, "-") if place < positive else (NEGATIVE, "--")
        seen = camera.project(line)
        far, near = seen[np.argsort(seen[:, 2]), :2]
        axes.plot(*seen[:, :2].T, color=colour, linestyle=dash, linewidth=1.5)
        out = (near - far) / (float(np.linalg.norm(near - far)) or 1.0)
        name = label(axis.name, 14)
        named.append(avoid_names(near + (5.0 + 2.0 * len(name)) * out, named))
        axes.annotate(name, tuple(named[-1]), ha="center", va="center", color=colour, fontsize=7)


def _indices(triangles: IntArray) -> tuple[tuple[int, int, int], ...]:
    return tuple((a, b, c) for a, b, c in triangles.tolist())


def _wires_of_view(view: View, surface: TriangleSurface, positive: int) -> Iterator[Wire]:
    """Yield the sections of a view, its axes of rotation with their names, and the direction of motion."""
    size = float(max(view.size))
    yield from (Wire(rounded_points(np.array(ring)), INK, dashed=True) for ring in view.sections)
    for place, axis in enumerate(view.axes):
        colour, ends = POSITIVE if place < positive else NEGATIVE, _extend_line(np.array(axis.ends), AXIS_BEYOND * size)
        yield Wire(rounded_points(ends), colour, label(axis.name, 14), dashed=place >= positive)
    yield Wire(rounded_points(direction_arrow(surface.vertices, np.array(view.direction), size)), INK, arrow=True)
