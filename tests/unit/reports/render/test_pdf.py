"""The PDF as a reader of its text sees it."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, Literal

import pytest
from matplotlib.figure import Figure as Drawn
from pypdf import PdfReader
from pypdf.generic import Destination
from reportlab.pdfbase import pdfmetrics

from reports.document import (
    Banner,
    Block,
    BulletList,
    Column,
    Document,
    Facts,
    Figure,
    FigureRow,
    FileLines,
    OutcomeCell,
    OutcomeColour,
    Prose,
    Section,
    Signatures,
    Table,
    WritingBox,
)
from reports.figures.style import BANNER, printable
from reports.language.locale import Locale
from reports.language.texts import Verbatim, quantity
from reports.render.pdf import write_pdf
from reports.render.pdf_blocks import BOLD, INK_OF, REGULAR, TINT, column_widths, register_fonts, width_of
from reports.render.table_text import verdict_word
from tests.support.letters import without_spaces
from tests.support.sample_document import HOSTILE, sample_document

WORDS = "the wall rocks about its base and comes to rest again after a few impacts " * 3


def pages_of(path: Path) -> list[str]:
    return [" ".join(page.extract_text().split()) for page in PdfReader(path).pages]


def text_of(path: Path) -> str:
    return " ".join(pages_of(path))


def write(folder: Path, *sections: Section, **changed: Any) -> Path:
    """Write the sample document with these sections in place of its own."""
    return write_pdf(replace(sample_document(), sections=sections, **changed), folder / "report.pdf")


def section(*blocks: Block, title: str = "A chapter", starts_page: bool = False) -> Section:
    return Section(Verbatim(title), 0, blocks, starts_page)


def figure(name: str, height: float) -> Figure:
    return Figure(name, Verbatim(f"Caption of {name}."), lambda _: Drawn(figsize=(3.3, height)))


@pytest.fixture(scope="module")
def document() -> Document:
    return sample_document(tall=60)


@pytest.fixture(scope="module")
def report(document: Document, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_pdf(document, tmp_path_factory.mktemp("pdf") / "report.pdf")


def test_text_of_the_user_is_printed_letter_for_letter(report: Path) -> None:
    text, wanted = without_spaces(text_of(report)), without_spaces(printable(HOSTILE))
    tags = ("title", "client", "reference", "headline", "basis", "point", "caption-key-plan", "head", "cell", "graded")
    tags += ("mechanism", "name", "listed", "caption-row-1", "photograph", "sheet")
    assert [tag for tag in tags if f"{wanted}{tag}#" not in text] == []
    assert wanted in text.replace("#", "")


def test_every_page_says_which_of_how_many_and_of_what(report: Path) -> None:
    pages = pages_of(report)
    for place, page in enumerate(pages, start=1):
        assert f"page {place} of {len(pages)}" in page
        assert "assess 9.9.9, stamp 0123456789abcdef" in page
        assert page.startswith("=cmd|")
        assert "Revision =cmd|" in page


def test_the_running_head_stays_on_its_line(report: Path) -> None:
    for page in PdfReader(report).pages:
        lines = sorted((x, text) for x, y, text, *_ in lettered(page) if y > float(page.mediabox.top) - 50)
        (left, title), (right, running) = lines
        assert left + pdfmetrics.stringWidth(title, REGULAR, 7) < right
        assert right + pdfmetrics.stringWidth(running, REGULAR, 7) < float(page.mediabox.right) - 50


def test_bookmarks_name_the_chapters_and_reach_their_pages(document: Document, report: Path) -> None:
    reader = PdfReader(report)
    marks = [mark for mark in reader.outline if isinstance(mark, Destination)]
    assert [str(mark.title)[:2] for mark in marks] == ["1 ", "2 ", "M1", "3 ", "A "]
    for mark in marks:
        page = reader.get_destination_page_number(mark)
        assert page is not None
        assert str(mark.title)[:40] in " ".join(reader.pages[page].extract_text().split())


def test_contents_list_chapters_and_mechanisms_with_their_pages(report: Path) -> None:
    reader = PdfReader(report)
    place = next(place for place, page in enumerate(pages_of(report)) if "Contents" in page)
    numbers = [int(found) for found in re.findall(r"(?: \.)+ (\d+)", reader.pages[place].extract_text())]
    marks = [mark for mark in reader.outline if isinstance(mark, Destination)]
    assert numbers == [(reader.get_destination_page_number(mark) or 0) + 1 for mark in marks]
    links = [each.get_object() for each in reader.pages[place]["/Annots"]]  # type: ignore[attr-defined]
    assert len(links) == len(marks)
    assert all(link["/Subtype"] == "/Link" for link in links)


def test_title_author_and_subject_are_in_the_properties(report: Path) -> None:
    found = PdfReader(report).metadata
    assert found is not None
    assert str(found.title).endswith("title#")
    assert str(found.author).endswith("author#")
    assert found.subject == "Seismic assessment of masonry by rocking dynamics"


@pytest.mark.parametrize(("date", "year"), [("2026-05-12", 2026), ("12 May", 2000), ("", 2000)])
def test_the_date_of_the_report_is_that_of_the_file(document: Document, tmp_path: Path, date: str, year: int) -> None:
    found = PdfReader(write_pdf(replace(document, date=date), tmp_path / "dated.pdf")).metadata
    assert found is not None
    assert found.creation_date is not None
    assert found.creation_date.year == year


def test_the_same_document_gives_the_same_bytes(document: Document, report: Path, tmp_path: Path) -> None:
    assert write_pdf(document, tmp_path / "again.pdf").read_bytes() == report.read_bytes()


def test_figures_are_vectors_and_photographs_pictures(report: Path) -> None:
    assert [len(page.images) for page in PdfReader(report).pages if page.images] == [1, 1]  # logo and photograph
    assert "rotation φ [rad]" in text_of(report)


@pytest.mark.parametrize("paper", ["A4", "letter"])
def test_paper(document: Document, tmp_path: Path, paper: Literal["A4", "letter"]) -> None:
    box = PdfReader(write_pdf(replace(document, paper=paper), tmp_path / "r.pdf")).pages[0].mediabox
    width, height = {"A4": (210 / 25.4, 297 / 25.4), "letter": (8.5, 11.0)}[paper]
    assert float(box.width) / 72 == pytest.approx(width, abs=1e-3)
    assert float(box.height) / 72 == pytest.approx(height, abs=1e-3)


def test_numbers_have_the_units_and_the_decimal_sign_of_the_locale(tmp_path: Path) -> None:
    text = text_of(write_pdf(sample_document(Locale("it", "US")), tmp_path / "it.pdf"))
    assert "40,5 ft" in text  # 12.3456 m
    assert "2,4525" in text  # the sheet is worked in SI
    assert "22,07 m (72,42 ft)" in text
    assert "40.5" not in text


def test_a_sheet_has_its_formula_with_numbers(report: Path) -> None:
    assert "= 2.4525 · 3" in text_of(report)
    assert "22.07 m" in text_of(report)


@pytest.mark.parametrize("outcome", ["pass", "fail", "incomplete", "comparison"])
def test_an_answer_has_a_colour_and_a_word(tmp_path: Path, outcome: OutcomeColour) -> None:
    table = Table(
        "t", Verbatim("A table"), (Column(Verbatim("Answer")),), ((OutcomeCell(outcome, Verbatim("a word")),),)
    )
    path = write(tmp_path, section(table))
    assert "a word" in text_of(path)
    for colour in (TINT[outcome], INK_OF[outcome]):
        red, green, blue = (int(colour[k : k + 2], 16) / 255 for k in (1, 3, 5))
        contents = b"\n".join(
            each.get_data() for page in PdfReader(path).pages if (each := page.get_contents()) is not None
        )
        drawn = [tuple(map(float, found)) for found in re.findall(rb"([\d.]+) ([\d.]+) ([\d.]+) rg", contents)]
        assert (red, green, blue) in [pytest.approx(each, abs=1e-3) for each in drawn]


@pytest.mark.parametrize("near", [False, True])
@pytest.mark.parametrize("outcome", list(BANNER))
def test_the_verdict_is_printed_whole(
    tmp_path: Path, outcome: Literal["pass", "fail", "incomplete"], near: bool
) -> None:
    banner = Banner(outcome, Verbatim("some words beside it"), near)
    assert Locale().text(verdict_word(banner)) in text_of(write(tmp_path, section(banner)))


def test_lines_to_paste_are_printed_letter_for_letter(tmp_path: Path) -> None:
    code = FileLines(('[materials."<b> & stone"]', 'disintegration = "excluded"'))
    assert " ".join(code.lines) in text_of(write(tmp_path, section(code)))


def lettered(page: Any) -> Iterator[tuple[float, float, str, str, float]]:
    """Yield every piece of text of a page: where it begins [pt], its letters, its font, its size."""
    found: list[tuple[float, float, str, str, float]] = []

    def line(text: str, cm: list[float], tm: list[float], font: Any, size: float) -> None:
        if text.strip():
            face = BOLD if font and "Bold" in font["/BaseFont"] else REGULAR
            found.append((tm[4] * cm[0] + cm[4], tm[5] * cm[3] + cm[5], text.strip(), face, size))

    page.extract_text(visitor_text=line)
    yield from found


def test_words_of_ten_thousand_letters_stay_on_the_page_and_are_printed_whole(tmp_path: Path) -> None:
    long = Verbatim("".join(f"{number:05d}" for number in range(2000)))
    columns = (Column(Verbatim("Name")), Column(long), Column(Verbatim("Level"), "length"), Column(Verbatim("Answer")))
    rows = tuple(
        (Verbatim(f"M{place}"), long if place == 3 else None, 0.1, OutcomeCell("pass", long)) for place in range(4)
    )
    blocks = (Prose((long,)), BulletList((long,)), Facts(((long, long),)), Banner("fail", long))
    table = Table("u", long, columns, rows)
    path = write(tmp_path, section(*blocks, title=long.text), section(table))
    reader = PdfReader(path)
    for page in reader.pages:
        for x, y, text, face, size in lettered(page):
            assert x > 45
            assert x + pdfmetrics.stringWidth(text, face, size) < float(page.mediabox.right) - 45
            assert 20 < y < float(page.mediabox.top) - 20
    assert long.text[:3000] in without_spaces(text_of(path))
    assert len(reader.pages) < 40


@pytest.mark.parametrize("shares", [(0.0,) * 30, (0.5, 0.5, 0.0, 0.0), (0.9, 0.9, 0.0), (0.2, 0.0, 0.0)])
def test_columns_have_the_width_of_the_table_together(shares: tuple[float, ...]) -> None:
    register_fonts()
    row = [WORDS[place : place + 40] for place in range(len(shares))]
    widths = column_widths([row, row], shares, 480.0, "head")
    assert sum(widths) == pytest.approx(480.0)
    assert min(widths) > 10.0


def test_a_narrow_table_is_not_stretched_and_no_word_of_it_is_broken() -> None:
    register_fonts()
    widths = column_widths([["Level [g]", "Answer"], ["0.1", "not answered"]], (0.0, 0.0), 480.0, "head")
    assert sum(widths) < 240.0
    assert widths[1] > width_of("not answered", "head")
    rows = [["Name", "Outcome", "Text"], ["M1", "incomplete", WORDS], ["M2", "fail", WORDS]]
    assert column_widths(rows, (0.0,) * 3, 300.0, "head")[1] > width_of("incomplete", "head")


def test_a_figure_higher_than_the_page_is_made_smaller(tmp_path: Path) -> None:
    path = write(tmp_path, section(figure("tall", 30.0), title="Tall"))
    assert [("Tall" in page, "Caption of tall" in page) for page in pages_of(path)[-1:]] == [(True, True)]


def test_figures_of_a_row_stand_side_by_side_over_their_captions(tmp_path: Path) -> None:
    path = write(tmp_path, section(FigureRow((figure("one", 2.0), figure("two", 2.0)))))
    ((one, low, *_), (two, high, *_)) = [each for each in lettered(PdfReader(path).pages[0]) if "Caption" in each[2]]
    assert low == pytest.approx(high)
    assert two - one > 200


def test_the_title_of_a_table_stands_above_its_first_row(tmp_path: Path) -> None:
    long = Verbatim(WORDS * 3)
    columns = (Column(long), Column(Verbatim("Height"), "length"), Column(Verbatim("Text")))
    table = Table("t", Verbatim("Walls"), columns, tuple((Verbatim(f"Wall {n}"), 0.1, long) for n in range(20)))
    for filled in range(30, 55, 3):
        pages = pages_of(write(tmp_path, section(Prose((Verbatim("a line"),) * filled), table)))
        (titled,) = [page for page in pages if "Table 1." in page]
        assert "Wall 0" in titled


def test_a_table_repeats_its_head_on_each_page(tmp_path: Path) -> None:
    rows = tuple((Verbatim(f"Wall {place}"), 0.1 * place) for place in range(150))
    table = Table("t", Verbatim("Walls"), (Column(Verbatim("The wall")), Column(Verbatim("Height"), "length")), rows)
    pages = pages_of(write(tmp_path, section(table)))
    assert len(pages) > 2
    assert all("The wall Height [m]" in page for page in pages)
    assert all(f"Wall {place} " in " ".join(pages) for place in range(150))


def test_no_heading_stands_at_the_foot_of_a_page(tmp_path: Path) -> None:
    table = Table("t", Verbatim("Walls"), (Column(Verbatim("Wall")),), ((Verbatim("one"),),) * 40)
    for filled in range(30, 60, 3):
        blocks = (Prose((Verbatim(WORDS),)), FigureRow((figure("f", 2.0),)), table)
        ends = [replace(section(block, title=f"Heading of {place}"), level=1) for place, block in enumerate(blocks)]
        first = section(Prose((Verbatim("a line"),) * filled))
        for page in PdfReader(write(tmp_path, first, section(title="A chapter alone"), *ends)).pages:
            lines = sorted((y, text) for _, y, text, face, size in lettered(page) if y > 40)
            assert not re.match("Heading of|A chapter alone", lines[0][1])


def test_a_section_that_asks_for_it_begins_a_page_unless_the_page_is_nearly_empty(tmp_path: Path) -> None:
    much, little = section(Prose((Verbatim("a line"),) * 25)), section(Prose((Verbatim("a line"),) * 2))
    asks = section(Prose((Verbatim("asks"),)), title="Asking", starts_page=True)
    no_head: dict[str, Any] = {"facts": (), "logo": None, "title": Verbatim("t")}
    assert ["Asking" in page for page in pages_of(write(tmp_path, much, asks, **no_head))] == [False, True]
    assert ["Asking" in page for page in pages_of(write(tmp_path, little, asks, **no_head))] == [True]
    whole = section(Prose((Verbatim("a line"),) * 42), title="Asking", starts_page=True)  # more than is left
    pages = pages_of(write(tmp_path, little, whole, **no_head))
    assert "Asking" in pages[0]  # no page is left nearly empty
    assert sum(page.count("a line") for page in pages) == 44


def test_a_section_that_may_share_a_page_follows_where_it_fits_whole(tmp_path: Path) -> None:
    """Each has a good third of a page: several follow on a page, and none is divided."""
    names = [f"Part {place}" for place in "ABCD"]
    first = section(Prose((Verbatim("a line"),) * 30))
    parts = [section(*[Prose((Verbatim(WORDS),))] * 9, title=name, starts_page=True) for name in names]
    alone = pages_of(write(tmp_path, first, first, *parts))
    shared = pages_of(write(tmp_path, first, first, *(replace(each, shares_page=True) for each in parts)))
    found = [[sum(name in page for name in names) for page in pages[-4:]] for pages in (alone, shared)]
    assert found[0] == [1, 1, 1, 1]
    assert max(found[1][-2:]) > 1
    assert len(shared) < len(alone)
    assert all(page.count(WORDS[:30]) % 27 == 0 for page in shared)  # three in a paragraph, nine paragraphs


def test_the_title_of_a_list_stays_with_it(tmp_path: Path) -> None:
    listed = (Prose((Verbatim("What follows:"),)), BulletList((Verbatim(WORDS),) * 2))
    for rows in range(20, 60):
        texts = tuple(Verbatim("a line of its own") for _ in range(rows))
        pages = pages_of(write(tmp_path, section(Prose(texts), *listed)))
        page = next(each for each in pages if "What follows:" in each)
        assert WORDS[:30] in page


def test_figures_give_way_where_a_page_has_nearly_room_for_all(tmp_path: Path) -> None:
    facts = Facts(tuple((Verbatim("slenderness"), quantity(0.1)) for _ in range(8)))
    table = Table("t", Verbatim("Walls"), (Column(Verbatim("Wall")),), ((Verbatim("one"),),) * 8)
    sections = [section(Prose((Verbatim("a line"),) * 25))]
    for place in range(3):
        a, b, c = (figure(f"{name}{place}", 2.6) for name in "abc")
        blocks = (FigureRow((a, b)), facts, FigureRow((c,)), table, Prose((Verbatim(WORDS),) * 4))
        sections.append(section(*blocks, title=f"Wall {place}", starts_page=True))
    pages = pages_of(write(tmp_path, *sections))
    assert [[f"Caption of c{place}" in page for page in pages[1:]].index(True) for place in range(3)] == [0, 1, 2]
    assert len(pages) == 4


def test_what_is_written_and_signed_by_hand_stays_on_one_page(tmp_path: Path) -> None:
    judged = section(Prose((Verbatim("judge it"),)), WritingBox(Verbatim("judgement"), 60.0), title="Judgement")
    signed = section(Prose((Verbatim("signed by"),)), Signatures(((Verbatim("Engineer"), Verbatim("A. Name")),)))
    for points in range(10, 50, 4):
        before = section(BulletList((Verbatim("a point"),) * points))
        pages = pages_of(write(tmp_path, before, judged, signed))
        assert sum("judge it" in page and "signed by" in page and "A. Name" in page for page in pages) == 1


def test_a_photograph_without_a_picture_keeps_its_caption(document: Document, tmp_path: Path) -> None:
    assert document.logo is not None
    for data in ("no base 64 §", "AAAA", ""):
        path = write(tmp_path, section(replace(document.logo, data=data)), logo=replace(document.logo, data=data))
        assert "Figure 1." in text_of(path)
