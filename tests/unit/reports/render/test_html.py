"""The page as a parser of HTML sees it."""

from __future__ import annotations

import base64
import hashlib
import re
from dataclasses import replace
from pathlib import Path

import pytest
from lxml import html

from assess.results import Results
from reports.assessment import assessment
from reports.document import Document, Figure, Section
from reports.figures import spectrum
from reports.render.html import SCRIPTS, resource, write_html
from reports.render.svg import picture
from reports.render.vector import trace_figure


@pytest.fixture(scope="module")
def tree(page: Path) -> html.HtmlElement:
    return html.document_fromstring(page.read_text(encoding="utf-8"))


def digest(text: str) -> str:
    return "'sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() + "'"


def test_nothing_comes_from_elsewhere(page: Path, tree: html.HtmlElement) -> None:
    """Every reference leads into the page, and the policy allows this style sheet and this script alone."""
    for attribute in ("href", "src", "{http://www.w3.org/1999/xlink}href", "xlink:href"):
        assert all(re.match(r"#|data:,$", each.get(attribute)) for each in tree.iter() if each.get(attribute))
    assert not re.search(r"@import|url\((?!#w)|fetch\(|XMLHttpRequest|innerHTML|eval\(", page.read_text("utf-8"))
    (policy,) = tree.xpath("//meta[@http-equiv='Content-Security-Policy']/@content")
    rules = dict(rule.strip().split(" ", 1) for rule in policy.split(";"))
    assert rules["default-src"] == "'none'"
    assert rules["style-src"] == digest(tree.findtext(".//style"))
    assert rules["script-src"] == digest(tree.xpath("//script[@type='module']")[0].text)


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
    assert [link.text_content() for link in links] == [section.title for section in document.sections]
    for link, section in zip(links, document.sections, strict=True):
        (heading,) = tree.xpath(f"//*[@id='{link.get('href')[1:]}']")
        assert (heading.tag, heading.text_content()) == (f"h{section.level + 2}", section.title)
        assert len(link.xpath("ancestor::ul")) == section.level + 1


def test_captions_are_numbered_in_the_order_of_the_document(document: Document, tree: html.HtmlElement) -> None:
    for kind, blocks, path in (
        ("Figure", document.figures, "//figure/figcaption"),
        ("Sheet", document.sheets, "//table[contains(@class, 'sheet')]/caption"),
    ):
        found = [each.text_content() for each in tree.xpath(path)]
        assert found == [f"{kind} {n}. {block.caption}" for n, block in enumerate(blocks, start=1)]


def test_alternative_texts_are_the_captions(tree: html.HtmlElement) -> None:
    for drawing in tree.xpath("//figure//svg"):
        (caption,) = tree.xpath(f"//*[@id='{drawing.get('aria-labelledby')}']")
        assert drawing.get("role") == "img"
        assert caption.text_content().startswith("Figure ")


def test_heads_of_tables_have_a_scope(tree: html.HtmlElement) -> None:
    assert all(head.get("scope") in ("col", "row") for head in tree.iter("th"))
    assert tree.get("lang") == "en"


def test_words_of_the_page_stand_in_its_template_alone(tree: html.HtmlElement) -> None:
    """So that another language is another template."""
    assert {button.text_content() for button in tree.xpath("//template//button")} == {"Enlarge", "Turn in 3D"}
    assert not any(word in resource(name) for name in SCRIPTS for word in ("Enlarge", "Close", "Reset"))


def test_formulas_have_indices_and_powers(tree: html.HtmlElement) -> None:
    sheets = tree.xpath("//table[contains(@class, 'sheet')]")
    assert any(each.text_content() == "a,CAP" for each in sheets[0].iter("sub"))
    assert any(each.text_content() == "2" for each in sheets[0].iter("sup"))


def test_the_same_document_gives_the_same_bytes(results: Results, tmp_path: Path) -> None:
    whole = assessment(results)
    document = replace(whole, sections=(Section("s", 0, (spectrum_of(results),)),), data=())
    pages = []
    for name in ("one.html", "two.html"):
        pictures = {figure.name: picture(trace_figure(figure.draw())) for figure in document.figures}
        pages.append(write_html(document, tmp_path / name, pictures=pictures).read_bytes())
    assert pages[0] == pages[1]


def spectrum_of(results: Results) -> Figure:
    target = results.spectrum
    assert target is not None
    return Figure("spectrum", "The spectrum.", lambda: spectrum.draw(target, results.records))
