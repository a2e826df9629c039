"""Overturning envelopes for the terminal, as CSV and as JSON."""

from __future__ import annotations

from assess.cli.tables.messages import messages_text
from assess.cli.tables.text_table import text_table
from assess.results import CriticalResult, EnvelopeResult, Results
from assess.results.json import dumps_envelopes
from reports.render.csv import csv_lines

SHOWN = 8  # frequencies in the table for reading


def table_text(results: Results) -> str:
    """Write the critical mechanism by frequency band, and the lower bounds of all mechanisms at some frequencies."""
    if results.critical is None:
        return "the project has no mechanisms\n"
    bands = text_table(["critical mechanism", "from [Hz]", "to [Hz]"], _bands(results.critical))
    return f"{bands}\n{_bounds(results)}{messages_text(results.warnings)}"


def _bands(critical: CriticalResult) -> list[list[str]]:
    return [[band.mechanism or "none overturns", f"{band.from_hz:.3g}", f"{band.to_hz:.3g}"] for band in critical.bands]


def _bounds(results: Results) -> str:
    mapped = [(each.name, each.envelope) for each in results.mechanisms if each.envelope is not None]
    frequency = mapped[0][1].frequency_hz
    places = sorted({round(k * (len(frequency) - 1) / (SHOWN - 1)) for k in range(SHOWN)})
    header = ["least pulse [g] at", *(f"{frequency[place]:.3g} Hz" for place in places)]
    return text_table(header, [[name, *(_bound(one, place) for place in places)] for name, one in mapped])


def _bound(one: EnvelopeResult, place: int) -> str:
    bound = one.lower_bound_g[place]
    return f"> {one.amplitude_g[-1]:.3g}" if bound is None else f"{bound:.3g}"


def csv_text(results: Results) -> str:
    """Write a line for each frequency: the critical mechanism, then the least pulse of each [g], empty if none."""
    mapped = [(each.name, each.envelope) for each in results.mechanisms if each.envelope is not None]
    rows: list[list[str | float | None]] = [
        ["frequency [Hz]", "critical", "least [g]", *(f"{name} [g]" for name, _ in mapped)]
    ]
    if results.critical is not None:
        for k, frequency in enumerate(results.critical.frequency_hz):
            head = [frequency, results.critical.mechanism[k], results.critical.lower_bound_g[k]]
            rows.append([*head, *(one.lower_bound_g[k] for _, one in mapped)])
    return csv_lines(rows)


def json_text(results: Results) -> str:
    """Write the envelopes by mechanism and the critical mechanisms as in results.json."""
    return dumps_envelopes(results)
