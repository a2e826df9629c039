"""Moment over rotation of a mechanism with deformable joints and of simpler ones (thesis Fig. 8.8)."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from assess.results import MechanismResult
from reports import joints
from reports.figures.style import HALF, MUTED, label, legend_below, report_style, sheet
from reports.language.locale import Locale
from reports.language.texts import say
from spectra.arrays import FloatArray

FIXED, OWN = "#0072b2", "#c1121f"
NEAR = 0.03  # of an axis: joints whose marks are nearer share one


def draw(mechanism: MechanismResult, locale: Locale) -> Figure:
    """Draw moment / largest rigid moment [-] over rotation [rad]: rigid joints, hinges at a_SF, its own joints."""
    rest, own, simpler = mechanism.oscillator.equilibrium_rad, mechanism.curve.positive, mechanism.interface_curves
    largest = max(own.restoring_n_m if simpler is None else simpler.rigid.restoring_n_m)
    rotation, moment = np.asarray(own.rotation_rad) + rest, np.asarray(own.restoring_n_m) / largest
    with report_style():
        figure = sheet(2.6, locale, width=HALF)
        axes = figure.subplots()
        if simpler is not None:
            for one, colour, dash, name in (
                (simpler.rigid, MUTED, "-", say("rigid joints")),
                (simpler.fixed_hinges, FIXED, "--", say("hinges fixed at a_SF")),
            ):
                simple = np.asarray(one.restoring_n_m) / largest
                axes.plot(one.rotation_rad, simple, dash, color=colour, label=locale.text(name))
        axes.plot(rotation, moment, color=OWN, label=locale.text(say("its joints")))
        axes.axhline(0.0, color=MUTED, linewidth=0.7)
        _marks(axes, mechanism, rotation, moment, locale)
        axes.set_xlabel(locale.heading(say("rotation φ"), "rotation"))
        axes.set_ylabel(locale.heading(say("moment / largest rigid moment"), "ratio"))
        axes.set_xlim(min(0.0, rest), 1.08 * max(mechanism.oscillator.overturning_rad, rest))
        axes.set_ylim(-0.08, 1.08)
        legend_below(figure, columns=2)
        return figure


def _marks(axes: Axes, mechanism: MechanismResult, rotation: FloatArray, moment: FloatArray, locale: Locale) -> None:
    """Mark where each joint begins to open, and where its edge begins to crush."""
    for key, face, offset in (("opening_rad", "white", (6, -3)), ("crushing_rad", OWN, (-2, -10))):
        for at, height, hinges in places(mechanism, key, rotation, moment):
            axes.plot([at], [height], "o", color=OWN, markerfacecolor=face, markersize=4.5, zorder=3)
            axes.annotate(label(", ".join(hinges)), (at, height), xytext=offset, textcoords="offset points", color=OWN)
    for face, name in (("white", say("a joint begins to open")), (OWN, say("its edge begins to crush"))):
        axes.plot([], [], "o", color=OWN, markerfacecolor=face, markersize=4.5, label=locale.text(name))


def places(
    mechanism: MechanismResult, key: str, rotation: FloatArray, moment: FloatArray
) -> list[tuple[float, float, list[str]]]:
    """Return rotation [rad] and moment [-] at which joints of the positive branch open or crush, with their hinges."""
    found: list[tuple[float, float, list[str]]] = []
    for interface in joints.joints_of_branch(mechanism, "positive"):
        at = joints.event_rotation(interface, key)
        if at is None:
            continue
        height = float(np.interp(at, rotation, moment))
        near = [hinges for x, y, hinges in found if abs(x - at) <= NEAR * rotation[-1] and abs(y - height) <= NEAR]
        if near:
            near[0].append(interface["hinge"])
        else:
            found.append((at, height, [interface["hinge"]]))
    return found
