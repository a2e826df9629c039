"""Closed surfaces united and intersected, against closed forms."""

import pytest

from assess.errors import GeometryError
from assess.geometry.boolean import split, unite
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


def test_halves_of_a_cube() -> None:
    upper, lower = split(surfaces_of(solid_box(base=(0.0, 0.0, -0.3))), where="cube")
    assert (volume(*upper), volume(*lower)) == pytest.approx((0.7, 0.3), rel=1e-12)


def test_an_open_surface_is_refused() -> None:
    vertices, triangles = surfaces_of(solid_box())
    with pytest.raises(GeometryError, match="sheet cannot be cut, united"):
        split((vertices, triangles[1:]), where="sheet")
