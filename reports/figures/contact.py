"""The contact of each joint over rotation: where the resultant presses, and how hard."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter

from assess.codes.check import BranchName
from assess.results import MechanismResult
from reports import joints
from reports.figures.scale import table_scale
from reports.figures.style import MUTED, label, report_style, sheet
from reports.language.locale import Locale
from reports.language.texts import say

COLOURS = ("#c1121f", "#0072b2", "#009e73", "#e69f00")  # of the hinges A, B, C, D
BEFORE = 0.5  # of the rotation at which a joint opens
SHORTEST = 1e-3  # of the largest rotation drawn
LEAST = 1e-2  # of the largest value: curves that differ by less are one

_PANELS = (
    ("resultant_m", "length", say("resultant from the edge")),
    ("peak_stress_pa", "stress", say("stress at the edge")),
)


def draw(mechanism: MechanismResult, locale: Locale) -> Figure:
    """Draw the distance of the resultant and the peak stress of each joint over the rotation."""
    sides = (mechanism.oscillator, mechanism.oscillator_negative)
    end = max(side.overturning_rad for side in sides if side is not None)
    with report_style():
        figure = sheet(2.2, locale)
        for axes, (key, dimension, name) in zip(figure.subplots(1, 2), _PANELS, strict=True):
            scale = table_scale(dimension, locale)
            for interface, colour, dash, hinges in distinct_curves(mechanism):
                curve = interface["curve"]
                rotation, values = np.asarray(curve["mechanism_rotation_rad"]), scale.of(curve[key])
                axes.plot(rotation, values, dash, color=colour, label=label(hinges))
            axes.set(xlabel=locale.heading(say("rotation φ"), "rotation"), ylabel=scale.heading(name), xscale="log")
            axes.set_xlim(axis_start(mechanism, end), end)
            axes.xaxis.set_minor_formatter(NullFormatter())
            axes.set_ylim(bottom=0.0)
        _strength(axes, mechanism, locale)
        axes.legend(loc="lower right")
        return figure


def axis_start(mechanism: MechanismResult, end: float) -> float:
    """Return the start of the axis of rotations [rad]: before any joint opens, at most a thousandth of its end."""
    opening = [float(found["opening_rad"]) for found in joints.deformable_joints(mechanism) if found["opening_rad"]]
    return min([*(BEFORE * at for at in opening), SHORTEST * end])


def distinct_curves(mechanism: MechanismResult) -> list[tuple[dict[str, Any], str, str, str]]:
    """Return each joint unlike those before it: itself, colour, line, and the hinges that it represents."""
    found: list[tuple[dict[str, Any], str, str, list[str]]] = []
    branches: tuple[tuple[BranchName, str], ...] = (("positive", "-"), ("negative", "--"))
    for branch, dash in branches:
        for place, interface in enumerate(joints.joints_of_branch(mechanism, branch)):
            like = next((hinges for other, _, _, hinges in found if are_alike(interface, other)), None)
            if like is None:
                found.append((interface, COLOURS[place % len(COLOURS)], dash, [interface["hinge"]]))
            else:
                like.append(interface["hinge"])
    return [(interface, colour, dash, ", ".join(hinges)) for interface, colour, dash, hinges in found]


def are_alike(one: dict[str, Any], other: dict[str, Any]) -> bool:
    """Return whether two joints have the same curves, to the eye."""
    return all(_same_curve(one["curve"], other["curve"], key) for key, _, _ in _PANELS)


def _same_curve(one: dict[str, Any], other: dict[str, Any], key: str) -> bool:
    values = np.asarray(one[key])
    between = np.interp(one["mechanism_rotation_rad"], other["mechanism_rotation_rad"], other[key])
    return bool(np.abs(values - between).max() <= LEAST * np.abs(values).max())


def _strength(axes: Axes, mechanism: MechanismResult, locale: Locale) -> None:
    scale = table_scale("stress", locale)
    for strength in sorted({found["strength_pa"] for found in joints.deformable_joints(mechanism)} - {None}):
        at = float(scale.of(strength))
        axes.axhline(at, color=MUTED, linewidth=0.8, linestyle=":")
        name, side = locale.text(say("strength")), axes.get_yaxis_transform()
        axes.annotate(name, (1.0, at), xycoords=side, ha="right", va="bottom", color=MUTED)
