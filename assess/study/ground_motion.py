"""The suite of records compared with its target: means, misfit, and the requirements of codes."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType

import numpy as np
from scipy.constants import g

from assess.messages.message import Message, Quantity, Term, message
from assess.results import EquivalentPeriods, GroundMotionResult, Remaining, RequirementResult, SelectionResult
from assess.study.motions import ScaledRecord
from assess.study.oscillator_results import floats
from assess.study.periods import ABOVE, BELOW, FITTED_OVER, equivalent_periods, extreme_periods
from assess.study.site_results import display_periods
from assess.study.study import Fitting, Study
from assess.study.suite_rules import RULES
from records.band import Band, truncate_band
from records.compliance.making import MAKING
from records.compliance.registry import all_requirements
from records.compliance.requirement import Requirement
from records.compliance.suite import DAMPING, suite_of
from records.response import response_spectrum
from records.scaling import log_ratio, mean_square
from records.selection import Selection
from spectra.spectrum import Spectrum


def ground_motion(study: Study, spectrum: Spectrum, motions: Sequence[ScaledRecord]) -> GroundMotionResult | None:
    """Return the scaled suite of a study, compared with its target.

    Parameters
    ----------
    study : Study
        The study.
    spectrum : Spectrum
        The target.
    motions : sequence of ScaledRecord
        The suite.

    Returns
    -------
    GroundMotionResult or None
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
    motions : sequence of ScaledRecord
        The suite.
    spectrum : Spectrum
        The target.
    fitting : Fitting
        Range of periods of the scaling, and how the records were chosen.
    source : str
        Source of the range, in words.
    equivalent : dict
        Shortest and longest equivalent period of each mechanism by name [s]. If empty, those are used whose multiples
        the range is.
    own : mapping
        Shortest and longest period by code, for codes that define their own [s].

    Returns
    -------
    GroundMotionResult
        With the requirements of every code.
    """
    given = fitting.given
    low, high = truncate_band(fitting.band, spectrum.longest_period).ends
    shortest, longest = extreme_periods(equivalent) if equivalent else (low / BELOW, high / ABOVE)
    period = display_periods(spectrum)
    spectra = np.array([m.scaling.factor * response_spectrum(m.record, period, damping=DAMPING) for m in motions])
    return GroundMotionResult(
        from_s=low,
        to_s=high,
        source=source,
        equivalent_periods=tuple(EquivalentPeriods(name, *of) for name, of in equivalent.items()),
        period_s=floats(period),
        target_g=floats(spectrum.acceleration(period, damping=DAMPING) / g),
        mean_g=floats(spectra.mean(axis=0) / g),
        geometric_mean_g=floats(np.exp(np.log(spectra).mean(axis=0)) / g),
        misfit=misfit_of_mean(motions, spectrum, fitting.band),
        selection=None if fitting.selection is None else selection_result(fitting.selection),
        requirements=requirements_of(motions, spectrum, shortest, longest, own),
        lock="" if given is None else given.lock,
        made_for=MAKING[given.code].code if given is not None and given.code else "",
    )


def source_of(study: Study) -> str:
    """Return the source of the range of periods, in words."""
    if study.fitting.given is not None and study.fitting.given.lock:
        return "as the suite was locked"
    if study.fitting.selection is None:
        return "default of the scaling by least squares"
    given = study.resolved.get("records.select.periods")
    if given is not None and given.given:
        return "given"
    if study.fitting.given is not None:
        return "the range of the code whose rules the suite was made to meet"
    return FITTED_OVER


def misfit_of_mean(motions: Sequence[ScaledRecord], spectrum: Spectrum, band: Band) -> float:
    """Return the mean squared natural-log difference between the mean spectrum and the target over the band [-]."""
    over = truncate_band(band, spectrum.longest_period)
    ratios = [
        m.scaling.factor * np.exp(-log_ratio(m.record, spectrum, period=over.period, nodes=over.nodes)) for m in motions
    ]
    return float(mean_square(np.log(np.mean(ratios, axis=0)), weight=over.weight))


def requirements_of(
    motions: Sequence[ScaledRecord],
    spectrum: Spectrum,
    shortest: float,
    longest: float,
    own: Mapping[str, tuple[float, float]],
) -> tuple[RequirementResult, ...]:
    """Return the requirements of every code; shortest, longest: equivalent periods [s]; own: those of some codes."""
    suite = suite_of([m.record for m in motions], [m.scaling.factor for m in motions], spectrum)
    found = all_requirements(suite, shortest=shortest, longest=longest, own=own)
    return tuple(requirement_result(one) for one in found)


def requirement_result(one: Requirement) -> RequirementResult:
    """Return a requirement as a result."""
    low, high = one.periods or (None, None)
    return RequirementResult(
        code=one.code,
        clause=one.clause,
        what=one.what,
        value=one.value,
        sense=one.sense,
        limit=one.limit,
        unit=one.unit,
        verdict=one.verdict,
        from_s=low,
        to_s=high,
        remark=one.remark,
        caveat=one.caveat,
        remarks=tuple(_remarks(one)),
    )


def _remarks(one: Requirement) -> Iterator[Term | Message]:
    """Yield the factor that would do, the range of the target, and the note of a requirement."""
    if one.factor is not None:
        yield message("further-factor", {"factor": Quantity(one.factor)})
    if one.known is not None:
        low, high = one.known
        yield message("target-known", {"low": Quantity(low, "time", 3), "high": Quantity(high, "time")})
    if one.note:
        yield Term(one.note)


def selection_result(found: Selection) -> SelectionResult:
    """Return how a suite was chosen as a result."""
    of = found.criteria
    return SelectionResult(
        fit=of.fit,
        components=of.components,
        one_per_event=of.one_per_event,
        least_factor=of.scale_limits[0],
        largest_factor=of.scale_limits[1],
        remaining=tuple(Remaining(step, number) for step, number in found.counted),
        misfit=found.misfit,
        greedy_misfit=found.greedy,
    )
