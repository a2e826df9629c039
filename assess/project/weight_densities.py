"""Densities that a project file gives as weights per volume, like "20 kN/m^3": read, and said to have been read so."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from assess.messages.message import Message, Quantity, note
from assess.project.key_text import key_text, look_up
from assess.project.keys import places_of
from assess.project.sections.content import Content
from assess.project.units import KINDS, is_weight

DENSITY = KINDS["density"]


def weight_density_messages(content: Content, raw: Mapping[str, Any]) -> Iterator[Message]:
    """Note each density of the `raw` file that is a weight per volume."""
    for place in places_of(content).values():
        typed = look_up(raw, place.path)[1] if place.kind == DENSITY else None
        if isinstance(typed, str) and is_weight(typed, DENSITY):
            density = Quantity(place.value, "density", 6)
            yield note("weight-density", key_text(place.path), given=typed, density=density)
