"""The sketch: every panel to one scale, names where there is room."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.patches import Polygon

from assess.results import Drawing, DrawnLoad, HingeForceResult, NamedPoint, Results
from reports.figures.sketch import MASONRY_BESIDE, common_window, draw_sketch, extent_between, panel_size
from reports.figures.style import HALF
from reports.language.locale import Locale


def rings(axes) -> list[np.ndarray]:
    return [patch.get_xy()[:-1] for patch in axes.patches if isinstance(patch, Polygon)]


def test_one_panel_at_rest_and_one_displaced(results: Results) -> None:
    for mechanism in results.mechanisms:
        rest, turned = draw_sketch(mechanism, Locale()).axes
        assert rest.get_title(loc="left") == "at rest"
        assert turned.get_title(loc="left").startswith("displaced, φ = 0.")


def test_feet_are_written_at_round_numbers_of_feet(results: Results) -> None:
    axes = draw_sketch(results.mechanisms[0], Locale(system="US")).axes[0]
    ticks = [float(tick.get_text().replace("−", "-")) for tick in axes.get_yticklabels()]
    np.testing.assert_allclose(axes.get_yticks(), np.array(ticks) * 0.3048, rtol=1e-12)
    assert axes.get_ylabel() == "elevation z [ft]"


def test_all_panels_have_one_scale_and_it_is_true(results: Results) -> None:
    figure = draw_sketch(results.mechanisms[0], Locale())
    for axes in figure.axes:
        box = axes.get_window_extent()
        across = box.width / np.ptp(axes.get_xlim())
        assert box.height / np.ptp(axes.get_ylim()) == pytest.approx(across, rel=1e-9)
    scales = [axes.get_window_extent().width / np.ptp(axes.get_xlim()) for axes in figure.axes]
    assert scales == pytest.approx([scales[0]] * 2, rel=1e-9)


def test_displaced_panels_show_the_displaced_shape_over_the_one_at_rest(results: Results) -> None:
    drawing = results.mechanisms[0].drawing
    figure = draw_sketch(results.mechanisms[0], Locale())
    back, displaced, rest = rings(figure.axes[1])
    assert back == pytest.approx(np.array(drawing.displaced_negative.blocks[0]))
    assert displaced == pytest.approx(np.array(drawing.displaced.blocks[0]))
    assert rest == pytest.approx(np.array(drawing.blocks[0]))
    assert rings(figure.axes[0])[0] == pytest.approx(np.array(drawing.blocks[0]))


@pytest.mark.parametrize(
    ("system", "weight", "floor", "reaction"),
    [
        ("SI", "G 98.1 kN", "floor <beam>: 11.4 kN", "A 6.6 kN"),
        ("US", "G 22 kip", "floor <beam>: 2.56 kip", "A 1.48 kip"),
    ],
)
def test_forces_are_written_in_the_units_of_the_project(
    results: Results, system: str, weight: str, floor: str, reaction: str
) -> None:
    """By hand: 10 t and 1.16 t times g; the hypotenuse of 4310 N and 5000 N; 4448.2 N to the kip."""
    mechanism = results.mechanisms[0]
    at = mechanism.drawing.displaced.hinges[0].at
    displaced = replace(mechanism.drawing.displaced, hinges=(NamedPoint("A", at),))
    drawing = replace(
        mechanism.drawing,
        masses_kg=(1e4,),
        displaced=displaced,
        loads=(DrawnLoad("floor <beam>", (0.2, 6.1), "mass", (0.0, -1.0)),),
    )
    loaded = replace(mechanism, drawing=drawing, loads=results.mechanisms[1].loads, hinge_forces=_FORCES)
    rest, turned = draw_sketch(loaded, Locale(system=system)).axes
    names = {text.get_text().replace("\xa0", " ") for axes in (rest, turned) for text in axes.texts}
    assert {weight, floor, reaction} <= names


_FORCES = (HingeForceResult("A", "positive", -4310.0, 5000.0, 0.862, 0.6, 5e3, -4310.0, (0, 1), True, 0.4, 0.3, False),)


def test_nothing_lies_outside_the_window(results: Results) -> None:
    drawing = results.mechanisms[0].drawing
    window = common_window(drawing)
    points = np.concatenate([drawing.blocks[0], drawing.displaced.blocks[0], drawing.displaced_negative.blocks[0]])
    assert np.all(points > window.low)
    assert np.all(points < window.high)


@pytest.mark.parametrize("size", [(2.0, 9.0), (12.0, 5.0), (40.0, 2.0)])
def test_two_panels_fit_half_the_page(size: tuple[float, float]) -> None:
    wide, high = panel_size(size)
    assert 2 * wide < HALF
    assert 0.9 <= high < 2.5


def test_hinges_are_coloured_by_branch_whatever_they_are_called(results: Results) -> None:
    mechanism = results.mechanisms[0]
    drawing: Drawing = mechanism.drawing
    named = replace(drawing, hinges=tuple(NamedPoint("$x'", hinge.at) for hinge in drawing.hinges))
    figure = draw_sketch(replace(mechanism, drawing=named), Locale())
    names = [text for text in figure.axes[0].texts if text.get_text() == "$x'"]
    assert len(names) == 2
    assert names[0].get_color() != names[1].get_color()


def test_masonry_that_stays_is_shown_beside_the_mechanism_up_to_a_limit(results: Results) -> None:
    drawing = replace(results.mechanisms[0].drawing, fixed=())
    alone = common_window(drawing)
    (left, low), (right, _) = alone.low, alone.high
    size = (right - left) / 5
    below = ((left - size, low - 9.0), (right, low - 9.0), (right, low - 8.0))
    assert common_window(replace(drawing, fixed=(below,))) == alone
    wide = ((left - 99.0, low), (right, low), (right, low + 2.0), (left - 99.0, low + 2.0))
    grown = common_window(replace(drawing, fixed=(wide,)))
    assert grown.high[0] >= alone.high[0]
    assert 0.0 < alone.low[0] - grown.low[0] <= MASONRY_BESIDE * max(alone.size)


def test_how_far_a_ring_reaches_between_two_elevations() -> None:
    triangle = ((0.0, 0.0), (4.0, 0.0), (2.0, 2.0))
    assert extent_between(triangle, 1.0, 3.0) == pytest.approx((1.0, 3.0))
    assert extent_between(triangle, 3.0, 4.0) == ()
