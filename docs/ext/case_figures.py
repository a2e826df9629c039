"""Figures of a solved case: how well it agrees, and what the program draws of its project."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from textwrap import fill
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure
from pydantic import TypeAdapter

from assess.results import MechanismResult, Results
from assess.results.json import loads
from assess.results.verification import CaseResult, QuantityResult, ValueResult
from reports.assessment import report_figure
from reports.figures import capacity, sketch
from reports.figures.style import FAIL, HALF, INK, MUTED, PAPER, PASS, WIDTH, report_style, sheet
from reports.language.locale import Locale

OF_A_RUN = ("key-plan", "curves")
OF_A_MECHANISM = ("view", "sketch", "moment", "capacity", "history", "envelope")
MOST = 4  # figures of a project
CAPTIONS = {
    "key-plan": "The building",
    "curves": "All mechanisms: rotation over peak ground acceleration, and restoring moment over rotation",
    "view": "{}: the mechanism in space",
    "sketch": "{}: the mechanism in its plane",
    "moment": "{}: restoring moment over rotation, by joint",
    "capacity": "{}: restoring moment and multiplier over rotation",
    "history": "{}: ground acceleration and rotation under one record",
    "envelope": "{}: which pulses overturn it",
}
COLOURS = {"pass": PASS, "misprint": MUTED, "fail": FAIL}
LOCALE = Locale()


def draw_agreement(result: CaseResult) -> Figure:
    """Draw the difference of each value over its tolerance, and the program's values over those of the source."""
    largest = max(result.quantities, key=lambda each: len(each.values))
    count = len(result.quantities)
    with report_style():
        figure = sheet(max(2.4, 0.8 + 0.28 * count), LOCALE, width=WIDTH)
        over, within = figure.subplots(1, 2, width_ratios=(1.0, 1.6))
        _draw_over(over, largest)
        _draw_within(within, result.quantities)
    return figure


def _draw_over(axes: Axes, quantity: QuantityResult) -> None:
    """The program's values over those of the source, with the line on which they are equal."""
    shown = [each for each in quantity.values if each.found is not None]
    for each in shown:
        axes.plot(each.expected, each.found, "o", ms=3.2, color=COLOURS[each.outcome])
    ends = [value for each in shown for value in (each.expected, each.found) if value is not None] or [0.0, 1.0]
    margin = 0.06 * (max(ends) - min(ends)) or 0.1 * abs(ends[0]) or 1.0
    limits = (min(ends) - margin, max(ends) + margin)
    axes.plot(limits, limits, color=MUTED, lw=0.7, zorder=0)
    axes.set(xlim=limits, ylim=limits, aspect="equal", xlabel="source", ylabel="program")
    unit = f" [{quantity.unit}]" if quantity.unit else ""
    axes.set_title(fill(f"{quantity.name}{unit}", 36))


def _draw_within(axes: Axes, quantities: tuple[QuantityResult, ...]) -> None:
    """The difference of each value over its tolerance, a row for each quantity."""
    axes.axvspan(-1.0, 1.0, color=PAPER, lw=0.0, zorder=0)
    axes.axvline(0.0, color=INK, lw=0.7)
    for place, quantity in enumerate(quantities):
        for value in quantity.values:
            share = difference_share(quantity, value)
            if share is not None:
                axes.plot(max(-1.5, min(1.5, share)), place, "o", ms=3.2, color=COLOURS[value.outcome], alpha=0.75)
    axes.set(xlim=(-1.6, 1.6), ylim=(len(quantities) - 0.5, -0.5), xlabel="difference / tolerance [–]")
    axes.set_yticks(range(len(quantities)), [fill(each.name, 28) for each in quantities])
    axes.grid(visible=False, axis="y")


def difference_share(quantity: QuantityResult, value: ValueResult) -> float | None:
    """Return the difference of a value over its tolerance [-]; None where there is no value or no tolerance."""
    allowed = quantity.tolerance.around(value.reference)
    return value.difference / allowed if value.difference is not None and allowed else None


def project_results(tree: Mapping[str, Any]) -> Results | None:
    """Return the results of a case that is a project; None of others."""
    return loads(json.dumps(tree)) if "schema_version" in tree and "mechanisms" in tree else None


def tree_mechanisms(tree: Mapping[str, Any]) -> tuple[MechanismResult, ...]:
    """Return the mechanisms of a case that builds them without assessing them; none of others."""
    found = tree.get("mechanisms")
    if "schema_version" in tree or not isinstance(found, list):
        return ()
    return TypeAdapter(tuple[MechanismResult, ...]).validate_python(found)


def draw_mechanisms(mechanisms: tuple[MechanismResult, ...]) -> Iterator[tuple[str, str, Figure]]:
    """Yield name, caption and figure of the first and the last mechanism: in its plane, and its moments."""
    for place, each in enumerate(mechanisms[:: max(1, len(mechanisms) - 1)][:2]):
        named = each.label or each.name
        yield f"sketch-{place}", CAPTIONS["sketch"].format(named), sketch.draw_sketch(each, LOCALE)
        yield f"capacity-{place}", CAPTIONS["capacity"].format(named), capacity.draw_capacity(each, LOCALE)


def draw_project(results: Results) -> Iterator[tuple[str, str, Figure]]:
    """Yield name, caption and figure of the first figures that the report draws of the run and its first mechanism."""
    first = results.mechanisms[0]
    found = [*_drawn(OF_A_MECHANISM, results, first.name)]
    if len(results.mechanisms) > 1:
        found = [*_drawn(OF_A_RUN, results, None), *found]
    for name, figure in found[:MOST]:
        yield name, CAPTIONS[name].format(first.label or first.name), figure


def _drawn(names: tuple[str, ...], results: Results, mechanism: str | None) -> Iterator[tuple[str, Figure]]:
    from assess.errors import AssessError

    for name in names:
        try:
            yield name, report_figure(name, results, mechanism=mechanism)
        except AssessError:  # these results have no such figure
            continue


def is_half(figure: Figure) -> bool:
    """Return whether a figure takes half a page's width."""
    return bool(figure.get_figwidth() <= 1.2 * HALF)
