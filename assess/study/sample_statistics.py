"""Quantiles, probability of failing and influences of one answer over its samples."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypedDict

import numpy as np

from assess.results.uncertainty import QUANTILES, Influence
from assess.risk.wilson import wilson
from assess.study.sample_answers import FAILED, OPEN, Outcomes
from spectra.arrays import FloatArray


class Statistics(TypedDict):
    """The fields of an uncertain answer that are counted."""

    answered: int
    failed: int
    probability: float | None
    interval: tuple[float, float] | None
    quantiles: tuple[float | None, ...]
    ratios: tuple[float | None, ...]


def statistics_of(ratio: FloatArray, outcome: Outcomes) -> Statistics:
    """Return what is counted over the samples of one answer.

    Parameters
    ----------
    ratio : demand over capacity, inf where it fails without a finite one, nan where it is not answered [samples]
    outcome : `PASSED`, `FAILED` or `OPEN` [samples]
    """
    answered, failed = int(np.count_nonzero(outcome != OPEN)), int(np.count_nonzero(outcome == FAILED))
    low, high = wilson(failed, answered) if answered else (0.0, 0.0)
    return Statistics(
        answered=answered,
        failed=failed,
        probability=failed / answered if answered else None,
        interval=(float(low), float(high)) if answered else None,
        quantiles=quantiles(ratio[outcome != OPEN]),
        ratios=tuple(float(each) if np.isfinite(each) else None for each in ratio),
    )


def quantiles(ratio: FloatArray) -> tuple[float | None, ...]:
    """Return the quantiles of ratios at `QUANTILES`, linear between samples; None where there is no finite one."""
    if not ratio.size:
        return (None,) * len(QUANTILES)
    rising = np.sort(ratio)
    place = np.array(QUANTILES) / 100.0 * (rising.size - 1)
    below, above = rising[np.floor(place).astype(int)], rising[np.ceil(place).astype(int)]
    finite = np.isfinite(above)
    step = np.subtract(above, below, where=finite, out=np.zeros_like(above))
    found = below + (place % 1.0) * step
    return tuple(float(each) if known else None for each, known in zip(found, finite, strict=True))


def influences_of(
    columns: Mapping[str, FloatArray],
    keys: Mapping[str, tuple[str, ...]],
    ratio: FloatArray,
    outcome: Outcomes,
    moves: Mapping[str, bool],
) -> tuple[Influence, ...]:
    """Return what each group does to one answer: Spearman's correlation of the ranks, and its square.

    Groups are sampled independently, so that the square is the share of the variance of the ranks of the answer that
    a straight line over the ranks of the group explains.

    Parameters
    ----------
    columns : probability at which each group is in each sample [samples], by group
    keys : of the numbers of each group
    ratio, outcome : of the answer [samples]
    moves : whether the group changes the answer at all
    """
    known = outcome != OPEN
    found = []
    for group, column in columns.items():
        rho = spearman(column[known], ratio[known]) if moves[group] else None
        found.append(Influence(group, keys[group], rho, None if rho is None else rho**2))
    return tuple(found)


def spearman(one: FloatArray, other: FloatArray) -> float | None:
    """Return the correlation of the ranks of two samples, equal values at their mean rank; None if one is constant."""
    from scipy.stats import rankdata  # late: it takes a third of a second

    if one.size < 2 or np.ptp(one) == 0.0 or np.all(other == other[0]):
        return None
    a, b = rankdata(one), rankdata(other)
    return float(np.corrcoef(a, b)[0, 1])
