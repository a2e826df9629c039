"""Numbers of an IFC file that are none, or lost their decimal point: ifcopenshell reads them without a warning."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path

COMMAS = "{what} has {found} values where it has {wanted}; decimals take a point, not a comma"
SIZED = re.compile(
    rb"=\s*(IFC(?:\w+PROFILEDEF|\w+SOLID|\w+SOLIDTAPERED|CIRCLE|ELLIPSE|VECTOR|BLOCK|SPHERE|RECTANGULARPYRAMID|"
    rb"RIGHTCIRCULARCYLINDER|RIGHTCIRCULARCONE|SIUNIT|MEASUREWITHUNIT))\s*\(([^;]*)\)\s*;"
)
LIST = re.compile(rb"IFCCARTESIANPOINTLIST([23])D\s*\(\s*\(([^;]*?\))\s*\)[^;]*;")
DIRECTION = re.compile(rb"IFCDIRECTION\s*\(\s*\(([^()]*)\)\s*\)")
ZERO = re.compile(rb"\s*[-+]?0+\.?0*(?:E[-+]?\d+)?\s*", re.IGNORECASE)
POINT = re.compile(rb"IFC(?:CARTESIANPOINT|DIRECTION)\s*\(\s*\(([^()]*)\)\s*\)")
REAL = re.compile(rb"\s*[-+]?\d+\.\d*(?:E[-+]?\d+)?\s*", re.IGNORECASE)
WHOLE = re.compile(rb"\s*[-+]?\d+\s*")
HABIT = 0.01  # of the points: if more have whole numbers without a point, the program that wrote them leaves it out


def refuse_commas(file: Path, attributes: Callable[[str], int | None]) -> None:
    """Raise where points, profiles, solids or units have more or fewer values than possible.

    Parameters
    ----------
    attributes : number of attributes of a class of the file's schema; None where it has no such class

    Raises
    ------
    ValueError : a value is no number, or a number of values is impossible
    """
    text = re.sub(rb"/\*.*?\*/|'[^']*'", b"''", file.read_bytes(), flags=re.DOTALL)
    points = POINT.findall(text)
    for row in points:
        if not all(map(_is_finite, row.split(b","))):
            raise ValueError(f"({row.decode('latin-1'):.40}) in it are not numbers; it is damaged, export it again")
    for ratios in DIRECTION.findall(text):
        if all(map(ZERO.fullmatch, ratios.split(b","))):
            shown = ratios.decode("latin-1")
            raise ValueError(f"the direction ({shown:.40}) in it has no length; it is damaged, export it again")
    _points(points)
    for dimensions, rows in LIST.findall(text):
        for row in re.findall(rb"\(([^()]*)\)", rows):
            _coordinates(row.split(b","), {int(dimensions)})
    for name, arguments in SIZED.findall(text):
        wanted, found = attributes(name.decode("latin-1")), _arguments(arguments)
        if wanted not in (None, found):
            raise ValueError(COMMAS.format(what=f"an {name.decode('latin-1')}", found=found, wanted=wanted))


def _is_finite(value: bytes) -> bool:
    try:
        return not value.strip() or math.isfinite(float(value))
    except ValueError:
        return False


def _points(points: list[bytes]) -> None:
    rows = [point.split(b",") for point in points]
    for row in rows:
        _coordinates(row, {1, 2, 3})
    whole = [row for row in rows if any(map(WHOLE.fullmatch, row)) and any(map(REAL.fullmatch, row))]
    if whole and len(whole) <= HABIT * len(rows):
        shown = b",".join(whole[0]).decode("latin-1")
        raise ValueError(f"of the point ({shown:.40}) a number has no decimal point, as all others have")


def _coordinates(row: list[bytes], wanted: set[int]) -> None:
    found = sum(1 for value in row if value.strip())
    if found != len(row) or found not in wanted:
        raise ValueError(COMMAS.format(what="a point", found=len(row), wanted=max(wanted)))


def _arguments(text: bytes) -> int:
    """Count the arguments of an instance, a list as one."""
    inner = None
    while inner != text:
        inner, text = text, re.sub(rb"\([^()]*\)", b"", text)
    return text.count(b",") + 1
