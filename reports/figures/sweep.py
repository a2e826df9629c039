"""A parametric study: results over the swept number."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from assess.results import SweepResult
from reports.figures.style import FAIL, label, report_style, sheet
from reports.language.locale import Locale
from reports.language.texts import Phrase, say

Values = Sequence[float | None]


def draw(sweep: SweepResult, locale: Locale) -> Figure:
    """Draw the results over the values, a panel for each quantity that is known of any case."""
    shown = panels(sweep)
    with report_style():
        figure = sheet(2.0, locale)
        beside = figure.subplots(1, len(shown), squeeze=False)[0]
        for axes, (values, name, dimension) in zip(beside, shown, strict=True):
            _curve(axes, sweep, values)
            axes.set_ylabel(locale.heading(name, dimension))
            axes.xaxis.set_major_locator(MaxNLocator(5, steps=[1, 2, 2.5, 5, 10]))
            if values is sweep.demand_capacity:
                axes.axhline(1.0, color=FAIL, linewidth=0.8)
        figure.supxlabel(label(f"{sweep.key} [{sweep.unit}]", 90), fontsize=7)
        return figure


def panels(sweep: SweepResult) -> list[tuple[Values, Phrase, str]]:
    """Return the quantities of which any value is known, with their names and dimensions.

    On joints without a threshold of uplift the overturning rotation replaces the multiplier.
    """
    threshold = (sweep.uplift_multiplier, say("load multiplier at uplift λ"), "ratio")
    overturning = (sweep.overturning_flexible_rad, say("overturning on joints φₒᵥ"), "rotation")
    all_of_them: list[tuple[Values, Phrase, str]] = [
        threshold if known(sweep.uplift_multiplier) else overturning,
        (sweep.p_eq_per_s, say("frequency parameter p"), "angular frequency"),
        (sweep.demand_capacity, say("demand / capacity"), "ratio"),
    ]
    return [each for each in all_of_them if known(each[0])]


def known(values: Values) -> bool:
    """Return whether any case has a value."""
    return any(value is not None for value in values)


def _curve(axes: Axes, sweep: SweepResult, values: Values) -> None:
    """Draw the known values in the order of the swept number, with the controlling case marked."""
    known = sorted((x, y) for x, y in zip(sweep.value, values, strict=True) if y is not None)
    axes.plot([x for x, _ in known], [y for _, y in known], marker="o", markersize=3, color="#0072b2", linewidth=1.0)
    highest = max((y for _, y in known), default=1.0)
    axes.set_ylim(0.0, 1.15 * highest or 1.0)  # from 0: noise must not look like a trend
    x, y = sweep.value[sweep.controlling], values[sweep.controlling]
    if y is not None:
        axes.plot([x], [y], "o", markersize=8, markerfacecolor="none", markeredgecolor=FAIL)
