"""The title of a mechanism in the report."""

from __future__ import annotations

from assess.results import MechanismResult


def mechanism_title(mechanism: MechanismResult) -> str:
    """Return the mechanism's label, or its name where it has none."""
    return mechanism.label or mechanism.name
