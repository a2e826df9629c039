"""The height of each mechanism above the ground, and the source of the level of the ground."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from assess.codes.check import Reason, reason_message
from assess.codes.context import is_above_ground
from assess.geometry.solid import Solids
from assess.loads.definitions import bodies_of
from assess.mechanisms.limits import height_of_support
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity
from assess.model.definitions import Chained, Definition

FAR = 0.5  # m: a lowest body farther from elevation 0 does not show where the ground is
BY_BUILDING = "by building.ground_elevation"
BY_MECHANISM = "by its base_elevation"
BY_TABLE = "by its elevation, the ground at 0"
BY_BODIES = "by the lowest body, which stands near elevation 0"
UNKNOWN = "not known where the ground is: give building.ground_elevation, or its base_elevation"


@dataclass(frozen=True)
class Grounded:
    """The height of a mechanism above the ground.

    base : height of its base [m]; support : height of its support, the mean of base and far support if it has both [m]
    above : whether that counts as above the ground; source : of the level of the ground, in words
    unknown : why no check can be answered, if that level is not known
    """

    base: float
    support: float
    above: bool
    source: str
    unknown: tuple[Message, ...] = ()


@dataclass(frozen=True)
class Ground:
    """The level of the ground, as far as given.

    elevation : of the ground [m], None if not given; lowest : elevation of the lowest body [m], None without bodies
    building_height : height of the building above the ground [m], 0 if not given
    """

    elevation: float | None = None
    lowest: float | None = None
    building_height: float = 0.0

    def below(self, mechanism: Mechanism, base_elevation: float | None) -> float:
        """Return how high the base of a mechanism is above the ground [m]: given for it alone, or by its elevation."""
        return mechanism.elevation - (self.elevation or 0.0) if base_elevation is None else base_elevation


def stand_on(
    ground: Ground, mechanism: Mechanism, *, base_elevation: float | None = None, by_table: bool = False
) -> Grounded:
    """Find the height of a mechanism above the ground.

    Parameters
    ----------
    ground : Ground
        The level of the ground.
    mechanism : Mechanism
        The mechanism.
    base_elevation : float, optional
        Height of its base above the ground, if it is not drawn in its place [m].
    by_table : bool
        Whether the mechanism gives its own elevation, as one of published parameters does.

    Returns
    -------
    Grounded
        With the source of the level of the ground.
    """
    base = ground.below(mechanism, base_elevation)
    support = max(base, 0.0) + height_of_support(mechanism) / 2.0
    source = _source(ground, base_elevation, by_table=by_table)
    lowest = mechanism.elevation if ground.lowest is None else ground.lowest
    if not source:
        source = BY_BODIES if abs(lowest) <= FAR else UNKNOWN
    unknown: tuple[Message, ...] = (
        (reason_message(Reason.GROUND_UNKNOWN, height=Quantity(lowest, "length")),) if source == UNKNOWN else ()
    )
    if source == BY_MECHANISM and not unknown:
        unknown = _contradiction(base, ground.below(mechanism, None), lowest, mechanism, ground)
    return Grounded(base, support, is_above_ground(support, ground.building_height), source, unknown)


def _contradiction(
    base: float, drawn: float, lowest: float, mechanism: Mechanism, ground: Ground
) -> tuple[Message, ...]:
    """Return why a base_elevation below the drawn base cannot be right: the project defines the level of the ground.

    It does so by ground_elevation, or by bodies under the mechanism, which is then not drawn alone.
    """
    alone = lowest > mechanism.elevation - FAR
    if base >= drawn - FAR or (alone and ground.elevation is None):
        return ()
    return (
        reason_message(Reason.GROUND_CONTRADICTED, given=Quantity(base, "length"), drawn=Quantity(drawn, "length")),
    )


def _source(ground: Ground, base_elevation: float | None, *, by_table: bool) -> str:
    """Return which key defines the level of the ground, in words; empty if none does."""
    if base_elevation is not None:
        return BY_MECHANISM
    if ground.elevation is not None:
        return BY_BUILDING
    return BY_TABLE if by_table else ""


def lowest_of(definitions: Mapping[str, Definition], solids: Solids) -> float | None:
    """Return the elevation of the lowest body [m] that is more than a load; None where there is none.

    Parameters
    ----------
    definitions : the mechanisms by name
    solids : of the building's bodies by name
    """
    chained = [each for each in definitions.values() if isinstance(each, Chained)]
    used = {body for each in chained for body in each.bodies}
    loads = {body for each in chained for load in each.loads for body in bodies_of(load)}
    bodies = [solid for name, solid in solids.items() if solid is not None and (name in used or name not in loads)]
    return min((float(solid.vertices[:, 2].min()) for solid in bodies), default=None)
