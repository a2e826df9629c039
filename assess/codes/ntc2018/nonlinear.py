"""Non-linear kinematic check of Circolare 7/2019, C8.7.1.2.1: displacement capacity at SLV or SLC."""

from __future__ import annotations

import numpy as np

from assess.codes.check import Check, Step
from assess.codes.context import Context
from assess.codes.italian.displacement import Answer, displacement_check, ground_step, ratio_step
from assess.codes.italian.edition import Options
from assess.codes.italian.floor import Demands
from assess.codes.italian.kinematic import activation_steps, collapse_step, curve_step
from assess.codes.italian.limit_state import Case, at_each, rated
from assess.codes.ntc2018.clauses import (
    EDITION,
    ULTIMATE,
    Capacity,
    acceleration_demands,
    activation_pga,
    capacity_of,
    displacement_demands,
    floor_ordinate,
    mode_of,
    period_of,
    resonant_displacement,
    uplift,
    worst_period,
)
from assess.codes.ntc2018.linear import demand_steps
from assess.codes.ntc2018.sheet import ordinate_steps, period_steps
from assess.oscillator import Oscillator
from spectra.floor_spectrum import PLATEAU

PROCEDURE = "ntc2018-nonlinear"
CLAUSE = "C8.7.1.2.1"
STATES = tuple(ULTIMATE)


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """d_SLV = 0.4 d0* and d_SLC = 0.6 d0* against the displacements of ground and floor; at least a_g,SLD is stood."""
    checks = at_each(oscillator, context, options.among(STATES), lambda case: _check(case, options))
    return tuple(rated(check, context) for check in checks)


def _check(case: Case, options: Options) -> Check:
    FC, context, damping = options.confidence_factor, case.context, ULTIMATE[case.state].damping
    T0 = period_of(case.branch, context)
    cap = capacity_of(case.branch, state=case.state, mass=case.mass, confidence_factor=FC, T0=T0)
    over_pga = acceleration_demands(context, T0=T0)
    answer = _answer(case, cap, over_pga, displacement_demands(context, T0=T0, T=cap.T, damping=damping), options)
    steps = (
        *activation_steps(case, EDITION, confidence_factor=FC),
        *period_steps(case, T0=T0),
        *demand_steps(case, over_pga, T0=T0, a0=cap.a0),
        *_capacity_steps(case, cap, confidence_factor=FC),
        *_displacement_steps(case, cap, answer),
    )
    rule = context.spectrum.damping_rule
    return displacement_check(case, answer, EDITION, procedure=PROCEDURE, damping=damping, rule=rule, steps=steps)


def _answer(case: Case, cap: Capacity, over_pga: Demands, wanted: Demands | None, options: Options) -> Answer:
    """Below a_g,SLD the element does not rock: it moves elastically with T0, or, rigid, not at all."""
    activated, elastic = activation_pga(cap.a0, over_pga), over_pga.largest * (cap.T0 / (2 * np.pi)) ** 2
    return Answer(
        ultimate=cap.d,
        symbol=f"d_{case.state}",
        collapse=cap.d0,
        e=cap.e,
        period=cap.T,
        period_symbol=f"T_{case.state}",
        wanted=wanted,
        starts=activated if elastic * activated <= cap.d else 0.0,
        still=elastic,
        uplift=uplift(case.branch, case.context, confidence_factor=options.confidence_factor),
    )


def _capacity_steps(case: Case, cap: Capacity, *, confidence_factor: float) -> tuple[Step, ...]:
    state, ultimate = case.state, ULTIMATE[case.state]
    share, root = f"{ultimate.share:g} · {cap.d0:.5g}", f"{ultimate.factor:g} π √({cap.d:.5g} / {cap.a:.5g})"
    formula = f"{ultimate.factor:g} π √(d_{state} / a(d_{state}))"
    symbol, on_curve = f"a(d_{state})", "acceleration on the model's curve"
    words = "displacement capacity; local limits are not modelled"
    return (
        collapse_step(case.branch, CLAUSE, mass=case.mass),
        Step(f"d_{state}", words, CLAUSE, f"{ultimate.share:g} d0*", share, cap.d, "m"),
        curve_step(case, "C8.7.1.3", symbol, on_curve, moved=cap.d, confidence_factor=confidence_factor),
        Step(f"T_{state}", "secant period", ultimate.clause, formula, root, cap.T, "s"),
    )


def _displacement_steps(case: Case, cap: Capacity, answer: Answer) -> tuple[Step, ...]:
    wanted, demanded, spectrum = answer.wanted, answer.demand(case.pga), case.context.spectrum
    if wanted is None or demanded is None:
        return ()
    damping, symbol = ULTIMATE[case.state].damping, f"T_{case.state}"
    T = worst_period(case.context, T0=cap.T0, T=cap.T, damping=damping)
    ordinate = float(spectrum.acceleration(T, damping=damping)) * case.pga / spectrum.pga
    said, at = f"elastic spectrum, {100 * damping:.3g} %", f"T = {T:.5g} s, PGA = {case.pga:.5g} m/s2"
    largest = f"period from T0 to {symbol} of the largest S_De"
    steps = [
        Step("T", largest, CLAUSE, f"T0 ≤ T ≤ {symbol}", f"{cap.T0:.5g} to {cap.T:.5g} s", T, "s"),
        Step("S_e(T)", said, spectrum.clause, "S_e(T, ξ)", at, ordinate, "m/s2"),
        ground_step(case, CLAUSE, "T", T, ordinate=ordinate, moved=wanted.ground * case.pga),
        *ordinate_steps(case, cap.T, symbol, damping=damping),
        *_floor_steps(case, cap, symbol, damping=damping),
    ]
    return (*steps, ratio_step(answer, CLAUSE, demanded=demanded))


def _floor_steps(case: Case, cap: Capacity, symbol: str, *, damping: float) -> tuple[Step, ...]:
    """The demand of the floor, with its lower bound beyond b T1; none at the ground."""
    mode = mode_of(case.context)
    if mode is None:
        return ()
    scale = case.pga / case.context.spectrum.pga
    ordinate, clause = floor_ordinate(case.context, cap.T, damping=damping) * scale, "C8.7.1.12"
    moved, numbers = ordinate * (cap.T / (2 * np.pi)) ** 2, f"{ordinate:.5g} · ({cap.T:.5g} / 2π)²"
    step = Step(
        f"d({symbol}, Z)", "demand of the floor", clause, f"S_eZ({symbol}) ({symbol} / 2π)²", numbers, moved, "m"
    )
    least = resonant_displacement(case.context, cap.T, damping=damping) * scale
    if least == 0.0:
        return (step,)
    resonant, b = floor_ordinate(case.context, mode.period, damping=damping) * scale, PLATEAU[1]
    numbers = f"{resonant:.5g} · ({b:g} · {mode.period:.5g} / 2π)²"
    words = f"no less than this, as {symbol} > b T1"
    return step, Step("d(b T1, Z)", words, clause, "S_eZ(T1) (b T1 / 2π)²", numbers, least, "m")
