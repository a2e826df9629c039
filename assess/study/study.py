"""A study: site, motions, mechanisms and questions of one assessment, as plain data."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import isclose
from typing import Literal

from assess.codes.check import Family
from assess.codes.context import Building, FreePeriod, SiteHazard
from assess.codes.procedures import PROCEDURES, CodeOptions
from assess.codes.question import Question, VerdictFacts, find_limit_states, methods_of
from assess.dynamics.packing import Equation
from assess.errors import ProjectError
from assess.geometry.cut import Scene
from assess.geometry.solid import Solid
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message
from assess.results import NO_MATTER, CapacitiesResult, Input, ReportMatter, ResolvedValue
from assess.results.fragility import FragilityMethod, HazardResult, MeasureResult, StateResult
from assess.results.run import FallingMechanism, UncertainInput
from assess.results.verification import AnnexResult
from assess.study.amplification import HeightAboveGround, MechanismAmplification
from records.compliance import CodeName
from records.pulses import PulseShape
from records.record import Record
from records.scaling import Band, Scaling
from records.selection import ScaleTo, Selection, TargetMark
from records.synthetic import ArtificialRecords
from spectra.arrays import FloatArray
from spectra.spectrum import Spectrum

FRAGILITY_STATES = (StateResult("rocking"), StateResult("rotation", 0.5), StateResult("overturning"))

LARGEST_FACTOR = 10.0
"""Scale factor beyond which no record is run, where the project does not say [-]."""


@dataclass(frozen=True)
class Stripe:
    """An intensity with records of its own.

    intensity [unit of the primary measure]; records : their names, or patterns of names and paths as in a shell
    """

    intensity: float
    records: tuple[str, ...]


@dataclass(frozen=True)
class FragilityQuestion:
    """The question on the fragility of every mechanism.

    measures : at the ground, the primary one first; empty: all that apply
    samples : intensities at which each record is run; None for that of the method
    largest : intensity of the primary measure up to which records are run [unit of the measure]; None: until all that
        may be scaled so far overturn
    largest_factor : scale factor beyond which no record is run [-]
    uncertain : whether each record meets a wall of its own, with sampled values of the uncertain numbers
    stripes : intensities with records of their own, rising; empty where all records are run at the same ones
    epistemic : dispersion of what is not known of mechanisms, by name [-]
    hazard : of the site in one measure; None where it is not known
    target_rate : annual rate that the risk is compared with [1/year]
    """

    measures: tuple[MeasureResult, ...] = ()
    states: tuple[StateResult, ...] = FRAGILITY_STATES
    method: FragilityMethod = "ida"
    samples: int | None = None
    largest: float | None = None
    largest_factor: float = LARGEST_FACTOR
    seed: int = 1
    draws: int = 500
    uncertain: bool = False
    stripes: tuple[Stripe, ...] = ()
    epistemic: Mapping[str, float] = field(default_factory=dict)
    hazard: HazardResult | None = None
    target_rate: float | None = None

    @property
    def levels(self) -> int:
        """Intensities at which each record is run."""
        return RUNS_PER_RECORD[self.method] if self.samples is None else self.samples


@dataclass(frozen=True)
class Study:
    """Site, motions, mechanisms and questions of one assessment.

    spectrum : the site's elastic spectrum at its own PGA; None without a site
    hazard : of an Italian site over return periods; None if the site has a single spectrum
    free_periods : of the mechanisms that vibrate before uplift, by name
    knowledge : level of knowledge by mechanism and code, where given
    limit_state : that a single spectrum of the site is declared for; None if not declared
    levels : PGA at which demands are compared, rising [m/s2]
    offered : procedures that are not requested; shown where they decide
    equations : the equation of motion of each mechanism's histories, by name
    amplified : how the motion of the histories reaches each mechanism, by name
    fitting : how the records are scaled
    scenes : the bodies in space of each mechanism that has geometry, by name; beside : those of no mechanism
    sweeps : parametric studies; a case has none
    question : what decides
    facts : what a pass of each mechanism needs and is not given, and its conditions, by name
    heights : of each mechanism above the ground, by name
    moving : the bodies that move in each mechanism, by name
    on_masonry : whether what is drawn below a wall between supports bears it from face to face, by name
    record_factor : a further factor on every record [-]
    suite_faults : rules for suites that the records do not meet, by code; known once the records are
    survey : returns the surveyed numbers of a mechanism by its name
    variables : numbers that the sensitivity of each mechanism varies
    pulses : of the overturning envelopes; None if none are requested
    fragility : the question of `assess fragility`
    report : what the report states besides the analysis
    scan : whether histories are run at rising PGA for the capacity
    sampling : how its uncertain numbers are sampled; None if that is not requested
    annex : of verification that the report names; None if there is none
    falling : mechanisms that fall at rest under their own loads, which are not among `mechanisms`
    replaceables : its values that something stands for where no source vouches for them
    replaced : returns the study in which these are replaced
    drawn_ties : which of `beside` are ties, by name
    before : the state of the building before the works; None where the project names no results of it
    """

    spectrum: Spectrum | None
    vertical_ratio: float
    records: tuple[Record, ...]
    fitting: Fitting
    levels: tuple[float, ...]
    mechanisms: tuple[Mechanism, ...]
    equations: dict[str, Equation]
    amplified: dict[str, MechanismAmplification]
    question: Question
    building: Building | None = None
    artificial: ArtificialRecords | None = None
    scale_to: ScaleTo = "none"
    procedures: tuple[str, ...] = ()
    offered: tuple[str, ...] = ()
    options: CodeOptions = field(default_factory=CodeOptions)
    scenes: dict[str, Scene] = field(default_factory=dict)
    inputs: tuple[Input, ...] = ()
    resolved: dict[str, ResolvedValue] = field(default_factory=dict)
    messages: tuple[Message, ...] = ()
    sweeps: tuple[Sweep, ...] = ()
    pulses: PulseGrid | None = None
    hazard: SiteHazard | None = None
    free_periods: Mapping[str, FreePeriod] = field(default_factory=dict)
    knowledge: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    limit_state: str | None = None
    facts: Mapping[str, VerdictFacts] = field(default_factory=dict)
    heights: Mapping[str, HeightAboveGround] = field(default_factory=dict)
    moving: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    on_masonry: Mapping[str, bool] = field(default_factory=dict)
    record_factor: float = 1.0
    suite_faults: Mapping[str, tuple[Message, ...]] = field(default_factory=dict)
    survey: Callable[[str], tuple[Variable, ...]] = lambda name: ()
    variables: tuple[Variable | UnvariedNumber, ...] = ()
    fragility: FragilityQuestion = field(default_factory=FragilityQuestion)
    report: ReportMatter = NO_MATTER
    scan: bool = True
    sampling: Sampling | None = None
    annex: AnnexResult | None = None
    falling: tuple[FallingMechanism, ...] = ()
    beside: tuple[Solid, ...] = ()
    replaceables: tuple[Replaceable, ...] = ()
    replaced: Callable[[Sequence[Replaceable]], Study] | None = None
    drawn_ties: frozenset[str] = frozenset()
    before: CapacitiesResult | None = None


@dataclass(frozen=True)
class GivenFactors:
    """Scale factors that are given, not found: those of a locked suite, or of one made to meet the rules of a code.

    factors : (id, scale factor [-]) of each record; target : that they refer to
    lock : the file that they are from, as the project names it; empty if they are of no lock
    code : whose rules the suite was made to meet, as `select.for` names it; empty if of none
    """

    factors: tuple[tuple[str, float], ...]
    target: TargetMark
    lock: str = ""
    code: CodeName | Literal[""] = ""


@dataclass(frozen=True)
class Fitting:
    """How records are scaled to the target, and how they were chosen.

    band : periods over which they are scaled; together : ids of records that share one factor
    selection : how they were chosen, with its criteria; None if all records of the project are used
    nga : (id, number in the NGA database) of records that have one
    given_factors : None if they follow from the target
    """

    band: Band
    together: tuple[tuple[str, ...], ...] = ()
    selection: Selection | None = None
    nga: tuple[tuple[str, int], ...] = ()
    given_factors: GivenFactors | None = None


@dataclass(frozen=True)
class PulseGrid:
    """The pulses of overturning envelopes: shape, frequencies [n] [Hz], peak ground accelerations [m] [m/s2]."""

    shape: PulseShape
    frequency: FloatArray
    amplitude: FloatArray


@dataclass(frozen=True)
class SweepCase:
    """One value of a sweep, in the sweep's unit; its name by table, key and value; the study of what it changes."""

    value: float
    name: str
    study: Study


@dataclass(frozen=True)
class Sweep:
    """Several values of one number of the project.

    key : the number; unit : of its values, as the user wrote it, "-" for none
    cases : one for each value, in the user's order, each with the mechanisms that depend on the key
    has_typed : whether one of them is the study itself, with the value of the file
    """

    key: str
    unit: str
    cases: tuple[SweepCase, ...]
    has_typed: bool = True


@dataclass(frozen=True)
class Variable:
    """One number of a mechanism that its sensitivity varies.

    parameter : in a word of the project file; key : where the number stands; unit : SI, "-" for none
    base, low, high : [unit]; study_at : returns the study of the mechanism alone with another value
    remark : a sentence, may be empty
    """

    mechanism: str
    parameter: str
    key: str
    unit: str
    base: float
    low: float
    high: float
    study_at: Callable[[float], Study]
    remark: str = ""


@dataclass(frozen=True)
class SampledNumber:
    """An uncertain number of the project.

    input : its mean, scatter and group; least, most : physical limits of its values over the mean [-]
    mechanisms : those that it can change
    """

    input: UncertainInput
    least: float
    most: float
    mechanisms: tuple[str, ...]


@dataclass(frozen=True)
class Sampling:
    """How often a study is repeated with other values of its uncertain numbers.

    samples : a power of two; seed : of the Sobol sequence
    study_at : returns, for a value of each number in their order, what builds the study of one mechanism by its name
    notes : on what does not vary
    """

    samples: int
    seed: int
    numbers: tuple[SampledNumber, ...]
    study_at: Callable[[Sequence[float]], Callable[[str], Study]]
    notes: tuple[Message, ...] = ()

    @property
    def groups(self) -> tuple[str, ...]:
        """The names of what varies together, in the order of the numbers."""
        return tuple(dict.fromkeys(number.input.group for number in self.numbers))

    def keys_of(self, group: str) -> tuple[str, ...]:
        """Return the keys of the numbers of a group."""
        return tuple(number.input.key for number in self.numbers if number.input.group == group)

    def groups_of(self, mechanism: str) -> tuple[str, ...]:
        """Return the groups with a number that can change a mechanism."""
        return tuple(dict.fromkeys(number.input.group for number in self.numbers if mechanism in number.mechanisms))


@dataclass(frozen=True)
class Replaceable:
    """A value of the project that may help a wall, and what a run takes where no source vouches for it.

    key, value : as the file has them; instead : what stands in its place; source : who vouches for it, may be empty
    mechanisms : those that it can change, by name
    is_value : whether `instead` is a value, and not in words
    either_way : whether more of it may help or not; of_range : whether it is one of several that are plausible
    same : share by which a margin may fall without it
    place : what is changed; setting : what the file says at this and other keys without it
    study_at : returns the study of one mechanism with that
    """

    key: str
    value: str
    instead: str
    source: str
    is_value: bool
    either_way: bool
    of_range: bool
    same: float
    mechanisms: tuple[str, ...]
    place: tuple[str | int, ...]
    setting: Mapping[tuple[str | int, ...], object]
    study_at: Callable[[str], Study]


@dataclass(frozen=True)
class UnvariedNumber:
    """A number of a mechanism that its sensitivity does not vary, and why."""

    mechanism: str
    parameter: str
    why: str


RUNS_PER_RECORD: Mapping[FragilityMethod, int] = {"ida": 50, "stripes": 10, "cloud": 1}
"""Intensities at which each record is run, where the project does not say."""

AVERAGE_PERIODS = tuple(round(0.1 * k, 1) for k in range(2, 21))
"""Periods of "sa-average" where the project does not say [s]."""

Progress = Callable[[str, int, int], None]
"""Called with the stage of the work, the number of its parts done, and their total."""


def no_progress(stage: str, done: int, total: int) -> None:
    """Report nothing."""


@dataclass(frozen=True)
class ScaledRecord:
    """A record as read, with the factor that scales it to the target, and the remaining misfit (mean squared log)."""

    record: Record
    scaling: Scaling


def case_text(sweep: Sweep, case: SweepCase, mechanism: str) -> str:
    """Return a case in a few words: the key without its table, and the value."""
    key = sweep.key
    for table in (f"mechanisms.{mechanism}.", "bodies.", "materials."):
        key = key.removeprefix(table)
    return f"{key} = {case_value_text(sweep, case)}"


def case_value_text(sweep: Sweep, case: SweepCase) -> str:
    """Return the value of a case with its unit.

    Parameters
    ----------
    sweep, case : the parametric study, and one of its cases
    """
    return f"{case.value:.6g}" + ("" if sweep.unit == "-" else f" {sweep.unit}")


def without_scenes(study: Study) -> Study:
    """Return a study without bodies in space, in its cases too: tables show none, and a large mesh takes long."""
    sweeps = [
        replace(sweep, cases=tuple(replace(case, study=replace(case.study, scenes={})) for case in sweep.cases))
        for sweep in study.sweeps
    ]
    return replace(study, scenes={}, beside=(), sweeps=tuple(sweeps))


def may_follow_motion(question: Question) -> bool:
    """Return whether a method by histories or energy may decide, or no method is named."""
    methods = methods_of(question)
    return not methods or any(map(follows_motion, methods))


def follows_motion(procedure: str) -> bool:
    """Return whether a procedure follows the ground's motion: by histories, or by their energy."""
    return PROCEDURES[procedure].family in (Family.HISTORY, Family.ENERGY)


def needs_motions(study: Study) -> bool:
    """Return whether an answer of a study depends on its ground motions."""
    above = any(study.amplified[mechanism.name].height is not None for mechanism in study.mechanisms)
    return above or any(follows_motion(name) for name in study.procedures)


def deciding_limit_states(question: Question) -> tuple[str, ...]:
    """Return the limit states that decide, as checks name them."""
    return tuple(state.checked_as for state in find_limit_states(question)[0])


def levels_with_site(levels: tuple[float, ...], site_pga: float) -> tuple[float, ...]:
    """Return the levels of the study, including the site's own action, rising.

    Parameters
    ----------
    levels : PGA of the levels [m/s2]
    site_pga : PGA of the site [m/s2]

    Returns
    -------
    Levels [m/s2]; one equal to the site's PGA but for rounding is replaced by it.
    """
    if any(isclose(level, site_pga, rel_tol=1e-9) for level in levels):
        return tuple(site_pga if isclose(level, site_pga, rel_tol=1e-9) else level for level in levels)
    return tuple(sorted((*levels, site_pga)))


def require_spectrum(study: Study) -> Spectrum:
    """Return the site's spectrum; raise ProjectError if the study has none."""
    if study.spectrum is None:
        raise ProjectError("site.spectrum: missing; an analysis needs the site's spectrum: add a table [site.spectrum]")
    return study.spectrum
