"""The table [records]: all horizontal records that it names, the suite that it describes, or the one that it locks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import numpy as np

from assess.errors import ProjectError
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, first_names, note, warning
from assess.project import sections
from assess.project.section import fill
from assess.project.sections.ground_motion import Records
from assess.project.suite_lock import AGAIN, LockedArtificial, LockedChoice, LockedRecord, LockedSuite, read_lock
from assess.results.provenance import file_sha256
from assess.study.study import Fitting, GivenFactors, Study
from assess.study.suites import (
    ALL_PERIODS,
    MULTIPLE_OF_LONGEST,
    RULES,
    SHARE_OF_SHORTEST,
    RecordSet,
    candidate_records,
    equivalent_periods,
    extreme_periods,
    offer_messages,
    read_candidate,
    record_messages,
    record_set,
    spectrum_of_rules,
    with_given_factors,
    with_unique_names,
)
from records.candidates import PERIODS
from records.code_suites import SuiteTarget, band_for, select_for
from records.compliance import SELECTION_RULES
from records.errors import RecordError
from records.formats.header import HeaderOverrides
from records.reading import read_with_overrides, recall_records, relative_path
from records.record import Record, is_vertical
from records.scaling import Band, band
from records.selection import Selection, SuiteCriteria, TargetMark, samples_sha256, select
from records.synthetic import artificial_records
from spectra.gravity import g
from spectra.spectrum import Spectrum


def named_records(section: sections.Records, folder: Path) -> RecordSet:
    """Read every record that [records] names; `folder` is that of the project file."""
    found = [record for path in section.files for record in recall_records(path, overrides_of(section))]
    records = with_unique_names([replace(one, path=relative_path(Path(one.path), folder)) for one in found])
    return RecordSet(records, Fitting(ALL_PERIODS))


def overrides_of(section: sections.Records) -> HeaderOverrides:
    """Return what [records] states for files that do not state it themselves."""
    return HeaderOverrides(section.unit, section.step, section.response)


def select_records(
    section: sections.Records,
    selection: sections.Select,
    *,
    study: Study,
    spectrum: Spectrum,
    folder: Path,
    executor: Executor | None = None,
) -> tuple[RecordSet, tuple[Message, ...]]:
    """Select the suite that [records.select] describes, with messages about it.

    Parameters
    ----------
    section, selection : [records] and its table of the selection
    study : the mechanisms, and the limit state that decides
    spectrum : the target
    folder : of the project file
    executor : processes that share the reading of many files

    Raises
    ------
    ProjectError : there is no such suite
    """
    offer = candidate_records(
        section.files, overrides=overrides_of(section), flatfile=section.flatfile, executor=executor
    )
    try:
        if selection.code is None:
            over = band(*periods_of(selection, spectrum, study.mechanisms), weights=selection.weights)
            found = select(offer.candidates, spectrum, _criteria_of_section(section, selection, over))
        else:
            rules = SELECTION_RULES[selection.code]
            target = target_of(rules.code, study, spectrum)
            over = band_for(rules, target)
            if selection.periods is not None:
                over = band(*selection.periods, weights=selection.weights)
            criteria = _criteria_of_section(section, selection, over)
            found = select_for(offer.candidates, rules, target, criteria, read=read_candidate)
    except RecordError as error:
        raise ProjectError(f"records.select: {error}") from None
    suite = record_set(found, over, folder=folder)
    if selection.code is not None:
        suite = with_given_factors(suite, found, spectrum, code=selection.code)
    return suite, (*offer_messages(offer), *record_messages(suite.records))


def target_of(code: str, study: Study, spectrum: Spectrum) -> SuiteTarget:
    """Return what the rules of a code are checked with: its own spectrum and periods where it has any."""
    own = {rules.code: (name, rules) for name, rules in RULES.items()}
    if code not in own:
        return SuiteTarget(spectrum, spectrum, *extreme_periods(equivalent_periods(study.mechanisms)))
    name, rules = own[code]
    return SuiteTarget(spectrum, spectrum_of_rules(name, study, spectrum), *rules.periods(study))


def periods_of(selection: sections.Select, spectrum: Spectrum, mechanisms: Iterable[Mechanism]) -> tuple[float, float]:
    """Return the range given, else 0.2 times the least to 1.2 times the largest equivalent period [s]."""
    if selection.periods is not None:
        return selection.periods
    least, largest = extreme_periods(equivalent_periods(mechanisms))
    longest = min(float(PERIODS[-1]), spectrum.longest_period)
    return max(SHARE_OF_SHORTEST * least, float(PERIODS[0])), min(MULTIPLE_OF_LONGEST * largest, longest)


def horizontal_records(records: Sequence[Record]) -> tuple[Record, ...]:
    """Return the records without vertical components; raise ProjectError if there are no others."""
    kept = tuple(record for record in records if not is_vertical(record.component))
    if records and not kept:
        raise ProjectError("records.files: vertical components alone; give the files of horizontal ones")
    return kept


def vertical_record_messages(records: Sequence[Record]) -> Iterator[Message]:
    """Say which vertical components were found and are not used."""
    vertical = [record.id for record in records if is_vertical(record.component)]
    if vertical:
        yield note("vertical-left-out", "records.files", records=", ".join(vertical))


LOCK_KEY = "records.lock"
MOST_TARGETS = 3  # that an error lists

KEYS_OF_MAKING = ("files", "select", "flatfile", "unit", "step", "response", "synthetic", "scale_to", "factor")
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
    lock, target = _suite_for(spectrum, path)
    recorded = [(_locked_record(one, path=path, folder=folder), one.scale_factor) for one in lock.records]
    made = [] if lock.artificial is None else _artificial_records_of(lock.artificial, spectrum)
    both = [*recorded, *((one, lock.artificial.scale_factor) for one in made if lock.artificial is not None)]
    if not both:
        raise ProjectError(f"{LOCK_KEY}: {path.name} holds no records; {AGAIN}")
    given = GivenFactors(
        factors=tuple((record.id, factor) for record, factor in both),
        target=target,
        lock=relative_path(path, folder),
        code=lock.chosen.code or "",
    )
    fitting = Fitting(
        band=_band_of(lock.chosen),
        selection=_selection_of(lock),
        nga=tuple((one.id, one.nga) for one in lock.records if one.nga is not None),
        given_factors=given,
    )
    return RecordSet(tuple(record for record, _ in both), fitting)


def _suite_for(spectrum: Spectrum, path: Path) -> tuple[LockedSuite, TargetMark]:
    """Return the suite of a lock that was made for a spectrum, with its target."""
    suites = read_lock(path)[0].suites
    for suite in suites:
        target = TargetMark(suite.target.code, suite.target.pga_g * g, suite.target.sha256)
        if target.is_of(spectrum):
            return suite, target
    listed = first_names([f"{each.target.code}, PGA {each.target.pga_g:.4g} g" for each in suites], MOST_TARGETS)
    table = ", or with `--table TABLE.csv` for the targets of all rows of a table" if len(suites) == 1 else ""
    raise ProjectError(
        f"{LOCK_KEY}: {path.name} was made for another target ({listed}) than the site's spectrum ({spectrum.code}, "
        f"PGA {spectrum.pga / g:.4g} g), its factors do not apply; {AGAIN}{table}"
    )


def lock_messages(path: Path, section: Records) -> Iterator[Message]:
    """Say which keys of [records] the lock stands for, and whether it was changed by hand."""
    beside = ", ".join(key for key in KEYS_OF_MAKING if section.has_key(key))
    if beside:
        yield note("suite-locked", LOCK_KEY, file=path.name, keys=beside)
    if not read_lock(path)[1]:
        yield warning("lock-edited", LOCK_KEY, file=path.name)


def files_of_lock(path: Path) -> tuple[Path, ...]:
    """Return the lock and every file that it names."""
    records = [one for suite in read_lock(path)[0].suites for one in suite.records]
    named = [name for one in records for name in (one.file, one.response) if name is not None]
    return (path, *(path.parent / name for name in dict.fromkeys(named)))


def _criteria_of_section(section: sections.Records, selection: sections.Select, over: Band) -> SuiteCriteria:
    """Return the criteria of the selection."""
    return fill(SuiteCriteria, selection, band=over, filters=selection.plain, scale_to=section.scale_to)


def _locked_record(one: LockedRecord, *, path: Path, folder: Path) -> Record:
    """Read a record of a lock; raise ProjectError if its file is not the one that was locked."""
    file = path.parent / one.file
    _check_file(file, one.sha256, path)
    response = None if one.response is None else path.parent / one.response
    if response is not None:
        _check_file(response, one.response_sha256 or "", path)
    found = _records_of_file(file, one.sha256, one.response_sha256, HeaderOverrides(one.unit, one.step_s, response))
    if one.position > len(found):
        raise ProjectError(
            f"{LOCK_KEY}: {path.name}: {one.file} has {len(found)} records, none at {one.position}; {AGAIN}"
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
def _records_of_file(
    file: Path, sha256: str, response_sha256: str | None, overrides: HeaderOverrides
) -> tuple[Record, ...]:
    """Read the records of a file that has this SHA-256; they are frozen and may be shared."""
    return read_with_overrides(file, overrides)


def _check_file(file: Path, sha256: str, lock: Path) -> None:
    try:
        now = file_sha256(file)
    except OSError as error:
        raise ProjectError(
            f"{LOCK_KEY}: {lock.name} names {file}, which cannot be read ({error.strerror}); put it back, or {AGAIN}"
        ) from None
    if now != sha256:
        raise ProjectError(
            f"{LOCK_KEY}: {file} has changed since {lock.name} was made (SHA-256 {now[:12]}, locked {sha256[:12]}); "
            f"put it back, or {AGAIN}"
        )


def _artificial_records_of(recipe: LockedArtificial, spectrum: Spectrum) -> tuple[Record, ...]:
    """Make the artificial records of a lock again; raise ProjectError if they are not the same."""
    made = artificial_records(
        spectrum, count=recipe.count, seed=recipe.seed, duration=recipe.duration_s, band=recipe.periods_s
    )
    if tuple(map(samples_sha256, made)) != recipe.sha256:
        raise ProjectError(
            f"{LOCK_KEY}: the artificial records made again are not those that were locked, as another version of the "
            f"program may make them; {AGAIN}"
        )
    return made


def _band_of(chosen: LockedChoice) -> Band:
    """Return the periods that the records are compared at."""
    if chosen.how == "all":
        return ALL_PERIODS
    try:
        return band(*chosen.periods_s, weights=chosen.weights)
    except RecordError as error:
        raise ProjectError(f"{LOCK_KEY}: chosen: {error}; {AGAIN}") from None


def _selection_of(lock: LockedSuite) -> Selection | None:
    """Return how the records of a lock were chosen, without the candidates; None if all were taken."""
    chosen = lock.chosen
    if chosen.how == "all":
        return None
    criteria = SuiteCriteria(
        count=len(lock.records),
        band=_band_of(chosen),
        scale_limits=chosen.scale_limits or (0.0, np.inf),
        one_per_event=chosen.one_per_event is not False,
        fit=chosen.fit or "suite",
        components=chosen.components or "single",
        scale_to=chosen.scale_to,
    )
    return Selection(criteria, (), chosen.misfit or 0.0, chosen.greedy_misfit, chosen.remaining)
