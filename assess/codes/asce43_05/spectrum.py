"""The spectrum method of A.2 in two readings: the clause's, and the thesis' that reproduces its Tables 8.5-8.6."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.constants import g

from assess.codes.asce43_05.clauses import (
    CAVEAT,
    EDITION,
    Options,
    capacity_acceleration,
    effective_damping,
    effective_frequency,
    pga_relation,
    stored_work,
    thesis_limit,
    thesis_limit_ratio,
    vertical_factor,
)
from assess.codes.asce43_05.height import with_height
from assess.codes.check import BranchName, Check, Outcome, Reason, Step, because
from assess.codes.check import Reading as Kind
from assess.codes.context import Context
from assess.codes.governing import branch_named, governing
from assess.codes.plain import plain
from assess.codes.relation import PgaRelation, as_curve, demand
from assess.codes.spectral import Answer, spectral_answer
from assess.codes.worked import multiplier_worked
from assess.oscillator import Branch, Oscillator, energy, multiplier, resisted, threshold

THESIS_DAMPING = 0.05
A2, DEMANDED = "ASCE 43-05 A.2", "at the demand"


@dataclass(frozen=True)
class Reading:
    """How the clause is read for one branch, each choice with its source.

    damping of the demand [-]; allowable_ratio: rotation / phi_ov [-]; starts_at: PGA below which nothing rocks [m/s2].
    """

    procedure: str
    kind: Kind
    damping: float
    damping_formula: str
    damping_numbers: str
    allowable_ratio: float
    allowable_source: str
    allowable_formula: str
    starts_at: float


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """A.2 with the demand at f_e and beta_e, from true uplift on; one check for each level, on the worse branch."""

    def reading(branch: Branch) -> Reading:
        gamma = "β_e = γ / √(4π² + γ²), γ = −2 ln C_R"
        return Reading(
            procedure="asce43-05-spectrum",
            kind="letter",
            damping=effective_damping(branch.restitution),
            damping_formula=gamma,
            damping_numbers=f"C_R = {branch.restitution:.4g}",
            allowable_ratio=options.allowable_ratio,
            allowable_source="limit of the response-history method; the limit of A.2 itself was not seen",
            allowable_formula="θ_lim = ratio · φ_ov",
            starts_at=(threshold(branch) or 0.0) * g,
        )

    return _checks(oscillator, context, reading, own=oscillator)


def assess_thesis(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """The thesis' reading (8.3.2): 5 % damping, limit k alpha / sin 2 alpha, no threshold of uplift; informative."""

    def reading(branch: Branch) -> Reading:
        return Reading(
            procedure="asce43-05-spectrum-thesis",
            kind="thesis",
            damping=THESIS_DAMPING,
            damping_formula="5 %",
            damping_numbers="thesis 8.3.2",
            allowable_ratio=thesis_limit_ratio(branch, mass=oscillator.mass),
            allowable_source="empirical: fits the thesis' Table 8.5, no derivation known",
            allowable_formula="θ_lim = φ_ov · k α / sin 2α, k = I_O / (M R²)",
            starts_at=0.0,
        )

    like = plain(oscillator, lambda branch: thesis_limit(branch, mass=oscillator.mass))
    return _checks(like, context, reading, own=oscillator)


def _checks(
    oscillator: Oscillator, context: Context, reading_of: Callable[[Branch], Reading], *, own: Oscillator
) -> tuple[Check, ...]:
    """Of the oscillator as it is read; own: the mechanism's, which says where it lifts off."""

    def one(branch: Branch, name: BranchName, level: float) -> Check:
        lifts = threshold(branch_named(own, name))
        return _check(oscillator, branch, name, context, reading_of(branch), level, lifts=lifts)

    return with_height(governing(oscillator, context.levels, one), context=context)


def _check(
    oscillator: Oscillator,
    branch: Branch,
    name: BranchName,
    context: Context,
    reading: Reading,
    level: float,
    *,
    lifts: float | None,
) -> Check:
    a = resisted(branch)
    f_v = vertical_factor(a, context.vertical_ratio)
    curve = pga_relation(branch, context.spectrum, damping=reading.damping, f_v=f_v, uplift=reading.starts_at)
    allowable = reading.allowable_ratio * branch.unstable
    rotation = demand(curve, level)
    answer = spectral_answer(rotation, allowable, curve=curve, level=level, uplift=lifts, context=context)
    if reading.allowable_ratio > 1.0:
        answer = Answer(Outcome.NOT_APPLICABLE, because(Reason.LIMIT_BEYOND_OVERTURNING), None)
    damping_rule = context.spectrum.damping_rule if reading.damping != context.spectrum.damping else ""
    return Check(
        procedure=reading.procedure,
        edition=EDITION,
        reading=reading.kind,
        branch=name,
        limit_state="no overturning",
        level_pga_g=level / g,
        input_at="ground",
        damping=reading.damping,
        damping_rule=damping_rule,
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
        pga_curve=as_curve(curve, branch),
        steps=_steps(oscillator, branch, context, reading, curve=curve, level=level, f_v=f_v, rotation=rotation),
        caveat=CAVEAT if oscillator.negative is not None else f"{CAVEAT}; it is written for bodies that rock both ways",
    )


def _steps(
    oscillator: Oscillator,
    branch: Branch,
    context: Context,
    reading: Reading,
    *,
    curve: PgaRelation,
    level: float,
    f_v: float,
    rotation: float | None,
) -> tuple[Step, ...]:
    """The calculation sheet; the spectral values stand at the demand, or at the allowable where nothing rocks.

    Where the spectrum ends before that, they stand where it ends; a sheet without a known ordinate ends with theta.
    """
    formula, start, a = multiplier_worked(branch)
    mass, I0 = oscillator.mass, float(branch.inertia[0])
    h = float(branch.excitation[0]) / mass
    C1 = I0 / (mass * h**2)
    limit = reading.allowable_ratio * branch.unstable
    meant = "tan α, multiplier at rest; true uplift at a g" if a == multiplier(branch)[0] else "largest multiplier"
    vertical = f"√(1 + ({a:.5g} · {context.vertical_ratio:.3g})²)"
    limited = f"{reading.allowable_ratio:.4g} · {branch.unstable:.5g}"
    damped = reading.damping_formula, reading.damping_numbers, reading.damping
    block = (
        Step("h", "height of the centroid", A2, "B0 / M", f"{branch.excitation[0]:.5g} / {mass:.5g}", h, "m"),
        Step("a", meant, A2, formula, start, a, "-"),
        Step("C1", "inertia ratio", A2, "I_O / (M h²)", f"{I0:.5g} / ({mass:.5g} · {h:.5g}²)", C1, "-"),
        Step("F_V", "vertical ground motion", "Eq. A-5(b)", "√(1 + (a S_aV/S_aH)²)", vertical, f_v, "-"),
        Step("F_H", "inertia beyond the body's mass", "Eq. A-5(c)", "counted in B0", "1", 1.0, "-"),
        Step("β_e", "effective damping", A2, *damped, "-"),
        Step("θ_lim", reading.allowable_source, A2, reading.allowable_formula, limited, limit, "rad"),
    )
    if not curve.rotation.size:
        return block
    at = rotation if rotation else min(limit, float(curve.rotation[-1]))
    where = DEMANDED if rotation else "at the allowable rotation" if at == limit else "where the curve ends"
    worked = _rotation_steps(branch, context, reading, at=at, where=where, level=level, f_v=f_v, h=h, C1=C1)
    return (*block, *(_resting_steps(curve, level) if rotation == 0.0 else ()), *worked)


def _resting_steps(curve: PgaRelation, level: float) -> tuple[Step, ...]:
    """Why the demand is no rotation: less PGA than takes the body to any."""
    words = "at the demand: none, the PGA is no more than the least that takes it to a lasting θ"
    numbers = f"{level / g:.4g} g ≤ {float(curve.least[0]) / g:.4g} g"
    return (Step("θ_dem", words, A2, "PGA ≤ least PGA(θ)", numbers, 0.0, "rad"),)


def _rotation_steps(
    branch: Branch,
    context: Context,
    reading: Reading,
    *,
    at: float,
    where: str,
    level: float,
    f_v: float,
    h: float,
    C1: float,
) -> tuple[Step, ...]:
    """From a rotation to the PGA that takes the body there."""
    theta = np.array([at])
    f1, stored = float(stored_work(branch, theta)[0]), float(energy(branch, theta)[0])
    cap = float(capacity_acceleration(branch, theta, f_v=f_v)[0])
    f_e = float(effective_frequency(branch, theta)[0])
    ordinate = float(context.spectrum.acceleration(1 / f_e, damping=reading.damping)) / context.spectrum.pga
    rocking = f"2 · 9.80665 · {f1:.5g} / ({f_v:.5g} · 1 · {at:.5g})"
    root = f"√(2 · {f1:.5g} · 9.80665 / ({C1:.5g} · {h:.5g} · {at:.5g}²)) / 2π"
    spectral = f"T = {1 / f_e:.5g} s, β = {reading.damping:.4g}"
    clause, divided = context.spectrum.clause, f"{cap:.5g} / {ordinate:.5g}"
    solved = "SA_H,DEM(θ) = SA_H,CAP(θ)", f"PGA = {level / g:.4g} g"
    chosen = solved if where == DEMANDED else ("θ_lim, or where the curve ends", f"{at:.5g}")
    return (
        Step("θ", where, A2, *chosen, at, "rad"),
        Step(
            "f1",
            "work stored over M g h",
            "Eq. A-5(a)",
            "E / (g B0); rigid block: cos θ + a sin θ − 1",
            f"{stored:.5g} / (9.80665 · {branch.excitation[0]:.5g}), θ = {at:.5g}",
            f1,
            "-",
        ),
        Step("SA_H,CAP", "spectral acceleration capacity", "Eq. A-5", "2 g f1 / (F_V F_H θ)", rocking, cap, "m/s2"),
        Step("f_e", "effective frequency", A2, "√(2 f1 g / (C1 h θ²)) / 2π", root, f_e, "Hz"),
        Step("S_a/PGA", "spectrum at f_e, β_e over PGA", clause, "S_a(1/f_e, β_e) / PGA", spectral, ordinate, "-"),
        Step("PGA(θ)", f"takes the body to θ, {where}", A2, "SA_H,CAP / (S_a/PGA)", divided, cap / ordinate, "m/s2"),
    )
