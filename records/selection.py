"""Which records of a catalogue make a suite for a target spectrum.

Candidates pass the filters, are scaled to the target one by one, and must keep within the limits of the scale factor.
Of those that are left either the records that fit best one by one are taken, or the suite whose mean spectrum fits
best: greedy, record by record, then improved by exchanging one record at a time until no exchange helps. Where the
suites are few, all of them are tried. Recordings of one earthquake, or of one motion in two files, are one event group.

A selection that was locked is known again by SHA-256 of its target and its records, of numbers rounded so that the last
digits of another machine do not change it.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, islice
from math import comb, inf, isclose, log, sqrt
from typing import Annotated, Literal

import numpy as np

from assess.declaration import Acceleration, IsRange, Length, Ratio, Speed, Time
from records.candidates import DAMPING, PERIODS, Candidate
from records.errors import RecordError
from records.record import Record
from records.scaling import Band, least_squares, mean_square, truncate_band
from spectra.arrays import BoolArray, FloatArray, IntArray
from spectra.spectrum import Spectrum

Range = tuple[float, float]
ScaleTo = Literal["spectrum", "pga", "none"]
Components = Literal["single", "together"]

FILTERED_METADATA: Mapping[str, Callable[[Candidate], float | None]] = {
    "magnitude": lambda candidate: candidate.magnitude,
    "distance": lambda candidate: candidate.distance,
    "vs30": lambda candidate: candidate.vs30,
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
class CandidateFilters:
    """What a candidate must be; both ends of a range included, None for any. What is not known does not pass."""

    magnitude: Annotated[tuple[Ratio, Ratio], IsRange()] | None = None
    """[from, to]; a record whose magnitude is not known is left out, as below"""
    distance: Annotated[tuple[Length, Length], IsRange()] | None = None
    """[from, to], like ["0 km", "50 km"]"""
    vs30: Annotated[tuple[Speed, Speed], IsRange()] | None = None
    """[from, to], like ["360 m/s", "800 m/s"]"""
    pga: Annotated[tuple[Acceleration, Acceleration], IsRange()] | None = None
    """[from, to], before scaling"""
    duration: Annotated[tuple[Time, Time], IsRange()] | None = None
    """[from, to] of D5-95"""
    events: tuple[str, ...] = ()
    """parts of the names of the earthquakes allowed; all if absent"""


@dataclass(frozen=True)
class SuiteCriteria:
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
    filters: CandidateFilters = CandidateFilters()
    scale_limits: Range = (0.0, inf)
    one_per_event: bool = True
    fit: Fit = "suite"
    components: Components = "single"
    scale_to: ScaleTo = "spectrum"
    largest_misfit: float = inf


@dataclass(frozen=True)
class ScaledRecording:
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

    criteria: SuiteCriteria
    choices: tuple[ScaledRecording, ...]
    misfit: float
    greedy: float | None
    counted: tuple[tuple[str, int], ...]


def select(candidates: Sequence[Candidate], spectrum: Spectrum, criteria: SuiteCriteria) -> Selection:
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
    horizontal = [each for each in candidates if each.horizontal_at_surface]
    of_known = _of_known_metadata(horizontal, criteria.filters)
    passed = [each for each in of_known[-1][1] if passes(each, criteria.filters)]
    choices, log_ratio = _scaled(_join_components(passed, criteria.components), spectrum, band, criteria.scale_to)
    low, high = criteria.scale_limits
    within = np.array([low <= choice.factor <= high for choice in choices], dtype=np.bool_)
    choices, log_ratio = [choice for choice, keep in zip(choices, within, strict=True) if keep], log_ratio[within]
    misfits = [choice.mse for choice in choices]
    fitting = np.array([choice.mse <= criteria.largest_misfit for choice in choices], dtype=np.bool_)
    fitting_step = ((STEPS["near"], int(fitting.sum())),) if criteria.largest_misfit < inf else ()
    choices, log_ratio = [choice for choice, keep in zip(choices, fitting, strict=True) if keep], log_ratio[fitting]
    groups = event_groups([choice.components for choice in choices], one_per_event=criteria.one_per_event)
    counted = (
        (STEPS["all"], len(candidates)),
        *((step, len(remaining)) for step, remaining in of_known),
        (STEPS["passed"], len(passed)),
        (STEPS["scaled"], int(within.sum())),
        *fitting_step,
        (STEPS["apart" if criteria.one_per_event else "free"], len(set(groups.tolist()))),
    )
    if counted[-1][1] < criteria.count:
        steps = ", ".join(f"{number} {step}" for step, number in counted)
        remedy = "widen the limits, or add records"
        remedy += ", or a flatfile that knows more of them" if len(of_known[-1][1]) < len(horizontal) else ""
        nearest = _nearest_miss(misfits, criteria.largest_misfit)
        raise RecordError(f"{criteria.count} records wanted; there are {steps}{nearest}: {remedy}")
    chosen, greedy_misfit = FITS[criteria.fit](_pool(choices, log_ratio, band, groups), criteria.count)
    ratio = _ratios([choices[i] for i in chosen], log_ratio[chosen])
    misfit = float(mean_square(np.log(ratio.mean(axis=0)), weight=band.weight))
    by_misfit = tuple(sorted((choices[i] for i in chosen), key=lambda choice: choice.mse))
    return Selection(criteria, by_misfit, misfit, greedy_misfit, counted)


def misfit_of_mean(choices: Sequence[ScaledRecording], spectrum: Spectrum, band: Band) -> float:
    """Return the mean squared difference of logarithms between the mean spectrum of choices and the target [-].

    Parameters
    ----------
    choices : with their factors, each with motion at every period
    spectrum : target
    band : periods at which they are compared, with weights
    """
    compared = truncate_band(band, spectrum.longest_period)
    _, log_ratio = _scaled([choice.components for choice in choices], spectrum, compared, "none")
    return float(mean_square(np.log(_ratios(choices, log_ratio).mean(axis=0)), weight=compared.weight))


def passes(candidate: Candidate, filters: CandidateFilters) -> bool:
    """Return whether a candidate is what the filters ask for."""
    measures = candidate.measures
    ranges = (
        (filters.magnitude, candidate.magnitude),
        (filters.distance, candidate.distance),
        (filters.vs30, candidate.vs30),
        (filters.pga, measures.get("pga")),
        (filters.duration, measures.get("d5_95")),
    )
    if any(limits is not None and (value is None or not limits[0] <= value <= limits[1]) for limits, value in ranges):
        return False
    name = candidate.event.lower()
    return not filters.events or any(part.lower() in name for part in filters.events)


Fit = Literal["suite", "each"]
COUNTABLE = 20_000  # suites that are all tried
EXCHANGED = 2_000  # records, those of least misfit, that may be exchanged into a suite
CHUNK = 1_000


@dataclass(frozen=True)
class Pool:
    """What suites are made of: scaled spectrum over target [n, k], weights [k] that sum to 1, group and misfit [n]."""

    ratio: FloatArray
    weight: FloatArray
    group: IntArray
    mse: FloatArray

    def misfit(self, mean: FloatArray) -> FloatArray:
        """Return the misfit of mean spectra over target [..., k]."""
        return np.asarray(np.log(mean) ** 2 @ self.weight)


def best_suite(pool: Pool, count: int) -> tuple[list[int], float]:
    """Choose the `count` records whose mean fits best; return also the misfit of the greedy suite, its upper bound."""
    first = greedy_suite(pool, count)
    before = _misfit_of(pool, first)
    if comb(pool.mse.size, count) <= COUNTABLE:
        return exhaustive_suite(pool, count), before
    starts = (first, _best_each(pool, count)[0])
    return min((exchanged_suite(pool, start) for start in starts), key=lambda chosen: _misfit_of(pool, chosen)), before


def greedy_suite(pool: Pool, count: int) -> list[int]:
    """Choose record by record, each time the one that makes the mean fit best."""
    chosen: list[int] = []
    total = np.zeros(pool.weight.size)
    free = np.ones(pool.mse.size, dtype=np.bool_)
    for size in range(1, count + 1):
        score = np.where(free, pool.misfit((total + pool.ratio) / size), inf)
        best = int(np.argmin(score))
        chosen.append(best)
        total = total + pool.ratio[best]
        free &= pool.group != pool.group[best]
    return chosen


def exchanged_suite(pool: Pool, start: Sequence[int]) -> list[int]:
    """Improve a suite by exchanging one record at a time for the best other, until no exchange helps."""
    chosen, among = list(start), np.argsort(pool.mse, kind="stable")[:EXCHANGED]
    ratio, group = pool.ratio[among], pool.group[among]
    least, better = _misfit_of(pool, chosen), True
    while better:
        better = False
        for place in range(len(chosen)):
            others = [i for k, i in enumerate(chosen) if k != place]
            free = ~np.isin(group, pool.group[others])
            score = np.where(free, pool.misfit((pool.ratio[others].sum(axis=0) + ratio) / len(chosen)), inf)
            best = int(np.argmin(score))
            if score[best] < least * (1 - 1e-9):
                chosen[place], least, better = int(among[best]), float(score[best]), True
    return chosen


def exhaustive_suite(pool: Pool, count: int) -> list[int]:
    """Choose the best of all suites."""
    best, least = greedy_suite(pool, count), inf
    for suites in _chunks(combinations(range(pool.mse.size), count)):
        group = np.sort(pool.group[suites], axis=1)
        allowed: BoolArray = np.all(np.diff(group, axis=1) > 0, axis=1)
        if not allowed.any():
            continue
        score = pool.misfit(pool.ratio[suites[allowed]].mean(axis=1))
        if score.min() < least:
            least, best = float(score.min()), suites[allowed][int(np.argmin(score))].tolist()
    return best


def _best_each(pool: Pool, count: int) -> tuple[list[int], None]:
    """Choose the `count` records of least misfit, the best of each group."""
    chosen: list[int] = []
    taken: set[int] = set()
    for i in np.argsort(pool.mse, kind="stable").tolist():
        if pool.group[i] not in taken and len(chosen) < count:
            chosen.append(i)
            taken.add(int(pool.group[i]))
    return chosen, None


def _chunks(suites: Iterator[tuple[int, ...]]) -> Iterator[IntArray]:
    while part := list(islice(suites, CHUNK)):
        yield np.array(part, dtype=np.int64)


def _misfit_of(pool: Pool, chosen: Sequence[int]) -> float:
    return float(pool.misfit(pool.ratio[list(chosen)].mean(axis=0)))


FITS: Mapping[Fit, Callable[[Pool, int], tuple[list[int], float | None]]] = {"suite": best_suite, "each": _best_each}

Recording = tuple[Candidate, ...]  # the components of one recording that are chosen together
SAME_SHAPE = 0.01  # largest difference of the logarithms of two spectra of one motion; digits differ between files
COARSE = 8  # of how many ordinates one is compared first


def event_groups(recordings: Sequence[Recording], *, one_per_event: bool) -> IntArray:
    """Number the groups of recordings [n] of which a suite may have only one.

    Recordings of one motion are one group, and with `one_per_event` also those of one earthquake. Where a motion is in
    two files of which only one names its earthquake, both are of that earthquake.
    """
    pairs = [same_motion(recordings)]
    if one_per_event:
        pairs.append(_same_earthquake(recordings))
    first, second = np.concatenate(pairs).T
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    graph = coo_array((np.ones(first.size), (first, second)), shape=(len(recordings), len(recordings)))
    return np.asarray(connected_components(graph, directed=False)[1], dtype=np.int64)


def same_motion(recordings: Sequence[Recording]) -> IntArray:
    """Pair recordings [m, 2] with a component whose spectrum has the same shape, to one percent."""
    recording_of = np.array([index for index, components in enumerate(recordings) for _ in components], dtype=np.int64)
    spectra = [component.spectrum for components in recordings for component in components]
    if not spectra:
        return np.empty((0, 2), dtype=np.int64)
    log = np.log(np.maximum(spectra, 1e-300))
    shape = log - log.max(axis=1, keepdims=True)
    from scipy.spatial import KDTree

    near = KDTree(shape[:, ::COARSE]).query_pairs(SAME_SHAPE, p=np.inf, output_type="ndarray").reshape(-1, 2)
    alike = np.abs(shape[near[:, 0]] - shape[near[:, 1]]).max(axis=1) <= SAME_SHAPE
    return np.asarray(recording_of[near[alike]], dtype=np.int64)


SHAPE_FIGURES = 6  # of an ordinate over the peak ground acceleration
SAMPLE_STEP = 1e-4  # m/s2, to which samples are rounded
SAME_PGA = 1e-9  # relative difference of peak ground accelerations that are one


@dataclass(frozen=True)
class TargetMark:
    """What tells one target spectrum from another.

    code : as in the project file
    pga : peak ground acceleration [m/s2]
    sha256 : of the shape, the 5 % ordinates over the peak ground acceleration
    """

    code: str
    pga: float
    sha256: str

    def is_of(self, spectrum: Spectrum) -> bool:
        """Return whether a spectrum has this shape and this peak ground acceleration."""
        other = target_mark(spectrum)
        return other.sha256 == self.sha256 and isclose(other.pga, self.pga, rel_tol=SAME_PGA)


def target_mark(spectrum: Spectrum) -> TargetMark:
    """Return what tells a target spectrum from others."""
    period = PERIODS[spectrum.longest_period >= PERIODS]
    shape = spectrum.acceleration(period, damping=DAMPING) / spectrum.pga
    text = " ".join(f"{each:.{SHAPE_FIGURES}g}" for each in shape.tolist())
    return TargetMark(spectrum.code, spectrum.pga, hashlib.sha256(text.encode()).hexdigest())


def samples_sha256(record: Record) -> str:
    """Return the SHA-256 of the step and the samples of a record, rounded to 1e-4 m/s2."""
    rounded = np.round(record.acceleration / SAMPLE_STEP).astype("<i8")
    return hashlib.sha256(f"{record.dt:.9g} ".encode() + rounded.tobytes()).hexdigest()


def _nearest_miss(misfits: Sequence[float], largest: float) -> str:
    """Return how far the next record is from the limit of its misfit, in words; empty where none is beyond it."""
    beyond = [sqrt(each) / log(10.0) for each in misfits if each > largest]
    if not beyond:
        return ""
    return f" (the next one is {min(beyond):.3f} off in log10, {sqrt(largest) / log(10.0):.3f} is the limit)"


def _of_known_metadata(
    horizontal: Sequence[Candidate], filters: CandidateFilters
) -> list[tuple[str, Sequence[Candidate]]]:
    """List what is left of the horizontal components after each step that drops those with an unknown value."""
    steps = [(STEPS["horizontal"], horizontal)]
    for name, value_of in FILTERED_METADATA.items():
        before = steps[-1][1]
        if getattr(filters, name) is not None:
            remaining = [each for each in before if value_of(each) is not None]
            steps.append((STEPS[name], remaining))
    return steps


def _join_components(candidates: Sequence[Candidate], components: Components) -> list[tuple[Candidate, ...]]:
    """Take candidates one by one, or those of one recording together, in order of first appearance."""
    if components == "single":
        return [(each,) for each in candidates]
    recordings: dict[str, list[Candidate]] = {}
    for each in candidates:
        recordings.setdefault(each.recording, []).append(each)
    return [tuple(components_of) for components_of in recordings.values()]


def _scaled(
    recordings: Sequence[tuple[Candidate, ...]], spectrum: Spectrum, band: Band, scale_to: ScaleTo
) -> tuple[list[ScaledRecording], FloatArray]:
    """Return every choice with its factor and misfit, and ln(target / spectrum) before scaling [n, k].

    Components kept together count by the geometric mean of their spectra. Those without motion at a period are left
    out.
    """
    target = np.log(spectrum.acceleration(band.period, damping=DAMPING))
    with np.errstate(divide="ignore", invalid="ignore"):
        log_spectra = np.array(
            [_log_mean([component.spectrum[band.columns] for component in components]) for components in recordings]
        )
        log_ratio = np.asarray(
            target - band.at_periods(log_spectra.reshape(len(recordings), band.nodes.size)), dtype=np.float64
        )
    with_motion = np.asarray(np.isfinite(log_ratio).all(axis=1), dtype=np.bool_)
    log_ratio, recordings = (
        log_ratio[with_motion],
        [components for components, keep in zip(recordings, with_motion, strict=True) if keep],
    )
    if scale_to == "spectrum":
        log_factor, mse = least_squares(log_ratio, weight=band.weight)
    else:
        peaks = np.array(
            [_log_mean([np.array(component.measures["pga"]) for component in components]) for components in recordings]
        )
        log_factor = np.log(spectrum.pga) - peaks if scale_to == "pga" else np.zeros(len(recordings))
        mse = mean_square(log_ratio - log_factor.reshape(-1, 1), weight=band.weight)
    factor = np.exp(log_factor)
    scaled = [
        ScaledRecording(components, float(f), float(m))
        for components, f, m in zip(recordings, factor, mse, strict=True)
    ]
    return scaled, log_ratio


def _log_mean(spectra: Sequence[FloatArray]) -> FloatArray:
    logs = [np.log(each) for each in spectra]
    return logs[0] if len(logs) == 1 else np.mean(logs, axis=0)


def _ratios(choices: Sequence[ScaledRecording], log_ratio: FloatArray) -> FloatArray:
    """Return the scaled spectrum over the target [n, k]."""
    factor = np.array([choice.factor for choice in choices])
    return np.asarray(factor[:, np.newaxis] * np.exp(-log_ratio))


def _pool(choices: Sequence[ScaledRecording], log_ratio: FloatArray, band: Band, group: IntArray) -> Pool:
    mse = np.array([choice.mse for choice in choices])
    return Pool(_ratios(choices, log_ratio), band.weight / band.weight.sum(), group, mse)


def _same_earthquake(recordings: Sequence[Recording]) -> IntArray:
    """Pair each recording with the first of its earthquake [m, 2]."""
    first: dict[str, int] = {}
    pairs = [(first.setdefault(components[0].earthquake, index), index) for index, components in enumerate(recordings)]
    return np.array(pairs, dtype=np.int64).reshape(-1, 2)
