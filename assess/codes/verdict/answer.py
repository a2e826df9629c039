"""The deciding answer of one limit state of one mechanism."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from math import inf, isclose

from assess.codes.basis import Basis, IndexKind, LimitState
from assess.codes.check import Check, Outcome
from assess.codes.incremental import failure_below
from assess.codes.numerical_spread import is_between
from assess.codes.standing_figures import ratio_figures, side_figures, standing_figures
from assess.codes.verdict.methods import Rank, missing_action, requested_ranks
from assess.codes.verdict.missing_keys import missing_keys
from assess.codes.verdict.outcome import Decision, worst
from assess.codes.verdict.question import Action, MechanismChecks, Missing, Question
from assess.codes.verdict.target import FULL, whole
from assess.messages.message import Message, Term, message
from assess.short_repr import ShortRepr

FIGURES = 3  # of an index
LEAST_WIDTH = 0.05  # of the threshold: answers nearer to it are "at the limit"
GRADES = ((80.0, "A"), (67.0, "B"), (34.0, "C"), (20.0, "D"), (0.0, "E"))
"""Grades of NZSEE 2017 by the least share of the new building standard [%]; above 100 it is A+."""


@dataclass(frozen=True, repr=False)
class Index(ShortRepr):
    """The measure of an answer: its name, its value (%NBS in per cent), and its grade if there are grades.

    figures : to how many significant figures the value stands, where it comes from histories
    """

    name: str
    value: float
    grade: str = ""
    figures: int = 3


@dataclass(frozen=True, repr=False)
class Answer(ShortRepr):
    """The deciding answer of one limit state; `procedure` is empty where no method was requested or applies.

    provisional : of an incomplete one, what it would be with the safe value of what is missing; None where none exists
    """

    limit_state: str
    outcome: Decision
    procedure: str
    ratio: float | None
    index: Index | None
    reason: Message
    at_the_limit: bool = False
    provisional: Decision | None = None


@dataclass(frozen=True)
class Found:
    """An answer with the checks behind it, none where nothing decided, and the keys that are missing."""

    answer: Answer
    checks: tuple[Check, ...] = ()
    missing: tuple[Missing, ...] = ()


def find_answer(
    one: MechanismChecks, state: LimitState, question: Question, basis: Basis, target: float | None
) -> Found:
    """Find the answer of the most refined method that may decide and was answered.

    Methods of one rank must all pass: one that fails decides, one that is missing lets the next rank answer.

    Parameters
    ----------
    one : the checks of the mechanism
    state : the limit state
    question : what the project asks
    basis : the rules of the code
    target : of the index; None where it is not known

    Returns
    -------
    Found
    """
    ranks = requested_ranks(state, question.procedures)
    lacking = missing_action(state, question.action)
    silent: list[Check] = []
    for rank in ranks:
        checks = [check for method in rank for check in _of_method(one, method.procedure, state, question.action)]
        said = [decide(check, basis, target) for check in checks]
        if Decision.FAIL in said or (said and None not in said and _every_method(checks, one, rank, state)):
            outcome = worst(each for each in said if each is not None)
            return _declared(_answered(one, checks, said, state, outcome, basis, target), lacking)
        silent += [check for check, each in zip(checks, said, strict=True) if each is None]
    return _unanswered(one, state, ranks, silent, basis, target, lacking)


def _every_method(checks: Sequence[Check], one: MechanismChecks, rank: Rank, state: LimitState) -> bool:
    """Return whether each method of a rank gave a check; one that gives several does not count for another."""
    return {check.procedure for check in checks}.issuperset(_applying(one, rank, state))


def _applying(one: MechanismChecks, rank: Rank, state: LimitState) -> list[str]:
    """Return the methods of a rank that cover such a mechanism."""
    no = {check.procedure for check in one.checks if check.verdict == Outcome.NOT_APPLICABLE and _is_of(check, state)}
    return [method.procedure for method in rank if method.procedure not in no]


def _is_of(check: Check, state: LimitState) -> bool:
    return state.checked_as in (check.limit_state, "*")


def _of_method(one: MechanismChecks, procedure: str, state: LimitState, action: Action) -> list[Check]:
    return [
        check
        for check in one.checks
        if check.procedure == procedure
        and _is_of(check, state)
        and check.reading == "letter"
        and not check.informs
        and check.verdict != Outcome.NOT_APPLICABLE
        and at_action(check, action)
    ]


def at_action(check: Check, action: Action) -> bool:
    """Return whether a check is at the site's own action."""
    return isclose(check.level_pga_g, action.pga_g, rel_tol=1e-9)


def decide(check: Check, basis: Basis, target: float | None) -> Decision | None:
    """Compare a check with the target; None where it decides nothing.

    A pass above a PGA at which the scan fails is a fail: the margin is then below one.

    Parameters
    ----------
    check : to be compared
    basis : the rules of the code
    target : of the index; None where it is not known

    Returns
    -------
    Decision or None
    """
    if target is None or check.verdict == Outcome.NOT_ANSWERED:
        return None
    index, full = index_of(check, basis), whole(basis)
    if index is not None and index.name != IndexKind.DEMAND_CAPACITY and target != full:
        holds = index.value >= target
    elif target == full:
        holds = check.verdict == Outcome.PASS and failure_below(check) is None
    else:  # no index to compare: full safety is more than any lower target, and nothing is known of a higher one
        holds = check.verdict == Outcome.PASS
        if holds is (target > full):
            return None
    if holds and not check.may_pass:
        return None
    return Decision.PASS if holds else Decision.FAIL


def index_of(check: Check, basis: Basis) -> Index | None:
    """Return the measure of a check; None where it is not known.

    Parameters
    ----------
    check : of any procedure
    basis : which measure it uses

    Returns
    -------
    Index or None
    """
    if basis.index == IndexKind.ZETA_E:
        index = check.safety_index
        return None if index is None else Index(basis.index, index, figures=_figures(check))
    if basis.index == IndexKind.NBS:
        share = check.score.get(IndexKind.NBS)
        return None if share is None else Index(basis.index, share, grade(share))
    return None if check.ratio is None else Index(basis.index, check.ratio, figures=ratio_figures(check, most=FIGURES))


def _figures(check: Check) -> int:
    """Return to how many figures, one at least, the PGA at capacity stands up to that of 16 % of the draws."""
    low = None if check.numerical is None else check.numerical.capacity_low_pga_g
    if low is None or check.capacity_pga_g is None:
        return FIGURES
    return max(1, standing_figures(check.capacity_pga_g, (low,), most=FIGURES))


def _beside(index: Index | None, target: float | None) -> Index | None:
    """Return an index with as many figures as show it on its side of the target."""
    if index is None or target is None:
        return index
    return replace(index, figures=side_figures(index.value, index.figures, limit=target))


def grade(share: float) -> str:
    """Return the grade of a share of the new building standard [%] (NZSEE 2017, Table A3.1)."""
    return "A+" if share > 100.0 else next(name for least, name in GRADES if share >= least)


def _answered(
    one: MechanismChecks,
    checks: Sequence[Check],
    said: Sequence[Decision | None],
    state: LimitState,
    outcome: Decision,
    basis: Basis,
    target: float | None,
) -> Found:
    """Return the answer by the governing check: of those with this outcome the one with the largest ratio."""
    telling = [check for check, each in zip(checks, said, strict=True) if each == outcome]
    check = max(telling, key=lambda each: inf if each.ratio is None else each.ratio)
    index = _beside(index_of(check, basis), target)
    near, below = is_near(check, index, target, one.tolerance), failure_below(check)
    reason = below if below is not None and outcome == Decision.FAIL else check.reason
    answer = Answer(state.name, outcome, check.procedure, check.ratio, index, reason, near)
    return Found(answer, tuple(checks))


def is_near(check: Check, index: Index | None, target: float | None, tolerance: float) -> bool:
    """Return whether an answer is at the limit: within 5 %, or what the survey or the numerical spread changes."""
    width = max(LEAST_WIDTH, tolerance)
    if index is not None and index.name != IndexKind.DEMAND_CAPACITY and target is not None:
        return abs(index.value / target - 1.0) <= width or _within_spread(check, index, target)
    near = check.ratio is not None and abs(check.ratio - 1.0) <= width
    return near or is_between(check) or failure_below(check) is not None


def _within_spread(check: Check, index: Index, target: float) -> bool:
    """Return whether an index misses its target where 16 % of the draws do not: an index is the PGA at capacity."""
    if target == FULL and (is_between(check) or failure_below(check)):
        return True
    if check.numerical is None or not check.capacity_pga_g or index.value >= target:
        return False
    low = check.numerical.capacity_low_pga_g
    return low is None or index.value * low / check.capacity_pga_g >= target


def _declared(found: Found, lacking: Missing | None) -> Found:
    """Return the answer where the site's action is declared; where not, what it would be if it were."""
    if lacking is None:
        return found
    reason = message("missing-key", {"key": lacking.key, "text": lacking.why[0]}, where=lacking.key)
    answer = replace(
        found.answer, outcome=Decision.INCOMPLETE, provisional=found.answer.outcome, reason=reason, at_the_limit=False
    )
    return Found(answer, found.checks, (lacking,))


def _provisional(check: Check, basis: Basis, target: float | None) -> Decision | None:
    """Return the outcome of a check with the safe value of what is missing; the safe target is the whole one."""
    wanted = whole(basis) if target is None else target
    if check.verdict != Outcome.NOT_ANSWERED:
        return decide(check, basis, wanted) if target is None else None
    if check.provisional is None:
        return None
    return decide(replace(check, verdict=check.provisional, may_pass=True), basis, wanted)


def _of_rank(check: Check, silent: Sequence[Check], ranks: Sequence[Rank]) -> list[Check]:
    """Return the unanswered checks of the methods of the rank that `check` is of."""
    rank = next(each for each in ranks if any(method.procedure == check.procedure for method in each))
    procedures = {method.procedure for method in rank}
    return [each for each in silent if each.procedure in procedures]


def _together(said: Iterable[Decision | None]) -> Decision | None:
    """Return the outcome of methods that must all pass: fail where one fails, pass where none is left open."""
    found = list(said)
    if Decision.FAIL in found:
        return Decision.FAIL
    return None if None in found else Decision.PASS


def _unanswered(
    one: MechanismChecks,
    state: LimitState,
    ranks: Sequence[Rank],
    silent: Sequence[Check],
    basis: Basis,
    target: float | None,
    lacking: Missing | None,
) -> Found:
    """Return the answer where no method was answered: the most refined one gives the reason and the missing keys."""
    missing = (*missing_keys(one.name, silent), *(() if lacking is None else (lacking,)))
    if not silent:
        names = ", ".join(method.procedure for rank in ranks for method in rank) or Term("none")
        reason = message("no-deciding-method", {"state": state.name, "methods": names})
        return Found(Answer(state.name, Decision.INCOMPLETE, "", None, None, reason), (), missing)
    check = silent[0]
    said = _together(_provisional(each, basis, target) for each in _of_rank(check, silent, ranks))
    index = _beside(index_of(check, basis), target)
    answer = Answer(
        state.name, Decision.INCOMPLETE, check.procedure, check.ratio, index, check.reason, provisional=said
    )
    return Found(answer, (), missing)
