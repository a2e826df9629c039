"""What the values of a project file are called in words, where an assessment depends on them."""

from __future__ import annotations

from collections.abc import Mapping

from reports.language.texts import Phrase, Text, Verbatim, say

TITLES: Mapping[str, Phrase] = {
    "site.spectrum": say("Spectrum of the site"),
    "site.spectrum.damping": say("Damping of the spectrum"),
    "site.pga": say("PGA of the site"),
    "site.limit_state": say("Limit state of the site’s spectrum"),
    "site.vertical_ratio": say("Vertical over horizontal spectrum"),
    "verdict.survey_tolerance": say("Tolerance of the survey, on thickness and hinges"),
    "verdict.works": say("Kind of works"),
    "building.height": say("Height of the building"),
    "building.storeys": say("Number of storeys"),
    "building.ground_elevation": say("Elevation of the ground"),
    "building.period": say("First period of the building"),
    "building.damping": say("Damping of the building"),
    "building.natural_frequency": say("Natural frequency of the building"),
    "building.effective_height": say("Effective height of the building"),
    "building.use_class": say("Class of use"),
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
    "mechanisms.*.crack": say("Position of the crack"),
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
OF_MATERIAL: Mapping[str, Phrase] = {
    "": say("{material}: all properties"),
    "density": say("{material}: density"),
    "young_modulus": say("{material}: Young’s modulus"),
    "compressive_strength": say("{material}: compressive strength"),
    "tensile_strength": say("{material}: tensile strength"),
    "friction": say("{material}: friction"),
    "disintegration": say("{material}: disintegration"),
}
OF_CODE: Mapping[str, Phrase] = {
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
        known = [last for last in OF_MATERIAL if last and rest.endswith(f".{last}")]
        last = known[0] if known else ""
        phrase, name = OF_MATERIAL[last], rest.removesuffix(f".{last}") if last else rest
        return Phrase(phrase.english, {"material": Verbatim(name)})
    if table == "procedures":
        return OF_CODE.get(key.rpartition(".")[2])
    return TITLES.get(key)


WORDS: Mapping[str, Phrase] = {
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
}
"""Words among which a project file chooses."""


def value_word(text: Verbatim) -> Text:
    """Return a value in words, where it is one of those among which a project file chooses."""
    return WORDS.get(text.text, text)
