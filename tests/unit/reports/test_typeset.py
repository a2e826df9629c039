"""Text and formulas as markup."""

from __future__ import annotations

from io import BytesIO

import numpy as np
import pytest
from hypothesis import given, strategies
from pypdf import PdfReader
from reportlab.pdfgen.canvas import Canvas
from reportlab.platypus import Flowable, Paragraph

from reports.lettering import printable, shortened, visible
from reports.typeset import Plain, formula, paragraph, register_fonts


def test_indices_are_lowered_and_powers_raised() -> None:
    assert formula("S_a") == 'S<sub rise="1.2" size="5.2">a</sub>'
    assert ">2</super>" in formula("π^2")
    assert ">a,CAP</sub>" in formula("S_{a,CAP}")
    assert ">a,CAP</sub>" in formula("S_a,CAP = 2")


@pytest.mark.parametrize("text", ["<b>&", "<para>", "</font>", "a_<b>", "x^</sub>", "_", "^", "a_{", "a^{}", "%s {0}"])
def test_no_text_is_markup(text: str) -> None:
    register_fonts()
    for made in (paragraph(text, "body"), Paragraph(formula(text))):
        plain = made.getPlainText(identify=True)
        assert plain.replace("^", "").replace("_", "") == text.replace("^", "").replace("_", "")


@given(strategies.text(max_size=60))
def test_any_text_can_be_set(text: str) -> None:
    register_fonts()
    paragraph(text, "cell").wrap(60, 1000)
    Paragraph(formula(text)).wrap(60, 1000)
    assert printable(printable(text)) == printable(text)


def test_what_cannot_be_seen_is_shown_by_its_code() -> None:
    assert visible("a\x00b\u202ec\nd") == "a⟨U+0000⟩b⟨U+202E⟩c d"
    assert printable("東😀") == "⟨U+6771⟩⟨U+1F600⟩"
    assert shortened("abcdef", 4) == "abc…"
    assert shortened("abcd", 4) == "abcd"


def placed(flowable: Flowable, width: float) -> list[tuple[str, float, float]]:
    """The words of a flowable in a cell of `width` [pt], and where each line begins [pt]."""
    stream, found = BytesIO(), []
    canvas = Canvas(stream)
    flowable.wrapOn(canvas, width, 1000.0)
    flowable.drawOn(canvas, 100.0, 200.0)
    canvas.save()

    def line(text: str, cm: list[float], tm: list[float], *_: object) -> None:
        if text.strip():
            found.append((text.strip(), tm[4] * cm[0] + cm[4], tm[5] * cm[3] + cm[5]))

    PdfReader(stream).pages[0].extract_text(visitor_text=line)
    return found


@pytest.mark.parametrize("style", ["cell", "number", "head", "head-number", "muted", "pass"])
@pytest.mark.parametrize(
    "text", ["0.5994", "asce43-05-spectrum", "<b>&amp;  two", "φ / φₒᵥ [-]", "no\u00a0break", "\u2009thin", "—"]
)
@pytest.mark.parametrize("width", [25.0, 200.0])
def test_plain_text_stands_where_a_paragraph_has_it(text: str, style: str, width: float) -> None:
    register_fonts()
    plain, whole = placed(Plain(text, style), width), placed(paragraph(text, style), width)
    assert [words for words, *_ in plain] == [words for words, *_ in whole]
    np.testing.assert_allclose([at for _, *at in plain], [at for _, *at in whole], rtol=0.0, atol=1e-3)
