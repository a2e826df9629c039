"""To how many significant figures the answers by histories stand, by the spread of their runs."""

from __future__ import annotations

from collections.abc import Iterable
from math import floor, inf, isinf, log10

from assess.codes.check import Check

FIGURES = 4


def ratio_figures(check: Check, *, most: int = FIGURES) -> int:
    """Return to how many figures, one at least, demand over capacity stands between 16 and 84 % of the draws.

    Parameters
    ----------
    check : of any procedure; all figures stand where it has no numerical spread
    most : figures to be shown at most
    """
    if check.numerical is None or check.ratio is None:
        return most
    return max(1, standing_figures(check.ratio, (check.numerical.ratio_low, check.numerical.ratio_high), most=most))


def interval_figures(low: float, high: float, *, most: int = 3) -> int:
    """Return to how many figures the two ends of an interval are written, so that they differ.

    Parameters
    ----------
    low, high : its ends, positive
    most : figures where they hardly differ
    """
    if high <= low:
        return most
    return max(1, min(most, floor(log10(high)) - floor(log10(high - low)) + 1))


def standing_figures(value: float, others: Iterable[float | None], *, most: int = FIGURES) -> int:
    """Return to how many significant figures a number stands: all its runs are within half a unit of the last one.

    Parameters
    ----------
    value : the number that is shown
    others : the same of the other runs; None where they have none, as where the body overturned
    most : figures where the runs agree

    Returns
    -------
    int
        0 where not even the first figure stands.
    """
    far = max((inf if other is None else abs(other - value) for other in others), default=0.0)
    if far == 0.0 or value == 0.0 or isinf(far):
        return most if far == 0.0 else 0
    place = floor(log10(abs(value)))
    return next((figures for figures in range(most, 0, -1) if far <= 0.5 * 10.0 ** (place - figures + 1)), 0)
