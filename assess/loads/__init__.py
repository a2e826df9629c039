"""Loads of a mechanism: as stated, as found on the geometry, and in the plane of motion."""

from typing import TYPE_CHECKING

from assess.late import late_names

if TYPE_CHECKING:
    from assess.loads.bearing import Overburden, Support, shares, support
    from assess.loads.load import (
        BodyLoad,
        Force,
        ForceLoad,
        Load,
        LoadDefinition,
        MassLoad,
        OverburdenLoad,
        PointMass,
        Tie,
        TieLoad,
    )
    from assess.loads.roofs_and_vaults import CONSTRUCTIONS, Construction, arch_thrust, uniform_lever_arm

__all__ = [
    "CONSTRUCTIONS",
    "BodyLoad",
    "Construction",
    "Force",
    "ForceLoad",
    "Load",
    "LoadDefinition",
    "MassLoad",
    "Overburden",
    "OverburdenLoad",
    "PointMass",
    "Support",
    "Tie",
    "TieLoad",
    "arch_thrust",
    "shares",
    "support",
    "uniform_lever_arm",
]

_HOMES = {
    "assess.loads.bearing": ("Overburden", "Support", "shares", "support"),
    "assess.loads.load": (
        "BodyLoad",
        "Force",
        "ForceLoad",
        "Load",
        "LoadDefinition",
        "MassLoad",
        "OverburdenLoad",
        "PointMass",
        "Tie",
        "TieLoad",
    ),
    "assess.loads.roofs_and_vaults": ("CONSTRUCTIONS", "Construction", "arch_thrust", "uniform_lever_arm"),
}
__getattr__, __dir__ = late_names(__name__, _HOMES)
