"""Non-linear kinematic check of Circolare 7/2019: displacement capacity at SLV or SLC (C8.7.1.2.1.6, .8)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from assess.codes.calculation_step import Given
from assess.codes.check import Check, Step, step
from assess.codes.context import Context
from assess.codes.italian.displacement import Answer, displacement_check, ground_step, ratio_step
from assess.codes.italian.edition import Options
from assess.codes.italian.floor import Demands
from assess.codes.italian.limit_state import Case, add_safety_index, check_each_limit_state
from assess.codes.italian.sheet import activation_steps, curve_steps
from assess.codes.italian.thresholds import break_conditions, seat_conditions, threshold_steps
from assess.codes.ntc2018.building import (
    SHOWN_DAMPING,
    FirstModes,
    FloorDemand,
    floor_demand,
    ground_period,
    longest_period_used,
    modes_at,
    ordinate,
)
from assess.codes.ntc2018.clauses import (
    EDITION,
    ULTIMATE,
    Capacity,
    acceleration_demands,
    activation_pga,
    capacity_of,
    displacement_demands,
    period_of,
    uplift,
)
from assess.codes.ntc2018.linear import demand_steps
from assess.codes.ntc2018.sheet import first_mode_steps, ordinate_steps, peak_steps, period_steps, share_steps
from assess.messages.message import Quantity, message
from assess.oscillator import Oscillator
from spectra.circolare2019 import PLATEAU

PROCEDURE = "ntc2018-nonlinear"
CLAUSE = "C8.7.1.2.1.8"
STATES = tuple(ULTIMATE)
SOFTENED_WORST = "first mode, softened by 1.5 to 2.0: that of the largest displacement"
FIRST, AT_ACTIVATION = "T1'", "T1'_a"  # of the building: what asks most of d_LS, and of a0*


@dataclass(frozen=True)
class Worked:
    """What a case is worked out from: capacity, first modes, demands over PGA of acceleration and displacement."""

    capacity: Capacity
    modes: FirstModes | None
    over_pga: Demands | None
    wanted: Demands | None


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """Check d_SLV and d_SLC against the displacements of ground and floor; the capacity is at least a_g,SLD."""
    checks = check_each_limit_state(
        oscillator, context, EDITION, options, known=STATES, one=lambda case: _check(case.at_ultimate)
    )
    return tuple(add_safety_index(check, context) for check in checks)


def _check(case: Case) -> Check:
    worked = _worked(case)
    cap, answer = worked.capacity, _answer(case, worked)
    steps = (
        *activation_steps(case, EDITION),
        *period_steps(case, T0=cap.T0),
        *share_steps(case, worked.modes),
        *demand_steps(case, worked.modes, worked.over_pga, T0=cap.T0, a0=cap.a0, symbol=AT_ACTIVATION),
        *_capacity_steps(case, cap),
        *_displacement_steps(case, worked, answer),
    )
    damping, rule = ULTIMATE[case.state].damping, case.context.spectrum.damping_rule
    return displacement_check(case, answer, EDITION, procedure=PROCEDURE, damping=damping, rule=rule, steps=steps)


def _worked(case: Case) -> Worked:
    context, T0 = case.context, period_of(case.curves.starting, case.context)
    modes, damping = modes_at(context, case.state), ULTIMATE[case.state].damping
    cap = capacity_of(case.curves, state=case.state, confidence_factor=case.confidence.factor, T0=T0)
    wanted = displacement_demands(context, modes, T0=T0, T=cap.T, damping=damping)
    return Worked(cap, modes, acceleration_demands(context, modes, T0=T0), wanted)


def _answer(case: Case, worked: Worked) -> Answer:
    """Make the answer: below a_g,SLD the element moves elastically with T0, or, if rigid, not at all."""
    cap, over_pga = worked.capacity, worked.over_pga
    if over_pga is None:
        activated = elastic = 0.0
    else:
        activated, elastic = activation_pga(cap.a0, over_pga), over_pga.largest * (cap.T0 / (2 * np.pi)) ** 2
    symbol, longest = f"T_{case.state}", longest_period_used(worked.modes, cap.T)
    at = Quantity(longest, "time")
    return Answer(
        ultimate=cap.d,
        symbol=f"d_{case.state}",
        collapse=cap.d0,
        e=cap.e,
        needs=message("period-of" if longest == cap.T else "period-or-floor", {"symbol": symbol, "period": at}),
        wanted=worked.wanted,
        starts=activated if elastic * activated <= cap.d else 0.0,
        still=elastic,
        uplift=uplift(case.curves.starting, case.context, confidence_factor=case.confidence.factor),
        conditions=(
            *break_conditions(case.curves),
            *(seat_conditions(case.context, case.curves, case.state, cap.d) if case.state == "SLV" else ()),
        ),
    )


def _capacity_steps(case: Case, cap: Capacity) -> tuple[Step, ...]:
    state, ultimate = case.state, ULTIMATE[case.state]
    d, a = f"d_{state}", f"a(d_{state})"
    curve = curve_steps(case, "C8.7.1.3", a, "acceleration with actions that have not ended", moved=cap.d, argument=d)
    if cap.T0 > 0.0 and cap.a < curve[-1].value:  # type: ignore[operator]
        given = {d: (cap.d, "m"), "T0": (cap.T0, "s")}
        words, formula = "acceleration on the elastic branch", f"{d} · (2 · π / T0)²"
        curve = (step(a, words, "C8.7.1.6", formula, cap.a, "m/s2", given=given),)
    formula, given = f"{ultimate.factor:g} · π · √({d} / {a})", {d: (cap.d, "m"), a: (cap.a, "m/s2")}
    return (
        *threshold_steps(case.curves, cap.threshold, ultimate.rule, d, "displacement capacity"),
        *curve,
        step(f"T_{state}", "secant period", ultimate.clause, formula, cap.T, "s", given=given),
    )


def _displacement_steps(case: Case, worked: Worked, answer: Answer) -> tuple[Step, ...]:
    wanted, demanded, spectrum = answer.wanted, answer.demand(case.pga), case.context.spectrum
    if wanted is None or demanded is None:
        return ()
    cap, damping, symbol = worked.capacity, ULTIMATE[case.state].damping, f"T_{case.state}"
    T = ground_period(case.context, T0=cap.T0, T=cap.T, damping=damping)
    spectral = float(spectrum.acceleration(T, damping=damping)) * case.pga / spectrum.pga
    said = "elastic spectrum, damped as the mechanism"
    at: Given = {"T": (T, "s"), "ξ": damping, "PGA": (case.pga, "m/s2")}
    asked = "period from T0 to the secant one of the largest S_De"
    between: Given = {"T0": (cap.T0, "s"), symbol: (cap.T, "s")}
    steps = [
        step("T", asked, CLAUSE, "T0 ≤ T ≤ T_LS", T, "s", at=between),
        step("S_e(T)", said, spectrum.clause, "S_e(T, ξ)", spectral, "m/s2", at=at),
        ground_step(case, CLAUSE, "T", T, ordinate=spectral, moved=wanted.ground * case.pga),
        *_floor_steps(case, worked, symbol, damping=damping),
    ]
    return (*steps, ratio_step(answer, CLAUSE, demanded=demanded))


def _floor_steps(case: Case, worked: Worked, symbol: str, *, damping: float) -> tuple[Step, ...]:
    """Write the floor's demand under the worst first mode, with its lower bound, and at 20 %; nothing at the ground."""
    modes, cap = worked.modes, worked.capacity
    if modes is None:
        return ()
    asked = floor_demand(case.context, modes, T0=cap.T0, T=cap.T, damping=damping)
    T = (symbol, asked.period) if asked.period == cap.T else ("T_d", asked.period)
    first = (FIRST, asked.first)
    return (
        *first_mode_steps(modes, asked.first, FIRST, T, SOFTENED_WORST),
        *peak_steps(case, modes, asked.first, FIRST),
        *ordinate_steps(case, modes, first, T, damping=damping),
        *_demand_steps(case, modes, asked, T, damping=damping),
        *_shown_steps(case, worked, damping=damping),
    )


def _demand_steps(
    case: Case, modes: FirstModes, asked: FloorDemand, T: tuple[str, float], *, damping: float
) -> tuple[Step, ...]:
    scale, (symbol, period), clause = case.pga / case.context.spectrum.pga, T, "C8.7.1.12"
    spectral = ordinate(case.context, modes, asked.first, period, damping=damping) * scale
    given = {f"S_eZ({symbol})": (spectral, "m/s2"), symbol: (period, "s")}
    formula, name = f"S_eZ({symbol}) · ({symbol} / (2 · π))²", f"d({symbol}, Z)"
    line = step(name, "demand of the floor", clause, formula, asked.moved * scale, "m", given=given)
    if asked.least == 0.0:
        return (line,)
    resonant, b = ordinate(case.context, modes, asked.first, asked.first, damping=damping) * scale, PLATEAU[1]
    beside: Given = {f"S_eZ({FIRST})": (resonant, "m/s2"), "b": b, FIRST: (asked.first, "s")}
    words, formula = "no less than this, as the period exceeds b T1'", f"S_eZ({FIRST}) · (b · {FIRST} / (2 · π))²"
    return line, step(f"d(b {FIRST}, Z)", words, clause, formula, asked.least * scale, "m", given=beside)


def _shown_steps(case: Case, worked: Worked, *, damping: float) -> tuple[Step, ...]:
    """Write the floor's demand with 20 % of damping of the building, for comparison."""
    modes, cap = modes_at(case.context, case.state, damping=SHOWN_DAMPING), worked.capacity
    if modes is None or modes.reason:
        return ()
    asked = floor_demand(case.context, modes, T0=cap.T0, T=cap.T, damping=damping)
    moved = asked.largest * case.pga / case.context.spectrum.pga
    at: Given = {FIRST: (asked.first, "s"), "ξ1": SHOWN_DAMPING, "PGA": (case.pga, "m/s2")}
    words = "demand of the floor with ξ1 = 20 %, for comparison"
    return (step("d(20 %)", words, "C8.7.1.2.1.4", "as above, with ξ1 = 0.2", moved, "m", at=at),)
