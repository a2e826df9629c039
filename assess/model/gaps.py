"""Bodies that a mechanism takes to be joined though they touch nowhere."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import combinations, pairwise, product

import numpy as np

from assess.geometry.boolean import shortest_distance
from assess.geometry.contact import TOLERANCE
from assess.geometry.solid import Solid
from assess.geometry.surface import connected_groups
from assess.messages.message import Message, Quantity, Value, warning
from assess.model.body import Bodies
from assess.model.definitions import Chained, Definition

Gap = dict[str, Value]
"""The values of a warning of two bodies that lie apart."""


def gaps_of(definitions: Mapping[str, Definition], bodies: Bodies) -> Iterator[Message]:
    """Warn of each gap in a block of several bodies, and between blocks that a hinge joins.

    Bodies are compared whole, even if a cut leaves their base behind.

    Parameters
    ----------
    definitions : mechanisms by name
    bodies : of the building, by name
    """
    for name, definition in definitions.items():
        chained = definition.blocks if isinstance(definition, Chained) else ()
        blocks = [solids_of_block(block, bodies) for block in chained]
        where = f"mechanisms.{name}"
        yield from (warning("gap", where, **each) for block in blocks for each in gaps_in_block(block))
        pairs = pairwise(blocks)
        yield from (
            warning("gap-at-hinge", where, **each) for one, other in pairs for each in gaps_at_hinge(one, other)
        )


def solids_of_block(block: Sequence[str], bodies: Bodies) -> list[Solid]:
    """Return the solids of a block; none if a body has no geometry, as its extent is not known."""
    found = [solid for body in block if (solid := bodies[body].solid) is not None]
    return found if len(found) == len(block) else []


def gaps_in_block(block: Sequence[Solid]) -> Iterator[Gap]:
    """Find each gap that would have to be closed for the bodies of a block to touch one another."""
    pairs = list(combinations(range(len(block)), 2))
    joined = [(i, j) for i, j in pairs if in_contact(block[i], block[j])]
    while len(block) > 1:
        group = connected_groups(np.array(joined, dtype=np.int64).reshape(-1, 2), count=len(block))
        across = [(shortest_distance(block[i], block[j]), (i, j)) for i, j in pairs if group[i] != group[j]]
        if not across:
            return
        distance, (i, j) = min(across)
        joined.append((i, j))
        yield gap_values(block[i], block[j], distance)


def gaps_at_hinge(one: Sequence[Solid], other: Sequence[Solid]) -> Iterator[Gap]:
    """Find the gap between two blocks with a hinge between them that touch nowhere."""
    pairs = list(product(one, other))
    if not pairs or any(in_contact(*pair) for pair in pairs):
        return
    distances = [shortest_distance(*pair) for pair in pairs]
    yield gap_values(*pairs[int(np.argmin(distances))], min(distances))


def in_contact(one: Solid, other: Solid) -> bool:
    """Return whether two bodies are closer than the thickness of a joint."""
    return shortest_distance(one, other, limit=TOLERANCE) < TOLERANCE


def gap_values(one: Solid, other: Solid, distance: float) -> Gap:
    """Return the values of a warning: which two bodies are apart, and by how much [m]."""
    return {"one": one.name, "other": other.name, "distance": Quantity(distance, "length", 3)}
