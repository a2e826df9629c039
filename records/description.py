"""What a catalogue keeps of a record: measures and 5 % spectrum beside its metadata."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import Executor
from dataclasses import asdict
from functools import partial
from pathlib import Path
from typing import TypeVar

from records.candidates import DAMPING, PERIODS, Candidate, sequence_number
from records.formats.header_overrides import NO_OVERRIDES, HeaderOverrides
from records.intensity import measures
from records.reading import read_with
from records.record import Record
from records.response import response_spectrum

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
        one
        for made in map_files(partial(_describe_file, overrides=overrides), files, executor=executor)
        for one in made
    )


def _describe_file(file: Path, *, overrides: HeaderOverrides) -> tuple[Candidate, ...]:
    return tuple(
        describe_record(record, str(file), i, overrides=overrides)
        for i, record in enumerate(read_with(file, overrides))
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


def map_files(verb: Callable[[T], R], things: Sequence[T], *, executor: Executor | None) -> Iterable[R]:
    """Apply a function to each file, in order; by the executor where there are many."""
    if executor is None or len(things) <= FEW:
        return map(verb, things)
    return executor.map(verb, things, chunksize=4)
