"""Space that a surface encloses twice, against closed forms."""

import pytest

from assess.errors import GeometryError
from assess.geometry.shells import measure_self_overlap, self_overlap_warnings
from assess.geometry.surface import Surface
from tests.support.solids import solid_box, surfaces_of

CUBE = solid_box()


@pytest.mark.parametrize("overlap", [0.5, 0.1, 0.02])
def test_share_that_counts_twice(overlap: float) -> None:
    found = measure_self_overlap(surfaces_of(CUBE, solid_box(base=(1.0 - overlap, 0, 0))))
    assert found.share == pytest.approx(overlap / (2.0 - overlap), rel=0.1)  # 48 lines across
    assert found.place is not None
    assert 0.5 - overlap < found.place[0] < 0.5


@pytest.mark.parametrize(
    "surface",
    [
        surfaces_of(CUBE),
        surfaces_of(CUBE, solid_box(base=(1.0, 0, 0))),
        surfaces_of(CUBE, solid_box(base=(3.0, 0, 0))),
        surfaces_of(CUBE, solid_box((0.5, 0.5, 0.5), (0.75, 0, 0))),
    ],
)
def test_bodies_that_touch_or_stand_apart_are_sound(surface: Surface) -> None:
    assert measure_self_overlap(surface).place is None
    assert self_overlap_warnings(surface, where="pair") == ()


def test_a_little_is_told_and_much_refused() -> None:
    (told,) = self_overlap_warnings(surfaces_of(CUBE, solid_box(base=(0.995, 0, 0))), where="pair")
    assert "intersects itself near x = 0.49" in told.text
    with pytest.raises(GeometryError, match=r"pair: its surface intersects itself near .* about 33 % of its volume"):
        self_overlap_warnings(surfaces_of(CUBE, solid_box(base=(0.5, 0, 0))), where="pair")


def test_a_pillar_of_many_drums_is_sound() -> None:
    drums = [solid_box((1.0, 1.0, 0.1), (0.0, 0.0, 0.1 * i)) for i in range(30)]
    assert measure_self_overlap(surfaces_of(*drums)).place is None
