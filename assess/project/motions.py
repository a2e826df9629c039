"""The ground motions of a study: read or made, and scaled to its target."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import exp, log
from statistics import mean

from assess.project.study import Fitting, ScaleTo, Study
from records.band import Band
from records.record import Record
from records.scaling import Scaling, misfit, scale_to_pga, scale_to_spectrum
from records.synthetic import artificial
from spectra.spectrum import Spectrum


@dataclass(frozen=True)
class Motion:
    """A record as read, the factor that brings it to the target, and the misfit left (mean squared log)."""

    record: Record
    scaling: Scaling


def motions_of(study: Study, spectrum: Spectrum, *, jobs: int = 1) -> tuple[Motion, ...]:
    """Every record of the study, files first, each with its scaling; `jobs` threads, 0 for all cores."""
    return scaled_together(
        (*study.records, *_made(study, spectrum, jobs=jobs)), spectrum, study.fitting, scale_to=study.scale_to
    )


def _made(study: Study, spectrum: Spectrum, *, jobs: int) -> tuple[Record, ...]:
    made = study.artificial
    if made is None:
        return ()
    return artificial(spectrum, count=made.count, seed=made.seed, duration=made.duration, threads=jobs)


def scaled_together(
    records: Sequence[Record], spectrum: Spectrum, given: Fitting, *, scale_to: ScaleTo
) -> tuple[Motion, ...]:
    """Each record with its scaling; those that `given` keeps together share the geometric mean of their factors.

    That is the factor of least misfit, or to the PGA, of the geometric mean of their spectra.
    """
    band = given.band
    alone = {record.id: SCALINGS[scale_to](record, spectrum, band) for record in records}
    shared = {id: exp(mean(log(alone[each].factor) for each in ids)) for ids in given.together for id in ids}
    return tuple(
        Motion(one, _scaling(one, spectrum, band, shared[one.id]) if one.id in shared else alone[one.id])
        for one in records
    )


def _scaling(record: Record, spectrum: Spectrum, band: Band, factor: float) -> Scaling:
    return Scaling(factor, misfit(record, spectrum, factor=factor, period=band.period, weight=band.weight))


def to_spectrum(record: Record, spectrum: Spectrum, band: Band) -> Scaling:
    """The record brought as near to the spectrum as it comes over the band."""
    return scale_to_spectrum(record, spectrum, period=band.period, weight=band.weight)


def to_pga(record: Record, spectrum: Spectrum, band: Band) -> Scaling:
    """The record brought to the spectrum's PGA."""
    return _scaling(record, spectrum, band, scale_to_pga(record, spectrum.pga))


def as_it_is(record: Record, spectrum: Spectrum, band: Band) -> Scaling:
    """The record as it is."""
    return _scaling(record, spectrum, band, 1.0)


SCALINGS: dict[ScaleTo, Callable[[Record, Spectrum, Band], Scaling]] = {
    "spectrum": to_spectrum,
    "pga": to_pga,
    "none": as_it_is,
}
