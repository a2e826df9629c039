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
    record_messages,
    record_set,
    with_unique_names,
)
from assess.study.study import Fitting
from records.band import Band, band
from records.candidates import PERIODS
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
    spectrum: Spectrum,
    mechanisms: Iterable[Mechanism],
    folder: Path,
    executor: Executor | None = None,
) -> tuple[RecordSet, tuple[Message, ...]]:
    """Select the suite that [records.select] describes, with messages about it; `folder` is that of the project file.

    executor : processes that share the reading of many files
    """
    overrides = overrides_of(section)
    offer = candidate_records(section.files, overrides=overrides, flatfile=section.flatfile, executor=executor)
    try:
        over = band(*periods_of(wanted, spectrum, mechanisms), weights=wanted.weights)
        found = select(offer.candidates, spectrum, criteria_of(section, wanted, over))
    except RecordError as error:
        raise ProjectError(f"records.select: {error}") from None
    suite = record_set(found, over, folder=folder)
    return suite, (*offer_messages(offer), *record_messages(suite.records))


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
