"""Linear kinematic analysis, C8A.4.2.1: the acceleration that starts the mechanism against the demand over q."""

from __future__ import annotations

from assess.codes.calculation_step import Given
from assess.codes.check import Check, Step, step
from assess.codes.context import Context
from assess.codes.dmi2008.clauses import DAMPING, EDITION, floor_acceleration, uplift
from assess.codes.italian.acceleration import acceleration_check, ratio_steps
from assess.codes.italian.edition import Options
from assess.codes.italian.floor import Demands, floor_of
from assess.codes.italian.kinematic import activation
from assess.codes.italian.limit_state import Case, add_safety_index, check_each_limit_state
from assess.codes.italian.sheet import activation_steps
from assess.messages.message import Term
from assess.oscillator import Oscillator

PROCEDURE = "dmi2008-linear"
CLAUSE = "C8A.4.2.1"
STATES = ("SLD", "SLV")


def assess(oscillator: Oscillator, context: Context, *, options: Options) -> tuple[Check, ...]:
    """Check a0* against the demand (over q at SLV), at the ground and, above it, at the floor (C8A.4.2.1)."""
    checks = check_each_limit_state(
        oscillator, context, EDITION, options, known=STATES, one=lambda case: _check(case, options)
    )
    return tuple(add_safety_index(check, context) for check in checks)


def _check(case: Case, options: Options) -> Check:
    FC, context, branch = case.confidence.factor, case.context, case.curves.starting
    q = options.behaviour_factor if case.state == "SLV" else 1.0
    demands = demands_of(context, pga=case.pga, q=q)
    a0 = activation(branch, mass=case.curves.mass, confidence_factor=FC)
    return acceleration_check(
        case,
        EDITION,
        procedure=PROCEDURE,
        capacity=a0,
        demands=demands,
        needs=Term("T1 of the building"),
        uplift=uplift(branch, context, confidence_factor=FC),
        damping=DAMPING,
        steps=(
            *activation_steps(case, EDITION),
            *_demand_steps(case, demands, q=q),
            *ratio_steps(CLAUSE, demands, capacity=a0),
        ),
    )


def demands_of(context: Context, *, pga: float, q: float) -> Demands | None:
    """Return the accelerations that ground and floor demand, over q.

    Parameters
    ----------
    context : site and building
    pga : of the limit state [m/s2]
    q : behaviour factor [-]

    Returns
    -------
    Demands or None
        Accelerations [m/s2]; None where the spectrum ends before T1.
    """
    floor = floor_of(context)
    if floor is None:
        return Demands(pga / q, 0.0)
    if context.spectrum.longest_period < floor.T1:
        return None
    return Demands(1.0, floor_acceleration(context, floor) / context.spectrum.pga).scale(pga / q)


def _demand_steps(case: Case, demands: Demands | None, *, q: float) -> tuple[Step, ...]:
    if demands is None:
        return ()
    floor, spectrum = floor_of(case.context), case.context.spectrum
    given: Given = {"PGA": (case.pga, "m/s2"), "q": q}
    ground = step("a_g S / q", "demand of the ground", CLAUSE, "PGA / q", demands.ground, "m/s2", given=given)
    if floor is None:
        return (ground,)
    spectral = float(spectrum.acceleration(floor.T1, damping=DAMPING)) * case.pga / spectrum.pga
    shape: Given = {"S_e(T1)": (spectral, "m/s2"), "ψ": floor.psi, "γ": floor.gamma, "q": q}
    words, formula = "demand of the floor, ψ = Z / H, γ = 3 N / (2 N + 1)", "S_e(T1) · ψ · γ / q"
    return ground, step(formula, words, CLAUSE, formula, demands.floor, "m/s2", given=shape)
