"""The joints of a mechanism in the results: their models, what one carries at a rotation, and mechanisms that differ by
their joints alone (thesis Table 8.7).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from assess.codes.check import BranchName
from assess.results import HistoryResult, MechanismResult, Results
from reports.language.texts import Phrase, say

JOINT_MODELS: Mapping[str, Phrase] = {
    "rigid": say("rigid"),
    "rigid with crushing": say("rigid, with crushing"),
    "flexible": say("flexible"),
    "flexible-thesis": say("flexible, by the thesis"),
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
        found.setdefault(definition_without_joints(results, mechanism), []).append(mechanism)
    return [tuple(sorted(group, key=lambda each: bool(deformable_joints(each)))) for group in found.values()]


def definition_without_joints(results: Results, mechanism: MechanismResult) -> frozenset[tuple[str, str]]:
    """Return what the project says of a mechanism, except its joints and label: {(key, value)}."""
    start = f"mechanisms.{mechanism.name}."
    found = ((key[len(start) :], each.value) for key, each in results.project.items() if key.startswith(start))
    same = frozenset((key, repr(value)) for key, value in found if key.partition(".")[0] not in JOINT_KEYS)
    return same or frozenset({("name", mechanism.name)})
