"""Draw the pictures of README.md and docs/: a rocking wall with its oscillator, the signs, the waist, the verdict.

    make figures        SVG in docs/images, beside this file

Usage: python docs/images/draw.py [FOLDER]
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from math import atan2, cos, degrees, sin
from pathlib import Path

import matplotlib as mpl
import numpy as np
from flow import draw_verdict
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Arc, FancyArrowPatch, FancyBboxPatch, Polygon
from placing import draw_placing
from scipy.constants import g

import assess
from assess import Block, Record
from assess.oscillator import Oscillator
from records.synthetic import artificial_records

THICKNESS, LENGTH, HEIGHT, DENSITY = 0.6, 4.0, 4.5, 2000.0  # m, kg/m3: the wall of README.md
SCALES = (1.0, 1.4)  # of the record in the picture of the wall: the wall stays up, and overturns
INK, MUTED, GRID, STONE, GHOST = "#1b2733", "#6b7680", "#d7dce1", "#d9cdb8", "#f1ece2"
RED, BLUE, GREEN = "#c1121f", "#0072b2", "#00694c"
LOOK = {
    "font.size": 8,
    "axes.titlesize": 9,
    "axes.titleweight": "bold",
    "axes.edgecolor": MUTED,
    "axes.linewidth": 0.7,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "text.color": INK,
    "axes.labelcolor": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "svg.hashsalt": "assess",
    "svg.fonttype": "path",
}
Point = tuple[float, float]


def main(folder: Path) -> None:
    """Draw every picture into a folder and print its path."""
    folder.mkdir(parents=True, exist_ok=True)
    with mpl.rc_context(LOOK):
        for name, draw in PICTURES.items():
            path = folder / f"{name}.svg"
            draw().savefig(path, metadata={"Date": None, "Creator": "assess"})
            path.write_text("\n".join(line.rstrip() for line in path.read_text().splitlines()) + "\n")
            print(path)


def draw_wall() -> Figure:
    """Return the picture of README.md: the wall, its restoring moment, its rotation under one record at two scales."""
    figure = Figure(figsize=(8.6, 2.9), layout="constrained")
    wall, curve, history = figure.subplots(1, 3, width_ratios=(0.75, 1.0, 1.45))
    block, alpha = wall_block(), atan2(THICKNESS, HEIGHT)
    _draw_rocking_wall(wall, rotation=0.6 * alpha)
    _draw_restoring_moment(curve, block.rocking)
    _draw_histories(history, block, ground())
    return figure


def wall_block() -> Block:
    """Return the wall of README.md as a block that rocks about the edges of its base."""
    wall = assess.box(thickness=THICKNESS, length=LENGTH, height=HEIGHT, density=DENSITY)
    return assess.single_block(wall, direction="weakest")


def ground() -> Record:
    """Return an artificial record for the EN 1998-1 spectrum of README.md."""
    return artificial_records(assess.spectrum("ec8", a_g=0.25 * g, ground_type="C"), count=1, seed=1)[0]


def _draw_rocking_wall(axes: Axes, *, rotation: float) -> None:
    axes.set(title="The wall rocks …", aspect="equal", xlim=(-1.3, 2.2), ylim=(-1.0, 5.4))
    axes.axis("off")
    hinge = (THICKNESS / 2, 0.0)
    corners = [(-THICKNESS / 2, 0.0), hinge, (THICKNESS / 2, HEIGHT), (-THICKNESS / 2, HEIGHT)]
    axes.add_patch(Polygon(corners, facecolor=GHOST, edgecolor=MUTED, lw=0.7, ls="--"))
    turned = [turn(corner, hinge, rotation) for corner in corners]
    axes.add_patch(Polygon(turned, facecolor=STONE, edgecolor=INK, lw=1.0))
    axes.plot([-1.2, 2.1], [0, 0], color=INK, lw=1.0)
    centroid = turn((0.0, HEIGHT / 2), hinge, rotation)
    axes.plot(*zip(hinge, centroid, strict=True), color=INK, lw=0.8)
    axes.plot(*centroid, "o", color=INK, ms=3.5)
    axes.plot(*hinge, "o", color=RED, ms=5)
    _write(axes, (centroid[0] - 0.22, centroid[1] * 0.58), "R")
    _turn_mark(axes, hinge, 3.4, 90.0 - degrees(rotation), 90.0, r"$\varphi$")
    _arrow(axes, (-0.75, -0.45), (0.75, -0.45), BLUE)
    _write(axes, (0.0, -0.8), r"ground acceleration $\ddot u_g$", color=BLUE)


def _draw_restoring_moment(axes: Axes, of: Oscillator) -> None:
    axes.set(title="… as one oscillator …", xlabel=r"rotation $\varphi$ [rad]", ylabel="restoring moment [kN m]")
    for branch, sign, colour in ((of.positive, 1.0, RED), (of.negative, -1.0, RED)):
        assert branch is not None
        axes.plot([0, *(sign * branch.rotation)], [0, *(sign * branch.restoring / 1e3)], color=colour, lw=1.6)
        axes.plot(sign * branch.overturning, 0, "o", color=INK, ms=4)
    alpha, top = atan2(THICKNESS, HEIGHT), float(of.positive.restoring[0]) / 1e3
    axes.axhline(0, color=GRID, lw=0.8, zorder=0)
    axes.axvline(0, color=GRID, lw=0.8, zorder=0)
    axes.annotate(r"overturns: $\varphi_{ov}$", (alpha, 0), (0.25 * alpha, -0.5 * top), arrowprops=_leader())
    axes.annotate("lifts off", (0, top), (0.35 * alpha, 1.04 * top), arrowprops=_leader(), va="center")
    axes.set(xlim=(-1.25 * alpha, 1.25 * alpha), ylim=(-1.2 * top, 1.2 * top))


def _draw_histories(axes: Axes, block: Block, record: Record) -> None:
    axes.set(title="… and stays up, or does not", xlabel="time [s]", ylabel=r"rotation $\varphi\,/\,\varphi_{ov}$ [–]")
    axes.axhspan(1.0, 2.0, color="#fbe9e7", lw=0)
    axes.axhspan(-2.0, -1.0, color="#fbe9e7", lw=0)
    overturning = block.oscillator.overturning
    for scale, colour in reversed(list(zip(SCALES, (GREEN, RED), strict=True))):
        motion = assess.respond(block, record, scale=scale)
        peak = f"{scale * record.pga / g:.2f} g"
        axes.plot(
            motion.time, motion.rotation / overturning, color=colour, lw=1.1, label=f"peak ground acceleration {peak}"
        )
    axes.set(ylim=(-1.35, 1.35), xlim=(0, record.time[-1]))
    axes.legend(loc="lower right", frameon=False, fontsize=7)


def draw_signs() -> Figure:
    """Return the figure of signs: direction, rotation of either branch, record, restoring moment."""
    figure = Figure(figsize=(8.6, 3.3), layout="constrained")
    for axes, sign in zip(figure.subplots(1, 2), (1.0, -1.0), strict=True):
        _draw_branch(axes, sign)
    return figure


def _draw_branch(axes: Axes, sign: float) -> None:
    """One branch: the block leans by a rotation of that sign."""
    axes.set(aspect="equal", xlim=(-3.4, 3.4), ylim=(-1.05, 3.6))
    axes.axis("off")
    axes.set_title("positive branch" if sign > 0 else "negative branch, in its own mirrored sign")
    half, height, angle = 0.45, 2.6, 0.16
    hinge = (sign * half, 0.0)
    corners = [(-half, 0.0), (half, 0.0), (half, height), (-half, height)]
    axes.add_patch(Polygon(corners, facecolor=GHOST, edgecolor=MUTED, lw=0.7, ls="--"))
    turned = [turn(corner, hinge, sign * angle) for corner in corners]
    axes.add_patch(Polygon(turned, facecolor=STONE, edgecolor=INK, lw=1.0))
    axes.plot([-3.2, 3.2], [0, 0], color=INK, lw=1.0)
    axes.plot(*hinge, "o", color=RED, ms=5)
    _write(axes, (hinge[0] + 0.22 * sign, -0.25), "A" if sign > 0 else "A'", color=RED)
    centroid = turn((0.0, height / 2), hinge, sign * angle)
    _arrow(axes, centroid, (centroid[0], centroid[1] - 0.8), INK)
    _write(axes, (centroid[0] - 0.3 * sign, centroid[1] - 0.75), "m g")
    _arrow(axes, centroid, (centroid[0] + 0.95 * sign, centroid[1]), BLUE)
    _write(axes, (centroid[0] + 1.45 * sign, centroid[1] + 0.3), "inertia force m |ü|", color=BLUE)
    _arrow(axes, (-1.5 + 0.7 * sign, -0.35), (-1.5 - 0.7 * sign, -0.35), BLUE)
    _write(axes, (-1.5, -0.72), "ground " + ("ü < 0" if sign > 0 else "ü > 0"), color=BLUE)
    _arrow(axes, (1.5, -0.35), (2.9, -0.35), INK)
    _write(axes, (2.2, -0.72), "+ direction")
    if sign > 0:
        _turn_mark(axes, hinge, 2.9, 90.0 - degrees(angle), 90.0, r"$\varphi \geq 0$")
    else:
        _turn_mark(axes, hinge, 2.9, 90.0, 90.0 + degrees(angle), r"$\varphi \geq 0$")
    axes.annotate(
        "restoring > 0\nbrings it back", hinge, (2.0 * sign, 0.75), color=GREEN, ha="center", va="center", fontsize=8
    )


def draw_waist() -> Figure:
    """Return the hourglass: what leads to the oscillator above, what reads it below."""
    figure = Figure(figsize=(8.6, 4.3))
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set(xlim=(0, 86), ylim=(0, 43))
    axes.axis("off")
    axes.add_patch(Polygon([(4, 42), (82, 42), (51, 21.5), (82, 1), (4, 1), (35, 21.5)], facecolor=GHOST, lw=0))
    _row(axes, 38, ["geometry", "model", "loads", "interfaces"], width=15)
    _row(axes, 30, ["mechanisms: one planar chain of blocks"], width=36)
    _row(axes, 21.5, ["oscillator"], width=17, colour="#f6d9d5")
    _row(axes, 13, ["dynamics", "amplification", "codes"], width=15)
    _row(axes, 5, ["study: histories, checks, sweeps  →  results  →  reports"], width=50)
    for top, bottom in ((35.5, 32.5), (27.5, 24), (19, 15.5), (10.5, 7.5)):
        _arrow(axes, (43, top), (43, bottom), MUTED)
    axes.text(54, 21.5, "two branches, each a table over φ:\nI(φ), restoring(φ), B(φ), C(φ)", va="center", color=RED)
    axes.text(83, 31, "knows of blocks\nand meshes;\nnot of codes", ha="right", va="center", color=MUTED)
    axes.text(83, 12, "knows of codes\nand records;\nnot of blocks", ha="right", va="center", color=MUTED)
    return figure


def _row(axes: Axes, height: float, words: Sequence[str], *, width: float, colour: str = "white") -> None:
    """Boxes side by side about the middle."""
    for place, word in enumerate(words):
        x = 43 + (place - (len(words) - 1) / 2) * (width + 2)
        shape = FancyBboxPatch((x - width / 2, height - 2), width, 4, boxstyle="round,pad=0.3", fc=colour, ec=MUTED)
        axes.add_patch(shape)
        axes.text(x, height, word, ha="center", va="center", fontsize=9)


def turn(point: Point, hinge: Point, rotation: float) -> Point:
    """Return a point turned about a hinge, clockwise for a positive rotation [rad]."""
    x, z = point[0] - hinge[0], point[1] - hinge[1]
    return hinge[0] + x * cos(rotation) + z * sin(rotation), hinge[1] - x * sin(rotation) + z * cos(rotation)


def _turn_mark(axes: Axes, centre: Point, radius: float, start: float, end: float, word: str) -> None:
    """An arc between two angles from the horizontal [deg], with its name beyond it and the upright as a dotted line."""
    axes.plot([centre[0]] * 2, [centre[1], centre[1] + radius * 1.08], color=MUTED, lw=0.7, ls=":")
    axes.add_patch(Arc(centre, 2 * radius, 2 * radius, theta1=start, theta2=end, color=RED, lw=1.2))
    middle = np.radians((start + end) / 2)
    at = (centre[0] + 1.1 * radius * np.cos(middle), centre[1] + 1.1 * radius * np.sin(middle))
    _write(axes, at, word, color=RED)


def _arrow(axes: Axes, start: Point, end: Point, colour: str) -> None:
    axes.add_patch(FancyArrowPatch(start, end, arrowstyle="-|>", mutation_scale=9, color=colour, lw=1.2))


def _write(axes: Axes, at: Point, word: str, *, color: str = INK) -> None:
    axes.text(*at, word, color=color, ha="center", va="center")


def _leader() -> dict[str, object]:
    return {"arrowstyle": "-", "color": MUTED, "lw": 0.6}


PICTURES: dict[str, Callable[[], Figure]] = {
    "wall": draw_wall,
    "signs": draw_signs,
    "waist": draw_waist,
    "verdict": draw_verdict,
    "placing": draw_placing,
}


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent)
