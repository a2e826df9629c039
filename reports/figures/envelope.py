"""Overturning envelopes: the map of one mechanism, and the lower bounds of all with the critical one (thesis 3.11)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import ListedColormap
from matplotlib.figure import Figure

from assess.results import CriticalResult, EnvelopeResult, RecordResult
from reports.style import FAIL, GRID, INK, MUTED, label, sheet, styled

STANDS, ROCKS, FALLS = "#ffffff", "#e7edf3", "#f2c1ad"
COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#6b4c9a", "#8c6d31", "#000000")
DASHES = ("-", "--", "-.", ":")
MOST_NAMES = 36
"""Lines that the legend of all mechanisms can name; the others are drawn in grey."""


def draw(one: EnvelopeResult, records: Sequence[RecordResult]) -> Figure:
    """Outcome of pulses [g] over frequency [Hz]: white at rest, grey rocking, red overturned; dots: primary pulses."""
    frequency, amplitude = np.array(one.frequency_hz), np.array(one.amplitude_g)
    with styled():
        figure = sheet(3.1)
        axes = figure.subplots()
        rocks = amplitude[None, :] > np.array(one.uplift_g)[:, None]
        state = np.where(np.array(one.overturned), 2, np.where(rocks, 1, 0))
        axes.pcolormesh(
            frequency, amplitude, state.T, cmap=ListedColormap([STANDS, ROCKS, FALLS]), vmin=0, vmax=2,
            shading="nearest", rasterized=True,
        )  # fmt: skip
        axes.plot(frequency, one.uplift_g, color=MUTED, linewidth=0.9, linestyle="--", label="rocking starts")
        axes.plot(frequency, _numbers(one.lower_bound_g), color=FAIL, label="least pulse that overturns")
        _dots(axes, records, frequency, amplitude)
        _frame(axes, frequency, amplitude[-1], "peak acceleration of the pulse [g]")
        axes.legend(loc="upper left", frameon=True, facecolor="white", edgecolor="none", framealpha=0.85)
        return figure


def _dots(axes: Axes, records: Sequence[RecordResult], frequency: np.ndarray, amplitude: np.ndarray) -> None:
    """The best pulse within each record, as the record is scaled, where the map shows its place."""
    found = [record.primary_pulses[0] for record in records if record.primary_pulses]
    inside = [
        pulse for pulse in found
        if frequency[0] <= pulse.frequency_hz <= frequency[-1] and pulse.amplitude_g <= amplitude[-1]
    ]  # fmt: skip
    if inside:
        at = [pulse.frequency_hz for pulse in inside], [pulse.amplitude_g for pulse in inside]
        axes.plot(*at, "o", color=INK, markersize=3, label="primary pulses of the records")


def bounds(mapped: Sequence[tuple[str, EnvelopeResult]], critical: CriticalResult) -> Figure:
    """Least pulse [g] that overturns each mechanism over frequency [Hz]; below, a band coloured by the critical one.

    mapped: the name of each mechanism and its envelope.
    """
    frequency = np.array(critical.frequency_hz)
    pens = {name: (COLOURS[k % 9], DASHES[k // 9 % 4]) for k, (name, _) in enumerate(mapped[:MOST_NAMES])}
    with styled():
        figure = sheet(3.9)
        axes, band = figure.subplots(2, 1, sharex=True, height_ratios=(14, 1))
        for name, one in mapped:
            colour, dash = pens.get(name, (GRID, "-"))
            named = label(name, 24) if name in pens else None
            axes.plot(frequency, _numbers(one.lower_bound_g), color=colour, linestyle=dash, label=named)
        axes.plot(
            frequency, _numbers(critical.lower_bound_g), color=INK, linewidth=3.0, alpha=0.25, label="least of all"
        )
        _frame(axes, frequency, min(one.amplitude_g[-1] for _, one in mapped), "least pulse that overturns [g]")
        axes.set_xlabel("")
        for part in critical.bands:
            colour, dash = pens.get(part.mechanism or "", (GRID, "-"))
            hatch = None if dash == "-" else "////"
            band.axvspan(
                part.from_hz, part.to_hz, color=None, facecolor=colour if part.mechanism else "white",
                edgecolor="white", hatch=hatch, linewidth=0.4,
            )  # fmt: skip
        band.set_yticks([])
        band.set_ylabel("critical", rotation=0, ha="right", va="center")
        band.set_xlabel("frequency of the pulse [Hz]")
        band.grid(visible=False)
        figure.legend(*axes.get_legend_handles_labels(), loc="outside right upper", ncols=1 + len(pens) // 19)
        return figure


def _frame(axes: Axes, frequency: np.ndarray, top: float, name: str) -> None:
    axes.set_xlim(frequency[0], frequency[-1])
    axes.set_ylim(0.0, top)
    if frequency[-1] / frequency[0] > 2.0 and np.ptp(np.diff(frequency)) > 1e-6 * frequency[-1]:
        axes.set_xscale("log")
    axes.set_xlabel("frequency of the pulse [Hz]")
    axes.set_ylabel(name)


def _numbers(values: Sequence[float | None]) -> np.ndarray:
    return np.array([np.nan if value is None else value for value in values])
