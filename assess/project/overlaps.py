"""Bodies of one mechanism that share space, so that their masonry counts twice."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import combinations

import numpy as np

from assess.geometry.boolean import common_volume
from assess.geometry.solid import Solid
from assess.geometry.surface import volume
from assess.project import sections
from assess.results import Notice

LEAST = 1e-6  # of the smaller body: a common volume below this is rounding where bodies touch


def overlaps_of(content: sections.Content, solids: Mapping[str, Solid | None]) -> Iterator[Notice]:
    """A notice for each two bodies of a mechanism that overlap, with the volume that counts twice."""
    for name, section in content.mechanisms.items():
        blocks = () if isinstance(section, sections.EquivalentBlock) else section.blocks
        names = dict.fromkeys(body for block in blocks for body in block)
        bodies = [solid for body in names if (solid := solids[body]) is not None]
        for one, other in combinations(bodies, 2):
            shared = shared_volume(one, other)
            smaller = min((one, other), key=lambda solid: volume(solid.vertices, solid.triangles))
            share = shared / volume(smaller.vertices, smaller.triangles)
            if share > LEAST:
                yield Notice(
                    "overlap",
                    f"mechanisms.{name}",
                    f'bodies "{one.name}" and "{other.name}" overlap: {shared:.3g} m3, {100.0 * share:.3g} % of '
                    f'"{smaller.name}", counts twice; shape them so that they only touch',
                )


def shared_volume(one: Solid, other: Solid) -> float:
    """Volume [m3] inside both bodies; none where their boxes only touch."""
    low = np.maximum(one.vertices.min(axis=0), other.vertices.min(axis=0))
    high = np.minimum(one.vertices.max(axis=0), other.vertices.max(axis=0))
    if (high <= low).any():
        return 0.0
    where = f'bodies "{one.name}" and "{other.name}":'
    return common_volume((one.vertices, one.triangles), (other.vertices, other.triangles), where=where)
