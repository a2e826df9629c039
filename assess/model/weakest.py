"""The direction of a mechanism: the weakest where none is given, and a given one beside those that are weaker.

The least uplift multiplier, with all loads and the crack in place, is the first filter; of the candidates near it the
one of least d0* stays.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from assess.errors import ProjectError
from assess.mechanisms.directions import Candidate, Vector, angle_of
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity, Severity, Term, Value, message
from assess.model.assembly import Built, mechanism_of
from assess.model.body import Bodies
from assess.model.candidates import (
    OTHER_SIDE,
    Look,
    displacement_of,
    evaluate_all,
    free_of,
    look_around,
    near_least,
    rank,
    uplift,
    vector_text,
    weakest_of,
    with_displacement,
    worth,
)
from assess.model.definitions import Chained, Definition, EquivalentBlock, Turnable
from assess.model.directions import S, sweep_directions, turn_towards
from assess.model.obstacles import AHEAD, bodies_that_stop

CLEARLY = 0.95  # of a given direction's multiplier: a candidate below it is clearly weaker
LISTED = 4


def mechanism_in_direction(name: str, definition: Definition, bodies: Bodies) -> Built:
    """Build the mechanism of a definition, in its weakest direction if none is given.

    Parameters
    ----------
    name : of the mechanism
    definition : the mechanism as stated
    bodies : of the building, by name

    Returns
    -------
    The mechanism with its candidate directions and messages, and its bodies in space

    Raises
    ------
    ProjectError : the direction must be given; the text lists the candidates
    MechanismError or GeometryError : it cannot rock as described
    """
    if not isinstance(definition, Turnable) or definition.direction == "sweep" or not has_geometry(definition, bodies):
        return mechanism_as_given(name, definition, bodies)
    look = look_around(name, definition, bodies)
    if definition.direction is None:
        return in_weakest(look)
    return in_given_direction(look)


def mechanism_as_given(name: str, definition: Definition, bodies: Bodies) -> Built:
    """Build the mechanism without comparing candidates; a body without geometry has one plane only, taken as +x.

    Parameters
    ----------
    name : of the mechanism
    definition : the mechanism as stated, with its direction and sides
    bodies : of the building, by name
    """
    if not isinstance(definition, EquivalentBlock) and definition.direction == "sweep":
        return sweep_directions(name, definition, bodies)
    return mechanism_of(name, definition, bodies)


def has_geometry(definition: Chained, bodies: Bodies) -> bool:
    """Return whether all bodies of a mechanism have geometry."""
    return all(bodies[body].solid is not None for body in definition.bodies)


def in_weakest(look: Look) -> Built:
    """Build the mechanism in its weakest direction; raise ProjectError with the candidates if it must be given."""
    candidates = evaluate_all(look)
    known = [each for each in candidates if each.multiplier is not None]
    if not known:  # nor can it be built towards any: say why
        return mechanism_of(look.name, turn_towards(look.definition, candidates[0].way), look.bodies)
    reason = next(must_be_given(look.definition), "")
    if reason:
        raise ProjectError(f"{look.where}.direction: missing; {reason}; the candidates are {list_directions(known)}")
    pool, held = free_of(known)
    found = weakest_of([with_displacement(each, look) for each in near_least(pool)])
    candidates = tuple(found if each.angle == found.angle else each for each in candidates)
    behind = () if held else bodies_that_stop(look.obstacles, opposite(found.way))
    definition = with_sides(turn_towards(look.definition, found.way), behind)
    built = mechanism_of(look.name, definition, look.bodies)
    messages = [*obstacle_messages(candidates, found, held=held, where=look.where), *sides_messages(behind, look)]
    messages += [cannot_rock(each, look.where) for each in candidates if each.why not in ("", OTHER_SIDE)]
    return with_messages(built, candidates, messages, look)


def with_sides(definition: S, behind: Sequence[str]) -> S:
    """Return the definition with its sides: those given, else one if bodies stand behind."""
    return replace(definition, sides=definition.sides or ("one" if behind else "two"))


def must_be_given(definition: Turnable) -> Iterator[str]:
    """Say why the direction cannot be found for the user."""
    if definition.sides == "one":
        yield 'with sides = "one" it says which way the mechanism is free'
    for key in definition.keys_along():
        yield f"{format_key(key)} is measured along it"


def format_key(key: Sequence[str | int]) -> str:
    """Write a key of a mechanism as the user does, with entries of lists counted from 1."""
    return "".join(f"[{step + 1}]" if isinstance(step, int) else f".{step}" for step in key).lstrip(".")


def list_directions(known: Sequence[Candidate]) -> str:
    """List directions with their multipliers, the weakest first."""
    rising = sorted(known, key=rank)
    texts = [f"{vector_text(each.way)} with a multiplier of {each.multiplier:.4g}" for each in rising[:LISTED]]
    return ", ".join(texts) + (f" and {len(rising) - LISTED} stronger" if len(rising) > LISTED else "")


def opposite(way: Vector) -> Vector:
    """Return the opposite direction."""
    return (-way[0], -way[1], 0.0)


def in_given_direction(look: Look) -> Built:
    """Build the mechanism in the given direction, with a warning if another is clearly weaker."""
    ahead = Candidate(angle_of(look.definition.towards)).way
    into = bodies_that_stop(look.obstacles, ahead)
    behind = () if into else bodies_that_stop(look.obstacles, opposite(ahead))
    built = mechanism_of(look.name, with_sides(look.definition, behind), look.bodies)
    messages = [*direction_warnings(into, ahead, look), *sides_messages(behind, look)]
    if look.definition.hinges is not None or next(look.definition.keys_along(), None) is not None:
        return with_messages(built, (), messages, look)
    candidates = evaluate_all(look)
    messages += weaker_than(built.mechanism, candidates, look)
    return with_messages(built, candidates, messages, look)


def direction_warnings(into: Sequence[str], ahead: Vector, look: Look) -> Iterator[Message]:
    """Warn that the given direction leads into a body."""
    if into:
        values = {"direction": vector_text(ahead), "bodies": ", ".join(into)}
        yield message("direction-into", values, severity=Severity.WARNING, where=look.where)


def weaker_than(given: Mechanism, candidates: Sequence[Candidate], look: Look) -> Iterator[Message]:
    """Warn if an unobstructed candidate is clearly weaker than the mechanism in its given direction."""
    ahead = np.array(Candidate(angle_of(look.definition.towards)).way)
    open_ways = [each for each in candidates if each.multiplier is not None and not each.touching]
    if given.sides == "one":  # what stops it stands behind
        open_ways = [each for each in open_ways if np.array(each.way) @ ahead > -AHEAD]
    if not open_ways:
        return
    weak = weakest_of([with_displacement(each, look) for each in near_least(open_ways)])
    own = min((given.positive, *([given.negative] if given.negative else [])), key=uplift)
    if worth(weak) >= CLEARLY * uplift(own):
        return
    values: dict[str, Value] = {
        "direction": vector_text(weak.way),
        "weaker": Quantity(worth(weak)),
        "weaker_d0": length_text(weak.displacement),
        "given": Quantity(uplift(own)),
        "given_d0": length_text(displacement_of(own, name=look.name)),
    }
    yield message("direction-weaker", values, severity=Severity.WARNING, where=look.where)


def length_text(length: float | None) -> Value:
    """Return a displacement [m] as a value of a message."""
    return Term("none, as it never overturns,") if length is None else Quantity(length, "length")


def obstacle_messages(
    candidates: Sequence[Candidate], found: Candidate, *, held: bool, where: str
) -> Iterator[Message]:
    """Tell which directions are stopped by bodies beside the mechanism."""
    for each in candidates:
        if each.multiplier is None or not each.touching:
            continue
        bodies, weaker = ", ".join(each.touching), Quantity(worth(each))
        values: dict[str, Value] = {"direction": vector_text(each.way), "bodies": bodies, "weaker": weaker}
        if not held:
            yield message("direction-stopped", values, where=where)
        elif each.angle == found.angle:
            yield message("direction-held", values, severity=Severity.WARNING, where=where)


def sides_messages(behind: Sequence[str], look: Look) -> Iterator[Message]:
    """Tell that it rocks to one side because of what stands behind it."""
    if behind and look.definition.sides is None:
        yield message("sides-by-contact", {"bodies": ", ".join(behind)}, where=look.where)


def cannot_rock(candidate: Candidate, where: str) -> Message:
    """Say why a direction was left out."""
    values = {"direction": vector_text(candidate.way), "why": candidate.why}
    return message("direction-left-out", values, severity=Severity.WARNING, where=where)


def with_messages(built: Built, candidates: Sequence[Candidate], messages: Sequence[Message], look: Look) -> Built:
    """Return the mechanism with its candidates, the bodies beside it and the messages on them."""
    beside = tuple(obstacle.body for obstacle in look.obstacles)
    found = replace(built.mechanism, candidates=tuple(candidates), beside=beside, messages=tuple(messages))
    return replace(built, mechanism=found)
