"""Numbers beside axes: the decimal sign of the language, whatever the machine's, and no power of ten below."""

from __future__ import annotations

import pytest
from matplotlib.figure import Figure

from reports.figures.style import fitting_scale, report_style, sheet, table_scale
from reports.language.locale import Locale
from reports.language.texts import say


class _Italian(Locale):
    """A locale with a decimal comma, without a catalogue."""

    @property
    def point(self) -> str:
        """The decimal sign."""
        return ","


def drawn(locale: Locale, *, scale: str = "linear") -> Figure:
    with report_style():
        figure = sheet(2.0, locale, width=3.0)
        axes = figure.subplots()
        axes.plot([0.01, 0.02, 0.05], [-0.25, 0.0, 0.25])
        axes.set_xscale(scale)
    figure.draw_without_rendering()
    return figure


def names(figure: Figure, axis: str) -> list[str]:
    return [tick.get_text() for tick in getattr(figure.axes[0], f"get_{axis}ticklabels")() if tick.get_text()]


def test_an_axis_has_the_decimal_comma_of_its_language() -> None:
    found = names(drawn(_Italian()), "y")
    assert "−0,2" in found
    assert not any("." in name for name in found)
    assert "−0.2" in names(drawn(Locale()), "y")


@pytest.mark.parametrize(("locale", "tick"), [(Locale(), "0.01"), (_Italian(), "0,01")])
def test_a_logarithmic_axis_has_numbers_as_they_are_read(locale: Locale, tick: str) -> None:
    assert tick in names(drawn(locale, scale="log"), "x")


def test_labels_that_were_set_stay() -> None:
    with report_style():
        figure = sheet(2.0, _Italian())
        figure.subplots().set_yticks([0.0, 1.0], ["Wall 1.5 m", "Wall 2"])
    figure.draw_without_rendering()
    assert names(figure, "y") == ["Wall 1.5 m", "Wall 2"]


def test_one_unit_for_a_whole_axis() -> None:
    small, large = (fitting_scale("moment", [0.1 * top, -top], Locale()) for top in (200.0, 3.4e6))
    assert (small.heading(say("moment")), large.heading(say("moment"))) == ("moment [N m]", "moment [MN m]")
    assert large.in_unit([3.4e6]) == pytest.approx([3.4])
    feet = table_scale("length", Locale(system="US"))
    assert feet.in_unit([0.3048, 3.048]) == pytest.approx([1.0, 10.0])
    assert feet.heading(say("elevation z")) == "elevation z [ft]"
    assert table_scale("ratio", Locale()).heading(say("demand / capacity")) == "demand / capacity [-]"
