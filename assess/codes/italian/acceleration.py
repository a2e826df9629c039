"""The linear check of either edition: the acceleration of activation against that of ground and floor."""

from __future__ import annotations

from scipy.constants import g

from assess.codes.check import Check, Outcome, Reason, Step, caveats_of, reason_message, step
from assess.codes.italian.edition import Edition
from assess.codes.italian.floor import Demands, floor_of, outcome_of
from assess.codes.italian.limit_state import Case
from assess.messages.message import Message, Quantity, Severity, Term, message
from assess.oscillator import linear_multiplier


def acceleration_check(
    case: Case,
    edition: Edition,
    *,
    procedure: str,
    capacity: float,
    demands: Demands | None,
    needs: Term,
    uplift: float | None,
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
    demands : [m/s2]; None where the spectrum ends before a period that it `needs`
    uplift : PGA at uplift [m/s2]
    damping : of the demand [-]
    steps : the calculation sheet

    Returns
    -------
    Check
    """
    demanded = None if demands is None else demands.largest
    verdict, reason = _verdict(case, demanded, capacity, needs=needs)
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
        demand=demanded,
        capacity=capacity,
        ratio=None if demanded is None else demanded / capacity,
        verdict=verdict,
        reason=reason,
        capacity_pga_g=None if demanded is None else case.pga * capacity / demanded / g,
        uplift_pga_g=None if uplift is None else uplift / g,
        steps=steps,
        **caveats_of(edition.caveat),
        conditions=_conditions(case) if verdict == Outcome.PASS else (),
    )


def _conditions(case: Case) -> tuple[Message, ...]:
    """Return the condition of a pass where the multiplier counts actions that are not shown to last."""
    shown = case.curves.lasting
    if linear_multiplier(case.curves.starting) <= linear_multiplier(shown) * (1.0 + 1e-9):
        return ()
    return (message("counts-at-rest", severity=Severity.WARNING),)


def _verdict(case: Case, demanded: float | None, capacity: float, *, needs: Term) -> tuple[Outcome, Message]:
    if demanded is None:
        end = Quantity(case.context.spectrum.longest_period, "time")
        return Outcome.NOT_ANSWERED, reason_message(Reason.SPECTRUM_TOO_SHORT, period=needs, end=end)
    verdict = outcome_of(demanded / capacity)
    return verdict, reason_message(Reason.WITHIN if verdict == Outcome.PASS else Reason.BEYOND, capacity="a0*")


def ratio_steps(clause: str, demands: Demands | None, *, capacity: float) -> tuple[Step, ...]:
    """Write the last line of the sheet."""
    if demands is None:
        return ()
    given = {"D": (demands.largest, "m/s2"), "a0*": (capacity, "m/s2")}
    return (step("D / a0*", "ratio", clause, "D / a0*", demands.largest / capacity, given=given),)
