"""Mutants kept as text are found again where their lines stand now, under the names of today."""

from __future__ import annotations

from pathlib import Path

import pytest

from tools.mutate import kept
from tools.mutate.kept import find_again, keep
from tools.mutate.mutant import Mutant
from tools.mutate.site import Site

DRAWN_IN = """
def half(width, height):
    area = width * height
    return area / 2.0
"""
MUTATED = DRAWN_IN.replace("width * height", "width + height")


@pytest.fixture
def sources(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder that stands for the checkout, with the file that a mutant is drawn in."""
    (tmp_path / "old.py").write_text(DRAWN_IN)
    monkeypatch.setattr("tools.mutate.kept.ROOT", tmp_path)
    monkeypatch.setattr("tools.mutate.mutant.ROOT", tmp_path)
    monkeypatch.setattr(kept, "files", lambda: sorted(path.name for path in tmp_path.glob("*.py")))
    for each in (kept._text, kept._tokens_of, kept._functions):
        each.cache_clear()
    return tmp_path


@pytest.fixture
def file(sources: Path) -> Path:
    site = Site("old.py", ((3, 11), (3, 25)), (3, 3), "half", (("ReplaceBinaryOperator_Mul_Add", 0),))
    keep([Mutant(site, "ReplaceBinaryOperator_Mul_Add", 0, MUTATED)], sources / "kept.json")
    return sources / "kept.json"


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("old.py", DRAWN_IN),
        ("new.py", "import math\n\n\ndef first():\n    return 1.0\n" + DRAWN_IN),
        ("new.py", DRAWN_IN.replace("width", "thickness").replace("area", "section")),
        ("new.py", DRAWN_IN.replace("half", "half_area")),
    ],
)
def test_it_is_found_wherever_its_lines_stand(name: str, text: str, file: Path, sources: Path) -> None:
    (sources / "old.py").unlink()
    (sources / name).write_text(text)
    (found,), lost = find_again(file)
    assert lost == []
    assert found.site.path == name
    names = ("thickness", "height") if "thickness" in text else ("width", "height")
    assert found.source == text.replace(" * ".join(names), " + ".join(names))


def test_lines_that_are_gone_or_stand_twice_are_lost(file: Path, sources: Path) -> None:
    (sources / "old.py").write_text(DRAWN_IN.replace("*", "-"))
    assert [each.function for each in find_again(file)[1]] == ["half"]
    kept._text.cache_clear()
    kept._tokens_of.cache_clear()
    (sources / "old.py").write_text(DRAWN_IN + DRAWN_IN)
    assert [each.function for each in find_again(file)[1]] == ["half"]
