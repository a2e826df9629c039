"""What a joint answers to being closed."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf


@dataclass(frozen=True)
class JointLaw:
    """No tension, linear up to the strength, plastic beyond, without memory.

    stiffness : of the joint for each area, k_n = E / thickness [Pa/m]; infinite: rigid
    strength : in compression, f_m [Pa]; infinite: elastic
    """

    stiffness: float = inf
    strength: float = inf
