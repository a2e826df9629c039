"""Quantities as they are typed: a number in SI, or a string of a number and its unit, becomes an SI float.

The number is split off by a regular expression and nothing is evaluated; only the unit goes to pint, whose own parser
would evaluate `9**9**9 m`. pint is imported for the first unit that is not a usual one (0.5 s). All is computed with
fractions, so "690 mm" is 0.69.

The patterns of quantities in the JSON Schema, by which an editor shows a wrong unit while the file is written, are made
of the same parts and of pint's names. A pattern accepts whatever is read: what it cannot judge, the product of several
units or signs beyond a keyboard's, it leaves to the reader. Only constructions that Python and ECMA 262 read alike are
used.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, lru_cache
from typing import Any, Literal

from assess.declaration import RANGES
from assess.errors import ProjectError
from spectra.gravity import g


class QuantityError(ProjectError):
    """A quantity cannot be read; the text says what is wrong and the remedy, its caller adds the key and the value."""


_TURNS = frozenset(
    {"radian", "degree", "turn", "revolution", "cycle", "revolutions_per_minute", "revolutions_per_second"}
)
_ANGLES = frozenset({"radian", "degree", "gradian", "grade", "turn", "arcminute", "arcsecond"})
SMALLEST, LARGEST = 1e-12, 1e18  # in SI: no size, mass, force or stress of a structure lies beyond


@dataclass(frozen=True)
class QuantityKind:
    """What a key measures.

    range : of what keys may give beside 0 [SI]
    name : in words; unit : SI, as pint reads it; symbol : SI, as the project file writes it; example : with its unit
    only : the units allowed where their dimension does not settle it, empty for all of the right dimension
    never : units refused although their dimension is right
    weight : the unit of the weight of it, as pint reads it, which is divided by standard gravity; "" for none
    weighing : an example of that
    """

    range: tuple[float, float]
    name: str
    unit: str
    symbol: str
    example: str
    only: frozenset[str] = frozenset()
    never: frozenset[str] = frozenset()
    weight: str = ""
    weighing: str = ""


KINDS: dict[str, QuantityKind] = {
    "length": QuantityKind(RANGES["length"], "length", "meter", "m", "1.25 m"),
    "mass": QuantityKind(RANGES["mass"], "mass", "kilogram", "kg", "1200 kg"),
    "time": QuantityKind(RANGES["time"], "time", "second", "s", "6 s"),
    "duration": QuantityKind(
        RANGES["duration"], "duration", "year", "years", "50 years", only=frozenset({"year"})
    ),  # of hazards and buildings
    "speed": QuantityKind(RANGES["speed"], "speed", "meter/second", "m/s", "400 m/s"),
    "acceleration": QuantityKind(RANGES["acceleration"], "acceleration", "meter/second**2", "m/s^2", "0.10 g"),
    "force": QuantityKind(RANGES["force"], "force", "newton", "N", "10 kN"),
    "stress": QuantityKind(RANGES["stress"], "stress", "pascal", "Pa", "1.0 MPa"),
    "stiffness": QuantityKind(RANGES["stiffness"], "stiffness per area", "pascal/meter", "Pa/m", "10 GPa/m"),
    "spring stiffness": QuantityKind(RANGES["spring stiffness"], "stiffness", "newton/meter", "N/m", "5 MN/m"),
    "density": QuantityKind(
        RANGES["density"],
        "density",
        "kilogram/meter**3",
        "kg/m^3",
        "2240 kg/m^3",
        weight="newton/meter**3",
        weighing="20 kN/m^3",
    ),
    "area": QuantityKind(RANGES["area"], "area", "meter**2", "m^2", "314 mm^2"),
    "mass per area": QuantityKind(RANGES["mass per area"], "mass per area", "kilogram/meter**2", "kg/m^2", "80 kg/m^2"),
    "inertia": QuantityKind(RANGES["inertia"], "moment of inertia", "kilogram*meter**2", "kg*m^2", "5200 kg*m^2"),
    "angle": QuantityKind(RANGES["angle"], "angle", "radian", "rad", "30 deg", only=_ANGLES),
    "frequency": QuantityKind(RANGES["frequency"], "frequency", "1/second", "Hz", "2.5 Hz", never=_TURNS),
    "rate": QuantityKind(
        RANGES["rate"],
        "rate",
        "1/second",
        "1/s",
        "1.60 1/s",
        never=frozenset({"hertz", "turn", "revolution", "cycle"}),
    ),
    "ratio": QuantityKind(
        RANGES["ratio"], "ratio", "dimensionless", "no unit", "0.05", only=frozenset({"percent", "permille"})
    ),
}


def to_si(value: Any, kind: str, *, key: str) -> float:
    """Return the SI value of a number (SI already) or a string with a unit, of a `kind` in KINDS.

    Raises ProjectError with the key, the value, what is wrong and the unit expected.
    """
    try:
        return si_value(value, KINDS[kind])
    except QuantityError as error:
        raise ProjectError(f"{key}: {value!r:.80}: {error}") from None


def si_value(value: Any, kind: QuantityKind) -> float:
    """Return the SI value of a number or a string with a unit; raise QuantityError if it cannot be read."""
    if isinstance(value, str):
        return _finite(_from_text(value, kind), kind)
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise QuantityError(f"not a number or a quantity; {_remedy(kind)}")
    return _finite(value, kind)


def key_value(value: Any, kind: QuantityKind) -> float:
    """Return the SI value of a key of the project file, within the range of its kind; else raise QuantityError."""
    number = si_value(value, kind)
    least, most = kind.range
    if number and not least <= abs(number) <= most:
        what, unit = (
            (f"{number:.3g}", "") if kind.name == "ratio" else (f"{number:.3g} {kind.symbol}", f" {kind.symbol}")
        )
        raise QuantityError(f"{what} is outside {least:g} to {most:g}{unit}; {_remedy(kind)}")
    return number


LONGEST = 60  # characters
NUMBER = r"[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]{1,3})?"
_NUMBER = re.compile(rf"\s*({NUMBER})\s*")
_SEPARATED = re.compile(
    r"([+-]?)([0-9]*,[0-9]+(?:(?:[.,'_][0-9]+)| [0-9]{3})*|[0-9]+(?:[.,'_][0-9]+| [0-9]{3})+)(?![.0-9/])"
)
_GROUPED = re.compile(
    r"([0-9]{1,3}(?:,[0-9]{3})+|[0-9]{1,3}(?:\.[0-9]{3})+|[0-9]{1,3}(?:['_ ][0-9]{3})+)(?:[.,]([0-9]+))?"
)
_FEET_AND_INCHES = re.compile(r"'[\s-]*[0-9]|(?:ft|feet|foot)[\s-]+[0-9]")
_PLAIN = str.maketrans({
    "−": "-", "‐": "-", "‑": "-", "–": "-", "﹣": "-", "－": "-",  # minus signs, hyphens, an en dash
    "⋅": "·", "∙": "·", "×": "·", "∕": "/", "⁄": "/",
    "º": "°", "˚": "°", "’": "'", "′": "'", "ʹ": "'", "”": '"', "″": '"', "ʺ": '"',
    "\u200b": None, "\u2060": None, "\ufeff": None,  # spaces without width
})  # fmt: skip


def number_and_unit(text: str) -> tuple[str, str]:
    """Split a quantity into its number and its unit, both in plain signs; raise QuantityError if it has none."""
    plain = " ".join(text.translate(_PLAIN).split())
    found = _NUMBER.match(plain)
    unit = plain[found.end() :] if found else ""
    fault = (
        "" if len(text) > LONGEST else _separator_fault(plain) or _two_units_fault(unit) or _leading_zero_fault(plain)
    )
    if fault:
        raise QuantityError(fault)
    if len(text) > LONGEST or found is None:
        raise QuantityError("not a number with a unit")
    return found[1], unit


def reads_unit(unit: str, kind: QuantityKind) -> bool:
    """Whether `unit` is one of `kind`, as it is typed behind a number."""
    try:
        _factor(unit, kind)
    except QuantityError:
        return False
    return True


def is_weight(value: str, kind: QuantityKind) -> bool:
    """Whether a quantity that `si_value` reads is the weight of what it stands for, like a density in kN/m^3."""
    if not kind.weight:
        return False
    unit = number_and_unit(value)[1]
    if unit in USUAL[kind.name]:
        return unit in WEIGHTS
    pint_factor(unit, kind)
    return bool(_registry().parse_units(_as_pint(unit, kind)).is_compatible_with(kind.weight))


@cache
def pint_factor(unit: str, kind: QuantityKind) -> Fraction:
    """Return how many SI units one `unit` is by pint, for any unit; raise QuantityError for an unknown one."""
    import pint

    try:
        parsed = _registry().parse_units(_as_pint(unit, kind))
        names = {_registry().parse_unit_name(name)[0][1] for name in parsed._units}
        one = _registry().Quantity(Fraction(1), parsed)
        if kind.weight and one.is_compatible_with(kind.weight):
            return Fraction(one.to(kind.weight).magnitude) / G
        factor = one.to(kind.unit).magnitude
    except pint.UndefinedUnitError:
        raise QuantityError(f'unknown unit "{unit}"; {_remedy(kind)}') from None
    except (pint.DimensionalityError, pint.OffsetUnitCalculusError):
        raise QuantityError(f'"{unit}" is not a unit of {kind.name}; {_remedy(kind)}') from None
    except Exception:  # whatever else pint's parser stumbles over is not a unit either
        raise QuantityError(f'"{unit}" is not a unit; {_remedy(kind)}') from None
    if not all(_allows(kind, name) for name in names):
        raise QuantityError(f'"{unit}" is not a unit of {kind.name}; {_remedy(kind)}')
    return Fraction(factor)


def prefixes_and_names(kind: QuantityKind) -> tuple[list[str], list[str]]:
    """Return the prefixes of units and the names, without prefix and plural, that units of `kind` have by pint."""
    names = [name for name, root in _names().items() if _allows(kind, root) and _has_dimension(name, kind)]
    return sorted(filter(None, _registry()._prefixes)), sorted(names)


_POWER = r"(?:(?:\^|\*\*)?-?[1-9]|[⁻]?[¹²³⁴])?"
SIGNS = "%‰°'\""


def _name_pattern(letter: str) -> str:
    """Return the pattern of a unit's name, of a class of letters."""
    return f"{letter}+(?:_{letter}+)*"


INCH, FOOT = Fraction("0.0254"), Fraction("0.3048")
POUND = Fraction("0.45359237")
G = Fraction("9.80665")  # standard gravity [m/s2]
POUND_FORCE = POUND * G
PI = Fraction("3.1415926535897932384626433832795028841971693993751")  # as pint has it
USUAL: Mapping[str, Mapping[str, Fraction]] = {
    "length": {
        "m": Fraction(1),
        "cm": Fraction(1, 100),
        "mm": Fraction(1, 1000),
        "ft": FOOT,
        "in": INCH,
        "'": FOOT,
        '"': INCH,
    },
    "mass": {"kg": Fraction(1), "t": Fraction(1000), "lb": POUND},
    "time": {"s": Fraction(1), "ms": Fraction(1, 1000)},
    "duration": {"years": Fraction(1), "year": Fraction(1)},
    "acceleration": {"m/s^2": Fraction(1), "m/s2": Fraction(1), "cm/s^2": Fraction(1, 100)},
    "force": {"N": Fraction(1), "kN": Fraction(1000), "MN": Fraction(10**6), "lbf": POUND_FORCE},
    "stress": {
        "Pa": Fraction(1),
        "kPa": Fraction(1000),
        "MPa": Fraction(10**6),
        "GPa": Fraction(10**9),
        "N/mm^2": Fraction(10**6),
        "psi": POUND_FORCE / INCH**2,
        "ksi": 1000 * POUND_FORCE / INCH**2,
    },
    "stiffness": {
        "N/m": Fraction(1),
        "kN/m": Fraction(1000),
        "MN/m": Fraction(10**6),
        "N/mm": Fraction(1000),
        "lbf/in": POUND_FORCE / INCH,
    },
    "stiffness per area": {
        "GPa/m": Fraction(10**9),
        "MPa/m": Fraction(10**6),
        "N/mm^3": Fraction(10**9),
        "psi/in": POUND_FORCE / INCH**3,
    },
    "density": {
        "kg/m^3": Fraction(1),
        "kg/m3": Fraction(1),
        "t/m^3": Fraction(1000),
        "lb/ft^3": POUND / FOOT**3,
        "pcf": POUND / FOOT**3,
        "kN/m^3": 1000 / G,
        "kN/m3": 1000 / G,
        "kN/m³": 1000 / G,
    },
    "area": {
        "m^2": Fraction(1),
        "m2": Fraction(1),
        "cm^2": Fraction(1, 10**4),
        "cm2": Fraction(1, 10**4),
        "mm^2": Fraction(1, 10**6),
        "mm2": Fraction(1, 10**6),
        "in^2": INCH**2,
    },
    "mass per area": {"kg/m^2": Fraction(1), "kg/m2": Fraction(1)},
    "angle": {"rad": Fraction(1), "deg": PI / 180},
    "frequency": {"Hz": Fraction(1)},
    "rate": {"1/s": Fraction(1)},
    "ratio": {"%": Fraction(1, 100)},
}
"""SI units of a kind, by its name in `units.KINDS`, that one of each unit is, as it is typed."""
WEIGHTS = frozenset({"kN/m^3", "kN/m3", "kN/m³", "pcf"})
"""Units of weight per volume among those of density."""
DEFINED = ("pcf = pound_force / foot ** 3", "psf = pound_force / foot ** 2", "lbm = pound")
"""Units of American engineers that pint does not know, as its definitions."""
AMBIGUOUS: Mapping[str, str] = dict.fromkeys(
    ("ton", "tons"), '1000 kg to some and 2000 lb to others; write "t" or "short_ton"'
)
"""What is wrong with units that mean different things in different countries, and the remedy."""
QuantityForm = Literal["quantity", "quantity or infinite", "change", "unit"]
INFINITE = ("inf", "infinite")
SHARE_UNITS = ("", "%", "percent", "permille")
"""The units of a change that is a share of a number, and no amount."""
_LETTER = "[A-Za-z]"
_PLAIN_UNIT = re.compile(rf"{_name_pattern(_LETTER)}|[{SIGNS}]")
_BEYOND_A_KEYBOARD = "[^ -~¹²³⁴⁻·°‰]"


@cache
def quantity_pattern(kind: str, form: QuantityForm = "quantity") -> str:
    """Return the pattern of a quantity of a kind in KINDS, of one that may be infinite, of a share or an amount by
    which it changes, or of its unit alone.
    """
    unit = _pattern_of_unit(KINDS[kind])
    if form == "unit":
        read = rf"\s*{unit}"
    elif KINDS[kind].unit == "dimensionless":
        read = rf"\s*{NUMBER}\s*(?:{unit})?"
    else:
        read = rf"\s*{NUMBER}\s*{unit}"
    either = [rf"{read}\s*", f".*{_BEYOND_A_KEYBOARD}.*"]
    if form == "quantity or infinite":
        either.append(rf"\s*{_any_case(INFINITE)}\s*")
    elif form == "change":
        either.append(rf"\s*{NUMBER}\s*{_any_of(SHARE_UNITS)}\s*")
    return f"^(?:{'|'.join(either)})$"


def _finite(value: int | float | Fraction, kind: QuantityKind) -> float:
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise QuantityError(f"not a finite number; {_remedy(kind)}")
    if number and not SMALLEST <= abs(number) <= LARGEST:
        raise QuantityError(f"beyond anything built ({number:.3g} {kind.symbol}); {_remedy(kind)}")
    return number


@lru_cache(maxsize=4096)  # rows of a table have most of their texts alike
def _from_text(text: str, kind: QuantityKind) -> Fraction:
    try:
        number, unit = number_and_unit(text)
    except QuantityError as error:
        reason = str(error)
        raise QuantityError(reason if "; write " in reason else f"{reason}; {_remedy(kind)}") from None
    if not math.isfinite(float(number)):
        raise QuantityError(f"not a finite number; {_remedy(kind)}")
    return Fraction(number) * _factor(unit, kind)


def _remedy(kind: QuantityKind) -> str:
    if kind.unit == "dimensionless":
        return f"write a {kind.name} without unit, like {kind.example}"
    article = "an" if kind.name[0] in "aeiou" else "a"
    weighing = f' or "{kind.weighing}"' if kind.weighing else ""
    return f'write {article} {kind.name} like "{kind.example}"{weighing}, or a number in {kind.symbol}'


def _separator_fault(text: str) -> str:
    """Say what is wrong with a number that has commas or separated thousands; empty if nothing is."""
    found = _SEPARATED.match(text)
    if found is None or re.fullmatch(r"[0-9]+\.[0-9]+", found[2]):
        return ""
    sign, number, rest = found[1], found[2], text[found.end() :]
    grouped = _GROUPED.fullmatch(number)
    whole, point = (f"{sign}{digits}{rest}" for digits in (re.sub(r"\D", "", number), number.replace(",", ".")))
    if re.fullmatch(r"[1-9][0-9]{0,2},[0-9]{3}", number):
        return f'a comma that may mean two things; write "{point}" for a decimal comma, "{whole}" for thousands'
    if re.fullmatch(r"[0-9]*,[0-9]+", number):
        return f'a decimal comma; write "{point if number[0] != "," else point.replace(".", "0.", 1)}"'
    if grouped is None:
        return 'more in the number than one decimal point; write it like "1250.5"'
    decimals = f".{grouped[2]}" if grouped[2] else ""
    return f'thousands set apart; write "{sign}{re.sub(r"[^0-9]", "", grouped[1])}{decimals}{rest}"'


def _leading_zero_fault(text: str) -> str:
    """Say what is wrong with a number that has lost its decimal point behind a zero, like "05 m"; else empty."""
    found = re.match(r"[+-]?0+([0-9][0-9.]*)", text)
    return f'a 0 before the digits; write "{found[1]}", or "0.{found[1]}" if a point was lost' if found else ""


def _two_units_fault(unit: str) -> str:
    """Say what is wrong with feet and inches in one quantity."""
    return 'feet and inches in one; write it in one of them, like "4.5 ft"' if _FEET_AND_INCHES.match(unit) else ""


def _unit_pattern(letter: str) -> str:
    """Return the pattern of a unit: names and signs with their powers, multiplied and divided."""
    factor = rf"(?:1(?=\s*/)|{_name_pattern(letter)}|[{SIGNS}]){_POWER}"
    return rf"{factor}(?:\s*[*/·]\s*{factor}|\s+{factor})*"


_UNIT = re.compile(_unit_pattern(r"[^\W\d_]"))
UNITS_OF_ACCELERATION = ("g", "gal")


def _factor(unit: str, kind: QuantityKind) -> Fraction:
    """Return how many SI units of `kind` one `unit` is."""
    if kind.name == "acceleration" and unit in UNITS_OF_ACCELERATION:
        return Fraction(str(g)) if unit == "g" else Fraction(1, 100)
    if not unit and kind.unit == "dimensionless":
        return Fraction(1)
    if not unit:
        raise QuantityError(f"no unit; {_remedy(kind)}")
    if _UNIT.fullmatch(unit) is None:
        raise QuantityError(f'"{unit}" is not a unit; {_remedy(kind)}')
    if re.search(r"(?<![^\W\d_])g(?![^\W\d_])", unit):
        raise QuantityError(f'"g" is standard gravity, alone and for accelerations only; {_remedy(kind)}')
    for word in re.findall(r"[^\W\d]+", unit.lower()):
        if word in AMBIGUOUS:
            raise QuantityError(f'"{word}" is {AMBIGUOUS[word]}')
    usual = USUAL.get(kind.name, {}).get(unit)
    return pint_factor(unit, kind) if usual is None else usual


def _has_dimension(unit: str, kind: QuantityKind) -> bool:
    """Whether a unit of pint's has the dimension of `kind`, or that of its weight."""
    return _dimension(_as_pint(unit, kind)) in [_dimension(each) for each in (kind.unit, kind.weight) if each]


@cache
def _dimension(unit: str) -> Any:
    return _registry().parse_units(unit).dimensionality


@cache
def _registry() -> Any:
    """Make the pint registry in exact fractions, which takes half a second."""
    import pint

    registry: Any = pint.UnitRegistry(non_int_type=Fraction)
    for definition in DEFINED:
        registry.define(definition)
    return registry


@cache
def _names() -> dict[str, str]:
    """Return pint's names of units that can be typed, each with the unit that it is of; none with a prefix."""
    found: dict[str, str] = {}
    for name in [each for each in _registry()._units if each.replace("_", "").isalpha()]:
        with suppress(AttributeError):  # of a few names that pint lists and does not know
            prefix, root, _ = _registry().parse_unit_name(name)[0]
            found |= {} if prefix else {name: root}
            _dimension(name)
    return found


def _allows(kind: QuantityKind, name: str) -> bool:
    """Whether a unit of the right dimension is one of `kind`."""
    return name not in kind.never and (not kind.only or name in kind.only)


def _as_pint(unit: str, kind: QuantityKind) -> str:
    """Write `m/s2`, `kg·m²` and `5 %` for pint; a prime is a foot, or a minute of an angle."""
    powers = re.sub(r"(?<=[^\W\d_])(-?[0-9])", r"**\1", unit)
    prime, double = ("arcminute", "arcsecond") if kind.name == "angle" else ("foot", "inch")
    plain = powers.replace("'", prime).replace('"', double)
    return plain.replace("%", "percent").replace("‰", "permille").replace("·", "*").replace("°", "degree")


def _pattern_of_unit(kind: QuantityKind) -> str:
    """Return the pattern of a unit: a name of the kind, or a product, unless it is known as of another kind."""
    plain = rf"(?:{_name_pattern(_LETTER)}|[{SIGNS}])\s*$"
    return rf"(?!{_any_of(_refused_units(kind))}\s*$)(?:{_pattern_of_names(kind)}|(?!{plain}){_unit_pattern(_LETTER)})"


def _pattern_of_names(kind: QuantityKind) -> str:
    """Return the pattern of the kind's names, with prefix and plural, and signs."""
    prefixes, names = (list(filter(str.isascii, each)) for each in prefixes_and_names(kind))
    single = filter(_PLAIN_UNIT.fullmatch, (*SIGNS, *USUAL.get(kind.name, {}), *UNITS_OF_ACCELERATION))
    without_prefix = dict.fromkeys(each for each in single if each not in names and reads_unit(each, kind))
    with_prefix = f"{_any_of(prefixes)}?{_any_of(names)}s?" if names else ""
    return "|".join(filter(None, (_any_of(without_prefix) if without_prefix else "", with_prefix)))


def _refused_units(kind: QuantityKind) -> Iterator[str]:
    """Yield units that a pattern of the kind might take for one of it: usual ones of other kinds, ambiguous ones."""
    yield from (unit for unit in (*AMBIGUOUS, *UNITS_OF_ACCELERATION) if not reads_unit(unit, kind))
    usual = dict.fromkeys(unit for units in USUAL.values() for unit in units)
    yield from (unit for unit in usual if not _has_dimension(unit, kind))


def _any_of(texts: Iterable[str]) -> str:
    """Return the pattern of any of the texts; `re.escape` escapes signs that ECMA 262 does not allow to be escaped."""
    return "(?:" + "|".join(re.sub(r"([$()*+./?^{|}])", r"\\\1", text) for text in texts) + ")"


def _any_case(words: Iterable[str]) -> str:
    return "(?:" + "|".join("".join(f"[{c.lower()}{c.upper()}]" for c in word) for word in words) + ")"
