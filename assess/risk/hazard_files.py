"""Hazard curves from files: those that the OpenQuake engine exports as CSV, and plain text of two columns.

OpenQuake writes a comment with `investigation_time` and `imt`, then `lon,lat,depth,poe-0.005,...` and a row for each
site; `poe` are probabilities of exceedance in the investigation time T of Poisson's process, so that the annual rate is
-ln(1 - poe) / T. PGA and SA are in g there, PGV in cm/s (OpenQuake manual, "Intensity measure types").
"""

from __future__ import annotations

import csv
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np
from scipy.constants import g

from assess.errors import HazardError
from assess.risk.hazard import HazardCurve
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray
from spectra.columns import ACCELERATION_UNITS, ColumnError, decode, factor_of, read_columns

VELOCITY_UNITS = {"m/s": 1.0, "cm/s": 0.01, "mm/s": 1e-3}
IN_G = {name: factor / g for name, factor in ACCELERATION_UNITS.items()}
Measure = Literal["pga", "sa", "pgv"]
FACTORS: Mapping[str, tuple[Measure, float]] = {"PGA": ("pga", 1.0), "SA": ("sa", 1.0), "PGV": ("pgv", 0.01)}
"""Measure of OpenQuake's names, and what converts its unit to g or m/s."""
PLAIN: Mapping[str, tuple[Measure, Mapping[str, float]]] = {"pga": ("pga", IN_G), "pgv": ("pgv", VELOCITY_UNITS)}
"""Measure and units of the first column of a plain file, by how its label begins."""
YEARS = {"1/year", "1/yr", "1/y", "1/a", "year^-1"}
PERIODS = {"year", "years", "yr", "a"}
EARTH_RADIUS = 6371.0  # km
FARTHEST = 50.0  # km from the nearest site of a file to the one asked for
EXAMPLE = "pga [g], annual_rate [1/year]"
IMT = r"([A-Za-z][A-Za-z0-9]*(?:\([^)]*\))?)"


@dataclass(frozen=True, repr=False)
class SiteHazard(ShortRepr):
    """A hazard curve with what its file says of it.

    curve : PGA and SA in g, PGV in m/s
    measure : "pga", "sa", "pgv"; period : of "sa" [s]
    distance : of the site of the file from the one asked for [km]; None where none is asked for
    """

    curve: HazardCurve
    measure: Measure
    period: float | None = None
    distance: float | None = None


def read_hazard(path: Path, *, longitude: float | None = None, latitude: float | None = None) -> SiteHazard:
    """Read a hazard curve, of OpenQuake or of two columns; what cannot be read raises HazardError, one line.

    Parameters
    ----------
    path : CSV file of OpenQuake, or text of two columns like `pga [g], annual_rate [1/year]` or
        `pgv [cm/s]; return_period [years]`
    longitude : of the site [deg]; needed where a file of OpenQuake has several sites
    latitude : of the site [deg]
    """
    try:
        text = decode(path.read_bytes(), where=str(path))
        lines = [line for line in text.splitlines() if line.strip()]
        if any("poe-" in line for line in lines if not line.lstrip().startswith("#")):
            return _openquake(path, lines, longitude, latitude)
        return _plain(path)
    except OSError as error:
        raise HazardError(f"{path}: the file cannot be read: {error.strerror}") from None
    except (ColumnError, HazardError) as error:
        raise HazardError(str(error) if str(error).startswith(str(path)) else f"{path}: {error}") from None


def _plain(path: Path) -> SiteHazard:
    columns = read_columns(path)
    label, unit = columns.header[0], columns.units[0]
    if unit is None:
        raise HazardError(f"the header gives no unit for the intensity; write it like: {EXAMPLE}")
    start = label.strip().lower()[:3]
    if start not in PLAIN:
        raise HazardError(
            f'its first column is "{label.strip()}", neither pga nor pgv; write the header like: {EXAMPLE}; give '
            "spectral accelerations as OpenQuake does"
        )
    measure, units = PLAIN[start]
    values, rates = factor_of(unit, known=units) * columns.values[:, 0], columns.values[:, 1]
    if (columns.units[1] or "").replace(" ", "").lower() in PERIODS:
        with np.errstate(divide="ignore"):
            rates = 1.0 / rates
    elif (columns.units[1] or "1/year").replace(" ", "").lower() not in YEARS:
        raise HazardError(f'unit "{columns.units[1]}" of the second column is not known; write it like: {EXAMPLE}')
    order = np.argsort(values, kind="stable")
    return SiteHazard(HazardCurve(values[order], rates[order]), measure)


def _openquake(path: Path, lines: list[str], longitude: float | None, latitude: float | None) -> SiteHazard:
    comment = " ".join(line for line in lines if line.lstrip().startswith("#"))
    rows = list(csv.reader(line for line in lines if not line.lstrip().startswith("#")))
    header = [field.split(":")[0].strip() for field in rows[0]]
    measure, factor, period = _measure(path, comment)
    years = _years(comment)
    row, distance = _site(header, rows[1:], longitude, latitude)
    levels = [(at, _number(name[4:], name)) for at, name in enumerate(header) if name.startswith("poe-")]
    if alien := [name for name in header[levels[0][0] if levels else len(header) :] if name[:4] != "poe-"]:
        raise HazardError(f'column "{alien[0]}" stands among those of probabilities, poe-…; the table is damaged')
    im = factor * np.array([level for _, level in levels])
    poe = np.array([_number(row[at], header[at]) for at, _ in levels])
    if ((poe < 0.0) | (poe > 1.0) | np.isnan(poe)).any():
        raise HazardError("a probability of exceedance is not between 0 and 1; is this a hazard curve?")
    known = (poe > 0.0) & (poe < 1.0)
    if known.sum() < 2:
        raise HazardError("fewer than two probabilities of exceedance lie between 0 and 1; compute more levels")
    return SiteHazard(HazardCurve(im[known], -np.log1p(-poe[known]) / years), measure, period, distance)


def _measure(path: Path, comment: str) -> tuple[Measure, float, float | None]:
    """Return measure, factor of its unit and period from the comment, else from the file's name."""
    found = re.search(r"\bimt=[\\\"' ]*" + IMT, comment) or re.search(rf"-{IMT}(?:_\d+)?\.csv$", path.name)
    if found is None:
        raise HazardError(
            "neither its comment nor its name tells the intensity measure; keep the name that OpenQuake gave it, like "
            "hazard_curve-mean-PGA_23.csv"
        )
    name, _, inside = found[1].partition("(")
    if name not in FACTORS or (name == "SA") != bool(inside):
        raise HazardError(f'intensity measure "{found[1]}" cannot be used; export one of PGA, PGV, SA(period)')
    measure, factor = FACTORS[name]
    return measure, factor, _number(inside.rstrip(")"), found[1]) if inside else None


def _years(comment: str) -> float:
    found = re.search(r"investigation_time=[\\\"' ]*([0-9.eE+-]+)", comment)
    years = 0.0 if found is None else _number(found[1], "investigation_time")
    if not years > 0.0:
        raise HazardError(
            "its first line gives no investigation_time, without which probabilities are no rates; export it again "
            "with OpenQuake, or write intensity and annual rate in two columns"
        )
    return years


def _site(
    header: list[str], rows: list[list[str]], longitude: float | None, latitude: float | None
) -> tuple[list[str], float | None]:
    """Return the row of the site, and its distance to the one asked for [km]."""
    wrong = next((at for at, row in enumerate(rows, start=1) if len(row) != len(header)), None)
    if wrong is not None or not rows:
        raise HazardError(f"site {wrong} has another number of columns than the header" if rows else "it has no site")
    if not {"lon", "lat"} <= set(header):
        if len(rows) > 1:
            raise HazardError(f"it has {len(rows)} sites and no columns lon and lat to choose from")
        return rows[0], None
    lon, lat = ([_number(row[header.index(name)], name) for row in rows] for name in ("lon", "lat"))
    if longitude is None or latitude is None:
        if len(rows) > 1:
            raise HazardError(f"it has {len(rows)} sites; give longitude and latitude of yours as site")
        return rows[0], None
    distances = _distance(np.array(lon), np.array(lat), longitude, latitude)
    at = int(np.argmin(distances))
    if not distances[at] <= FARTHEST:
        raise HazardError(
            f"its nearest site is {distances[at]:.0f} km from longitude {longitude:g}, latitude {latitude:g}; give the "
            "hazard of the site"
        )
    return rows[at], float(distances[at])


def _distance(lon: FloatArray, lat: FloatArray, longitude: float, latitude: float) -> FloatArray:
    """Return great-circle distances of sites [n] from a place [km], by the haversine formula."""
    a, b, da, db = np.radians(lat), np.radians(latitude), np.radians(lat - latitude), np.radians(lon - longitude)
    h = np.sin(0.5 * da) ** 2 + np.cos(a) * np.cos(b) * np.sin(0.5 * db) ** 2
    return np.asarray(2.0 * EARTH_RADIUS * np.arcsin(np.sqrt(np.minimum(h, 1.0))))


def _number(text: str, where: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise HazardError(f'"{text}" in "{where}" is not a number') from None
