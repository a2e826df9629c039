"""Displacement capacities d_LS: a share of d0*, or less where a tie breaks or a seat is lost before.

A break limits where it takes more than half of the largest acceleration that the mechanism has; after a smaller loss
the curve goes on without the element. Rotations of both become spectral displacements by C8.7.1.4.
Source: Circolare 7/2019, C8.7.1.2.1.6; 617/2009, C8A.4.2.2.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from assess.codes.check import Step, step
from assess.codes.context import Context, LocalLimit
from assess.codes.italian.curves import Curves
from assess.codes.italian.kinematic import (
    BEFORE,
    displacement_at,
    displacement_at_collapse,
    multiplier_at,
    rotation_at,
)
from assess.codes.italian.sheet import collapse_steps, displacement_steps
from assess.messages.message import Message, Quantity, Severity, Value, list_values, message
from assess.oscillator import Branch, multiplier, participation_ratio

LOSS = 0.5  # of the largest acceleration capacity


@dataclass(frozen=True)
class Rule:
    """What a limit state allows: its share of d0* [-], whether breaks limit it besides seats, and the clause."""

    share: float
    breaks: bool
    clause: str


@dataclass(frozen=True)
class Local:
    """A local limit that counts: its displacement [m], and for a break lambda just after and the largest lambda [-]."""

    limit: LocalLimit
    moved: float
    after: float = 0.0
    largest: float = 0.0


@dataclass(frozen=True)
class Threshold:
    """d_LS and d0* [m], and the local limits that count."""

    moved: float
    collapse: float
    locals: tuple[Local, ...]


def threshold_of(curves: Curves, rule: Rule) -> Threshold:
    """Return the displacement capacity of one branch: the least of the share of d0*, the breaks and the seats.

    Parameters
    ----------
    curves : the branch by the actions in it, with its local limits
    rule : of the limit state

    Returns
    -------
    Threshold
    """
    collapse = displacement_at_collapse(curves.lasting, mass=curves.mass)
    found = tuple(_locals(curves, rule))
    return Threshold(min([rule.share * collapse, *(each.moved for each in found)]), collapse, found)


def _locals(curves: Curves, rule: Rule) -> Iterator[Local]:
    for limit in curves.limits:
        moved = displacement_at(curves.lasting, limit.rotation, mass=curves.mass)
        if limit.kind == "seat":
            yield Local(limit, moved)
        elif rule.breaks:
            after, largest = _around(curves.breaking, limit.rotation)
            if after < LOSS * largest:
                yield Local(limit, moved, after, largest)


def _around(branch: Branch, rotation: float) -> tuple[float, float]:
    """Return lambda just after a rotation [rad], 0 beyond the end of the table, and the largest of the curve [-]."""
    standing = branch.rotation <= branch.unstable
    beyond = rotation * (1.0 + BEFORE)
    after = 0.0 if beyond > branch.rotation[-1] else multiplier_at(branch, beyond)
    return after, float(multiplier(branch)[standing].max())


def threshold_steps(curves: Curves, threshold: Threshold, rule: Rule, symbol: str, words: str) -> tuple[Step, ...]:
    """Write d0*, the local limits that count, and d_LS named `symbol`."""
    steps = [*collapse_steps(curves.lasting, rule.clause, mass=curves.mass)]
    terms, given = [f"{rule.share:g} · d0*"], {"d0*": (threshold.collapse, "m")}
    for number, each in enumerate(threshold.locals, 1):
        name = f"d_{each.limit.kind}{number}"
        steps += _local_steps(curves, each, name, rule.clause)
        terms.append(name)
        given[name] = (each.moved, "m")
    formula = terms[0] if len(terms) == 1 else f"min({', '.join(terms)})"
    return *steps, step(symbol, words, rule.clause, formula, threshold.moved, "m", given=given)


def _local_steps(curves: Curves, each: Local, name: str, clause: str) -> Iterator[Step]:
    seat, what, upper = each.limit.kind == "seat", each.limit.what, f"φ_{name[2:]}"
    words = "displacement at which the seat is lost" if seat else "displacement at which the action ends"
    yield from displacement_steps(
        name, words, clause, curves.lasting, mass=curves.mass, rotation=each.limit.rotation, upper=upper, subject=what
    )
    if seat:
        return
    words = "acceleration just after the action ends over the largest; it limits below one half"
    given = {"λ": each.after, "λ_max": each.largest}
    yield step("λ / λ_max", words, clause, "λ / λ_max", each.after / each.largest, given=given, subject=what)


def break_conditions(curves: Curves) -> tuple[Message, ...]:
    """Return the condition of a pass where a tie or force is counted up to a displacement: that it lasts until then."""
    what = ", ".join(dict.fromkeys(each.what for each in curves.limits if each.kind == "break"))
    return (message("holds-to-its-end", {"what": what}, severity=Severity.WARNING),) if what else ()


def seat_conditions(context: Context, curves: Curves, state: str, moved: float) -> tuple[Message, ...]:
    """Return the condition of a pass where floors or beams rest on the mechanism and their seats are not given.

    A point above the centre of the masses moves more than it, so that each seat has a movement of its own; of two
    branches the larger at the same rotation counts.

    Parameters
    ----------
    context : of the mechanism
    curves : of the branch
    state : limit state
    moved : displacement capacity d* [m]
    """
    e = participation_ratio(curves.lasting, mass=curves.mass)
    rotation = rotation_at(curves.lasting, moved * e, mass=curves.mass)
    travels: dict[str, float] = {}
    for seat in context.open_seats:
        travel = float(np.interp(rotation, seat.rotation, seat.travel))
        travels[seat.what] = max(travel, travels.get(seat.what, 0.0))
    if not travels:
        return ()
    seats = [message("seat-travel", {"what": what, "moved": Quantity(far, "length")}) for what, far in travels.items()]
    values: dict[str, Value] = {"state": state, "seats": list_values(*seats)}
    return (message("seats-hold", values, severity=Severity.WARNING),)
