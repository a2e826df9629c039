"""The import names are generic: what is imported must be ours, whatever else is installed."""

from __future__ import annotations

import importlib
from pathlib import Path

import pytest

import assess

PACKAGES = ("assess", "records", "reports", "spectra")
ROOT = Path(assess.__file__).resolve().parents[1]


@pytest.mark.parametrize("name", PACKAGES)
def test_imported_package_is_ours(name):
    assert Path(importlib.import_module(name).__file__).resolve().parent == ROOT / name
    assert Path(__file__).resolve().parents[3] == ROOT


def test_command_is_the_distributions_own():
    from importlib.metadata import distribution

    (entry,) = distribution("rocking-assess").entry_points.select(group="console_scripts")
    assert (entry.name, entry.load().__module__) == ("assess", "assess.cli")


def test_top_level_holds_what_the_design_lists():
    listed = {
        "pyproject.toml", "README.md", "CHANGELOG.md", "CONTRIBUTING.md", "CITATION.cff", "LICENSE", "Makefile",
        "requirements.lock", "requirements-cad.lock", "requirements-docs.lock",
        ".ci", ".gitignore", ".pre-commit-config.yaml",
        "assess", "docs", "records", "reports", "spectra", "tests",
    }  # fmt: skip
    made = {".git", ".venv", "build", "dist"}
    found = {path.name for path in ROOT.iterdir() if not path.name.endswith("cache") and path.name != ".hypothesis"}
    assert found - made == listed
