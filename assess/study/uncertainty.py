"""How the answers spread when the uncertain numbers of a study vary together.

One coordinate of a scrambled Sobol sequence (Owen 1995; scipy.stats.qmc) stands for each group; the numbers of a group
are at the same probability. Every sample is each mechanism alone through its procedures, under the same scaled records,
without the scan over rising PGA, as a sensitivity is.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from assess.codes.check import Check, Outcome
from assess.codes.families import uses_histories
from assess.errors import AssessError
from assess.messages.message import Message, Quantity, note
from assess.results import MechanismResult
from assess.results.uncertainty import UncertainAnswer, UncertaintyResult
from assess.study.distributions import mean_kept, share_cut_off, values_at
from assess.study.motions import ScaledRecord
from assess.study.progress import Progress
from assess.study.sample_answers import (
    OPEN,
    Flags,
    SampleAnswers,
    Tally,
    rocking_of,
    same_answers,
    sample_answers,
    unbuilt,
)
from assess.study.sample_statistics import influences_of, statistics_of
from assess.study.sensitivity import check_case
from assess.study.sensitivity_rows import Answer, by_answer
from assess.study.study import Sampled, Sampling, Study
from spectra.arrays import FloatArray
from spectra.errors import SpectrumError
from spectra.spectrum import Spectrum

ENDS = (0.05, 0.95)
"""Probabilities at which each group is varied alone, to see what it changes."""
TOLD = 1e-6  # of a distribution beyond what is possible
Questions = Mapping[str, Mapping[Answer, Check]]
"""The checks of each mechanism at the means, by what they answer."""


def uncertainty(
    study: Study,
    spectrum: Spectrum,
    motions: tuple[ScaledRecord, ...],
    mechanisms: Sequence[MechanismResult],
    *,
    jobs: int,
    progress: Progress,
) -> UncertaintyResult | None:
    """Assess every sample of the uncertain numbers of a study.

    Parameters
    ----------
    study : Study
        The study, with its sampling.
    spectrum : Spectrum
        The site's elastic spectrum.
    motions : tuple of ScaledRecord
        The suite of records, the same for all samples.
    mechanisms : sequence of MechanismResult
        The mechanisms as assessed with the means.
    jobs : int
        Number of threads that share the histories of a sample; 0 for all cores. The results do not depend on it.
    progress : Progress
        Called as samples are done.

    Returns
    -------
    UncertaintyResult or None
        The answers of each mechanism that an uncertain number can change; None if nothing is sampled.
    """
    sampling = study.sampling
    if sampling is None:
        return None
    questions = {each.name: questions_of(each) for each in mechanisms if sampling.groups_of(each.name)}
    sampler = Sampler(study, sampling, spectrum, motions, questions, jobs)
    points = sobol(sampling)
    tallies = {name: Tally(sampling.samples, tuple(asked)) for name, asked in questions.items()}
    for sample, point in enumerate(points):
        progress("samples", sample, len(points))
        for name, each in sampler.at(point).items():
            tallies[name].put(sample, each)
    changed = changes(sampler, points)
    answers = tuple(
        answer
        for name, tally in tallies.items()
        for answer in answers_of(name, tally, questions[name], points, sampling, changed)
    )
    return UncertaintyResult(
        samples=sampling.samples,
        seed=sampling.seed,
        inputs=tuple(number.given for number in sampling.numbers),
        answers=answers,
        notes=(*sampling.notes, *cut_off(sampling.numbers), *idle(sampling, questions, changed)),
    )


def questions_of(mechanism: MechanismResult) -> Mapping[Answer, Check]:
    """Return the checks of a mechanism whose spread is of use: by the letter of a clause that covers it."""
    return by_answer(
        tuple(
            check
            for check in mechanism.checks
            if check.reading == "letter" and not check.informs and check.verdict != Outcome.NOT_APPLICABLE
        )
    )


def sobol(sampling: Sampling) -> FloatArray:
    """Return the samples as probabilities, each in the middle of its cell, in (0, 1) [samples, groups]."""
    from scipy.stats import qmc  # late: it takes a third of a second

    sequence = qmc.Sobol(len(sampling.groups), scramble=True, rng=np.random.default_rng(sampling.seed))
    return np.asarray(sequence.random_base2(sampling.samples.bit_length() - 1) + 0.5 / 2.0**sequence.bits)


class Sampler:
    """Assesses the mechanisms of a study at values of its uncertain numbers.

    One sample follows the other: threads that build mechanisms only wait for each other (2 of them took 1.6 times the
    time of one), those of the kernel do not.
    """

    def __init__(
        self,
        study: Study,
        sampling: Sampling,
        spectrum: Spectrum,
        motions: tuple[ScaledRecord, ...],
        questions: Questions,
        jobs: int,
    ) -> None:
        self.study, self.sampling, self.spectrum, self.motions = study, sampling, spectrum, motions
        self.questions, self.jobs = questions, jobs

    def at(self, point: FloatArray, only: Sequence[str] | None = None) -> dict[str, SampleAnswers]:
        """Return the answers at the probability of each group [groups], nan for the means.

        only : the mechanisms to assess; all if None
        """
        names = tuple(self.questions) if only is None else only
        asked = {name: tuple(self.questions[name]) for name in names}
        try:
            build = self.sampling.study_at(self.values(point))
        except (AssessError, SpectrumError) as error:
            return {name: unbuilt(asked[name], str(error)) for name in names}
        found = {}
        for name in names:
            procedures = tuple(dict.fromkeys(procedure for procedure, _, _ in asked[name]))
            try:
                case = replace(build(name), procedures=procedures, suite_faults=self.study.suite_faults)
                checks = by_answer(check_case(case, self.spectrum, self.motions, jobs=self.jobs))
                found[name] = sample_answers(asked[name], checks, rocking_of(case))
            except (AssessError, SpectrumError) as error:
                found[name] = unbuilt(asked[name], str(error))
        return found

    def values(self, point: FloatArray) -> tuple[float, ...]:
        """Return the value of each number at the probability of its group, its mean where that is nan."""
        at = dict(zip(self.sampling.groups, point.tolist(), strict=True))
        pairs = ((number, at[number.given.group]) for number in self.sampling.numbers)
        return tuple(number.given.mean if np.isnan(p) else float(values_at(number, p)) for number, p in pairs)


def changes(sampler: Sampler, points: FloatArray) -> dict[tuple[str, str], Flags]:
    """Return by mechanism and group which answers change when the group alone goes to both `ENDS`.

    The others are at their means, then at their values in the first sample.
    """
    groups = sampler.sampling.groups
    by_histories = {
        name: np.array([uses_histories(procedure) for procedure, _, _ in asked], dtype=np.bool_)
        for name, asked in sampler.questions.items()
    }
    changed: dict[tuple[str, str], Flags] = {}
    for base in (np.full(len(groups), np.nan), points[0]):
        names = [[each for each in sampler.questions if group in sampler.sampling.groups_of(each)] for group in groups]
        asked = [(place, end) for place in range(len(groups)) for end in ENDS if names[place]]
        moved = [np.where(np.arange(len(groups)) == place, end, base) for place, end in asked]
        at_base = sampler.at(base)
        for (place, _), point in zip(asked, moved, strict=True):
            for name, each in sampler.at(point, names[place]).items():
                key, known = (name, groups[place]), by_histories[name]
                differs = ~same_answers(at_base[name], each, histories=known)
                changed[key] = changed.get(key, np.zeros_like(known)) | differs
    return changed


def answers_of(
    name: str,
    tally: Tally,
    asked: Mapping[Answer, Check],
    points: FloatArray,
    sampling: Sampling,
    changed: Mapping[tuple[str, str], Flags],
) -> Iterator[UncertainAnswer]:
    """Yield every answer of one mechanism over all samples."""
    groups = sampling.groups_of(name)
    keys = {group: tuple(n.given.key for n in sampling.numbers if n.given.group == group) for group in groups}
    columns = {group: points[:, sampling.groups.index(group)] for group in groups}
    for place, check in enumerate(asked.values()):
        ratio, outcome = tally.ratio[:, place], tally.outcome[:, place]
        moves = {group: bool(changed[name, group][place]) for group in groups}
        answered = bool(np.any(outcome != OPEN))
        still = tuple(group for group in groups if answered and not moves[group])
        yield UncertainAnswer(
            mechanism=name,
            procedure=check.procedure,
            limit_state=check.limit_state,
            level_pga_g=check.level_pga_g,
            role=check.role,
            at_mean=check.ratio,
            influences=influences_of(columns, keys, ratio, outcome, moves) if answered else (),
            notes=(*tally.open_answers(place), *(note("uncertainty-no-influence", group=group) for group in still)),
            **statistics_of(ratio, outcome),
        )


def cut_off(numbers: Sequence[Sampled]) -> Iterator[Message]:
    """Report distributions that reach beyond what is possible."""
    for number in numbers:
        share = share_cut_off(number)
        if share > TOLD:
            mean = Quantity(mean_kept(number), "ratio", 3)
            yield note("uncertainty-cut-off", number.given.key, share=Quantity(share, "ratio", 2), mean=mean)


def idle(sampling: Sampling, questions: Questions, changed: Mapping[tuple[str, str], Flags]) -> Iterator[Message]:
    """Report the groups that change no answer at all."""
    for group in sampling.groups:
        touched = [name for name in questions if group in sampling.groups_of(name)]
        if not any(changed[name, group].any() for name in touched):
            keys = ", ".join(number.given.key for number in sampling.numbers if number.given.group == group)
            yield note("uncertainty-idle", "analysis.uncertainty", keys=keys)
