"""Non-linear kinematic analysis to the letter, C8A.4.2.2-2.3: d_u* against the displacement demand at T_s."""

from __future__ import annotations

from scipy.constants import g

from assess.codes.check import Check, Step
from assess.codes.context import Context
from assess.codes.dmi2008.clauses import (
    DAMPING,
    EDITION,
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
from assess.codes.italian.kinematic import activation_steps, collapse_step, curve_step
from assess.codes.italian.limit_state import Case, at_each, rated_on_hazard
from assess.oscillator import Oscillator

PROCEDURE = "dmi2008-nonlinear"
CLAUSE = "C8A.4.2.2"
STATES = ("SLV",)


def demands(context: Context, Ts: float) -> Demands | None:
    """S_De(Ts) and the floor's demand over PGA [s2]; None where the spectrum ends before Ts or T1."""
    floor = floor_of(context)
    if max(Ts, floor.T1 if floor is not None else 0.0) > context.spectrum.longest_period:
        return None
    at_floor = 0.0 if floor is None else floor_displacement(context, floor, Ts)
    return Demands(ground_displacement(context, Ts) / context.spectrum.pga, at_floor / context.spectrum.pga)


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """C8A.4.2.2-2.3 to the letter: du* against S_De(Ts), and against the floor's displacement above ground."""
    checks = at_each(oscillator, context, options.among(STATES), lambda case: _check(case, options))
    return rated_on_hazard(checks, context)


def _check(case: Case, options: Options) -> Check:
    FC, context = options.confidence_factor, case.context
    cap = capacity_of(case.branch, mass=case.mass, confidence_factor=FC)
    lifts = uplift(case.branch, context, confidence_factor=FC)
    answer = Answer(
        ultimate=cap.du,
        symbol="d_u*",
        collapse=cap.d0,
        e=cap.e,
        period=cap.Ts,
        period_symbol="T_s",
        wanted=demands(context, cap.Ts),
        starts=lifts or 0.0,
        still=0.0,
        uplift=lifts,
    )
    steps = (
        *activation_steps(case, EDITION, confidence_factor=FC),
        *_capacity_steps(case, cap, confidence_factor=FC),
        *_demand_steps(case, cap, answer),
    )
    return displacement_check(case, answer, EDITION, procedure=PROCEDURE, damping=DAMPING, rule="", steps=steps)


def _capacity_steps(case: Case, cap: Capacity, *, confidence_factor: float) -> tuple[Step, ...]:
    on_curve = "acceleration at d_s*, model's curve"
    root = f"2π √({cap.ds:.5g} / {cap.as_:.5g})"
    ultimate = f"{ULTIMATE:g} · {cap.d0:.5g}"
    return (
        collapse_step(case.branch, CLAUSE, mass=case.mass),
        Step("d_u*", "ultimate displacement", CLAUSE, "0.4 d0*", ultimate, cap.du, "m"),
        Step("d_s*", "secant displacement", CLAUSE, "0.4 d_u*", f"{ULTIMATE:g} · {cap.du:.5g}", cap.ds, "m"),
        curve_step(case, CLAUSE, "a_s*", on_curve, moved=cap.ds, confidence_factor=confidence_factor),
        Step("T_s", "secant period", CLAUSE, "2π √(d_s* / a_s*)", root, cap.Ts, "s"),
    )


def _demand_steps(case: Case, cap: Capacity, answer: Answer) -> tuple[Step, ...]:
    wanted, demanded, spectrum = answer.wanted, answer.demand(case.pga), case.context.spectrum
    if wanted is None or demanded is None:
        return ()
    scale = case.pga / spectrum.pga
    ordinate = float(spectrum.acceleration(cap.Ts, damping=DAMPING)) * scale
    spectral = f"T = {cap.Ts:.5g} s, PGA = {case.pga / g:.4g} g"
    steps = [
        Step("S_e(T_s)", "elastic spectrum, 5 %", spectrum.clause, "S_e(T_s)", spectral, ordinate, "m/s2"),
        ground_step(case, CLAUSE, "T_s", cap.Ts, ordinate=ordinate, moved=wanted.ground * case.pga),
    ]
    floor = floor_of(case.context)
    if floor is not None:
        first = ground_displacement(case.context, floor.T1) * scale
        numbers = f"{first:.5g} · {floor.psi:.4g} · {floor.gamma:.4g}, r = {cap.Ts:.5g} / {floor.T1:.5g}"
        formula, at_floor = "S_De(T1) ψ γ r² / √((1 − r)² + 0.02 r), r = T_s / T1", wanted.floor * case.pga
        steps.append(Step("Δ_d(Z)", "demand at the floor", "C8A.4.2.3", formula, numbers, at_floor, "m"))
    return (*steps, ratio_step(answer, CLAUSE, demanded=demanded))
