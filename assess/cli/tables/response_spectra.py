"""Response spectra of records for the terminal, as CSV and as a figure."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.constants import g

from assess.cli.tables.text_table import text_table
from assess.errors import AssessError
from assess.results.stamp import origin
from assess.study.record_set import candidate_records
from records.candidates import DAMPING, PERIODS
from records.formats.header_overrides import HeaderOverrides
from records.reading import read_with
from records.response import response_spectrum
from reports.figures import record_spectra
from reports.language.locale import Locale
from reports.render.csv import csv_lines
from reports.render.figure_file import write_figure

ROUND = (0.1, 0.2, 0.3, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0)  # s


@dataclass(frozen=True)
class Spectra:
    """Names of records, their peaks [n] and pseudo-accelerations at PERIODS [n, k], all in m/s2."""

    names: tuple[str, ...]
    pga: NDArray[np.float64]
    ordinates: NDArray[np.float64]


def spectra_in(
    places: Sequence[Path],
    *,
    damping: float,
    overrides: HeaderOverrides,
    kept: Path | None,
    executor: Executor | None = None,
) -> Spectra:
    """Return the spectra of the records of `places`; raise AssessError where a catalogue lacks the damping."""
    folders = [place for place in places if place.is_dir()]
    if folders and damping != DAMPING:
        raise AssessError(f"{folders[0]}: a folder's catalogue holds spectra of 5 % damping; give its files instead")
    if not folders:
        records = [record for place in places for record in read_with(place, overrides)]
        ordinates = [response_spectrum(record, PERIODS, damping=damping) for record in records]
        pga = np.array([record.pga for record in records])
        return Spectra(tuple(record.id for record in records), pga, np.array(ordinates))
    found = candidate_records(places, overrides=overrides, kept=kept, executor=executor).candidates
    if not found:
        raise AssessError(f"{folders[0]}: no records in the folder that can be read; `assess records index` says why")
    pga = np.array([one.measures["pga"] for one in found])
    return Spectra(tuple(one.id for one in found), pga, np.array([one.spectrum for one in found]))


def table_text(spectra: Spectra) -> str:
    """Write ordinates in g at round periods, rounded, interpolated logarithmically between periods."""
    rows = []
    for name, pga, of in zip(spectra.names, spectra.pga, spectra.ordinates, strict=True):
        at = np.exp(np.interp(np.log(ROUND), np.log(PERIODS), np.log(np.maximum(of, 1e-300))))
        rows.append([name, f"{pga / g:.4g}", *(f"{each / g:.4g}" for each in at)])
    return text_table(("record", "PGA [g]", *(f"{T:g} s" for T in ROUND)), rows)


def csv_text(spectra: Spectra) -> str:
    """Write a line for each period and a column for each record at full precision."""
    header = ["period [s]", *(f"{name} [m/s2]" for name in spectra.names)]
    columns = zip(PERIODS.tolist(), spectra.ordinates.T.tolist(), strict=True)
    return csv_lines([header, [0.0, *spectra.pga.tolist()], *([T, *column] for T, column in columns)])


def draw(spectra: Spectra, path: Path) -> None:
    """Draw the figure to `path`."""
    figure = record_spectra.draw(spectra.names, PERIODS, spectra.ordinates / g, Locale())
    write_figure(figure, path, creator=origin("records spectra", csv_text(spectra)))
