"""The horizontal elastic site spectrum of SNZ TS 1170.5:2025, from its four parameters of a place.

The formulas agree with two public implementations of clause 3.1.2 and with their grid point in Wellington; the tables
are those that GNS Science publishes as CSV. Nobody here has read the specification: what it says of near faults,
vertical motion, parts and damping is not built in.
"""

from __future__ import annotations

from dataclasses import replace
from difflib import get_close_matches
from pathlib import Path

import numpy as np

from assess.messages.message import warning
from spectra.arrays import FloatArray, plain_float
from spectra.columns import ColumnError, csv_rows, decode
from spectra.damping import ec8_eta
from spectra.errors import SpectrumError
from spectra.gravity import g
from spectra.spectrum import Spectrum, check_periods, check_positive, plausibility_warnings

CODE = "ts1170.5"
NEAR_FAULT = "ts1170-near-fault"  # key of the warning
RISE = 0.1  # s: end of the rising branch
CLASSES = ("I", "II", "III", "IV", "V", "VI")
DAMPING_RULE = (
    "EN 1998-1 eq. (3.6), applied to TS 1170.5, whose own rule was not read: zero-period ordinate kept, eta in full "
    "from 0.1 s on, linear in between"
)


def site_spectrum(*, pga: float, s_as: float, t_c: float, t_d: float) -> Spectrum:
    """Return the horizontal elastic site spectrum.

        T < 0.1 s          PGA + (S_a,s - PGA) T / 0.1
        0.1 s <= T <= T_c  S_a,s
        T_c < T <= T_d     S_a,s T_c / T
        T > T_d            S_a,s (T_c / T) (T_d / T)^0.5

    The first branch is that of response-spectrum and time-history analyses.

    Parameters
    ----------
    pga, s_as : peak ground acceleration and short-period spectral acceleration S_a,s [m/s2]
    t_c, t_d : corner periods of the acceleration and velocity plateaus [s]

    Raises
    ------
    SpectrumError : a number is not positive, S_a,s is below PGA, or not 0.1 s < T_c < T_d

    Source: SNZ TS 1170.5:2025, 3.1.2, eq. 3.2 to 3.5.
    """
    check_positive(CODE, pga_site=pga, s_as=s_as, t_c=t_c, t_d=t_d)
    if s_as < pga:
        raise SpectrumError(f"{CODE} spectrum: s_as = {s_as / g:.4g} g is below pga_site = {pga / g:.4g} g; exchanged?")
    if not RISE < t_c < t_d:
        raise SpectrumError(f"{CODE} spectrum: t_c = {t_c:.4g} s, t_d = {t_d:.4g} s; 0.1 s < T_c < T_d is needed")

    def ordinates(period: FloatArray, damping: float) -> FloatArray:
        T, plateau = np.maximum(check_periods(period), RISE), ec8_eta(damping) * s_as
        falling = plateau * np.minimum(1.0, t_c / T) * np.minimum(1.0, t_d / T) ** 0.5
        return np.asarray(np.where(period < RISE, pga + (plateau - pga) * period / RISE, falling), dtype=np.float64)

    return Spectrum(
        code=CODE,
        parameters={"pga": pga, "s_as": s_as, "t_c": t_c, "t_d": t_d},
        damping=0.05,
        damping_rule=DAMPING_RULE,
        ordinates=ordinates,
        clause="SNZ TS 1170.5:2025, 3.1.2",
        warnings=(*plausibility_warnings(pga_site=pga, s_as=s_as), warning(NEAR_FAULT)),
    )


def tabulated_spectrum(file: Path, *, location: str, site_class: str, return_period: float) -> Spectrum:
    """Return the spectrum of a place from the published CSV of Table 3.1 (settlements) or 3.2 (grid points).

    Parameters
    ----------
    file : with columns location, apoe, D and, for each class, like IV-PGA, IV-Sas [g], IV-Tc, IV-Td [s]
    location : name of the settlement, with or without macrons, or grid point like "-41.3~174.8"
    site_class : "I" to "VI"
    return_period : that of a row [years]; the specification was not read on any between them

    Raises
    ------
    SpectrumError : the file is none of these tables, or has no such place or return period; class VII
    """
    if site_class == "VII":
        raise SpectrumError(
            f'{CODE} spectrum: site_class = VII has no row in the tables; give its spectrum with code = "table"'
        )
    rows = _rows_of_place(file, location)
    row = rows.get(return_period)
    if row is None:
        raise SpectrumError(
            f"{file}: {location} has no return period of {return_period:g} years; choose one of "
            f"{', '.join(f'{years:g}' for years in rows)}"
        )
    try:
        pga, s_as, t_c, t_d = (plain_float(row[f"{site_class}-{name}"]) for name in ("PGA", "Sas", "Tc", "Td"))
        distance = None if row["D"] in (">20", "n/a", "") else 1e3 * plain_float(row["D"])
    except ValueError as error:
        raise SpectrumError(f"{file}: {location}, {return_period:g} years, class {site_class}: {error}") from None
    found = site_spectrum(pga=pga * g, s_as=s_as * g, t_c=t_c, t_d=t_d)
    place: dict[str, float | str] = {"location": location, "site_class": site_class, "return_period": return_period}
    place["near_fault_distance"] = "none" if distance is None else distance
    near = found.warnings if distance is not None else found.warnings[:-1]
    return replace(found, parameters={**place, **found.parameters}, warnings=near)


def _rows_of_place(file: Path, location: str) -> dict[float, dict[str, str]]:
    """Return the rows of a place by return period [years], each by the names of its columns."""
    try:
        lines = csv_rows(decode(file.read_bytes(), where=str(file)).splitlines())
        header = next(lines, (1, []))[1]
        needed = ("location", "apoe", "D", *(f"{c}-{name}" for c in CLASSES for name in ("PGA", "Sas", "Tc", "Td")))
        if missing := [name for name in needed if name not in header]:
            raise SpectrumError(
                f"{file}: no column {missing[0]}; give the CSV of Table 3.1 or 3.2 that GNS Science publishes for TS "
                "1170.5:2025"
            )
        table = [dict(zip(header, cells, strict=False)) for _, cells in lines if len(cells) >= len(header)]
    except ColumnError as error:
        raise SpectrumError(f"{file}: {error}") from None
    except OSError as error:
        raise SpectrumError(f"{file}: the file cannot be read: {error.strerror}") from None
    named = {name.casefold() for row in table for name in (row["location"], row.get("location_ascii", ""))}
    asked = location.strip().casefold()
    if asked not in named:
        near = get_close_matches(asked, sorted(named), n=3, cutoff=0.0)
        raise SpectrumError(f'{file}: no place "{location}"; the nearest names are {", ".join(near)}')
    rows = (r for r in table if asked in (r["location"].casefold(), r.get("location_ascii", "").casefold()))
    try:
        return {plain_float(row["apoe"].strip().removeprefix("1/")): row for row in rows}
    except ValueError as error:
        raise SpectrumError(f"{file}: {location}: apoe: {error}; it is written like 1/500") from None
