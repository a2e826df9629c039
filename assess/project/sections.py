"""The tables of a project file, one class each; every quantity is an SI float. Attributes are named as the keys.

The sentence below a key is its description in the JSON Schema and in the message when it is missing.
"""

from __future__ import annotations

from collections.abc import Mapping
from datetime import date
from typing import Annotated, Any, ClassVar, Literal, get_args

from pydantic import AfterValidator, BeforeValidator, Discriminator, Field, StrictInt, StrictStr, Tag, model_validator

from assess.project.quantities import (
    AccelerationUnit,
    Count,
    Damping,
    Direction,
    InputFile,
    InputFiles,
    Length,
    LengthUnit,
    Name,
    NotNegativeRatio,
    NotNegativeStress,
    PlanePoint,
    Point,
    PositiveAcceleration,
    PositiveDensity,
    PositiveInertia,
    PositiveLength,
    PositiveMass,
    PositiveRate,
    PositiveStress,
    PositiveTime,
    Ratio,
    SpacePoint,
    Uplift,
    unique,
)
from assess.project.section import Section, listed, wrong
from assess.project.units import KINDS, si_value

SPECTRA = ("asce7-05", "ibc2009", "asce7-10", "asce7-16", "table")
MECHANISMS = ("single-block", "equivalent-block")
RESTITUTIONS = ("thesis", "housner", "sorrentino", "momentum")
Procedure = Literal[
    "asce43-05-spectrum",
    "asce43-05-spectrum-thesis",
    "asce43-05-history",
    "dmi2008-linear",
    "dmi2008-nonlinear",
    "dmi2008-nonlinear-thesis",
]
PROCEDURES: tuple[Procedure, ...] = get_args(Procedure)


# ---------------------------------------------------------------- site and building


class Asce7Spectrum(Section):
    """Design spectrum of ASCE 7 (IBC 2009 refers to 7-05), from its two design ordinates."""

    planned: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("s_s", "s_1", "site_class"), "give s_ds, s_d1 and t_l directly"
    )

    code: Literal["asce7-05", "ibc2009", "asce7-10", "asce7-16"]
    """name and edition of the code; "ibc2009" has the shape of "asce7-05\""""
    s_ds: PositiveAcceleration
    """design spectral acceleration at short periods, like "0.167 g\""""
    s_d1: PositiveAcceleration
    """design spectral acceleration at 1 s, like "0.053 g\""""
    t_l: PositiveTime
    """long-period transition period, like "6 s\""""
    hazard: Literal["design", "mce"] = "design"
    """"design", or "mce": the maximum considered earthquake, 1.5 times the design spectrum"""
    damping: Damping = 0.05
    """damping ratio of the spectrum"""


class TableSpectrum(Section):
    """A spectrum read from a file of periods and accelerations."""

    code: Literal["table"]
    """"table\""""
    file: InputFile
    """CSV of period and acceleration, with units in the header"""
    damping: Damping = 0.05
    """damping ratio of the spectrum in the file"""


def _spectrum_tag(values: Any) -> str | None:
    code = values.get("code") if isinstance(values, dict) else None
    return None if code not in SPECTRA else "<table>" if code == "table" else "<asce7>"


SpectrumSection = Annotated[
    Annotated[Asce7Spectrum, Tag("<asce7>")] | Annotated[TableSpectrum, Tag("<table>")],
    Discriminator(
        _spectrum_tag,
        custom_error_type="choice",
        custom_error_message="write one of {names}",
        custom_error_context={"key": ("code",), "names": listed(SPECTRA)},
    ),
]


class Site(Section):
    """What the ground demands."""

    spectrum: SpectrumSection
    """a table [site.spectrum] with the code and its parameters"""
    pga: PositiveAcceleration | None = None
    """scales the spectrum's ordinates to this peak ground acceleration, corner periods fixed"""
    vertical_ratio: NotNegativeRatio = 0.0
    """vertical over horizontal spectral acceleration, for F_V of ASCE 43-05"""


class Building(Section):
    """The structure below a mechanism; what the clauses for mechanisms above ground need."""

    planned: ClassVar[Mapping[str, str]] = dict.fromkeys(
        ("natural_frequency", "effective_height"), "amplification of histories comes later; remove it"
    )

    height: PositiveLength
    """height above ground_elevation, like "9 m\""""
    storeys: Count | None = None
    """number of storeys"""
    ground_elevation: Length = 0.0
    """elevation of the ground in the coordinates of the bodies"""
    period: PositiveTime = Field(default_factory=lambda values: 0.05 * values["height"] ** 0.75)
    """period of the first mode; 0.05 H^0.75 if absent"""
    damping: Damping = 0.05
    """damping ratio of the first mode"""


# ---------------------------------------------------------------- materials and bodies


class Material(Section):
    """A masonry."""

    density: PositiveDensity
    """mass per volume, like "2240 kg/m^3\""""
    young_modulus: PositiveStress | None = None
    """modulus of elasticity, like "6.89 GPa\""""
    compressive_strength: PositiveStress | None = None
    """strength in compression, like "1.0 MPa\""""
    tensile_strength: NotNegativeStress | None = None
    """strength of the mortar in tension"""
    friction: NotNegativeRatio | None = None
    """coefficient of friction"""


class Box(Section):
    """A rectangular block: thickness along x, length along y."""

    thickness: PositiveLength
    """size along x, like "1.25 m\""""
    length: PositiveLength
    """size along y, like "3.0 m\""""
    height: PositiveLength
    """size along z, like "8.0 m\""""
    base: SpacePoint = (0.0, 0.0, 0.0)
    """centre of the base face [x, y, z]"""


class MeshBody(Section):
    """A body bounded by a closed triangle mesh."""

    material: Name
    """the name of a table [materials.NAME]"""
    mesh: InputFile
    """closed triangle mesh: STL, OBJ or PLY"""
    mesh_unit: LengthUnit = 1.0
    """unit of the mesh's coordinates, like "mm"; metre if absent"""


class BoxBody(Section):
    """A rectangular body."""

    material: Name
    """the name of a table [materials.NAME]"""
    box: Box
    """{ thickness, length, height, base }"""


class ProfileBody(Section):
    """A polygon in the x-z plane, extruded along y and centred on y = 0."""

    material: Name
    """the name of a table [materials.NAME]"""
    profile: Annotated[tuple[PlanePoint, ...], Field(min_length=3)]
    """corners of the polygon [[x, z], …] in order"""
    length: PositiveLength
    """length along y, like "3.0 m\""""


class DirectBody(Section):
    """A body by its mass, centroid and inertia, without geometry."""

    mass: PositiveMass
    """mass, like "12000 kg\""""
    centroid: PlanePoint
    """centre of mass [x, z]"""
    inertia: PositiveInertia
    """moment of inertia about the centroid, like "5200 kg*m^2\""""


Body = MeshBody | BoxBody | ProfileBody | DirectBody
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


# ---------------------------------------------------------------- mechanisms


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


def _block_names(value: Any) -> Any:
    """Each entry of `blocks` as a tuple of bodies that move as one."""
    return [[entry] if isinstance(entry, str) else entry for entry in value] if isinstance(value, list) else value


BlockNames = Annotated[tuple[Name, ...], Field(min_length=1), AfterValidator(unique("body"))]


class SingleBlock(Section):
    """One block that rocks about its base."""

    planned: ClassVar[Mapping[str, str]] = {
        "cut": "model what lies above the crack as its own body",
        "interface": "the interface is rigid; remove it",
        "interfaces": "the interface is rigid; remove it",
        "loads": "loads come later; remove it",
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
    sides: Literal["one", "two"] = "two"
    """"two", or "one": positive rotation only, the building behind stops the other"""
    hinges: Hinges | None = None
    """hinge of positive rotation; the extreme line of the base if absent"""
    hinges_negative: Hinges | None = None
    """hinge of negative rotation; the extreme line of the base if absent"""
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


# ---------------------------------------------------------------- records, analysis, report


class Synthetic(Section):
    """Artificial records that fit the site's spectrum."""

    count: Annotated[Count, Field(le=1000)] = 7
    """how many"""
    seed: Annotated[StrictInt, Field(ge=0)] = 1
    """of the random numbers: the same seed makes the same records"""
    duration: Annotated[PositiveTime, Field(ge=8, le=600)] = 20.0
    """length of each record, like "20 s\""""


class Records(Section):
    """The ground motions: from files, artificial, or both; artificial ones where nothing is said."""

    planned: ClassVar[Mapping[str, str]] = {"select": "list the files you want; remove it"}

    files: InputFiles = ()
    """PEER AT2 or CSV files, names or patterns relative to the project file"""
    unit: AccelerationUnit | None = None
    """unit of acceleration, only for files that do not say theirs"""
    synthetic: Synthetic | None = Field(default_factory=lambda values: None if values["files"] else Synthetic())
    """{ count, seed, duration } of artificial records"""
    scale_to: Literal["spectrum", "pga", "none"] = "spectrum"
    """scale each record to the "spectrum" (least squares), to its "pga", or "none"; levels then multiply"""


class Analysis(Section):
    """What is asked."""

    planned: ClassVar[Mapping[str, str]] = {"pulses": "overturning envelopes come later; remove it"}

    levels: Annotated[tuple[PositiveAcceleration, ...], Field(min_length=1), AfterValidator(unique("level"))] | None = (
        None
    )
    """peak ground accelerations at which demands are compared; the site's own if absent"""
    procedures: Annotated[tuple[Procedure, ...], Field(min_length=1), AfterValidator(unique("procedure"))] = PROCEDURES
    """code procedures to apply; all if absent"""
    equation: Literal["exact", "linearised"] | None = None
    """equation of motion of the histories; if absent exact, and linearised for equivalent blocks"""


class Dmi2008(Section):
    """Options of the Italian procedure (NTC 2008 with Circolare 617/2009)."""

    confidence_factor: Annotated[Ratio, Field(ge=1)] = 1.0
    """FC of the level of knowledge: LC1 1.35, LC2 1.20, LC3 1.00"""
    limit_states: Annotated[
        tuple[Literal["SLD", "SLV"], ...], Field(min_length=1), AfterValidator(unique("limit state"))
    ] = ("SLV",)
    """limit states to check"""


class Procedures(Section):
    """Options of the code procedures, one table each."""

    dmi2008: Dmi2008 = Field(default_factory=Dmi2008)
    """options of dmi2008-linear and dmi2008-nonlinear"""


class Report(Section):
    """How the report looks."""

    units: Literal["SI"] = "SI"
    """units of the report"""
    paper: Literal["A4", "letter"] = "A4"
    """paper size"""


# ---------------------------------------------------------------- the whole


def _text_or_date(value: Any) -> Any:
    return value.isoformat() if isinstance(value, date) else value


class Content(Section):
    """All a project file says."""

    format: StrictInt = 1
    """version of this format"""
    title: StrictStr = ""
    """title of the report"""
    engineer: StrictStr = ""
    """who made the assessment"""
    checker: StrictStr = ""
    """who checked it"""
    reference: StrictStr = ""
    """the office's number of the job"""
    client: StrictStr = ""
    """for whom"""
    date: Annotated[StrictStr, BeforeValidator(_text_or_date)] = ""
    """date of the report"""
    notes: StrictStr = ""
    """remarks for the report"""
    masonry_quality: StrictStr = ""
    """the engineer's judgement of the masonry, for the report"""
    site: Site | None = None
    """a table [site] with the spectrum"""
    building: Building | None = None
    """a table [building], for mechanisms above ground"""
    materials: dict[Name, Material] = Field(default_factory=dict)
    """a table [materials.NAME] for each material"""
    bodies: dict[Name, BodySection] = Field(default_factory=dict)
    """a table [bodies.NAME] for each body"""
    mechanisms: Annotated[dict[Name, MechanismSection], Field(min_length=1)]
    """add a table [mechanisms.NAME] for each way to collapse"""
    records: Records = Field(default_factory=Records)
    """a table [records]"""
    analysis: Analysis = Field(default_factory=Analysis)
    """a table [analysis]"""
    procedures: Procedures = Field(default_factory=Procedures)
    """tables [procedures.CODE] with options"""
    report: Report = Field(default_factory=Report)
    """a table [report]"""

    @model_validator(mode="after")
    def _names_exist(self) -> Content:
        for name, body in self.bodies.items():
            if not isinstance(body, DirectBody) and body.material not in self.materials:
                raise wrong(("bodies", name, "material"), f"no such material; {_known('materials', self.materials)}")
        for name, mechanism in self.mechanisms.items():
            for body_name in mechanism.blocks[0] if isinstance(mechanism, SingleBlock) else ():
                if body_name not in self.bodies:
                    raise wrong(("mechanisms", name, "blocks"), f"no such body; {_known('bodies', self.bodies)}")
        return self


def _known(table: str, names: Mapping[str, Any]) -> str:
    return f"known: {listed(names)}" if names else f"add a table [{table}.NAME]"
