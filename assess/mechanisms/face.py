"""The faces that meet at a hinge, for checks of sliding."""

from __future__ import annotations

from dataclasses import dataclass

from assess.messages.message import Message, Term

LEVEL = (0.0, 1.0)


NO_FRICTION = Term("give blocks with geometry and a material with friction")


@dataclass(frozen=True)
class Face:
    """The orientation and friction of the faces at a hinge.

    normal : unit vector (x, z) in the sign of the branch, to the block that presses
    found : whether the geometry has such faces; if not, they are taken as horizontal
    friction : coefficient [-], None if not known; remedy : what to add to the project
    """

    normal: tuple[float, float] = LEVEL
    found: bool = False
    friction: float | None = None
    remedy: Term | Message = NO_FRICTION
