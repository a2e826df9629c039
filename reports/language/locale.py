"""A language and a system of units: what turns the texts of a document into letters, once, from whole values.

`numeral` is the one place where a number is rounded for a reader.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import singledispatchmethod
from math import isfinite

from assess.messages.message import Message, Quantity
from assess.messages.texts import TEXTS
from reports.language.catalogue import ENGLISH, decimal_point, read_catalogue
from reports.language.texts import Kind, Listing, Paragraph, Phrase, Reference, Term, Text, Verbatim
from reports.language.units import UNIT_WORDS, UNITS, System, Unit

_NARROW = "\u00a0"  # between a number and its unit and within units, so that no line breaks there
FIGURES = 4


@dataclass(frozen=True)
class Locale:
    """How a reader wants texts and numbers.

    language : code of a catalogue, "en" for none
    system : of units
    titles : numbers of figures, tables and sheets by kind and name, for references
    """

    language: str = ENGLISH
    system: System = "SI"
    titles: Mapping[tuple[Kind, str], int] = field(default_factory=dict)

    def with_titles(self, titles: Mapping[tuple[Kind, str], int]) -> Locale:
        """Return this locale for a document whose blocks are numbered so."""
        return replace(self, titles=titles)

    def word(self, english: str) -> str:
        """Return an entry of the catalogue: the words in the language, or the English ones where it has no entry."""
        return read_catalogue(self.language).gettext(english)

    @property
    def point(self) -> str:
        """The decimal sign."""
        return decimal_point(self.language)

    @singledispatchmethod
    def text(self, text: Text) -> str:
        """Return a text in letters. Raises TypeError for what is no text of a document."""
        raise TypeError(f"{type(text).__name__}: not a text of a document")

    @text.register
    def _(self, text: Verbatim) -> str:
        return text.text

    @text.register
    def _(self, text: Term) -> str:
        return self.word(text.english)

    @text.register
    def _(self, text: Phrase) -> str:
        entry = self.word(text.english)
        if text.plural:
            entry = read_catalogue(self.language).ngettext(text.english, text.plural, text.number)
        return entry.format(**{name: self.text(value) for name, value in text.values.items()})

    @text.register
    def _(self, text: Message) -> str:
        english = TEXTS.get(text.key)
        if english is None or _fill_entry(english, text) != text.text:  # made by another version
            return text.text
        filled = {name: value if isinstance(value, str) else self.text(value) for name, value in text.values.items()}
        return self.word(english).format(**filled)

    @text.register
    def _(self, text: Quantity) -> str:
        unit = UNITS[self.system][text.dimension].of(text.value)
        return self.with_unit(numeral(text.value / unit.size, figures=text.figures, point=self.point), unit)

    @text.register
    def _(self, text: Listing) -> str:
        written = [self.text(each) for each in text.texts]
        comma = "; " if any(", " in each or (self.point == "," in each) for each in written) else ", "
        if len(written) < 2 or not text.join:
            return comma.join(written)
        last = {"and": "{first} and {last}", "or": "{first} or {last}"}[text.join]
        return self.word(last).format(first=comma.join(written[:-1]), last=written[-1])

    @text.register
    def _(self, text: Paragraph) -> str:
        return " ".join(self.text(each) for each in text.sentences)

    @text.register
    def _(self, text: Reference) -> str:
        return self.title(text.kind, text.name)

    def title(self, kind: Kind, name: str) -> str:
        """Return the title of a block: "Figure 5"."""
        return f"{self.word(kind)}{_NARROW}{self.titles[kind, name]}"

    def number(self, value: float, *, figures: int = FIGURES, aligned: bool = False) -> str:
        """Return a number without a unit."""
        return numeral(value, figures=figures, aligned=aligned, point=self.point)

    def table_unit(self, dimension: str) -> Unit:
        """Return the unit of a column or of an axis."""
        return UNITS[self.system][dimension].table

    def unit_name(self, unit: Unit) -> str:
        """Return the name of a unit in the language."""
        return self.word(unit.name) if unit.name in UNIT_WORDS else unit.name

    def with_unit(self, number: str, unit: Unit) -> str:
        """Return a number and its unit: 1.234 m, 30°."""
        if not unit.name:
            return number
        return number + ("" if unit.name == "°" else _NARROW) + self.unit_name(unit).replace(" ", _NARROW)

    def heading(self, label: Text, dimension: str) -> str:
        """Return the label of a column or an axis with its unit: "rotation [rad]"."""
        unit = self.unit_name(self.table_unit(dimension)) if dimension else ""
        return f"{self.text(label)} [{unit or '-'}]" if dimension else self.text(label)


def _fill_entry(english: str, message: Message) -> str | None:
    """Return an entry with the values of a message; None where it has other gaps."""
    try:
        return english.format(**message.values)
    except KeyError:
        return None


_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
_NOT_FINITE = {"inf": "∞", "-inf": "−∞", "nan": "—"}


def numeral(value: float, *, figures: int = FIGURES, aligned: bool = False, point: str = ".") -> str:
    """Return `value` to so many significant figures: 0.1, 12.34, 456700, 1.234×10⁶.

    Parameters
    ----------
    value : the number
    figures : significant figures
    aligned : keep zeros at the end, 0.1000, as in a column
    point : the decimal sign
    """
    if not isfinite(value):
        return _NOT_FINITE[str(float(value))]
    mantissa, power = f"{value:.{figures - 1}e}".split("e")
    exponent = int(power)
    whole = value == round(value) and abs(value) < 1e6
    if value == 0 or (whole and figures > exponent and not aligned):
        return f"{value:.0f}".replace("-", "−") if value else "0"
    places = decimals(value, figures=figures)
    if places is not None:
        return _with_decimal_sign(f"{float(f'{mantissa}e{power}'):.{places}f}", aligned=aligned, point=point)
    return f"{_with_decimal_sign(mantissa, aligned=aligned, point=point)}×10{str(exponent).translate(_SUPERSCRIPT)}"


def decimals(value: float, *, figures: int) -> int | None:
    """Return the decimals that show a finite number to so many significant figures; None for a power of ten."""
    exponent = int(f"{value:.{figures - 1}e}".split("e")[1])
    return max(0, figures - 1 - exponent) if -4 <= exponent < 6 else None


def _with_decimal_sign(text: str, *, aligned: bool, point: str) -> str:
    shorter = text if aligned or "." not in text else text.rstrip("0").rstrip(".")
    return shorter.replace("-", "−").replace(".", point)
