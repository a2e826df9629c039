"""What ASSESS_REQUIRE names makes a skipped test fail; nothing else does."""

from __future__ import annotations

import pytest

from tests.support.places import NO_RECORDS
from tests.support.required import fail_if_required, names_required

SKIPPED = {
    "browser": "Skipped: needs chromium and chromedriver: .venv/browser of the Makefile",
    "cad": "Skipped: the extra 'ifc' is not installed",
    "records": f"Skipped: {NO_RECORDS}",
}


@pytest.mark.parametrize("name", SKIPPED)
def test_what_is_required_may_not_be_skipped(name: str) -> None:
    for each, reason in SKIPPED.items():
        found = pytest.TestReport("test", ("test.py", 1, "test"), {}, "skipped", ("test.py", 1, reason), "setup")
        fail_if_required(found, (name,))
        assert found.outcome == ("failed" if each == name else "skipped")


def test_every_reason_is_the_one_that_pytest_gives() -> None:
    with pytest.raises(pytest.skip.Exception, match="could not import 'no_such_package'"):
        pytest.importorskip("no_such_package")


def test_an_unknown_name_is_refused() -> None:
    assert names_required("") == ()
    assert names_required("browser, cad") == ("browser", "cad")
    with pytest.raises(pytest.UsageError, match="brwser is not known; choose among browser, cad"):
        names_required("brwser,cad")
