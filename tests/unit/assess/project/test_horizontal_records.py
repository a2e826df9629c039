"""Vertical components do not shake mechanisms."""

import pytest

from assess.errors import ProjectError
from assess.project.record_set import horizontal_records, vertical_record_messages
from records.record import make_record

RECORDS = {name: make_record(f"x {name}", [0.0, 1.0], 0.01, component=name) for name in ("N28W", "UP", "", "HNZ")}


def test_horizontal_and_unnamed_components_are_kept_and_the_others_named() -> None:
    found = [RECORDS[name] for name in ("N28W", "UP", "", "HNZ")]
    assert [one.component for one in horizontal_records(found)] == ["N28W", ""]
    (notice,) = vertical_record_messages(found)
    assert notice.text == "vertical components are not used: x UP, x HNZ"
    assert list(vertical_record_messages(horizontal_records(found))) == []


def test_vertical_components_alone_are_an_error() -> None:
    with pytest.raises(ProjectError, match=r"records\.files: vertical components alone"):
        horizontal_records([RECORDS["UP"]])
    assert horizontal_records([]) == ()
