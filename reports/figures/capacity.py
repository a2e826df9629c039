"""The capacity of one mechanism over rotation: multiplier, moment (thesis Fig. 8.8), and the contact of its joints."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator, NullFormatter

from assess.results import BranchCurve, BranchName, MechanismResult
from reports.figures import style
from reports.language.locale import Locale
from reports.language.texts import Phrase, say
from reports.mechanisms import deformable_joints, event_rotation, joints_of_branch
from spectra.arrays import FloatArray
from spectra.gravity import g

CAPACITY_HEIGHT = 2.4  # in


def draw_capacity(mechanism: MechanismResult, locale: Locale) -> Figure:
    """Draw restoring moment (above) and lambda = restoring / (g B) (below) over rotation, both branches as mirrored."""
    positive = mechanism.curve.positive
    rotation = style.table_scale("rotation", locale)
    moment = style.fitting_scale("moment", positive.restoring_n_m, locale)
    with style.report_style():
        figure = style.sheet(CAPACITY_HEIGHT, locale, width=style.HALF)
        above, below = figure.subplots(2, 1, sharex=True)
        for branch, colour, dash, name in _branches(mechanism):
            across, named = rotation.in_unit(branch.rotation_rad), locale.text(name)
            above.plot(across, moment.in_unit(branch.restoring_n_m), dash, color=colour, label=named)
            below.plot(across, _multiplier(branch), dash, color=colour)
        for axes in (above, below):
            axes.axhline(0.0, color=style.MUTED, linewidth=0.7)
            _mark_overturning(axes, mechanism, locale)
            axes.set_xlim(left=0.0)
            axes.yaxis.set_major_locator(MaxNLocator(4))
        above.set_ylabel(moment.heading(say("moment")))
        below.set_ylabel(locale.heading(say("multiplier λ"), "ratio"))
        below.set_xlabel(rotation.heading(say("rotation φ")))
        below.xaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 2.5, 5, 10]))
        figure.align_ylabels()
        style.legend_below(figure, columns=2)
        return figure


FIXED_HINGES, OWN_JOINTS = "#0072b2", "#c1121f"
NEAR_MARKS = 0.03  # of an axis: joints whose marks are nearer share one


def draw_moment_rotation(mechanism: MechanismResult, locale: Locale) -> Figure:
    """Draw moment / largest rigid moment [-] over rotation [rad]: rigid joints, hinges at a_SF, its own joints."""
    rest, own, simpler = mechanism.oscillator.equilibrium_rad, mechanism.curve.positive, mechanism.interface_curves
    largest = max(own.restoring_n_m if simpler is None else simpler.rigid.restoring_n_m)
    rotation, moment = np.asarray(own.rotation_rad) + rest, np.asarray(own.restoring_n_m) / largest
    with style.report_style():
        figure = style.sheet(2.6, locale, width=style.HALF)
        axes = figure.subplots()
        if simpler is not None:
            for one, colour, dash, name in (
                (simpler.rigid, style.MUTED, "-", say("rigid joints")),
                (simpler.fixed_hinges, FIXED_HINGES, "--", say("hinges fixed at a_SF")),
            ):
                simple = np.asarray(one.restoring_n_m) / largest
                axes.plot(one.rotation_rad, simple, dash, color=colour, label=locale.text(name))
        axes.plot(rotation, moment, color=OWN_JOINTS, label=locale.text(say("its joints")))
        axes.axhline(0.0, color=style.MUTED, linewidth=0.7)
        _mark_joint_events(axes, mechanism, rotation, moment, locale)
        axes.set_xlabel(locale.heading(say("rotation φ"), "rotation"))
        axes.set_ylabel(locale.heading(say("moment / largest rigid moment"), "ratio"))
        axes.set_xlim(min(0.0, rest), 1.08 * max(mechanism.oscillator.overturning_rad, rest))
        axes.set_ylim(-0.08, 1.08)
        style.legend_below(figure, columns=2)
        return figure


HINGE_COLOURS = ("#c1121f", "#0072b2", "#009e73", "#e69f00")  # of the hinges A, B, C, D
BEFORE_OPENING = 0.5  # of the rotation at which a joint opens
LEAST_ROTATION = 1e-3  # of the largest rotation drawn
LEAST_DIFFERENCE = 1e-2  # of the largest value: curves that differ by less are one

_CONTACT_PANELS = (
    ("resultant_m", "length", say("resultant from the edge")),
    ("peak_stress_pa", "stress", say("stress at the edge")),
)


def draw_contact(mechanism: MechanismResult, locale: Locale) -> Figure:
    """Draw the distance of the resultant and the peak stress of each joint over the rotation."""
    sides = (mechanism.oscillator, mechanism.oscillator_negative)
    end = max(side.overturning_rad for side in sides if side is not None)
    with style.report_style():
        figure = style.sheet(2.2, locale)
        for axes, (key, dimension, name) in zip(figure.subplots(1, 2), _CONTACT_PANELS, strict=True):
            scale = style.table_scale(dimension, locale)
            for interface, colour, dash, hinges in distinct_curves(mechanism):
                curve = interface["curve"]
                rotation, values = np.asarray(curve["mechanism_rotation_rad"]), scale.in_unit(curve[key])
                axes.plot(rotation, values, dash, color=colour, label=style.label(hinges))
            axes.set(xlabel=locale.heading(say("rotation φ"), "rotation"), ylabel=scale.heading(name), xscale="log")
            axes.set_xlim(_axis_start(mechanism, end), end)
            axes.xaxis.set_minor_formatter(NullFormatter())
            axes.set_ylim(bottom=0.0)
        _draw_strength(axes, mechanism, locale)
        axes.legend(loc="lower right")
        return figure


def distinct_curves(mechanism: MechanismResult) -> list[tuple[dict[str, Any], str, str, str]]:
    """Return each joint unlike those before it: itself, colour, line, and the hinges that it represents."""
    found: list[tuple[dict[str, Any], str, str, list[str]]] = []
    branches: tuple[tuple[BranchName, str], ...] = (("positive", "-"), ("negative", "--"))
    for branch, dash in branches:
        for place, interface in enumerate(joints_of_branch(mechanism, branch)):
            like = next((hinges for other, _, _, hinges in found if _have_same_curves(interface, other)), None)
            if like is None:
                found.append((interface, HINGE_COLOURS[place % len(HINGE_COLOURS)], dash, [interface["hinge"]]))
            else:
                like.append(interface["hinge"])
    return [(interface, colour, dash, ", ".join(hinges)) for interface, colour, dash, hinges in found]


def _branches(mechanism: MechanismResult) -> list[tuple[BranchCurve, str, str, Phrase]]:
    positive, negative = mechanism.curve.positive, mechanism.curve.negative
    mirrored = [] if negative is None else [(negative, style.NEGATIVE, "--", say("negative side, mirrored"))]
    return [(positive, style.POSITIVE, "-", say("positive side")), *mirrored]


def _mark_overturning(axes: Axes, mechanism: MechanismResult, locale: Locale) -> None:
    """Mark the rotations that overturn: of rigid joints, and of the joints in use where these give."""
    marks = [(mechanism.oscillator.overturning_rad, "o", say("rigid joints: φₒᵥ"))]
    if mechanism.oscillator.overturning_flexible_rad is not None:
        marks.append((mechanism.oscillator.overturning_flexible_rad, "s", say("its joints: φₒᵥ")))
    for at, marker, name in marks:
        axes.plot(
            style.table_scale("rotation", locale).in_unit(at), 0.0, marker=marker, color=style.FAIL, markersize=4,
            linestyle="none", clip_on=False, label=locale.text(name),
        )  # fmt: skip


def _multiplier(branch: BranchCurve) -> FloatArray:
    excitation = np.asarray(branch.excitation_kg_m)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(np.where(excitation > 0, np.asarray(branch.restoring_n_m) / (g * excitation), np.nan))


def _mark_joint_events(
    axes: Axes, mechanism: MechanismResult, rotation: FloatArray, moment: FloatArray, locale: Locale
) -> None:
    """Mark where each joint begins to open, and where its edge begins to crush."""
    for key, face, offset in (("opening_rad", "white", (6, -3)), ("crushing_rad", OWN_JOINTS, (-2, -10))):
        for at, height, hinges in _joint_events(mechanism, key, rotation, moment):
            axes.plot([at], [height], "o", color=OWN_JOINTS, markerfacecolor=face, markersize=4.5, zorder=3)
            axes.annotate(
                style.label(", ".join(hinges)),
                (at, height),
                xytext=offset,
                textcoords="offset points",
                color=OWN_JOINTS,
            )
    for face, name in (("white", say("a joint begins to open")), (OWN_JOINTS, say("its edge begins to crush"))):
        axes.plot([], [], "o", color=OWN_JOINTS, markerfacecolor=face, markersize=4.5, label=locale.text(name))


def _joint_events(
    mechanism: MechanismResult, key: str, rotation: FloatArray, moment: FloatArray
) -> list[tuple[float, float, list[str]]]:
    """Return rotation [rad] and moment [-] at which joints of the positive branch open or crush, with their hinges."""
    found: list[tuple[float, float, list[str]]] = []
    for interface in joints_of_branch(mechanism, "positive"):
        at = event_rotation(interface, key)
        if at is None:
            continue
        height = float(np.interp(at, rotation, moment))
        near = [
            hinges
            for x, y, hinges in found
            if abs(x - at) <= NEAR_MARKS * rotation[-1] and abs(y - height) <= NEAR_MARKS
        ]
        if near:
            near[0].append(interface["hinge"])
        else:
            found.append((at, height, [interface["hinge"]]))
    return found


def _axis_start(mechanism: MechanismResult, end: float) -> float:
    """Return the start of the axis of rotations [rad]: before any joint opens, at most a thousandth of its end."""
    opening = [float(found["opening_rad"]) for found in deformable_joints(mechanism) if found["opening_rad"]]
    return min([*(BEFORE_OPENING * at for at in opening), LEAST_ROTATION * end])


def _have_same_curves(one: dict[str, Any], other: dict[str, Any]) -> bool:
    """Return whether two joints have the same curves, to the eye."""
    return all(_same_curve(one["curve"], other["curve"], key) for key, _, _ in _CONTACT_PANELS)


def _same_curve(one: dict[str, Any], other: dict[str, Any], key: str) -> bool:
    values = np.asarray(one[key])
    between = np.interp(one["mechanism_rotation_rad"], other["mechanism_rotation_rad"], other[key])
    return bool(np.abs(values - between).max() <= LEAST_DIFFERENCE * np.abs(values).max())


def _draw_strength(axes: Axes, mechanism: MechanismResult, locale: Locale) -> None:
    scale = style.table_scale("stress", locale)
    for strength in sorted({found["strength_pa"] for found in deformable_joints(mechanism)} - {None}):
        at = float(scale.in_unit(strength))
        axes.axhline(at, color=style.MUTED, linewidth=0.8, linestyle=":")
        name, side = locale.text(say("strength")), axes.get_yaxis_transform()
        axes.annotate(name, (1.0, at), xycoords=side, ha="right", va="bottom", color=style.MUTED)
