"""Bodies of one mechanism that share space, so that their masonry counts twice."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from assess.geometry.boolean import overlap_warnings
from assess.messages.message import Message
from assess.model.body import Bodies
from assess.model.definitions import BlockMechanism, Definition


def overlaps_of(definitions: Mapping[str, Definition], bodies: Bodies) -> Iterator[Message]:
    """Warn of each two bodies of a mechanism's blocks that overlap.

    Parameters
    ----------
    definitions : mechanisms by name
    bodies : of the building, by name
    """
    for name, definition in definitions.items():
        names = dict.fromkeys(definition.bodies if isinstance(definition, BlockMechanism) else ())
        known = [solid for body in names if (solid := bodies[body].solid) is not None]
        yield from overlap_warnings(known, where=f"mechanisms.{name}")
