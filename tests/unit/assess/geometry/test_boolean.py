"""Closed surfaces united and intersected, against closed forms."""

import pytest

from assess.geometry.boolean import unite
from assess.geometry.surface import find_edges, volume
from tests.support.solids import solid_box, surfaces_of


def test_union_is_closed_and_holds_both() -> None:
    whole = unite(
        [
            surfaces_of(solid_box()),
            surfaces_of(solid_box(base=(0.25, 0.5, 0.5))),
            surfaces_of(solid_box(base=(5.0, 0.0, 0.0))),
        ],
        where="cubes",
    )
    assert volume(*whole) == pytest.approx(3.0 - 0.75 * 0.25, rel=1e-12)
    assert find_edges(whole[1]).closed
