"""What the varied inputs of a sensitivity are called, and their values and answers as texts."""

from __future__ import annotations

import re
from collections.abc import Mapping
from math import inf

from assess.results import SensitivityResult
from reports.chapters.cells import OVERTURNED
from reports.chapters.index_text import symbol
from reports.chapters.sensitivity_ranking import Case, answer_value
from reports.language.texts import Phrase, Term, Text, Verbatim, quantity, say

FIGURES = 3
WORDS: Mapping[str, Phrase] = {
    "thickness": say("thickness"),
    "density": say("density"),
    "compressive_strength": say("compressive strength"),
    "stiffness": say("stiffness"),
    "friction": say("friction"),
    "restitution": say("restitution"),
    "tie_force": say("force of the tie"),
    "loads": say("load"),
    "uplift": say("uplift multiplier"),
    "p": say("frequency parameter"),
}
DIMENSIONS: Mapping[str, str] = {
    "m": "length",
    "kg": "mass",
    "N": "force",
    "Pa": "stress",
    "Pa/m": "stiffness",
    "kg/m^3": "density",
    "1/s": "angular frequency",
}
"""The dimensions of the units of varied inputs."""


def input_name(row: SensitivityResult) -> Text:
    """Return the name of an input: the parameter, and of what as far as its key tells."""
    word = WORDS.get(row.parameter, Term(row.parameter))
    if row.key.startswith("materials."):
        material = row.key.removeprefix("materials.").rpartition(".")[0]
        return say("{parameter} of {material}", parameter=word, material=Verbatim(material))
    own = row.key.removeprefix(f"mechanisms.{row.mechanism}.")
    entry, joint = re.match(r"loads\[(\d+)\]", own), re.match(r"interfaces\.([A-D])\.", own)
    if entry:
        return say("{parameter} {number}", parameter=word, number=quantity(int(entry[1])))
    return say("{parameter}, joint {joint}", parameter=word, joint=Verbatim(joint[1])) if joint else word


def value_text(row: SensitivityResult, value: float | None) -> Text:
    """Return a value of an input with its unit."""
    if value is None:
        return say("not known")
    return quantity(value, DIMENSIONS.get(row.unit, "ratio"))


def range_text(row: SensitivityResult) -> Text:
    """Return the low and the high value of an input."""
    return say("{low} to {high}", low=value_text(row, row.low), high=value_text(row, row.high))


def answer_name(row: SensitivityResult) -> Text:
    """Return the name of an answer."""
    if row.quantity == "index":
        return say("index {name}", name=symbol(row.index))
    if row.quantity == "capacity_pga_g":
        return say("PGA at capacity")
    return say("D/C at {pga}", pga=quantity(row.level_pga_g or 0.0, "ground acceleration", FIGURES))


def answer_text(row: SensitivityResult, at: Case) -> Text:
    """Return an answer in a case, with its unit."""
    found = answer_value(row, at)
    if found is None:
        return say("not known")
    if found == inf:
        return OVERTURNED
    dimension = "ground acceleration" if row.quantity == "capacity_pga_g" else "ratio"
    return quantity(found, dimension, FIGURES)
