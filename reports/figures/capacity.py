"""The capacity curve: restoring moment and load multiplier over rotation."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray
from scipy.constants import g

from assess.results import BranchCurve, MechanismResult
from reports.figures.style import FAIL, MUTED, NEGATIVE, POSITIVE, report_style, sheet

_UNITS = ((1e6, "MN m"), (1e3, "kN m"), (1.0, "N m"))


def draw(mechanism: MechanismResult) -> Figure:
    """Draw restoring moment (left) and lambda = restoring / (g B) (right) over rotation, both branches as mirrored."""
    positive, negative = mechanism.curve.positive, mechanism.curve.negative
    with report_style():
        figure = sheet(2.35)
        moment, multiplier = figure.subplots(1, 2)
        branches = [(positive, POSITIVE, "-", "positive branch")]
        branches += [] if negative is None else [(negative, NEGATIVE, "--", "negative branch, mirrored")]
        size, unit = _unit(positive)
        for branch, colour, dash, name in branches:
            rotation = np.asarray(branch.rotation_rad)
            moment.plot(rotation, np.asarray(branch.restoring_n_m) / size, dash, color=colour, label=name)
            multiplier.plot(rotation, _multiplier(branch), dash, color=colour, label=name)
        _marks(moment, mechanism)
        _marks(multiplier, mechanism)
        moment.set(xlabel="rotation φ [rad]", ylabel=f"restoring moment [{unit}]")
        multiplier.set(xlabel="rotation φ [rad]", ylabel="load multiplier λ [-]")
        for axes in (moment, multiplier):
            axes.xaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 2.5, 5, 10]))
        moment.legend(loc="upper right")
        return figure


def _marks(axes: Axes, mechanism: MechanismResult) -> None:
    axes.axhline(0.0, color=MUTED, linewidth=0.7)
    overturning = mechanism.oscillator.overturning_rad
    axes.plot([overturning], [0.0], marker="o", color=FAIL, markersize=4.5, linestyle="none", clip_on=False)
    axes.annotate("φₒᵥ", (overturning, 0.0), xytext=(4, 5), textcoords="offset points", color=FAIL)
    flexible = mechanism.oscillator.overturning_flexible_rad
    if flexible is not None:
        axes.plot([flexible], [0.0], marker="s", color=FAIL, markersize=4, linestyle="none")
        axes.annotate(
            "φₒᵥ, interface", (flexible, 0.0), xytext=(-4, -10), textcoords="offset points", ha="right", color=FAIL
        )
    axes.set_xlim(left=0.0)


def _multiplier(branch: BranchCurve) -> NDArray[np.float64]:
    excitation = np.asarray(branch.excitation_kg_m)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.where(excitation > 0, np.asarray(branch.restoring_n_m) / (g * excitation), np.nan)


def _unit(branch: BranchCurve) -> tuple[float, str]:
    largest = max((abs(moment) for moment in branch.restoring_n_m), default=0.0)
    return next((pair for pair in _UNITS if largest >= pair[0]), _UNITS[-1])
