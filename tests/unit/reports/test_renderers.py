"""Renderers draw a document; they know nothing of the physics behind it."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import reports

ROOT = Path(reports.__file__).parent
RENDERERS = sorted(
    str(path.relative_to(ROOT))
    for path in (ROOT / "document.py", *(ROOT / "render").glob("*.py"), *(ROOT / "language").glob("*.py"))
)
LETTERS = {
    "spectra.arrays",  # what counts as a number
    "spectra.formulas",  # which text a spreadsheet would run
    "spectra.gravity",  # a constant
    "assess.codes.calculation_sheet",  # the lines of a calculation sheet
    "assess.codes.procedures",  # the titles of methods, in messages that name them
    "assess.messages.message",
    "assess.messages.texts",
}
FIGURES_AS_FILES = {"assess.outputs.writing", "assess.workers"}
"""Figures are drawn in processes of their own, and written whole or not at all."""
DATA = {
    *LETTERS,
    "assess.geometry.surface",  # fewer faces for a drawing
    "assess.outputs.signals",  # interruptions end the process that writes
    "assess.outputs.writing",  # files whole or not at all
    "assess.workers",  # processes that end with their parent
    "assess.errors",
    "assess.results",
    "assess.results.before",  # both states are read from results in one way
    "assess.results.mechanism",
    "assess.portfolio.tasks",
    "assess.results.provenance",
    "assess.results.fragility",
    "assess.results.run",
    "assess.results.retrofit",
    "assess.results.verification",
    "assess.codes.bases",
    "assess.codes.check",
    "assess.codes.checklists",
    "assess.codes.procedures",
    "assess.codes.sliding",  # the name of its procedure
    "assess.codes.histories",
    "assess.codes.question",
    "assess.codes.verdict",
    "assess.codes.works",  # by how much an index may be less and count as the same
    "assess.messages.message",
}

SESSION = ROOT / "figures/session.py"  # draws what a Python session holds, which no file of results has


def imports(path: Path) -> set[str]:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    found = {node.module or "" for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    return found | {name.name for node in ast.walk(tree) if isinstance(node, ast.Import) for name in node.names}


@pytest.mark.parametrize("name", RENDERERS)
def test_renderers_import_nothing_of_assess_but_its_words(name: str) -> None:
    others = imports(ROOT / name) - LETTERS - (FIGURES_AS_FILES if name == "render/vector.py" else set())
    assert not any(module.split(".")[0] in {"assess", "records", "spectra"} for module in others)


def test_the_rest_imports_only_results() -> None:
    for path in (each for each in ROOT.rglob("*.py") if each != SESSION):
        ours = {module for module in imports(path) if module.split(".")[0] in {"assess", "records", "spectra"}}
        assert ours <= DATA, path


def test_nothing_uses_the_global_state_of_pyplot() -> None:
    assert not any("pyplot" in module for path in ROOT.rglob("*.py") for module in imports(path))
