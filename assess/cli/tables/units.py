"""What the terminal says of a project in US units: the quantities within its messages, as the report writes them."""

from __future__ import annotations

from dataclasses import dataclass, fields, is_dataclass, replace
from typing import TypeVar

from assess.messages.message import Message, Quantity, Value, with_values
from assess.results import Results
from reports.language.locale import Locale

T = TypeVar("T")


def in_units_of_project(results: Results) -> Results:
    """Return results with the quantities of their messages in US units, where the project asks for them."""
    asked = results.project.get("report.units")
    if asked is None or asked.value != "US":
        return results
    return replace(
        results,
        verdict=_in_us_units(results.verdict),
        warnings=_in_us_units(results.warnings),
        mechanisms=tuple(replace(each, checks=_in_us_units(each.checks)) for each in results.mechanisms),
    )


@dataclass(frozen=True)
class _UsQuantity(Quantity):
    """A quantity whose text is in US units."""

    def __str__(self) -> str:
        shown = Quantity(self.value, self.dimension, self.figures)
        return Locale(system="US").text(shown).replace("\u00a0", " ").replace("−", "-")


def _message(given: Message) -> Message:
    return with_values(given, {name: _value(value) for name, value in given.values.items()})


def _value(value: Value) -> Value:
    if isinstance(value, Quantity):
        return _UsQuantity(value.value, value.dimension, value.figures)
    return _message(value) if isinstance(value, Message) else value


def _in_us_units(data: T) -> T:
    """Return data with every message in it in US units."""
    if isinstance(data, Message):
        return _message(data)  # type: ignore[return-value]  # a message, as given
    if isinstance(data, tuple):
        return tuple(map(_in_us_units, data))  # type: ignore[return-value]  # of the same kind
    if is_dataclass(data) and not isinstance(data, type):
        return replace(data, **{each.name: _in_us_units(getattr(data, each.name)) for each in fields(data)})
    return data
