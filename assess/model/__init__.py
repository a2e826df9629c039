"""The parts of a building and where they can fail: bodies, walls and their cracks, arches, joints, directions."""

from typing import TYPE_CHECKING

from assess.late import late_names

if TYPE_CHECKING:
    from assess.model.assembly import Built, mechanism_of
    from assess.model.blocks import gaps_of
    from assess.model.body import Bodies, Body, Material, PointValues
    from assess.model.definitions import (
        CutAngle,
        CutPlane,
        Definition,
        EquivalentBlock,
        FourHinge,
        RadialJoints,
        Restitution,
        SingleBlock,
        TwoBlock,
    )
    from assess.model.overlaps import overlaps_of
    from assess.model.walls import Crack, crack

__all__ = [
    "Bodies",
    "Body",
    "Built",
    "Crack",
    "CutAngle",
    "CutPlane",
    "Definition",
    "EquivalentBlock",
    "FourHinge",
    "Material",
    "PointValues",
    "RadialJoints",
    "Restitution",
    "SingleBlock",
    "TwoBlock",
    "crack",
    "gaps_of",
    "mechanism_of",
    "overlaps_of",
]

_HOMES = {
    "assess.model.assembly": ("Built", "mechanism_of"),
    "assess.model.body": ("Bodies", "Body", "Material", "PointValues"),
    "assess.model.definitions": (
        "CutAngle",
        "CutPlane",
        "Definition",
        "EquivalentBlock",
        "FourHinge",
        "RadialJoints",
        "Restitution",
        "SingleBlock",
        "TwoBlock",
    ),
    "assess.model.blocks": ("gaps_of",),
    "assess.model.overlaps": ("overlaps_of",),
    "assess.model.walls": ("Crack", "crack"),
}
__getattr__, __dir__ = late_names(__name__, _HOMES)
