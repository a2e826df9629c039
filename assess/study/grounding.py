"""How high each mechanism stands above the ground, and how it is known where the ground is."""

from __future__ import annotations

from dataclasses import dataclass

from assess.codes.check import Reason, reason_message
from assess.codes.context import is_above_ground
from assess.mechanisms.limits import height_of_support
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity

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


@dataclass(frozen=True)
class Ground:
    """Where the ground is, as far as anybody says.

    elevation : of the ground [m], None where nobody gives it; lowest : of the lowest body [m], None without bodies
    building_height : of the building above the ground [m], 0 where nobody gives it
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
    """Find where a mechanism stands over the ground.

    Parameters
    ----------
    ground : what is said of the ground
    mechanism : as built
    base_elevation : of its base above the ground [m], where it is drawn alone and not in its place
    by_table : whether the mechanism gives its own elevation, as one of published parameters does
    """
    base = ground.below(mechanism, base_elevation)
    support = max(base, 0.0) + height_of_support(mechanism) / 2.0
    source = _source(ground, base_elevation, by_table=by_table)
    lowest = mechanism.elevation if ground.lowest is None else ground.lowest
    if not source:
        source = BY_BODIES if abs(lowest) <= DOUBTFUL else UNKNOWN
    unknown: tuple[Message, ...] = (
        (reason_message(Reason.GROUND_UNKNOWN, height=Quantity(lowest, "length")),) if source == UNKNOWN else ()
    )
    if source == BY_MECHANISM and not unknown:
        unknown = _contradiction(base, ground.below(mechanism, None), lowest, mechanism, ground)
    return Grounded(base, support, is_above_ground(support, ground.building_height), source, unknown)


def _contradiction(
    base: float, drawn: float, lowest: float, mechanism: Mechanism, ground: Ground
) -> tuple[Message, ...]:
    """Why a base_elevation below where the mechanism is drawn does not hold: the file says where the ground is.

    It does by its ground_elevation, or by bodies under the mechanism, which then is not drawn alone.
    """
    alone = lowest > mechanism.elevation - DOUBTFUL
    if base >= drawn - DOUBTFUL or (alone and ground.elevation is None):
        return ()
    return (
        reason_message(Reason.GROUND_CONTRADICTED, given=Quantity(base, "length"), drawn=Quantity(drawn, "length")),
    )


def _source(ground: Ground, base_elevation: float | None, *, by_table: bool) -> str:
    """Which key says where the ground is; empty where none does."""
    if base_elevation is not None:
        return BY_MECHANISM
    if ground.elevation is not None:
        return BY_BUILDING
    return BY_TABLE if by_table else ""
