"""The faces that meet at a hinge, as friction sees them."""

from __future__ import annotations

from dataclasses import dataclass

LEVEL = (0.0, 1.0)


@dataclass(frozen=True)
class Face:
    """Which way the faces at a hinge look, and how rough they are.

    normal : unit vector (x, z) in the sign of the branch, to the block that presses
    found : whether the geometry has such faces; they are taken level where not
    friction : coefficient [-], None where it is not known; remedy : what the project would have to say
    """

    normal: tuple[float, float] = LEVEL
    found: bool = False
    friction: float | None = None
    remedy: str = "give blocks with geometry and a material with friction"
