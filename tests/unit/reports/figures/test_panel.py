"""Panels against matplotlib's own axes: the same letters at the same places, the same lines."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.path import Path
from matplotlib.ticker import MaxNLocator, NullFormatter
from reports.figures.ruler import Canvas

from reports.figures.style import report_style, sheet
from reports.render.vector import Letters, Stroke, trace_figure

TIME = np.linspace(0.0, 20.0, 401)
Scene = Callable[[Figure], None]


def two_panels_that_share(figure: Figure) -> None:
    """The upper one without numbers, a title, a legend outside."""
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=(1, 2))
    above.plot(TIME, np.sin(TIME), label="ground")
    below.plot(TIME, 1e-7 * TIME * np.cos(TIME), label="rotation")
    above.set_title("above", loc="left")
    below.set(xlabel="time [s]", ylabel="rotation [rad]")
    figure.legend(loc="outside upper right", ncols=2)


def logarithmic(figure: Figure) -> None:
    """Smaller ticks without numbers."""
    axes = figure.subplots()
    axes.plot(TIME + 0.01, np.exp(-TIME))
    axes.set(xscale="log", yscale="log", xlabel="period T [s]", ylabel="S [g]", xlim=(0.01, 5.0))
    axes.xaxis.set_minor_formatter(NullFormatter())


def large_numbers(figure: Figure) -> None:
    """A power of ten beside each scale."""
    axes = figure.subplots()
    axes.plot(1e8 * TIME, -3e9 * TIME)
    axes.set(xlabel="energy [J]", ylabel="moment [N m]")


def named_lines(figure: Figure) -> None:
    """Names of two lines at ticks without length, a scale turned round, no grid across."""
    axes, other = figure.subplots(1, 2, sharey=True)
    axes.set_yticks(range(3), ["Wall 0\nthe top", "Wall 1", "Façade gp"])
    axes.set_ylim(2.5, -0.5)
    for each in (axes, other):
        each.xaxis.set_major_locator(MaxNLocator(4, steps=[1, 2, 5, 10]))
        each.grid(visible=False, axis="y")
        each.tick_params(axis="y", length=0, labelsize=5.8)
    figure.supxlabel("demand / capacity [-]")


def placed_by_hand(figure: Figure) -> None:
    """A panel of given place whose scale of x has no tick, and one without scales."""
    figure.set_layout_engine("none")
    axes = figure.add_axes((0.2, 0.2, 0.3, 0.7))
    axes.set(xlim=(0.0, 3.0), ylim=(-1.0, 4.0), ylabel="z [m]")
    axes.set_xticks([])
    figure.add_axes((0.6, 0.2, 0.3, 0.7)).set_axis_off()


@pytest.fixture(params=[two_panels_that_share, logarithmic, large_numbers, named_lines, placed_by_hand])
def scene(request: pytest.FixtureRequest) -> Iterator[Scene]:
    """What is drawn."""
    with report_style():
        yield request.param


def pair(scene: Scene) -> tuple[Figure, Figure]:
    """The scene on panels, and on matplotlib's own axes of the same size."""
    ours = sheet(2.6)
    theirs = Figure(figsize=ours.get_size_inches(), layout="constrained")
    Canvas(theirs)
    for figure in (ours, theirs):
        scene(figure)
    return ours, theirs


def letters(figure: Figure) -> list[tuple[object, ...]]:
    """Every text with its look."""
    marks = [mark for mark in trace_figure(figure).marks if isinstance(mark, Letters)]
    return sorted((m.text, m.angle, m.size, m.colour, round(m.x, 6), round(m.y, 6)) for m in marks)


def lines(figure: Figure) -> list[tuple[object, ...]]:
    """Every straight piece of a line with its look."""
    found = set()
    for mark in trace_figure(figure).marks:
        if isinstance(mark, Stroke) and mark.line is not None:
            points = np.round(mark.numbers, 6).reshape(-1, 2).tolist()
            drawn = [code for code in mark.codes if code != Path.CLOSEPOLY][1:]
            pairs = zip(points, points[1:], drawn, strict=False)
            found |= {(*a, *b, mark.width, mark.line) for a, b, code in pairs if code == Path.LINETO}
    return sorted(found)


def test_letters_stand_where_matplotlib_puts_them(scene: Scene) -> None:
    ours, theirs = pair(scene)
    assert letters(ours) == letters(theirs)
    assert len(letters(ours)) > 3


def test_grid_ticks_and_frames_are_those_of_matplotlib(scene: Scene) -> None:
    ours, theirs = pair(scene)
    assert lines(ours) == lines(theirs)
    assert lines(ours)


def test_no_artist_is_made_of_a_tick(scene: Scene) -> None:
    figure, _ = pair(scene)
    trace_figure(figure)
    made = [len(axis.majorTicks) for axes in figure.axes for axis in (axes.xaxis, axes.yaxis)]
    assert sum(made) == 0 or scene is named_lines  # whose names matplotlib keeps in ticks


def test_a_hidden_scale_takes_no_place() -> None:
    with report_style():
        figure = sheet(2.0)
        axes: Axes = figure.subplots()
        axes.yaxis.set_visible(False)
        assert axes.yaxis.get_tightbbox() is None
        axes.yaxis.set_visible(True)
        box = axes.yaxis.get_tightbbox()
        assert box is not None
        assert box.x0 < axes.bbox.x0


def test_a_scale_that_has_been_drawn_shows_its_new_range() -> None:
    def numbers(*ranges: tuple[float, float]) -> list[str]:
        with report_style():
            figure = sheet(2.0)
            axes = figure.subplots()
            for low, high in ranges:
                axes.set_xlim(low, high)
                marks = trace_figure(figure).marks
        return [mark.text for mark in marks if isinstance(mark, Letters)]

    assert numbers((0.0, 1.0), (0.0, 7e7)) == numbers((0.0, 7e7)) != numbers((0.0, 1.0))


def test_drawn_in_pixels_they_look_alike_at_any_resolution(scene: Scene) -> None:
    """By matplotlib's own renderer: letters and lines stand within a pixel of where its axes have them."""
    pictures = []
    for figure in pair(scene):
        canvas = FigureCanvasAgg(figure)
        figure.set_dpi(144)
        canvas.draw()
        pictures.append(np.asarray(canvas.buffer_rgba())[..., :3].min(axis=-1) < 160)
    ours, theirs = pictures
    near = np.zeros_like(theirs)
    for down in range(-3, 4):
        for across in range(-3, 4):
            near |= np.roll(theirs, (down, across), axis=(0, 1))
    assert (ours & ~near).sum() <= 0.01 * ours.sum()
