"""Every clause function is evaluated by a parametrised test of its own edition, `<edition>/test_clauses.py`."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest

import assess.codes

CODES, TESTS = Path(assess.codes.__file__).parent, Path(__file__).parent
FILES = {  # of formulas, by edition
    "asce41_13": ("asce41_13",),
    "asce43_05": ("asce43_05", "sliding"),
    "dmi2008": ("dmi2008",),
    "en1998_1": ("en1998_1",),
    "italian": ("italian_kinematic", "italian_limit_states"),
    "ntc2018": ("ntc2018_clauses",),
    "nzsee2017": ("nzsee2017",),
}
NO_FORMULA = {  # of one mechanism as a whole, tested through its procedure
    "asce41_13": {"s_x1_over_pga"},
    "asce43_05": {
        *("clause_reading", "thesis_reading", "friction_utilisation", "sliding_pga"),
        *("with_floor_ratio", "lacks_vertical_floor", "falls_short"),
    },
    "dmi2008": {"acceleration_demands", "displacement_demands"},
    "en1998_1": {"element_demand"},
    "italian": {"case_of", "own_spectrum", "rows_around", "curves_of", "curves_of_all_actions", "branch_curves"},
    "nzsee2017": {"wall_response", "is_overloaded", "gravity_of"},
}
WRITTEN = ("Check", "Step", "Message")
"""What procedures and calculation sheets return, and formulas do not."""


def called_in_tables(file: Path) -> Iterator[str]:
    """Names of the functions that the parametrised tests of a file call."""
    for test in ast.parse(file.read_text()).body:
        if isinstance(test, ast.FunctionDef) and any(
            "parametrize" in ast.unparse(each) for each in test.decorator_list
        ):
            for node in ast.walk(test):
                if isinstance(node, ast.Call):
                    yield ast.unparse(node.func).rpartition(".")[2]


@pytest.mark.parametrize("edition", FILES)
def test_every_clause_function_has_a_table_test(edition: str) -> None:
    # Public functions of the files of formulas of an edition, but for what makes checks and lines of sheets
    files = [CODES / f"{name}.py" for name in FILES[edition]]
    found = [node for file in files for node in ast.parse(file.read_text()).body if isinstance(node, ast.FunctionDef)]
    formulas = {each.name for each in found if not any(word in ast.unparse(each.returns) for word in WRITTEN)}
    public = {name for name in formulas - NO_FORMULA.get(edition, set()) if not name.startswith("_")}
    missing = public - set(called_in_tables(TESTS / edition / "test_clauses.py"))
    assert not missing, f"add a table test of {', '.join(sorted(missing))} to {edition}/test_clauses.py"
