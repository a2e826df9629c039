"""The verdict of one mechanism in sentences: the check that governs, its margin, and what would make it pass."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import isclose

from assess.codes.calculation_sheet import Step
from assess.codes.check import NEEDED, Check, Family, Outcome
from assess.codes.histories import margin_figures, ratio_figures
from assess.codes.procedures import family_of
from assess.codes.verdict import Answer, Decision, MechanismVerdict, Verdict
from assess.messages.message import DIMENSIONS
from assess.results import MechanismResult, Results
from reports import governing
from reports.chapters import cells
from reports.document import Equations, Facts
from reports.language.texts import Term, Text, count, listing, quantity, say
from reports.language.value_names import key_words
from reports.mechanisms import procedure_title


def verdict_summary(results: Results, mechanism: MechanismResult) -> list[Facts]:
    """Return the verdict of the mechanism with its indices; none without a verdict."""
    mechanism_verdict = governing.verdict_of(results, mechanism)
    if mechanism_verdict is None:
        return []
    outcome = cells.outcome_text(mechanism_verdict.outcome, near=mechanism_verdict.at_the_limit)
    found = [
        (answer.limit_state, cells.index_text(answer.index))
        for answer in mechanism_verdict.answers
        if answer.index is not None
    ]
    indices = [
        say("{index} at {state}", index=index, state=cells.state_text(state)) if len(found) > 1 else index
        for state, index in found
    ]
    text = say("{outcome}, {index}", outcome=outcome, index=listing(indices)) if indices else outcome
    known = cells.mechanism_knowledge(results, mechanism)
    if known is not None:
        text = say("{verdict}; knowledge level: {knowledge}", verdict=text, knowledge=cells.factor_text(*known))
    return [Facts(((say("Verdict"), text),))]


def verdict_sentences(results: Results, mechanism: MechanismResult) -> Iterator[Text]:
    """Yield what governs, up to which action the mechanism holds, and what would make it pass or complete."""
    verdict, mechanism_verdict = results.verdict, governing.verdict_of(results, mechanism)
    if verdict is None or mechanism_verdict is None:
        return
    if not verdict.basis:
        yield say("No code is named that decides: the results of all methods are for comparison only.")
        return
    for answer in mechanism_verdict.answers:
        check = _governing_check(governing.checks_at_site(results, mechanism), answer)
        yield _governing_sentence(check, answer)
        yield from _floor_motion(check)
        yield from _numerical_spread(check)
    yield from _failing_within_ratio(mechanism_verdict)
    yield from _passing_by_target(mechanism_verdict, verdict)
    tabled = [
        _governing_check(governing.checks_at_site(results, mechanism), each)
        for each in _failing_by_table(mechanism_verdict)
    ]
    if tabled:
        yield from _slender(tabled)
    else:
        yield from _margin_or_lack(mechanism_verdict, verdict)
    if mechanism_verdict.at_the_limit:
        yield say(
            "The answer is at the limit: within 5 % of it, or within what the tolerance of the survey or the numerical "
            "spread of histories changes."
        )
    if mechanism_verdict.conditions:
        yield say("The answer depends on the conditions listed with the verdict.")


def comparison_clause(check: Check) -> str:
    """Return the clause by which a check compares demand and capacity; empty without steps."""
    shown = [value for value in (check.ratio, check.demand, check.capacity) if value is not None]
    steps = check.steps[::-1]
    found = (step for value in shown for step in steps if step.value is not None and isclose(step.value, value))
    return next((step.clause for step in found), steps[0].clause if steps else "")


def unanswered_methods(results: Results, mechanism: MechanismResult) -> Iterator[Text]:
    """Yield why methods of codes, besides the one that governs, gave no answer; those with one reason together."""
    mechanism_verdict = governing.verdict_of(results, mechanism)
    governs = () if mechanism_verdict is None else tuple(answer.procedure for answer in mechanism_verdict.answers)
    checks = governing.worst_per_procedure(governing.code_checks_at_site(results, mechanism))
    unanswered = [each for each in checks if each.verdict == Outcome.NOT_ANSWERED and each.procedure not in governs]
    for reason in {check.reason.text: check.reason for check in unanswered}.values():
        same = dict.fromkeys(check.procedure for check in unanswered if check.reason.text == reason.text)
        yield say("No answer by {methods}: {reason}.", methods=listing(map(procedure_title, same)), reason=reason)


def governing_steps(results: Results, mechanism: MechanismResult) -> Iterator[Equations]:
    """Yield the steps to the number that decides at each limit state, from which it can be redone.

    Left out is what is read between two points of a curve, which the annex has, and what the index is turned into.
    """
    mechanism_verdict = governing.verdict_of(results, mechanism)
    for answer in () if mechanism_verdict is None else mechanism_verdict.answers:
        check = _governing_check(governing.checks_at_site(results, mechanism), answer)
        if check is not None and check.verdict != Outcome.NOT_ANSWERED:
            steps = tuple(step for step in check.steps if step.value is not None and not _between_points(step))
            state = cells.state_text(answer.limit_state)
            yield Equations(say("{method}, {state}:", method=procedure_title(check.procedure), state=state), steps)


def _between_points(step: Step) -> bool:
    """Return whether a formula has the points of a curve: numbered symbols, two at least."""
    return sum(each.symbol[-2:-1] == "_" and each.symbol[-1:].isdigit() for each in step.inputs) > 1


def _governing_check(checks: tuple[Check, ...], answer: Answer) -> Check | None:
    """Return the check behind an answer, of those at the site's own action; None where no method was asked."""
    own = tuple(check for check in governing.code_checks(checks) if check.procedure == answer.procedure)
    of_state = tuple(check for check in own if check.limit_state == answer.limit_state)
    return governing.worst_check(of_state or own)


def _governing_sentence(check: Check | None, answer: Answer) -> Text:
    """Return the governing check with its numbers and clause, or why there is none."""
    if check is None or answer.outcome == Decision.INCOMPLETE:
        return _unanswered(answer)
    method, state, by = (
        procedure_title(check.procedure),
        cells.state_text(answer.limit_state),
        Term(comparison_clause(check) or check.edition),
    )
    if not check.demand or check.capacity is None or check.ratio is None:
        return say(
            "{method} governs at {state}: {reason} ({clause}).",
            method=method,
            state=state,
            reason=check.reason,
            clause=by,
        )
    figures = ratio_figures(check, most=cells.FIGURES)
    return say(
        "{method} governs at {state}: {quantity} {demand} against an allowable {allowable}, a ratio of {ratio} "
        "({clause}).",
        method=method,
        state=state,
        quantity=Term(check.quantity),
        demand=quantity(check.demand, DIMENSIONS.get(check.unit, "ratio"), figures),
        allowable=quantity(check.capacity, DIMENSIONS.get(check.unit, "ratio"), cells.FIGURES),
        ratio=quantity(check.ratio, "ratio", figures),
        clause=by,
    )


def _unanswered(answer: Answer) -> Text:
    """Return why a limit state has no answer, with what it would be."""
    if answer.provisional is None:
        return say(
            "There is no answer for {state}: {reason}.",
            state=cells.state_text(answer.limit_state),
            reason=answer.reason,
        )
    if answer.provisional == Decision.PASS:
        return say(
            "There is no answer for {state}: {reason}. With the safe value of what is missing it would pass.",
            state=cells.state_text(answer.limit_state),
            reason=answer.reason,
        )
    return say(
        "There is no answer for {state}: {reason}. With the safe value of what is missing it would fail.",
        state=cells.state_text(answer.limit_state),
        reason=answer.reason,
    )


def _floor_motion(check: Check | None) -> Iterator[Text]:
    """Yield which motion of the building a check takes, where it takes that of a floor."""
    steps = {} if check is None else {step.symbol: step for step in check.steps}
    share, period = steps.get("γψ"), steps.get("T1")
    height = next((each.value for each in share.inputs if each.symbol == "Z"), None) if share else None
    if share is None or share.value is None or period is None or period.value is None or height is None:
        return
    yield say(
        "Its demand takes the motion of the building at {height} above the ground: first-mode factor γψ = {share} "
        "({clause}), elastic first period {period}.",
        height=quantity(height, "length", cells.FIGURES),
        share=quantity(share.value, figures=cells.FIGURES),
        clause=Term(share.clause),
        period=quantity(period.value, "time", cells.FIGURES),
    )


def _numerical_spread(check: Check | None) -> Iterator[Text]:
    """Yield for how many choices among the runs of histories the rule holds; that is no scatter of earthquakes."""
    if check is None or check.numerical is None or check.verdict not in (Outcome.PASS, Outcome.FAIL):
        return
    yield say(
        "Numerical spread: the rule holds for {share} of the choices among the {runs} runs of each record; a pass "
        "needs {least}.",
        share=quantity(100.0 * check.numerical.holds, "percent", cells.FIGURES),
        runs=count(check.numerical.runs),
        least=quantity(100.0 * NEEDED, "percent", 2),
    )


def _failing_within_ratio(mechanism_verdict: MechanismVerdict) -> Iterator[Text]:
    """Yield why an answer fails whose ratio is within 1, as by histories."""
    for answer in mechanism_verdict.answers:
        if answer.outcome == Decision.FAIL and answer.ratio is not None and answer.ratio <= 1.0:
            yield say("It fails although this ratio is not above 1: {reason}.", reason=answer.reason)


def _passing_by_target(mechanism_verdict: MechanismVerdict, verdict: Verdict) -> Iterator[Text]:
    """Yield why a ratio above 1 passes, where the target is less than full safety."""
    above = any(answer.ratio is not None and answer.ratio > 1.0 for answer in mechanism_verdict.answers)
    target = cells.target_text(verdict)
    if (
        mechanism_verdict.outcome == Decision.PASS
        and cells.has_reduced_target(verdict)
        and above
        and target is not None
    ):
        yield say("It passes, as the target is less than full safety: {target}.", target=target)


def _margin_or_lack(mechanism_verdict: MechanismVerdict, verdict: Verdict) -> Iterator[Text]:
    """Yield the margin of a pass, the factor that a failure lacks, or what is missing."""
    outcome, margin, most = mechanism_verdict.outcome, mechanism_verdict.margin, mechanism_verdict.margin_most
    pga = None if margin is None else cells.capacity_pga_text(mechanism_verdict, margin, verdict.action)
    if outcome == Decision.INCOMPLETE:
        if mechanism_verdict.missing:
            needed = dict.fromkeys(key_words(each.key) for each in mechanism_verdict.missing)
            yield say("An answer needs: {keys}.", keys=listing(needed))
    elif outcome == Decision.FAIL:
        yield from _lacking(mechanism_verdict, verdict, pga)
    elif margin is not None and pga is not None and most is not None:
        yield say(
            "It holds up to a peak ground acceleration of {pga}, the numerical spread of the histories; the lower end "
            "counts, {margin} times the site’s own.",
            pga=pga,
            margin=quantity(margin, "ratio", margin_figures(margin, most)),
        )
    elif margin is not None and pga is not None:
        yield say(
            "It holds up to a peak ground acceleration of {pga}, {margin} times the site’s own.",
            pga=pga,
            margin=quantity(margin, "ratio", margin_figures(margin, most)),
        )


def _failing_by_table(mechanism_verdict: MechanismVerdict) -> list[Answer]:
    """Return the answers that fail by a table of slenderness, which states no action that a wall bears."""
    failing = (each for each in mechanism_verdict.answers if each.outcome == Decision.FAIL)
    return [each for each in failing if family_of(each.procedure) == Family.TABLE]


def _slender(checks: Iterable[Check | None]) -> Iterator[Text]:
    """Yield to what slenderness a wall would have to come."""
    for check in checks:
        if check is not None and check.demand is not None and check.capacity is not None:
            yield say(
                "To pass, its slenderness h/t of {slenderness} must not exceed {permitted}.",
                slenderness=quantity(check.demand, figures=cells.FIGURES),
                permitted=quantity(check.capacity, figures=cells.FIGURES),
            )


def _lacking(mechanism_verdict: MechanismVerdict, verdict: Verdict, pga: Text | None) -> Iterator[Text]:
    """Yield by how much a mechanism that fails would have to resist more. pga : up to which it holds, if known."""
    factor = cells.required_increase(mechanism_verdict, verdict)
    if factor is None:
        return
    shown = quantity(factor, "ratio", cells.required_increase_figures(mechanism_verdict, factor))
    if pga is None:
        yield say("To pass, its resistance must be {factor} times as large.", factor=shown)
    else:
        yield say(
            "It holds up to a peak ground acceleration of {pga}; to pass, this must be {factor} times as large.",
            pga=pga,
            factor=shown,
        )
