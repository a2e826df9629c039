"""The keys `cut` and `crack` of a mechanism."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import (
    BeforeValidator,
    Discriminator,
    Tag,
    WithJsonSchema,
    model_validator,
)

from assess.model.ranges import CRACKS
from assess.project.quantities import Inclination, Length, Ratio, SpacePoint, quantity_schema
from assess.project.section import Section, quote_names, wrong
from assess.project.units import KINDS, key_value


def _crack(value: Any) -> float | str:
    if isinstance(value, str) and value in CRACKS:
        return value
    if isinstance(value, str) and not any(letter.isdigit() for letter in value):
        raise ValueError(f"not a crack; write an elevation, or one of {quote_names(CRACKS)}")
    return key_value(value, KINDS["length"])


Crack = Annotated[
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
