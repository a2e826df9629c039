"""What mechanisms and procedures are called in the report, and what the results say of a mechanism's joints."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from assess.codes.check import Check
from assess.codes.procedures import PROCEDURES
from assess.results import BranchName, HistoryResult, MechanismResult, Results
from assess.results.run import FallingMechanism
from reports.language.texts import Phrase, Text, Verbatim, listing, say


def mechanism_title(mechanism: MechanismResult | FallingMechanism) -> str:
    """Return the mechanism's label, or its name where it has none."""
    return mechanism.label or mechanism.name


def mechanism_number(results: Results, name: str) -> str:
    """Return the number of a mechanism by its name: "M1" for the first; those that fall at rest come last."""
    place = next(place for place, each in enumerate(_every_mechanism(results), start=1) if each.name == name)
    return f"M{place}"


def numbered_title(results: Results, name: str) -> Verbatim:
    """Return number and title of a mechanism by its name: "M1 Wall 6"."""
    found = next(each for each in _every_mechanism(results) if each.name == name)
    return Verbatim(f"{mechanism_number(results, name)} {mechanism_title(found)}")


def title_in_either_state(results: Results, name: str) -> Verbatim:
    """Return number and title of a mechanism; of one of the state before the works alone its title."""
    if any(each.name == name for each in _every_mechanism(results)):
        return numbered_title(results, name)
    found = None if results.before is None else results.before.of(name)
    return Verbatim(found.label if found is not None and found.label else name)


def tie_number(place: int) -> str:
    """Return the number of a tie of the building by its place from 1: "T1"."""
    return f"T{place}"


def _every_mechanism(results: Results) -> tuple[MechanismResult | FallingMechanism, ...]:
    return (*results.mechanisms, *results.falling)


def procedure_title(procedure: str) -> Text:
    """Return the title of a procedure; the name itself of one that is not known."""
    return PROCEDURES[procedure].title if procedure in PROCEDURES else Verbatim(procedure)


def short_title(procedure: str) -> Text:
    """Return the short title of a procedure; the name itself of one that is not known."""
    return PROCEDURES[procedure].short_title if procedure in PROCEDURES else Verbatim(procedure)


def check_title(check: Check, among: tuple[Check, ...]) -> Text:
    """Return the title of a check's procedure, with its limit state where `among` has several of the same procedure."""
    return _with_state(procedure_title(check.procedure), check, among)


def short_check_title(check: Check, among: tuple[Check, ...]) -> Text:
    """Return the short title of a check's procedure, with its limit state as `check_title` has it."""
    return _with_state(short_title(check.procedure), check, among)


def file_stem(name: str, place: int) -> str:
    """Return a unique and safe beginning for the file names of a mechanism: its place and its name in plain letters."""
    plain = re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")[:40].strip("-")
    return f"{place:02d}-{plain}" if plain else f"{place:02d}"


SHORTEST_RANGE = 3  # numbers in a row that become a range


def mechanism_list(results: Results, names: Iterable[str]) -> Text:
    """Return mechanisms, by their names, as numbers in order, rows of them as ranges; all of several as such."""
    listed = set(names)
    places = [place for place, each in enumerate(results.mechanisms) if each.name in listed]
    if len(places) == len(results.mechanisms) > 1:
        return say("all mechanisms")
    numbers = [mechanism_number(results, results.mechanisms[place].name) for place in places]
    return listing(text for run in _neighbours(places, numbers) for text in _range_texts(run))


JOINT_MODELS: Mapping[str, Phrase] = {
    "rigid": say("rigid"),
    "rigid with crushing": say("rigid, with crushing"),
    "flexible": say("flexible"),
    "flexible-thesis": say("flexible, by Mehrotra"),
    "semi-flexible": say("semi-flexible"),
}


def deformable_joints(mechanism: MechanismResult) -> list[dict[str, Any]]:
    """Return the joints of both branches that open or crush; none where all are rigid."""
    return [interface for interface in mechanism.interfaces if interface["curve"] is not None]


def joints_of_branch(mechanism: MechanismResult, branch: BranchName) -> list[dict[str, Any]]:
    """Return the joints of one branch that open or crush: the hinges of the positive branch come first."""
    first = len(mechanism.drawing.displaced.hinges)
    part = mechanism.interfaces[first:] if branch == "negative" else mechanism.interfaces[:first]
    return [interface for interface in part if interface["curve"] is not None]


def model_names(mechanism: MechanismResult) -> tuple[str, ...]:
    """Return the models of its joints, each once: "rigid with crushing" where rigid ones crush, else "rigid" alone."""
    models = dict.fromkeys(interface["model"] for interface in deformable_joints(mechanism))
    return tuple("rigid with crushing" if each == "rigid" else each for each in models) or ("rigid",)


def peak_rotation(mechanism: MechanismResult, history: HistoryResult) -> float:
    """Return the largest rotation of a history [rad], counted from upright as in the curves of the joints.

    The history itself counts from rest, which under an eccentric load is not upright.
    """
    side = mechanism.oscillator if history.branch == "positive" else mechanism.oscillator_negative
    rest = 0.0 if side is None else side.equilibrium_rad
    return max(0.0, abs(history.max_rotation_rad or 0.0) + rest)


def event_rotation(interface: dict[str, Any], key: str) -> float | None:
    """Return the rotation of the mechanism [rad] at which a joint opens ("opening_rad") or crushes ("crushing_rad").

    None where it never does, where it does from the start, and where that is beyond its curve.
    """
    own, of_mechanism = (interface["curve"][name] for name in ("rotation_rad", "mechanism_rotation_rad"))
    at = interface[key]
    return None if not at or at > own[-1] else float(np.interp(at, own, of_mechanism))


def values_at(interface: dict[str, Any], rotation: float) -> tuple[float, float, float, float]:
    """Return peak stress [Pa], resultant [m], open and crushed share [-] of a joint at a rotation [rad]."""
    curve = interface["curve"]
    keys = ("peak_stress_pa", "resultant_m", "open_share", "crushed_share")
    stress, resultant, opened, crushed = (
        float(np.interp(rotation, curve["mechanism_rotation_rad"], curve[key])) for key in keys
    )
    return stress, resultant, opened, crushed


JOINT_KEYS = ("label", "interface", "interfaces")
"""Keys in which variants may differ."""


def group_variants(results: Results) -> list[tuple[MechanismResult, ...]]:
    """Return every mechanism, those that differ by their joints alone together: rigid first, in the project's order."""
    found: dict[frozenset[tuple[str, str]], list[MechanismResult]] = {}
    for mechanism in results.mechanisms:
        found.setdefault(_definition_without_joints(results, mechanism), []).append(mechanism)
    return [tuple(sorted(group, key=lambda each: bool(deformable_joints(each)))) for group in found.values()]


def _with_state(title: Text, check: Check, among: tuple[Check, ...]) -> Text:
    states = {other.limit_state for other in among if other.procedure == check.procedure}
    if len(states) < 2:
        return title
    return say("{procedure}, {limit_state}", procedure=title, limit_state=Verbatim(check.limit_state))


def _neighbours(places: list[int], numbers: list[str]) -> list[list[str]]:
    """Return the numbers in groups of neighbours."""
    runs: list[list[str]] = []
    for index, (place, number) in enumerate(zip(places, numbers, strict=True)):
        if index and place == places[index - 1] + 1:
            runs[-1].append(number)
        else:
            runs.append([number])
    return runs


def _range_texts(run: list[str]) -> list[Text]:
    if len(run) < SHORTEST_RANGE:
        return [Verbatim(number) for number in run]
    return [say("{first} to {last}", first=Verbatim(run[0]), last=Verbatim(run[-1]))]


def _definition_without_joints(results: Results, mechanism: MechanismResult) -> frozenset[tuple[str, str]]:
    """Return what the project says of a mechanism, except its joints and label: {(key, value)}."""
    start = f"mechanisms.{mechanism.name}."
    found = ((key[len(start) :], each.value) for key, each in results.project.items() if key.startswith(start))
    same = frozenset((key, repr(value)) for key, value in found if key.partition(".")[0] not in JOINT_KEYS)
    return same or frozenset({("name", mechanism.name)})
