"""One answer over all samples of the uncertain inputs: its distribution, and the inputs that it hangs on."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from assess.results.uncertainty import Influence, UncertainAnswer
from reports.figures.style import FAIL, HALF, INK, record_label, report_style, sheet
from reports.language.locale import Locale
from reports.language.texts import Text, Verbatim, say

RISING, FALLING = "#d55e00", "#56b4e9"
HEIGHT = 1.95  # of a figure [in]
MOST = 6  # bars
LONGEST = 26  # letters of the name of a bar
TAIL, PAST = 98.0, 1.5  # percentile up to whose so many times the axis reaches
PERCENT = 100.0


def draw_distribution(answer: UncertainAnswer, locale: Locale) -> Figure:
    """Draw the share of samples [%] whose demand over capacity is at most a value; the limit is at 1."""
    ratios = np.sort([ratio for ratio in answer.ratios if ratio is not None])
    with report_style():
        figure = sheet(HEIGHT, locale, width=HALF)
        axes = figure.subplots()
        share = PERCENT * np.arange(1, ratios.size + 1) / max(answer.answered, ratios.size, 1)
        axes.step(ratios, share, where="post", color="#0072b2")
        axes.axvline(1.0, color=FAIL, linewidth=1.0)
        if answer.at_mean is not None:
            axes.axvline(answer.at_mean, color=INK, linewidth=0.8, linestyle=":")
        high = min(ratios[-1], PAST * float(np.percentile(ratios, TAIL))) if ratios.size else 1.0
        axes.set_xlim(0.0, 1.08 * max(high, 1.0, answer.at_mean or 0.0))
        axes.set_ylim(0.0, 103.0)
        axes.set_xlabel(locale.heading(say("demand / capacity"), "ratio"))
        axes.set_ylabel(locale.heading(say("samples at or below"), "percent"))
        return figure


def draw_influences(answer: UncertainAnswer, locale: Locale) -> Figure:
    """Draw the rank correlation of the answer with each group of inputs, the strongest at the top."""
    found = rank_influences(answer)[:MOST]
    with report_style():
        figure = sheet(HEIGHT, locale, width=HALF)
        axes = figure.subplots()
        values = [influence.rank_correlation or 0.0 for influence in found]
        colours = [RISING if value > 0.0 else FALLING for value in values]
        axes.barh(range(len(found)), values, 0.6, color=colours, linewidth=0)
        axes.set_yticks(range(len(found)), [record_label(locale.text(group_name(each)), LONGEST) for each in found])
        axes.set_ylim(max(len(found), 3) - 0.4, -0.6)
        axes.axvline(0.0, color=INK, linewidth=0.8)
        axes.set_xlim(-1.0, 1.0)
        axes.set_xlabel(locale.heading(say("rank correlation with demand / capacity"), "ratio"))
        axes.grid(visible=False, axis="y")
        axes.tick_params(axis="y", length=0)
        return figure


def rank_influences(answer: UncertainAnswer) -> list[Influence]:
    """Return the groups that change an answer, the strongest first."""
    known = [each for each in answer.influences if each.rank_correlation is not None]
    return sorted(known, key=lambda each: -abs(each.rank_correlation or 0.0))


def group_name(influence: Influence) -> Text:
    """Return the key of a single input, or the name of a group of several."""
    return Verbatim(influence.keys[0] if len(influence.keys) == 1 else influence.group)
