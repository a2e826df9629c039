"""DM 14.01.2008 with Circolare 617/2009, C8A.4: kinematic and dynamic analysis of local mechanisms.

Clause and equation numbers of C8A.4 are from memory, not checked against the printed circular; formulas were
re-derived. Linear: the acceleration that starts the mechanism against the demand over q. Non-linear: the ultimate
displacement d_u* = 0.4 d_0*, or less where a floor loses its seat before, against the spectral displacement at the
secant period T_s; a mechanism above ground must also pass the check on the floor's motion. Histories: what the circular
says of them is from memory; the criterion is that of Circolare 7/2019 with the capacity of 2009, no record beyond d0*
and the mean within d_u*. One function for each formula; those that Circolare 7/2019 has too are in
`assess.codes.italian_kinematic`.

The thesis' reading of the non-linear procedure (8.3.2) reproduces its Tables 8.6 and 8.7 and is for comparison only:
its period has d_u under the root where the clause has d_s, on the linearised rigid curve.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Annotated, Literal

import numpy as np

from assess.codes import italian_kinematic as kinematic
from assess.codes.calculation_sheet import Given, Step, excitation_column, instability_step, integral_step, step
from assess.codes.check import (
    Check,
    CodeProcedure,
    DefaultRun,
    Family,
    Premise,
    branch_of,
    caveats_of,
    check_worst_branch,
)
from assess.codes.context import Context
from assess.codes.italian_histories import (
    SOFTENING_BUILDING,
    SOFTENING_CLAUSE,
    HistoryRule,
    assess_histories,
    history_rules,
    required_pga,
)
from assess.codes.italian_limit_states import (
    FURTHER_STATES,
    BranchCurves,
    Demands,
    Floor,
    ItalianEdition,
    ItalianOptions,
    LimitStateCase,
    check_each_limit_state,
    floor_of,
)
from assess.codes.pga_rotation import (
    PgaRotation,
    pga_rotation,
    rotation_demand,
    rotation_verdict,
    to_equivalent_blocks,
    to_pga_curve,
)
from assess.declaration import Several
from assess.messages.message import Quantity, Term, message
from assess.oscillator import Branch, BranchName, Oscillator, displacement, participation_ratio, threshold
from spectra.arrays import FloatArray
from spectra.gravity import g

EDITION = ItalianEdition(
    code="dmi2008",
    name="DM 14.01.2008, Circolare 617/2009",
    caveat="clause numbers of C8A.4 not checked against the printed circular",
    multiplier="C8A.4.1",
    oscillator="C8A.4.1.2",
    confidence="C8A.1.1, C8A.4.1",
)
DAMPING = 0.05  # of every ordinate: the clauses know no other
ULTIMATE = 0.4  # d_u* / d_0*, and d_s* / d_u* (C8A.4.2.2)
DISPLACEMENT_LIMIT = kinematic.DisplacementLimit(ULTIMATE, breaks=False, clause="C8A.4.2.2")
LINEAR_CLAUSE = "C8A.4.2.1"


@dataclass(frozen=True)
class Dmi2008Options(ItalianOptions):
    """Options of the Italian procedure of DM 2008 with Circolare 617/2009."""

    limit_states: Annotated[tuple[Literal["SLD", "SLV"], ...], Several(1, unlike="limit state"), FURTHER_STATES] = (
        "SLV",
    )
    """limit states to check: "SLD" by dmi2008-linear, "SLV" by all"""


def assess_linear(oscillator: Oscillator, context: Context, *, options: ItalianOptions) -> tuple[Check, ...]:
    """Check a0* against the demand (over q at SLV), at the ground and, above it, at the floor (C8A.4.2.1)."""
    return check_each_limit_state(
        oscillator,
        context,
        EDITION,
        options,
        known=DMI2008_LINEAR.limit_states,
        one=lambda case: _linear_check(case, options),
    )


def acceleration_demands(context: Context, *, pga: float, q: float) -> Demands | None:
    """Return the accelerations that ground and floor demand, over q.

    Parameters
    ----------
    context : site and building
    pga : of the limit state [m/s2]
    q : behaviour factor [-]

    Returns
    -------
    Accelerations [m/s2]; None where the spectrum ends before T1.
    """
    floor = floor_of(context)
    if floor is None:
        return Demands(pga / q, 0.0)
    if context.spectrum.longest_period < floor.T1:
        return None
    return Demands(1.0, floor_acceleration(context, floor) / context.spectrum.pga).scale(pga / q)


NONLINEAR_CLAUSE = "C8A.4.2.2"


def assess_nonlinear(oscillator: Oscillator, context: Context, *, options: ItalianOptions) -> tuple[Check, ...]:
    """Check du* against S_De(Ts) and, above the ground, against the floor's displacement (C8A.4.2.2-2.3)."""
    return check_each_limit_state(
        oscillator,
        context,
        EDITION,
        options,
        known=DMI2008_NONLINEAR.limit_states,
        one=lambda case: _nonlinear_check(case.at_ultimate),
    )


def displacement_demands(context: Context, Ts: float) -> Demands | None:
    """Return S_De(Ts) of the ground and the floor's demand, both over PGA (C8A.4.2.3).

    Parameters
    ----------
    context : site and building
    Ts : secant period [s]

    Returns
    -------
    Displacements for each m/s2 of PGA [s2]; None where the spectrum ends before Ts or T1.
    """
    floor = floor_of(context)
    if max(Ts, floor.T1 if floor is not None else 0.0) > context.spectrum.longest_period:
        return None
    at_floor = 0.0 if floor is None else floor_displacement(context, floor, Ts)
    return Demands(ground_displacement(context, Ts) / context.spectrum.pga, at_floor / context.spectrum.pga)


@dataclass(frozen=True)
class Dmi2008Capacity:
    """The equivalent oscillator of one branch (C8A.4.2.2), all starred quantities: e* [-], a [m/s2], d [m], T [s]."""

    e: float
    a0: float
    ds: float
    as_: float
    Ts: float
    displacements: kinematic.DisplacementCapacity

    @property
    def d0(self) -> float:
        """d0* [m], of the actions shown to last."""
        return self.displacements.collapse

    @property
    def du(self) -> float:
        """du* [m]."""
        return self.displacements.displacement


def capacity_of(curves: BranchCurves, *, confidence_factor: float) -> Dmi2008Capacity:
    """Return the capacity of one branch: e*, a0*, d0*, du*, ds*, as* and Ts (C8A.4.2.2).

    du* = 0.4 d0*, or less where a seat is lost; ds* = 0.4 du*; as* is read on the model's own curve; Ts = 2 pi
    sqrt(ds* / as*).

    Parameters
    ----------
    curves : the branch by the actions in it
    confidence_factor : FC [-]

    Returns
    -------
    Dmi2008Capacity
    """
    mass, FC, capacity = curves.mass, confidence_factor, kinematic.displacement_capacity(curves, DISPLACEMENT_LIMIT)
    ds = ULTIMATE * capacity.displacement
    as_ = kinematic.acceleration_at(curves.breaking, ds, mass=mass, confidence_factor=FC)
    a0 = kinematic.activation(curves.starting, mass=mass, confidence_factor=FC)
    e = participation_ratio(curves.lasting, mass=mass)
    return Dmi2008Capacity(e, a0, ds, as_, float(2 * np.pi * np.sqrt(ds / as_)), capacity)


def ground_displacement(context: Context, Ts: float) -> float:
    """Return S_De(Ts) at the site's own PGA (C8A.4.2.3): S_e(Ts) (Ts / 2 pi)^2, or the code's own at long periods.

    Parameters
    ----------
    context : its spectrum
    Ts : secant period [s]

    Returns
    -------
    float [m]
    """
    return float(context.spectrum.displacement(Ts, damping=DAMPING))


def floor_displacement(context: Context, floor: Floor, Ts: float) -> float:
    """Return S_De(T1) psi gamma (Ts/T1)^2 / sqrt((1 - Ts/T1)^2 + 0.02 Ts/T1) at the site's own PGA (C8A.4.2.3).

    Parameters
    ----------
    context : its spectrum
    floor : psi, gamma and T1 of the building
    Ts : secant period [s]

    Returns
    -------
    float [m]
    """
    r = Ts / floor.T1
    at_first_mode = ground_displacement(context, floor.T1) * floor.psi * floor.gamma
    return float(at_first_mode * r**2 / np.sqrt((1 - r) ** 2 + 0.02 * r))


def floor_acceleration(context: Context, floor: Floor) -> float:
    """Return S_e(T1) psi gamma at the site's own PGA (C8A.4.2.3).

    Parameters
    ----------
    context : its spectrum
    floor : psi, gamma and T1 of the building

    Returns
    -------
    float [m/s2]
    """
    return float(context.spectrum.acceleration(floor.T1, damping=DAMPING)) * floor.psi * floor.gamma


def uplift_on_floor(branch: Branch, context: Context, *, confidence_factor: float) -> float | None:
    """Return the PGA at uplift, less where the floor amplifies the ground.

    Parameters
    ----------
    branch : with every action at rest
    context : site and building
    confidence_factor : FC [-]

    Returns
    -------
    PGA [m/s2]; None without a threshold, and where the spectrum ends before the period of the building.
    """
    floor = floor_of(context)
    if floor is not None and context.spectrum.longest_period < floor.T1:
        return None
    amplified = 1.0 if floor is None else floor_acceleration(context, floor) / context.spectrum.pga
    return kinematic.uplift_pga(branch, confidence_factor=confidence_factor, amplified=amplified)


HISTORY_RULE = HistoryRule(
    procedure="dmi2008-history",
    edition=EDITION,
    clause="C8A.4.2.3 (non-linear dynamic)",
    limits={"SLV": DISPLACEMENT_LIMIT},
)


def assess_history(oscillator: Oscillator, context: Context, *, options: ItalianOptions) -> tuple[Check, ...]:
    """Return the checks of the suites of time histories against 0.4 d0*."""
    return assess_histories(oscillator, context, rule=HISTORY_RULE, options=options)


DMI2008_HISTORY = CodeProcedure(
    name=HISTORY_RULE.procedure,
    family=Family.HISTORY,
    assess=assess_history,
    title=Term("DMI 2008, response history"),
    short_title=Term("DMI 2008 history"),
    work="dmi2008",
    options="dmi2008",
    limit_states=tuple(HISTORY_RULE.limits),
    default_run=DefaultRun(spectra=("ntc2008",)),
    suite_rules="ntc2018",
    history_rules=partial(history_rules, rule=HISTORY_RULE),
    required_pga=partial(required_pga, rule=HISTORY_RULE),
    premises=(Premise.SOUND_MASONRY,),
    buildings=SOFTENING_BUILDING,
    building_clause=SOFTENING_CLAUSE,
)


def _assess_nonlinear_thesis(oscillator: Oscillator, context: Context, *, options: ItalianOptions) -> tuple[Check, ...]:
    """Return the checks of the thesis' reading (8.3.2): at the ground, FC = 1, no threshold of uplift."""
    like = to_equivalent_blocks(oscillator, lambda branch: ULTIMATE * branch.unstable)

    def one(branch: Branch, name: BranchName, level: float) -> Check:
        curve = thesis_pga_rotation(branch, context, mass=oscillator.mass)
        allowable = ULTIMATE * branch.unstable
        rotation = rotation_demand(curve, level)
        lifts = threshold(branch_of(oscillator, name))
        answer = rotation_verdict(rotation, allowable, curve=curve, level=level, uplift=lifts, context=context)
        return Check(
            procedure=DMI2008_NONLINEAR_THESIS.name,
            edition=EDITION.name,
            reading=DMI2008_NONLINEAR_THESIS.reading,
            branch=name,
            limit_state="SLV",
            level_pga_g=level / g,
            input_at="ground",
            damping=DAMPING,
            quantity="rotation",
            unit="rad",
            demand=rotation,
            capacity=allowable,
            ratio=None if rotation is None else rotation / allowable,
            verdict=answer.verdict,
            reason=answer.reason,
            capacity_pga_g=answer.capacity_pga_g,
            uplift_pga_g=lifts,
            capacity_rotation_ratio=allowable / branch.overturning,
            rotation_ratio=None if rotation is None else rotation / branch.overturning,
            pga_curve=to_pga_curve(curve, branch),
            steps=_thesis_steps(
                like, branch, context, level=level, rotation=rotation, at_collapse=answer.capacity_pga_g
            ),
            **caveats_of(EDITION.caveat),
        )

    return check_worst_branch(like, context.levels, one)


DMI2008_NONLINEAR_THESIS = CodeProcedure(
    name="dmi2008-nonlinear-thesis",
    family=Family.DISPLACEMENT,
    assess=_assess_nonlinear_thesis,
    title=Term("DMI 2008, capacity spectrum, Mehrotra"),
    short_title=Term("DMI 2008 sp., Mehrotra"),
    work="dmi2008",
    options="dmi2008",
    reading="thesis",
    default_run=DefaultRun(except_spectra=("ntc2018",)),
    premises=(Premise.SOUND_MASONRY,),
)


def thesis_pga_rotation(branch: Branch, context: Context, *, mass: float) -> PgaRotation:
    """Return PGA(phi) of the thesis' reading: a_s = lambda g (1 - 0.4 x) at d_s = 0.4 d_u, T = 2 pi sqrt(d_u / a_s).

    x = phi / phi_ov, d_u = x d0; lambda and the curve are linearised and rigid. The clause has d_s, not d_u, under the
    root; with d_u the eight walls of Table 8.6 come out within rounding (the letter is higher by about 1.6).

    Parameters
    ----------
    branch : the direction of rocking
    context : its spectrum
    mass : total moved mass [kg]

    Returns
    -------
    PgaRotation
    """
    d0 = float(displacement(branch, np.array(branch.unstable), mass=mass))
    linear = branch.linearised

    def secant(rotation: FloatArray) -> FloatArray:
        return linear.multiplier * g * (1 - ULTIMATE * rotation / branch.unstable)

    def period_of(rotation: FloatArray) -> FloatArray:
        return np.asarray(2 * np.pi * np.sqrt(rotation / branch.unstable * d0 / secant(rotation)))

    def pga_of(rotation: FloatArray) -> FloatArray:
        ordinate = context.spectrum.acceleration(period_of(rotation), damping=DAMPING)
        return secant(rotation) * context.spectrum.pga / ordinate

    return pga_rotation(
        pga_of,
        overturning=branch.unstable,
        period_of=period_of,
        longest_period=context.spectrum.longest_period,
    )


DMI2008_LINEAR = CodeProcedure(
    name="dmi2008-linear",
    family=Family.LINEAR,
    assess=assess_linear,
    title=Term("DMI 2008, linear"),
    short_title=Term("DMI 2008 linear"),
    work="dmi2008",
    options="dmi2008",
    limit_states=("SLD", "SLV"),
    default_run=DefaultRun(except_spectra=("ntc2018",)),
    premises=(Premise.SOUND_MASONRY,),
)


def _linear_check(case: LimitStateCase, options: ItalianOptions) -> Check:
    FC, context, branch = case.confidence.factor, case.context, case.curves.starting
    q = options.behaviour_factor if case.state == "SLV" else 1.0
    demands = acceleration_demands(context, pga=case.pga, q=q)
    a0 = kinematic.activation(branch, mass=case.curves.mass, confidence_factor=FC)
    return kinematic.acceleration_check(
        case,
        EDITION,
        procedure=DMI2008_LINEAR.name,
        capacity=a0,
        demands=demands,
        period_needed=Term("T1 of the building"),
        uplift_pga=uplift_on_floor(branch, context, confidence_factor=FC),
        damping=DAMPING,
        steps=(
            *kinematic.activation_steps(case, EDITION),
            *_acceleration_demand_steps(case, demands, q=q),
            *kinematic.acceleration_ratio_steps(LINEAR_CLAUSE, demands, capacity=a0),
        ),
    )


def _acceleration_demand_steps(case: LimitStateCase, demands: Demands | None, *, q: float) -> tuple[Step, ...]:
    if demands is None:
        return ()
    floor, spectrum = floor_of(case.context), case.context.spectrum
    given: Given = {"PGA": (case.pga, "m/s2"), "q": q}
    ground = step("a_g S / q", "demand of the ground", LINEAR_CLAUSE, "PGA / q", demands.ground, "m/s2", given=given)
    if floor is None:
        return (ground,)
    spectral = float(spectrum.acceleration(floor.T1, damping=DAMPING)) * case.pga / spectrum.pga
    shape: Given = {"S_e(T1)": (spectral, "m/s2"), "ψ": floor.psi, "γ": floor.gamma, "q": q}
    words, formula = "demand of the floor, ψ = Z / H, γ = 3 N / (2 N + 1)", "S_e(T1) · ψ · γ / q"
    return ground, step(formula, words, LINEAR_CLAUSE, formula, demands.floor, "m/s2", given=shape)


DMI2008_NONLINEAR = CodeProcedure(
    name="dmi2008-nonlinear",
    family=Family.DISPLACEMENT,
    assess=assess_nonlinear,
    title=Term("DMI 2008, capacity spectrum"),
    short_title=Term("DMI 2008 spectrum"),
    work="dmi2008",
    options="dmi2008",
    limit_states=("SLV",),
    default_run=DefaultRun(except_spectra=("ntc2018",)),
    premises=(Premise.SOUND_MASONRY,),
)


def _nonlinear_check(case: LimitStateCase) -> Check:
    FC, context = case.confidence.factor, case.context
    cap = capacity_of(case.curves, confidence_factor=FC)
    lifts = uplift_on_floor(case.curves.starting, context, confidence_factor=FC)
    analysis = kinematic.DisplacementAnalysis(
        ultimate_displacement=cap.du,
        symbol="d_u*",
        collapse_displacement=cap.d0,
        participation_ratio=cap.e,
        period_needed=message("period-or-building", {"symbol": "T_s", "period": Quantity(cap.Ts, "time")}),
        demand_per_pga=displacement_demands(context, cap.Ts),
        activation_pga=lifts or 0.0,
        elastic_displacement_per_pga=0.0,
        uplift_pga=lifts,
        conditions=(
            *kinematic.break_conditions(case.curves),
            *kinematic.seat_conditions(context, case.curves, case.state, cap.du),
        ),
    )
    steps = (
        *kinematic.activation_steps(case, EDITION),
        *_capacity_steps(case, cap),
        *_displacement_demand_steps(case, cap, analysis),
    )
    return kinematic.displacement_check(
        case, analysis, EDITION, procedure=DMI2008_NONLINEAR.name, damping=DAMPING, rule="", steps=steps
    )


def _capacity_steps(case: LimitStateCase, cap: Dmi2008Capacity) -> tuple[Step, ...]:
    of_ds: Given = {"k": ULTIMATE, "d_u*": (cap.du, "m")}
    of_Ts = {"d_s*": (cap.ds, "m"), "a_s*": (cap.as_, "m/s2")}
    return (
        *kinematic.displacement_capacity_steps(case.curves, cap.displacements, DISPLACEMENT_LIMIT, "d_u*",
                                     "ultimate displacement"),
        step("d_s*", "secant displacement, k = 0.4", NONLINEAR_CLAUSE, "k · d_u*", cap.ds, "m", given=of_ds),
        *kinematic.curve_steps(case, NONLINEAR_CLAUSE, "a_s*", "acceleration at d_s*, with actions that have not ended",
                     moved=cap.ds, argument="d_s*"),
        step("T_s", "secant period", NONLINEAR_CLAUSE, "2 · π · √(d_s* / a_s*)", cap.Ts, "s", given=of_Ts),
    )  # fmt: skip


def _displacement_demand_steps(
    case: LimitStateCase, cap: Dmi2008Capacity, analysis: kinematic.DisplacementAnalysis
) -> tuple[Step, ...]:
    per_pga, demand, spectrum = analysis.demand_per_pga, analysis.demand(case.pga), case.context.spectrum
    if per_pga is None or demand is None:
        return ()
    scale = case.pga / spectrum.pga
    spectral = float(spectrum.acceleration(cap.Ts, damping=DAMPING)) * scale
    at: Given = {"T_s": (cap.Ts, "s"), "ξ": DAMPING, "PGA": (case.pga, "m/s2")}
    words = "elastic spectrum, 5 %"
    steps = [
        step("S_e(T_s)", words, spectrum.clause, "S_e(T, 5 %)", spectral, "m/s2", at=at),
        kinematic.ground_step(
            case, NONLINEAR_CLAUSE, "T_s", cap.Ts, ordinate=spectral, moved=per_pga.ground * case.pga
        ),
    ]
    floor = floor_of(case.context)
    if floor is not None:
        first = ground_displacement(case.context, floor.T1) * scale
        shape = {"T_s": (cap.Ts, "s"), "T1": (floor.T1, "s")}
        given: Given = {"S_De(T1)": (first, "m"), "ψ": floor.psi, "γ": floor.gamma, "r": cap.Ts / floor.T1}
        formula = "S_De(T1) · ψ · γ · (r)² / √((1 − r)² + 0.02 · r)"
        steps += [
            step("r", "period over the first mode's", "C8A.4.2.3", "T_s / T1", cap.Ts / floor.T1, given=shape),
            step("Δ_d(Z)", "demand at the floor", "C8A.4.2.3", formula, per_pga.floor * case.pga, "m", given=given),
        ]
    return (*steps, kinematic.displacement_ratio_step(analysis, NONLINEAR_CLAUSE, demand=demand))


def _thesis_steps(
    oscillator: Oscillator,
    branch: Branch,
    context: Context,
    *,
    level: float,
    rotation: float | None,
    at_collapse: float | None,
) -> tuple[Step, ...]:
    linear, source = branch.linearised, "Mehrotra 8.3.2"
    d0 = float(displacement(branch, np.array(branch.unstable), mass=oscillator.mass))
    a_s = linear.multiplier * g * (1 - ULTIMATE**2)
    period = float(2 * np.pi * np.sqrt(ULTIMATE * d0 / a_s))
    ratio = None if rotation is None else rotation / branch.overturning
    at_rest = {
        "K": (linear.stiffness, "N m/rad"),
        "φ_cr": (linear.critical, "rad"),
        "M": (linear.moment, "N m"),
        "B": (linear.excitation, "kg m"),
    }
    secant, moved = {"d0": (d0, "m"), "a_s": (a_s, "m/s2")}, d0 * oscillator.mass
    whole: Given = {"∫ B dφ": (moved, "kg m"), "M": (oscillator.mass, "kg")}
    falls, along = "rotation where the restoring moment falls to zero", "excitation over rotation"
    steps = (
        step("λ", "multiplier, linearised", "Mehrotra 3.11", "(K φ_cr − M) / (g B)", linear.multiplier, given=at_rest),
        instability_step("φ_ov", falls, source, branch),
        integral_step("∫ B dφ", along, source, excitation_column(branch), branch.unstable, "kg m", upper="φ_ov"),
        step("d0", "displacement at overturning", source, "∫ B dφ / M", d0, "m", given=whole),
        step("a_s", "acceleration at 0.4 d_u, d_u = 0.4 d0", source, "λ g (1 − 0.4 · 0.4)", a_s, "m/s2",
             given={"λ": linear.multiplier}),
        step("T", "period, with d_u (the clause: d_s)", source, "2π √(0.4 d0 / a_s)", period, "s", given=secant),
        step("φ/φ_ov", "rotation at the level", source, "PGA(φ) = level", ratio, at={"level": (level / g, "g")}),
    )  # fmt: skip
    return steps if at_collapse is None else (*steps, *_collapse_steps(context, a_s, period, at_collapse))


def _collapse_steps(context: Context, a_s: float, period: float, at_collapse: float) -> tuple[Step, ...]:
    ordinate = float(context.spectrum.acceleration(period, damping=DAMPING)) / context.spectrum.pga
    clause, at = context.spectrum.clause, {"T": (period, "s"), "ξ": (DAMPING, "-")}
    given = {"a_s": (a_s, "m/s2"), "S_a/PGA": (ordinate, "-")}
    words = "largest PGA with φ ≤ 0.4 φ_ov"
    return (
        step("S_a/PGA", "spectrum over PGA, 5 %", clause, "S_a(T) / PGA", ordinate, at=at),
        step("PGA_c", words, "Mehrotra 8.3.2", "a_s / (g S_a/PGA)", at_collapse, "g", given=given),
    )
