"""K-NET and KiK-net: seventeen lines of header, then counts, eight to a line, of one component.

    Scale Factor      3920(gal)/6182761
    Max. Acc. (gal)   11.971

Acceleration is count times scale factor less the mean of the record, which is the instrument's offset and far larger
than most motions; so says NIED (K-NET ASCII format, https://www.kyoshin.bosai.go.jp). Times are Japan Standard Time,
nine hours ahead of UTC. KiK-net numbers its six components: 1-3 in the borehole, 4-6 at the surface, each NS, EW, UD.
"""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from assess.messages.message import Quantity, note
from records.errors import RecordError
from records.formats.header import HeaderOverrides, check_count, check_peak, iso_time_of_text
from records.formats.samples import acceleration_factor, check_layout, number, numbers, positive_number, text_lines
from records.record import Earthquake, Record, StationSite, azimuth_of, make_record

NAME = "K-NET/KiK-net"
HEADER_LINES = 17
KEY_WIDTH = 18
GAL = 0.01  # m/s2
AHEAD = 9.0  # hours of Japan Standard Time before UTC
NUMBERED = {"1": "NS1", "2": "EW1", "3": "UD1", "4": "NS2", "5": "EW2", "6": "UD2"}
NAMED = {"NS": "N-S", "EW": "E-W", "UD": "U-D"}  # endings of the files of K-NET; those of KiK-net are NUMBERED

SCALE = re.compile(r"([0-9.eE+-]+)\s*\(([^()]+)\)\s*/\s*([0-9.eE+-]+)")


def looks_like(head: bytes) -> bool:
    """Return whether a file that begins with `head` is K-NET: its first line and the line of the scale factor."""
    return head.startswith(b"Origin Time") and b"\nScale Factor" in head


def read(path: Path, overrides: HeaderOverrides) -> tuple[Record, ...]:
    """Return the one record in the file at `path`; its header says all that is needed.

    Raises RecordError, naming the file, for a header cut short, a step, scale or duration that is none, samples fewer
    than the duration says or of another peak than the header's.
    """
    lines = text_lines(path)
    header = _header(lines, path=path)
    rate = positive_number(re.sub(r"\s*Hz$", "", header["Sampling Freq(Hz)"]), name="Sampling Freq", line=11, path=path)
    unit, scale = _scale(header["Scale Factor"], path=path)
    counts = numbers(lines[HEADER_LINES:], first=HEADER_LINES + 1, path=path)
    duration = positive_number(header["Duration Time(s)"], name="Duration Time", line=12, path=path)
    check_count(f"{duration * rate:.0f}", counts.size, path=path, name=f"Duration Time of {duration:.6g} s")
    if not counts.size or not np.all(np.isfinite(counts)):
        raise RecordError(f"{path}: no samples below the header, or some that are not finite; the file is damaged")
    offset = float(np.mean(counts))
    factor = acceleration_factor(unit, line=14, path=path)
    acceleration = factor * scale * (counts - offset)
    peak = check_peak(number(header["Max. Acc. (gal)"]), acceleration / GAL, unit="gal", digits=6e-4, path=path)
    component = _component(header["Dir."], path=path)
    return (
        make_record(
            path.name,
            acceleration,
            1.0 / rate,
            path=str(path),
            station=header["Station Code"],
            component=component,
            processing_history=(
                note("read-from", format=NAME, unit=unit),
                note("mean-removed-of", mean=Quantity(scale * offset, figures=6), unit=unit),
            ),
            azimuth=azimuth_of(component),
            earthquake=_earthquake(header),
            site=_site(header, component),
            warnings=(peak, check_layout(lines[HEADER_LINES:], first=HEADER_LINES + 1, path=path)),
        ),
    )


def _header(lines: list[str], *, path: Path) -> dict[str, str]:
    """Return the value of each key."""
    header = {line[:KEY_WIDTH].strip(): line[KEY_WIDTH:].strip() for line in lines[:HEADER_LINES]}
    needed = ("Sampling Freq(Hz)", "Duration Time(s)", "Dir.", "Scale Factor", "Max. Acc. (gal)", "Station Code")
    absent = [key for key in needed if key not in header]
    if absent:
        raise RecordError(f'{path}: the header of {NAME} has no "{absent[0]}"; it is cut short or damaged')
    return header


def _component(direction: str, *, path: Path) -> str:
    """Return the component by the header, which must be that of the file's name where it ends as NIED's do."""
    component = NUMBERED.get(direction, direction)
    if component not in (*NUMBERED.values(), *NAMED.values()):
        raise RecordError(f'{path}: line 13: Dir. = "{direction[:20]}"; it must be N-S, E-W, U-D or 1 to 6')
    ending = path.suffix[1:].upper()
    named = NAMED.get(ending, ending if ending in NUMBERED.values() else component)
    if named != component:
        raise RecordError(
            f'{path}: line 13: Dir. = "{direction}" is {component}, the file is named as {named}; correct what is wrong'
        )
    return component


def _scale(text: str, *, path: Path) -> tuple[str, float]:
    """Return the unit, and one count in it."""
    found = SCALE.fullmatch(text)
    if found is None:
        raise RecordError(f'{path}: line 14: scale factor "{text[:30]}"; it must be like 3920(gal)/6182761')
    full, counts = (positive_number(found[i], name="Scale Factor", line=14, path=path) for i in (1, 3))
    return found[2].strip(), full / counts


def _earthquake(header: dict[str, str]) -> Earthquake:
    depth, magnitude = number(header.get("Depth. (km)", "")), number(header.get("Mag.", ""))
    return Earthquake(
        time=iso_time_of_text(header.get("Origin Time", ""), ahead=AHEAD),
        magnitude=magnitude,
        scale="" if magnitude is None else "MJMA",
        latitude=number(header.get("Lat.", "")),
        longitude=number(header.get("Long.", "")),
        depth=None if depth is None else 1000.0 * depth,
    )


def _site(header: dict[str, str], component: str) -> StationSite:
    return StationSite(
        latitude=number(header.get("Station Lat.", "")),
        longitude=number(header.get("Station Long.", "")),
        elevation=number(header.get("Station Height(m)", "")),
        place="borehole" if component.endswith("1") else "",
    )
