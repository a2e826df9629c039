"""Which branch is told where a mechanism answers on both."""

from __future__ import annotations

import pytest

from assess.codes.check import Check, worst_branch_check, worst_check
from tests.support.answered import rotation_check


def check(branch: str, ratio: float | None, verdict: str = "fail", *, at: float | None = 0.2) -> Check:
    """One answer; ratio None: it overturns."""
    return rotation_check(verdict, ratio, branch=branch, capacity_pga_g=at, uplift_pga_g=at and at / 2)


@pytest.mark.parametrize(
    ("first", "second", "told"),
    [
        (check("positive", 1.2), check("negative", 1.5), "negative"),
        (check("positive", 1.5), check("negative", 1.2), "positive"),
        (check("positive", 5.0), check("negative", None), "negative"),  # one that overturns is worse than any ratio
        (check("positive", None), check("negative", 5.0), "positive"),
        (check("positive", None, at=0.3), check("negative", None, at=0.1), "negative"),
        (check("positive", None, at=0.1), check("negative", None, at=0.3), "positive"),
        (check("positive", None, at=None), check("negative", None, at=9.0), "negative"),  # not known: as if beyond all
        (check("positive", 1.5, at=0.3), check("negative", 1.5, at=0.1), "negative"),
        (check("positive", 1.2, at=0.1), check("negative", 1.5, at=0.3), "negative"),  # the ratio counts first
        (check("positive", 1.5), check("negative", 1.5), "positive"),
        (check("positive", 3.0, "pass"), check("negative", 1.1), "negative"),  # a failure before any ratio
        (check("positive", None, "pass"), check("negative", 1.1), "negative"),
        (check("positive", 0.2, "pass"), check("negative", 0.4, "pass"), "negative"),
    ],
)
def test_the_worse_of_two_branches_is_told(first, second, told):
    assert worst_check([first, second]).branch == told


def test_the_branch_told_has_the_smaller_pga_of_both():
    found = worst_branch_check([check("positive", 1.5, at=0.3), check("negative", 1.2, at=0.1)])
    assert (found.branch, found.ratio, found.capacity_pga_g, found.uplift_pga_g) == ("positive", 1.5, 0.1, 0.05)
    unknown = worst_branch_check([check("positive", 1.5, at=0.3), check("negative", 1.2, at=None)])
    assert (unknown.capacity_pga_g, unknown.uplift_pga_g) == (None, None)
