"""Warnings on a chain that can move, but should be reviewed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import shapely

from assess.geometry.outline import Outline
from assess.loads.load import Load
from assess.mechanisms.chain import Chain, Point, hinge_names, point_values
from assess.mechanisms.statics import compressions
from assess.messages.message import Message, Quantity, warning, whole_number

NEAR = 0.01  # of the size of a block: a hinge this far outside it still touches it


def loose_hinges(hinges: Sequence[Point], outlines: Sequence[Outline], *, mark: str = "") -> Iterator[Message]:
    """Yield a warning for each hinge, counted from the base, that does not touch a block it joins."""
    areas = [shapely.union_all([shapely.Polygon(ring) for ring in rings]) for rings in outlines]
    for number, (letter, hinge) in enumerate(zip("ABCD", hinges, strict=False)):
        for block in (number - 1, number):
            if not 0 <= block < len(areas) or areas[block].is_empty:
                continue
            gap = float(areas[block].distance(shapely.Point(hinge)))
            if gap > NEAR * float(areas[block].length) / 4.0:
                away, number_of_block = Quantity(gap, "length", 3), whole_number(block)
                named = f"{letter}{mark}"
                yield warning("loose-hinge", hinge=named, gap=away, block=number_of_block, **point_values(hinge))


def loads_across_crack(loads: Sequence[Load], elevation: float) -> Iterator[Message]:
    """Yield a warning for each load of a wall of two blocks across the crack from its block."""
    for load in loads:
        side = int(load.at[1] >= elevation)
        if load.block != side:
            yield warning(
                "load-across-crack",
                load=load.name,
                block=whole_number(load.block),
                side=whole_number(side),
                crack=Quantity(elevation, "length"),
                **point_values(load.at),
            )


def supports_in_tension(chain: Chain, *, mark: str = "") -> Iterator[Message]:
    """Yield a warning for each hinge on the ground that would be in tension at incipient motion."""
    for letter, force in zip(hinge_names(chain), compressions(chain), strict=True):
        if letter in "AD" and force < 0.0:
            yield warning("hinge-in-tension", hinge=f"{letter}{mark}", pull=Quantity(-force, "force"))
