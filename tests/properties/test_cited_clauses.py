"""Every line of every calculation sheet cites the clause and has the unit of tests/support/cited_clauses.toml."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from assess.codes.procedures import PROCEDURES
from tests.support.subjects import subjects

CITED = tomllib.loads((Path(__file__).parents[1] / "support/cited_clauses.toml").read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", PROCEDURES)
def test_lines_cite_their_clauses_and_no_others(name: str) -> None:
    steps = [step for subject in subjects(name) for step in subject.check.steps]
    found = {(step.clause, f"{step.symbol} [{step.unit}]") for step in steps}
    assert found == {(clause, line) for clause, lines in CITED[name].items() for line in lines}


def test_every_procedure_is_listed() -> None:
    assert set(CITED) == set(PROCEDURES)
