"""The outcome of a procedure that reads rotations from a curve of PGA over rotation."""

from __future__ import annotations

from dataclasses import dataclass

from scipy.constants import g

from assess.codes.check import Outcome, Reason, reason_message
from assess.codes.context import Context
from assess.codes.pga_rotation import PgaRotation, pga_capacity
from assess.messages.message import Message, Quantity, Term


@dataclass(frozen=True)
class Answer:
    """Outcome, reason, and the PGA at capacity [g] where it is known."""

    verdict: Outcome
    reason: Message
    capacity_pga_g: float | None


def rotation_verdict(
    rotation: float | None,
    allowable: float,
    *,
    curve: PgaRotation,
    level: float,
    uplift: float | None,
    context: Context,
) -> Answer:
    """Compare the demand with the allowable rotation; without an outcome where the spectrum ends before the answer.

    Parameters
    ----------
    rotation : demand [rad]; None where none was found
    allowable : [rad]
    curve : PGA over rotation
    level : PGA [m/s2]
    uplift : multiplier at uplift [-]; None on joints without a threshold
    context : the site

    Returns
    -------
    Answer
    """
    at_capacity = pga_capacity(curve, allowable)
    in_g = None if at_capacity is None else at_capacity / g
    if rotation is not None:
        within = Outcome.PASS if rotation <= allowable else Outcome.FAIL
        return Answer(within, _rocks(rotation, allowable, level, uplift), in_g)
    if curve.complete:
        return Answer(Outcome.FAIL, reason_message(Reason.OVERTURNS), in_g)
    if at_capacity is not None:
        return Answer(Outcome.FAIL, reason_message(Reason.BEYOND_SPECTRUM), in_g)
    end = Quantity(context.spectrum.longest_period, "time")
    return Answer(
        Outcome.NOT_ANSWERED, reason_message(Reason.SPECTRUM_TOO_SHORT, period=Term("the answer"), end=end), None
    )


def _rocks(rotation: float, allowable: float, level: float, uplift: float | None) -> Message:
    if rotation == 0.0:
        return reason_message(_still(level, uplift))
    return reason_message(
        Reason.WITHIN if rotation <= allowable else Reason.BEYOND, capacity=Term("the allowable rotation")
    )


def _still(level: float, uplift: float | None) -> Reason:
    if uplift is None:
        return Reason.ON_JOINTS
    return Reason.NO_ROCKING if level <= uplift * g else Reason.NO_LASTING
