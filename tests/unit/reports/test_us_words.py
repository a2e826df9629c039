"""Quantities in sentences: what is converted and what is not, beside numbers of NIST's tables (1 ft = 0.3048 m)."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from time import perf_counter

import pytest
from matplotlib.figure import Figure as Drawn

from assess.results import Resolved, Results
from reports.assessment import assessment
from reports.document import Document, Figure, Section, Text
from reports.style import sheet, styled
from reports.us_words import in_us_words, in_words

SAID = {
    "4.77 m above the ground": "15.6 ft above the ground",
    "bodies, 1.12 × 2.99 × 6.43 m along x": "bodies, 3.67 × 9.81 × 21.1 ft along x",
    "0.57 to 0.63 m": "1.87 to 2.07 ft",
    "from 0.3 m to 0.6 m": "from 0.984 ft to 1.97 ft",
    "near (0.3048, -0.6096, 3.048) m, so": "near (1.000, -2.000, 10.00) ft, so",
    "profile [[-2.5, 0], [0, 3.048]] m": "profile [[-8.20, 0], [0, 10.00]] ft",
    "box thickness 0.30479999999999996 m": "box thickness 1.00000 ft",
    "+0.2 m from mid-thickness, z = -0.5 m.": "+0.656 ft from mid-thickness, z = -1.64 ft.",
    "up to 1.00 MPa (strength 1.00 MPa)": "up to 145 psi (strength 145 psi)",
    "at 10 GPa/m": "at 36800 psi/in",
    "6.89 GPa": "9.99×10⁵ psi",
    "1.2e+05 N m at rest; 1.2×10⁵ N m": "88.5 kip ft at rest; 88.5 kip ft",
    "40 kN x 2 m / 1.5 m": "8.99 kip x 6.56 ft / 4.92 ft",
    "6400 kg; bears on 0.8 m2, fill 80 kg/m²": "14110 lb; bears on 8.61 ft², fill 16.4 lb/ft²",
    "1620 to 1980 kg/m^3": "101.1 to 123.6 lb/ft³",
    "0.4 mm off, 20 km away, 360 m/s": "0.0157 in off, 12.4 mi away, 1180 ft/s",
    "a* = 1.962 m/s2, 9.81 m/s²": "a* = 0.2001 g, 1.00 g",
    "kept: 0.3 g, 2.5 Hz, 0.2 rad, 5 s, 3 °": "kept: 0.3 g, 2.5 Hz, 0.2 rad, 5 s, 3 °",
}
KEPT = (
    "EN 1998-1:2004 4.3.5.1 and thesis 8.3.2",
    "sqrt((S_a(T_n)/a_g h/h_e)^2 + 1)",
    "mesh walls/wall-3 m.stl and W3 m and v1.2 m",
    'write a length like "1.25 m", or `length = 2 m`; “Wall 3 m high”',
    "3 main walls, 2 Nm, 5 mW, 7 m-wide, 4 m/s³, 2 Paris",
    "C8A.4.1.2, 0.1 [m]",
)


@pytest.mark.parametrize("text", SAID)
def test_quantities_keep_their_figures_and_never_fewer_than_three(text: str) -> None:
    assert in_words(text) == SAID[text]


@pytest.mark.parametrize("text", KEPT)
def test_what_is_no_quantity_stays(text: str) -> None:
    assert in_words(text) == text


@pytest.mark.parametrize(
    "text", ["“" * 10_000, '"' * 9_999, "1" * 10_000 + " m", "1 × " * 5_000, "(1, " * 5_000, "[" * 9_999]
)
def test_long_texts_of_no_quantity_are_read_in_no_time(text: str) -> None:
    start = perf_counter()
    assert in_words(text) == text
    assert perf_counter() - start < 2.0


def test_names_of_the_user_stay_in_sentences_captions_and_figures(results: Results) -> None:
    name = "Wall 3 m high, 2 kN <b>"
    first = replace(results.mechanisms[0], label=name)
    project = {**results.project, "report.units": Resolved("US", True), "title": Resolved("A 12 m tower", True)}
    mechanisms = (first, *results.mechanisms[1:])
    document = in_us_words(assessment(replace(results, mechanisms=mechanisms, project=project)))
    assert document.title == "A 12 m tower"
    assert f"Mechanism: {name}" in [section.title for section in document.sections]
    texts = [text for block in document.blocks if isinstance(block, Text) for text in block.paragraphs]
    assert any(name in text for text in texts)
    cells = {cell for table in document.tables for row in table.rows for cell in row if isinstance(cell, str)}
    assert name in cells
    assert not any("9.84 ft" in text for text in (*texts, *cells))


def test_sheets_are_not_touched(results: Results) -> None:
    document = assessment(results)
    assert in_us_words(document).sheets == document.sheets


def test_names_of_ticks_are_words_too() -> None:
    with styled():
        figure = sheet(1.0)
        axes = figure.subplots()
        axes.set_yticks([0, 1], ["thickness\n0.57 to 0.63 m", "restitution"])
    figures = (Figure("ticks", "", partial(_same, figure)),)
    document = Document("", "", "", "", "A4", (), (Section("One", 0, figures),), ())
    drawn = in_us_words(document).figures[0].draw()
    drawn.draw_without_rendering()
    names = [text.get_text() for text in drawn.axes[0].get_yticklabels()]
    assert names == ["thickness\n1.87 to 2.07 ft", "restitution"]


def _same(figure: Drawn) -> Drawn:
    return figure
