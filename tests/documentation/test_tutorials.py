"""Every command and every piece of Python in the tutorials, and in the worked additions, prints what the page says."""

from __future__ import annotations

import re
import tomllib
from html import unescape
from itertools import chain
from pathlib import Path
from unittest.mock import patch

import pytest

from assess.codes.procedures import PROCEDURES
from assess.examples import source
from docs.tutorial.follow import Output, follow
from records.formats import FORMATS

FOLDER = Path(__file__).resolve().parents[2] / "docs" / "tutorial"


def test_from_an_ifc_model_to_a_report(tmp_path: Path) -> None:
    pytest.importorskip("ifcopenshell", reason="the extra 'ifc' is not installed")
    for output in follow(FOLDER / "from_ifc.md", tmp_path):
        assert output.agrees, f"{output.given}\n{output.printed}"
    made = tomllib.loads((tmp_path / "house" / "tied.toml").read_text(encoding="utf-8"))
    assert made == tomllib.loads((source("house") / "project.toml").read_text(encoding="utf-8"))


def test_in_the_browser(tmp_path: Path) -> None:
    """Each line that the page of the manual quotes below a heading is on the page in the browser after that step."""
    pytest.importorskip("ifcopenshell", reason="the extra 'ifc' is not installed")
    pytest.importorskip("viser", reason="the extra 'serve' is not installed")
    from docs.tutorial.in_the_browser import SIGNED, SITE, TIED, WHOLE, follow_house, follow_spire

    manual = (FOLDER / "in_the_browser.md").read_text(encoding="utf-8")
    typed = (SITE, TIED, *WHOLE, *SIGNED.values())
    assert all(given in manual for given in typed)
    assert f" {sum(map(len, typed))} characters" in manual
    sections = dict(re.findall(r"^## (.+)\n((?:(?!## ).*\n)*)", manual, flags=re.MULTILINE))
    for heading, page in chain(follow_house(tmp_path / "house"), follow_spire(tmp_path / "spire")):
        parts = (page.status, page.building, page.facts, page.links)
        shown = "\n".join([*page.mechanisms.options, *(re.sub(r"<[^>]+>", " ", each.content) for each in parts)])
        words = " ".join(unescape(shown).split())
        quoted = "".join(re.findall(r"^```text\n(.*?)^```", sections[heading], flags=re.DOTALL | re.MULTILINE))
        assert quoted
        for line in quoted.splitlines():
            assert line in words.replace("FAIL ,", "FAIL,"), f"{heading}: {line}\n{words}"
        assert not page.fault.content
    report = (tmp_path / "house/house-project/project-results/report.html").read_text(encoding="utf-8")
    assert all(text in report for text in SIGNED.values())


@pytest.mark.parametrize(
    ("expected", "printed", "agrees"),
    [
        ("a\n…\nd\n", "a\nb\nc\nd\n", True),
        ("a\n…\nd\n", "a\nb\nc\n", False),
        ("in … s\n", "in 3.1 s\n", True),
        ("a\n", "a\nb\n", False),
        ("", "", True),
        ("", "b\n", False),
    ],
)
def test_an_ellipsis_is_any_lines_or_any_words(expected: str, printed: str, agrees: bool) -> None:
    assert Output("", expected, printed).agrees is agrees


def test_from_python(tmp_path: Path) -> None:
    pytest.importorskip("ifcopenshell", reason="the extra 'ifc' is not installed")
    for output in follow(FOLDER / "from_python.md", tmp_path):
        assert output.agrees, f"{output.given}\n{output.printed}"


def test_three_additions_work_as_their_page_says(tmp_path: Path) -> None:
    """What the page registers is taken away again."""
    with patch.dict(FORMATS), patch.dict(PROCEDURES):
        outputs = list(follow(FOLDER.parent / "developers" / "additions.md", tmp_path))
        assert "toy-start" in PROCEDURES
    assert "toy-start" not in PROCEDURES
    assert sum(bool(output.expected) for output in outputs) == 3
    for output in outputs:
        assert output.agrees, f"{output.given}\n{output.printed}"
