"""What the parameters of design spectra are called, with their symbols and dimensions."""

from __future__ import annotations

from collections.abc import Mapping

from scipy.constants import g

from reports.language.texts import Phrase, Text, Verbatim, quantity, say

ACCELERATION, NONE = "ground acceleration", "ratio"

NAMES: Mapping[str, tuple[Phrase, str]] = {
    # ASCE 7
    "s_s": (say("S_S, mapped, at short periods"), ACCELERATION),
    "s_1": (say("S_1, mapped, at 1 s"), ACCELERATION),
    "site_class": (say("Site class"), NONE),
    "f_a": (say("F_a, site coefficient, short periods"), NONE),
    "f_v": (say("F_v, site coefficient, 1 s"), NONE),
    "s_ms": (say("S_MS, MCE on the site, short periods"), ACCELERATION),
    "s_m1": (say("S_M1, MCE on the site, 1 s"), ACCELERATION),
    "s_ds": (say("S_DS, design, at short periods"), ACCELERATION),
    "s_d1": (say("S_D1, design, at 1 s"), ACCELERATION),
    "t_l": (say("T_L, long-period transition"), "time"),
    "t_0": (say("T_0, start of the level branch"), "time"),
    "t_s": (say("T_S, end of the level branch"), "time"),
    "hazard": (say("Hazard"), NONE),
    # EN 1998-1 and NTC
    "a_g": (say("a_g, peak ground acceleration on rock"), ACCELERATION),
    "importance_factor": (say("γ_I, importance factor"), NONE),
    "design_a_g": (say("γ_I a_gR, design ground acceleration"), ACCELERATION),
    "a_vg": (say("a_vg, vertical ground acceleration"), ACCELERATION),
    "ground_type": (say("Ground type"), NONE),
    "type": (say("Type of spectrum"), NONE),
    "s": (say("S, soil factor"), NONE),
    "t_b": (say("T_B, start of the level branch"), "time"),
    "t_c": (say("T_C, end of the level branch"), "time"),
    "t_d": (say("T_D, displacement constant from here"), "time"),
    "t_e": (say("T_E, displacement constant to here"), "time"),
    "t_f": (say("T_F, ground displacement from here"), "time"),
    # NTC
    "limit_state": (say("Limit state"), NONE),
    "nominal_life": (say("V_N, nominal life"), "return period"),
    "use_class": (say("Class of use"), NONE),
    "use_coefficient": (say("C_U, coefficient of use"), NONE),
    "reference_life": (say("V_R, reference life"), "return period"),
    "return_period": (say("T_R, return period"), "return period"),
    "f_0": (say("F_0, largest amplification on rock"), NONE),
    "t_c_star": (say("T_C*, end of the level branch on rock"), "time"),
    "soil": (say("Subsoil category"), NONE),
    "topography": (say("Topographic category"), NONE),
    "s_soil": (say("S_S, soil factor"), NONE),
    "s_topography": (say("S_T, topographic factor"), NONE),
    "c_c": (say("C_C, coefficient of T_C*"), NONE),
    "f_vertical": (say("F_V, largest vertical amplification"), NONE),
    # NZS 1170.5
    "subsoil": (say("Site subsoil class"), NONE),
    "z": (say("Z, hazard factor"), NONE),
    "r": (say("R, return period factor"), NONE),
    "zr": (say("Z R as used"), NONE),
    "near_fault_distance": (say("D, to the nearest major fault"), "length"),
    "c_0": (say("C(0), spectrum at zero period"), NONE),
    "vertical_ratio": (say("Vertical over horizontal"), NONE),
    # any
    "scale": (say("Ordinates scaled by"), NONE),
    # tables
    "points": (say("Points of the table"), NONE),
    "period_max": (say("Longest period of the table"), "time"),
    "pga": (say("Ordinate at zero period"), ACCELERATION),
}
CORNERS = ("t_0", "t_s", "t_b", "t_c", "t_d", "t_l")  # the parameters that are corner periods of the curve


def corners(parameters: Mapping[str, float | str]) -> tuple[float, ...]:
    """Return the corner periods [s] among the parameters."""
    found = (parameters.get(name) for name in CORNERS)
    return tuple(period for period in found if isinstance(period, float))


def parameter_rows(parameters: Mapping[str, float | str]) -> tuple[tuple[str, Text, Text], ...]:
    """Return key, name and value of each parameter; one that is not known here is called by its key."""
    named = ((key, *NAMES.get(key, (Verbatim(key), NONE)), value) for key, value in parameters.items())
    return tuple((key, name, _value(value, dimension)) for key, name, dimension, value in named)


def _value(value: float | str, dimension: str) -> Text:
    """Return a value with its dimension: results hold accelerations in m/s2."""
    if isinstance(value, str):
        return Verbatim(value)
    return quantity(value / g if dimension == ACCELERATION else value, dimension)
