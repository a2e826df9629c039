"""Every word of every figure goes through the locale: a language that brackets each entry leaves none without."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text

from assess.results import Results
from reports import governing
from reports.figures import capacity, comparison, key_plan, rocking, sensitivity, sketch, spectrum
from reports.figures.key_plan import building_of
from reports.language.locale import Locale
from reports.language.texts import Verbatim, say
from reports.mechanisms import deformable_joints
from tests.support.drawn_figures import WORD, Bracketed, fixed_words


def every(results: Results) -> Iterator[Callable[[Locale], Figure]]:
    building = building_of(results)
    assert building is not None
    for each in results.mechanisms:
        yield from (
            partial(draw, each) for draw in (sketch.draw_sketch, capacity.draw_capacity, comparison.draw_pga_rotation)
        )
        if deformable_joints(each):
            yield from (partial(draw, each) for draw in (capacity.draw_contact, capacity.draw_moment_rotation))
        found = governing.governing_history(each)
        if found is not None:
            yield partial(rocking.draw_history, each, *found, 0.4)
        if each.envelope is not None:
            yield partial(rocking.draw_envelope, each.envelope, results.records)
        if each.direction_sweep is not None:
            yield partial(sensitivity.draw_directions, each.direction_sweep)
        if each.amplification.motion is not None:
            yield partial(rocking.draw_amplification, each.amplification.motion)
        if each.view is not None:
            yield partial(sketch.draw_view, each.view, 1)
            yield partial(key_plan.draw_place, building, each.name)
    yield from (partial(sensitivity.draw_sweep, each) for each in results.sweeps)
    yield from (partial(draw, results) for draw in (comparison.draw_capacities, comparison.draw_demands))
    yield partial(comparison.draw_curves, results)
    yield partial(key_plan.draw_key_plan, building)
    if results.critical is not None:
        yield partial(rocking.draw_envelope_bounds, results)
    if results.ground_motion is not None:
        yield partial(spectrum.draw_suite, results)
    assert results.spectrum is not None
    yield partial(spectrum.draw_scaled_spectra, results.spectrum, results.records)
    yield partial(spectrum.draw_design_spectrum, results.spectrum)
    bar = sensitivity.TornadoBar((say("density"), Verbatim("1 to 2")), 0.1, 0.3, (None, say("fails")))
    panel = sensitivity.TornadoPanel((say("index"), say("method")), "ratio", 0.2, (0.25, say("limit")), (bar,))
    yield partial(sensitivity.draw_tornado, [panel])


def test_no_word_of_a_figure_is_fixed_in_english(results: Results) -> None:
    own = [each.label or each.name for each in results.mechanisms] + [record.id for record in results.records]
    own += [results.spectrum.clause if results.spectrum else "", *(sweep.key for sweep in results.sweeps)]
    own += [name for each in results.mechanisms for name in (*(load.name for load in each.drawing.loads),)]
    allowed = {word for text in own for word in WORD.findall(text)} | {"SRSS"}
    for draw in every(results):
        assert not fixed_words(draw(Bracketed())) - allowed, str(draw)


@pytest.mark.parametrize("system", ["SI", "US"])
def test_every_figure_is_drawn_in_both_systems(results: Results, system: str) -> None:
    feet, metres = 0, 0
    for draw in every(results):
        figure = draw(Locale(system=system))  # type: ignore[arg-type]
        words = [text.get_text() for text in figure.findobj(Text)]
        feet += any(word.endswith("[ft]") for word in words)
        metres += any(word.endswith("[m]") for word in words)
    assert (feet > 0, metres > 0) == ((False, True) if system == "SI" else (True, False))
