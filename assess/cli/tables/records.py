"""Records as a table for the terminal, as CSV and as JSON: what a file says of each, and its measures."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict
from math import degrees
from typing import Any

import numpy as np
from scipy.constants import g

from assess.cli.tables.text_table import text_table
from records.intensity import Measures, measures
from records.orientation import is_vertical
from records.record import Record
from records.response import response_spectrum
from reports.render.csv import csv_lines

PERIODS = np.concatenate(([0.0], np.geomspace(0.01, 10.0, 160)))  # s, of the spectra, as in results.json
_COLUMNS = (
    "record",
    "event",
    "station",
    "component",
    "dt [s]",
    "npts",
    "PGA [g]",
    "PGV [m/s]",
    "PGD [m]",
    "Arias [m/s]",
    "CAV [m/s]",
    "D5-75 [s]",
    "D5-95 [s]",
    "T_m [s]",
    "Housner [m]",
)


def table_text(records: Sequence[Record]) -> str:
    """Write a rounded line for each record."""
    return text_table(_COLUMNS, [_row(record, measures(record)) for record in records])


def csv_text(records: Sequence[Record]) -> str:
    """Write everything but the spectra at full precision, under the JSON names."""
    rows = [_flat(_properties(record)) for record in records]
    return csv_lines([rows[0], *(row.values() for row in rows)])


def json_text(records: Sequence[Record]) -> str:
    """Write the `records` of results.json, unscaled, with further properties and measures."""
    listed = [
        _properties(record) | {"trail": list(map(str, record.processing_history)), "spectrum": _spectrum(record)}
        for record in records
    ]
    return json.dumps(listed, ensure_ascii=False, allow_nan=False, indent=1) + "\n"


def _row(record: Record, of: Measures) -> list[str]:
    names = [record.id, record.event, record.station, record.component]
    peaks = [of.pgv, of.pgd, of.arias, of.cav, of.d5_75, of.d5_95, of.mean_period, of.housner]
    return [*names, f"{record.dt:.6g}", str(record.npts), f"{record.pga / g:.4g}", *(f"{each:.4g}" for each in peaks)]


def _properties(record: Record) -> dict[str, Any]:
    """Return the properties of a record, with units in the names."""
    of = measures(record)
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
        "measures": {
            "pgv_m_per_s": of.pgv,
            "pgd_m": of.pgd,
            "arias_m_per_s": of.arias,
            "cav_m_per_s": of.cav,
            "d5_75_s": of.d5_75,
            "d5_95_s": of.d5_95,
            "mean_period_s": of.mean_period,
            "housner_m": of.housner,
        },
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
    ordinates = response_spectrum(record, PERIODS) / g
    return {"period_s": PERIODS.tolist(), "acceleration_g": ordinates.tolist()}


def _flat(known: dict[str, Any]) -> dict[str, Any]:
    """Flatten nested tables into columns such as `earthquake_magnitude`; measures keep their own names."""
    flat: dict[str, Any] = {}
    for key, value in known.items():
        if isinstance(value, dict):
            flat |= {name if key == "measures" else f"{key}_{name}": each for name, each in value.items()}
        else:
            flat[key] = str(value) if isinstance(value, bool) else value
    return flat
