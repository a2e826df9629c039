"""The elastic spectra of the Italian code, NTC 2008 and NTC 2018, and the hazard they start from.

Both editions have the same formulas and tables under other numbers. Those of 2018 (formulas, Tables 2.4.II, 3.2.I and
3.2.IV to 3.2.VII) and the least V_R agree with a public transcription of decree and Circolare. From memory are the
interpolation in return period and its range, the least F_0, and the numbers of clauses and tables in 2008. Nothing was
compared with the printed decrees.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from spectra.errors import SpectrumError
from spectra.gravity import g
from spectra.spectrum import FourBranches, Spectrum, check_positive, plausibility_warnings

LEAST_F_0 = 2.2  # 3.2 [-]
SHORTEST_LIFE = 35.0  # years: least V_R, NTC 2008 2.4.3; under NTC 2018 by Table C2.4.I of Circolare 7/2019
RETURN_PERIODS = (30.0, 2475.0)  # years: the range of the hazard, Annex A
LARGEST_FACTORS: Mapping[str, float] = {"T1": 1.0, "T2": 1.2, "T3": 1.2, "T4": 1.4}  # S_T, Table 3.2.V (2008: 3.2.VI)
EXCEEDANCE: Mapping[str, float] = {"SLO": 0.81, "SLD": 0.63, "SLV": 0.10, "SLC": 0.05}  # P_VR, Table 3.2.I
USE_FACTORS: Mapping[str, float] = {"I": 0.7, "II": 1.0, "III": 1.5, "IV": 2.0}  # C_U, Table 2.4.II
LONG_PERIODS: Mapping[str, float] = {"A": 4.5, "B": 5.0, "C": 6.0, "D": 6.0, "E": 6.0}  # T_E [s]
T_F = 10.0  # s
VERTICAL_CORNERS = (0.05, 0.15, 1.0)  # T_B, T_C, T_D [s]
CLAUSES: Mapping[str, str] = {"ntc2008": "NTC 2008 §3.2.3.2", "ntc2018": "NTC 2018 §3.2.3.2"}
VERTICAL_CLAUSES: Mapping[str, str] = {
    "ntc2008": "NTC 2008 §3.2.3.2 (vertical)",
    "ntc2018": "NTC 2018 §3.2.3.2 (vertical)",
}
DAMPING_RULES: Mapping[str, str] = {
    "ntc2008": "NTC 2008 §3.2.3.2.1: eta = √(10 / (5 + ξ)) ≥ 0.55; not checked against the printed decree",
    "ntc2018": "NTC 2018 §3.2.3.2.1: eta = √(10 / (5 + ξ)) ≥ 0.55; not checked against the printed decree",
}


@dataclass(frozen=True)
class Soil:
    """Coefficients of a subsoil: S_S = constant - slope F_0 a_g / g within [least, most]; C_C = factor T_C*^power."""

    constant: float
    slope: float
    least: float
    most: float
    factor: float
    power: float


SOILS: Mapping[str, Soil] = {  # NTC 2018 Table 3.2.IV (2008: Table 3.2.V)
    "A": Soil(1.00, 0.00, 1.00, 1.00, 1.00, 0.00),
    "B": Soil(1.40, 0.40, 1.00, 1.20, 1.10, -0.20),
    "C": Soil(1.70, 0.60, 1.00, 1.50, 1.05, -0.33),
    "D": Soil(2.40, 1.50, 0.90, 1.80, 1.25, -0.50),
    "E": Soil(2.00, 1.10, 1.00, 1.60, 1.15, -0.40),
}
SPECIAL_ANALYSIS = ("S1", "S2")  # soils that need one


@dataclass(frozen=True)
class Hazard:
    """The hazard on rock at one return period [years], None where it is not known: a_g [m/s2], F_0 [-], T_C* [s]."""

    a_g: float
    f_0: float
    t_c_star: float
    return_period: float | None = None


@dataclass(frozen=True)
class SoilAndTopography:
    """Soil and topography of a site; relief_position: 1 at the top of the relief, 0 at its base, where S_T is 1 [-]."""

    soil: str = "A"
    topography: str = "T1"
    relief_position: float = 1.0


def elastic_spectrum(hazard: Hazard, *, place: SoilAndTopography, code: str = "ntc2018") -> Spectrum:
    """Return the horizontal elastic spectrum.

        S = S_S S_T   T_C = C_C T_C*   T_B = T_C / 3   T_D = 4 a_g / g + 1.6

    The code gives it up to 4 s; beyond, its last branch continues, on the safe side of the code's displacements.

    Parameters
    ----------
    hazard : a_g, F_0 and T_C* on rock
    place : soil and topography
    code : "ntc2008" or "ntc2018"

    Raises
    ------
    SpectrumError : the code, soil or topography is unknown, or a value is outside the clause

    Source: NTC 2018 §3.2.3.2.1, (3.2.2)-(3.2.7), §3.2.3.2.3, (3.2.10)-(3.2.12); NTC 2008 §3.2.3.2.1.
    """
    clause = _check(hazard, place, code)
    S_S, S_T = soil_factor(hazard, place.soil), topographic_factor(place)
    C_C = _period_coefficient(hazard, place.soil)
    T_C, T_D = C_C * hazard.t_c_star, 4.0 * hazard.a_g / g + 1.6
    shape = FourBranches(hazard.a_g * S_S * S_T, hazard.f_0, T_C / 3.0, T_C, T_D)
    return Spectrum(
        code=code,
        parameters={
            **_parameters(hazard, place),
            "s_soil": S_S,
            "s_topography": S_T,
            "s": S_S * S_T,
            "c_c": C_C,
            "t_b": shape.t_b,
            "t_c": T_C,
            "t_d": T_D,
            "t_e": LONG_PERIODS[place.soil],
            "t_f": T_F,
        },
        damping=0.05,
        damping_rule=DAMPING_RULES[code],
        ordinates=shape.ordinates,
        clause=clause,
        displacements=partial(shape.displacements, t_e=LONG_PERIODS[place.soil], t_f=T_F),
        warnings=plausibility_warnings(a_g=hazard.a_g),
    )


def vertical_spectrum(hazard: Hazard, *, place: SoilAndTopography, code: str = "ntc2018") -> Spectrum:
    """Return the vertical elastic spectrum: F_V = 1.35 F_0 (a_g / g)^0.5 on the level branch, S_S = 1 on every soil.

    Parameters
    ----------
    hazard, place, code : as in `elastic_spectrum`

    Source: NTC 2018 §3.2.3.2.2, (3.2.8), (3.2.9).
    """
    _check(hazard, place, code)
    S_T, F_V = topographic_factor(place), 1.35 * hazard.f_0 * (hazard.a_g / g) ** 0.5
    T_B, T_C, T_D = VERTICAL_CORNERS
    shape = FourBranches(hazard.a_g * S_T * F_V / hazard.f_0, hazard.f_0, T_B, T_C, T_D)
    return Spectrum(
        code=code,
        parameters={
            **_parameters(hazard, place),
            "f_vertical": F_V,
            "s_topography": S_T,
            "t_b": T_B,
            "t_c": T_C,
            "t_d": T_D,
        },
        damping=0.05,
        damping_rule=DAMPING_RULES[code],
        ordinates=shape.ordinates,
        clause=VERTICAL_CLAUSES[code],
        warnings=plausibility_warnings(a_g=hazard.a_g),
    )


def soil_factor(hazard: Hazard, soil: str) -> float:
    """Return S_S [-].

    Parameters
    ----------
    hazard : a_g and F_0 on rock
    soil : subsoil category, "A" to "E"

    Source: NTC 2018 Table 3.2.IV (2008: 3.2.V).
    """
    row = SOILS[soil]
    return min(max(row.constant - row.slope * hazard.f_0 * hazard.a_g / g, row.least), row.most)


def topographic_factor(place: SoilAndTopography) -> float:
    """Return S_T [-]: that of the category at the top of the relief, falling to 1 at its base.

    Source: NTC 2018 §3.2.3.2.1, Table 3.2.V (2008: 3.2.VI).
    """
    return 1.0 + place.relief_position * (LARGEST_FACTORS[place.topography] - 1.0)


def reference_life(nominal_life: float, *, use_class: str) -> float:
    """Return V_R = V_N C_U [years], at least 35.

    Parameters
    ----------
    nominal_life : V_N [years]
    use_class : class of use, "I" to "IV"

    Source: NTC 2018 §2.4.3, (2.4.1).
    """
    _check_known("use_class", use_class, USE_FACTORS)
    check_positive("ntc", nominal_life=nominal_life)
    return max(nominal_life * USE_FACTORS[use_class], SHORTEST_LIFE)


def return_period(limit_state: str, *, reference_life: float) -> float:
    """Return T_R = -V_R / ln(1 - P_VR) [years], within the hazard's 30 to 2475.

    Parameters
    ----------
    limit_state : "SLO", "SLD", "SLV" or "SLC"
    reference_life : V_R [years]

    Source: NTC 2018 §3.2.1, (3.2.0).
    """
    _check_known("limit_state", limit_state, EXCEEDANCE)
    T_R = -reference_life / np.log1p(-EXCEEDANCE[limit_state])
    return float(np.clip(T_R, *RETURN_PERIODS))


def hazard_at(table: Sequence[Hazard], *, return_period: float) -> Hazard:
    """Return the hazard at `return_period` [years]: between two rows log p is linear in log T_R, for each of the three.

    Raises SpectrumError for rows without or not rising in return period, and beyond the first and last of them.
    Source: NTC 2008, Annex A, eq. (2).
    """
    years = np.array([np.nan if row.return_period is None else row.return_period for row in table])
    if not (years.size and np.all(years > 0.0) and np.all(np.diff(years) > 0.0)):
        raise SpectrumError("ntc spectrum: hazard: the return periods of its rows do not rise; sort them, each once")
    if not years[0] <= return_period <= years[-1]:
        raise SpectrumError(
            f"ntc spectrum: hazard: the return period asked for, {return_period:.4g} years, is outside its rows, "
            f"{years[0]:.4g} to {years[-1]:.4g} years; add rows (the hazard of the code has 30 to 2475 years)"
        )
    columns = np.array([(row.a_g, row.f_0, row.t_c_star) for row in table])
    if not np.all(np.isfinite(columns) & (columns > 0.0)):
        raise SpectrumError("ntc spectrum: hazard: a_g, f_0 and t_c_star of every row must be positive numbers")
    x, logs = np.log(return_period), np.log(columns)
    a_g, f_0, t_c_star = (float(np.exp(np.interp(x, np.log(years), column))) for column in logs.T)
    return Hazard(a_g, f_0, t_c_star, return_period)


def limit_state_hazard(
    table: Sequence[Hazard], *, limit_state: str, nominal_life: float, use_class: str = "II"
) -> Hazard:
    """Return the hazard of a limit state.

    Parameters
    ----------
    table : hazard of the site over return periods, rising
    limit_state : "SLO", "SLD", "SLV" or "SLC"
    nominal_life : V_N [years]
    use_class : class of use, "I" to "IV"
    """
    life = reference_life(nominal_life, use_class=use_class)
    return hazard_at(table, return_period=return_period(limit_state, reference_life=life))


def _period_coefficient(hazard: Hazard, soil: str) -> float:
    """Return C_C [-]. Source: NTC 2018 Table 3.2.IV (2008: 3.2.V)."""
    return float(SOILS[soil].factor * hazard.t_c_star ** SOILS[soil].power)


def _check(hazard: Hazard, place: SoilAndTopography, code: str) -> str:
    """Return the clause of the `code`, once the values are within it."""
    _check_known("code", code, CLAUSES)
    check_positive(code, a_g=hazard.a_g, f_0=hazard.f_0, t_c_star=hazard.t_c_star)
    if hazard.f_0 < LEAST_F_0:
        raise SpectrumError(f"{code} spectrum: f_0 = {hazard.f_0:.4g}; {CLAUSES[code]} has at least {LEAST_F_0}")
    if place.soil in SPECIAL_ANALYSIS:
        raise SpectrumError(
            f"{code} spectrum: soil = {place.soil}: §3.2.2 asks for a special analysis; give its spectrum with "
            'code = "table"'
        )
    _check_known("soil", place.soil, SOILS)
    _check_known("topography", place.topography, LARGEST_FACTORS)
    if not 0.0 <= place.relief_position <= 1.0:
        raise SpectrumError(
            f"{code} spectrum: relief_position = {place.relief_position}; it is 1 at the top of a relief, 0 at its foot"
        )
    return CLAUSES[code]


def _parameters(hazard: Hazard, place: SoilAndTopography) -> dict[str, float | str]:
    """Return the hazard and the site as used."""
    years = {} if hazard.return_period is None else {"return_period": hazard.return_period}
    return {
        **years,
        "a_g": hazard.a_g,
        "f_0": hazard.f_0,
        "t_c_star": hazard.t_c_star,
        "soil": place.soil,
        "topography": place.topography,
    }


def _check_known(key: str, value: str, known: Mapping[str, object]) -> None:
    """Refuse a value that is not among those known."""
    if value not in known:
        raise SpectrumError(f"ntc spectrum: {key} = {value}; choose one of {', '.join(known)}")
