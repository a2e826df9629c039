"""NTC 2018 with Circolare 7/2019, C8.7.1.2: the linear, non-linear and dynamic checks of local mechanisms.

Linear: activation at SLD (C8.7.1.2.1.5), and at SLV with q (C8.7.1.2.1.7). Non-linear kinematic: displacement capacity
at SLV or SLC (C8.7.1.2.1.6, .8). Non-linear dynamic: no record beyond d0*, the mean within d_SLV or d_SLC
(C8.7.1.2.1.9).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import Annotated, Literal

import numpy as np

from assess.codes import italian_kinematic as kinematic
from assess.codes import ntc2018_clauses as clauses
from assess.codes.calculation_sheet import Given, Step, step
from assess.codes.check import Check, CodeProcedure, DefaultRun, Family, Premise
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
    Demands,
    ItalianOptions,
    LimitStateCase,
    check_each_limit_state,
)
from assess.codes.toothing import count_side_walls, left_step, toothing_steps, with_side_wall_messages
from assess.declaration import Evidence, Name, PositiveTime, Range, Safe, Several, Tried
from assess.messages.message import Quantity, Term, message
from assess.oscillator import Oscillator
from spectra.damping import ec8_eta
from spectra.floor import PLATEAU

LINEAR_CLAUSES = {"SLD": "C8.7.1.2.1.5", "SLV": "C8.7.1.2.1.7"}


FREE_PERIOD = Evidence(
    "measured",
    "either",
    "the worst from it to none, rigid before it lifts off",
    safe=Range((Tried(Safe.ABSENT, "0 s"),), up_to="rigid"),
)


@dataclass(frozen=True)
class Ntc2018Options(ItalianOptions):
    """Options of the Italian procedure of NTC 2018 with Circolare 7/2019."""

    limit_states: Annotated[
        tuple[Literal["SLD", "SLV", "SLC"], ...], Several(1, unlike="limit state"), FURTHER_STATES
    ] = ("SLV",)
    """limit states to check: "SLD" by ntc2018-linear, "SLC" by ntc2018-nonlinear and -history, "SLV" by all"""
    free_periods: Annotated[Mapping[Name, PositiveTime | clauses.FreeElement], FREE_PERIOD] = field(
        default_factory=dict
    )
    """{ MECHANISM = "0.2 s" }: period before uplift of those that vibrate freely, as parapets and pinnacles do; or in
    place of the period { length, thickness, young_modulus, density, support }"""


def assess_linear(oscillator: Oscillator, context: Context, *, options: ItalianOptions) -> tuple[Check, ...]:
    """Check a0* against the accelerations of ground and floor, S_eZ(T0) of free elements; a_g,SLV = q a_g,SLD."""
    found = check_each_limit_state(
        oscillator,
        count_side_walls(oscillator, context),
        clauses.EDITION,
        options,
        known=NTC2018_LINEAR.limit_states,
        one=lambda case: _linear_check(case, options),
    )
    return tuple(with_side_wall_messages(check, context) for check in found)


NONLINEAR_CLAUSE = "C8.7.1.2.1.8"
SOFTENED_WORST = "first mode, softened by 1.5 to 2.0: that of the largest displacement"
ELASTIC, FIRST, AT_ACTIVATION = "T1", "T1'", "T1'_a"  # of the building: elastic, what asks most of d_LS, and of a0*


def assess_nonlinear(oscillator: Oscillator, context: Context, *, options: ItalianOptions) -> tuple[Check, ...]:
    """Check d_SLV and d_SLC against the displacements of ground and floor; the capacity is at least a_g,SLD."""
    found = check_each_limit_state(
        oscillator,
        count_side_walls(oscillator, context),
        clauses.EDITION,
        options,
        known=NTC2018_NONLINEAR.limit_states,
        one=lambda case: _nonlinear_check(case.at_ultimate),
    )
    return tuple(with_side_wall_messages(check, context) for check in found)


def _acceleration_demand_steps(
    case: LimitStateCase,
    possible: Sequence[clauses.FirstModes],
    over_pga: Demands | None,
    *,
    T0: float,
    a0: float,
) -> tuple[Step, ...]:
    """Write the accelerations of ground and floor, and the PGA a_g,SLD S at which the larger one reaches a0*.

    possible : first modes of the building, of which the most demanding is written
    """
    if over_pga is None:
        return ()
    modes = max(possible, key=lambda each: clauses.floor_acceleration(case.context, each, T0)[1], default=None)
    symbol = ELASTIC if modes is None or modes.shortest == modes.longest else AT_ACTIVATION
    spectrum, free = case.context.spectrum, T0 > 0.0
    ground, floor = ("S_e(T0)" if free else "PGA"), ("S_eZ(T0)" if free else _peak_symbol(symbol))
    given = {"a0*": (a0, "m/s2"), "PGA": (case.pga, "m/s2"), ground: (over_pga.ground * case.pga, "m/s2")}
    steps: list[Step] = []
    if free:
        at: Given = {"T0": (T0, "s"), "ξ": clauses.ELASTIC_DAMPING, "PGA": (case.pga, "m/s2")}
        words, value = "elastic spectrum of the ground", over_pga.ground * case.pga
        steps.append(step(ground, words, spectrum.clause, "S_e(T, ξ)", value, "m/s2", at=at))
    most = ground
    if modes is not None:
        steps += _floor_acceleration_steps(case, modes, T0=T0, symbol=symbol)
        given[floor], most = (over_pga.floor * case.pga, "m/s2"), f"max({ground}, {floor})"
    words, value = "PGA of activation, by the larger of ground and floor", clauses.activation_pga(a0, over_pga)
    clause, formula = "C8.7.1.9" if free else "C8.7.1.8", f"a0* · PGA / {most}"
    return *steps, step("a_g,SLD S", words, clause, formula, value, "m/s2", given=given)


def _floor_acceleration_steps(
    case: LimitStateCase, modes: clauses.FirstModes, *, T0: float, symbol: str
) -> tuple[Step, ...]:
    """Write the floor's acceleration under the most demanding first mode."""
    first, _ = clauses.floor_acceleration(case.context, modes, T0)
    why = "first mode from the elastic to the softest: that of the largest acceleration"
    at = _ordinate_steps(case, modes, (symbol, first), ("T0", T0), damping=clauses.ELASTIC_DAMPING) if T0 > 0.0 else ()
    return (
        *first_mode_steps(modes, first, symbol, ("T0", T0), why),
        *_peak_steps(case, modes, first, symbol),
        *at,
    )


NTC2018_NONLINEAR = CodeProcedure(
    name="ntc2018-nonlinear",
    family=Family.DISPLACEMENT,
    assess=assess_nonlinear,
    title=Term("NTC 2018, non-linear kinematic"),
    short_title=Term("NTC 2018 non-linear"),
    work="ntc2018",
    options="ntc2018",
    limit_states=tuple(clauses.ULTIMATE),
    default_run=DefaultRun(spectra=("ntc2018",)),
    premises=(Premise.SOUND_MASONRY,),
)


@dataclass(frozen=True)
class CapacityAndDemands:
    """Capacity and first modes of one case, and its demands over PGA: of acceleration and of displacement."""

    capacity: clauses.Ntc2018Capacity
    modes: clauses.FirstModes | None
    activation_modes: tuple[clauses.FirstModes, ...]
    acceleration_per_pga: Demands | None
    displacement_per_pga: Demands | None


HISTORY_RULE = HistoryRule(
    procedure="ntc2018-history",
    edition=clauses.EDITION,
    clause="C8.7.1.2.1.9",
    limits={state: ultimate.rule for state, ultimate in clauses.ULTIMATE.items()},
)


def assess_history(oscillator: Oscillator, context: Context, *, options: ItalianOptions) -> tuple[Check, ...]:
    """Return the checks of the suites of time histories against d0* and d_SLV or d_SLC."""
    return assess_histories(oscillator, context, rule=HISTORY_RULE, options=options)


def first_mode_steps(
    modes: clauses.FirstModes, first: float, symbol: str, T: tuple[str, float], why: str
) -> tuple[Step, ...]:
    """Write the most demanding T_1' [s], named `symbol`, for a mechanism of period T, (symbol, value) [s]."""
    if modes.reason:
        stated = "first mode at this limit state"
        return (step(symbol, stated, "C8.7.1.2.1.4", "as stated", first, "s", subject=modes.reason),)
    if modes.shortest == modes.longest:
        return ()
    name, value = T
    for letter, factor in zip("ab", PLATEAU, strict=True):
        if np.isclose(first, value / factor, rtol=1e-12, atol=0.0):
            peak: Given = {name: (value, "s"), letter: factor}
            return (step(symbol, why, "C8.7.1.2.1.4", f"{name} / {letter}", first, "s", given=peak),)
    k: Given = {"k": first / modes.floor.T1, "T1": (modes.floor.T1, "s")}
    return (step(symbol, why, "C8.7.1.2.1.4", "k · T1", first, "s", given=k),)


NTC2018_LINEAR = CodeProcedure(
    name="ntc2018-linear",
    family=Family.LINEAR,
    assess=assess_linear,
    title=Term("NTC 2018, linear kinematic"),
    short_title=Term("NTC 2018 linear"),
    work="ntc2018",
    options="ntc2018",
    limit_states=tuple(LINEAR_CLAUSES),
    default_run=DefaultRun(spectra=("ntc2018",)),
    premises=(Premise.SOUND_MASONRY,),
)


def _linear_check(case: LimitStateCase, options: ItalianOptions) -> Check:
    FC, q = case.confidence.factor, options.behaviour_factor if case.state == "SLV" else 1.0
    context, branch, modes = case.context, case.curves.starting, clauses.elastic_modes(case.context)
    T0 = clauses.period_before_uplift(branch, context)
    possible = () if modes is None else (modes,)
    over_pga = clauses.acceleration_demands(context, possible, T0=T0)
    demands = None if over_pga is None else over_pga.scale(case.pga / q)
    a0 = kinematic.activation(branch, mass=case.curves.mass, confidence_factor=FC)
    return kinematic.acceleration_check(
        case,
        clauses.EDITION,
        procedure=NTC2018_LINEAR.name,
        capacity=a0,
        demands=demands,
        period_needed=Term("T0 or T1 of the building"),
        uplift_pga=clauses.uplift_on_floor(branch, context, confidence_factor=FC),
        damping=clauses.ELASTIC_DAMPING,
        steps=(
            *_toothing_steps(case),
            *kinematic.activation_steps(case, clauses.EDITION),
            *_period_steps(case, T0=T0),
            *_share_steps(case, modes),
            *_acceleration_demand_steps(case, possible, over_pga, T0=T0, a0=a0),
            *_linear_capacity_steps(case, over_pga, a0=a0, q=q),
            *kinematic.acceleration_ratio_steps(LINEAR_CLAUSES[case.state], demands, capacity=a0),
        ),
    )


def _toothing_steps(case: LimitStateCase) -> tuple[Step, ...]:
    """Write the friction of side walls, which holds the wall on its way outwards."""
    toothing = case.context.toothing
    return () if toothing is None or case.curves.name != "positive" else toothing_steps(toothing)


def _linear_capacity_steps(case: LimitStateCase, over_pga: Demands | None, *, a0: float, q: float) -> tuple[Step, ...]:
    if over_pga is None:
        return ()
    clause, largest = LINEAR_CLAUSES[case.state], over_pga.largest * case.pga
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
    activated = clauses.activation_pga(a0, over_pga)
    given: Given = {"q": q, "a_g,SLD S": (activated, "m/s2")}
    return step("a_g,SLV S", "PGA at capacity", clause, "q · a_g,SLD S", q * activated, "m/s2", given=given), demanded


def _nonlinear_check(case: LimitStateCase) -> Check:
    derived = _capacity_and_demands(case)
    cap, analysis = derived.capacity, _displacement_analysis(case, derived)
    steps = (
        *kinematic.activation_steps(case, clauses.EDITION),
        *_period_steps(case, T0=cap.T0),
        *_share_steps(case, derived.modes),
        *_acceleration_demand_steps(case, derived.activation_modes, derived.acceleration_per_pga, T0=cap.T0, a0=cap.a0),
        *_nonlinear_capacity_steps(case, cap),
        *_displacement_steps(case, derived, analysis),
    )
    damping, rule = clauses.ULTIMATE[case.state].damping, case.context.spectrum.damping_rule
    return kinematic.displacement_check(
        case, analysis, clauses.EDITION, procedure=NTC2018_NONLINEAR.name, damping=damping, rule=rule, steps=steps
    )


def _capacity_and_demands(case: LimitStateCase) -> CapacityAndDemands:
    context, T0 = case.context, clauses.period_before_uplift(case.curves.starting, case.context)
    modes, damping = clauses.ultimate_modes(context, case.state), clauses.ULTIMATE[case.state].damping
    cap = clauses.capacity_of(case.curves, state=case.state, confidence_factor=case.confidence.factor, T0=T0)
    per_pga = clauses.displacement_demands(context, modes, T0=T0, T=cap.T, damping=damping)
    activation = clauses.activation_modes(context, case.state)
    over_pga = clauses.acceleration_demands(context, activation, T0=T0)
    return CapacityAndDemands(cap, modes, activation, over_pga, per_pga)


def _displacement_analysis(case: LimitStateCase, derived: CapacityAndDemands) -> kinematic.DisplacementAnalysis:
    """Return capacity and demand: below a_g,SLD the element moves elastically with T0, or, if rigid, not at all."""
    cap, over_pga = derived.capacity, derived.acceleration_per_pga
    if over_pga is None:
        activated = elastic = 0.0
    else:
        activated, elastic = clauses.activation_pga(cap.a0, over_pga), over_pga.largest * (cap.T0 / (2 * np.pi)) ** 2
    symbol, longest = f"T_{case.state}", clauses.longest_period_used(derived.modes, cap.T)
    at = Quantity(longest, "time")
    return kinematic.DisplacementAnalysis(
        ultimate_displacement=cap.d,
        symbol=f"d_{case.state}",
        collapse_displacement=cap.d0,
        participation_ratio=cap.e,
        period_needed=message("period-of" if longest == cap.T else "period-or-floor", {"symbol": symbol, "period": at}),
        demand_per_pga=derived.displacement_per_pga,
        activation_pga=activated if elastic * activated <= cap.d else 0.0,
        elastic_displacement_per_pga=elastic,
        uplift_pga=clauses.uplift_on_floor(
            case.curves.starting, case.context, confidence_factor=case.confidence.factor
        ),
        conditions=(
            *kinematic.break_conditions(case.curves),
            *(kinematic.seat_conditions(case.context, case.curves, case.state, cap.d) if case.state == "SLV" else ()),
        ),
    )


def _nonlinear_capacity_steps(case: LimitStateCase, cap: clauses.Ntc2018Capacity) -> tuple[Step, ...]:
    state, ultimate = case.state, clauses.ULTIMATE[case.state]
    d, a = f"d_{state}", f"a(d_{state})"
    curve = kinematic.curve_steps(
        case, "C8.7.1.3", a, "acceleration with actions that have not ended", moved=cap.d, argument=d
    )
    if cap.T0 > 0.0 and cap.a < curve[-1].value:  # type: ignore[operator]
        given = {d: (cap.d, "m"), "T0": (cap.T0, "s")}
        words, formula = "acceleration on the elastic branch", f"{d} · (2 · π / T0)²"
        curve = (step(a, words, "C8.7.1.6", formula, cap.a, "m/s2", given=given),)
    elif (friction := _toothing_steps(case)) and case.context.toothing is not None:
        left = left_step(case.context.toothing, curve[0].value or 0.0, argument=f"φ({d})")
        curve = (*friction, left, *curve)
    formula, given = f"{cap.factor:g} · π · √({d} / {a})", {d: (cap.d, "m"), a: (cap.a, "m/s2")}
    return (
        *kinematic.displacement_capacity_steps(
            case.curves, cap.displacements, ultimate.rule, d, "displacement capacity"
        ),
        *curve,
        step(f"T_{state}", "secant period", ultimate.clause, formula, cap.T, "s", given=given),
    )


def _displacement_steps(
    case: LimitStateCase, derived: CapacityAndDemands, analysis: kinematic.DisplacementAnalysis
) -> tuple[Step, ...]:
    per_pga, demand, spectrum = analysis.demand_per_pga, analysis.demand(case.pga), case.context.spectrum
    if per_pga is None or demand is None:
        return ()
    cap, damping, symbol = derived.capacity, clauses.ULTIMATE[case.state].damping, f"T_{case.state}"
    T = clauses.ground_period(case.context, T0=cap.T0, T=cap.T, damping=damping)
    spectral = float(spectrum.acceleration(T, damping=damping)) * case.pga / spectrum.pga
    ordinate_words = "elastic spectrum, damped as the mechanism"
    at: Given = {"T": (T, "s"), "ξ": damping, "PGA": (case.pga, "m/s2")}
    period_words = "period from T0 to the secant one of the largest S_De"
    between: Given = {"T0": (cap.T0, "s"), symbol: (cap.T, "s")}
    steps = [
        step("T", period_words, NONLINEAR_CLAUSE, "T0 ≤ T ≤ T_LS", T, "s", at=between),
        step("S_e(T)", ordinate_words, spectrum.clause, "S_e(T, ξ)", spectral, "m/s2", at=at),
        kinematic.ground_step(case, NONLINEAR_CLAUSE, "T", T, ordinate=spectral, moved=per_pga.ground * case.pga),
        *_floor_displacement_steps(case, derived, symbol, damping=damping),
    ]
    return (*steps, kinematic.displacement_ratio_step(analysis, NONLINEAR_CLAUSE, demand=demand))


def _floor_displacement_steps(
    case: LimitStateCase, derived: CapacityAndDemands, symbol: str, *, damping: float
) -> tuple[Step, ...]:
    """Write the floor's demand under the worst first mode, with its lower bound, and at 20 %; nothing at the ground."""
    modes, cap = derived.modes, derived.capacity
    if modes is None:
        return ()
    demand = clauses.floor_demand(case.context, modes, T0=cap.T0, T=cap.T, damping=damping)
    T = (symbol, demand.period) if demand.period == cap.T else ("T_d", demand.period)
    first = (FIRST, demand.first)
    return (
        *first_mode_steps(modes, demand.first, FIRST, T, SOFTENED_WORST),
        *_peak_steps(case, modes, demand.first, FIRST),
        *_ordinate_steps(case, modes, first, T, damping=damping),
        *_floor_demand_steps(case, modes, demand, T, damping=damping),
        *_comparison_damping_steps(case, derived, damping=damping),
    )


def _floor_demand_steps(
    case: LimitStateCase,
    modes: clauses.FirstModes,
    demand: clauses.FloorDemand,
    T: tuple[str, float],
    *,
    damping: float,
) -> tuple[Step, ...]:
    scale, (symbol, period), clause = case.pga / case.context.spectrum.pga, T, "C8.7.1.12"
    spectral = clauses.floor_ordinate(case.context, modes, demand.first, period, damping=damping) * scale
    given = {f"S_eZ({symbol})": (spectral, "m/s2"), symbol: (period, "s")}
    formula, name = f"S_eZ({symbol}) · ({symbol} / (2 · π))²", f"d({symbol}, Z)"
    line = step(name, "demand of the floor", clause, formula, demand.displacement * scale, "m", given=given)
    if demand.least == 0.0:
        return (line,)
    resonant, b = (
        clauses.floor_ordinate(case.context, modes, demand.first, demand.first, damping=damping) * scale,
        PLATEAU[1],
    )
    beside: Given = {f"S_eZ({FIRST})": (resonant, "m/s2"), "b": b, FIRST: (demand.first, "s")}
    words, formula = "no less than this, as the period exceeds b T1'", f"S_eZ({FIRST}) · (b · {FIRST} / (2 · π))²"
    return line, step(f"d(b {FIRST}, Z)", words, clause, formula, demand.least * scale, "m", given=beside)


def _comparison_damping_steps(case: LimitStateCase, derived: CapacityAndDemands, *, damping: float) -> tuple[Step, ...]:
    """Write the floor's demand with 20 % of damping of the building, for comparison."""
    modes, cap = clauses.ultimate_modes(case.context, case.state, damping=clauses.COMPARISON_DAMPING), derived.capacity
    if modes is None or modes.reason:
        return ()
    demand = clauses.floor_demand(case.context, modes, T0=cap.T0, T=cap.T, damping=damping)
    moved = demand.largest * case.pga / case.context.spectrum.pga
    at: Given = {FIRST: (demand.first, "s"), "ξ1": clauses.COMPARISON_DAMPING, "PGA": (case.pga, "m/s2")}
    words = "demand of the floor with ξ1 = 20 %, for comparison"
    return (step("d(20 %)", words, "C8.7.1.2.1.4", "as above, with ξ1 = 0.2", moved, "m", at=at),)


NTC2018_HISTORY = CodeProcedure(
    name=HISTORY_RULE.procedure,
    family=Family.HISTORY,
    assess=assess_history,
    title=Term("NTC 2018, response history"),
    short_title=Term("NTC 2018 history"),
    work="ntc2018",
    options="ntc2018",
    limit_states=tuple(HISTORY_RULE.limits),
    default_run=DefaultRun(spectra=("ntc2018",)),
    suite_rules="ntc2018",
    history_rules=partial(history_rules, rule=HISTORY_RULE),
    required_pga=partial(required_pga, rule=HISTORY_RULE),
    premises=(Premise.SOUND_MASONRY,),
    buildings=SOFTENING_BUILDING,
    building_clause=SOFTENING_CLAUSE,
)


def _period_steps(case: LimitStateCase, *, T0: float) -> tuple[Step, ...]:
    """Write T0 of an element that vibrates before it lifts off."""
    if T0 == 0.0:
        return ()
    given, words = case.context.free_period, "period before uplift"
    if given is not None:
        return (step("T0", words, "C8.7.1.7", given.formula, T0, "s", given=given.inputs, remark=given.remark),)
    return (step("T0", words, "C8.7.1.6", "1 / f", T0, "s", given={"f": (1.0 / T0, "Hz")}),)


def _share_steps(case: LimitStateCase, modes: clauses.FirstModes | None) -> tuple[Step, ...]:
    """Write gamma psi of the floor and the elastic first mode; nothing at the ground."""
    building = case.context.building
    if modes is None or building is None:
        return ()
    Z, H = (modes.floor.psi * building.height, "m"), (building.height, "m")
    given: Given = {"N": float(building.storeys or 0), "Z": Z, "H": H}
    words = "share of the first mode at Z, N storeys"
    mode = "first mode of the building, elastic"
    return (
        step("γψ", words, "C7.2.10", "3 · N · Z / ((2 · N + 1) · H)", modes.share, given=given),
        step("T1", mode, "C7.2.3", "[building] period", modes.floor.T1, "s", remark="given, or 0.05 H^0.75"),
    )


def _peak_steps(case: LimitStateCase, modes: clauses.FirstModes, first: float, symbol: str) -> tuple[Step, ...]:
    """Write S_e(T1, xi1) and a_Z of the floor under the first mode of period `first` [s], named `symbol`."""
    spectrum = case.context.spectrum
    scale, xi = case.pga / spectrum.pga, modes.damping
    spectral = float(spectrum.acceleration(first, damping=xi)) * scale
    peak, name = clauses.peak_acceleration(case.context, modes, first) * scale, f"S_e({symbol})"
    at: Given = {symbol: (first, "s"), "ξ1": xi, "PGA": (case.pga, "m/s2")}
    given: Given = {name: (spectral, "m/s2"), "γψ": modes.share, "ξ1": xi}
    words = "peak acceleration of the floor, first mode; ξ1 as ratio"
    return (
        step(name, "elastic spectrum at the first mode", spectrum.clause, "S_e(T, ξ1)", spectral, "m/s2", at=at),
        step(
            _peak_symbol(symbol), words, "C7.2.7, C7.2.8", f"{name} · γψ · √(1 + (2 · ξ1)²)", peak, "m/s2", given=given
        ),
    )


def _peak_symbol(first: str) -> str:
    """Return the symbol of a_Z under the first mode named `first`."""
    return f"a_Z({first})"


def _ordinate_steps(
    case: LimitStateCase, modes: clauses.FirstModes, first: tuple[str, float], T: tuple[str, float], *, damping: float
) -> tuple[Step, ...]:
    """Write A and the ordinate of the floor spectrum at T under T_1', both (symbol, value) [s]."""
    spectrum, (symbol, period), (name, building) = case.context.spectrum, T, first
    scale, eta = case.pga / spectrum.pga, ec8_eta(damping)
    peak = clauses.peak_acceleration(case.context, modes, building) * scale
    A = max(1.1 / np.sqrt(modes.damping) * eta, 1.0)
    value = clauses.floor_ordinate(case.context, modes, building, period, damping=damping) * scale
    formula, given = _ordinate_formula(symbol, period, name, building)
    given = {"A": A, _peak_symbol(name): (peak, "m/s2"), **given}
    if period > building:
        ground = float(spectrum.acceleration(period, damping=damping)) * scale
        formula, given = f"max({formula}, S_e({symbol}))", {**given, f"S_e({symbol})": (ground, "m/s2")}
    words, of_A = "floor spectrum, damped as the mechanism", {"η": eta, "ξ1": modes.damping}
    return (
        step("A", "resonance; ξ1 as ratio", "C7.2.6", "max(1.1 · η / √(ξ1), 1)", float(A), given=of_A),
        step(f"S_eZ({symbol})", words, "C7.2.5, C7.2.6", formula, value, "m/s2", given=given),
    )


def _ordinate_formula(
    symbol: str, period: float, name: str, first: float
) -> tuple[str, dict[str, float | tuple[float, str]]]:
    """Return the formula of C7.2.6 on the stretch where a period lies, and its inputs besides A and a_Z."""
    (a, b), peak = PLATEAU, _peak_symbol(name)
    given: dict[str, float | tuple[float, str]] = {symbol: (period, "s"), name: (first, "s")}
    if period < a * first:
        return f"A · {peak} / (1 + (A − 1) · (1 − {symbol} / (a · {name}))^1.6)", {**given, "a": a}
    if period <= b * first * (1.0 + 1e-12):
        return f"A · {peak}", {}
    return f"A · {peak} / (1 + (A − 1) · ({symbol} / (b · {name}) − 1)^1.2)", {**given, "b": b}
