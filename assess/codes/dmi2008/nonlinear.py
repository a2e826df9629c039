"""Non-linear kinematic analysis to the letter, C8A.4.2.2-2.3: d_u* against the displacement demand at T_s."""

from __future__ import annotations

from scipy.constants import g

from assess.codes.check import BranchName, Check, Step
from assess.codes.context import Context
from assess.codes.dmi2008.clauses import (
    CAVEAT,
    EDITION,
    Capacity,
    Options,
    capacity_of,
    floor_displacement,
    floor_of,
    ground_displacement,
    rotation_at,
    unanswerable,
    uplift_pga,
)
from assess.codes.governing import governing
from assess.codes.relation import as_curve, relation
from assess.oscillator import Branch, Oscillator, displacement, multiplier

NONLINEAR = "C8A.4.2.2"


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
    floor = floor_of(context)
    at_ground = ground_displacement(context, cap.Ts)
    at_floor = 0.0 if floor is None else floor_displacement(context, floor, cap.Ts)
    per_pga = max(at_ground, at_floor) / context.spectrum.pga
    uplift = uplift_pga(branch, context, confidence_factor=FC)
    demanded = 0.0 if level <= uplift else per_pga * level
    rotation = rotation_at(branch, demanded * cap.e, mass=mass) if demanded < cap.d0 else None
    allowable = rotation_at(branch, cap.du * cap.e, mass=mass)
    curve = relation(lambda phi: displacement(branch, phi, mass=mass) / cap.e / per_pga, overturning=branch.overturning)
    missing = unanswerable(context)
    return Check(
        procedure="dmi2008-nonlinear",
        edition=EDITION,
        role="code",
        branch=name,
        limit_state="SLV",
        level_pga_g=level / g,
        input_at="mechanism base" if at_floor > at_ground else "ground",
        damping=context.spectrum.damping,
        damping_rule="",
        quantity="d*",
        unit="m",
        demand=demanded,
        capacity=cap.du,
        ratio=demanded / cap.du,
        verdict="not-applicable" if missing else "pass" if demanded <= cap.du else "fail",
        reason=missing or _reason(demanded, cap.du),
        capacity_pga_g=max(cap.du / per_pga, uplift) / g,
        uplift_pga_g=uplift / g,
        capacity_rotation_ratio=allowable / branch.overturning,
        rotation_ratio=None if rotation is None else rotation / branch.overturning,
        pga_curve=as_curve(curve, branch),
        steps=_steps(oscillator, branch, context, FC, cap, level=level, demanded=demanded),
        caveat=CAVEAT,
    )


def _reason(demanded: float, ultimate: float) -> str:
    if demanded == 0.0:
        return "no rocking: the demand does not lift the body off its base"
    return "displacement within d_u*" if demanded <= ultimate else "displacement beyond d_u*"


def _steps(
    oscillator: Oscillator,
    branch: Branch,
    context: Context,
    FC: float,
    cap: Capacity,
    *,
    level: float,
    demanded: float,
) -> tuple[Step, ...]:
    scale = level / context.spectrum.pga
    ordinate = float(context.spectrum.acceleration(cap.Ts)) * scale
    at_ground = ground_displacement(context, cap.Ts) * scale
    steps = [
        Step(
            "α0",
            "multiplier that starts the mechanism",
            "C8A.4.1",
            "V'(0) / (g B0)",
            f"{branch.restoring[0]:.5g} / (9.80665 · {branch.excitation[0]:.5g})",
            float(multiplier(branch)[0]),
            "-",
        ),
        Step(
            "e*",
            "fraction of participating mass",
            "C8A.4.1.2",
            "M* / M, M* = (Σ m δx)² / Σ m δx²",
            f"({branch.excitation[0]:.5g})² / ({branch.participation[0]:.5g} · {oscillator.mass:.5g})",
            cap.e,
            "-",
        ),
        Step("FC", "confidence factor of the knowledge level", "C8A.1.1", "given", f"{FC:g}", FC, "-"),
        Step(
            "a0*",
            "acceleration of activation",
            "C8A.4.1.2",
            "α0 g / (e* FC)",
            f"{multiplier(branch)[0]:.5g} · 9.80665 / ({cap.e:.5g} · {FC:g})",
            cap.a0,
            "m/s2",
        ),
        Step(
            "d0*",
            "displacement where a* = 0",
            NONLINEAR,
            "(∫ B dφ / M) / e* up to φ_ov",
            f"φ_ov = {branch.overturning:.5g} rad",
            cap.d0,
            "m",
        ),
        Step("d_u*", "ultimate displacement", NONLINEAR, "0.4 d0*", f"0.4 · {cap.d0:.5g}", cap.du, "m"),
        Step("d_s*", "displacement of the secant", NONLINEAR, "0.4 d_u*", f"0.4 · {cap.du:.5g}", cap.ds, "m"),
        Step(
            "a_s*",
            "acceleration at d_s*, on the model's curve",
            NONLINEAR,
            "λ(φ) g / (e* FC) at d* = d_s*",
            f"d_s* = {cap.ds:.5g}",
            cap.as_,
            "m/s2",
        ),
        Step(
            "T_s",
            "secant period",
            NONLINEAR,
            "2π √(d_s* / a_s*)",
            f"2π √({cap.ds:.5g} / {cap.as_:.5g})",
            cap.Ts,
            "s",
        ),
        Step(
            "S_e(T_s)",
            "elastic spectrum at the level",
            context.spectrum.clause,
            "S_e(T_s)",
            f"T = {cap.Ts:.5g} s, PGA = {level / g:.4g} g",
            ordinate,
            "m/s2",
        ),
        Step(
            "S_De(T_s)",
            "displacement demand at the ground",
            NONLINEAR,
            "S_e(T_s) (T_s / 2π)²",
            f"{ordinate:.5g} · ({cap.Ts:.5g} / 2π)²",
            at_ground,
            "m",
        ),
    ]
    floor = floor_of(context)
    if floor is not None:
        at_first_mode = ground_displacement(context, floor.T1) * scale
        steps.append(
            Step(
                "Δ_d(Z)",
                "displacement demand at the floor",
                "C8A.4.2.3",
                "S_De(T1) ψ γ r² / √((1 − r)² + 0.02 r), r = T_s / T1",
                f"{at_first_mode:.5g} · {floor.psi:.4g} · {floor.gamma:.4g}, r = {cap.Ts:.5g} / {floor.T1:.5g}",
                floor_displacement(context, floor, cap.Ts) * scale,
                "m",
            )
        )
    gate = "" if demanded else "; below uplift nothing moves"
    steps.append(
        Step(
            "demand / d_u*",
            f"ratio{gate}",
            NONLINEAR,
            "demand / capacity",
            f"{demanded:.5g} / {cap.du:.5g}",
            demanded / cap.du,
            "-",
        )
    )
    return tuple(steps)
