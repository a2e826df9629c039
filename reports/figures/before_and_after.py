"""What each mechanism holds before and after the works, as two bars over one axis."""

from __future__ import annotations

from matplotlib.figure import Figure

from assess.results import Results
from assess.results.before import state_of
from reports import governing
from reports.figures import style
from reports.language.locale import Locale
from reports.language.texts import say
from reports.mechanisms import title_in_either_state

ROW_HEIGHT, ROOM, TALLEST = 0.36, 0.75, 4.6  # a mechanism, what is above and below all, the figure [in]
BAR = 0.34  # height of a bar, of that of its row [-]
BEFORE, AFTER = style.MUTED, "#0072b2"
NAME_LENGTH = 30  # characters of a line beside a row


def draw_states(results: Results, locale: Locale) -> Figure:
    """Draw the PGA at capacity [g] of every mechanism in both states, and the site's own."""
    before, after = results.before, state_of(results)
    assert before is not None
    assert after is not None
    names = list(dict.fromkeys(each.mechanism for each in (*after.mechanisms, *before.mechanisms)))
    with style.report_style():
        figure = style.sheet(min(ROW_HEIGHT * len(names) + ROOM, TALLEST), locale)
        axes = figure.subplots()
        for state, shift, colour, label in (
            (before, -0.5 * BAR, BEFORE, say("before")),
            (after, 0.5 * BAR, AFTER, say("after")),
        ):
            found = [(row, one.capacity_pga_g) for row, name in enumerate(names) if (one := state.of(name)) is not None]
            held = [(row + shift, pga) for row, pga in found if pga is not None]
            places, lengths = zip(*held, strict=True) if held else ((), ())
            axes.barh(places, lengths, height=BAR, color=colour, label=locale.text(label))
        own = governing.site_pga(results)
        if own is not None:
            axes.axvline(own, color=style.FAIL, linewidth=1.0, label=locale.text(say("site’s own action")))
        titles = [locale.text(title_in_either_state(results, name)) for name in names]
        axes.set_yticks(range(len(names)), [style.fold(title, width=NAME_LENGTH) for title in titles])
        axes.set_ylim(len(names) - 0.5, -0.5)
        axes.tick_params(axis="y", length=0)
        axes.grid(visible=False, axis="y")
        axes.set_xlim(0.0, None)
        axes.set_xlabel(locale.heading(say("peak ground acceleration at capacity"), "ground acceleration"))
        figure.legend(loc="outside lower center", ncols=3)
        return figure
