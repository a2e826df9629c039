"""How likely it is that at least one of several mechanisms overturns, under the same records at the same intensities.

Mechanisms of one building feel the same motion, so that their overturnings go together: the share of records under
which at least one overturns is counted, and what independent mechanisms would give stands beside it. Of mechanisms
that share a body, which are alternatives, the one that overturns most often counts. Each mechanism is taken in its
worse polarity. Where mechanisms were run at different intensities, each is as in its run of nearest logarithm.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import reduce
from math import ceil, log

import numpy as np

from assess.results.fragility import StateResult, UnionFragility
from assess.short_repr import ShortRepr
from assess.study.fragility_curves import curve_outcomes, fragility_curve
from assess.study.fragility_runs import FragilityRuns, Intensities, nearest, scale_factors
from assess.study.study import FragilityQuestion
from spectra.arrays import FloatArray

OVERTURNING = StateResult("overturning")


@dataclass(frozen=True, repr=False)
class NamedRuns(ShortRepr):
    """The runs of a mechanism, with the intensities of the records by every measure, the primary one first."""

    name: str
    runs: FragilityRuns
    all_intensities: tuple[Intensities, ...]


def find_union(
    mechanisms: Sequence[NamedRuns],
    bodies: Mapping[str, Sequence[str]],
    events: Sequence[str],
    question: FragilityQuestion,
) -> UnionFragility | None:
    """Return the fragility of several mechanisms together; None where fewer than two may be counted together.

    Parameters
    ----------
    mechanisms : under the same records
    bodies : that move in each mechanism, by its name
    events : earthquake of each record [records]
    question : method, seed and draws
    """
    common = _common_intensities(mechanisms)
    if len(mechanisms) < 2 or common is None:
        return None
    scale, ratios = _at_same_scales([each.runs for each in mechanisms], common.unit, question)
    overturned = {each.name: int(np.isinf(ratio).sum()) for each, ratio in zip(mechanisms, ratios, strict=True)}
    counted: list[str] = []
    for name in sorted(overturned, key=lambda name: -overturned[name]):
        if not any(set(bodies.get(name, ())) & set(bodies.get(other, ())) for other in counted):
            counted.append(name)
    if len(counted) < 2:
        return None
    own = [ratio for each, ratio in zip(mechanisms, ratios, strict=True) if each.name in counted]
    runs = _known_runs(scale, reduce(_worse, own), mechanisms[0].runs.stripe)
    known = curve_outcomes(runs, common, OVERTURNING, question).known
    number = known.sum(axis=0)
    with np.errstate(invalid="ignore"):
        stands = np.prod([1.0 - (np.isinf(ratio) & known).sum(axis=0) / number for ratio in own], axis=0)
    names = [each.name for each in mechanisms]
    return UnionFragility(
        mechanisms=tuple(name for name in names if name in counted),
        left_out=tuple(name for name in names if name not in counted),
        curve=fragility_curve(runs, common, OVERTURNING, events, question),
        if_independent=tuple((1.0 - stands[number > 0]).tolist()),
    )


def _common_intensities(mechanisms: Sequence[NamedRuns]) -> Intensities | None:
    """Return the first measure of the ground by which the records have one intensity for all mechanisms."""
    if not mechanisms:
        return None
    first, *others = mechanisms
    for one in first.all_intensities:
        same = [each for other in others for each in other.all_intensities if each.measure == one.measure]
        if one.measure.at == "ground" and all(np.array_equal(each.unit, one.unit) for each in same):
            return Intensities(one.measure, one.unit, primary=True)
    return None


def _at_same_scales(
    all_runs: Sequence[FragilityRuns], unit: FloatArray, question: FragilityQuestion
) -> tuple[FloatArray, list[FloatArray]]:
    """Return scales [records, levels], and the ratios of each mechanism there; nan where they are not known."""
    first = all_runs[0].scale
    if all(np.array_equal(each.scale, first, equal_nan=True) for each in all_runs):
        return first, [each.ratio for each in all_runs]
    intensity = [each.scale * unit[:, None] for each in all_runs]
    step = min(float(np.nanmax(each.scale[:, 1] / each.scale[:, 0])) for each in all_runs)
    least, most = (float(f([f(each) for each in intensity])) for f in (np.nanmin, np.nanmax))
    levels = np.geomspace(least, most, 1 + ceil(log(most / least) / log(step) - 1e-9))
    scale = scale_factors(levels, unit, most=question.largest_factor)
    scale[np.isnan(scale).all(axis=1), 0] = question.largest_factor
    return scale, [_nearest_ratio(each, scale, step) for each in all_runs]


def _nearest_ratio(runs: FragilityRuns, scale: FloatArray, step: float) -> FloatArray:
    """Return the ratio of each record in its run of nearest logarithm of scale; nan above the last, if it stands."""
    ratio = np.full(scale.shape, np.nan)
    for record, end in enumerate(runs.last):
        own, wanted = runs.scale[record, : end + 1], scale[record]
        found = runs.ratio[record, nearest(np.log(own), np.log(wanted))]
        within = (wanted <= own[-1] * np.sqrt(step) * (1.0 + 1e-9)) | np.isinf(runs.ratio[record, end])
        ratio[record] = np.where(within, found, np.nan)
    return ratio


def _worse(one: FloatArray, other: FloatArray) -> FloatArray:
    """Return the larger ratio; overturned where one is, not known where only one is known and stands."""
    return np.where(np.isinf(one) | np.isinf(other), np.inf, np.maximum(one, other))


def _known_runs(scale: FloatArray, ratio: FloatArray, stripe: FloatArray | None) -> FragilityRuns:
    """Return runs that end where the first ratio of a record is not known."""
    unknown = np.logical_or.accumulate(np.isnan(ratio), axis=1)
    return FragilityRuns(np.where(unknown, np.nan, scale), np.where(unknown, np.nan, ratio), stripe)
