"""Warnings on a chain that can move, but should be reviewed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import shapely

from assess.geometry.outline import Outline
from assess.loads.load import Load
from assess.mechanisms.chain import Chain, Point, format_point, hinge_names
from assess.mechanisms.statics import compressions

NEAR = 0.01  # of the size of a block: a hinge this far outside it still touches it


def loose_hinges(hinges: Sequence[Point], outlines: Sequence[Outline], *, mark: str = "") -> Iterator[str]:
    """Yield a warning for each hinge, counted from the base, that does not touch a block it joins."""
    areas = [shapely.union_all([shapely.Polygon(ring) for ring in rings]) for rings in outlines]
    for number, (letter, hinge) in enumerate(zip("ABCD", hinges, strict=False)):
        for block in (number - 1, number):
            if not 0 <= block < len(areas) or areas[block].is_empty:
                continue
            gap = float(areas[block].distance(shapely.Point(hinge)))
            if gap > NEAR * float(areas[block].length) / 4.0:
                yield f"hinge {letter}{mark} at {format_point(hinge)} is {gap:.3g} m away from block {block}; check it"


def loads_across_crack(loads: Sequence[Load], elevation: float) -> Iterator[str]:
    """Yield a warning for each load of a wall of two blocks across the crack from its block."""
    for load in loads:
        side = int(load.at[1] >= elevation)
        if load.block != side:
            yield (
                f'load "{load.name}" at {format_point(load.at)} acts on block {load.block}, yet the crack is at z = '
                f"{elevation:.4g} m; write block = {side} if it moves with that one"
            )


def supports_in_tension(chain: Chain, *, mark: str = "") -> Iterator[str]:
    """Yield a warning for each hinge on the ground that would be in tension at incipient motion."""
    for letter, force in zip(hinge_names(chain), compressions(chain), strict=True):
        if letter in "AD" and force < 0.0:
            yield (
                f"hinge {letter}{mark} would have to pull its block down with {-force:.4g} N when the mechanism "
                "starts, which masonry cannot: check hinges and loads"
            )
