"""The two-corner design spectrum of ASCE 7, editions 2005 to 2016, with the IBC that copies it.

The site coefficients agree with those that the USGS tools compute with; the rules on site studies are from memory, and
nothing was compared with the printed standards.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from scipy.constants import g

from assess.messages.message import warning
from spectra.arrays import FloatArray
from spectra.asce7_editions import SiteTable, edition_of
from spectra.damping import asce7_b_factor
from spectra.errors import SpectrumError
from spectra.spectrum import Spectrum, check_periods, check_positive, in_g, plausibility_warnings

ZERO_PERIOD_RATIO = 0.4  # S_a(0) / S_DS
ROUNDING = 1e-9  # of a mapped acceleration [g]
HAZARD_FACTOR: Mapping[str, float] = {"design": 1.0, "mce": 1.5}


def mapped_spectrum(
    *, s_s: float, s_1: float, site_class: str, t_l: float, code: str = "asce7-16", hazard: str = "design"
) -> Spectrum:
    """Return the design spectrum from the mapped accelerations of the rock and the site class.

        S_MS = F_a S_S    S_M1 = F_v S_1    S_DS = 2/3 S_MS    S_D1 = 2/3 S_M1

    Where the standard has coefficients and yet asks for a study of the site, the spectrum has a warning.

    Parameters
    ----------
    s_s, s_1 : mapped spectral accelerations at short periods and at 1 s [m/s2]
    site_class : "A" to "E"; ASCE 7-16 also "B-unmeasured" (§11.4.3) and "D-default" (§11.4.4)
    t_l : long-period transition period T_L [s]
    code : edition, a key of `EDITIONS`
    hazard : "design" or "mce"

    Raises
    ------
    SpectrumError : site class F, and whatever `design_spectrum` refuses

    Source: ASCE 7-16 §11.4.4-11.4.5, 7-10 and 7-05 §11.4.3-11.4.4, with Tables 11.4-1 and 11.4-2 of each.
    """
    edition = edition_of(code)
    check_positive(code, s_s=s_s, s_1=s_1)
    F_a = site_coefficient(s_s, table=edition.f_a, site_class=site_class, study=edition.study)
    F_v = site_coefficient(s_1, table=edition.f_v, site_class=site_class, study=edition.study)
    S_MS, S_M1 = F_a * s_s, F_v * s_1
    spectrum = design_spectrum(s_ds=2 / 3 * S_MS, s_d1=2 / 3 * S_M1, t_l=t_l, code=code, hazard=hazard)
    mapped: dict[str, float | str] = {
        "s_s": s_s,
        "s_1": s_1,
        "site_class": site_class,
        "f_a": F_a,
        "f_v": F_v,
        "s_ms": S_MS,
        "s_m1": S_M1,
    }
    given = {"s_s": s_s / g, "s_1": s_1 / g}
    warnings = [
        warning(r.key) for r in edition.rules if site_class in r.classes and given[r.parameter] >= r.least - ROUNDING
    ]
    if s_1 > s_s:
        warnings.append(warning("mapped-exchanged", s_1=in_g(s_1), s_s=in_g(s_s)))
    implausible = plausibility_warnings(s_s=s_s, s_1=s_1)
    return replace(spectrum, parameters={**mapped, **spectrum.parameters}, warnings=(*implausible, *warnings))


def site_coefficient(mapped: float, *, table: SiteTable, site_class: str, study: str) -> float:
    """Return F_a or F_v [-] at the `mapped` acceleration [m/s2], linear between columns and constant beyond them.

    Raises SpectrumError for site class F, citing the clause `study`, and for a class that the table does not have.
    """
    if site_class == "F":
        raise SpectrumError(
            f"site_class = F: {study} asks for a site response analysis; give its s_ds and s_d1, or its spectrum with "
            'code = "table"'
        )
    if site_class not in table.rows:
        raise SpectrumError(f"site_class = {site_class}; {table.clause} has {', '.join(table.rows)}")
    return float(np.interp(mapped / g, table.columns, table.rows[site_class]))


def design_spectrum(
    *, s_ds: float, s_d1: float, t_l: float, code: str = "asce7-16", hazard: str = "design"
) -> Spectrum:
    """Return the design spectrum from its two design ordinates.

        T < T_0          S_DS (0.4 + 0.6 T / T_0)         T_0 = 0.2 T_S
        T_0 <= T <= T_S  S_DS                             T_S = S_D1 / S_DS
        T_S < T <= T_L   S_D1 / T
        T > T_L          S_D1 T_L / T^2

    Damping other than 5 % divides the ordinates from T_0 on by B. The code divides S_a by B and is silent on T < T_0; a
    rigid body moves with the ground whatever its damping, so here the zero-period ordinate is kept and the ordinates
    are linear in between.

    Parameters
    ----------
    s_ds, s_d1 : design spectral accelerations at short periods and at 1 s [m/s2]
    t_l : long-period transition period T_L [s]
    code : edition, a key of `EDITIONS`
    hazard : "design", or "mce", which multiplies every ordinate by 1.5

    Raises
    ------
    SpectrumError : the code or hazard is unknown, a value is not positive, or T_S > T_L

    Source: ASCE 7-16 §11.4.6-11.4.7, 7-10 and 7-05 §11.4.5-11.4.6; damping Table 18.7-1 (18.6-1).
    """
    edition = edition_of(code)
    if hazard not in HAZARD_FACTOR:
        raise SpectrumError(f'hazard "{hazard}" is not known; choose one of {", ".join(HAZARD_FACTOR)}')
    check_positive(code, s_ds=s_ds, s_d1=s_d1, t_l=t_l)
    t_s = s_d1 / s_ds
    if t_s > t_l:
        raise SpectrumError(
            f"{code} spectrum: T_S = S_D1 / S_DS = {t_s:.4g} s exceeds t_l = {t_l:.4g} s ({edition.design})"
        )
    shape, factor = _Shape(s_ds, s_d1, t_l), HAZARD_FACTOR[hazard]
    return Spectrum(
        code=code,
        parameters={"s_ds": s_ds, "s_d1": s_d1, "t_l": t_l, "t_0": shape.t_0, "t_s": t_s, "hazard": hazard},
        damping=0.05,
        damping_rule=edition.damping,
        ordinates=lambda period, damping: factor * shape.ordinates(period, damping),
        clause=edition.design if hazard == "design" else edition.mce,
        warnings=plausibility_warnings(s_ds=s_ds, s_d1=s_d1),
    )


@dataclass(frozen=True)
class _Shape:
    """The spectrum's curve: S_DS, S_D1 [m/s2], T_L [s]."""

    s_ds: float
    s_d1: float
    t_l: float

    @property
    def t_0(self) -> float:
        """T_0 = 0.2 S_D1 / S_DS [s]."""
        return 0.2 * self.s_d1 / self.s_ds

    def ordinates(self, period: FloatArray, damping: float) -> FloatArray:
        """S_a [m/s2] at `period` [s] (same shape) and `damping` [-]."""
        S_DS, S_D1, T_L, T_0, B = self.s_ds, self.s_d1, self.t_l, self.t_0, asce7_b_factor(damping)
        T = np.maximum(check_periods(period), T_0)
        falling = np.minimum(S_DS, S_D1 / T * np.minimum(1.0, T_L / T)) / B
        rising = S_DS * (ZERO_PERIOD_RATIO + (1.0 / B - ZERO_PERIOD_RATIO) * period / T_0)
        return np.asarray(np.where(period < T_0, rising, falling), dtype=np.float64)
