"""Fragility curves as a plain table: a row for each empirical point, and one for each lognormal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from assess.risk.exports.curve import Export, ExportedCurve, ExportedState
from assess.risk.exports.table import Cell, table_text

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
    rows: list[tuple[Cell, ...]] = [HEADER]
    for curve in curves:
        for state in curve.states:
            first = (curve.name, curve.measure, curve.period, curve.unit, state.name)
            rows += [(*first, *row) for row in _rows(state)]
    return Export(table_text(rows), ())


def _rows(state: ExportedState) -> Iterator[tuple[Cell, ...]]:
    columns = (state.intensity, state.records, state.reached, state.share, state.low, state.high)
    for im, records, reached, share, low, high in zip(*columns, strict=True):
        yield "empirical", float(im), int(records), int(reached), float(share), float(low), float(high), None, None
    if state.lognormal is not None:
        yield "lognormal", *[None] * 6, float(state.lognormal.median), float(state.lognormal.dispersion)
