"""The horizontal thrust of roofs and vaults on what they stand on, and what vaults are built of (thesis 3.2.2).

A pair of rafters, or the two halves of a vault, lean on each other at the ridge or crown and stand on springings: an
arch with three hinges. At the crown of a symmetric one only a horizontal force H acts between the halves, which each
springing returns as the thrust; V, half the weight W, is the springing's vertical reaction. Moments of one half about
its springing, its weight at the distance x from there, the crown at the rise f above:

              crown
            H -->o<-- H                      V x = H f
            .    |    .
          .   V  |      .                    weight even over the plan of span L:  x = L / 4,  H = W L / (8 f)
       H o--x-->         o H
         V <--- L ---> V

So the thrust follows the vertical reaction of the springing: a wall that carries a part of it takes that part of H.
For the bay of a quadripartite vault the same equilibrium holds for half the bay, cut along its ridge: the thrust is
that of both its corners together.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from assess.errors import GeometryError


@dataclass(frozen=True)
class Construction:
    """What a vault is built of: name, thickness [m], density [kg/m3]."""

    name: str
    thickness: float
    density: float

    @property
    def mass_per_area(self) -> float:
        """The mass of the vault per area of its surface [kg/m2]."""
        return self.thickness * self.density


LIGHT_BRICK, STRONG_BRICK, SANDSTONE, RUBBLE = 1300.0, 1800.0, 2250.0, 2200.0  # kg/m3
CONSTRUCTIONS: Mapping[int, Construction] = {
    1: Construction("1/2 lightweight brick", 0.125, LIGHT_BRICK),
    2: Construction("1/2 strong brick, or 3/4 lightweight brick", 0.125, STRONG_BRICK),
    3: Construction("3/4 strong brick, or 1 lightweight brick", 0.190, STRONG_BRICK),
    4: Construction("1 strong brick, or 200 mm sandstone", 0.250, STRONG_BRICK),
    5: Construction("300 mm rubble", 0.300, RUBBLE),
}
"""The five cases of Ungewitter and Mohrmann (1901) with their thicknesses, as thesis 3.2.2 lists them.

The densities are assumptions: usual ones for which the two constructions of a case weigh nearly the same (case 2:
225 and 247 kg/m2, case 3: 342 and 325, case 4: 450 and 450); the strong brick stands for the case.
"""


def arch_thrust(reaction: float, *, lever: float, rise: float) -> float:
    """Return the thrust H = V x / f of half an arch of three hinges on its springing.

    Parameters
    ----------
    reaction : vertical reaction V of the springing [N]
    lever : distance x of the weight of the half from its springing [m]
    rise : f of the crown above the springing [m]

    Returns
    -------
    Horizontal thrust, outwards [N]

    Raises
    ------
    GeometryError : the crown is not above the springing
    """
    if not rise > 0.0:
        raise GeometryError(f"arch: rise = {rise:g} m: the crown must be above the springing")
    return reaction * lever / rise


def uniform_lever_arm(span: float) -> float:
    """x = L / 4 [m] for a weight spread evenly over the plan: rafters, a flat vault, one filled up to the crown."""
    return span / 4.0
