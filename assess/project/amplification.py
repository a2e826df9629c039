"""The key `amplification` of a mechanism and the table [building] as what `assess.study.amplification` takes."""

from __future__ import annotations

from assess.project import sections
from assess.project.definitions import fill
from assess.study.amplification import AmplificationChoice, Structure


def amplification_method_of(section: sections.Mechanism) -> AmplificationChoice | None:
    """Return the key `amplification` of a mechanism; None for the ground's motion as it is."""
    asked = section.amplification
    return None if isinstance(asked, sections.NoAmplification) else fill(AmplificationChoice, asked)


def structure_of(building: sections.Building | None) -> Structure:
    """Return what the table [building] says of the structure below a mechanism; its period only where it is given."""
    if building is None:
        return Structure()
    return fill(Structure, building, period=building.period if building.has_key("period") else None)
