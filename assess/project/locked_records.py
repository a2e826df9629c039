"""The suite of records that a lock holds, read for a project."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import numpy as np
from scipy.constants import g

from assess.errors import ProjectError
from assess.messages.message import Message, note, warning
from assess.project.file_digests import file_sha256
from assess.project.sections.analysis import Records
from assess.project.suite_lock import AGAIN, LockedArtificial, LockedChoice, LockedRecord, SuiteLock, read_lock
from assess.study.record_set import EVERYWHERE, RecordSet
from assess.study.study import Fitting, GivenFactors
from records.band import Band, band
from records.errors import RecordError
from records.fingerprints import TargetMark, samples_sha256
from records.formats.header_overrides import HeaderOverrides
from records.paths import relative_path
from records.reading import read_with
from records.record import Record
from records.selection import Criteria, Selection
from records.synthetic import artificial
from spectra.spectrum import Spectrum

WHERE = "records.lock"
MAKING = ("files", "select", "flatfile", "unit", "step", "response", "synthetic", "scale_to", "factor")
"""Keys of [records] that say how a lock is made."""


def locked_records(path: Path, *, folder: Path, spectrum: Spectrum) -> RecordSet:
    """Return the records and factors of a lock.

    Parameters
    ----------
    path : of the lock
    folder : of the project file, which paths in the results are relative to
    spectrum : the site's, which has to be the one that the lock was made for

    Raises
    ------
    ProjectError : the lock is of another spectrum, or a file is missing or was changed
    """
    lock, _ = read_lock(path)
    target = TargetMark(lock.target.code, lock.target.pga_g * g, lock.target.sha256)
    if not target.is_of(spectrum):
        raise ProjectError(
            f"{WHERE}: {path.name} was made for another target ({target.code}, PGA {lock.target.pga_g:.4g} g) than the "
            f"site's spectrum ({spectrum.code}, PGA {spectrum.pga / g:.4g} g), its factors do not apply; {AGAIN}"
        )
    recorded = [(_record(one, path=path, folder=folder), one.scale_factor) for one in lock.records]
    made = [] if lock.artificial is None else artificial_of(lock.artificial, spectrum)
    both = [*recorded, *((one, lock.artificial.scale_factor) for one in made if lock.artificial is not None)]
    if not both:
        raise ProjectError(f"{WHERE}: {path.name} holds no records; {AGAIN}")
    given = GivenFactors(
        factors=tuple((record.id, factor) for record, factor in both),
        target=target,
        lock=relative_path(path, folder),
        code=lock.chosen.code or "",
    )
    fitting = Fitting(
        band=band_of(lock.chosen),
        selection=selection_of(lock),
        nga=tuple((one.id, one.nga) for one in lock.records if one.nga is not None),
        given=given,
    )
    return RecordSet(tuple(record for record, _ in both), fitting)


def lock_messages(path: Path, section: Records) -> Iterator[Message]:
    """Say which keys of [records] the lock stands for, and whether it was changed by hand."""
    beside = ", ".join(key for key in MAKING if section.has_key(key))
    if beside:
        yield note("suite-locked", WHERE, file=path.name, keys=beside)
    if not read_lock(path)[1]:
        yield warning("lock-edited", WHERE, file=path.name)


def files_of_lock(path: Path) -> tuple[Path, ...]:
    """Return the lock and every file that it names."""
    records = read_lock(path)[0].records
    named = [name for one in records for name in (one.file, one.response) if name is not None]
    return (path, *(path.parent / name for name in dict.fromkeys(named)))


def _record(one: LockedRecord, *, path: Path, folder: Path) -> Record:
    """Read a record of a lock; raise ProjectError if its file is not the one that was locked."""
    file = path.parent / one.file
    _check_file(file, one.sha256, path)
    response = None if one.response is None else path.parent / one.response
    if response is not None:
        _check_file(response, one.response_sha256 or "", path)
    found = _read(file, one.sha256, one.response_sha256, HeaderOverrides(one.unit, one.step_s, response))
    if one.position > len(found):
        raise ProjectError(
            f"{WHERE}: {path.name}: {one.file} has {len(found)} records, none at {one.position}; {AGAIN}"
        )
    record = found[one.position - 1]
    return replace(
        record,
        id=one.id,
        path=relative_path(file, folder),
        event=one.event,
        station=one.station,
        distance=one.distance_m,
        earthquake=replace(record.earthquake, time=one.date, magnitude=one.magnitude),
        site=replace(record.site, vs30=one.vs30_m_per_s),
    )


@lru_cache(maxsize=256)
def _read(file: Path, sha256: str, response_sha256: str | None, overrides: HeaderOverrides) -> tuple[Record, ...]:
    """Read the records of a file that has this SHA-256; they are frozen and may be shared."""
    return read_with(file, overrides)


def _check_file(file: Path, sha256: str, lock: Path) -> None:
    try:
        now = file_sha256(file)
    except OSError as error:
        raise ProjectError(
            f"{WHERE}: {lock.name} names {file}, which cannot be read ({error.strerror}); put it back, or {AGAIN}"
        ) from None
    if now != sha256:
        raise ProjectError(
            f"{WHERE}: {file} has changed since {lock.name} was made (SHA-256 {now[:12]}, locked {sha256[:12]}); "
            f"put it back, or {AGAIN}"
        )


def artificial_of(recipe: LockedArtificial, spectrum: Spectrum) -> tuple[Record, ...]:
    """Make the artificial records of a lock again; raise ProjectError if they are not the same."""
    made = artificial(spectrum, count=recipe.count, seed=recipe.seed, duration=recipe.duration_s, band=recipe.periods_s)
    if tuple(map(samples_sha256, made)) != recipe.sha256:
        raise ProjectError(
            f"{WHERE}: the artificial records made again are not those that were locked, as another version of the "
            f"program may make them; {AGAIN}"
        )
    return made


def band_of(chosen: LockedChoice) -> Band:
    """Return the periods that the records are compared at."""
    if chosen.how == "all":
        return EVERYWHERE
    try:
        return band(*chosen.periods_s, weights=chosen.weights)
    except RecordError as error:
        raise ProjectError(f"{WHERE}: chosen: {error}; {AGAIN}") from None


def selection_of(lock: SuiteLock) -> Selection | None:
    """Return how the records of a lock were chosen, without the candidates; None if all were taken."""
    chosen = lock.chosen
    if chosen.how == "all":
        return None
    criteria = Criteria(
        count=len(lock.records),
        band=band_of(chosen),
        scale_limits=chosen.scale_limits or (0.0, np.inf),
        one_per_event=chosen.one_per_event is not False,
        fit=chosen.fit or "suite",
        components=chosen.components or "single",
        scale_to=chosen.scale_to,
    )
    return Selection(criteria, (), chosen.misfit or 0.0, chosen.greedy_misfit, chosen.remaining)
