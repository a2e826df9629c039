"""What a check says of itself is what its numbers say: reason, verdict and ratio agree, for every procedure."""

from __future__ import annotations

import pytest

from assess.codes.check import Outcome, Reason
from assess.codes.procedures import PROCEDURES
from tests.support.subjects import subjects

PASSES, FAILS = {Reason.WITHIN, Reason.NO_SLIDING, Reason.NO_ROCKING, Reason.SLIDES_LATER, Reason.ROCKS_FIRST}, {
    Reason.BEYOND, Reason.OVERTURNS, Reason.SLIDES_FIRST, Reason.RECORDS_OVERTURN,
    Reason.RECORDS_OVERTURN_FACTORED, Reason.SLIDING_BEYOND_BEFORE,
}  # fmt: skip


@pytest.mark.parametrize("name", PROCEDURES)
def test_reason_verdict_and_ratio_agree(name: str) -> None:
    for subject in subjects(name):
        check, reason = subject.check, Reason(subject.check.reason.key)
        assert reason not in PASSES or check.verdict == Outcome.PASS, (reason, check.verdict)
        assert reason not in FAILS or check.verdict == Outcome.FAIL, (reason, check.verdict)
        if check.ratio is not None and reason in (Reason.WITHIN, Reason.BEYOND):
            assert (check.ratio <= 1.0) == (reason == Reason.WITHIN), (reason, check.ratio)


def test_the_pga_at_which_it_slides_is_that_of_the_sheet_to_three_figures() -> None:
    later = [subject.check for subject in subjects("sliding") if subject.check.reason.key == Reason.SLIDES_LATER]
    assert later
    for check in later:
        (stated,) = (step.value for step in check.steps if step.symbol == "PGA_s")
        assert f"PGA {stated:.3g} g upwards" in str(check.reason)
