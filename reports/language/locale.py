"""A language and a system of units: what turns the texts of a document into letters, once, from whole values.

`numeral` is the one place where a number is rounded for a reader.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from datetime import date
from functools import cache
from gettext import GNUTranslations, NullTranslations
from io import BytesIO
from math import isfinite, pi
from pathlib import Path
from typing import Literal

from assess.messages.message import Message, Quantity, Value
from assess.messages.texts import TEXTS
from reports.language.client_texts import CLIENT_TERMS, CLIENT_TEXTS, client_value
from reports.language.texts import Date, Kind, Listing, Paragraph, Phrase, Reference, Term, Text, Verbatim
from spectra.gravity import g

_NARROW = "\u00a0"  # between a number and its unit and within units, so that no line breaks there
FIGURES = 4
System = Literal["SI", "US"]
ENGLISH = "en"
FOLDER = Path(__file__).parent / "catalogues"


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

    def text(self, text: Text) -> str:
        """Return a text in letters. Raises TypeError for what is no text of a document."""
        match text:
            case Verbatim():
                return text.text
            case Date():
                return long_date(text.text, self.language if self.language != ENGLISH else _ENGLISH_OF[self.system])
            case Quantity():
                unit = UNITS[self.system][text.dimension].unit_for(text.value)
                return self.with_unit(numeral(text.value / unit.size, figures=text.figures, point=self.point), unit)
            case Term():
                client = CLIENT_TERMS.get(text.english)
                return self.word(text.english if client is None else client.english)
            case Phrase():
                entry = self.word(text.english)
                if text.plural:
                    entry = read_catalogue(self.language).ngettext(text.english, text.plural, text.number)
                return entry.format(**{name: self.text(value) for name, value in text.values.items()})
            case Message():
                return self._message(text)
            case Listing():
                return self._listing(text)
            case Paragraph():
                return " ".join(self.text(each) for each in text.sentences)
            case Reference():
                return self.title(text.kind, text.name)
        raise TypeError(f"{type(text).__name__}: not a text of a document")

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

    def _message(self, text: Message) -> str:
        english = TEXTS.get(text.key)
        if english is None or _fill_entry(english, text) != text.text:  # made by another version
            return text.text
        client = CLIENT_TEXTS.get(text.key)
        filled = {name: self._value(value) for name, value in text.values.items()}
        return self.word(english if client is None else client.english).format(**filled)

    def _value(self, value: Value) -> str:
        words = client_value(value) if isinstance(value, str) else value
        return str(value) if words is None else self.text(words)

    def _listing(self, text: Listing) -> str:
        written = [self.text(each) for each in text.texts]
        comma = "; " if any(", " in each or (self.point == "," in each) for each in written) else ", "
        if len(written) < 2 or not text.join:
            return comma.join(written)
        last = {"and": "{first} and {last}", "or": "{first} or {last}"}[text.join]
        return self.word(last).format(first=comma.join(written[:-1]), last=written[-1])


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


FOOT, INCH, MILE = 0.3048, 0.0254, 1609.344  # m, exact: international yard and pound, 1959
POUND = 0.45359237  # kg, exact by the same agreement
LBF = POUND * g
KIP, PSI = 1e3 * LBF, LBF / INCH**2


@dataclass(frozen=True)
class Unit:
    """A unit. size : of one of them in the SI unit of its dimension."""

    name: str
    size: float = 1.0


@dataclass(frozen=True)
class DimensionUnits:
    """The units of one dimension in one system: that of tables, and those of single numbers, the smallest first."""

    table: Unit
    single: tuple[Unit, ...]

    def unit_for(self, value: float) -> Unit:
        """Return the unit of a single number: the largest of which there is at least one."""
        return next((unit for unit in reversed(self.single) if abs(value) >= unit.size), self.single[0])


def _one(name: str, size: float = 1.0) -> DimensionUnits:
    return DimensionUnits(Unit(name, size), (Unit(name, size),))


def _several(table: str, **sizes: float) -> DimensionUnits:
    units = tuple(Unit(name.replace("_", " "), size) for name, size in sizes.items())
    return DimensionUnits(next(unit for unit in units if unit.name == table), units)


_PER_METRE = DimensionUnits(
    Unit("GPa/m", 1e9), (Unit("Pa/m"), Unit("kPa/m", 1e3), Unit("MPa/m", 1e6), Unit("GPa/m", 1e9))
)
_SI: Mapping[str, DimensionUnits] = {
    "ratio": _one(""),
    "percent": _one("%"),
    "length": _one("m"),
    "short length": _one("mm", 1e-3),
    "distance": _one("km", 1e3),
    "area": _one("m²"),
    "volume": _one("m³"),
    "time": _one("s"),
    "velocity": _one("m/s"),
    "acceleration": _one("m/s²"),
    "ground acceleration": _one("g"),
    "frequency": _one("Hz"),
    "rotation": _one("rad"),
    "angle": _one("°", pi / 180.0),
    "angular frequency": _one("1/s"),
    "mass": _several("kg", kg=1.0, t=1e3),
    "inertia": _several("kg m²", **{"kg m²": 1.0, "t m²": 1e3}),
    "first moment": _several("kg m", **{"kg m": 1.0, "t m": 1e3}),
    "density": _one("kg/m³"),
    "weight density": _one("kN/m³", 1e3),
    "area density": _one("kg/m²"),
    "force": _several("kN", N=1.0, kN=1e3, MN=1e6),
    "moment": _several("kN m", N_m=1.0, kN_m=1e3, MN_m=1e6),
    "energy": _several("kJ", J=1.0, kJ=1e3, MJ=1e6),
    "stress": _several("MPa", Pa=1.0, kPa=1e3, MPa=1e6, GPa=1e9),
    "stiffness": _PER_METRE,
    "rotational stiffness": _several("kN m/rad", **{"N m/rad": 1.0, "kN m/rad": 1e3, "MN m/rad": 1e6}),
    "spring stiffness": _several("MN/m", **{"N/m": 1.0, "kN/m": 1e3, "MN/m": 1e6}),
    "return period": _one("years"),
    "annual rate": _one("1/year"),
}
_US: Mapping[str, DimensionUnits] = {
    "length": _one("ft", FOOT),
    "short length": _one("in", INCH),
    "distance": _one("mi", MILE),
    "area": _one("ft²", FOOT**2),
    "volume": _one("ft³", FOOT**3),
    "velocity": _one("ft/s", FOOT),
    "acceleration": _one("g", g),
    "mass": _one("lb", POUND),
    "inertia": _one("lb ft²", POUND * FOOT**2),
    "first moment": _one("lb ft", POUND * FOOT),
    "density": _one("lb/ft³", POUND / FOOT**3),
    "weight density": _one("lbf/ft³", LBF / FOOT**3),
    "area density": _one("lb/ft²", POUND / FOOT**2),
    "force": _one("kip", KIP),
    "moment": _one("kip ft", KIP * FOOT),
    "energy": _one("kip ft", KIP * FOOT),
    "stress": _several("psi", psi=PSI, ksi=1e3 * PSI),
    "stiffness": _several("psi/in", **{"psi/in": PSI / INCH, "ksi/in": 1e3 * PSI / INCH}),
    "rotational stiffness": _one("kip ft/rad", KIP * FOOT),
    "spring stiffness": _one("kip/in", KIP / INCH),
}
UNITS: Mapping[System, Mapping[str, DimensionUnits]] = {"SI": _SI, "US": {**_SI, **_US}}
UNIT_WORDS = ("years", "1/year")
"""Units that are words of a language."""


def languages() -> tuple[str, ...]:
    """Return the codes of all languages that a report can be written in, English first."""
    return (ENGLISH, *sorted(path.stem for path in FOLDER.glob("*.po")))


@cache
def read_catalogue(language: str) -> NullTranslations:
    """Return the entries of a language; raises ValueError where there is no file of it."""
    if language not in languages():
        raise ValueError(f'report.language: "{language}" has no catalogue; known are {", ".join(languages())}')
    if language == ENGLISH:
        return NullTranslations()
    from babel.messages.mofile import write_mo
    from babel.messages.pofile import read_po

    compiled = BytesIO()
    with (FOLDER / f"{language}.po").open("rb") as file:
        write_mo(compiled, read_po(file, locale=language))
    compiled.seek(0)
    return GNUTranslations(compiled)


@cache
def decimal_point(language: str) -> str:
    """Return the decimal sign of a language."""
    if language == ENGLISH:
        return "."
    from babel.numbers import get_decimal_symbol

    return get_decimal_symbol(language)


_ENGLISH_OF: Mapping[System, str] = {"SI": "en_GB", "US": "en_US"}


def long_date(text: str, language: str) -> str:
    """Return a day written like 2026-11-28 in words of a language: "28 novembre 2026"; another text as it is."""
    from babel.dates import format_date

    try:
        return format_date(date.fromisoformat(text), "long", language)
    except ValueError:
        return text


_HIDDEN = {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"}


def visible(text: str) -> str:
    """Return `text` on one line, with control, format and unassigned characters shown as their code: ⟨U+0007⟩."""
    if text.isprintable():
        return text
    spaced = " ".join(text.split()) if any(mark in text for mark in "\n\r\t\v\f") else text
    return "".join(character_code(mark) if unicodedata.category(mark) in _HIDDEN else mark for mark in spaced)


def truncate(text: str, limit: int) -> str:
    """Cut `text` to `limit` characters, with an ellipsis at the end."""
    return text if len(text) <= limit else text[: limit - 1].rstrip() + "…"


def truncate_middle(text: str, limit: int) -> str:
    """Cut `text` in the middle to `limit` characters: names of components differ at their ends."""
    kept = limit - 1
    return text if len(text) <= limit else f"{text[: kept // 2].rstrip()}…{text[-(kept - kept // 2) :].lstrip()}"


def character_code(mark: str) -> str:
    """Return the code of a character in brackets: ⟨U+0007⟩."""
    return f"⟨U+{ord(mark):04X}⟩"


_INDEX_MARK = re.compile(r"(?<=[^\W\d_])_(?:\{([^{}]+)\}|([^\W_]+(?:,[^\W_]+)*))")
_POWER_MARK = re.compile(r"\^(?:\{([^{}]+)\}|([-−]?[\w.]+))")


def mark_up(escaped: str, *, index: tuple[str, str], power: tuple[str, str]) -> str:
    """Put the given marks before and after each index and each power of an escaped formula."""
    lowered = _INDEX_MARK.sub(lambda found: f"{index[0]}{found[1] or found[2]}{index[1]}", escaped)
    return _POWER_MARK.sub(lambda found: f"{power[0]}{found[1] or found[2]}{power[1]}", lowered)


def _fill_entry(english: str, message: Message) -> str | None:
    """Return an entry with the values of a message; None where it has other gaps."""
    try:
        return english.format(**message.values)
    except KeyError:
        return None


def _with_decimal_sign(text: str, *, aligned: bool, point: str) -> str:
    shorter = text if aligned or "." not in text else text.rstrip("0").rstrip(".")
    return shorter.replace("-", "−").replace(".", point)
