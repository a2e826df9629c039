"""What the parameters of design spectra are called, with their symbols and units; accelerations in g."""

from __future__ import annotations

from collections.abc import Mapping

from scipy.constants import g

ACCELERATION = "g"

NAMES: Mapping[str, tuple[str, str]] = {
    # ASCE 7
    "s_s": ("S_S, mapped, at short periods", ACCELERATION),
    "s_1": ("S_1, mapped, at 1 s", ACCELERATION),
    "site_class": ("site class", "-"),
    "f_a": ("F_a, site coefficient, short periods", "-"),
    "f_v": ("F_v, site coefficient, 1 s", "-"),
    "s_ms": ("S_MS, MCE on the site, short periods", ACCELERATION),
    "s_m1": ("S_M1, MCE on the site, 1 s", ACCELERATION),
    "s_ds": ("S_DS, design, at short periods", ACCELERATION),
    "s_d1": ("S_D1, design, at 1 s", ACCELERATION),
    "t_l": ("T_L, long-period transition", "s"),
    "t_0": ("T_0, start of the level branch", "s"),
    "t_s": ("T_S, end of the level branch", "s"),
    "hazard": ("hazard", "-"),
    # EN 1998-1 and NTC
    "a_g": ("a_g, peak ground acceleration on rock", ACCELERATION),
    "importance_factor": ("γ_I, importance factor", "-"),
    "design_a_g": ("γ_I a_gR, design ground acceleration", ACCELERATION),
    "a_vg": ("a_vg, vertical ground acceleration", ACCELERATION),
    "ground_type": ("ground type", "-"),
    "type": ("type of spectrum", "-"),
    "s": ("S, soil factor", "-"),
    "t_b": ("T_B, start of the level branch", "s"),
    "t_c": ("T_C, end of the level branch", "s"),
    "t_d": ("T_D, displacement constant from here", "s"),
    "t_e": ("T_E, displacement constant to here", "s"),
    "t_f": ("T_F, ground displacement from here", "s"),
    # NTC
    "limit_state": ("limit state", "-"),
    "nominal_life": ("V_N, nominal life", "years"),
    "use_class": ("class of use", "-"),
    "use_coefficient": ("C_U, coefficient of use", "-"),
    "reference_life": ("V_R, reference life", "years"),
    "return_period": ("T_R, return period", "years"),
    "f_0": ("F_0, largest amplification on rock", "-"),
    "t_c_star": ("T_C*, end of the level branch on rock", "s"),
    "soil": ("subsoil category", "-"),
    "topography": ("topographic category", "-"),
    "s_soil": ("S_S, soil factor", "-"),
    "s_topography": ("S_T, topographic factor", "-"),
    "c_c": ("C_C, coefficient of T_C*", "-"),
    "f_vertical": ("F_V, largest vertical amplification", "-"),
    # NZS 1170.5
    "subsoil": ("site subsoil class", "-"),
    "z": ("Z, hazard factor", "-"),
    "r": ("R, return period factor", "-"),
    "zr": ("Z R as used", "-"),
    "near_fault_distance": ("D, to the nearest major fault", "m"),
    "c_0": ("C(0), spectrum at zero period", "-"),
    "vertical_ratio": ("vertical over horizontal", "-"),
    # any
    "scale": ("ordinates scaled by", "-"),
    # tables
    "points": ("points of the table", "-"),
    "period_max": ("longest period of the table", "s"),
    "pga": ("ordinate at zero period", ACCELERATION),
}
CORNERS = ("t_0", "t_s", "t_b", "t_c", "t_d", "t_l")  # the parameters that are corner periods of the curve


def corners(parameters: Mapping[str, float | str]) -> tuple[float, ...]:
    """Return the corner periods [s] among the parameters."""
    found = (parameters.get(name) for name in CORNERS)
    return tuple(period for period in found if isinstance(period, float))


def parameter_rows(parameters: Mapping[str, float | str]) -> tuple[tuple[str, str, float | str], ...]:
    """Return name, unit and value of each parameter; one that is not known here keeps its name."""
    return tuple(_parameter_row(*NAMES.get(key, (key, "-")), value) for key, value in parameters.items())


def _parameter_row(name: str, unit: str, value: float | str) -> tuple[str, str, float | str]:
    """Return a parameter in the unit that it is shown in: results hold accelerations in m/s2."""
    return name, unit, value / g if unit == ACCELERATION and not isinstance(value, str) else value
