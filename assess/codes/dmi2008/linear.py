"""Linear kinematic analysis, C8A.4.2.1: the acceleration that starts the mechanism against the demand over q."""

from __future__ import annotations

from scipy.constants import g

from assess.codes.check import BranchName, Check, PgaCurve, Step
from assess.codes.context import Context
from assess.codes.dmi2008.clauses import (
    CAVEAT,
    DAMPING,
    EDITION,
    Options,
    activation,
    activation_steps,
    floor_acceleration,
    floor_of,
    judged,
    uplift_pga,
)
from assess.codes.governing import governing
from assess.oscillator import Branch, Oscillator

CLAUSE = "C8A.4.2.1"


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
    floor, uplift = floor_of(context), uplift_pga(branch, context, confidence_factor=FC)
    scale = level / context.spectrum.pga
    at_floor = 0.0 if floor is None else floor_acceleration(context, floor) * scale / q
    demanded = max(level / q, at_floor)
    verdict, reason = judged(
        demanded / a0, context, passed="a0* covers the demand", failed="a0* is less than the demand"
    )
    return Check(
        procedure="dmi2008-linear",
        edition=EDITION,
        role="code",
        branch=name,
        limit_state=state,
        level_pga_g=level / g,
        input_at="ground" if floor is None else "mechanism base",
        damping=DAMPING,
        damping_rule="",
        quantity="acceleration",
        unit="m/s2",
        demand=demanded,
        capacity=a0,
        ratio=demanded / a0,
        verdict=verdict,
        reason=reason,
        capacity_pga_g=level * a0 / demanded / g,
        uplift_pga_g=None if uplift is None else uplift / g,
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
    floor = floor_of(context)
    at_ground = Step("a_g S / q", "demand of the ground", CLAUSE, "PGA / q", f"{level:.5g} / {q:g}", level / q, "m/s2")
    steps = [*activation_steps(branch, mass=oscillator.mass, confidence_factor=FC), at_ground]
    if floor is not None:
        ordinate = float(context.spectrum.acceleration(floor.T1, damping=DAMPING)) * level / context.spectrum.pga
        numbers = f"{ordinate:.5g} · {floor.psi:.4g} · {floor.gamma:.4g} / {q:g}"
        formula = "S_e(T1) · Z/H · 3N/(2N+1) / q"
        steps.append(Step("S_e(T1) ψ γ / q", "demand of the floor", CLAUSE, formula, numbers, at_floor, "m/s2"))
    numbers = f"{demanded:.5g} / {a0:.5g}"
    steps.append(Step("demand / a0*", "ratio", CLAUSE, "demand / capacity", numbers, demanded / a0, "-"))
    return tuple(steps)
