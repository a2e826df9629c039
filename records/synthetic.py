"""Artificial accelerograms whose 5 % response spectrum follows a design spectrum.

A sum of harmonics with random phases under a non-stationary envelope; their amplitudes are corrected, harmonic by
harmonic, by the ratio of the target to the response spectrum (Gasparini & Vanmarcke 1976, SIMQKE, MIT R76-4). Each
round also brings the peak acceleration to the target's zero-period ordinate and the final velocity, the final
displacement and its mean to zero, so that the corrections that follow undo what these did to the spectrum.
"""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import partial

import numpy as np

from assess.messages.message import Message, Quantity, note, whole_number
from records.errors import RecordError
from records.record import Record, make_record
from records.spectral_fit import DAMPING, RISE, STATIONARY, Match, Stage, Target, fit_rounds, make_stage
from spectra.spectrum import Spectrum

BAND = (0.04, 5.0)  # periods the spectrum is matched at [s]: 25 Hz to 0.2 Hz, those of ASCE 43-05, 2.4
PERIODS_PER_DECADE = 80
SHORTFALL = 0.10  # of any ordinate below the target, at most [-]
RMS = 0.05  # of record / target - 1 over the band, at most [-]
TRIALS = 8  # sets of phases before the record is given up
MAX_SAMPLES = 2**18


def artificial(
    spectrum: Spectrum,
    *,
    count: int,
    seed: int,
    duration: float = 25.0,
    dt: float = 0.01,
    band: tuple[float, float] = BAND,
    threads: int = 1,
) -> tuple[Record, ...]:
    """Generate spectrum-compatible artificial records, "artificial-1" and so on; the same for the same seed.

    No 5 % ordinate of a record in the band is more than 10 % below the target (EN 1998-1, 3.2.3.1.2(4)c asks that of
    the mean), the differences have an rms below 5 %, and the peak acceleration is the target's zero-period ordinate;
    velocity and displacement end at zero and the mean displacement is zero. The envelope has the form of Jennings,
    Housner & Tsai (1968): a parabola over a tenth of the duration, a stationary half (12.5 s of 25 s; NTC 2018, 3.2.3.6
    asks for 10 s of 25 s), then an exponential fall to 5 %. Ordinates are those at 80 periods a decade, as
    `response_spectrum` defines them. Record k depends on `seed` and k only, not on `count`.

    Parameters
    ----------
    spectrum : target
    count : number of records
    seed : whole number from 0 up
    duration, dt : length and time step [s]
    band : shortest and longest period matched [s], cut where a table ends
    threads : records made at once, 0 for all cores; half of the time is in a kernel, free of the interpreter's lock

    Raises
    ------
    RecordError : the arguments make no record, or none of the phases tried comes within these bounds

    Source: Gasparini & Vanmarcke 1976; Jennings, Housner & Tsai 1968, Simulated earthquake motions, Caltech EERL.
    """
    _check(count=count, seed=seed, duration=duration, dt=dt, band=band)
    target = _target(spectrum, band=band)
    stage = make_stage(target, duration=duration, dt=dt)
    with ThreadPoolExecutor(threads or os.cpu_count() or 1) as pool:
        made = partial(_record, target, stage, spectrum.code, seed)
        return tuple(pool.map(made, range(1, count + 1)))


def _check(*, count: int, seed: int, duration: float, dt: float, band: tuple[float, float]) -> None:
    """Refuse arguments that make no record."""
    if count < 1:
        raise RecordError(f"artificial records: count = {count}; ask for at least one")
    if seed < 0:
        raise RecordError(f"artificial records: seed = {seed}; it must be a whole number from 0 up")
    if not 0.0 < band[0] < band[1] < np.inf:
        raise RecordError(f"artificial records: band = {band[0]} s to {band[1]} s; it must rise, above zero")
    if not 0.0 < dt <= band[0] / 4.0:
        raise RecordError(
            f"artificial records: dt = {dt} s; to hold periods of {band[0]} s it must be positive, "
            f"at most {band[0] / 4.0} s"
        )
    if not 2.0 * band[1] <= duration <= dt * MAX_SAMPLES:
        raise RecordError(
            f"artificial records: duration = {duration} s; for periods up to {band[1]} s and steps of {dt} s "
            f"it must be {2.0 * band[1]:.6g} s to {dt * MAX_SAMPLES:.6g} s"
        )


def _target(spectrum: Spectrum, *, band: tuple[float, float]) -> Target:
    """Return the 5 % ordinates at log-spaced periods of the band, as far as the spectrum goes."""
    longest = min(band[1], spectrum.longest_period)
    if longest <= band[0]:
        raise RecordError(f"artificial records: the spectrum ends at {longest} s, below the band from {band[0]} s")
    number = round(PERIODS_PER_DECADE * np.log10(longest / band[0])) + 2
    period = np.geomspace(band[0], longest, number)
    period[-1] = longest
    return Target(
        period, spectrum.acceleration(period, damping=DAMPING), float(spectrum.acceleration(0.0, damping=DAMPING))
    )


def _record(target: Target, stage: Stage, code: str, seed: int, index: int) -> Record:
    """Make record `index` of the set of `seed` with the first set of phases whose fit is within the bounds."""
    random = np.random.default_rng([seed, index])
    fits = []
    for _ in range(TRIALS):
        phase = random.uniform(0.0, 2.0 * np.pi, stage.amplitude.size)
        fit = min(fit_rounds(target, stage, phase=phase), key=lambda match: match.worst)
        if fit.low >= -SHORTFALL and fit.rms <= RMS:
            history = _history(fit, target, stage, code, seed, index)
            made = make_record(f"artificial-{index}", fit.acceleration, stage.dt, processing_history=history)
            return replace(made, stationary=STATIONARY * stage.duration)
        fits.append(fit)
    best = min(fits, key=lambda fit: fit.worst)
    raise RecordError(
        f"artificial-{index}: after {TRIALS} sets of phases the spectrum is {best.low:+.1%} to {best.high:+.1%} "
        f"(rms {best.rms:.1%}) of the {code} target over {target.period[0]:g} s to {target.period[-1]:g} s; "
        f"{-SHORTFALL:.0%} and rms {RMS:.0%} are the bounds; a longer duration may help"
    )


def _history(fit: Match, target: Target, stage: Stage, code: str, seed: int, index: int) -> tuple[Message, ...]:
    lengths = {"rise": RISE * stage.duration, "level": STATIONARY * stage.duration, "duration": stage.duration}
    times = {name: Quantity(each, "time", 6) for name, each in lengths.items()}
    range_of = {"first": Quantity(target.period[0], "time", 6), "last": Quantity(target.period[-1], "time", 6)}
    shares = {"low": fit.low, "high": fit.high, "rms": fit.rms}
    misfits = {name: Quantity(100.0 * each, "percent", 2) for name, each in shares.items()}
    return (
        note("artificial-phases", seed=str(seed), number=whole_number(index), **times),
        note("artificial-fit", code=code, **range_of, **misfits),
        note("artificial-baseline"),
    )
