"""The values a project file may hold, as pydantic types: quantities in SI, points, names, paths."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any, Literal, TypeVar

from pydantic import (
    AfterValidator,
    BeforeValidator,
    Discriminator,
    Field,
    StrictInt,
    StrictStr,
    Tag,
    ValidationInfo,
    WithJsonSchema,
)

from assess.project.quantity_patterns import INFINITE, MARK, Form
from assess.project.units import KINDS, key_value, si_value
from spectra.columns import ACCELERATION_UNITS, ColumnError, factor_of

T = TypeVar("T")


def _read(kind: str) -> BeforeValidator:
    return BeforeValidator(lambda value: key_value(value, KINDS[kind]))


def quantity_schema(kind: str) -> dict[str, Any]:
    """Return the schema of a key that holds a quantity of a kind in KINDS."""
    return {"type": ["number", "string"], MARK: [kind, "quantity"]}


def _described(kind: str, form: Form = "quantity") -> WithJsonSchema:
    k = KINDS[kind]
    words = f'{k.name}: a number in {k.symbol}, or a string with its unit like "{k.example}"'
    words += f', or the weight of it like "{k.weighing}", by standard gravity' if k.weight else ""
    return WithJsonSchema({**quantity_schema(kind), "description": words, MARK: [kind, form]})


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


def _described_or_infinite(kind: str) -> WithJsonSchema:
    return _described(kind, "quantity or infinite")


Strength = Annotated[float, Field(gt=0), _or_infinite("stress"), _described_or_infinite("stress"), KINDS["stress"]]
JointStiffness = Annotated[
    float, Field(gt=0), _or_infinite("stiffness"), _described_or_infinite("stiffness"), KINDS["stiffness"]
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
        {"type": ["number", "string"], "description": 'a unit of length like "mm"', MARK: ["length", "unit"]}
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
