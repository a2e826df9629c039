"""The tables [mechanisms.NAME]."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Literal

from pydantic import (
    AfterValidator,
    BeforeValidator,
    Discriminator,
    Field,
    StrictBool,
    StrictInt,
    StrictStr,
    Tag,
    WithJsonSchema,
    model_validator,
)

from assess.project.quantities import (
    AnyDirection,
    Direction,
    Length,
    Name,
    Point,
    PositiveForce,
    PositiveLength,
    PositiveMass,
    PositiveRate,
    Ratio,
    SpacePoint,
    Uplift,
    unique,
)
from assess.project.section import Section, listed, wrong
from assess.project.units import KINDS, si_value

MECHANISMS = ("single-block", "equivalent-block")
RESTITUTIONS = ("thesis", "housner", "sorrentino", "momentum")


def _restitution(value: Any) -> float | str:
    if isinstance(value, str):
        if value not in RESTITUTIONS:
            raise ValueError(f"not a known restitution; write a number in [0, 1] or one of {listed(RESTITUTIONS)}")
        return value
    number = si_value(value, KINDS["ratio"])
    if not 0.0 <= number <= 1.0:
        raise ValueError("outside [0, 1]; restitution is velocity after over velocity before the impact")
    return number


RestitutionValue = Annotated[
    float | Literal["thesis", "housner", "sorrentino", "momentum"],
    BeforeValidator(_restitution),
    Field(description='a number in [0, 1], or "thesis", "housner", "sorrentino", "momentum"'),
]


BlockIndex = Annotated[StrictInt, Field(ge=0, le=0)]


def _force(value: Any) -> tuple[float, float] | float:
    """Two components, or the size of a force."""
    if not isinstance(value, list | tuple):
        size = si_value(value, KINDS["force"])
        if size <= 0:
            raise ValueError("must be greater than 0; turn its direction instead")
        return size
    if len(value) != 2:
        raise ValueError("not a force; write [along the direction, up], or a size with direction")
    return si_value(value[0], KINDS["force"]), si_value(value[1], KINDS["force"])


GivenForce = Annotated[
    tuple[float, float] | float,
    BeforeValidator(_force),
    WithJsonSchema({"description": 'like "10 kN" with a direction, or ["8 kN", "-3 kN"]: along the direction, up'}),
]


class Restitution(Section):
    """Velocity after over velocity before the impact that ends a rotation, for each direction."""

    positive: RestitutionValue = "thesis"
    negative: RestitutionValue = "thesis"

    @model_validator(mode="before")
    @classmethod
    def _one_for_both(cls, value: Any) -> Any:
        return value if isinstance(value, dict | Restitution) else {"positive": value, "negative": value}


class Hinges(Section):
    """Where a block turns: [x, y, z], or [distance along the direction, elevation]."""

    A: Point
    """the base hinge"""


class CutPlane(Section):
    """An inclined crack."""

    point: SpacePoint
    """a point of the plane [x, y, z]"""
    normal: tuple[Ratio, Ratio, Ratio]
    """square to the plane, to the side that moves: [nx, ny, nz] with nz > 0"""


Cut = Annotated[
    Annotated[Length, Tag("<elevation>")] | Annotated[CutPlane, Tag("<plane>")],
    Discriminator(lambda value: "<plane>" if isinstance(value, dict | CutPlane) else "<elevation>"),
]


def _block_names(value: Any) -> Any:
    """Each entry of `blocks` as a tuple of bodies that move as one."""
    return [[entry] if isinstance(entry, str) else entry for entry in value] if isinstance(value, list) else value


BlockNames = Annotated[tuple[Name, ...], Field(min_length=1), AfterValidator(unique("body"))]


class MassLoad(Section):
    """A point mass: a floor, a roof, a wall that moves with the block."""

    kind: Literal["mass"]
    """"mass\""""
    mass: PositiveMass
    """like "1200 kg\""""
    at: Point
    """[x, y, z], or [distance along the direction, elevation]"""
    bearing: StrictBool = True
    """true: weight and inertia; false: its weight is carried elsewhere, horizontal inertia only"""
    block: BlockIndex = 0
    """which block it acts on, from 0 at the base"""


class ForceLoad(Section):
    """A dead force: the thrust of a vault or roof."""

    kind: Literal["force"]
    """"force\""""
    force: GivenForce
    """[along the direction, up], or a size with `direction`"""
    at: Point
    """[x, y, z], or [distance along the direction, elevation]"""
    direction: AnyDirection | None = None
    """where a force given by its size points: [x, y, z], or [along the direction, up]"""
    block: BlockIndex = 0
    """which block it acts on, from 0 at the base"""

    @model_validator(mode="after")
    def _size_has_a_direction(self) -> ForceLoad:
        if isinstance(self.force, float) and self.direction is None:
            raise wrong("direction", "missing; a force given by its size needs one, or write force = [x, z]")
        if not isinstance(self.force, float) and self.direction is not None:
            raise wrong("direction", "beside components of the force; remove one of them")
        return self


class TieLoad(Section):
    """A tie of constant pretension; slack on the branch where it shortens."""

    kind: Literal["tie"]
    """"tie\""""
    force: PositiveForce
    """pretension, like "30 kN\""""
    at: Point
    """where it holds the block: [x, y, z], or [distance along the direction, elevation]"""
    direction: AnyDirection | None = None
    """the way it pulls: [x, y, z], or [along the direction, up]; or give anchor"""
    anchor: Point | None = None
    """the fixed end: [x, y, z], or [distance along the direction, elevation]"""
    both: StrictBool = False
    """true: taut on both branches"""
    block: BlockIndex = 0
    """which block it acts on, from 0 at the base"""

    @model_validator(mode="after")
    def _one_way_to_pull(self) -> TieLoad:
        if (self.direction is None) == (self.anchor is None):
            raise wrong("anchor", "give either anchor or direction, the way the tie pulls")
        return self


LoadTable = MassLoad | ForceLoad | TieLoad
LOADS = ("mass", "force", "tie")


def _load_tag(values: Any) -> str | None:
    kind = values.get("kind") if isinstance(values, dict) else None
    return f"<{kind}>" if kind in LOADS else None


LoadSection = Annotated[
    Annotated[MassLoad, Tag("<mass>")] | Annotated[ForceLoad, Tag("<force>")] | Annotated[TieLoad, Tag("<tie>")],
    Discriminator(
        _load_tag,
        custom_error_type="project",
        custom_error_message="{reason}",
        custom_error_context={"key": ("kind",), "reason": f"not a supported load; write one of {listed(LOADS)}"},
    ),
]


class SingleBlock(Section):
    """One block that rocks about its base."""

    planned: ClassVar[Mapping[str, str]] = {
        "interface": "the interface is rigid; remove it",
        "interfaces": "the interface is rigid; remove it",
        "amplification": "histories act on the mechanism's base as they are; remove it",
    }

    kind: Literal["single-block"]
    """"single-block\""""
    blocks: Annotated[tuple[BlockNames, ...], BeforeValidator(_block_names), Field(min_length=1, max_length=1)]
    """the body that rocks, ["wall"], or several that move as one, [["wall", "buttress"]]"""
    label: StrictStr = ""
    """what the report calls it; the name of the table if absent"""
    direction: Direction = (1.0, 0.0, 0.0)
    """horizontal; positive rotation topples this way"""
    cut: Cut | None = None
    """only what lies above moves: an elevation like "4.77 m", or { point, normal } of an inclined crack"""
    sides: Literal["one", "two"] = "two"
    """"two", or "one": positive rotation only, the building behind stops the other"""
    hinges: Hinges | None = None
    """hinge of positive rotation; the extreme line of the base (of the cut) if absent"""
    hinges_negative: Hinges | None = None
    """hinge of negative rotation; the extreme line of the base (of the cut) if absent"""
    loads: tuple[LoadSection, ...] = ()
    """[ { kind = "mass" | "force" | "tie", … }, … ]"""
    restitution: Restitution = Field(default_factory=Restitution)
    """a number in [0, 1], a name, or { positive, negative }"""


class EquivalentBlock(Section):
    """A mechanism by its rocking parameters, as published tables give them."""

    planned: ClassVar[Mapping[str, str]] = {
        "amplification": "histories act on the mechanism's base as they are; remove it"
    }

    kind: Literal["equivalent-block"]
    """"equivalent-block\""""
    p: PositiveRate
    """frequency parameter, like "1.60 1/s\""""
    uplift: Uplift
    """multiplier that starts rocking, taken as the slenderness [rad], like 0.14"""
    radius: PositiveLength
    """distance from hinge to centre of mass, like "2.84 m\""""
    label: StrictStr = ""
    """what the report calls it; the name of the table if absent"""
    sides: Literal["one", "two"] = "two"
    """"two", or "one": positive rotation only, the building behind stops the other"""
    restitution: Restitution = Field(default_factory=Restitution)
    """a number in [0, 1], a name, or { positive, negative }"""
    mass: PositiveMass = 1.0
    """mass of the mechanism"""
    elevation: Length = 0.0
    """of the mechanism's base, in the coordinates of the bodies"""


Mechanism = SingleBlock | EquivalentBlock


def _mechanism_tag(values: Any) -> str | None:
    kind = values.get("kind") if isinstance(values, dict) else None
    return f"<{kind}>" if kind in MECHANISMS else None


MechanismSection = Annotated[
    Annotated[SingleBlock, Tag("<single-block>")] | Annotated[EquivalentBlock, Tag("<equivalent-block>")],
    Discriminator(
        _mechanism_tag,
        custom_error_type="choice",
        custom_error_message="write one of {names}",
        custom_error_context={"key": ("kind",), "names": listed(MECHANISMS)},
    ),
]
