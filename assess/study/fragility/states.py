"""Which runs reach a state, and how the runs of a record answer at intensities of any measure."""

from __future__ import annotations

from dataclasses import dataclass
from math import ceil, log

import numpy as np

from assess.results.fragility import LARGE_SCALE, StateResult
from assess.short_repr import ShortRepr
from assess.study.fragility.runs import Runs
from spectra.arrays import BoolArray, FloatArray, IntArray


@dataclass(frozen=True, repr=False)
class Outcomes(ShortRepr):
    """Whether each record reaches a state at the same intensities.

    intensity [n] rising; reached [records, n]; known [records, n] : where the record counts
    hollow [records, n] : where it is scaled by more than 4
    """

    intensity: FloatArray
    reached: BoolArray
    known: BoolArray
    hollow: BoolArray


def reaches(runs: Runs, state: StateResult) -> BoolArray:
    """Return which runs reach a state [records, levels]; a run that does not exist does not.

    Parameters
    ----------
    runs : of all records
    state : rocking is any rotation, overturning is no return
    """
    with np.errstate(invalid="ignore"):
        if state.name == "overturning":
            return np.isposinf(runs.ratio)
        least = np.nextafter(0.0, 1.0) if state.share is None else state.share
        return np.asarray(runs.ratio >= least)


def outcomes(runs: Runs, unit: FloatArray, reached: BoolArray, *, primary: bool) -> Outcomes:
    """Return whether each record reaches a state at the intensities of a measure.

    Each record is a step function of its intensity: at each intensity it is as in its run of nearest logarithm. All
    records are run at the same intensities of the primary measure, so there each point is a run; other measures have
    points in the same ratio. Below its least scale a record is as there, where it does not rock. Above its largest
    scale it counts as reaching the state if it does there; if it stands there, it is censored and does not count.

    Parameters
    ----------
    runs : of all records, at scales of one ratio
    unit : intensity of each record at scale 1 [records]
    reached : which runs reach the state [records, levels]
    primary : whether it is the measure that records are scaled by, or proportional to it
    """
    intensity = runs.scale * unit[:, None]
    step = float(np.nanmax(runs.scale[:, 1] / runs.scale[:, 0]))
    levels = np.nanmax(intensity, axis=0) if primary else _levels(intensity, step)
    known, found, hollow = np.zeros((3, unit.size, levels.size), dtype=bool)
    for record, end in enumerate(runs.last):
        own = intensity[record, : end + 1]
        place = _nearest(np.log(own), np.log(levels))
        found[record], hollow[record] = reached[record, place], runs.scale[record, place] > LARGE_SCALE
        known[record] = (levels <= own[-1] * np.sqrt(step) * (1.0 + 1e-9)) | reached[record, end]
    return Outcomes(levels, found & known, known, hollow)


def _levels(intensity: FloatArray, step: float) -> FloatArray:
    """Return intensities in the ratio of the runs, from the least to the largest of records that are run twice."""
    twice = intensity[~np.isnan(intensity[:, 1])]
    least, most = float(np.nanmin(twice)), float(np.nanmax(twice))
    return np.geomspace(least, most, 1 + ceil(log(most / least) / log(step) - 1e-9))


def _nearest(rising: FloatArray, at: FloatArray) -> IntArray:
    """Return the place of the nearest of rising numbers [n]; of two as near, the upper one."""
    middle = 0.5 * (rising[1:] + rising[:-1])
    return np.asarray(np.searchsorted(middle, at, side="right"), dtype=np.int64)


def first_bounds(runs: Runs, unit: FloatArray, reached: BoolArray) -> tuple[FloatArray, FloatArray]:
    """Return the intensities between which each record first reaches a state [records], [records].

    The lower is 0 where it does at its least scale; the upper is inf where it stands at all scales.

    Parameters
    ----------
    runs : of all records
    unit : intensity of each record at scale 1 [records]
    reached : which runs reach the state [records, levels]
    """
    rows = np.arange(unit.size)
    ever, first = reached.any(axis=1), reached.argmax(axis=1)
    below = np.where(ever, first - 1, runs.last)
    lower = np.where(below >= 0, runs.scale[rows, np.maximum(below, 0)], 0.0)
    upper = np.where(ever, runs.scale[rows, first], np.inf)
    return lower * unit, upper * unit


def islands(scale: FloatArray, overturned: BoolArray) -> tuple[tuple[float, float], ...]:
    """Return the ranges of scale in which a record leaves the mechanism standing although a lower one overturns it.

    Parameters
    ----------
    scale : of the runs of one record, rising [n]
    overturned : whether each overturns [n]
    """
    if not overturned.any():
        return ()
    stands = np.concatenate([[False], ~overturned & (np.arange(scale.size) > overturned.argmax()), [False]])
    change = np.diff(stands.astype(np.int8))
    starts, ends = np.flatnonzero(change == 1), np.flatnonzero(change == -1) - 1
    return tuple((float(scale[a]), float(scale[b])) for a, b in zip(starts, ends, strict=True))
