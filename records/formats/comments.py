"""What our CSV files say of a record above its columns, in comments: `# magnitude: 6.9`, `# distance [km]: 12.5`."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import takewhile
from math import degrees, radians
from typing import Any

from records.formats.samples import number
from records.orientation import azimuth_of
from records.record import Earthquake, Record, Site
from spectra.formulas import mark_formulas, unmark_formulas

COMMENT = re.compile(r"\s*#\s*([a-z][a-z0-9 ]*(?:\[[^\]]*\])?)\s*:\s*(.*?)\s*")
LONGEST = 2000  # characters of a comment
KNOWN: Mapping[str, Callable[[Record], str | float | None]] = {
    "event": lambda record: record.event,
    "origin": lambda record: record.earthquake.time,
    "magnitude": lambda record: record.earthquake.magnitude,
    "magnitude type": lambda record: record.earthquake.scale,
    "event latitude [deg]": lambda record: record.earthquake.latitude,
    "event longitude [deg]": lambda record: record.earthquake.longitude,
    "event depth [km]": lambda record: _times(0.001, record.earthquake.depth),
    "distance [km]": lambda record: _times(0.001, record.distance),
    "station": lambda record: record.station,
    "station latitude [deg]": lambda record: record.site.latitude,
    "station longitude [deg]": lambda record: record.site.longitude,
    "station elevation [m]": lambda record: record.site.elevation,
    "vs30 [m/s]": lambda record: record.site.vs30,
    "ground": lambda record: record.site.ground,
    "place": lambda record: record.site.place,
    "component": lambda record: record.component,
    "azimuth [deg]": lambda record: None if record.azimuth is None else degrees(record.azimuth),
    "samples": lambda record: float(record.npts),
    "trail": lambda record: "; ".join(map(str, record.processing_history)),
}
"""What is written, in this order, where it is known."""


def comments(record: Record) -> Iterator[str]:
    """Yield a line for each thing that is known of `record`."""
    for key, of in KNOWN.items():
        value = of(record)
        text = f"{value:.12g}" if isinstance(value, float | int) else value
        if text:
            yield f"# {key}: {mark_formulas(_on_one_line(text))}\n"


def parse_comments(lines: Sequence[str]) -> dict[str, str]:
    """Parse the comments before the first row, by key."""
    above = takewhile(lambda line: not line.strip() or line.lstrip().startswith("#"), lines)
    found = (COMMENT.fullmatch(line) for line in above)
    return {match[1]: unmark_formulas(match[2])[:LONGEST] for match in found if match}


def record_fields(text: Mapping[str, str]) -> dict[str, Any]:
    """Return the fields of a record for `make_record`; a number that cannot be read or cannot be is unknown."""
    known = {key: number(text.get(key, "")) for key in KNOWN}
    component, azimuth = text.get("component", ""), known["azimuth [deg]"]
    return {
        "event": text.get("event", ""),
        "station": text.get("station", ""),
        "component": component,
        "azimuth": azimuth_of(component) if azimuth is None else radians(azimuth % 360.0),
        "distance": _times(1000.0, known["distance [km]"]),
        "earthquake": Earthquake(
            time=text.get("origin", ""),
            magnitude=known["magnitude"],
            scale=text.get("magnitude type", ""),
            latitude=known["event latitude [deg]"],
            longitude=known["event longitude [deg]"],
            depth=_times(1000.0, known["event depth [km]"]),
        ),
        "site": Site(
            latitude=known["station latitude [deg]"],
            longitude=known["station longitude [deg]"],
            elevation=known["station elevation [m]"],
            vs30=known["vs30 [m/s]"],
            ground=text.get("ground", ""),
            place=text.get("place", ""),
        ),
    }


def _times(factor: float, value: float | None) -> float | None:
    return None if value is None else float(f"{factor * value:.12g}")


def _on_one_line(text: str) -> str:
    """Return `text` without line breaks and control characters, cut."""
    return "".join(c if c.isprintable() else " " for c in text)[:LONGEST]
