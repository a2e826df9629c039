"""Numbers beside an axis, with the decimal sign of a locale."""

from __future__ import annotations

from typing import Any

from matplotlib.axis import Axis
from matplotlib.ticker import Formatter, LogFormatter, LogLocator, NullLocator, ScalarFormatter

from reports.language.locale import Locale

TICK_FIGURES = 3


class LinearTicks(ScalarFormatter):
    """As many decimals as the ticks need, all alike."""

    def __init__(self, locale: Locale) -> None:
        super().__init__(useOffset=False, useMathText=False, useLocale=False)
        self.point = locale.point

    def __call__(self, x: float, pos: Any = None) -> str:
        """Return the number of a tick."""
        return super().__call__(x, pos).replace(".", self.point)

    def get_offset(self) -> str:
        """Return the power of ten by which the ticks are multiplied, empty for none."""
        return super().get_offset().replace(".", self.point)


class LogTicks(Formatter):
    """Numbers as they are read, 0.02 and not a power of ten."""

    def __init__(self, locale: Locale) -> None:
        self.locale = locale

    def __call__(self, x: float, pos: Any = None) -> str:
        """Return the number of a tick."""
        return self.locale.number(x, figures=TICK_FIGURES)


def localise_ticks(axis: Axis, locale: Locale) -> None:
    """Give an axis that matplotlib would number by itself the numbers of a locale; labels that were set stay."""
    given = axis.get_major_formatter()
    if type(given) is ScalarFormatter:
        axis.set_major_formatter(LinearTicks(locale))
    elif isinstance(given, LogFormatter):
        axis.set_major_formatter(LogTicks(locale))


def number_by_decades(axis: Axis, locale: Locale) -> None:
    """Give a logarithmic axis numbers at 1, 2 and 5 of each decade."""
    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0)))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(LogTicks(locale))
