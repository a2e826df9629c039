"""What the report says in words, against results changed by hand."""

from __future__ import annotations

from dataclasses import replace

from assess.codes.check import GROUND_AT_HEIGHT
from assess.results import Results
from reports import sentences, tables


def test_limits_name_what_is_judged_at_height_by_the_motion_of_the_ground(results: Results) -> None:
    assert not any(GROUND_AT_HEIGHT in said for said in sentences.limits(results))
    first, *others = results.mechanisms
    checks = (replace(first.checks[0], caveat=f"x; {GROUND_AT_HEIGHT}"), *first.checks[1:])
    raised = replace(results, mechanisms=(replace(first, checks=checks), *others))
    (said,) = (said for said in sentences.limits(raised) if GROUND_AT_HEIGHT in said)
    assert said.startswith(f"{first.checks[0].procedure}, for {tables.name_of(first)}: ")
