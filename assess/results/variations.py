"""Answers under other values of the project's numbers: parametric studies, sensitivity, uncertainty."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.codes.check import Outcome, Role
from assess.codes.verdict import Decision
from assess.messages.message import Message, Term
from assess.results.values import Floats
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class SweepResult(ShortRepr):
    """One mechanism for several values of one number of the project.

    value [n]: in `unit`, as the user wrote it, "-" for none. Parameters [n]: of the branch that uplifts first;
    overturning_rad with rigid joints; overturning_flexible_rad, elastic_frequency_hz: with its own, None if rigid.
    demand_capacity [n]: largest of the checks that decide, capacity_pga_g [n]: least of them; if none decides, of all
    checks by the letter of a code at all levels; None where the mechanism overturned (overturned is True) or no check
    was evaluated. outcome [n]: verdict of the mechanism in each case. controlling: the most critical case, from 0.
    governs: whether that case represents the mechanism in `mechanisms` and in the comparison.
    """

    mechanism: str
    key: str
    unit: str
    value: Floats
    p_eq_per_s: Floats
    uplift_multiplier: tuple[float | None, ...]
    overturning_rad: Floats
    overturning_flexible_rad: tuple[float | None, ...]
    elastic_frequency_hz: tuple[float | None, ...]
    restitution: Floats
    demand_capacity: tuple[float | None, ...]
    overturned: tuple[bool, ...]
    capacity_pga_g: tuple[float | None, ...]
    outcome: tuple[Decision, ...]
    controlling: int
    governs: bool


@dataclass(frozen=True, repr=False)
class SensitivityResult(ShortRepr):
    """One answer of a mechanism with one number at its low and at its high value, all others unchanged.

    parameter : thickness, density, …; key : its key in the project, or the bodies it belongs to
    base, low, high : of the parameter [unit], None if it is not varied, for the reason in `remarks`
    remark : the English of `remarks`
    role : whether the procedure decides the limit state at this level
    quantity : "demand_capacity" at level_pga_g, None where the body overturns or there is no answer; "index" of the
        check that decides, named by `index`; "capacity_pga_g", of all levels, which procedures by histories do not have
        here; "" if nothing is varied
    """

    mechanism: str
    parameter: str
    remark: str
    key: str = ""
    unit: str = ""
    base: float | None = None
    low: float | None = None
    high: float | None = None
    procedure: str = ""
    limit_state: str = ""
    level_pga_g: float | None = None
    quantity: Literal["index", "capacity_pga_g", "demand_capacity", ""] = ""
    at_base: float | None = None
    at_low: float | None = None
    at_high: float | None = None
    verdict_base: Outcome | None = None
    verdict_low: Outcome | None = None
    verdict_high: Outcome | None = None
    role: Role = "comparison"
    index: str = ""
    remarks: tuple[Term | Message, ...] = ()


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
