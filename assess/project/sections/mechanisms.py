"""The tables [mechanisms.NAME], with their hinges, cuts, interfaces, restitution and amplification."""

from __future__ import annotations

from dataclasses import fields
from functools import reduce
from operator import or_
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, cast

from pydantic import BeforeValidator, Discriminator, Field, StrictStr, Tag, WithJsonSchema, model_validator

from assess.declaration import (
    UNCERTAIN_COORDINATE,
    UNCERTAIN_RESTITUTION,
    Coordinate,
    Drawn,
    Evidence,
    IsPlace,
    Length,
    Name,
    NotNegativeLength,
    PositiveFrequency,
    PositiveLength,
    PositiveRatio,
    Range,
    Safe,
    Several,
    Tried,
    annotations_of,
)
from assess.interfaces.contact import Interface
from assess.loads.load import Place
from assess.mechanisms.assembly import MechanismKind
from assess.mechanisms.kinds import MECHANISM_KINDS
from assess.mechanisms.mechanism import DRAWN_HINGES, BlockMechanism
from assess.mechanisms.restitution import RESTITUTION_NUMBER, RESTITUTIONS, Restitution
from assess.messages.message import Term
from assess.project.key_errors import error_at, quote_names
from assess.project.section import DeclaredSection, OrValue, ProjectSection, table_of
from assess.project.sections.bodies_and_loads import Disintegration, LoadSection
from assess.project.values import CHECKLIST, ItemKeys


def _block_names(value: Any) -> Any:
    """Write each entry of `blocks` as a list of bodies that move as one."""
    return [[entry] if isinstance(entry, str) else entry for entry in value] if isinstance(value, list) else value


BlockNames = Annotated[
    tuple[Name, ...],
    Several(1, unlike="body"),
    WithJsonSchema({"anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}, "minItems": 1}]}),
]
Blocks = Annotated[tuple[BlockNames, ...], BeforeValidator(_block_names)]


HingeCoordinate = Annotated[Coordinate, UNCERTAIN_COORDINATE]
UncertainPoint = Annotated[tuple[HingeCoordinate, ...], IsPlace()]


class HingesSection(ProjectSection):
    """Where a block turns: [x, y, z], or [distance along the direction, elevation]."""

    evidence = DRAWN_HINGES

    A: UncertainPoint
    """the base hinge"""

    @property
    def plain(self) -> tuple[Place, ...]:
        """The hinges, from A on."""
        return tuple(at for _, at in self)


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


HingeName = Annotated[StrictStr, WithJsonSchema({"enum": list("ABCD"), "type": "string"})]
"""Which hinges a mechanism has is among its faults."""


if TYPE_CHECKING:
    RestitutionKeys = DeclaredSection
else:
    RestitutionKeys = table_of(Restitution)


class RestitutionSection(RestitutionKeys):
    """Velocity after over velocity before the impact that ends a rotation, for each direction."""

    @model_validator(mode="before")
    @classmethod
    def _one_for_both(cls, value: Any) -> Any:
        if isinstance(value, list):
            raise error_at((), RESTITUTION_NUMBER.form)
        return value if isinstance(value, dict | RestitutionSection) else {"positive": value, "negative": value}


ONE_FOR_BOTH = OrValue(
    annotations_of(Restitution)["positive"],
    {"type": "number", "minimum": 0, "maximum": 1},
    {"enum": list(RESTITUTIONS)},
)
"""The mark of a restitution that may be one value for both directions."""


AMPLIFIED = Evidence("chosen", "either", "the other methods that can be computed stand beside it")
FIRST_MODE = Evidence(
    "measured",
    "either",
    "the worst from it to that of the building, or Rayleigh's",
    safe=Range((Tried(Safe.ABSENT, str(Term("that of the building or Rayleigh's"))),), up_to="own frequency"),
)


class NoAmplification(ProjectSection):
    """The ground's motion as it is."""

    method: Annotated[Literal["none"], AMPLIFIED] = "none"
    """"none\""""


class RaisedAmplification(ProjectSection):
    """What every method that amplifies needs."""

    height: Annotated[
        NotNegativeLength | None, Evidence("drawn", "down", "its base as drawn over the ground", safe=Safe.ABSENT)
    ] = None
    """of the mechanism's base above the ground; by its elevation if absent"""


class FirstModeAmplification(RaisedAmplification):
    """The first mode of the structure, its shape linear in height."""

    method: Annotated[Literal["srss", "srss-relative", "modal-filter"], AMPLIFIED]
    """"srss" (thesis 3.48), "srss-relative" (pulses by 3.47), or "modal-filter": through the first mode"""
    natural_frequency: Annotated[PositiveFrequency | None, FIRST_MODE] = None
    """first natural frequency, like "2.5 Hz"; [building]'s, or Rayleigh's of the bodies if absent"""
    effective_height: Annotated[
        PositiveLength | None,
        Evidence(
            "measured",
            "up",
            "Rayleigh's, or two thirds of the drawn height",
            judged="the higher that resultant, the less the mode moves the mechanism's base",
            safe=Drawn("resultant"),
        ),
    ] = None
    """height of the resultant of the first mode's inertia; [building]'s, or Rayleigh's of the bodies if absent"""


class FloorAmplification(RaisedAmplification):
    """A floor factor of a code, from the height of [building]."""

    method: Annotated[Literal["ec8", "ec8-resonance", "nzs1170.5"], AMPLIFIED]
    """"ec8" (EN 1998-1 4.3.5.2, rigid part), "ec8-resonance" (T_a = T_1), or "nzs1170.5" (8.3)"""


class PrintedAmplification(RaisedAmplification):
    """The floor factor of EN 1998-1 as thesis eq. 3.49 prints it."""

    method: Annotated[Literal["ec8-printed"], AMPLIFIED]
    """"ec8-printed": S [3 (1 + h/H) - 0.5]"""
    soil_factor: Annotated[PositiveRatio, Evidence("code", "down", "the code's factor of the ground type")]
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


class ChainSection(DeclaredSection):
    """A mechanism of blocks."""


class ChainKeys(ProjectSection):
    """What a project file says of a mechanism of blocks in its own form, and of where it stands."""

    first: ClassVar[tuple[str, ...]] = (
        *(field.name for field in fields(BlockMechanism) if not field.name.startswith("hinges")),
        "amplification",
        "base_elevation",
        "examines",
        "kind",
    )
    loads: tuple[LoadSection, ...] = ()
    restitution: Annotated[RestitutionSection, ONE_FOR_BOTH, UNCERTAIN_RESTITUTION] = Field(
        default_factory=RestitutionSection
    )
    interfaces: dict[HingeName, Interface] = Field(default_factory=dict)
    amplification: AmplificationSection = Field(default_factory=NoAmplification)
    """{ method = "srss" | "modal-filter" | "ec8" | "nzs1170.5" | …, height, … }: the motion's way up to its base"""
    base_elevation: Annotated[
        Length | None, Evidence("drawn", "down", "as drawn over the ground", safe=Safe.ABSENT)
    ] = None
    """of its base above the ground, where it is drawn alone and not in its place"""
    examines: Annotated[ItemKeys | None, CHECKLIST] = None
    """what of the report's list of possible mechanisms it examines, like "gable"; if absent, as its kind tells"""


class SingleBlockKeys(ChainKeys):
    """What a project file says of one block in its own form."""

    blocks: Annotated[Blocks, Several(1, 1)]
    hinges: HingesSection | None = None
    hinges_negative: HingesSection | None = None


class TwoBlockKeys(ChainKeys):
    """What a project file says of a wall of two blocks in its own form."""

    blocks: Annotated[Blocks, Several(1, 2)]
    hinges: ThreeHingesSection | None = None
    hinges_negative: ThreeHingesSection | None = None


class ThreeBlockKeys(ChainKeys):
    """What a project file says of three blocks in its own form."""

    blocks: Annotated[Blocks, Several(1, 3)]
    hinges: FourHingesSection | None = None
    hinges_negative: FourHingesSection | None = None


class FourHingeKeys(ChainKeys):
    """What a project file says of a frame or an arch in its own form."""

    blocks: Annotated[Blocks, Several(1, 3)]
    hinges: ArchHingesValue
    hinges_negative: FourHingesSection | None = None


class EquivalentBlockKeys(ProjectSection):
    """What a project file says beside published parameters."""

    first: ClassVar = ("kind", "p", "uplift", "radius", "label", "sides", "restitution", "mass", "disintegration")
    restitution: Annotated[RestitutionSection, ONE_FOR_BOTH, UNCERTAIN_RESTITUTION] = Field(
        default_factory=RestitutionSection
    )
    disintegration: Disintegration = None
    """whether its masonry may fall apart: "excluded" (by survey, quality index or test) or "possible\""""
    amplification: AmplificationSection = Field(default_factory=NoAmplification)
    """{ method = "srss" | "modal-filter" | "ec8" | "nzs1170.5" | …, height, … }: the motion's way up to its base"""
    examines: Annotated[ItemKeys | None, CHECKLIST] = None
    """what of the report's list of possible mechanisms it examines, like "gable\""""


BLOCK_KEYS: dict[int, type[ProjectSection]] = {1: SingleBlockKeys, 2: TwoBlockKeys, 3: ThreeBlockKeys}
"""The keys that a project file writes in a form of its own, by the number of blocks of a mechanism."""
FILE_KEYS: dict[str, type[ProjectSection]] = {"four-hinge": FourHingeKeys, "equivalent-block": EquivalentBlockKeys}
"""The same of kinds that take other hinges, or are not of blocks."""


def table_of_kind(kind: MechanismKind) -> type[DeclaredSection]:
    """Return what reads the mechanisms of a kind: the keys of its definition, some in a form of the file's own.

    Raises LookupError for a kind that is not of blocks and says nothing of its form.
    """
    of_blocks = issubclass(kind.definition, BlockMechanism)
    keys = FILE_KEYS.get(kind.name)
    if keys is None and of_blocks:
        keys = BLOCK_KEYS[kind.definition.number_of_blocks]
    if keys is None:
        raise LookupError(f'{kind.name}: not a mechanism of blocks; add its keys to FILE_KEYS in "{__name__}"')
    return table_of(cast(Any, kind.definition), ChainSection if of_blocks else DeclaredSection, keys)


MECHANISM_TABLES = {name: table_of_kind(kind) for name, kind in MECHANISM_KINDS.items()}
"""What reads each kind of mechanism."""


def _mechanism_tag(values: Any) -> str | None:
    kind = values.get("kind") if isinstance(values, dict) else None
    return f"<{kind}>" if kind in MECHANISM_TABLES else None


if TYPE_CHECKING:
    MechanismSection = DeclaredSection
else:
    MechanismSection = Annotated[
        reduce(or_, (Annotated[table, Tag(f"<{kind}>")] for kind, table in MECHANISM_TABLES.items())),
        Discriminator(
            _mechanism_tag,
            custom_error_type="choice",
            custom_error_message="write one of {names}",
            custom_error_context={"key": ("kind",), "names": quote_names(MECHANISM_TABLES)},
        ),
    ]
