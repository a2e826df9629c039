"""The tables [materials.NAME] and [bodies.NAME], and the entries of `loads` of a mechanism."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import Discriminator, Tag

from assess.declaration import (
    UNCERTAIN,
    Evidence,
    MasonryStrength,
    Name,
    NotNegativeRatio,
    NotNegativeStress,
    PlanePoint,
    PositiveDensity,
    PositiveInertia,
    PositiveLength,
    PositiveMass,
    PositiveStress,
    SpacePoint,
)
from assess.geometry.solid import Corners
from assess.loads.load import LOADS, LoadDefinition
from assess.project.section import ProjectSection
from assess.project.tables import table_by_kind
from assess.project.values import InputFile, LengthUnit

DENSITY = Evidence(
    "defines",
    "either",
    "as stated, within the range of the type of masonry",
    judged="weight holds a wall against thrusts and drives one that crushes; alone on a rigid base it changes nothing",
)
MODULUS = Evidence(
    "measured",
    "either",
    "the worst over the range of its type, joints up to 100 GPa/m",
    judged="it sets the stiffness of joints and the first mode of the building, and a softer one may rock more or less",
)
COMPRESSION = Evidence("measured", "up", "the lower bound of the type of masonry, that of LC1; never above 50 MPa")
TENSION = Evidence(
    "measured",
    "either",
    "the worse of 0 and what is stated",
    judged="no procedure counts on it; eq. 3.27 places a crack by it, which may be the weaker or the stronger place",
)
Disintegration = Annotated[
    Literal["excluded", "possible"] | None,
    Evidence("measured", ("possible", "excluded"), '"possible", by which no Italian procedure passes'),
]
FRICTION = Evidence("measured", "up", "absent: whether anything slides is not answered")
GIVEN = Evidence("defines", "either", "as stated")
SIZE = Evidence("defines", "either", "as drawn, the tolerance of the survey either way")
THICKNESS = Evidence(
    "defines",
    "up",
    "that of the leaf that turns, the tolerance of the survey either way",
    judged="a thicker wall turns later; boxes that are walls have it along the way they turn",
)
HEIGHT = Evidence(
    "defines",
    "down",
    "as drawn, the tolerance of the survey either way",
    judged="of two walls of one thickness the taller lifts off and overturns at less",
)
PLACE = Evidence("drawn", "either", "as drawn")
INERTIA = Evidence(
    "defines",
    "either",
    "as stated",
    judged="more of it slows the wall, which records overturn less easily, and lets an impact take less from it",
)


class MaterialSection(ProjectSection):
    """A masonry."""

    density: Annotated[PositiveDensity, UNCERTAIN, DENSITY]
    """mass per volume, like "2240 kg/m^3\""""
    young_modulus: Annotated[PositiveStress, UNCERTAIN, MODULUS] | None = None
    """modulus of elasticity, like "6.89 GPa\""""
    compressive_strength: Annotated[MasonryStrength, UNCERTAIN, COMPRESSION] | None = None
    """strength in compression, like "1.0 MPa\""""
    tensile_strength: Annotated[NotNegativeStress, UNCERTAIN, TENSION] | None = None
    """strength of the mortar in tension"""
    disintegration: Disintegration = None
    """whether the masonry may fall apart: "excluded" (by survey, quality index or test) or "possible\""""
    friction: Annotated[NotNegativeRatio, UNCERTAIN, FRICTION] | None = None
    """coefficient of friction"""


class BoxSection(ProjectSection):
    """A rectangular block: thickness along x, length along y."""

    thickness: Annotated[PositiveLength, UNCERTAIN, THICKNESS]
    """size along x, like "1.25 m\""""
    length: Annotated[PositiveLength, UNCERTAIN, SIZE]
    """size along y, like "3.0 m\""""
    height: Annotated[PositiveLength, UNCERTAIN, HEIGHT]
    """size along z, like "8.0 m\""""
    base: Annotated[SpacePoint, PLACE] = (0.0, 0.0, 0.0)
    """centre of the base face [x, y, z]"""


class MeshBody(ProjectSection):
    """A body bounded by a triangle mesh, which is mended where it is not closed; a warning then says how.

    In the project z points up. glTF files have y up and are in metres by their standard; they are turned.
    """

    evidence = GIVEN

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

    evidence = GIVEN

    material: Name
    """the name of a table [materials.NAME]"""
    box: BoxSection
    """{ thickness, length, height, base }"""


class ProfileBody(ProjectSection):
    """A polygon in the x-z plane, extruded along y and centred on y = 0."""

    material: Annotated[Name, GIVEN]
    """the name of a table [materials.NAME]"""
    profile: Annotated[Corners, SIZE]
    """corners of the polygon [[x, z], …] in order"""
    length: Annotated[PositiveLength, UNCERTAIN, SIZE]
    """length along y, like "3.0 m\""""


class DirectBody(ProjectSection):
    """A body by its mass, centroid and inertia, without geometry."""

    evidence = GIVEN

    mass: Annotated[PositiveMass, UNCERTAIN]
    """mass, like "12000 kg\""""
    centroid: PlanePoint
    """centre of mass [x, z]"""
    inertia: Annotated[PositiveInertia, UNCERTAIN, INERTIA]
    """moment of inertia about the centroid, like "5200 kg*m^2\""""
    disintegration: Disintegration = None
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
if TYPE_CHECKING:
    LoadSection = LoadDefinition  # a table has the keys of its class
else:
    LoadSection = table_by_kind(LOADS, what="load")
