"""Fragility curves as a plain table: a row for each empirical point, and one for each lognormal."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Sequence

from assess.risk.exports.curve import Export, ExportedCurve, ExportedState

HEADER = (
    "mechanism", "measure", "period_s", "unit", "state", "curve", "intensity", "records", "reached", "share", "low",
    "high", "median", "dispersion",
)  # fmt: skip


def csv_text(curves: Sequence[ExportedCurve]) -> Export:
    """Return the table of all curves; it has a place for everything.

    Rows of "empirical" have intensity, records, reached, share and its Wilson interval; those of "lognormal" median and
    dispersion.

    Parameters
    ----------
    curves : of the mechanisms
    """
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(HEADER)
    for curve in curves:
        period = "" if curve.period is None else repr(float(curve.period))
        for state in curve.states:
            first = [cell_of(curve.name), curve.measure, period, curve.unit, state.name]
            writer.writerows([*first, *row] for row in _rows(state))
    return Export(text.getvalue(), ())


def cell_of(text: str) -> str:
    """Return a text that no spreadsheet takes for a formula: an apostrophe stands before =, +, - and @."""
    return f"'{text}" if text[:1] in ("=", "+", "-", "@", "\t", "\r") else text


def _rows(state: ExportedState) -> Iterator[list[str]]:
    columns = (state.intensity, state.records, state.reached, state.share, state.low, state.high)
    for values in zip(*columns, strict=True):
        im, records, reached, *shares = values
        yield ["empirical", repr(float(im)), str(int(records)), str(int(reached)),
               *(repr(float(each)) for each in shares), "", ""]  # fmt: skip
    if state.lognormal is not None:
        fit = state.lognormal
        yield ["lognormal", *[""] * 6, repr(float(fit.median)), repr(float(fit.dispersion))]
