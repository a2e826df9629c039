"""Records for the terminal, as CSV, as JSON and as a figure: their measures, their spectra, the catalogue of a
folder.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import asdict, dataclass
from math import degrees
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from assess.cli.tables import messages_text, text_table
from assess.errors import AssessError
from assess.messages.message import escape_text
from assess.project.suites import ScaledSuite
from assess.results import RecordResult
from assess.results.json import dumps_suite
from assess.results.provenance import origin
from records.candidates import DAMPING, PERIODS
from records.reading import read_with_overrides
from records.record import Record, is_vertical
from records.response import Measures, measures, response_spectrum
from reports.chapters.suite import event_name, requirements_table, selection_sentences
from reports.document import Cell, Column
from reports.figures.spectrum import draw_beside_target
from reports.figures.style import WIDTH
from reports.language.locale import Locale
from reports.language.texts import Verbatim
from reports.render.table_text import cell_text, csv_lines
from reports.render.vector import write_figure
from spectra.gravity import g

if TYPE_CHECKING:
    from records.catalogue import IndexSummary
    from records.flatfile import FlatfileMatch
    from records.formats.header import HeaderOverrides


SPECTRUM_PERIODS = np.concatenate(([0.0], np.geomspace(0.01, 10.0, 160)))  # s, of the spectra, as in results.json
RECORD_HEADER = ("record", "event", "station", "component", "dt [s]", "npts", "PGA [g]")
MEASURES: Mapping[str, tuple[str, str]] = {
    "PGV [m/s]": ("pgv_m_per_s", "pgv"),
    "PGD [m]": ("pgd_m", "pgd"),
    "Arias [m/s]": ("arias_m_per_s", "arias"),
    "CAV [m/s]": ("cav_m_per_s", "cav"),
    "D5-75 [s]": ("d5_75_s", "d5_75"),
    "D5-95 [s]": ("d5_95_s", "d5_95"),
    "T_m [s]": ("mean_period_s", "mean_period"),
    "Housner [m]": ("housner_m", "housner"),
}
"""The measures of a record besides its PGA, by their headings: their keys in JSON, their names in `Measures`."""
ROUND_PERIODS = (0.1, 0.2, 0.3, 0.5, 1.0, 2.0, 3.0, 5.0, 10.0)  # s
MAX_CELLS = 20  # bad cells of a flatfile


def records_table(records: Sequence[Record]) -> str:
    """Write a rounded line for each record."""
    return text_table((*RECORD_HEADER, *MEASURES), [_row(record, measures(record)) for record in records])


def records_csv(records: Sequence[Record]) -> str:
    """Write everything but the spectra at full precision, under the JSON names."""
    from reports.render.table_text import csv_lines

    rows = [_flat(_properties(record)) for record in records]
    return csv_lines([rows[0], *(row.values() for row in rows)])


def records_json(records: Sequence[Record]) -> str:
    """Write the `records` of results.json, unscaled, with further properties and measures."""
    listed = [
        _properties(record) | {"trail": list(map(str, record.processing_history)), "spectrum": _spectrum(record)}
        for record in records
    ]
    return json.dumps(listed, ensure_ascii=False, allow_nan=False, indent=1) + "\n"


@dataclass(frozen=True)
class Spectra:
    """Names of records, their peaks [n] and pseudo-accelerations at PERIODS [n, k], all in m/s2."""

    names: tuple[str, ...]
    pga: NDArray[np.float64]
    ordinates: NDArray[np.float64]


def read_spectra(
    places: Sequence[Path],
    *,
    damping: float,
    overrides: HeaderOverrides,
    kept: Path | None,
    executor: Executor | None = None,
) -> Spectra:
    """Return the spectra of the records of `places`; raise AssessError where a catalogue lacks the damping."""
    from assess.study.suites import candidate_records

    folders = [place for place in places if place.is_dir()]
    if folders and damping != DAMPING:
        raise AssessError(f"{folders[0]}: a folder's catalogue holds spectra of 5 % damping; give its files instead")
    if not folders:
        records = [record for place in places for record in read_with_overrides(place, overrides)]
        ordinates = [response_spectrum(record, PERIODS, damping=damping) for record in records]
        pga = np.array([record.pga for record in records])
        return Spectra(tuple(record.id for record in records), pga, np.array(ordinates))
    found = candidate_records(places, overrides=overrides, kept=kept, executor=executor).candidates
    if not found:
        raise AssessError(f"{folders[0]}: no records in the folder that can be read; `assess records index` says why")
    pga = np.array([one.measures["pga"] for one in found])
    return Spectra(tuple(one.id for one in found), pga, np.array([one.spectrum for one in found]))


def spectra_table(spectra: Spectra) -> str:
    """Write ordinates in g at round periods, rounded, interpolated logarithmically between periods."""
    rows = []
    for name, pga, ordinates in zip(spectra.names, spectra.pga, spectra.ordinates, strict=True):
        at = np.exp(np.interp(np.log(ROUND_PERIODS), np.log(PERIODS), np.log(np.maximum(ordinates, 1e-300))))
        rows.append([name, f"{pga / g:.4g}", *(f"{each / g:.4g}" for each in at)])
    return text_table(("record", "PGA [g]", *(f"{T:g} s" for T in ROUND_PERIODS)), rows)


def spectra_csv(spectra: Spectra) -> str:
    """Write a line for each period and a column for each record at full precision."""
    from reports.render.table_text import csv_lines

    header = ["period [s]", *(f"{name} [m/s2]" for name in spectra.names)]
    columns = zip(PERIODS.tolist(), spectra.ordinates.T.tolist(), strict=True)
    return csv_lines([header, [0.0, *spectra.pga.tolist()], *([T, *column] for T, column in columns)])


def draw_spectra(spectra: Spectra, path: Path) -> None:
    """Draw the figure to `path`."""
    from assess.results.provenance import origin
    from reports.figures import spectrum
    from reports.language.locale import Locale
    from reports.render.vector import write_figure

    figure = spectrum.draw_record_spectra(spectra.names, PERIODS, spectra.ordinates / g, Locale())
    write_figure(figure, path, creator=origin("records spectra", spectra_csv(spectra)))


def index_summary_text(found: IndexSummary, place: Path, *, described: int, merged: FlatfileMatch | None) -> str:
    """Write the counts, the use of a flatfile, each unreadable file with the reason, and the catalogue's path."""
    counts = f"{found.read} files read, {found.unchanged} unchanged, {found.gone} gone"
    lines = [
        f"{counts}; {found.records} records, {described} of known magnitude; {len(found.problems)} files not readable",
        *(["the catalogue had an older format: every file was read again"] if found.older else []),
        *(f"{path}: its rows in the catalogue were damaged: the file was read again" for path in found.damaged),
        *([] if merged is None else _flatfile_lines(merged)),
        *(f"{path}: {why}" for path, why in found.problems),
        str(place),
    ]
    return "".join(f"{escape_text(line)}\n" for line in lines)


def index_summary_json(found: IndexSummary, place: Path, *, described: int, merged: FlatfileMatch | None) -> str:
    """Write the counts, the use of a flatfile and the unreadable files as JSON."""
    problems = [{"path": path, "reason": why} for path, why in found.problems]
    summary = {**asdict(found), "problems": problems, "with_magnitude": described, "catalogue": str(place)}
    return json.dumps({**summary, "flatfile": _flatfile_json(merged)}, ensure_ascii=False, indent=1) + "\n"


SUITE_HEADER = ("record", "event", "NGA", "M", "comp.", "misfit", "factor", "PGA [g]")


def suite_table(suite: ScaledSuite) -> str:
    """Write the records as in thesis Table 8.8, how they were selected, and the code rules of the suite."""
    motion = suite.motion
    steps = () if motion.selection is None else motion.selection.remaining
    left = "; ".join(f"{one.number} {one.step}" for one in steps)
    written = "\n".join([*map(Locale().text, selection_sentences(motion)), *([f"Candidates: {left}."] if left else [])])
    requirements = [_requirement_row(row) for row in requirements_table(motion).rows]
    columns = ("requirement", "clause", "code", "found", "limit", "periods", "met")
    return (
        "\n".join(
            (
                text_table(SUITE_HEADER, [_record_row(record) for record in suite.records]),
                f"{written}\n",
                text_table(columns, requirements),
                messages_text(suite.messages),
            )
        ).rstrip("\n")
        + "\n"
    )


def suite_csv(suite: ScaledSuite) -> str:
    """Write the records at full precision, under their names of results.json."""
    names = (
        "id", "path", "event", "date", "station", "component", "nga", "magnitude", "distance_km", "vs30_m_per_s",
        "dt_s", "npts", "mse", "scale_factor", "pga_g",
    )  # fmt: skip
    return csv_lines([names, *([getattr(record, name) for name in names] for record in suite.records)])


def suite_json(suite: ScaledSuite) -> str:
    """Write `records` and `ground_motion` of results.json."""
    return dumps_suite(suite.records, suite.motion)


def draw_suite(suite: ScaledSuite, path: Path) -> None:
    """Draw target, records and their mean to `path`."""
    write_figure(
        draw_beside_target(suite.motion, suite.records, (), Locale(), width=WIDTH),
        path,
        creator=origin("records select", suite_json(suite)),
    )


def _row(record: Record, measured: Measures) -> list[str]:
    names = [record.id, record.event, record.station, record.component]
    peaks = [getattr(measured, name) for _, name in MEASURES.values()]
    sampling = [f"{record.dt:.6g}", str(record.npts)]
    return [*names, *sampling, f"{record.pga / g:.4g}", *(f"{each:.4g}" for each in peaks)]


def _properties(record: Record) -> dict[str, Any]:
    """Return the properties of a record, with units in the names."""
    measured = measures(record)
    return {
        "id": record.id,
        "path": record.path,
        "event": record.event,
        "station": record.station,
        "component": record.component,
        "dt_s": record.dt,
        "npts": record.npts,
        "pga_g": record.pga / g,
        "scale_factor": 1.0,
        "mse": None,
        "vertical": is_vertical(record.component),
        "azimuth_deg": None if record.azimuth is None else degrees(record.azimuth),
        "epicentral_distance_km": None if record.distance is None else record.distance / 1000.0,
        "earthquake": _earthquake(record),
        "site": _site(record),
        "measures": {key: getattr(measured, name) for key, name in MEASURES.values()},
    }


def _earthquake(record: Record) -> dict[str, Any]:
    found = asdict(record.earthquake)
    depth = found.pop("depth")
    return {"origin_time": found.pop("time"), **found, "depth_km": None if depth is None else depth / 1000.0}


def _site(record: Record) -> dict[str, Any]:
    names = {"elevation": "elevation_m", "vs30": "vs30_m_per_s"}
    return {names.get(key, key): value for key, value in asdict(record.site).items()}


def _spectrum(record: Record) -> dict[str, list[float]]:
    """Return the pseudo-acceleration spectrum at 5 % damping."""
    ordinates = response_spectrum(record, SPECTRUM_PERIODS) / g
    return {"period_s": SPECTRUM_PERIODS.tolist(), "acceleration_g": ordinates.tolist()}


def _flat(known: dict[str, Any]) -> dict[str, Any]:
    """Flatten nested tables into columns such as `earthquake_magnitude`; measures keep their own names."""
    flat: dict[str, Any] = {}
    for key, value in known.items():
        if isinstance(value, dict):
            flat |= {name if key == "measures" else f"{key}_{name}": each for name, each in value.items()}
        else:
            flat[key] = str(value) if isinstance(value, bool) else value
    return flat


def _flatfile_lines(merged: FlatfileMatch) -> list[str]:
    from assess.study.suites import cell_message

    counts = f"{merged.matched} rows matched, {merged.unmatched} unmatched, {len(merged.bad)} bad cells"
    bad = [f"flatfile, {cell_message(cell)}" for cell in merged.bad[:MAX_CELLS]]
    more = (
        [f"flatfile: {len(merged.bad) - MAX_CELLS} more bad cells; --json lists all"]
        if len(merged.bad) > MAX_CELLS
        else []
    )
    return [f"flatfile: {counts}; {merged.records} records described", *bad, *more]


def _flatfile_json(merged: FlatfileMatch | None) -> dict[str, object] | None:
    if merged is None:
        return None
    bad = [asdict(cell) for cell in merged.bad]
    counts = {"matched": merged.matched, "unmatched": merged.unmatched, "records": merged.records}
    return {**counts, "bad_cells": bad, "warning": None if merged.warning is None else merged.warning.text}


def _record_row(record: RecordResult) -> list[str]:
    known = ["-" if each is None else f"{each:g}" for each in (record.nga, record.magnitude)]
    numbers = [f"{record.mse:.4f}", f"{record.scale_factor:.4g}", f"{record.pga_g:.4g}"]
    return [record.id, event_name(record), *known, record.component, *numbers]


def _requirement_row(row: tuple[Cell, ...]) -> list[str]:
    """Return a requirement without its remark."""
    code, clause, what, *found, _ = (cell_text(cell, Column(Verbatim("")), Locale()) for cell in row)
    return [what, clause, code, *found]
