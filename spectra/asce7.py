"""The two-corner design spectrum of ASCE 7, editions 2005 to 2016, with the IBC that copies it.

Each edition has its clauses, its site coefficients, and when it asks for a study of the site. The coefficients agree
with those that the USGS tools compute with; the rules on site studies are from memory, and nothing was compared with
the printed standards.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from assess.messages.message import warning
from spectra.arrays import FloatArray
from spectra.damping import asce7_b_factor
from spectra.errors import SpectrumError
from spectra.gravity import g
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
    edition = _edition_of(code)
    check_positive(code, s_s=s_s, s_1=s_1)
    F_a = site_coefficient(s_s, table=edition.f_a, site_class=site_class, study=edition.study)
    F_v = site_coefficient(s_1, table=edition.f_v, site_class=site_class, study=edition.study)
    S_MS, S_M1 = F_a * s_s, F_v * s_1
    spectrum = design_spectrum(s_ds=2 / 3 * S_MS, s_d1=2 / 3 * S_M1, t_l=t_l, code=code, hazard=hazard)
    inputs: dict[str, float | str] = {
        "s_s": s_s,
        "s_1": s_1,
        "site_class": site_class,
        "f_a": F_a,
        "f_v": F_v,
        "s_ms": S_MS,
        "s_m1": S_M1,
    }
    in_units_of_g = {"s_s": s_s / g, "s_1": s_1 / g}
    warnings = [
        warning(r.key)
        for r in edition.rules
        if site_class in r.classes and in_units_of_g[r.parameter] >= r.least - ROUNDING
    ]
    if s_1 > s_s:
        warnings.append(warning("mapped-exchanged", s_1=in_g(s_1), s_s=in_g(s_s)))
    implausible = plausibility_warnings(s_s=s_s, s_1=s_1)
    return replace(spectrum, parameters={**inputs, **spectrum.parameters}, warnings=(*implausible, *warnings))


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
    edition = _edition_of(code)
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


Rows = Mapping[str, tuple[float, ...]]


@dataclass(frozen=True)
class SiteTable:
    """A site coefficient over a mapped acceleration: columns [g], a row of coefficients [-] for each site class."""

    clause: str
    columns: tuple[float, ...]
    rows: Rows


@dataclass(frozen=True)
class StudyRule:
    """When the standard asks for a study of the site: its classes, the least mapped value [g], the key of a message."""

    classes: tuple[str, ...]
    parameter: Literal["s_s", "s_1"]
    least: float
    key: str


@dataclass(frozen=True)
class Edition:
    """Where an edition keeps the design spectrum and the MCE spectrum, its rule for damping, coefficients, studies."""

    design: str
    mce: str
    damping: str
    f_a: SiteTable
    f_v: SiteTable
    study: str
    rules: tuple[StudyRule, ...] = ()


F_A_2005: Rows = {
    "A": (0.8, 0.8, 0.8, 0.8, 0.8),
    "B": (1.0, 1.0, 1.0, 1.0, 1.0),
    "C": (1.2, 1.2, 1.1, 1.0, 1.0),
    "D": (1.6, 1.4, 1.2, 1.1, 1.0),
    "E": (2.5, 1.7, 1.2, 0.9, 0.9),
}

F_V_2005: Rows = {
    "A": (0.8, 0.8, 0.8, 0.8, 0.8),
    "B": (1.0, 1.0, 1.0, 1.0, 1.0),
    "C": (1.7, 1.6, 1.5, 1.4, 1.3),
    "D": (2.4, 2.0, 1.8, 1.6, 1.5),
    "E": (3.5, 3.2, 2.8, 2.4, 2.4),
}

F_A_2016: Rows = {
    "A": (0.8, 0.8, 0.8, 0.8, 0.8, 0.8),
    "B": (0.9, 0.9, 0.9, 0.9, 0.9, 0.9),
    "B-unmeasured": (1.0, 1.0, 1.0, 1.0, 1.0, 1.0),  # 11.4.3: no shear wave velocity measured
    "C": (1.3, 1.3, 1.2, 1.2, 1.2, 1.2),
    "D": (1.6, 1.4, 1.2, 1.1, 1.0, 1.0),
    "D-default": (1.6, 1.4, 1.2, 1.2, 1.2, 1.2),  # 11.4.4: site class D taken by default
    "E": (2.4, 1.7, 1.3, 1.2, 1.2, 1.2),  # from S_S = 1.0 the value of class C, exception 1 of 11.4.8
}

F_V_2016: Rows = {
    "A": (0.8, 0.8, 0.8, 0.8, 0.8, 0.8),
    "B": (0.8, 0.8, 0.8, 0.8, 0.8, 0.8),
    "B-unmeasured": (1.0, 1.0, 1.0, 1.0, 1.0, 1.0),
    "C": (1.5, 1.5, 1.5, 1.5, 1.5, 1.4),
    "D": (2.4, 2.2, 2.0, 1.9, 1.8, 1.7),
    "D-default": (2.4, 2.2, 2.0, 1.9, 1.8, 1.7),
    "E": (4.2, 3.3, 2.8, 2.4, 2.2, 2.0),
}

STUDIES_2016 = (
    StudyRule(("E",), "s_s", 1.0, "study-of-class-e"),
    StudyRule(("D", "D-default", "E"), "s_1", 0.2, "study-of-classes-d-and-e"),
)
_COLUMNS_2005 = ((0.25, 0.5, 0.75, 1.0, 1.25), (0.1, 0.2, 0.3, 0.4, 0.5))  # S_S, S_1 [g]
_COLUMNS_2016 = ((0.25, 0.5, 0.75, 1.0, 1.25, 1.5), (0.1, 0.2, 0.3, 0.4, 0.5, 0.6))

EDITIONS: Mapping[str, Edition] = {
    "asce7-05": Edition(
        "ASCE 7-05 §11.4.5",
        "ASCE 7-05 §11.4.6",
        "ASCE 7-05 Table 18.6-1: ordinates from T_0 on divided by B, zero-period ordinate kept, linear in between (the "
        "code is silent below T_0); not checked against the printed standard",
        SiteTable("ASCE 7-05 Table 11.4-1", _COLUMNS_2005[0], F_A_2005),
        SiteTable("ASCE 7-05 Table 11.4-2", _COLUMNS_2005[1], F_V_2005),
        "ASCE 7-05 §11.4.7",
    ),
    "ibc2009": Edition(
        "IBC 2009 §1613.5 with ASCE 7-05 §11.4.5",
        "IBC 2009 §1613.5 with ASCE 7-05 §11.4.6",
        "ASCE 7-05 Table 18.6-1: ordinates from T_0 on divided by B, zero-period ordinate kept, linear in between (the "
        "code is silent below T_0); not checked against the printed standard",
        SiteTable("IBC 2009 Table 1613.5.3(1)", _COLUMNS_2005[0], F_A_2005),
        SiteTable("IBC 2009 Table 1613.5.3(2)", _COLUMNS_2005[1], F_V_2005),
        "ASCE 7-05 §11.4.7",
    ),
    "asce7-10": Edition(
        "ASCE 7-10 §11.4.5",
        "ASCE 7-10 §11.4.6",
        "ASCE 7-10 Table 18.6-1: ordinates from T_0 on divided by B, zero-period ordinate kept, linear in between (the "
        "code is silent below T_0); not checked against the printed standard",
        SiteTable("ASCE 7-10 Table 11.4-1", _COLUMNS_2005[0], F_A_2005),
        SiteTable("ASCE 7-10 Table 11.4-2", _COLUMNS_2005[1], F_V_2005),
        "ASCE 7-10 §11.4.7",
    ),
    "asce7-16": Edition(
        "ASCE 7-16 §11.4.6",
        "ASCE 7-16 §11.4.7",
        "ASCE 7-16 Table 18.7-1: ordinates from T_0 on divided by B, zero-period ordinate kept, linear in between (the "
        "code is silent below T_0); not checked against the printed standard",
        SiteTable("ASCE 7-16 Table 11.4-1", _COLUMNS_2016[0], F_A_2016),
        SiteTable("ASCE 7-16 Table 11.4-2", _COLUMNS_2016[1], F_V_2016),
        "ASCE 7-16 §11.4.8",
        STUDIES_2016,
    ),
}


def _edition_of(code: str) -> Edition:
    """Return the edition of that name; SpectrumError lists those known."""
    if code not in EDITIONS:
        raise SpectrumError(f'"{code}" is no edition of ASCE 7 known here; choose one of {", ".join(EDITIONS)}')
    return EDITIONS[code]
