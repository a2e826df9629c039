"""What stays literal beside the registry of procedures (for mypy, catalogue and figures) names the same ones."""

from __future__ import annotations

from dataclasses import fields
from inspect import signature
from typing import get_type_hints

import pytest

from assess.codes import bases
from assess.codes.procedures import PROCEDURES, THESIS_READINGS, CodeOptions, default_procedures, procedures_of_site
from assess.project.sections.procedures import PROCEDURES as IN_THE_FILE
from assess.results.verification import USES
from assess.study.suites import RULES
from records.compliance import REQUIREMENTS
from reports.chapters.scope import PROCEDURE_WORKS
from reports.figures.style import PROCEDURES as PENS
from spectra.design_spectra import SPECTRA

ASCE43 = ("asce43-05-spectrum", "asce43-05-spectrum-thesis", "asce43-05-history")
DMI2008 = ("dmi2008-linear", "dmi2008-nonlinear", "dmi2008-nonlinear-thesis")
NTC2018 = ("ntc2018-linear", "ntc2018-nonlinear", "ntc2018-history")
RUN_AT: dict[str, tuple[str, ...]] = {
    "": (*ASCE43, *DMI2008),
    "table": (*ASCE43, *DMI2008),
    "asce7-05": (*ASCE43, *DMI2008, "asce41-13-ht"),
    "ibc2009": (*ASCE43, *DMI2008, "asce41-13-ht"),
    "asce7-10": (*ASCE43, *DMI2008, "asce41-13-ht"),
    "asce7-16": (*ASCE43, *DMI2008, "asce41-13-ht"),
    "asce7-22": (*ASCE43, *DMI2008, "asce41-13-ht"),
    "ec8": (*ASCE43, *DMI2008),
    "nzs1170.5": (*ASCE43, *DMI2008, "nzsee2017-face-loaded"),
    "ts1170.5": (*ASCE43, *DMI2008),
    "ntc2008": (*ASCE43, *DMI2008, "dmi2008-history"),
    "ntc2018": (*ASCE43, *NTC2018),
}
"""By the code of the site's spectrum, "" without a site: what runs, in this order, where the project names nothing."""


def test_literals_name_the_procedures_of_the_registry() -> None:
    assert tuple(PROCEDURES) == IN_THE_FILE
    assert THESIS_READINGS == ("asce43-05-spectrum-thesis", "dmi2008-nonlinear-thesis")
    assert set(PENS) == set(PROCEDURES)
    assert set(PROCEDURES) <= set(USES)
    assert {each.work for each in PROCEDURES.values()} - {""} == set(PROCEDURE_WORKS)
    assert {method for basis in bases.BASES.values() for method in basis.methods} <= set(PROCEDURES)


def test_every_spectrum_has_its_default_procedures() -> None:
    assert set(RUN_AT) == {"", *SPECTRA}


@pytest.mark.parametrize(("code", "names"), RUN_AT.items())
def test_procedures_run_by_default_at_the_spectra_of_their_code(code: str, names: tuple[str, ...]) -> None:
    assert default_procedures(code, has_friction=False) == names
    assert default_procedures(code, has_friction=True) == (*names, "asce43-05-sliding", "sliding")
    assert procedures_of_site(code) == tuple(
        name for name in names if name in ("asce41-13-ht", "nzsee2017-face-loaded")
    )


def test_rules_for_suites_are_those_of_a_code_that_has_them() -> None:
    for each in PROCEDURES.values():
        assert {each.suite_rules, each.floor_suite_rules} <= {"", *RULES}
    assert {name: basis.suite_code for name, basis in bases.BASES.items()} == {
        "ntc2018": "NTC 2018",
        "dmi2008": "NTC 2018",
        "nzsee2017": "NZS 1170.5:2004",
        "asce41-13": "ASCE 7-16",
        "asce43-05": "ASCE 43-05",
        "ec8": "EN 1998-1:2004",
    }
    assert {basis.suite_code for basis in bases.BASES.values()} <= set(REQUIREMENTS)


@pytest.mark.parametrize("name", PROCEDURES)
def test_a_procedure_takes_the_options_of_its_code(name: str) -> None:
    each = PROCEDURES[name]
    hints = get_type_hints(CodeOptions)
    assert each.options in ("", *(field.name for field in fields(CodeOptions)))
    assert ("options" in signature(each.assess).parameters) == bool(each.options)
    if each.options:
        assert issubclass(hints[each.options], get_type_hints(each.assess)["options"])


def test_titles_are_unique() -> None:
    for titles in ([each.title for each in PROCEDURES.values()], [each.short_title for each in PROCEDURES.values()]):
        assert len({title.english for title in titles}) == len(PROCEDURES)
