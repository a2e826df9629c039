"""Figures of rigid, semi-flexible and flexible joints beside each other, for the cases of thesis chapter 7.

    make figures        PNG and SVG in build/figures

Free rocking as its Figs. 7.3, 7.4 and 7.13, histories as its Figs. 7.15, 7.20 and 7.22. Its records are not at hand:
the ground here is an artificial record for a design spectrum.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache, partial
from math import atan2
from pathlib import Path
from textwrap import fill

import numpy as np
from chapter_7 import RELEASE, SCALES, SEEDS, SLENDERNESSES, STIFFNESSES, frame, motion, storey, suites, wall
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from scipy.constants import g

from assess.dynamics.history import Trace, trace
from assess.oscillator import Oscillator
from records.record import Record, make_record
from records.synthetic import artificial_records
from reports.figures.style import FAIL, INK, MUTED, report_style, sheet
from reports.language.locale import Locale
from reports.render.vector import write_figure
from spectra.asce7 import design_spectrum

FOLDER = Path("build/figures")
STEP = 0.005  # s, between the points of a curve in free rocking
HISTORY_STIFFNESSES = (170e6, 680e6, 1350e6)  # Pa/m, of Fig. 7.19
LEVEL = 0.3 * g  # m/s2: peak acceleration under which a wall and frames are set
OVER_UPLIFT = 4.50 / 2.75  # of the thesis' record: its scale over that which lifts the rigid wall of two blocks off
BEYOND = 1.25  # of the slenderness: where a curve that overturns is cut
PENS = {  # colour, width, dash; the semi-flexible one is drawn over the flexible one, which it nearly covers
    "rigid": (MUTED, 0.9, "-"),
    "flexible": ("#e69f00", 2.2, "-"),
    "semi-flexible": ("#0072b2", 0.9, (0, (4, 2))),
}


@dataclass(frozen=True)
class Panel:
    """One panel: a mechanism on joints of each model, and the slenderness its rotations are divided by [rad]."""

    title: str
    make: Callable[[str], Oscillator]
    slenderness: float


Curve = Callable[[Panel, str], Trace]


def wall_of(stiffness: float) -> Panel:
    """The wall of 1 x 2 x 6 m on joints of a stiffness [Pa/m]."""
    return Panel(stiff(stiffness), partial(wall, stiffness), atan2(0.5, 3.0))


def storey_under(load: float) -> Panel:
    """The wall of two blocks under a load over its weight."""
    alpha = storey(340e6, "rigid", over=load)[1]
    return Panel(f"F = {load:g} W", lambda model: storey(340e6, model, over=load)[0], alpha)


def stiff(stiffness: float) -> str:
    """A stiffness as a title."""
    return f"kₙ = {stiffness / 1e6:g} MPa/m"


def released(case: Panel, model: str, *, duration: float) -> Trace:
    """Let go at 0.8 of its slenderness, on still ground."""
    still = make_record("still ground", np.zeros(round(duration / STEP) + 1), STEP)
    return trace(case.make(model), still, scale=1.0, equation="exact", release=RELEASE * case.slenderness)


def under_record(case: Panel, model: str, *, level: float) -> Trace:
    """Under the artificial record at a peak ground acceleration [m/s2]."""
    return trace(case.make(model), ground(), scale=level / ground().pga, equation="exact")


@cache
def ground() -> Record:
    """The artificial record of all histories: S_DS 1.0 g, S_D1 0.6 g, 20 s."""
    return artificial_records(design_spectrum(s_ds=1.0 * g, s_d1=0.6 * g, t_l=6.0), count=1, seed=7)[0]


def free_figure(caption: str, cases: list[Panel], *, duration: float) -> Figure:
    """Rotation over time of every case, released."""
    with report_style():
        figure = sheet(0.9 + 1.15 * len(cases), Locale())
        rows = figure.subplots(len(cases), 1, sharex=True, squeeze=False)[:, 0]
        finished(figure, rows, cases, partial(released, duration=duration), caption)
        rows[-1].set_xlim(0.0, duration)
        return figure


def history_figure(caption: str, cases: list[Panel], *, level: float, until: float = 20.0) -> Figure:
    """The ground's acceleration [g], and below it the rotation of every case under it, for so long [s]."""
    with report_style():
        figure = sheet(1.7 + 1.25 * len(cases), Locale())
        above, *rows = figure.subplots(len(cases) + 1, 1, sharex=True)
        above.plot(ground().time, ground().acceleration * (level / ground().pga / g), color=INK, linewidth=0.6)
        above.set(ylabel="ground [g]", title=f"artificial record, peak {level / g:.3g} g")
        finished(figure, rows, cases, partial(under_record, level=level), caption)
        above.set_xlim(0.0, until)
        return figure


def finished(figure: Figure, rows: list[Axes], cases: list[Panel], curve: Curve, caption: str) -> None:
    """The panels with their curves, the legend above and the caption below."""
    named = {}
    for axes, case in zip(rows, cases, strict=True):
        for model, time, ratio, fell in curves(case, curve):
            colour, width, dash = PENS[model]
            named[model] = axes.plot(time, ratio, color=colour, linewidth=width, linestyle=dash)[0]
            if fell:
                named["overturns"] = axes.plot(time[-1:], ratio[-1:], "x", color=FAIL, clip_on=False, zorder=4)[0]
        axes.set(ylabel="φ / α₀ [-]", title=case.title)
    largest = 1.15 * max(np.abs(line.get_ydata()).max() for axes in rows for line in axes.lines)
    for axes in rows:
        axes.set_ylim(-min(largest, BEYOND), min(largest, BEYOND))
    rows[-1].set_xlabel("time t [s]")
    figure.legend(list(named.values()), list(named), loc="outside upper right", ncols=4)
    figure.supxlabel(fill(caption, 128), x=0.01, ha="left", fontsize=7)


def curves(case: Panel, curve: Curve) -> Iterator[tuple[str, np.ndarray, np.ndarray, bool]]:
    """Of each model: its name, time [s], rotation over slenderness [-] as far as BEYOND, and whether it goes there."""
    for model in PENS:
        found = curve(case, model)
        ratio = found.rotation / case.slenderness
        beyond = np.flatnonzero(np.abs(ratio) > BEYOND)
        end = beyond[0] if beyond.size else ratio.size
        yield model, found.time[:end], ratio[:end], bool(beyond.size)


NEAR = "the curve of semi-flexible joints nearly covers that of flexible ones"
UNLIKE = (
    "one ratio of velocities keeps 0.81 of the energy on flexible joints, where both directions begin about one point, "
    "but 0.86 and 0.76 in turn about fixed hinges, rigid or semi-flexible, about which the inertia differs"
)
BLOCKS = "fₘ = 1.28 MPa, density 1800 kg/m³"
RECORD = "under an artificial record in place of the thesis'"
CHANCE = (
    "One history is chance: once an impact has come out otherwise the curves part, so tests judge the models by the "
    "statistics of many"
)


def of_walls() -> Iterator[tuple[str, Figure]]:
    """Single blocks (7.2.2)."""
    yield (
        "7-03-wall-released-by-stiffness",
        free_figure(
            f"As thesis Fig. 7.3: a wall of 1 × 2 × 6 m let go at 0.8 α₀, {BLOCKS}; {NEAR}, and the rigid wall comes "
            "to rest sooner, the less so the stiffer the joint.",
            [wall_of(k) for k in STIFFNESSES],
            duration=25.0,
        ),
    )
    yield (
        "7-04-wall-released-by-slenderness",
        free_figure(
            f"As thesis Fig. 7.4: walls of one radius, 3.04 m, let go at 0.8 α₀, kₙ = 340 MPa/m, {BLOCKS}; {NEAR}.",
            [Panel(f"α₀ = {alpha:.2f} rad", partial(wall, 340e6, slenderness=alpha), alpha) for alpha in SLENDERNESSES],
            duration=25.0,
        ),
    )
    yield (
        "7-wall-history",
        history_figure(
            f"The wall of 1 × 2 × 6 m {RECORD}, {BLOCKS}. {CHANCE}.",
            [wall_of(k) for k in HISTORY_STIFFNESSES],
            level=LEVEL,
        ),
    )


def of_storeys() -> Iterator[tuple[str, Figure]]:
    """Walls of two blocks (7.3.2, 7.3.3)."""
    walled = "a wall of 0.4 × 1 × 3 m, cracked by eq. 3.27 under a load F that presses at hinge C"
    yield (
        "7-13-two-block-released",
        free_figure(
            f"As thesis Figs. 7.12 and 7.13: {walled}, let go at 0.8 α₀ of its lower block, kₙ = 340 MPa/m, {BLOCKS}; "
            f"{NEAR}. Under more load it comes to rest sooner.",
            [storey_under(load) for load in (0.5, 1.0, 2.0)],
            duration=6.0,
        ),
    )
    rigid = storey(340e6, "rigid")[0].positive
    yield (
        "7-15-two-block-history",
        history_figure(
            f"As thesis Fig. 7.15: {walled}, {RECORD}, at {OVER_UPLIFT:.3g} times the acceleration that lifts the "
            f"rigid wall off, as there; kₙ = 340 MPa/m, {BLOCKS}. The rigid wall begins to move when the others fall.",
            [storey_under(2.0)],
            level=OVER_UPLIFT * rigid.restoring[0] / rigid.excitation[0],
            until=5.0,
        ),
    )


def of_frames() -> Iterator[tuple[str, Figure]]:
    """Four hinges (7.4.1)."""
    for number, even, form, remark in (
        (20, True, "a frame of two columns of 0.8 × 1 × 4 m", NEAR),
        (22, False, "a frame of unlike columns on two levels, restitution 0.90,", UNLIKE),
    ):
        cases = [Panel(stiff(k), partial(frame, k, even=even), atan2(0.8, 4.0)) for k in HISTORY_STIFFNESSES]
        yield (
            f"7-{number}-frame-released",
            free_figure(
                f"{form.capitalize()} of the kind of thesis Fig. 7.17 let go at 0.8 α₀ of its first column, {BLOCKS}; "
                f"{remark}.",
                cases,
                duration=20.0,
            ),
        )
        yield (
            f"7-{number}-frame-history",
            history_figure(
                f"As thesis Fig. 7.{number}: {form} of the kind of Fig. 7.17 {RECORD}, {BLOCKS}. {CHANCE}.",
                cases,
                level=LEVEL,
            ),
        )


def of_suites() -> Iterator[tuple[str, Figure]]:
    """Largest rotations of frames under many motions, of which one history is an instance."""
    with report_style():
        figure = sheet(4.1, Locale())
        told = []
        for axes, even in zip(figure.subplots(1, 2), (True, False), strict=True):
            told.append(peaks_panel(axes, even=even))
            axes.set(title="columns alike" if even else "columns unlike, restitution 0.90")
        caption = (
            f"Largest rotations of frames under {len(SEEDS)} motions of noise, peak {SCALES[0]} and {SCALES[1]} m/s², "
            f"on joints of 170, 680 and 2700 MPa/m, {BLOCKS}. Semi-flexible over flexible, columns alike: {told[0]}; "
            f"unlike: {told[1]}. Crosses: overturned by one model or both."
        )
        figure.supxlabel(fill(caption, 128), x=0.01, ha="left", fontsize=7)
    yield "7-frames-peaks", figure


def peaks_panel(axes: Axes, *, even: bool) -> str:
    """Semi-flexible over flexible peaks / phi_ov, and a summary in words."""
    ratio, over = suites([motion(seed) for seed in SEEDS], SCALES, even=even)
    stood = ~over.any(axis=0)
    axes.plot([0.0, 1.1], [0.0, 1.1], color=MUTED, linewidth=0.7)
    axes.plot(*ratio[:, stood], "o", color=PENS["semi-flexible"][0], markersize=3, alpha=0.7)
    axes.plot(*np.where(over, 1.06, ratio)[:, ~stood], "x", color=FAIL, markersize=4)
    axes.set(xlabel="flexible, largest φ / φₒᵥ [-]", ylabel="semi-flexible, largest φ / φₒᵥ [-]", aspect="equal")
    axes.set(xlim=(0.0, 1.1), ylim=(0.0, 1.1))
    rocked = stood & (ratio > 0.02).all(axis=0)
    median = np.median(ratio[1][rocked] / ratio[0][rocked])
    return f"median {median:.3f}, {over[1].sum()} and {over[0].sum()} of {over.shape[1]} overturned"


def written(name: str, figure: Figure, folder: Path) -> list[Path]:
    """The figure as PNG and SVG in an existing folder; the paths."""
    return [write_figure(figure, folder / f"{name}{ending}", creator="assess") for ending in (".png", ".svg")]


def main(folder: Path = FOLDER) -> None:
    """Every figure into the folder."""
    folder.mkdir(parents=True, exist_ok=True)
    for group in (of_walls, of_storeys, of_frames, of_suites):
        for name, figure in group():
            print(*written(name, figure, folder))  # noqa: T201


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:2]))
