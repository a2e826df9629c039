"""Kinematic analysis by either Italian edition: its linear and non-linear check, and the curve both are read from.

The equivalent oscillator is the same in both circulars: a* = alpha g / (e* FC) over d*. alpha(d) is the curve of
lambda = restoring / (g B) of the mechanism; displacements are those of the control point over e*. The linear check
compares a0* with the accelerations of ground and floor, the non-linear one the displacement capacity with the spectral
demand at a secant period. A capacity d_LS is a share of d0*, or less where a tie breaks or a seat is lost before. A
break limits where it takes more than half of the largest acceleration that the mechanism has; after a smaller loss the
curve goes on without the element. Rotations of both become spectral displacements by C8.7.1.4.
Source: Circolare 617/2009, C8A.4.1-2; 7/2019, C8.7.1.1-C8.7.1.5, C8.7.1.2.1.6.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import isclose, pi

import numpy as np

from assess.codes.calculation_sheet import (
    Given,
    Step,
    excitation_column,
    instability_step,
    integral_step,
    moment_column,
    multiplier_step,
    reading_step,
    step,
)
from assess.codes.check import Check, Outcome, PgaCurve, Reason, caveats_of, reason_message
from assess.codes.context import Context
from assess.codes.italian_limit_states import (
    BranchCurves,
    Demands,
    ItalianEdition,
    LimitStateCase,
    confidence_step,
    floor_of,
    outcome_of,
)
from assess.codes.pga_rotation import pga_rotation, to_pga_curve
from assess.messages.message import Message, Quantity, Severity, Term, Value, list_values, message
from assess.oscillator import (
    Branch,
    LocalLimit,
    displacement,
    linear_multiplier,
    multiplier,
    participation_ratio,
    threshold,
)
from spectra.arrays import FloatArray
from spectra.gravity import g


def acceleration_check(
    case: LimitStateCase,
    edition: ItalianEdition,
    *,
    procedure: str,
    capacity: float,
    demands: Demands | None,
    period_needed: Term,
    uplift_pga: float | None,
    damping: float,
    steps: tuple[Step, ...],
) -> Check:
    """Make the check of a0* against the larger of the demands.

    Parameters
    ----------
    case : branch, limit state and level
    edition : how it is cited
    procedure : its name
    capacity : a0* [m/s2]
    demands : [m/s2]; None where the spectrum ends before a period that is needed, `period_needed`
    uplift_pga : PGA at uplift [m/s2]
    damping : of the demand [-]
    steps : the calculation sheet

    Returns
    -------
    Check
    """
    demand = None if demands is None else demands.largest
    verdict, reason = _acceleration_outcome(case, demand, capacity, period_needed=period_needed)
    return Check(
        procedure=procedure,
        edition=edition.name,
        branch=case.curves.name,
        limit_state=case.state,
        level_pga_g=case.level / g,
        input_at="ground" if floor_of(case.context) is None else "mechanism base",
        damping=damping,
        quantity="acceleration",
        unit="m/s2",
        demand=demand,
        capacity=capacity,
        ratio=None if demand is None else demand / capacity,
        verdict=verdict,
        reason=reason,
        capacity_pga_g=None if demand is None else case.pga * capacity / demand / g,
        uplift_pga_g=None if uplift_pga is None else uplift_pga / g,
        steps=steps,
        **caveats_of(edition.caveat),
        conditions=_acceleration_conditions(case) if verdict == Outcome.PASS else (),
    )


def acceleration_ratio_steps(clause: str, demands: Demands | None, *, capacity: float) -> tuple[Step, ...]:
    """Write the last line of the sheet."""
    if demands is None:
        return ()
    given = {"D": (demands.largest, "m/s2"), "a0*": (capacity, "m/s2")}
    return (step("D / a0*", "ratio", clause, "D / a0*", demands.largest / capacity, given=given),)


@dataclass(frozen=True)
class DisplacementAnalysis:
    """Capacity and demand of one case, as an edition finds them; displacements are spectral, d*.

    ultimate_displacement : capacity [m], written `symbol`; collapse_displacement : d0* [m]
    participation_ratio : e* [-]
    demand_per_pga : displacement for each m/s2 of PGA [s2]; None where the spectrum ends too early for it
    period_needed : the longest period at which the spectrum is read
    activation_pga : PGA up to which the mechanism does not rock [m/s2]
    elastic_displacement_per_pga : its displacement until then, for each m/s2 of PGA [s2]
    uplift_pga : PGA at uplift [m/s2]; None on joints without a threshold
    conditions : what a pass rests on
    """

    ultimate_displacement: float
    symbol: str
    collapse_displacement: float
    participation_ratio: float
    demand_per_pga: Demands | None
    period_needed: Message
    activation_pga: float
    elastic_displacement_per_pga: float
    uplift_pga: float | None
    conditions: tuple[Message, ...] = ()

    @property
    def activation_displacement(self) -> float:
        """Displacement at which the mechanism begins to rock [m]."""
        return self.activation_pga * self.elastic_displacement_per_pga

    def demand(self, pga: float) -> float | None:
        """Return d* [m] at `pga` [m/s2], rocking no less than before; None where the spectrum ends too early."""
        if self.demand_per_pga is None:
            return None
        if pga <= self.activation_pga:
            return pga * self.elastic_displacement_per_pga
        return max(pga * self.demand_per_pga.largest, self.activation_displacement)


def displacement_check(
    case: LimitStateCase,
    analysis: DisplacementAnalysis,
    edition: ItalianEdition,
    *,
    procedure: str,
    damping: float,
    rule: str,
    steps: tuple[Step, ...],
) -> Check:
    """Make the check of one case; damping [-] of the demand, by the spectrum's `rule`."""
    branch, mass, demand = case.curves.lasting, case.curves.mass, analysis.demand(case.pga)
    rotation = None
    if demand is not None and demand < analysis.collapse_displacement:
        rotation = rotation_at(branch, demand * analysis.participation_ratio, mass=mass)
    allowable = rotation_at(branch, analysis.ultimate_displacement * analysis.participation_ratio, mass=mass)
    verdict, reason = _displacement_outcome(case, analysis, demand)
    per_pga = analysis.demand_per_pga
    return Check(
        procedure=procedure,
        edition=edition.name,
        branch=case.curves.name,
        limit_state=case.state,
        level_pga_g=case.level / g,
        input_at="ground" if per_pga is None else per_pga.input_at,
        damping=damping,
        damping_rule=rule,
        quantity="d*",
        unit="m",
        demand=demand,
        capacity=analysis.ultimate_displacement,
        ratio=None if demand is None else demand / analysis.ultimate_displacement,
        verdict=verdict,
        reason=reason,
        capacity_pga_g=None
        if per_pga is None
        else max(analysis.ultimate_displacement / per_pga.largest, analysis.activation_pga) / g,
        uplift_pga_g=None if analysis.uplift_pga is None else analysis.uplift_pga / g,
        capacity_rotation_ratio=allowable / branch.overturning,
        rotation_ratio=None if rotation is None else rotation / branch.overturning,
        pga_curve=_displacement_pga_curve(case, analysis),
        steps=steps,
        conditions=analysis.conditions,
        **caveats_of(edition.caveat),
    )


def ground_step(
    case: LimitStateCase, clause: str, symbol: str, period: float, *, ordinate: float, moved: float
) -> Step:
    """Write S_De at a period [s] named `symbol`, from S_e [m/s2] or from the code's own displacements beyond T_E."""
    words, name, spectral = "demand at the ground", f"S_De({symbol})", f"S_e({symbol})"
    if isclose(moved, ordinate * (period / (2 * pi)) ** 2, rel_tol=1e-9):
        given = {spectral: (ordinate, "m/s2"), symbol: (period, "s")}
        return step(name, words, clause, f"{spectral} · ({symbol} / (2 · π))²", moved, "m", given=given)
    at = {symbol: (period, "s"), "PGA": (case.pga, "m/s2")}
    return step(name, words, case.context.spectrum.clause, "displacement spectrum, T > T_E", moved, "m", at=at)


def displacement_ratio_step(analysis: DisplacementAnalysis, clause: str, *, demand: float) -> Step:
    """Write the last line of the sheet."""
    rising = "no less than as it begins to rock" if demand == analysis.activation_displacement else ""
    remark = rising if demand else "no motion below uplift"
    symbol, given = (
        f"D / {analysis.symbol}",
        {"D": (demand, "m"), analysis.symbol: (analysis.ultimate_displacement, "m")},
    )
    return step(symbol, "ratio", clause, symbol, demand / analysis.ultimate_displacement, given=given, remark=remark)


LOSS = 0.5  # of the largest acceleration capacity


@dataclass(frozen=True)
class DisplacementLimit:
    """What a limit state allows: its share of d0* [-], whether breaks limit it besides seats, and the clause."""

    share: float
    breaks: bool
    clause: str


@dataclass(frozen=True)
class LocalDisplacement:
    """A local limit that counts: its displacement [m], and for a break lambda just after and the largest lambda [-]."""

    limit: LocalLimit
    displacement: float
    after: float = 0.0
    largest: float = 0.0


@dataclass(frozen=True)
class DisplacementCapacity:
    """d_LS and d0* [m], and the local limits that count."""

    displacement: float
    collapse: float
    local_limits: tuple[LocalDisplacement, ...]


def displacement_capacity(curves: BranchCurves, limit: DisplacementLimit) -> DisplacementCapacity:
    """Return the displacement capacity of one branch: the least of the share of d0*, the breaks and the seats.

    Parameters
    ----------
    curves : the branch by the actions in it, with its local limits
    limit : of the limit state

    Returns
    -------
    DisplacementCapacity
    """
    collapse = displacement_at_collapse(curves.lasting, mass=curves.mass)
    found = tuple(_local_displacements(curves, limit))
    return DisplacementCapacity(min([limit.share * collapse, *(each.displacement for each in found)]), collapse, found)


def displacement_capacity_steps(
    curves: BranchCurves, capacity: DisplacementCapacity, limit: DisplacementLimit, symbol: str, words: str
) -> tuple[Step, ...]:
    """Write d0*, the local limits that count, and d_LS named `symbol`."""
    steps = [*collapse_steps(curves.lasting, limit.clause, mass=curves.mass)]
    terms, given = [f"{limit.share:g} · d0*"], {"d0*": (capacity.collapse, "m")}
    for number, each in enumerate(capacity.local_limits, 1):
        name = f"d_{each.limit.kind}{number}"
        steps += _local_steps(curves, each, name, limit.clause)
        terms.append(name)
        given[name] = (each.displacement, "m")
    formula = terms[0] if len(terms) == 1 else f"min({', '.join(terms)})"
    return *steps, step(symbol, words, limit.clause, formula, capacity.displacement, "m", given=given)


def break_conditions(curves: BranchCurves) -> tuple[Message, ...]:
    """Return the condition of a pass where a tie or force is counted up to a displacement: that it lasts until then."""
    what = ", ".join(dict.fromkeys(each.what for each in curves.limits if each.kind == "break"))
    return (message("holds-to-its-end", {"what": what}, severity=Severity.WARNING),) if what else ()


def seat_conditions(context: Context, curves: BranchCurves, state: str, moved: float) -> tuple[Message, ...]:
    """Return the condition of a pass where floors or beams rest on the mechanism and their seats are not given.

    A point above the centre of the masses moves more than it, so that each seat has a movement of its own; of two
    branches the larger at the same rotation counts.

    Parameters
    ----------
    context : of the mechanism
    curves : of the branch
    state : limit state
    moved : displacement capacity d* [m]
    """
    e = participation_ratio(curves.lasting, mass=curves.mass)
    rotation = rotation_at(curves.lasting, moved * e, mass=curves.mass)
    travels: dict[str, float] = {}
    for seat in context.open_seats:
        travel = float(np.interp(rotation, seat.rotation, seat.travel))
        travels[seat.what] = max(travel, travels.get(seat.what, 0.0))
    if not travels:
        return ()
    seats = [message("seat-travel", {"what": what, "moved": Quantity(far, "length")}) for what, far in travels.items()]
    values: dict[str, Value] = {"state": state, "seats": list_values(*seats)}
    return (message("seats-hold", values, severity=Severity.WARNING),)


BEFORE_BREAK = 1e-9
"""Of a rotation at which an action ends: just before it, where the curve has a jump."""


def activation(branch: Branch, *, mass: float, confidence_factor: float) -> float:
    """Return the acceleration of activation a0* = alpha0 g / (e* FC) (C8.7.1.3).

    Parameters
    ----------
    branch : with every action at rest
    mass : total moved mass [kg]
    confidence_factor : FC [-]

    Returns
    -------
    float [m/s2]
    """
    return linear_multiplier(branch) * g / (participation_ratio(branch, mass=mass) * confidence_factor)


def displacement_at_collapse(branch: Branch, *, mass: float) -> float:
    """Return d0* [m], where the multiplier of the model's own curve falls to zero."""
    return displacement_at(branch, branch.unstable, mass=mass)


def displacement_at(branch: Branch, rotation: float, *, mass: float) -> float:
    """Return the spectral displacement d* at a rotation (C8.7.1.4).

    Parameters
    ----------
    branch : the direction of rocking
    rotation : phi [rad]
    mass : total moved mass [kg]

    Returns
    -------
    float [m]
    """
    moved = float(displacement(branch, np.array(rotation), mass=mass))
    return moved / participation_ratio(branch, mass=mass)


def rotation_at(branch: Branch, moved: float, *, mass: float) -> float:
    """Return the rotation at which the control point has moved by a displacement, up to the overturning rotation.

    Parameters
    ----------
    branch : the direction of rocking
    moved : displacement of the control point, e* d* [m]
    mass : total moved mass [kg]

    Returns
    -------
    float [rad]
    """
    integral = branch.excitation_integral
    from scipy.optimize import brentq

    return float(brentq(lambda phi: float(integral(phi)) / mass - moved, 0.0, branch.unstable, xtol=1e-15))


def multiplier_at(branch: Branch, rotation: float) -> float:
    """Return lambda [-] of the model's own curve at a rotation [rad]."""
    return float(branch.restoring_spline(rotation)) / float(branch.excitation_spline(rotation)) / g


def acceleration_at(branch: Branch, moved: float, *, mass: float, confidence_factor: float) -> float:
    """Return a* at a displacement d*, on the model's own curve, just before an action that ends there (C8.7.1.3).

    Parameters
    ----------
    branch : with the actions that have not ended
    moved : d* [m]
    mass : total moved mass [kg]
    confidence_factor : FC [-]

    Returns
    -------
    float [m/s2]
    """
    e = participation_ratio(branch, mass=mass)
    rotation = rotation_at(branch, moved * e, mass=mass) * (1.0 - BEFORE_BREAK)
    return multiplier_at(branch, rotation) * g / (e * confidence_factor)


def uplift_pga(branch: Branch, *, confidence_factor: float, amplified: float) -> float | None:
    """Return the PGA at uplift: lambda g / FC over the amplification of the ground by the floor.

    Parameters
    ----------
    branch : with every action at rest
    confidence_factor : FC [-]
    amplified : floor over ground [-]; counts from 1 on

    Returns
    -------
    PGA [m/s2]; None on joints without a threshold of uplift.
    """
    at_rest = threshold(branch)
    return None if at_rest is None else at_rest * g / confidence_factor / max(1.0, amplified)


def activation_steps(case: LimitStateCase, edition: ItalianEdition) -> tuple[Step, ...]:
    """Write the PGA, alpha0, e*, FC and a0*."""
    branch, mass, FC = case.curves.starting, case.curves.mass, case.confidence.factor
    e, moved = participation_ratio(branch, mass=mass), "(Σ m δx)² / (M · Σ m δx²)"
    shares: Given = {
        "Σ m δx": (float(branch.excitation[0]), "kg m"),
        "M": (mass, "kg"),
        "Σ m δx²": (float(branch.participation[0]), "kg m2"),
    }
    a0, given = (
        activation(branch, mass=mass, confidence_factor=FC),
        {"α0": linear_multiplier(branch), "e*": e, "FC": FC},
    )
    return (
        case.pga_step,
        multiplier_step("α0", "multiplier that starts the mechanism", edition.multiplier, branch),
        step("e*", "fraction of participating mass", edition.oscillator, moved, e, given=shares),
        confidence_step(case.confidence, edition),
        step("a0*", "acceleration of activation", edition.oscillator, "α0 · g / (e* · FC)", a0, "m/s2", given=given),
    )


def collapse_steps(branch: Branch, clause: str, *, mass: float) -> tuple[Step, ...]:
    """Write phi_ov, the integral of B up to there, and d0*."""
    falls = "rotation where the restoring moment falls to zero, with only actions shown to last"
    words, end = "displacement where a* = 0, with only actions shown to last", branch.unstable
    return (
        instability_step("φ_ov", falls, clause, branch),
        *displacement_steps("d0*", words, clause, branch, mass=mass, rotation=end, upper="φ_ov"),
    )


def displacement_steps(
    symbol: str,
    words: str,
    clause: str,
    branch: Branch,
    *,
    mass: float,
    rotation: float,
    upper: str = "φ",
    subject: str = "",
) -> tuple[Step, ...]:
    """Write the spectral displacement d* at a rotation, with the integral of B up to there.

    Parameters
    ----------
    symbol, words, clause : of d*
    branch : the direction of rocking
    mass : total moved mass [kg]
    rotation : [rad], written `upper`
    subject : the load that ends there
    """
    e, moved = participation_ratio(branch, mass=mass), displacement_at(branch, rotation, mass=mass)
    integral = moved * e * mass
    given: Given = {"∫ B dφ": (integral, "kg m"), "M": (mass, "kg"), "e*": e}
    along = integral_step(
        "∫ B dφ", "excitation over rotation", clause, excitation_column(branch), rotation, "kg m", upper=upper
    )
    return (
        replace(along, value=integral, subject=subject),
        step(symbol, words, clause, "∫ B dφ / (M · e*)", moved, "m", given=given, subject=subject),
    )


def curve_steps(
    case: LimitStateCase, clause: str, symbol: str, words: str, *, moved: float, argument: str
) -> tuple[Step, ...]:
    """Write a* at the displacement d* = `moved` [m], named `argument`, with phi and lambda where the curve is read."""
    branch, mass, FC = case.curves.breaking, case.curves.mass, case.confidence.factor
    e = participation_ratio(branch, mass=mass)
    rotation = rotation_at(branch, moved * e, mass=mass)
    a = acceleration_at(branch, moved, mass=mass, confidence_factor=FC)
    phi, lam = f"φ({argument})", a * e * FC / g
    at: Given = {argument: (moved, "m"), "M": (mass, "kg"), "e*": e}
    before = rotation * (1.0 - BEFORE_BREAK)
    moment = reading_step("R", "restoring moment there", clause, moment_column(branch), before, argument=phi)
    excitation = reading_step("B", "excitation there", clause, excitation_column(branch), before, argument=phi)
    ratio: Given = {"R": (moment.value or 0.0, "N m"), "B": (excitation.value or 0.0, "kg m")}
    given = {"λ": lam, "e*": e, "FC": FC}
    return (
        step(phi, "rotation at which d* is reached", clause, "∫ B dφ = d* M e*", rotation, "rad", at=at),
        moment,
        excitation,
        step("λ", "multiplier there", clause, "R / (g · B)", lam, given=ratio),
        step(symbol, words, clause, "λ · g / (e* · FC)", a, "m/s2", given=given),
    )


def _acceleration_conditions(case: LimitStateCase) -> tuple[Message, ...]:
    """Return the condition of a pass where the multiplier counts actions that are not shown to last."""
    same = linear_multiplier(case.curves.starting) <= linear_multiplier(case.curves.lasting) * (1.0 + 1e-9)
    if same or not case.context.actions:
        return ()
    return (message("counts-at-rest", severity=Severity.WARNING),)


def _acceleration_outcome(
    case: LimitStateCase, demand: float | None, capacity: float, *, period_needed: Term
) -> tuple[Outcome, Message]:
    if demand is None:
        end = Quantity(case.context.spectrum.longest_period, "time")
        return Outcome.NOT_ANSWERED, reason_message(Reason.SPECTRUM_TOO_SHORT, period=period_needed, end=end)
    verdict = outcome_of(demand / capacity)
    return verdict, reason_message(Reason.WITHIN if verdict == Outcome.PASS else Reason.BEYOND, capacity="a0*")


def _displacement_pga_curve(case: LimitStateCase, analysis: DisplacementAnalysis) -> PgaCurve:
    """Return PGA over rotation: the demand is proportional to PGA, as the period does not change with it."""
    per_pga, branch = analysis.demand_per_pga, case.curves.lasting
    if per_pga is None:
        return PgaCurve((), ())

    def pga_of(rotation: FloatArray) -> FloatArray:
        return displacement(branch, rotation, mass=case.curves.mass) / (analysis.participation_ratio * per_pga.largest)

    return to_pga_curve(pga_rotation(pga_of, overturning=branch.unstable, uplift=analysis.activation_pga), branch)


def _displacement_outcome(
    case: LimitStateCase, analysis: DisplacementAnalysis, demand: float | None
) -> tuple[Outcome, Message]:
    if demand is None:
        end = Quantity(case.context.spectrum.longest_period, "time")
        return Outcome.NOT_ANSWERED, reason_message(Reason.SPECTRUM_TOO_SHORT, period=analysis.period_needed, end=end)
    if demand == 0.0:
        return Outcome.PASS, reason_message(Reason.NO_ROCKING)
    verdict = outcome_of(demand / analysis.ultimate_displacement)
    return verdict, reason_message(
        Reason.WITHIN if verdict == Outcome.PASS else Reason.BEYOND, capacity=analysis.symbol
    )


def _local_displacements(curves: BranchCurves, limit: DisplacementLimit) -> Iterator[LocalDisplacement]:
    for local in curves.limits:
        displacement = displacement_at(curves.lasting, local.rotation, mass=curves.mass)
        if local.kind == "seat":
            yield LocalDisplacement(local, displacement)
        elif limit.breaks:
            after, largest = _multipliers_at_break(curves.breaking, local.rotation)
            if after < LOSS * largest:
                yield LocalDisplacement(local, displacement, after, largest)


def _multipliers_at_break(branch: Branch, rotation: float) -> tuple[float, float]:
    """Return lambda just after a rotation [rad], 0 beyond the end of the table, and the largest of the curve [-]."""
    standing = branch.rotation <= branch.unstable
    beyond = rotation * (1.0 + BEFORE_BREAK)
    after = 0.0 if beyond > branch.rotation[-1] else multiplier_at(branch, beyond)
    return after, float(multiplier(branch)[standing].max())


def _local_steps(curves: BranchCurves, each: LocalDisplacement, name: str, clause: str) -> Iterator[Step]:
    seat, what, upper = each.limit.kind == "seat", each.limit.what, f"φ_{name[2:]}"
    words = "displacement at which the seat is lost" if seat else "displacement at which the action ends"
    yield from displacement_steps(
        name, words, clause, curves.lasting, mass=curves.mass, rotation=each.limit.rotation, upper=upper, subject=what
    )
    if seat:
        return
    words = "acceleration just after the action ends over the largest; it limits below one half"
    given = {"λ": each.after, "λ_max": each.largest}
    yield step("λ / λ_max", words, clause, "λ / λ_max", each.after / each.largest, given=given, subject=what)
