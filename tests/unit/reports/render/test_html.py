"""The page as a parser of HTML sees it."""

from __future__ import annotations

import base64
import hashlib
import re
from dataclasses import replace
from pathlib import Path

import pytest
from lxml import html

from reports.document import Document, Section, Table
from reports.language.locale import Locale, visible
from reports.render.html import FRAME, SCRIPTS, web_resource
from tests.support.sample_document import sample_document, write_page


@pytest.fixture(scope="module")
def document() -> Document:
    return sample_document()


@pytest.fixture(scope="module")
def page(document: Document, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_page(document, tmp_path_factory.mktemp("html") / "report.html")


@pytest.fixture(scope="module")
def tree(page: Path) -> html.HtmlElement:
    return html.document_fromstring(page.read_text(encoding="utf-8"))


def test_nothing_comes_from_elsewhere(page: Path, tree: html.HtmlElement) -> None:
    """Every reference leads into the page, and the policy allows this style sheet and this script alone."""
    for attribute in ("href", "src", "{http://www.w3.org/1999/xlink}href", "xlink:href"):
        found = [each.get(attribute) for each in tree.iter() if each.get(attribute)]
        assert all(re.match(r"#|data:,$|data:image/png;base64,[\w+/=]+$", each) for each in found)
    assert not re.search(r"@import|url\((?!#w)|fetch\(|XMLHttpRequest|innerHTML|eval\(", page.read_text("utf-8"))
    (policy,) = tree.xpath("//meta[@http-equiv='Content-Security-Policy']/@content")
    rules = dict(rule.strip().split(" ", 1) for rule in policy.split(";"))
    assert rules["default-src"] == "'none'"
    for rule, (element,) in (("style", tree.xpath("//style")), ("script", tree.xpath("//script[@type='module']"))):
        digest = base64.b64encode(hashlib.sha256(element.text.encode()).digest()).decode()
        assert rules[f"{rule}-src"] == f"'sha256-{digest}'"


def test_nothing_runs_or_styles_by_attribute(tree: html.HtmlElement) -> None:
    """Such attributes would be refused by the policy."""
    assert not [name for each in tree.iter() for name in each.attrib if name == "style" or name.startswith("on")]


def test_every_reference_has_its_target_once(tree: html.HtmlElement) -> None:
    ids = [each.get("id") for each in tree.iter() if each.get("id")]
    assert len(set(ids)) == len(ids)
    wanted = {each.get("href")[1:] for each in tree.xpath("//a[@href]")}
    wanted |= {each.get("xlink:href")[1:] for each in tree.iter("use")}
    wanted |= {each.get("clip-path")[5:-1] for each in tree.xpath("//*[@clip-path]")}
    wanted |= {name for each in tree.xpath("//*[@aria-labelledby]") for name in each.get("aria-labelledby").split()}
    assert wanted <= set(ids)


def test_contents_list_every_section(document: Document, tree: html.HtmlElement) -> None:
    links = tree.xpath("//nav//a")
    for link, section in zip(links, document.sections, strict=True):
        (heading,) = tree.xpath(f"//*[@id='{link.get('href')[1:]}']")
        title = visible(f"{section.mark} {document.writer.text(section.title)}".strip())
        assert (heading.tag, heading.text_content()) == (f"h{section.level + 2}", title)
        assert link.text_content() == title
        assert len(link.xpath("ancestor::ul")) == section.level + 1


def test_captions_are_numbered_in_the_order_of_the_document(document: Document, tree: html.HtmlElement) -> None:
    """Photographs are figures, in rows or not."""
    for kind, path in (("Figure", "//figcaption"), ("Table", "//*[contains(@class, 'sortable')]/caption")):
        found = [each.text_content().partition(".")[0] for each in tree.xpath(path)]
        assert found == [f"{kind}\u00a0{number}" for number in range(1, len(found) + 1)]
        assert len(found) == sum(of == kind for of, _ in document.numbers)


def test_a_reference_names_the_caption(tree: html.HtmlElement) -> None:
    caption = tree.get_element_by_id("figure-2-caption").text_content()
    assert caption.startswith("Figure\u00a02.")
    assert "caption-row-1#" in caption
    assert any(each.text_content().startswith("Figure\u00a02 and Table\u00a01 show") for each in tree.iter("p"))


def test_alternative_texts_are_the_captions(tree: html.HtmlElement) -> None:
    for drawing in tree.xpath("//div[@class='picture']/svg"):
        (caption,) = tree.xpath(f"//*[@id='{drawing.get('aria-labelledby')}']")
        assert drawing.get("role") == "img"
        assert caption.text_content().startswith("Figure\u00a0")


def test_heads_of_tables_have_a_scope(tree: html.HtmlElement) -> None:
    assert all(head.get("scope") in ("col", "row") for head in tree.iter("th"))
    assert tree.get("lang") == "en"


def test_words_of_the_page_stand_in_its_template_alone(tree: html.HtmlElement) -> None:
    """Which a locale fills."""
    assert {button.text_content() for button in tree.xpath("//template//button")} == {"Enlarge", "Turn in 3D"}
    assert not any(word in web_resource(name) for name in SCRIPTS for word in ("Enlarge", "Close", "Reset"))


def test_formulas_have_indices_and_powers(tree: html.HtmlElement) -> None:
    sheets = tree.xpath("//table[contains(@class, 'sheet')]")
    assert any(each.text_content() == "S,1" for each in sheets[0].iter("sub"))
    assert any(each.text_content() == "2" for each in sheets[0].iter("sup"))


def test_words_of_the_page_are_those_of_the_language(tmp_path: Path) -> None:
    written = html.parse(write_page(sample_document(Locale("it")), tmp_path / "it.html")).getroot()
    assert written.get("lang") == "it"
    labels = {button.text_content() for button in written.xpath("//template//button")}
    assert labels == {Locale("it").text(FRAME[name]) for name in ("enlarge", "turn")}
    assert written.findtext(".//summary") == "Indice"


@pytest.mark.parametrize(("locale", "shown"), [(Locale("it"), "1,235"), (Locale("en", "US"), "4.050")])
def test_numbers_are_written_in_the_locale_and_sorted_by_their_values(
    tmp_path: Path, locale: Locale, shown: str
) -> None:
    written = html.parse(write_page(sample_document(locale), tmp_path / "page.html")).getroot()
    cell = written.xpath("//table[@id='table-1']/tbody/tr[1]/td[3]")[0]
    assert (cell.text, float(cell.get("data-value"))) == (shown, 1.23456789)


def test_a_table_without_rows_has_its_heads(document: Document, tmp_path: Path) -> None:
    table = next(block for block in document.blocks if isinstance(block, Table))
    section = Section(table.caption, 0, (replace(table, rows=(), muted=frozenset()),))
    written = html.parse(write_page(replace(document, sections=(section,)), tmp_path / "page.html")).getroot()
    assert len(written.xpath("//thead//th")) == len(table.columns)


def test_lines_to_copy_stay_lines(tree: html.HtmlElement) -> None:
    assert tree.xpath("//pre")[0].text_content().splitlines()[1:] == ["[report]", 'title = "x"']


def test_the_same_document_gives_the_same_bytes(page: Path, tmp_path: Path) -> None:
    assert write_page(sample_document(), tmp_path / "two.html").read_bytes() == page.read_bytes()
