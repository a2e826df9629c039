"""A design spectrum by itself."""

from __future__ import annotations

from matplotlib.figure import Figure

from assess.results import SpectrumResult
from reports.figures.style import INK, MUTED, label, report_style, sheet
from reports.language.spectrum_parameters import corners

LONGEST = 4.0  # s: of the period axis, as far as most codes give their spectra


def draw(spectrum: SpectrumResult) -> Figure:
    """Draw pseudo-acceleration [g] over period [s], with the corner periods marked."""
    end = min(LONGEST, max(spectrum.period_s))
    with report_style():
        figure = sheet(3.3)
        axes = figure.subplots()
        for corner in corners(spectrum.parameters):
            if corner <= end:
                axes.axvline(corner, color=MUTED, linewidth=0.6, linestyle=":")
        axes.plot(spectrum.period_s, spectrum.acceleration_g, color=INK, linewidth=1.8)
        axes.set_title(label(f"{spectrum.clause}, damping {100 * spectrum.damping:.3g} %", 90))
        axes.set(xlabel="period T [s]", ylabel="pseudo-acceleration Sₐ [g]")
        axes.set_xlim(0.0, end)
        axes.set_ylim(bottom=0.0)
        return figure
