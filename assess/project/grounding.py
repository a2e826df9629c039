"""Where the ground is."""

from __future__ import annotations

from collections.abc import Mapping

from assess.codes.check import Reason, because
from assess.geometry.solid import Solid
from assess.message import Message, Quantity
from assess.project import sections

DOUBTFUL = 0.5  # m: a lowest body farther from elevation 0 does not tell where the ground is


def ground_of(content: sections.Content) -> float:
    """Elevation of the ground [m]: given, or 0."""
    given = None if content.building is None else content.building.ground_elevation
    return given or 0.0


def unknown_ground(content: sections.Content, solids: Mapping[str, Solid | None]) -> tuple[Message, ...]:
    """Why no check can be answered where nobody says where the ground is: the lowest body is far from elevation 0."""
    if content.building is not None and content.building.ground_elevation is not None:
        return ()
    lowest = min((float(solid.vertices[:, 2].min()) for solid in solids.values() if solid is not None), default=0.0)
    if abs(lowest) <= DOUBTFUL:
        return ()
    return (because(Reason.GROUND_UNKNOWN, height=Quantity(lowest, "length")),)
