"""Every clause function is evaluated by a parametrised test of its own edition, `<edition>/test_clauses.py`."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import assess.codes

CODES, TESTS = Path(assess.codes.__file__).parent, Path(__file__).parent
CLAUSE_FILES = ("clauses.py", "sliding_clauses.py", "building.py", "toothing.py", "kinematic.py", "floor.py")
BESIDE = {  # clause functions in files that also write calculation sheets
    "italian": {"threshold_of", "confidence_factors", "pga_ratio", "return_period"},
    "dmi2008": {"thesis_pga_rotation"},
}
EDITIONS = sorted(folder.name for folder in CODES.iterdir() if any((folder / name).exists() for name in CLAUSE_FILES))


def clause_functions(edition: str) -> set[str]:
    """Public functions of the files of formulas of an edition."""
    files = [CODES / edition / name for name in CLAUSE_FILES if (CODES / edition / name).exists()]
    found = [node for file in files for node in ast.parse(file.read_text()).body if isinstance(node, ast.FunctionDef)]
    return {each.name for each in found if not each.name.startswith("_")} | BESIDE.get(edition, set())


def is_table(test: ast.FunctionDef) -> bool:
    """Whether a test runs over a table of cases."""
    return any("parametrize" in ast.unparse(each) for each in test.decorator_list)


def called_in_tables(file: Path) -> Iterator[str]:
    """Names of the functions that the parametrised tests of a file call."""
    for test in ast.parse(file.read_text()).body:
        if isinstance(test, ast.FunctionDef) and is_table(test):
            for node in ast.walk(test):
                if isinstance(node, ast.Call):
                    yield ast.unparse(node.func).rpartition(".")[2]


def test_all_editions_are_looked_at() -> None:
    assert {"asce43_05", "asce41_13", "dmi2008", "en1998_1", "italian", "ntc2018", "nzsee2017"} <= set(EDITIONS)


@pytest.mark.parametrize("edition", EDITIONS)
def test_every_clause_function_has_a_table_test(edition: str) -> None:
    missing = clause_functions(edition) - set(called_in_tables(TESTS / edition / "test_clauses.py"))
    assert not missing, f"add a table test of {', '.join(sorted(missing))} to {edition}/test_clauses.py"
