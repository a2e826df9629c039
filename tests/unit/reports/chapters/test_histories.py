"""Time histories in words."""

from __future__ import annotations

from assess.results import Results
from reports.chapters import histories


def test_what_overturned_or_did_not_move_is_said_in_words(results: Results) -> None:
    rows = histories.histories(results.mechanisms[1], name="h").rows
    assert [row[5:7] for row in rows].count(("overturned", "overturned")) == 1
    assert [row[5:7] for row in rows].count(("no rocking", "no rocking")) == 5
    assert histories.suites(results.mechanisms[1], name="s").rows[-1][3] == "overturned"
