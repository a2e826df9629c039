"""What stays literal beside the registry of procedures (for mypy, catalogue and figures) names the same ones."""

from __future__ import annotations

from dataclasses import fields
from inspect import signature
from typing import get_type_hints

import pytest

from assess.codes import bases, procedures
from assess.codes.procedures import PROCEDURES, CodeOptions
from assess.project.sections.procedures import PROCEDURES as IN_THE_FILE
from assess.project.sections.procedures import READINGS
from assess.results.verification import USES
from reports.chapters.scope import PROCEDURE_WORKS
from reports.figures.style import PROCEDURES as PENS


def test_literals_name_the_procedures_of_the_registry() -> None:
    assert tuple(PROCEDURES) == IN_THE_FILE
    assert set(READINGS) == set(procedures.THESIS_READINGS)
    assert set(PENS) == set(PROCEDURES)
    assert set(PROCEDURES) <= set(USES)
    assert {each.work for each in PROCEDURES.values()} - {""} == set(PROCEDURE_WORKS)
    assert {method for basis in bases.BASES.values() for method in basis.methods} <= set(PROCEDURES)


@pytest.mark.parametrize("name", PROCEDURES)
def test_a_procedure_takes_the_options_of_its_code(name: str) -> None:
    each = PROCEDURES[name]
    hints = get_type_hints(CodeOptions)
    assert each.options in ("", *(field.name for field in fields(CodeOptions)))
    assert ("options" in signature(each.assess).parameters) == bool(each.options)
    if each.options:
        assert get_type_hints(each.assess)["options"] is hints[each.options]


def test_titles_are_unique() -> None:
    for titles in ([each.title for each in PROCEDURES.values()], [each.short_title for each in PROCEDURES.values()]):
        assert len({title.english for title in titles}) == len(PROCEDURES)
