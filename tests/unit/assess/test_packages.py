"""The import names are generic: what is imported must be ours, whatever else is installed."""

from __future__ import annotations

import ast
import importlib
import re
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support.places import PACKAGES, ROOT, SOURCES

IMPORTED_AS = {"pillow": "PIL"}


@pytest.mark.parametrize("name", PACKAGES)
def test_imported_package_is_ours(name):
    """Those beside the tests; or, where the tests are alone, those that an installer put into site-packages."""
    folder = Path(importlib.import_module(name).__file__).resolve().parent
    assert folder == SOURCES / name
    assert SOURCES == ROOT if (ROOT / name).is_dir() else SOURCES.name == "site-packages"


@pytest.mark.parametrize("name", PACKAGES)
def test_packages_say_that_they_are_typed(name):
    assert (SOURCES / name / "py.typed").is_file()


def test_every_package_that_is_imported_is_declared_and_no_other():
    """Each dependency of a plain installation is imported somewhere; what only an extra brings is declared by one."""
    declared = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    plain = {re.match(r"[\w-]+", line)[0] for line in declared["dependencies"]}
    extra = {re.match(r"[\w-]+", line)[0] for lines in declared["optional-dependencies"].values() for line in lines}
    found = {name for package in PACKAGES for path in (SOURCES / package).rglob("*.py") for name in imports_of(path)}
    third = found - set(sys.stdlib_module_names) - set(PACKAGES) - {"pydantic_core", "llvmlite"}  # of pydantic, numba
    assert third == {IMPORTED_AS.get(name, name) for name in plain | extra - {"rocking-assess"}}


def test_what_builds_the_program_is_pinned():
    """A build without a network finds what `[build-system]` asks for: the lock is made of the group."""
    found = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    assert found["dependency-groups"]["build"] == found["build-system"]["requires"]


def imports_of(path: Path) -> Iterator[str]:
    """Yield the top-level packages that a file imports, by their names."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (each.name.partition(".")[0] for each in node.names)
        elif isinstance(node, ast.ImportFrom) and not node.level:
            yield str(node.module).partition(".")[0]


def test_command_is_the_distributions_own():
    from importlib.metadata import distribution

    (entry,) = distribution("rocking-assess").entry_points.select(group="console_scripts")
    assert (entry.name, entry.load().__module__) == ("assess", "assess.cli")


@pytest.mark.skipif(SOURCES != ROOT, reason="the tests are not in a checkout")
def test_top_level_holds_what_the_design_lists():
    listed = {
        "pyproject.toml", "README.md", "CHANGELOG.md", "CONTRIBUTING.md", "CITATION.cff", "LICENSE", "Makefile",
        "requirements.lock", "requirements-run.lock", "requirements-build.lock", "requirements-cad.lock",
        "requirements-docs.lock", "requirements-serve.lock",
        ".ci", ".github", ".gitignore", ".pre-commit-config.yaml",
        "assess", "docs", "records", "reports", "spectra", "tests", "tools",
    }  # fmt: skip
    made = {".git", ".venv", "build", "dist"}
    found = {path.name for path in ROOT.iterdir() if not path.name.endswith("cache") and path.name != ".hypothesis"}
    assert found - made == listed
