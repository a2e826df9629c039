"""Numbers in texts: rounded once, from the full value, in the units of the document."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from itertools import chain
from math import log10

import pint
import pytest
from hypothesis import given
from hypothesis import strategies as st
from matplotlib.figure import Figure as Drawn
from reports.language.document_texts import map_texts
from reports.language.measures import Units, as_typed, in_units, measure, measures, number, render_measures, unit_word
from reports.language.message_text import message_text
from reports.language.us_units import WORKED_IN_SI
from reports.localisation import localise

from assess.messages.message import Message, Quantity, note, warning
from assess.results import AmplificationResult, Factor, Resolved, Results
from assess.results.json import dumps
from reports.assessment import assessment
from reports.document import Document, Figure, Section, Text
from reports.figures.style import report_style, sheet

REGISTRY = pint.UnitRegistry()
NUMBER = re.compile(r"[-−]?\d+(?:\.\d+)?(?:e[+-]\d+|×10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?")
RAISED = str.maketrans("−⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "--0123456789")


def us(text: str) -> str:
    return render_measures(text, units="US")


def si(text: str) -> str:
    return render_measures(text, units="SI")


def test_a_length_is_rounded_once() -> None:
    """1.3643 m is 1.36 m and 4.476 ft; the rounded 1.36 m would be 4.46 ft."""
    text = measure(1.3643, "m", figures=3)
    assert (si(text), us(text)) == ("1.36 m", "4.48 ft")
    assert us(measure(1.3643, "m", figures=5)) == "4.4760 ft"


SHOWN = [
    (measure(1.36e6, "Pa", figures=3), "1.36e+06 Pa", "197 psi"),
    (measure(1.0, "MPa", figures=3, style="aligned"), "1.00 MPa", "145 psi"),
    (measures((1.1164, 2.99, 6.43), "m", figures=3, between=" × "), "1.12 × 2.99 × 6.43 m", "3.66 × 9.81 × 21.1 ft"),
    (f"{number(5.0, 'GPa/m', figures=4, style='round')} {unit_word('GPa/m')}", "5 GPa/m", "18420 psi/in"),
    (f"{as_typed([0.3048, -3, 0.0], 'm')} {unit_word('m')}", "[0.3048, -3, 0] m", "[1, −9.84, 0] ft"),
    (f"{as_typed(0.30479999999999996, 'm')} {unit_word('m')}", "0.30479999999999996 m", "1 ft"),
    (f"{as_typed(4.45008, 'm')} {unit_word('m')}", "4.45008 m", "14.6 ft"),
    (measure(12.34567, "Hz", figures=3), "12.3 Hz", "12.3 Hz"),
    (measure(0.0, "m", figures=3), "0 m", "0 ft"),
    (measure(1.962, "m/s2", figures=4), "1.962 m/s2", "0.2001 g"),
]


@pytest.mark.parametrize(("text", "in_si", "in_us"), SHOWN)
def test_both_systems_show_the_full_value(text: str, in_si: str, in_us: str) -> None:
    assert (si(text), us(text)) == (in_si, in_us)


@given(st.floats(1e-3, 1e9), st.sampled_from(("m", "mm", "kg", "N", "kN m", "Pa", "kg/m³")), st.integers(3, 6))
def test_a_number_in_us_units_is_within_half_of_its_last_figure(value: float, unit: str, figures: int) -> None:
    """Beside pint; a number that was rounded in SI first is up to five times as far off."""
    shown, _, name = us(measure(value, unit, figures=figures)).partition(" ")
    exact = value * factor(unit, name)
    assert abs(read(shown) / exact - 1.0) <= 0.5 * 10.0 ** (1 - figures) * 1.0000001


def test_a_message_is_told_in_both_systems_from_its_values() -> None:
    told = warning("ground-motion-at-height", "mechanisms.w", height=Quantity(1.3643, "length", 3), remedy="see 1.36 m")
    assert si(message_text(told)) == told.text
    assert us(message_text(told)).startswith("the highest support of the mechanism is 4.48 ft above the ground")
    assert us(message_text(told)).endswith("see 1.36 m")  # a text of somebody's is never converted
    unknown = Message("of-another-version", told.severity, "", told.text, told.values)
    assert message_text(unknown) == told.text


def test_what_a_shortening_cuts_leaves_no_signs() -> None:
    text = f"{'x' * 30} {measure(1.3643, 'm', figures=3)}"
    for length in range(31, len(text)):
        assert re.fullmatch(r"x{30}( 4\.48)?( ?…|…)?", us(text[:length].rstrip() + "…")), length


def factor(unit: str, other: str) -> float:
    """How many of `other` one `unit` is, by pint."""
    one, into = (re.sub(r"(?<=[a-z])(\d)", r"**\1", each.translate(RAISED_UNITS)) for each in (unit, other))
    into = {"g": "standard_gravity"}.get(into, into)
    found: float = REGISTRY.Quantity(1.0, one.replace(" ", "*")).to(into.replace(" ", "*")).magnitude
    return found


RAISED_UNITS = str.maketrans({"²": "**2", "³": "**3"})


def read(shown: str) -> float:
    return float(shown.replace("×10", "e").translate(RAISED))


@pytest.fixture(scope="module")
def tall(results: Results) -> Results:
    """A mechanism above the ground, with heights, sizes and warnings that rounding twice would show."""
    first = results.mechanisms[0]
    assert first.view is not None
    height = 1.3643
    mode = note(
        "by-first-mode", "mechanisms.wall-6", frequency=Quantity(4.0, "frequency"), frequency_from="given",
        effective=Quantity(7.62462, "length"), effective_from="given", damping=Quantity(0.05, "ratio", 3),
        height=Quantity(height, "length"), shape=Quantity(0.1789),
    )  # fmt: skip
    raised = AmplificationResult("srss", (Factor("artificial-1", 1.25),), height, (mode,))
    view = replace(first.view, size=(1.3643, 2.9996, 6.4349))
    told = warning("gap", "mechanisms.wall-6", one="a 3 m wall", other="b", distance=Quantity(0.0123456, "length", 3))
    return replace(
        results,
        mechanisms=(replace(first, amplification=raised, view=view), *results.mechanisms[1:]),
        warnings=(*results.warnings, told),
        project={**results.project, "bodies.wall.box.thickness": Resolved(1.3643, True)},
    )


def texts(results: Results, units: Units) -> list[str]:
    """Every text of a document in these units, in order, each figure's caption among them."""
    project = {**results.project, "report.units": Resolved(units, True)}
    found: list[str] = []

    def seen(text: str) -> str:
        found.append(text)
        return text

    map_texts(localise(assessment(replace(results, project=project))), seen)
    return [text for text in found if text != WORKED_IN_SI]


def values(results: object) -> set[float]:
    """The size of every number of results.json."""
    if isinstance(results, dict):
        return set(chain.from_iterable(map(values, results.values())))
    if isinstance(results, list):
        return set(chain.from_iterable(map(values, results)))
    return {abs(float(results))} if isinstance(results, int | float) and not isinstance(results, bool) else set()


def pairs(one: str, other: str) -> Iterator[tuple[str, str, str, str]]:
    """The numbers that differ in two forms of a text, with the next word after each that is a unit."""
    units = (re.findall(r"[^\W\d_][^\s,;:()\]]*", NUMBER.sub(" ", text)) for text in (one, other))
    changed = [pair for pair in zip(*units, strict=True) if pair[0] != pair[1]]
    assert len({*changed}) == 1, (one, other)
    for first, second in zip(NUMBER.findall(one), NUMBER.findall(other), strict=True):
        if first != second:
            yield first, second, *changed[0]


def rounds_to(value: float, shown: str) -> bool:
    """Whether a number is what it is rounded to."""
    digits = re.sub(r"\D", "", re.split(r"e|×", shown)[0]).lstrip("0")
    step = 10.0 ** (1 - len(digits))
    return abs(value / read(shown) - 1.0) <= 0.5 * step * 1.0000001 if read(shown) else value == 0.0


def test_every_number_of_a_us_report_is_that_of_the_results(tall: Results) -> None:
    """Each that differs from the SI report is one value of results.json, rounded once in either."""
    known, compared = values(json.loads(dumps(tall))), 0
    for one, other in zip(texts(tall, "SI"), texts(tall, "US"), strict=True):
        if one == other or not NUMBER.search(one):
            continue
        for in_si, in_us, unit, name in pairs(one, other):
            times = factor(unit, name)
            found = [v for v in known if rounds_to(v, in_si.lstrip("-−")) and rounds_to(v * times, in_us.lstrip("-−"))]
            assert found, (one, other)
            compared += 1
    assert compared >= 8


def test_the_figures_of_both_reports_are_as_many(tall: Results) -> None:
    for one, other in zip(texts(tall, "SI"), texts(tall, "US"), strict=True):
        if "along x, y and z" in one:
            assert "1.36 × 3 × 6.43 m" in one
            assert "4.48 × 9.84 × 21.1 ft" in other
            return
    pytest.fail("the bodies in space are not in the report")


def test_texts_of_the_user_stay(tall: Results) -> None:
    name = "Wall 3 m high, 2 kN <b>"
    first = replace(tall.mechanisms[0], label=name)
    project = {**tall.project, "title": Resolved("A 12 m tower", True)}
    found = texts(replace(tall, mechanisms=(first, *tall.mechanisms[1:]), project=project), "US")
    assert found[0] == "A 12 m tower"
    assert f"Mechanism: {name}" in found
    assert any("a 3 m wall" in text for text in found)  # a body
    assert not any("9.84 ft high" in text for text in found)


def test_names_of_ticks_are_words_too() -> None:
    with report_style():
        figure = sheet(1.0)
        axes = figure.subplots()
        axes.set_yticks([0, 1], [f"thickness\n{measure(1.3643, 'm', figures=3)}", "restitution"])
    figures = (Figure("ticks", "", partial(_same, figure)),)
    document = Document("", "", "", "", "A4", (), (Section("One", 0, (*figures, Text(("1 m",)))),), ())
    drawn = in_units(document, "US").figures[0].draw()
    drawn.draw_without_rendering()
    assert [text.get_text() for text in drawn.axes[0].get_yticklabels()] == ["thickness\n4.48 ft", "restitution"]


def _same(figure: Drawn) -> Drawn:
    return figure


def test_a_typed_number_keeps_its_figures_within_reason() -> None:
    for value in (0.5, 3, 12.25, 1234.5678):
        digits = len(json.dumps(value).replace(".", "").lstrip("0"))
        shown = us(as_typed(value, "m"))
        assert 3 <= len(re.sub(r"\D", "", shown).lstrip("0")) <= max(3, min(6, digits)) + int(log10(value) > 5)
