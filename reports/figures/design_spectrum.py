"""A design spectrum by itself."""

from __future__ import annotations

from matplotlib.figure import Figure

from assess.results import SpectrumResult
from reports.figures.spectrum import frame_spectra
from reports.figures.style import INK, MUTED, label, report_style, sheet
from reports.language.locale import Locale
from reports.language.spectrum_parameters import corners
from reports.language.texts import Verbatim, quantity, say

LONGEST = 4.0  # s: of the period axis, as far as most codes give their spectra


def draw(spectrum: SpectrumResult, locale: Locale) -> Figure:
    """Draw pseudo-acceleration [g] over period [s], with the corner periods marked.

    Parameters
    ----------
    spectrum : of the site
    locale : of the labels
    """
    end = min(LONGEST, max(spectrum.period_s))
    with report_style():
        figure = sheet(2.8, locale)
        axes = figure.subplots()
        for corner in corners(spectrum.parameters):
            if corner <= end:
                axes.axvline(corner, color=MUTED, linewidth=0.6, linestyle=":")
        axes.plot(spectrum.period_s, spectrum.acceleration_g, color=INK, linewidth=1.8)
        damping = quantity(100.0 * spectrum.damping, "percent", 3)
        title = say("{clause}, damping {damping}", clause=Verbatim(spectrum.clause), damping=damping)
        axes.set_title(label(locale.text(title), 90))
        frame_spectra(axes, (0.0, end), locale)
        return figure
