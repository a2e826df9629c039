"""The values of a project file as pydantic types: quantities in SI, uncertain numbers, points, names, paths, texts."""

from __future__ import annotations

import math
import unicodedata
from collections.abc import Callable
from dataclasses import dataclass
from datetime import date
from pathlib import Path
from typing import Annotated, Any, Literal, TypeVar

from pydantic import (
    AfterValidator,
    BeforeValidator,
    Discriminator,
    Field,
    GetJsonSchemaHandler,
    PlainValidator,
    StrictInt,
    StrictStr,
    Tag,
    ValidationInfo,
    WithJsonSchema,
    model_validator,
)
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema

from assess.project.section import ProjectSection, error_at
from assess.project.units import (
    KINDS,
    key_value,
    si_value,
)
from assess.results.variations import Distribution
from spectra.columns import ACCELERATION_UNITS, ColumnError, factor_of

T = TypeVar("T")
QuantityForm = Literal["quantity", "quantity or infinite", "change", "unit"]
PATTERN_MARK = "pattern of"
"""Stands in the schema of a marked key, with its kind and form, until `with_quantity_patterns` has replaced it."""
UNCERTAIN_MARK = "or { mean, cov }"
"""Stands in the schema of a marked key until `with_uncertain_numbers` has replaced it."""
SHARE_UNITS = ("", "%", "percent", "permille")
"""The units of a change that is a share of a number, and no amount."""
INFINITE = ("inf", "infinite")
LONGEST_LINE = 200  # characters
LONGEST_PARAGRAPH = 1000  # characters
REORDERING = frozenset("\u202a\u202b\u202c\u202d\u202e\u2066\u2067\u2068\u2069")
"""Characters that show a text in another order than it is written."""


def _read(kind: str) -> BeforeValidator:
    return BeforeValidator(lambda value: key_value(value, KINDS[kind]))


def quantity_schema(kind: str) -> dict[str, Any]:
    """Return the schema of a key that holds a quantity of a kind in KINDS."""
    return {"type": ["number", "string"], PATTERN_MARK: [kind, "quantity"]}


def _described(kind: str, form: QuantityForm = "quantity") -> WithJsonSchema:
    k = KINDS[kind]
    words = f'{k.name}: a number in {k.symbol}, or a string with its unit like "{k.example}"'
    words += f', or the weight of it like "{k.weighing}", by standard gravity' if k.weight else ""
    return WithJsonSchema({**quantity_schema(kind), "description": words, PATTERN_MARK: [kind, form]})


# the kind stands beside its reader, so that the unit of a key can be told from the type of the key
Length = Annotated[float, _read("length"), _described("length"), KINDS["length"]]
Mass = Annotated[float, _read("mass"), _described("mass"), KINDS["mass"]]
Time = Annotated[float, _read("time"), _described("time"), KINDS["time"]]
Speed = Annotated[float, _read("speed"), _described("speed"), KINDS["speed"]]
Acceleration = Annotated[float, _read("acceleration"), _described("acceleration"), KINDS["acceleration"]]
Force = Annotated[float, _read("force"), _described("force"), KINDS["force"]]
Stress = Annotated[float, _read("stress"), _described("stress"), KINDS["stress"]]
Density = Annotated[float, _read("density"), _described("density"), KINDS["density"]]
Inertia = Annotated[float, _read("inertia"), _described("inertia"), KINDS["inertia"]]
AreaMass = Annotated[float, _read("mass per area"), _described("mass per area"), KINDS["mass per area"]]
Rate = Annotated[float, _read("rate"), _described("rate"), KINDS["rate"]]
Frequency = Annotated[float, _read("frequency"), _described("frequency"), KINDS["frequency"]]
Angle = Annotated[float, _read("angle"), _described("angle"), KINDS["angle"]]
Ratio = Annotated[float, _read("ratio"), _described("ratio"), KINDS["ratio"]]
Years = Annotated[float, _read("duration"), _described("duration"), KINDS["duration"]]

PositiveLength = Annotated[Length, Field(gt=0)]
NotNegativeLength = Annotated[Length, Field(ge=0)]
PositiveMass = Annotated[Mass, Field(gt=0)]
PositiveTime = Annotated[Time, Field(gt=0)]
PositiveYears = Annotated[Years, Field(gt=0)]
PositiveAcceleration = Annotated[Acceleration, Field(gt=0)]
PositiveForce = Annotated[Force, Field(gt=0)]
PositiveStress = Annotated[Stress, Field(gt=0)]
NotNegativeStress = Annotated[Stress, Field(ge=0)]
PositiveDensity = Annotated[Density, Field(gt=0)]
PositiveInertia = Annotated[Inertia, Field(gt=0)]
PositiveAreaMass = Annotated[AreaMass, Field(gt=0)]
PositiveFrequency = Annotated[Frequency, Field(gt=0)]
PositiveRate = Annotated[Rate, Field(gt=0)]
PositiveRatio = Annotated[Ratio, Field(gt=0)]
NotNegativeRatio = Annotated[Ratio, Field(ge=0)]
RatioToOne = Annotated[Ratio, Field(ge=0, le=1)]
Share = Annotated[Ratio, Field(gt=0, le=1)]
Damping = Annotated[Ratio, Field(gt=0, lt=1)]
Uplift = Annotated[Ratio, Field(gt=0, lt=math.pi / 2)]


def _or_infinite(kind: str) -> BeforeValidator:
    def read(value: Any) -> float:
        endless = value == math.inf or (isinstance(value, str) and value.strip().lower() in INFINITE)
        return math.inf if endless else key_value(value, KINDS[kind])

    return BeforeValidator(read)


Strength = Annotated[
    float, Field(gt=0), _or_infinite("stress"), _described("stress", "quantity or infinite"), KINDS["stress"]
]
JointStiffness = Annotated[
    float, Field(gt=0), _or_infinite("stiffness"), _described("stiffness", "quantity or infinite"), KINDS["stiffness"]
]


def _coordinate(value: Any) -> float:
    """Read a length; values near 0 are rounding errors, as in exported coordinates."""
    if isinstance(value, float) and abs(value) < KINDS["length"].least:
        return 0.0
    return key_value(value, KINDS["length"])


Coordinate = Annotated[float, BeforeValidator(_coordinate), _described("length"), KINDS["length"]]
PlanePoint = tuple[Coordinate, Coordinate]
SpacePoint = tuple[Coordinate, Coordinate, Coordinate]
Count = Annotated[StrictInt, Field(ge=1)]


def a_point(value: Any) -> Any:
    """Return what has the form of a point; raise ValueError else."""
    if isinstance(value, list | tuple) and len(value) in (2, 3):
        return value
    raise ValueError("not a point; write [x, y, z], or [distance along the direction, elevation]")


def _a_direction(value: Any) -> Any:
    if not (isinstance(value, list | tuple) and len(value) in (2, 3)):
        raise ValueError("not a direction; write [x, y, z], or [along the direction of motion, up]")
    if all(part == 0 for part in value):
        raise ValueError("no direction; write [-1, 0, 0] for a pull towards -x")
    return value


AnyDirection = Annotated[tuple[Ratio, ...], BeforeValidator(_a_direction), Field(min_length=2, max_length=3)]
Point = Annotated[tuple[Coordinate, ...], BeforeValidator(a_point), Field(min_length=2, max_length=3)]


def _horizontal(direction: tuple[float, ...]) -> tuple[float, ...]:
    if direction[2] != 0:
        raise ValueError("not horizontal; its third number, the vertical one, must be 0")
    if math.hypot(*direction) == 0:
        raise ValueError("no direction; write [1, 0, 0] for +x")
    return direction


Direction = Annotated[tuple[Ratio, Ratio, Ratio], AfterValidator(_horizontal)]


def _sweep(text: str) -> str:
    if text != "sweep":
        raise ValueError('not a direction; write [1, 0, 0] for +x, [0, -1, 0] for -y, or "sweep" for the weakest')
    return text


SoughtDirection = Annotated[
    Annotated[Direction, Tag("<given>")] | Annotated[Literal["sweep"], BeforeValidator(_sweep), Tag("<sought>")],
    Discriminator(lambda value: "<sought>" if isinstance(value, str) else "<given>"),
]


def _less_than_upright(angle: float) -> float:
    if not abs(angle) < math.pi / 2:
        raise ValueError("not between -90 deg and 90 deg; measure the crack from the horizontal")
    return angle


Inclination = Annotated[Angle, AfterValidator(_less_than_upright)]


def _named(text: str) -> str:
    if not text.strip():
        raise ValueError("an empty name; write a name")
    return text


Name = Annotated[StrictStr, AfterValidator(_named)]


def unique(what: str) -> Callable[[tuple[T, ...]], tuple[T, ...]]:
    """Return a check that a list holds no value twice."""

    def check(values: tuple[T, ...]) -> tuple[T, ...]:
        if len(set(values)) < len(values):
            raise ValueError(f"the same {what} stands there twice; remove one")
        return values

    return check


def _one_unit(kind: str, value: Any) -> Any:
    """Read a unit alone, such as "mm", as one of it; a number is the size of the unit in SI already."""
    return si_value(f"1 {value}" if isinstance(value, str) else value, KINDS[kind])


def length_of_unit(text: str) -> float:
    """Return the length [m] of a unit such as "mm"; raise ValueError if it is not a unit of length."""
    length = float(_one_unit("length", text))
    if not 0.0 < length < float("inf"):
        raise ValueError("not a unit of length; write one like mm")
    return length


LengthUnit = Annotated[
    float,
    BeforeValidator(lambda value: _one_unit("length", value)),
    Field(gt=0),
    WithJsonSchema(
        {"type": ["number", "string"], "description": 'a unit of length like "mm"', PATTERN_MARK: ["length", "unit"]}
    ),
]


def _acceleration_unit(text: str) -> str:
    try:
        factor_of(text, known=ACCELERATION_UNITS)
    except ColumnError as error:
        raise ValueError(str(error)) from None
    return text


AccelerationUnit = Annotated[StrictStr, AfterValidator(_acceleration_unit)]


def _folder(info: ValidationInfo) -> Path:
    return Path((info.context or {}).get("folder", "."))


def _an_input_file(value: Any, info: ValidationInfo) -> Path:
    path = _folder(info) / _path_text(value)
    if not path.is_file():
        raise ValueError(f"no such file ({path}); paths are relative to the project file")
    return path


def _path_text(value: Any) -> str:
    if not isinstance(value, str | Path) or not str(value) or "\0" in str(value):
        raise ValueError("not a path; write it in quotes, relative to the project file")
    return str(value)


InputFile = Annotated[
    Path,
    BeforeValidator(_an_input_file),
    WithJsonSchema({"type": "string", "description": "path relative to the project file"}),
]


def _a_path(value: Any, info: ValidationInfo) -> Path:
    return _folder(info) / _path_text(value)


FilePlace = Annotated[
    Path,
    BeforeValidator(_a_path),
    WithJsonSchema({"type": "string", "description": "path relative to the project file"}),
]
"""A file that may not exist yet."""


def _matching(pattern: Any, folder: Path) -> list[Path]:
    """Return the files that a name or pattern matches, sorted; a file or folder of that exact name comes first."""
    text = _path_text(pattern)
    if (folder / text).is_file() or (folder / text).is_dir():
        return [folder / text]
    found = sorted(path for path in map(Path, _glob(text, folder)) if path.is_file())
    if not found:
        raise ValueError(f'"{text}" matches no file in {folder}; paths are relative to the project file')
    return found


def _glob(pattern: str, folder: Path) -> list[str]:
    from glob import escape, glob

    return glob(str(Path(escape(str(folder))) / pattern), recursive=True)


def _files(value: Any, info: ValidationInfo) -> tuple[Path, ...]:
    if not isinstance(value, list | tuple) or not value:
        raise ValueError('not a list of files; write files = ["records/*.AT2"], or leave the key out')
    found = [path for pattern in value for path in _matching(pattern, _folder(info))]
    return tuple(dict.fromkeys(found))


InputFiles = Annotated[
    tuple[Path, ...],
    BeforeValidator(_files),
    WithJsonSchema(
        {
            "type": "array",
            "items": {"type": "string"},
            "minItems": 1,
            "description": "paths, patterns (*, ?, **) or folders relative to the project file",
        }
    ),
]


def _fits_in(most: int, *, line_breaks: bool) -> Callable[[str], str]:
    """Return a check that a text has at most so many characters, each of which can be printed."""

    def check(text: str) -> str:
        if len(text) > most:
            raise ValueError(f"{len(text)} characters; write at most {most}")
        for place, character in enumerate(text, start=1):
            if character == "\n":
                if not line_breaks:
                    raise ValueError("a line break; write it on one line")
            elif character in REORDERING or unicodedata.category(character) in ("Cc", "Cs"):
                raise ValueError(f"character {place} is U+{ord(character):04X}, which cannot be printed; remove it")
        return text

    return check


def text_of_date(value: Any) -> Any:
    """Return a date of TOML as its text, and all else unchanged."""
    return value.isoformat() if isinstance(value, date) else value


def _text_or_number(value: Any) -> Any:
    return str(value) if isinstance(value, int) and not isinstance(value, bool) and abs(value) < 10**9 else value


TextLine = Annotated[StrictStr, AfterValidator(_fits_in(LONGEST_LINE, line_breaks=False))]
"""A text of one line."""
Paragraph = Annotated[StrictStr, AfterValidator(_fits_in(LONGEST_PARAGRAPH, line_breaks=True))]
"""A text of a few lines."""
DateText = Annotated[TextLine, BeforeValidator(text_of_date)]
"""A date as TOML has them, or in the user's own words."""
NumberText = Annotated[
    TextLine,
    BeforeValidator(_text_or_number),
    WithJsonSchema({"type": ["string", "integer"], "maxLength": LONGEST_LINE}),
]
"""A number that nothing is calculated with, kept as a text."""


def _geographic_coordinates(value: Any) -> Any:
    if isinstance(value, str):
        return value
    if not (isinstance(value, list | tuple) and len(value) == 2 and all(map(_is_number, value))):
        raise ValueError("not a place; write [latitude, longitude] in degrees, like [42.351, 13.401], or a text")
    for number, name, most in zip(value, ("latitude", "longitude"), (90.0, 180.0), strict=True):
        if not abs(number) <= most:
            raise ValueError(f"{number:.6g} is no {name}; write one within -{most:.0f} and {most:.0f} degrees")
    return (float(value[0]), float(value[1]))


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


GeographicCoordinates = Annotated[
    TextLine | tuple[float, float],
    BeforeValidator(_geographic_coordinates),
    WithJsonSchema(
        {
            "anyOf": [
                {"type": "string", "maxLength": LONGEST_LINE},
                {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2},
            ]
        }
    ),
]
"""Latitude and longitude [deg], or the user's text."""


def _listed(value: Any) -> Any:
    """Write a key alone as a list of one, and numbers as texts."""
    listed = value if isinstance(value, list | tuple) else [value]
    return tuple(_text_or_number(each) for each in listed)


_AN_ITEM = {"type": ["string", "integer"]}
ItemKeys = Annotated[
    tuple[TextLine, ...],
    BeforeValidator(_listed),
    Field(max_length=30),
    AfterValidator(unique("item")),
    WithJsonSchema({"anyOf": [_AN_ITEM, {"type": "array", "items": _AN_ITEM}]}),
]
"""Items of the list of possible mechanisms: one or several, by key, or by number for churches."""


@dataclass(frozen=True)
class UncertainMark:
    """The mark of a key whose number may be `{ mean, cov }`.

    most : the largest size that it can have [SI]; crosses_zero : whether its values may change sign, as coordinates
    """

    most: float = math.inf
    crosses_zero: bool = False

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        return {**handler(schema), UNCERTAIN_MARK: True}


UNCERTAIN = UncertainMark()
UNCERTAIN_COORDINATE = UncertainMark(crosses_zero=True)
UNCERTAIN_RESTITUTION = UncertainMark(most=1.0)
UNCERTAIN_UPLIFT = UncertainMark(most=math.pi / 2.0)


def number_or_text(remedy: str) -> PlainValidator:
    """Return a check that a value is a number or a text, which is read where it is known what it measures."""

    def check(value: Any) -> Any:
        if isinstance(value, bool) or not isinstance(value, int | float | str):
            raise ValueError(f"not a number or a quantity; {remedy}")
        return value

    return PlainValidator(check)


WRITTEN_QUANTITY_SCHEMA = WithJsonSchema({"type": ["number", "string"]})
WrittenQuantity = Annotated[int | float | str, number_or_text("write it as without scatter"), WRITTEN_QUANTITY_SCHEMA]


class UncertainNumber(ProjectSection):
    """A number that is not well known; without [analysis.uncertainty] its mean is used."""

    mean: WrittenQuantity
    """its mean, written as at any key, like "0.60 m\""""
    cov: Annotated[Ratio, Field(gt=0, lt=1)] | None = None
    """coefficient of variation, standard deviation over mean, like 0.05; or give sd"""
    sd: WrittenQuantity | None = None
    """standard deviation in the unit of the key, like "2 cm", in place of cov"""
    distribution: Distribution | None = None
    """"lognormal" (if absent; of coordinates "normal"), "normal" or "uniform" over mean (1 ± √3 cov)"""
    group: Annotated[Name, StrictStr] | None = None
    """numbers of one group vary together; each by itself if absent"""

    @model_validator(mode="after")
    def _one_scatter(self) -> UncertainNumber:
        if (self.cov is None) == (self.sd is None):
            raise error_at("cov", "give either cov, a share of the mean like 0.05, or sd, in the unit of the mean")
        return self
