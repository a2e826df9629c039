"""Where the ground is, by the tables [building] and [mechanisms.NAME] and the lowest body."""

from __future__ import annotations

from collections.abc import Mapping

from assess.geometry.solid import Solids
from assess.mechanisms.mechanism import Mechanism
from assess.model.definitions import Definition
from assess.project import sections
from assess.study.grounding import Ground, Grounded, lowest_of, stand_on


def ground_of(building: sections.Building | None, definitions: Mapping[str, Definition], solids: Solids) -> Ground:
    """Return what the project says of the ground."""
    lowest = lowest_of(definitions, solids)
    if building is None:
        return Ground(lowest=lowest)
    return Ground(building.ground_elevation, lowest, building.height or 0.0)


def base_elevation_of(section: sections.Mechanism) -> float | None:
    """Return the elevation of the base above the ground [m] that the table of a mechanism gives for it alone."""
    return section.base_elevation if isinstance(section, sections.Chained) else None


def ground_mechanism(section: sections.Mechanism, mechanism: Mechanism, ground: Ground) -> Grounded:
    """Return where a mechanism stands over the ground."""
    by_table = isinstance(section, sections.EquivalentBlock) and section.has_key("elevation")
    return stand_on(ground, mechanism, base_elevation=base_elevation_of(section), by_table=by_table)
