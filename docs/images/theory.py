"""Draw the pictures of the pages on theory: chains of blocks, restitution, capacities of the Italian code.

Usage: python docs/images/theory.py [FOLDER]
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from math import degrees
from pathlib import Path

import matplotlib as mpl
import numpy as np
from draw import BLUE, GHOST, GREEN, GRID, INK, LOOK, MUTED, RED, STONE, Point, wall_block
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Arc, Polygon

from assess.mechanisms.chain import Chain, RigidBlock, move, trace_point
from assess.mechanisms.restitution import housner, sorrentino
from assess.oscillator import RockingBlock, displacement, multiplier

Blocks = tuple[tuple[Point, ...], ...]
CHAINS: dict[str, tuple[Blocks, tuple[Point, ...], float]] = {
    "one block": ((((-0.9, 0), (0, 0), (0, 3), (-0.9, 3)),), ((0, 0),), 0.14),
    "two blocks: C slides on the vertical": (
        (((-0.6, 0), (0, 0), (0, 1.8), (-0.6, 1.8)), ((-0.6, 1.8), (0, 1.8), (0, 3), (-0.6, 3))),
        ((0, 0), (-0.6, 1.8), (0, 3)),
        0.10,
    ),
    "three blocks: D is fixed": (
        (
            ((-0.6, 0), (0, 0), (0, 2.2), (-0.6, 2.2)),
            ((-0.6, 2.2), (2.6, 2.2), (2.6, 2.8), (-0.6, 2.8)),
            ((2.0, 0), (2.6, 0), (2.6, 2.2), (2.0, 2.2)),
        ),
        ((0, 0), (-0.6, 2.2), (2.0, 2.2), (2.6, 0)),
        0.14,
    ),
}


def draw_chains() -> Figure:
    """Return the chains at rest and displaced."""
    figure = Figure(figsize=(8.6, 3.2), layout="constrained")
    for axes, (name, (blocks, hinges, rotation)) in zip(
        figure.subplots(1, 3, width_ratios=(1, 1, 1.5)), CHAINS.items(), strict=True
    ):
        _draw_chain(axes, blocks, hinges, rotation)
        axes.set_title(name)
    return figure


def _draw_chain(axes: Axes, blocks: Blocks, hinges: tuple[Point, ...], rotation: float) -> None:
    """One chain: its blocks at rest in outline, displaced in colour, with hinges and the rotation of the first."""
    axes.set(aspect="equal", xlim=(-1.3, hinges[-1][0] + 1.0), ylim=(-0.7, 3.7))
    axes.axis("off")
    axes.plot([-1.2, hinges[-1][0] + 0.9], [0, 0], color=INK, lw=1.0)
    motion = move(Chain(tuple(RigidBlock(1.0, corners[0], 1.0) for corners in blocks), hinges), np.array([rotation]))
    for number, corners in enumerate(blocks):
        axes.add_patch(Polygon(corners, facecolor=GHOST, edgecolor=MUTED, lw=0.7, ls="--"))
        paths = [trace_point(motion, block=number, at=corner) for corner in corners]
        moved = [(float(path.x[0]), float(path.z[0])) for path in paths]
        axes.add_patch(Polygon(moved, facecolor=STONE, edgecolor=INK, lw=1.0, alpha=0.9))
    for number, (letter, hinge) in enumerate(zip("ABCD", hinges, strict=False)):
        path = trace_point(motion, block=min(max(number - 1, 0), len(blocks) - 1), at=hinge)
        at = float(path.x[0]), float(path.z[0])
        axes.plot(*at, "o", color=RED, ms=5)
        axes.text(at[0] + 0.12, at[1] + (0.12 if number else -0.35), letter, color=RED)
    axes.plot([0, 0], [0, 3.4], color=MUTED, lw=0.7, ls=":")
    axes.add_patch(Arc((0, 0), 6.4, 6.4, theta1=90 - degrees(rotation), theta2=90, color=RED, lw=1.2))
    axes.text(3.2 * np.sin(rotation) + 0.1, 3.2, r"$\varphi$", color=RED)


def draw_restitution() -> Figure:
    """Return the restitution of a rectangle over its slenderness."""
    figure = Figure(figsize=(6.2, 2.9), layout="constrained")
    axes = figure.subplots()
    alpha = np.linspace(0.02, 0.6, 120)
    blocks = [RockingBlock(1.0, 1.0, float(each), 4.0 / 3.0) for each in alpha]
    axes.plot(alpha, [housner(block) for block in blocks], color=RED, lw=1.6)
    axes.plot(alpha, [-sorrentino(block) for block in blocks], color=BLUE, lw=1.6)
    axes.text(0.33, 0.88, "two-sided: Housner 1963", color=RED)
    axes.text(0.20, 0.52, "one-sided, the rebound: Sorrentino et al. 2011", color=BLUE)
    axes.set(xlabel=r"slenderness $\alpha$ of a rectangle [rad]", ylabel=r"restitution $\eta$ [–]", ylim=(0, 1.05))
    axes.grid(color=GRID, lw=0.5)
    return figure


def draw_capacity() -> Figure:
    """Return the capacity curve of the wall of README.md with the capacities of NTC 2018."""
    figure = Figure(figsize=(6.2, 2.9), layout="constrained")
    axes, block = figure.subplots(), wall_block()
    branch = block.rocking.positive
    up = branch.rotation <= branch.overturning * (1 + 1e-9)
    moved = displacement(branch, branch.rotation, mass=block.rocking.mass)[up]
    acceleration = multiplier(branch)[up] / 1.35
    axes.plot([0, *moved], [0, *acceleration], color=INK, lw=1.6)
    for share, word, colour in ((0.4, "SLV", GREEN), (0.6, "SLC", BLUE)):
        at = share * moved[-1]
        height = float(np.interp(at, moved, acceleration))
        axes.plot([at, at], [0, height], color=colour, lw=1.2, ls="--")
        axes.text(at + 0.003, 0.006, rf"$d_{{{word}}}$ = {share} $d_0^*$", color=colour)
        axes.plot([0, at], [height, height], color=colour, lw=0.8, ls=":")
        axes.text(0.003, height + 0.002, rf"$a(d_{{{word}}})$", color=colour)
    axes.annotate(r"$a_0^* = \alpha_0\, g / (e^* FC)$", (0, acceleration[0]), (0.02, acceleration[0] * 1.03))
    axes.text(moved[-1], 0.006, r"$d_0^*$", ha="right")
    axes.set(xlabel="displacement d [m]", ylabel="acceleration a [g]", ylim=(0, 1.15 * float(acceleration[0])))
    axes.set_xlim(0, 1.02 * float(moved[-1]))
    return figure


PICTURES: dict[str, Callable[[], Figure]] = {
    "chains": draw_chains,
    "restitution": draw_restitution,
    "capacity": draw_capacity,
}


def main(folder: Path) -> None:
    """Draw every picture into a folder and print its path."""
    with mpl.rc_context(LOOK):
        for name, draw in PICTURES.items():
            path = folder / f"{name}.svg"
            draw().savefig(path, metadata={"Date": None, "Creator": "assess"})
            path.write_text("\n".join(line.rstrip() for line in path.read_text().splitlines()) + "\n")
            print(path)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent)
