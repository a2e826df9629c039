"""The PDF as a reader of its text sees it."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Literal

import pytest
from pypdf import PdfReader
from pypdf.generic import Destination
from reports.language.document_texts import map_texts
from reports.localisation import localise

from assess.results import Resolved, Results
from reports.assessment import assessment
from reports.document import Banner, Code, Section
from reports.document import Figure as DrawnFigure
from reports.figures.style import bare_sheet
from reports.render.pdf import write_pdf

HOSTILE = ("<b>&", "<para>", "</font>", "=cmd()", "$x$", "{}%s", "\\frac{1}{2}")


def text_of(path: Path) -> str:
    return " ".join(" ".join(page.extract_text() for page in PdfReader(path).pages).split())


@pytest.fixture(scope="module")
def report(results: Results, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_pdf(localise(assessment(results)), tmp_path_factory.mktemp("pdf") / "report.pdf")


def test_text_holds_every_verdict_and_every_mechanism(results: Results, report: Path) -> None:
    text = text_of(report)
    for mechanism in results.mechanisms:
        assert mechanism.name in text
        assert mechanism.label in text
        for check in mechanism.checks:
            assert check.procedure in text
    number = r"(?:no rocking|none lasting|\S+)"
    rows = re.findall(
        rf"(?:rotation, rad|acceleration, g) {number} \S+ \S+ {number} \S+ \S+ (pass|fail|not-answered)", text
    )
    assert rows == [check.verdict for mechanism in results.mechanisms for check in mechanism.checks]


def test_every_page_says_which_of_how_many(report: Path) -> None:
    pages = PdfReader(report).pages
    for place, page in enumerate(pages, start=1):
        assert f"page {place} of {len(pages)}" in page.extract_text()


def test_no_page_is_empty(report: Path) -> None:
    assert min(len(page.extract_text()) for page in PdfReader(report).pages) > 200


def test_bookmarks_name_the_sections_and_reach_their_pages(results: Results, report: Path) -> None:
    reader = PdfReader(report)
    marks = [mark for mark in reader.outline if isinstance(mark, Destination)]
    titles = [section.title for section in assessment(results).sections if section.level == 0]
    assert [mark.title for mark in marks] == titles
    for mark in marks:
        page = reader.get_destination_page_number(mark)
        assert page is not None
        assert str(mark.title) in " ".join(reader.pages[page].extract_text().split())


def test_contents_link_to_their_sections(report: Path) -> None:
    links = [each.get_object() for each in PdfReader(report).pages[1]["/Annots"]]  # type: ignore[attr-defined]
    assert len(links) >= 14
    assert all(link["/Subtype"] == "/Link" for link in links)


def test_contents_have_the_numbers_of_the_pages(report: Path) -> None:
    reader = PdfReader(report)
    numbers = {int(found) for found in re.findall(r"(?: \. )+(\d+)", reader.pages[1].extract_text())}
    marks = [mark for mark in reader.outline if isinstance(mark, Destination)]
    assert {(reader.get_destination_page_number(mark) or 0) + 1 for mark in marks} <= numbers
    assert len(numbers) > 5


def test_the_same_document_gives_the_same_bytes(results: Results, report: Path, tmp_path: Path) -> None:
    assert write_pdf(localise(assessment(results)), tmp_path / "again.pdf").read_bytes() == report.read_bytes()


def test_symbols_and_numbers_reach_the_text(report: Path) -> None:
    text = text_of(report)
    for wanted in ("overturned", "no rocking", "artificial-5", "φₒᵥ", "β", "not checked against the printed standard"):
        assert wanted in text
    assert "1.607" in text  # 0.45 g / 0.28 g


def test_figures_are_drawn_as_vectors(report: Path) -> None:
    assert not any(page.images for page in PdfReader(report).pages)
    assert "peak ground acceleration, PGA [g]" in text_of(report)


@pytest.mark.parametrize("paper", ["A4", "letter"])
def test_paper(results: Results, tmp_path: Path, paper: str) -> None:
    whole = assessment(results)
    document = replace(whole, paper=paper, sections=whole.sections[:2])  # type: ignore[arg-type]
    box = PdfReader(write_pdf(document, tmp_path / "r.pdf")).pages[0].mediabox
    width, height = {"A4": (210 / 25.4, 297 / 25.4), "letter": (8.5, 11.0)}[paper]
    assert float(box.width) / 72 == pytest.approx(width, abs=1e-3)
    assert float(box.height) / 72 == pytest.approx(height, abs=1e-3)


def hostile(results: Results, text: str) -> Results:
    """The results with `text` wherever a user may write."""
    first, *others = results.mechanisms
    hinges = tuple(replace(hinge, name=text) for hinge in first.drawing.hinges)
    named = replace(first, name=text, label=text, drawing=replace(first.drawing, hinges=hinges))
    keys = ("title", "engineer", "checker", "client", "reference", "notes", "masonry_quality", text)
    return replace(
        results,
        mechanisms=(named, *others),
        records=tuple(replace(r, id=text, path=text, event=text, trail=(text,)) for r in results.records),
        project={**results.project, **{key: Resolved(text, True) for key in keys}},
        inputs=(replace(results.inputs[0], path=text),),
        warnings=tuple(replace(warning, where=text, text=text) for warning in results.warnings),
        comparison=tuple(
            replace(r, mechanism=text if r.mechanism == first.name else r.mechanism) for r in results.comparison
        ),
    )


def test_markup_and_rare_letters_appear_as_text(results: Results, tmp_path: Path) -> None:
    rare = "Ж λ 東 😀 \x07 \u202e é\ud800"
    text = text_of(write_pdf(localise(assessment(hostile(results, " ".join((*HOSTILE, rare))))), tmp_path / "r.pdf"))
    for wanted in (*HOSTILE, "Ж λ", "⟨U+6771⟩", "⟨U+1F600⟩", "⟨U+0007⟩", "⟨U+202E⟩", "é⟨U+D800⟩"):
        assert text.count(wanted) > 5


def test_long_text_is_shortened_in_heads_and_printed_once_in_full(results: Results, tmp_path: Path) -> None:
    long = "".join(f"{number:05d}" for number in range(2000))
    reader = PdfReader(write_pdf(localise(assessment(hostile(results, long))), tmp_path / "r.pdf"))
    texts = ("".join(re.sub(r"page \d+ of \d+", "", page.extract_text()).split()) for page in reader.pages)
    squeezed = "".join(texts)
    assert "…" in squeezed
    found = sum(f"{number:05d}" in squeezed for number in range(2000))
    assert found > 1990  # headers and footers cut one or two where a page ends
    assert len(reader.pages) < 40


def test_a_figure_higher_than_the_page_is_made_smaller(results: Results, tmp_path: Path) -> None:
    tall = DrawnFigure("tall", "A tower. " * 60, lambda: bare_sheet(30.0))
    document = assessment(results)
    one = replace(document, sections=(Section("Tall", 0, (tall,)),))
    assert len(PdfReader(write_pdf(one, tmp_path / "tall.pdf")).pages) <= 3


@pytest.mark.parametrize("near", [False, True])
@pytest.mark.parametrize("verdict", ["pass", "fail", "incomplete"])
def test_the_verdict_on_the_cover_is_printed_whole(
    results: Results, tmp_path: Path, verdict: Literal["pass", "fail", "incomplete"], near: bool
) -> None:
    banner = Banner(verdict, "some words beside it", near)
    document = replace(assessment(results), sections=(Section("Verdict", 0, (banner,)),), data=())
    assert banner.word in text_of(write_pdf(document, tmp_path / "verdict.pdf"))


def test_lines_to_paste_are_printed_letter_for_letter(results: Results, tmp_path: Path) -> None:
    code = Code(('[materials."<b> & stone"]', 'disintegration = "excluded"'))
    document = replace(assessment(results), sections=(Section("Verdict", 0, (code,)),), data=())
    assert " ".join(code.lines) in text_of(write_pdf(document, tmp_path / "code.pdf"))
    assert map_texts(document, str.upper).sections[0].blocks == (code,)
