"""A procedure of a code as one object, one check of it, and the worse of the checks of a mechanism's two branches."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum
from math import inf
from typing import TYPE_CHECKING, Literal, TypedDict

from assess.codes.calculation_sheet import Bound, Step
from assess.declaration import Evidence, Safe
from assess.messages.message import Message, Severity, Term, Value, message
from assess.oscillator import BRANCH_NAMES, Branch, BranchName, Oscillator
from assess.short_repr import ShortRepr

if TYPE_CHECKING:
    from assess.codes.histories import SuiteRule

Role = Literal["deciding", "comparison"]
Reading = Literal["letter", "thesis"]
InputAt = Literal["ground", "mechanism base", "missing"]
Unbounded = Literal["", "overturned", "beyond the spectrum"]

AMERICAN = ("asce7-05", "ibc2009", "asce7-10", "asce7-16", "asce7-22")
EUROPEAN = ("ec8", "ntc2008", "ntc2018")
NEW_ZEALAND = ("nzs1170.5",)
TABLE_SPECTRUM = "table"  # the engineer's own spectrum, for any code
ORDINATE = Evidence("code", "down", "that of the site's spectrum; on a table not answered", safe=Safe.ABSENT)
"""Of the ordinate by which a code's own clause begins."""

NEEDED = 0.84
"""Share of the draws among the runs of histories in which a rule must hold for a pass."""


class Outcome(StrEnum):
    """The outcome of a check.

    It is not answered where an input is missing that could be given, not applicable where the clause does not cover
    such a mechanism.
    """

    PASS = "pass"
    FAIL = "fail"
    NOT_ANSWERED = "not-answered"
    NOT_APPLICABLE = "not-applicable"


class Premise(StrEnum):
    """What a pass of a procedure depends on besides its numbers."""

    SOUND_MASONRY = "sound-masonry"
    ANCHORAGE = "anchorage"
    COLLAR_JOINTS = "collar-joints"
    NO_FLOORS = "no-floors"


class Family(StrEnum):
    """The kind of comparison that a procedure makes."""

    LINEAR = "linear"
    DISPLACEMENT = "displacement"
    ENERGY = "energy"
    HISTORY = "history"
    PART = "part"
    TABLE = "table"
    ELEMENT = "element"
    SLIDING = "sliding"
    FRICTION = "friction"


@dataclass(frozen=True, kw_only=True)
class DefaultRun:
    """When a procedure runs in a project that names none: at any site, and without one, unless a field says less.

    spectra : codes of the site spectra at which it runs; empty for any
    except_spectra : codes of the site spectra at which another edition takes its place
    needs_friction : whether it runs only where a material has friction
    """

    spectra: tuple[str, ...] = ()
    except_spectra: tuple[str, ...] = ()
    needs_friction: bool = False

    def applies(self, spectrum_code: str, *, has_friction: bool) -> bool:
        """Return whether it runs at a spectrum of this code, "" without a site."""
        if self.spectra and spectrum_code not in self.spectra:
            return False
        return spectrum_code not in self.except_spectra and (has_friction or not self.needs_friction)


@dataclass(frozen=True)
class BuildingState:
    """A state of the building through which histories reach a mechanism above the ground.

    period_ratio : of its first period to the elastic one [-]; damping : of its first mode [-], None for the elastic one
    """

    period_ratio: float
    damping: float | None = None


ELASTIC = BuildingState(1.0)


@dataclass(frozen=True, kw_only=True)
class CodeProcedure:
    """A procedure of a code: each stands beside its formulas, and `assess.codes.procedures` lists them all.

    name : as project files write it
    family : the kind of comparison it makes
    assess : makes the checks of an oscillator in a context, with `options` of its code where it has any
    title, short_title : in the report; the shorter one for legends and narrow columns
    work : the key of its source in the references of the report; empty for none
    options : the field of `assess.codes.procedures.CodeOptions` that it takes; empty for none
    reading : whether it follows the clause, or a reading of the thesis, which is shown and never decides
    limit_states : that it checks, of those its options request; empty where they request none
    spectra : codes of the site spectra it is written for; empty for any
    default_run : when it runs in a project that names no procedures; None where it must be named
    suite_rules : the code whose rules its suite of records must meet; empty where it uses none
    floor_suite_rules : the code whose rules a suite must meet to give it a floor spectrum; empty where it takes none
    history_rules : gives the rules that a suite of histories is held to, one for each limit state, in a context; None
        where it uses none
    required_pga : gives the PGA [m/s2] of the suites it needs, from the levels, hazard and spectrum of the site, its
        options, crushing and the level of knowledge; None where suites at the levels are enough
    premises : what a pass of it depends on, under any basis
    buildings, building_clause : states of the building that its histories above the ground are run through, of which
        the worst decides, and what asks for them
    damped_by_impacts : whether its damping is that of impacts on both hinges, so that the body must rebound on both
    """

    name: str
    family: Family
    assess: Callable[..., tuple[Check, ...]]
    title: Term
    short_title: Term
    work: str = ""
    options: str = ""
    reading: Reading = "letter"
    limit_states: tuple[str, ...] = ()
    spectra: tuple[str, ...] = ()
    default_run: DefaultRun | None = None
    suite_rules: str = ""
    floor_suite_rules: str = ""
    history_rules: Callable[..., tuple[SuiteRule, ...]] | None = None
    required_pga: Callable[..., tuple[float, ...]] | None = None
    buildings: tuple[BuildingState, ...] = (ELASTIC,)
    building_clause: str = ""
    damped_by_impacts: bool = False
    premises: tuple[Premise, ...] = ()

    @property
    def knowledge_code(self) -> str:
        """The code whose knowledge levels and limit states it goes by; empty where it has none."""
        return self.options if self.limit_states else ""

    def spectrum_caveats(self, spectrum_code: str) -> tuple[Message, ...]:
        """Return the caveat where the spectrum is of a code the procedure is not written for; else none."""
        if not self.spectra or spectrum_code in (*self.spectra, TABLE_SPECTRUM):
            return ()
        return (message("other-spectrum", {"codes": ", ".join(self.spectra), "code": spectrum_code}),)


class Reason(StrEnum):
    """Why a check ends as it does: the keys of `assess.messages.texts.TEXTS` that a check may give."""

    WITHIN = "within-capacity"
    BEYOND = "beyond-capacity"
    NO_ROCKING = "no-rocking"
    SLIDES_INSTEAD = "slides-instead"
    NO_LASTING = "no-lasting-rotation"
    ON_JOINTS = "moves-on-joints"
    OVERTURNS = "overturns"
    BEYOND_SPECTRUM = "beyond-spectrum"
    SPECTRUM_TOO_SHORT = "spectrum-too-short"
    LIMIT_BEYOND_OVERTURNING = "limit-beyond-overturning"
    RECORDS_OVERTURN = "records-overturn"
    RECORDS_OVERTURN_FACTORED = "records-overturn-factored"
    RECORDS_BEYOND_COLLAPSE = "records-beyond-collapse"
    NUMERICAL_SPREAD = "numerical-spread"
    TOO_FEW_RECORDS = "too-few-records"
    ABOVE_BUILDING = "above-building"
    GROUND_MOTION = "ground-motion-at-height"
    SCALAR_MOTION = "scalar-motion-at-height"
    VERTICAL_UNKNOWN = "vertical-motion-unknown"
    FLOOR_SPECTRUM_UNNAMED = "floor-spectrum-unnamed"
    UNHELD = "unheld"
    GROUND_UNKNOWN = "ground-unknown"
    GROUND_CONTRADICTED = "ground-contradicted"
    STOREY_UNKNOWN = "storey-unknown"
    KNOWLEDGE_UNKNOWN = "knowledge-unknown"
    SEAT_UNKNOWN = "seat-unknown"
    OTHER_LIMIT_STATE = "other-limit-state"
    HAZARD_TOO_SHORT = "hazard-too-short"
    ONE_SIDED = "one-sided"
    NO_REBOUND = "no-rebound"
    STOPS = "stops-at-impact"
    HISTORIES_UNKNOWN = "histories-unknown"
    NOT_A_WALL = "not-a-wall"
    NOT_SPANNING = "not-spanning"
    NO_WALL_SIZE = "no-wall-size"
    OVERLOADED = "overloaded-wall"
    CARRIES_FLOORS = "carries-floors"
    RUBBLE = "rubble-masonry"
    NOT_BY_NAME = "ordinate-not-by-name"
    FRICTION_UNKNOWN = "friction-unknown"
    HINGE_PULLS = "hinge-pulls"
    NO_HINGE_FORCES = "no-hinge-forces"
    SLIDES_FIRST = "slides-first"
    SLIDES_LATER = "slides-later"
    ROCKS_FIRST = "rocks-first"
    ONE_BLOCK_ONLY = "one-block-only"
    LEVEL_BASE_ONLY = "level-base-only"
    WEIGHT_ONLY = "weight-only"
    SLIDING_BEYOND_BEFORE = "sliding-beyond-before"
    NO_SLIDING = "no-sliding"
    NO_ALLOWABLE_SLIDING = "no-allowable-sliding"
    SLIDING_UNBOUNDED = "sliding-unbounded"


def reason_message(reason: Reason, **values: Value) -> Message:
    """Return the message of a reason, with its values."""
    return message(reason, values, severity=Severity.NOTE)


def missing_ordinate(clause: str, symbol: str, key: str) -> Message:
    """Return the message that a clause needs an ordinate which a table of a spectrum does not state.

    Parameters
    ----------
    clause : that needs it
    symbol : of the ordinate
    key : of the project file that gives it

    Returns
    -------
    Message
    """
    line = f'{key.rpartition(".")[2]} = "…"  # {symbol} in g'
    values = {"clause": clause, "symbol": symbol, "key": key, "toml": f"# {line}"}
    return message(Reason.NOT_BY_NAME, values, severity=Severity.NOTE, where=key)


class CaveatFields(TypedDict):
    """The fields of a check that say what could not be compared with the printed standard."""

    caveat: str
    caveats: tuple[Term | Message, ...]


def caveats_of(*parts: str | Message) -> CaveatFields:
    """Return the caveats of a check, as fields of it.

    Parameters
    ----------
    parts : fixed sentences, and messages
    """
    kept = tuple(Term(each) if isinstance(each, str) else each for each in parts if each)
    return {"caveat": "; ".join(str(each) for each in kept), "caveats": kept}


@dataclass(frozen=True, repr=False)
class PgaCurve(ShortRepr):
    """The peak ground acceleration that takes the mechanism to each rotation, by one procedure.

    rotation_ratio [n]: rotation / rigid overturning rotation; pga_g [n]: in g.
    """

    rotation_ratio: tuple[float, ...]
    pga_g: tuple[float, ...]


@dataclass(frozen=True, repr=False)
class NumericalSpread(ShortRepr):
    """The spread of an answer by histories that comes from their own sensitivity, by seeded draws among runs.

    runs : of each record, itself and its twins; draws, seed : how many draws, of which random numbers
    holds : p, how often the rule of the code holds, standing times within [-]
    ratio_16, ratio_84 : demand over capacity not exceeded in 16 % and in 84 % of the draws; None where that draw
        overturned. The ratio of the check is that of the records as they are, one draw of all, and can lie outside
    capacity_50_pga_g, capacity_16_pga_g : PGA up to which p is at least 0.5, and 0.16, at every level below: the larger
        the lower p is, so at least the PGA at capacity of the check, up to which p is at least 0.84
    standing : share of the choices of runs in which every record stands, exact [-]
    within : share of the draws, among the runs that stand, in which their mean is within its limit [-]
    """

    runs: int
    draws: int
    seed: int
    holds: float
    ratio_16: float | None = None
    ratio_84: float | None = None
    capacity_50_pga_g: float | None = None
    capacity_16_pga_g: float | None = None
    standing: float = 1.0
    within: float = 1.0


@dataclass(frozen=True, kw_only=True, repr=False)
class Check(ShortRepr):
    """Demand, capacity, ratio and outcome of one procedure at one level, with the steps of its calculation sheet.

    demand, capacity : in `unit`, of `quantity`; None where there is no finite value, as of a body that overturns
    uplift_pga_g : None on flexible joints without a threshold
    caveat : what could not be compared with the printed standard, the English of `caveats`
    rotation_ratio : the demand as rotation / rigid overturning rotation of the branch; None where the procedure has no
        rotation or the body overturned
    capacity_rotation_ratio : the capacity in the same measure
    score : the code's own measures, by name, as {"%NBS": 43.1}; empty where it has none
    safety_index : capacity over demand, both as PGA; None where the code has none
    return_period_years : of the capacity; return_period_bound : "<=" or ">=" where the capacity lies beyond the rows of
        the hazard, and the value is that of the end
    provisional : outcome that the numbers would give, of a check that is not answered because an input is missing
    may_pass : whether its input allows a pass at all
    informs : whether it may not decide under any basis, as with a confidence factor below the code's
    conditions : what a pass depends on and is not shown; remarks : further messages about the answer
    numerical : numerical spread of an answer by histories, whose `capacity_pga_g` is the PGA up to which p is at least
        0.84; None for other procedures
    """

    procedure: str
    edition: str
    reading: Reading = "letter"
    role: Role = "comparison"
    branch: BranchName
    limit_state: str
    level_pga_g: float
    input_at: InputAt
    damping: float | None
    damping_rule: str = ""
    quantity: str
    unit: str
    demand: float | None = None
    capacity: float | None = None
    ratio: float | None = None
    verdict: Outcome
    reason: Message
    capacity_pga_g: float | None = None
    uplift_pga_g: float | None = None
    capacity_rotation_ratio: float | None = None
    rotation_ratio: float | None = None
    pga_curve: PgaCurve = PgaCurve((), ())
    steps: tuple[Step, ...] = ()
    caveat: str = ""
    score: dict[str, float] = field(default_factory=dict)
    safety_index: float | None = None
    return_period_years: float | None = None
    return_period_bound: Bound = ""
    provisional: Outcome | None = None
    informs: bool = False
    may_pass: bool = True
    conditions: tuple[Message, ...] = ()
    remarks: tuple[Message, ...] = ()
    caveats: tuple[Term | Message, ...] = ()
    numerical: NumericalSpread | None = None

    @property
    def follows_code(self) -> bool:
        """Whether it follows the clause, not a reading of the thesis, and with no input milder than the code's own."""
        return self.reading == "letter" and not self.informs

    @property
    def unbounded(self) -> Unbounded:
        """Why it fails without a finite demand: the body overturns, or the spectrum ends first; "" where it slides."""
        if self.verdict != Outcome.FAIL or self.demand is not None or self.reason.key == Reason.SLIDING_BEYOND_BEFORE:
            return ""
        return "beyond the spectrum" if self.reason.key == Reason.BEYOND_SPECTRUM else "overturned"


CheckOfBranch = Callable[[Branch, BranchName, float], Check]


def check_worst_branch(oscillator: Oscillator, levels: Sequence[float], one: CheckOfBranch) -> tuple[Check, ...]:
    """Return for each level the check of the worse branch.

    PGA at capacity and at uplift are the smaller of the branches', whichever is the worse at the level. Where one
    branch serves both ways, it is the positive one.

    Parameters
    ----------
    oscillator : the mechanism
    levels : PGA [m/s2]
    one : makes the check of a branch, its name and a level

    Returns
    -------
    tuple of Check
    """
    branches = tuple(dict.fromkeys(oscillator.branches))
    named = tuple(zip(branches, BRANCH_NAMES, strict=False))
    return tuple(worst_branch_check([one(branch, name, level) for branch, name in named]) for level in levels)


def branch_of(oscillator: Oscillator, name: BranchName) -> Branch:
    """Return the branch of a name; the positive one where there is no other."""
    return oscillator.positive if name == "positive" or oscillator.negative is None else oscillator.negative


def worst_branch_check(checks: Sequence[Check]) -> Check:
    """Return the check of the worse branch, with the smallest PGA at capacity and at uplift of all."""
    return replace(
        worst_check(checks),
        capacity_pga_g=least_if_all_known([check.capacity_pga_g for check in checks]),
        uplift_pga_g=least_if_all_known([check.uplift_pga_g for check in checks]),
    )


def least_if_all_known(values: Sequence[float | None]) -> float | None:
    """Return the smallest value; None where one is not known."""
    known = [value for value in values if value is not None]
    return min(known) if len(known) == len(values) else None


def worst_check(checks: Sequence[Check]) -> Check:
    """Return the check that fails, then the one with the larger demand/capacity, then the smaller PGA at capacity.

    Of equals the first is kept, that of the positive branch.
    """

    def severity(check: Check) -> tuple[bool, float, float]:
        ratio = inf if check.ratio is None else check.ratio
        at_collapse = inf if check.capacity_pga_g is None else check.capacity_pga_g
        return check.verdict == "fail", ratio, -at_collapse

    return max(checks, key=severity)
