"""The ground motions of a study: records that files and catalogues offer, or artificial ones, scaled to its target."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from math import exp, log
from pathlib import Path
from statistics import mean

import numpy as np

from assess.errors import ProjectError
from assess.messages.message import Message, Quantity, locate, note, warning, whole_number
from assess.study.study import Fitting, GivenFactors, ScaledRecord, ScaleTo, Study
from assess.study.suite_rules import made_band
from records import catalogue
from records.candidates import Candidate, read_candidates
from records.compliance import CodeName
from records.compliance.asce43_05 import fit_of_mean
from records.compliance.suite import common_factor, suite_of
from records.flatfile import BadCell, FlatfileMatch, describe_candidates, match_flatfile, read_flatfile
from records.formats.header import NO_OVERRIDES, HeaderOverrides
from records.indexing import index
from records.plausibility import implausibility_warnings, warnings_among
from records.reading import read_with_overrides, relative_path
from records.record import Record, with_step
from records.scaling import SCALING_PERIODS, Band, Scaling, misfit, scale_to_pga, scale_to_spectrum, truncate_band
from records.selection import Selection, target_mark
from records.synthetic import artificial_records
from spectra.spectrum import Spectrum


def motions_of(study: Study, spectrum: Spectrum, *, jobs: int = 1) -> tuple[ScaledRecord, ...]:
    """Return every record of a study with its scaling, those of files first.

    A suite of artificial records only is raised as a whole if its mean falls short of the target, unless the study
    scales records otherwise.

    Parameters
    ----------
    study : Study
        Its records, the artificial ones to be made, and how they are scaled.
    spectrum : Spectrum
        The target.
    jobs : int
        Number of threads; 0 for all cores.

    Returns
    -------
    tuple of ScaledRecord
        In the order of the study.
    """
    made = study.artificial
    if made is None:
        return apply_record_factor(scale_records(study, study.records, spectrum), spectrum, study)
    band = made_band(study, spectrum, duration=made.duration)
    own = artificial_records(
        spectrum, count=made.count, seed=made.seed, duration=made.duration, band=band, threads=jobs
    )
    motions = scale_records(study, (*study.records, *own), spectrum)
    if not study.records and study.scale_to == "spectrum":
        motions = raise_artificial(motions, spectrum, band, fitting=study.fitting)
    return apply_record_factor(motions, spectrum, study)


def scale_records(study: Study, records: Sequence[Record], spectrum: Spectrum) -> tuple[ScaledRecord, ...]:
    """Return the records as the study scales them."""
    given = study.fitting.given
    if given is not None:
        return apply_given_factors(records, spectrum, given, band=study.fitting.band)
    return scale_together(records, spectrum, study.fitting, scale_to=study.scale_to)


def apply_given_factors(
    records: Sequence[Record], spectrum: Spectrum, given: GivenFactors, *, band: Band
) -> tuple[ScaledRecord, ...]:
    """Scale each record by its given factor, times the PGA of the target over the PGA that the factors refer to.

    Parameters
    ----------
    records : sequence of Record
        The records.
    spectrum : Spectrum
        The target.
    given : GivenFactors
        Factors by id, and the target that they refer to.
    band : Band
        Periods at which the misfit is taken.

    Raises
    ------
    ProjectError
        If the target has another shape than the one that the factors refer to.
    """
    if target_mark(spectrum).sha256 != given.target.sha256:
        what = "records.lock: the suite is locked" if given.lock else "records.select: the suite is made for a code"
        raise ProjectError(f"{what}, for a spectrum of another shape; sweep the PGA or another key")
    share = 1.0 if given.target.is_of(spectrum) else spectrum.pga / given.target.pga
    factors, over = dict(given.factors), truncate_band(band, spectrum.longest_period)
    return tuple(ScaledRecord(one, _scaling(one, spectrum, over, factors.get(one.id, 1.0) * share)) for one in records)


def raise_artificial(
    motions: tuple[ScaledRecord, ...], spectrum: Spectrum, band: tuple[float, float], *, fitting: Fitting
) -> tuple[ScaledRecord, ...]:
    """Multiply artificial motions by the least factor with which their mean meets ASCE 43-05, 2.4 over the `band` [s].

    That clause requires more of the mean than other codes: no ordinate a tenth below the target, no ten in a row below.
    """
    suite = suite_of([each.record for each in motions], [each.scaling.factor for each in motions], spectrum)
    factor = common_factor(fit_of_mean(suite, band)) or 1.0
    if factor <= 1.0:
        return motions
    said = note("suite-raised", factor=Quantity(factor, figures=6), period=Quantity(band[1], "time", 3))
    noted = tuple(replace(each, record=with_step(each.record, said)) for each in motions)
    return _multiply_all(noted, factor, spectrum, fitting.band)


def apply_record_factor(
    motions: tuple[ScaledRecord, ...], spectrum: Spectrum, study: Study
) -> tuple[ScaledRecord, ...]:
    """Multiply every motion by the further factor of the study."""
    if study.record_factor == 1.0:
        return motions
    return _multiply_all(motions, study.record_factor, spectrum, study.fitting.band)


def _multiply_all(
    motions: tuple[ScaledRecord, ...], factor: float, spectrum: Spectrum, band: Band
) -> tuple[ScaledRecord, ...]:
    return tuple(
        ScaledRecord(each.record, _scaling(each.record, spectrum, band, each.scaling.factor * factor))
        for each in motions
    )


def scale_together(
    records: Sequence[Record], spectrum: Spectrum, given: Fitting, *, scale_to: ScaleTo
) -> tuple[ScaledRecord, ...]:
    """Scale each record; those that are kept together share the geometric mean of their factors.

    That is the factor of least misfit, or to the PGA, of the geometric mean of their spectra. Artificial records are
    made for the target and stay as they are.

    Parameters
    ----------
    records : sequence of Record
        The records.
    spectrum : Spectrum
        The target.
    given : Fitting
        Range of periods, and the records that are kept together.
    scale_to : {"spectrum", "pga", "none"}
        What the records are scaled to.

    Returns
    -------
    tuple of ScaledRecord
        In the order of `records`.
    """
    band = truncate_band(given.band, spectrum.longest_period)
    alone = {
        record.id: SCALINGS["none" if record.artificial else scale_to](record, spectrum, band) for record in records
    }
    shared = {id: exp(mean(log(alone[each].factor) for each in ids)) for ids in given.together for id in ids}
    return tuple(
        ScaledRecord(one, _scaling(one, spectrum, band, shared[one.id]) if one.id in shared else alone[one.id])
        for one in records
    )


def _scaling(record: Record, spectrum: Spectrum, band: Band, factor: float) -> Scaling:
    return Scaling(factor, misfit(record, spectrum, factor=factor, **vars(band)))


def to_spectrum(record: Record, spectrum: Spectrum, band: Band) -> Scaling:
    """Scale the record to the least misfit with the spectrum over the band."""
    return scale_to_spectrum(record, spectrum, **vars(band))


def to_pga(record: Record, spectrum: Spectrum, band: Band) -> Scaling:
    """Scale the record to the PGA of the spectrum."""
    return _scaling(record, spectrum, band, scale_to_pga(record, spectrum.pga))


def keep_scale(record: Record, spectrum: Spectrum, band: Band) -> Scaling:
    """Leave the record as it is."""
    return _scaling(record, spectrum, band, 1.0)


SCALINGS: dict[ScaleTo, Callable[[Record, Spectrum, Band], Scaling]] = {
    "spectrum": to_spectrum,
    "pga": to_pga,
    "none": keep_scale,
}
ALL_PERIODS = Band(np.array(SCALING_PERIODS), np.ones(len(SCALING_PERIODS)), np.array(SCALING_PERIODS))
MOST_NAMED = 3  # files, cells or records that a warning names
LONGEST_CELL = 30  # characters of a cell that are shown


@dataclass(frozen=True)
class RecordSet:
    """Records as read, and how they are scaled."""

    records: tuple[Record, ...]
    fitting: Fitting


@dataclass(frozen=True)
class OfferedRecords:
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
) -> OfferedRecords:
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
            listed = catalogue.catalogue_candidates(connection)
        found += [replace(one, path=str(catalogue.path_inside(place, one.path))) for one in listed]
    alone = [path for path in files if not path.is_dir()]
    made = read_candidates(alone, overrides=overrides, executor=executor)
    offer = (*found, *made)
    if table is None:
        return OfferedRecords(offer, tuple(problems))
    return OfferedRecords(describe_candidates(offer, table.recordings), tuple(problems), match_flatfile(offer, table))


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
    records = with_unique_names([_described_record(one, folder=folder) for _, one in parts])
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
    return read_with_overrides(Path(one.path), one.overrides)[one.position]


def _described_record(one: Candidate, *, folder: Path) -> Record:
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


def offer_messages(offer: OfferedRecords) -> Iterator[Message]:
    """What to know of the files that were not read, and of a flatfile that does not fit."""
    yield from _first_messages(
        [warning("file-not-read", "records.files", file=str(path), why=str(why)) for path, why in offer.problems],
        "files-not-read",
    )
    if offer.merged is not None:
        yield from locate(() if offer.merged.warning is None else (offer.merged.warning,), "records.flatfile")
        yield from _first_messages([cell_message(cell) for cell in offer.merged.bad], "cells-ignored")


def cell_message(cell: BadCell) -> Message:
    """A cell of a flatfile that was passed over."""
    row, value = whole_number(cell.row), cell.value[:LONGEST_CELL]
    return warning("cell-ignored", "records.flatfile", row=row, column=cell.column, value=value)


def record_messages(records: Sequence[Record]) -> Iterator[Message]:
    """Which records have peaks or steps that ground hardly has, or files that contradict themselves."""
    own = [
        warning("of-record", record=record.id, what=what)
        for record in records
        for what in implausibility_warnings(record)
    ]
    yield from _first_messages(locate([*own, *warnings_among(records)], "records.unit"), "of-further-records")


def _first_messages(messages: Sequence[Message], key: str) -> Iterator[Message]:
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
