"""The text of cells, beside what a paragraph of reportlab makes of it."""

from __future__ import annotations

from collections.abc import Callable
from io import BytesIO

import numpy as np
import pytest
from hypothesis import given, strategies
from pypdf import PdfReader
from reportlab.pdfgen.canvas import Canvas
from reportlab.platypus import Paragraph
from reports.render.cells import Cell, cell, draw_cells, formula_pieces, plain_cell

from reports.figures.font import printable
from reports.render.typeset import STYLES, paragraph, register_fonts, width_of

PROSE = "a horizontal action lambda times all the weights, at which the mechanism just begins to rock: see the clause"
FORMULA = "S_{a,CAP} = 2 E / (g B_0 φ F_V) (1 + x^2) e^{-π β_e}, S_a,CAP"
MARKED = (
    'S<sub rise="1.2" size="5.2">a,CAP</sub> = 2 E / (g B<sub rise="1.2" size="5.2">0</sub> φ'
    ' F<sub rise="1.2" size="5.2">V</sub>) (1 + x<super rise="2.4" size="5.2">2</super>)'
    ' e<super rise="2.4" size="5.2">-π β<sub rise="1.2" size="5.2">e</sub></super>,'
    ' S<sub rise="1.2" size="5.2">a,CAP</sub>'
)
Lines = list[tuple[str, float, float]]


def drawn(draw: Callable[[Canvas], None]) -> Lines:
    """The words that `draw` puts on a canvas, and where each line begins [pt]."""
    stream, found = BytesIO(), []
    canvas = Canvas(stream)
    draw(canvas)
    canvas.save()

    def line(text: str, cm: list[float], tm: list[float], *_: object) -> None:
        if text.strip():
            found.append((text.strip(), tm[4] * cm[0] + cm[4], tm[5] * cm[3] + cm[5]))

    PdfReader(stream).pages[0].extract_text(visitor_text=line)
    return found


def squeezed(lines: Lines) -> str:
    return "".join("".join(words for words, *_ in lines).split())


def of_cell(made: Cell) -> Lines:
    return drawn(lambda canvas: draw_cells(canvas, [(made, 100.0, 200.0 + made.height)]))


def of_paragraph(made: Paragraph, width: float) -> Lines:
    made.wrap(width, 1000.0)
    return drawn(lambda canvas: made.drawOn(canvas, 100.0, 200.0))


@pytest.mark.parametrize("style", ["cell", "number", "head", "head-number", "muted", "pass", "muted-number-small"])
@pytest.mark.parametrize(
    "text", ["0.5994", "asce43-05-spectrum", "<b>&amp;  two", "φ / φₒᵥ [-]", "no\u00a0break", "\u2009thin", "—"]
)
@pytest.mark.parametrize("width", [25.0, 60.0, 200.0])
def test_plain_text_stands_where_a_paragraph_has_it(text: str, style: str, width: float) -> None:
    register_fonts()
    made, whole = of_cell(plain_cell(text, style, width=width)), of_paragraph(paragraph(text, style), width)
    assert [words for words, *_ in made] == [words for words, *_ in whole]
    np.testing.assert_allclose([at for _, *at in made], [at for _, *at in whole], rtol=0.0, atol=1e-3)


@pytest.mark.parametrize("width", [25.0, 60.0, 200.0])
def test_lines_break_where_a_paragraph_breaks_them(width: float) -> None:
    register_fonts()
    made, whole = of_cell(plain_cell(PROSE, "cell", width=width)), of_paragraph(paragraph(PROSE, "cell"), width)
    assert made == [(words, pytest.approx(x, abs=1e-3), pytest.approx(y, abs=1e-3)) for words, x, y in whole]


@pytest.mark.parametrize("width", [40.0, 90.0, 400.0])
def test_formulas_are_set_as_a_paragraph_sets_them(width: float) -> None:
    register_fonts()
    made = of_cell(cell([formula_pieces(FORMULA)], "cell", width=width))
    whole = of_paragraph(Paragraph(MARKED, STYLES["cell"]), width)
    assert squeezed(made) == squeezed(whole)
    heights = [sorted({round(y, 3) for *_, y in lines}) for lines in (made, whole)]
    assert heights[0] == heights[1]


@pytest.mark.parametrize("text", ["<b>&", "<para>", "</font>", "a_<b>", "x^</sub>", "_", "^", "a_{", "a^{}", "%s {0}"])
def test_no_text_is_markup(text: str) -> None:
    register_fonts()
    shown = "".join(
        letters for line in cell([formula_pieces(text)], "cell", width=200.0).lines for letters, _ in line.pieces
    )
    assert shown.translate(str.maketrans("", "", "^_")) == text.translate(str.maketrans("", "", "^_"))


@given(strategies.text(max_size=80), strategies.floats(20.0, 90.0))
def test_any_text_is_kept_and_no_line_is_too_wide(text: str, width: float) -> None:
    register_fonts()
    made = plain_cell(text, "cell", width=width)
    shown = "".join(letters for line in made.lines for letters, _ in line.pieces)
    assert "".join(shown.split()) == "".join(printable(text).split())
    spare = 0.05 * 40 * width_of(" ", "cell")  # what spaces may be shrunk by, at most 40 on a line
    assert all(line.width <= width + spare for line in made.lines)
