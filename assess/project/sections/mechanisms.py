"""The tables [mechanisms.NAME]."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Literal

from pydantic import AfterValidator, BeforeValidator, Discriminator, Field, StrictStr, Tag, model_validator

from assess.project.quantities import (
    Direction,
    Length,
    Name,
    Point,
    PositiveLength,
    PositiveMass,
    PositiveRate,
    Ratio,
    SpacePoint,
    Uplift,
    unique,
)
from assess.project.section import Section, listed
from assess.project.sections.loads import LoadSection
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
