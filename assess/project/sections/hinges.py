"""The keys `hinges` and `joints` of a mechanism."""

from __future__ import annotations

from typing import Annotated, Any, Literal, Self

from pydantic import (
    BeforeValidator,
    Discriminator,
    Field,
    StrictInt,
    Tag,
    model_validator,
)

from assess.model.ranges import MOST_VOUSSOIRS
from assess.project.quantities import Angle, Coordinate, PlanePoint, a_point
from assess.project.section import Section, wrong
from assess.project.sections.uncertain_number import UNCERTAIN_COORDINATE

Place = Annotated[Coordinate, UNCERTAIN_COORDINATE]
UncertainPoint = Annotated[tuple[Place, ...], BeforeValidator(a_point), Field(min_length=2, max_length=3)]


class Hinges(Section):
    """Where a block turns: [x, y, z], or [distance along the direction, elevation]."""

    A: UncertainPoint
    """the base hinge"""


class ThreeHinges(Hinges):
    """Hinges of a wall of two blocks."""

    B: UncertainPoint
    """at the crack"""
    C: UncertainPoint
    """at the top"""


class FourHinges(ThreeHinges):
    """Hinges of three blocks."""

    D: UncertainPoint
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
