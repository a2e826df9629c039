"""Where the ground is, and how high above it each mechanism stands."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from assess.codes.check import Reason, reason_message
from assess.codes.context import is_above_ground
from assess.geometry.solid import Solid
from assess.mechanisms.lasting import rise_of
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity
from assess.project import sections

DOUBTFUL = 0.5  # m: a lowest body farther from elevation 0 does not tell where the ground is
BY_BUILDING = "by building.ground_elevation"
BY_MECHANISM = "by its base_elevation"
BY_TABLE = "by its elevation, the ground at 0"
BY_BODIES = "by the lowest body, which stands near elevation 0"
UNKNOWN = "not known where the ground is: give building.ground_elevation, or its base_elevation"


@dataclass(frozen=True)
class Grounded:
    """A mechanism over the ground.

    base : of its base [m]; support : of what holds it, the mean of base and far support where it is held twice [m]
    above : whether that counts as above the ground; source : where the ground is known from
    unknown : why no check can be answered, where it is not
    """

    base: float
    support: float
    above: bool
    source: str
    unknown: tuple[Message, ...] = ()


def ground_of(content: sections.Content) -> float:
    """Elevation of the ground [m]: given, or 0."""
    given = None if content.building is None else content.building.ground_elevation
    return given or 0.0


def base_above_ground(section: sections.Mechanism, mechanism: Mechanism, content: sections.Content) -> float:
    """How high the base of a mechanism is above the ground [m]: given for it alone, or by its elevation."""
    given = section.base_elevation if isinstance(section, sections.Chained) else None
    return mechanism.elevation - ground_of(content) if given is None else given


def grounded(
    section: sections.Mechanism, mechanism: Mechanism, content: sections.Content, solids: Mapping[str, Solid | None]
) -> Grounded:
    """Where a mechanism stands over the ground."""
    base = base_above_ground(section, mechanism, content)
    support = max(base, 0.0) + rise_of(mechanism) / 2.0
    height = 0.0 if content.building is None or content.building.height is None else content.building.height
    source = known_from(section, content)
    lowest = lowest_of(content, solids, default=mechanism.elevation)
    if not source:
        source = BY_BODIES if abs(lowest) <= DOUBTFUL else UNKNOWN
    unknown: tuple[Message, ...] = (
        (reason_message(Reason.GROUND_UNKNOWN, height=Quantity(lowest, "length")),) if source == UNKNOWN else ()
    )
    if source == BY_MECHANISM and not unknown:
        unknown = _contradicted(base, mechanism.elevation - ground_of(content), lowest, mechanism, content)
    return Grounded(base, support, is_above_ground(support, height), source, unknown)


def _contradicted(
    base: float, drawn: float, lowest: float, mechanism: Mechanism, content: sections.Content
) -> tuple[Message, ...]:
    """Why a base_elevation below where the mechanism is drawn does not hold: the file says where the ground is.

    It does by its ground_elevation, or by bodies under the mechanism, which then is not drawn alone.
    """
    said = content.building is not None and content.building.ground_elevation is not None
    alone = lowest > mechanism.elevation - DOUBTFUL
    if base >= drawn - DOUBTFUL or (alone and not said):
        return ()
    return (
        reason_message(Reason.GROUND_CONTRADICTED, given=Quantity(base, "length"), drawn=Quantity(drawn, "length")),
    )


def known_from(section: sections.Mechanism, content: sections.Content) -> str:
    """Which key says where the ground is; empty where none does."""
    if isinstance(section, sections.Chained) and section.base_elevation is not None:
        return BY_MECHANISM
    if content.building is not None and content.building.ground_elevation is not None:
        return BY_BUILDING
    return BY_TABLE if isinstance(section, sections.EquivalentBlock) and section.given("elevation") else ""


def lowest_of(content: sections.Content, solids: Mapping[str, Solid | None], *, default: float) -> float:
    """Elevation of the lowest body [m], those left out that are no more than loads; the default where none is left."""
    chained = [each for each in content.mechanisms.values() if isinstance(each, sections.Chained)]
    used = {body for each in chained for block in each.blocks for body in block}
    loads = {body for each in chained for load in each.loads for body in carried(load)}
    bodies = [solid for name, solid in solids.items() if solid is not None and (name in used or name not in loads)]
    return min((float(solid.vertices[:, 2].min()) for solid in bodies), default=default)


def carried(load: sections.LoadTable) -> tuple[str, ...]:
    """The bodies that a load stands for."""
    if isinstance(load, sections.OverburdenLoad):
        return load.bodies
    return (load.body,) if isinstance(load, sections.BodyLoad) else ()
