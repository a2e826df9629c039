"""Candidates for selection: what a catalogue keeps of a record, its measures and 5 % spectrum beside its metadata."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import asdict, dataclass, fields
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from records.formats.header import NO_OVERRIDES, HeaderOverrides
from records.reading import read_with_overrides
from records.record import Record, is_vertical
from records.response import measures, response_spectrum
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
    def horizontal_at_surface(self) -> bool:
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
    rows = [{name: getattr(each, name) for name in columns} | dict(each.measures) for each in candidates]
    return DataFrame(rows, columns=None if rows else columns)


def sequence_number(path: str) -> int | None:
    """Return the NGA number in a PEER file name, `RSN57_SFERN_ORR021.AT2`; None where there is none."""
    found = SEQUENCE_NUMBER.search(path.rsplit("/", 1)[-1])
    return int(found[1]) if found and len(found[1]) < 10 else None


FEW = 24  # files that are read here rather than by an executor, whose workers take seconds to start
T = TypeVar("T")
R = TypeVar("R")


def read_candidates(
    files: Sequence[Path], *, overrides: HeaderOverrides = NO_OVERRIDES, executor: Executor | None = None
) -> tuple[Candidate, ...]:
    """Read every record of `files`, in order, without a catalogue.

    Parameters
    ----------
    files : record files
    overrides : for what their headers leave out
    executor : of processes, that read where files are many

    Raises
    ------
    RecordError : for the first file that cannot be read
    """
    return tuple(
        candidate
        for candidates in map_files(partial(_describe_file, overrides=overrides), files, executor=executor)
        for candidate in candidates
    )


def describe_record(
    record: Record, path: str, position: int = 0, *, overrides: HeaderOverrides = NO_OVERRIDES
) -> Candidate:
    """Return what a catalogue keeps of a record, with the overrides its file was read with."""
    return Candidate(
        path=path,
        position=position,
        id=record.id,
        event=record.event,
        station=record.station,
        component=record.component,
        date=record.earthquake.time,
        magnitude=record.earthquake.magnitude,
        distance=record.distance,
        vs30=record.site.vs30,
        place=record.site.place,
        nga=sequence_number(path),
        dt=record.dt,
        npts=record.npts,
        measures=asdict(measures(record)),
        spectrum=response_spectrum(record, PERIODS, damping=DAMPING),
        overrides=overrides,
    )


def map_files(function: Callable[[T], R], files: Sequence[T], *, executor: Executor | None) -> Iterable[R]:
    """Apply a function to each file, in order; by the executor where there are many."""
    if executor is None or len(files) <= FEW:
        return map(function, files)
    return executor.map(function, files, chunksize=4)


def _describe_file(file: Path, *, overrides: HeaderOverrides) -> tuple[Candidate, ...]:
    return tuple(
        describe_record(record, str(file), i, overrides=overrides)
        for i, record in enumerate(read_with_overrides(file, overrides))
    )
