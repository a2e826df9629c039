"""How likely a mechanism is to rock and to overturn, given the strength of the ground motion: `assess fragility`.

Intensities stand in the unit of the measure's dimension: accelerations in g, velocities in m/s, ratios without unit.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import exp, inf
from statistics import NormalDist
from typing import Literal

from assess.messages.message import Message
from assess.results.provenance import NO_MATTER, Floats, Input, Program, ReportMatter, ResolvedValue
from assess.short_repr import ShortRepr, html_table

FRAGILITY_VERSION = 1
FragilityMethod = Literal["ida", "stripes", "cloud"]
StateName = Literal["rocking", "rotation", "overturning"]
CurveName = Literal["empirical", "lognormal", "first"]
RateGap = Literal["motion", "runs", "hazard", "epistemic"]
LARGE_SCALE = 4.0
"""Scale factor above which the runs are drawn hollow and counted."""
HTML_HEADING = ("mechanism", "state", "measure", "median", "dispersion")
FIVE_PERCENT = NormalDist().inv_cdf(0.05)


@dataclass(frozen=True, repr=False)
class MeasureResult(ShortRepr):
    """A measure of intensity.

    key : as the project names it, "pga", "pgv", "sa", "sa-average", "pga/(g tan alpha)", "p pgv/(g tan alpha)"
    dimension : "ground acceleration" [g], "velocity" [m/s] or "ratio" [-]
    at : whether it measures the motion of the ground, or that at the base of a mechanism above it
    periods_s : of "sa" one, of "sa-average" all that are averaged; empty for the others
    """

    key: str
    dimension: str
    at: Literal["ground", "base"]
    periods_s: Floats = ()


@dataclass(frozen=True, repr=False)
class StateResult(ShortRepr):
    """A state that fragility is found for; share : of the rotation that overturns, None but for "rotation" [-]."""

    name: StateName
    share: float | None = None


@dataclass(frozen=True, repr=False)
class EmpiricalPoint(ShortRepr):
    """The share of records that reach a state at one intensity, with its Wilson interval at 95 %.

    hollow : how many of the records are scaled by more than 4
    """

    intensity: float
    records: int
    reached: int
    share: float
    low: float
    high: float
    hollow: int = 0


@dataclass(frozen=True, repr=False)
class CurveBand(ShortRepr):
    """The bootstrap interval at 95 % of a curve at each intensity [n], rising: low and high [n] of the share [-]."""

    intensity: Floats
    low: Floats
    high: Floats


@dataclass(frozen=True, repr=False)
class LognormalResult(ShortRepr):
    """A lognormal curve and its bootstrap intervals at 95 %, by earthquake; an interval is None where draws fail.

    median [unit of the measure]; dispersion : standard deviation of its natural logarithm [-]
    five_percent_interval : of the intensity at which 5 % reach the state, median exp(-1.645 dispersion)
    band : of the curve itself, None where draws fail
    """

    median: float
    dispersion: float
    median_interval: tuple[float, float] | None = None
    dispersion_interval: tuple[float, float] | None = None
    five_percent_interval: tuple[float, float] | None = None
    band: CurveBand | None = None

    @property
    def five_percent(self) -> float:
        """The intensity at which 5 % reach the state [unit of the measure]."""
        return self.median * exp(FIVE_PERCENT * self.dispersion)


@dataclass(frozen=True, repr=False)
class FragilityCurve(ShortRepr):
    """The fragility of one mechanism in one state by one measure.

    records, events : how many records, of how many earthquakes
    censored : records that do not reach the state at their largest scale
    hollow : scale factors above 4 among the runs that decide the curve
    empirical : at rising intensity; what rates are computed from
    lognormal : by binomial maximum likelihood; None where the data do not bound one, for the reason in `notes`
    first : of the least intensity at which each record reaches the state, censored ones included: a bound, as rocking
        is not monotone and a record may stand again at a higher intensity
    least_run, largest_run : of a cloud, whose points are groups of records: of its weakest and strongest record
    """

    measure: MeasureResult
    state: StateResult
    method: FragilityMethod
    records: int
    events: int
    censored: int
    hollow: int
    empirical: tuple[EmpiricalPoint, ...]
    lognormal: LognormalResult | None
    first: LognormalResult | None
    notes: tuple[Message, ...] = ()
    largest_run: float | None = None
    least_run: float | None = None

    @property
    def end(self) -> float:
        """The largest intensity that was run, above which a curve is extrapolated [unit of the measure]."""
        last = self.empirical[-1].intensity if self.empirical else 0.0
        return last if self.largest_run is None else self.largest_run


@dataclass(frozen=True, repr=False)
class RecordRunsResult(ShortRepr):
    """The runs of one record on one mechanism, in the worse polarity, at rising scale.

    scale [n] [-]; ratio [n] : largest rotation over that which overturns it, None where it overturned
    intensity : of each measure of the mechanism, at scale 1 or at the ground as it is, in their order
    islands : ranges of scale in which the record leaves it standing although a lower scale overturns it
    """

    record: str
    event: str
    magnitude: float | None
    distance_km: float | None
    intensity: Floats
    scale: Floats
    ratio: tuple[float | None, ...]
    islands: tuple[tuple[float, float], ...] = ()


@dataclass(frozen=True, repr=False)
class Trend(ShortRepr):
    """The slope of the residuals of ln intensity at first overturning on a property of the records, and its p-value.

    The p-value is corrected for the number of trends of the mechanism, by all measures and in all states.
    on : "magnitude", "distance" (of its natural logarithm) or "scale" (of its natural logarithm); n : records
    """

    on: Literal["magnitude", "distance", "scale"]
    slope: float
    p_value: float
    n: int


@dataclass(frozen=True, repr=False)
class MeasureComparison(ShortRepr):
    """How well a measure explains a state: its dispersion, and what is left that depends on the records."""

    measure: MeasureResult
    state: StateResult
    dispersion: float | None
    trends: tuple[Trend, ...]


@dataclass(frozen=True, repr=False)
class HazardResult(ShortRepr):
    """The hazard of the site in one measure.

    source : a file, or the key of the project; intensity [n] rising; annual_rate [n] of exceedance, falling [1/year]
    distance_km : from the site of the file to that of the project; None where it is not known
    """

    measure: MeasureResult
    source: str
    intensity: Floats
    annual_rate: Floats
    distance_km: float | None = None


@dataclass(frozen=True, repr=False)
class RiskResult(ShortRepr):
    """The annual rate of a state, of one curve with the hazard of the site.

    intensity [n], contribution [n-1] : shares of the rate between neighbouring intensities, which rise in a constant
        ratio from the first row of the hazard to the last [-]
    beyond : the rate that the hazard leaves above its last row if every motion there reaches the state [1/year]
    below : what motions below the first row of the hazard add if it goes on with its first slope; None where that has
        no end [1/year]
    above_runs : what motions within the rows of the hazard that are stronger than any run add if every one of them
        reaches the state [1/year]
    motion_known : False where the mechanism is above the ground and its base moves as the ground, or as that times a
        number: such a rate can exceed a target, and cannot be within it
    target_rate : that the project sets [1/year]; None where it sets none
    with_epistemic : the rate of the curve widened by the epistemic dispersion, which the target is compared with, and
        its `below` and `above_runs`; None where no dispersion is given [1/year]
    """

    measure: MeasureResult
    state: StateResult
    curve: CurveName
    annual_rate: float
    probability_50_years: float
    intensity: Floats
    contribution: Floats
    beyond: float
    target_rate: float | None = None
    notes: tuple[Message, ...] = ()
    with_epistemic: float | None = None
    below: float | None = 0.0
    above_runs: float = 0.0
    motion_known: bool = True
    below_with_epistemic: float | None = 0.0
    above_runs_with_epistemic: float = 0.0

    @property
    def at_most(self) -> float | None:
        """The rate with all that hazard and runs leave out [1/year]; None where that has no end."""
        return None if self.below is None else self.annual_rate + self.above_runs + self.beyond + self.below

    @property
    def outcome(self) -> Literal["pass", "fail", "incomplete"] | None:
        """Whether the rate is within its target, also with what hazard and runs leave out; None without a target."""
        if self.target_rate is None:
            return None
        if max(self.annual_rate, self.with_epistemic or 0.0) > self.target_rate:
            return "fail"
        return "pass" if self.gap is None else "incomplete"

    @property
    def gap(self) -> RateGap | None:
        """What keeps the rate from being within its target; None where nothing does, or without a target."""
        if self.target_rate is None:
            return None
        wide = self.with_epistemic
        if wide is not None and wide > self.target_rate >= self.annual_rate:
            return "epistemic"
        if not self.motion_known:
            return "motion"
        found = [(self.annual_rate, self.above_runs, self.below)]
        if wide is not None:
            found.append((wide, self.above_runs_with_epistemic, self.below_with_epistemic))
        if any(rate + above > self.target_rate for rate, above, _ in found):
            return "runs"
        below = [inf if each is None else each for _, _, each in found]
        if any(r + a + self.beyond + b > self.target_rate for (r, a, _), b in zip(found, below, strict=True)):
            return "hazard"
        return "epistemic" if wide is None else None


@dataclass(frozen=True, repr=False)
class MechanismFragility(ShortRepr):
    """The fragility of one mechanism.

    epistemic : dispersion of what is not known of the mechanism, apart from that of records; None where none is given
    epistemic_sources : key of the project and its share, by name
    measures : in the order of the intensities of `runs`, the primary one first
    notes : what the engineer should know of its curves
    """

    name: str
    label: str
    slenderness_rad: float
    p_eq_per_s: float
    above_ground: bool
    runs: tuple[RecordRunsResult, ...]
    curves: tuple[FragilityCurve, ...]
    comparison: tuple[MeasureComparison, ...]
    risks: tuple[RiskResult, ...]
    epistemic: float | None = None
    epistemic_sources: dict[str, float] | None = None
    measures: tuple[MeasureResult, ...] = ()
    notes: tuple[Message, ...] = ()

    @property
    def html_rows(self) -> tuple[tuple[str | float, ...], ...]:
        """Mechanism, state, measure, median and dispersion of each lognormal by the primary measure."""
        return tuple(
            (
                self.label or self.name,
                each.state.name if each.state.share is None else f"rotation {each.state.share:g}",
                each.measure.key,
                *(("none", "") if each.lognormal is None else (each.lognormal.median, each.lognormal.dispersion)),
            )
            for each in self.curves
            if each.measure in self.measures[:1]
        )

    def _repr_html_(self) -> str:
        return html_table(HTML_HEADING, *self.html_rows)


@dataclass(frozen=True, repr=False)
class UnionFragility(ShortRepr):
    """How often at least one of several mechanisms overturns, under the same records.

    mechanisms : names of those that count; left_out : of those that share a body with one that overturns more often
    curve : of the records that overturn at least one
    if_independent : share at each point of `curve.empirical` if each mechanism overturned by itself [-]
    """

    mechanisms: tuple[str, ...]
    left_out: tuple[str, ...]
    curve: FragilityCurve
    if_independent: Floats


@dataclass(frozen=True, repr=False)
class FragilityResults(ShortRepr):
    """The tree of fragility.json; seed and draws : of the bootstrap; project : resolved values, as in results.json.

    union : of mechanisms together; None where there are not two that may be counted together
    """

    schema_version: int
    program: Program
    inputs: tuple[Input, ...]
    warnings: tuple[Message, ...]
    title: str
    method: FragilityMethod
    seed: int
    draws: int
    mechanisms: tuple[MechanismFragility, ...]
    hazard: tuple[HazardResult, ...] = ()
    stamp: str = ""
    report: ReportMatter = NO_MATTER
    project: dict[str, ResolvedValue] = field(default_factory=dict)
    union: UnionFragility | None = None

    def _repr_html_(self) -> str:
        return html_table(HTML_HEADING, *(row for each in self.mechanisms for row in each.html_rows))
