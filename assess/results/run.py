"""The whole tree of one run: spectrum and records, mechanisms, and answers under other values of the numbers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from assess.codes.check import Outcome, Role
from assess.codes.verdict import Decision, Verdict
from assess.messages.message import Message, Term
from assess.results.before import CapacitiesResult
from assess.results.mechanism import BodyEdges, CriticalResult, MechanismResult, TieResult
from assess.results.provenance import NO_MATTER, Floats, Input, Program, ReportMatter, ResolvedValue
from assess.results.verification import AnnexResult
from assess.short_repr import ShortRepr, html_table

SCHEMA_VERSION = 2


@dataclass(frozen=True, repr=False)
class Results(ShortRepr):
    """One run, whole.

    project : maps each key, written with dots, to its resolved value
    stamp : of the inputs and the program, the same in every output of these results; "" in results of older versions
    falling : mechanisms that fall under their own loads, which have no more than their place in the verdict
    uncertainty : None where the project gives no uncertain numbers, and in results of older versions
    verification : the annex of verification that the run names; None where there is none
    beside : the bodies of the project that belong to no mechanism, such as floors and roofs, for drawing
    ties : of the building, each once
    before : the state of the building before the works, of the results that the project names; None where it names none
    """

    schema_version: int
    program: Program
    inputs: tuple[Input, ...]
    warnings: tuple[Message, ...]
    project: dict[str, ResolvedValue]
    spectrum: SpectrumResult | None
    records: tuple[RecordResult, ...]
    mechanisms: tuple[MechanismResult, ...]
    critical: CriticalResult | None
    comparison: tuple[ComparisonRow, ...]
    sweeps: tuple[SweepResult, ...]
    verdict: Verdict | None = None
    ground_motion: GroundMotionResult | None = None
    sensitivity: tuple[SensitivityResult, ...] = ()
    stamp: str = ""
    report: ReportMatter = NO_MATTER
    controls: tuple[Control, ...] = ()
    uncertainty: UncertaintyResult | None = None
    verification: AnnexResult | None = None
    falling: tuple[FallingMechanism, ...] = ()
    beside: tuple[BodyEdges, ...] = ()
    before: CapacitiesResult | None = None
    ties: tuple[TieResult, ...] = ()

    def _repr_html_(self) -> str:
        rows = [] if self.verdict is None else self.verdict.mechanisms
        return html_table(
            ("mechanism", "outcome", "PGA at capacity / action"),
            *((each.mechanism, each.outcome.value, each.margin or "not known") for each in rows),
            ("building", "no verdict" if self.verdict is None else self.verdict.outcome.value, ""),
        )


@dataclass(frozen=True, repr=False)
class FallingMechanism(ShortRepr):
    """A mechanism that falls at rest under its own loads.

    uplift_multiplier : at rest, 0 or negative; None where it is not known; reason : why it falls
    """

    name: str
    label: str
    kind: str
    uplift_multiplier: float | None
    reason: str


@dataclass(frozen=True, repr=False)
class SpectrumResult(ShortRepr):
    """The site's elastic spectrum."""

    code: str
    parameters: dict[str, float | str]
    damping: float
    damping_rule: str
    clause: str
    pga_g: float
    period_s: Floats
    acceleration_g: Floats


@dataclass(frozen=True, repr=False)
class RecordResult(ShortRepr):
    """A record as used: after scaling to the site's spectrum, before the factor of a level.

    mse: mean squared natural-log misfit to the target after scaling [-]; processing: its processing history, in
    order, where a str is a line of its file; trail: the English of it.
    """

    id: str
    path: str
    event: str
    station: str
    component: str
    dt_s: float
    npts: int
    pga_g: float
    scale_factor: float
    mse: float
    trail: tuple[str, ...]
    spectrum: RecordSpectrum
    primary_pulses: tuple[PrimaryPulseResult, ...] = ()
    date: str = ""
    magnitude: float | None = None
    distance_km: float | None = None
    vs30_m_per_s: float | None = None
    nga: int | None = None
    processing: tuple[Message | str, ...] = ()


@dataclass(frozen=True, repr=False)
class RecordSpectrum(ShortRepr):
    """The elastic response spectrum of a record after scaling, 5 % damping."""

    period_s: Floats
    acceleration_g: Floats


@dataclass(frozen=True, repr=False)
class PrimaryPulseResult(ShortRepr):
    """A pulse within a record, scaled as the record: the one that matches it best, or another local optimum.

    polarity: 1 or -1; energy_share: share of the integral of squared acceleration that the pulse explains [-].
    """

    shape: str
    frequency_hz: float
    amplitude_g: float
    start_s: float
    polarity: int
    energy_share: float


@dataclass(frozen=True, repr=False)
class GroundMotionResult(ShortRepr):
    """The suite of records compared with its target, 5 % damping.

    from_s, to_s: range of periods over which it was scaled and chosen; source: of that range, in words. mean_g,
    geometric_mean_g, target_g [k]: at period_s; misfit: of the mean to the target over the range, mean squared
    difference of natural logarithms [-]. selection: None if all records of the project are used. lock: file that the
    records and factors are taken from, empty if the suite is not locked; made_for: the code whose
    rules it was made to meet, empty if none.
    """

    from_s: float
    to_s: float
    source: str
    equivalent_periods: tuple[EquivalentPeriods, ...]
    period_s: Floats
    target_g: Floats
    mean_g: Floats
    geometric_mean_g: Floats
    misfit: float
    selection: SelectionResult | None
    requirements: tuple[RequirementResult, ...]
    lock: str = ""
    made_for: str = ""


@dataclass(frozen=True, repr=False)
class EquivalentPeriods(ShortRepr):
    """The shortest and longest equivalent period of a mechanism's branches, at the allowable rotation."""

    mechanism: str
    shortest_s: float
    longest_s: float


@dataclass(frozen=True, repr=False)
class SelectionResult(ShortRepr):
    """How the suite was chosen; misfit: of its mean spectrum to the target [-]; greedy_misfit: before exchanges [-]."""

    fit: Literal["suite", "each"]
    components: Literal["single", "together"]
    one_per_event: bool
    least_factor: float
    largest_factor: float
    remaining: tuple[RemainingCandidates, ...]
    misfit: float
    greedy_misfit: float | None


@dataclass(frozen=True, repr=False)
class RemainingCandidates(ShortRepr):
    """The number of candidates left after a step of the selection."""

    step: str
    number: int


@dataclass(frozen=True, repr=False)
class RequirementResult(ShortRepr):
    """A requirement of a code on the suite, the value found, and the verdict; from_s, to_s: range of periods.

    caveat: why the clause was not checked against the printed standard; empty if it was. remark: the English of
    `remarks`.
    """

    code: str
    clause: str
    what: str
    value: float | None
    sense: Literal[">=", "<="]
    limit: float
    unit: str
    verdict: Literal["met", "not met", "not answered"]
    from_s: float | None
    to_s: float | None
    remark: str
    caveat: str
    remarks: tuple[Term | Message, ...] = ()


@dataclass(frozen=True, repr=False)
class ComparisonRow(ShortRepr):
    """One row of the comparison; rotation_ratio is None where the mechanism overturned or rotation is not known."""

    mechanism: str
    level_pga_g: float
    procedure: str
    rotation_ratio: float | None
    allowable_ratio: float | None
    demand_capacity: float | None


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
class UncertaintyResult(ShortRepr):
    """The samples of a project: their number, the seed of the Sobol sequence, what varies and the answers."""

    samples: int
    seed: int
    inputs: tuple[UncertainInput, ...]
    answers: tuple[UncertainAnswer, ...]
    notes: tuple[Message, ...] = ()


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
class Influence(ShortRepr):
    """What one group of inputs does to one answer.

    rank_correlation : Spearman's, of the demand over capacity; None where the group does not change the answer
    share : of the variance of its ranks that a line over those of the group explains, the square of it [-]
    total : of that variance, what would be left if all other groups were known, interactions with them included [-];
        None where the shares of all groups explain 0.9 of it
    """

    group: str
    keys: tuple[str, ...]
    rank_correlation: float | None
    share: float | None
    total: float | None = None


ControlKind = Literal["equilibrium", "energy", "hand-multiplier", "convergence"]


@dataclass(frozen=True, repr=False)
class Control(ShortRepr):
    """One control of one mechanism: a value of the run beside a reference found another way.

    Values are in SI. `value`, `reference`, `difference` and `met` are None where the control was not made; `note` says
    why. `met` is also None where the two need not agree, which the note explains.

    Parameters
    ----------
    kind : "equilibrium", "energy", "hand-multiplier" or "convergence"
    mechanism : name of the mechanism
    quantity : what is compared, in English
    value : the program's own value
    reference : the value it is compared with
    dimension : dimension of both, a key of `assess.messages.message.UNITS`
    difference : relative difference; docs/controls.md says relative to what
    tolerance : the largest difference that is accepted; 0 where there is none
    met : whether the difference is within the tolerance
    note : how the control was made, or why it was not
    """

    kind: ControlKind
    mechanism: str
    quantity: str
    value: float | None
    reference: float | None
    dimension: str
    difference: float | None
    tolerance: float
    met: bool | None
    note: Message
