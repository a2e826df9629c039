"""Non-linear kinematic analysis to the letter, C8A.4.2.2-2.3: d_u* against the displacement demand at T_s."""

from __future__ import annotations

from assess.codes.calculation_step import Given
from assess.codes.check import Check, Step, step
from assess.codes.context import Context
from assess.codes.dmi2008.clauses import (
    DAMPING,
    EDITION,
    RULE,
    ULTIMATE,
    Capacity,
    capacity_of,
    floor_displacement,
    ground_displacement,
    uplift,
)
from assess.codes.italian.displacement import Answer, displacement_check, ground_step, ratio_step
from assess.codes.italian.edition import Options
from assess.codes.italian.floor import Demands, floor_of
from assess.codes.italian.limit_state import Case, add_safety_index, check_each_limit_state
from assess.codes.italian.sheet import activation_steps, curve_steps
from assess.codes.italian.thresholds import break_conditions, seat_conditions, threshold_steps
from assess.messages.message import Quantity, message
from assess.oscillator import Oscillator

PROCEDURE = "dmi2008-nonlinear"
CLAUSE = "C8A.4.2.2"
STATES = ("SLV",)


def demands(context: Context, Ts: float) -> Demands | None:
    """Return S_De(Ts) of the ground and the floor's demand, both over PGA (C8A.4.2.3).

    Parameters
    ----------
    context : site and building
    Ts : secant period [s]

    Returns
    -------
    Demands or None
        Displacements for each m/s2 of PGA [s2]; None where the spectrum ends before Ts or T1.
    """
    floor = floor_of(context)
    if max(Ts, floor.T1 if floor is not None else 0.0) > context.spectrum.longest_period:
        return None
    at_floor = 0.0 if floor is None else floor_displacement(context, floor, Ts)
    return Demands(ground_displacement(context, Ts) / context.spectrum.pga, at_floor / context.spectrum.pga)


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """Check du* against S_De(Ts) and, above the ground, against the floor's displacement (C8A.4.2.2-2.3)."""
    checks = check_each_limit_state(
        oscillator, context, EDITION, options, known=STATES, one=lambda case: _check(case.at_ultimate)
    )
    return tuple(add_safety_index(check, context) for check in checks)


def _check(case: Case) -> Check:
    FC, context = case.confidence.factor, case.context
    cap = capacity_of(case.curves, confidence_factor=FC)
    lifts = uplift(case.curves.starting, context, confidence_factor=FC)
    answer = Answer(
        ultimate=cap.du,
        symbol="d_u*",
        collapse=cap.d0,
        e=cap.e,
        needs=message("period-or-building", {"symbol": "T_s", "period": Quantity(cap.Ts, "time")}),
        wanted=demands(context, cap.Ts),
        starts=lifts or 0.0,
        still=0.0,
        uplift=lifts,
        conditions=(*break_conditions(case.curves), *seat_conditions(context, case.curves, case.state, cap.du)),
    )
    steps = (
        *activation_steps(case, EDITION),
        *_capacity_steps(case, cap),
        *_demand_steps(case, cap, answer),
    )
    return displacement_check(case, answer, EDITION, procedure=PROCEDURE, damping=DAMPING, rule="", steps=steps)


def _capacity_steps(case: Case, cap: Capacity) -> tuple[Step, ...]:
    of_ds: Given = {"k": ULTIMATE, "d_u*": (cap.du, "m")}
    of_Ts = {"d_s*": (cap.ds, "m"), "a_s*": (cap.as_, "m/s2")}
    return (
        *threshold_steps(case.curves, cap.threshold, RULE, "d_u*", "ultimate displacement"),
        step("d_s*", "secant displacement, k = 0.4", CLAUSE, "k · d_u*", cap.ds, "m", given=of_ds),
        *curve_steps(case, CLAUSE, "a_s*", "acceleration at d_s*, with actions that have not ended", moved=cap.ds,
                     argument="d_s*"),
        step("T_s", "secant period", CLAUSE, "2 · π · √(d_s* / a_s*)", cap.Ts, "s", given=of_Ts),
    )  # fmt: skip


def _demand_steps(case: Case, cap: Capacity, answer: Answer) -> tuple[Step, ...]:
    wanted, demanded, spectrum = answer.wanted, answer.demand(case.pga), case.context.spectrum
    if wanted is None or demanded is None:
        return ()
    scale = case.pga / spectrum.pga
    spectral = float(spectrum.acceleration(cap.Ts, damping=DAMPING)) * scale
    at: Given = {"T_s": (cap.Ts, "s"), "ξ": DAMPING, "PGA": (case.pga, "m/s2")}
    words = "elastic spectrum, 5 %"
    steps = [
        step("S_e(T_s)", words, spectrum.clause, "S_e(T, 5 %)", spectral, "m/s2", at=at),
        ground_step(case, CLAUSE, "T_s", cap.Ts, ordinate=spectral, moved=wanted.ground * case.pga),
    ]
    floor = floor_of(case.context)
    if floor is not None:
        first = ground_displacement(case.context, floor.T1) * scale
        shape = {"T_s": (cap.Ts, "s"), "T1": (floor.T1, "s")}
        given: Given = {"S_De(T1)": (first, "m"), "ψ": floor.psi, "γ": floor.gamma, "r": cap.Ts / floor.T1}
        formula = "S_De(T1) · ψ · γ · (r)² / √((1 − r)² + 0.02 · r)"
        steps += [
            step("r", "period over the first mode's", "C8A.4.2.3", "T_s / T1", cap.Ts / floor.T1, given=shape),
            step("Δ_d(Z)", "demand at the floor", "C8A.4.2.3", formula, wanted.floor * case.pga, "m", given=given),
        ]
    return (*steps, ratio_step(answer, CLAUSE, demanded=demanded))
