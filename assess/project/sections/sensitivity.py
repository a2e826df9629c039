"""The table [analysis.sensitivity]: which numbers of each mechanism are varied, and by how much."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Annotated, Any, NamedTuple

from pydantic import BeforeValidator, Field, WithJsonSchema

from assess.project.quantities import Ratio
from assess.project.quantity_patterns import MARK
from assess.project.quantity_patterns import SHARES as UNITS_OF_SHARES
from assess.project.quantity_text import QuantityError, number_and_unit
from assess.project.section import Section
from assess.project.units import KINDS, key_value

SHARES: Mapping[str, float] = {
    "thickness": 0.05,
    "density": 0.10,
    "compressive_strength": 0.30,
    "stiffness": 0.50,
    "friction": 0.20,
    "restitution": 0.05,
    "tie_force": 0.20,
    "loads": 0.20,
    "uplift": 0.05,
    "p": 0.05,
}
"""By how much each parameter is varied where the project does not say it: judgement, not taken from a standard."""

VaryingShare = Annotated[Ratio, Field(ge=0, lt=1)]
SHARE = "share"


class Change(NamedTuple):
    """By how much a number is varied to either side: by a share of it, or by an amount in the SI unit `of`."""

    by: float
    of: str = SHARE


def _change(kind: str) -> Callable[[Any], Any]:
    """Return a reader of one change: a share, an amount with the unit of `kind`, or false for none."""

    def read(value: Any) -> Any:
        if value is False or value is None or isinstance(value, Change):
            return value or None
        try:
            absolute = isinstance(value, str) and number_and_unit(value)[1] not in UNITS_OF_SHARES
            found = Change(key_value(value, KINDS[kind]), KINDS[kind].symbol) if absolute else _share(value)
        except QuantityError:
            raise ValueError(f'not a change; write a share like 0.05 or "5 %"{_or_amount(kind)}, or false') from None
        if found.by < 0:
            raise ValueError("must be 0 or more; it counts to both sides")
        return found

    return read


def _share(value: Any) -> Change:
    share = key_value(value, KINDS["ratio"])
    if share >= 1:
        raise ValueError("must be less than 1; a share of 1 leaves nothing of the number")
    return Change(share)


def _or_amount(kind: str) -> str:
    """Say what may be written besides a share."""
    return "" if kind == "ratio" else f', or an amount like "{KINDS[kind].example}"'


def _described(kind: str) -> WithJsonSchema:
    words = f"a share like 0.05{_or_amount(kind)}; false: not varied"
    return WithJsonSchema({"type": ["number", "string", "boolean"], "description": words, MARK: [kind, "change"]})


def _default(parameter: str) -> Any:
    def share(values: dict[str, Any]) -> Change:
        everywhere = values.get("vary")
        return Change(SHARES[parameter] if everywhere is None else everywhere)

    return Field(default_factory=share)


LengthChange = Annotated[Change | None, BeforeValidator(_change("length")), _described("length")]
DensityChange = Annotated[Change | None, BeforeValidator(_change("density")), _described("density")]
StressChange = Annotated[Change | None, BeforeValidator(_change("stress")), _described("stress")]
ShareChange = Annotated[Change | None, BeforeValidator(_change("ratio")), _described("ratio")]
ForceChange = Annotated[Change | None, BeforeValidator(_change("force")), _described("force")]


class Sensitivity(Section):
    """How the verdicts move with numbers that are not well known, each varied alone to either side; `true` for all."""

    vary: VaryingShare | None = None
    """share by which everything below is varied that has none of its own; each its own default if absent"""
    thickness: LengthChange = _default("thickness")
    """size of the blocks along the direction of motion, about the middle of their base: 0.05, or "2 cm\""""
    density: DensityChange = _default("density")
    """of each material that the mechanism has"""
    compressive_strength: StressChange = _default("compressive_strength")
    """of joints that crush"""
    stiffness: ShareChange = _default("stiffness")
    """of joints that give way, and Young's modulus where something follows from it"""
    friction: ShareChange = _default("friction")
    """of each material that gives one"""
    restitution: ShareChange = _default("restitution")
    """of both branches, at most to 1"""
    tie_force: ForceChange = _default("tie_force")
    """pretension of each tie"""
    loads: ShareChange = _default("loads")
    """masses, forces and overburden that are given as numbers"""
    uplift: ShareChange = _default("uplift")
    """multiplier of an equivalent-block"""
    p: ShareChange = _default("p")
    """frequency parameter of an equivalent-block"""


def _switched(value: Any) -> Any:
    """Replace `true` by the table of defaults and `false` by none."""
    return {} if value is True else None if value is False else value


def _or_switch(schema: dict[str, Any]) -> None:
    schema["anyOf"].append({"type": "boolean"})


Asked = Annotated[Sensitivity | None, BeforeValidator(_switched), Field(json_schema_extra=_or_switch)]
