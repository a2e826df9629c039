"""What works reach over what they take: every layout that was examined, the front, the target, and the least proved."""

from __future__ import annotations

from math import isfinite

from matplotlib.figure import Figure

from assess.results.retrofit import Layout, RetrofitResults, TargetKind
from reports.figures.style import FAIL, INK, MUTED, PASS, legend_below, report_style, sheet
from reports.language.locale import Locale
from reports.language.texts import Phrase, Text, Verbatim, say

MEASURES: dict[TargetKind, Phrase] = {
    "index": say("Index"),
    "ratio": say("Largest rotation over that which overturns"),
    "probability": say("Probability of overturning, upper end of 84 %"),
}
COST, STEEL = say("Cost"), say("Steel of ties")
HEIGHT = 3.0  # in


def cost_heading(results: RetrofitResults) -> Text:
    """Return what an axis or column of cost is called, with its currency where one is named.

    Parameters
    ----------
    results : of the search
    """
    return say("Cost [{currency}]", currency=Verbatim(results.currency)) if results.currency else COST


def draw_front(results: RetrofitResults, locale: Locale) -> Figure:
    """Draw what layouts reach [-] over their steel [kg] or cost; those with which a record overturns are left out."""
    known = [each for each in results.layouts if isfinite(results.target.beyond(each))]
    size = 1.0 if results.priced else locale.table_unit("mass").size

    def points(layouts: list[Layout] | tuple[Layout, ...]) -> tuple[list[float], list[float]]:
        values = [each.reached.value for each in layouts if each.reached is not None and each.reached.value is not None]
        return [each.objective / size for each in layouts], values

    with report_style():
        figure = sheet(HEIGHT, locale)
        axes = figure.subplots()
        axes.plot(*points(known), "o", color=MUTED, markersize=2.5, label=locale.text(say("examined")))
        front = [each for each in results.front if each in known]
        axes.plot(*points(front), "-o", color=INK, markersize=3.5, label=locale.text(say("Pareto front")))
        if failed := [each for each in known if results.fell_short(each)]:
            axes.plot(*points(failed), "x", color=FAIL, markersize=5, label=locale.text(say("falls short")))
        if results.best is not None:
            axes.plot(*points([results.best]), "*", color=PASS, markersize=10, label=locale.text(say("least, proved")))
        axes.axhline(results.target.reach, color=FAIL, linestyle="--", label=locale.text(say("target")))
        axes.set_xlabel(locale.text(cost_heading(results)) if results.priced else locale.heading(STEEL, "mass"))
        axes.set_ylabel(locale.text(MEASURES[results.target.kind]))
        legend_below(figure, columns=5)
        return figure
