"""Numbers as an engineer writes them."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from math import isfinite

from reports.document import Cell, Kind

_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")

SIGNS: Mapping[str, str] = {"<=": "≤", ">=": "≥"}
FIGURES = 4


def numeral(value: float, *, digits: int = FIGURES) -> str:
    """Return `value` to `digits` significant figures: 0.1000, 12.34, 45670, 1.234×10⁶."""
    if value == 0 or not isfinite(value):
        return "0" if value == 0 else {"inf": "∞", "-inf": "−∞", "nan": "not a number"}[str(float(value))]
    mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
    places = decimals(value, figures=digits)
    if places is None:
        return f"{mantissa}×10{str(int(exponent)).translate(_SUPERSCRIPT)}".replace("-", "−")
    return f"{float(f'{mantissa}e{exponent}'):.{places}f}".replace("-", "−")


def decimals(value: float, *, figures: int) -> int | None:
    """Return the decimals that show a finite number to so many significant figures; None for a power of ten."""
    exponent = int(f"{value:.{figures - 1}e}".split("e")[1])
    if value == 0:
        return 0
    return max(0, figures - 1 - exponent) if -3 <= exponent < 5 else None


def as_given(value: float) -> str:
    """Return `value` with the figures it was given with, at most ten."""
    return f"{value:.10g}".replace("-", "−")


def with_bound(value: float | None, bound: str) -> float | str | None:
    """Return `value` where it is known, else that it is no more, or no less: "≤ 30", "≥ 2475"."""
    return value if value is None or not bound else f"{SIGNS[bound]} {as_given(value)}"


def step_result(value: float | str | None, unit: str, beside: tuple[float, str] | None = None) -> str:
    """Return the result of a step with its unit, 1.234 m (4.049 ft); a dash where there is no value."""
    if value is None:
        return "—"
    number = value if isinstance(value, str) else _result(value)
    other = "" if beside is None else f" ({numeral(beside[0])} {beside[1]})"
    return number if unit == "-" else f"{number} {unit}{other}"


def _result(value: float) -> str:
    return as_given(value) if float(value).is_integer() and abs(value) < 1e5 else numeral(value)


def cell_text(cell: Cell, kind: Kind) -> str:
    """Return the text of a cell; a dash where there is no value."""
    if cell is None or cell == "":
        return "—"
    if isinstance(cell, bool):
        return "yes" if cell else "no"
    if isinstance(cell, int):
        return str(cell)
    if isinstance(cell, float):
        return as_given(cell) if kind == "given" else numeral(cell)
    return cell


def entries(key: str, value: object) -> Iterator[tuple[str, Cell]]:
    """Yield a resolved value as cells with their keys: a list of tables as one cell for each, without absent values."""
    if isinstance(value, list | tuple) and value and all(isinstance(each, dict) for each in value):
        for place, each in enumerate(value, start=1):
            yield f"{key}[{place}]", as_cell({name: held for name, held in each.items() if held is not None})
    else:
        yield key, as_cell(value)


def as_cell(value: object) -> Cell:
    """Return any resolved value as one cell: a number stays a number, lists and tables become one line of text."""
    if value is None or isinstance(value, bool | int | float | str):
        return value
    return json.dumps(value, ensure_ascii=False, default=str)
