"""Mechanisms that differ by their joints alone, as rigid and flexible ones of the same wall (thesis Table 8.7)."""

from __future__ import annotations

from assess.results import MechanismResult, Results
from reports import joints

OWN = ("label", "interface", "interfaces")
"""Keys in which variants may differ."""


def group_variants(results: Results) -> list[tuple[MechanismResult, ...]]:
    """Return every mechanism, those that differ by their joints alone together: rigid first, in the project's order."""
    found: dict[frozenset[tuple[str, str]], list[MechanismResult]] = {}
    for mechanism in results.mechanisms:
        found.setdefault(definition(results, mechanism), []).append(mechanism)
    return [tuple(sorted(group, key=lambda each: bool(joints.deformable_joints(each)))) for group in found.values()]


def definition(results: Results, mechanism: MechanismResult) -> frozenset[tuple[str, str]]:
    """Return what the project says of a mechanism, except its joints and label: {(key, value)}."""
    start = f"mechanisms.{mechanism.name}."
    found = ((key[len(start) :], each.value) for key, each in results.project.items() if key.startswith(start))
    same = frozenset((key, repr(value)) for key, value in found if key.partition(".")[0] not in OWN)
    return same or frozenset({("name", mechanism.name)})
