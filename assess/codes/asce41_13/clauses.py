"""ASCE/SEI 41-13, 11.3.3, Table 11-5 (41-06 Table 7-5): walls that need no analysis out of their plane.

A wall anchored at floors and roof is taken as stable for life safety and collapse prevention where its height over
thickness does not exceed the table's. Parapets have limits of their own, those of the checklist for nonstructural
components. Table, bounds and limits are from memory, not checked against the printed standard; the later edition
(41-17) may differ. One function for each rule.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from assess.codes.context import PLINTH, Building, Context, Wall

EDITION = "ASCE/SEI 41-13"
CAVEAT = (
    "Table 11-5 is from memory, not checked against the printed standard; it presumes a wall anchored at its base and "
    "top; S_X1 is that of the site's spectrum at the level, whatever hazard it represents"
)
CAVEAT_PARAPET = "the limits for parapets are from memory, not checked against the printed standard"

Position = Literal["one-storey", "first-storey", "top-storey", "other"]
STRICTEST: Position = "top-storey"
MILDEST: Position = "first-storey"
Masonry = Literal["coursed", "rubble"]
Seismicity = Literal["moderate", "high"]

BOUNDS = (0.24, 0.37)  # g: S_X1 up to which the first and the second column hold
PERMISSIBLE: Mapping[Position, tuple[float, float, float]] = {  # h/t [-], Table 11-5
    "one-storey": (20.0, 16.0, 13.0),
    "first-storey": (20.0, 18.0, 15.0),
    "top-storey": (14.0, 14.0, 9.0),
    "other": (20.0, 16.0, 13.0),
}
PLACES: Mapping[Position, str] = {
    "one-storey": "wall of a one-storey building",
    "first-storey": "first-storey wall of a multistorey building",
    "top-storey": "wall in the top storey of a multistorey building",
    "other": "all other walls",
}
PARAPET: Mapping[Seismicity, float] = {"moderate": 2.5, "high": 1.5}  # h/t [-]
NEAR_ROOF = 0.5  # m: what stands free no lower than this under the top of the building stands on it


@dataclass(frozen=True)
class Options:
    """Options of the permissible h/t.

    position : row of Table 11-5; None where storeys and elevation decide
    masonry : None where it is not given; seismicity : of the site, for parapets
    s_x1 : at the site's own PGA [g]; None for the ordinate of the spectrum at 1 s
    """

    position: Position | None = None
    masonry: Masonry | None = None
    seismicity: Seismicity = "high"
    s_x1: float | None = None


def permissible(position: Position, s_x1: float) -> float:
    """Return the largest permissible h/t of a wall (Table 11-5).

    Parameters
    ----------
    position : row of the table
    s_x1 : S_X1 [g]

    Returns
    -------
    float [-]
    """
    return PERMISSIBLE[position][sum(s_x1 > bound for bound in BOUNDS)]


def largest_s_x1(position: Position, slenderness: float) -> float | None:
    """Return the S_X1 up to which a wall is permitted (Table 11-5).

    Parameters
    ----------
    position : row of the table
    slenderness : h/t [-]

    Returns
    -------
    float or None
        S_X1 [g]; 0 where the wall never is, None where it always is.
    """
    within = [slenderness <= most for most in PERMISSIBLE[position]]
    return None if all(within) else (0.0, *BOUNDS)[sum(within)]


def position_of(wall: Wall, elevation: float, building: Building | None) -> Position | None:
    """Return the row of Table 11-5 of a wall; None where the building's storeys are not known.

    A wall whose top is within half a storey of the building's is in the top storey, the stricter row.

    Parameters
    ----------
    wall : its size
    elevation : of its base above the ground [m]
    building : the structure it belongs to

    Returns
    -------
    Position or None
    """
    if building is None or building.storeys is None:
        return None
    if building.storeys == 1:
        return "one-storey"
    storey = building.height / building.storeys
    if elevation + wall.height >= building.height - storey / 2.0:
        return "top-storey"
    return "first-storey" if elevation <= PLINTH else "other"


def is_parapet(context: Context) -> bool:
    """Return whether the masonry stands free on top of a building whose height is known."""
    building = context.building
    return context.support == "free" and building is not None and context.elevation >= building.height - NEAR_ROOF
