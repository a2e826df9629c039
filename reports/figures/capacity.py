"""The capacity curve: load multiplier over rotation, with the restoring moment beside it."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from scipy.constants import g

from assess.results import BranchCurve, MechanismResult
from reports.figures.scale import fitting_scale, table_scale
from reports.figures.style import FAIL, HALF, MUTED, NEGATIVE, POSITIVE, legend_below, report_style, sheet
from reports.language.locale import Locale
from reports.language.texts import Phrase, say
from spectra.arrays import FloatArray

HEIGHT = 2.4  # in


def draw(mechanism: MechanismResult, locale: Locale) -> Figure:
    """Draw restoring moment (above) and lambda = restoring / (g B) (below) over rotation, both branches as mirrored."""
    positive = mechanism.curve.positive
    rotation = table_scale("rotation", locale)
    moment = fitting_scale("moment", positive.restoring_n_m, locale)
    with report_style():
        figure = sheet(HEIGHT, locale, width=HALF)
        above, below = figure.subplots(2, 1, sharex=True)
        for branch, colour, dash, name in _branches(mechanism):
            across, named = rotation.of(branch.rotation_rad), locale.text(name)
            above.plot(across, moment.of(branch.restoring_n_m), dash, color=colour, label=named)
            below.plot(across, _multiplier(branch), dash, color=colour)
        for axes in (above, below):
            axes.axhline(0.0, color=MUTED, linewidth=0.7)
            _overturning(axes, mechanism, locale)
            axes.set_xlim(left=0.0)
            axes.yaxis.set_major_locator(MaxNLocator(4))
        above.set_ylabel(moment.heading(say("moment")))
        below.set_ylabel(locale.heading(say("multiplier λ"), "ratio"))
        below.set_xlabel(rotation.heading(say("rotation φ")))
        below.xaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 2.5, 5, 10]))
        figure.align_ylabels()
        legend_below(figure, columns=2)
        return figure


def _branches(mechanism: MechanismResult) -> list[tuple[BranchCurve, str, str, Phrase]]:
    positive, negative = mechanism.curve.positive, mechanism.curve.negative
    mirrored = [] if negative is None else [(negative, NEGATIVE, "--", say("negative side, mirrored"))]
    return [(positive, POSITIVE, "-", say("positive side")), *mirrored]


def _overturning(axes: Axes, mechanism: MechanismResult, locale: Locale) -> None:
    """Mark the rotations that overturn: of rigid joints, and of the joints in use where these give."""
    marks = [(mechanism.oscillator.overturning_rad, "o", say("rigid joints: φₒᵥ"))]
    if mechanism.oscillator.overturning_flexible_rad is not None:
        marks.append((mechanism.oscillator.overturning_flexible_rad, "s", say("its joints: φₒᵥ")))
    for at, marker, name in marks:
        axes.plot(
            table_scale("rotation", locale).of(at), 0.0, marker=marker, color=FAIL, markersize=4, linestyle="none",
            clip_on=False, label=locale.text(name),
        )  # fmt: skip


def _multiplier(branch: BranchCurve) -> FloatArray:
    excitation = np.asarray(branch.excitation_kg_m)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(np.where(excitation > 0, np.asarray(branch.restoring_n_m) / (g * excitation), np.nan))
