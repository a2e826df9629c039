"""Checks and questions made by hand, for tests of the verdict."""

from __future__ import annotations

from collections.abc import Iterable

from assess.codes.bases import BASES
from assess.codes.check import Check, Outcome, Reason, reason_message
from assess.codes.question import Action, MechanismChecks, Missing, Question
from assess.codes.verdict import Verdict, verdict

SITE = 0.2  # g
RATIOS = {Outcome.PASS: 0.5, Outcome.FAIL: 2.0}


def check(procedure: str, outcome: Outcome | None, *, state: str = "SLV", ratio: float | None = None, **more) -> Check:
    """A check at the site's own action; its index is 1 / ratio."""
    outcome = outcome or Outcome.NOT_ANSWERED
    ratio = RATIOS.get(outcome) if ratio is None else ratio
    index = None if ratio is None else 1.0 / ratio
    reason = {Outcome.PASS: Reason.WITHIN, Outcome.FAIL: Reason.BEYOND}.get(outcome, Reason.GROUND_UNKNOWN)
    values = {"capacity": "d"} if reason != Reason.GROUND_UNKNOWN else {"height": "8 m"}
    given = {
        "edition": "",
        "branch": "positive",
        "level_pga_g": SITE,
        "input_at": "ground",
        "damping": None,
        "quantity": "",
        "unit": "-",
        "safety_index": index,
        "score": {} if index is None else {"%NBS": 100.0 * index},
        "capacity_pga_g": None if index is None else index * SITE,
    }
    return Check(
        procedure=procedure,
        limit_state=state,
        verdict=outcome,
        ratio=ratio,
        reason=reason_message(reason, **values),
        **{**given, **more},
    )


def question(basis: str | None, *, state: str | None = "SLV", periods: bool = False, **more) -> Question:
    """The question of a basis at a site whose single spectrum is that of `state`."""
    return Question(None if basis is None else BASES[basis], Action(SITE, state, over_periods=periods), **more)


def decide(asked: Question, checks: Iterable[Check], *, missing: Iterable[Missing] = (), **more) -> Verdict:
    """The verdict on one mechanism."""
    return verdict(asked, [MechanismChecks("wall", tuple(checks), tuple(missing), **more)])


def step_values(check: Check) -> dict[str, float]:
    """The value of each line of a calculation sheet, by its symbol."""
    return {step.symbol: step.value for step in check.steps}
