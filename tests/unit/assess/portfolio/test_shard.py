"""Shares of a portfolio: every project in one, whatever else is in the portfolio."""

from __future__ import annotations

import pytest

from assess.errors import AssessError
from assess.portfolio.batch import WHOLE, Shard, parse_shard


def test_every_project_is_in_one_share_and_shares_are_about_equal() -> None:
    shares = [Shard(number, 8) for number in range(1, 9)]
    keys = [f"wall {n}" for n in range(4000)]
    assert all(sum(share.holds(key) for share in shares) == 1 for key in keys)
    sizes = [sum(map(share.holds, keys)) for share in shares]
    assert min(sizes) > 400  # five standard deviations of 500 are 105


def test_the_only_share_holds_everything() -> None:
    assert parse_shard("1/1") == WHOLE
    assert WHOLE.holds("\ud800")


@pytest.mark.parametrize("text", ["", "1", "0/4", "5/4", "1/0", "-1/4", "1/4/2", "a/b", "1.0/2", "1/2\n", "٣/٤"])
def test_what_is_no_share_is_refused(text: str) -> None:
    with pytest.raises(AssessError, match="--shard"):
        parse_shard(text)
