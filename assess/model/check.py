"""What a definition must hold before it can become a mechanism; a project file says the same by its schema."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from math import inf, isfinite, pi, sqrt
from numbers import Real
from typing import Any

from scipy.constants import g

from assess.errors import MechanismError
from assess.interfaces.definition import Interface, Shape
from assess.mechanisms.chain import HINGES
from assess.model.body import Bodies
from assess.model.check_loads import load_problems, place_problems
from assess.model.definitions import (
    Chained,
    CutAngle,
    CutPlane,
    Definition,
    EquivalentBlock,
    FourHinge,
    RadialJoints,
    Restitution,
    TwoBlock,
)
from assess.model.ranges import CRACKS, INERTIA_RATIOS, MOST_VOUSSOIRS, RESTITUTIONS

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
TINY = 5e-324  # the least number above 0
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
        yield from _parameters(definition)
        return
    yield from _blocks(definition, bodies)
    yield from _materials(bodies)
    yield from _direction(definition)
    yield from _cut(definition)
    yield from _hinges(definition)
    if isinstance(definition, TwoBlock):
        yield from _crack(definition)
    if isinstance(definition, FourHinge):
        yield from _arch(definition)
    for letter in set(definition.interfaces) - set("ABCD"[: HINGES[definition.moving]]):
        yield f"interfaces.{letter}: no such hinge; known: {', '.join('ABCD'[: HINGES[definition.moving]])}"
    for interface in (definition.interface, *definition.interfaces.values()):
        yield from _interface(interface)
    for number, load in enumerate(definition.loads, start=1):
        yield from (f"loads[{number}]: {problem}" for problem in load_problems(load, definition, bodies))


def _parameters(block: EquivalentBlock) -> Iterator[str]:
    """Yield what is wrong with published parameters: an angle, and an inertia that no mechanism has."""
    if not block.uplift < pi / 2.0:
        yield f"uplift = {block.uplift:g}: must be less than pi / 2; it is taken as the slenderness [rad]"
    least, most = INERTIA_RATIOS
    ratio = g / (block.p**2 * block.radius)
    if not least <= ratio <= most:
        low, high = (sqrt(g / (each * block.radius)) for each in (most, least))
        yield (
            f"p = {block.p:g}: with a radius of {block.radius:.4g} m the inertia about the hinge is {ratio:.3g} M R^2, "
            f"which no mechanism has; give {low:.3g} to {high:.3g} 1/s, or another radius"
        )


def _blocks(definition: Chained, bodies: Bodies) -> Iterator[str]:
    count = len(definition.blocks)
    most = definition.moving
    if not 1 <= count <= most or not all(definition.blocks):
        yield f"{count} blocks: give 1{f' to {most}' if most > 1 else ''}, each of one body or more"
    for body in definition.bodies:
        if body not in bodies:
            yield f'"{body}" is no body; known: {", ".join(bodies)}'


def _materials(bodies: Bodies) -> Iterator[str]:
    """Yield what is wrong with the masonry of a body; its density is checked with its solid."""
    for name, body in bodies.items():
        for key in ("young_modulus", "compressive_strength", "tensile_strength", "friction"):
            value = getattr(body.material, key, None)
            least = 0.0 if key in ("tensile_strength", "friction") else TINY
            if value is not None and not least <= value < inf:
                bound = "0 or more" if least == 0.0 else "more than 0"
                yield f'body "{name}": {key} = {value:g}: give a finite number, {bound}'


def _cut(definition: Chained) -> Iterator[str]:
    cut = definition.cut
    if cut is not None and not isinstance(cut, Real | CutPlane | CutAngle):
        yield f"cut = {cut!r}: give an elevation [m], a CutPlane or a CutAngle"


def _hinges(definition: Chained) -> Iterator[str]:
    """Yield what is wrong with given hinges: their number, and places that are none."""
    count = HINGES[definition.moving]
    for key in ("hinges", "hinges_negative"):
        hinges = getattr(definition, key)
        if hinges is None or (hinges == "minimum" and key == "hinges" and isinstance(definition, FourHinge)):
            continue
        if isinstance(hinges, str) or len(hinges) != count:
            yield f"{key} = {hinges!r}: give {', '.join('ABCD'[:count])}, each a place"
            continue
        for letter, place in zip("ABCD", hinges, strict=False):
            yield from place_problems(f"{key}.{letter}", place)


def _crack(definition: TwoBlock) -> Iterator[str]:
    crack = definition.crack
    if len(definition.blocks) == 2 and crack is not None:
        yield "crack: is for one body; two bodies part at their joint, so remove one of them"
    if crack not in (None, *CRACKS) and not isinstance(crack, Real):
        yield f"crack = {crack!r}: give an elevation, or one of {', '.join(CRACKS)}"


def _arch(definition: FourHinge) -> Iterator[str]:
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
        if isinstance(value, str) and value not in RESTITUTIONS:
            yield f"restitution = {value!r}: write a number in [0, 1], or one of {', '.join(RESTITUTIONS)}"
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
