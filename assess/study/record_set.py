"""Sets of records: what files and catalogues offer, the suite that is chosen, and what to know of both."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from assess.messages.message import Message, locate, warning, whole_number
from assess.study.study import Fitting, GivenFactors
from records import catalogue
from records.band import Band
from records.candidates import Candidate
from records.compliance.making import CodeName
from records.description import read_candidates
from records.fingerprints import target_mark
from records.flatfile import BadCell, read_flatfile
from records.flatfile_match import FlatfileMatch, describe_candidates, match_flatfile
from records.formats.header_overrides import NO_OVERRIDES, HeaderOverrides
from records.indexing import index
from records.paths import relative_path
from records.plausibility import record_doubts, warnings_among
from records.reading import read_with
from records.record import Record
from records.scaling import SCALING_PERIODS
from records.selection import Selection
from spectra.spectrum import Spectrum

EVERYWHERE = Band(np.array(SCALING_PERIODS), np.ones(len(SCALING_PERIODS)), np.array(SCALING_PERIODS))
MOST_NAMED = 3  # files, cells or records that a warning names
LONGEST = 30  # characters of a cell that are shown


@dataclass(frozen=True)
class RecordSet:
    """Records as read, and how they are scaled."""

    records: tuple[Record, ...]
    fitting: Fitting


@dataclass(frozen=True)
class Offer:
    """Records to choose from, with absolute paths, what was not read, and what became of a flatfile."""

    candidates: tuple[Candidate, ...]
    problems: tuple[tuple[str, str], ...]
    merged: FlatfileMatch | None = None


def candidate_records(
    files: Sequence[Path],
    *,
    overrides: HeaderOverrides = NO_OVERRIDES,
    flatfile: Path | None = None,
    kept: Path | None = None,
    executor: Executor | None = None,
) -> Offer:
    """Collect every record of files and of the catalogues of folders, brought up to date.

    Parameters
    ----------
    files : files and folders of records
    overrides : what files do not state themselves
    flatfile : magnitudes and distances of the recordings
    kept : file of the catalogue of the one folder, if it is not in the folder
    executor : processes that share the reading of many files

    Returns
    -------
    The candidates, and the files of folders that cannot be read

    Raises
    ------
    RecordError : a file that is named cannot be read
    """
    found: list[Candidate] = []
    problems: list[tuple[str, str]] = []
    table = None if flatfile is None else read_flatfile(flatfile)
    for place in (path for path in files if path.is_dir()):
        with catalogue.open_catalogue(kept or catalogue_of(place)) as connection:
            indexed = index(place, connection, overrides=overrides, executor=executor)
            problems += [(str(place / path), why) for path, why in indexed.problems]
            listed = catalogue.candidates(connection)
        found += [replace(one, path=str(catalogue.path_inside(place, one.path))) for one in listed]
    alone = [path for path in files if not path.is_dir()]
    made = read_candidates(alone, overrides=overrides, executor=executor)
    offer = (*found, *made)
    if table is None:
        return Offer(offer, tuple(problems))
    return Offer(describe_candidates(offer, table.recordings), tuple(problems), match_flatfile(offer, table))


def catalogue_of(folder: Path) -> Path | None:
    """Return the file of a folder's catalogue; None, in memory alone, if the folder cannot be written."""
    file = folder / catalogue.NAME
    return file if os.access(folder, os.W_OK) else None


def record_set(found: Selection, over: Band, *, folder: Path) -> RecordSet:
    """Read the records of a selection from their files; identical ids are numbered.

    Parameters
    ----------
    found : the selection
    over : the periods over which it was selected, with weights
    folder : paths are written relative to it
    """
    parts = [(choice, one) for choice in found.choices for one in choice.components]
    records = with_unique_names([_record(one, folder=folder) for _, one in parts])
    by_choice: dict[int, list[str]] = {}
    for (choice, _), record in zip(parts, records, strict=True):
        by_choice.setdefault(id(choice), []).append(record.id)
    fitting = Fitting(
        band=over,
        together=tuple(tuple(ids) for ids in by_choice.values() if len(ids) > 1),
        selection=found,
        nga=tuple((r.id, one.nga) for r, (_, one) in zip(records, parts, strict=True) if one.nga is not None),
    )
    return RecordSet(records, fitting)


def with_given_factors(suite: RecordSet, found: Selection, spectrum: Spectrum, *, code: CodeName) -> RecordSet:
    """Give the records of a selection the factors of its choices, which do not follow from the target alone.

    Parameters
    ----------
    suite : the records of the selection
    found : the selection
    spectrum : the target that the factors refer to
    code : whose rules the suite was made to meet, as `select.for` names it
    """
    factors = [choice.factor for choice in found.choices for _ in choice.components]
    ids = [record.id for record in suite.records]
    given = GivenFactors(tuple(zip(ids, factors, strict=True)), target_mark(spectrum), code=code)
    return replace(suite, fitting=replace(suite.fitting, given=given))


def read_candidate(one: Candidate) -> Record:
    """Read the record of a candidate from its file."""
    return read_with(Path(one.path), one.overrides)[one.position]


def _record(one: Candidate, *, folder: Path) -> Record:
    """Read the record of a candidate, with the data of a flatfile, and its path as the project file writes it."""
    record = read_candidate(one)
    return replace(
        record,
        path=relative_path(Path(one.path), folder),
        event=one.event,
        station=one.station,
        distance=one.distance,
        earthquake=replace(record.earthquake, time=one.date, magnitude=one.magnitude),
        site=replace(record.site, vs30=one.vs30),
    )


def offer_messages(offer: Offer) -> Iterator[Message]:
    """What to know of the files that were not read, and of a flatfile that does not fit."""
    yield from _first(
        [warning("file-not-read", "records.files", file=str(path), why=str(why)) for path, why in offer.problems],
        "files-not-read",
    )
    if offer.merged is not None:
        yield from locate(() if offer.merged.warning is None else (offer.merged.warning,), "records.flatfile")
        yield from _first([cell_message(cell) for cell in offer.merged.bad], "cells-ignored")


def cell_message(cell: BadCell) -> Message:
    """A cell of a flatfile that was passed over."""
    row, value = whole_number(cell.row), cell.value[:LONGEST]
    return warning("cell-ignored", "records.flatfile", row=row, column=cell.column, value=value)


def record_messages(records: Sequence[Record]) -> Iterator[Message]:
    """Which records have peaks or steps that ground hardly has, or files that contradict themselves."""
    own = [warning("of-record", record=record.id, what=what) for record in records for what in record_doubts(record)]
    yield from _first(locate([*own, *warnings_among(records)], "records.unit"), "of-further-records")


def _first(messages: Sequence[Message], key: str) -> Iterator[Message]:
    """Yield the first of many messages, and how many others there are."""
    yield from messages[:MOST_NAMED]
    if len(messages) > MOST_NAMED:
        yield warning(key, messages[0].where, number=whole_number(len(messages) - MOST_NAMED))


def with_unique_names(records: Sequence[Record]) -> tuple[Record, ...]:
    """The records, a second one of the same id numbered "id (2)", and so on."""
    seen: dict[str, int] = {}
    named = []
    for record in records:
        seen[record.id] = seen.get(record.id, 0) + 1
        again = seen[record.id]
        named.append(record if again == 1 else replace(record, id=f"{record.id} ({again})"))
    return tuple(named)
