"""The law of a joint: its stress over its closure."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf


@dataclass(frozen=True)
class JointLaw:
    """A joint without tension, linear up to its strength and plastic beyond, without memory.

    stiffness : per unit of area, k_n = E / thickness [Pa/m]; infinite: rigid
    strength : in compression, f_m [Pa]; infinite: elastic
    """

    stiffness: float = inf
    strength: float = inf
