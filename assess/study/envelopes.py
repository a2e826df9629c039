"""Overturning envelopes under pulses, of one oscillator and of the mechanisms of a study, and the critical
mechanism.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray
from scipy.constants import g

from assess.amplification import pulse_factor
from assess.dynamics import pulses
from assess.dynamics.packing import Equation
from assess.dynamics.pulses import CriticalMechanism, Envelope, envelope, find_critical
from assess.messages.message import Message, warning
from assess.oscillator import Oscillator
from assess.results import SCHEMA_VERSION, CriticalBand, CriticalResult, EnvelopeResult, Results
from assess.results.inputs import describe_program, stamp
from assess.short_repr import ShortRepr
from assess.study.ground_motion import record_result, spectrum_result, with_primary_pulses
from assess.study.mechanism_results import parameters
from assess.study.record_set import motions_of
from assess.study.study import (
    Progress,
    PulseGrid,
    Study,
    case_text,
    report_nothing,
)
from assess.study.sweeps import MechanismSweep
from records.errors import RecordError
from records.pulses import PULSE_SHAPES, PulseShape, pulse_shape
from spectra.arrays import FloatArray


def run_envelopes(study: Study, *, jobs: int = 0, progress: Progress = report_nothing) -> Results:
    """Find the overturning envelopes of a study, without spectrum, records or checks.

    Mechanisms are those of the project file, without the cases of its sweeps.

    Parameters
    ----------
    study : Study
        The study; its own pulses are used, or the default ones.
    jobs : int
        Number of threads; 0 for all cores. The results do not depend on it.
    progress : Progress
        Called with the stage, the number of its parts done, and their total.

    Returns
    -------
    Results
        Parameters and envelope of each mechanism, and the critical mechanism at each frequency.
    """
    grid = study.pulses or DEFAULT_GRID
    envelopes = map_envelopes(envelope_cases(study, {}), grid, jobs=jobs, progress=progress)
    progress("primary pulses", 0, 1)
    recorded = tuple(record for record in study.records if not record.artificial)
    given = replace(study, artificial=None, records=recorded)
    motions = () if study.spectrum is None else motions_of(given, study.spectrum)
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


def envelope_cases(study: Study, controlling: Mapping[str, MechanismSweep]) -> tuple[EnvelopeCase, ...]:
    """Return the mechanisms whose envelopes are sought, swept ones in their controlling case.

    Mechanisms that fall at rest without actions that are not shown to last are left out.
    """
    found = []
    for mechanism in study.mechanisms:
        sweep = controlling.get(mechanism.name)
        of = study if sweep is None else sweep.case.study
        case = "" if sweep is None else case_text(sweep.sweep, sweep.case, sweep.mechanism)
        used = next(each for each in of.mechanisms if each.name == mechanism.name)
        oscillator = used.variants.collapse
        if oscillator is None:
            continue
        factor = partial(pulse_factor, of.amplified[used.name].amplification)
        found.append(EnvelopeCase(used.name, oscillator, of.equations[used.name], factor, case))
    return tuple(found)


DEFAULT_GRID = PulseGrid(PULSE_SHAPES["sine"], np.linspace(0.2, 10.0, 100), np.linspace(0.0, 3.0 * g, 100))


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


def map_envelopes(
    cases: Sequence[EnvelopeCase], grid: PulseGrid | None, *, jobs: int, progress: Progress
) -> dict[str, EnvelopeResult]:
    """Return the envelope of every mechanism by name; empty without a grid of pulses."""
    if grid is None:
        return {}
    found = {}
    for count, case in enumerate(cases):
        progress("overturning envelopes", count, len(cases))
        made = envelope(
            case.oscillator,
            grid.shape,
            grid.frequency,
            grid.amplitude,
            equation=case.equation,
            factor=case.factor(grid.frequency),
            threads=jobs,
        )
        found[case.name] = replace(envelope_result(made, case.oscillator), case=case.case)
    progress("overturning envelopes", len(cases), len(cases))
    return found


def envelope_result(made: Envelope, oscillator: Oscillator) -> EnvelopeResult:
    """Return the envelope in the units of results."""
    form = min((branch.linearised for branch in oscillator.branches), key=lambda form: form.multiplier)
    bound = made.lower_bound / g
    above = made.amplitude[None, :] > made.lower_bound[:, None]  # nowhere, if nothing overturns
    return EnvelopeResult(
        shape=made.shape.name,
        gamma=made.shape.gamma,
        nu_rad=made.shape.nu,
        equation=made.equation,
        frequency_hz=tuple(made.frequency.tolist()),
        amplitude_g=tuple((made.amplitude / g).tolist()),
        overturned=tuple(tuple(row) for row in made.overturned.tolist()),
        lower_bound_g=none_for_nan(bound),
        polarity=tuple(made.polarity.tolist()),
        islands=tuple((above & ~made.overturned).sum(axis=1).tolist()),
        uplift_g=tuple((made.uplift / g).tolist()),
        factor=tuple(made.factor.tolist()),
        omega=tuple((2 * np.pi * made.frequency / form.p).tolist()),
        lower_bound_ratio=none_for_nan(bound * made.factor / form.multiplier),
    )


def critical_result(found: dict[str, EnvelopeResult]) -> CriticalResult | None:
    """Return which mechanism is critical at each frequency; None without mechanisms."""
    if not found:
        return None
    names = list(found)
    frequency = np.array(next(iter(found.values())).frequency_hz)
    bounds = np.array([[np.nan if b is None else b for b in each.lower_bound_g] for each in found.values()])
    order = find_critical(frequency, bounds)
    return CriticalResult(
        frequency_hz=tuple(frequency.tolist()),
        mechanism=_names(order.mechanism, names),
        lower_bound_g=none_for_nan(order.lower_bound),
        runner_up=_names(order.runner_up, names),
        margin=none_for_nan(order.margin),
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


def none_for_nan(values: FloatArray) -> tuple[float | None, ...]:
    """Return numbers [n], None in place of nan."""
    return tuple(None if np.isnan(value) else float(value) for value in values)


LEAST_ABOVE_ZERO = 5e-324  # the least number above 0


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
    oscillator : Oscillator
        The branches of the mechanism, or of a rigid block.
    pulse : str or Shape
        Name of a pulse of `records.pulses.PULSE_SHAPES`, or a shape made by `records.pulses.pulse_shape`.
    frequency : array
        Rising frequencies of the pulse [n] [Hz].
    amplitude : array
        Rising peak accelerations [m] [m/s2].
    equation : {"exact", "linearised"}
        The equation of motion.
    threads : int
        Number of threads; 0 for all cores. The results do not depend on it.

    Returns
    -------
    Envelope
        Outcome of each pulse [n, m], and at each frequency the least amplitude that overturns [n] [m/s2].

    Raises
    ------
    RecordError
        If no pulse has that name, or frequencies or amplitudes are not finite, positive and rising.
    MechanismError
        If a branch cannot rock.
        If frequencies or amplitudes are not finite, positive and rising.
    """
    made = pulse_shape(pulse) if isinstance(pulse, str) else pulse
    if not isinstance(made, PulseShape):
        raise RecordError(f'pulse = {pulse!r:.60}: give the name of a pulse, such as "sine"')
    return pulses.envelope(
        oscillator,
        made,
        _rising_axis("frequency", frequency, least=LEAST_ABOVE_ZERO),
        _rising_axis("amplitude", amplitude, least=0.0),
        equation=equation,
        threads=threads,
    )


def _rising_axis(name: str, given: Sequence[float] | FloatArray, *, least: float) -> FloatArray:
    """Return an axis of the grid; raise RecordError where it is not finite, rising, or within its bounds."""
    try:
        values = np.atleast_1d(np.array(given, dtype=np.float64))
    except (TypeError, ValueError):
        raise RecordError(f"{name} = {given!r:.60}: give rising numbers above 0") from None
    if values.ndim != 1 or not values.size or not np.isfinite(values).all():
        raise RecordError(f"{name}: give one finite number or more")
    if values[0] < least or values[-1] <= 0.0 or (np.diff(values) <= 0.0).any():
        raise RecordError(f"{name}: {values[0]:g} to {values[-1]:g}: give rising numbers above 0")
    return values


def envelope_messages(study: Study) -> tuple[Message, ...]:
    """Return the messages on envelopes, where no procedure of a code is used."""
    kept = tuple(message for message in study.messages if message.key != "confidence-factor")
    if not study.sweeps:
        return kept
    keys = ", ".join(sweep.key for sweep in study.sweeps)
    return (*kept, warning("sweep-left-out", "analysis.sweep", keys=keys))
