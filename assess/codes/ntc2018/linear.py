"""Linear check of Circolare 7/2019, C8.7.1.2.1: activation at SLD, and at SLV with the behaviour factor q."""

from __future__ import annotations

from assess.codes.check import Check, Step
from assess.codes.context import Context
from assess.codes.italian.acceleration import acceleration_check, ratio_step
from assess.codes.italian.edition import Options
from assess.codes.italian.floor import Demands
from assess.codes.italian.kinematic import activation, activation_steps
from assess.codes.italian.limit_state import Case, at_each, rated
from assess.codes.ntc2018.clauses import (
    EDITION,
    ELASTIC_DAMPING,
    acceleration_demands,
    activation_pga,
    period_of,
    uplift,
)
from assess.codes.ntc2018.sheet import floor_steps, ordinate_steps, period_steps
from assess.oscillator import Oscillator

PROCEDURE = "ntc2018-linear"
CLAUSES = {"SLD": "C8.7.1.8, C8.7.1.9", "SLV": "C8.7.1.2.1 (SLV, q)"}
STATES = tuple(CLAUSES)


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """a0* against the peak acceleration of ground and floor (S_eZ(T0) of free elements); a_g,SLV = q a_g,SLD."""
    checks = at_each(oscillator, context, options.among(STATES), lambda case: _check(case, options))
    return tuple(rated(check, context) for check in checks)


def _check(case: Case, options: Options) -> Check:
    FC, q = options.confidence_factor, options.behaviour_factor if case.state == "SLV" else 1.0
    T0 = period_of(case.branch, case.context)
    over_pga = acceleration_demands(case.context, T0=T0)
    demands = Demands(over_pga.ground * case.pga / q, over_pga.floor * case.pga / q)
    a0 = activation(case.branch, mass=case.mass, confidence_factor=FC)
    return acceleration_check(
        case,
        EDITION,
        procedure=PROCEDURE,
        capacity=a0,
        demands=demands,
        uplift=uplift(case.branch, case.context, confidence_factor=FC),
        damping=ELASTIC_DAMPING,
        steps=(
            *activation_steps(case, EDITION, confidence_factor=FC),
            *period_steps(case, T0=T0),
            *demand_steps(case, over_pga, T0=T0, a0=a0),
            *_capacity_steps(case, over_pga, a0=a0, q=q),
            ratio_step(CLAUSES[case.state], demanded=demands.largest, capacity=a0),
        ),
    )


def demand_steps(case: Case, over_pga: Demands, *, T0: float, a0: float) -> tuple[Step, ...]:
    """Accelerations of ground and floor, and the PGA a_g,SLD at which the larger one reaches a0*."""
    spectrum, largest = case.context.spectrum, over_pga.largest * case.pga
    ground: tuple[Step, ...] = ()
    if T0 > 0.0:
        at, value = f"T0 = {T0:.5g} s, 5 %", over_pga.ground * case.pga
        ground = (Step("S_e(T0)", "elastic spectrum of the ground", spectrum.clause, "S_e(T0)", at, value, "m/s2"),)
    at_floor = ordinate_steps(case, T0, "T0", damping=ELASTIC_DAMPING) if T0 > 0.0 else ()
    numbers = f"{a0:.5g} · {case.pga:.5g} / {largest:.5g}"
    words = "PGA of activation, by the larger of ground and floor"
    clause = "C8.7.1.9" if T0 > 0.0 else "C8.7.1.8"
    value = activation_pga(a0, over_pga)
    activated = Step("a_g,SLD S", words, clause, "a0* · PGA / largest acceleration", numbers, value, "m/s2")
    return (*ground, *floor_steps(case), *at_floor, activated)


def _capacity_steps(case: Case, over_pga: Demands, *, a0: float, q: float) -> tuple[Step, ...]:
    clause, divided = CLAUSES[case.state], over_pga.largest * case.pga / q
    demanded = Step(
        "a_max / q",
        "demand: the larger of ground and floor",
        clause,
        "largest acceleration / q",
        f"{over_pga.largest * case.pga:.5g} / {q:g}",
        divided,
        "m/s2",
    )
    if case.state == "SLD":
        return (demanded,)
    activated = activation_pga(a0, over_pga)
    words, numbers = "PGA at capacity", f"{q:g} · {activated:.5g}"
    return Step("a_g,SLV S", words, clause, "q a_g,SLD S", numbers, q * activated, "m/s2"), demanded
