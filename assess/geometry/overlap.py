"""Overlap of bodies, whose common masonry would count twice."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from assess.geometry.boolean import intersect
from assess.geometry.solid import Solid
from assess.messages.message import Message, Quantity, warning

OVERLAP = 5e-3  # of the smaller body's volume: bodies that share less are taken to touch
SAME_PLACE = 0.1  # of the smaller body's volume: a body that shares more with a block is another state of it


def overlap_warnings(bodies: Sequence[Solid], *, where: str = "") -> Iterator[Message]:
    """Warn of each pair of bodies that overlap, so that their common volume is weighed twice.

    Parameters
    ----------
    bodies : any number
    where : what the warnings concern
    """
    for one, other in combinations(bodies, 2):
        shared = intersect(one, other)
        if shared is not None and shared.part > OVERLAP:
            yield warning(
                "overlap",
                where,
                one=one.name,
                other=other.name,
                volume=Quantity(shared.volume, "volume", 3),
                share=Quantity(100.0 * shared.part, "percent", 3),
            )


def shared_volume(block: Sequence[Solid], other: Solid) -> tuple[float, float]:
    """Return the overlap of a body with the solids of a block.

    Parameters
    ----------
    block : its solids
    other : the body

    Returns
    -------
    largest share of the smaller body [-], and the volume [m3]
    """
    shared = [each for solid in block if (each := intersect(solid, other)) is not None]
    return max((each.part for each in shared), default=0.0), sum(each.volume for each in shared)
