"""Accelerations of the site, against numbers by hand."""

from __future__ import annotations

import pytest

from assess.results import Results
from reports.chapters import site


def test_accelerations_of_the_site_are_all_in_g(results: Results) -> None:
    rows = {row[0]: row[1:] for row in site.site(results).rows}
    assert rows["S_DS, design, at short periods"] == ("g", pytest.approx(0.167, rel=1e-4))
    assert rows["T_L, long-period transition"] == ("s", 6.0)
    assert rows["peak ground acceleration, Sₐ(0)"][0] == "g"
