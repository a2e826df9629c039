"""What the parameters of design spectra are called, with their symbols and dimensions; accelerations in g."""

from __future__ import annotations

from collections.abc import Mapping

from scipy.constants import g

from assess.messages.message import Quantity
from reports.language.texts import Phrase, Text, Verbatim, say

ACCELERATION = "ground acceleration"
_FIGURES = 5

NAMES: Mapping[str, tuple[Phrase, str]] = {
    # ASCE 7
    "s_s": (say("S_S, mapped, at short periods"), ACCELERATION),
    "s_1": (say("S_1, mapped, at 1 s"), ACCELERATION),
    "site_class": (say("site class"), ""),
    "f_a": (say("F_a, site coefficient, short periods"), ""),
    "f_v": (say("F_v, site coefficient, 1 s"), ""),
    "s_ms": (say("S_MS, MCE on the site, short periods"), ACCELERATION),
    "s_m1": (say("S_M1, MCE on the site, 1 s"), ACCELERATION),
    "s_ds": (say("S_DS, design, at short periods"), ACCELERATION),
    "s_d1": (say("S_D1, design, at 1 s"), ACCELERATION),
    "t_l": (say("T_L, long-period transition"), "time"),
    "t_0": (say("T_0, start of the level branch"), "time"),
    "t_s": (say("T_S, end of the level branch"), "time"),
    "hazard": (say("hazard"), ""),
    # EN 1998-1 and NTC
    "a_g": (say("a_g, PGA on rock"), ACCELERATION),
    "importance_factor": (say("γ_I, importance factor"), ""),
    "design_a_g": (say("γ_I a_gR, design ground acceleration"), ACCELERATION),
    "a_vg": (say("a_vg, vertical ground acceleration"), ACCELERATION),
    "ground_type": (say("ground type"), ""),
    "type": (say("type of spectrum"), ""),
    "s": (say("S, soil factor"), ""),
    "t_b": (say("T_B, start of the level branch"), "time"),
    "t_c": (say("T_C, end of the level branch"), "time"),
    "t_d": (say("T_D, corner period"), "time"),
    "t_e": (say("T_E, corner period"), "time"),
    "t_f": (say("T_F, corner period"), "time"),
    # NTC
    "limit_state": (say("limit state"), ""),
    "nominal_life": (say("V_N, nominal life"), "return period"),
    "use_class": (say("class of use"), ""),
    "use_coefficient": (say("C_U, coefficient of use"), ""),
    "reference_life": (say("V_R, reference life"), "return period"),
    "return_period": (say("T_R, return period"), "return period"),
    "f_0": (say("F_0, largest amplification on rock"), ""),
    "t_c_star": (say("T_C*, T_C on rock"), "time"),
    "soil": (say("subsoil category"), ""),
    "topography": (say("topographic category"), ""),
    "s_soil": (say("S_S, soil factor"), ""),
    "s_topography": (say("S_T, topographic factor"), ""),
    "c_c": (say("C_C, coefficient of T_C*"), ""),
    "f_vertical": (say("F_V, largest vertical amplification"), ""),
    # NZS 1170.5
    "subsoil": (say("site subsoil class"), ""),
    "z": (say("Z, hazard factor"), ""),
    "r": (say("R, return period factor"), ""),
    "zr": (say("Z R as used"), ""),
    "near_fault_distance": (say("D, to the nearest major fault"), "length"),
    "c_0": (say("C(0), spectrum at zero period"), ""),
    "vertical_ratio": (say("vertical over horizontal"), ""),
    # any
    "scale": (say("ordinates scaled by"), ""),
    # tables
    "points": (say("points of the table"), ""),
    "period_max": (say("longest period of the table"), "time"),
    "pga": (say("ordinate at zero period"), ACCELERATION),
}
WORDS: Mapping[str, Phrase] = {"none": say("none"), "design": say("design"), "mce": say("maximum considered")}
"""Values of parameters that are words."""
CORNERS = ("t_0", "t_s", "t_b", "t_c", "t_d", "t_l")  # the parameters that are corner periods of the curve


def corners(parameters: Mapping[str, float | str]) -> tuple[float, ...]:
    """Return the corner periods [s] among the parameters."""
    found = (parameters.get(name) for name in CORNERS)
    return tuple(period for period in found if isinstance(period, float))


def parameter_rows(parameters: Mapping[str, float | str]) -> tuple[tuple[Text, Quantity | Verbatim | Phrase], ...]:
    """Return name and value of each parameter; one that is not known here keeps its name."""
    return tuple(_parameter_row(key, value) for key, value in parameters.items())


def _parameter_row(key: str, value: float | str) -> tuple[Text, Quantity | Verbatim | Phrase]:
    """Return a parameter as it is shown: results hold accelerations in m/s2."""
    name, dimension = NAMES.get(key, (Verbatim(key), ""))
    if isinstance(value, str):
        return name, WORDS.get(value, Verbatim(value))
    return name, Quantity(value / g if dimension == ACCELERATION else float(value), dimension or "ratio", _FIGURES)
