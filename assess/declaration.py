"""What an input is, written once beside the class that holds it: its dimension, bounds and words, who vouches for it.

The fields of a frozen class are annotated with marks, and the sentence below each says what it means. By these the
project file gets a table (`assess.project.section`), and data of Python are checked (`assess.faults`). What keys
must be to one another is a method `faults` of the class, which both ask:

    def faults(self) -> Iterator[Fault]: ...      # the key at fault, and what is wrong; remedy

Words are those of the project file, which is written more often. Nothing here knows of units, of files or of a room.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, fields
from enum import Enum
from functools import cache
from itertools import pairwise
from math import inf, isfinite, pi
from operator import ge, gt, le, lt
from typing import Annotated, Any, Literal, get_args, get_type_hints

Fault = tuple[str, str]
"""A key, and what is wrong with its value; the remedy follows behind a semicolon."""
KeyFault = tuple[str | tuple[str | int, ...], str]
"""The same, where the key may lie below one of the table; entries of lists are counted from 0."""
Annotation = Any
"""What stands behind the colon of a field: a type or a form of `typing`, for which Python has no type of its own."""
BOUNDS = {
    "above": (gt, "must be greater than {:.6g}"),
    "least": (ge, "must be {:.6g} or more"),
    "below": (lt, "must be less than {:.6g}"),
    "most": (le, "must be {:.6g} or less"),
}
"""The bounds of a number: what it must be to each of them, and the words where it is not."""
RANGES: dict[str, tuple[float, float]] = {
    "length": (1e-9, 1e8),
    "mass": (1e-6, 1e12),
    "time": (1e-6, 1e6),
    "duration": (1e-3, 1e7),
    "speed": (1e-3, 1e5),
    "acceleration": (1e-9, 1e4),
    "force": (1e-6, 1e13),
    "stress": (1e-3, 1e13),
    "stiffness": (1e-3, 1e17),
    "spring stiffness": (1e-3, 1e13),
    "density": (1e-3, 1e5),
    "area": (1e-9, 1e6),
    "mass per area": (1e-6, 1e7),
    "inertia": (1e-12, 1e18),
    "angle": (1e-9, 1e3),
    "frequency": (1e-6, 1e6),
    "rate": (1e-3, 1e3),
    "ratio": (1e-12, 1e18),
}
"""What numbers of each dimension may be beside 0 [SI; of a duration years]: no structure or site lies beyond."""
LEVEL = 1e-9  # of a direction: one that rises by less is horizontal


class Mark:
    """What `Annotated` says of an input.

    form : what is wrong with a value of another form, and the remedy; "" for the words of its type
    """

    form: str = ""

    def remedy(self, value: Any) -> str:
        """Return what is wrong with a value of another form, and the remedy; "" for the words of its type."""
        return self.form

    def fault(self, value: Any) -> str:
        """Return what is wrong with a value of the right form; empty if nothing is."""
        return ""


@dataclass(frozen=True)
class Number(Mark):
    """A number, or some of one dimension, or a word in its place, as the annotated type says.

    dimension : a name of `assess.project.units.KINDS`; "" for a count
    above, below : bounds that it does not reach; least, most : bounds that it may reach; not of several
    infinite : it may be infinite, where it has no limit; rounded : values next to 0 are 0, as in exported coordinates
    beyond : what is wrong beyond its bounds and the remedy, where the bound's own words would not do
    form : what is wrong with what is neither a number nor a known word, and the remedy
    """

    dimension: str = ""
    above: float | None = None
    least: float | None = None
    below: float | None = None
    most: float | None = None
    infinite: bool = False
    rounded: bool = False
    beyond: str = ""
    form: str = ""

    def fault(self, value: Any) -> str:
        """Return what is wrong with a number or several; empty if nothing is, and of a word."""
        if isinstance(value, str):
            return ""
        several = value if isinstance(value, tuple) else (value,)
        if self.infinite and value == inf:
            return ""
        if not all(isfinite(each) or (self.infinite and each > 0.0) for each in several):
            return "not a finite number"
        if reason := next(filter(None, map(self._beyond_range, several)), ""):
            return reason
        if several is value:
            return ""
        for bound, (holds, words) in BOUNDS.items():
            limit = getattr(self, bound)
            if limit is not None and not holds(value, limit):
                return self.beyond or words.format(limit)
        return ""

    def _beyond_range(self, value: float) -> str:
        least, most = RANGES.get(self.dimension, (0.0, inf))
        if not value or value == inf or (self.rounded and abs(value) < least) or least <= abs(value) <= most:
            return ""
        return f"outside {least:g} to {most:g}, beyond which there is no structure or site"


@dataclass(frozen=True)
class IsPlace(Mark):
    """A place: [x, y, z], or (distance along the direction, elevation) [m]."""

    form: str = "not a point; write [x, y, z], or [distance along the direction, elevation]"

    def fault(self, value: Any) -> str:
        """Return what is wrong with a row of numbers; empty if it is a place."""
        return "" if len(value) in (2, 3) else self.form


@dataclass(frozen=True)
class IsDirection(Mark):
    """A direction: [x, y, z], or (along the direction of motion, up), of any length but none."""

    form: str = "not a direction; write [x, y, z], or [along the direction of motion, up]"

    def fault(self, value: Any) -> str:
        """Return what is wrong with a row of numbers; empty if it is a direction."""
        if len(value) not in (2, 3):
            return self.form
        return "" if any(value) else "no direction; write [-1, 0, 0] for a pull towards -x"


@dataclass(frozen=True)
class IsHorizontal(Mark):
    """A horizontal direction [x, y, 0], of any length but none."""

    form: str = 'not a direction; write [1, 0, 0] for +x, [0, -1, 0] for -y, or "sweep" for the weakest'

    def fault(self, value: Any) -> str:
        """Return what is wrong with a vector; empty if it is horizontal, and of a word."""
        if isinstance(value, str):
            return ""
        if not all(map(isfinite, value)):
            return "not a finite number"
        if abs(value[2]) > LEVEL * max(map(abs, value)):
            return "not horizontal; its third number, the vertical one, must be 0"
        return "" if any(value[:2]) else "no direction; write [1, 0, 0] for +x"


@dataclass(frozen=True)
class IsRange(Mark):
    """A range: two numbers, of which the second is no less than the first."""

    def fault(self, value: Any) -> str:
        """Return what is wrong with two numbers; empty if they are a range."""
        return "the first is larger than the second; write [from, to]" if value[0] > value[1] else ""


@dataclass(frozen=True)
class IsName(Mark):
    """The name of what is described elsewhere, such as a body."""

    def fault(self, value: Any) -> str:
        """Return what is wrong with a text; empty if it is a name."""
        return "" if value.strip() else "an empty name; write a name"


@dataclass(frozen=True)
class IsInputFile(Mark):
    """A file that exists; a project file names it by its path from there."""


@dataclass(frozen=True)
class Several(Mark):
    """A list of so many entries.

    form : what is wrong with anything else, from Python
    unlike : what its entries are, where no two may be the same, as "level"
    """

    least: int = 0
    most: int | None = None
    form: str = ""
    unlike: str = ""

    def fault(self, value: Any) -> str:
        """Return what is wrong with the number of entries; empty if nothing is."""
        if len(value) < self.least:
            return f"too few; give at least {self.least}"
        if self.most is not None and len(value) > self.most:
            return f"too many; give at most {self.most}"
        twice = self.unlike and len(set(value)) < len(value)
        return f"the same {self.unlike} stands there twice; remove one" if twice else ""


@dataclass(frozen=True)
class Forms(Mark):
    """A word, or a table with one of several keys.

    word : that stands in place of the table; values : what each key of the table takes
    """

    word: str
    values: tuple[tuple[str, str], ...]

    def remedy(self, value: Any) -> str:
        """Return what to write in place of a value of another form: all forms, or the one whose key it is."""
        meant = [each for each in self.values if each[0] == value] or self.values
        return f'not allowed; write "{self.word}", or {", ".join(f"{{ {key} = {size} }}" for key, size in meant)}'


@dataclass(frozen=True)
class Scatters(Mark):
    """A number that a project file may give as { mean, cov }.

    most : the largest size that it can have [SI]; crosses_zero : whether its values may change sign, as coordinates
    """

    most: float = inf
    crosses_zero: bool = False


@dataclass(frozen=True)
class OfWorks(Mark):
    """What works on a building may change: a size, a place or steel that one chooses, and nothing that was measured.

    priced : whether it takes more than the steel of its bar shows, so that it is varied only at a price
    """

    priced: bool = False


class Safe(Enum):
    """What a run does in place of taking a value that no source vouches for."""

    STATED = "as stated"
    FIRST = "of a choice the value that helps least"
    ABSENT = "the key left out: what the code or the drawing gives"
    WITHOUT = "the table left out that holds the key: a tie, a force"
    WEAKEST = "the weakest that can be computed, where that is clearly weaker: a direction, a crack"


@dataclass(frozen=True)
class Drawn:
    """A value that the drawing of the building gives, by its name in `assess.project.overrides`."""

    name: str


Order = tuple[str | int, ...]
"""The values of a choice, from the one that helps a wall least to the one that helps it most."""
NO_THEN_YES: Order = (False, True)


@dataclass(frozen=True)
class Tried:
    """One value of a range, which is tried in place of the one stated.

    value : as a project file has it, or `Safe.ABSENT` for what the code or the drawing gives
    words : what it is called; empty: as the value
    beside : keys of the same table that change with it, with their values
    """

    value: float | str | Safe
    words: str = ""
    beside: tuple[tuple[str, float | str | Safe], ...] = ()


@dataclass(frozen=True)
class Range:
    """The plausible values of an input that may help the wall or not: where no source vouches for it, the worst counts.

    values : that are tried; where a source vouches, the first alone, to show what the stated one is worth
    up_to : what gives the far end of further values, which begin at the stated one, by its name in
        `assess.project.overrides`; empty for none
    between : how many further values are tried, between the stated one and that far end
    """

    values: tuple[Tried, ...]
    up_to: str = ""
    between: int = 3


@dataclass(frozen=True)
class Evidence(Mark):
    """Who vouches for an input, and which way it helps the wall.

    kind : by whom its value comes about
    helps : whether more of it makes the wall safer, less safe, either, or neither; of a choice whose values can be
        ordered, all of them, from the one that helps least to the one that helps most
    instead : what counts where no source vouches for it
    judged : why this kind and this sense, where that is a judgement
    safe : what a run takes in its place where no source vouches for it: a value [SI], or one that is found
    """

    kind: Literal["defines", "drawn", "chosen", "loads", "code", "measured", "action", "clamped", "free"]
    helps: Literal["up", "down", "either", "none"] | Order
    instead: str
    judged: str = ""
    safe: float | Drawn | Range | Safe = Safe.STATED


ITS_KIND = Evidence(
    "chosen",
    "either",
    "as stated; other kinds that the drawing allows are proposed",
    judged="a kind is a reading of the building: a cantilever or a wall that spans, a floor that bears or a mass",
)
"""Of the kind of a mechanism, and of a load."""
FREE = Evidence("free", "none", "nothing")
"""What can change no outcome: labels, texts, figures."""


@dataclass(frozen=True)
class NotAKey(Mark):
    """What no table of a project file holds under this name."""


@dataclass(frozen=True)
class FileDefault(Mark):
    """What a project file counts as given where a key is absent; the class has None there, to know that it is."""

    value: Any


Length = Annotated[float, Number("length")]
Coordinate = Annotated[float, Number("length", rounded=True)]
PlanePoint = tuple[Coordinate, Coordinate]
SpacePoint = tuple[Coordinate, Coordinate, Coordinate]
PositiveLength = Annotated[float, Number("length", above=0)]
NotNegativeLength = Annotated[float, Number("length", least=0)]
PositiveMass = Annotated[float, Number("mass", above=0)]
Time = Annotated[float, Number("time")]
PositiveTime = Annotated[float, Number("time", above=0)]
PositiveYears = Annotated[float, Number("duration", above=0)]
Speed = Annotated[float, Number("speed")]
Acceleration = Annotated[float, Number("acceleration")]
PositiveAcceleration = Annotated[float, Number("acceleration", above=0)]
PositiveForce = Annotated[float, Number("force", above=0)]
PositiveStress = Annotated[float, Number("stress", above=0)]
NotNegativeStress = Annotated[float, Number("stress", least=0)]
NO_MASONRY = "must be greater than 0 and 50 MPa or less, beyond which there is no masonry"
MasonryStrength = Annotated[float, Number("stress", above=0, most=50e6, beyond=NO_MASONRY)]
Strength = Annotated[
    float, Number("stress", above=0, most=50e6, infinite=True, beyond=f'{NO_MASONRY}; "inf" is the rigid reading')
]
JointStiffness = Annotated[
    float,
    Number(
        "stiffness",
        above=0,
        most=2e12,
        infinite=True,
        beyond='must be greater than 0 and 2 TPa/m or less; of a stiffer joint say model = "rigid"',
    ),
]
PositiveDensity = Annotated[float, Number("density", above=0)]
PositiveInertia = Annotated[float, Number("inertia", above=0)]
PositiveArea = Annotated[float, Number("area", above=0)]
PositiveAreaMass = Annotated[float, Number("mass per area", above=0)]
PositiveFrequency = Annotated[float, Number("frequency", above=0)]
PositiveRate = Annotated[float, Number("rate", above=0)]
Angle = Annotated[float, Number("angle")]
OUT_OF_UPRIGHT = "not between -90 deg and 90 deg; measure the crack from the horizontal"
Inclination = Annotated[float, Number("angle", above=-pi / 2, below=pi / 2, beyond=OUT_OF_UPRIGHT)]
Ratio = Annotated[float, Number("ratio")]
Component = Annotated[float, Number("ratio", rounded=True)]
PositiveRatio = Annotated[float, Number("ratio", above=0)]
NotNegativeRatio = Annotated[float, Number("ratio", least=0)]
RatioToOne = Annotated[float, Number("ratio", least=0, most=1)]
Share = Annotated[float, Number("ratio", above=0, most=1)]
Damping = Annotated[float, Number("ratio", above=0, below=1)]
BuildingDamping = Annotated[
    float, Number("ratio", above=0, most=0.3, beyond="must be greater than 0 and 0.3 or less; 0.05 is 5 % of critical")
]
NominalLife = Annotated[
    float,
    Number("duration", least=5, beyond="must be 5 years or more: 10 for construction phases, 50 for ordinary works"),
]
Uplift = Annotated[float, Number("ratio", above=0, below=pi / 2)]
Count = Annotated[int, Number(least=1)]
Name = Annotated[str, IsName()]
StatedPlace = Annotated[tuple[Coordinate, ...], IsPlace()]
StatedDirection = Annotated[tuple[Component, ...], IsDirection()]

UNCERTAIN = Scatters()
CHOSEN, BOUGHT = OfWorks(), OfWorks(priced=True)
UNCERTAIN_COORDINATE = Scatters(crosses_zero=True)
UNCERTAIN_RESTITUTION = Scatters(most=1.0)
UNCERTAIN_UPLIFT = Scatters(most=pi / 2)


@cache
def annotations_of(kind: type) -> dict[str, Annotation]:
    """Return the annotation of each field of a class, with its marks."""
    hints = get_type_hints(kind, include_extras=True)
    return {field.name: hints[field.name] for field in fields(kind)}


def marks_of(annotation: Annotation) -> Iterator[Any]:
    """Yield what `Annotated` says anywhere in an annotation."""
    yield from getattr(annotation, "__metadata__", ())
    for part in get_args(annotation):
        yield from marks_of(part)


@cache
def descriptions(kind: type) -> dict[str, str]:
    """Return the sentence below each attribute that a class itself declares; it is read from the source when needed."""
    import ast
    import inspect
    from textwrap import dedent

    found = {}
    (body,) = ast.parse(dedent(inspect.getsource(kind))).body
    assert isinstance(body, ast.ClassDef)
    for attribute, below in pairwise(body.body):
        match attribute, below:
            case ast.AnnAssign(target=ast.Name(name)), ast.Expr(value=ast.Constant(value=str(sentence))):
                found[name] = inspect.cleandoc(sentence)
    return found


def meanings_of(kind: type) -> dict[str, str]:
    """Return the sentence below each attribute of a class and of those that it extends."""
    return {key: text for each in reversed(kind.__mro__[:-1]) for key, text in descriptions(each).items()}


def unknown_key(key: str, known: Collection[str]) -> str:
    """Say that a key is unknown, with the nearest of those known, or all.

    Parameters
    ----------
    key : as it was given
    known : in their order
    """
    from difflib import get_close_matches

    near = get_close_matches(key, known, n=1)
    return f'unknown key; did you mean "{near[0]}"?' if near else f"unknown key; known here: {', '.join(known)}"


def one_of(words: tuple[object, ...]) -> str:
    """Write the words or numbers that a key takes, for a sentence: "a", "b" or "c"."""
    *first, last = (f'"{each}"' if isinstance(each, str) else str(each) for each in words)
    return f"{', '.join(first)} or {last}" if first else last
