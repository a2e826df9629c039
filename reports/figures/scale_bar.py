"""A round length by which a drawing in space is read."""

from __future__ import annotations

from math import floor, log10

from matplotlib.axes import Axes

from reports.language.locale import Locale
from reports.language.texts import quantity, say


def round_length(near: float, locale: Locale) -> float:
    """Return a length [m] of 1, 2 or 5 with zeros in the unit of the locale, the largest up to `near` [m]."""
    size = locale.table_unit("length").size
    power = 10.0 ** floor(log10(near / size))
    return size * power * next(digit for digit in (5, 2, 1) if digit * power <= near / size * (1 + 1e-9))


def write_arm(axes: Axes, arm: float, *, at: tuple[float, float], locale: Locale) -> None:
    """Write the length of the arms of a triad [m] at a point [pt]."""
    axes.annotate(locale.text(say("arms {length}", length=quantity(arm, "length", 3))), at, fontsize=6.5)
