"""Annex D: the records, how they were chosen and processed, and the rules of each code on the suite."""

from __future__ import annotations

from collections.abc import Iterable

from assess.results import GroundMotionResult, RecordResult, RequirementResult, Results
from reports.chapters import suite
from reports.chapters.cells import MECHANISM
from reports.document import Block, Cell, Column, Prose, Section, Table, nonempty
from reports.language.texts import Listing, Term, Text, Verbatim, quantity, say
from reports.titles import numbered_title

MARK = "D"
FITS = {"suite": say("the mean of the suite"), "each": say("each record by itself")}


def sections(results: Results) -> list[Section]:
    """Return the annex; none without records."""
    motion = results.ground_motion
    if motion is None and not results.records:
        return []
    blocks: list[Block] = []
    if motion is not None:
        blocks += [Prose(sentences(motion)), *nonempty(periods(results, motion)), *nonempty(selection_steps(motion))]
        blocks += nonempty(requirements(motion))
    blocks += [*nonempty(amplification(results)), *nonempty(processing(results))]
    return [Section(say("Suite of records"), 0, tuple(blocks), starts_page=True, mark=MARK)]


def sentences(motion: GroundMotionResult) -> tuple[Text, ...]:
    """Return the range of periods, and the rules of the selection."""
    over = say(
        "The records are compared with the target from {low} to {high}, both ends included ({source}). The mean "
        "squared difference of the logarithms of their mean and the target is {misfit}.",
        low=quantity(motion.from_s, "time"),
        high=quantity(motion.to_s, "time"),
        source=Term(motion.source),
        misfit=quantity(motion.misfit),
    )
    made = (suite.made_for_sentence(motion.made_for),) if motion.made_for else ()
    lock = (*made, *((suite.lock_sentence(motion.lock),) if motion.lock else ()))
    chosen = motion.selection
    if chosen is None:
        return (over, *lock)
    rules: list[Text] = [
        say("no two of one earthquake") if chosen.one_per_event else say("several of one earthquake allowed")
    ]
    if chosen.components == "together":
        rules.append(say("components of a recording kept together with one factor"))
    rule = say(
        "They were chosen so that {fits} fits best, with scale factors from {least} to {largest}, {rules}.",
        fits=FITS[chosen.fit],
        least=quantity(chosen.least_factor),
        largest=quantity(chosen.largest_factor),
        rules=Listing(tuple(rules)),
    )
    return (over, rule, *lock)


def periods(results: Results, motion: GroundMotionResult) -> Table:
    """Tabulate the equivalent periods of the mechanisms."""
    columns = (MECHANISM, Column(say("Shortest"), "time"), Column(say("Longest"), "time"))
    known = {each.name for each in results.mechanisms}
    rows = tuple(
        (
            numbered_title(results, one.mechanism) if one.mechanism in known else Verbatim(one.mechanism),
            one.shortest_s,
            one.longest_s,
        )
        for one in motion.equivalent_periods
    )
    caption = say(
        "Equivalent periods, used as T₁ in the clauses on records because a rocking body has no natural period: the "
        "period of equal work at half the overturning rotation (1/fₑ of ASCE 43-05 A.2), over both branches."
    )
    return Table("equivalent-periods", caption, columns, rows, small=True)


def selection_steps(motion: GroundMotionResult) -> Table:
    """Tabulate the number of records left after each step of the selection."""
    steps = () if motion.selection is None else motion.selection.remaining
    rows = tuple((Term(one.step), one.number) for one in steps)
    columns = (Column(say("Records")), Column(say("Number")))
    return Table("selection", say("Records left after each step of the selection."), columns, rows, small=True)


def amplification(results: Results) -> Table:
    """Tabulate the amplification factor of each record at each mechanism (as thesis Table 8.9)."""
    raised = [m for m in results.mechanisms if m.amplification.height_m is not None and m.amplification.factors]
    factors = [{one.record: one.factor for one in m.amplification.factors} for m in raised]
    columns = (Column(say("Record"), share=0.25), *(Column(numbered_title(results, m.name), "ratio") for m in raised))
    rows: tuple[tuple[Cell, ...], ...] = tuple(
        (Verbatim(r.id), *(of.get(r.id) for of in factors)) for r in (results.records if raised else ())
    )
    caption = say(
        "Scale factors for the amplification up to the base of each mechanism above the ground (as thesis Table 8.9): "
        "peak acceleration there over that of the ground."
    )
    return Table("amplification", caption, columns, rows, small=True)


def requirements(motion: GroundMotionResult) -> Table:
    """Tabulate the requirements of each code on the suite."""
    columns = (
        Column(say("Code")),
        Column(say("Clause")),
        Column(say("Requirement"), share=0.26),
        Column(say("Found")),
        Column(say("Limit")),
        Column(say("Periods")),
        Column(say("Outcome")),
        Column(say("Remark"), share=0.2),
    )
    caption = say(
        "Requirements of codes on the suite. Histories by ASCE 43-05 and NTC 2018 are evaluated only where their "
        "requirements are met; the others are for information. T₁ is replaced by the smallest and the largest "
        "equivalent period."
    )
    rows = tuple(_requirement(one) for one in motion.requirements)
    return Table("requirements", caption, columns, rows, small=True)


def _requirement(one: RequirementResult) -> tuple[Cell, ...]:
    over = (
        None
        if one.from_s is None or one.to_s is None
        else say("{low} to {high}", low=quantity(one.from_s, "time", 3), high=quantity(one.to_s, "time", 3))
    )
    return (
        Verbatim(one.code),
        Term(one.clause),
        Term(one.what),
        *suite.found_and_limit(one),
        over,
        suite.MET[one.verdict][1],
        Listing((*(one.remarks or map(Term, _nonempty((one.remark,)))), *map(Term, _nonempty((one.caveat,)))), ""),
    )


def _nonempty(texts: Iterable[str]) -> list[str]:
    return [text for text in texts if text]


def _processing(record: RecordResult) -> tuple[Text, ...]:
    """Return what was done to a record; lines of its file are verbatim, and older results hold the English alone."""
    texts = tuple(Verbatim(each) if isinstance(each, str) else each for each in record.processing)
    return texts or tuple(map(Term, record.trail))


def processing(results: Results) -> Table:
    """Tabulate the origin and the processing of each record."""
    columns = (
        Column(say("Record"), share=0.18),
        Column(say("Station"), share=0.15),
        Column(say("File"), share=0.22),
        Column(say("Processing, in order")),
    )
    rows = tuple(
        (
            Verbatim(record.id),
            Verbatim(record.station),
            Verbatim(record.path),
            Listing(_processing(record), ""),
        )
        for record in results.records
    )
    return Table("processing", say("Origin and processing of the records."), columns, rows, small=True)
