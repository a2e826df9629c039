"""The bodies of a mechanism in space: the moving members and the fixed rest."""

from __future__ import annotations

from dataclasses import dataclass

from assess.geometry.solid import Solid
from spectra.arrays import FloatArray


@dataclass(frozen=True)
class Scene:
    """The bodies of a mechanism in space.

    Attributes
    ----------
    members : the solids of each of the mechanism's outlines, in their order
    fixed : solids that do not move, such as those under a cut
    sections : where cuts pass through the masonry: closed rings [k, 3] [m]
    direction : of motion, a horizontal unit vector [3]
    """

    members: tuple[tuple[Solid, ...], ...]
    fixed: tuple[Solid, ...]
    sections: tuple[FloatArray, ...]
    direction: FloatArray
