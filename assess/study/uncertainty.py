"""How the answers spread when the uncertain numbers of a study vary together.

One coordinate of a scrambled Sobol sequence (Owen 1995; scipy.stats.qmc) stands for each group; the numbers of a group
are at the same probability. Every sample is each mechanism alone through its procedures, under the same scaled records,
without the scan over rising PGA, as a sensitivity is. Of each sample only demand over capacity and outcome are kept.

Numbers stay within what is physically possible: a distribution that reaches beyond a limit, as a lognormal restitution
beyond 1, is cut there and the rest scaled up.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from math import log1p, sqrt

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import ndtr, ndtri

from assess.codes.check import Check, Outcome
from assess.codes.procedures import uses_histories
from assess.errors import AssessError
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message, Quantity, note, whole_number
from assess.results import MechanismResult
from assess.results.run import QUANTILES, Distribution, Influence, UncertainAnswer, UncertaintyResult
from assess.risk.estimates import wilson_interval
from assess.study.study import Progress, SampledNumber, Sampling, ScaledRecord, Study
from assess.study.variations import CaseChecks, CheckKey, check_case, checks_by_key, ratio_of
from spectra.arrays import FloatArray
from spectra.errors import SpectrumError
from spectra.spectrum import Spectrum

END_PROBABILITIES = (0.05, 0.95)
"""Probabilities at which each group is varied alone, to see what it changes."""
LEAST_SHARE_REPORTED = 1e-6  # of a distribution beyond what is possible

Questions = Mapping[str, Mapping[CheckKey, Check]]
"""The checks of each mechanism at the means, by what they answer."""


def uncertainty(
    study: Study,
    spectrum: Spectrum,
    motions: tuple[ScaledRecord, ...],
    results: Sequence[MechanismResult],
    *,
    jobs: int,
    progress: Progress,
) -> UncertaintyResult | None:
    """Assess every sample of the uncertain numbers of a study.

    Parameters
    ----------
    study : the study, with its sampling
    spectrum : the site's elastic spectrum
    motions : the suite of records, the same for all samples
    results : the mechanisms as assessed with the means
    jobs : number of threads that share the histories of a sample; 0 for all cores. The results do not depend on it.
    progress : called as samples are done

    Returns
    -------
    The answers of each mechanism that an uncertain number can change; None if nothing is sampled.
    """
    sampling = study.sampling
    if sampling is None:
        return None
    questions = {result.name: _questions_of(result) for result in results if sampling.groups_of(result.name)}
    check = partial(check_case, suite_faults=study.suite_faults, spectrum=spectrum, motions=motions, jobs=jobs)
    sampler = Sampler(sampling, questions, check)
    points = sobol_points(sampling, sampling.samples)
    tallies = {name: Tally(sampling.samples, tuple(checks)) for name, checks in questions.items()}
    for sample, point in enumerate(points):
        progress("samples", sample, len(points))
        for name, case in sampler.cases_at(point).items():
            tallies[name].put(sample, case)
    changed = _find_changed_answers(sampler, points)
    answers = tuple(
        answer
        for name, tally in tallies.items()
        for answer in answers_of(name, tally, questions[name], points, sampling, changed)
    )
    answers = tuple(_with_totals(answers, sampler, points, tallies, changed, progress))
    return UncertaintyResult(
        samples=sampling.samples,
        seed=sampling.seed,
        inputs=tuple(number.input for number in sampling.numbers),
        answers=answers,
        notes=(
            *sampling.notes,
            *_cut_off_messages(sampling.numbers),
            *_no_effect_messages(sampling, questions, changed),
        ),
    )


@dataclass(frozen=True)
class Sampler:
    """Assesses the mechanisms of a study at values of its uncertain numbers.

    One sample follows the other: threads that build mechanisms only wait for each other (2 of them took 1.6 times the
    time of one), those of the kernel do not.

    check : assesses a study of one mechanism by some procedures
    """

    sampling: Sampling
    questions: Questions
    check: Callable[[Callable[[], Study], Iterable[str]], CaseChecks]

    def cases_at(self, point: FloatArray, only: Sequence[str] | None = None) -> dict[str, CaseChecks]:
        """Return the checks of mechanisms at the probability of each group [groups], nan for the means.

        only : the mechanisms to assess; all if None
        """
        names = tuple(self.questions) if only is None else only
        try:
            build = self.sampling.study_at(values_at_point(self.sampling, point))
        except (AssessError, SpectrumError) as error:
            return {name: CaseChecks(error=str(error)) for name in names}
        return {name: self.check(partial(build, name), [key[0] for key in self.questions[name]]) for name in names}


def values_at_point(sampling: Sampling, point: FloatArray) -> tuple[float, ...]:
    """Return the value of each number at the probability of its group [groups], its mean where that is nan."""
    probability = dict(zip(sampling.groups, point.tolist(), strict=True))
    pairs = ((number, probability[number.input.group]) for number in sampling.numbers)
    return tuple(number.input.mean if np.isnan(p) else float(values_at(number, p)) for number, p in pairs)


def sobol_points(sampling: Sampling, number: int) -> FloatArray:
    """Return the first points as probabilities, each in the middle of its cell, in (0, 1) [number, groups]."""
    from scipy.stats import qmc  # late: it takes a third of a second

    sequence = qmc.Sobol(len(sampling.groups), scramble=True, rng=np.random.default_rng(sampling.seed))
    points = sequence.random_base2((number - 1).bit_length())[:number]
    return np.asarray(points + 0.5 / 2.0**sequence.bits)


def answers_of(
    name: str,
    tally: Tally,
    checks: Mapping[CheckKey, Check],
    points: FloatArray,
    sampling: Sampling,
    changed: Mapping[tuple[str, str], Flags],
) -> Iterator[UncertainAnswer]:
    """Yield every answer of one mechanism over all samples."""
    columns = {group: points[:, sampling.groups.index(group)] for group in sampling.groups_of(name)}
    for place, check in enumerate(checks.values()):
        ratio, outcome = tally.ratio[:, place], tally.outcome[:, place]
        is_answered = outcome != OPEN
        answered, failed = int(np.count_nonzero(is_answered)), int(np.count_nonzero(outcome == FAILED))
        low, high = wilson_interval(failed, answered) if answered else (0.0, 0.0)
        moving = {group: column for group, column in columns.items() if changed[name, group][place]}
        influences = (
            _influence(group, sampling.keys_of(group), moving.get(group), ratio, is_answered) for group in columns
        )
        yield UncertainAnswer(
            mechanism=name,
            procedure=check.procedure,
            limit_state=check.limit_state,
            level_pga_g=check.level_pga_g,
            role=check.role,
            answered=answered,
            failed=failed,
            probability=failed / answered if answered else None,
            interval=(float(low), float(high)) if answered else None,
            at_mean=check.ratio,
            quantiles=quantiles(ratio[is_answered]),
            ratios=tuple(float(each) if np.isfinite(each) else None for each in ratio),
            influences=tuple(influences) if answered else (),
            notes=(
                *tally.open_answers(place),
                *(note("uncertainty-no-influence", group=each) for each in columns if answered and each not in moving),
            ),
        )


EXPLAINED = 0.9
"""Sum of the shares of an answer's influences below which their totals are found."""
TOTAL_SAMPLES = 128
"""Samples that totals are found from, at most: their standard error is some 0.05."""


def total_influence(values: FloatArray, changed: FloatArray) -> float | None:
    """Return the total Sobol index of a group, of the ranks of an answer [-]; None where the answer never varies.

    Half the mean square of what the answer's rank changes by, over its variance, when the group alone takes the value
    of another sample: Jansen 1999, Computer Physics Communications 117, 35-43. Ranks stay finite where an answer does
    not.

    Parameters
    ----------
    values : of the answer in each sample, nan where there is none [n]
    changed : the same with the group at its value in another sample [n]
    """
    known = ~(np.isnan(values) | np.isnan(changed))
    rising = np.sort(values[known])
    rank, other = (
        0.5 * (np.searchsorted(rising, each[known], "left") + np.searchsorted(rising, each[known], "right"))
        for each in (values, changed)
    )
    variance = float(np.var(rank)) if rank.size else 0.0
    return min(1.0, float(np.mean((rank - other) ** 2)) / (2.0 * variance)) if variance > 0.0 else None


def _with_totals(
    answers: Sequence[UncertainAnswer],
    sampler: Sampler,
    points: FloatArray,
    tallies: Mapping[str, Tally],
    changed: Mapping[tuple[str, str], Flags],
    progress: Progress,
) -> Iterator[UncertainAnswer]:
    """Yield the answers, with the totals of their influences where the shares explain too little."""
    groups, number = sampler.sampling.groups, min(TOTAL_SAMPLES, len(points))
    order = np.random.default_rng(sampler.sampling.seed).permutation(number)
    partner = np.empty_like(order)
    partner[order] = np.roll(order, 1)  # another sample for each
    little = {
        answer.mechanism
        for answer in answers
        if answer.influences and sum(each.share or 0.0 for each in answer.influences) < EXPLAINED
    }
    swapped: dict[tuple[str, str], FloatArray] = {}
    for name, group in ((name, group) for name in tallies for group in groups if name in little):
        if (name, group) in changed and changed[name, group].any():
            tally, column = Tally(number, tallies[name].questions), groups.index(group)
            for sample, point in enumerate(points[:number]):
                progress("total influences", sample, number)
                other = np.where(np.arange(len(groups)) == column, points[partner[sample]], point)
                tally.put(sample, sampler.cases_at(other, (name,))[name])
            swapped[name, group] = tally.ratio
    places = {name: iter(range(len(tally.questions))) for name, tally in tallies.items()}
    for answer in answers:
        place = next(places[answer.mechanism])
        own = tallies[answer.mechanism].ratio[:number, place]
        explained = sum(each.share or 0.0 for each in answer.influences)
        yield replace(
            answer,
            influences=tuple(
                each
                if each.share is None or explained >= EXPLAINED or (answer.mechanism, each.group) not in swapped
                else replace(each, total=total_influence(own, swapped[answer.mechanism, each.group][:, place]))
                for each in answer.influences
            ),
        )


PASSED, FAILED, OPEN = 0, 1, -1
"""Outcomes of a sample; open: not answered."""
SAME_RATIO = 1e-9  # two ratios that differ by less are one
Flags = NDArray[np.bool_]
SampleOutcomes = NDArray[np.int8]


class Tally:
    """The ratios and outcomes of the samples of one mechanism [samples, questions], filled in sample by sample."""

    def __init__(self, samples: int, questions: Sequence[CheckKey]) -> None:
        self.questions = tuple(questions)
        self.ratio = np.full((samples, len(questions)), np.nan)
        self.outcome = np.full((samples, len(questions)), OPEN, dtype=np.int8)
        self.unbuilt: tuple[int, str] = (0, "")
        self.open: tuple[dict[str, tuple[int, Message]], ...] = tuple({} for _ in questions)

    def put(self, sample: int, case: CaseChecks) -> None:
        """Keep the answers of one sample."""
        found = case.by_key
        for place, key in enumerate(self.questions):
            check = found.get(key)
            self.ratio[sample, place], self.outcome[sample, place] = _ratio(check), _outcome(check)
            if check is not None and _outcome(check) == OPEN:
                number, first = self.open[place].get(check.reason.key, (0, check.reason))
                self.open[place][check.reason.key] = (number + 1, first)
        if case.error:
            self.unbuilt = (self.unbuilt[0] + 1, self.unbuilt[1] or case.error)

    def open_answers(self, place: int) -> Iterator[Message]:
        """Yield how many samples have no answer to a question, with the first reason of each kind."""
        samples = whole_number(len(self.outcome))
        number, why = self.unbuilt
        if number:
            yield note("uncertainty-not-built", number=whole_number(number), samples=samples, why=why)
        for number, reason in self.open[place].values():
            yield note("uncertainty-open", number=whole_number(number), samples=samples, why=reason)


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
    return tuple(float(each) if is_finite else None for each, is_finite in zip(found, finite, strict=True))


MEAN_POINTS = 4096
"""Equally likely values that a mean is taken over."""


def values_at(number: SampledNumber, probability: ArrayLike) -> FloatArray:
    """Return the values of a number that it does not exceed with these probabilities.

    Parameters
    ----------
    number : with its mean m and coefficient of variation V
    probability : in (0, 1) [n]

    Returns
    -------
    [n] [unit of the number]
    """
    distribution = number.input
    below, above = _beyond_limits(number)
    p = below + np.asarray(probability, dtype=np.float64) * (1.0 - below - above)
    return distribution.mean * _values_over_mean(distribution.distribution, distribution.cov, p)


def share_cut_off(number: SampledNumber) -> float:
    """Return the probability that a number would lie beyond its physical limits, if it had none."""
    return sum(_beyond_limits(number))


def _questions_of(result: MechanismResult) -> Mapping[CheckKey, Check]:
    """Return the checks of a mechanism whose spread is of use: by the letter of a clause that covers it."""
    return checks_by_key(
        tuple(check for check in result.checks if check.follows_code and check.verdict != Outcome.NOT_APPLICABLE)
    )


def _find_changed_answers(sampler: Sampler, points: FloatArray) -> dict[tuple[str, str], Flags]:
    """Return by mechanism and group which answers change when the group alone goes to both `END_PROBABILITIES`.

    The others are at their means, then at their values in the first sample.
    """
    groups = sampler.sampling.groups
    changed: dict[tuple[str, str], Flags] = {}
    for base in (np.full(len(groups), np.nan), points[0]):
        names = [[name for name in sampler.questions if group in sampler.sampling.groups_of(name)] for group in groups]
        ends = [(place, end) for place in range(len(groups)) for end in END_PROBABILITIES if names[place]]
        at_base = sampler.cases_at(base)
        for place, end in ends:
            point = np.where(np.arange(len(groups)) == place, end, base)
            for name, case in sampler.cases_at(point, names[place]).items():
                key, differs = (name, groups[place]), _differing_answers(sampler.questions[name], at_base[name], case)
                changed[key] = changed.get(key, np.zeros_like(differs)) | differs
    return changed


def _cut_off_messages(numbers: Sequence[SampledNumber]) -> Iterator[Message]:
    """Report distributions that reach beyond what is possible."""
    for number in numbers:
        share = share_cut_off(number)
        if share > LEAST_SHARE_REPORTED:
            mean = Quantity(_mean_kept(number), "ratio", 3)
            yield note("uncertainty-cut-off", number.input.key, share=Quantity(share, "ratio", 2), mean=mean)


def _no_effect_messages(
    sampling: Sampling, questions: Questions, changed: Mapping[tuple[str, str], Flags]
) -> Iterator[Message]:
    """Report the groups that change no answer at all."""
    for group in sampling.groups:
        touched = [name for name in questions if group in sampling.groups_of(name)]
        if not any(changed[name, group].any() for name in touched):
            yield note("uncertainty-idle", "analysis.uncertainty", keys=", ".join(sampling.keys_of(group)))


def _rock_alike(one: Study, other: Study) -> bool:
    """Whether the one mechanism of two studies rocks alike, on a base that moves alike, but for rounding."""
    (first,), (second,) = one.mechanisms, other.mechanisms
    if one.amplified[first.name].amplification != other.amplified[second.name].amplification:
        return False
    tables, others = _rocking_tables(first), _rocking_tables(second)
    return len(tables) == len(others) and all(
        a.shape == b.shape and np.allclose(a, b, rtol=SAME_RATIO, atol=SAME_RATIO)
        for a, b in zip(tables, others, strict=True)
    )


def _rocking_tables(mechanism: Mechanism) -> list[FloatArray]:
    """Return the equation of motion of a mechanism over its inertia at rest."""
    numbers: list[FloatArray] = []
    for branch in mechanism.variants.deciding.branches:
        tables = (branch.inertia, branch.restoring, branch.excitation, branch.lift)
        numbers += [branch.rotation, *(table / branch.inertia[0] for table in tables), np.array([branch.restitution])]
    return numbers


def _outcome(check: Check | None) -> int:
    if check is None or check.verdict not in (Outcome.PASS, Outcome.FAIL):
        return OPEN
    return FAILED if check.verdict == Outcome.FAIL else PASSED


def _ratio(check: Check | None) -> float:
    return np.nan if check is None or _outcome(check) == OPEN else ratio_of(check)


def _differing_answers(questions: Iterable[CheckKey], one: CaseChecks, other: CaseChecks) -> Flags:
    """Return which answers differ between two cases, by more than rounding [k].

    Histories may amplify rounding: theirs are the same where the mechanism rocks alike.
    """
    checks, others = one.by_key, other.by_key
    alike = one.study is not None and other.study is not None and _rock_alike(one.study, other.study)
    return np.array(
        [not (alike and uses_histories(key[0])) and _differ(checks.get(key), others.get(key)) for key in questions],
        dtype=np.bool_,
    )


def _differ(one: Check | None, other: Check | None) -> bool:
    near = np.isclose(_ratio(one), _ratio(other), rtol=SAME_RATIO, atol=SAME_RATIO, equal_nan=True)
    return not near or _outcome(one) != _outcome(other)


def _influence(
    group: str, keys: tuple[str, ...], column: FloatArray | None, ratio: FloatArray, answered: Flags
) -> Influence:
    """Return what a group does to one answer: Spearman's correlation of the ranks, and its square.

    Groups are sampled independently, so that the square is the share of the variance of the ranks of the answer that
    a straight line over the ranks of the group explains.

    Parameters
    ----------
    group : its name
    keys : of its numbers
    column : probability at which it is in each sample [samples]; None if it does not change the answer at all
    ratio, answered : of the answer [samples]
    """
    rho = None if column is None else _spearman(column[answered], ratio[answered])
    return Influence(group, keys, rho, None if rho is None else rho**2)


def _spearman(one: FloatArray, other: FloatArray) -> float | None:
    """Return the correlation of the ranks of two samples, equal values at their mean rank; None if one is constant."""
    from scipy.stats import rankdata  # late: it takes a third of a second

    if one.size < 2 or np.ptp(one) == 0.0 or np.all(other == other[0]):
        return None
    a, b = rankdata(one), rankdata(other)
    return float(np.corrcoef(a, b)[0, 1])


def _mean_kept(number: SampledNumber) -> float:
    """Return the mean of the values that a number takes within its physical limits, over the mean that is given."""
    middles = (np.arange(MEAN_POINTS) + 0.5) / MEAN_POINTS
    return float(values_at(number, middles).mean() / number.input.mean)


def _beyond_limits(number: SampledNumber) -> tuple[float, float]:
    """Return the probabilities below the least and above the most share of the mean."""
    kind, cov = number.input.distribution, number.input.cov
    return _probability(kind, cov, number.least), 1.0 - _probability(kind, cov, number.most)


def _values_over_mean(kind: Distribution, cov: float, p: FloatArray) -> FloatArray:
    """Return values over the mean: 1 + V z; exp(b z - b^2 / 2) with b^2 = ln(1 + V^2); 1 + sqrt(3) V (2 p - 1)."""
    if kind == "uniform":
        return 1.0 + sqrt(3.0) * cov * (2.0 * p - 1.0)
    z = ndtri(p)
    if kind == "normal":
        return np.asarray(1.0 + cov * z)
    b = sqrt(log1p(cov**2))
    return np.asarray(np.exp(b * z - b**2 / 2.0))


def _probability(kind: Distribution, cov: float, share: float) -> float:
    """Return the probability of a value below a share of the mean: the inverse of `_shares`."""
    if kind == "uniform":
        return float(np.clip(0.5 + (share - 1.0) / (2.0 * sqrt(3.0) * cov), 0.0, 1.0))
    if kind == "normal":
        return float(ndtr((share - 1.0) / cov))
    if share <= 0.0:
        return 0.0
    b = sqrt(log1p(cov**2))
    return float(ndtr((np.log(share) + b**2 / 2.0) / b))
