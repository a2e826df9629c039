"""The wall at the far end of a tie as a mechanism of its own: it turns inwards, and the tie pulls it over.

        tied wall                         far wall
      <-- a g W' |------------ N ----------->|  h above the crack, towards the tied wall
                 |                           |
                 |            <-- a g W      |   both walls are shaken in one sense
                 |                           |
                 A                           A   turns about the edge that is nearer to the tied wall

Virtual work for a small turn about that edge, with the weight W at a distance b from it and a height h_G above it:
N h = W b - a W h_G, and with more weights the sums of their moments (own derivation, of no clause). The far wall is not
to begin to turn, as what holds a tie is taken as fixed. So a is FC times the peak acceleration at the level of the
crack, without the factor q = 2 by which a wall that rocks may be checked. Several ties of one wall share it evenly:
with N on each of them, N times the sum of their heights.
"""

from __future__ import annotations

from dataclasses import dataclass

RIGID_ABOVE = 1.5  # times Z / H: more acceleration of what is rigid above the ground (EN 1998-1, 4.3.5.2, T_a = 0)


@dataclass(frozen=True)
class SiteAction:
    """What shakes far walls: the peak acceleration of the ground at the limit state that decides.

    pga : a_g S / g [-]
    ground, height : elevation of the ground and height of the building above it [m]; None: as far as bodies are drawn
    """

    pga: float
    ground: float | None = None
    height: float | None = None


def action_at(*, pga: float, FC: float, Z: float, H: float) -> float:
    """Return FC times the peak acceleration of what is rigid at a level of a building, over g [-].

    FC a_g S / g (1 + 1.5 Z / H): eq. 4.25 of EN 1998-1, from memory, for T_a = 0, where it is S_a without q_a.

    Parameters
    ----------
    pga : a_g S / g [-]
    FC : confidence factor [-]
    Z, H : height of the level above the ground, of the building [m]
    """
    return FC * pga * (1.0 + RIGID_ABOVE * min(max(Z / H, 0.0), 1.0))


@dataclass(frozen=True)
class FarEnd:
    """What is known of the wall at the far end of a tie.

    body : its name, empty where none is drawn
    unexamined : why it is no mechanism: "no wall", "no site", "no loads" that are known, "held", or "pressed"
        down; empty if it is one
    held_by : bodies that stop it from within; stack : walls on it or under it as bodies of their own, which are not
        examined with it
    cone : of an injected end, its surface as the edges of the wall and cones of its neighbours leave it to each [m2];
        None without
    """

    body: str = ""
    unexamined: str = "no wall"
    held_by: tuple[str, ...] = ()
    stack: tuple[str, ...] = ()
    cone: float | None = None


NOT_DRAWN = FarEnd()


@dataclass(frozen=True)
class FarWall:
    """The far wall of a tie above its weakest crack, as far along the wall as its ties hold it.

    body : its name
    crack : elevation of the crack [m]
    stabilising : sum of the moments of its weights about the edge at which it turns [N m]
    overturning : sum of weights times heights above that edge, which the acceleration over g multiplies [N m]
    levers : heights above that edge of all ties that it holds, summed up [m]; ties : their number
    action : FC times the peak acceleration at the crack, over g [-]
    FC, pga, rise : of which that is made: confidence factor, a_g S / g, Z / H [-]
    length : of the wall that turns, along it [m]
    """

    body: str
    crack: float
    stabilising: float
    overturning: float
    levers: float
    ties: int
    action: float
    FC: float
    pga: float
    rise: float
    length: float

    @property
    def multiplier(self) -> float:
        """The acceleration over g at which it turns without any tie [-]."""
        return self.stabilising / self.overturning

    @property
    def strength(self) -> float:
        """The pull of each tie at which it begins to turn [N]; 0 where it does so without any."""
        return max(self.stabilising - self.action * self.overturning, 0.0) / self.levers
