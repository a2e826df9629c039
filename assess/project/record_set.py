"""The table [records]: all records that it names, or the suite that it describes."""

from __future__ import annotations

from collections.abc import Iterable
from concurrent.futures import Executor
from dataclasses import replace
from pathlib import Path

from assess.errors import ProjectError
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message
from assess.project import sections
from assess.study.periods import ABOVE, BELOW, equivalent_periods, extreme_periods
from assess.study.record_set import (
    EVERYWHERE,
    RecordSet,
    candidate_records,
    offer_messages,
    read_candidate,
    record_messages,
    record_set,
    with_given_factors,
    with_unique_names,
)
from assess.study.study import Fitting, Study
from assess.study.suite_rules import RULES, spectrum_of_rules
from records.band import Band, band
from records.candidates import PERIODS
from records.code_suites import Target, band_for, select_for
from records.compliance.making import MAKING
from records.errors import RecordError
from records.formats.header_overrides import HeaderOverrides
from records.paths import relative_path
from records.reading import recall_records
from records.selection import Criteria, Filters, select
from spectra.spectrum import Spectrum


def all_of(section: sections.Records, folder: Path) -> RecordSet:
    """Read every record that [records] names; `folder` is that of the project file."""
    found = [record for path in section.files for record in recall_records(path, overrides_of(section))]
    records = with_unique_names([replace(one, path=relative_path(Path(one.path), folder)) for one in found])
    return RecordSet(records, Fitting(EVERYWHERE))


def overrides_of(section: sections.Records) -> HeaderOverrides:
    """Return what [records] states for files that do not state it themselves."""
    return HeaderOverrides(section.unit, section.step, section.response)


def select_records(
    section: sections.Records,
    wanted: sections.Select,
    *,
    study: Study,
    spectrum: Spectrum,
    folder: Path,
    executor: Executor | None = None,
) -> tuple[RecordSet, tuple[Message, ...]]:
    """Select the suite that [records.select] describes, with messages about it.

    Parameters
    ----------
    section, wanted : [records] and its table of the selection
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
        if wanted.code is None:
            over = band(*periods_of(wanted, spectrum, study.mechanisms), weights=wanted.weights)
            found = select(offer.candidates, spectrum, criteria_of(section, wanted, over))
        else:
            making, target = MAKING[wanted.code], target_of(MAKING[wanted.code].code, study, spectrum)
            over = band_for(making, target)
            if wanted.periods is not None:
                over = band(*wanted.periods, weights=wanted.weights)
            criteria = criteria_of(section, wanted, over)
            found = select_for(offer.candidates, making, target, criteria, read=read_candidate)
    except RecordError as error:
        raise ProjectError(f"records.select: {error}") from None
    suite = record_set(found, over, folder=folder)
    if wanted.code is not None:
        suite = with_given_factors(suite, found, spectrum, code=wanted.code)
    return suite, (*offer_messages(offer), *record_messages(suite.records))


def target_of(code: str, study: Study, spectrum: Spectrum) -> Target:
    """Return what the rules of a code are checked with: its own spectrum and periods where it has any."""
    own = {rules.code: (name, rules) for name, rules in RULES.items()}
    if code not in own:
        return Target(spectrum, spectrum, *extreme_periods(equivalent_periods(study.mechanisms)))
    name, rules = own[code]
    return Target(spectrum, spectrum_of_rules(name, study, spectrum), *rules.periods(study))


def periods_of(wanted: sections.Select, spectrum: Spectrum, mechanisms: Iterable[Mechanism]) -> tuple[float, float]:
    """Return the range given, else 0.2 times the least to 1.2 times the largest equivalent period [s]."""
    if wanted.periods is not None:
        return wanted.periods
    least, largest = extreme_periods(equivalent_periods(mechanisms))
    longest = min(float(PERIODS[-1]), spectrum.longest_period)
    return max(BELOW * least, float(PERIODS[0])), min(ABOVE * largest, longest)


def criteria_of(section: sections.Records, wanted: sections.Select, over: Band) -> Criteria:
    """Return the criteria of the selection."""
    filters = Filters(wanted.magnitude, wanted.distance, wanted.vs30, wanted.pga, wanted.duration, wanted.events)
    return Criteria(
        count=wanted.count,
        band=over,
        filters=filters,
        scale_limits=wanted.scale_limits,
        one_per_event=wanted.one_per_event,
        fit=wanted.fit,
        components=wanted.components,
        scale_to=section.scale_to,
    )
