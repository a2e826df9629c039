"""What a load of a definition must hold; a project file says the same by its schema."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from numbers import Real
from typing import Any

from assess.loads.definitions import (
    BodyLoad,
    ForceLoad,
    LoadDefinition,
    MassLoad,
    OverburdenLoad,
    TieLoad,
    bodies_of,
)
from assess.model.body import Bodies
from assess.model.definitions import Chained, TwoBlock

KINDS = (MassLoad, ForceLoad, TieLoad, OverburdenLoad, BodyLoad)
ROLES = ("floor", "roof", "vault")
VAULTS = ("barrel", "quadripartite", None)
CONSTRUCTIONS = (1, 2, 3, 4, 5, None)  # Ungewitter's cases
OF_THRUST = ("thrust", "span", "rise", "tied")
OF_VAULTS = ("vault", "construction", "fill")
LEAVES_OUT = {"thrust": ("tied", "span", "rise"), "mass": ("construction", "fill")}  # a number, and what it replaces


def load_problems(load: LoadDefinition, definition: Chained, bodies: Bodies) -> Iterator[str]:
    """Yield what is wrong with a load, each with what to give.

    Parameters
    ----------
    load : as stated
    definition : the mechanism that it is a load of
    bodies : the bodies that it may name
    """
    if not isinstance(load, KINDS):
        yield f"{load!r} is no load; give {', '.join(kind.__name__ for kind in KINDS)}"
        return
    unknown = [body for body in bodies_of(load) if body not in bodies]
    if unknown:
        yield f'"{unknown[0]}" is no body here; give it in `around`'
    if not isinstance(load, OverburdenLoad):
        if load.block is not None and load.block not in range(definition.moving):
            yield f"block = {load.block}: must be from 0 to {definition.moving - 1}, counted from the base"
        if load.at is not None:
            yield from place_problems("at", load.at)
    yield from OF_KIND[type(load)](load, definition)


def place_problems(key: str, place: Any) -> Iterator[str]:
    """Yield what is wrong with a place or a direction: it has two or three numbers."""
    if not isinstance(place, tuple) or len(place) not in (2, 3) or not all(isinstance(each, Real) for each in place):
        yield f"{key} = {place!r}: give (x, y, z), or (along the direction, up)"


def _mass(load: MassLoad, definition: Chained) -> Iterator[str]:
    if load.seat is not None and not load.bearing:
        yield "seat: only what bears on the block has a seat; remove it, or give bearing = True"


def _force(load: ForceLoad, definition: Chained) -> Iterator[str]:
    if isinstance(load.force, tuple) != (load.direction is None):
        yield "give the force by its two components, or its size with a direction"
    elif isinstance(load.force, tuple):
        if len(load.force) != 2:
            yield f"force = {load.force}: give (along the direction, up), or a size with a direction"
    elif not load.force > 0.0:
        yield f"force = {load.force:g}: must be greater than 0; turn its direction instead"
    yield from _pull(load)


def _tie(load: TieLoad, definition: Chained) -> Iterator[str]:
    if (load.direction is None) == (load.anchor is None):
        yield "give either anchor or direction, the way the tie pulls"
    if not load.force > 0.0:
        yield f"force = {load.force:g}: must be greater than 0; it is the pretension"
    if load.anchor is not None:
        yield from place_problems("anchor", load.anchor)
    yield from _pull(load)


def _pull(load: ForceLoad | TieLoad) -> Iterator[str]:
    """Yield what is wrong with the direction and the end of a force or a tie."""
    if load.direction is not None:
        yield from place_problems("direction", load.direction)
        if not any(load.direction):
            yield f"direction = {load.direction}: must not be zero"
    until = load.until
    if until not in (None, "collapse") and not (isinstance(until, Real) and until > 0.0):
        yield f'until = {until!r}: give the displacement of its point at which it ends, above 0, or "collapse"'


def _overburden(load: OverburdenLoad, definition: Chained) -> Iterator[str]:
    if not isinstance(definition, TwoBlock):
        yield "an overburden is for two-block mechanisms; use a mass or a force"
    if (load.force is None) == (not load.bodies):
        yield "give either force, or the bodies that press"
    if load.force is not None and not load.force > 0.0:
        yield f"force = {load.force:g}: must be greater than 0; it presses down"
    if load.through not in ("joint", "fixed", None):
        yield f'through = {load.through!r}: write "joint" or "fixed"'
    if load.through == "joint" and load.eccentricity:
        yield 'eccentricity: a load through the joint presses where that does; remove it, or give through = "fixed"'


def _body(load: BodyLoad, definition: Chained) -> Iterator[str]:
    if load.body in definition.bodies:
        yield f'"{load.body}" is part of a block; name another body'
    for key, known in (("role", ROLES), ("vault", VAULTS), ("construction", CONSTRUCTIONS)):
        if getattr(load, key) not in known:
            yield f"{key} = {getattr(load, key)!r}: choose one of {', '.join(str(each) for each in known if each)}"
    if load.share is not None and load.share > 1.0:
        yield f"share = {load.share:g}: outside (0, 1]; it is the part of the body that this block carries"
    for key in OF_THRUST:
        if load.role == "floor" and getattr(load, key):
            yield f'{key}: only a roof or a vault has a thrust; give role = "roof" or "vault", or remove it'
    for key in OF_VAULTS:
        if load.role != "vault" and getattr(load, key) is not None:
            yield f'{key}: only of a vault; give role = "vault", or remove it'
    for number, keys in LEAVES_OUT.items():
        for key in keys:
            if getattr(load, key) and getattr(load, number) is not None:
                yield f"{key}: has no effect beside {number}; remove one of them"


OF_KIND: dict[type[Any], Callable[[Any, Chained], Iterator[str]]] = {
    MassLoad: _mass,
    ForceLoad: _force,
    TieLoad: _tie,
    OverburdenLoad: _overburden,
    BodyLoad: _body,
}
