"""The tables [mechanisms.NAME], with their hinges, cuts, interfaces, restitution and amplification."""

from __future__ import annotations

from math import sqrt
from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import (
    AfterValidator,
    BeforeValidator,
    Discriminator,
    Field,
    GetJsonSchemaHandler,
    StrictInt,
    StrictStr,
    Tag,
    WithJsonSchema,
    model_validator,
)
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema
from scipy.constants import g

from assess.declaration import (
    UNCERTAIN,
    UNCERTAIN_COORDINATE,
    UNCERTAIN_RESTITUTION,
    UNCERTAIN_UPLIFT,
    Angle,
    Inclination,
    JointStiffness,
    Length,
    Name,
    NotNegativeLength,
    PositiveFrequency,
    PositiveLength,
    PositiveMass,
    PositiveRate,
    PositiveRatio,
    Ratio,
    Strength,
    Uplift,
)
from assess.loads.load import block_faults
from assess.mechanisms.chain import HINGES
from assess.mechanisms.four_hinge import MOST_VOUSSOIRS
from assess.mechanisms.kinds import MECHANISM_KINDS
from assess.mechanisms.mechanism import sweep_faults
from assess.mechanisms.restitution import RESTITUTIONS
from assess.mechanisms.single_block import INERTIA_RATIOS
from assess.mechanisms.two_block import CRACKS
from assess.project.section import (
    A_POINT,
    Coordinate,
    ItemKeys,
    PlanePoint,
    ProjectSection,
    SoughtDirection,
    SpacePoint,
    error_at,
    quantity_schema,
    quote_names,
    unique,
)
from assess.project.sections.bodies_and_loads import Corners, LoadSection
from assess.project.units import KINDS, key_value


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


class CutPlaneSection(ProjectSection):
    """An inclined crack."""

    point: SpacePoint
    """a point of the plane [x, y, z]"""
    normal: tuple[Ratio, Ratio, Ratio]
    """square to the plane, to the side that moves: [nx, ny, nz] with nz > 0; or give angle"""


class CutAngleSection(ProjectSection):
    """A crack inclined in the plane of motion."""

    point: SpacePoint
    """a point of the plane [x, y, z]"""
    angle: Inclination
    """from the horizontal, like "60 deg": where positive, the crack falls towards the direction"""

    @model_validator(mode="before")
    @classmethod
    def _one_inclination(cls, values: Any) -> Any:
        if isinstance(values, dict) and "normal" in values:
            raise error_at("normal", "beside angle; remove one of them")
        return values


def _cut_tag(value: Any) -> str:
    if isinstance(value, CutAngleSection) or (isinstance(value, dict) and "angle" in value):
        return "<angle>"
    return "<plane>" if isinstance(value, dict | CutPlaneSection) else "<elevation>"


Cut = Annotated[
    Annotated[Length, Tag("<elevation>")]
    | Annotated[CutPlaneSection, Tag("<plane>")]
    | Annotated[CutAngleSection, Tag("<angle>")],
    Discriminator(_cut_tag),
]


def _crack(value: Any) -> float | str:
    if isinstance(value, str) and value in CRACKS:
        return value
    if isinstance(value, str) and not any(character.isdigit() for character in value):
        raise ValueError(f"not a crack; write an elevation, or one of {quote_names(CRACKS)}")
    return key_value(value, KINDS["length"])


CrackElevation = Annotated[
    float | Literal["sorrentino", "minimum"],
    BeforeValidator(_crack),
    WithJsonSchema(
        {
            "anyOf": [quantity_schema("length"), {"enum": list(CRACKS)}],
            "description": 'an elevation like "2.4 m", or "sorrentino", "minimum"',
        }
    ),
    KINDS["length"],
]
HingeCoordinate = Annotated[Coordinate, UNCERTAIN_COORDINATE]
UncertainPoint = Annotated[tuple[HingeCoordinate, ...], A_POINT, Field(min_length=2, max_length=3)]


class HingesSection(ProjectSection):
    """Where a block turns: [x, y, z], or [distance along the direction, elevation]."""

    A: UncertainPoint
    """the base hinge"""


class ThreeHingesSection(HingesSection):
    """Hinges of a wall of two blocks."""

    B: UncertainPoint
    """at the crack"""
    C: UncertainPoint
    """at the top"""


class FourHingesSection(ThreeHingesSection):
    """Hinges of three blocks."""

    D: UncertainPoint
    """the far base hinge"""


def _minimum(value: Any) -> Any:
    if value != "minimum":
        raise ValueError('not hinges; write { A, B, C, D }, each a point, or "minimum" for an arch')
    return value


ArchHingesValue = Annotated[
    Annotated[FourHingesSection, Tag("<hinges>")]
    | Annotated[Literal["minimum"], BeforeValidator(_minimum), Tag("<minimum>")],
    Discriminator(lambda value: "<hinges>" if isinstance(value, dict | FourHingesSection) else "<minimum>"),
]


class RadialJointsSection(ProjectSection):
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
            raise error_at("last", "is the first joint again; give the angle of the other springing")
        return self


JointLine = tuple[PlanePoint, PlanePoint]
Joints = Annotated[
    Annotated[RadialJointsSection, Tag("<radial>")]
    | Annotated[tuple[JointLine, ...], Field(max_length=MOST_VOUSSOIRS + 1), Tag("<lines>")],
    Discriminator(lambda value: "<radial>" if isinstance(value, dict | RadialJointsSection) else "<lines>"),
]
HingeName = Literal["A", "B", "C", "D"]
SHAPE_SIZES = {
    "rectangle": "[t, l]",
    "hollow_rectangle": "[t, l, t_in, l_in]",
    "circle": "d",
    "annulus": "[d, d_in]",
    "polygon": "[[x, y], …]",
}
JointSize = Annotated[PositiveLength, UNCERTAIN]


def _contact_shape(value: Any) -> Any:
    """Check that the value is "outline" or a table."""
    if value == "outline" or isinstance(value, dict | ShapeSection):
        return value
    meant = [value] if value in list(SHAPE_SIZES) else list(SHAPE_SIZES)
    forms = ", ".join(f"{{ {name} = {SHAPE_SIZES[name]} }}" for name in meant)
    raise error_at((), f'not allowed; write "outline", or {forms}')


def _hollow(sizes: tuple[float, ...]) -> tuple[float, ...]:
    """Check that the hole of an outline is smaller than the outline."""
    half = len(sizes) // 2
    for outside, inside in zip(sizes[:half], sizes[half:], strict=True):
        if inside >= outside:
            raise error_at((), f"the hole, {inside:g} m, must be smaller than the outside, {outside:g} m")
    return sizes


class ShapeSection(ProjectSection):
    """The contact by one of its sizes, the first along the direction of motion, the second across."""

    rectangle: tuple[JointSize, JointSize] | None = None
    """[thickness, length]"""
    hollow_rectangle: Annotated[tuple[JointSize, JointSize, JointSize, JointSize], AfterValidator(_hollow)] | None = (
        None
    )
    """[thickness, length, inner thickness, inner length]"""
    circle: JointSize | None = None
    """diameter"""
    annulus: Annotated[tuple[JointSize, JointSize], AfterValidator(_hollow)] | None = None
    """[diameter, inner diameter]"""
    polygon: Corners | None = None
    """corners [[x, y], …] in plan"""

    @model_validator(mode="after")
    def _one(self) -> Self:
        given = [key for key, value in self.entries().items() if value is not None]
        if len(given) != 1:
            raise error_at(given[-1] if given else "rectangle", f"one shape is needed, not {len(given)}")
        return self


class InterfaceSection(ProjectSection):
    """What a hinge presses on: without tension, linear up to the strength, then plastic without memory."""

    model: Literal["rigid", "flexible", "semi-flexible", "flexible-thesis"] = "rigid"
    """"rigid" (with strength: crushing only), "flexible"; with its moment, but inertia about a fixed hinge:
    "semi-flexible", about the resultant: "flexible-thesis\""""
    stiffness: Annotated[JointStiffness, UNCERTAIN] | None = None
    """normal stiffness per area, like "10 GPa/m"; or give course_thickness"""
    course_thickness: Annotated[PositiveLength, UNCERTAIN] | None = None
    """thickness of the layer that yields: stiffness = young_modulus of the material / course_thickness"""
    strength: Annotated[Strength, UNCERTAIN] | None = None
    """in compression, like "1 MPa", or "inf"; the material's if absent (not for a rigid one)"""
    shape: Annotated[
        Annotated[Literal["outline"], Tag("<outline>")] | Annotated[ShapeSection, Tag("<shape>")],
        Discriminator(lambda value: "<shape>" if isinstance(value, dict | ShapeSection) else "<outline>"),
        BeforeValidator(_contact_shape),
    ] = "outline"
    """"outline" of the mesh at the hinge, or { rectangle | hollow_rectangle | circle | annulus | polygon = … }"""

    @model_validator(mode="after")
    def _stiffness_is_given_once(self) -> Self:
        given = [key for key in ("stiffness", "course_thickness") if getattr(self, key) is not None]
        if self.model == "rigid" and given:
            raise error_at(given[0], 'is for flexible interfaces; write model = "flexible", or remove it')
        if self.model != "rigid" and len(given) != 1:
            raise error_at("stiffness", "give either stiffness or course_thickness")
        return self


class _OneForBoth:
    """The mark of a key whose one value stands for both directions."""

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        return {
            "anyOf": [handler(schema), {"type": "number", "minimum": 0, "maximum": 1}, {"enum": list(RESTITUTIONS)}]
        }


ONE_FOR_BOTH = _OneForBoth()


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
    UNCERTAIN_RESTITUTION,
]


class RestitutionSection(ProjectSection):
    """Velocity after over velocity before the impact that ends a rotation, for each direction."""

    positive: RestitutionValue | None = None
    """momentum where a load moves with the mechanism, else the thesis' rule for the kind"""
    negative: RestitutionValue | None = None
    """the same for the impact that ends negative rotation"""

    @model_validator(mode="before")
    @classmethod
    def _one_for_both(cls, value: Any) -> Any:
        return value if isinstance(value, dict | RestitutionSection) else {"positive": value, "negative": value}


class NoAmplification(ProjectSection):
    """The ground's motion as it is."""

    method: Literal["none"] = "none"
    """"none\""""


class RaisedAmplification(ProjectSection):
    """What every method that amplifies needs."""

    height: NotNegativeLength | None = None
    """of the mechanism's base above the ground; by its elevation if absent"""


class FirstModeAmplification(RaisedAmplification):
    """The first mode of the structure, its shape linear in height."""

    method: Literal["srss", "srss-relative", "modal-filter"]
    """"srss" (thesis 3.48), "srss-relative" (pulses by 3.47), or "modal-filter": through the first mode"""
    natural_frequency: PositiveFrequency | None = None
    """first natural frequency, like "2.5 Hz"; [building]'s, or Rayleigh's of the bodies if absent"""
    effective_height: PositiveLength | None = None
    """height of the resultant of the first mode's inertia; [building]'s, or Rayleigh's of the bodies if absent"""


class FloorAmplification(RaisedAmplification):
    """A floor factor of a code, from the height of [building]."""

    method: Literal["ec8", "ec8-resonance", "nzs1170.5"]
    """"ec8" (EN 1998-1 4.3.5.2, rigid part), "ec8-resonance" (T_a = T_1), or "nzs1170.5" (8.3)"""


class PrintedAmplification(RaisedAmplification):
    """The floor factor of EN 1998-1 as thesis eq. 3.49 prints it."""

    method: Literal["ec8-printed"]
    """"ec8-printed": S [3 (1 + h/H) - 0.5]"""
    soil_factor: PositiveRatio
    """soil factor S, like 1.15"""


_AMPLIFICATION_TAGS = {
    "none": "<none>",
    "srss": "<mode>",
    "srss-relative": "<mode>",
    "modal-filter": "<mode>",
    "ec8": "<floor>",
    "ec8-resonance": "<floor>",
    "ec8-printed": "<printed>",
    "nzs1170.5": "<floor>",
}


def _amplification_tag(value: Any) -> str | None:
    method = value.get("method") if isinstance(value, dict) else getattr(value, "method", None)
    return _AMPLIFICATION_TAGS.get(method) if isinstance(method, str) else None


AmplificationSection = Annotated[
    Annotated[NoAmplification, Tag("<none>")]
    | Annotated[FirstModeAmplification, Tag("<mode>")]
    | Annotated[FloorAmplification, Tag("<floor>")]
    | Annotated[PrintedAmplification, Tag("<printed>")],
    Discriminator(
        _amplification_tag,
        custom_error_type="choice",
        custom_error_message="write one of {names}",
        custom_error_context={"key": ("method",), "names": quote_names(_AMPLIFICATION_TAGS)},
    ),
]


class ChainSection(ProjectSection):
    """What all mechanisms of blocks share."""

    number_of_blocks: ClassVar[int] = 1
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
    restitution: Annotated[RestitutionSection, ONE_FOR_BOTH, UNCERTAIN_RESTITUTION] = Field(
        default_factory=RestitutionSection
    )
    """a number in [0, 1], a name, or { positive, negative }"""
    interface: InterfaceSection = Field(default_factory=InterfaceSection)
    """what the hinges press on: { model = "flexible", stiffness = "10 GPa/m", strength, shape }"""
    interfaces: dict[HingeName, InterfaceSection] = Field(default_factory=dict)
    """the same for single hinges of a chain, { A = { … }, B = { … } }"""
    amplification: AmplificationSection = Field(default_factory=NoAmplification)
    """{ method = "srss" | "modal-filter" | "ec8" | "nzs1170.5" | …, height, … }: the motion's way up to its base"""
    base_elevation: Length | None = None
    """of its base above the ground, where it is drawn alone and not in its place"""
    examines: ItemKeys | None = None
    """what of the report's list of possible mechanisms it examines, like "gable"; if absent, as its kind tells"""

    @model_validator(mode="after")
    def _interfaces_are_at_hinges(self) -> Self:
        known = "ABCD"[: HINGES[self.number_of_blocks]]
        for hinge_name in self.interfaces:
            if hinge_name not in known:
                raise error_at(("interfaces", hinge_name), f"no such hinge; known: {', '.join(known)}")
        return self

    def points(self) -> dict[str, tuple[tuple[float, ...], ...] | None]:
        """The hinges that are given as points, from A on, by key."""
        given = {key: getattr(self, key, None) for key in ("hinges", "hinges_negative")}
        return {
            key: tuple(at for _, at in each) if isinstance(each, HingesSection) else None for key, each in given.items()
        }

    @model_validator(mode="after")
    def _nothing_turns_with_a_sought_direction(self) -> Self:
        for key, reason in sweep_faults(self, hinges=self.points()):
            raise error_at(key, reason)
        return self

    @model_validator(mode="after")
    def _loads_find_their_block(self) -> Self:
        kind = getattr(self, "kind", "")
        for number, key, reason in block_faults(self.loads, kind, number_of_blocks=self.number_of_blocks):
            raise error_at(("loads", number, key), reason)
        return self


class SingleBlockSection(ChainSection):
    """One block that rocks about its base."""

    kind: Literal["single-block"]
    """"single-block\""""
    blocks: Annotated[Blocks, Field(min_length=1, max_length=1)]
    """the body that rocks, ["wall"], or several that move as one, [["wall", "buttress"]]"""
    hinges: HingesSection | None = None
    """hinge of positive rotation; the extreme line of the base (of the cut) if absent"""
    hinges_negative: HingesSection | None = None
    """hinge of negative rotation; the extreme line of the base (of the cut) if absent"""


class TwoBlockSection(ChainSection):
    """A wall held at its base and its top that opens at a crack between."""

    number_of_blocks: ClassVar[int] = 2
    kind: Literal["two-block"]
    """"two-block\""""
    blocks: Annotated[Blocks, Field(min_length=1, max_length=2)]
    """one body, cut at the crack, or two, the lower first"""
    hinges: ThreeHingesSection | None = None
    """hinges of positive rotation; the edges of base, crack and top if absent"""
    hinges_negative: ThreeHingesSection | None = None
    """hinges of negative rotation; the edges of base, crack and top if absent"""
    crack: CrackElevation | None = None
    """"sorrentino" (eq. 3.27), "minimum" (least uplift multiplier), or an elevation; hinge B's if hinges are given"""

    @model_validator(mode="after")
    def _one_body_cracks(self) -> Self:
        if len(self.blocks) == 2 and self.crack is not None:
            raise error_at("crack", "is for one body; two bodies part at their joint, so remove one of them")
        return self


class FourHingeSection(ChainSection):
    """Three blocks between two fixed hinges: portal, frame, arch, side-aisle vault, belfry."""

    number_of_blocks: ClassVar[int] = 3
    kind: Literal["four-hinge"]
    """"four-hinge\""""
    blocks: Annotated[Blocks, Field(min_length=1, max_length=3)]
    """the bodies A-B, B-C and C-D; or one arch, with joints and hinges = "minimum\""""
    hinges: ArchHingesValue
    """hinges A, B, C, D of positive rotation, or "minimum": where the arch resists least"""
    hinges_negative: FourHingesSection | None = None
    """hinges A, B, C, D of negative rotation"""
    joints: Joints | None = None
    """of an arch, in order: [[[x, z], [x, z]], …], or { centre, first, last, count } for radial ones"""

    @model_validator(mode="after")
    def _hinges_suit_the_bodies(self) -> Self:
        if self.hinges != "minimum":
            if len(self.blocks) != 3:
                raise error_at("blocks", f"{len(self.blocks)} of them with four hinges; name three, base first")
            if (self.hinges_negative is None) == (self.sides != "one"):
                two, one = (
                    'missing; two-sided rocking has hinges of its own each way: give them, or sides = "one"',
                    "beside one-sided rocking; remove it",
                )
                raise error_at("hinges_negative", two if self.sides != "one" else one)
            if self.joints is not None:
                raise error_at("joints", 'are for an arch with hinges = "minimum"; remove one of them')
            return self
        if self.hinges_negative is not None:
            raise error_at("hinges_negative", 'are looked for too with hinges = "minimum"; remove them')
        if len(self.blocks) != 1 or self.joints is None:
            raise error_at("joints", 'hinges = "minimum" needs one arch in blocks, and joints where it may open')
        if self.loads:
            raise error_at("loads", 'not with hinges = "minimum"; write the hinges that `assess check` prints')
        return self


class EquivalentBlockSection(ProjectSection):
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
    restitution: Annotated[RestitutionSection, ONE_FOR_BOTH, UNCERTAIN_RESTITUTION] = Field(
        default_factory=RestitutionSection
    )
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
            raise error_at(
                "p",
                f"with a radius of {self.radius:.4g} m the inertia about the hinge is {ratio:.3g} M R^2, which no "
                f"mechanism has; give {low:.3g} to {high:.3g} 1/s (a slender block has sqrt(3 g / (4 R)) = "
                f"{sqrt(0.75 * g / self.radius):.3g} 1/s), or another radius",
            )
        return self


MECHANISMS = tuple(MECHANISM_KINDS)


def _mechanism_tag(values: Any) -> str | None:
    kind = values.get("kind") if isinstance(values, dict) else None
    return f"<{kind}>" if kind in MECHANISMS else None


MechanismSection = Annotated[
    Annotated[SingleBlockSection, Tag("<single-block>")]
    | Annotated[TwoBlockSection, Tag("<two-block>")]
    | Annotated[FourHingeSection, Tag("<four-hinge>")]
    | Annotated[EquivalentBlockSection, Tag("<equivalent-block>")],
    Discriminator(
        _mechanism_tag,
        custom_error_type="choice",
        custom_error_message="write one of {names}",
        custom_error_context={"key": ("kind",), "names": quote_names(MECHANISMS)},
    ),
]
