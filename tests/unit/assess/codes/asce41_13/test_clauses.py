"""ASCE/SEI 41-13, Table 11-5 and the parapets of the checklist, row by row."""

from __future__ import annotations

from dataclasses import replace

import pytest

from assess.codes.asce41_13 import PARAPET, is_parapet, permissible_slenderness, permitted_s_x1, position_of
from assess.codes.context import Building, Wall
from tests.support.straight import GROUND

HOUSE = Building(height=9.0, storeys=3, period=0.26, damping=0.05)  # storeys of 3 m


@pytest.mark.parametrize(
    ("position", "row"),
    [
        ("one-storey", (20.0, 16.0, 13.0)),
        ("first-storey", (20.0, 18.0, 15.0)),
        ("top-storey", (14.0, 14.0, 9.0)),
        ("other", (20.0, 16.0, 13.0)),
    ],
)
def test_permissible(position, row) -> None:
    """S_X1 <= 0.24 g, <= 0.37 g and above: the bounds belong to the milder column."""
    assert tuple(permissible_slenderness(position, s_x1) for s_x1 in (0.24, 0.37, 0.38)) == row
    assert tuple(permissible_slenderness(position, s_x1) for s_x1 in (0.0, 0.25, 2.0)) == row


@pytest.mark.parametrize(
    ("position", "slenderness", "bound"),
    [
        ("first-storey", 15.0, None),
        ("first-storey", 16.0, 0.37),
        ("first-storey", 19.0, 0.24),
        ("first-storey", 20.5, 0.0),
        ("top-storey", 9.0, None),
        ("top-storey", 14.0, 0.37),
        ("top-storey", 14.1, 0.0),
    ],
)
def test_largest_s_x1(position, slenderness: float, bound: float | None) -> None:
    assert permitted_s_x1(position, slenderness) == bound


@pytest.mark.parametrize(
    ("elevation", "height", "building", "position"),
    [
        (0.0, 3.0, HOUSE, "first-storey"),
        (3.0, 3.0, HOUSE, "other"),
        (6.0, 3.0, HOUSE, "top-storey"),
        (4.5, 3.0, HOUSE, "top-storey"),  # top at 7.5 m, half a storey below the roof
        (4.4, 3.0, HOUSE, "other"),
        (0.0, 3.0, replace(HOUSE, storeys=1), "one-storey"),
        (0.0, 3.0, replace(HOUSE, storeys=None), None),
        (0.0, 3.0, None, None),
    ],
)
def test_position_of(elevation: float, height: float, building: Building | None, position: str | None) -> None:
    assert position_of(Wall(height, 0.3), elevation, building) == position


@pytest.mark.parametrize(
    ("elevation", "support", "building", "parapet"),
    [
        (9.0, "free", HOUSE, True),
        (8.5, "free", HOUSE, True),  # within 0.5 m of the top
        (8.4, "free", HOUSE, False),
        (9.0, "spanning", HOUSE, False),
        (9.0, "free", None, False),
    ],
)
def test_is_parapet(elevation: float, support, building: Building | None, parapet: bool) -> None:
    at = replace(GROUND, elevation=elevation, support=support, building=building)
    assert is_parapet(at) is parapet


@pytest.mark.parametrize(("seismicity", "most"), [("moderate", 2.5), ("high", 1.5)])
def test_limits_of_parapets(seismicity, most: float) -> None:
    assert PARAPET[seismicity] == most
