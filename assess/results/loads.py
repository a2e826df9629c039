"""The loads on a mechanism, as used."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.messages.message import Message, Term
from assess.results.values import Point
from assess.short_repr import ShortRepr

Lasting = Literal["to collapse", "to its end", "not shown"]


@dataclass(frozen=True, repr=False)
class LoadResult(ShortRepr):
    """A load as used: a mass, bearing or not, or the force (along the direction, up) of a force or tie at rest.

    at: distance along the direction, elevation [m]; source: how it was found, or "given", the English of `found`.
    lasting: how long a force or tie that resists on some branch is shown to last: to collapse, to an earlier end
    (at end_rad, where its point has moved by end_m), or not at all, because the keys `missing` are not given; None
    if it only drives. A tie that lasts also has an end if its fracture strain is reached beyond collapse. seat_m:
    length of seat of a bearing mass.
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
    found: tuple[Term | Message, ...] = ()
