"""What a definition must hold before it can become a mechanism; a project file says the same by its schema."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from math import inf, isfinite, pi, sqrt
from numbers import Integral, Real
from types import NoneType, UnionType
from typing import Any, Literal, TypeVar, Union, get_args, get_origin, get_type_hints

import numpy as np
from scipy.constants import g

from assess.errors import MechanismError
from assess.interfaces.contact import Interface, JointModel
from assess.interfaces.section import Shape
from assess.loads.load import BodyLoad, ForceLoad, LoadDefinition, MassLoad, OverburdenLoad, TieLoad, bodies_of
from assess.mechanisms.chain import HINGES
from assess.mechanisms.four_hinge import MOST_VOUSSOIRS, FourHinge, RadialJoints
from assess.mechanisms.kinds import Definition
from assess.mechanisms.mechanism import BlockMechanism, CutAngle, CutPlane
from assess.mechanisms.restitution import RESTITUTIONS, Restitution
from assess.mechanisms.single_block import INERTIA_RATIOS, EquivalentBlock
from assess.mechanisms.two_block import CRACKS, TwoBlock
from assess.model.bodies import Bodies
from spectra.arrays import is_number

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
    yield from type_problems(definition)
    yield from _number_problems(definition, "")
    yield from _restitution_problems(definition.restitution)
    if definition.sides not in ("one", "two", None):
        yield f'sides = {definition.sides!r}: write "one" or "two"'
    if isinstance(definition, EquivalentBlock):
        yield from _parameter_problems(definition)
        return
    yield from _block_problems(definition, bodies)
    yield from _material_problems(bodies)
    yield from _direction_problems(definition)
    yield from _cut_problems(definition)
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
    for number, load in enumerate(definition.loads, start=1):
        yield from (f"loads[{number}]: {problem}" for problem in load_problems(load, definition, bodies))


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


def _cut_problems(definition: BlockMechanism) -> Iterator[str]:
    cut = definition.cut
    if cut is not None and not isinstance(cut, Real | CutPlane | CutAngle):
        yield f"cut = {cut!r}: give an elevation [m], a CutPlane or a CutAngle"


def _hinge_problems(definition: BlockMechanism) -> Iterator[str]:
    """Yield what is wrong with given hinges: their number, and places that are none."""
    count = HINGES[definition.number_of_blocks]
    for key in ("hinges", "hinges_negative"):
        hinges = getattr(definition, key)
        if hinges is None or (hinges == "minimum" and key == "hinges" and isinstance(definition, FourHinge)):
            continue
        if isinstance(hinges, str) or len(hinges) != count:
            yield f"{key} = {hinges!r}: give {', '.join('ABCD'[:count])}, each a place"
            continue
        for hinge_name, place in zip("ABCD", hinges, strict=False):
            yield from place_problems(f"{key}.{hinge_name}", place)


def _crack_problems(definition: TwoBlock) -> Iterator[str]:
    crack = definition.crack
    if len(definition.blocks) == 2 and crack is not None:
        yield "crack: is for one body; two bodies part at their joint, so remove one of them"
    if crack not in (None, *CRACKS) and not isinstance(crack, Real):
        yield f"crack = {crack!r}: give an elevation, or one of {', '.join(CRACKS)}"


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
                yield f"{key} = {value}: give a finite number"
            elif field.name in POSITIVE and value <= 0.0:
                yield f"{key} = {value:g}: must be greater than 0"


def _entry_problems(values: tuple[Any, ...], key: str) -> Iterator[str]:
    for number, value in enumerate(values, start=1):
        if is_dataclass(value) and not isinstance(value, type):
            yield from _number_problems(value, f"{key}[{number}].")
        elif isinstance(value, tuple):
            yield from _entry_problems(value, f"{key}[{number}]")
        elif isinstance(value, float) and not isfinite(value):
            yield f"{key}[{number}] = {value}: give a finite number"


def _restitution_problems(restitution: Restitution) -> Iterator[str]:
    for value in (restitution.positive, restitution.negative):
        if isinstance(value, str) and value not in RESTITUTIONS:
            yield f"restitution = {value!r}: write a number in [0, 1], or one of {', '.join(RESTITUTIONS)}"
        if isinstance(value, float | int) and not 0.0 <= value <= 1.0:
            yield f"restitution = {value:g}: outside [0, 1]; it is velocity after over velocity before the impact"


def _direction_problems(definition: BlockMechanism) -> Iterator[str]:
    direction = definition.direction
    if direction is None or direction == "sweep":
        return
    if isinstance(direction, str) or len(direction) != 3:
        yield f'direction = {direction!r}: give (x, y, 0), "weakest" or "sweep"'
    elif abs(direction[2]) > LEVEL * max(map(abs, direction)) or not any(direction[:2]):
        yield f"direction = {direction}: must be horizontal and not zero; give (x, y, 0)"


def _interface_problems(interface: Interface) -> Iterator[str]:
    if interface.model not in get_args(JointModel):
        yield f"interface.model = {interface.model!r}: write one of {', '.join(get_args(JointModel))}"
    given = [key for key in ("stiffness", "course_thickness") if getattr(interface, key) is not None]
    if interface.model == "rigid" and given:
        yield f'interface.{given[0]}: is for flexible interfaces; give model = "flexible", or remove it'
    if interface.model != "rigid" and len(given) != 1:
        yield "interface.stiffness: give either stiffness or course_thickness"
    if interface.shape != "outline" and not isinstance(interface.shape, Shape):
        yield f'interface.shape = {interface.shape!r}: give "outline" or a Shape'
    if isinstance(interface.shape, Shape):
        sizes = [field.name for field in fields(Shape) if getattr(interface.shape, field.name) is not None]
        if len(sizes) != 1:
            yield f"interface.shape: one size is needed, not {len(sizes)}"


ROLES = ("floor", "roof", "vault")
VAULTS = ("barrel", "quadripartite", None)
CONSTRUCTIONS = (1, 2, 3, 4, 5, None)  # Ungewitter's cases
OF_THRUST = ("thrust", "span", "rise", "tied")
OF_VAULTS = ("vault", "construction", "fill")
LEAVES_OUT = {"thrust": ("tied", "span", "rise"), "mass": ("construction", "fill")}  # a number, and what it replaces


def load_problems(load: LoadDefinition, definition: BlockMechanism, bodies: Bodies) -> Iterator[str]:
    """Yield what is wrong with a load, each with what to give.

    Parameters
    ----------
    load : as stated
    definition : the mechanism that it is a load of
    bodies : the bodies that it may name
    """
    if not isinstance(load, LoadDefinition):
        yield f"{load!r} is no load; give {', '.join(kind.__name__ for kind in get_args(LoadDefinition))}"
        return
    unknown = [body for body in bodies_of(load) if body not in bodies]
    if unknown:
        yield f'"{unknown[0]}" is no body here; give it in `around`'
    if not isinstance(load, OverburdenLoad):
        if load.block is not None and load.block not in range(definition.number_of_blocks):
            yield f"block = {load.block}: must be from 0 to {definition.number_of_blocks - 1}, counted from the base"
        if load.at is not None:
            yield from place_problems("at", load.at)
    yield from PROBLEMS_BY_KIND[type(load)](load, definition)


def place_problems(key: str, place: Any) -> Iterator[str]:
    """Yield what is wrong with a place or a direction: it has two or three numbers."""
    if not isinstance(place, tuple) or len(place) not in (2, 3) or not all(isinstance(each, Real) for each in place):
        yield f"{key} = {place!r}: give (x, y, z), or (along the direction, up)"


def _mass_problems(load: MassLoad, definition: BlockMechanism) -> Iterator[str]:
    if load.seat is not None and not load.bearing:
        yield "seat: only what bears on the block has a seat; remove it, or give bearing = True"


def _force_problems(load: ForceLoad, definition: BlockMechanism) -> Iterator[str]:
    if isinstance(load.force, tuple) != (load.direction is None):
        yield "give the force by its two components, or its size with a direction"
    elif isinstance(load.force, tuple):
        if len(load.force) != 2:
            yield f"force = {load.force}: give (along the direction, up), or a size with a direction"
    elif not load.force > 0.0:
        yield f"force = {load.force:g}: must be greater than 0; turn its direction instead"
    yield from _pull_problems(load)


def _tie_problems(load: TieLoad, definition: BlockMechanism) -> Iterator[str]:
    if (load.direction is None) == (load.anchor is None):
        yield "give either anchor or direction, the way the tie pulls"
    if not load.force > 0.0:
        yield f"force = {load.force:g}: must be greater than 0; it is the pretension"
    if load.anchor is not None:
        yield from place_problems("anchor", load.anchor)
    yield from _pull_problems(load)


def _pull_problems(load: ForceLoad | TieLoad) -> Iterator[str]:
    """Yield what is wrong with the direction and the end of a force or a tie."""
    if load.direction is not None:
        yield from place_problems("direction", load.direction)
        if not any(load.direction):
            yield f"direction = {load.direction}: must not be zero"
    until = load.until
    if until not in (None, "collapse") and not (isinstance(until, Real) and until > 0.0):
        yield f'until = {until!r}: give the displacement of its point at which it ends, above 0, or "collapse"'


def _overburden_problems(load: OverburdenLoad, definition: BlockMechanism) -> Iterator[str]:
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


def _body_problems(load: BodyLoad, definition: BlockMechanism) -> Iterator[str]:
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


PROBLEMS_BY_KIND: dict[type[Any], Callable[[Any, BlockMechanism], Iterator[str]]] = {
    MassLoad: _mass_problems,
    ForceLoad: _force_problems,
    TieLoad: _tie_problems,
    OverburdenLoad: _overburden_problems,
    BodyLoad: _body_problems,
}
KIND_TEXTS = {float: "a number", int: "a whole number", str: "a text", bool: "True or False"}
PLACE = "(x, y, z), or (along the direction, up)"

REMEDIES = {
    "at": PLACE,
    "anchor": PLACE,
    "direction": '(x, y, 0), "weakest" or "sweep"',
    "cut": "an elevation [m], a CutPlane or a CutAngle",
    "crack": 'an elevation [m], "sorrentino" or "minimum"',
    "hinges": f"the hinges from A on, each {PLACE}",
    "hinges_negative": f"the hinges from A on, each {PLACE}",
    "restitution": "a number in [0, 1], or the name of a rule",
}
LONGEST = 60  # characters of a value in a message


def type_problems(data: Any, where: str = "") -> Iterator[str]:
    """Yield each field whose value is of another kind than its annotation says, with what to give.

    Parameters
    ----------
    data : a definition, a load, an interface: any frozen dataclass
    where : what stands before the names of its fields
    """
    for name, kind in _annotations(type(data)).items():
        value, key = getattr(data, name), f"{where}{name}"
        if _fits(value, kind):
            yield from _nested_type_problems(value, key)
        else:
            remedy = PLACE if where and name == "direction" else REMEDIES.get(name)
            yield f"{key} = {repr(value)[:LONGEST]}: give {remedy or _kind_text(kind)}"


def _nested_type_problems(value: Any, key: str) -> Iterator[str]:
    """Look into what a field holds: other data, and rows of them."""
    if is_dataclass(value) and not isinstance(value, type):
        yield from type_problems(value, f"{key}.")
    elif isinstance(value, tuple):
        for number, each in enumerate(value, start=1):
            yield from _nested_type_problems(each, f"{key}[{number}]")
    elif isinstance(value, Mapping):
        for name, each in value.items():
            yield from _nested_type_problems(each, f"{key}.{name}")


def _annotations(of: Any) -> dict[str, Any]:
    """Return the annotation of each field of a class."""
    hints = get_type_hints(of)
    return {field.name: hints[field.name] for field in fields(of)}


def _fits(value: Any, kind: Any) -> bool:
    """Tell whether a value is of a kind; which texts are known is left to the checks of values."""
    origin, inner = get_origin(kind), get_args(kind)
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
