"""To how many significant figures the answers by histories stand, by the spread of their runs."""

from __future__ import annotations

from collections.abc import Iterable
from math import floor, inf, isinf, log10

from assess.codes.check import Check

FIGURES = 4
FARTHEST = 6  # figures of a number that is all but its limit


def ratio_figures(check: Check, *, most: int = FIGURES) -> int:
    """Return to how many figures demand over capacity stands between 16 and 84 % of the draws.

    They are as many, one at least, as keep it on its side of 1.

    Parameters
    ----------
    check : of any procedure; all figures stand where it has no numerical spread
    most : figures to be shown at most
    """
    if check.ratio is None:
        return most
    spread = check.numerical
    ends = () if spread is None else (spread.ratio_low, spread.ratio_high)
    return side_figures(check.ratio, max(1, standing_figures(check.ratio, ends, most=most)))


def side_figures(value: float, figures: int, *, limit: float = 1.0) -> int:
    """Return the least number of figures, of `figures` and more, that shows a number on its side of a limit.

    Parameters
    ----------
    value : the number that is shown
    figures : to which it stands
    limit : what it is compared with
    """
    return next(
        (each for each in range(figures, FARTHEST) if _side(value, limit) == _side(value, limit, each)), FARTHEST
    )


def _side(value: float, limit: float, figures: int = 12) -> int:
    """Return -1, 0 or 1 for a number, written to some figures, that is below, at or above a limit."""
    shown, of = float(f"{value:.{figures}g}"), float(f"{limit:.12g}")
    return (shown > of) - (shown < of)


def margin_figures(margin: float, most: float | None) -> int:
    """Return to how many figures the factor on the action is written up to which a mechanism holds.

    Parameters
    ----------
    margin : the factor
    most : the same up to which 16 % of the draws hold; None where there is no spread
    """
    return side_figures(margin, 3 if most is None else interval_figures(margin, most))


def interval_figures(low: float, high: float, *, most: int = 3, limit: float | None = None) -> int:
    """Return to how many figures the two ends of an interval are written, so that they differ.

    Parameters
    ----------
    low, high : its ends, positive
    most : figures where they hardly differ
    limit : what they are compared with, on whose sides they are to be shown; None for nothing
    """
    figures = most if high <= low else max(1, min(most, floor(log10(high)) - floor(log10(high - low)) + 1))
    return figures if limit is None else max(side_figures(each, figures, limit=limit) for each in (low, high))


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
