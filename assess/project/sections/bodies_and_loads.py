"""The tables [materials.NAME] and [bodies.NAME], and the entries of `loads` of a mechanism."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal

from pydantic import Discriminator, Tag

from assess.declaration import BOUGHT, UNCERTAIN, Evidence, Name, PositiveLength, SpacePoint
from assess.geometry.solid import Corners
from assess.loads.load import LOADS, LoadDefinition
from assess.model.bodies import Material, PointValues
from assess.project.section import DeclaredSection, ProjectSection, table_of
from assess.project.tables import table_by_kind
from assess.project.values import InputFile, LengthUnit

Disintegration = Annotated[
    Literal["excluded", "possible"] | None,
    Evidence("measured", ("possible", "excluded"), '"possible", by which no Italian procedure passes'),
]
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


class MaterialKeys(ProjectSection):
    """What a project file says of a masonry beside its numbers."""

    first: ClassVar = ("density", "young_modulus", "compressive_strength", "tensile_strength", "disintegration")
    disintegration: Disintegration = None
    """whether the masonry may fall apart: "excluded" (by survey, quality index or test) or "possible\""""


if TYPE_CHECKING:
    MaterialSection = DeclaredSection
    PointSection = DeclaredSection
else:
    MaterialSection = table_of(Material, file_keys=MaterialKeys)
    PointSection = table_of(PointValues)


class BoxSection(ProjectSection):
    """A rectangular block: thickness along x, length along y."""

    thickness: Annotated[PositiveLength, UNCERTAIN, BOUGHT, THICKNESS]
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


class DirectBody(PointSection):
    """A body by its mass, centroid and inertia, without geometry."""

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
