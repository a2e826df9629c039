"""Numbers as an engineer writes them: the one place where a number is rounded for a reader."""

from __future__ import annotations

from math import isfinite

FIGURES = 4
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
        return _written(f"{float(f'{mantissa}e{power}'):.{places}f}", aligned=aligned, point=point)
    return f"{_written(mantissa, aligned=aligned, point=point)}×10{str(exponent).translate(_SUPERSCRIPT)}"


def decimals(value: float, *, figures: int) -> int | None:
    """Return the decimals that show a finite number to so many significant figures; None for a power of ten."""
    exponent = int(f"{value:.{figures - 1}e}".split("e")[1])
    return max(0, figures - 1 - exponent) if -4 <= exponent < 6 else None


def _written(text: str, *, aligned: bool, point: str) -> str:
    shorter = text if aligned or "." not in text else text.rstrip("0").rstrip(".")
    return shorter.replace("-", "−").replace(".", point)
