"""The linear check of either edition: the acceleration of activation against that of ground and floor."""

from __future__ import annotations

from scipy.constants import g

from assess.codes.check import Check, Outcome, Reason, Step, because, step
from assess.codes.italian.edition import Edition
from assess.codes.italian.floor import Demands, floor_of, judged
from assess.codes.italian.limit_state import Case


def acceleration_check(
    case: Case,
    edition: Edition,
    *,
    procedure: str,
    capacity: float,
    demands: Demands,
    uplift: float | None,
    damping: float,
    steps: tuple[Step, ...],
) -> Check:
    """a0* = `capacity` [m/s2] against the larger of the `demands` [m/s2]; uplift: its PGA [m/s2]."""
    demanded = demands.largest
    verdict = judged(demanded / capacity)
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
        ratio=demanded / capacity,
        verdict=verdict,
        reason=because(Reason.WITHIN if verdict == Outcome.PASS else Reason.BEYOND, capacity="a0*"),
        capacity_pga_g=case.pga * capacity / demanded / g,
        uplift_pga_g=None if uplift is None else uplift / g,
        steps=steps,
        caveat=edition.caveat,
    )


def ratio_step(clause: str, *, demanded: float, capacity: float) -> Step:
    """The last line of the sheet."""
    given = {"demand": (demanded, "m/s2"), "a0*": (capacity, "m/s2")}
    return step("demand / a0*", "ratio", clause, "demand / a0*", demanded / capacity, given=given)
