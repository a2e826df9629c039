"""The non-linear check of either edition: ultimate displacement against the spectral demand at a secant period."""

from __future__ import annotations

from dataclasses import dataclass
from math import isclose, pi

from scipy.constants import g

from assess.codes.check import Check, Outcome, PgaCurve, Reason, Step, caveats_of, reason_message, step
from assess.codes.italian.edition import Edition
from assess.codes.italian.floor import Demands, outcome_of
from assess.codes.italian.kinematic import rotation_at
from assess.codes.italian.limit_state import Case
from assess.codes.pga_rotation import pga_rotation, to_pga_curve
from assess.messages.message import Message, Quantity
from assess.oscillator import displacement
from spectra.arrays import FloatArray


@dataclass(frozen=True)
class Answer:
    """What an edition finds of one case.

    ultimate : displacement capacity d* [m], written `symbol`; collapse : d0* [m]; e : e* [-]
    wanted : displacement for each m/s2 of PGA [s2]; None where the spectrum ends too early for it
    needs : longest period at which the spectrum is read
    conditions : what a pass rests on
    starts : PGA [m/s2] up to which the mechanism does not rock, and its displacement there for each m/s2 of PGA [s2]
    uplift : PGA at uplift [m/s2], None on joints without a threshold
    """

    ultimate: float
    symbol: str
    collapse: float
    e: float
    needs: Message
    wanted: Demands | None
    starts: float
    still: float
    uplift: float | None
    conditions: tuple[Message, ...] = ()

    @property
    def before(self) -> float:
        """Displacement d* at which the mechanism begins to rock [m]."""
        return self.starts * self.still

    def demand(self, pga: float) -> float | None:
        """Return d* [m] at `pga` [m/s2], rocking no less than before; None where the spectrum ends too early."""
        if self.wanted is None:
            return None
        return pga * self.still if pga <= self.starts else max(pga * self.wanted.largest, self.before)


def displacement_check(
    case: Case, answer: Answer, edition: Edition, *, procedure: str, damping: float, rule: str, steps: tuple[Step, ...]
) -> Check:
    """Make the check of one case; damping [-] of the demand, by the spectrum's `rule`."""
    branch, mass, demanded = case.curves.lasting, case.curves.mass, answer.demand(case.pga)
    rotation = None
    if demanded is not None and demanded < answer.collapse:
        rotation = rotation_at(branch, demanded * answer.e, mass=mass)
    allowable = rotation_at(branch, answer.ultimate * answer.e, mass=mass)
    verdict, reason = _verdict(case, answer, demanded)
    wanted = answer.wanted
    return Check(
        procedure=procedure,
        edition=edition.name,
        branch=case.curves.name,
        limit_state=case.state,
        level_pga_g=case.level / g,
        input_at="ground" if wanted is None else wanted.at,
        damping=damping,
        damping_rule=rule,
        quantity="d*",
        unit="m",
        demand=demanded,
        capacity=answer.ultimate,
        ratio=None if demanded is None else demanded / answer.ultimate,
        verdict=verdict,
        reason=reason,
        capacity_pga_g=None if wanted is None else max(answer.ultimate / wanted.largest, answer.starts) / g,
        uplift_pga_g=None if answer.uplift is None else answer.uplift / g,
        capacity_rotation_ratio=allowable / branch.overturning,
        rotation_ratio=None if rotation is None else rotation / branch.overturning,
        pga_curve=_curve(case, answer),
        steps=steps,
        conditions=answer.conditions,
        **caveats_of(edition.caveat),
    )


def ground_step(case: Case, clause: str, symbol: str, period: float, *, ordinate: float, moved: float) -> Step:
    """Write S_De at a period [s] named `symbol`, from S_e [m/s2] or from the code's own displacements beyond T_E."""
    words, name, spectral = "demand at the ground", f"S_De({symbol})", f"S_e({symbol})"
    if isclose(moved, ordinate * (period / (2 * pi)) ** 2, rel_tol=1e-9):
        given = {spectral: (ordinate, "m/s2"), symbol: (period, "s")}
        return step(name, words, clause, f"{spectral} · ({symbol} / (2 · π))²", moved, "m", given=given)
    at = {symbol: (period, "s"), "PGA": (case.pga, "m/s2")}
    return step(name, words, case.context.spectrum.clause, "displacement spectrum, T > T_E", moved, "m", at=at)


def ratio_step(answer: Answer, clause: str, *, demanded: float) -> Step:
    """Write the last line of the sheet."""
    held = "no less than as it begins to rock" if demanded == answer.before else ""
    remark = held if demanded else "no motion below uplift"
    symbol, given = f"D / {answer.symbol}", {"D": (demanded, "m"), answer.symbol: (answer.ultimate, "m")}
    return step(symbol, "ratio", clause, symbol, demanded / answer.ultimate, given=given, remark=remark)


def _curve(case: Case, answer: Answer) -> PgaCurve:
    """Return PGA over rotation: the demand is proportional to PGA, as the period does not change with it."""
    wanted, branch = answer.wanted, case.curves.lasting
    if wanted is None:
        return PgaCurve((), ())

    def pga_of(rotation: FloatArray) -> FloatArray:
        return displacement(branch, rotation, mass=case.curves.mass) / (answer.e * wanted.largest)

    return to_pga_curve(pga_rotation(pga_of, overturning=branch.unstable, uplift=answer.starts), branch)


def _verdict(case: Case, answer: Answer, demanded: float | None) -> tuple[Outcome, Message]:
    if demanded is None:
        end = Quantity(case.context.spectrum.longest_period, "time")
        return Outcome.NOT_ANSWERED, reason_message(Reason.SPECTRUM_TOO_SHORT, period=answer.needs, end=end)
    if demanded == 0.0:
        return Outcome.PASS, reason_message(Reason.NO_ROCKING)
    verdict = outcome_of(demanded / answer.ultimate)
    return verdict, reason_message(Reason.WITHIN if verdict == Outcome.PASS else Reason.BEYOND, capacity=answer.symbol)
