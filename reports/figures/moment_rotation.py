"""The moment over rotation of a mechanism with joints, beside those of simpler ones (thesis Fig. 8.8)."""

from __future__ import annotations

from math import isclose

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from assess.results import MechanismResult
from reports import joints
from reports.style import MUTED, label, sheet, styled

FIXED, OWN = "#0072b2", "#c1121f"
ALIKE = 1e-3  # two rotations that differ by less, of themselves, share a mark

FloatArray = NDArray[np.float64]


def draw(mechanism: MechanismResult) -> Figure:
    """Moment / largest rigid moment [-] over rotation [rad] of the positive branch: rigid, hinges at a_SF, its own."""
    rest, own, simpler = mechanism.oscillator.equilibrium_rad, mechanism.curve.positive, mechanism.interface_curves
    largest = max(own.restoring_n_m if simpler is None else simpler.rigid.restoring_n_m)
    rotation, moment = np.asarray(own.rotation_rad) + rest, np.asarray(own.restoring_n_m) / largest
    with styled():
        figure = sheet(2.9)
        axes = figure.subplots()
        if simpler is not None:
            for one, colour, dash, name in (
                (simpler.rigid, MUTED, "-", "rigid joints"),
                (simpler.fixed_hinges, FIXED, "--", "hinges fixed at a_SF"),
            ):
                axes.plot(one.rotation_rad, np.asarray(one.restoring_n_m) / largest, dash, color=colour, label=name)
        axes.plot(rotation, moment, color=OWN, label=label(f"its joints: {joints.model(mechanism)}"))
        axes.axhline(0.0, color=MUTED, linewidth=0.7)
        _marks(axes, mechanism, rotation, moment)
        axes.set(xlabel="rotation φ [rad]", ylabel="moment / largest rigid moment [-]")
        axes.set_xlim(min(0.0, rest), 1.08 * max(mechanism.oscillator.overturning_rad, rest))
        axes.set_ylim(-0.08, 1.08)
        axes.legend(loc="upper right")
        return figure


def _marks(axes: Axes, mechanism: MechanismResult, rotation: FloatArray, moment: FloatArray) -> None:
    """Where each joint begins to open, and where its edge begins to crush."""
    for key, face, offset in (("opening_rad", "white", (6, -3)), ("crushing_rad", OWN, (-2, -10))):
        for at, hinges in together(mechanism, key):
            height = float(np.interp(at, rotation, moment))
            axes.plot([at], [height], "o", color=OWN, markerfacecolor=face, markersize=4.5, zorder=3)
            axes.annotate(label(", ".join(hinges)), (at, height), xytext=offset, textcoords="offset points", color=OWN)
    for face, name in (("white", "a joint begins to open"), (OWN, "its edge begins to crush")):
        axes.plot([], [], "o", color=OWN, markerfacecolor=face, markersize=4.5, label=name)


def together(mechanism: MechanismResult, key: str) -> list[tuple[float, list[str]]]:
    """Rotations [rad] at which joints of the positive branch open or crush, with the hinges of each."""
    found: list[tuple[float, list[str]]] = []
    for interface in joints.of_branch(mechanism, "positive"):
        at = joints.rotation_when(interface, key)
        beside = next((hinges for other, hinges in found if at is not None and isclose(at, other, rel_tol=ALIKE)), None)
        if beside is not None:
            beside.append(interface["hinge"])
        elif at is not None:
            found.append((at, [interface["hinge"]]))
    return found
