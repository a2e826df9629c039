"""How the answers spread when uncertain numbers of the project vary together."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.codes.check import Role
from assess.messages.message import Message
from assess.short_repr import ShortRepr

Distribution = Literal["normal", "lognormal", "uniform"]
QUANTILES = (5, 16, 50, 84, 95)
"""Percent of the samples below each quantile."""


@dataclass(frozen=True, repr=False)
class UncertainInput(ShortRepr):
    """A number of the project given by its mean and coefficient of variation.

    key : in the project; unit : SI, "-" for none; mean [unit]; cov [-]; group : those of one name vary together
    """

    key: str
    unit: str
    mean: float
    cov: float
    distribution: Distribution
    group: str


@dataclass(frozen=True, repr=False)
class Influence(ShortRepr):
    """What one group of inputs does to one answer.

    rank_correlation : Spearman's, of the demand over capacity; None where the group does not change the answer
    share : of the variance of its ranks that a line over those of the group explains, the square of it [-]
    """

    group: str
    keys: tuple[str, ...]
    rank_correlation: float | None
    share: float | None


@dataclass(frozen=True, repr=False)
class UncertainAnswer(ShortRepr):
    """One answer over all samples.

    answered : samples with an answer; failed : of these; probability : failed / answered, with its Wilson interval at
    95 %, that of as many independent samples; at_mean : demand over capacity with every number at its mean
    quantiles : of demand over capacity at `QUANTILES`, None where that sample has no finite one
    influences : of the groups that can change the mechanism; notes : samples without an answer, groups without effect
    ratios [samples] : of each sample in their order, None without a finite one
    """

    mechanism: str
    procedure: str
    limit_state: str
    level_pga_g: float | None
    role: Role
    answered: int
    failed: int
    probability: float | None
    interval: tuple[float, float] | None
    at_mean: float | None
    quantiles: tuple[float | None, ...]
    ratios: tuple[float | None, ...]
    influences: tuple[Influence, ...]
    notes: tuple[Message, ...] = ()

    @property
    def unanswered(self) -> int:
        """How many samples have no answer."""
        return len(self.ratios) - self.answered


@dataclass(frozen=True, repr=False)
class UncertaintyResult(ShortRepr):
    """The samples of a project: their number, the seed of the Sobol sequence, what varies and the answers."""

    samples: int
    seed: int
    inputs: tuple[UncertainInput, ...]
    answers: tuple[UncertainAnswer, ...]
    notes: tuple[Message, ...] = ()
