"""Space that a surface encloses twice, against closed forms."""

import numpy as np
import pytest

from assess.errors import GeometryError
from assess.geometry.shells import measure_self_overlap, self_overlap_warnings
from assess.geometry.solid import box, join
from assess.geometry.surface import Surface


def cube(x: float, size: float = 1.0) -> Surface:
    body = box(thickness=size, length=size, height=size, base=[x, 0.0, 0.0], density=1.0, name="cube")
    return body.vertices, body.triangles


def two(x: float, size: float = 1.0) -> Surface:
    (a, s), (b, t) = cube(0.0), cube(x, size)
    return np.vstack([a, b]), np.vstack([s, t + len(a)])


@pytest.mark.parametrize("overlap", [0.5, 0.1, 0.02])
def test_share_that_counts_twice(overlap: float) -> None:
    found = measure_self_overlap(two(1.0 - overlap))
    assert found.share == pytest.approx(overlap / (2.0 - overlap), rel=0.1)  # 48 lines across
    assert found.place is not None
    assert 0.5 - overlap < found.place[0] < 0.5


@pytest.mark.parametrize("surface", [cube(0.0), two(1.0), two(3.0), two(0.75, 0.5)])
def test_bodies_that_touch_or_stand_apart_are_sound(surface: Surface) -> None:
    assert measure_self_overlap(surface).place is None
    assert self_overlap_warnings(surface, where="pair") == ()


def test_a_little_is_told_and_much_refused() -> None:
    (told,) = self_overlap_warnings(two(0.995), where="pair")
    assert "intersects itself near x = 0.49" in told.text
    with pytest.raises(GeometryError, match=r"pair: its surface intersects itself near .* about 33 % of its volume"):
        self_overlap_warnings(two(0.5), where="pair")


def test_a_pillar_of_many_drums_is_sound() -> None:
    drums = [
        box(thickness=1.0, length=1.0, height=0.1, base=[0.0, 0.0, 0.1 * i], density=1.0, name="d") for i in range(30)
    ]
    whole = join(drums, name="pillar")
    assert measure_self_overlap((whole.vertices, whole.triangles)).place is None
