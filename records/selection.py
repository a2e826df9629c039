"""Which records of a catalogue make a suite for a target spectrum.

Candidates pass the filters, are scaled to the target one by one, and must keep within the limits of the scale factor.
Of those that are left either the records that fit best one by one are taken, or the suite whose mean spectrum fits
best: greedy, record by record, then improved by exchanging one record at a time until no exchange helps. Where the
suites are few, all of them are tried.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from math import inf, log, sqrt
from typing import Literal

import numpy as np

from records.band import Band, truncate_band
from records.candidates import DAMPING, Candidate
from records.errors import RecordError
from records.event_groups import event_groups
from records.scaling import least_squares, mean_square
from records.suites import FITS, Fit, Pool
from spectra.arrays import FloatArray, IntArray
from spectra.spectrum import Spectrum

Range = tuple[float, float]
ScaleTo = Literal["spectrum", "pga", "none"]
Components = Literal["single", "together"]

KNOWN: Mapping[str, Callable[[Candidate], float | None]] = {
    "magnitude": lambda one: one.magnitude,
    "distance": lambda one: one.distance,
    "vs30": lambda one: one.vs30,
}
"""What files may not say, by the name of its filter."""
STEPS: Mapping[str, str] = {
    "all": "components",
    "horizontal": "horizontal at the free surface",
    "magnitude": "of known magnitude",
    "distance": "of known distance",
    "vs30": "of known vs30",
    "passed": "that pass the filters",
    "scaled": "within the limits of the scale factor",
    "near": "that fit the target one by one",
    "apart": "of different earthquakes",
    "free": "to choose from",
}
"""What is left after each step of a selection, in words."""


@dataclass(frozen=True)
class Filters:
    """What a candidate must be; both ends of a range included, None for any. What is not known does not pass.

    magnitude [-]; distance [m]; vs30 [m/s]; pga [m/s2]; duration: D5-95 [s]; events: parts of the names of the
    earthquakes that pass, capitals or not, all where none is given
    """

    magnitude: Range | None = None
    distance: Range | None = None
    vs30: Range | None = None
    pga: Range | None = None
    duration: Range | None = None
    events: tuple[str, ...] = ()


@dataclass(frozen=True)
class Criteria:
    """What the suite must be.

    count : of records, or of recordings where their components are kept together
    band : periods at which it is to fit, with weights
    scale_limits : least and largest scale factor [-]
    one_per_event : whether no two may be of one earthquake
    fit : the mean of the "suite", or "each" record
    components : each a "single" record, or those of a recording kept "together" with one factor
    scale_to : how each is scaled before it is compared
    largest_misfit : of one record to the target, mean squared difference of logarithms [-]
    """

    count: int
    band: Band
    filters: Filters = Filters()
    scale_limits: Range = (0.0, inf)
    one_per_event: bool = True
    fit: Fit = "suite"
    components: Components = "single"
    scale_to: ScaleTo = "spectrum"
    largest_misfit: float = inf


@dataclass(frozen=True)
class Choice:
    """One record, or the components of one recording, with its scale factor [-] and misfit [-] to the target."""

    components: tuple[Candidate, ...]
    factor: float
    mse: float


@dataclass(frozen=True)
class Selection:
    """The suite that was chosen, in order of misfit.

    criteria : it was chosen by
    misfit : of its mean spectrum to the target, mean squared difference of logarithms [-]
    greedy : the same for the suite found record by record, before exchanges; None where each record was chosen alone
    counted : (step, how many candidates were left after it)
    """

    criteria: Criteria
    choices: tuple[Choice, ...]
    misfit: float
    greedy: float | None
    counted: tuple[tuple[str, int], ...]


def select(candidates: Sequence[Candidate], spectrum: Spectrum, criteria: Criteria) -> Selection:
    """Select the suite of records that fits a spectrum best, 5 % damping.

    Parameters
    ----------
    candidates : records of catalogues and files
    spectrum : target
    criteria : number, periods, filters, limits and kind of fit

    Raises
    ------
    RecordError : too few candidates are left; lists how many after each step
    """
    band = truncate_band(criteria.band, spectrum.longest_period)
    horizontal = [one for one in candidates if one.shakes]
    known = _known(horizontal, criteria.filters)
    passed = [one for one in known[-1][1] if passes(one, criteria.filters)]
    choices, log_ratio = _scaled(_joined(passed, criteria.components), spectrum, band, criteria.scale_to)
    low, high = criteria.scale_limits
    within = np.array([low <= choice.factor <= high for choice in choices], dtype=np.bool_)
    choices, log_ratio = [choice for choice, keep in zip(choices, within, strict=True) if keep], log_ratio[within]
    misfits = [choice.mse for choice in choices]
    near = np.array([choice.mse <= criteria.largest_misfit for choice in choices], dtype=np.bool_)
    near_ones = ((STEPS["near"], int(near.sum())),) if criteria.largest_misfit < inf else ()
    choices, log_ratio = [choice for choice, keep in zip(choices, near, strict=True) if keep], log_ratio[near]
    groups = event_groups([choice.components for choice in choices], one_per_event=criteria.one_per_event)
    counted = (
        (STEPS["all"], len(candidates)),
        *((step, len(left)) for step, left in known),
        (STEPS["passed"], len(passed)),
        (STEPS["scaled"], int(within.sum())),
        *near_ones,
        (STEPS["apart" if criteria.one_per_event else "free"], len(set(groups.tolist()))),
    )
    if counted[-1][1] < criteria.count:
        steps = ", ".join(f"{number} {step}" for step, number in counted)
        remedy = "widen the limits, or add records"
        remedy += ", or a flatfile that knows more of them" if len(known[-1][1]) < len(horizontal) else ""
        nearest = _nearest_miss(misfits, criteria.largest_misfit)
        raise RecordError(f"{criteria.count} records wanted; there are {steps}{nearest}: {remedy}")
    chosen, greedy = FITS[criteria.fit](_pool(choices, log_ratio, band, groups), criteria.count)
    ratio = _ratios([choices[i] for i in chosen], log_ratio[chosen])
    misfit = float(mean_square(np.log(ratio.mean(axis=0)), weight=band.weight))
    return Selection(
        criteria, tuple(sorted((choices[i] for i in chosen), key=lambda choice: choice.mse)), misfit, greedy, counted
    )


def _nearest_miss(misfits: Sequence[float], largest: float) -> str:
    """Return how far the next record is from the limit of its misfit, in words; empty where none is beyond."""
    beyond = [sqrt(each) / log(10.0) for each in misfits if each > largest]
    if not beyond:
        return ""
    return f" (the next one is {min(beyond):.3f} off in log10, {sqrt(largest) / log(10.0):.3f} is the limit)"


def misfit_of_mean(choices: Sequence[Choice], spectrum: Spectrum, band: Band) -> float:
    """Return the mean squared difference of logarithms between the mean spectrum of choices and the target [-].

    Parameters
    ----------
    choices : with their factors, each with motion at every period
    spectrum : target
    band : periods at which they are compared, with weights
    """
    over = truncate_band(band, spectrum.longest_period)
    _, log_ratio = _scaled([choice.components for choice in choices], spectrum, over, "none")
    return float(mean_square(np.log(_ratios(choices, log_ratio).mean(axis=0)), weight=over.weight))


def passes(candidate: Candidate, filters: Filters) -> bool:
    """Return whether a candidate is what the filters ask for."""
    measures = candidate.measures
    asked = (
        (filters.magnitude, candidate.magnitude),
        (filters.distance, candidate.distance),
        (filters.vs30, candidate.vs30),
        (filters.pga, measures.get("pga")),
        (filters.duration, measures.get("d5_95")),
    )
    if any(span is not None and (value is None or not span[0] <= value <= span[1]) for span, value in asked):
        return False
    name = candidate.event.lower()
    return not filters.events or any(part.lower() in name for part in filters.events)


def _known(level: Sequence[Candidate], filters: Filters) -> list[tuple[str, Sequence[Candidate]]]:
    """List what is left of the horizontal components after each step that drops those with an unknown value."""
    steps = [(STEPS["horizontal"], level)]
    for name, of in KNOWN.items():
        before = steps[-1][1]
        if getattr(filters, name) is not None:
            left = [one for one in before if of(one) is not None]
            steps.append((STEPS[name], left))
    return steps


def _joined(candidates: Sequence[Candidate], components: Components) -> list[tuple[Candidate, ...]]:
    """Take candidates one by one, or those of one recording together, in order of first appearance."""
    if components == "single":
        return [(one,) for one in candidates]
    recordings: dict[str, list[Candidate]] = {}
    for one in candidates:
        recordings.setdefault(one.recording, []).append(one)
    return [tuple(parts) for parts in recordings.values()]


def _scaled(
    joined: Sequence[tuple[Candidate, ...]], spectrum: Spectrum, band: Band, scale_to: ScaleTo
) -> tuple[list[Choice], FloatArray]:
    """Return every choice with its factor and misfit, and ln(target / spectrum) before scaling [n, k].

    Components kept together count by the geometric mean of their spectra. Those without motion at a period are left
    out.
    """
    target = np.log(spectrum.acceleration(band.period, damping=DAMPING))
    with np.errstate(divide="ignore", invalid="ignore"):
        own = np.array([_log_mean([one.spectrum[band.columns] for one in parts]) for parts in joined])
        log_ratio = np.asarray(target - band.at_periods(own.reshape(len(joined), band.nodes.size)), dtype=np.float64)
    moving = np.asarray(np.isfinite(log_ratio).all(axis=1), dtype=np.bool_)
    log_ratio, joined = log_ratio[moving], [parts for parts, keep in zip(joined, moving, strict=True) if keep]
    if scale_to == "spectrum":
        log_factor, mse = least_squares(log_ratio, weight=band.weight)
    else:
        peaks = np.array([_log_mean([np.array(one.measures["pga"]) for one in parts]) for parts in joined])
        log_factor = np.log(spectrum.pga) - peaks if scale_to == "pga" else np.zeros(len(joined))
        mse = mean_square(log_ratio - log_factor.reshape(-1, 1), weight=band.weight)
    factor = np.exp(log_factor)
    made = [Choice(parts, float(f), float(m)) for parts, f, m in zip(joined, factor, mse, strict=True)]
    return made, log_ratio


def _log_mean(spectra: Sequence[FloatArray]) -> FloatArray:
    logs = [np.log(one) for one in spectra]
    return logs[0] if len(logs) == 1 else np.mean(logs, axis=0)


def _ratios(choices: Sequence[Choice], log_ratio: FloatArray) -> FloatArray:
    """Return the scaled spectrum over the target [n, k]."""
    factor = np.array([choice.factor for choice in choices])
    return np.asarray(factor[:, np.newaxis] * np.exp(-log_ratio))


def _pool(choices: Sequence[Choice], log_ratio: FloatArray, band: Band, group: IntArray) -> Pool:
    mse = np.array([choice.mse for choice in choices])
    return Pool(_ratios(choices, log_ratio), band.weight / band.weight.sum(), group, mse)
