"""The parts of a building and where they can fail: bodies, walls and their cracks, arches, joints, directions."""

from typing import TYPE_CHECKING

from assess.late import late_names

if TYPE_CHECKING:
    from assess.mechanisms.four_hinge import FourHinge, RadialJoints
    from assess.mechanisms.kinds import Definition
    from assess.mechanisms.mechanism import CutAngle, CutPlane
    from assess.mechanisms.restitution import Restitution
    from assess.mechanisms.single_block import EquivalentBlock, SingleBlock
    from assess.mechanisms.two_block import TwoBlock
    from assess.model.assembly import Built, mechanism_of
    from assess.model.bodies import Bodies, Body, Material, PointValues
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
    "mechanism_of",
]

_HOMES = {
    "assess.mechanisms.four_hinge": ("FourHinge", "RadialJoints"),
    "assess.mechanisms.kinds": ("Definition",),
    "assess.mechanisms.mechanism": ("CutAngle", "CutPlane"),
    "assess.mechanisms.restitution": ("Restitution",),
    "assess.mechanisms.single_block": ("EquivalentBlock", "SingleBlock"),
    "assess.mechanisms.two_block": ("TwoBlock",),
    "assess.model.assembly": ("Built", "mechanism_of"),
    "assess.model.bodies": ("Bodies", "Body", "Material", "PointValues"),
    "assess.model.walls": ("Crack", "crack"),
}
__getattr__, __dir__ = late_names(__name__, _HOMES)
