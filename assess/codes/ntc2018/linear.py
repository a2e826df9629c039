"""Linear check of Circolare 7/2019: activation at SLD (C8.7.1.2.1.5), and at SLV with q (C8.7.1.2.1.7)."""

from __future__ import annotations

from assess.codes.calculation_step import Given
from assess.codes.check import Check, Step, step
from assess.codes.context import Context
from assess.codes.italian.acceleration import acceleration_check, ratio_steps
from assess.codes.italian.edition import Options
from assess.codes.italian.floor import Demands
from assess.codes.italian.kinematic import activation
from assess.codes.italian.limit_state import Case, add_safety_index, check_each_limit_state
from assess.codes.italian.sheet import activation_steps
from assess.codes.ntc2018.building import ELASTIC_DAMPING, FirstModes, elastic_modes, floor_acceleration
from assess.codes.ntc2018.clauses import EDITION, acceleration_demands, activation_pga, period_of, uplift
from assess.codes.ntc2018.sheet import (
    first_mode_steps,
    ordinate_steps,
    peak_steps,
    peak_symbol,
    period_steps,
    share_steps,
)
from assess.messages.message import Term
from assess.oscillator import Oscillator

PROCEDURE = "ntc2018-linear"
CLAUSES = {"SLD": "C8.7.1.2.1.5", "SLV": "C8.7.1.2.1.7"}
STATES = tuple(CLAUSES)


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """Check a0* against the accelerations of ground and floor, S_eZ(T0) of free elements; a_g,SLV = q a_g,SLD."""
    checks = check_each_limit_state(
        oscillator, context, EDITION, options, known=STATES, one=lambda case: _check(case, options)
    )
    return tuple(add_safety_index(check, context) for check in checks)


def _check(case: Case, options: Options) -> Check:
    FC, q = case.confidence.factor, options.behaviour_factor if case.state == "SLV" else 1.0
    context, branch, modes = case.context, case.curves.starting, elastic_modes(case.context)
    T0 = period_of(branch, context)
    over_pga = acceleration_demands(context, modes, T0=T0)
    demands = None if over_pga is None else over_pga.scale(case.pga / q)
    a0 = activation(branch, mass=case.curves.mass, confidence_factor=FC)
    return acceleration_check(
        case,
        EDITION,
        procedure=PROCEDURE,
        capacity=a0,
        demands=demands,
        needs=Term("T0 or T1 of the building"),
        uplift=uplift(branch, context, confidence_factor=FC),
        damping=ELASTIC_DAMPING,
        steps=(
            *activation_steps(case, EDITION),
            *period_steps(case, T0=T0),
            *share_steps(case, modes),
            *demand_steps(case, modes, over_pga, T0=T0, a0=a0),
            *_capacity_steps(case, over_pga, a0=a0, q=q),
            *ratio_steps(CLAUSES[case.state], demands, capacity=a0),
        ),
    )


def demand_steps(
    case: Case, modes: FirstModes | None, over_pga: Demands | None, *, T0: float, a0: float, symbol: str = "T1"
) -> tuple[Step, ...]:
    """Write the accelerations of ground and floor, and the PGA a_g,SLD S at which the larger one reaches a0*.

    symbol : of the most demanding first mode
    """
    if over_pga is None:
        return ()
    spectrum, free = case.context.spectrum, T0 > 0.0
    ground, floor = ("S_e(T0)" if free else "PGA"), ("S_eZ(T0)" if free else peak_symbol(symbol))
    given = {"a0*": (a0, "m/s2"), "PGA": (case.pga, "m/s2"), ground: (over_pga.ground * case.pga, "m/s2")}
    steps: list[Step] = []
    if free:
        at: Given = {"T0": (T0, "s"), "ξ": ELASTIC_DAMPING, "PGA": (case.pga, "m/s2")}
        words, value = "elastic spectrum of the ground", over_pga.ground * case.pga
        steps.append(step(ground, words, spectrum.clause, "S_e(T, ξ)", value, "m/s2", at=at))
    most = ground
    if modes is not None:
        steps += floor_steps(case, modes, T0=T0, symbol=symbol)
        given[floor], most = (over_pga.floor * case.pga, "m/s2"), f"max({ground}, {floor})"
    words, value = "PGA of activation, by the larger of ground and floor", activation_pga(a0, over_pga)
    clause, formula = "C8.7.1.9" if free else "C8.7.1.8", f"a0* · PGA / {most}"
    return *steps, step("a_g,SLD S", words, clause, formula, value, "m/s2", given=given)


def floor_steps(case: Case, modes: FirstModes, *, T0: float, symbol: str) -> tuple[Step, ...]:
    """Write the floor's acceleration under the most demanding first mode."""
    first, _ = floor_acceleration(case.context, modes, T0)
    why = "first mode, softened by 1.5 to 2.0: that of the largest acceleration"
    at = ordinate_steps(case, modes, (symbol, first), ("T0", T0), damping=ELASTIC_DAMPING) if T0 > 0.0 else ()
    return (
        *first_mode_steps(modes, first, symbol, ("T0", T0), why),
        *peak_steps(case, modes, first, symbol),
        *at,
    )


def _capacity_steps(case: Case, over_pga: Demands | None, *, a0: float, q: float) -> tuple[Step, ...]:
    if over_pga is None:
        return ()
    clause, largest = CLAUSES[case.state], over_pga.largest * case.pga
    demanded = step(
        "a_max / q",
        "demand: the larger of ground and floor",
        clause,
        "a_max / q",
        largest / q,
        "m/s2",
        given={"a_max": (largest, "m/s2"), "q": q},
    )
    if case.state == "SLD":
        return (demanded,)
    activated = activation_pga(a0, over_pga)
    given: Given = {"q": q, "a_g,SLD S": (activated, "m/s2")}
    return step("a_g,SLV S", "PGA at capacity", clause, "q · a_g,SLD S", q * activated, "m/s2", given=given), demanded
