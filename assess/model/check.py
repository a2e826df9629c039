"""What a definition must hold before it can become a mechanism; a project file says the same by its schema."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass, replace
from math import inf, isfinite, pi, sqrt
from numbers import Real
from typing import Any, TypeVar

import numpy as np
from scipy.constants import g

from assess.declaration import StatedPlace
from assess.errors import MechanismError
from assess.faults import declared_problems, text_of_value, value_fault
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
    yield from declared_problems(definition, forms=FORMS | by_kind)
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
            if reason := value_fault(place, StatedPlace):
                yield f"{key}.{hinge_name} = {text_of_value(place)}: {reason}"


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
        yield f"loads[{number + 1}].{key} = {text_of_value(getattr(loads[number], key))}: {reason}"


FORMS = {
    "direction": 'give (x, y, 0), "weakest" or "sweep"',
    "cut": "give an elevation [m], a CutPlane or a CutAngle",
    "crack": 'give an elevation [m], "sorrentino" or "minimum"',
    "restitution": "give a number in [0, 1], or the name of a rule",
}


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
