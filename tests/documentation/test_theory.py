"""Every function that the pages on theory name is in the file that they name."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.support.places import ROOT, defines

NAMED = re.compile(r"`([\w/]+\.py): (\w+)`")
PAGES = sorted((ROOT / "docs" / "theory").glob("*.md"))


@pytest.mark.parametrize("page", PAGES, ids=[page.stem for page in PAGES])
def test_every_function_named_exists(page: Path) -> None:
    named = NAMED.findall(page.read_text(encoding="utf-8"))
    assert named or page.stem == "index"
    assert [(file, name) for file, name in named if not defines(file, name)] == []
