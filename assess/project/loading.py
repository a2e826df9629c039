"""The entries of `loads` as the field's loads."""

from __future__ import annotations

from collections.abc import Sequence

from assess.loads import Force, Load, PointMass, Tie
from assess.project import sections
from assess.project.plane import point_in_plane, unit_in_plane


def load_of(
    number: int, load: sections.MassLoad | sections.ForceLoad | sections.TieLoad, direction: Sequence[float]
) -> Load:
    """One entry of `loads` in the plane of motion, named by its kind and number."""
    name, at = f"{load.kind} {number}", point_in_plane(load.at, direction)
    if isinstance(load, sections.MassLoad):
        return PointMass(name, load.mass, at, load.bearing, load.block)
    way = None if load.direction is None else unit_in_plane(load.direction, direction)
    if isinstance(load, sections.TieLoad):
        anchor = None if load.anchor is None else point_in_plane(load.anchor, direction)
        return Tie(name, load.force, at, way, anchor, load.both, load.block)
    if isinstance(load.force, tuple):
        return Force(name, load.force, at, load.block)
    assert way is not None  # the schema asks for it
    return Force(name, (load.force * way[0], load.force * way[1]), at, load.block)
