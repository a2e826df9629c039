"""What a procedure may know besides the oscillator: the site, the building, where the mechanism is, its histories."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, Literal

from assess.codes.calculation_sheet import Given
from assess.codes.check import InputAt
from assess.codes.histories import SuiteResponse
from assess.declaration import BuildingDamping, Count, Evidence, PositiveLength, PositiveTime, Safe
from assess.errors import ProcedureError
from assess.faults import argument_problems
from assess.messages.message import Message
from assess.oscillator import BranchName, HingeForces, LocalLimit, OpenSeat, Oscillator, Toothing
from spectra.spectrum import Spectrum

WallSupport = Literal["free", "spanning", "hinged"]

PLINTH, PLINTH_SHARE = 0.5, 0.05  # m, and of the building's height: a support no higher than either is on the ground
Transfer = Literal["not", "by a factor", "by a filter"]
"""How the motion of histories reaches a mechanism: as it is at the ground, times one number, or through a mode."""


@dataclass(frozen=True)
class Gravity:
    """The share of weight in the rocking of one branch: of the wall itself, and of what presses on it.

    overburden_ratio : P / W, of what presses on the wall to the wall's own weight [-]
    own_moment, moment : of the restoring moment at rest, from the wall and from what presses on it [N m]
    own_slope : of its fall to the rotation at instability, from the wall [N m/rad]
    own_inertia, inertia : of the inertia at rest, from the wall and from what presses on it [kg m2]
    own_excitation : of the excitation at rest, from the wall [kg m]
    base_eccentricity : of the reaction at the base from mid-thickness, as the drawing bears it [m]
    edge_moment, edge_inertia : what the hinge at the edge of the base gives beyond that, to the restoring moment and
        to the inertia at rest [N m, kg m2]; the other values are without it
    """

    overburden_ratio: float
    own_moment: float
    moment: float
    own_slope: float
    own_inertia: float
    inertia: float
    own_excitation: float
    base_eccentricity: float = 0.0
    edge_moment: float = 0.0
    edge_inertia: float = 0.0


def is_above_ground(support: float, height: float) -> bool:
    """Return whether the supports of a mechanism are above the ground, and not on its plinth.

    Parameters
    ----------
    support : height of the supports above the ground [m]
    height : of the building [m]

    Returns
    -------
    bool
    """
    return support > max(PLINTH, PLINTH_SHARE * height)


@dataclass(frozen=True)
class Wall:
    """The size of a wall across its plane.

    height : between its supports, or of what stands free, from its base to its top [m]
    thickness : along the direction of motion, at the base, or at the crack where it spans [m]
    gravity : of each branch of a wall that spans; empty where it is not known
    """

    height: float
    thickness: float
    gravity: Mapping[BranchName, Gravity] = field(default_factory=dict)


SOFTENED_PERIOD = Evidence(
    "measured", "either", "the worst over 1.5 to 2.0 times the period of the elastic building", safe=Safe.WITHOUT
)


@dataclass(frozen=True)
class StatedFirstMode:
    """First mode of the building at one limit state, in place of the range of softened periods."""

    period: Annotated[PositiveTime, SOFTENED_PERIOD]
    """period of the first mode at this limit state, like "0.5 s\""""
    damping: Annotated[BuildingDamping, Evidence("measured", "up", "10 %; never above 30 %", safe=0.10)]
    """its damping ratio"""
    reason: Annotated[
        str,
        Evidence("measured", "up", "absent: 1.5 to 2.0 times the period", judged="it lets one period stand for all"),
    ]
    """why, for the report"""


@dataclass(frozen=True)
class Building:
    """The structure below a mechanism.

    height H [m] above the ground; storeys N; period T_1 [s] of the first mode, elastic; damping [-].
    limit_states : its first mode at a limit state, where that is stated
    """

    height: float
    storeys: int | None
    period: float
    damping: float
    limit_states: Mapping[str, StatedFirstMode] = field(default_factory=dict)


def default_period(height: float) -> float:
    """Return the period of the first mode of a building by its height [m], 0.05 H^0.75 [s] (EN 1998-1, eq. 4.6)."""
    return float(0.05 * height**0.75)


def building(
    *,
    height: PositiveLength,
    storeys: Count | None = None,
    period: PositiveTime | None = None,
    damping: BuildingDamping = 0.05,
) -> Building:
    """Return the structure below a mechanism.

    Parameters
    ----------
    height : above the ground [m]
    storeys : their number, where it is known
    period : of the first mode [s]; 0.05 H^0.75 where None
    damping : of the first mode [-]

    Raises
    ------
    ProcedureError : a value is none that a building has
    """
    given = {"height": height, "storeys": storeys, "period": period, "damping": damping}
    if problem := next(argument_problems(building, given), ""):
        raise ProcedureError(f"building: {problem}")
    return Building(height, storeys, default_period(height) if period is None else period, damping)


@dataclass(frozen=True)
class SiteHazard:
    """The hazard of an Italian site over return periods.

    spectra : the elastic spectrum of each limit state that the rows reach, by name
    return_period, pga : of each row, rising in return period [n] [years], [n] [m/s2] at the surface, S a_g
    """

    spectra: Mapping[str, Spectrum]
    return_period: tuple[float, ...]
    pga: tuple[float, ...]


@dataclass(frozen=True)
class FreePeriod:
    """T_0 of an element that vibrates before it lifts off [s], and how it was found, for the calculation sheets.

    inputs : the symbols of `formula`; empty where the period itself is given; remark : a fixed term
    """

    value: float
    formula: str = "given"
    inputs: Given = field(default_factory=dict)
    remark: str = ""


@dataclass(frozen=True)
class Context:
    """Site, building and position of one mechanism, and the results of its time histories.

    spectrum : the site's elastic spectrum at its own PGA
    levels : PGA at which demands are compared [m/s2]
    vertical_ratio : S_aV / S_aH [-]
    elevation : of the base above the ground [m]; rise : of the far support above it, 0 where there is none [m]
    building : None where the project gives none
    suites : time histories, one suite for each of `levels`, in that order; empty when none were run
    incremental : further suites at rising PGA, for the curve and the PGA at capacity; empty when none were run
    linearised : whether the histories solve the linearised equation, which lifts off at its own multiplier
    histories_at : where the motion of the time histories is given
    transfer : how it got there; a single factor misses resonance
    starting : the mechanism with every action that is there at rest, for multipliers; None: the oscillator itself
    breaking : the same with actions until they end, for the acceleration on the capacity curve; None: the oscillator
    limits : rotations at which actions end or seats are lost
    toothing : side walls whose friction the linear and the non-linear check of NTC 2018 count; None: none
    open_seats : floors and beams that rest on the mechanism and whose seat is not given, in each branch
    crushing : whether every hinge presses on a joint of finite strength
    knowledge : level of knowledge that the project gives for this mechanism, by the code that needs it
    limit_state : that the site's single spectrum is declared for; None where it is not, or the site gives its hazard
    floor_spectrum : of the motion at the mechanism's base, at the site's PGA; None where none is given
    impossible, impossible_by_histories : why no answer can be given, and why none by histories; with the remedies
    rocks : whether what its impacts leave is known; else only multiplier and curve are, which the kinematic checks ask
    not_lasting : why none by displacements and histories: it is held only by what is not shown to last; with the remedy
    suite_faults : by the code of a procedure, the rules for suites that the records miss, with the remedies
    amplification : the largest, over the records, of peak acceleration at the mechanism's base over that at the ground
    support : how the masonry is held: it stands free on its base, spans between two supports, or is a chain of hinges
    held : multiplier that lasting ties at or above the centre of mass of what stands free resist alone, by branch [-]
    carries_floors : whether a floor, roof or vault presses on it or moves with it
    actions : ties and applied forces on it, by name
    wall : its size, None where the mechanism is no wall or has no geometry
    hazard : of an Italian site over return periods; None where the site has one spectrum
    free_period : of an element that vibrates before it lifts off; None where the project gives none
    extra_suites : suites at the other PGA that procedures need, of limit states of their own
    hinges : forces at the hinges of both branches when the mechanism starts to rock; empty where they are not known
    """

    spectrum: Spectrum
    levels: tuple[float, ...]
    vertical_ratio: float
    elevation: float
    building: Building | None
    suites: tuple[SuiteResponse, ...] = ()
    incremental: tuple[SuiteResponse, ...] = ()
    linearised: bool = False
    histories_at: InputAt = "ground"
    transfer: Transfer = "not"
    starting: Oscillator | None = None
    breaking: Oscillator | None = None
    limits: tuple[LocalLimit, ...] = ()
    toothing: Toothing | None = None
    open_seats: tuple[OpenSeat, ...] = ()
    crushing: bool = False
    knowledge: Mapping[str, str] = field(default_factory=dict)
    limit_state: str | None = None
    floor_spectrum: Spectrum | None = None
    impossible: tuple[Message, ...] = ()
    impossible_by_histories: tuple[Message, ...] = ()
    rocks: bool = True
    not_lasting: tuple[Message, ...] = ()
    suite_faults: Mapping[str, tuple[Message, ...]] = field(default_factory=dict)
    amplification: float = 1.0
    support: WallSupport = "free"
    held: Mapping[BranchName, float] = field(default_factory=dict)
    carries_floors: bool = False
    actions: tuple[str, ...] = ()
    wall: Wall | None = None
    hazard: SiteHazard | None = None
    free_period: FreePeriod | None = None
    extra_suites: tuple[SuiteResponse, ...] = ()
    hinges: tuple[HingeForces, ...] = ()
    rise: float = 0.0

    @property
    def support_height(self) -> float:
        """Height of the supports above the ground [m]: of the base, or the mean of base and far support."""
        return max(self.elevation, 0.0) + self.rise / 2.0

    @property
    def top_support(self) -> float:
        """Height of the highest support above the ground [m]: of the far one where there is one, else of the base."""
        return max(self.elevation, 0.0) + max(self.rise, 0.0)

    @property
    def above_ground(self) -> bool:
        """Whether the supports are above the ground; a plinth counts as ground."""
        return is_above_ground(self.support_height, 0.0 if self.building is None else self.building.height)

    @property
    def above_building(self) -> bool:
        """Whether the supports are higher than the building."""
        return self.building is not None and self.support_height > self.building.height * (1.0 + 1e-9)
