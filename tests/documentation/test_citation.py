"""What stands in two files agrees: version and licence, the version of ruff."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

from tests.support.places import text_of

ROOT = Path(__file__).resolve().parents[2]


def value(pattern: str, name: str) -> str:
    """What a line of a file gives after its key."""
    found = re.search(pattern, text_of(name), re.MULTILINE)
    assert found, (pattern, name)
    return found[1]


def test_citation_has_the_version_and_licence_of_the_distribution():
    project = tomllib.loads(text_of("pyproject.toml"))["project"]
    assert value(r"^version: (\S+)$", "CITATION.cff") == project["version"]
    assert value(r"^license: (\S+)$", "CITATION.cff") == project["license"]
    assert value(r"^  - name: (.+)$", "CITATION.cff") in text_of("LICENSE")


def test_changelog_has_the_version_of_the_distribution():
    version = tomllib.loads(text_of("pyproject.toml"))["project"]["version"]
    assert f"\n## {version}\n" in text_of("CHANGELOG.md")


def test_ruff_of_the_hooks_is_that_of_the_lock():
    assert value(r"^    rev: v(\S+)$", ".pre-commit-config.yaml") == value(r"^ruff==(\S+)", "requirements.lock")
