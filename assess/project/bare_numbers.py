"""Numbers alone that look as if another unit had been meant: accelerations in g, sizes of boxes in mm."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from scipy.constants import g

from assess.message import Message, Quantity, warning
from assess.project.messages import Key, look_up, written

HUGE = 60.0  # m: a box larger than this, by a number alone, was rather meant in mm or cm
WEAK = 0.1 * g  # m/s2: below it a number alone was rather meant in g
SPECTRUM: Key = ("site", "spectrum")
PLACES: tuple[Key, ...] = (("site", "pga"), *((*SPECTRUM, key) for key in ("s_ds", "s_d1", "s_s", "s_1", "a_g")))


def bare_numbers(raw: Mapping[str, Any]) -> Iterator[Message]:
    """A notice for each plain number of the file that is hardly an earthquake, or hardly the size of a wall."""
    yield from _weak(raw)
    yield from _huge(raw)


def _huge(raw: Mapping[str, Any]) -> Iterator[Message]:
    bodies = look_up(raw, ("bodies",))[1]
    for name in bodies if isinstance(bodies, Mapping) else ():
        for size in ("thickness", "length", "height"):
            key: Key = ("bodies", name, "box", size)
            value = look_up(raw, key)[1]
            if isinstance(value, int | float) and value > HUGE:
                yield warning("box-size", written(key), given=Quantity(value, "length"), number=Quantity(value))


def _weak(raw: Mapping[str, Any]) -> Iterator[Message]:
    levels = look_up(raw, ("analysis", "levels"))[1] or ()
    rows = look_up(raw, (*SPECTRUM, "hazard"))[1] or ()
    listed: list[Key] = [("analysis", "levels", place) for place in range(len(levels))]
    listed += [(*SPECTRUM, "hazard", place, "a_g") for place in range(len(rows))]
    for key in (*PLACES, *listed):
        value = look_up(raw, key)[1]
        if isinstance(value, int | float) and value < WEAK:
            given, as_g = Quantity(value, "acceleration"), Quantity(value / g, "ground acceleration", 3)
            yield warning("unit", written(key), given=given, as_g=as_g, number=Quantity(value))
