"""Faults planted by hand turn solved cases red; `make faults` does so for more modules, with every case."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from assess.mechanisms import chain, restitution
from assess.verification.case_files import read_cases
from assess.verification.verify import run_case
from spectra import asce7
from tests.support.places import place_of
from tools.faults import FAULTS

CASES = {each.key: each for each in read_cases()}


@pytest.fixture
def wrong_restitution(monkeypatch):
    right = restitution.housner
    monkeypatch.setattr(restitution, "housner", lambda block: 0.5 * (1.0 + right(block)))


@pytest.fixture
def wrong_tie(monkeypatch):
    right = chain.generalised_moment
    monkeypatch.setattr(chain, "generalised_moment", lambda load, moved: -right(load, moved))


@pytest.fixture
def wrong_spectrum(monkeypatch):
    right = asce7.site_coefficient
    monkeypatch.setattr(asce7, "site_coefficient", lambda mapped, **given: np.round(right(mapped, **given), 0))


@pytest.mark.parametrize(
    ("key", "fault"),
    [
        ("mehrotra_2019/table_8_2", "wrong_restitution"),
        ("own_arithmetic/tie", "wrong_tie"),
        ("asce7/usgs_site_coefficients", "wrong_spectrum"),
    ],
)
def test_planted_fault_turns_a_case_red(key, fault, request):
    assert run_case(CASES[key]).outcome == "pass"
    request.getfixturevalue(fault)
    assert run_case(CASES[key]).outcome == "fail"


def test_value_that_moves_beyond_its_tolerance_fails():
    file = CASES["own_arithmetic/tie"]
    (quantity,) = file.case.quantities
    moved = replace(quantity, values={**quantity.values, "free": 0.1 * (1.0 + 2e-6)})
    result = run_case(replace(file, case=replace(file.case, quantities=(moved,))))
    assert [each.outcome for each in result.values] == ["pass", "fail"]


def test_case_that_cannot_be_run_fails_and_says_why():
    file = CASES["housner_1963/free_rocking"]
    result = run_case(replace(file, case=replace(file.case, given={})))
    assert result.outcome == "fail"
    assert "KeyError" in result.fault


@pytest.mark.parametrize("fault", FAULTS, ids=lambda each: each.name)
def test_fault_of_the_study_stands_in_the_source_once(fault):
    assert place_of(fault.module).read_text(encoding="utf-8").count(fault.right) == 1
