"""Messages to the engineer: a key, a severity, a location, values, and the English sentence made from them.

Nothing is decided by reading the sentence: code compares keys.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum
from math import degrees, isfinite

from assess.messages.texts import TEXTS
from assess.short_repr import ShortRepr

UNITS: Mapping[str, str] = {
    "ratio": "-",
    "length": "m",
    "short length": "m",
    "distance": "m",
    "area": "m2",
    "time": "s",
    "velocity": "m/s",
    "mass": "kg",
    "density": "kg/m3",
    "area density": "kg/m2",
    "force": "N",
    "moment": "N m",
    "energy": "J",
    "rotational stiffness": "N m/rad",
    "spring stiffness": "N/m",
    "rotation": "rad",
    "angle": "rad",
    "acceleration": "m/s2",
    "ground acceleration": "g",
    "frequency": "Hz",
    "angular frequency": "1/s",
    "inertia": "kg m2",
    "first moment": "kg m",
    "stress": "Pa",
    "stiffness": "Pa/m",
    "volume": "m3",
    "percent": "%",
    "return period": "years",
    "annual rate": "1/year",
}
"""The unit in which values of each dimension are given: SI, but for peak ground accelerations, in g, and years."""

DIMENSIONS: Mapping[str, str] = {unit: dimension for dimension, unit in reversed(tuple(UNITS.items()))}
"""The first dimension of `UNITS` that has a unit."""
PLAIN = 1e9  # numbers below it are written without an exponent


class Severity(StrEnum):
    """The severity of a message: an error prevents an answer, a warning affects it, a note informs."""

    ERROR = "error"
    WARNING = "warning"
    NOTE = "note"


@dataclass(frozen=True)
class Quantity:
    """A number with its dimension, in the unit of `UNITS`, and the significant figures to which it is shown."""

    value: float
    dimension: str = "ratio"
    figures: int = 4

    def __str__(self) -> str:
        unit, value = UNITS[self.dimension], self.value
        if self.dimension == "angle":  # of what is drawn: typed in degrees
            unit, value = "deg", degrees(value) if isfinite(value) else value
        text = f"{value:.{self.figures}g}"
        if "e+" in text and abs(self.value) < PLAIN:
            text = f"{float(text):.0f}"
        return text + (f" {unit}" if unit != "-" else "")


@dataclass(frozen=True, repr=False)
class Term(ShortRepr):
    """Fixed English words, a literal of the program, that a language looks up as they are."""

    english: str

    def __str__(self) -> str:
        return self.english


@dataclass(frozen=True, repr=False)
class Message(ShortRepr):
    """Something the engineer should know. `text` is the English sentence, in SI.

    values : what fills its gaps: numbers, fixed words, other messages; a str is of the user, a name or a symbol, which
        no language changes
    """

    key: str
    severity: Severity
    where: str
    text: str
    values: dict[str, Quantity | Term | Message | str] = field(default_factory=dict)

    def __hash__(self) -> int:
        return hash((self.key, self.where, self.text))

    def __str__(self) -> str:
        return self.text


Value = Quantity | Term | Message | str

Translatable = Term | Message
"""What is said in English that a language can say otherwise."""


def message(
    key: str, values: Mapping[str, Value] | None = None, *, severity: Severity = Severity.NOTE, where: str = ""
) -> Message:
    """Make the message of a key of `TEXTS`.

    Parameters
    ----------
    key : of `TEXTS`
    values : numbers and texts that its sentence names
    severity : error, warning or note
    where : the key of the project file, or the mechanism, that it concerns

    Raises
    ------
    KeyError : the key is unknown or a value is missing
    """
    given = dict(values or {})
    return Message(str(key), severity, where, TEXTS[str(key)].format(**given), given)


def text_of(text: Translatable | str) -> str:
    """Return the English sentence of a message; a text is returned unchanged."""
    return str(text)


def whole_number(number: int) -> Quantity:
    """Return a whole number as a value of a message."""
    return Quantity(float(number), "ratio", 12)


def lengths(**values: float) -> dict[str, Value]:
    """Return lengths and coordinates as values of a message, to a tenth of a millimetre.

    Parameters
    ----------
    values : by the names of the gaps that they fill [m]
    """
    return {name: Quantity(round(float(value), 4) + 0.0, "length", 6) for name, value in values.items()}


def format_key(key: Sequence[str | int]) -> str:
    """Write a key of a project as its messages do, with dots, and items of lists in brackets, from 1.

    Parameters
    ----------
    key : names of tables and keys, and places in lists from 0
    """
    return "".join(f"[{step + 1}]" if isinstance(step, int) else f".{step}" for step in key).lstrip(".")


def distinct(messages: Iterable[Message]) -> tuple[Message, ...]:
    """Return messages in their order, each sentence once.

    Parameters
    ----------
    messages : some of them perhaps alike
    """
    return tuple({each.text: each for each in messages}.values())


def locate(messages: Iterable[Message], where: str) -> tuple[Message, ...]:
    """Return messages with the place that they concern.

    Parameters
    ----------
    messages : without a place
    where : the key of the project file
    """
    return tuple(replace(each, where=where) for each in messages)


def warning(key: str, where: str = "", /, **values: Value) -> Message:
    """Make the warning of a key of `TEXTS`.

    Parameters
    ----------
    key : of `TEXTS`
    where : what it concerns; empty: it is located later
    values : that its sentence names
    """
    return message(key, values, severity=Severity.WARNING, where=where)


def with_values(given: Message, values: Mapping[str, Value]) -> Message:
    """Return a message with other values; as it is where another version made it, in other words.

    Parameters
    ----------
    given : the message
    values : in place of its own
    """
    english = TEXTS.get(given.key, "")
    try:
        is_of_today = english.format(**given.values) == given.text
    except KeyError:
        is_of_today = False
    return replace(given, text=english.format(**values), values=dict(values)) if is_of_today else given


def note(key: str, where: str = "", /, **values: Value) -> Message:
    """Make the note of a key of `TEXTS`, which affects no verdict.

    Parameters
    ----------
    key : of `TEXTS`
    where : what it concerns; empty: it is located later
    values : that its sentence names
    """
    return message(key, values, where=where)


def list_values(first: Value, *others: Value) -> Value:
    """Return several values as one, which a language writes one after the other."""
    return message("listed", {"first": first, "others": list_values(*others)}) if others else first


def count_noun(number: int, noun: str, several: str = "") -> str:
    """Write a number with its noun in the singular or plural: 1 wall, 2 walls.

    Parameters
    ----------
    number : of things
    noun : in the singular
    several : its plural, "" for one in -s
    """
    return f"{number} {noun if number == 1 else several or f'{noun}s'}"


def first_names(names: Sequence[str], most: int) -> str:
    """Write the first of many names with commas, and an ellipsis for the others.

    Parameters
    ----------
    names : at least one
    most : how many are written
    """
    return ", ".join(names[:most]) + (", …" if len(names) > most else "")


def escape_text(text: str) -> str:
    """Escape line breaks and control characters, so that the text stays on one line."""
    return "".join(c if c.isprintable() else c.encode("unicode_escape").decode() for c in text)
