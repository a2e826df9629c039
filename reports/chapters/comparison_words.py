"""Sentences that compare mechanisms and methods: where they disagree, how far apart they are, what overturns."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from statistics import median

from assess.codes.check import Check, Family, Outcome
from assess.codes.families import FAMILIES, uses_histories
from assess.results import MechanismResult, Results, SuiteResult
from reports import governing
from reports.chapters.cells import FIGURES
from reports.language.texts import Listing, Paragraph, Phrase, Text, count, listing, names, quantity, say
from reports.titles import mechanism_number, numbered_title, procedure_title

ABOVE = 1.000001  # times the PGA at capacity: a level that lies beyond it
MEASURES: Mapping[Family, Phrase] = {
    Family.DISPLACEMENT: say(
        "It compares the displacement capacity with the spectral displacement at a secant period."
    ),
    Family.LINEAR: say("It compares the acceleration that starts the motion with the demand reduced by q."),
    Family.ENERGY: say("It replaces the rocking body by an oscillator of equal work with the damping of its impacts."),
    Family.PART: say(
        "It compares the rotation capacity of the wall with the spectral rotation of a part at its floor."
    ),
    Family.TABLE: say("It compares height over thickness with a tabulated limit, whatever the load."),
    Family.ELEMENT: say(
        "It compares the force on a part at its floor, reduced by q_a, with that which starts the motion."
    ),
    Family.HISTORY: say("It follows each record with its impacts, and fails where one overturns the body."),
    Family.SLIDING: say("It estimates how far the body slides without rocking."),
    Family.FRICTION: say("It checks whether friction holds until rocking starts."),
}
"""What each kind of method measures."""


def introduction(results: Results) -> Iterator[Text]:
    """Yield which mechanisms are represented by one of several cases, and where inputs differ."""
    swept = dict.fromkeys(sweep.mechanism for sweep in results.sweeps if sweep.governs)
    if swept:
        which = _numbers(results, swept)
        yield say("Each swept mechanism is represented by its most critical case: {mechanisms}.", mechanisms=which)
    carried = [m for m in results.mechanisms if m.amplification.height_m is not None and m.histories]
    if carried and len(carried) < len(results.mechanisms):
        yield say(
            "The time histories of {mechanisms} have the motion at the base of the mechanism, amplified up the "
            "building; those of the others have the ground motion.",
            mechanisms=_numbers(results, (m.name for m in carried)),
        )


def findings(results: Results) -> Iterator[Text]:
    """Yield what the comparison shows."""
    if governing.other_levels(results):
        yield say(
            "The levels other than the site’s own action decide nothing: they show how the answers change with the "
            "action. A pass at a higher level is not a margin."
        )
    yield from _passes_beyond_capacity(results)
    yield from _disagreements(results)
    yield from _spread(results)
    yield from _overturning(results)


def _numbers(results: Results, of: Iterable[str]) -> Listing:
    return names(mechanism_number(results, name) for name in of)


def _passes_beyond_capacity(results: Results) -> Iterator[Text]:
    found = [m.name for m in results.mechanisms if any(map(_passes_beyond, governing.code_checks(m.checks)))]
    if found:
        yield say(
            "For {mechanisms} a record that overturns the mechanism at one level is survived at a higher one: the PGA "
            "at capacity is the last before the suite first fails.",
            mechanisms=_numbers(results, found),
        )


def _passes_beyond(check: Check) -> bool:
    capacity = check.capacity_pga_g
    beyond = capacity is not None and check.level_pga_g > ABOVE * capacity
    return beyond and check.verdict == Outcome.PASS and uses_histories(check.procedure)


def _disagreements(results: Results) -> Iterator[Text]:
    """Yield on which mechanisms methods disagree at the site's own action, and what those measure that fail some."""
    apart = [m for m in results.mechanisms if {Outcome.PASS, Outcome.FAIL} <= {c.verdict for c in _own(results, m)}]
    if governing.site_pga(results) is None or not apart:
        return
    yield say(
        "At the site’s own action the methods disagree on {mechanisms}.",
        mechanisms=_numbers(results, (m.name for m in apart)),
    )
    answering = dict.fromkeys(
        c.procedure for m in apart for c in _own(results, m) if c.verdict in (Outcome.PASS, Outcome.FAIL)
    )
    failed = {
        procedure: [m.name for m in results.mechanisms if _fails(results, m, procedure)]
        for procedure in answering
        if any(_fails(results, m, procedure) for m in apart)
    }
    told: set[Family | None] = set()
    for procedure, mechanisms in failed.items():
        family = FAMILIES.get(procedure)
        yield _failing(results, procedure, mechanisms, None if family in told else family)
        told.add(family)
    passed: dict[tuple[str, ...], list[str]] = {}
    for procedure in (name for name in answering if name not in failed):
        passed.setdefault(tuple(m.name for m in apart if _passes(results, m, procedure)), []).append(procedure)
    for which, procedures in passed.items():
        yield _passing(results, which, procedures, is_all=1 < len(which) == len(apart))


def _passing(results: Results, which: tuple[str, ...], procedures: list[str], *, is_all: bool) -> Text:
    """Return which mechanisms are passed by methods that fail none."""
    methods, mechanisms = listing(map(procedure_title, procedures)), _numbers(results, which)
    if is_all:
        return say("All of these are passed by {methods}.", methods=methods)
    if len(which) == 1:
        return say("{mechanism} is passed by {methods}.", mechanism=mechanisms, methods=methods)
    return say("{mechanisms} are passed by {methods}.", mechanisms=mechanisms, methods=methods)


def _own(results: Results, mechanism: MechanismResult) -> tuple[Check, ...]:
    return governing.code_checks(governing.at_site(results, mechanism))


def _fails(results: Results, mechanism: MechanismResult, procedure: str) -> bool:
    own = (check for check in _own(results, mechanism) if check.procedure == procedure)
    return any(check.verdict == Outcome.FAIL for check in own)


def _passes(results: Results, mechanism: MechanismResult, procedure: str) -> bool:
    own = (check for check in _own(results, mechanism) if check.procedure == procedure)
    return any(check.verdict == Outcome.PASS for check in own)


def _failing(results: Results, procedure: str, mechanisms: list[str], family: Family | None) -> Text:
    """Return which mechanisms a method fails, and what its family measures, if it was not told before."""
    which = _numbers(results, mechanisms)
    sentence = say("{method} fails {mechanisms}.", method=procedure_title(procedure), mechanisms=which)
    return sentence if family is None else Paragraph((sentence, MEASURES[family]))


def _spread(results: Results) -> Iterator[Text]:
    """Yield how far apart the methods of codes are in PGA at capacity."""
    spreads = []
    for mechanism in results.mechanisms:
        known = governing.capacities(governing.with_answer(governing.code_checks(mechanism.checks)))
        if len(known) > 1 and min(known.values()) > 0.0:
            low, high = min(known, key=lambda name: known[name]), max(known, key=lambda name: known[name])
            spreads.append((known[high] / known[low], mechanism, low, high))
    if not spreads:
        return
    largest, mechanism, low, high = max(spreads, key=lambda spread: spread[0])
    if len(spreads) == 1:
        yield say(
            "The PGA at capacity by {high} is {largest} times that by {low}.",
            high=procedure_title(high),
            largest=quantity(largest, "ratio", FIGURES),
            low=procedure_title(low),
        )
        return
    yield say(
        "Of each mechanism, the largest PGA at capacity by any method is {middle} times the smallest in the median, "
        "and at most {largest} times ({mechanism}: {high} over {low}).",
        middle=quantity(median(spread[0] for spread in spreads), "ratio", FIGURES),
        largest=quantity(largest, "ratio", FIGURES),
        mechanism=numbered_title(results, mechanism.name),
        high=procedure_title(high),
        low=procedure_title(low),
    )


def _overturning(results: Results) -> Iterator[Text]:
    """Yield how many records overturn which mechanisms."""
    fallen = [
        say(
            "{mechanism} at {levels}",
            mechanism=numbered_title(results, mechanism.name),
            levels=Listing(tuple(_fallen(suite) for suite in mechanism.suites if suite.overturned), ""),
        )
        for mechanism in results.mechanisms
        if any(suite.overturned for suite in mechanism.suites)
    ]
    if fallen:
        yield say("Records overturn {cases}. No other history overturns a mechanism.", cases=listing(fallen))
    elif any(mechanism.suites for mechanism in results.mechanisms):
        yield _none_overturns(results)


def _fallen(suite: SuiteResult) -> Text:
    return say(
        "{pga} ({number} of {all})",
        pga=quantity(suite.level_pga_g, "ground acceleration", FIGURES),
        number=count(suite.overturned),
        all=count(suite.n),
    )


def _none_overturns(results: Results) -> Text:
    """Return that no record overturns, but for the procedures that run records at another PGA than their level."""
    checks = [check for mechanism in results.mechanisms for check in mechanism.checks]
    fallen = dict.fromkeys(c.procedure for c in checks if uses_histories(c.procedure) and governing.is_overturned(c))
    if not fallen:
        return say("No record overturns a mechanism at the levels requested.")
    return say(
        "No record overturns a mechanism at the levels requested; with the confidence factor, or at the PGA of another "
        "limit state, records do: {methods}.",
        methods=listing(map(procedure_title, fallen)),
    )
