"""Accelerations written as numbers alone that look as if g had been meant."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from scipy.constants import g

from assess.message import Message, Quantity, warning
from assess.project.messages import Key, look_up, written

WEAK = 0.1 * g  # m/s2: below it a number alone was rather meant in g
SPECTRUM: Key = ("site", "spectrum")
PLACES: tuple[Key, ...] = (("site", "pga"), *((*SPECTRUM, key) for key in ("s_ds", "s_d1", "s_s", "s_1", "a_g")))


def bare_numbers(raw: Mapping[str, Any]) -> Iterator[Message]:
    """A notice for each acceleration of the ground in the file that is a plain number, and hardly an earthquake."""
    levels = look_up(raw, ("analysis", "levels"))[1] or ()
    rows = look_up(raw, (*SPECTRUM, "hazard"))[1] or ()
    listed: list[Key] = [("analysis", "levels", place) for place in range(len(levels))]
    listed += [(*SPECTRUM, "hazard", place, "a_g") for place in range(len(rows))]
    for key in (*PLACES, *listed):
        value = look_up(raw, key)[1]
        if isinstance(value, int | float) and value < WEAK:
            given, as_g = Quantity(value, "acceleration"), Quantity(value / g, "ground acceleration", 3)
            yield warning("unit", written(key), given=given, as_g=as_g, number=Quantity(value))
