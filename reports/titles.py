"""What mechanisms and procedures are called in the report."""

from __future__ import annotations

import re
from collections.abc import Mapping

from assess.codes.check import Check
from assess.results import MechanismResult, Results
from reports.language.texts import Phrase, Text, Verbatim, say

PROCEDURES: Mapping[str, Phrase] = {
    "asce43-05-spectrum": say("ASCE 43-05, approximate method"),
    "asce43-05-spectrum-thesis": say("ASCE 43-05, approximate method, thesis reading"),
    "asce43-05-history": say("ASCE 43-05, response history"),
    "dmi2008-linear": say("DMI 2008, linear"),
    "dmi2008-nonlinear": say("DMI 2008, capacity spectrum"),
    "dmi2008-nonlinear-thesis": say("DMI 2008, capacity spectrum, thesis reading"),
    "dmi2008-history": say("DMI 2008, response history"),
    "ntc2018-linear": say("NTC 2018, linear kinematic"),
    "ntc2018-nonlinear": say("NTC 2018, non-linear kinematic"),
    "ntc2018-history": say("NTC 2018, response history"),
    "nzsee2017-face-loaded": say("NZSEE 2017, face-loaded wall"),
    "asce41-13-ht": say("ASCE 41-13, slenderness"),
    "ec8-element": say("Eurocode 8, non-structural element"),
    "sliding": say("Sliding, equilibrium"),
    "asce43-05-sliding": say("ASCE 43-05, sliding"),
}
"""Titles of the procedures, in place of the names by which a project file calls them."""

SHORT: Mapping[str, Phrase] = {
    "asce43-05-spectrum": say("ASCE 43-05 approximate"),
    "asce43-05-spectrum-thesis": say("ASCE 43-05 appr., thesis"),
    "asce43-05-history": say("ASCE 43-05 history"),
    "dmi2008-linear": say("DMI 2008 linear"),
    "dmi2008-nonlinear": say("DMI 2008 spectrum"),
    "dmi2008-nonlinear-thesis": say("DMI 2008 sp., thesis"),
    "dmi2008-history": say("DMI 2008 history"),
    "ntc2018-linear": say("NTC 2018 linear"),
    "ntc2018-nonlinear": say("NTC 2018 non-linear"),
    "ntc2018-history": say("NTC 2018 history"),
    "nzsee2017-face-loaded": say("NZSEE 2017"),
    "asce41-13-ht": say("ASCE 41-13"),
    "ec8-element": say("Eurocode 8"),
    "sliding": say("Sliding"),
    "asce43-05-sliding": say("ASCE 43-05 sliding"),
}
"""Shorter titles, for legends and narrow columns."""


def mechanism_title(mechanism: MechanismResult) -> str:
    """Return the mechanism's label, or its name where it has none."""
    return mechanism.label or mechanism.name


def mechanism_number(results: Results, name: str) -> str:
    """Return the number of a mechanism by its name: "M1" for the first of the results."""
    place = next(place for place, each in enumerate(results.mechanisms, start=1) if each.name == name)
    return f"M{place}"


def numbered_title(results: Results, name: str) -> Verbatim:
    """Return number and title of a mechanism by its name: "M1 Wall 6"."""
    found = next(each for each in results.mechanisms if each.name == name)
    return Verbatim(f"{mechanism_number(results, name)} {mechanism_title(found)}")


def procedure_title(procedure: str) -> Text:
    """Return the title of a procedure; the name itself of one that is not in the table."""
    return PROCEDURES.get(procedure, Verbatim(procedure))


def short_title(procedure: str) -> Text:
    """Return the short title of a procedure; the name itself of one that is not in the table."""
    return SHORT.get(procedure, Verbatim(procedure))


def check_title(check: Check, among: tuple[Check, ...]) -> Text:
    """Return the title of a check's procedure, with its limit state where `among` has several of the same procedure."""
    return _with_state(procedure_title(check.procedure), check, among)


def short_check_title(check: Check, among: tuple[Check, ...]) -> Text:
    """Return the short title of a check's procedure, with its limit state as `check_title` has it."""
    return _with_state(short_title(check.procedure), check, among)


def _with_state(title: Text, check: Check, among: tuple[Check, ...]) -> Text:
    states = {other.limit_state for other in among if other.procedure == check.procedure}
    if len(states) < 2:
        return title
    return say("{procedure}, {limit_state}", procedure=title, limit_state=Verbatim(check.limit_state))


def file_stem(name: str, place: int) -> str:
    """Return a unique and safe beginning for the file names of a mechanism: its place and its name in plain letters."""
    plain = re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")[:40].strip("-")
    return f"{place:02d}-{plain}" if plain else f"{place:02d}"
