"""Linear kinematic analysis, C8A.4.2.1: the acceleration that starts the mechanism against the demand over q."""

from __future__ import annotations

from scipy.constants import g

from assess.codes.check import BranchName, Check, PgaCurve, Step
from assess.codes.context import Context
from assess.codes.dmi2008.clauses import (
    CAVEAT,
    EDITION,
    Options,
    activation,
    floor_acceleration,
    floor_of,
    unanswerable,
    uplift_pga,
)
from assess.codes.governing import governing
from assess.oscillator import Branch, Oscillator, multiplier, participation_ratio


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """C8A.4.2.1: a0* against the demand (over q at SLV), at the ground and, above it, at the floor."""
    checks: list[Check] = []
    for state in options.limit_states:
        q = options.behaviour_factor if state == "SLV" else 1.0

        def one(branch: Branch, name: BranchName, level: float, state: str = state, q: float = q) -> Check:
            return _check(oscillator, branch, name, context, options, level, state=state, q=q)

        checks.extend(governing(oscillator, context.levels, one))
    return tuple(checks)


def _check(
    oscillator: Oscillator,
    branch: Branch,
    name: BranchName,
    context: Context,
    options: Options,
    level: float,
    *,
    state: str,
    q: float,
) -> Check:
    FC = options.confidence_factor
    a0 = activation(branch, mass=oscillator.mass, confidence_factor=FC)
    floor = floor_of(context)
    scale = level / context.spectrum.pga
    at_floor = 0.0 if floor is None else floor_acceleration(context, floor) * scale / q
    demanded = max(level / q, at_floor)
    missing = unanswerable(context)
    passes = a0 >= demanded
    return Check(
        procedure="dmi2008-linear",
        edition=EDITION,
        role="code",
        branch=name,
        limit_state=state,
        level_pga_g=level / g,
        input_at="ground" if floor is None else "mechanism base",
        damping=context.spectrum.damping,
        damping_rule="",
        quantity="acceleration",
        unit="m/s2",
        demand=demanded,
        capacity=a0,
        ratio=demanded / a0,
        verdict="not-applicable" if missing else "pass" if passes else "fail",
        reason=missing or ("a0* covers the demand" if passes else "a0* is less than the demand"),
        capacity_pga_g=level * a0 / demanded / g,
        uplift_pga_g=uplift_pga(branch, context, confidence_factor=FC) / g,
        capacity_rotation_ratio=None,
        rotation_ratio=None,
        pga_curve=PgaCurve((), ()),
        steps=_steps(oscillator, branch, context, FC, level=level, q=q, a0=a0, at_floor=at_floor, demanded=demanded),
        caveat=CAVEAT,
    )


def _steps(
    oscillator: Oscillator,
    branch: Branch,
    context: Context,
    FC: float,
    *,
    level: float,
    q: float,
    a0: float,
    at_floor: float,
    demanded: float,
) -> tuple[Step, ...]:
    alpha0, e = float(multiplier(branch)[0]), participation_ratio(branch, mass=oscillator.mass)
    steps = [
        Step(
            "α0",
            "multiplier that starts the mechanism",
            "C8A.4.1",
            "V'(0) / (g B0)",
            f"{branch.restoring[0]:.5g} / (9.80665 · {branch.excitation[0]:.5g})",
            alpha0,
            "-",
        ),
        Step(
            "e*",
            "fraction of participating mass",
            "C8A.4.1.2",
            "M* / M, M* = (Σ m δx)² / Σ m δx²",
            f"({branch.excitation[0]:.5g})² / ({branch.participation[0]:.5g} · {oscillator.mass:.5g})",
            e,
            "-",
        ),
        Step(
            "a0*",
            "spectral acceleration of activation",
            "C8A.4.1.2",
            "α0 g / (e* FC)",
            f"{alpha0:.5g} · 9.80665 / ({e:.5g} · {FC:.3g})",
            a0,
            "m/s2",
        ),
        Step(
            "a_g S / q",
            "demand of the ground",
            "C8A.4.2.1",
            "PGA / q",
            f"{level:.5g} / {q:g}",
            level / q,
            "m/s2",
        ),
    ]
    floor = floor_of(context)
    if floor is not None:
        at_site = float(context.spectrum.acceleration(floor.T1)) * level / context.spectrum.pga
        steps.append(
            Step(
                "S_e(T1) ψ γ / q",
                "demand of the floor",
                "C8A.4.2.1",
                "S_e(T1) · Z/H · 3N/(2N+1) / q",
                f"{at_site:.5g} · {floor.psi:.4g} · {floor.gamma:.4g} / {q:g}",
                at_floor,
                "m/s2",
            )
        )
    steps.append(
        Step(
            "demand / a0*",
            "ratio",
            "C8A.4.2.1",
            "demand / capacity",
            f"{demanded:.5g} / {a0:.5g}",
            demanded / a0,
            "-",
        )
    )
    return tuple(steps)
