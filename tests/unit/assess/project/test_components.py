"""Vertical components do not shake mechanisms."""

import pytest

from assess.errors import ProjectError
from assess.project.components import horizontal, left_out
from records.record import Record, make_record


def record(component: str) -> Record:
    return make_record(f"x {component}", [0.0, 1.0], 0.01, component=component)


def test_horizontal_and_unnamed_components_are_kept_and_the_others_named() -> None:
    found = [record(name) for name in ("N28W", "UP", "", "HNZ")]
    assert [one.component for one in horizontal(found)] == ["N28W", ""]
    (notice,) = left_out(found)
    assert notice.text == "vertical components are not used: x UP, x HNZ"
    assert list(left_out(horizontal(found))) == []


def test_vertical_components_alone_are_an_error() -> None:
    with pytest.raises(ProjectError, match=r"records\.files: vertical components alone"):
        horizontal([record("UP")])
    assert horizontal([]) == ()
