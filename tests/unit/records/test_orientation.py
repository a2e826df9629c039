"""Azimuths from the names of components, by the compass."""

import math

import pytest

from records.record import azimuth_of, is_vertical


@pytest.mark.parametrize(
    ("name", "degrees"),
    [
        ("N", 0), ("E", 90), ("S", 180), ("W", 270), ("WEST", 270),
        ("E-W", 90), ("NS", 0), ("WE", 90), ("EAST", 90), ("EW2", 90), ("HNE", 90), ("hnn", 0),
        ("360", 0), ("000", 0), ("21", 21), ("090", 90), ("90 DEG", 90), ("340 deg", 340),
        ("N28W", 332), ("S62W", 242), ("S16E", 164), ("N45E", 45),
    ],
)  # fmt: skip
def test_azimuths(name: str, degrees: float) -> None:
    found = azimuth_of(name)
    assert found is not None
    assert math.degrees(found) == pytest.approx(degrees, abs=1e-9)
    assert not is_vertical(name)


@pytest.mark.parametrize("name", ["UP", "up", "U-D", "UD2", "HNZ", "V", "DWN", "Vert"])
def test_vertical_components_have_none(name: str) -> None:
    assert is_vertical(name)
    assert azimuth_of(name) is None


@pytest.mark.parametrize("name", ["", "L", "T", "H1", "361", "chan 1", "N28", "-90", "9e9", "N--1W", "N-28W", "N98W"])
def test_what_a_name_does_not_tell_stays_unknown(name: str) -> None:
    assert azimuth_of(name) is None
    assert not is_vertical(name)
