"""The ground motion in the results: the site's spectrum, each record with its primary pulses, and the suite.

The suite is compared with its target: means, misfit, and the requirements of codes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from assess.messages.message import Message, Quantity, Term, message
from assess.results import (
    EquivalentPeriods,
    GroundMotionResult,
    PrimaryPulseResult,
    RecordResult,
    RecordSpectrum,
    RemainingCandidates,
    RequirementResult,
    SelectionResult,
    SpectrumResult,
)
from assess.study.study import Fitting, PulseGrid, ScaledRecord, Study
from assess.study.suites import (
    FITTED_OVER,
    MULTIPLE_OF_LONGEST,
    RULES,
    SHARE_OF_SHORTEST,
    equivalent_periods,
    extreme_periods,
)
from records.candidates import sequence_number
from records.compliance import SELECTION_RULES, all_requirements
from records.compliance.suite import DAMPING, Requirement, suite_of
from records.pulses import primary_pulses
from records.record import scale
from records.response import response_spectrum
from records.scaling import Band, log_ratio, mean_square, truncate_band
from records.selection import Selection
from spectra.arrays import FloatArray
from spectra.gravity import g
from spectra.spectrum import Spectrum


def ground_motion(study: Study, spectrum: Spectrum, motions: Sequence[ScaledRecord]) -> GroundMotionResult | None:
    """Return the scaled suite of a study, compared with its target.

    Parameters
    ----------
    study : the study
    spectrum : the target
    motions : the suite

    Returns
    -------
    None without records.
    """
    if not motions:
        return None
    return ground_motion_result(
        motions,
        spectrum,
        study.fitting,
        source=source_of(study),
        equivalent=equivalent_periods(study.mechanisms),
        own={rules.code: rules.periods(study) for rules in RULES.values()},
    )


def ground_motion_result(
    motions: Sequence[ScaledRecord],
    spectrum: Spectrum,
    fitting: Fitting,
    *,
    source: str,
    equivalent: dict[str, tuple[float, float]],
    own: Mapping[str, tuple[float, float]] = MappingProxyType({}),
) -> GroundMotionResult:
    """Return a suite compared with its target.

    Parameters
    ----------
    motions : the suite
    spectrum : the target
    fitting : range of periods of the scaling, and how the records were chosen
    source : source of the range, in words
    equivalent : shortest and longest equivalent period of each mechanism by name [s]. If empty, those are used whose
        multiples the range is.
    own : shortest and longest period by code, for codes that define their own [s]

    Returns
    -------
    With the requirements of every code.
    """
    factors = fitting.given_factors
    low, high = truncate_band(fitting.band, spectrum.longest_period).ends
    shortest, longest = (
        extreme_periods(equivalent) if equivalent else (low / SHARE_OF_SHORTEST, high / MULTIPLE_OF_LONGEST)
    )
    period = _display_periods(spectrum)
    spectra = np.array(
        [motion.scaling.factor * response_spectrum(motion.record, period, damping=DAMPING) for motion in motions]
    )
    return GroundMotionResult(
        from_s=low,
        to_s=high,
        source=source,
        equivalent_periods=tuple(EquivalentPeriods(name, *periods) for name, periods in equivalent.items()),
        period_s=tuple(period.tolist()),
        target_g=tuple((spectrum.acceleration(period, damping=DAMPING) / g).tolist()),
        mean_g=tuple((spectra.mean(axis=0) / g).tolist()),
        geometric_mean_g=tuple((np.exp(np.log(spectra).mean(axis=0)) / g).tolist()),
        misfit=misfit_of_mean(motions, spectrum, fitting.band),
        selection=None if fitting.selection is None else _selection_result(fitting.selection),
        requirements=_requirements_of(motions, spectrum, shortest, longest, own),
        lock="" if factors is None else factors.lock,
        made_for=SELECTION_RULES[factors.code].code if factors is not None and factors.code else "",
    )


def source_of(study: Study) -> str:
    """Return the source of the range of periods, in words."""
    if study.fitting.given_factors is not None and study.fitting.given_factors.lock:
        return "as the suite was locked"
    if study.fitting.selection is None:
        return "default of the scaling by least squares"
    periods = study.resolved.get("records.select.periods")
    if periods is not None and periods.given:
        return "given"
    if study.fitting.given_factors is not None:
        return "the range of the code whose rules the suite was made to meet"
    return FITTED_OVER


def misfit_of_mean(motions: Sequence[ScaledRecord], spectrum: Spectrum, band: Band) -> float:
    """Return the mean squared natural-log difference between the mean spectrum and the target over the band [-]."""
    used_band = truncate_band(band, spectrum.longest_period)
    ratios = [
        motion.scaling.factor
        * np.exp(-log_ratio(motion.record, spectrum, period=used_band.period, nodes=used_band.nodes))
        for motion in motions
    ]
    return float(mean_square(np.log(np.mean(ratios, axis=0)), weight=used_band.weight))


def spectrum_result(spectrum: Spectrum) -> SpectrumResult:
    """Return the site's spectrum at the periods shown."""
    period = _display_periods(spectrum)
    scale = {} if spectrum.factor == 1.0 else {"scale": spectrum.factor}
    return SpectrumResult(
        code=spectrum.code,
        parameters={**spectrum.parameters, **scale},
        damping=spectrum.damping,
        damping_rule=spectrum.damping_rule,
        clause=spectrum.clause,
        pga_g=spectrum.pga / g,
        period_s=tuple(period.tolist()),
        acceleration_g=tuple((spectrum.acceleration(period) / g).tolist()),
    )


def record_result(motion: ScaledRecord, spectrum: Spectrum, *, nga: int | None = None) -> RecordResult:
    """Return a record as used.

    Parameters
    ----------
    motion : the record with its factor
    spectrum : the site's spectrum, at whose periods that of the record is given
    nga : its number in the NGA database; by default the one in its file name

    Returns
    -------
    The record scaled to the site.
    """
    used = scale(motion.record, motion.scaling.factor)
    period = _display_periods(spectrum)
    return RecordResult(
        id=used.id,
        path=used.path,
        event=used.event,
        station=used.station,
        component=used.component,
        dt_s=used.dt,
        npts=used.npts,
        pga_g=used.pga / g,
        scale_factor=motion.scaling.factor,
        mse=motion.scaling.mse,
        trail=tuple(map(str, used.processing_history)),
        processing=used.processing_history,
        spectrum=RecordSpectrum(tuple(period.tolist()), tuple((response_spectrum(used, period) / g).tolist())),
        date=used.earthquake.time,
        magnitude=used.earthquake.magnitude,
        distance_km=None if used.distance is None else used.distance / 1000.0,
        vs30_m_per_s=used.site.vs30,
        nga=sequence_number(used.path) if nga is None else nga,
    )


MOST_PULSES = 3  # of a record: the best, and the next ones, which may be longer and match worse
LEAST_ENERGY_SHARE = 0.1  # of the energy that the best pulse explains: pulses that explain less are dropped


def with_primary_pulses(
    records: Sequence[RecordResult], motions: Sequence[ScaledRecord], grid: PulseGrid | None
) -> tuple[RecordResult, ...]:
    """Return the records with the pulses of the grid's shape found in them, scaled as they are."""
    if grid is None:
        return tuple(records)
    return tuple(
        replace(record, primary_pulses=_pulses_of(motion, grid))
        for record, motion in zip(records, motions, strict=True)
    )


def _requirements_of(
    motions: Sequence[ScaledRecord],
    spectrum: Spectrum,
    shortest: float,
    longest: float,
    own: Mapping[str, tuple[float, float]],
) -> tuple[RequirementResult, ...]:
    """Return the requirements of every code; shortest, longest: equivalent periods [s]; own: those of some codes."""
    suite = suite_of([motion.record for motion in motions], [motion.scaling.factor for motion in motions], spectrum)
    requirements = all_requirements(suite, shortest=shortest, longest=longest, own=own)
    return tuple(_requirement_result(requirement) for requirement in requirements)


def _requirement_result(requirement: Requirement) -> RequirementResult:
    """Return a requirement as a result."""
    low, high = requirement.periods or (None, None)
    return RequirementResult(
        code=requirement.code,
        clause=requirement.clause,
        what=requirement.what,
        value=requirement.value,
        sense=requirement.sense,
        limit=requirement.limit,
        unit=requirement.unit,
        verdict=requirement.verdict,
        from_s=low,
        to_s=high,
        remark=requirement.remark,
        caveat=requirement.caveat,
        remarks=tuple(_remarks(requirement)),
    )


def _remarks(requirement: Requirement) -> Iterator[Term | Message]:
    """Yield the factor that would do, the range of the target, and the note of a requirement."""
    if requirement.factor is not None:
        yield message("further-factor", {"factor": Quantity(requirement.factor)})
    if requirement.known is not None:
        low, high = requirement.known
        yield message("target-known", {"low": Quantity(low, "time", 3), "high": Quantity(high, "time")})
    if requirement.note:
        yield Term(requirement.note)


def _selection_result(selection: Selection) -> SelectionResult:
    """Return how a suite was chosen as a result."""
    criteria = selection.criteria
    return SelectionResult(
        fit=criteria.fit,
        components=criteria.components,
        one_per_event=criteria.one_per_event,
        least_factor=criteria.scale_limits[0],
        largest_factor=criteria.scale_limits[1],
        remaining=tuple(RemainingCandidates(step, number) for step, number in selection.counted),
        misfit=selection.misfit,
        greedy_misfit=selection.greedy,
    )


SHORTEST_SHOWN = 0.01  # [s]
LONGEST_PERIOD = 10.0  # s, of the spectra in the results, where the spectrum reaches so far
ROUND_PERIODS = (0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 7.5)
"""Periods that are shown in any case [s]."""
SAME_PERIOD = 1e-9  # relative difference of periods that are one


def _display_periods(spectrum: Spectrum) -> FloatArray:
    """Return the periods [s] at which spectra are shown: 0, even in the logarithm, round and corner periods."""
    longest = min(LONGEST_PERIOD, spectrum.longest_period)
    corners = [float(value) for key, value in spectrum.parameters.items() if key.startswith("t_") and value != "none"]
    extra = [period for period in (*ROUND_PERIODS, *corners) if SHORTEST_SHOWN < period < longest]
    even = np.geomspace(SHORTEST_SHOWN, longest, 160)
    apart = [period for period in extra if np.abs(even / period - 1.0).min() > SAME_PERIOD]
    return np.concatenate(([0.0], np.unique(np.concatenate([even, apart]))))


def _pulses_of(motion: ScaledRecord, grid: PulseGrid) -> tuple[PrimaryPulseResult, ...]:
    """Return the pulses that match one motion best, each as the motion is scaled."""
    pulses = primary_pulses(motion.record, shape=grid.shape, count=MOST_PULSES)
    return tuple(
        PrimaryPulseResult(
            shape=pulse.shape.name,
            frequency_hz=pulse.frequency,
            amplitude_g=pulse.amplitude * motion.scaling.factor / g,
            start_s=pulse.start,
            polarity=pulse.polarity,
            energy_share=pulse.energy_share,
        )
        for pulse in pulses
        if pulse.energy_share >= LEAST_ENERGY_SHARE * pulses[0].energy_share
    )
