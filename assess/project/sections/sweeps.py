"""The table [analysis.sweep], or several of them, [[analysis.sweep]]."""

from __future__ import annotations

from typing import Annotated, Any

from pydantic import (
    AfterValidator,
    Discriminator,
    Field,
    PlainValidator,
    StrictInt,
    StrictStr,
    Tag,
    WithJsonSchema,
    model_validator,
)

from assess.project.quantities import unique
from assess.project.section import Section, wrong

MOST = 1000  # cases of one sweep


def _a_quantity(value: Any) -> Any:
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        raise ValueError("not a number or a quantity; write one as at the key that is swept")
    return value


Quantity = Annotated[int | float | str, PlainValidator(_a_quantity), WithJsonSchema({"type": ["number", "string"]})]


class Sweep(Section):
    """A parametric study: the mechanisms that one number of the project changes, for each of several values of it."""

    key: StrictStr
    """a number of this file by its key: "mechanisms.spire.cut.angle"; loads.0 or loads[1] is the first of a list"""
    values: Annotated[tuple[Quantity, ...], Field(min_length=1, max_length=MOST), AfterValidator(unique("value"))] = ()
    """its values, like ["45 deg", "60 deg"]; or give from, to and count"""
    start: Quantity | None = Field(None, alias="from")
    """the first of evenly spaced values"""
    to: Quantity | None = None
    """the last of them"""
    count: Annotated[StrictInt, Field(ge=2, le=MOST)] | None = None
    """how many, with both ends"""

    @model_validator(mode="after")
    def _values_or_range(self) -> Sweep:
        given = {"from": self.start, "to": self.to, "count": self.count}
        absent = [key for key, value in given.items() if value is None]
        if self.values and len(absent) < len(given):
            raise wrong("values", "beside from, to or count; give either the values or a range")
        if not self.values and absent:
            raise wrong(absent[0], "missing; give values = [ … ], or from, to and count")
        return self


def _form(value: Any) -> str:
    return "<several>" if isinstance(value, list | tuple) else "<one>"


Sweeps = Annotated[
    Annotated[Sweep, Tag("<one>")] | Annotated[tuple[Sweep, ...], Tag("<several>")],
    Discriminator(_form),
]
