"""The verdict: one deciding answer for each mechanism and limit state, by the basis that the project names.

    verdict(question, mechanisms) -> Verdict      a pure function; what stands here knows nothing of formulas

For one limit state the most refined method that may decide and was answered decides; a less refined one never outvotes
it. A mechanism fails if a deciding answer fails, else it is incomplete if one is missing, else it passes; the building
is the worst of its mechanisms in that order.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum
from math import isclose
from typing import Literal

from assess.codes.basis import Acceptance, Basis, IndexKind, LimitState, Method, Role
from assess.codes.check import Check, Outcome
from assess.message import Message, Quantity, message

LEAST_WIDTH = 0.05  # of the threshold: answers nearer to it are "at the limit"
Works = Literal["none", "repair", "improvement", "upgrading"]
GRADES = ((1.0, "A+"), (0.80, "A"), (0.67, "B"), (0.34, "C"), (0.20, "D"), (0.0, "E"))
"""Grades of the New Zealand guidelines by the least share of the standard; A+ lies above it."""
IMPROVED, RAISED, UPGRADED = 0.60, 0.10, 0.80  # NTC 8.4.2, 8.4.3


class Decision(StrEnum):
    """What a verdict says of a mechanism, and of the building."""

    PASS = "pass"
    FAIL = "fail"
    INCOMPLETE = "incomplete"


@dataclass(frozen=True)
class Missing:
    """An input without which there is no answer: its key in the project file, why, and a line of TOML to begin with."""

    key: str
    text: str
    toml: str = ""


@dataclass(frozen=True)
class Action:
    """What the site's own spectrum stands for.

    limit_state : that of a single spectrum, None where nobody says; over_periods : whether the site gives its hazard
    over return periods, so that each limit state has a spectrum of its own
    """

    pga_g: float
    limit_state: str | None
    return_period_years: float | None = None
    over_periods: bool = False


@dataclass(frozen=True)
class Question:
    """What the project asks of its basis.

    basis : None where none is named and the site has no default
    limit_state, procedures : as the project names them; None where it does not
    works, use_class, school, upgrading, index_before : of the targets of NTC 8.4; target_nbs : in percent
    missing : what the whole project lacks
    """

    basis: Basis | None
    action: Action
    limit_state: str | None = None
    procedures: tuple[str, ...] | None = None
    works: Works = "none"
    use_class: str | None = None
    school: bool | None = None
    upgrading: str | None = None
    index_before: float | None = None
    target_nbs: float | None = None
    missing: tuple[Missing, ...] = ()


@dataclass(frozen=True)
class Judged:
    """One mechanism as the verdict sees it.

    missing : what a pass needs and nobody gave; conditions : what a pass rests on
    tolerance : the relative change of the index when the survey's tolerance goes the bad way [-]
    """

    name: str
    checks: tuple[Check, ...]
    missing: tuple[Missing, ...] = ()
    conditions: tuple[Message, ...] = ()
    tolerance: float = 0.0


@dataclass(frozen=True)
class Index:
    """What the code counts the answer in: its name, and its value."""

    name: str
    value: float
    grade: str = ""


@dataclass(frozen=True)
class Answer:
    """The deciding answer of one limit state; procedure is empty where none decided."""

    limit_state: str
    outcome: Decision
    procedure: str
    ratio: float | None
    index: Index | None
    reason: Message
    at_the_limit: bool = False
    provisional: Decision | None = None


@dataclass(frozen=True)
class MechanismVerdict:
    """The verdict of one mechanism.

    margin : PGA at capacity over the action's, None where unknown; provisional : what it would be with the safe value
    of each input that is missing, None where it is not incomplete or no such value exists
    """

    mechanism: str
    outcome: Decision
    margin: float | None
    at_the_limit: bool
    answers: tuple[Answer, ...]
    conditions: tuple[Message, ...] = ()
    missing: tuple[Missing, ...] = ()
    provisional: Decision | None = None


@dataclass(frozen=True)
class Verdict:
    """The verdict of the building, at the site's own action; `index` is "at most": of local mechanisms only."""

    basis: str
    edition: str
    action: Action
    limit_states: tuple[str, ...]
    methods: tuple[str, ...]
    target: float | None
    outcome: Decision
    at_the_limit: bool
    conditions: tuple[Message, ...]
    missing: tuple[Missing, ...]
    mechanisms: tuple[MechanismVerdict, ...]
    index: Index | None = None
    provisional: Decision | None = None
    clauses: tuple[tuple[str, str], ...] = ()
    uncompared: tuple[str, ...] = ()


@dataclass(frozen=True)
class _Asked:
    """What each mechanism is measured by: limit states, target, and what is missing for all."""

    states: tuple[LimitState, ...]
    target: float | None
    missing: tuple[Missing, ...] = field(default=())


def verdict(question: Question, mechanisms: Sequence[Judged]) -> Verdict:
    """Decide the building and each mechanism at the site's own action."""
    basis = question.basis
    if basis is None:
        return _without_basis(question, mechanisms)
    states, lacking = deciding_states(question)
    target, unknown = target_of(question)
    asked = _Asked(states, target, (*question.missing, *lacking, *unknown))
    found = tuple(_of_mechanism(each, question, basis, asked) for each in mechanisms)
    outcome = worst(one.outcome for one in found)
    missing = _once((*asked.missing, *(each for one in found for each in one.missing)))
    return Verdict(
        basis=basis.name,
        edition=basis.edition,
        action=question.action,
        limit_states=tuple(state.name for state in states),
        methods=tuple(dict.fromkeys(method for state in states for method in methods_asked(state, question))),
        target=target,
        outcome=outcome,
        at_the_limit=any(one.at_the_limit and one.outcome == outcome for one in found),
        conditions=_conditions(found),
        missing=missing,
        mechanisms=found,
        index=_least(found),
        provisional=_provisional(found) if outcome == Decision.INCOMPLETE else None,
        clauses=basis.clauses,
        uncompared=basis.uncompared,
    )


def deciding_states(question: Question) -> tuple[tuple[LimitState, ...], tuple[Missing, ...]]:
    """Find the limit states that decide, and what is missing to know them.

    One is chosen for the building; others decide besides it in some classes of use. Where the class is not given, those
    others are asked too, and one that fails makes the verdict incomplete.
    """
    basis = question.basis
    assert basis is not None
    name = question.limit_state or basis.default or _declared(basis, question.action)
    chosen = [state for state in basis.chosen if state.name == name]
    if not chosen:
        names = ", ".join(state.name for state in basis.chosen)
        missing = Missing("verdict.limit_state", f"which limit state decides: {names}", f'limit_state = "{names}"')
        return (), (missing,)
    besides = [state for state in basis.states if state.role == Role.BESIDES]
    asked = [state for state in besides if question.use_class is None or question.use_class in state.classes]
    return (*chosen, *asked), ()


def _declared(basis: Basis, action: Action) -> str:
    """The limit state that the site's own action belongs to; empty where nobody says."""
    return next((state.name for state in basis.chosen if action.limit_state in state.actions), "")


def methods_asked(state: LimitState, question: Question) -> tuple[str, ...]:
    """The procedures that may decide a limit state, in order of refinement."""
    return tuple(method.procedure for rank in _ranks_asked(state, question.procedures) for method in rank)


def _ranks_asked(state: LimitState, named: tuple[str, ...] | None) -> tuple[tuple[Method, ...], ...]:
    """The methods of each rank that the project asks for; where it names none of a state's, those accepted unnamed."""
    every = [method for rank in state.ranks for method in rank]
    known = {method.procedure for method in every}
    names = set(named or ()) & known
    if not names:
        names = {method.procedure for method in every if method.acceptance == Acceptance.ACCEPTED}
    ranks = (tuple(m for m in rank if m.procedure in names and not names & set(m.yields_to)) for rank in state.ranks)
    return tuple(rank for rank in ranks if rank)


def target_of(question: Question) -> tuple[float | None, tuple[Missing, ...]]:
    """Find what the index is compared with, and what is missing to know it (NTC 8.4.2, 8.4.3; C8 of NZSEE 2017)."""
    basis = question.basis
    assert basis is not None
    if basis.index == IndexKind.NBS:
        if question.target_nbs is None:
            text = "the share of the new building standard to be reached, 34, 67 or 100, has no default"
            return None, (Missing("verdict.target_nbs", text, "target_nbs = 67"),)
        return question.target_nbs / 100.0, ()
    if basis.index == IndexKind.DEMAND_CAPACITY or question.works == "none":
        return 1.0, ()
    return _OF_WORKS[question.works](question)


def _repaired(question: Question) -> tuple[float | None, tuple[Missing, ...]]:
    text = (
        'a local repair has no threshold (NTC 8.4.1): set the indices before and after beside each other; write "none"'
    )
    return None, (Missing("verdict.works", text, 'works = "none"'),)


def _improved(question: Question) -> tuple[float | None, tuple[Missing, ...]]:
    if question.use_class is None:
        text = "class of use, on which the target of an improvement hangs (NTC 8.4.2)"
        return None, (Missing("building.use_class", text, 'use_class = "II"'),)
    if question.use_class == "III" and question.school is None:
        text = "whether the building is a school, for which class III asks 0.60 (NTC 8.4.2)"
        return None, (Missing("building.school", text, "school = false"),)
    if question.use_class == "IV" or (question.use_class == "III" and question.school):
        return IMPROVED, ()
    if question.index_before is None:
        text = "the index before the works, which an improvement has to raise by 0.10 (NTC 8.4.2)"
        return None, (Missing("verdict.index_before", text, "index_before = 0.40"),)
    return question.index_before + RAISED, ()


def _upgraded(question: Question) -> tuple[float | None, tuple[Missing, ...]]:
    return (UPGRADED if question.upgrading in ("c", "e") else 1.0), ()


_OF_WORKS = {"repair": _repaired, "improvement": _improved, "upgrading": _upgraded}


def _of_mechanism(one: Judged, question: Question, basis: Basis, asked: _Asked) -> MechanismVerdict:
    found = [_answer(one, state, question, basis, asked.target) for state in asked.states]
    answers = [answer for answer, _ in found]
    lacking = tuple(each for _, each in found if each is not None)
    answers = _without_class(answers, asked.states, question)
    outcome = worst(answer.outcome for answer in answers) if answers else Decision.INCOMPLETE
    missing = _once((*lacking, *one.missing))
    provisional = worst(answer.provisional or answer.outcome for answer in answers) if answers else None
    if outcome == Decision.PASS and (missing or asked.missing):
        outcome = Decision.INCOMPLETE
    if Role.BESIDES in {state.role for state in asked.states} and question.use_class is None:
        missing = _once((*missing, *_class_needed(answers, asked.states)))
    deciding = [answer for answer in answers if answer.outcome == outcome] or answers
    return MechanismVerdict(
        mechanism=one.name,
        outcome=outcome,
        margin=_margin(one, answers, question.action),
        at_the_limit=any(answer.at_the_limit for answer in deciding),
        answers=tuple(answers),
        conditions=_of_pass(one, answers, question) if outcome != Decision.FAIL else (),
        missing=missing if outcome == Decision.INCOMPLETE else (),
        provisional=provisional if outcome == Decision.INCOMPLETE else None,
    )


def _without_class(answers: list[Answer], states: tuple[LimitState, ...], question: Question) -> list[Answer]:
    """Where the class of use is not given, a limit state besides the chosen one cannot fail the mechanism, nor pass."""
    if question.use_class is not None:
        return answers
    besides = {state.name for state in states if state.role == Role.BESIDES}
    kept = []
    for answer in answers:
        if answer.limit_state not in besides:
            kept.append(answer)
        elif answer.outcome == Decision.FAIL:
            kept.append(replace(answer, outcome=Decision.INCOMPLETE, provisional=Decision.FAIL))
    return kept


def _class_needed(answers: Sequence[Answer], states: tuple[LimitState, ...]) -> tuple[Missing, ...]:
    besides = {state.name for state in states if state.role == Role.BESIDES}
    failing = [answer.limit_state for answer in answers if answer.limit_state in besides]
    if not failing:
        return ()
    text = f"{', '.join(failing)} fails, which decides in class of use IV"
    return (Missing("building.use_class", text, 'use_class = "II"'),)


def _answer(
    one: Judged, state: LimitState, question: Question, basis: Basis, target: float | None
) -> tuple[Answer, Missing | None]:
    """The deciding answer of one limit state, with what is missing where there is none."""
    ranks, action = _ranks_asked(state, question.procedures), question.action
    undeclared = _undeclared(state, action)
    remembered: Check | None = None
    for rank in ranks:
        checks = [check for method in rank for check in _of_method(one, method, state, action)]
        decided = [_decided(check, basis, target) for check in checks]
        if checks and len(checks) >= len(rank) and (Decision.FAIL in decided or set(decided) == {Decision.PASS}):
            outcome = worst(each for each in decided if each is not None)
            check = _telling(checks, decided, outcome)
            answer = _answered(check, state, outcome, basis, target, one.tolerance)
            if undeclared is None:
                return answer, None
            provisional = replace(answer, outcome=Decision.INCOMPLETE, provisional=answer.outcome)
            return replace(provisional, reason=_message_of(undeclared)), undeclared
        remembered = remembered or next((check for check in checks if check.verdict == Outcome.NOT_ANSWERED), None)
    return _unanswered(state, ranks, remembered, basis, target), undeclared


def _undeclared(state: LimitState, action: Action) -> Missing | None:
    """A single spectrum decides only the limit state that the site declares."""
    if action.over_periods or action.limit_state in state.actions or state.actions == ("*",):
        return None
    names = " or ".join(state.actions)
    if action.limit_state is None:
        text = f"what the site's single spectrum stands for; {state.name} is decided by the action of {names}"
    else:
        text = f"the site's spectrum is that of {action.limit_state}; {state.name} asks for the action of {names}"
    return Missing("site.limit_state", text, f'limit_state = "{state.actions[0]}"')


def _of_method(one: Judged, method: Method, state: LimitState, action: Action) -> list[Check]:
    return [
        check
        for check in one.checks
        if check.procedure == method.procedure
        and state.checked_as in (check.limit_state, "*")
        and check.reading == "letter"
        and not check.informs
        and check.verdict != Outcome.NOT_APPLICABLE
        and isclose(check.level_pga_g, action.pga_g, rel_tol=1e-9)
    ]


def _decided(check: Check, basis: Basis, target: float | None) -> Decision | None:
    """What a check says beside the target; None where it says nothing."""
    if check.verdict == Outcome.NOT_ANSWERED:
        return None
    index = index_of(check, basis)
    if target is None:
        return None
    if basis.index == IndexKind.DEMAND_CAPACITY or index is None or target == 1.0:
        if target > 1.0 and index is None:
            return Decision.FAIL if check.verdict == Outcome.FAIL else None
        if target < 1.0 and check.verdict == Outcome.FAIL:
            return None
        holds = check.verdict == Outcome.PASS
    else:
        holds = index.value >= target
    if holds and not check.may_pass:
        return None
    return Decision.PASS if holds else Decision.FAIL


def index_of(check: Check, basis: Basis) -> Index | None:
    """What the code counts the check in; %NBS as a share."""
    if basis.index == IndexKind.ZETA_E:
        return None if check.safety_index is None else Index("zeta_E", check.safety_index)
    if basis.index == IndexKind.NBS:
        share = check.score.get(IndexKind.NBS)
        return None if share is None else Index("%NBS", share / 100.0, grade(share / 100.0))
    return None if check.ratio is None else Index("D/C", check.ratio)


def grade(share: float) -> str:
    """The grade of a share of the new building standard (NZSEE 2017, A3)."""
    if share > GRADES[0][0]:
        return GRADES[0][1]
    return next(name for least, name in GRADES[1:] if share >= least)


def _telling(checks: Sequence[Check], decided: Sequence[Decision | None], outcome: Decision) -> Check:
    """Of several checks that must all hold, the one that tells: of those that decide, the largest ratio."""
    telling = [check for check, each in zip(checks, decided, strict=True) if each == outcome]
    return max(telling, key=lambda check: float("inf") if check.ratio is None else check.ratio)


def _answered(
    check: Check, state: LimitState, outcome: Decision, basis: Basis, target: float | None, tolerance: float
) -> Answer:
    index = index_of(check, basis)
    return Answer(
        state.name, outcome, check.procedure, check.ratio, index, check.reason, _near(check, index, target, tolerance)
    )


def _near(check: Check, index: Index | None, target: float | None, tolerance: float) -> bool:
    """Whether an answer lies within the width of the threshold."""
    width = max(LEAST_WIDTH, tolerance)
    if index is not None and index.name != "D/C" and target is not None:
        return abs(index.value / target - 1.0) <= width
    return check.ratio is not None and abs(check.ratio - 1.0) <= width


def _unanswered(
    state: LimitState, ranks: Sequence[Sequence[Method]], check: Check | None, basis: Basis, target: float | None
) -> Answer:
    if check is None:
        names = ", ".join(method.procedure for rank in ranks for method in rank)
        reason = message("no-deciding-method", {"state": state.name, "methods": names or "none"})
        return Answer(state.name, Decision.INCOMPLETE, "", None, None, reason)
    said = None
    if check.provisional is not None:
        said = _decided(replace(check, verdict=check.provisional, may_pass=True), basis, target)
    index = index_of(check, basis)
    return Answer(state.name, Decision.INCOMPLETE, check.procedure, check.ratio, index, check.reason, provisional=said)


def _message_of(missing: Missing) -> Message:
    return message("missing-key", {"key": missing.key, "text": missing.text}, where=missing.key)


def _of_pass(one: Judged, answers: Sequence[Answer], question: Question) -> tuple[Message, ...]:
    """What the deciding checks and the mechanism rest on."""
    deciding = {(answer.procedure, answer.limit_state) for answer in answers}
    basis = question.basis
    assert basis is not None
    names = {state.checked_as: state.name for state in basis.states}
    own = [
        each
        for check in one.checks
        if (check.procedure, names.get(check.limit_state, "")) in deciding
        and isclose(check.level_pga_g, question.action.pga_g, rel_tol=1e-9)
        for each in check.conditions
    ]
    return _unique((*one.conditions, *own))


def _margin(one: Judged, answers: Sequence[Answer], action: Action) -> float | None:
    """The least PGA at capacity of the deciding answers over the action's; None where one is not known."""
    deciding = {(answer.procedure, answer.limit_state) for answer in answers if answer.procedure}
    found: list[float] = []
    for check in one.checks:
        of_answer = any(check.procedure == procedure for procedure, _ in deciding)
        if not of_answer or not isclose(check.level_pga_g, action.pga_g, rel_tol=1e-9) or check.informs:
            continue
        if check.safety_index is not None:
            found.append(check.safety_index)
        elif check.capacity_pga_g is not None:
            found.append(check.capacity_pga_g / check.level_pga_g)
        else:
            return None
    return min(found, default=None)


def worst(outcomes: object) -> Decision:
    """The worst of several: fail, then incomplete, then pass; incomplete where there are none."""
    found = set(outcomes)  # type: ignore[call-overload]
    if Decision.FAIL in found:
        return Decision.FAIL
    return Decision.INCOMPLETE if Decision.INCOMPLETE in found or not found else Decision.PASS


def _provisional(found: Sequence[MechanismVerdict]) -> Decision | None:
    said = [one.provisional or one.outcome for one in found]
    return worst(said) if said else None


def _least(found: Sequence[MechanismVerdict]) -> Index | None:
    """The least index over the mechanisms; of a ratio of demand to capacity the largest. None where one is unknown."""
    indices = [answer.index for one in found for answer in one.answers]
    if not indices or any(index is None for index in indices):
        return None
    known = [index for index in indices if index is not None]
    return max(known, key=lambda index: index.value if index.name == "D/C" else -index.value)


def _conditions(found: Sequence[MechanismVerdict]) -> tuple[Message, ...]:
    return _unique(each for one in found for each in one.conditions)


def _unique(messages: object) -> tuple[Message, ...]:
    kept: list[Message] = []
    for each in messages:  # type: ignore[attr-defined]
        if each not in kept:
            kept.append(each)
    return tuple(kept)


def _once(missing: Sequence[Missing]) -> tuple[Missing, ...]:
    """Each missing key once, with all its reasons."""
    texts: dict[str, list[Missing]] = {}
    for each in missing:
        texts.setdefault(each.key, []).append(each)
    return tuple(
        replace(group[0], text="; ".join(dict.fromkeys(each.text for each in group))) for group in texts.values()
    )


def _without_basis(question: Question, mechanisms: Sequence[Judged]) -> Verdict:
    text = "which code decides; nothing follows from the site's spectrum"
    missing = Missing("verdict.basis", text, 'basis = "asce43-05"')
    reason = message("missing-key", {"key": missing.key, "text": missing.text}, where=missing.key)
    silent = tuple(
        MechanismVerdict(
            each.name, Decision.INCOMPLETE, None, False, (Answer("", Decision.INCOMPLETE, "", None, None, reason),)
        )
        for each in mechanisms
    )
    return Verdict(
        basis="",
        edition="",
        action=question.action,
        limit_states=(),
        methods=(),
        target=None,
        outcome=Decision.INCOMPLETE,
        at_the_limit=False,
        conditions=(),
        missing=(missing, *question.missing),
        mechanisms=silent,
    )


def with_roles(
    checks: Sequence[Check], found: MechanismVerdict, basis: Basis | None, action: Action
) -> tuple[Check, ...]:
    """The checks of a mechanism, those that decide marked as such."""
    names: Mapping[str, str] = {} if basis is None else {state.checked_as: state.name for state in basis.states}
    if basis is not None and len(set(names)) < len(basis.states):  # two limit states by one check
        names = {check.limit_state: answer.limit_state for answer in found.answers for check in checks}
    deciding = {(answer.procedure, answer.limit_state) for answer in found.answers}

    def decides(check: Check) -> bool:
        at_site = isclose(check.level_pga_g, action.pga_g, rel_tol=1e-9)
        own = (check.procedure, names.get(check.limit_state, "")) in deciding
        return at_site and own and not check.informs and check.reading == "letter"

    return tuple(replace(check, role="deciding") if decides(check) else check for check in checks)


def holds_to(found: MechanismVerdict, action: Action) -> Quantity | None:
    """The PGA up to which a mechanism holds; None where it is not known."""
    return None if found.margin is None else Quantity(found.margin * action.pga_g, "ground acceleration", 3)
