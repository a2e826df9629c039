"""A spectrum given point by point: a site study, or a code that is not built in."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from spectra.arrays import FloatArray
from spectra.columns import ACCELERATION_UNITS, TIME_UNITS, ColumnError, factor_of, read_columns
from spectra.damping import check_damping, ec8_eta
from spectra.errors import SpectrumError
from spectra.spectrum import Spectrum, plausibility_warnings

DAMPING_RULE = (
    "EN 1998-1 eq. (3.6), applied to a table, which states no rule of its own: zero-period ordinate kept, eta in full "
    "from the period of the largest ordinate on, EN 1998-1 eq. (3.2) in between"
)


def table_spectrum(
    period: ArrayLike,
    acceleration: ArrayLike,
    *,
    damping: float = 0.05,
    pga: float | None = None,
    reduction: Callable[[float], float] = ec8_eta,
) -> Spectrum:
    """Return a spectrum linear between its points.

    Beyond the last period nothing is known: asking there raises SpectrumError. Other damping: see `DAMPING_RULE`; a
    table sampled from EN 1998-1 then gives EN 1998-1. To scale a whole table to a PGA: `scale_to_pga`.

    Parameters
    ----------
    period : rising [n] [s]
    acceleration : at these periods [n] [m/s2]
    damping : of the table [-]
    pga : zero-period ordinate [m/s2], used only where the table has no entry at T = 0
    reduction : factor on ordinates [-] of a damping ratio [-]

    Raises
    ------
    SpectrumError : points are not finite, not positive or not rising in period, or there is no PGA
    """
    points = _with_pga(*_check_points(period, acceleration), pga=pga)
    T_max = float(points.period[-1])
    check_damping(damping)
    return Spectrum(
        code="table",
        parameters={"points": float(points.period.size), "period_max": T_max, "pga": float(points.acceleration[0])},
        damping=damping,
        damping_rule=DAMPING_RULE,
        ordinates=lambda at, other_damping: points.ordinates(at, reduction(other_damping) / reduction(damping)),
        clause="table given by the user",
        longest_period=T_max,
        warnings=plausibility_warnings(**{"S_a(0)": float(points.acceleration[0])}),
    )


def read_table(path: Path, *, damping: float = 0.05, pga: float | None = None) -> Spectrum:
    """Read the spectrum from a text file of two columns, period and acceleration, with their units in the header.

    The header is like `period [s], acceleration [g]` or `T (s);Sa (m/s2)`; units s, ms; g, m/s2, cm/s2, gal, mm/s2.

    Parameters
    ----------
    path : text file
    damping : of the table [-]
    pga : zero-period ordinate [m/s2], used only where the table has no entry at T = 0

    Raises
    ------
    SpectrumError : names the file, and what cannot be read
    """
    try:
        columns = read_columns(path)
        seconds = _factor(columns.units[0], "period", known=TIME_UNITS)
        si = _factor(columns.units[1], "acceleration", known=ACCELERATION_UNITS)
        return table_spectrum(seconds * columns.values[:, 0], si * columns.values[:, 1], damping=damping, pga=pga)
    except (ColumnError, SpectrumError) as error:
        raise SpectrumError(_name_file(path, str(error))) from None
    except OSError as error:
        raise SpectrumError(f"{path}: the file cannot be read: {error.strerror}") from None


@dataclass(frozen=True)
class _Points:
    """Points of a spectrum from T = 0: period [n] [s], acceleration [n] [m/s2]."""

    period: FloatArray
    acceleration: FloatArray

    def ordinates(self, period: FloatArray, eta: float) -> FloatArray:
        """Return ordinates [m/s2] at `period` [s] (same shape), `eta` [-] times as high where damping acts in full."""
        outside = period[~((period >= 0.0) & (period <= self.period[-1]))]
        if outside.size:
            raise SpectrumError(
                f"period {outside[0]:.6g} s is outside the spectrum's table, 0 to {self.period[-1]:.6g} s; "
                "extend the table"
            )
        return np.interp(period, self.period, self.acceleration * self._damping_factor(eta))

    def _damping_factor(self, eta: float) -> FloatArray:
        """Return the factor of damping on each point [n]: 1 at T = 0, eta from the largest ordinate on."""
        T, T_B = self.period, self.period[np.argmax(self.acceleration)]
        amplification = np.max(self.acceleration) / self.acceleration[0]
        tau = np.minimum(T / T_B, 1.0) if T_B > 0.0 else (T > 0.0).astype(np.float64)
        return np.asarray((1.0 + tau * (amplification * eta - 1.0)) / (1.0 + tau * (amplification - 1.0)))


def _name_file(path: Path, text: str) -> str:
    return text if text.startswith(str(path)) else f"{path}: {text}"


def _factor(unit: str | None, column: str, *, known: Mapping[str, float]) -> float:
    if unit is None:
        raise ColumnError(f"the header gives no unit for the {column}; write it like: period [s], acceleration [g]")
    return factor_of(unit, known=known)


def _check_points(period: ArrayLike, acceleration: ArrayLike) -> tuple[FloatArray, FloatArray]:
    """Return both columns as arrays [n], once they make a spectrum."""
    try:
        T, S_a = np.array(period, dtype=np.float64), np.array(acceleration, dtype=np.float64)
    except (TypeError, ValueError):
        raise SpectrumError("spectrum table: give period [s] and acceleration [m/s2] as rows of numbers") from None
    if T.ndim != 1 or T.shape != S_a.shape or T.size == 0:
        raise SpectrumError(
            f"spectrum table: {T.size} periods and {S_a.size} accelerations; one of each per point is needed"
        )
    for name, values in (("period", T), ("acceleration", S_a)):
        bad = np.flatnonzero(~np.isfinite(values))
        if bad.size:
            raise SpectrumError(
                f"spectrum table, point {bad[0] + 1}: {name} {values[bad[0]]}; it must be a finite number"
            )
    if T[0] < 0.0:
        raise SpectrumError(f"spectrum table, point 1: period {T[0]:.6g} s; periods start at 0 or above")
    back = np.flatnonzero(np.diff(T) <= 0.0)
    if back.size:
        raise SpectrumError(
            f"spectrum table, point {back[0] + 2}: period {T[back[0] + 1]:.6g} s does not exceed the one before, "
            f"{T[back[0]]:.6g} s; sort the table and give each period once"
        )
    low = np.flatnonzero(S_a <= 0.0)
    if low.size:
        raise SpectrumError(
            f"spectrum table, point {low[0] + 1}: acceleration {S_a[low[0]]:.6g} m/s2; it must be positive"
        )
    return T, S_a


def _with_pga(period: FloatArray, acceleration: FloatArray, *, pga: float | None) -> _Points:
    """Return the points from T = 0: the table's own first entry, or `pga` [m/s2] put before it."""
    if pga is not None and not (np.isfinite(pga) and pga > 0.0):
        raise SpectrumError(f"spectrum table: pga = {pga} m/s2; it must be a positive number")
    if period[0] > 0.0:
        if pga is None:
            raise SpectrumError(
                f"spectrum table starts at {period[0]:.6g} s; add the point at T = 0 (the PGA) or give pga"
            )
        period, acceleration = np.insert(period, 0, 0.0), np.insert(acceleration, 0, pga)
    if period.size < 2:
        raise SpectrumError("spectrum table: one point; a spectrum needs at least two")
    return _Points(period, acceleration)
