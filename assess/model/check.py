"""What a definition must hold before it can become a mechanism; project files are read by the same declarations."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass, replace
from numbers import Real
from types import UnionType
from typing import Annotated, Any, TypeVar, Union, get_args, get_origin

import numpy as np

from assess.declaration import StatedPlace, annotations_of
from assess.errors import MechanismError
from assess.faults import declared_problems, text_of_value, value_fault
from assess.loads.load import body_faults
from assess.mechanisms.chain import HINGES
from assess.mechanisms.four_hinge import FourHinge
from assess.mechanisms.kinds import Definition
from assess.mechanisms.mechanism import BlockMechanism
from assess.mechanisms.single_block import EquivalentBlock
from assess.model.bodies import Bodies

HINGE_KEYS = ("hinges", "hinges_negative")


def check_definition(name: str, definition: Definition, bodies: Bodies) -> None:
    """Raise MechanismError for a value that no mechanism can have, with where it stands and what to give.

    Parameters
    ----------
    name : of the mechanism
    definition : as stated
    bodies : the bodies that it may name
    """
    problem = next(_problems(definition, bodies), None)
    if problem is not None:
        raise MechanismError(f'mechanism "{name}": {problem}')


def _problems(definition: Definition, bodies: Bodies) -> Iterator[str]:
    by_kind: dict[str, str] = {}
    if isinstance(definition, BlockMechanism):
        by_kind = dict.fromkeys(HINGE_KEYS, _hinge_form(definition))
    yield from declared_problems(definition, forms=FORMS | by_kind)
    if isinstance(definition, EquivalentBlock):
        return
    yield from _block_problems(definition, bodies)
    yield from _material_problems(bodies)
    yield from _hinge_problems(definition)
    known = ", ".join(f'"{name}"' for name in bodies)
    for number, key, reason in body_faults(
        definition.loads, bodies, moving=definition.bodies, known=f"known: {known}; give it in `around`"
    ):
        yield f"loads[{number + 1}].{key} = {text_of_value(getattr(definition.loads[number], key))}: {reason}"


def _block_problems(definition: BlockMechanism, bodies: Bodies) -> Iterator[str]:
    count = len(definition.blocks)
    most = definition.number_of_blocks
    if not 1 <= count <= most or not all(definition.blocks):
        yield f"blocks: {count} of them; give 1{f' to {most}' if most > 1 else ''}, each of one body or more"
    for body in definition.bodies:
        if body not in bodies:
            yield f'blocks: "{body}" is no body; known: {", ".join(bodies)}'


def _material_problems(bodies: Bodies) -> Iterator[str]:
    for name, body in bodies.items():
        for data in filter(None, (body.material, body.values)):
            yield from declared_problems(data, f'body "{name}": ')


def _hinge_problems(definition: BlockMechanism) -> Iterator[str]:
    """Yield what is wrong with given hinges: their number, and places that are none."""
    for key in HINGE_KEYS:
        hinges = getattr(definition, key)
        if hinges is None or (hinges == "minimum" and key == "hinges" and isinstance(definition, FourHinge)):
            continue
        if isinstance(hinges, str) or len(hinges) != HINGES[definition.number_of_blocks]:
            yield f"{key} = {hinges!r}: {_hinge_form(definition)}"
            continue
        for hinge_name, place in zip("ABCD", hinges, strict=False):
            if reason := value_fault(place, StatedPlace):
                yield f"{key}.{hinge_name} = {text_of_value(place)}: {reason}"


def _hinge_form(definition: BlockMechanism) -> str:
    return f"give {', '.join('ABCD'[: HINGES[definition.number_of_blocks]])}, each a place"


FORMS = {
    "cut": "give an elevation [m], a CutPlane or a CutAngle",
    "restitution": "give a number in [0, 1], or the name of a rule",
}
Data = TypeVar("Data")


def with_floats(data: Data) -> Data:
    """Return a definition whose lengths and masses are floats and whose places are tuples, however they were given."""
    kind: type = type(data)
    kinds = annotations_of(kind)
    changed = {
        field.name: as_floats(getattr(data, field.name))
        for field in fields(data)  # type: ignore[arg-type]
        if field.init and not _is_count(kinds[field.name])
    }
    return replace(data, **changed)  # type: ignore[type-var]


def _is_count(annotation: Any) -> bool:
    """Return whether a field holds a whole number, as which block, which case or how many."""
    if get_origin(annotation) in (Annotated, Union, UnionType):
        return any(map(_is_count, get_args(annotation)))
    return annotation is int


def as_floats(value: Any) -> Any:
    """Return a value with every number in it as a float and every list as a tuple; truth values and texts stay."""
    if isinstance(value, np.ndarray):
        return as_floats(value.tolist())
    if isinstance(value, tuple | list):
        return tuple(map(as_floats, value))
    if isinstance(value, dict):
        return {key: as_floats(each) for key, each in value.items()}
    if is_dataclass(value) and not isinstance(value, type):
        return with_floats(value)
    return float(value) if isinstance(value, Real) and not isinstance(value, bool) else value
