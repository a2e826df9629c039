"""Arrival times: whether a record's peak comes when waves of its earthquake can reach the site."""

from __future__ import annotations

from datetime import datetime
from math import asin, cos, hypot, radians, sin, sqrt

import numpy as np

from assess.messages.message import Message, Quantity, warning
from records.record import Record

EARTH = 6_371_000.0  # m, mean radius
FASTEST, SLOWEST = 8_500.0, 500.0  # m/s, of P waves below the crust and of surface waves in soft basins
CLOCK, RUPTURE = 5.0, 60.0  # s, of clocks and origins, and of how long the source of a large earthquake lasts


def arrival_warning(record: Record) -> Message | None:
    """Return a warning where the peak comes earlier or later after the earthquake's origin than waves take."""
    origin, start, distance = _instant(record.earthquake.time), _instant(record.start), _distance(record)
    if origin is None or start is None or distance is None:
        return None
    after = (start - origin).total_seconds() + record.dt * int(np.argmax(np.abs(record.acceleration)))
    earliest = hypot(distance, record.earthquake.depth or 0.0) / FASTEST - CLOCK
    latest = distance / SLOWEST + RUPTURE + CLOCK
    if earliest <= after <= latest:
        return None
    return warning(
        "peak-time",
        after=Quantity(after, "time"),
        distance=Quantity(distance, "distance"),
        earliest=Quantity(max(earliest, 0.0), "time", 3),
        latest=Quantity(latest, "time", 3),
    )


def _distance(record: Record) -> float | None:
    """Return the distance of the site from the epicentre [m], as given or by the two places; None where unknown."""
    if record.distance is not None:
        return record.distance
    places = (record.earthquake.latitude, record.earthquake.longitude, record.site.latitude, record.site.longitude)
    known = [radians(each) for each in places if each is not None]
    if len(known) < len(places):
        return None
    lat, lon, site_lat, site_lon = known
    half = sin((site_lat - lat) / 2.0) ** 2 + cos(lat) * cos(site_lat) * sin((site_lon - lon) / 2.0) ** 2
    return 2.0 * EARTH * asin(sqrt(min(half, 1.0)))  # haversine


def _instant(text: str) -> datetime | None:
    """Return a time of ISO 8601 with its hour; None for a date alone, or nothing."""
    try:
        return datetime.fromisoformat(text) if "T" in text else None
    except ValueError:
        return None
