"""What values of a project file and parameters of design spectra are called, with symbols and dimensions.

Accelerations among the parameters are in g.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from assess.messages.message import Quantity
from reports.language.texts import Phrase, Text, Verbatim, count, say
from spectra.gravity import g

VALUE_TITLES: Mapping[str, Phrase] = {
    "site.spectrum": say("Spectrum of the site"),
    "site.spectrum.damping": say("Damping of the spectrum"),
    "site.pga": say("PGA of the site"),
    "site.return_period": say("Return period of the site’s spectrum"),
    "site.limit_state": say("Limit state of the site’s spectrum"),
    "site.vertical_ratio": say("Vertical over horizontal spectrum"),
    "verdict.survey_tolerance": say("Tolerance of the survey, on thickness and hinges"),
    "verdict.basis": say("Code that decides"),
    "verdict.procedures": say("Methods that may decide"),
    "verdict.works": say("Kind of works"),
    "building.height": say("Height of the building"),
    "building.storeys": say("Number of storeys"),
    "building.ground_elevation": say("Elevation of the ground"),
    "building.period": say("First period of the building"),
    "building.damping": say("Damping of the building"),
    "building.natural_frequency": say("Natural frequency of the building"),
    "building.effective_height": say("Effective height of the building"),
    "building.use_class": say("Class of use"),
    "building.importance_level": say("Importance level of the building"),
    "building.limit_states": say("Period and damping of the building at the limit states"),
    "report.building_type": say("Kind of building"),
    "report.verification": say("Annex of verification"),
    "report.sources": say("Sources of the values"),
    "records": say("Records"),
    "records.files": say("Files of records"),
    "records.synthetic.count": say("Number of artificial records"),
    "records.synthetic.seed": say("Seed of the artificial records"),
    "records.synthetic.duration": say("Duration of the artificial records"),
    "records.scale_to": say("Records scaled to"),
    "mechanisms": say("Definition of the mechanisms"),
    "mechanisms.*": say("Definition of the mechanism"),
    "mechanisms.*.p": say("Frequency parameter p"),
    "mechanisms.*.uplift": say("Multiplier at uplift"),
    "mechanisms.*.radius": say("Radius R"),
    "mechanisms.*.mass": say("Mass, on which no ratio depends"),
    "mechanisms.*.cut": say("Elevation of the crack"),
    "mechanisms.*.cut.angle": say("Angle of the crack"),
    "mechanisms.*.crack": say("Position of the crack"),
    "mechanisms.*.blocks": say("Bodies of the mechanism"),
    "mechanisms.*.wedges": say("Wedges of the side walls"),
    "mechanisms.*.side_walls": say("Bond of the side walls"),
    "mechanisms.*.interfaces": say("Joints"),
    "mechanisms.*.direction": say("Direction of motion"),
    "mechanisms.*.sides": say("Sides to which it rocks"),
    "mechanisms.*.elevation": say("Elevation of the base"),
    "mechanisms.*.base_elevation": say("Elevation of the base above the ground"),
    "mechanisms.*.hinges": say("Hinges"),
    "mechanisms.*.loads": say("Loads"),
    "mechanisms.*.restitution": say("Coefficient of restitution"),
    "mechanisms.*.restitution.positive": say("Coefficient of restitution, positive rotation"),
    "mechanisms.*.restitution.negative": say("Coefficient of restitution, negative rotation"),
    "mechanisms.*.disintegration": say("Disintegration of the masonry"),
    "mechanisms.*.interface": say("Joints"),
    "mechanisms.*.interface.model": say("Model of the joints"),
    "mechanisms.*.interface.stiffness": say("Stiffness of the joints"),
    "mechanisms.*.interface.strength": say("Strength of the joints"),
    "mechanisms.*.interface.shape": say("Shape of the joints"),
    "mechanisms.*.interface.course_thickness": say("Height of a course"),
    "mechanisms.*.amplification": say("Motion at the base of the mechanism"),
    "mechanisms.*.amplification.method": say("Motion at the base of the mechanism, method"),
    "mechanisms.*.amplification.height": say("Motion at the base of the mechanism, height"),
    "mechanisms.*.amplification.natural_frequency": say("Motion at the base of the mechanism, natural frequency"),
    "mechanisms.*.amplification.effective_height": say("Motion at the base of the mechanism, effective height"),
    "analysis.equation": say("Equation of motion"),
}
"""By key, with * for the name of a mechanism."""

MATERIAL_TITLES: Mapping[str, Phrase] = {
    "": say("{material}: all properties"),
    "density": say("{material}: density"),
    "young_modulus": say("{material}: Young’s modulus"),
    "compressive_strength": say("{material}: compressive strength"),
    "tensile_strength": say("{material}: tensile strength"),
    "friction": say("{material}: friction"),
    "disintegration": say("{material}: disintegration"),
}

CODE_OPTION_TITLES: Mapping[str, Phrase] = {
    "floor_vertical_ratio": say("Vertical over horizontal motion of the floor"),
    "floor_spectrum": say("Floor spectrum"),
    "allowable_sliding": say("Allowable sliding displacement"),
    "knowledge_level": say("Knowledge level"),
    "confidence_factor": say("Confidence factor"),
    "position": say("Position of the wall"),
    "masonry": say("Kind of masonry"),
    "seismicity": say("Level of seismicity"),
}


def value_title(key: str) -> Text | None:
    """Return the words for a key of the project file, * for the name of a mechanism; None where there are none."""
    table, _, rest = key.partition(".")
    if table == "materials" and rest:
        known = [last for last in MATERIAL_TITLES if last and rest.endswith(f".{last}")]
        last = known[0] if known else ""
        phrase, name = MATERIAL_TITLES[last], rest.removesuffix(f".{last}") if last else rest
        return Phrase(phrase.english, {"material": Verbatim(name)})
    if table == "procedures":
        return CODE_OPTION_TITLES.get(key.rpartition(".")[2])
    return VALUE_TITLES.get(key)


_OWNER = re.compile(r"^mechanisms\.(?:\"[^\"]*\"|[^.\[]+)")
LOAD_KEY = re.compile(r"mechanisms\.\*\.loads\[(\d+)\](?:\.(\w+))?")
LOAD_TITLES: Mapping[str, Phrase] = {
    "force": say("force"),
    "mass": say("mass"),
    "share": say("share of the weight"),
    "thrust": say("thrust"),
    "eccentricity": say("eccentricity"),
    "at": say("position"),
    "tied": say("connection"),
    "bearing": say("bearing"),
    "until": say("duration"),
    "seat": say("seat"),
    "strength": say("strength"),
    "length": say("length"),
    "fracture_strain": say("strain at fracture"),
    "area": say("area of the section"),
    "young_modulus": say("modulus of elasticity"),
    "yield_stress": say("yield stress"),
    "psi_2": say("combination factor"),
}
"""What the values of a load are called, by the key of each."""


def key_words(key: str) -> Text:
    """Return the words for a key of the project file; where it has none, those of which its last part is made.

    key : with the name of its mechanism, or * in its place
    """
    starred = _OWNER.sub("mechanisms.*", key)
    item = LOAD_KEY.fullmatch(starred)
    if item:
        load = say("load {number}", number=count(int(item[1])))
        return say("{quantity} of {load}", quantity=LOAD_TITLES[item[2]], load=load) if item[2] in LOAD_TITLES else load
    last = re.split(r"[.\[]", starred)[-1].removesuffix("]")
    return value_title(starred) or Verbatim(last.replace("_", " ").replace("-", " "))


VALUE_WORDS: Mapping[str, Phrase] = {
    "none": say("none"),
    "rigid": say("rigid"),
    "flexible": say("flexible"),
    "semi-flexible": say("semi-flexible"),
    "spectrum": say("the spectrum"),
    "pga": say("the PGA"),
    "excluded": say("excluded"),
    "exact": say("exact"),
    "linearised": say("linearised"),
    "modal-filter": say("filtered by the first mode"),
    "low": say("low"),
    "moderate": say("moderate"),
    "high": say("high"),
    "one": say("one"),
    "two": say("two"),
    "true": say("yes"),
    "false": say("no"),
}
"""Words among which a project file chooses."""


def value_word(text: Verbatim) -> Text:
    """Return a value in words, where it is one of those among which a project file chooses."""
    return VALUE_WORDS.get(text.text, text)


ACCELERATION = "ground acceleration"
_FIGURES = 5

PARAMETER_NAMES: Mapping[str, tuple[Phrase, str]] = {
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
    "pga_m": (say("PGA_M, geometric mean, for liquefaction"), ACCELERATION),
    "s_x1": (say("S_X1, at 1 s, of the hazard chosen"), ACCELERATION),
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
    # TS 1170.5
    "location": (say("place in the table"), ""),
    "s_as": (say("S_a,s, the level branch"), ACCELERATION),
    # any
    "scale": (say("ordinates scaled by"), ""),
    # tables
    "points": (say("points of the table"), ""),
    "period_max": (say("longest period of the table"), "time"),
    "pga": (say("ordinate at zero period"), ACCELERATION),
}

PARAMETER_WORDS: Mapping[str, Phrase] = {"none": say("none"), "design": say("design"), "mce": say("maximum considered")}
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
    name, dimension = PARAMETER_NAMES.get(key, (Verbatim(key), ""))
    if isinstance(value, str):
        return name, PARAMETER_WORDS.get(value, Verbatim(value))
    return name, Quantity(value / g if dimension == ACCELERATION else float(value), dimension or "ratio", _FIGURES)
