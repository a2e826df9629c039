"""Overturning envelopes: of one oscillator, and of all mechanisms of a study."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from assess.amplification import pulse_factor
from assess.dynamics import pulses
from assess.dynamics.packing import Equation
from assess.dynamics.pulses import CriticalMechanism, Envelope, envelope, find_critical
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity, first_names, message, warning
from assess.oscillator import Oscillator
from assess.results import SCHEMA_VERSION, CriticalBand, CriticalResult, EnvelopeResult, Results
from assess.results.provenance import describe_program, stamp
from assess.short_repr import ShortRepr
from assess.study.ground_motion import record_result, spectrum_result, with_primary_pulses
from assess.study.histories import fastest_vibration
from assess.study.mechanism_results import parameters
from assess.study.study import Progress, PulseGrid, ScaledRecord, Study, case_text, no_progress
from assess.study.suites import motions_of
from assess.study.variations import MechanismSweep
from records.errors import RecordError
from records.pulses import PULSE_SHAPES, PulseShape, pulse_shape
from spectra.arrays import FloatArray
from spectra.gravity import g


def coarse_record_messages(cases: Sequence[EnvelopeCase], motions: Sequence[ScaledRecord]) -> Iterator[Message]:
    """Yield a warning for each mechanism for which some record is too coarse."""
    for case in cases:
        longest, why = longest_step(case.oscillator, equation=case.equation)
        coarse = [motion.record for motion in motions if motion.record.dt > longest]
        if coarse:
            names = first_names([f"{record.id} ({record.dt:.4g} s)" for record in coarse], MOST_RECORDS_NAMED)
            yield warning(
                "coarse-record",
                f"mechanisms.{case.name}",
                records=names,
                motion=why,
                longest=Quantity(longest, "time", 3),
            )


def longest_step(oscillator: Oscillator, *, equation: Equation) -> tuple[float, Message]:
    """Return the longest step of a record for an oscillator [s], and the motion that requires it.

    The linearised equation has no vibration about rest.
    """
    p = max(branch.linearised.p for branch in oscillator.branches)
    elastic = fastest_vibration(oscillator)
    if equation == "exact" and FEWEST_ELASTIC * elastic > FEWEST_ROCKING * p:
        return 1.0 / (FEWEST_ELASTIC * elastic), message(
            "motion-elastic", {"frequency": Quantity(elastic, "frequency", 3)}
        )
    return 1.0 / (FEWEST_ROCKING * p), message("motion-rocking", {"p": Quantity(p, "angular frequency", 3)})


def run_envelopes(study: Study, *, jobs: int = 0, progress: Progress = no_progress) -> Results:
    """Find the overturning envelopes of a study, without spectrum, records or checks.

    Mechanisms are those of the project file, without the cases of its sweeps.

    Parameters
    ----------
    study : the study; its own pulses are used, or the default ones
    jobs : number of threads; 0 for all cores. The results do not depend on it.
    progress : called with the stage, the number of its parts done, and their total

    Returns
    -------
    Parameters and envelope of each mechanism, and the critical mechanism at each frequency.
    """
    grid = study.pulses or DEFAULT_GRID
    envelopes = map_envelopes(envelope_cases(study, {}), grid, jobs=jobs, progress=progress)
    progress("primary pulses", 0, 1)
    recorded = tuple(record for record in study.records if not record.artificial)
    recorded_only = replace(study, artificial=None, records=recorded)
    motions = () if study.spectrum is None else motions_of(recorded_only, study.spectrum)
    records = () if study.spectrum is None else tuple(record_result(motion, study.spectrum) for motion in motions)
    program = describe_program()
    return Results(
        schema_version=SCHEMA_VERSION,
        program=program,
        inputs=study.inputs,
        warnings=envelope_messages(study),
        project=study.resolved,
        spectrum=None if study.spectrum is None else spectrum_result(study.spectrum),
        records=with_primary_pulses(records, motions, grid),
        mechanisms=tuple(replace(each, envelope=envelopes.get(each.name)) for each in parameters(study)),
        critical=critical_result(envelopes),
        comparison=(),
        sweeps=(),
        stamp=stamp("envelope", program, study.inputs),
    )


def envelope_of(study: Study) -> EnvelopeResult | None:
    """Return the envelope of a lone mechanism, by its own pulses or the default ones; None where there is none."""
    found = map_envelopes(envelope_cases(study, {}), study.pulses or DEFAULT_GRID, jobs=0, progress=no_progress)
    return next(iter(found.values()), None)


def envelope_cases(study: Study, controlling: Mapping[str, MechanismSweep]) -> tuple[EnvelopeCase, ...]:
    """Return the mechanisms whose envelopes are sought, swept ones in their controlling case.

    Mechanisms that fall at rest without actions that are not shown to last, and those of which no history is answered,
    are left out.
    """
    cases = []
    for name in (mechanism.name for mechanism in study.mechanisms):
        swept = controlling.get(name)
        study_there, mechanism = study_and_mechanism(study, swept, name)
        oscillator = mechanism.variants.collapse
        if oscillator is None or not mechanism.rocks:
            continue
        factor = partial(pulse_factor, study_there.amplified[name].amplification)
        words = "" if swept is None else case_text(swept.sweep, swept.controlling_case, swept.mechanism)
        cases.append(EnvelopeCase(name, oscillator.bare, study_there.equations[name], factor, words))
    return tuple(cases)


@dataclass(frozen=True, repr=False)
class EnvelopeCase(ShortRepr):
    """A mechanism whose envelope is sought.

    factor : amplification to its base at given frequencies [n] [Hz] -> [n]
    case : the case of a sweep in words, else empty
    """

    name: str
    oscillator: Oscillator
    equation: Equation
    factor: Callable[[FloatArray], FloatArray]
    case: str = ""


def envelope_result(computed: Envelope, oscillator: Oscillator | None) -> EnvelopeResult:
    """Return an envelope in the units of results.

    Parameters
    ----------
    computed : the envelope
    oscillator : of the mechanism; where None, what is dimensionless is left out
    """
    form = oscillator and min((branch.linearised for branch in oscillator.branches), key=lambda form: form.multiplier)
    bound = computed.lower_bound / g
    above = computed.amplitude[None, :] > computed.lower_bound[:, None]  # nowhere, if nothing overturns
    return EnvelopeResult(
        shape=computed.shape.name,
        gamma=computed.shape.gamma,
        nu_rad=computed.shape.nu,
        equation=computed.equation,
        frequency_hz=tuple(computed.frequency.tolist()),
        amplitude_g=tuple((computed.amplitude / g).tolist()),
        overturned=tuple(tuple(row) for row in computed.overturned.tolist()),
        lower_bound_g=_none_for_nan(bound),
        polarity=tuple(computed.polarity.tolist()),
        islands=tuple((above & ~computed.overturned).sum(axis=1).tolist()),
        uplift_g=tuple((computed.uplift / g).tolist()),
        factor=tuple(computed.factor.tolist()),
        omega=tuple((2 * np.pi * computed.frequency / form.p).tolist()) if form else (),
        lower_bound_ratio=_none_for_nan(bound * computed.factor / form.multiplier) if form else (),
    )


def envelope_messages(study: Study) -> tuple[Message, ...]:
    """Return the messages on envelopes, where no procedure of a code is used."""
    kept = tuple(message for message in study.messages if message.key != "confidence-factor")
    if not study.sweeps:
        return kept
    keys = ", ".join(sweep.key for sweep in study.sweeps)
    return (*kept, warning("sweep-left-out", "analysis.sweep", keys=keys))


def map_envelopes(
    cases: Sequence[EnvelopeCase], grid: PulseGrid | None, *, jobs: int, progress: Progress
) -> dict[str, EnvelopeResult]:
    """Return the envelope of every mechanism by name; empty without a grid of pulses."""
    if grid is None:
        return {}
    results = {}
    for count, case in enumerate(cases):
        progress("overturning envelopes", count, len(cases))
        computed = envelope(
            case.oscillator,
            grid.shape,
            grid.frequency,
            grid.amplitude,
            equation=case.equation,
            factor=case.factor(grid.frequency),
            threads=jobs,
        )
        results[case.name] = replace(envelope_result(computed, case.oscillator), case=case.case)
    progress("overturning envelopes", len(cases), len(cases))
    return results


def critical_result(envelopes: dict[str, EnvelopeResult]) -> CriticalResult | None:
    """Return which mechanism is critical at each frequency; None without mechanisms."""
    if not envelopes:
        return None
    names = list(envelopes)
    frequency = np.array(next(iter(envelopes.values())).frequency_hz)
    bounds = np.array([[np.nan if b is None else b for b in each.lower_bound_g] for each in envelopes.values()])
    order = find_critical(frequency, bounds)
    return CriticalResult(
        frequency_hz=tuple(frequency.tolist()),
        mechanism=_names(order.mechanism, names),
        lower_bound_g=_none_for_nan(order.lower_bound),
        runner_up=_names(order.runner_up, names),
        margin=_none_for_nan(order.margin),
        near=tuple(tuple(name for name, is_near in zip(names, row, strict=True) if is_near) for row in order.near.T),
        bands=_bands(order, names),
    )


def _bands(order: CriticalMechanism, names: Sequence[str]) -> tuple[CriticalBand, ...]:
    return tuple(
        CriticalBand(None if band.mechanism is None else names[band.mechanism], band.start, band.end)
        for band in order.bands
    )


def _names(index: NDArray[np.int64], names: Sequence[str]) -> tuple[str | None, ...]:
    """Return the names of mechanisms by index, None for a negative one."""
    return tuple(names[i] if i >= 0 else None for i in index)


def _none_for_nan(values: FloatArray) -> tuple[float | None, ...]:
    """Return numbers [n], None in place of nan."""
    return tuple(None if np.isnan(value) else float(value) for value in values)


def find_envelope(
    oscillator: Oscillator,
    pulse: str | PulseShape,
    *,
    frequency: Sequence[float] | FloatArray,
    amplitude: Sequence[float] | FloatArray,
    equation: Equation = "exact",
    threads: int = 0,
) -> Envelope:
    """Find which pulses of a grid overturn an oscillator, in the worse polarity, and the least that does.

    Parameters
    ----------
    oscillator : the branches of the mechanism, or of a rigid block
    pulse : name of a pulse of `records.pulses.PULSE_SHAPES`, or a shape made by `records.pulses.pulse_shape`
    frequency : rising frequencies of the pulse [n] [Hz]
    amplitude : rising peak accelerations [m] [m/s2]
    equation : {"exact", "linearised"}
        The equation of motion.
    threads : number of threads; 0 for all cores. The results do not depend on it.

    Returns
    -------
    Outcome of each pulse [n, m], and at each frequency the least amplitude that overturns [n] [m/s2].

    Raises
    ------
    RecordError : if no pulse has that name, or frequencies or amplitudes are not finite, positive and rising
    MechanismError : if a branch cannot rock, or frequencies or amplitudes are not finite, positive and rising
    """
    chosen = pulse_shape(pulse) if isinstance(pulse, str) else pulse
    if not isinstance(chosen, PulseShape):
        raise RecordError(f'pulse = {pulse!r:.60}: give the name of a pulse, such as "sine"')
    return pulses.envelope(
        oscillator,
        chosen,
        _rising_axis("frequency", frequency, least=LEAST_ABOVE_ZERO),
        _rising_axis("amplitude", amplitude, least=0.0),
        equation=equation,
        threads=threads,
    )


def _rising_axis(name: str, numbers: Sequence[float] | FloatArray, *, least: float) -> FloatArray:
    """Return an axis of the grid; raise RecordError where it is not finite, rising, or within its bounds."""
    try:
        values = np.atleast_1d(np.array(numbers, dtype=np.float64))
    except (TypeError, ValueError):
        raise RecordError(f"{name} = {numbers!r:.60}: give rising numbers above 0") from None
    if values.ndim != 1 or not values.size or not np.isfinite(values).all():
        raise RecordError(f"{name}: give one finite number or more")
    if values[0] < least or values[-1] <= 0.0 or (np.diff(values) <= 0.0).any():
        raise RecordError(f"{name}: {values[0]:g} to {values[-1]:g}: give rising numbers above 0")
    return values


FEWEST_ELASTIC = 6.0
"""Samples in a period of the elastic vibration about rest."""


FEWEST_ROCKING = 10.0
"""Samples within 1 / p, in which a rocking rotation grows e-fold."""


MOST_RECORDS_NAMED = 3
"""Records that a message names."""


DEFAULT_GRID = PulseGrid(PULSE_SHAPES["sine"], np.linspace(0.2, 10.0, 100), np.linspace(0.0, 3.0 * g, 100))


def study_and_mechanism(study: Study, swept: MechanismSweep | None, name: str) -> tuple[Study, Mechanism]:
    """Return the study in which a mechanism was assessed, that of the controlling case if swept, and the mechanism."""
    deciding = study if swept is None else swept.controlling_case.study
    return deciding, next(mechanism for mechanism in deciding.mechanisms if mechanism.name == name)


LEAST_ABOVE_ZERO = 5e-324  # the least number above 0
