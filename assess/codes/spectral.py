"""The verdict of a procedure that reads rotations from a PGA-rotation curve."""

from __future__ import annotations

from dataclasses import dataclass

from scipy.constants import g

from assess.codes.check import BEYOND_SPECTRUM, NO_LASTING, Verdict
from assess.codes.context import Context
from assess.codes.relation import PgaRelation, capacity


@dataclass(frozen=True)
class Answer:
    """Verdict, why, and the PGA at capacity [g] where it is known."""

    verdict: Verdict
    reason: str
    capacity_pga_g: float | None


def spectral_answer(
    rotation: float | None,
    allowable: float,
    *,
    curve: PgaRelation,
    level: float,
    uplift: float | None,
    context: Context,
) -> Answer:
    """What the demand `rotation` [rad] (None: none found) means beside `allowable` [rad] at PGA `level` [m/s2].

    uplift: the true multiplier [-], None on joints without a threshold. Where the spectrum ends before the answer,
    nothing is claimed.
    """
    at_capacity = capacity(curve, allowable)
    in_g = None if at_capacity is None else at_capacity / g
    if rotation is not None:
        return Answer("pass" if rotation <= allowable else "fail", _rocks(rotation, allowable, level, uplift), in_g)
    if curve.complete:
        return Answer("fail", "overturns: no rotation holds this demand", in_g)
    if at_capacity is not None:
        return Answer("fail", BEYOND_SPECTRUM, in_g)
    end = context.spectrum.longest_period
    return Answer(
        "not-applicable", f"the answer lies beyond the end of the spectrum at {end:.4g} s: extend its table", None
    )


def _rocks(rotation: float, allowable: float, level: float, uplift: float | None) -> str:
    if rotation == 0.0:
        return _still(level, uplift)
    return "rotation within the allowable" if rotation <= allowable else "rotation beyond the allowable"


def _still(level: float, uplift: float | None) -> str:
    if uplift is None:
        return f"moves on its joints, {NO_LASTING}"
    if level <= uplift * g:
        return "no rocking: the demand does not lift the body off its base"
    return f"lifts off, {NO_LASTING}"
