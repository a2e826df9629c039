"""A study: site, motions, mechanisms and questions as plain data."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

from assess.amplification.floor_motion import Amplification
from assess.codes.context import Building, FreePeriod, Hazard
from assess.codes.registry import CodeOptions
from assess.codes.verdict import Missing, Question
from assess.geometry.scene import Scene
from assess.mechanisms.mechanism import Mechanism
from assess.messages.message import Message
from assess.results import NO_MATTER, Input, ReportMatter, Resolved
from assess.results.uncertainty import UncertainInput
from assess.results.verification import AnnexResult
from assess.study.fragility.question import FragilityQuestion
from assess.study.grounding import Grounded
from records.band import Band
from records.compliance.making import CodeName
from records.fingerprints import TargetMark
from records.pulses import Shape
from records.record import Record
from records.selection import Selection
from spectra.arrays import FloatArray
from spectra.spectrum import Spectrum

Equation = Literal["exact", "linearised"]
ScaleTo = Literal["spectrum", "pga", "none"]


@dataclass(frozen=True)
class Artificial:
    """Artificial records to be made: their number, the seed, and their duration [s]."""

    count: int
    seed: int
    duration: float


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
    given : factors that are given; None if they follow from the target
    """

    band: Band
    together: tuple[tuple[str, ...], ...] = ()
    selection: Selection | None = None
    nga: tuple[tuple[str, int], ...] = ()
    given: GivenFactors | None = None


@dataclass(frozen=True)
class PulseGrid:
    """The pulses of overturning envelopes: shape, frequencies [n] [Hz], peak ground accelerations [m] [m/s2]."""

    shape: Shape
    frequency: FloatArray
    amplitude: FloatArray


@dataclass(frozen=True)
class Amplified:
    """How the ground's motion reaches the base of a mechanism.

    method : as in the project; height : of the base above the ground [m], None where nothing is amplified
    description : what is done, with which numbers and their sources
    assumptions : on values that are not given
    by_stiffness : whether the amplification follows from the stiffness of the bodies
    """

    method: str
    height: float | None
    amplification: Amplification
    description: tuple[Message | str, ...]
    assumptions: tuple[Message, ...] = ()
    by_stiffness: bool = False


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
    scenes : the bodies in space of each mechanism that has geometry, by name
    sweeps : parametric studies; a case has none
    question : what decides
    facts : what a pass of each mechanism needs and is not given, and its conditions, by name
    grounded : the height of each mechanism above the ground, by name
    record_factor : a further factor on every record [-]
    suite_faults : rules for suites that the records do not meet, by code; known once the records are
    survey : returns the surveyed numbers of a mechanism by its name
    variables : numbers that the sensitivity of each mechanism varies
    pulses : of the overturning envelopes; None if none are requested
    fragility : what `assess fragility` asks
    report : what the report states besides the analysis
    scan : whether histories are run at rising PGA for the capacity
    sampling : how its uncertain numbers are sampled; None if that is not requested
    annex : of verification that the report names; None if there is none
    """

    spectrum: Spectrum | None
    vertical_ratio: float
    building: Building | None
    records: tuple[Record, ...]
    fitting: Fitting
    artificial: Artificial | None
    scale_to: ScaleTo
    levels: tuple[float, ...]
    procedures: tuple[str, ...]
    offered: tuple[str, ...]
    options: CodeOptions
    mechanisms: tuple[Mechanism, ...]
    equations: dict[str, Equation]
    amplified: dict[str, Amplified]
    scenes: dict[str, Scene]
    inputs: tuple[Input, ...]
    resolved: dict[str, Resolved]
    messages: tuple[Message, ...]
    sweeps: tuple[Sweep, ...]
    pulses: PulseGrid | None
    hazard: Hazard | None
    free_periods: Mapping[str, FreePeriod]
    knowledge: Mapping[str, Mapping[str, str]]
    limit_state: str | None
    question: Question
    facts: Mapping[str, tuple[tuple[Missing, ...], tuple[Message, ...]]]
    grounded: Mapping[str, Grounded] = field(default_factory=dict)
    record_factor: float = 1.0
    suite_faults: Mapping[str, tuple[Message, ...]] = field(default_factory=dict)
    survey: Callable[[str], tuple[Variable, ...]] = lambda name: ()
    variables: tuple[Variable | Unvaried, ...] = ()
    fragility: FragilityQuestion = field(default_factory=FragilityQuestion)
    report: ReportMatter = NO_MATTER
    scan: bool = True
    sampling: Sampling | None = None
    annex: AnnexResult | None = None


@dataclass(frozen=True)
class Case:
    """One value of a sweep, in the sweep's unit; its name by table, key and value; the study of what it changes."""

    value: float
    name: str
    study: Study


@dataclass(frozen=True)
class Sweep:
    """Several values of one number of the project.

    key : the number; unit : of its values, as the user wrote it, "-" for none
    cases : one for each value, in the user's order, each with the mechanisms that depend on the key
    """

    key: str
    unit: str
    cases: tuple[Case, ...]


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
class Sampled:
    """An uncertain number of the project.

    given : its mean, scatter and group; least, most : physical limits of its values over the mean [-]
    mechanisms : those that it can change
    """

    given: UncertainInput
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
    numbers: tuple[Sampled, ...]
    study_at: Callable[[Sequence[float]], Callable[[str], Study]]
    notes: tuple[Message, ...] = ()

    @property
    def groups(self) -> tuple[str, ...]:
        """The names of what varies together, in the order of the numbers."""
        return tuple(dict.fromkeys(number.given.group for number in self.numbers))

    def groups_of(self, mechanism: str) -> tuple[str, ...]:
        """Return the groups with a number that can change a mechanism."""
        return tuple(dict.fromkeys(each.given.group for each in self.numbers if mechanism in each.mechanisms))


@dataclass(frozen=True)
class Unvaried:
    """A number of a mechanism that its sensitivity does not vary, and why."""

    mechanism: str
    parameter: str
    why: str
