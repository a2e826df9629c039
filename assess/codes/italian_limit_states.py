"""Limit states of the Italian codes: the spectrum and PGA of each, FC, the curves of a mechanism, and the safety index.

DM 2008 with Circolare 617/2009 and NTC 2018 with Circolare 7/2019 share all of this.

Where the site gives its hazard over return periods, each limit state has a spectrum and a PGA of its own, and a level
multiplies them all alike: level / PGA of the site. Elsewhere every limit state is checked at the PGA of the level.

The confidence factor FC divides the acceleration of the mechanism once, and no displacement. Where the compressive
strength of the masonry is not in the multiplier, FC is that of LC1 whatever the level of knowledge (C8.7.1.2.1.3;
617/2009: C8A.4.1).
"""

from __future__ import annotations

from collections.abc import Callable, Container, Mapping, Sequence
from dataclasses import dataclass, field, replace
from math import exp, log
from typing import Annotated, Literal

import numpy as np

from assess.codes.calculation_sheet import Bound, Step, step
from assess.codes.check import Check, InputAt, Outcome, branch_of, worst_branch_check
from assess.codes.context import Context, SiteHazard
from assess.declaration import Evidence, Name, NotAKey, Number, Safe
from assess.messages.message import Quantity, message
from assess.oscillator import BRANCH_NAMES, Branch, BranchName, LocalLimit, Oscillator
from spectra.floor import first_mode_factor
from spectra.gravity import g
from spectra.spectrum import Spectrum

INDEX_CLAUSE = "NTC 8.3"
HAZARD_CLAUSE = "NTC Annex A"


@dataclass(frozen=True)
class ItalianEdition:
    """Code, name and caveat of an edition, and its clauses of the multiplier, the equivalent oscillator and FC."""

    code: str
    name: str
    caveat: str
    multiplier: str
    oscillator: str
    confidence: str


KnowledgeLevel = Literal["LC1", "LC2", "LC3"]
KNOWLEDGE = Evidence("measured", ("LC1", "LC2", "LC3"), "LC1", safe=Safe.FIRST)
CONFIDENCE_FACTOR = Evidence(
    "code", "down", "that of the knowledge level; one below it is for comparison", safe=Safe.ABSENT
)
FURTHER_STATES = Evidence(
    "chosen", "none", '"SLV"', judged="the limit states that decide are checked whatever stands here"
)


@dataclass(frozen=True)
class ItalianOptions:
    """What both Italian procedures may say."""

    knowledge_level: Annotated[KnowledgeLevel | None, KNOWLEDGE] = None
    """level of knowledge, which gives the confidence factor where crushing is modelled: LC1 1.35, LC2 1.20, LC3 1.00;
    1.35 wherever it is not"""
    knowledge_levels: Annotated[Mapping[Name, KnowledgeLevel], KNOWLEDGE] = field(default_factory=dict)
    """{ MECHANISM = "LC2" }: of single mechanisms, in place of knowledge_level"""
    confidence_factor: Annotated[float, Number("ratio", least=1), CONFIDENCE_FACTOR] | None = None
    """FC in place of the code's: a larger one decides, a lower one is shown for comparison"""
    limit_states: tuple[str, ...] = ("SLV",)
    """limit states to check"""
    behaviour_factor: Annotated[float, NotAKey()] = 2.0  # q of the linear check at SLV

    def requested_states(self, known: Container[str]) -> tuple[str, ...]:
        """Return the limit states requested that a procedure knows."""
        return tuple(state for state in self.limit_states if state in known)


@dataclass(frozen=True)
class LimitStateCase:
    """One branch of a mechanism in a limit state at one level, with one confidence factor.

    context : with the spectrum of the limit state; level : of the project [m/s2]
    pga : of the limit state at that level [m/s2]; pga_step : how it follows from the level
    """

    curves: BranchCurves
    confidence: ConfidenceFactor
    state: str
    context: Context
    level: float
    pga: float
    pga_step: Step

    @property
    def at_ultimate(self) -> LimitStateCase:
        """Return the case with the curves of an ultimate limit state."""
        return replace(self, curves=self.curves.at_ultimate)


CheckOfCase = Callable[[LimitStateCase], Check]


def check_each_limit_state(
    oscillator: Oscillator,
    context: Context,
    edition: ItalianEdition,
    options: ItalianOptions,
    *,
    known: tuple[str, ...],
    one: CheckOfCase,
) -> tuple[Check, ...]:
    """Return the check of the worse branch for each limit state that is known and requested, and each level.

    Each has its safety index. Checks with the confidence factor that decides come first, then those with one for
    comparison.
    """
    branches, states = curves_of(oscillator, context), options.requested_states(known)
    checks: list[Check] = []
    known_level = context.knowledge.get(edition.code)
    for confidence in confidence_factors(options, crushing=context.crushing, level=known_level):
        for state in states:
            for level in context.levels:
                cases = [case_of(curves, confidence, context, state=state, level=level) for curves in branches]
                checks.append(mark_for_comparison(worst_branch_check([one(case) for case in cases]), confidence))
    return tuple(add_safety_index(check, context) for check in checks)


def case_of(
    curves: BranchCurves, confidence: ConfidenceFactor, context: Context, *, state: str, level: float
) -> LimitStateCase:
    """Return the case on the spectrum of its limit state, or on that of the site at the level's PGA."""
    own = own_spectrum(context.hazard, state)
    used = context if own is None else replace(context, spectrum=own)
    pga = level * pga_ratio(context.hazard, context.spectrum, state)
    line = pga_step(context, state=state, level=level, pga=pga)
    return LimitStateCase(curves, confidence, state, used, level, pga, line)


def own_spectrum(hazard: SiteHazard | None, state: str) -> Spectrum | None:
    """Return the spectrum of a limit state; None where the site does not give it."""
    return None if hazard is None else hazard.spectra.get(state)


def pga_ratio(hazard: SiteHazard | None, spectrum: Spectrum, state: str) -> float:
    """Return the PGA of a limit state over that of the site's `spectrum` [-]; 1 where it has none of its own."""
    own = own_spectrum(hazard, state)
    return 1.0 if own is None else own.pga / spectrum.pga


def pga_step(context: Context, *, state: str, level: float, pga: float) -> Step:
    """Write the PGA of a limit state at a level."""
    own, symbol = own_spectrum(context.hazard, state), f"PGA_{state}"
    if own is None:
        remark = "" if context.hazard is None else "no hazard of this limit state"
        words, given = "peak ground acceleration, that of the level", {"PGA_L": (level, "m/s2")}
        return step(symbol, words, HAZARD_CLAUSE, "PGA_L", pga, "m/s2", given=given, remark=remark)
    words = "peak ground acceleration of the limit state: the level multiplies every limit state"
    given = {"PGA_L": (level, "m/s2"), f"S a_g,{state}": (own.pga, "m/s2"), "PGA": (context.spectrum.pga, "m/s2")}
    return step(symbol, words, HAZARD_CLAUSE, f"PGA_L · S a_g,{state} / PGA", pga, "m/s2", given=given)


def add_safety_index(check: Check, context: Context) -> Check:
    """Return the check with its safety index zeta_E, capacity over demand as PGA, and its return period."""
    capacity = check.capacity_pga_g
    if capacity is None:
        return check
    demand = check.level_pga_g * pga_ratio(context.hazard, context.spectrum, check.limit_state)
    index, given = capacity / demand, {"PGA_C": (capacity, "g"), "PGA": (demand, "g")}
    words = "safety index of the limit state: PGA at capacity over PGA demanded"
    line = step("ζ_E", words, INDEX_CLAUSE, "PGA_C / PGA", index, given=given)
    indexed = replace(check, safety_index=index, steps=(*check.steps, line))
    return indexed if context.hazard is None else _with_years(indexed, context.hazard, capacity)


def rows_around(hazard: SiteHazard, pga: float) -> tuple[int, int] | None:
    """Return the rows between which the site first reaches a PGA [m/s2]; None before the first and after the last."""
    reached = np.maximum.accumulate(hazard.pga)
    above = int(np.searchsorted(reached, pga))
    return None if above in (0, reached.size) else (above - 1, above)


def return_period(hazard: SiteHazard, pga: float) -> tuple[float, Bound]:
    """Return the least return period at which the site reaches a PGA, linear in logarithms between rows.

    Beyond the rows it is that of the first or the last one, and a bound. On soft soils S a_g may fall while a_g
    rises, so the least is not the only one.

    Parameters
    ----------
    hazard : of the site
    pga : [m/s2]

    Returns
    -------
    Return period [years], and "<=" or ">=" where it is a bound, else "".
    """
    reached, rows = np.maximum.accumulate(hazard.pga), rows_around(hazard, pga)
    if rows is None:
        if pga > reached[0]:
            return hazard.return_period[-1], ">="
        return hazard.return_period[0], "<=" if pga < reached[0] else ""
    low, high = rows
    between = log(pga / reached[low]) / log(reached[high] / reached[low])
    first, second = hazard.return_period[low], hazard.return_period[high]
    return exp(log(first) + between * log(second / first)), ""


FACTORS_BY_LEVEL: Mapping[str, float] = {"LC1": 1.35, "LC2": 1.20, "LC3": 1.00}  # C8.5.4 (617/2009: C8A.1.1)
LARGEST_FACTOR = FACTORS_BY_LEVEL["LC1"]
SOURCE_BY_LEVEL: Mapping[str, str] = {"LC1": "LC1's, as given", "LC2": "LC2's, as given", "LC3": "LC3's, as given"}


@dataclass(frozen=True)
class ConfidenceFactor:
    """FC [-], where it comes from, and the larger one that decides where this one is for comparison only."""

    factor: float
    why: str
    instead_of: float | None = None


def confidence_factors(options: ItalianOptions, *, crushing: bool, level: str | None) -> tuple[ConfidenceFactor, ...]:
    """Return the factor that decides, then the one given where it is lower, which is for comparison.

    Parameters
    ----------
    options : the factor given, if any
    crushing : whether the mechanism models crushing of the masonry
    level : of knowledge, None where it is not given

    Returns
    -------
    tuple of ConfidenceFactor
    """
    deciding, given = _by_code(crushing, level), options.confidence_factor
    if given is None or given == deciding.factor:
        return (deciding,)
    if given > deciding.factor:
        return (ConfidenceFactor(given, "given, larger than the code's"),)
    return deciding, ConfidenceFactor(given, "given, below the code's: for comparison", deciding.factor)


def confidence_step(confidence: ConfidenceFactor, edition: ItalianEdition) -> Step:
    """Write FC."""
    words = "confidence factor, divides the acceleration once"
    return step("FC", words, edition.confidence, "of the level of knowledge", confidence.factor, remark=confidence.why)


def mark_for_comparison(check: Check, confidence: ConfidenceFactor) -> Check:
    """Return the check as it is, or marked as one for comparison where its factor is below the code's."""
    if confidence.instead_of is None:
        return check
    values = {"given": Quantity(confidence.factor), "deciding": Quantity(confidence.instead_of)}
    return replace(check, informs=True, remarks=(*check.remarks, message("lower-confidence-factor", values)))


@dataclass(frozen=True)
class BranchCurves:
    """The branches of one name, by the actions in them (C8.7.1.2.1.6).

    lasting : those shown to be there up to collapse, and all that drive: d0*
    starting : every action there at rest: alpha0
    breaking : actions until they end: a(d), for the period
    limits : rotations at which actions end or seats are lost
    mass : total moved mass [kg]
    """

    name: BranchName
    lasting: Branch
    starting: Branch
    breaking: Branch
    limits: tuple[LocalLimit, ...]
    mass: float

    @property
    def at_ultimate(self) -> BranchCurves:
        """Return the curves at an ultimate limit state, where at rest too only the actions shown to last count.

        No wall is kept from moving by a tie that is gone after a millimetre.
        """
        return replace(self, starting=self.lasting)


def curves_of(oscillator: Oscillator, context: Context) -> tuple[BranchCurves, ...]:
    """Return the curves of each branch; of one only where both ways are alike.

    Branches are paired by name: a mechanism that is symmetric without its ties need not be so with them.
    """
    states = (oscillator, context.starting or oscillator, context.breaking or oscillator)
    alike = all(each.negative is None or each.symmetric for each in states) and not context.limits
    names = BRANCH_NAMES[:1] if alike or oscillator.negative is None else BRANCH_NAMES
    return tuple(_curves_of_branch(name, states, context.limits, oscillator.mass) for name in names)


def curves_of_all_actions(oscillator: Oscillator) -> tuple[BranchCurves, ...]:
    """Return the curves of each branch of an oscillator that is the same for every set of actions."""
    names = BRANCH_NAMES[:1] if oscillator.negative is None or oscillator.symmetric else BRANCH_NAMES
    return tuple(_curves_of_branch(name, (oscillator,) * 3, (), oscillator.mass) for name in names)


def branch_curves(oscillator: Oscillator, context: Context, name: BranchName) -> BranchCurves:
    """Return the curves of the branch of a name; those of the positive one where there is no other."""
    found = curves_of(oscillator, context)
    return next((each for each in found if each.name == name), found[0])


@dataclass(frozen=True)
class Floor:
    """The building as the clauses see it: psi = Z/H, gamma = 3N/(2N+1), T1 [s] and xi1 [-] of the first mode."""

    psi: float
    gamma: float
    T1: float
    damping: float


@dataclass(frozen=True)
class Demands:
    """What the motions of ground and floor demand of a mechanism, in one unit; floor: 0 at the ground."""

    ground: float
    floor: float

    def scale(self, factor: float) -> Demands:
        """Return both multiplied by a factor."""
        return Demands(self.ground * factor, self.floor * factor)

    @property
    def largest(self) -> float:
        """The governing one: both must be met."""
        return max(self.ground, self.floor)

    @property
    def input_at(self) -> InputAt:
        """Where the governing one acts."""
        return "mechanism base" if self.floor > self.ground else "ground"


def floor_of(context: Context) -> Floor | None:
    """Return psi, gamma and T1 of a mechanism above the ground; None at the ground, or where the building is not known.

    Z is the height of what joins the mechanism to the rest of the building: of its base, or of a wall that spans the
    mean of base and top. A mechanism on the ground is checked at the ground alone, a wall that spans included.
    Source: Circolare 617/2009, C8A.4.2.3; 7/2019, C7.2.10.
    """
    building = context.building
    if not context.above_ground or building is None or building.storeys is None:
        return None
    gamma = first_mode_factor(building.storeys)
    return Floor(context.support_height / building.height, gamma, building.period, building.damping)


def outcome_of(ratio: float) -> Outcome:
    """Return pass or fail of a ratio of demand to capacity."""
    return Outcome.FAIL if ratio > 1.0 else Outcome.PASS


def _with_years(check: Check, hazard: SiteHazard, capacity_g: float) -> Check:
    years, bound = return_period(hazard, capacity_g * g)
    line = _years_step(hazard, capacity_g * g, years, bound)
    return replace(check, return_period_years=years, return_period_bound=bound, steps=(*check.steps, line))


def _years_step(hazard: SiteHazard, pga: float, years: float, bound: Bound) -> Step:
    """Write the return period of a capacity [m/s2]: between two rows of the hazard, or at its first or last one."""
    symbol, words = "T_R,C", "return period of the capacity"
    rows = rows_around(hazard, pga)
    if rows is None:
        ends = {"<=": "or less: the hazard begins there", ">=": "or more: the hazard ends there"}
        at = {"PGA_C": (pga, "m/s2"), "T_R": (years, "years")}
        formula = "first or last row of the hazard"
        return step(
            symbol, words, HAZARD_CLAUSE, formula, years, "years", remark=ends.get(bound, ""), bound=bound, at=at
        )
    low, high = rows
    given = {
        "T_1": (hazard.return_period[low], "years"),
        "T_2": (hazard.return_period[high], "years"),
        "PGA_C": (pga, "m/s2"),
        "PGA_1": (float(np.maximum.accumulate(hazard.pga)[low]), "m/s2"),
        "PGA_2": (float(np.maximum.accumulate(hazard.pga)[high]), "m/s2"),
    }
    formula = "exp(ln(T_1) + ln(PGA_C / PGA_1) / ln(PGA_2 / PGA_1) ln(T_2 / T_1))"
    remark = "linear in logarithms between the neighbouring rows of the hazard"
    return step(symbol, words, HAZARD_CLAUSE, formula, years, "years", given=given, remark=remark)


def _by_code(crushing: bool, level: str | None) -> ConfidenceFactor:
    if not crushing:
        return ConfidenceFactor(LARGEST_FACTOR, "LC1's, as crushing of the masonry is not modelled")
    if level is None:
        return ConfidenceFactor(LARGEST_FACTOR, "LC1's, as no level of knowledge is given")
    return ConfidenceFactor(FACTORS_BY_LEVEL[level], SOURCE_BY_LEVEL[level])


def _curves_of_branch(
    name: BranchName, states: Sequence[Oscillator], limits: Sequence[LocalLimit], mass: float
) -> BranchCurves:
    lasting, starting, breaking = (branch_of(each, name) for each in states)
    return BranchCurves(name, lasting, starting, breaking, tuple(each for each in limits if each.branch == name), mass)
