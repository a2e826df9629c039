"""All mechanisms on one axis."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest
from matplotlib.figure import Figure

from assess.codes.check import Check, Outcome
from assess.results import Results
from reports.figures import comparison
from reports.figures.style import mechanism_pens
from reports.language.locale import Locale

DRAWN = (comparison.draw_capacities, comparison.draw_demands, comparison.draw_curves)


@pytest.mark.parametrize("draw", DRAWN)
def test_user_text_stays_letter_for_letter(results: Results, draw: Callable[[Results, Locale], Figure]) -> None:
    named = [replace(each, label="Wall 6 m $x$\x07") for each in results.mechanisms[:1]]
    figure = draw(replace(results, mechanisms=(*named, *results.mechanisms[1:])), Locale(system="US"))
    figure.draw_without_rendering()
    axes = figure.axes[0]
    words = [tick.get_text() for tick in axes.get_yticklabels()]
    words += [text.get_text() for legend in figure.legends for text in legend.get_texts()]
    assert any("Wall 6 m $x$⟨U+0007⟩" in word.replace("\n", " ") for word in words)


def test_procedures_have_titles_in_the_legend(results: Results) -> None:
    figure = comparison.draw_demands(results, Locale())
    shown = {text.get_text() for legend in figure.legends for text in legend.get_texts()}
    assert "ASCE 43-05 history" in shown
    assert not any(check.procedure in shown for mechanism in results.mechanisms for check in mechanism.checks)


def test_every_level_has_a_panel(results: Results) -> None:
    levels = {row.level_pga_g for row in results.comparison}
    figure = comparison.draw_demands(results, Locale())
    assert sum(axes.get_visible() for axes in figure.axes) == len(levels)


def test_how_an_answer_is_drawn(results: Results) -> None:
    found: Check = results.mechanisms[0].checks[0]
    for change, kind in (
        ({"ratio": 0.4, "verdict": Outcome.PASS}, "inside"),
        ({"ratio": 9.0, "verdict": Outcome.FAIL}, "beyond"),
        ({"ratio": None, "verdict": Outcome.FAIL}, "beyond"),
        ({"ratio": None, "verdict": Outcome.NOT_ANSWERED}, ""),
    ):
        assert comparison.marker_kind(replace(found, **change)) == kind


def test_variants_of_one_wall_share_a_colour(results: Results) -> None:
    first = results.mechanisms[0]
    keys = {key: value for key, value in results.project.items() if key.startswith(f"mechanisms.{first.name}.")}
    twin = replace(first, name="twin")
    project = results.project | {key.replace(f".{first.name}.", ".twin."): value for key, value in keys.items()}
    pens = mechanism_pens(replace(results, mechanisms=(*results.mechanisms, twin), project=project))
    assert keys
    assert pens["twin"].colour == pens[first.name].colour
    assert pens["twin"].dash != pens[first.name].dash
    assert pens[results.mechanisms[1].name].colour != pens[first.name].colour
