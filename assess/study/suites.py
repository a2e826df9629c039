"""The suite of records of a study: offered by files and catalogues or artificial, scaled, and held to rules of codes.

Rules that the records do not meet are listed, each with a change of the project that would meet it. One suite serves
the whole building, so the range of periods reaches the slowest of all its mechanisms. A rocking body has no period of
its own. Where codes refer to the period of a structure, it is that of the linear oscillator with the same work at the
allowable rotation of histories, half the overturning rotation: 1/f_e of ASCE 43-05 A.2 (the secant in energy).
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from math import ceil, exp, floor, log
from pathlib import Path
from statistics import mean
from typing import TYPE_CHECKING, Protocol

import numpy as np

from assess.codes.asce43_05 import HALF, effective_frequency
from assess.codes.italian_limit_states import curves_of_all_actions
from assess.codes.ntc2018_clauses import ULTIMATE, capacity_of
from assess.codes.procedures import PROCEDURES, uses_histories
from assess.codes.question import methods_of
from assess.errors import ProjectError
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import (
    Message,
    Quantity,
    Severity,
    Term,
    Value,
    locate,
    message,
    note,
    warning,
    whole_number,
)
from assess.oscillator import Branch
from assess.study.study import Fitting, GivenFactors, ScaledRecord, Study, deciding_limit_states
from records import catalogue
from records.candidates import Candidate, candidate_table, read_candidates
from records.catalogue import index
from records.compliance import CodeName, Requirements, asce43_05, ntc2018
from records.compliance.asce43_05 import fit_of_mean
from records.compliance.suite import FINE, Requirement, RequirementKind, Suite, common_factor, suite_of
from records.flatfile import BadCell, FlatfileMatch, describe_candidates, match_flatfile, read_flatfile
from records.formats.header import NO_OVERRIDES, HeaderOverrides
from records.plausibility import implausibility_warnings, warnings_among
from records.reading import read_with_overrides, relative_path
from records.record import Record, with_step
from records.scaling import SCALING_PERIODS, Band, Scaling, misfit, scale_to_pga, scale_to_spectrum, truncate_band
from records.selection import Range, ScaleTo, Selection, target_mark
from records.synthetic import MATCHED_PERIODS, STATIONARY, ArtificialRecords, artificial_records
from spectra.spectrum import Spectrum

if TYPE_CHECKING:
    from pandas import DataFrame


def motions_of(study: Study, spectrum: Spectrum, *, jobs: int = 1) -> tuple[ScaledRecord, ...]:
    """Return every record of a study with its scaling, those of files first.

    A suite of artificial records only is raised as a whole if its mean falls short of the target, unless the study
    scales records otherwise.

    Parameters
    ----------
    study : its records, the artificial ones to be made, and how they are scaled
    spectrum : the target
    jobs : number of threads; 0 for all cores

    Returns
    -------
    In the order of the study; none where every mechanism falls under its own loads.
    """
    if study.falling and not study.mechanisms:
        return ()
    to_make = study.artificial
    if to_make is None:
        return _apply_record_factor(_scale_records(study, study.records, spectrum), spectrum, study)
    band = artificial_band(study, spectrum, duration=to_make.duration)
    made_records = artificial_records(
        spectrum, count=to_make.count, seed=to_make.seed, duration=to_make.duration, band=band, threads=jobs
    )
    motions = _scale_records(study, (*study.records, *made_records), spectrum)
    if not study.records and study.scale_to == "spectrum":
        motions = raise_artificial(motions, spectrum, band, fitting=study.fitting)
    return _apply_record_factor(motions, spectrum, study)


def apply_given_factors(
    records: Sequence[Record], spectrum: Spectrum, given_factors: GivenFactors, *, band: Band
) -> tuple[ScaledRecord, ...]:
    """Scale each record by its given factor, times the PGA of the target over the PGA that the factors refer to.

    Parameters
    ----------
    records : the records
    spectrum : the target
    given_factors : factors by id, and the target that they refer to
    band : periods at which the misfit is taken

    Raises
    ------
    ProjectError : if the target has another shape than the one that the factors refer to
    """
    if target_mark(spectrum).sha256 != given_factors.target.sha256:
        what = (
            "records.lock: the suite is locked"
            if given_factors.lock
            else "records.select: the suite is made for a code"
        )
        raise ProjectError(f"{what}, for a spectrum of another shape; sweep the PGA or another key")
    share = 1.0 if given_factors.target.is_of(spectrum) else spectrum.pga / given_factors.target.pga
    factors, over = dict(given_factors.factors), truncate_band(band, spectrum.longest_period)
    return tuple(
        ScaledRecord(record, _scaling(record, spectrum, over, factors.get(record.id, 1.0) * share))
        for record in records
    )


def raise_artificial(
    motions: tuple[ScaledRecord, ...], spectrum: Spectrum, band: tuple[float, float], *, fitting: Fitting
) -> tuple[ScaledRecord, ...]:
    """Multiply artificial motions by the least factor with which their mean meets ASCE 43-05, 2.4 over the `band` [s].

    That clause requires more of the mean than other codes: no ordinate a tenth below the target, no ten in a row below.
    """
    suite = suite_of([motion.record for motion in motions], [motion.scaling.factor for motion in motions], spectrum)
    factor = common_factor(fit_of_mean(suite, band)) or 1.0
    if factor <= 1.0:
        return motions
    raised = note("suite-raised", factor=Quantity(factor, figures=6), period=Quantity(band[1], "time", 3))
    noted = tuple(replace(motion, record=with_step(motion.record, raised)) for motion in motions)
    return _multiply_all(noted, factor, spectrum, fitting.band)


def scale_together(
    records: Sequence[Record], spectrum: Spectrum, fitting: Fitting, *, scale_to: ScaleTo
) -> tuple[ScaledRecord, ...]:
    """Scale each record; those that are kept together share the geometric mean of their factors.

    That is the factor of least misfit, or to the PGA, of the geometric mean of their spectra. Artificial records are
    made for the target and stay as they are.

    Parameters
    ----------
    records : the records
    spectrum : the target
    fitting : range of periods, and the records that are kept together
    scale_to : {"spectrum", "pga", "none"}
        What the records are scaled to.

    Returns
    -------
    In the order of `records`.
    """
    band = truncate_band(fitting.band, spectrum.longest_period)
    own_scalings = {
        record.id: SCALINGS["none" if record.artificial else scale_to](record, spectrum, band) for record in records
    }
    shared = {id: exp(mean(log(own_scalings[each].factor) for each in ids)) for ids in fitting.together for id in ids}
    return tuple(
        ScaledRecord(
            record,
            _scaling(record, spectrum, band, shared[record.id]) if record.id in shared else own_scalings[record.id],
        )
        for record in records
    )


def _scaling(record: Record, spectrum: Spectrum, band: Band, factor: float) -> Scaling:
    return Scaling(factor, misfit(record, spectrum, factor=factor, **vars(band)))


def _to_spectrum(record: Record, spectrum: Spectrum, band: Band) -> Scaling:
    """Scale the record to the least misfit with the spectrum over the band."""
    return scale_to_spectrum(record, spectrum, **vars(band))


def _to_pga(record: Record, spectrum: Spectrum, band: Band) -> Scaling:
    """Scale the record to the PGA of the spectrum."""
    return _scaling(record, spectrum, band, scale_to_pga(record, spectrum.pga))


def _keep_scale(record: Record, spectrum: Spectrum, band: Band) -> Scaling:
    """Leave the record as it is."""
    return _scaling(record, spectrum, band, 1.0)


SCALINGS: dict[ScaleTo, Callable[[Record, Spectrum, Band], Scaling]] = {
    "spectrum": _to_spectrum,
    "pga": _to_pga,
    "none": _keep_scale,
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

    def table(self) -> DataFrame:
        """Return a row for each record: its metadata and measures, in SI."""
        return candidate_table(self.candidates)

    def __repr__(self) -> str:
        return f"OfferedRecords({len(self.candidates)} components, {len(self.problems)} files not read)"


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
    catalogued: list[Candidate] = []
    problems: list[tuple[str, str]] = []
    table = None if flatfile is None else read_flatfile(flatfile)
    for place in (path for path in files if path.is_dir()):
        with catalogue.open_catalogue(kept or catalogue_of(place)) as connection:
            indexed = index(place, connection, overrides=overrides, executor=executor)
            problems += [(str(place / path), why) for path, why in indexed.problems]
            listed = catalogue.catalogue_candidates(connection)
        catalogued += [
            replace(candidate, path=str(catalogue.path_inside(place, candidate.path))) for candidate in listed
        ]
    single_files = [path for path in files if not path.is_dir()]
    read = read_candidates(single_files, overrides=overrides, executor=executor)
    offer = (*catalogued, *read)
    if table is None:
        return OfferedRecords(offer, tuple(problems))
    return OfferedRecords(describe_candidates(offer, table.recordings), tuple(problems), match_flatfile(offer, table))


def catalogue_of(folder: Path) -> Path | None:
    """Return the file of a folder's catalogue; None, in memory alone, if the folder cannot be written."""
    file = folder / catalogue.NAME
    return file if os.access(folder, os.W_OK) else None


def record_set(selection: Selection, periods: Band, *, folder: Path) -> RecordSet:
    """Read the records of a selection from their files; identical ids are numbered.

    Parameters
    ----------
    selection : the selection
    periods : the periods over which it was selected, with weights
    folder : paths are written relative to it
    """
    parts = [(choice, candidate) for choice in selection.choices for candidate in choice.components]
    records = with_unique_names([_described_record(candidate, folder=folder) for _, candidate in parts])
    by_choice: dict[int, list[str]] = {}
    for (choice, _), record in zip(parts, records, strict=True):
        by_choice.setdefault(id(choice), []).append(record.id)
    fitting = Fitting(
        band=periods,
        together=tuple(tuple(ids) for ids in by_choice.values() if len(ids) > 1),
        selection=selection,
        nga=tuple(
            (r.id, candidate.nga) for r, (_, candidate) in zip(records, parts, strict=True) if candidate.nga is not None
        ),
    )
    return RecordSet(records, fitting)


def with_given_factors(suite: RecordSet, selection: Selection, spectrum: Spectrum, *, code: CodeName) -> RecordSet:
    """Give the records of a selection the factors of its choices, which do not follow from the target alone.

    Parameters
    ----------
    suite : the records of the selection
    selection : the selection
    spectrum : the target that the factors refer to
    code : whose rules the suite was made to meet, as `select.for` names it
    """
    factors = [choice.factor for choice in selection.choices for _ in choice.components]
    ids = [record.id for record in suite.records]
    given_factors = GivenFactors(tuple(zip(ids, factors, strict=True)), target_mark(spectrum), code=code)
    return replace(suite, fitting=replace(suite.fitting, given_factors=given_factors))


def read_candidate(candidate: Candidate) -> Record:
    """Read the record of a candidate from its file."""
    return read_with_overrides(Path(candidate.path), candidate.overrides)[candidate.position]


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


def with_unique_names(records: Sequence[Record]) -> tuple[Record, ...]:
    """The records, a second one of the same id numbered "id (2)", and so on."""
    seen: dict[str, int] = {}
    named = []
    for record in records:
        seen[record.id] = seen.get(record.id, 0) + 1
        again = seen[record.id]
        named.append(record if again == 1 else replace(record, id=f"{record.id} ({again})"))
    return tuple(named)


COUNTED_RULES = (RequirementKind.COUNT, RequirementKind.RUN_BELOW)
DIMENSIONS: Mapping[str, str] = {"s": "time", "-": "ratio"}


def suite_faults(
    study: Study, spectrum: Spectrum, motions: Sequence[ScaledRecord]
) -> Mapping[str, tuple[Message, ...]]:
    """Find the rules for suites that the records do not meet, by code.

    Codes whose histories are not requested are included: a floor spectrum is made of the same suite.

    Parameters
    ----------
    study : the study, with its question
    spectrum : the site's elastic spectrum
    motions : the suite

    Returns
    -------
    mapping of str to tuple of Message
        By code; an empty tuple where all rules are met.
    """
    return {code: tuple(_faults_by_code(code, study, spectrum, motions)) for code in RULES}


FACTOR_STEPS = 1000.0  # a factor is proposed to three decimals, rounded to the side that meets the rule
FILES_LINE = 'files = ["records/*.AT2"]'
NO_FACTOR = Term("no one factor does: choose records whose mean has the shape of the target")


@dataclass(frozen=True)
class Remedy:
    """A change of the project: its key, in words, and as a line of TOML, empty if there is none."""

    key: str
    text: Term | Message
    toml: str = ""


@dataclass(frozen=True)
class SuiteReview:
    """A suite with its study and the requirements of a code on it."""

    study: Study
    suite: Suite
    requirements: tuple[Requirement, ...]

    @property
    def unmet(self) -> tuple[Requirement, ...]:
        """The requirements that are not met."""
        return tuple(requirement for requirement in self.requirements if requirement.verdict == "not met")


LONGEST_PERIOD_SHARE = (
    3.0  # artificial records hold periods up to their duration over this, well within what can be fitted
)


class FittedRange(Protocol):
    """The range of periods over which artificial records have to fit the target [s]."""

    def __call__(self, *, longest: float) -> Range:
        """Return the range for the longest period of the mechanisms [s]."""


class PeriodsOf(Protocol):
    """The periods at the limit state, used as T_1 in the clauses of a code [s]."""

    def __call__(self, study: Study) -> Range:
        """Return the shortest and the longest of all mechanisms."""


@dataclass(frozen=True)
class SuiteRules:
    """The rules of one code: its requirements, the range of periods to be fitted, and the periods of the mechanisms.

    by_limit_state : whether the target is the spectrum of the limit state that decides, not the site's
    """

    code: str
    requirements: Requirements
    fitted: FittedRange
    periods: PeriodsOf
    by_limit_state: bool = False


def spectrum_of_rules(code: str, study: Study, spectrum: Spectrum) -> Spectrum:
    """Return the target of a suite: for the Italian code, the spectrum of the limit state that decides, if known.

    Parameters
    ----------
    code : of a procedure, as in `RULES`
    study : the hazard and what decides
    spectrum : the site's
    """
    if not RULES[code].by_limit_state or study.hazard is None:
        return spectrum
    return study.hazard.spectra.get(_deciding_state(study), spectrum)


def artificial_band(study: Study, spectrum: Spectrum, *, duration: float) -> Range:
    """Return the range of periods over which artificial records are made to fit [s]: as the rules require, if possible.

    The longest period is rounded up to a whole second, so that walls that differ a little have the same records. A
    record holds periods up to a share of its duration; further than the target or 10 s nothing is compared.

    Parameters
    ----------
    study : the mechanisms, and the codes that decide
    spectrum : the target
    duration : of the records [s]
    """
    ranges = [RULES[code].fitted(longest=RULES[code].periods(study)[1]) for code in _codes_that_decide(study)]
    longest = ceil(max([MATCHED_PERIODS[1], *(high for _, high in ranges)]))
    return MATCHED_PERIODS[0], min(longest, duration / LONGEST_PERIOD_SHARE, float(FINE[-1]), spectrum.longest_period)


def equivalent_periods(mechanisms: Iterable[Mechanism]) -> dict[str, tuple[float, float]]:
    """Return the shortest and the longest equivalent period [s] of the branches of each mechanism, by name."""
    found = {}
    for mechanism in mechanisms:
        periods = [_equivalent_period(branch) for branch in mechanism.variants.deciding.branches]
        found[mechanism.name] = (min(periods), max(periods))
    return found


def extreme_periods(periods: dict[str, tuple[float, float]]) -> tuple[float, float]:
    """Return the least and the largest of all periods [s]; raise ProjectError if there are none."""
    if not periods:
        raise ProjectError("mechanisms: none to take periods from; add one, or give records.select periods")
    return min(low for low, _ in periods.values()), max(high for _, high in periods.values())


def _scale_records(study: Study, records: Sequence[Record], spectrum: Spectrum) -> tuple[ScaledRecord, ...]:
    """Return the records as the study scales them."""
    factors = study.fitting.given_factors
    if factors is not None:
        return apply_given_factors(records, spectrum, factors, band=study.fitting.band)
    return scale_together(records, spectrum, study.fitting, scale_to=study.scale_to)


def _apply_record_factor(
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
        ScaledRecord(motion.record, _scaling(motion.record, spectrum, band, motion.scaling.factor * factor))
        for motion in motions
    )


def _described_record(candidate: Candidate, *, folder: Path) -> Record:
    """Read the record of a candidate, with the data of a flatfile, and its path as the project file writes it."""
    record = read_candidate(candidate)
    return replace(
        record,
        path=relative_path(Path(candidate.path), folder),
        event=candidate.event,
        station=candidate.station,
        distance=candidate.distance,
        earthquake=replace(record.earthquake, time=candidate.date, magnitude=candidate.magnitude),
        site=replace(record.site, vs30=candidate.vs30),
    )


def _first_messages(messages: Sequence[Message], key: str) -> Iterator[Message]:
    """Yield the first of many messages, and how many others there are."""
    yield from messages[:MOST_NAMED]
    if len(messages) > MOST_NAMED:
        yield warning(key, messages[0].where, number=whole_number(len(messages) - MOST_NAMED))


def _faults_by_code(code: str, study: Study, spectrum: Spectrum, motions: Sequence[ScaledRecord]) -> Iterator[Message]:
    if not motions:
        yield _message_with_remedy("suite-empty", {}, Remedy("records.files", Term("give records"), FILES_LINE))
        return
    rules, target = RULES[code], spectrum_of_rules(code, study, spectrum)
    suite = _suite_on(motions, spectrum, target)
    shortest, longest = rules.periods(study)
    review = SuiteReview(study, suite, rules.requirements(suite, shortest=shortest, longest=longest))
    yield from _not_named(code, review)
    yield from (
        _unmet_message(requirement, REMEDIES[requirement.kind](requirement, review)) for requirement in review.unmet
    )
    yield from (
        _out_of_reach(requirement, review)
        for requirement in review.requirements
        if requirement.verdict == "not answered"
    )


def _suite_on(motions: Sequence[ScaledRecord], spectrum: Spectrum, target: Spectrum) -> Suite:
    """Return the suite as run for the limit state of `target`: at the PGA of `target`, not at the site's."""
    share = target.pga / spectrum.pga
    return suite_of([m.record for m in motions], [m.scaling.factor * share for m in motions], target)


def _not_named(code: str, review: SuiteReview) -> Iterator[Message]:
    """Yield a message if artificial records would decide without the project naming the method."""
    question = review.study.question
    deciding = [name for name in methods_of(question) if PROCEDURES[name].suite_rules == code]
    not_named = [name for name in deciding if name not in (question.procedures or ())]
    if review.suite.artificial.any() and not_named:
        line = f'procedures = ["{not_named[0]}"]'
        remedy = Remedy("verdict.procedures", Term("name it there"), line)
        yield _message_with_remedy("suite-not-named", {"procedure": not_named[0]}, remedy)


def _unmet_message(requirement: Requirement, remedy: Remedy) -> Message:
    """Return the message on a rule that is not met."""
    low, high = requirement.periods or (0.0, 0.0)
    values: dict[str, Value] = {
        "code": requirement.code,
        "clause": requirement.clause,
        "found": _quantity_of(requirement, requirement.value or 0.0),
        "limit": _quantity_of(requirement, requirement.limit),
        "low": Quantity(low, "time", 3),
        "high": Quantity(high, "time", 3),
    }
    return _message_with_remedy(f"suite-{requirement.kind}", values, remedy)


def _out_of_reach(requirement: Requirement, review: SuiteReview) -> Message:
    """Return the message on a rule over periods beyond the target or the records."""
    assert requirement.periods is not None
    low, high = (Quantity(period, "time", 3) for period in requirement.periods)
    ends = Quantity(review.suite.period_range[1], "time", 3)
    values: dict[str, Value] = {
        "code": requirement.code,
        "clause": requirement.clause,
        "low": low,
        "high": high,
        "end": ends,
    }
    return _message_with_remedy("suite-out-of-reach", values, Remedy("site.spectrum", Term("extend its table")))


def _message_with_remedy(key: str, values: Mapping[str, Value], remedy: Remedy) -> Message:
    all_values: dict[str, Value] = {**values, "remedy": remedy.text, "toml": remedy.toml}
    return message(key, all_values, severity=Severity.WARNING, where=remedy.key)


def _quantity_of(requirement: Requirement, value: float) -> Quantity:
    return (
        whole_number(round(value))
        if requirement.kind in COUNTED_RULES
        else Quantity(value, DIMENSIONS[requirement.unit], 3)
    )


def _more_records(requirement: Requirement, review: SuiteReview) -> Remedy:
    """Propose as many more records as are missing."""
    missing = round(requirement.limit - (requirement.value or 0.0))
    number = {"number": whole_number(missing)}
    text = message("remedy-records", number) if missing > 1 else Term("give 1 more record")
    return _remake(text, review) or Remedy("records.files", text, FILES_LINE)


def _longer_records(requirement: Requirement, review: SuiteReview) -> Remedy:
    """Propose artificial records of a longer duration."""
    text = message("remedy-longer", {"duration": Quantity(_required_duration(requirement, review), "time", 6)})
    return _remake(text, review) or Remedy("records.files", text)


def _finer_records(requirement: Requirement, review: SuiteReview) -> Remedy:
    """Propose records of a smaller time step."""
    return Remedy("records.files", message("remedy-finer", {"step": Quantity(requirement.limit, "time", 6)}))


def _other_records(requirement: Requirement, review: SuiteReview) -> Remedy:
    """Propose records that contain longer periods."""
    return Remedy("records.files", Term("give records whose processing kept longer periods"))


def _another_factor(requirement: Requirement, review: SuiteReview) -> Remedy:
    """Propose one further factor on every record, times the one of the project; other records if no factor helps.

    Artificial records that are too short for the required periods are made longer instead.
    """
    if _required_duration(requirement, review):
        return _longer_records(requirement, review)
    factor = common_factor(review.requirements)
    if factor is None:
        return Remedy("records.files", NO_FACTOR)
    rounded = (
        ceil(factor * FACTOR_STEPS) / FACTOR_STEPS if factor > 1.0 else floor(factor * FACTOR_STEPS) / FACTOR_STEPS
    )
    whole = review.study.record_factor * rounded
    text = message("remedy-factor", {"factor": Quantity(rounded, "ratio", 6)})
    return Remedy("records.factor", text, f"factor = {whole:.6g}")


REMEDIES: Mapping[RequirementKind, Callable[[Requirement, SuiteReview], Remedy]] = {
    RequirementKind.COUNT: _more_records,
    RequirementKind.STEP: _finer_records,
    RequirementKind.DURATION: _longer_records,
    RequirementKind.STATIONARY: _longer_records,
    RequirementKind.USABLE: _other_records,
    RequirementKind.MEAN_LOW: _another_factor,
    RequirementKind.MEAN_HIGH: _another_factor,
    RequirementKind.RUN_BELOW: _another_factor,
}


def _remake(text: Term | Message, review: SuiteReview) -> Remedy | None:
    """Return the line that makes artificial records as all rules require; None if records come from files."""
    to_make = review.study.artificial
    if to_make is None:
        return None
    improved = _improve_artificial(to_make, review)
    seed = "" if improved.seed is None else f"seed = {improved.seed}, "
    line = f'synthetic = {{ count = {improved.count}, {seed}duration = "{improved.duration:g} s" }}'
    return Remedy("records.synthetic", text, line)


def _improve_artificial(to_make: ArtificialRecords, review: SuiteReview) -> ArtificialRecords:
    """Return the artificial records with the number and the duration that the rules require."""
    missing = [
        round(requirement.limit - (requirement.value or 0.0))
        for requirement in review.unmet
        if requirement.kind == RequirementKind.COUNT
    ]
    durations = [_required_duration(requirement, review) for requirement in review.unmet]
    return replace(to_make, count=to_make.count + max(missing, default=0), duration=max([to_make.duration, *durations]))


def _required_duration(requirement: Requirement, review: SuiteReview) -> float:
    """Return the duration [s] that a rule requires of artificial records, directly, by level part or by periods."""
    if requirement.kind == RequirementKind.DURATION:
        return requirement.limit
    if requirement.kind == RequirementKind.STATIONARY:
        return requirement.limit / STATIONARY
    to_make, end = review.study.artificial, 0.0 if requirement.periods is None else requirement.periods[1]
    return (
        0.0
        if to_make is None or end * LONGEST_PERIOD_SHARE <= to_make.duration
        else float(ceil(end * LONGEST_PERIOD_SHARE))
    )


def _periods_at_allowable_rotation(study: Study) -> Range:
    """Return the periods of equal work at half the overturning rotation [s], for ASCE 43-05."""
    return extreme_periods(equivalent_periods(study.mechanisms))


def _periods_at_limit_state(study: Study) -> Range:
    """Return T_SLV or T_SLC, and the building's T_1 if a mechanism is above the ground [s], for NTC 2018."""
    state = _deciding_state(study)
    low, high = extreme_periods(_limit_state_periods(study.mechanisms, state=state))
    above = any(study.heights[mechanism.name].base > 0.0 for mechanism in study.mechanisms)  # if only on a plinth
    if study.building is None or not above:
        return low, high
    return min(low, study.building.period), max(high, study.building.period)


def _deciding_state(study: Study) -> str:
    """Return the ultimate limit state that decides by the Italian code; SLV if another code decides."""
    return next((state for state in deciding_limit_states(study.question) if state in ULTIMATE), "SLV")


RULES: Mapping[str, SuiteRules] = {
    "asce43-05": SuiteRules(
        asce43_05.CODE, asce43_05.requirements, asce43_05.fit_periods, _periods_at_allowable_rotation
    ),
    "ntc2018": SuiteRules(
        ntc2018.CODE, ntc2018.requirements, ntc2018.fit_periods, _periods_at_limit_state, by_limit_state=True
    ),
}
"""By the code that a procedure names as its `suite_rules`."""


def _codes_of_histories(study: Study) -> tuple[str, ...]:
    """Return the codes whose procedures by histories are requested."""
    return tuple(dict.fromkeys(PROCEDURES[name].suite_rules for name in study.procedures if uses_histories(name)))


def _codes_that_decide(study: Study) -> tuple[str, ...]:
    """Return the codes whose procedures by histories may decide; if none may, those requested."""
    deciding = [PROCEDURES[name].suite_rules for name in methods_of(study.question) if uses_histories(name)]
    return tuple(dict.fromkeys(deciding)) or _codes_of_histories(study)


LARGEST_FC = 1.35  # of LC1, which makes the longest periods
SHARE_OF_SHORTEST, MULTIPLE_OF_LONGEST = 0.2, 1.2  # of equivalent periods: the range that spectra are fitted over
FITTED_OVER = "0.2 times the least to 1.2 times the largest equivalent period of the mechanisms"


def _equivalent_period(branch: Branch) -> float:
    """Return the equivalent period [s] of a branch at the allowable rotation."""
    return float(1.0 / effective_frequency(branch, np.array([HALF * branch.unstable]))[0])


def _limit_state_periods(mechanisms: Iterable[Mechanism], *, state: str) -> dict[str, tuple[float, float]]:
    """Return the shortest and the longest T_SLV or T_SLC [s] of each mechanism (NTC 2018, C8.7.1.10, 11), by name."""
    found = {}
    for mechanism in mechanisms:
        branches = curves_of_all_actions(mechanism.variants.deciding)
        periods = [capacity_of(curves, state=state, confidence_factor=LARGEST_FC).T for curves in branches]
        found[mechanism.name] = (min(periods), max(periods))
    return found
