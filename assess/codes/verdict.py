"""The verdict: one deciding answer for each mechanism and limit state, by the basis that the project names.

A mechanism fails if a deciding answer fails, else it is incomplete if one is missing or there is none, else it passes;
the building is the worst of its mechanisms in that order. `verdict(question, mechanisms)` is a pure function that knows
no formulas. The words of a verdict, for the command line and the report, are English, in SI.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from math import inf, isclose
from typing import Protocol

from assess.codes.bases import Basis, IndexKind, LimitState, LimitStateRole
from assess.codes.check import Check, Outcome
from assess.codes.histories import failure_below, is_between, ratio_figures, side_figures, standing_figures
from assess.codes.question import (
    Action,
    MechanismChecks,
    Missing,
    Question,
    Rank,
    find_limit_states,
    merge_missing,
    methods_of,
    missing_action,
    missing_input,
    missing_keys,
    requested_ranks,
)
from assess.codes.works import FULL, fall_of_index, full_target, target_of
from assess.messages.message import Message, Quantity, Severity, Term, message
from assess.short_repr import ShortRepr


class State(StrEnum):
    """Which state of the project decides."""

    AS_TYPED = "as-typed"
    REPLACED = "unsourced-replaced"


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
    state : of the project, whose mechanisms these are; other_state : the better one, None where nothing differs
    overrides : the values that help, with the outcome without each
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
    state: State = State.AS_TYPED
    other_state: OtherState | None = None
    overrides: tuple[Override, ...] = ()


@dataclass(frozen=True, repr=False)
class Override(ShortRepr):
    """A value that helps, with the outcome of the building where something else stands in its place.

    key, value : as the project file has them; instead : what code or drawing give
    is_value : whether that is a value, and not in words; of_range : whether it is the worst over the plausible range
    source : who vouches for it; empty where nobody does
    margin_instead : PGA at capacity over the action's; 0 for what falls at rest, None where it is not known
    index_instead : the measure of the worst mechanism; None for what falls at rest, and where it is not known
    """

    key: str
    value: str
    instead: str
    outcome_instead: Decision
    source: str = ""
    margin_instead: float | None = None
    of_range: bool = False
    index_instead: Index | None = None
    is_value: bool = False

    @property
    def message(self) -> Message:
        """What the verdict hangs on, in words."""
        end, outcome = "", OUTCOME_TERMS[self.outcome_instead]
        if not self.margin_instead:
            end = "-falls" if self.margin_instead == 0.0 and self.index_instead is None else "-unknown"
        values: dict[str, Quantity | Term | Message | str] = {
            "key": self.key,
            "value": self.value,
            "without": self._without,
            "source": self.source,
            "outcome": outcome if self.index_instead is None or not end else _with_index(outcome, self.index_instead),
            "margin": Quantity(self.margin_instead or 0.0, "ratio", 3),
        }
        key = f"override-{'sourced' if self.source else 'unsourced'}{end}"
        return message(key, values, severity=Severity.WARNING, where=self.key)

    @property
    def _without(self) -> Message:
        if not self.of_range:
            return message("without-value", {"instead": self.instead}) if self.is_value else message("without", {})
        key = "without-value" if self.source else "worst-of-range"  # beside a value with a source one alone is tried
        return message(key, {"instead": Term(self.instead)})


def _with_index(outcome: Term, index: Index) -> Message:
    return message(
        "outcome-with-index", {"outcome": outcome, "name": index.name, "index": Quantity(index.value, "ratio", 3)}
    )


@dataclass(frozen=True, repr=False)
class MechanismOutcome(ShortRepr):
    """The outcome of one mechanism, as in the state that does not decide.

    margin : PGA at capacity over the action's, None where it is not known
    index : the worst of its answers; None where one is not known
    """

    mechanism: str
    outcome: Decision
    margin: float | None
    index: Index | None = None


@dataclass(frozen=True, repr=False)
class OtherState(ShortRepr):
    """The state of the project that does not decide, as no value differs or its outcome is better."""

    outcome: Decision
    mechanisms: tuple[MechanismOutcome, ...]


class Decision(StrEnum):
    """The outcome of a limit state, of a mechanism and of the building."""

    PASS = "pass"
    FAIL = "fail"
    INCOMPLETE = "incomplete"


def worst_outcome(outcomes: Iterable[Decision]) -> Decision:
    """Return the worst of several: fail, then incomplete, then pass; incomplete where there are none."""
    found = set(outcomes)
    if Decision.FAIL in found:
        return Decision.FAIL
    return Decision.INCOMPLETE if Decision.INCOMPLETE in found or not found else Decision.PASS


RANKS = (Decision.PASS, Decision.INCOMPLETE, Decision.FAIL)
SAME_MARGIN = 0.01  # share by which a margin may fall without being worse


def outcome_of(found: MechanismVerdict) -> MechanismOutcome:
    """Return the outcome of a mechanism, with its margin and index."""
    return MechanismOutcome(found.mechanism, found.outcome, found.margin, least_index(found))


def is_worse(one: MechanismOutcome, *, than: MechanismOutcome, same: float = SAME_MARGIN) -> bool:
    """Return whether an outcome is worse than another, or as bad with a margin that is lower by more than a share.

    Where the margins are the same or not known, the indices count so.

    Parameters
    ----------
    one, than : the two
    same : the share
    """
    if one.outcome != than.outcome:
        return RANKS.index(one.outcome) > RANKS.index(than.outcome)
    if one.margin is not None and than.margin is not None:
        least, most = sorted((one.margin, than.margin))
        if least < most * (1.0 - same):
            return one.margin == least
    if one.index is None or than.index is None or one.index.name != than.index.name:
        return False
    if one.index.name == IndexKind.DEMAND_CAPACITY:
        return than.index.value < one.index.value * (1.0 - same)
    return one.index.value < than.index.value * (1.0 - same)


OUTCOME_TERMS = {
    Decision.PASS: Term("pass"),
    Decision.FAIL: Term("fail"),
    Decision.INCOMPLETE: Term("incomplete"),
}


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
    criteria = _Criteria(question, basis, states, target, (*question.missing, *no_state, *no_target))
    found = tuple(_hold_to_before(_decide_mechanism(each, criteria), question) for each in mechanisms)
    of_no_mechanism = Verdict(
        basis=basis.name,
        edition=basis.edition,
        action=question.action,
        target=target,
        outcome=Decision.INCOMPLETE,
        at_the_limit=False,
        conditions=tuple(map(_of_struck_out, question.struck_out)),
        missing=criteria.missing,
        mechanisms=(),
        limit_states=tuple(state.name for state in states),
        methods=methods_of(question),
        clauses=basis.clauses,
        uncompared=basis.uncompared,
    )
    return with_mechanisms(of_no_mechanism, found)


def with_mechanisms(building: Verdict, found: Sequence[MechanismVerdict]) -> Verdict:
    """Return the verdict of a building whose mechanisms come off so.

    Conditions of the building and what is missing for it stay, and those of each mechanism join them.

    Parameters
    ----------
    building : basis, action and target
    found : the verdict of each mechanism
    """
    outcome = worst_outcome(one.outcome for one in found)
    of_mechanisms = [condition for one in building.mechanisms for condition in one.conditions]
    own = [condition for condition in building.conditions if condition not in of_mechanisms]
    return replace(
        building,
        outcome=outcome,
        at_the_limit=_near_limit(outcome, [one.at_the_limit for one in found if one.outcome == outcome]),
        conditions=_unique((*own, *(each for one in found for each in one.conditions))),
        missing=merge_missing((*building.missing, *(each for one in found for each in one.missing))),
        mechanisms=tuple(found),
        index=_index(found),
        provisional=worst_outcome(one.provisional or one.outcome for one in found)
        if outcome == Decision.INCOMPLETE
        else None,
    )


def _of_struck_out(struck: tuple[str, str]) -> Message:
    name, reason = struck
    return message("struck-out", {"name": name, "reason": reason}, severity=Severity.WARNING, where="report.struck_out")


class Falling(Protocol):
    """A mechanism that falls at rest under its own loads."""

    @property
    def name(self) -> str:
        """Its name."""

    @property
    def uplift_multiplier(self) -> float | None:
        """At rest, 0 or negative; None where it is not known."""

    @property
    def reason(self) -> str:
        """Why it falls."""


def add_falling_mechanisms(found: Verdict, falling: Sequence[Falling]) -> Verdict:
    """Return a verdict with the mechanisms that fall under their own loads: each fails, whatever the basis.

    Parameters
    ----------
    found : of the mechanisms that stand
    falling : those that do not
    """
    if not falling:
        return found
    zero = Index(IndexKind.ZETA_E, 0.0) if found.index is not None and found.index.name == IndexKind.ZETA_E else None
    state = next(iter(found.limit_states), "")

    def answer(mechanism: Falling) -> Answer:
        return Answer(state, Decision.FAIL, "", None, zero, falling_message(mechanism))

    fallen = tuple(MechanismVerdict(each.name, Decision.FAIL, 0.0, False, (answer(each),)) for each in falling)
    return replace(
        found,
        outcome=Decision.FAIL,
        at_the_limit=False,
        provisional=None,
        index=zero,
        mechanisms=(*found.mechanisms, *fallen),
    )


FALLS = "falls-at-rest"


def falling_message(mechanism: Falling) -> Message:
    """Return why a mechanism fails that falls under its own loads, with its multiplier."""
    values: dict[str, Quantity | Term | Message | str] = {"reason": mechanism.reason}
    if mechanism.uplift_multiplier is not None:
        values["multiplier"] = Quantity(mechanism.uplift_multiplier, "ratio", 3)
    key = FALLS if "multiplier" in values else f"{FALLS}-unknown"
    return message(key, values, severity=Severity.WARNING, where=f"mechanisms.{mechanism.name}")


@dataclass(frozen=True)
class _Criteria:
    """What every mechanism is compared with."""

    question: Question
    basis: Basis
    states: tuple[LimitState, ...]
    target: float | None
    missing: tuple[Missing, ...]


INDEX_FIGURES = 3  # of an index
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
class AnswerAndChecks:
    """An answer with the checks behind it, none where nothing decided, and the keys that are missing."""

    answer: Answer
    checks: tuple[Check, ...] = ()
    missing: tuple[Missing, ...] = ()


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
    index, full = index_of(check, basis), full_target(basis)
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
        return None if index is None else Index(basis.index, index, figures=_index_figures(check))
    if basis.index == IndexKind.NBS:
        share = check.score.get(IndexKind.NBS)
        return None if share is None else Index(basis.index, share, grade(share))
    return (
        None
        if check.ratio is None
        else Index(basis.index, check.ratio, figures=ratio_figures(check, most=INDEX_FIGURES))
    )


def grade(share: float) -> str:
    """Return the grade of a share of the new building standard [%] (NZSEE 2017, Table A3.1)."""
    return "A+" if share > 100.0 else next(name for least, name in GRADES if share >= least)


def is_near(check: Check, index: Index | None, target: float | None, tolerance: float) -> bool:
    """Return whether an answer is at the limit: within 5 %, or what the survey or the numerical spread changes."""
    width = max(LEAST_WIDTH, tolerance)
    if index is not None and index.name != IndexKind.DEMAND_CAPACITY and target is not None:
        return abs(index.value / target - 1.0) <= width or _within_spread(check, index, target)
    near = check.ratio is not None and abs(check.ratio - 1.0) <= width
    return near or is_between(check) or failure_below(check) is not None


def mark_deciding(
    checks: Sequence[Check], found: MechanismVerdict, basis: Basis | None, action: Action
) -> tuple[Check, ...]:
    """Return the checks with the role of those that decide; all others are for comparison.

    Parameters
    ----------
    checks : of one mechanism
    found : its verdict
    basis : the rules of the code; None where none is named
    action : of the site

    Returns
    -------
    tuple of Check
    """
    return tuple(
        replace(check, role="deciding")
        if any(_is_behind(check, each, basis, action) for each in found.answers)
        else check
        for check in checks
    )


def find_deciding_check(checks: Sequence[Check], answer: Answer, basis: Basis | None, action: Action) -> Check | None:
    """Return the check behind an answer; None where nothing decided.

    Parameters
    ----------
    checks : of one mechanism
    answer : of one limit state
    basis : the rules of the code; None where none is named
    action : of the site

    Returns
    -------
    Check or None
    """
    return next((check for check in checks if _is_behind(check, answer, basis, action)), None)


AT_THE_LIMIT = " at the limit"
NAME_BEHIND_VALUE = ("%NBS",)  # indices whose name stands behind their value


def outcome_text(outcome: Decision, *, near: bool) -> str:
    """Return the outcome in words: "fail", or "fail at the limit".

    Parameters
    ----------
    outcome : pass, fail or incomplete
    near : whether it is at the limit

    Returns
    -------
    str
    """
    return outcome.value + (AT_THE_LIMIT if near and outcome != Decision.INCOMPLETE else "")


def named_index_text(index: Index | None) -> str:
    """Return an index with its name and grade, as "zeta_E 0.83" or "45 %NBS, grade C"; empty where there is none."""
    if index is None:
        return ""
    value = number_text(index.value, index.figures)
    text = f"{value} {index.name}" if index.name in NAME_BEHIND_VALUE else f"{index.name} {value}"
    return f"{text}, grade {index.grade}" if index.grade else text


def building_index_text(verdict: Verdict) -> str:
    """Return the index of the building, which local mechanisms alone can only bound; empty where none is known."""
    if verdict.index is None:
        return ""
    bound = "at least" if verdict.index.name == "D/C" else "at most"
    return f"{bound} {named_index_text(verdict.index)}"


def target_text(verdict: Verdict) -> str:
    """Return the target that the index is compared with; empty where that is not known."""
    return "" if verdict.target is None else f"{verdict.target:.3g}"


def number_text(value: float, number: int = 3) -> str:
    """Return a number to three figures, or as many as requested, with trailing zeros: 1.00 for one.

    Parameters
    ----------
    value : the number
    number : of figures
    """
    return f"{value:#.{number}g}".rstrip(".") if value else "0"


def action_text(action: Action) -> str:
    """Return the site's own action in words: PGA, limit state and return period as far as they are known."""
    known = [f"PGA {action.pga_g:.3g} g"]
    known += [f"stated for {action.limit_state}"] if action.limit_state else []
    known += ["each limit state by the hazard of the site"] if action.over_periods else []
    known += [f"return period {action.return_period_years:.0f} years"] if action.return_period_years else []
    return ", ".join(known)


def relevant_warnings(warnings: Sequence[Message]) -> tuple[Message, ...]:
    """Return the messages that bear on a verdict: all but notes, and why a mechanism falls, which is its reason."""
    return tuple(each for each in warnings if each.severity != Severity.NOTE and not each.key.startswith(FALLS))


def _decide_mechanism(mechanism: MechanismChecks, criteria: _Criteria) -> MechanismVerdict:
    """Decide one mechanism; numbers that pass do not make up for an input that is missing."""
    answers = [
        _find_answer(mechanism, state, criteria.question, criteria.basis, criteria.target) for state in criteria.states
    ]
    found = _by_class(answers, criteria)
    provisional = (*criteria.question.provisional, *mechanism.provisional)
    if provisional:
        found = tuple(replace(each, answer=_not_shown(each.answer)) for each in found)
    own = (missing for each in found for missing in each.missing)
    missing = merge_missing((*own, *mechanism.missing, *provisional))
    outcome = worst_outcome(each.answer.outcome for each in found)
    if outcome == Decision.PASS and (missing or criteria.missing):
        outcome = Decision.INCOMPLETE
    incomplete = outcome == Decision.INCOMPLETE
    return MechanismVerdict(
        mechanism=mechanism.name,
        outcome=outcome,
        margin=_margin([check for each in found for check in each.checks]),
        margin_most=_margin_most([check for each in found for check in each.checks]),
        at_the_limit=_near_limit(
            outcome, [each.answer.at_the_limit for each in found if each.answer.outcome == outcome]
        ),
        answers=tuple(each.answer for each in found),
        conditions=()
        if outcome == Decision.FAIL
        else _unique((*_conditions(mechanism, found), *_of_class(answers, criteria))),
        missing=missing if incomplete else (),
        provisional=_provisional_of_mechanism(found, missing, criteria) if incomplete else None,
    )


def _hold_to_before(found: MechanismVerdict, question: Question) -> MechanismVerdict:
    """Return the verdict of a mechanism, which fails where works lower an index that they are not to lower."""
    least = least_index(found)
    falls = fall_of_index(question, found.mechanism, None if least is None else least.value)
    if falls is None:
        return found
    answers = (
        replace(each, outcome=Decision.FAIL, reason=falls, provisional=None) if each.index == least else each
        for each in found.answers
    )
    return replace(
        found,
        outcome=Decision.FAIL,
        at_the_limit=False,
        answers=tuple(answers),
        conditions=(),
        missing=(),
        provisional=None,
    )


def _not_shown(answer: Answer) -> Answer:
    """Return an answer that rests on a provisional value: incomplete, whether it would pass or fail."""
    would_be = answer.provisional or answer.outcome
    if would_be == Decision.INCOMPLETE:
        return answer
    return replace(answer, outcome=Decision.INCOMPLETE, provisional=would_be)


def _near_limit(outcome: Decision, those: Sequence[bool]) -> bool:
    """Return whether the verdict is at the limit: one pass at the limit is enough, but all failures must be."""
    return all(those) if outcome == Decision.FAIL else any(those)


def _provisional_of_mechanism(
    found: Sequence[AnswerAndChecks], missing: Sequence[Missing], criteria: _Criteria
) -> Decision | None:
    """Return the provisional outcome; None where an input is lacking without which a pass may be too good."""
    if criteria.question.missing:
        return None
    would_be = worst_outcome(each.answer.provisional or each.answer.outcome for each in found)
    return None if would_be == Decision.PASS and any(each.enlarges for each in missing) else would_be


def _by_class(found: Sequence[AnswerAndChecks], criteria: _Criteria) -> tuple[AnswerAndChecks, ...]:
    """Return the answers that count where the class of use is not given: the chosen limit state's, and failures.

    A failure of another limit state then makes the mechanism incomplete, for want of the class.
    """
    if criteria.question.use_class is not None:
        return tuple(found)
    besides = {state.name for state in criteria.states if state.role == LimitStateRole.BESIDES}
    kept: list[AnswerAndChecks] = []
    for each in found:
        if each.answer.limit_state not in besides:
            kept.append(each)
        elif each.answer.outcome == Decision.FAIL:
            why = message("missing-class-by-state", {"state": each.answer.limit_state})
            missing = missing_input("building.use_class", why, 'use_class = "II"')
            answer = replace(each.answer, outcome=Decision.INCOMPLETE, provisional=Decision.FAIL)
            kept.append(AnswerAndChecks(answer, each.checks, (missing,)))
    return tuple(kept)


def _of_class(answers: Sequence[AnswerAndChecks], criteria: _Criteria) -> tuple[Message, ...]:
    """Return the condition of a pass where the class of use is not given and a limit state was not answered."""
    if criteria.question.use_class is not None:
        return ()
    besides = {state.name for state in criteria.states if state.role == LimitStateRole.BESIDES}
    incomplete = [each.answer.limit_state for each in answers if each.answer.outcome == Decision.INCOMPLETE]
    names = ", ".join(name for name in incomplete if name in besides)
    return (message("class-not-given", {"states": names}, severity=Severity.WARNING),) if names else ()


def _conditions(mechanism: MechanismChecks, found: Sequence[AnswerAndChecks]) -> tuple[Message, ...]:
    return _unique(
        (
            *mechanism.conditions,
            *(condition for each in found for check in each.checks for condition in check.conditions),
        )
    )


def _margin(checks: Sequence[Check]) -> float | None:
    """Return the least PGA at capacity of the checks that decide, over the action's; None where one is not known."""
    margins = [margin_of(check) for check in checks]
    known = [margin for margin in margins if margin is not None]
    return min(known) if known and len(known) == len(margins) else None


def _margin_most(checks: Sequence[Check]) -> float | None:
    """Return the margin of the same check up to which 16 % of its draws hold; None where that is no more."""
    margin = _margin(checks)
    check = next((check for check in checks if margin is not None and margin_of(check) == margin), None)
    if check is None or check.numerical is None or not margin or not check.capacity_pga_g:
        return None
    low = check.numerical.capacity_16_pga_g
    return margin * low / check.capacity_pga_g if low is not None and low > check.capacity_pga_g else None


def margin_of(check: Check) -> float | None:
    """Return the PGA at capacity of a check over that of its level; None where it is not known."""
    if check.safety_index is not None:
        return check.safety_index
    return None if check.capacity_pga_g is None else check.capacity_pga_g / check.level_pga_g


def least_index(found: MechanismVerdict) -> Index | None:
    """Return the index of a mechanism, the worst of its answers'; None where one has none."""
    return _index([found])


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
        missing=merge_missing((missing, *question.missing)),
        mechanisms=tuple(silent),
    )


def _find_answer(
    mechanism: MechanismChecks, state: LimitState, question: Question, basis: Basis, target: float | None
) -> AnswerAndChecks:
    """Find the answer of the most refined method that may decide and was answered.

    Methods of one rank must all pass: one that fails decides, one that is missing lets the next rank answer.

    Parameters
    ----------
    mechanism : with its checks
    state : the limit state
    question : what the project asks
    basis : the rules of the code
    target : of the index; None where it is not known

    Returns
    -------
    AnswerAndChecks
    """
    ranks = requested_ranks(state, question.procedures)
    undeclared = missing_action(state, question.action)
    unanswered: list[Check] = []
    for rank in ranks:
        checks = [check for method in rank for check in _of_method(mechanism, method.procedure, state, question.action)]
        decisions = [decide(check, basis, target) for check in checks]
        if Decision.FAIL in decisions or (
            decisions and None not in decisions and _every_method(checks, mechanism, rank, state)
        ):
            outcome = worst_outcome(each for each in decisions if each is not None)
            return _declared(_answered(mechanism, checks, decisions, state, outcome, basis, target), undeclared)
        unanswered += [check for check, each in zip(checks, decisions, strict=True) if each is None]
    return _unanswered(mechanism, state, ranks, unanswered, basis, target, undeclared)


def _every_method(checks: Sequence[Check], mechanism: MechanismChecks, rank: Rank, state: LimitState) -> bool:
    """Return whether each method of a rank gave a check; one that gives several does not count for another."""
    return {check.procedure for check in checks}.issuperset(_applying(mechanism, rank, state))


def _applying(mechanism: MechanismChecks, rank: Rank, state: LimitState) -> list[str]:
    """Return the methods of a rank that cover such a mechanism."""
    no = {
        check.procedure
        for check in mechanism.checks
        if check.verdict == Outcome.NOT_APPLICABLE and _is_of(check, state)
    }
    return [method.procedure for method in rank if method.procedure not in no]


def _is_of(check: Check, state: LimitState) -> bool:
    return state.checked_as in (check.limit_state, "*")


def _of_method(mechanism: MechanismChecks, procedure: str, state: LimitState, action: Action) -> list[Check]:
    return [
        check
        for check in mechanism.checks
        if check.procedure == procedure
        and _is_of(check, state)
        and check.follows_code
        and check.verdict != Outcome.NOT_APPLICABLE
        and at_action(check, action)
    ]


def at_action(check: Check, action: Action) -> bool:
    """Return whether a check is at the site's own action.

    Parameters
    ----------
    check : of a mechanism
    action : of the site
    """
    return isclose(check.level_pga_g, action.pga_g, rel_tol=1e-9)


def _index_figures(check: Check) -> int:
    """Return to how many figures, one at least, the PGA at capacity stands up to that of 16 % of the draws."""
    low = None if check.numerical is None else check.numerical.capacity_16_pga_g
    if low is None or check.capacity_pga_g is None:
        return INDEX_FIGURES
    return max(1, standing_figures(check.capacity_pga_g, (low,), most=INDEX_FIGURES))


def _show_side_of_target(index: Index | None, target: float | None) -> Index | None:
    """Return an index with as many figures as show it on its side of the target."""
    if index is None or target is None:
        return index
    return replace(index, figures=side_figures(index.value, index.figures, limit=target))


def _answered(
    mechanism: MechanismChecks,
    checks: Sequence[Check],
    decisions: Sequence[Decision | None],
    state: LimitState,
    outcome: Decision,
    basis: Basis,
    target: float | None,
) -> AnswerAndChecks:
    """Return the answer by the governing check: of those with this outcome the one with the largest ratio."""
    governing = [check for check, each in zip(checks, decisions, strict=True) if each == outcome]
    check = max(governing, key=lambda each: inf if each.ratio is None else each.ratio)
    index = _show_side_of_target(index_of(check, basis), target)
    near, below = is_near(check, index, target, mechanism.tolerance), failure_below(check)
    reason = below if below is not None and outcome == Decision.FAIL else check.reason
    answer = Answer(state.name, outcome, check.procedure, check.ratio, index, reason, near)
    return AnswerAndChecks(answer, tuple(checks))


def _within_spread(check: Check, index: Index, target: float) -> bool:
    """Return whether an index misses its target where 16 % of the draws do not: an index is the PGA at capacity."""
    if target == FULL and (is_between(check) or failure_below(check)):
        return True
    if check.numerical is None or not check.capacity_pga_g or index.value >= target:
        return False
    low = check.numerical.capacity_16_pga_g
    return low is None or index.value * low / check.capacity_pga_g >= target


def _declared(found: AnswerAndChecks, undeclared: Missing | None) -> AnswerAndChecks:
    """Return the answer where the site's action is declared; where not, what it would be if it were."""
    if undeclared is None:
        return found
    reason = message("missing-key", {"key": undeclared.key, "text": undeclared.why[0]}, where=undeclared.key)
    answer = replace(
        found.answer, outcome=Decision.INCOMPLETE, provisional=found.answer.outcome, reason=reason, at_the_limit=False
    )
    return AnswerAndChecks(answer, found.checks, (undeclared,))


def _unanswered(
    mechanism: MechanismChecks,
    state: LimitState,
    ranks: Sequence[Rank],
    unanswered: Sequence[Check],
    basis: Basis,
    target: float | None,
    undeclared: Missing | None,
) -> AnswerAndChecks:
    """Return the answer where no method was answered: the most refined one gives the reason and the missing keys."""
    missing = (*missing_keys(mechanism.name, unanswered), *(() if undeclared is None else (undeclared,)))
    if not unanswered:
        names = ", ".join(method.procedure for rank in ranks for method in rank) or Term("none")
        reason = message("no-deciding-method", {"state": state.name, "methods": names})
        return AnswerAndChecks(Answer(state.name, Decision.INCOMPLETE, "", None, None, reason), (), missing)
    check = unanswered[0]
    provisional = _outcome_of_rank(
        _provisional_of_check(each, basis, target) for each in _of_rank(check, unanswered, ranks)
    )
    index = _show_side_of_target(index_of(check, basis), target)
    answer = Answer(
        state.name, Decision.INCOMPLETE, check.procedure, check.ratio, index, check.reason, provisional=provisional
    )
    known = target is None and check.verdict != Outcome.NOT_ANSWERED  # how far it holds depends on no target
    return AnswerAndChecks(answer, tuple(_of_rank(check, unanswered, ranks)) if known else (), missing)


def _provisional_of_check(check: Check, basis: Basis, target: float | None) -> Decision | None:
    """Return the outcome of a check with the safe value of what is missing; the safe target is the whole one."""
    safe_target = full_target(basis) if target is None else target
    if check.verdict != Outcome.NOT_ANSWERED:
        return decide(check, basis, safe_target) if target is None else None
    if check.provisional is None:
        return None
    return decide(replace(check, verdict=check.provisional, may_pass=True), basis, safe_target)


def _of_rank(check: Check, unanswered: Sequence[Check], ranks: Sequence[Rank]) -> list[Check]:
    """Return the unanswered checks of the methods of the rank that `check` is of."""
    rank = next(each for each in ranks if any(method.procedure == check.procedure for method in each))
    procedures = {method.procedure for method in rank}
    return [each for each in unanswered if each.procedure in procedures]


def _outcome_of_rank(decisions: Iterable[Decision | None]) -> Decision | None:
    """Return the outcome of methods that must all pass: fail where one fails, pass where none is left open."""
    known = list(decisions)
    if Decision.FAIL in known:
        return Decision.FAIL
    return None if None in known else Decision.PASS


def _is_behind(check: Check, answer: Answer, basis: Basis | None, action: Action) -> bool:
    if basis is None or check.procedure != answer.procedure or not check.follows_code:
        return False
    states = {state.checked_as for state in basis.states if state.name == answer.limit_state}
    decides = check.verdict in (Outcome.PASS, Outcome.FAIL)
    return decides and bool(states & {check.limit_state, "*"}) and at_action(check, action)
