"""What the numbers say, in sentences: which mechanism is critical, by how much, and which procedures disagree."""

from __future__ import annotations

from collections.abc import Iterator
from statistics import median

from assess.codes.check import Family, Outcome
from assess.codes.family import FAMILIES, of_histories
from assess.codes.verdict import MechanismVerdict
from assess.codes.verdict_text import holds_text
from assess.results import MechanismResult, Results, SuiteResult
from reports import governing
from reports.chapters.sentences import joined
from reports.language.lettering import shortened
from reports.language.numerals import numeral
from reports.mechanism_title import mechanism_title

LONGEST, MANY = 40, 6  # characters of a name in a sentence; names in a list
MEASURES = {
    Family.DISPLACEMENT: "compares the displacement capacity with the spectral displacement at the secant period",
    Family.LINEAR: "judges the acceleration that starts the motion, reduced by q, not the rotation after it",
    Family.ENERGY: "replaces the rocking body by an oscillator of equal work, with the damping of its impacts",
    Family.PART: "compares the rotation that the wall can take with the spectral one of a part at its floor",
    Family.TABLE: "looks up the height over thickness that the spectrum at 1 s allows, whatever the load",
    Family.ELEMENT: "compares the force on a part at its floor, reduced by q_a, with the one that starts the motion",
    Family.HISTORY: "sees each record with its impacts and the order of its pulses, and fails where one overturns",
    Family.SLIDING: "estimates how far the body slides, without rocking",
    Family.FRICTION: "asks whether friction holds until rocking starts",
}


def findings(results: Results) -> tuple[str, ...]:
    """The sentences, most important first; those that have nothing to say are left out."""
    own = governing.site_pga(results)
    return (
        *_critical(results),
        *disagreements(results, () if own is None else (own,)),
        *_spread(results),
        *_overturned(results),
        *_pulses(results),
    )


def named(mechanism: MechanismResult) -> str:
    """The name of a mechanism in a sentence."""
    return shortened(mechanism_title(mechanism), LONGEST)


def listed(names: list[str]) -> str:
    """Names with commas and an "and"; of many the first ones, and how many there are besides."""
    return joined([*names[:MANY], f"{len(names) - MANY} others"] if len(names) > MANY + 1 else names)


def _critical(results: Results) -> Iterator[str]:
    """The mechanism that holds the least, by the procedures that decide, and the runner-up."""
    ranked = ranking(results)
    if not ranked or results.verdict is None:
        return
    action, ((first, least), *others) = results.verdict.action, ranked
    said = f"Critical is {named(first)}: it holds up to {holds_text(least, action)}, by {_deciding(least)}"
    if others:
        runner_up, other = others[0]
        said += f"; next is {named(runner_up)} with {holds_text(other, action)}, by {_deciding(other)}"
    yield f"{said}."


def _deciding(one: MechanismVerdict) -> str:
    return joined(dict.fromkeys(answer.procedure for answer in one.answers if answer.procedure))


def ranking(results: Results) -> list[tuple[MechanismResult, MechanismVerdict]]:
    """Mechanisms with their verdict by their margin, rising; those where none is known are left out."""
    verdicts = {} if results.verdict is None else {one.mechanism: one for one in results.verdict.mechanisms}
    pairs = ((m, verdicts[m.name]) for m in results.mechanisms if m.name in verdicts)
    return sorted((pair for pair in pairs if pair[1].margin is not None), key=lambda pair: pair[1].margin or 0.0)


def disagreements(results: Results, levels: tuple[float, ...]) -> Iterator[str]:
    """At each level where procedures disagree: who fails whom, and what each of them measures."""
    failing: dict[str, None] = {}
    for level in levels:
        apart = [m for m in results.mechanisms if _apart(m, level)]
        if not apart:
            continue
        by = {procedure: _failed(apart, level, procedure) for procedure in _asked(apart, level)}
        fails = "; ".join(f"{procedure} fails {listed(names)}" for procedure, names in by.items() if names)
        passing = [procedure for procedure, names in by.items() if not names]
        rest = f"; {listed(passing)} {'passes' if len(passing) == 1 else 'pass'} all of these" if passing else ""
        yield (
            f"For comparison: at PGA {level:.3g} g the procedures disagree on {listed([named(m) for m in apart])}: "
            f"{fails}{rest}."
        )
        failing |= dict.fromkeys(by)
    reasons = [f"{procedure} {measure}" for procedure in failing if (measure := measured(procedure))]
    if reasons:
        yield f"They measure different margins: {'; '.join(reasons)}."


def measured(procedure: str) -> str:
    """What a procedure measures; empty where nothing is known."""
    return MEASURES[FAMILIES[procedure]] if procedure in FAMILIES else ""


def _asked(mechanisms: list[MechanismResult], level: float) -> dict[str, None]:
    checks = (check for m in mechanisms for check in governing.letters(governing.at_level(m.checks, level)))
    return dict.fromkeys(check.procedure for check in checks if check.verdict in (Outcome.PASS, Outcome.FAIL))


def _apart(mechanism: MechanismResult, level: float) -> bool:
    checks = governing.letters(governing.at_level(mechanism.checks, level))
    return {Outcome.PASS, Outcome.FAIL} <= {check.verdict for check in checks}


def _failed(mechanisms: list[MechanismResult], level: float, procedure: str) -> list[str]:
    def fails(mechanism: MechanismResult) -> bool:
        checks = governing.letters(governing.at_level(mechanism.checks, level))
        return any(check.procedure == procedure and check.verdict == Outcome.FAIL for check in checks)

    return [named(mechanism) for mechanism in mechanisms if fails(mechanism)]


def _spread(results: Results) -> Iterator[str]:
    """How far the procedures lie apart in PGA at capacity."""
    spreads = []
    for mechanism in results.mechanisms:
        known = governing.capacities(governing.letters(mechanism.checks))
        if len(known) > 1 and min(known.values()) > 0.0:
            low, high = min(known, key=lambda name: known[name]), max(known, key=lambda name: known[name])
            spreads.append((known[high] / known[low], mechanism, low, high))
    if not spreads:
        return
    largest, mechanism, low, high = max(spreads, key=lambda spread: spread[0])
    middle = f"{numeral(median(spread[0] for spread in spreads), digits=3)} in the median, " if len(spreads) > 1 else ""
    yield (
        "For comparison: the largest PGA at capacity of a mechanism over its least one, by another code procedure, "
        f"is {middle}at most {numeral(largest, digits=3)} ({named(mechanism)}: {high} over {low})."
    )


def _overturned(results: Results) -> Iterator[str]:
    """How many records overturn which mechanisms."""
    fallen = [(m, suite) for m in results.mechanisms for suite in m.suites if suite.overturned]
    if fallen:
        each = listed([_fallen(mechanism, suite) for mechanism, suite in fallen])
        yield f"In the time histories records overturn {each}. No other history overturns a mechanism."
    elif any(mechanism.suites for mechanism in results.mechanisms):
        said = "In the time histories no record overturns a mechanism at the levels requested"
        yield f"{said}{_factored(results)}."


def _factored(results: Results) -> str:
    """Which procedures on records still find one that overturns: with a confidence factor, or at a PGA of their own."""
    fallen = dict.fromkeys(
        governing.named(check, mechanism.checks)
        for mechanism in results.mechanisms
        for check in mechanism.checks
        if of_histories(check.procedure) and governing.fell(check)
    )
    said = f"; {listed(list(fallen))}, with the confidence factor or at the PGA of another limit state, finds some"
    return said if fallen else ""


def _fallen(mechanism: MechanismResult, suite: SuiteResult) -> str:
    return f"{named(mechanism)} at {suite.level_pga_g:.3g} g ({suite.overturned} of {suite.n})"


def _pulses(results: Results) -> Iterator[str]:
    """Which mechanism the weakest pulse overturns, where that was asked."""
    if results.critical is None:
        return
    bands = [(band, band.mechanism) for band in results.critical.bands if band.mechanism is not None]
    if bands:
        names = {mechanism.name: named(mechanism) for mechanism in results.mechanisms}
        each = [f"{names.get(of, of)} ({band.from_hz:.3g}–{band.to_hz:.3g} Hz)" for band, of in bands]
        yield f"The weakest pulse overturns, by its frequency: {listed(each)}."
