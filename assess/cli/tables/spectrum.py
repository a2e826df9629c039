"""A design spectrum for the terminal, as CSV, as JSON and as a figure."""

from __future__ import annotations

from pathlib import Path

from scipy.constants import g

from assess.cli.stderr import print_messages
from assess.cli.tables.text_table import text_table
from assess.messages.message import Message, Quantity, locate
from assess.results.json import dumps_spectrum
from assess.results.provenance import origin
from assess.study.ground_motion import spectrum_result
from reports.language.locale import Locale
from reports.language.texts import Phrase, Verbatim
from reports.language.value_names import corners, parameter_rows
from reports.render.csv import csv_lines
from spectra.spectrum import Spectrum

ROUND_PERIODS = (0.0, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)  # s


def spectrum_table(spectrum: Spectrum) -> str:
    """Write the clause, the parameters, and the ordinates at round and corner periods."""
    scale = "" if spectrum.factor == 1.0 else f", ordinates scaled by {spectrum.factor:.4g}"
    peak = f"PGA {spectrum.pga / g:.4g} g{scale}"
    heading = f"{spectrum.code}: {spectrum.clause}; damping {spectrum.damping:g}, {peak}\n"
    parameters = [[Locale().text(name), *_shown(value)] for name, value in parameter_rows(spectrum.parameters)]
    period = periods_of(spectrum)
    columns = zip(period, spectrum.acceleration(period) / g, spectrum.displacement(period), strict=True)
    ordinates = [[f"{T:.4g}", f"{S_a:.4f}", f"{1e3 * S_d:.2f}"] for T, S_a, S_d in columns]
    return "\n".join(
        (
            heading,
            text_table(["parameter", "value", "unit"], parameters),
            text_table(["T [s]", "S_a [g]", "S_d [mm]"], ordinates),
        )
    )


def periods_of(spectrum: Spectrum) -> list[float]:
    """Return round periods and the spectrum's corners [s], ascending, as far as the spectrum extends."""
    wanted = {*ROUND_PERIODS, *corners(spectrum.parameters)}
    return sorted(period for period in wanted if period <= min(spectrum.longest_period, max(ROUND_PERIODS)))


def spectrum_csv(spectrum: Spectrum) -> str:
    """Write period and acceleration at full precision, in the format of a spectrum table."""
    result = spectrum_result(spectrum)
    rows = zip(result.period_s, result.acceleration_g, strict=True)
    return csv_lines([("period [s]", "acceleration [g]"), *rows])


def spectrum_json(spectrum: Spectrum) -> str:
    """Write the block `spectrum` of results.json."""
    return dumps_spectrum(spectrum_result(spectrum))


def print_spectrum_warnings(spectrum: Spectrum, *, messages: tuple[Message, ...] = ()) -> None:
    """Print on stderr what to consider before using the spectrum; messages: on the options given."""
    found = locate(spectrum.warnings, "site.spectrum")
    print_messages((*messages, *found))


def draw_spectrum(spectrum: Spectrum, path: Path) -> Path:
    """Draw the figure of the spectrum to `path`."""
    from reports.figures.spectrum import draw_design_spectrum
    from reports.language.locale import Locale
    from reports.render.vector import write_figure

    return write_figure(
        draw_design_spectrum(spectrum_result(spectrum), Locale()),
        path,
        creator=origin("spectrum", spectrum_json(spectrum)),
    )


def _shown(value: Quantity | Verbatim | Phrase) -> tuple[str, str]:
    """Return a value and its unit, "-" for none."""
    locale = Locale()
    if not isinstance(value, Quantity):
        return locale.text(value), "-"
    unit = locale.table_unit(value.dimension)
    return locale.number(value.value / unit.size, figures=value.figures), unit.name or "-"
