"""Artificial accelerograms whose 5 % response spectrum follows a design spectrum.

A sum of harmonics with random phases under a non-stationary envelope; their amplitudes are corrected, harmonic by
harmonic, by the ratio of the target to the response spectrum (Gasparini & Vanmarcke 1976, SIMQKE, MIT R76-4). Each
round also brings the peak acceleration to the target's zero-period ordinate and the final velocity, the final
displacement and its mean to zero, so that the corrections that follow undo what these did to the spectrum.
"""

from __future__ import annotations

import hashlib
import os
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import lru_cache, partial
from typing import Annotated

import numpy as np

from assess.declaration import Drawn, Evidence, Number, Safe
from assess.messages.message import Message, Quantity, note, whole_number
from records.errors import RecordError
from records.record import Record, make_record
from records.selection import target_mark
from spectra.arrays import FloatArray
from spectra.spectrum import Spectrum

MATCHED_PERIODS = (0.04, 5.0)  # periods the spectrum is matched at [s]: 25 Hz to 0.2 Hz, those of ASCE 43-05, 2.4
PERIODS_PER_DECADE = 80
SHORTFALL = 0.10  # of any ordinate below the target, at most [-]
LARGEST_RMS = 0.05  # of record / target - 1 over the band, at most [-]
TRIALS = 8  # sets of phases before the record is given up
MAX_SAMPLES = 2**18


SUITE_SIZE = Evidence(
    "action",
    "up",
    "as stated; of fewer than seven the largest decides",
    judged="of seven records and more the mean counts",
)
SEED = Evidence(
    "action",
    "up",
    "the hash of target and duration; both suites run, the worse decides",
    judged="of many seeds one may be chosen whose suite is lenient",
    safe=Safe.ABSENT,
)
DURATION = Evidence("action", "down", "25 s; 20 s for ASCE 43-05", safe=Drawn("duration"))


@dataclass(frozen=True)
class ArtificialRecords:
    """Artificial records that fit the site's spectrum."""

    count: Annotated[int, Number(least=1, most=1000), SUITE_SIZE] = 7
    """how many"""
    seed: Annotated[int | None, Number(least=0), SEED] = None
    """of the random numbers: the same seed makes the same records; if absent, it follows from target and duration"""
    duration: Annotated[float, Number("time", above=0, least=8, most=600), DURATION] = 25.0
    """length of each record, like "25 s", which NTC 2018 asks for; ASCE 43-05 asks for 20 s"""


def artificial_records(
    spectrum: Spectrum,
    *,
    count: int,
    seed: int | None = None,
    duration: float = 25.0,
    dt: float = 0.01,
    band: tuple[float, float] = MATCHED_PERIODS,
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
    seed : whole number from 0 up; None for `seed_of_target`, which nobody chooses
    duration, dt : length and time step [s]
    band : shortest and longest period matched [s], cut where a table ends
    threads : records made at once, 0 for all cores; half of the time is in a kernel, free of the interpreter's lock

    Raises
    ------
    RecordError : the arguments make no record, or none of the phases tried comes within these bounds

    Source: Gasparini & Vanmarcke 1976; Jennings, Housner & Tsai 1968, Simulated earthquake motions, Caltech EERL.
    """
    seed = seed_of_target(spectrum, duration=duration) if seed is None else seed
    _check(count=count, seed=seed, duration=duration, dt=dt, band=band)
    target = _target_ordinates(spectrum, band=band)
    recipe = _Recipe(spectrum.code, target.period.tobytes(), target.ordinate.tobytes(), target.pga, seed, duration, dt)
    with ThreadPoolExecutor(threads or os.cpu_count() or 1) as pool:
        return tuple(pool.map(partial(_make_artificial, recipe), range(1, count + 1)))


def seed_of_target(spectrum: Spectrum, *, duration: float) -> int:
    """Return the seed of the records of a target and a duration [s]: the first 32 bits of a SHA-256 of both.

    Of many seeds one makes a lenient suite, so none is chosen. The target counts by its shape, that a PGA may be swept,
    and neither the number of records nor the band counts: with more records, or another mechanism, those that were
    there stay alike.

    Parameters
    ----------
    spectrum : target
    duration : length of each record [s]
    """
    text = f"{target_mark(spectrum).sha256} {duration:.6g}"
    return int(hashlib.sha256(text.encode()).hexdigest()[:8], 16)


DAMPING = 0.05
ROUNDS = 40
RECORDS_KEPT, SETS_KEPT = 256, 16  # in the memory of a process, of those used last
RISE, STATIONARY = 0.1, 0.5  # shares of the duration
END_LEVEL = 0.05  # of the envelope at the end of the duration
TAPER = 0.05  # share of the duration over which the end is brought to zero


@dataclass(frozen=True)
class SpectralMatch:
    """An accelerogram [n] [m/s2] and how its spectrum compares with the target over the band.

    low, high : smallest and largest of record / target - 1 [-]; rms of it [-]
    """

    acceleration: FloatArray
    low: float
    high: float
    rms: float

    @property
    def worst(self) -> float:
        """Largest difference, either way [-]."""
        return max(-self.low, self.high)


@dataclass(frozen=True)
class TargetOrdinates:
    """What an accelerogram is fitted to: ordinates [k] [m/s2] at rising period [k] [s]; zero-period ordinate [m/s2]."""

    period: FloatArray
    ordinate: FloatArray
    pga: float


@dataclass(frozen=True)
class HarmonicBasis:
    """What all artificial records of a set share: envelope, harmonics, corrections of the ends.

    dt, duration : step and length [s]; n samples from 0
    envelope : of the amplitude [n]
    gate : 1 wherever the envelope is above a twentieth, less outside, so that nothing creeps into the ends [n]
    ends : see `end_weights` [3, n]
    shapes : accelerations that correct the ends [3, n]
    log_period : of each harmonic, ln(T / 1 s), held within the band [m]
    amplitude : of each harmonic at the start, up to a factor [m]
    high_pass : what each harmonic is multiplied by in each round: 0 for periods above 2.5 times the band's longest [m]
    """

    dt: float
    duration: float
    envelope: FloatArray
    gate: FloatArray
    ends: FloatArray
    shapes: FloatArray
    log_period: FloatArray
    amplitude: FloatArray
    high_pass: FloatArray


def envelope(time: FloatArray, *, duration: float) -> FloatArray:
    """Return the amplitude's envelope [-] at `time` [n] [s]: parabola, level, exponential, brought to zero at the end.

    Source: Jennings, Housner & Tsai 1968, the form of their type A and B earthquakes, in shares of the duration.
    """
    rise, fall = RISE * duration, (RISE + STATIONARY) * duration
    decay = np.log(END_LEVEL) / (duration - fall)
    level = np.minimum(1.0, (time / rise) ** 2) * np.exp(decay * np.maximum(time - fall, 0.0))
    return np.asarray(level * np.sin(0.5 * np.pi * np.clip((duration - time) / (TAPER * duration), 0.0, 1.0)) ** 2)


def end_weights(npts: int, *, dt: float) -> FloatArray:
    """Return rows w [3, npts] so that w . a are the final velocity, displacement and integral of displacement.

    The motion starts from rest. These are the integrals of a(t) (t_end - t)^k / k! for k = 0, 1, 2, exact for a(t)
    linear between samples: at the two ends of a step that ends `left` before t_end, the weights are integrals of that
    over the two hat functions.
    """
    left, h = dt * np.arange(npts - 2, -1, -1), dt
    start = (0.5 * h, h * left / 2 + h**2 / 3, h * left**2 / 4 + h**2 * left / 3 + h**3 / 8)
    end = (0.5 * h, h * left / 2 + h**2 / 6, h * left**2 / 4 + h**2 * left / 6 + h**3 / 24)
    weights = np.zeros((3, npts))
    for row in range(3):
        weights[row, :-1] += start[row]
        weights[row, 1:] += end[row]
    return weights


def with_peak(a: FloatArray, *, pga: float) -> FloatArray:
    """Return the accelerogram [n] with its peak at `pga` [m/s2].

    Every half-cycle that exceeds it is lowered to it; if none does, the largest is raised. A half-cycle, between
    two changes of sign, is multiplied as a whole: nothing is clipped flat.
    """
    starts = np.concatenate([[0], np.flatnonzero(np.diff(np.signbit(a))) + 1])
    peak = np.maximum.reduceat(np.abs(a), starts)
    scale = pga / np.maximum(peak, pga)
    if np.max(peak) < pga:
        scale[np.argmax(peak)] = pga / np.max(peak)
    return np.asarray(a * np.repeat(scale, np.diff(np.append(starts, a.size))))


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


def _target_ordinates(spectrum: Spectrum, *, band: tuple[float, float]) -> TargetOrdinates:
    """Return the 5 % ordinates at log-spaced periods of the band, as far as the spectrum goes."""
    longest = min(band[1], spectrum.longest_period)
    if longest <= band[0]:
        raise RecordError(f"artificial records: the spectrum ends at {longest} s, below the band from {band[0]} s")
    number = round(PERIODS_PER_DECADE * np.log10(longest / band[0])) + 2
    period = np.geomspace(band[0], longest, number)
    period[-1] = longest
    return TargetOrdinates(
        period, spectrum.acceleration(period, damping=DAMPING), float(spectrum.acceleration(0.0, damping=DAMPING))
    )


@dataclass(frozen=True)
class _Recipe:
    """All that a set of artificial records follows from.

    code : of the target; period [k] [s], ordinate [k] [m/s2] : as bytes; pga : its zero-period ordinate [m/s2]
    seed : of the set; duration, dt : length and step of each [s]
    """

    code: str
    period: bytes
    ordinate: bytes
    pga: float
    seed: int
    duration: float
    dt: float

    @property
    def target(self) -> TargetOrdinates:
        return TargetOrdinates(np.frombuffer(self.period), np.frombuffer(self.ordinate), self.pga)


@lru_cache(maxsize=RECORDS_KEPT)
def _make_artificial(recipe: _Recipe, index: int) -> Record:
    """Make record `index` of a set with the first set of phases whose fit is within the bounds.

    Once a process: a town has many walls and few targets, and what is made is frozen.
    """
    target, basis, code, seed = recipe.target, _basis_of(recipe), recipe.code, recipe.seed
    random = np.random.default_rng([seed, index])
    fits = []
    for _ in range(TRIALS):
        phase = random.uniform(0.0, 2.0 * np.pi, basis.amplitude.size)
        fit = min(_fit_rounds(target, basis, phase=phase), key=lambda match: match.worst)
        if fit.low >= -SHORTFALL and fit.rms <= LARGEST_RMS:
            history = _history(fit, target, basis, code, seed, index)
            record = make_record(f"artificial-{index}", fit.acceleration, basis.dt, processing_history=history)
            return replace(record, stationary=STATIONARY * basis.duration)
        fits.append(fit)
    best = min(fits, key=lambda fit: fit.worst)
    raise RecordError(
        f"artificial-{index}: after {TRIALS} sets of phases the spectrum is {best.low:+.1%} to {best.high:+.1%} "
        f"(rms {best.rms:.1%}) of the {code} target over {target.period[0]:g} s to {target.period[-1]:g} s; "
        f"{-SHORTFALL:.0%} and rms {LARGEST_RMS:.0%} are the bounds; a longer duration may help"
    )


@lru_cache(maxsize=SETS_KEPT)
def _basis_of(recipe: _Recipe) -> HarmonicBasis:
    return _harmonic_basis(recipe.target, duration=recipe.duration, dt=recipe.dt)


def _history(
    fit: SpectralMatch, target: TargetOrdinates, basis: HarmonicBasis, code: str, seed: int, index: int
) -> tuple[Message, ...]:
    lengths = {"rise": RISE * basis.duration, "level": STATIONARY * basis.duration, "duration": basis.duration}
    times = {name: Quantity(each, "time", 6) for name, each in lengths.items()}
    range_of = {"first": Quantity(target.period[0], "time", 6), "last": Quantity(target.period[-1], "time", 6)}
    shares = {"low": fit.low, "high": fit.high, "rms": fit.rms}
    misfits = {name: Quantity(100.0 * each, "percent", 2) for name, each in shares.items()}
    return (
        note("artificial-phases", seed=str(seed), number=whole_number(index), **times),
        note("artificial-fit", code=code, **range_of, **misfits),
        note("artificial-baseline"),
    )


def _harmonic_basis(target: TargetOrdinates, *, duration: float, dt: float) -> HarmonicBasis:
    """Return the fixed arrays of a set of records; a random motion's amplitudes go as S_a / sqrt(f) to first order."""
    time = dt * np.arange(round(duration / dt) + 1, dtype=np.float64)
    level = envelope(time, duration=float(time[-1]))
    f = np.fft.rfftfreq(2 * time.size, dt)
    T = 1.0 / np.maximum(f, f[1])
    log_period = np.log(np.clip(T, target.period[0], target.period[-1]))
    start = np.interp(log_period, np.log(target.period), target.ordinate) * np.sqrt(T)
    high_pass = np.clip(5.0 * f * target.period[-1] - 2.0, 0.0, 1.0)
    return HarmonicBasis(
        dt=dt,
        duration=float(time[-1]),
        envelope=level,
        gate=np.minimum(1.0, 20.0 * level),
        ends=end_weights(time.size, dt=dt),
        shapes=np.vstack([level * (time / time[-1]) ** power for power in range(3)]),
        log_period=log_period,
        amplitude=start * high_pass,
        high_pass=high_pass,
    )


def _fit_rounds(target: TargetOrdinates, basis: HarmonicBasis, *, phase: FloatArray) -> Iterator[SpectralMatch]:
    """Yield the accelerograms that these phases [m] [rad] lead to, round after round."""
    n, harmonics = basis.envelope.size, basis.amplitude * np.exp(1j * phase)
    a = basis.envelope * np.fft.irfft(harmonics, 2 * n)[:n]
    a *= target.pga / np.max(np.abs(a))
    for _ in range(ROUNDS):
        a = _without_drift(a * basis.gate, basis, pga=target.pga)
        ratio = _ratio(a, target, basis.dt)
        yield _match(a, ratio)
        correction = basis.high_pass * np.exp(-np.interp(basis.log_period, np.log(target.period), np.log(ratio)))
        a = np.fft.irfft(correction * np.fft.rfft(a, 2 * n), 2 * n)[:n]


def _match(a: FloatArray, ratio: FloatArray) -> SpectralMatch:
    """Return the accelerogram [n] with record / target [k] summed up."""
    low, high, rms = np.min(ratio) - 1.0, np.max(ratio) - 1.0, np.sqrt(np.mean((ratio - 1.0) ** 2))
    return SpectralMatch(a, float(low), float(high), float(rms))


def _without_drift(a: FloatArray, basis: HarmonicBasis, *, pga: float) -> FloatArray:
    """Return the accelerogram [n] with peak `pga` [m/s2] and no velocity or displacement left at the end."""
    system = basis.ends @ basis.shapes.T
    for _ in range(3):
        a = with_peak(a - np.linalg.solve(system, basis.ends @ a) @ basis.shapes, pga=pga)
    a = a - np.linalg.solve(system, basis.ends @ a) @ basis.shapes
    return np.asarray(a * (pga / np.max(np.abs(a))))


def _ratio(a: FloatArray, target: TargetOrdinates, dt: float) -> FloatArray:
    """Return the accelerogram's 5 % response spectrum over the target [k]."""
    from records.kernel import peak_displacements  # brings numba

    omega = 2.0 * np.pi / target.period
    return np.asarray(omega**2 * peak_displacements(a, dt, target.period, DAMPING) / target.ordinate)
