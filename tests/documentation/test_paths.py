"""Every file, module and page that the documents name is there."""

from __future__ import annotations

import pkgutil
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support.places import MANUAL, ROOT, defines, place_of, text_of

PAGES = sorted([ROOT / "README.md", ROOT / "CONTRIBUTING.md", *MANUAL])
NAMES = [str(page.relative_to(ROOT)) for page in PAGES]
ROOMS = ("assess/", "spectra/", "records/", "reports/", "tests/", "tools/", "docs/", ".ci/")
PATH = re.compile(r"`([\w.-]+(?:/[\w.-]+)*/?)`")
LINK = re.compile(r"\]\(([^)#\s]*)(#[^)\s]+)?\)")
MODULE = re.compile(r"`((?:assess|spectra|records|reports)(?:\.\w+)+)(?:\([^`]*\))?`")
DEVELOPERS = ("CONTRIBUTING.md", "docs/architecture.md", "docs/robustness.md")


def links_of(page: Path) -> Iterator[tuple[Path, str]]:
    """Targets of a page's links within the repository, with the heading they point to."""
    for target, heading in LINK.findall(page.read_text(encoding="utf-8")):
        if not target.startswith(("http:", "https:")):
            yield (page.parent / target if target else page), heading


@pytest.mark.parametrize("page", PAGES, ids=NAMES)
def test_every_path_exists(page):
    named = [path for path in PATH.findall(page.read_text(encoding="utf-8")) if path.startswith(ROOMS)]
    gone = [path for path in named if not place_of(path).exists()]
    assert not gone, f"{page.name} names what is not there any more: {', '.join(gone)}"


@pytest.mark.parametrize("page", PAGES, ids=NAMES)
def test_every_link_leads_somewhere(page):
    for target, heading in links_of(page):
        assert target.exists(), target
        headings = re.findall(r"^#+ (.+)$", target.read_text(encoding="utf-8"), re.MULTILINE) if heading else []
        anchors = {"#" + re.sub(r"[^\w\- ]", "", each.lower()).replace(" ", "-") for each in headings}
        assert not heading or heading in anchors, (target, heading)


@pytest.mark.parametrize("name", DEVELOPERS)
def test_every_module_exists(name):
    for dotted in MODULE.findall(text_of(name)):
        pkgutil.resolve_name(dotted)  # a module, or something in one


@pytest.mark.parametrize("name", ["CONTRIBUTING.md", "docs/architecture.md"])
def test_every_name_is_in_the_source(name):
    """Functions, classes and registries by their own names, as `make_record` or `FORMATS`."""
    source = "\n".join(path.read_text(encoding="utf-8") for room in ROOMS[:6] for path in place_of(room).rglob("*.py"))
    named = re.findall(r"`(_?[A-Za-z]+(?:_\w+)+|[A-Z]{3,}|[A-Z][a-z]+(?:[A-Z][a-z]+)*)(?:\(.*?)?`", text_of(name))
    known = set(re.findall(r"\w+", source))
    assert [each for each in dict.fromkeys(named) if each not in known and each not in ("BASE", "Makefile")] == []


def test_every_function_is_in_the_file_named_beside_it():
    """As "`assess/codes/verdict.py`: `decide`" and "`decide` (`assess/codes/verdict.py`)"."""
    text = text_of("docs/architecture.md")
    pairs = [*re.findall(r"`([\w/]+\.py)`: `(\w+)`", text)]
    pairs += [(path, name) for name, path in re.findall(r"`(\w+)`[ ,(\n]+`([\w/]+\.py)`", text)]
    assert len(pairs) > 20
    assert [(path, name) for path, name in pairs if not defines(path, name)] == []


def test_every_page_of_docs_is_reached_from_its_index():
    reached, ahead = set(), [ROOT / "docs" / "index.md"]
    while ahead:
        page = ahead.pop().resolve()
        if page.suffix == ".md" and page not in reached:
            reached.add(page)
            ahead += [target for target, _ in links_of(page)]
    included = {ROOT / "docs" / "changes.md", ROOT / "docs" / "contributing.md"}  # reached as pages of the root
    assert set(MANUAL) - included <= reached


def test_every_picture_is_shown_somewhere():
    shown = {target.resolve() for page in PAGES for target, _ in links_of(page)}
    assert set((ROOT / "docs" / "images").glob("*.svg")) <= shown
