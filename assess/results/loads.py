"""The loads on a mechanism, as used."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.results.values import Point
from assess.short_repr import ShortRepr

Lasting = Literal["to collapse", "to its end", "not shown"]


@dataclass(frozen=True, repr=False)
class LoadResult(ShortRepr):
    """A load as used: a mass, bearing or not, or the force (along the direction, up) of a force or tie at rest.

    at: distance along the direction, elevation [m]; source: how it was found, or "given". lasting: how long a force or
    tie is shown to be there, where it resists on some branch: to collapse, to its end on the way (at a rotation, where
    its point has moved by end_m), or not at all, for want of the keys `missing`; None where it only drives. A tie that
    lasts has an end too where its fracture strain is reached beyond collapse. seat_m: of a bearing mass.
    """

    name: str
    kind: Literal["mass", "force", "tie"]
    block: int
    at: Point
    mass_kg: float | None
    bearing: bool | None
    force_n: Point | None
    source: str
    lasting: Lasting | None = None
    missing: tuple[str, ...] = ()
    end_rad: float | None = None
    end_m: float | None = None
    seat_m: float | None = None
