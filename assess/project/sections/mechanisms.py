"""The tables [mechanisms.NAME]."""

from __future__ import annotations

from math import sqrt
from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import (
    AfterValidator,
    BeforeValidator,
    Discriminator,
    Field,
    StrictStr,
    Tag,
    WithJsonSchema,
    model_validator,
)
from scipy.constants import g

from assess.mechanisms.chain import HINGES
from assess.model.definitions import keys_along_direction
from assess.model.ranges import INERTIA_RATIOS
from assess.project.quantities import (
    Length,
    Name,
    PositiveLength,
    PositiveMass,
    PositiveRate,
    SoughtDirection,
    Uplift,
    unique,
)
from assess.project.report_texts import ItemKeys
from assess.project.section import Section, quote_names, wrong
from assess.project.sections.amplification import AmplificationSection, NoAmplification
from assess.project.sections.cuts import Crack, Cut
from assess.project.sections.hinges import ArchHinges, FourHinges, Hinges, Joints, ThreeHinges
from assess.project.sections.interfaces import Interface, Letter
from assess.project.sections.loads import LoadSection, OverburdenLoad
from assess.project.sections.restitution import ONE_FOR_BOTH, Restitution
from assess.project.sections.uncertain_number import UNCERTAIN, UNCERTAIN_RESTITUTION, UNCERTAIN_UPLIFT

MECHANISMS = ("single-block", "two-block", "four-hinge", "equivalent-block")


def _block_names(value: Any) -> Any:
    """Write each entry of `blocks` as a list of bodies that move as one."""
    return [[entry] if isinstance(entry, str) else entry for entry in value] if isinstance(value, list) else value


BlockNames = Annotated[
    tuple[Name, ...],
    Field(min_length=1),
    AfterValidator(unique("body")),
    WithJsonSchema({"anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}, "minItems": 1}]}),
]


Blocks = Annotated[tuple[BlockNames, ...], BeforeValidator(_block_names)]


class Chained(Section):
    """What all mechanisms of blocks share."""

    moving: ClassVar[int] = 1
    blocks: Blocks
    """bodies from the base on; an entry may join several that move as one, [["wall", "buttress"]]"""
    label: StrictStr = ""
    """what the report calls it; the name of the table if absent"""
    direction: SoughtDirection | None = None
    """horizontal, positive rotation topples this way; the weakest if absent (four-hinge: +x); or "sweep\""""
    cut: Cut | None = None
    """only what lies above moves: an elevation like "4.77 m", or a crack, { point, normal } or { point, angle }"""
    sides: Literal["one", "two"] | None = None
    """"two", or "one": positive rotation only, the building behind stops the other; if absent, as bodies touch it"""
    loads: tuple[LoadSection, ...] = ()
    """[ { kind = "mass" | "force" | "tie" | "overburden" | "body", … }, … ]"""
    restitution: Annotated[Restitution, ONE_FOR_BOTH, UNCERTAIN_RESTITUTION] = Field(default_factory=Restitution)
    """a number in [0, 1], a name, or { positive, negative }"""
    interface: Interface = Field(default_factory=Interface)
    """what the hinges press on: { model = "flexible", stiffness = "10 GPa/m", strength, shape }"""
    interfaces: dict[Letter, Interface] = Field(default_factory=dict)
    """the same for single hinges of a chain, { A = { … }, B = { … } }"""
    amplification: AmplificationSection = Field(default_factory=NoAmplification)
    """{ method = "srss" | "modal-filter" | "ec8" | "nzs1170.5" | …, height, … }: the motion's way up to its base"""
    base_elevation: Length | None = None
    """of its base above the ground, where it is drawn alone and not in its place"""
    examines: ItemKeys | None = None
    """what of the report's list of possible mechanisms it examines, like "gable"; if absent, as its kind tells"""

    @model_validator(mode="after")
    def _interfaces_are_at_hinges(self) -> Self:
        known = "ABCD"[: HINGES[self.moving]]
        for letter in self.interfaces:
            if letter not in known:
                raise wrong(("interfaces", letter), f"no such hinge; known: {', '.join(known)}")
        return self

    def points(self) -> dict[str, tuple[tuple[float, ...], ...] | None]:
        """The hinges that are given as points, from A on, by key."""
        given = {key: getattr(self, key, None) for key in ("hinges", "hinges_negative")}
        return {key: tuple(at for _, at in each) if isinstance(each, Hinges) else None for key, each in given.items()}

    @model_validator(mode="after")
    def _nothing_turns_with_a_sought_direction(self) -> Self:
        if self.direction != "sweep":
            return self
        for key in keys_along_direction(self, hinges=self.points()):
            of = "an eccentricity depends" if key[-1] == "eccentricity" else "two numbers depend"
            raise wrong(key, f'{of} on the direction, which is "sweep"; give three numbers, or the direction')
        return self

    @model_validator(mode="after")
    def _loads_find_their_block(self) -> Self:
        last = self.moving - 1
        for number, load in enumerate(self.loads):
            if isinstance(load, OverburdenLoad):
                if not isinstance(self, TwoBlock):
                    raise wrong(("loads", number, "kind"), "is for two-block mechanisms; use a mass or a force")
            elif load.block is not None and load.block > last:
                raise wrong(("loads", number, "block"), f"must be {last} or less, counted from 0 at the base")
        return self


class SingleBlock(Chained):
    """One block that rocks about its base."""

    kind: Literal["single-block"]
    """"single-block\""""
    blocks: Annotated[Blocks, Field(min_length=1, max_length=1)]
    """the body that rocks, ["wall"], or several that move as one, [["wall", "buttress"]]"""
    hinges: Hinges | None = None
    """hinge of positive rotation; the extreme line of the base (of the cut) if absent"""
    hinges_negative: Hinges | None = None
    """hinge of negative rotation; the extreme line of the base (of the cut) if absent"""


class TwoBlock(Chained):
    """A wall held at its base and its top that opens at a crack between."""

    moving: ClassVar[int] = 2
    kind: Literal["two-block"]
    """"two-block\""""
    blocks: Annotated[Blocks, Field(min_length=1, max_length=2)]
    """one body, cut at the crack, or two, the lower first"""
    hinges: ThreeHinges | None = None
    """hinges of positive rotation; the edges of base, crack and top if absent"""
    hinges_negative: ThreeHinges | None = None
    """hinges of negative rotation; the edges of base, crack and top if absent"""
    crack: Crack | None = None
    """"sorrentino" (eq. 3.27), "minimum" (least uplift multiplier), or an elevation; hinge B's if hinges are given"""

    @model_validator(mode="after")
    def _one_body_cracks(self) -> Self:
        if len(self.blocks) == 2 and self.crack is not None:
            raise wrong("crack", "is for one body; two bodies part at their joint, so remove one of them")
        return self


class FourHinge(Chained):
    """Three blocks between two fixed hinges: portal, frame, arch, side-aisle vault, belfry."""

    moving: ClassVar[int] = 3
    kind: Literal["four-hinge"]
    """"four-hinge\""""
    blocks: Annotated[Blocks, Field(min_length=1, max_length=3)]
    """the bodies A-B, B-C and C-D; or one arch, with joints and hinges = "minimum\""""
    hinges: ArchHinges
    """hinges A, B, C, D of positive rotation, or "minimum": where the arch resists least"""
    hinges_negative: FourHinges | None = None
    """hinges A, B, C, D of negative rotation"""
    joints: Joints | None = None
    """of an arch, in order: [[[x, z], [x, z]], …], or { centre, first, last, count } for radial ones"""

    @model_validator(mode="after")
    def _hinges_suit_the_bodies(self) -> Self:
        if self.hinges != "minimum":
            if len(self.blocks) != 3:
                raise wrong("blocks", f"{len(self.blocks)} of them with four hinges; name three, base first")
            if (self.hinges_negative is None) == (self.sides != "one"):
                two, one = (
                    'missing; two-sided rocking has hinges of its own each way: give them, or sides = "one"',
                    "beside one-sided rocking; remove it",
                )
                raise wrong("hinges_negative", two if self.sides != "one" else one)
            if self.joints is not None:
                raise wrong("joints", 'are for an arch with hinges = "minimum"; remove one of them')
            return self
        if self.hinges_negative is not None:
            raise wrong("hinges_negative", 'are looked for too with hinges = "minimum"; remove them')
        if len(self.blocks) != 1 or self.joints is None:
            raise wrong("joints", 'hinges = "minimum" needs one arch in blocks, and joints where it may open')
        if self.loads:
            raise wrong("loads", 'not with hinges = "minimum"; write the hinges that `assess check` prints')
        return self


class EquivalentBlock(Section):
    """A mechanism by its rocking parameters, as published tables give them."""

    kind: Literal["equivalent-block"]
    """"equivalent-block\""""
    p: Annotated[PositiveRate, UNCERTAIN]
    """frequency parameter, like "1.60 1/s\""""
    uplift: Annotated[Uplift, UNCERTAIN_UPLIFT]
    """multiplier that starts rocking, taken as the slenderness [rad], like 0.14"""
    radius: PositiveLength
    """distance from hinge to centre of mass, like "2.84 m\""""
    label: StrictStr = ""
    """what the report calls it; the name of the table if absent"""
    sides: Literal["one", "two"] = "two"
    """"two", or "one": positive rotation only, the building behind stops the other"""
    restitution: Annotated[Restitution, ONE_FOR_BOTH, UNCERTAIN_RESTITUTION] = Field(default_factory=Restitution)
    """a number in [0, 1], a name, or { positive, negative }"""
    mass: PositiveMass = 1.0
    """mass of the mechanism"""
    disintegration: Literal["excluded", "possible"] | None = None
    """whether its masonry may fall apart: "excluded" (by survey, quality index or test) or "possible\""""
    elevation: Length = 0.0
    """of the mechanism's base, in the coordinates of the bodies"""
    amplification: AmplificationSection = Field(default_factory=NoAmplification)
    """{ method = "srss" | "modal-filter" | "ec8" | "nzs1170.5" | …, height, … }: the motion's way up to its base"""
    examines: ItemKeys | None = None
    """what of the report's list of possible mechanisms it examines, like "gable\""""

    @model_validator(mode="after")
    def _p_suits_the_radius(self) -> Self:
        least, most = INERTIA_RATIOS
        ratio = g / (self.p**2 * self.radius)
        if not least <= ratio <= most:
            low, high = (sqrt(g / (each * self.radius)) for each in (most, least))
            raise wrong(
                "p",
                f"with a radius of {self.radius:.4g} m the inertia about the hinge is {ratio:.3g} M R^2, which no "
                f"mechanism has; give {low:.3g} to {high:.3g} 1/s (a slender block has sqrt(3 g / (4 R)) = "
                f"{sqrt(0.75 * g / self.radius):.3g} 1/s), or another radius",
            )
        return self


Mechanism = SingleBlock | TwoBlock | FourHinge | EquivalentBlock


def _mechanism_tag(values: Any) -> str | None:
    kind = values.get("kind") if isinstance(values, dict) else None
    return f"<{kind}>" if kind in MECHANISMS else None


MechanismSection = Annotated[
    Annotated[SingleBlock, Tag("<single-block>")]
    | Annotated[TwoBlock, Tag("<two-block>")]
    | Annotated[FourHinge, Tag("<four-hinge>")]
    | Annotated[EquivalentBlock, Tag("<equivalent-block>")],
    Discriminator(
        _mechanism_tag,
        custom_error_type="choice",
        custom_error_message="write one of {names}",
        custom_error_context={"key": ("kind",), "names": quote_names(MECHANISMS)},
    ),
]
