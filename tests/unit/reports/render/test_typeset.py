"""Text as markup."""

from __future__ import annotations

import pytest
from hypothesis import given, strategies

from reports.figures.style import printable
from reports.language.locale import truncate, visible
from reports.render.pdf_blocks import paragraph, register_fonts


@pytest.mark.parametrize("text", ["<b>&", "<para>", "</font>", "a_<b>", "x^</sub>", "_", "^", "a_{", "a^{}", "%s {0}"])
def test_no_text_is_markup(text: str) -> None:
    register_fonts()
    assert paragraph(text, "body").getPlainText(identify=True) == text


@given(strategies.text(max_size=60))
def test_any_text_can_be_set(text: str) -> None:
    register_fonts()
    paragraph(text, "cell").wrap(60, 1000)
    assert printable(printable(text)) == printable(text)


def test_what_cannot_be_seen_is_shown_by_its_code() -> None:
    assert visible("a\x00b\u202ec\nd") == "a⟨U+0000⟩b⟨U+202E⟩c d"
    assert printable("東😀") == "⟨U+6771⟩⟨U+1F600⟩"
    assert truncate("abcdef", 4) == "abc…"
    assert truncate("abcd", 4) == "abcd"
