"""The tables [mechanisms.NAME]."""

from __future__ import annotations

from math import sqrt
from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import (
    AfterValidator,
    BeforeValidator,
    Discriminator,
    Field,
    StrictInt,
    StrictStr,
    Tag,
    WithJsonSchema,
    model_validator,
)
from scipy.constants import g

from assess.mechanisms.chain import HINGES
from assess.model.definitions import keys_along_direction
from assess.project.quantities import (
    Angle,
    Inclination,
    Length,
    Name,
    PlanePoint,
    Point,
    PositiveLength,
    PositiveMass,
    PositiveRate,
    Ratio,
    SoughtDirection,
    SpacePoint,
    Uplift,
    unique,
)
from assess.project.section import Section, quote_names, wrong
from assess.project.sections.amplification import AmplificationSection, NoAmplification
from assess.project.sections.interfaces import Interface, Letter
from assess.project.sections.loads import LoadSection, OverburdenLoad
from assess.project.units import KINDS, key_value

MECHANISMS = ("single-block", "two-block", "four-hinge", "equivalent-block")
CRACKS = ("sorrentino", "minimum")
MOST_VOUSSOIRS = 80  # of an arch: all choices of four of its joints are looked at, which takes seconds
INERTIA_RATIOS = (1e-4, 1e4)  # I_O / (M R^2) = g / (p^2 R): 4/3 of a slender block, less of a wall that spans
RESTITUTIONS = ("thesis", "housner", "sorrentino", "momentum")


def _restitution(value: Any) -> float | str:
    if isinstance(value, str):
        if value not in RESTITUTIONS:
            raise ValueError(f"not a known restitution; write a number in [0, 1] or one of {quote_names(RESTITUTIONS)}")
        return value
    number = key_value(value, KINDS["ratio"])
    if not 0.0 <= number <= 1.0:
        raise ValueError("outside [0, 1]; restitution is velocity after over velocity before the impact")
    return number


RestitutionValue = Annotated[
    float | Literal["thesis", "housner", "sorrentino", "momentum"],
    BeforeValidator(_restitution),
    Field(description='a number in [0, 1], or "thesis", "housner", "sorrentino", "momentum"'),
    KINDS["ratio"],
]


class Restitution(Section):
    """Velocity after over velocity before the impact that ends a rotation, for each direction."""

    positive: RestitutionValue | None = None
    """momentum where a load moves with the mechanism, else the thesis' rule for the kind"""
    negative: RestitutionValue | None = None
    """the same for the impact that ends negative rotation"""

    @model_validator(mode="before")
    @classmethod
    def _one_for_both(cls, value: Any) -> Any:
        return value if isinstance(value, dict | Restitution) else {"positive": value, "negative": value}


class Hinges(Section):
    """Where a block turns: [x, y, z], or [distance along the direction, elevation]."""

    A: Point
    """the base hinge"""


class ThreeHinges(Hinges):
    """Hinges of a wall of two blocks."""

    B: Point
    """at the crack"""
    C: Point
    """at the top"""


class FourHinges(ThreeHinges):
    """Hinges of three blocks."""

    D: Point
    """the far base hinge"""


class RadialJoints(Section):
    """Joints of an arch that all point to its centre, evenly spaced."""

    centre: PlanePoint
    """[distance along the direction, elevation]"""
    first: Angle
    """angle of the first joint above the direction, like "168.75 deg\""""
    last: Angle
    """angle of the last joint, like "11.25 deg\""""
    count: Annotated[StrictInt, Field(ge=3, le=MOST_VOUSSOIRS)]
    """number of voussoirs between them"""

    @model_validator(mode="after")
    def _ends_are_apart(self) -> Self:
        if self.first == self.last:
            raise wrong("last", "is the first joint again; give the angle of the other springing")
        return self


Line = tuple[PlanePoint, PlanePoint]
Joints = Annotated[
    Annotated[RadialJoints, Tag("<radial>")]
    | Annotated[tuple[Line, ...], Field(max_length=MOST_VOUSSOIRS + 1), Tag("<lines>")],
    Discriminator(lambda value: "<radial>" if isinstance(value, dict | RadialJoints) else "<lines>"),
]


def _minimum(value: Any) -> Any:
    if value != "minimum":
        raise ValueError('not hinges; write { A, B, C, D }, each a point, or "minimum" for an arch')
    return value


ArchHinges = Annotated[
    Annotated[FourHinges, Tag("<hinges>")] | Annotated[Literal["minimum"], BeforeValidator(_minimum), Tag("<minimum>")],
    Discriminator(lambda value: "<hinges>" if isinstance(value, dict | FourHinges) else "<minimum>"),
]


def _crack(value: Any) -> float | str:
    if isinstance(value, str) and value in CRACKS:
        return value
    if isinstance(value, str) and not any(letter.isdigit() for letter in value):
        raise ValueError(f"not a crack; write an elevation, or one of {quote_names(CRACKS)}")
    return key_value(value, KINDS["length"])


Crack = Annotated[
    float | Literal["sorrentino", "minimum"],
    BeforeValidator(_crack),
    WithJsonSchema({"description": 'an elevation like "2.4 m", or "sorrentino", "minimum"'}),
    KINDS["length"],
]


class CutPlane(Section):
    """An inclined crack."""

    point: SpacePoint
    """a point of the plane [x, y, z]"""
    normal: tuple[Ratio, Ratio, Ratio]
    """square to the plane, to the side that moves: [nx, ny, nz] with nz > 0; or give angle"""


class CutAngle(Section):
    """A crack inclined in the plane of motion."""

    point: SpacePoint
    """a point of the plane [x, y, z]"""
    angle: Inclination
    """from the horizontal, like "60 deg": where positive, the crack falls towards the direction"""

    @model_validator(mode="before")
    @classmethod
    def _one_inclination(cls, values: Any) -> Any:
        if isinstance(values, dict) and "normal" in values:
            raise wrong("normal", "beside angle; remove one of them")
        return values


def _cut_tag(value: Any) -> str:
    if isinstance(value, CutAngle) or (isinstance(value, dict) and "angle" in value):
        return "<angle>"
    return "<plane>" if isinstance(value, dict | CutPlane) else "<elevation>"


Cut = Annotated[
    Annotated[Length, Tag("<elevation>")] | Annotated[CutPlane, Tag("<plane>")] | Annotated[CutAngle, Tag("<angle>")],
    Discriminator(_cut_tag),
]


def _block_names(value: Any) -> Any:
    """Write each entry of `blocks` as a list of bodies that move as one."""
    return [[entry] if isinstance(entry, str) else entry for entry in value] if isinstance(value, list) else value


BlockNames = Annotated[tuple[Name, ...], Field(min_length=1), AfterValidator(unique("body"))]


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
    restitution: Restitution = Field(default_factory=Restitution)
    """a number in [0, 1], a name, or { positive, negative }"""
    interface: Interface = Field(default_factory=Interface)
    """what the hinges press on: { model = "flexible", stiffness = "10 GPa/m", strength, shape }"""
    interfaces: dict[Letter, Interface] = Field(default_factory=dict)
    """the same for single hinges of a chain, { A = { … }, B = { … } }"""
    amplification: AmplificationSection = Field(default_factory=NoAmplification)
    """{ method = "srss" | "modal-filter" | "ec8" | "nzs1170.5" | …, height, … }: the motion's way up to its base"""
    base_elevation: Length | None = None
    """of its base above the ground, where it is drawn alone and not in its place"""

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
    disintegration: Literal["excluded", "possible"] | None = None
    """whether its masonry may fall apart: "excluded" (by survey, quality index or test) or "possible\""""
    elevation: Length = 0.0
    """of the mechanism's base, in the coordinates of the bodies"""
    amplification: AmplificationSection = Field(default_factory=NoAmplification)
    """{ method = "srss" | "modal-filter" | "ec8" | "nzs1170.5" | …, height, … }: the motion's way up to its base"""

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
