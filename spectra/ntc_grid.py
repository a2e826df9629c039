"""The hazard of a site from a file of the Italian grid, by the four nodes around it (NTC 2008, Annexes A and B).

The file is the user's: NTC 2018 refers to the same annexes. The weights by the inverse of the distance are as a region
of Italy prints them from Annex A; nothing was compared with the printed decree.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import lru_cache
from itertools import combinations
from pathlib import Path

import numpy as np

from spectra.arrays import FloatArray
from spectra.columns import ColumnError, csv_rows, decode, factor_of, separator_of, unit_of
from spectra.errors import SpectrumError
from spectra.gravity import g
from spectra.ntc import Hazard

EARTH_RADIUS = 6371.0  # km
ON_NODE = 1e-3  # km: a site this near to a node has its values
SLACK = 0.02  # of a side of the mesh, by which it is no exact parallelogram
NEAREST = 16  # nodes among which the mesh is sought
UNITS: Mapping[str, float] = {"g": g, "g/10": g / 10.0, "m/s2": 1.0}
COLUMN = re.compile(r"(?P<name>ag|a_g|f0|fo|f_0|tc\*?|t_c\*?|t\*c)[ _]*(?:tr *=? *)?(?P<years>\d+)", re.IGNORECASE)
KEYS: Mapping[str, str] = {"a": "a_g", "f": "f_0", "t": "t_c_star"}  # by the first letter of a heading
EXAMPLE = "lon;lat;ag_30 [g/10];F0_30;Tc_30 [s];ag_50 [g/10];…"


def site_hazard(file: Path, *, latitude: float, longitude: float) -> tuple[Hazard, ...]:
    """Return the hazard at a site for each return period of the file: p = sum(p_i / d_i) / sum(1 / d_i).

    Parameters
    ----------
    file : CSV with columns lon, lat and, for each return period, a_g, F_0 and T_C*; see `EXAMPLE`
    latitude, longitude : of the site, in the datum of the file [deg]

    Raises
    ------
    SpectrumError : names the file, and what cannot be read, or that no four nodes surround the site

    Source: NTC 2008, Annex A, eq. (3); d_i on the plane that touches the sphere at the site.
    """
    try:
        changed = file.stat().st_mtime_ns
        places, values, years = _read_grid(file, changed)
    except ColumnError as error:
        raise SpectrumError(f"{file}: {error}") from None
    except OSError as error:
        raise SpectrumError(f"{file}: the file cannot be read: {error.strerror}") from None
    scale = np.radians(1.0) * EARTH_RADIUS * np.array([np.cos(np.radians(latitude)), 1.0])
    offset = (places - (longitude, latitude)) * scale
    corners = surrounding_nodes(offset)
    if corners is None:
        raise SpectrumError(
            f"{file}: no four nodes of its grid surround {latitude:g} N, {longitude:g} E; check both, or give the rows "
            "of hazard"
        )
    distance = np.hypot(*offset[corners].T)
    weight = 1.0 / distance if distance.min() > ON_NODE else (distance == distance.min()).astype(np.float64)
    a_g, f_0, t_c_star = np.tensordot(weight, values[corners], axes=1) / weight.sum()
    return tuple(map(Hazard, a_g.tolist(), f_0.tolist(), t_c_star.tolist(), years))


def surrounding_nodes(offset: FloatArray) -> list[int] | None:
    """Return the four nodes of the mesh around the origin, by their places [n, 2]; None where there are none.

    The mesh may be turned and slightly oblique: the nearest node, two of its neighbours, and the node opposite to it.
    """
    near = np.argsort(np.hypot(*offset.T))[:NEAREST]
    first = offset[near[0]]
    around = sorted(near[1:], key=lambda node: float(np.hypot(*(offset[node] - first))))[:8]
    step = min((float(np.hypot(*(offset[node] - first))) for node in around), default=0.0)
    for one, other in combinations(around, 2):
        sides = np.array([offset[one] - first, offset[other] - first]).T
        lengths = np.hypot(*sides)
        if abs(np.linalg.det(sides)) < 0.8 * lengths[0] * lengths[1] or max(lengths) > 1.2 * step:
            continue
        u, v = np.linalg.solve(sides, -first)
        opposite = near[np.argmin(np.hypot(*(offset[near] - (first + sides.sum(axis=1))).T))]
        error = np.hypot(*(offset[opposite] - (first + sides.sum(axis=1))))
        if min(u, v) >= -SLACK and max(u, v) <= 1.0 + SLACK and error < 0.1 * min(lengths):
            return [int(near[0]), int(one), int(other), int(opposite)]
    return None


@lru_cache(maxsize=2)
def _read_grid(file: Path, changed: int) -> tuple[FloatArray, FloatArray, tuple[float, ...]]:
    """Return places [n, 2] [deg], a_g, F_0 and T_C* [n, 3, years] in SI, and the years, of a file of that time."""
    lines = [line for line in decode(file.read_bytes(), where=str(file)).splitlines() if line.strip()]
    separator = (separator_of(lines[0]) if lines else None) or ","
    rows = [cells for _, cells in csv_rows(lines, separator=separator)]
    header = [cell.strip() for cell in rows[0]] if rows else []
    found: dict[tuple[str, float], tuple[int, float]] = {}
    for place, heading in enumerate(header):
        if match := COLUMN.match(heading):
            key, unit = KEYS[match["name"][0].lower()], unit_of(heading)
            if key == "a_g" and unit is None:
                raise ColumnError(f'column "{heading}" has no unit; write [g/10] as Annex B prints a_g, [g] or [m/s2]')
            known = UNITS if key == "a_g" else {"s": 1.0, "-": 1.0}
            found[key, float(match["years"])] = place, 1.0 if unit is None else factor_of(unit, known=known)
    years = sorted({each for _, each in found})
    lower = [heading.lower().split()[0] if heading else "" for heading in header]
    lacking = [name for name in ("lon", "lat") if name not in lower]
    lacking += [f"{key} of {each:g} years" for each in years for key in KEYS.values() if (key, each) not in found]
    if lacking or len(years) < 2:
        what = lacking[0] if lacking else "a second return period"
        raise ColumnError(f"no column for {what}; its heading is like {EXAMPLE}")
    columns = [found[key, each] for key in KEYS.values() for each in years]
    used = [lower.index("lon"), lower.index("lat"), *(place for place, _ in columns)]
    mark = "," if separator == ";" else "."
    try:
        numbers = np.array([[float(row[place].replace(mark, ".")) for place in used] for row in rows[1:]])
    except (ValueError, IndexError):
        raise ColumnError("a row below the header is not whole, or holds what is no number") from None
    if len(numbers) < 4 or not np.all(np.isfinite(numbers)) or np.any(numbers[:, 2:] <= 0.0):
        raise ColumnError("four nodes and more are needed, all of positive values")
    values = numbers[:, 2:] * [factor for _, factor in columns]
    return numbers[:, :2], values.reshape(len(numbers), 3, len(years)), tuple(years)
