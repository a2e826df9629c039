"""The mechanism in its plane of motion, to scale."""

from __future__ import annotations

from math import cos, floor, log10, sin

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import FancyArrowPatch, Polygon

from assess.results import Drawing, MechanismResult, Point
from reports.style import FAIL, INK, MUTED, STONE, STONE_EDGE, label, sheet, styled


def draw(mechanism: MechanismResult) -> Figure:
    """Blocks at rest (shaded) and turned (outline), hinges, loads, centroid, sense of positive rotation, scale bar."""
    drawing = mechanism.drawing
    with styled():
        figure = sheet(3.25, width=4.6)
        axes = figure.subplots()
        for outline in drawing.blocks:
            axes.add_patch(Polygon(outline, facecolor=STONE, edgecolor=STONE_EDGE, linewidth=1.0))
        if len(drawing.blocks) == 1 and drawing.hinges:
            _turned(axes, drawing, 0.5 * mechanism.oscillator.overturning_rad)
        _sense(axes, drawing)
        _ground(axes, drawing)
        _names(axes, drawing)
        _frame(axes, drawing)
        return figure


def turned(point: Point, *, about: Point, angle: float) -> Point:
    """`point` after a rotation by `angle` [rad] about `about` that topples towards +x (clockwise in x-z)."""
    x, z = point[0] - about[0], point[1] - about[1]
    return about[0] + x * cos(angle) + z * sin(angle), about[1] - x * sin(angle) + z * cos(angle)


def _turned(axes: Axes, drawing: Drawing, angle: float) -> None:
    pivot = drawing.hinges[0].at
    ghost = [turned(point, about=pivot, angle=angle) for point in drawing.blocks[0]]
    axes.add_patch(Polygon(ghost, facecolor="none", edgecolor=FAIL, linewidth=0.9, linestyle=(0, (4, 2))))


def _sense(axes: Axes, drawing: Drawing) -> None:
    (left, right), (bottom, top) = _extent(drawing)
    size = max(right - left, top - bottom)
    middle, height = 0.5 * (left + right), top + 0.06 * size
    bow = FancyArrowPatch(
        (middle - 0.04 * size, height),
        (middle + 0.2 * size, height - 0.05 * size),
        connectionstyle="arc3,rad=-0.3",
        arrowstyle="-|>",
        mutation_scale=9,
        color=FAIL,
        linewidth=1.1,
    )
    axes.add_patch(bow)
    axes.annotate("+φ", (middle + 0.22 * size, height - 0.03 * size), color=FAIL, fontsize=8)


def _ground(axes: Axes, drawing: Drawing) -> None:
    xs, zs = _extent(drawing)
    margin = 0.25 * max(xs[1] - xs[0], 0.3 * (zs[1] - zs[0]))
    axes.plot([xs[0] - margin, xs[1] + margin], [zs[0], zs[0]], color=INK, linewidth=1.2, zorder=1)


def _names(axes: Axes, drawing: Drawing) -> None:
    axes.plot(*drawing.centroid, marker="+", markersize=9, markeredgewidth=1.3, color=INK)
    axes.annotate("G", drawing.centroid, xytext=(-10, 4), textcoords="offset points", fontsize=8)
    for place, hinge in enumerate(drawing.hinges):
        axes.plot(*hinge.at, marker="o", markersize=5.5, color="white", markeredgecolor=INK, markeredgewidth=1.2)
        side = -1 if place % 2 else 1
        align = "left" if side > 0 else "right"
        axes.annotate(
            label(hinge.name, 14), hinge.at, xytext=(6 * side, -11), textcoords="offset points", ha=align, fontsize=8
        )
    for load in drawing.loads:
        axes.plot(*load.at, marker="v", markersize=5.5, color=MUTED)
        axes.annotate(label(load.name, 18), load.at, xytext=(6, 5), textcoords="offset points", color=MUTED)


def _frame(axes: Axes, drawing: Drawing) -> None:
    xs, zs = _extent(drawing)
    size = max(xs[1] - xs[0], zs[1] - zs[0])
    half = max(0.62 * (xs[1] - xs[0]), 0.55 * size)
    middle = 0.5 * (xs[0] + xs[1])
    axes.set_xlim(middle - half, middle + half)
    axes.set_ylim(zs[0] - 0.17 * size, zs[1] + 0.13 * size)
    axes.set_aspect("equal")
    axes.grid(visible=False)
    axes.set(xlabel="distance along the direction of motion x [m]", ylabel="elevation z [m]")
    _scale_bar(axes, left=middle - 0.94 * half, base=zs[0] - 0.13 * size, length=scale_length(size))


def scale_length(size: float) -> float:
    """A round length (1, 2 or 5 times a power of ten) of about a quarter of `size` [same unit]."""
    power = 10.0 ** floor(log10(size / 4))
    return max(step * power for step in (1, 2, 5) if step * power <= size / 4)


def _scale_bar(axes: Axes, *, left: float, base: float, length: float) -> None:
    axes.plot([left, left + length], [base, base], color=INK, linewidth=2.5, solid_capstyle="butt")
    axes.annotate(
        f"{length:g} m", (left + length / 2, base), xytext=(0, 4), textcoords="offset points", ha="center", fontsize=7
    )
    arrow = {"arrowstyle": "-|>", "color": INK, "linewidth": 1.0, "shrinkA": 2, "shrinkB": 0}
    axes.annotate(
        "", (0.97, 0.06), xytext=(0.84, 0.06), xycoords="axes fraction", textcoords="axes fraction", arrowprops=arrow
    )
    axes.annotate("direction", (0.83, 0.06), xycoords="axes fraction", ha="right", va="center")


def _extent(drawing: Drawing) -> tuple[tuple[float, float], tuple[float, float]]:
    points = [point for outline in drawing.blocks for point in outline]
    points += [drawing.centroid, *(hinge.at for hinge in drawing.hinges), *(load.at for load in drawing.loads)]
    xs, zs = [x for x, _ in points], [z for _, z in points]
    width = max(max(xs) - min(xs), max(zs) - min(zs), 1e-6)
    return (min(xs), max(max(xs), min(xs) + 1e-3 * width)), (min(zs), max(max(zs), min(zs) + 1e-3 * width))
