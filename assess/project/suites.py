"""Suites for the command line: of a project, of folders beside a target, of files that are only scaled."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from math import isnan
from pathlib import Path
from typing import Any, get_args

from assess.errors import AssessError
from assess.messages.message import Message
from assess.portfolio.projects import find_tasks, project_tree, row_fault
from assess.project.build import build
from assess.project.placement import elevation_at
from assess.project.project_file import Project, load, load_tree
from assess.project.record_set import horizontal_records, overrides_of
from assess.project.site_and_structure import site_of, spectrum_of
from assess.project.suite_lock import LOCK_NAME, LockedSuite, lock_text, suite_to_lock, write_lock
from assess.results import GroundMotionResult, RecordResult
from assess.study import suites
from assess.study.ground_motion import ground_motion, ground_motion_result, record_result
from assess.study.study import Fitting, ScaledRecord, Study, require_spectrum
from assess.study.suites import (
    MULTIPLE_OF_LONGEST,
    SHARE_OF_SHORTEST,
    OfferedRecords,
    apply_given_factors,
    artificial_band,
    motions_of,
    scale_together,
)
from assess.workers import process_pool
from records.candidates import PERIODS
from records.code_suites import SuiteTarget, band_for, select_for
from records.compliance import REQUIREMENTS, SELECTION_RULES, CodeName
from records.errors import RecordError
from records.formats.header import HeaderOverrides
from records.reading import read_with_overrides
from records.record import Record, scale
from records.scaling import Scaling, band, misfit, scale_to_ordinate, truncate_band
from records.selection import CandidateFilters, Components, Fit, Range, ScaleTo, SuiteCriteria, select
from spectra.errors import SpectrumError
from spectra.gravity import g
from spectra.spectrum import Spectrum
from spectra.table import read_table

UNITS: Mapping[str, float] = {"magnitude": 1.0, "distance": 1000.0, "vs30": 1.0, "pga": g, "duration": 1.0}
"""SI of what the command line takes: km, m/s, g, s."""


@dataclass(frozen=True)
class ScaledSuite:
    """Records as scaled, the suite beside its target, and what to know of it."""

    records: tuple[RecordResult, ...]
    motion: GroundMotionResult
    messages: tuple[Message, ...] = ()


@dataclass(frozen=True)
class SuiteOptions:
    """What the command line asks of a suite, in its units; spans: of the filters by name; code: whose rules to meet."""

    count: int
    periods: Range
    scale_limits: Range
    fit: str
    components: str
    scale_to: str
    one_per_event: bool
    spans: Mapping[str, Range | None]
    events: tuple[str, ...]
    code: str | None = None


def suite_of_project(path: Path, *, executor: Executor | None = None) -> ScaledSuite:
    """Return the records of a project as it selects and scales them, without artificial ones.

    Parameters
    ----------
    path : of the project
    executor : processes that share the reading of many records

    Raises
    ------
    AssessError : the project names no records
    """
    study = build(load(path), executor=executor)
    if not study.records:
        raise AssessError(f"{path}: records.files: missing; add the files or the folder to select from")
    return _suite_of(study, motions_of(replace(study, artificial=None), require_spectrum(study)))


def lock_project(
    path: Path, *, table: Path | None = None, executor: Executor | None = None
) -> tuple[ScaledSuite, Path, tuple[str, ...]]:
    """Write the lock of a project: its records as [records] finds, makes and scales them, whatever its lock says.

    Parameters
    ----------
    path : of the project
    table : of a portfolio, whose template the project is: the lock then has a suite for each target of its rows, found
        with the first row that has it
    executor : processes that share the reading of many records

    Returns
    -------
    The suite; the lock, the file of [records] lock, or records.lock.toml beside the project file; and what is wrong
    with the rows of the sites that have no suite in it

    Raises
    ------
    AssessError : [records] names only the lock; or a file is there that is no lock, or was changed by hand
    """
    project = load(path)
    given = project.content.records
    if given.lock is not None and not given.files and not given.has_key("synthetic"):
        raise AssessError(f"{project.path}: records.files: missing; add what the lock is to be made of, or `synthetic`")
    lock = given.lock or project.folder / LOCK_NAME
    found, suite = _found_suite(project, lock.parent, executor=executor)
    suites, left_out = {suite.target: suite}, tuple[str, ...]()
    if table is not None:
        of_rows, left_out = _suites_of_rows(table, project.path, lock.parent, executor=executor)
        for each in of_rows:
            suites.setdefault(each.target, each)
    write_lock(lock, lock_text(*suites.values()))
    return found, lock, left_out


def _found_suite(project: Project, place: Path, *, executor: Executor | None) -> tuple[ScaledSuite, LockedSuite]:
    """Return the suite that [records] of a project describes, and how its lock has it; place : folder of the lock."""
    section = project.content.records
    if section.lock is not None:
        section = section.model_copy(update={"lock": None})
        project = replace(project, content=project.content.model_copy(update={"records": section}))
    study = build(project, executor=executor)
    spectrum, made = require_spectrum(study), study.artificial
    motions = motions_of(study, spectrum)
    if not motions:
        raise AssessError(f"{project.path}: every mechanism falls under its own loads; no records are chosen for it")
    locked = suite_to_lock(
        motions,
        spectrum,
        study.fitting,
        place=place,
        folder=project.folder,
        scale_to=study.scale_to,
        further_factor=study.record_factor,
        overrides=overrides_of(section),
        recipe=None if made is None else (made, artificial_band(study, spectrum, duration=made.duration)),
    )
    return _suite_of(study, motions), locked


def _suites_of_rows(
    table: Path, template: Path, place: Path, *, executor: Executor | None
) -> tuple[list[LockedSuite], tuple[str, ...]]:
    """Return the suite of each site that the rows of a table have, found with the first of its rows that has one.

    And what is wrong with the first row of each site of which no row has one.
    """
    found: list[LockedSuite] = []
    done: list[Any] = []
    faults: list[tuple[Any, str]] = []
    for task in find_tasks(table, template, place_load=elevation_at):
        site: Any = task  # where its row cannot be read, nobody knows its site
        try:
            tables = project_tree(task)
            site = tables.get("site")
            if site not in done:
                found.append(_found_suite(load_tree(tables, template, sha256=task.sha256), place, executor=executor)[1])
                done.append(site)
        except (AssessError, RecordError, SpectrumError) as error:
            faults.append((site, row_fault(task, str(error))))
    sites = [site for site, _ in faults]
    left_out = (fault for number, (site, fault) in enumerate(faults) if site not in (*done, *sites[:number]))
    return found, tuple(left_out)


def lock_target(target: Path, found: SelectedSuite) -> Path:
    """Write the lock of a suite that was selected for a target, beside the target.

    Parameters
    ----------
    target : a project, or a table of period and acceleration
    found : the suite

    Returns
    -------
    The lock

    Raises
    ------
    AssessError : a file is there that is no lock, or was changed by hand
    """
    folder = (target if target.is_dir() else target.parent).absolute()
    suite = suite_to_lock(
        found.motions, found.spectrum, found.fitting, place=folder, folder=Path.cwd(), scale_to=found.scale_to
    )
    write_lock(folder / LOCK_NAME, lock_text(suite))
    return folder / LOCK_NAME


@dataclass(frozen=True)
class SelectedSuite:
    """A suite selected for a target: as results show it, and as it was scaled."""

    suite: ScaledSuite
    motions: tuple[ScaledRecord, ...]
    spectrum: Spectrum
    fitting: Fitting
    scale_to: ScaleTo

    @property
    def records(self) -> tuple[Record, ...]:
        """The records times their factors."""
        return tuple(scale(each.record, each.scaling.factor) for each in self.motions)


def select_for_target(
    target: Path,
    places: Sequence[Path],
    options: SuiteOptions,
    *,
    overrides: HeaderOverrides,
    flatfile: Path | None,
    kept: Path | None,
    executor: Executor | None = None,
) -> SelectedSuite:
    """Select the suite that fits the spectrum of a target, out of files and the catalogues of folders.

    Parameters
    ----------
    target : a project, or a table of period and acceleration
    places : files and folders of records
    options : of the command line
    overrides : what files do not state themselves
    flatfile : magnitudes and distances of the recordings
    kept : file of the catalogue, if it is not in the folder
    executor : processes that share the reading of many files

    Raises
    ------
    AssessError : an option cannot be followed
    """
    spectrum, criteria = _spectrum_at(target), _criteria_of_options(options)
    if kept is not None and sum(place.is_dir() for place in places) > 1:
        raise AssessError(f"--catalogue {kept}: one catalogue is of one folder; give one folder")
    code: CodeName | None = None if options.code is None else _one_of("--for", options.code, CodeName)
    offer = suites.candidate_records(places, overrides=overrides, flatfile=flatfile, kept=kept, executor=executor)
    return select_for_spectrum(spectrum, offer, criteria, code=code)


def select_records(
    target: Spectrum,
    records: OfferedRecords | str | Path | Sequence[str | Path],
    *,
    count: int = 7,
    periods: Range = (0.1, 2.0),
    scale_limits: Range = (0.25, 4.0),
    fit: Fit = "suite",
    components: Components = "single",
    scale_to: ScaleTo = "spectrum",
    one_per_event: bool = True,
    magnitude: Range | None = None,
    distance: Range | None = None,
    vs30: Range | None = None,
    pga: Range | None = None,
    duration: Range | None = None,
    events: Sequence[str] = (),
    code: CodeName | None = None,
) -> SelectedSuite:
    """Select the records that best fit a target spectrum, and scale them, as `assess records select` does.

    Parameters
    ----------
    target : elastic spectrum, 5 % damping
    records : what `catalogue` returns, or files and folders of records
    count : of records, or of recordings where their components are kept together
    periods : range over which to fit [s]
    scale_limits : smallest and largest scale factor [-]
    fit : the mean of the "suite", or "each" record
    components : each "single", or those of a recording "together" with one factor
    scale_to : "spectrum", "pga" or "none"
    one_per_event : whether no two may be of one earthquake
    magnitude, distance, vs30, pga, duration : least and largest [-], [m], [m/s], [m/s2], [s]; None for any
    events : parts of the names of the earthquakes allowed; all if empty
    code : whose rules to meet, such as "ntc2018"; the periods are then 0.2 to 1.2 T

    Returns
    -------
    The suite: `records` scaled, `motions` as read with their factors

    Raises
    ------
    AssessError : an argument cannot be followed
    RecordError : a file cannot be read, or too few records are left; lists how many after each step
    """
    if not isinstance(target, Spectrum):
        raise AssessError(f"target: {type(target).__name__} given; give a spectrum, as assess.spectrum returns it")
    spans = {"magnitude": magnitude, "distance": distance, "vs30": vs30, "pga": pga, "duration": duration}
    _check_spans({**spans, "scale_limits": scale_limits, "periods": periods}, "")
    if not isinstance(count, int) or count < 1:
        raise AssessError(f"count = {count!r:.60}: give a whole number from 1 up")
    criteria = SuiteCriteria(
        count=count,
        band=band(*periods),
        filters=CandidateFilters(**spans, events=tuple(events)),
        scale_limits=scale_limits,
        one_per_event=one_per_event,
        fit=_one_of("fit", fit, Fit),
        components=_one_of("components", components, Components),
        scale_to=_one_of("scale_to", scale_to, ScaleTo),
    )
    rules: CodeName | None = None if code is None else _one_of("code", code, CodeName)
    places = (records,) if isinstance(records, str | Path) else records
    offer = places if isinstance(places, OfferedRecords) else catalogue(*places)
    return select_for_spectrum(target, offer, criteria, code=rules)


def catalogue(*places: str | Path, flatfile: str | Path | None = None, jobs: int = 1) -> OfferedRecords:
    """Catalogue the records of folders and files: metadata, measures and 5 % spectra, as `assess records index` does.

    A folder keeps its catalogue in a file of its own; later calls read only new and changed files.

    Parameters
    ----------
    places : folders of records with their subfolders, and files
    flatfile : table of magnitudes and distances of the recordings
    jobs : processes that share the reading, 0 for all cores; more than one only under `if __name__ == "__main__":`

    Returns
    -------
    `candidates`, `problems` with the files that could not be read, and `table()`

    Raises
    ------
    RecordError : a file that is named cannot be read
    """
    if not places:
        raise AssessError("catalogue: no place given; give folders or files of records")
    with process_pool(jobs) as executor:
        return suites.candidate_records(
            [Path(each) for each in places], flatfile=None if flatfile is None else Path(flatfile), executor=executor
        )


def select_for_spectrum(
    spectrum: Spectrum, offer: OfferedRecords, criteria: SuiteCriteria, *, code: CodeName | None
) -> SelectedSuite:
    """Select the suite that fits a spectrum, by the rules of a code where one is named."""
    if code is None:
        found, own = select(offer.candidates, spectrum, criteria), {}
        chosen = suites.record_set(found, criteria.band, folder=Path.cwd())
        motions = scale_together(chosen.records, spectrum, chosen.fitting, scale_to=criteria.scale_to)
    else:
        making = SELECTION_RULES[code]
        low, high = truncate_band(criteria.band, spectrum.longest_period).ends
        goal = SuiteTarget(spectrum, spectrum, low / SHARE_OF_SHORTEST, high / MULTIPLE_OF_LONGEST)
        criteria = replace(criteria, band=band_for(making, goal))
        own = dict.fromkeys(REQUIREMENTS, (goal.shortest, goal.longest))
        found = select_for(offer.candidates, making, goal, criteria, read=suites.read_candidate)
        chosen = suites.record_set(found, criteria.band, folder=Path.cwd())
        chosen = suites.with_given_factors(chosen, found, spectrum, code=code)
        assert chosen.fitting.given_factors is not None
        motions = apply_given_factors(chosen.records, spectrum, chosen.fitting.given_factors, band=criteria.band)
    motion = ground_motion_result(motions, spectrum, chosen.fitting, source="given", equivalent={}, own=own)
    messages = (*suites.offer_messages(offer), *suites.record_messages(chosen.records))
    suite = ScaledSuite(results_of(motions, spectrum, chosen.fitting), motion, messages)
    return SelectedSuite(suite, motions, spectrum, chosen.fitting, criteria.scale_to)


def write_scaled_files(
    target: Path, files: Sequence[Path], *, to: str, at: float | None, periods: Range, overrides: HeaderOverrides
) -> tuple[tuple[ScaledRecord, ...], ScaledSuite]:
    """Scale every record to the spectrum of a target, or to its ordinate at one period.

    Parameters
    ----------
    target : a project, or a table of period and acceleration
    files : records
    to : "spectrum", "pga" or "none"
    at : period [s] at which ordinates are made equal; None for `to`
    periods : range over which the misfit is measured [s]
    overrides : what files do not state themselves

    Returns
    -------
    The scaled records, and the suite they form

    Raises
    ------
    AssessError : an option cannot be followed
    """
    _check_period(at)
    spectrum, fitting = _spectrum_at(target), Fitting(band(*periods))
    found = suites.with_unique_names([record for file in files for record in read_with_overrides(file, overrides)])
    records = horizontal_records(found)
    if at is None:
        motions = scale_together(records, spectrum, fitting, scale_to=_one_of("--to", to, ScaleTo))
    else:
        factors = [scale_to_ordinate(record, spectrum, period=at) for record in records]
        over = vars(truncate_band(fitting.band, spectrum.longest_period))
        scalings = [Scaling(f, misfit(r, spectrum, factor=f, **over)) for r, f in zip(records, factors, strict=True)]
        motions = tuple(ScaledRecord(record, scaling) for record, scaling in zip(records, scalings, strict=True))
    motion = ground_motion_result(motions, spectrum, fitting, source="given", equivalent={})
    return motions, ScaledSuite(results_of(motions, spectrum, fitting), motion, tuple(suites.record_messages(records)))


def results_of(motions: Sequence[ScaledRecord], spectrum: Spectrum, fitting: Fitting) -> tuple[RecordResult, ...]:
    """Return the records as results.json has them."""
    numbers = dict(fitting.nga)
    return tuple(record_result(motion, spectrum, nga=numbers.get(motion.record.id)) for motion in motions)


def _suite_of(study: Study, motions: tuple[ScaledRecord, ...]) -> ScaledSuite:
    """Return the suite of a study as scaled, with the messages on its records."""
    spectrum = require_spectrum(study)
    found = ground_motion(study, spectrum, motions)
    assert found is not None  # there are records
    messages = tuple(each for each in study.messages if each.where.startswith("records"))
    return ScaledSuite(results_of(motions, spectrum, study.fitting), found, messages)


def _criteria_of_options(options: SuiteOptions) -> SuiteCriteria:
    """Return the criteria in SI; raise AssessError for an unknown word or a range that falls."""
    _check_spans({**options.spans, "scale-limits": options.scale_limits}, "--")
    si = {
        name: None if span is None else (span[0] * UNITS[name], span[1] * UNITS[name])
        for name, span in options.spans.items()
    }
    return SuiteCriteria(
        count=options.count,
        band=band(*options.periods),
        filters=CandidateFilters(**si, events=options.events),
        scale_limits=options.scale_limits,
        one_per_event=options.one_per_event,
        fit=_one_of("--fit", options.fit, Fit),
        components=_one_of("--components", options.components, Components),
        scale_to=_one_of("--scale-to", options.scale_to, ScaleTo),
    )


def _check_spans(spans: Mapping[str, Range | None], dashes: str) -> None:
    """Raise AssessError for a range that is not a number or falls."""
    for name, span in spans.items():
        if span is not None and (isnan(span[0]) or isnan(span[1])):
            raise AssessError(
                f"{dashes}{name} {span[0]:g} {span[1]:g}: not a number; give two numbers, the lesser first"
            )
        if span is not None and span[0] > span[1]:
            raise AssessError(f"{dashes}{name} {span[0]:g} {span[1]:g}: the first is larger than the second")


def _check_period(at: float | None) -> None:
    """Refuse a period at which spectra of records mean nothing; 0 is that of the peak."""
    if at is not None and at != 0.0 and not PERIODS[0] <= at <= PERIODS[-1]:
        raise AssessError(
            f"--at {at:g}: records are scaled at 0 s, their peak, or from {PERIODS[0]:g} s to {PERIODS[-1]:g} s"
        )


def _spectrum_at(target: Path) -> Spectrum:
    """Return the spectrum of a project's site, or of a table in a .csv or .txt file."""
    if target.suffix.lower() in (".csv", ".txt") and target.is_file():
        return read_table(target)
    if target.is_file() and target.suffix.lower() != ".toml":
        raise AssessError(
            f"--target {target}: a target is a project (a folder, or a file in .toml), or a table of period and "
            "acceleration in .csv or .txt; this is neither"
        )
    return spectrum_of(site_of(target))


def _one_of(option: str, word: str, known: Any) -> Any:
    words = get_args(known)
    if word not in words:
        raise AssessError(f'{option} "{word}": not known; choose one of {", ".join(words)}')
    return word
