"""The answers of one mechanism over all samples: demand over capacity and outcome of each, and nothing else is kept."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from math import inf

import numpy as np
from numpy.typing import NDArray

from assess.amplification.floor_motion import Amplification
from assess.codes.check import Check, Outcome
from assess.messages.message import Message, note, whole_number
from assess.study.sensitivity_rows import Answer
from assess.study.study import Study
from spectra.arrays import FloatArray

PASSED, FAILED, OPEN = 0, 1, -1
"""Outcomes of a sample; open: not answered."""
SAME = 1e-9  # two ratios that differ by less are one
Flags = NDArray[np.bool_]
Outcomes = NDArray[np.int8]


@dataclass(frozen=True)
class SampleAnswers:
    """The answers of one sample, in the order of the questions.

    ratio : demand over capacity [k]; inf where it fails without a finite one, nan where it is not answered
    outcome : of `PASSED`, `FAILED`, `OPEN` [k]; rocking : the equation of its histories, None if it was not built
    reasons : why not answered, by the place of the question
    error : why the mechanism could not be built; then nothing is answered
    """

    ratio: FloatArray
    outcome: Outcomes
    rocking: Rocking | None = None
    reasons: Mapping[int, Message] = field(default_factory=dict)
    error: str = ""


@dataclass(frozen=True)
class Rocking:
    """The equation of motion of a mechanism over its inertia at rest, and how the ground's motion reaches its base."""

    numbers: tuple[FloatArray, ...]
    amplification: Amplification

    def same(self, other: Rocking) -> bool:
        """Return whether two mechanisms rock alike, but for rounding."""
        pairs = list(zip(self.numbers, other.numbers, strict=False))
        alike = all(a.shape == b.shape and np.allclose(a, b, rtol=SAME, atol=SAME) for a, b in pairs)
        return alike and len(self.numbers) == len(other.numbers) and self.amplification == other.amplification


def rocking_of(study: Study) -> Rocking:
    """Return how the one mechanism of a study rocks."""
    (mechanism,) = study.mechanisms
    numbers: list[FloatArray] = []
    for branch in mechanism.variants.deciding.branches:
        tables = (branch.inertia, branch.restoring, branch.excitation, branch.lift)
        numbers += [branch.rotation, *(table / branch.inertia[0] for table in tables), np.array([branch.restitution])]
    return Rocking(tuple(numbers), study.amplified[mechanism.name].amplification)


def sample_answers(questions: Sequence[Answer], checks: Mapping[Answer, Check], rocking: Rocking) -> SampleAnswers:
    """Return the answers of the checks of a sample to the questions."""
    found = [checks.get(each) for each in questions]
    return SampleAnswers(
        np.array([_ratio(check) for check in found]),
        np.array([_outcome(check) for check in found], dtype=np.int8),
        rocking,
        {place: check.reason for place, check in enumerate(found) if check is not None and _outcome(check) == OPEN},
    )


def unbuilt(questions: Sequence[Answer], why: str) -> SampleAnswers:
    """Return a sample that could not be built, with the reason."""
    count = len(questions)
    return SampleAnswers(np.full(count, np.nan), np.full(count, OPEN, dtype=np.int8), error=why)


def _outcome(check: Check | None) -> int:
    if check is None or check.verdict not in (Outcome.PASS, Outcome.FAIL):
        return OPEN
    return FAILED if check.verdict == Outcome.FAIL else PASSED


def _ratio(check: Check | None) -> float:
    if check is None or _outcome(check) == OPEN:
        return np.nan
    if check.ratio is None:
        return inf if check.verdict == Outcome.FAIL else 0.0
    return check.ratio


def same_answers(one: SampleAnswers, other: SampleAnswers, *, histories: Flags) -> Flags:
    """Return which answers are the same in two samples, but for rounding [k].

    histories : which answers follow from histories, that may amplify rounding; they are the same where the mechanism
        rocks alike
    """
    near = np.isclose(one.ratio, other.ratio, rtol=SAME, atol=SAME, equal_nan=True) & (one.outcome == other.outcome)
    alike = one.rocking is not None and other.rocking is not None and one.rocking.same(other.rocking)
    return np.asarray(near | (histories & alike), dtype=np.bool_)


class Tally:
    """The ratios and outcomes of the samples of one mechanism [samples, questions], filled in sample by sample."""

    def __init__(self, samples: int, questions: Sequence[Answer]) -> None:
        self.questions = tuple(questions)
        self.ratio = np.full((samples, len(questions)), np.nan)
        self.outcome = np.full((samples, len(questions)), OPEN, dtype=np.int8)
        self.unbuilt: tuple[int, str] = (0, "")
        self.open: tuple[dict[str, tuple[int, Message]], ...] = tuple({} for _ in questions)

    def put(self, sample: int, found: SampleAnswers) -> None:
        """Keep the answers of one sample."""
        self.ratio[sample], self.outcome[sample] = found.ratio, found.outcome
        if found.error:
            self.unbuilt = (self.unbuilt[0] + 1, self.unbuilt[1] or found.error)
        for place, reason in found.reasons.items():
            number, first = self.open[place].get(reason.key, (0, reason))
            self.open[place][reason.key] = (number + 1, first)

    def open_answers(self, place: int) -> Iterator[Message]:
        """Yield how many samples have no answer to a question, with the first reason of each kind."""
        samples = whole_number(len(self.outcome))
        number, why = self.unbuilt
        if number:
            yield note("uncertainty-not-built", number=whole_number(number), samples=samples, why=why)
        for number, reason in self.open[place].values():
            yield note("uncertainty-open", number=whole_number(number), samples=samples, why=reason)
