"""What the header of a COSMOS channel says in words, again in numbers, and in the samples below.

Source: COSMOS strong-motion data format v1.20 (2001), tables of text, integer and real header values.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from assess.messages.message import Message
from records.formats.agreement import (
    check_duration,
    check_same,
    check_time_of_peak,
    describe_disagreement,
    disagreement,
)
from records.formats.corners import nyquist_warning
from records.formats.samples import number
from records.formats.times import iso
from spectra.arrays import FloatArray

UNKNOWN = -999.0
NUMBER = "number in the header"
AZIMUTH, STARTED = 53, 39  # indices of integers, from 0: year, day of the year, month, day, hour, minute
SITE, EPICENTRE, SECONDS, HIGHEST = 0, 9, 29, 25  # of reals
LENGTH, PEAK, TIME = 62, 63, 64

CHANNEL = re.compile(r"Sta\s+Cha?n?\s*:?\s*[\w?]*\s*:\s*(\d+)\s*deg", re.IGNORECASE)
PROCESSED = re.compile(r"Processed.*\bMax\s*=\s*([-+\d.]+)\s+\S+\s+at\s+([\d.]+)\s*sec", re.IGNORECASE)
PLACES = (
    ("latitude", "longitude", re.compile(r"Coords:\s*([-+\d.]+)[\s,]+([-+\d.]+)"), SITE),
    (
        "epicentre's latitude",
        "epicentre's longitude",
        re.compile(r"Hypocenter:\s*([-+\d.]+)[\s,]+([-+\d.]+)"),
        EPICENTRE,
    ),
)
RECORDER = re.compile(r"Rcrd start time:\s*(\d+)/(\d+)/(\d+)[,\s]+(\d+):(\d+):([\d.]+)")
FILTER = re.compile(r"Record filtered below.*\babove\s+([\d.]+)\s*Hz", re.IGNORECASE)


def check_header(
    text: Sequence[str],
    integers: FloatArray,
    reals: FloatArray,
    samples: FloatArray,
    dt: float,
    *,
    path: Path,
    line: int,
) -> list[Message | None]:
    """Refuse step [s], length, peak and azimuth that are not the same everywhere; return warnings about the rest.

    Parameters
    ----------
    text : every line above the samples; it begins on `line`
    integers, reals : its numbers
    samples : accelerations as printed [n]
    """
    words = "\n".join(text)
    where = f"line {line}: the header's"
    check_duration(f"{where} length", _known(reals, LENGTH), size=samples.size, dt=dt, slack=0.006, path=path)
    check_time_of_peak(_known(reals, TIME), samples, dt, slack=0.006, path=path)
    processed, channel = PROCESSED.search(words), CHANNEL.search(words)
    peak, when = (number(processed[1]), number(processed[2])) if processed else (None, None)
    check_same(f"{where} peak", peak, "real value 64", _known(reals, PEAK), slack=0.002, path=path)
    check_same(f"{where} time of the peak", when, "real value 65", _known(reals, TIME), slack=0.006, path=path)
    azimuth = _known(integers, AZIMUTH)
    printed = number(channel[1]) if channel else None
    if printed is not None and azimuth is not None and 0.0 < azimuth <= 360.0:
        check_same(f"{where} azimuth", printed % 360.0, "integer value 54", azimuth % 360.0, slack=1.0, path=path)
    passed = FILTER.search(words)
    return [
        *_places(words, reals),
        _start(words, integers, reals),
        nyquist_warning(number(passed[1]) if passed else None, dt),
    ]


def _known(values: FloatArray, index: int) -> float | None:
    return number(str(values[index]), unknown=(UNKNOWN,)) if index < values.size else None


def _places(words: str, reals: FloatArray) -> Iterator[Message | None]:
    """Yield warnings about where the site and the epicentre are, sign and all."""
    for *names, pattern, at in PLACES:
        found = pattern.search(words)
        for i, name in enumerate(names):
            printed = number(found[i + 1]) if found else None
            yield disagreement(name, printed, NUMBER, _known(reals, at + i), slack=1e-3)


def _start(words: str, integers: FloatArray, reals: FloatArray) -> Message | None:
    """Return a warning about when the recorder started, to the second."""
    found = RECORDER.search(words)
    seconds, numbers = _known(reals, SECONDS), [_known(integers, STARTED + i) for i in (0, 2, 3, 4, 5)]
    if found is None or seconds is None or None in numbers:
        return None
    again = iso(*(f"{each:.0f}" for each in numbers), str(seconds))
    one, two, three, *clock = found.groups()
    printed = iso(one, two, three, *clock) if len(one) == 4 else iso(three, one, two, *clock)
    return describe_disagreement("start", printed, NUMBER, again) if printed[:19] != again[:19] else None
