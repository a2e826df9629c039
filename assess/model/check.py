"""What a definition must hold before it can become a mechanism; a project file says the same by its schema."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from math import isfinite
from typing import Any

from assess.errors import MechanismError
from assess.interfaces.definition import Interface, Shape
from assess.loads.definitions import BodyLoad, ForceLoad, LoadDefinition, OverburdenLoad, TieLoad, bodies_of
from assess.model.body import Bodies
from assess.model.definitions import Chained, Definition, EquivalentBlock, Restitution, TwoBlock

RULES = ("thesis", "housner", "sorrentino", "momentum")
MODELS = ("rigid", "flexible", "semi-flexible", "flexible-thesis")
POSITIVE = frozenset(
    [
        "p",
        "uplift",
        "radius",
        "mass",
        "stiffness",
        "course_thickness",
        "strength",
        "length",
        "fracture_strain",
        "seat",
        "tolerance",
        "share",
        "thrust",
        "span",
        "rise",
        "fill",
    ]
)
LEVEL = 1e-9  # of a direction: one that rises by less is horizontal


def check_definition(name: str, definition: Definition, bodies: Bodies) -> None:
    """Raise MechanismError for a value that no mechanism can have, with where it stands and what to give.

    Parameters
    ----------
    name : of the mechanism
    definition : as asked for
    bodies : the bodies that it may name
    """
    problem = next(_problems(definition, bodies), None)
    if problem is not None:
        raise MechanismError(f'mechanism "{name}": {problem}')


def _problems(definition: Definition, bodies: Bodies) -> Iterator[str]:
    yield from _numbers(definition, "")
    yield from _restitution(definition.restitution)
    if definition.sides not in ("one", "two", None):
        yield f'sides = {definition.sides!r}: write "one" or "two"'
    if isinstance(definition, EquivalentBlock):
        return
    yield from _direction(definition)
    for interface in (definition.interface, *definition.interfaces.values()):
        yield from _interface(interface)
    for number, load in enumerate(definition.loads, start=1):
        yield from (f"loads[{number}]: {problem}" for problem in _load(load, definition, bodies))


def _numbers(data: Any, where: str) -> Iterator[str]:
    """Yield each number that is not finite, and each that must be positive and is not; a strength may be infinite."""
    for field in fields(data):
        value, key = getattr(data, field.name), f"{where}{field.name}"
        if is_dataclass(value) and not isinstance(value, type):
            yield from _numbers(value, f"{key}.")
        elif isinstance(value, tuple):
            yield from _entries(value, key)
        elif isinstance(value, float | int) and not isinstance(value, bool):
            if not isfinite(value) and not (field.name in ("strength", "stiffness") and value > 0.0):
                yield f"{key} = {value}: give a finite number"
            elif field.name in POSITIVE and value <= 0.0:
                yield f"{key} = {value:g}: must be greater than 0"


def _entries(values: tuple[Any, ...], key: str) -> Iterator[str]:
    for number, value in enumerate(values, start=1):
        if is_dataclass(value) and not isinstance(value, type):
            yield from _numbers(value, f"{key}[{number}].")
        elif isinstance(value, tuple):
            yield from _entries(value, f"{key}[{number}]")
        elif isinstance(value, float) and not isfinite(value):
            yield f"{key}[{number}] = {value}: give a finite number"


def _restitution(restitution: Restitution) -> Iterator[str]:
    for value in (restitution.positive, restitution.negative):
        if isinstance(value, str) and value not in RULES:
            yield f"restitution = {value!r}: write a number in [0, 1], or one of {', '.join(RULES)}"
        if isinstance(value, float | int) and not 0.0 <= value <= 1.0:
            yield f"restitution = {value:g}: outside [0, 1]; it is velocity after over velocity before the impact"


def _direction(definition: Chained) -> Iterator[str]:
    direction = definition.direction
    if direction is None or direction == "sweep":
        return
    if isinstance(direction, str) or len(direction) != 3:
        yield f'direction = {direction!r}: give (x, y, 0), "weakest" or "sweep"'
    elif abs(direction[2]) > LEVEL * max(map(abs, direction)) or not any(direction[:2]):
        yield f"direction = {direction}: must be horizontal and not zero; give (x, y, 0)"


def _interface(interface: Interface) -> Iterator[str]:
    if interface.model not in MODELS:
        yield f"interface.model = {interface.model!r}: write one of {', '.join(MODELS)}"
    given = [key for key in ("stiffness", "course_thickness") if getattr(interface, key) is not None]
    if interface.model == "rigid" and given:
        yield f'interface.{given[0]}: is for flexible interfaces; give model = "flexible", or remove it'
    if interface.model != "rigid" and len(given) != 1:
        yield "interface.stiffness: give either stiffness or course_thickness"
    if isinstance(interface.shape, Shape):
        sizes = [field.name for field in fields(Shape) if getattr(interface.shape, field.name) is not None]
        if len(sizes) != 1:
            yield f"interface.shape: one size is needed, not {len(sizes)}"


def _load(load: LoadDefinition, definition: Chained, bodies: Bodies) -> Iterator[str]:
    unknown = [body for body in bodies_of(load) if body not in bodies]
    if unknown:
        yield f'"{unknown[0]}" is no body here; give it in `around`'
    if isinstance(load, OverburdenLoad):
        if not isinstance(definition, TwoBlock):
            yield "an overburden is for two-block mechanisms; use a mass or a force"
        if (load.force is None) == (not load.bodies):
            yield "give either force, or the bodies that press"
    elif load.block is not None and not 0 <= load.block < definition.moving:
        yield f"block = {load.block}: must be from 0 to {definition.moving - 1}, counted from the base"
    if isinstance(load, TieLoad) and (load.direction is None) == (load.anchor is None):
        yield "give either anchor or direction, the way the tie pulls"
    if isinstance(load, ForceLoad) and isinstance(load.force, tuple) != (load.direction is None):
        yield "give the force by its two components, or its size with a direction"
    if isinstance(load, BodyLoad) and load.body in definition.bodies:
        yield f'"{load.body}" is part of a block; name another body'
