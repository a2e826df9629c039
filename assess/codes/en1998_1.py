"""EN 1998-1:2004, 4.3.5: a non-structural element under a static force at its centre of mass.

    F_a = S_a W_a gamma_a / q_a                                                              (4.24)
    S_a = alpha S [3 (1 + z/H) / (1 + (1 - T_a/T_1)^2) - 0.5], at least alpha S              (4.25)

alpha S is the peak acceleration of the surface over g, the PGA of the level. T_a is known no better than as between 0
and that of cracked masonry, bent as a beam of the element's height and thickness, on its joints: the largest S_a
counts, at the T_a nearest to T_1; that of a rigid element stands beside it. Formulas and Table 4.4 are from memory, not
checked against the printed standard. The force is compared with what the weight resists, at each level. One function
for each formula.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np

from assess.codes.calculation_sheet import Given, Step, multiplier_step, step
from assess.codes.check import (
    EUROPEAN,
    ORDINATE,
    TABLE_SPECTRUM,
    Check,
    CodeProcedure,
    Family,
    Outcome,
    Premise,
    Reason,
    caveats_of,
    check_worst_branch,
    missing_ordinate,
    reason_message,
)
from assess.codes.context import Context, Wall, WallSupport
from assess.declaration import Evidence, Number, PositiveAcceleration, Safe
from assess.messages.message import Term
from assess.oscillator import Branch, BranchName, Oscillator, elastic_frequency, linear_multiplier, threshold
from spectra.floor import ec8_floor_factor
from spectra.gravity import g

EDITION = "EN 1998-1:2004"
CLAUSE, FORCE, TABLE = "EN 1998-1, 4.3.5.2 (4.25)", "EN 1998-1, 4.3.5.2 (4.24)", "EN 1998-1, 4.3.5.4, Table 4.4"
CAVEAT = (
    "(4.24), (4.25) and Table 4.4 are from memory, not checked against the printed standard; the clause covers "
    "non-structural elements, and its force check has no reserve beyond uplift but q_a"
)
BEHAVIOUR: dict[WallSupport, float] = {"free": 1.0, "spanning": 2.0, "hinged": 1.0}  # q_a, Table 4.4
ELEMENTS: dict[WallSupport, str] = {
    "free": "stands free, as cantilever parapets",
    "spanning": "held at base and top, as walls and facades",
    "hinged": "chain of hinges, not in Table 4.4: the smallest value",
}
IMPORTANCE_FACTORS = {"I": 0.8, "II": 1.0, "III": 1.2, "IV": 1.4}  # gamma_I by importance class, 4.2.5(5)
REFERENCE_YEARS = 475.0  # return period of a_gR, 2.1(1)
TIED, TYPED = "held at or above its centre of mass by a lasting tie, as braced chimneys and gables", "as stated"
RESONANCE = 1.0  # T_a / T_1 where building or element are not known: the worst
BENDING: dict[WallSupport, float] = {"free": 6.2, "spanning": 2.2}  # 2 pi sqrt(12) / 1.875^2, and over pi^2
YOUNG_MODULUS, DENSITY = 0.15e9, 2200.0  # Pa, kg/m3: a quarter of the least modulus of masonry, and its heaviest kind
BEAM = "first mode of a beam"


BEHAVIOUR_FACTOR = Evidence(
    "code", "up", "2.0 for what spans, or what ties hold that resist the force alone, else 1.0", safe=Safe.ABSENT
)
IMPORTANCE = Evidence("code", "down", "1.0; 1.5 where life depends on it")


@dataclass(frozen=True)
class Ec8Options:
    """Options of the check of non-structural elements of EN 1998-1, 4.3.5."""

    behaviour_factor: Annotated[float, Number("ratio", least=1, most=2), BEHAVIOUR_FACTOR] | None = None
    """q_a of Table 4.4, 1 to 2; if absent 2.0 for walls that span and for what is held by lasting ties at or above its
    centre of mass that resist the force alone, 1.0 for what stands free"""
    importance_factor: Annotated[float, Number("ratio", least=1), IMPORTANCE] = 1.0
    """gamma_a of the element, no less than 1: 1.5 where life depends on it"""
    alpha_s: Annotated[PositiveAcceleration | None, ORDINATE] = None
    """alpha S at the site's own peak ground acceleration; needed where the spectrum is a table"""


def assess_element(oscillator: Oscillator, context: Context, *, options: Ec8Options) -> tuple[Check, ...]:
    """Check F_a / W_a against the multiplier that the mechanism resists, on the worse branch (4.3.5)."""

    def one(branch: Branch, name: BranchName, level: float) -> Check:
        check = _check(branch, name, context, options, level)
        if context.spectrum.code != TABLE_SPECTRUM or options.alpha_s is not None:
            return check
        why = missing_ordinate(CLAUSE, "alpha S", "procedures.ec8.alpha_s")
        return replace(check, verdict=Outcome.NOT_ANSWERED, reason=why)

    return check_worst_branch(oscillator, context.levels, one)


EC8_ELEMENT = CodeProcedure(
    name="ec8-element",
    family=Family.ELEMENT,
    assess=assess_element,
    title=Term("Eurocode 8, non-structural element"),
    short_title=Term("Eurocode 8"),
    work="ec8",
    options="ec8",
    spectra=EUROPEAN,
    premises=(Premise.NO_FLOORS,),
)


@dataclass(frozen=True)
class ElementDemand:
    """The force of the clause: alpha S [g], T_a / T_1, S_a / (alpha S), q_a, gamma_a, F_a / W_a, all [-].

    surface : alpha S over PGA [-]
    """

    alpha_s: float
    surface: float
    ratio: float
    amplified: float
    q_a: float
    gamma_a: float
    force: float


def element_demand(
    branch: Branch, name: BranchName, context: Context, options: Ec8Options, level: float
) -> ElementDemand:
    """Return the force of the clause on one branch.

    Parameters
    ----------
    branch, name : the direction of rocking
    context : site and building
    options : q_a, gamma_a and alpha S, where they are given
    level : PGA [m/s2]

    Returns
    -------
    ElementDemand
    """
    ratio = period_ratio(branch, context)
    amplified = amplification(ratio, context)
    gamma_a = options.importance_factor
    surface = 1.0 if options.alpha_s is None else options.alpha_s / context.spectrum.pga
    alpha_s = surface * level / g
    q_a = options.behaviour_factor
    if q_a is None:
        unreduced = force_over_weight(alpha_s * amplified, behaviour_factor=1.0, importance_factor=gamma_a)
        q_a = behaviour_factor(context, name, unreduced)
    force = force_over_weight(alpha_s * amplified, behaviour_factor=q_a, importance_factor=gamma_a)
    return ElementDemand(alpha_s, surface, ratio, amplified, q_a, gamma_a, force)


def behaviour_factor(context: Context, name: BranchName, unreduced: float) -> float:
    """Return q_a of Table 4.4 by what holds the element as it is drawn [-].

    Ties hold what stands free where they alone resist the force that remains at the q_a of what is held.

    Parameters
    ----------
    context : how the masonry is held
    name : the direction of rocking: a tie may hold it in one alone
    unreduced : F_a / W_a at q_a = 1 [-]

    Returns
    -------
    float [-]
    """
    braced = context.held.get(name, 0.0) >= unreduced / BEHAVIOUR["spanning"]
    return BEHAVIOUR["spanning" if braced else context.support]


def joint_period(branch: Branch) -> float:
    """Return the period of small motions on flexible joints [s]; 0 for an element that stands on rigid ones."""
    frequency = elastic_frequency(branch)
    return 1.0 / frequency if frequency else 0.0


def bending_period(wall: Wall, support: WallSupport) -> float:
    """Return kappa L^2 / t sqrt(rho / E), the longest period of masonry that bends: cracked, heavy and soft.

    Parameters
    ----------
    wall : height L and thickness t
    support : "free" (kappa = 6.2) or "spanning" (2.2)

    Returns
    -------
    float [s]
    """
    return float(BENDING[support] * wall.height**2 / wall.thickness * np.sqrt(DENSITY / YOUNG_MODULUS))


def longest_period(branch: Branch, context: Context) -> float | None:
    """Return the longest T_a that the element can have, in bending and on its joints [s]; None without its size."""
    if context.wall is None or context.support not in BENDING:
        return None
    return float(np.hypot(bending_period(context.wall, context.support), joint_period(branch)))


def period_ratio(branch: Branch, context: Context) -> float:
    """Return T_a / T_1 at the T_a, from 0 to the longest, at which S_a is largest [-]: that nearest to T_1.

    1, the worst, where the building or the size of the element is not known.
    """
    longest = longest_period(branch, context)
    if longest is None or context.building is None:
        return RESONANCE
    return min(longest / context.building.period, RESONANCE)


def height_ratio(context: Context) -> float:
    """Return z / H of the supports [-]: 0 where the building is not known, and at most 1.

    At the ground H plays no part; above the building the check may only fail.
    """
    if context.building is None:
        return 0.0
    return min(context.support_height / context.building.height, 1.0)


def amplification(ratio: float, context: Context) -> float:
    """Return S_a / (alpha S) = 3 (1 + z/H) / (1 + (1 - T_a/T_1)^2) - 0.5, at least 1 (4.25).

    Parameters
    ----------
    ratio : T_a / T_1 [-]
    context : height of the supports and of the building

    Returns
    -------
    float [-]
    """
    return ec8_floor_factor(height_ratio(context), building_height=1.0, period_ratio=ratio)


def force_over_weight(S_a: float, *, behaviour_factor: float, importance_factor: float) -> float:
    """Return F_a / W_a = S_a gamma_a / q_a (4.24).

    Parameters
    ----------
    S_a : seismic coefficient [-]
    behaviour_factor : q_a [-]
    importance_factor : gamma_a [-]

    Returns
    -------
    float [-]
    """
    return S_a * importance_factor / behaviour_factor


def uplift_pga(branch: Branch, amplified: float) -> float | None:
    """Return the PGA at which S_a reaches the multiplier at rest.

    Parameters
    ----------
    branch : the direction of rocking
    amplified : S_a over PGA [-]

    Returns
    -------
    PGA [m/s2]; None without a threshold.
    """
    at_rest = threshold(branch)
    return None if at_rest is None else at_rest * g / amplified


def _check(branch: Branch, name: BranchName, context: Context, options: Ec8Options, level: float) -> Check:
    demand, resistance = element_demand(branch, name, context, options, level), linear_multiplier(branch)
    lifts, ratio = uplift_pga(branch, demand.surface * demand.amplified), demand.force / resistance
    verdict = Outcome.FAIL if ratio > 1.0 else Outcome.PASS
    return Check(
        procedure=EC8_ELEMENT.name,
        edition=EDITION,
        branch=name,
        limit_state="element",
        level_pga_g=level / g,
        input_at="mechanism base" if context.above_ground else "ground",
        damping=None,
        quantity="force over weight",
        unit="-",
        demand=demand.force,
        capacity=resistance,
        ratio=ratio,
        verdict=verdict,
        reason=reason_message(
            Reason.WITHIN if verdict == Outcome.PASS else Reason.BEYOND, capacity=Term("what the weight resists")
        ),
        capacity_pga_g=level * resistance / demand.force / g,
        uplift_pga_g=None if lifts is None else lifts / g,
        steps=_steps(branch, context, demand, held_by=_holding(demand.q_a, context, options)),
        **caveats_of(CAVEAT, *EC8_ELEMENT.spectrum_caveats(context.spectrum.code)),
    )


def _holding(q_a: float, context: Context, options: Ec8Options) -> str:
    """Return what q_a rests on, in words."""
    if options.behaviour_factor is not None:
        return TYPED
    return ELEMENTS[context.support] if q_a == BEHAVIOUR[context.support] else TIED


def _steps(branch: Branch, context: Context, demand: ElementDemand, *, held_by: str) -> tuple[Step, ...]:
    resistance, raised = linear_multiplier(branch), height_ratio(context)
    S_a, rigid = demand.alpha_s * demand.amplified, demand.alpha_s * amplification(0.0, context)
    given = {"α S": demand.alpha_s, "z/H": raised, "T_a/T_1": demand.ratio}
    forced = {"S_a": S_a, "γ_a": demand.gamma_a, "q_a": demand.q_a}
    held = {"F_a/W_a": demand.force, "λ": resistance}
    return (
        *_period_steps(branch, context, demand.ratio),
        _height_step(context),
        step("S_a(0)", "of a rigid element, for comparison", CLAUSE, "α S max(1, 3 (1 + z/H) / 2 − 0.5)", rigid,
             given={"α S": demand.alpha_s, "z/H": raised}),
        step("S_a", "seismic coefficient", CLAUSE, "α S max(1, 3 (1 + z/H) / (1 + (1 − T_a/T_1)²) − 0.5)", S_a,
             given=given),
        step("q_a", "behaviour factor", TABLE, "given", demand.q_a, remark=held_by),
        step("γ_a", "importance factor", "EN 1998-1, 4.3.5.3", "given", demand.gamma_a),
        step("F_a/W_a", "force over weight", FORCE, "S_a γ_a / q_a", demand.force, given=forced),
        multiplier_step("λ", "multiplier resisted by the weight", "statics", branch),
        step("D/C", "ratio", FORCE, "F_a/W_a / λ", demand.force / resistance, given=held),
    )  # fmt: skip


def _period_steps(branch: Branch, context: Context, ratio: float) -> tuple[Step, ...]:
    """Write the longest period of the element, and T_a / T_1 at the period of the largest S_a."""
    words, wall = "period of the element over the building's, the worst from 0 to the longest", context.wall
    longest = longest_period(branch, context)
    if wall is None or longest is None or context.building is None:
        unknown = "building" if context.building is None else "element"
        return (step("T_a/T_1", words, CLAUSE, "1 at worst", ratio, remark=UNKNOWN[unknown]),)
    on_joints, bent = joint_period(branch), bending_period(wall, context.support)
    beam: Given = {
        "κ": BENDING[context.support],
        "L": (wall.height, "m"),
        "t": (wall.thickness, "m"),
        "ρ": (DENSITY, "kg/m3"),
        "E": (YOUNG_MODULUS, "Pa"),
    }
    joined: Given = {"T_b": (bent, "s"), "T_j": (on_joints, "s")}
    given: Given = {"T_a": (longest, "s"), "T_1": (context.building.period, "s")}
    own = "longest period in bending: ρ and E of heavy, soft, cracked masonry"
    return (
        step("T_b", own, BEAM, "κ L² / t √(ρ / E)", bent, "s", given=beam),
        step("T_j", "period on flexible joints", BEAM, "small motions; 0 on rigid joints", on_joints, "s"),
        step("T_a", "longest period of the element", BEAM, "√(T_b² + T_j²)", longest, "s", given=joined),
        step("T_a/T_1", words, CLAUSE, "min(T_a / T_1, 1)", ratio, given=given),
    )


UNKNOWN: dict[str, str] = {
    "building": "the worst case, as the building is not known",
    "element": "the worst case, as the size of the element is not known",
}


def _height_step(context: Context) -> Step:
    words, z = "height of the supports", context.support_height
    if context.building is None:
        return step("z/H", words, CLAUSE, "0: the building is not known", 0.0, at={"z": (z, "m")})
    given = {"z": (z, "m"), "H": (context.building.height, "m")}
    return step("z/H", words, CLAUSE, "min(z / H, 1)", height_ratio(context), given=given)
