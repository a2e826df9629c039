"""The ground motions of a study, recorded or artificial, scaled to its target."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import exp, log
from statistics import mean

from assess.errors import ProjectError
from assess.messages.message import Quantity, note
from assess.study.study import Fitting, GivenFactors, ScaleTo, Study
from assess.study.suite_rules import made_band
from records.band import Band, truncate_band
from records.compliance.asce43_05 import fit_of_mean
from records.compliance.requirement import factor_that_does
from records.compliance.suite import suite_of
from records.fingerprints import target_mark
from records.record import Record, with_step
from records.scaling import Scaling, misfit, scale_to_pga, scale_to_spectrum
from records.synthetic import artificial
from spectra.spectrum import Spectrum


@dataclass(frozen=True)
class ScaledRecord:
    """A record as read, with the factor that scales it to the target, and the remaining misfit (mean squared log)."""

    record: Record
    scaling: Scaling


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
        return multiply(scale_records(study, study.records, spectrum), spectrum, study)
    band = made_band(study, spectrum, duration=made.duration)
    own = artificial(spectrum, count=made.count, seed=made.seed, duration=made.duration, band=band, threads=jobs)
    motions = scale_records(study, (*study.records, *own), spectrum)
    if not study.records and study.scale_to == "spectrum":
        motions = raise_artificial(motions, spectrum, band, fitting=study.fitting)
    return multiply(motions, spectrum, study)


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
    factor = factor_that_does(fit_of_mean(suite, band)) or 1.0
    if factor <= 1.0:
        return motions
    said = note("suite-raised", factor=Quantity(factor, figures=6), period=Quantity(band[1], "time", 3))
    noted = tuple(replace(each, record=with_step(each.record, said)) for each in motions)
    return _multiply_all(noted, factor, spectrum, fitting.band)


def multiply(motions: tuple[ScaledRecord, ...], spectrum: Spectrum, study: Study) -> tuple[ScaledRecord, ...]:
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
