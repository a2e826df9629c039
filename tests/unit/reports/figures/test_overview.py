"""All mechanisms beside each other fit on a page, however slender they are."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assess.results import MechanismResult, Results
from reports.figures import overview

LETTER_HEIGHT, MARGINS = 11.0, 1.8  # of the lower paper, with room for the caption [in]


def slender(mechanism: MechanismResult) -> MechanismResult:
    ring = ((0.0, 0.0), (0.5, 0.0), (0.5, 12.0), (0.0, 12.0))
    return replace(mechanism, drawing=replace(mechanism.drawing, blocks=(ring,), block_of=(0,), hinges=()))


@pytest.mark.parametrize("count", [1, 3, 19, overview.MOST])
def test_a_page_holds_it(results: Results, count: int) -> None:
    figure = overview.draw((slender(results.mechanisms[0]),) * count)
    assert figure.get_figheight() <= LETTER_HEIGHT - MARGINS
    assert len(figure.axes) == count
