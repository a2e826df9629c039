"""Conclusions in sentences: the critical mechanism and its margin, and where procedures disagree."""

from __future__ import annotations

from collections.abc import Iterator
from statistics import median

from assess.codes.check import Family, Outcome
from assess.codes.families import FAMILIES, uses_histories
from assess.codes.verdict import MechanismVerdict
from assess.codes.verdict_text import margin_text
from assess.results import MechanismResult, Results, SuiteResult
from reports import governing
from reports.language.lettering import truncate
from reports.language.lists import join_names, list_names
from reports.language.numerals import numeral
from reports.mechanism_title import mechanism_title

LONGEST = 40  # characters of a name in a sentence
MEASURES = {
    Family.DISPLACEMENT: "compares the displacement capacity with the spectral displacement at the secant period",
    Family.LINEAR: "checks the acceleration that starts the motion, reduced by q, not the rotation that follows",
    Family.ENERGY: (
        "replaces the rocking body by an equivalent oscillator of equal work, with the damping of its impacts"
    ),
    Family.PART: "compares the rotation capacity of the wall with the spectral rotation of a part at its floor",
    Family.TABLE: "looks up the ratio of height to thickness that the spectrum at 1 s allows, whatever the load",
    Family.ELEMENT: "compares the force on a part at its floor, reduced by q_a, with the force that starts the motion",
    Family.HISTORY: (
        "follows each record with its impacts and the order of its pulses, and fails where one overturns the body"
    ),
    Family.SLIDING: "estimates how far the body slides, without rocking",
    Family.FRICTION: "checks whether friction holds until rocking starts",
}


def conclusions(results: Results) -> tuple[str, ...]:
    """Return the sentences, most important first, without those that do not apply."""
    own = governing.site_pga(results)
    return (
        *_critical_mechanism(results),
        *disagreements(results, () if own is None else (own,)),
        *_spread(results),
        *_overturning_records(results),
        *_weakest_pulses(results),
    )


def short_title(mechanism: MechanismResult) -> str:
    """Return the title of a mechanism for use in a sentence."""
    return truncate(mechanism_title(mechanism), LONGEST)


def _critical_mechanism(results: Results) -> Iterator[str]:
    """Yield the mechanism with the smallest margin by the deciding procedures, and the runner-up."""
    ranked = ranking(results)
    if not ranked or results.verdict is None:
        return
    action, ((first, least), *others) = results.verdict.action, ranked
    margin = f"{margin_text(least, action)}, by {_deciding_procedures(least)}"
    sentence = f"The critical mechanism is {short_title(first)}: it holds up to {margin}"
    if others:
        runner_up, other = others[0]
        margin = f"{margin_text(other, action)}, by {_deciding_procedures(other)}"
        sentence += f"; next is {short_title(runner_up)} with {margin}"
    yield f"{sentence}."


def _deciding_procedures(one: MechanismVerdict) -> str:
    return join_names(dict.fromkeys(answer.procedure for answer in one.answers if answer.procedure))


def ranking(results: Results) -> list[tuple[MechanismResult, MechanismVerdict]]:
    """Sort the mechanisms by the margin of their verdict, smallest first, without those of unknown margin."""
    verdicts = {} if results.verdict is None else {one.mechanism: one for one in results.verdict.mechanisms}
    pairs = ((m, verdicts[m.name]) for m in results.mechanisms if m.name in verdicts)
    return sorted((pair for pair in pairs if pair[1].margin is not None), key=lambda pair: pair[1].margin or 0.0)


def disagreements(results: Results, levels: tuple[float, ...]) -> Iterator[str]:
    """Yield, for each level where procedures disagree, which mechanisms fail by which; then what each measures."""
    failing: dict[str, None] = {}
    for level in levels:
        apart = [m for m in results.mechanisms if _is_disputed(m, level)]
        if not apart:
            continue
        by = {
            procedure: _failing_mechanisms(apart, level, procedure) for procedure in _answering_procedures(apart, level)
        }
        fails = "; ".join(f"{procedure} fails {list_names(names)}" for procedure, names in by.items() if names)
        passing = [procedure for procedure, names in by.items() if not names]
        rest = f"; {list_names(passing)} {'passes' if len(passing) == 1 else 'pass'} all of these" if passing else ""
        disputed = list_names([short_title(m) for m in apart])
        yield f"For comparison: at PGA {level:.3g} g the procedures disagree on {disputed}: {fails}{rest}."
        failing |= dict.fromkeys(by)
    reasons = [f"{procedure} {measure}" for procedure in failing if (measure := describe_procedure(procedure))]
    if reasons:
        yield f"They measure different margins: {'; '.join(reasons)}."


def describe_procedure(procedure: str) -> str:
    """Return what a procedure measures; empty for one that is not known."""
    return MEASURES[FAMILIES[procedure]] if procedure in FAMILIES else ""


def _answering_procedures(mechanisms: list[MechanismResult], level: float) -> dict[str, None]:
    checks = (check for m in mechanisms for check in governing.code_checks(governing.at_level(m.checks, level)))
    return dict.fromkeys(check.procedure for check in checks if check.verdict in (Outcome.PASS, Outcome.FAIL))


def _is_disputed(mechanism: MechanismResult, level: float) -> bool:
    checks = governing.code_checks(governing.at_level(mechanism.checks, level))
    return {Outcome.PASS, Outcome.FAIL} <= {check.verdict for check in checks}


def _failing_mechanisms(mechanisms: list[MechanismResult], level: float, procedure: str) -> list[str]:
    def fails(mechanism: MechanismResult) -> bool:
        checks = governing.code_checks(governing.at_level(mechanism.checks, level))
        return any(check.procedure == procedure and check.verdict == Outcome.FAIL for check in checks)

    return [short_title(mechanism) for mechanism in mechanisms if fails(mechanism)]


def _spread(results: Results) -> Iterator[str]:
    """Yield the spread of the procedures in PGA at capacity."""
    spreads = []
    for mechanism in results.mechanisms:
        known = governing.capacities(governing.code_checks(mechanism.checks))
        if len(known) > 1 and min(known.values()) > 0.0:
            low, high = min(known, key=lambda name: known[name]), max(known, key=lambda name: known[name])
            spreads.append((known[high] / known[low], mechanism, low, high))
    if not spreads:
        return
    largest, mechanism, low, high = max(spreads, key=lambda spread: spread[0])
    middle = f"{numeral(median(spread[0] for spread in spreads), digits=3)} in the median, " if len(spreads) > 1 else ""
    yield (
        "For comparison: the largest PGA at capacity of a mechanism over its least one, by another code procedure, "
        f"is {middle}at most {numeral(largest, digits=3)} ({short_title(mechanism)}: {high} over {low})."
    )


def _overturning_records(results: Results) -> Iterator[str]:
    """Yield how many records overturn which mechanisms."""
    fallen = [(m, suite) for m in results.mechanisms for suite in m.suites if suite.overturned]
    if fallen:
        each = list_names([_overturning_share(mechanism, suite) for mechanism, suite in fallen])
        yield f"In the time histories records overturn {each}. No other history overturns a mechanism."
    elif any(mechanism.suites for mechanism in results.mechanisms):
        sentence = "In the time histories no record overturns a mechanism at the levels requested"
        yield f"{sentence}{_factored_exception(results)}."


def _factored_exception(results: Results) -> str:
    """Return the procedures on records that still find overturning: with a confidence factor, or at another PGA."""
    fallen = dict.fromkeys(
        governing.procedure_label(check, mechanism.checks)
        for mechanism in results.mechanisms
        for check in mechanism.checks
        if uses_histories(check.procedure) and governing.is_overturned(check)
    )
    if not fallen:
        return ""
    return f"; {list_names(list(fallen))}, with the confidence factor or at the PGA of another limit state, finds some"


def _overturning_share(mechanism: MechanismResult, suite: SuiteResult) -> str:
    return f"{short_title(mechanism)} at {suite.level_pga_g:.3g} g ({suite.overturned} of {suite.n})"


def _weakest_pulses(results: Results) -> Iterator[str]:
    """Yield the mechanism that the weakest pulse overturns, where envelopes were requested."""
    if results.critical is None:
        return
    bands = [(band, band.mechanism) for band in results.critical.bands if band.mechanism is not None]
    if bands:
        names = {mechanism.name: short_title(mechanism) for mechanism in results.mechanisms}
        each = [f"{names.get(of, of)} ({band.from_hz:.3g}–{band.to_hz:.3g} Hz)" for band, of in bands]
        yield f"The weakest pulse overturns, by its frequency: {list_names(each)}."
