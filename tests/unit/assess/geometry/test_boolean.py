"""Closed surfaces united and intersected, against closed forms."""

import pytest

from assess.errors import GeometryError
from assess.geometry.boolean import split, unite
from assess.geometry.solid import box
from assess.geometry.surface import Surface, find_edges, volume


def cube(x: float, y: float = 0.0, z: float = 0.0) -> Surface:
    body = box(thickness=1.0, length=1.0, height=1.0, base=[x, y, z], density=1.0, name="cube")
    return body.vertices, body.triangles


def test_union_is_closed_and_holds_both() -> None:
    whole = unite([cube(0.0), cube(0.25, 0.5, 0.5), cube(5.0)], where="cubes")
    assert volume(*whole) == pytest.approx(3.0 - 0.75 * 0.25, rel=1e-12)
    assert find_edges(whole[1]).closed


def test_halves_of_a_cube() -> None:
    upper, lower = split(cube(0.0, z=-0.3), where="cube")
    assert (volume(*upper), volume(*lower)) == pytest.approx((0.7, 0.3), rel=1e-12)


def test_an_open_surface_is_refused() -> None:
    vertices, triangles = cube(0.0)
    with pytest.raises(GeometryError, match="sheet cannot be cut, united"):
        split((vertices, triangles[1:]), where="sheet")
