"""Dates and times of headers as ISO 8601."""

from __future__ import annotations

import re
from datetime import UTC, datetime, timedelta

DAY_FIRST = re.compile(r"\s*\d{1,2}/\d{1,2}/\d{4}\b")
NUMBERS = re.compile(r"\d+(?:\.\d+)?")


def iso(year: str, month: str, day: str, *clock: str, ahead: float = 0.0) -> str:
    """Return a date as ISO 8601 from its parts as printed, like "2018-01-24T10:51:00Z"; the date alone without a clock.

    ahead : hours before UTC. "" for what is no date.
    """
    try:
        at = datetime(int(year), int(month), int(day), tzinfo=UTC)
        hours, minutes, seconds = (float(part) for part in (*clock, "0", "0", "0")[:3])
        at += timedelta(hours=hours - ahead, minutes=minutes, seconds=seconds)
    except (ValueError, OverflowError):
        return ""
    if not clock:
        return at.strftime("%Y-%m-%d")
    return at.strftime("%Y-%m-%dT%H:%M:%S") + f".{at.microsecond // 1000:03d}".rstrip("0").rstrip(".") + "Z"


def iso_of(text: str, *, ahead: float = 0.0) -> str:
    """Return the same from text in the order year, month, day, hour, minute, second, whatever separates the numbers.

    "20/07/2017 22:30:59", with the year in third place, has the day first.
    """
    compact = re.fullmatch(r"(\d{4})(\d\d)(\d\d)[ _T]*(?:(\d\d)(\d\d)(\d\d(?:\.\d+)?))?", text.strip())
    parts = [part for part in compact.groups() if part] if compact else NUMBERS.findall(text)
    if DAY_FIRST.match(text):
        parts[:3] = parts[2::-1]
    return iso(*parts[:6], ahead=ahead) if len(parts) >= 3 else ""
