"""The picture of docs/own-model.md: what `at`, `share`, `tolerance`, `seat` and `base_elevation` measure."""

from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Polygon, Rectangle

INK, MUTED, STONE, TIMBER, BLUE, RED = "#1b2733", "#6b7680", "#d9cdb8", "#c9a66b", "#0072b2", "#c1121f"
Point = tuple[float, float]


def draw_placing() -> Figure:
    """Return four sections: a load's place, its share, its seat, and a base above the ground."""
    figure = Figure(figsize=(8.6, 5.4), layout="constrained")
    panels = figure.subplots(2, 2)
    draws = (_draw_place, _draw_share, _draw_seat, _draw_base_elevation)
    for axes, draw in zip(panels.flat, draws, strict=True):
        axes.set_aspect("equal")
        axes.axis("off")
        draw(axes)
    return figure


def _draw_place(axes: Axes) -> None:
    axes.set_title('at = ["-0.3 m", "3.1 m"]')
    axes.set(xlim=(-2.2, 3.4), ylim=(-0.8, 4.4))
    _body(axes, -0.5, 0.5, 0.0, 4.0, STONE)
    _ground(axes, -2.0, 3.2, 0.0)
    axes.annotate("", (1.9, 0.0), (0.0, 0.0), arrowprops={"arrowstyle": "-|>", "color": BLUE, "lw": 1.4})
    axes.text(1.95, 0.12, "direction", color=BLUE, fontsize=8)
    axes.plot(0.0, 0.0, "o", color=BLUE, ms=4)
    axes.text(0.3, -0.5, "origin of the model", color=BLUE, fontsize=8)
    axes.plot(-0.3, 3.1, "o", color=RED, ms=5)
    _dimension(axes, (-1.2, 0.0), (-1.2, 3.1), "elevation\n3.1 m")
    _dimension(axes, (-0.3, 3.55), (0.0, 3.55), "")
    axes.text(0.65, 3.5, "−0.3 m along the direction", fontsize=8, color=INK)


def _draw_share(axes: Axes) -> None:
    axes.set_title("share: by statics, or as stated")
    axes.set(xlim=(-1.0, 7.2), ylim=(-1.4, 4.6))
    for left in (0.0, 5.5):
        _body(axes, left, left + 0.5, 0.0, 3.0, STONE)
    _body(axes, 0.1, 5.9, 3.0, 3.3, TIMBER)
    _body(axes, 0.1, 2.4, 3.3, 3.9, TIMBER)
    _ground(axes, -0.8, 7.0, 0.0)
    for x, share in ((0.25, "share = 0.6"), (5.75, "share = 0.4")):
        axes.annotate("", (x, 2.2), (x, 2.95), arrowprops={"arrowstyle": "-|>", "color": RED, "lw": 1.4})
        axes.text(x, -0.75, share, ha="center", fontsize=8)
    axes.annotate("", (2.55, 3.35), (2.55, 4.4), arrowprops={"arrowstyle": "-|>", "color": INK, "lw": 1.2})
    axes.text(2.7, 4.1, "weight of the body", fontsize=8)


def _draw_seat(axes: Axes) -> None:
    axes.set_title("tolerance and seat")
    axes.set(xlim=(-0.55, 0.75), ylim=(-0.55, 0.5))
    _body(axes, -0.25, 0.25, -0.5, 0.0, STONE)
    _body(axes, -0.5, -0.05, 0.03, 0.18, TIMBER)
    _dimension(axes, (0.33, 0.0), (0.33, 0.03), "")
    axes.text(0.37, -0.02, "a gap up to `tolerance`\n(0.01 m) is closed", fontsize=8, va="center")
    axes.plot((-0.05, 0.33), (0.03, 0.03), color=MUTED, lw=0.6, ls=":")
    axes.plot((0.25, 0.33), (0.0, 0.0), color=MUTED, lw=0.6, ls=":")
    _dimension(axes, (-0.25, 0.27), (-0.05, 0.27), "seat")
    axes.plot((-0.25, -0.25), (0.0, 0.3), color=MUTED, lw=0.6, ls=":")
    axes.plot((-0.05, -0.05), (0.18, 0.3), color=MUTED, lw=0.6, ls=":")
    axes.text(-0.5, 0.4, "the wall may move by so much\nbefore the floor falls off it", fontsize=8, va="center")
    axes.annotate("", (0.62, -0.3), (0.3, -0.3), arrowprops={"arrowstyle": "-|>", "color": BLUE, "lw": 1.4})
    axes.text(0.32, -0.4, "direction", color=BLUE, fontsize=8)


def _draw_base_elevation(axes: Axes) -> None:
    axes.set_title('base_elevation = "6 m"')
    axes.set(xlim=(-1.2, 7.4), ylim=(-1.0, 8.6))
    axes.add_patch(Rectangle((1.0, 0.0), 4.0, 6.0, fill=False, ec=MUTED, lw=0.8, ls="--"))
    axes.text(3.0, 3.0, "building\n(not drawn in\nthe project)", ha="center", va="center", fontsize=8, color=MUTED)
    axes.add_patch(Polygon([(1.0, 6.0), (5.0, 6.0), (3.0, 8.2)], fc=STONE, ec=INK, lw=0.9))
    axes.text(3.0, 6.7, "gable", ha="center", fontsize=8)
    _ground(axes, -1.0, 7.2, 0.0)
    axes.text(5.4, -0.7, "ground", fontsize=8, color=INK)
    _dimension(axes, (0.2, 0.0), (0.2, 6.0), "6 m")
    axes.text(5.2, 6.0, "base of the\nmechanism", fontsize=8, va="center", color=BLUE)
    axes.plot((5.0, 5.15), (6.0, 6.0), color=BLUE, lw=0.8)


def _body(axes: Axes, left: float, right: float, bottom: float, top: float, colour: str) -> None:
    axes.add_patch(Rectangle((left, bottom), right - left, top - bottom, fc=colour, ec=INK, lw=0.9))


def _ground(axes: Axes, left: float, right: float, level: float) -> None:
    axes.plot((left, right), (level, level), color=INK, lw=1.2)


def _dimension(axes: Axes, start: Point, end: Point, word: str) -> None:
    """A dimension line, its word to the left of it or above."""
    axes.annotate("", end, start, arrowprops={"arrowstyle": "<|-|>", "color": INK, "lw": 0.8, "mutation_scale": 7})
    x, y = (start[0] + end[0]) / 2, (start[1] + end[1]) / 2
    if start[0] == end[0]:
        axes.text(x - 0.12, y, word, ha="right", va="center", fontsize=8)
    else:
        axes.text(x, y + 0.02, word, ha="center", va="bottom", fontsize=8)
