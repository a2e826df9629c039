"""Time histories of a study: every mechanism under every record, in both polarities, at its levels and on a scan.

The scan raises the target's PGA in steps of SCAN_STEP until a record overturns the mechanism; it gives the curve of
the response-history method and its PGA at collapse. On joints that vibrate about rest a history takes ten times as many
steps of integration, so there the scan has half as many levels.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import inf, log

import numpy as np
from scipy.constants import g

from assess.amplification import Carried
from assess.codes.context import Suite
from assess.dynamics.history import Jobs, Peaks, peaks, trace
from assess.oscillator import Oscillator, elastic_frequency, resisted
from assess.project.motions import Motion
from assess.project.study import Equation
from assess.results import HistoryResult, Trace

Progress = Callable[[str, int, int], None]

SCAN_STEP, JOINTS_STEP = 1.025, 1.05  # ratio of two PGAs of the scan, and where joints vibrate about rest
SCAN_START = 0.4  # of the smaller uplift acceleration, or of what a flexible joint resists at most
BATCH = 1.35  # ratio by which the levels that run at once raise the PGA
MOST_BATCHES = 17


@dataclass(frozen=True)
class Shaken:
    """One oscillator with the equation its histories solve, and every ground motion as it acts at its base."""

    name: str
    oscillator: Oscillator
    equation: Equation
    base: tuple[Carried, ...]


@dataclass(frozen=True)
class Rocking:
    """Histories of one mechanism: [level][record] in the worse polarity, the suites of the scan and those besides."""

    histories: tuple[tuple[HistoryResult, ...], ...]
    scan: tuple[Suite, ...]
    besides: tuple[Suite, ...] = ()


def rocking(
    shaken: Sequence[Shaken],
    motions: Sequence[Motion],
    *,
    levels: Sequence[float],
    besides: Sequence[float],
    site_pga: float,
    scanned: bool,
    threads: int,
    progress: Progress,
) -> dict[str, Rocking]:
    """Histories of every mechanism at `levels` [m/s2], suites at other PGA `besides`, and its scan where `scanned`."""
    done: dict[str, Rocking] = {}
    for count, one in enumerate(shaken):
        progress("rocking histories", count, len(shaken))
        found = asked_of(one, motions, levels=levels, besides=besides, site_pga=site_pga, threads=threads)
        scan = scan_of(one, motions, site_pga=site_pga, threads=threads) if scanned else ()
        done[one.name] = replace(found, scan=scan)
    progress("rocking histories", len(shaken), len(shaken))
    return done


def asked_of(
    shaken: Shaken,
    motions: Sequence[Motion],
    *,
    levels: Sequence[float],
    besides: Sequence[float],
    site_pga: float,
    threads: int,
) -> Rocking:
    """Histories of one mechanism at `levels` and suites at other PGA `besides` [m/s2], without a scan."""
    every = (*levels, *besides)
    runs = run_levels(shaken, motions, levels=every, site_pga=site_pga, threads=threads)
    suites = tuple(suite_of(runs[place], pga=every[place]) for place in range(len(levels), len(every)))
    return Rocking(runs[: len(levels)], (), suites)


def run_levels(
    shaken: Shaken, motions: Sequence[Motion], *, levels: Sequence[float], site_pga: float, threads: int
) -> tuple[tuple[HistoryResult, ...], ...]:
    """[level][record] histories, each in its worse polarity."""
    n, factors = len(motions), np.array([motion.scaling.factor for motion in motions])
    scale = np.asarray(levels)[:, None, None] / site_pga * factors[None, :, None] * np.array([1.0, -1.0])
    motion = np.broadcast_to(np.arange(n)[None, :, None], scale.shape)
    jobs = Jobs(np.zeros(scale.size, dtype=np.int64), motion.ravel().astype(np.int64), scale.ravel())
    records = [carried.record for carried in shaken.base]
    found = peaks([shaken.oscillator], records, jobs, equation=shaken.equation, threads=threads)
    at = np.arange(scale.size).reshape(scale.shape)
    return tuple(
        tuple(
            min((_history(found, int(job), carried, level, float(jobs.scale[job])) for job in at[i, k]), key=_mildness)
            for k, carried in enumerate(shaken.base)
        )
        for i, level in enumerate(levels)
    )


def _history(found: Peaks, job: int, carried: Carried, level: float, scale: float) -> HistoryResult:
    overturned = bool(found.overturned[job])
    return HistoryResult(
        record=carried.record.id,
        polarity=1 if scale >= 0 else -1,
        level_pga_g=level / g,
        scale_factor=abs(scale),
        amplification=carried.factor,
        max_rotation_rad=None if overturned else float(found.max_rotation[job]),
        max_rotation_ratio=None if overturned else float(found.max_ratio[job]),
        time_of_max_s=None if overturned else float(found.time_of_max[job]),
        impacts=int(found.impacts[job]),
        overturned=overturned,
        overturning_time_s=float(found.overturning_time[job]) if overturned else None,
        trace=None,
        branch="negative" if found.max_rotation[job] < 0 else "positive",
    )


def _mildness(history: HistoryResult) -> float:
    """Smaller is worse; of two polarities that overturn, or that rest, the first stands."""
    return -inf if history.max_rotation_ratio is None else -history.max_rotation_ratio


def suite_of(histories: Sequence[HistoryResult], *, pga: float) -> Suite:
    """The maxima of all records at `pga` [m/s2]; the branch is that of the worst record."""
    worst = min(histories, key=_mildness)
    ratios, branches = tuple(h.max_rotation_ratio for h in histories), tuple(h.branch for h in histories)
    return Suite(pga, ratios, worst.branch, branches)


def scan_of(shaken: Shaken, motions: Sequence[Motion], *, site_pga: float, threads: int) -> tuple[Suite, ...]:
    """Suites at rising PGA, up to and with the first in which a record overturns the mechanism."""
    strongest = max(m.scaling.factor * at.record.pga for m, at in zip(motions, shaken.base, strict=True)) / site_pga
    uplift = g * min(resisted(branch) for branch in shaken.oscillator.branches)
    start = SCAN_START * uplift / max(1.0, strongest)
    vibrates = any(elastic_frequency(branch) is not None for branch in shaken.oscillator.branches)
    step = JOINTS_STEP if vibrates else SCAN_STEP
    batch = round(log(BATCH) / log(step))
    suites: list[Suite] = []
    for first in range(0, MOST_BATCHES * batch, batch):
        levels = [start * step ** (first + k) for k in range(batch)]
        for level, histories in zip(
            levels, run_levels(shaken, motions, levels=levels, site_pga=site_pga, threads=threads), strict=True
        ):
            suites.append(suite_of(histories, pga=level))
            if suites[-1].overturned:
                return tuple(suites)
    return tuple(suites)


def governing_trace(
    shaken: Shaken, histories: Sequence[Sequence[HistoryResult]], motions: Sequence[Motion]
) -> tuple[tuple[HistoryResult, ...], ...]:
    """The histories with the trace of the worst record of the highest level filled in."""
    *lower, highest = [tuple(level) for level in histories]
    worst = min(highest, key=_mildness)
    place = next(place for place, motion in enumerate(motions) if motion.record.id == worst.record)
    ground, base = motions[place].record, shaken.base[place].record
    scale = worst.polarity * worst.scale_factor
    path = trace(shaken.oscillator, base, scale=scale, equation=shaken.equation)
    below = np.interp(path.time, ground.time, ground.acceleration, right=0.0)
    drawn = Trace(
        time_s=tuple(path.time.tolist()),
        rotation_rad=tuple(path.rotation.tolist()),
        ground_acceleration_g=tuple((scale / g * below).tolist()),
        base_acceleration_g=None
        if base is ground
        else tuple((scale / g * base.acceleration[: path.time.size]).tolist()),
    )
    return (*lower, tuple(replace(history, trace=drawn) if history is worst else history for history in highest))
