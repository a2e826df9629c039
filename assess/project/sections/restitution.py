"""The key `restitution` of a mechanism."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import (
    BeforeValidator,
    Field,
    GetJsonSchemaHandler,
    model_validator,
)
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema

from assess.model.ranges import RESTITUTIONS
from assess.project.section import Section, quote_names
from assess.project.sections.uncertain_number import UNCERTAIN_RESTITUTION
from assess.project.units import KINDS, key_value


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


class _OneForBoth:
    """The mark of a key whose one value stands for both directions."""

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        return {
            "anyOf": [handler(schema), {"type": "number", "minimum": 0, "maximum": 1}, {"enum": list(RESTITUTIONS)}]
        }


ONE_FOR_BOTH = _OneForBoth()


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
