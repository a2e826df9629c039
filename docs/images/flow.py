"""The picture of docs/verdict.md: how one answer out of many becomes the verdict of a mechanism and of the building."""

from __future__ import annotations

from dataclasses import dataclass

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import FancyArrowPatch, FancyBboxPatch

MUTED, PAPER = "#6b7680", "#f3f5f7"
OUTCOMES = {"pass": "#9fd3bf", "fail": "#e9a592", "incomplete": "#ecd08a"}


@dataclass(frozen=True)
class Question:
    """A question of the flow: what `no` leads to; `yes` leads to the next."""

    text: str
    no: str
    why: str


QUESTIONS = (
    Question("Does the site give its own action\nat the limit state of the basis?", "incomplete", "keys are listed"),
    Question("Is a method that the basis accepts\nrequested and answered?", "incomplete", "what is missing is listed"),
    Question("Does the most refined such answer\nhold, demand ≤ capacity?", "fail", "the index tells by how much"),
    Question("Is everything known\nthat its clause relies on?", "incomplete", "conservative values beside it"),
)


def draw_verdict() -> Figure:
    """Return the questions that lead to the verdict, from top to bottom."""
    figure = Figure(figsize=(8.6, 4.6))
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set(xlim=(0, 86), ylim=(0, 46))
    axes.axis("off")
    for place, question in enumerate(QUESTIONS):
        y = 41 - 10 * place
        _box(axes, (24, y), 38, question.text, PAPER)
        _box(axes, (68, y), 22, f"{question.no}\n{question.why}", OUTCOMES[question.no])
        _arrow(axes, (43.5, y), (56.5, y), "no")
        _arrow(axes, (24, y - 3.3), (24, y - 6.7), "yes")
    _box(axes, (24, 2.5), 38, "pass: the building is as bad as its worst mechanism", OUTCOMES["pass"], height=3.6)
    return figure


def _box(axes: Axes, at: tuple[float, float], width: float, text: str, colour: str, height: float = 6.0) -> None:
    """A box about its middle."""
    corner = (at[0] - width / 2, at[1] - height / 2)
    axes.add_patch(FancyBboxPatch(corner, width, height, boxstyle="round,pad=0.2", fc=colour, ec=MUTED, lw=0.7))
    axes.text(*at, text, ha="center", va="center", fontsize=9)


def _arrow(axes: Axes, start: tuple[float, float], end: tuple[float, float], word: str) -> None:
    axes.add_patch(FancyArrowPatch(start, end, arrowstyle="-|>", mutation_scale=10, color=MUTED, lw=1.1))
    middle = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2)
    upright = start[0] == end[0]
    axes.text(middle[0] + (1.0 if upright else 0), middle[1] + (0 if upright else 0.9), word, fontsize=8, color=MUTED,
              ha="left" if upright else "center", va="center" if upright else "bottom")  # fmt: skip
