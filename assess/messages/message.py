"""Messages to the engineer: a key, a severity, a location, values, and the English sentence made from them.

Nothing is decided by reading the sentence: code compares keys.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from assess.messages.texts import TEXTS
from assess.short_repr import ShortRepr

UNITS: Mapping[str, str] = {
    "ratio": "-",
    "length": "m",
    "time": "s",
    "mass": "kg",
    "density": "kg/m3",
    "force": "N",
    "moment": "N m",
    "energy": "J",
    "rotational stiffness": "N m/rad",
    "rotation": "rad",
    "acceleration": "m/s2",
    "ground acceleration": "g",
    "frequency": "Hz",
    "inertia": "kg m2",
    "first moment": "kg m",
    "stress": "Pa",
    "area": "m2",
    "area density": "kg/m2",
    "volume": "m3",
    "percent": "%",
    "return period": "years",
}
"""The unit in which values of each dimension are given: SI, but for peak ground accelerations, in g, and years."""
DIMENSIONS: Mapping[str, str] = {unit: dimension for dimension, unit in UNITS.items()}


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
        unit = UNITS[self.dimension]
        return f"{self.value:.{self.figures}g}" + (f" {unit}" if unit != "-" else "")


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

    def __str__(self) -> str:
        return self.text


Value = Quantity | Term | Message | str


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


def text_of(said: Message | str) -> str:
    """Return the English sentence of a message; a text is returned unchanged."""
    return said if isinstance(said, str) else said.text


def whole_number(number: int) -> Quantity:
    """Return a whole number as a value of a message."""
    return Quantity(float(number), "ratio", 12)


def warning(key: str, where: str, **values: Value) -> Message:
    """Make the warning of a key of `TEXTS`.

    Parameters
    ----------
    key : of `TEXTS`
    where : what it concerns
    values : that its sentence names
    """
    return message(key, values, severity=Severity.WARNING, where=where)


def note(key: str, where: str, **values: Value) -> Message:
    """Make the note of a key of `TEXTS`, which affects no verdict.

    Parameters
    ----------
    key : of `TEXTS`
    where : what it concerns
    values : that its sentence names
    """
    return message(key, values, where=where)
