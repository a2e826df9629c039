"""A number given by its mean and its scatter, `{ mean, cov }`, and the mark of the keys that take one."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, pi
from typing import Annotated, Any

from pydantic import Field, GetJsonSchemaHandler, PlainValidator, StrictStr, WithJsonSchema, model_validator
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema

from assess.project.quantities import Name, Ratio, quantity_schema
from assess.project.quantity_patterns import MARK as PATTERN
from assess.project.section import Section, wrong
from assess.results.uncertainty import Distribution

MARK = "or { mean, cov }"
"""Stands in the schema of a marked key until `with_uncertain_numbers` has replaced it."""


@dataclass(frozen=True)
class Uncertain:
    """The mark of a key whose number may be `{ mean, cov }`.

    most : the largest size that it can have [SI]; crosses_zero : whether its values may change sign, as coordinates
    """

    most: float = inf
    crosses_zero: bool = False

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        return {**handler(schema), MARK: True}


UNCERTAIN = Uncertain()
UNCERTAIN_COORDINATE = Uncertain(crosses_zero=True)
UNCERTAIN_RESTITUTION = Uncertain(most=1.0)
UNCERTAIN_UPLIFT = Uncertain(most=pi / 2.0)


def _a_quantity(value: Any) -> Any:
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        raise ValueError("not a number or a quantity; write it as without scatter")
    return value


Quantity = Annotated[int | float | str, PlainValidator(_a_quantity), WithJsonSchema({"type": ["number", "string"]})]


class UncertainNumber(Section):
    """A number that is not well known; without [analysis.uncertainty] its mean is used."""

    mean: Quantity
    """its mean, written as at any key, like "0.60 m\""""
    cov: Annotated[Ratio, Field(gt=0, lt=1)] | None = None
    """coefficient of variation, standard deviation over mean, like 0.05; or give sd"""
    sd: Quantity | None = None
    """standard deviation in the unit of the key, like "2 cm", in place of cov"""
    distribution: Distribution | None = None
    """"lognormal" (if absent; of coordinates "normal"), "normal" or "uniform" over mean (1 ± √3 cov)"""
    group: Annotated[Name, StrictStr] | None = None
    """numbers of one group vary together; each by itself if absent"""

    @model_validator(mode="after")
    def _one_scatter(self) -> UncertainNumber:
        if (self.cov is None) == (self.sd is None):
            raise wrong("cov", "give either cov, a share of the mean like 0.05, or sd, in the unit of the mean")
        return self


def with_uncertain_numbers(schema: dict[str, Any]) -> dict[str, Any]:
    """Return the JSON Schema of a project file with { mean, cov } allowed at every key that is marked."""
    defined: dict[str, Any] = {}

    def allow(node: Any) -> Any:
        if isinstance(node, list):
            return [allow(each) for each in node]
        if not isinstance(node, dict):
            return node
        plain = {key: allow(each) for key, each in node.items() if key != MARK}
        if MARK not in node:
            return plain
        kept = {key: plain.pop(key) for key in ("description", "title", "default") if key in plain}
        kind = _kind(plain)
        name = f"{UncertainNumber.__name__}-of-{kind}".replace(" ", "-")
        defined[name] = _table(kind)
        return {"anyOf": [plain, {"$ref": f"#/$defs/{name}"}], **kept} if plain else kept

    found = allow(schema)
    return {**found, "$defs": {**found["$defs"], **dict(sorted(defined.items()))}}


def _kind(node: dict[str, Any]) -> str:
    """Return the kind of quantity that a key holds, a ratio where it has no unit, as a restitution."""
    marks = (each[PATTERN] for each in (node, *node.get("anyOf", ())) if PATTERN in each)
    kind: str = next(marks, ("ratio",))[0]
    return kind


def _table(kind: str) -> dict[str, Any]:
    """Return the schema of an uncertain number of a kind of quantity."""
    schema = UncertainNumber.model_json_schema()
    mean, sd = (schema["properties"][key] for key in ("mean", "sd"))
    mean.update(quantity_schema(kind))
    sd["anyOf"][0].update(quantity_schema(kind))
    return schema
