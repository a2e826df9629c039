"""The loads of a mechanism as used, how long each lasts, and messages on those that are not shown to last."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import inf
from typing import Literal

from assess.loads.load import Force, Load, PointMass, Tie, found_text, pull_at_rest
from assess.mechanisms.ends import displacement_at
from assess.mechanisms.mechanism import Mechanism
from assess.mechanisms.stages import actions_of
from assess.messages.message import Message, Quantity, Severity, Term, message
from assess.results import Lasting, LoadResult

WIDEST_SEAT = 2.0  # m: floors and roofs rest on less


def load_results(mechanism: Mechanism) -> tuple[LoadResult, ...]:
    """Return every load as used, with its source."""
    number, found = 0, []
    for load in mechanism.positive.loads:
        one = load_result(load)
        if not isinstance(load, PointMass):
            one = with_duration(mechanism, number, one)
            number += 1
        found.append(one)
    return tuple(found)


def load_result(load: Load) -> LoadResult:
    """Return a load as used, with its source."""
    found = load.found or (Term("given"),)
    source = found_text(found)
    if isinstance(load, PointMass):
        seat, mass = load.seat if load.bearing else None, load.mass
        made = LoadResult(load.name, "mass", load.block, load.at, mass, load.bearing, None, source, seat_m=seat)
        return replace(made, found=found)
    at, missing = load.at, load.missing
    kind: Literal["force", "tie"] = "force" if isinstance(load, Force) else "tie"
    force = load.force if isinstance(load, Force) else pull_at_rest(load)
    return LoadResult(load.name, kind, load.block, at, None, None, force, source, missing=missing, found=found)


def with_duration(mechanism: Mechanism, number: int, load: LoadResult) -> LoadResult:
    """Return a force or tie, by its number, with how long it lasts on the branch where it ends first."""
    sides = list(zip(mechanism.actions, mechanism.variants.ends, strict=True))
    resisting = [(one, kept[number]) for one, kept in sides if one.ever_resists(number)]
    if not resisting:
        return replace(load, missing=())
    first = min((one for one, _ in resisting), key=lambda one: one.ends[number])
    end, lasts = first.ends[number], all(kept > 0.0 for _, kept in resisting)
    broken = 0.0 < end < inf
    return replace(
        load,
        lasting=_lasting(lasts, broken),
        missing=load.missing if end == 0.0 else (),
        end_rad=end if broken else None,
        end_m=displacement_at(first.chain, first.actions[number], end) if broken else None,
    )


def _lasting(lasts: bool, broken: bool) -> Lasting:
    if lasts:
        return "to collapse"
    return "to its end" if broken else "not shown"


def load_messages(mechanism: Mechanism) -> Iterator[Message]:
    """Yield a warning for each tie or force that resists but is not shown to last, and if all depends on them.

    A tie with a pretension above its strength gets one, too, and so does a seat wider than walls are thick.

    A force that drives one way and resists the other is a thrust and gets no warning.
    """
    where = f"mechanisms.{mechanism.name}"
    for mass in mechanism.positive.loads:
        if isinstance(mass, PointMass) and mass.seat is not None and mass.seat > WIDEST_SEAT:
            seat = Quantity(mass.seat, "length")
            yield message("seat-wide", {"load": mass.name, "seat": seat}, severity=Severity.WARNING, where=where)
    for tie in mechanism.positive.loads:
        if isinstance(tie, Tie) and tie.tension < tie.pull:
            forces = {"force": Quantity(tie.pull, "force"), "strength": Quantity(tie.tension, "force")}
            yield message(
                "pretension-above-strength", {"load": tie.name, **forces}, severity=Severity.WARNING, where=where
            )
    if not actions_of(mechanism.positive):
        return
    thrusts = {each.name for one in mechanism.actions for each in one.thrusts}
    for load in load_results(mechanism):
        if load.lasting == "not shown" and load.name not in thrusts:
            values = {"load": load.name, "missing": ", ".join(load.missing)}
            yield message("not-lasting", values, severity=Severity.WARNING, where=where)
    yield from unsupported_messages(mechanism, where=where)


def unsupported_messages(mechanism: Mechanism, *, where: str = "") -> tuple[Message, ...]:
    """Return why no displacement can be assessed: the mechanism stands only by loads that are not shown to last."""
    loads = mechanism.variants.depends_on
    if not loads:
        return ()
    return (message("unheld", {"loads": ", ".join(loads)}, severity=Severity.WARNING, where=where),)
