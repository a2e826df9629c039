"""The verdict of each mechanism and of the building, from the deciding answers.

A mechanism fails if a deciding answer fails, else it is incomplete if one is missing or there is none, else it passes;
the building is the worst of its mechanisms in that order.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from assess.codes.basis import Basis, IndexKind, LimitState, Role
from assess.codes.check import Check
from assess.codes.verdict.answer import Answer, Found, Index, find_answer
from assess.codes.verdict.methods import find_limit_states, methods_of
from assess.codes.verdict.outcome import Decision, worst
from assess.codes.verdict.question import Action, MechanismChecks, Missing, Question, missing_input, once
from assess.codes.verdict.target import target_of
from assess.messages.message import Message, Severity, message
from assess.short_repr import ShortRepr


@dataclass(frozen=True, repr=False)
class MechanismVerdict(ShortRepr):
    """The verdict of one mechanism.

    margin : PGA at capacity over the action's, None where it is not known
    margin_most : the same up to which 16 % of the draws among runs of histories hold; None where that is no more
    provisional : of an incomplete one, what it would be with the safe value of what is missing; else None
    """

    mechanism: str
    outcome: Decision
    margin: float | None
    at_the_limit: bool
    answers: tuple[Answer, ...]
    conditions: tuple[Message, ...] = ()
    missing: tuple[Missing, ...] = ()
    provisional: Decision | None = None
    margin_most: float | None = None


@dataclass(frozen=True, repr=False)
class Verdict(ShortRepr):
    """The verdict of the building at the site's own action.

    limit_states, methods : that decide
    index : "at most" the least of the mechanisms', as they are local ones only; of a ratio of demand to capacity the
        largest; None where one is not known
    clauses : rule and clause of the basis; uncompared : what could not be compared with any text of the standard
    """

    basis: str
    edition: str
    action: Action
    target: float | None
    outcome: Decision
    at_the_limit: bool
    conditions: tuple[Message, ...]
    missing: tuple[Missing, ...]
    mechanisms: tuple[MechanismVerdict, ...]
    limit_states: tuple[str, ...] = ()
    methods: tuple[str, ...] = ()
    index: Index | None = None
    provisional: Decision | None = None
    clauses: tuple[tuple[str, str], ...] = ()
    uncompared: tuple[str, ...] = ()


@dataclass(frozen=True)
class _Measure:
    """What every mechanism is compared with."""

    question: Question
    basis: Basis
    states: tuple[LimitState, ...]
    target: float | None
    missing: tuple[Missing, ...]


def verdict(question: Question, mechanisms: Sequence[MechanismChecks]) -> Verdict:
    """Return the verdict of the building and of each of its mechanisms.

    Parameters
    ----------
    question : what the project asks of its basis
    mechanisms : with their checks

    Returns
    -------
    Verdict
    """
    basis = question.basis
    if basis is None:
        return _without_basis(question, mechanisms)
    states, no_state = find_limit_states(question)
    target, no_target = target_of(question, basis)
    measure = _Measure(question, basis, states, target, (*question.missing, *no_state, *no_target))
    found = tuple(_of_mechanism(each, measure) for each in mechanisms)
    outcome = worst(one.outcome for one in found)
    return Verdict(
        basis=basis.name,
        edition=basis.edition,
        action=question.action,
        target=target,
        outcome=outcome,
        at_the_limit=_near_limit(outcome, [one.at_the_limit for one in found if one.outcome == outcome]),
        conditions=_unique(each for one in found for each in one.conditions),
        missing=once((*measure.missing, *(each for one in found for each in one.missing))),
        mechanisms=found,
        limit_states=tuple(state.name for state in states),
        methods=methods_of(question),
        index=_index(found),
        provisional=worst(one.provisional or one.outcome for one in found) if outcome == Decision.INCOMPLETE else None,
        clauses=basis.clauses,
        uncompared=basis.uncompared,
    )


def _near_limit(outcome: Decision, those: Sequence[bool]) -> bool:
    """Return whether the verdict is at the limit: one pass at the limit is enough, but all failures must be."""
    return all(those) if outcome == Decision.FAIL else any(those)


def _of_mechanism(one: MechanismChecks, measure: _Measure) -> MechanismVerdict:
    """Decide one mechanism; numbers that pass do not make up for an input that is missing."""
    asked = [find_answer(one, state, measure.question, measure.basis, measure.target) for state in measure.states]
    found = _by_class(asked, measure)
    missing = once((*(each for it in found for each in it.missing), *one.missing))
    outcome = worst(it.answer.outcome for it in found)
    if outcome == Decision.PASS and (missing or measure.missing):
        outcome = Decision.INCOMPLETE
    incomplete = outcome == Decision.INCOMPLETE
    return MechanismVerdict(
        mechanism=one.name,
        outcome=outcome,
        margin=_margin([check for it in found for check in it.checks]),
        margin_most=_margin_most([check for it in found for check in it.checks]),
        at_the_limit=_near_limit(outcome, [it.answer.at_the_limit for it in found if it.answer.outcome == outcome]),
        answers=tuple(it.answer for it in found),
        conditions=() if outcome == Decision.FAIL else _unique((*_conditions(one, found), *_of_class(asked, measure))),
        missing=missing if incomplete else (),
        provisional=_provisional(found, measure) if incomplete else None,
    )


def _provisional(found: Sequence[Found], measure: _Measure) -> Decision | None:
    """Return the provisional outcome; None where the project lacks an input without a safe value."""
    return None if measure.question.missing else worst(it.answer.provisional or it.answer.outcome for it in found)


def _by_class(found: Sequence[Found], measure: _Measure) -> tuple[Found, ...]:
    """Return the answers that count where the class of use is not given: the chosen limit state's, and failures.

    A failure of another limit state then makes the mechanism incomplete, for want of the class.
    """
    if measure.question.use_class is not None:
        return tuple(found)
    besides = {state.name for state in measure.states if state.role == Role.BESIDES}
    kept: list[Found] = []
    for it in found:
        if it.answer.limit_state not in besides:
            kept.append(it)
        elif it.answer.outcome == Decision.FAIL:
            why = message("missing-class-by-state", {"state": it.answer.limit_state})
            missing = missing_input("building.use_class", why, 'use_class = "II"')
            answer = replace(it.answer, outcome=Decision.INCOMPLETE, provisional=Decision.FAIL)
            kept.append(Found(answer, it.checks, (missing,)))
    return tuple(kept)


def _of_class(asked: Sequence[Found], measure: _Measure) -> tuple[Message, ...]:
    """Return the condition of a pass where the class of use is not given and a limit state was not answered."""
    if measure.question.use_class is not None:
        return ()
    besides = {state.name for state in measure.states if state.role == Role.BESIDES}
    silent = [it.answer.limit_state for it in asked if it.answer.outcome == Decision.INCOMPLETE]
    names = ", ".join(name for name in silent if name in besides)
    return (message("class-not-given", {"states": names}, severity=Severity.WARNING),) if names else ()


def _conditions(one: MechanismChecks, found: Sequence[Found]) -> tuple[Message, ...]:
    return _unique((*one.conditions, *(each for it in found for check in it.checks for each in check.conditions)))


def _margin(checks: Sequence[Check]) -> float | None:
    """Return the least PGA at capacity of the checks that decide, over the action's; None where one is not known."""
    margins = [_margin_of(check) for check in checks]
    known = [margin for margin in margins if margin is not None]
    return min(known) if known and len(known) == len(margins) else None


def _margin_most(checks: Sequence[Check]) -> float | None:
    """Return the margin of the same check up to which 16 % of its draws hold; None where that is no more."""
    margin = _margin(checks)
    check = next((check for check in checks if margin is not None and _margin_of(check) == margin), None)
    if check is None or check.numerical is None or not margin or not check.capacity_pga_g:
        return None
    low = check.numerical.capacity_low_pga_g
    return margin * low / check.capacity_pga_g if low is not None and low > check.capacity_pga_g else None


def _margin_of(check: Check) -> float | None:
    if check.safety_index is not None:
        return check.safety_index
    return None if check.capacity_pga_g is None else check.capacity_pga_g / check.level_pga_g


def _index(found: Sequence[MechanismVerdict]) -> Index | None:
    """Return the index of the building: the worst of its mechanisms'."""
    indices = [answer.index for one in found for answer in one.answers]
    known = [index for index in indices if index is not None]
    if not known or len(known) < len(indices):
        return None
    return max(known, key=lambda each: each.value if each.name == IndexKind.DEMAND_CAPACITY else -each.value)


def _unique(messages: Iterable[Message]) -> tuple[Message, ...]:
    kept: list[Message] = []
    for each in messages:
        if each not in kept:
            kept.append(each)
    return tuple(kept)


def _without_basis(question: Question, mechanisms: Sequence[MechanismChecks]) -> Verdict:
    """Return a verdict that is incomplete: no basis is named, and the site's spectrum has no default."""
    why = message("missing-basis")
    missing = missing_input("verdict.basis", why, 'basis = "asce43-05"')
    reason = message("missing-key", {"key": missing.key, "text": why}, where=missing.key)
    answer = Answer("", Decision.INCOMPLETE, "", None, None, reason)
    silent = (MechanismVerdict(each.name, Decision.INCOMPLETE, None, False, (answer,)) for each in mechanisms)
    return Verdict(
        basis="",
        edition="",
        action=question.action,
        target=None,
        outcome=Decision.INCOMPLETE,
        at_the_limit=False,
        conditions=(),
        missing=once((missing, *question.missing)),
        mechanisms=tuple(silent),
    )
