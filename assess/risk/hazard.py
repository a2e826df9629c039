"""The hazard of a site, read from files, and the annual rate of a state, hazard and fragility together.

The rate is the integral of the fragility over the hazard, lambda = int P(state | im) |d lambda(im)|: Cornell and
Krawinkler 2000, PEER Center News 3(2); Jalayer and Cornell 2003, PEER 2003/08, eq. 2.5. The hazard is straight between
its rows in logarithms of intensity and rate.

Hazard curves are read from the CSV that the OpenQuake engine exports, and from plain text of two columns. OpenQuake
writes a comment with `investigation_time` and `imt`, then `lon,lat,depth,poe-0.005,...` and a row for each site; `poe`
are probabilities of exceedance in the investigation time T of Poisson's process, so that the annual rate is
-ln(1 - poe) / T. PGA and SA are in g there, PGV in cm/s (OpenQuake manual, "Intensity measure types").
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from assess.errors import HazardError
from assess.short_repr import ShortRepr
from spectra.arrays import FloatArray, plain_float
from spectra.columns import ACCELERATION_UNITS, ColumnError, csv_rows, decode, factor_of, read_columns
from spectra.gravity import g

Probability = Callable[[FloatArray], FloatArray]
ACCURACY = 1e-6  # relative change of the rate at which panels are halved no more
HALVINGS = 10
POINTS, WEIGHTS = np.polynomial.legendre.leggauss(6)
DEPTH = 30  # powers of e below the first row
LARGEST_LOGARITHM = 600.0  # of a rate: a steep first interval, extended far below, is more than floats hold


@dataclass(frozen=True, repr=False)
class HazardCurve(ShortRepr):
    """Annual rates at which intensities are exceeded, at least two rows; wrong rows raise HazardError.

    intensity [n] : positive, rising; annual_rate [n] : positive, not rising [1/year]
    """

    intensity: FloatArray
    annual_rate: FloatArray

    def __post_init__(self) -> None:
        for name in ("intensity", "annual_rate"):
            values = np.array(getattr(self, name), dtype=np.float64)
            values.flags.writeable = False
            object.__setattr__(self, name, values)
        _check_rows(self.intensity, self.annual_rate)

    def rate_at(self, intensity: ArrayLike) -> FloatArray:
        """Return annual rates of exceedance at intensities, any shape; beyond the rows those of the first and last."""
        at = np.log(np.asarray(intensity, dtype=np.float64))
        return np.asarray(np.exp(np.interp(at, np.log(self.intensity), np.log(self.annual_rate))))


@dataclass(frozen=True, repr=False)
class RateEstimate(ShortRepr):
    """The annual rate of a state, within the rows of the hazard and what may come from outside them.

    annual_rate : within the rows [1/year]
    contribution [n-1] : its parts between neighbouring rows of the hazard, or other edges [1/year]
    beyond : what motions above the last row add if every one reaches the state, a bound: the last row's rate [1/year]
    below : what motions below the first row add if the hazard goes on with the slope of its first interval, which is
        more than true where the hazard flattens towards small motions; inf where the state is too likely there [1/year]
    """

    annual_rate: float
    contribution: FloatArray
    beyond: float
    below: float

    @property
    def shares(self) -> FloatArray:
        """Parts of the rate between neighbouring edges [n-1] [-]; zeros where the rate is zero."""
        return self.contribution / self.annual_rate if self.annual_rate > 0.0 else np.zeros_like(self.contribution)


def rate(
    probability: Probability, hazard: HazardCurve, *, breaks: ArrayLike = (), edges: ArrayLike = ()
) -> RateEstimate:
    """Return the annual rate of a state.

    Parameters
    ----------
    probability : of the state at intensities [m], in the hazard's unit
    hazard : of the site
    breaks : intensities at which the probability has kinks, as an empirical curve at its points [k]
    edges : rising intensities from the first row to the last that part the contributions; the rows if empty [n]
    """
    u, v = np.log(hazard.intensity), np.log(hazard.annual_rate)
    slopes = -np.diff(v) / np.diff(u)
    kinks = np.log(np.asarray(breaks, dtype=np.float64))
    dividing = np.log(np.asarray(edges, dtype=np.float64)) if np.size(edges) else u
    further = np.concatenate([kinks, dividing])
    corners = np.unique(np.concatenate([u, further[(further > u[0]) & (further < u[-1])]]))
    row = np.clip(np.searchsorted(u, corners[:-1], side="right") - 1, 0, slopes.size - 1)
    parts = _integrate(probability, corners, u[row], v[row], slopes[row])
    place = np.clip(np.searchsorted(dividing, corners[:-1], side="right") - 1, 0, dividing.size - 2)
    contribution = np.asarray(np.bincount(place, weights=parts, minlength=dividing.size - 1), dtype=np.float64)
    return RateEstimate(
        float(contribution.sum()),
        contribution,
        float(hazard.annual_rate[-1]),
        _rate_below_first_row(probability, u[0], v[0], slopes[0], kinks),
    )


def probability_of(annual_rate: float, *, years: float = 50.0) -> float:
    """Return the probability of at least one occurrence of Poisson's process: 1 - exp(-rate years).

    Parameters
    ----------
    annual_rate : of the state [1/year]
    years : of exposure
    """
    return float(-np.expm1(-annual_rate * years))


VELOCITY_UNITS = {"m/s": 1.0, "cm/s": 0.01, "mm/s": 1e-3}
IN_G = {name: factor / g for name, factor in ACCELERATION_UNITS.items()}
HazardMeasure = Literal["pga", "sa", "pgv"]

OPENQUAKE_MEASURES: Mapping[str, tuple[HazardMeasure, float]] = {
    "PGA": ("pga", 1.0),
    "SA": ("sa", 1.0),
    "PGV": ("pgv", 0.01),
}
"""Measure of OpenQuake's names, and what converts its unit to g or m/s."""

PLAIN_MEASURES: Mapping[str, tuple[HazardMeasure, Mapping[str, float]]] = {
    "pga": ("pga", IN_G),
    "pgv": ("pgv", VELOCITY_UNITS),
}
"""Measure and units of the first column of a plain file, by how its label begins."""
YEARS = {"1/year", "1/yr", "1/y", "1/a", "year^-1"}
PERIODS = {"year", "years", "yr", "a"}
EARTH_RADIUS = 6371.0  # km
SITE_COLUMNS = ("lon", "lat", "depth", "custom_site_id", "site_id", "sid")
FARTHEST = 50.0  # km from the nearest site of a file to the one asked for
EXAMPLE = "pga [g], annual_rate [1/year]"
IMT = r"([A-Za-z][A-Za-z0-9]*(?:\([^)]*\))?)"


@dataclass(frozen=True, repr=False)
class HazardFile(ShortRepr):
    """A hazard curve as read from a file, with what the file says of it.

    curve : PGA and SA in g, PGV in m/s
    measure : "pga", "sa", "pgv"; period : of "sa" [s]
    distance : of the site of the file from the one asked for [km]; None where none is asked for
    """

    curve: HazardCurve
    measure: HazardMeasure
    period: float | None = None
    distance: float | None = None


def read_hazard(path: Path, *, longitude: float | None = None, latitude: float | None = None) -> HazardFile:
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
        lines = text.splitlines()
        if any("poe-" in line for line in lines if not line.lstrip().startswith("#")):
            return _read_openquake(path, lines, longitude, latitude)
        return _read_two_columns(path)
    except OSError as error:
        raise HazardError(f"{path}: the file cannot be read: {error.strerror}") from None
    except (ColumnError, HazardError) as error:
        raise HazardError(str(error) if str(error).startswith(str(path)) else f"{path}: {error}") from None


def _check_rows(intensity: FloatArray, annual_rate: FloatArray) -> None:
    if intensity.ndim != 1 or intensity.shape != annual_rate.shape or intensity.size < 2:
        raise HazardError("hazard: give at least two rows of intensity and annual rate of exceedance")
    for name, values in (("intensity", intensity), ("annual rate", annual_rate)):
        wrong = values[~(np.isfinite(values) & (values > 0.0))]
        if wrong.size:
            raise HazardError(f"hazard: {name} {wrong[0]:g} is not a positive number; leave that row out")
    if (np.diff(intensity) <= 0.0).any():
        at = int(np.argmax(np.diff(intensity) <= 0.0))
        raise HazardError(
            f"hazard: intensity {intensity[at + 1]:g} follows {intensity[at]:g}; give rows at rising intensity"
        )
    if (np.diff(annual_rate) > 0.0).any():
        at = int(np.argmax(np.diff(annual_rate) > 0.0))
        raise HazardError(
            f"hazard: the annual rate rises from {annual_rate[at]:g} to {annual_rate[at + 1]:g} at intensity "
            f"{intensity[at + 1]:g}; rates of exceedance fall as intensity rises"
        )


def _integrate(
    probability: Probability, corners: FloatArray, u_0: FloatArray, v_0: FloatArray, k: FloatArray
) -> FloatArray:
    """Return the integrals of P k lambda du between corners [m], lambda = exp(v_0 - k (u - u_0)), halving panels."""
    before = _gauss(probability, corners, u_0, v_0, k, panels=4)
    for halving in range(1, HALVINGS + 1):
        parts = _gauss(probability, corners, u_0, v_0, k, panels=4 * 2**halving)
        if np.abs(parts - before).sum() <= ACCURACY * parts.sum():
            break
        before = parts
    return parts


def _gauss(
    probability: Probability, corners: FloatArray, u_0: FloatArray, v_0: FloatArray, k: FloatArray, *, panels: int
) -> FloatArray:
    width = np.diff(corners)[:, None] / panels
    starts = corners[:-1, None] + width * np.arange(panels)
    u = starts[:, :, None] + 0.5 * width[:, :, None] * (1.0 + POINTS)
    logarithm = v_0[:, None, None] - k[:, None, None] * (u - u_0[:, None, None])
    density = k[:, None, None] * np.exp(np.minimum(logarithm, LARGEST_LOGARITHM))
    inside = probability(np.exp(u).ravel()).reshape(u.shape) * density
    return np.asarray((inside @ WEIGHTS).sum(axis=1) * 0.5 * width[:, 0])


def _rate_below_first_row(probability: Probability, u: float, v: float, k: float, kinks: FloatArray) -> float:
    """Return the rate below the first row, the first slope going on; inf where it does not converge."""
    corners = np.unique(np.concatenate([u - np.arange(DEPTH + 1.0), kinks[(kinks < u) & (kinks > u - DEPTH)]]))
    same = np.ones(corners.size - 1)
    parts = _integrate(probability, corners, u * same, v * same, k * same)
    return float("inf") if parts[0] > ACCURACY * parts.sum() else float(parts.sum())


def _read_two_columns(path: Path) -> HazardFile:
    columns = read_columns(path)
    label, unit = columns.header[0], columns.units[0]
    if unit is None:
        raise HazardError(f"the header gives no unit for the intensity; write it like: {EXAMPLE}")
    start = label.strip().lower()[:3]
    if start not in PLAIN_MEASURES:
        raise HazardError(
            f'its first column is "{label.strip()}", neither pga nor pgv; write the header like: {EXAMPLE}; give '
            "spectral accelerations as OpenQuake does"
        )
    measure, units = PLAIN_MEASURES[start]
    values, rates = factor_of(unit, known=units) * columns.values[:, 0], columns.values[:, 1]
    if (columns.units[1] or "").replace(" ", "").lower() in PERIODS:
        with np.errstate(divide="ignore"):
            rates = 1.0 / rates
    elif (columns.units[1] or "1/year").replace(" ", "").lower() not in YEARS:
        raise HazardError(f'unit "{columns.units[1]}" of the second column is not known; write it like: {EXAMPLE}')
    order = np.argsort(values, kind="stable")
    return HazardFile(HazardCurve(values[order], rates[order]), measure)


def _read_openquake(path: Path, lines: list[str], longitude: float | None, latitude: float | None) -> HazardFile:
    comment = " ".join(line for line in lines if line.lstrip().startswith("#"))
    table = ("" if line.lstrip().startswith("#") else line for line in lines)
    rows = [row for _, row in csv_rows(table) if any(cell.strip() for cell in row)]
    header = [field.split(":")[0].strip() for field in rows[0]]
    measure, factor, period = _measure(path, comment)
    years = _years(comment)
    row, distance = _nearest_site(header, rows[1:], longitude, latitude)
    levels = [(at, _number(name[4:], name)) for at, name in enumerate(header) if name.startswith("poe-")]
    if alien := [name for name in header if not name.startswith("poe-") and name not in SITE_COLUMNS]:
        raise HazardError(f'column "{alien[0]}" is none of {", ".join(SITE_COLUMNS)}, poe-…; is the header damaged?')
    im = factor * np.array([level for _, level in levels])
    poe = np.array([_number(row[at], header[at]) for at, _ in levels])
    if ((poe < 0.0) | (poe > 1.0) | np.isnan(poe)).any():
        raise HazardError("a probability of exceedance is not between 0 and 1; is this a hazard curve?")
    known = (poe > 0.0) & (poe < 1.0)
    if known.sum() < 2:
        raise HazardError("fewer than two probabilities of exceedance lie between 0 and 1; compute more levels")
    return HazardFile(HazardCurve(im[known], -np.log1p(-poe[known]) / years), measure, period, distance)


def _measure(path: Path, comment: str) -> tuple[HazardMeasure, float, float | None]:
    """Return measure, factor of its unit and period from the comment, else from the file's name."""
    found = re.search(r"\bimt=[\\\"' ]*" + IMT, comment) or re.search(rf"-{IMT}(?:_\d+)?\.csv$", path.name)
    if found is None:
        raise HazardError(
            "neither its comment nor its name tells the intensity measure; keep the name that OpenQuake gave it, like "
            "hazard_curve-mean-PGA_23.csv"
        )
    name, _, inside = found[1].partition("(")
    if name not in OPENQUAKE_MEASURES or (name == "SA") != bool(inside):
        raise HazardError(f'intensity measure "{found[1]}" cannot be used; export one of PGA, PGV, SA(period)')
    measure, factor = OPENQUAKE_MEASURES[name]
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


def _nearest_site(
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
        return plain_float(text)
    except ValueError:
        raise HazardError(f'"{text}" in "{where}" is not a number') from None
