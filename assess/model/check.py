"""What a definition must hold before it can become a mechanism; a project file says the same by its schema."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from math import inf, isfinite, pi, sqrt
from numbers import Integral, Real
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, TypeVar, Union, get_args, get_origin

import numpy as np
from scipy.constants import g

from assess.declaration import Mark, StatedPlace, annotations_of, one_of
from assess.errors import MechanismError
from assess.interfaces.contact import Interface
from assess.interfaces.section import Shape
from assess.loads.load import block_faults, body_faults
from assess.mechanisms.chain import HINGES
from assess.mechanisms.four_hinge import MOST_VOUSSOIRS, FourHinge, RadialJoints
from assess.mechanisms.kinds import Definition
from assess.mechanisms.mechanism import BlockMechanism
from assess.mechanisms.restitution import RESTITUTIONS, Restitution
from assess.mechanisms.single_block import INERTIA_RATIOS, EquivalentBlock
from assess.mechanisms.two_block import TwoBlock
from assess.model.bodies import Bodies
from spectra.arrays import is_number

POSITIVE = frozenset(["p", "uplift", "radius", "mass", "stiffness", "course_thickness", "strength"])
HINGE_KEYS = ("hinges", "hinges_negative")
TINY = 5e-324  # the least number above 0
TINIEST = 1e-150  # of a frequency parameter: its square is a number
LEVEL = 1e-9  # of a direction: one that rises by less is horizontal


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
    yield from _declared_problems(definition, forms=FORMS | by_kind)
    yield from _number_problems(definition, "")
    yield from _restitution_problems(definition.restitution)
    if isinstance(definition, EquivalentBlock):
        yield from _parameter_problems(definition)
        return
    yield from _block_problems(definition, bodies)
    yield from _material_problems(bodies)
    yield from _direction_problems(definition)
    yield from _hinge_problems(definition)
    if isinstance(definition, TwoBlock):
        yield from _crack_problems(definition)
    if isinstance(definition, FourHinge):
        yield from _arch_problems(definition)
    hinge_names = "ABCD"[: HINGES[definition.number_of_blocks]]
    for hinge_name in set(definition.interfaces) - set(hinge_names):
        yield f"interfaces.{hinge_name}: no such hinge; known: {', '.join(hinge_names)}"
    for interface in (definition.interface, *definition.interfaces.values()):
        yield from _interface_problems(interface)
    yield from _load_problems(definition, bodies)


def _parameter_problems(block: EquivalentBlock) -> Iterator[str]:
    """Yield what is wrong with published parameters: an angle, and an inertia that no mechanism has."""
    if not block.uplift < pi / 2.0:
        yield f"uplift = {block.uplift:g}: must be less than pi / 2; it is taken as the slenderness [rad]"
    least, most = INERTIA_RATIOS
    ratio = inf if block.p < TINIEST else g / (block.p * block.p * block.radius)
    if not least <= ratio <= most:
        low, high = (sqrt(g / (each * block.radius)) for each in (most, least))
        yield (
            f"p = {block.p:g}: with a radius of {block.radius:.4g} m the inertia about the hinge is {ratio:.3g} M R^2, "
            f"which no mechanism has; give {low:.3g} to {high:.3g} 1/s, or another radius"
        )


def _block_problems(definition: BlockMechanism, bodies: Bodies) -> Iterator[str]:
    count = len(definition.blocks)
    most = definition.number_of_blocks
    if not 1 <= count <= most or not all(definition.blocks):
        yield f"{count} blocks: give 1{f' to {most}' if most > 1 else ''}, each of one body or more"
    for body in definition.bodies:
        if body not in bodies:
            yield f'"{body}" is no body; known: {", ".join(bodies)}'


def _material_problems(bodies: Bodies) -> Iterator[str]:
    """Yield what is wrong with the masonry of a body; its density is checked with its solid."""
    for name, body in bodies.items():
        for key in ("young_modulus", "compressive_strength", "tensile_strength", "friction"):
            value = getattr(body.material, key, None)
            least = 0.0 if key in ("tensile_strength", "friction") else TINY
            if value is not None and not (is_number(value) and least <= value < inf):
                shown = f"{value:g}" if is_number(value) else repr(value)
                bound = "0 or more" if least == 0.0 else "more than 0"
                yield f'body "{name}": {key} = {shown}: give a finite number, {bound}'


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
            if reason := _fault(place, StatedPlace):
                yield f"{key}.{hinge_name} = {_value_text(place)}: {reason}"


def _hinge_form(definition: BlockMechanism) -> str:
    return f"give {', '.join('ABCD'[: HINGES[definition.number_of_blocks]])}, each a place"


def _crack_problems(definition: TwoBlock) -> Iterator[str]:
    crack = definition.crack
    if len(definition.blocks) == 2 and crack is not None:
        yield "crack: is for one body; two bodies part at their joint, so remove one of them"


def _arch_problems(definition: FourHinge) -> Iterator[str]:
    """Yield what does not suit three blocks between given hinges, or one arch whose hinges are searched for."""
    one_sided = definition.sides == "one"
    if definition.hinges != "minimum":
        if len(definition.blocks) != 3:
            yield f"{len(definition.blocks)} bodies with four hinges; give three, base first"
        if definition.hinges_negative is None and not one_sided:
            yield 'hinges_negative: missing; two-sided rocking has its own hinges each way: give them, or sides = "one"'
        if definition.hinges_negative is not None and one_sided:
            yield "hinges_negative: beside one-sided rocking; remove it"
        if definition.joints is not None:
            yield 'joints: are for an arch with hinges = "minimum"; remove one of them'
        return
    if definition.hinges_negative is not None:
        yield 'hinges_negative: are searched for too with hinges = "minimum"; remove them'
    if len(definition.blocks) != 1 or definition.joints is None:
        yield 'hinges = "minimum" needs one arch, and joints where it may open'
    if definition.loads:
        yield 'loads: not with hinges = "minimum"; give the hinges that the messages of the arch without loads list'
    joints = definition.joints
    count = joints.count if isinstance(joints, RadialJoints) else len(joints or ()) - 1
    if joints is not None and not 3 <= count <= MOST_VOUSSOIRS:
        yield f"joints: {count} voussoirs between them; give 3 to {MOST_VOUSSOIRS}"
    if isinstance(joints, RadialJoints) and joints.first == joints.last:
        yield "joints.last: is the first joint again; give the angle of the other springing"


def _number_problems(data: Any, where: str) -> Iterator[str]:
    """Yield each number that is not finite, and each that must be positive and is not; a strength may be infinite."""
    for field in fields(data):
        value, key = getattr(data, field.name), f"{where}{field.name}"
        if is_dataclass(value) and not isinstance(value, type):
            yield from _number_problems(value, f"{key}.")
        elif isinstance(value, tuple):
            yield from _entry_problems(value, key)
        elif isinstance(value, float | int) and not isinstance(value, bool):
            if not isfinite(value) and not (field.name in ("strength", "stiffness") and value > 0.0):
                yield f"{key} = {value}: not a finite number"
            elif field.name in POSITIVE and value <= 0.0:
                yield f"{key} = {value:g}: must be greater than 0"


def _entry_problems(values: tuple[Any, ...], key: str) -> Iterator[str]:
    for number, value in enumerate(values, start=1):
        if is_dataclass(value) and not isinstance(value, type):
            yield from _number_problems(value, f"{key}[{number}].")
        elif isinstance(value, tuple):
            yield from _entry_problems(value, f"{key}[{number}]")
        elif isinstance(value, float) and not isfinite(value):
            yield f"{key}[{number}] = {value}: not a finite number"


def _restitution_problems(restitution: Restitution) -> Iterator[str]:
    for value in (restitution.positive, restitution.negative):
        if isinstance(value, str) and value not in RESTITUTIONS:
            yield f"restitution = {value!r}: write a number in [0, 1], or one of {', '.join(RESTITUTIONS)}"
        if isinstance(value, float | int) and not 0.0 <= value <= 1.0:
            yield f"restitution = {value:g}: outside [0, 1]; it is velocity after over velocity before the impact"


def _direction_problems(definition: BlockMechanism) -> Iterator[str]:
    direction = definition.direction
    if direction == "sweep":
        yield from (f"{_path_text(path)}: {reason}" for path, reason in definition.sweep_faults())
    elif direction and (abs(direction[2]) > LEVEL * max(map(abs, direction)) or not any(direction[:2])):
        yield f"direction = {direction}: must be horizontal and not zero; give (x, y, 0)"


def _path_text(path: tuple[str | int, ...]) -> str:
    return "".join(f"[{step + 1}]" if isinstance(step, int) else f".{step}" for step in path).lstrip(".")


def _interface_problems(interface: Interface) -> Iterator[str]:
    given = [key for key in ("stiffness", "course_thickness") if getattr(interface, key) is not None]
    if interface.model == "rigid" and given:
        yield f'interface.{given[0]}: is for flexible interfaces; give model = "flexible", or remove it'
    if interface.model != "rigid" and len(given) != 1:
        yield "interface.stiffness: give either stiffness or course_thickness"
    if isinstance(interface.shape, Shape):
        sizes = [field.name for field in fields(Shape) if getattr(interface.shape, field.name) is not None]
        if len(sizes) != 1:
            yield f"interface.shape: one size is needed, not {len(sizes)}"


def _load_problems(definition: BlockMechanism, bodies: Bodies) -> Iterator[str]:
    """Yield the loads that no block carries, and those whose bodies cannot load it."""
    loads, known = definition.loads, ", ".join(f'"{name}"' for name in bodies)
    known = f"known: {known}; give it in `around`"
    for number, key, reason in (
        *block_faults(loads, definition.kind, number_of_blocks=definition.number_of_blocks),
        *body_faults(loads, bodies, moving=definition.bodies, known=known),
    ):
        yield f"loads[{number + 1}].{key} = {_value_text(getattr(loads[number], key))}: {reason}"


KIND_TEXTS = {float: "a number", int: "a whole number", str: "a text", bool: "True or False"}
FORMS = {
    "direction": 'give (x, y, 0), "weakest" or "sweep"',
    "cut": "give an elevation [m], a CutPlane or a CutAngle",
    "crack": 'give an elevation [m], "sorrentino" or "minimum"',
    "restitution": "give a number in [0, 1], or the name of a rule",
}
LONGEST = 60  # characters of a value in a message


def _declared_problems(data: Any, where: str = "", *, forms: Mapping[str, str] = FORMS) -> Iterator[str]:
    """Yield each field whose value is not what is declared, with what to give, and then those that do not go together.

    Parameters
    ----------
    data : a definition, a load, an interface: any frozen dataclass
    where : what stands before the names of its fields
    forms : what to give in place of a value of another form, by field, where neither a mark nor the type says it well
    """
    kind: type = type(data)
    for name, annotation in annotations_of(kind).items():
        value, key = getattr(data, name), f"{where}{name}"
        if reason := _fault(value, annotation, forms.get(name, "")):
            yield f"{key} = {_value_text(value)}: {reason}"
        else:
            yield from _nested_problems(value, key)
    for name, reason in data.faults() if hasattr(data, "faults") else ():
        value = getattr(data, name)
        yield f"{where}{name}: {reason}" if value is None else f"{where}{name} = {_value_text(value)}: {reason}"


def _nested_problems(value: Any, key: str) -> Iterator[str]:
    """Look into what a field holds: other data, and rows of them."""
    if is_dataclass(value) and not isinstance(value, type):
        yield from _declared_problems(value, f"{key}.")
    elif isinstance(value, tuple):
        for number, each in enumerate(value, start=1):
            yield from _nested_problems(each, f"{key}[{number}]")
    elif isinstance(value, Mapping):
        for name, each in value.items():
            yield from _nested_problems(each, f"{key}.{name}")


def _value_text(value: Any) -> str:
    return f"{value:g}" if is_number(value) else repr(value)[:LONGEST]


def _fault(value: Any, annotation: Any, form: str = "") -> str:
    """Return what is wrong with a value by its annotation, and what to give; empty if nothing is.

    form : the words for a value of another form; "" for those of its type
    """
    origin, inner = get_origin(annotation), get_args(annotation)
    if origin is Annotated:
        marks = [mark for mark in inner[1:] if isinstance(mark, Mark)]
        form = next((mark.form for mark in marks if mark.form), form)
        own = () if value is None else (mark.fault(value) for mark in marks)
        return _fault(value, inner[0], form) or next(filter(None, own), "")
    if not _fits(value, annotation):
        return form or f"give {_kind_text(annotation)}"
    if origin in (Union, UnionType):
        only_words = all(each is NoneType or get_origin(each) is Literal for each in inner)
        fitting = next(each for each in inner if _fits(value, each))
        return _fault(value, fitting, form or ("" if only_words else f"give {_kind_text(annotation)}"))
    if origin is Literal and value not in inner:
        return form or f"not allowed; write {one_of(inner)}"
    if origin is tuple:
        kinds = inner[:1] * len(value) if inner[-1] is Ellipsis else inner
        return next(filter(None, map(_fault, value, kinds)), "")
    return ""


def _fits(value: Any, kind: Any) -> bool:
    """Tell whether a value is of a kind; which texts are known is left to the checks of values."""
    origin, inner = get_origin(kind), get_args(kind)
    if origin is Annotated:
        return _fits(value, inner[0])
    if origin in (Union, UnionType):
        return any(_fits(value, each) for each in inner)
    if origin is Literal:
        return isinstance(value, tuple({type(each) for each in inner}))
    if origin is tuple:
        return isinstance(value, tuple) and _row_fits(value, inner)
    if origin is not None:
        return isinstance(value, origin) and all(_fits(each, inner[1]) for each in value.values())
    if kind in (float, int):
        return is_number(value) and (kind is float or isinstance(value, Integral))
    return kind is Any or isinstance(value, (bool, np.bool_) if kind is bool else kind)


def _row_fits(values: tuple[Any, ...], kinds: tuple[Any, ...]) -> bool:
    if kinds[-1] is Ellipsis:
        return all(_fits(each, kinds[0]) for each in values)
    return len(values) == len(kinds) and all(map(_fits, values, kinds))


def _kind_text(kind: Any) -> str:
    """Say what a kind of value is, without the None that leaves it out."""
    origin, inner = get_origin(kind), get_args(kind)
    if origin is Annotated:
        return _kind_text(inner[0])
    if origin in (Union, UnionType):
        return " or ".join(dict.fromkeys(_kind_text(each) for each in inner if each is not NoneType))
    if origin is Literal:
        return " or ".join(f'"{each}"' for each in inner)
    if origin is tuple and inner[-1] is Ellipsis:
        return f"a list, each {_kind_text(inner[0])}"
    if origin is tuple:
        return f"({', '.join(_kind_text(each).removeprefix('a ') for each in inner)})"
    if origin is not None:
        return f"a table of names, each {_kind_text(inner[1])}"
    name: str = kind.__name__
    return KIND_TEXTS.get(kind, f"{'an' if name[0] in 'AEIOU' else 'a'} {name}")


Data = TypeVar("Data")

COUNTS = ("block", "construction", "count")
"""The whole numbers of a definition: which block, which case, how many."""


def with_floats(data: Data) -> Data:
    """Return a definition whose lengths and masses are floats and whose places are tuples, however they were given."""
    changed = {
        field.name: as_floats(getattr(data, field.name))
        for field in fields(data)  # type: ignore[arg-type]
        if field.init and field.name not in COUNTS
    }
    return replace(data, **changed)  # type: ignore[type-var]


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
