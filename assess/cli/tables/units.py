"""Units of the terminal: SI, or US units as the report writes them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import TypeVar

from assess.messages.message import UNITS as SI_UNITS
from assess.messages.message import Message, Quantity, Value, with_values
from assess.results import Results
from reports.language.locale import Locale, System

T = TypeVar("T")
_SYSTEM: ContextVar[System] = ContextVar("system of units of the terminal", default="SI")


@contextmanager
def units_on_terminal(system: System) -> Iterator[None]:
    """Print what `in_units` and `column` write in a system of units."""
    before = _SYSTEM.set(system)
    try:
        yield
    finally:
        _SYSTEM.reset(before)


def in_units(si: str, value: float, dimension: str, figures: int = 4) -> str:
    """Return a quantity in the units of the terminal.

    Parameters
    ----------
    si : its text in SI, which is printed as it is
    value, dimension, figures : of the quantity, in SI, elsewhere
    """
    return si if _SYSTEM.get() == "SI" else str(_UsQuantity(value, dimension, figures))


def column(value: float, dimension: str, form: str) -> str:
    """Return a number of a column in the units of the terminal; form : as of `format`."""
    return format(value / (1.0 if _SYSTEM.get() == "SI" else Locale(system="US").table_unit(dimension).size), form)


def header(label: str, dimension: str) -> str:
    """Return a heading with the unit of `column`: "R [m]", "mass [lb]"."""
    unit = SI_UNITS[dimension] if _SYSTEM.get() == "SI" else Locale(system="US").table_unit(dimension).name
    return f"{label} [{unit or '-'}]"


def messages_in_units(messages: tuple[Message, ...]) -> tuple[Message, ...]:
    """Return messages with their quantities in the units of the terminal."""
    return messages if _SYSTEM.get() == "SI" else _in_us_units(messages)


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
