"""Non-linear kinematic analysis to the letter, C8A.4.2.2-2.3: d_u* against the displacement demand at T_s."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.constants import g

from assess.codes.check import BranchName, Check, PgaCurve, Step, Verdict
from assess.codes.context import Context
from assess.codes.dmi2008.clauses import (
    CAVEAT,
    DAMPING,
    EDITION,
    Capacity,
    Options,
    activation_steps,
    capacity_of,
    floor_displacement,
    floor_of,
    ground_displacement,
    judged,
    rotation_at,
    uplift_pga,
)
from assess.codes.governing import governing
from assess.codes.relation import as_curve, relation
from assess.oscillator import Branch, FloatArray, Oscillator, displacement

CLAUSE = "C8A.4.2.2"


@dataclass(frozen=True)
class Demands:
    """Displacement demand for each m/s2 of PGA [s2]: at the ground, and at the floor (0 at the ground)."""

    ground: float
    floor: float

    @property
    def largest(self) -> float:
        """The governing one."""
        return max(self.ground, self.floor)


def demands(context: Context, Ts: float) -> Demands | None:
    """S_De(Ts) and the floor's demand over PGA; None where the spectrum ends before Ts or T1."""
    floor = floor_of(context)
    if max(Ts, floor.T1 if floor is not None else 0.0) > context.spectrum.longest_period:
        return None
    at_floor = 0.0 if floor is None else floor_displacement(context, floor, Ts)
    return Demands(ground_displacement(context, Ts) / context.spectrum.pga, at_floor / context.spectrum.pga)


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """C8A.4.2.2-2.3 to the letter: du* against S_De(Ts), and against the floor's displacement above ground; SLV."""

    def one(branch: Branch, name: BranchName, level: float) -> Check:
        return _check(oscillator, branch, name, context, options, level)

    return governing(oscillator, context.levels, one)


def _check(
    oscillator: Oscillator, branch: Branch, name: BranchName, context: Context, options: Options, level: float
) -> Check:
    mass, FC = oscillator.mass, options.confidence_factor
    cap = capacity_of(branch, mass=mass, confidence_factor=FC)
    uplift = uplift_pga(branch, context, confidence_factor=FC)
    starts_at = uplift or 0.0
    wanted = demands(context, cap.Ts)
    demanded = None if wanted is None else 0.0 if level <= starts_at else wanted.largest * level
    rotation = None
    if demanded is not None and demanded < cap.d0:
        rotation = rotation_at(branch, demanded * cap.e, mass=mass)
    allowable = rotation_at(branch, cap.du * cap.e, mass=mass)
    verdict, reason = _verdict(demanded, cap, context)
    return Check(
        procedure="dmi2008-nonlinear",
        edition=EDITION,
        role="code",
        branch=name,
        limit_state="SLV",
        level_pga_g=level / g,
        input_at="mechanism base" if wanted is not None and wanted.floor > wanted.ground else "ground",
        damping=DAMPING,
        damping_rule="",
        quantity="d*",
        unit="m",
        demand=demanded,
        capacity=cap.du,
        ratio=None if demanded is None else demanded / cap.du,
        verdict=verdict,
        reason=reason,
        capacity_pga_g=None if wanted is None else max(cap.du / wanted.largest, starts_at) / g,
        uplift_pga_g=None if uplift is None else uplift / g,
        capacity_rotation_ratio=allowable / branch.overturning,
        rotation_ratio=None if rotation is None else rotation / branch.overturning,
        pga_curve=_curve(branch, cap, wanted, mass=mass, uplift=starts_at),
        steps=_steps(oscillator, branch, context, FC, cap, wanted, level=level, demanded=demanded),
        caveat=CAVEAT,
    )


def _curve(branch: Branch, cap: Capacity, wanted: Demands | None, *, mass: float, uplift: float) -> PgaCurve:
    """PGA over rotation: the demand is proportional to PGA, for T_s does not change with it."""
    if wanted is None:
        return PgaCurve((), ())

    def pga_of(rotation: FloatArray) -> FloatArray:
        return displacement(branch, rotation, mass=mass) / (cap.e * wanted.largest)

    return as_curve(relation(pga_of, overturning=branch.unstable, uplift=uplift), branch)


def _verdict(demanded: float | None, cap: Capacity, context: Context) -> tuple[Verdict, str]:
    if demanded is None:
        end = context.spectrum.longest_period
        return (
            "not-applicable",
            f"T_s = {cap.Ts:.4g} s lies beyond the end of the spectrum at {end:.4g} s: extend its table",
        )
    still = "no rocking: the demand does not lift the body off its base"
    within = still if demanded == 0.0 else "displacement within d_u*"
    return judged(demanded / cap.du, context, passed=within, failed="displacement beyond d_u*")


def _steps(
    oscillator: Oscillator,
    branch: Branch,
    context: Context,
    FC: float,
    cap: Capacity,
    wanted: Demands | None,
    *,
    level: float,
    demanded: float | None,
) -> tuple[Step, ...]:
    root = f"2π √({cap.ds:.5g} / {cap.as_:.5g})"
    curve = (
        Step(
            "d0*",
            "displacement where a* = 0",
            CLAUSE,
            "∫ B dφ / (M e*) to φ_ov",
            f"φ_ov = {branch.unstable:.5g}",
            cap.d0,
            "m",
        ),
        Step("d_u*", "ultimate displacement", CLAUSE, "0.4 d0*", f"0.4 · {cap.d0:.5g}", cap.du, "m"),
        Step("d_s*", "displacement of the secant", CLAUSE, "0.4 d_u*", f"0.4 · {cap.du:.5g}", cap.ds, "m"),
        Step(
            "a_s*",
            "acceleration at d_s*, model's curve",
            CLAUSE,
            "λ(φ) g / (e* FC)",
            f"d* = {cap.ds:.5g}",
            cap.as_,
            "m/s2",
        ),
        Step("T_s", "secant period", CLAUSE, "2π √(d_s* / a_s*)", root, cap.Ts, "s"),
    )
    activated = activation_steps(branch, mass=oscillator.mass, confidence_factor=FC)
    return (*activated, *curve, *_demand_steps(context, cap, wanted, level=level, demanded=demanded))


def _demand_steps(
    context: Context, cap: Capacity, wanted: Demands | None, *, level: float, demanded: float | None
) -> tuple[Step, ...]:
    if wanted is None or demanded is None:
        return ()
    ordinate = float(context.spectrum.acceleration(cap.Ts, damping=DAMPING)) * level / context.spectrum.pga
    spectral = f"T = {cap.Ts:.5g} s, PGA = {level / g:.4g} g"
    steps = [
        Step("S_e(T_s)", "elastic spectrum, 5 %", context.spectrum.clause, "S_e(T_s)", spectral, ordinate, "m/s2"),
        _at_ground(context, cap.Ts, ordinate=ordinate, moved=wanted.ground * level),
    ]
    floor = floor_of(context)
    if floor is not None:
        first = ground_displacement(context, floor.T1) * level / context.spectrum.pga
        numbers = f"{first:.5g} · {floor.psi:.4g} · {floor.gamma:.4g}, r = {cap.Ts:.5g} / {floor.T1:.5g}"
        formula = "S_De(T1) ψ γ r² / √((1 − r)² + 0.02 r), r = T_s / T1"
        steps.append(Step("Δ_d(Z)", "demand at the floor", "C8A.4.2.3", formula, numbers, wanted.floor * level, "m"))
    note = "ratio" if demanded else "ratio; below uplift nothing moves"
    numbers = f"{demanded:.5g} / {cap.du:.5g}"
    steps.append(Step("demand / d_u*", note, CLAUSE, "demand / capacity", numbers, demanded / cap.du, "-"))
    return tuple(steps)


def _at_ground(context: Context, Ts: float, *, ordinate: float, moved: float) -> Step:
    """S_De(T_s) from S_e(T_s), or from the displacements that the code gives beyond T_E."""
    factor = (Ts / (2 * np.pi)) ** 2
    if abs(moved - ordinate * factor) <= 1e-9 * moved:
        numbers = f"{ordinate:.5g} · ({Ts:.5g} / 2π)²"
        return Step("S_De(T_s)", "demand at the ground", CLAUSE, "S_e(T_s) (T_s / 2π)²", numbers, moved, "m")
    formula = "displacement spectrum, T > T_E"
    return Step("S_De(T_s)", "demand at the ground", context.spectrum.clause, formula, f"T_s = {Ts:.5g} s", moved, "m")
