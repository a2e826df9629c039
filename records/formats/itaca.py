"""ITACA's corrected accelerograms (`.cor.acc`): nine `Key : value` lines, a line with the unit, five values a line.

    Time Increment (s)            : 0.005
    Number of Data                : 23709
    PGA (m/s/s)                   : 6.7694000E-01
    Accelaration time series in m/s/s

The misspelling is the format's own.
"""

from __future__ import annotations

import re
from pathlib import Path

from assess.messages.message import note
from records.errors import RecordError
from records.formats.header import HeaderOverrides, check_count, check_peak, filter_warning, iso_time_of_text
from records.formats.samples import acceleration_factor, number, positive_number, text_lines, uniform_numbers
from records.record import Earthquake, Record, StationSite, azimuth_of, make_record, usable_period

NAME = "ITACA cor.acc"

SERIES = re.compile(r"\s*Accel[ae]ration time series in (\S+)\s*", re.IGNORECASE)
LONGEST_HEADER = 30
NEEDED = ("Time Increment (s)", "Number of Data")


def looks_like(head: bytes) -> bool:
    """Return whether a file that begins with `head` is a cor.acc: the line above the values, with the unit."""
    return any(SERIES.fullmatch(line) for line in head.decode("latin-1").splitlines()[:LONGEST_HEADER])


def read(path: Path, overrides: HeaderOverrides) -> tuple[Record, ...]:
    """Return the one record in the file at `path`; its header says all that is needed.

    Raises RecordError, naming the file, for a key that is absent, a count or peak that the samples do not have.
    """
    lines = text_lines(path)
    after = next((i + 1 for i, line in enumerate(lines[:LONGEST_HEADER]) if SERIES.fullmatch(line)), 0)
    found = SERIES.fullmatch(lines[after - 1]) if after else None
    text = _header(lines[: max(after - 1, 0)])
    absent = [key for key in NEEDED if key not in text]
    if found is None or absent:
        raise RecordError(f"{path}: the header of {NAME} has no {(*absent, 'unit')[0]}; it is cut short or damaged")
    factor = acceleration_factor(found[1], line=after, path=path)
    dt = positive_number(text["Time Increment (s)"], name="Time Increment", line=after, path=path)
    samples, uneven = uniform_numbers(lines[after:], first=after + 1, path=path)
    check_count(text["Number of Data"], samples.size, path=path, name="Number of Data")
    peak = check_peak(number(text.get("PGA (m/s/s)", "")), factor * samples, unit="m/s2", digits=1e-9, path=path)
    component = text.get("Orientation", "")
    cut = text.get("Filter Cut-off Frequency (Hz)", "")
    low, _, high = cut.partition(" - ")
    return (
        make_record(
            path.stem,
            factor * samples,
            dt,
            path=str(path),
            station=text.get("Station Code / Name", ""),
            component=component,
            processing_history=(
                note("read-from", format=NAME, unit=found[1]),
                *([note("filtered-by-source-as", corners=cut)] if cut else []),
            ),
            azimuth=azimuth_of(component),
            earthquake=Earthquake(time=iso_time_of_text(text.get("Event Date & Time", ""))),
            site=StationSite(),
            longest_period=usable_period(number(low)),
            warnings=(uneven, peak, filter_warning(samples, dt, low=number(low), high=number(high))),
        ),
    )


def _header(lines: list[str]) -> dict[str, str]:
    """Return the value of each key."""
    parts = (line.partition(" : ") for line in lines)
    return {key.strip(): value.strip() for key, _, value in parts}
