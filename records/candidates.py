"""Candidates for selection: earthquake, site, measures and 5 % spectrum at fixed periods of a record."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING

import numpy as np

from records.formats.header_overrides import NO_OVERRIDES, HeaderOverrides
from records.orientation import is_vertical
from spectra.arrays import FloatArray

if TYPE_CHECKING:
    from pandas import DataFrame

DAMPING = 0.05
PERIODS: FloatArray = np.geomspace(0.01, 10.0, 121)  # s, forty to the decade
PERIODS.flags.writeable = False

DAY = re.compile(r"\d{4}-\d\d-\d\d")
SEQUENCE_NUMBER = re.compile(r"RSN(\d+)_", re.IGNORECASE)


@dataclass(frozen=True)
class Candidate:
    """One component of a recording, as a catalogue describes it.

    path : of its file, relative to the folder of the catalogue, or as the caller wrote it
    position : of the record in its file, from 0; id, event, station, component : as in the record
    date : of the earthquake, ISO 8601, as far as known, "" unknown
    magnitude : [-]; distance [m]: to the rupture where a flatfile gives it, else as the file has it; vs30 [m/s]
    place : location of the instrument in the ground or a structure, "" for the free surface or unknown
    nga : number of the recording in the PEER NGA database; None where any of these four is unknown
    dt [s], npts, measures : by name, SI ("pga" [m/s2], "d5_95" [s], …)
    spectrum : 5 % pseudo-acceleration at PERIODS [k] [m/s2]
    overrides : what its file does not say and the caller did when it was read
    """

    path: str
    position: int
    id: str
    event: str
    station: str
    component: str
    date: str
    magnitude: float | None
    distance: float | None
    vs30: float | None
    place: str
    nga: int | None
    dt: float
    npts: int
    measures: Mapping[str, float]
    spectrum: FloatArray
    overrides: HeaderOverrides = NO_OVERRIDES

    @property
    def earthquake(self) -> str:
        """What two records of one earthquake have in common: its day; else its name and year; else its file.

        Names differ from one agency to another; that two earthquakes of one day count as one is on the safe side.
        """
        if DAY.match(self.date):
            return f"day {self.date[:10]}"
        name = re.sub(r"[^a-z0-9]+", "", self.event.lower())
        return f"{name} {self.date[:4]}".strip() or f"file {self.path}"

    @property
    def recording(self) -> str:
        """What the components of one recording have in common: NGA number, or earthquake and station; else its file."""
        if self.nga is not None:
            return f"nga {self.nga}"
        station = re.sub(r"[^a-z0-9]+", "", self.station.lower())
        return f"{self.earthquake} at {station}" if station else f"file {self.path}"

    @property
    def shakes(self) -> bool:
        """Whether it is a horizontal component at the free surface, as far as its file says."""
        return not self.place and not is_vertical(self.component)


def candidate_table(candidates: Sequence[Candidate]) -> DataFrame:
    """Return a table of the candidates: a row each, with what they are selected by and their measures, in SI.

    Parameters
    ----------
    candidates : of a catalogue or read from files [n]

    Returns
    -------
    DataFrame : metadata and measures as columns named as in `Candidate` and `Measures` [n rows]; the 5 % spectra are
        left out
    """
    from pandas import DataFrame

    columns = [field.name for field in fields(Candidate) if field.name not in ("measures", "spectrum", "overrides")]
    rows = [{name: getattr(one, name) for name in columns} | dict(one.measures) for one in candidates]
    return DataFrame(rows, columns=None if rows else columns)


def sequence_number(path: str) -> int | None:
    """Return the NGA number in a PEER file name, `RSN57_SFERN_ORR021.AT2`; None where there is none."""
    found = SEQUENCE_NUMBER.search(path.rsplit("/", 1)[-1])
    return int(found[1]) if found and len(found[1]) < 10 else None
