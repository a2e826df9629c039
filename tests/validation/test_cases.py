"""The solved cases of `assess verify`: each agrees with its source."""

from __future__ import annotations

import pytest

from assess.verification.case_files import read_cases
from assess.verification.verify import run_case

pytestmark = pytest.mark.usefixtures("all_twins")


@pytest.mark.parametrize("file", read_cases(), ids=lambda each: each.key)
def test_case_agrees_with_its_source(file):
    result = run_case(file)
    assert result.fault == ""
    wrong = [(each.name, value) for each in result.quantities for value in each.values if value.outcome == "fail"]
    assert wrong == []
    assert result.outcome == "pass"
