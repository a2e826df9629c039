"""Bodies that share space, so that their masonry counts twice."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from assess.geometry.boolean import intersect
from assess.geometry.solid import Solid
from assess.messages.message import Message, Quantity, warning

OVERLAP = 5e-3  # of the smaller body's volume: bodies that share less are taken to touch
SAME_PLACE = 0.1  # of the smaller body's volume: a body that shares more with a block is another state of it


def overlaps(bodies: Sequence[Solid], *, where: str = "") -> Iterator[Message]:
    """A warning for each two of the bodies that overlap, so that what they share is weighed twice."""
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


def shared_with(block: Sequence[Solid], other: Solid) -> tuple[float, float]:
    """What a body shares with the solids of a block: the largest part of the smaller [-], and the volume [m3]."""
    shared = [each for solid in block if (each := intersect(solid, other)) is not None]
    return max((each.part for each in shared), default=0.0), sum(each.volume for each in shared)
