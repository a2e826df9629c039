"""Text and formulas as markup."""

from __future__ import annotations

import pytest
from hypothesis import given, strategies
from reportlab.platypus import Paragraph

from reports.lettering import printable, shortened, visible
from reports.typeset import formula, paragraph, register_fonts


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
