"""Sentences on the answer of a mechanism: the check that governs, its margin, what would make it pass."""

from __future__ import annotations

from collections.abc import Iterator

from assess.codes.basis import IndexKind
from assess.codes.check import NEEDED, Check, Outcome
from assess.codes.standing_figures import ratio_figures
from assess.codes.verdict import Answer, Decision, MechanismVerdict, Verdict
from assess.messages.message import DIMENSIONS, Quantity
from assess.results import MechanismResult, Results
from reports import governing
from reports.chapters import premises
from reports.chapters.cells import FIGURES, clause, interval
from reports.chapters.index_text import index_text, is_lowered, outcome_text, state_text, target_text
from reports.document import Facts
from reports.language.texts import Term, Text, count, listing, names, quantity, say
from reports.titles import procedure_title


def sentences(results: Results, mechanism: MechanismResult) -> Iterator[Text]:
    """Yield what governs, up to which action the mechanism holds, and what would make it pass or complete."""
    found, own = results.verdict, governing.verdict_of(results, mechanism)
    if found is None or own is None:
        return
    if not found.basis:
        yield say("No code is named that decides: the results of all methods are for comparison only.")
        return
    for answer in own.answers:
        yield _governing(governing.at_site(results, mechanism), answer)
        yield from _floor(governing_check(governing.at_site(results, mechanism), answer))
        yield from _spread(governing_check(governing.at_site(results, mechanism), answer))
    yield from _failing(own)
    yield from _lowered(own, found)
    yield from _remedy(own, found)
    if own.at_the_limit:
        yield say(
            "The answer is at the limit: within 5 % of it, or within what the tolerance of the survey or the numerical "
            "spread of histories changes."
        )
    if own.conditions:
        yield say("The answer depends on the conditions listed with the verdict.")


def _failing(own: MechanismVerdict) -> Iterator[Text]:
    """Yield why an answer fails whose ratio is within 1, as by histories."""
    for answer in own.answers:
        if answer.outcome == Decision.FAIL and answer.ratio is not None and answer.ratio <= 1.0:
            yield say("It fails although this ratio is not above 1: {reason}.", reason=answer.reason)


def _lowered(own: MechanismVerdict, found: Verdict) -> Iterator[Text]:
    """Yield why a ratio above 1 passes, where the target is less than full safety."""
    above = any(answer.ratio is not None and answer.ratio > 1.0 for answer in own.answers)
    target = target_text(found)
    if own.outcome == Decision.PASS and is_lowered(found) and above and target is not None:
        yield say("It passes, as the target is less than full safety: {target}.", target=target)


def summary(results: Results, mechanism: MechanismResult) -> list[Facts]:
    """Return the verdict of the mechanism with its indices; none without a verdict."""
    own = governing.verdict_of(results, mechanism)
    if own is None:
        return []
    outcome = outcome_text(own.outcome, near=own.at_the_limit)
    found = [(answer.limit_state, index_text(answer.index)) for answer in own.answers if answer.index is not None]
    indices = [
        say("{index} at {state}", index=index, state=state_text(state)) if len(found) > 1 else index
        for state, index in found
    ]
    text = say("{outcome}, {index}", outcome=outcome, index=listing(indices)) if indices else outcome
    known = premises.knowledge_of(results, mechanism)
    if known is not None:
        text = say("{verdict}; knowledge level: {knowledge}", verdict=text, knowledge=premises.factor_text(*known))
    return [Facts(((say("Verdict"), text),))]


def silent_methods(results: Results, mechanism: MechanismResult) -> Iterator[Text]:
    """Yield why methods of codes, besides the one that governs, gave no answer; those with one reason together."""
    own = governing.verdict_of(results, mechanism)
    governs = () if own is None else tuple(answer.procedure for answer in own.answers)
    checks = governing.worst_per_procedure(governing.code_checks(governing.at_site(results, mechanism)))
    silent = [each for each in checks if each.verdict == Outcome.NOT_ANSWERED and each.procedure not in governs]
    for reason in {check.reason.text: check.reason for check in silent}.values():
        same = dict.fromkeys(check.procedure for check in silent if check.reason.text == reason.text)
        yield say("No answer by {methods}: {reason}.", methods=listing(map(procedure_title, same)), reason=reason)


def governing_check(checks: tuple[Check, ...], answer: Answer) -> Check | None:
    """Return the check behind an answer, of those at the site's own action; None where no method was asked."""
    own = tuple(check for check in governing.code_checks(checks) if check.procedure == answer.procedure)
    of_state = tuple(check for check in own if check.limit_state == answer.limit_state)
    return governing.worst(of_state or own)


def _governing(checks: tuple[Check, ...], answer: Answer) -> Text:
    """Return the governing check with its numbers and clause, or why there is none."""
    check = governing_check(checks, answer)
    if check is None or answer.outcome == Decision.INCOMPLETE:
        return _unanswered(answer)
    method, state, by = (
        procedure_title(check.procedure),
        state_text(answer.limit_state),
        Term(clause(check) or check.edition),
    )
    if not check.demand or check.capacity is None or check.ratio is None:
        return say(
            "{method} governs at {state}: {reason} ({clause}).",
            method=method,
            state=state,
            reason=check.reason,
            clause=by,
        )
    figures = ratio_figures(check, most=FIGURES)
    return say(
        "{method} governs at {state}: {quantity} {demand} against an allowable {allowable}, a ratio of {ratio} "
        "({clause}).",
        method=method,
        state=state,
        quantity=Term(check.quantity),
        demand=quantity(check.demand, DIMENSIONS.get(check.unit, "ratio"), figures),
        allowable=quantity(check.capacity, DIMENSIONS.get(check.unit, "ratio"), FIGURES),
        ratio=quantity(check.ratio, "ratio", figures),
        clause=by,
    )


def _floor(check: Check | None) -> Iterator[Text]:
    """Yield which motion of the building a check takes, where it takes that of a floor."""
    steps = {} if check is None else {step.symbol: step for step in check.steps}
    share, period = steps.get("γψ"), steps.get("T1")
    height = next((each.value for each in share.inputs if each.symbol == "Z"), None) if share else None
    if share is None or share.value is None or period is None or period.value is None or height is None:
        return
    yield say(
        "Its demand takes the motion of the building at {height} above the ground: first-mode factor γψ = {share} "
        "({clause}), elastic first period {period}.",
        height=quantity(height, "length", FIGURES),
        share=quantity(share.value, figures=FIGURES),
        clause=Term(share.clause),
        period=quantity(period.value, "time", FIGURES),
    )


def _spread(check: Check | None) -> Iterator[Text]:
    """Yield in how many draws among the runs of histories the rule holds; that is no scatter of earthquakes."""
    if check is None or check.numerical is None or check.verdict not in (Outcome.PASS, Outcome.FAIL):
        return
    yield say(
        "Numerical spread: the rule holds in {share} of {draws} draws among the {runs} runs of each record; a pass "
        "needs {least}. The scatter from record to record is something else, and belongs to the suite.",
        share=quantity(100.0 * check.numerical.holds, "percent", FIGURES),
        draws=count(check.numerical.draws),
        runs=count(check.numerical.runs),
        least=quantity(100.0 * NEEDED, "percent", 2),
    )


def _unanswered(answer: Answer) -> Text:
    """Return why a limit state has no answer, with what it would be."""
    if answer.provisional is None:
        return say(
            "There is no answer for {state}: {reason}.", state=state_text(answer.limit_state), reason=answer.reason
        )
    if answer.provisional == Decision.PASS:
        return say(
            "There is no answer for {state}: {reason}. With the safe value of what is missing it would pass.",
            state=state_text(answer.limit_state),
            reason=answer.reason,
        )
    return say(
        "There is no answer for {state}: {reason}. With the safe value of what is missing it would fail.",
        state=state_text(answer.limit_state),
        reason=answer.reason,
    )


def _remedy(own: MechanismVerdict, found: Verdict) -> Iterator[Text]:
    """Yield the margin of a pass, the factor that a failure lacks, or what is missing."""
    held = None if own.margin is None else _ground(own.margin * found.action.pga_g)
    if own.outcome == Decision.INCOMPLETE:
        if own.missing:
            yield say("An answer needs {keys}.", keys=names(each.key for each in own.missing))
    elif own.outcome == Decision.PASS and own.margin is not None and own.margin_most is not None:
        held_to = interval(own.margin * found.action.pga_g, own.margin_most * found.action.pga_g)
        yield say(
            "It holds up to a peak ground acceleration of {pga}, the numerical spread of the histories; the lower end "
            "counts, {margin} times the site’s own.",
            pga=held_to,
            margin=quantity(own.margin, "ratio", FIGURES),
        )
    elif own.outcome == Decision.PASS and own.margin is not None and held is not None:
        yield say(
            "It holds up to a peak ground acceleration of {pga}, {margin} times the site’s own.",
            pga=held,
            margin=quantity(own.margin, "ratio", FIGURES),
        )
    elif own.outcome == Decision.FAIL:
        yield from _lacking(own, found, held)


def _lacking(own: MechanismVerdict, found: Verdict, held: Quantity | None) -> Iterator[Text]:
    """Yield by how much a mechanism that fails would have to resist more."""
    factor = lacking_factor(own, found)
    if factor is None:
        return
    if held is None:
        yield say("To pass, its resistance must be {factor} times as large.", factor=quantity(factor, "ratio", FIGURES))
    else:
        yield say(
            "It holds up to a peak ground acceleration of {pga}; to pass, this must be {factor} times as large.",
            pga=held,
            factor=quantity(factor, "ratio", FIGURES),
        )


def lacking_factor(own: MechanismVerdict, found: Verdict) -> float | None:
    """Return by how much the resistance of a failing mechanism must grow; None where the numbers do not tell.

    It is the target over the index of the basis, where it has one as a share of the action; else the inverse of the
    margin; else the ratio of demand to capacity.
    """
    failing = [answer for answer in own.answers if answer.outcome == Decision.FAIL]
    shares = [a.index.value for a in failing if a.index is not None and a.index.name != IndexKind.DEMAND_CAPACITY]
    if shares and found.target is not None and min(shares) > 0.0:
        return found.target / min(shares)
    if own.margin is not None and 0.0 < own.margin < 1.0:
        return 1.0 / own.margin
    return max((answer.ratio for answer in failing if answer.ratio is not None), default=None)


def _ground(pga_g: float) -> Quantity:
    return quantity(pga_g, "ground acceleration", FIGURES)
