"""The suite of records beside its target: means, misfit, and what codes say of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

import numpy as np
from scipy.constants import g

from assess.results import EquivalentPeriods, GroundMotionResult, Remaining, RequirementResult, SelectionResult
from assess.study.motions import ScaledRecord
from assess.study.oscillator_results import floats
from assess.study.periods import ABOVE, BELOW, equivalent_periods, extreme_periods
from assess.study.site_results import display_periods
from assess.study.study import Fitting, Study
from assess.study.suite_rules import RULES
from records.band import Band, truncate_band
from records.compliance.registry import all_requirements
from records.compliance.requirement import Requirement
from records.compliance.suite import DAMPING, suite_of
from records.response import response_spectrum
from records.scaling import log_ratio, mean_square
from records.selection import Selection
from spectra.spectrum import Spectrum


def ground_motion(study: Study, spectrum: Spectrum, motions: Sequence[ScaledRecord]) -> GroundMotionResult | None:
    """The suite of a study as scaled; None without records."""
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
    """A suite beside its target; source: of the range of periods; equivalent: periods [s] of mechanisms by name.

    own : the shortest and the longest period [s] by the code of requirements that defines its own
    Without mechanisms the codes are asked for the periods whose multiples the range is.
    """
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
    )


def source_of(study: Study) -> str:
    """Where the range of periods comes from."""
    if study.fitting.selection is None:
        return "default of the scaling by least squares"
    given = study.resolved.get("records.select.periods")
    if given is not None and given.given:
        return "given"
    return f"{BELOW} times the least to {ABOVE} times the largest equivalent period of the mechanisms"


def misfit_of_mean(motions: Sequence[ScaledRecord], spectrum: Spectrum, band: Band) -> float:
    """Mean squared natural-log difference between the mean spectrum and the target over the band [-]."""
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
    """What every code says of the suite; shortest, longest: equivalent periods [s]; own: those of some codes."""
    suite = suite_of([m.record for m in motions], [m.scaling.factor for m in motions], spectrum)
    found = all_requirements(suite, shortest=shortest, longest=longest, own=own)
    return tuple(requirement_result(one) for one in found)


def requirement_result(one: Requirement) -> RequirementResult:
    """A requirement as the results have it."""
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
    )


def selection_result(found: Selection) -> SelectionResult:
    """How a suite was chosen, as the results have it."""
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
