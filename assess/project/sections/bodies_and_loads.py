"""The tables [materials.NAME] and [bodies.NAME], and the entries of `loads` of a mechanism."""

from __future__ import annotations

from typing import Annotated, Any, Literal

import numpy as np
import shapely
from pydantic import (
    AfterValidator,
    BeforeValidator,
    Discriminator,
    Field,
    StrictBool,
    StrictInt,
    Tag,
    WithJsonSchema,
    model_validator,
)

from assess.geometry.contact import CONTACT_TOLERANCE
from assess.geometry.solid import find_crossing, remove_repeats
from assess.interfaces.section import THINNEST
from assess.project.section import (
    UNCERTAIN,
    AnyDirection,
    InputFile,
    Length,
    LengthUnit,
    Name,
    NotNegativeRatio,
    NotNegativeStress,
    PlanePoint,
    Point,
    PositiveAreaMass,
    PositiveDensity,
    PositiveForce,
    PositiveInertia,
    PositiveLength,
    PositiveMass,
    PositiveRatio,
    PositiveStress,
    ProjectSection,
    Share,
    SpacePoint,
    error_at,
    quantity_schema,
    quote_names,
)
from assess.project.units import KINDS, key_value


class MaterialSection(ProjectSection):
    """A masonry."""

    density: Annotated[PositiveDensity, UNCERTAIN]
    """mass per volume, like "2240 kg/m^3\""""
    young_modulus: Annotated[PositiveStress, UNCERTAIN] | None = None
    """modulus of elasticity, like "6.89 GPa\""""
    compressive_strength: Annotated[PositiveStress, UNCERTAIN] | None = None
    """strength in compression, like "1.0 MPa\""""
    tensile_strength: Annotated[NotNegativeStress, UNCERTAIN] | None = None
    """strength of the mortar in tension"""
    disintegration: Literal["excluded", "possible"] | None = None
    """whether the masonry may fall apart: "excluded" (by survey, quality index or test) or "possible\""""
    friction: Annotated[NotNegativeRatio, UNCERTAIN] | None = None
    """coefficient of friction"""


class BoxSection(ProjectSection):
    """A rectangular block: thickness along x, length along y."""

    thickness: Annotated[PositiveLength, UNCERTAIN]
    """size along x, like "1.25 m\""""
    length: Annotated[PositiveLength, UNCERTAIN]
    """size along y, like "3.0 m\""""
    height: Annotated[PositiveLength, UNCERTAIN]
    """size along z, like "8.0 m\""""
    base: SpacePoint = (0.0, 0.0, 0.0)
    """centre of the base face [x, y, z]"""


class MeshBody(ProjectSection):
    """A body bounded by a triangle mesh, which is mended where it is not closed; a warning then says how.

    In the project z points up. glTF files have y up and are in metres by their standard; they are turned.
    """

    material: Name
    """the name of a table [materials.NAME]"""
    mesh: InputFile
    """triangle mesh: STL, OBJ, PLY, OFF, GLB, glTF or 3MF; with extra packages STEP, Rhino .3dm or IFC"""
    mesh_unit: LengthUnit | None = None
    """unit of the mesh's coordinates, like "mm"; the file's own if absent, metre where it has none"""
    mesh_up: Literal["y", "z"] | None = None
    """axis of the file that points up; "y" for glTF and "z" for all others if absent"""
    element: Name | None = None
    """only elements of the file: a name, a GlobalId, a class like "IfcWall", or a pattern like "Wall-*"; several become
    one body; all of the file if absent"""


class BoxBody(ProjectSection):
    """A rectangular body."""

    material: Name
    """the name of a table [materials.NAME]"""
    box: BoxSection
    """{ thickness, length, height, base }"""


def _simple(corners: tuple[tuple[float, float], ...]) -> tuple[tuple[float, float], ...]:
    """Check that corners enclose an area and that the sides meet only at them."""
    points = np.array(corners)
    if shapely.MultiPoint(points).convex_hull.area <= THINNEST * float(np.ptp(points, axis=0).max()) ** 2:
        raise error_at((), "no area, its corners lie on a line; give corners that enclose one")
    meet = find_crossing(remove_repeats(points))
    if meet is not None:
        at = f"[{meet[0]:.4g}, {meet[1]:.4g}] m"
        raise error_at(
            (), f"its sides cross or touch one another at {at}; list its corners in order around the outline"
        )
    return corners


Corners = Annotated[tuple[PlanePoint, ...], Field(min_length=3), AfterValidator(_simple)]


class ProfileBody(ProjectSection):
    """A polygon in the x-z plane, extruded along y and centred on y = 0."""

    material: Name
    """the name of a table [materials.NAME]"""
    profile: Corners
    """corners of the polygon [[x, z], …] in order"""
    length: Annotated[PositiveLength, UNCERTAIN]
    """length along y, like "3.0 m\""""


class DirectBody(ProjectSection):
    """A body by its mass, centroid and inertia, without geometry."""

    mass: Annotated[PositiveMass, UNCERTAIN]
    """mass, like "12000 kg\""""
    centroid: PlanePoint
    """centre of mass [x, z]"""
    inertia: Annotated[PositiveInertia, UNCERTAIN]
    """moment of inertia about the centroid, like "5200 kg*m^2\""""
    disintegration: Literal["excluded", "possible"] | None = None
    """whether its masonry may fall apart: "excluded" (by survey, quality index or test) or "possible\""""


_FORMS = {"mesh": "<mesh>", "box": "<box>", "profile": "<profile>", "mass": "<direct>"}


def _body_tag(values: Any) -> str | None:
    forms = [tag for key, tag in _FORMS.items() if key in values] if isinstance(values, dict) else []
    return forms[0] if len(forms) == 1 else None


BodySection = Annotated[
    Annotated[MeshBody, Tag("<mesh>")]
    | Annotated[BoxBody, Tag("<box>")]
    | Annotated[ProfileBody, Tag("<profile>")]
    | Annotated[DirectBody, Tag("<direct>")],
    Discriminator(
        _body_tag,
        custom_error_type="project",
        custom_error_message="{reason}",
        custom_error_context={
            "key": (),
            "reason": "not one geometry; give mesh, or box, or profile and length, or mass, centroid and inertia",
        },
    ),
]
BlockIndex = Annotated[StrictInt, Field(ge=0, le=2)]


def _force(value: Any) -> tuple[float, float] | float:
    """Read the two components or the size of a force."""
    if not isinstance(value, list | tuple):
        size = key_value(value, KINDS["force"])
        if size <= 0:
            raise ValueError("must be greater than 0; turn its direction instead")
        return size
    if len(value) != 2:
        raise ValueError("not a force; write [along the direction, up], or a size with direction")
    return key_value(value[0], KINDS["force"]), key_value(value[1], KINDS["force"])


GivenForce = Annotated[
    tuple[float, float] | float,
    BeforeValidator(_force),
    WithJsonSchema(
        {
            "anyOf": [
                quantity_schema("force"),
                {"type": "array", "items": quantity_schema("force"), "minItems": 2, "maxItems": 2},
            ],
            "description": 'like "10 kN" with a direction, or ["8 kN", "-3 kN"]: along the direction, up',
        }
    ),
    KINDS["force"],
    UNCERTAIN,
]


def _until(value: Any) -> float | str:
    """Read a displacement, or the word for a load that lasts up to collapse."""
    if isinstance(value, str) and value.strip() == "collapse":
        return "collapse"
    moved = key_value(value, KINDS["length"])
    if moved <= 0.0:
        raise ValueError('must be greater than 0; write the displacement of its point at which it ends, or "collapse"')
    return moved


Until = Annotated[
    float | Literal["collapse"],
    BeforeValidator(_until),
    WithJsonSchema(
        {
            "anyOf": [quantity_schema("length"), {"type": "string", "pattern": r"^\s*collapse\s*$"}],
            "description": 'a displacement like "0.10 m", or "collapse"',
        }
    ),
    KINDS["length"],
]


class MassLoadSection(ProjectSection):
    """A point mass: a floor, a roof, a wall that moves with the block."""

    kind: Literal["mass"]
    """"mass\""""
    mass: Annotated[PositiveMass, UNCERTAIN]
    """like "1200 kg\""""
    at: Point
    """[x, y, z], or [distance along the direction, elevation]"""
    bearing: StrictBool = True
    """true: weight and inertia; false: its weight is carried elsewhere, horizontal inertia only"""
    seat: PositiveLength | None = None
    """of a bearing mass: how far its point can move along the direction before it falls off, like "0.12 m\""""
    block: BlockIndex = 0
    """which block it acts on, from 0 at the base"""

    @model_validator(mode="after")
    def _what_bears_has_a_seat(self) -> MassLoadSection:
        if self.seat is not None and not self.bearing:
            raise error_at("seat", "only what bears on the block has a seat; remove it, or write bearing = true")
        return self


class ForceLoadSection(ProjectSection):
    """A dead force: the thrust of a vault or roof."""

    kind: Literal["force"]
    """"force\""""
    force: GivenForce
    """[along the direction, up], or a size with `direction`"""
    at: Point
    """[x, y, z], or [distance along the direction, elevation]"""
    direction: AnyDirection | None = None
    """where a force given by its size points: [x, y, z], or [along the direction, up]"""
    until: Until | None = None
    """where it resists: "collapse" if it is shown to be there up to collapse, with a source in [report.sources]; or the
    displacement of its point at which it ends; if absent it counts in the multiplier alone"""
    block: BlockIndex = 0
    """which block it acts on, from 0 at the base"""

    @model_validator(mode="after")
    def _size_has_a_direction(self) -> ForceLoadSection:
        if isinstance(self.force, float) and self.direction is None:
            raise error_at("direction", "missing; a force given by its size needs one, or write force = [x, z]")
        if not isinstance(self.force, float) and self.direction is not None:
            raise error_at("direction", "beside components of the force; remove one of them")
        return self


class TieLoadSection(ProjectSection):
    """A tie of constant pretension; slack on the branch where it shortens.

    It counts up to collapse only with until = "collapse", strength, length, fracture_strain and a source.
    """

    kind: Literal["tie"]
    """"tie\""""
    force: Annotated[PositiveForce, UNCERTAIN]
    """pretension, like "30 kN\""""
    at: Point
    """where it holds the block: [x, y, z], or [distance along the direction, elevation]"""
    direction: AnyDirection | None = None
    """the way it pulls: [x, y, z], or [along the direction, up]; or give anchor"""
    anchor: Point | None = None
    """the fixed end: [x, y, z], or [distance along the direction, elevation]"""
    both: StrictBool = False
    """true: taut on both branches"""
    until: Until | None = None
    """"collapse" if it is shown to be there up to collapse; or the displacement of its point at which it breaks; if
    absent it counts in the multiplier alone"""
    strength: Annotated[PositiveForce, UNCERTAIN] | None = None
    """least of bar, plate, masonry and far wall; it never pulls with more"""
    length: PositiveLength | None = None
    """of the bar, over which it stretches"""
    fracture_strain: PositiveRatio | None = None
    """of the bar; it breaks where it has lengthened by more than this times its length"""
    block: BlockIndex = 0
    """which block it acts on, from 0 at the base"""

    @model_validator(mode="after")
    def _one_way_to_pull(self) -> TieLoadSection:
        if (self.direction is None) == (self.anchor is None):
            raise error_at("anchor", "give either anchor or direction, the way the tie pulls")
        return self


class OverburdenLoadSection(ProjectSection):
    """What presses on the top of a wall of two blocks: a dead vertical load, without mass of its own."""

    kind: Literal["overburden"]
    """"overburden\""""
    force: Annotated[PositiveForce, UNCERTAIN] | None = None
    """vertical load, like "40 kN\""""
    bodies: tuple[Name, ...] = ()
    """or what stands on the wall: its weight, by its share, where it touches"""
    eccentricity: Length | None = None
    """of the load from mid-thickness of the top towards `direction`; 0, or where the bodies touch, if absent"""
    through: Literal["joint", "fixed"] | None = None
    """"joint": it presses where the top does, from mid-thickness to the edge as the wall turns (rigid: at hinge C);
    "fixed": it stays in its place on the wall; if absent "joint" on the middle of a joint at C, else "fixed\""""

    @model_validator(mode="after")
    def _one_of_them(self) -> OverburdenLoadSection:
        if (self.force is None) == (not self.bodies):
            raise error_at("force", "give either force, or the bodies that press")
        if self.through == "joint" and self.eccentricity:
            raise error_at(
                "through",
                'a load through the joint presses where the joint does; remove eccentricity, or write "fixed"',
            )
        return self


class BodyLoadSection(ProjectSection):
    """A floor, roof or vault given as a body: what it puts on the block is found where it touches it."""

    kind: Literal["body"]
    """"body\""""
    body: Name
    """the name of a table [bodies.NAME] that is not part of the block"""
    role: Literal["floor", "roof", "vault"] = "floor"
    """"floor" (weight), or "roof" or "vault" (weight and thrust)"""
    tolerance: PositiveLength = CONTACT_TOLERANCE
    """faces this near each other touch"""
    share: Share | None = None
    """part of the body that this block carries, in (0, 1]; by statics from what else carries it if absent"""
    bearing: StrictBool | None = None
    """true: the block carries weight; false: it is only pushed; as the contact shows if absent"""
    seat: PositiveLength | None = None
    """how far the contact can move along the direction before the body falls off the block, like "0.12 m\""""
    at: Point | None = None
    """where it acts: [x, y, z], or [distance along the direction, elevation]; centroid of the contact if absent"""
    mass: Annotated[PositiveMass, UNCERTAIN] | None = None
    """of the whole body; its volume times the density of its material if absent"""
    thrust: Annotated[PositiveForce, UNCERTAIN] | None = None
    """of a roof or vault on this block, along the direction of motion, outwards; from its shape if absent"""
    span: PositiveLength | None = None
    """of a roof or vault along its thrust; from its bounding box if absent"""
    rise: PositiveLength | None = None
    """of the ridge or crown above the springing; from the bounding box if absent"""
    tied: StrictBool = False
    """true: ties or tie-beams take the thrust"""
    vault: Literal["barrel", "quadripartite"] | None = None
    """as the faces of the mesh show if absent"""
    construction: Annotated[StrictInt, Field(ge=1, le=5)] | None = None
    """weight of a vault by Ungewitter's case 1 to 5 over its intrados, in place of the mesh's volume"""
    fill: Annotated[PositiveAreaMass, UNCERTAIN] | None = None
    """fill and plaster over the plan of a vault, beside its own weight, like "80 kg/m^2\""""
    block: BlockIndex | None = None
    """which block it acts on, from 0 at the base; if absent the one that it touches, or all that it bears on"""

    @model_validator(mode="after")
    def _keys_belong_together(self) -> BodyLoadSection:
        for key in ("thrust", "span", "rise", "tied"):
            if self.role == "floor" and self.has_key(key):
                raise error_at(key, 'only a roof or a vault has a thrust; write role = "roof" or "vault", or remove it')
        for key in ("vault", "construction", "fill"):
            if self.role != "vault" and self.has_key(key):
                raise error_at(key, 'only of a vault; write role = "vault", or remove it')
        instead = {"thrust": ("tied", "span", "rise"), "mass": ("construction", "fill")}
        for number, keys in instead.items():
            for key in keys:
                if getattr(self, key) and getattr(self, number) is not None:
                    raise error_at(key, f"beside {number}, which leaves nothing for it to say; remove one of them")
        return self


LOADS = ("mass", "force", "tie", "overburden", "body")


def _load_tag(values: Any) -> str | None:
    kind = values.get("kind") if isinstance(values, dict) else None
    return f"<{kind}>" if kind in LOADS else None


LoadSection = Annotated[
    Annotated[MassLoadSection, Tag("<mass>")]
    | Annotated[ForceLoadSection, Tag("<force>")]
    | Annotated[TieLoadSection, Tag("<tie>")]
    | Annotated[OverburdenLoadSection, Tag("<overburden>")]
    | Annotated[BodyLoadSection, Tag("<body>")],
    Discriminator(
        _load_tag,
        custom_error_type="project",
        custom_error_message="{reason}",
        custom_error_context={"key": ("kind",), "reason": f"not a supported load; write one of {quote_names(LOADS)}"},
    ),
]
