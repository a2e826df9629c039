"""Pages of the signed part: few for many mechanisms, none nearly empty, the first by itself."""

from __future__ import annotations

from pathlib import Path

import pytest
from pypdf import PdfReader

from reports.assessment import assessment
from reports.render.pdf import write_pdf
from tests.support.examples import example_results

MOST = {"san_leonardo_tower": 18, "chiesa": 14}
"""Pages, of twelve mechanisms and of six."""


@pytest.mark.parametrize("name", MOST)
def test_the_signed_part_has_few_pages_and_none_is_nearly_empty(name: str, tmp_path: Path) -> None:
    path = write_pdf(assessment(example_results(name), detail="main"), tmp_path / "report.pdf")
    pages = PdfReader(path).pages
    assert len(pages) <= MOST[name]
    assert "2 Key plan" in pages[1].extract_text()
    for page in pages:
        heights: list[float] = []

        def note_height(text: str, frame: list[float], place: list[float], *_: object) -> None:
            if text.strip():
                heights.append(frame[5] + frame[3] * place[5])  # noqa: B023  # called at once

        page.extract_text(visitor_text=note_height)
        tall = float(page.mediabox.height)
        body = [each for each in heights if 45 < each < tall - 45]
        assert max(body) - min(body) > tall / 3 - 60
