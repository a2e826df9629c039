"""The suite of records: what the chapter on the site says of it, and annex D with every step and requirement."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from assess.messages.message import DIMENSIONS
from assess.results import GroundMotionResult, RecordResult, RequirementResult, Results
from reports import document as doc
from reports.chapters.cells import CLAUSE, MECHANISM, OUTCOME
from reports.figures.spectrum import suite_code
from reports.language.texts import Listing, Phrase, Term, Text, Verbatim, listing, quantity, say, say_count
from reports.mechanisms import numbered_title

REQUIREMENT_OUTCOMES: Mapping[str, tuple[doc.OutcomeColour, Phrase]] = {
    "met": ("pass", say("met")),
    "not met": ("fail", say("not met")),
    "not answered": ("incomplete", say("not answered")),
}
SIGNS: Mapping[str, str] = {">=": "≥", "<=": "≤"}
FIGURES = 3


def suite_records_table(results: Results) -> doc.Table:
    """Tabulate the records as scaled, all artificial ones in one row; no rows where there are no others."""
    named = say("Record"), say("Event"), say("Station"), say("Component"), say("Scale factor"), say("PGA, scaled")
    if all(not record.path for record in results.records):
        return doc.Table("suite-records", doc.NOTHING, (), ())
    recorded = tuple(record for record in results.records if record.path)
    artificial = tuple(record for record in results.records if not record.path)
    rows = tuple(map(_record_row, recorded)) + ((_artificial_row(artificial),) if artificial else ())
    caption = say("Records, as scaled to the spectrum of the site.")
    return doc.Table("suite-records", caption, tuple(map(doc.Column, named)), rows, small=True)


def event_name(record: RecordResult) -> str:
    """Return the earthquake with its year, where that is known and not part of its name."""
    year = record.date[:4]
    return record.event if year in record.event else f"{record.event} {year}".strip()


def meets_requirements(results: Results) -> bool:
    """Return whether the suite meets every requirement of the code that belongs to the basis."""
    return all(rule.verdict == "met" for rule in _requirements_of_basis(results))


def suite_sentences(results: Results) -> Iterator[Text]:
    """Yield over which periods the suite was fitted, and whether it meets the rules of the basis."""
    motion, rules = results.ground_motion, _requirements_of_basis(results)
    if results.records and all(not record.path for record in results.records):
        yield say_count(
            "The suite has {number} artificial record, of PGA {pga} as scaled to the spectrum of the site.",
            "The suite has {number} artificial records, of PGA {pga} as scaled to the spectrum of the site.",
            len(results.records),
            pga=_range_text([record.pga_g for record in results.records], "ground acceleration"),
        )
    if motion is not None:
        yield say(
            "The records are compared with the target from {shortest} to {longest}; there the natural logarithms of "
            "their mean and the target differ by {misfit} in the mean square.",
            shortest=quantity(motion.from_s, "time"),
            longest=quantity(motion.to_s, "time"),
            misfit=quantity(motion.misfit, "ratio", FIGURES),
        )
    if motion is not None and motion.lock:
        yield _lock_sentence(motion.lock)
    if rules:
        yield from _compliance(rules)


def basis_requirements_table(results: Results) -> doc.Table:
    """Tabulate the requirements of the code that belongs to the basis."""
    fields: tuple[doc.Field[RequirementResult], ...] = (
        (doc.Column(say("Requirement")), lambda rule: Term(rule.what)),
        (CLAUSE, lambda rule: Term(rule.clause)),
        (doc.Column(say("Found")), _found_cell),
        (doc.Column(say("Limit")), _limit_text),
        (OUTCOME, lambda rule: doc.OutcomeCell(*REQUIREMENT_OUTCOMES[rule.verdict])),
    )
    rules = _requirements_of_basis(results)
    caption = say("The suite against the rules of {code}.", code=Verbatim(rules[0].code if rules else ""))
    return doc.tabulate("suite-rules", caption, fields, rules, small=True)


MARK = "D"
FIT_WORDS = {"suite": say("the mean of the suite"), "each": say("each record by itself")}


def sections(results: Results) -> list[doc.Section]:
    """Return the annex; none without records."""
    motion = results.ground_motion
    if motion is None and not results.records:
        return []
    blocks: list[doc.Block] = []
    if motion is not None:
        blocks += [
            doc.Prose(selection_sentences(motion)),
            *doc.nonempty(_equivalent_periods_table(results, motion)),
            *doc.nonempty(_selection_steps_table(motion)),
        ]
        blocks += doc.nonempty(requirements_table(motion))
    blocks += [*doc.nonempty(_amplification_table(results)), *doc.nonempty(processing_table(results))]
    return [doc.Section(say("Suite of records"), 0, tuple(blocks), starts_page=True, mark=MARK)]


def selection_sentences(motion: GroundMotionResult) -> tuple[Text, ...]:
    """Return the range of periods, and the rules of the selection."""
    over = say(
        "The records are compared with the target from {low} to {high}, both ends included ({source}). The mean "
        "squared difference of the logarithms of their mean and the target is {misfit}.",
        low=quantity(motion.from_s, "time"),
        high=quantity(motion.to_s, "time"),
        source=Term(motion.source),
        misfit=quantity(motion.misfit),
    )
    made = (_made_for_sentence(motion.made_for),) if motion.made_for else ()
    lock = (*made, *((_lock_sentence(motion.lock),) if motion.lock else ()))
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
        fits=FIT_WORDS[chosen.fit],
        least=quantity(chosen.least_factor),
        largest=quantity(chosen.largest_factor),
        rules=Listing(tuple(rules)),
    )
    return (over, rule, *lock)


def requirements_table(motion: GroundMotionResult) -> doc.Table:
    """Tabulate the requirements of each code on the suite."""
    fields: tuple[doc.Field[RequirementResult], ...] = (
        (doc.Column(say("Code")), lambda rule: Verbatim(rule.code)),
        (CLAUSE, lambda rule: Term(rule.clause)),
        (doc.Column(say("Requirement"), share=0.26), lambda rule: Term(rule.what)),
        (doc.Column(say("Found")), _found_cell),
        (doc.Column(say("Limit")), _limit_text),
        (doc.Column(say("Periods")), _periods_text),
        (OUTCOME, lambda rule: REQUIREMENT_OUTCOMES[rule.verdict][1]),
        (doc.Column(say("Remark"), share=0.2), _remarks_text),
    )
    caption = say(
        "Requirements of codes on the suite. Histories by ASCE 43-05 and NTC 2018 are evaluated only where their "
        "requirements are met; the others are for information. T₁ is replaced by the smallest and the largest "
        "equivalent period."
    )
    return doc.tabulate("requirements", caption, fields, motion.requirements, small=True)


def processing_table(results: Results) -> doc.Table:
    """Tabulate the origin and the processing of each record."""
    fields: tuple[doc.Field[RecordResult], ...] = (
        (doc.Column(say("Record"), share=0.18), lambda record: Verbatim(record.id)),
        (doc.Column(say("Station"), share=0.15), lambda record: Verbatim(record.station)),
        (doc.Column(say("File"), share=0.22), lambda record: Verbatim(record.path)),
        (doc.Column(say("Processing, in order")), lambda record: Listing(_processing_steps(record), "")),
    )
    return doc.tabulate("processing", say("Origin and processing of the records."), fields, results.records, small=True)


def _record_row(record: RecordResult) -> tuple[doc.Cell, ...]:
    texts = (record.id, event_name(record), record.station, record.component)
    scaled = (quantity(record.scale_factor), quantity(record.pga_g, "ground acceleration", FIGURES))
    return (*(Verbatim(text) if text else None for text in texts), *scaled)


def _artificial_row(records: tuple[RecordResult, ...]) -> tuple[doc.Cell, ...]:
    label = say_count("{number} artificial record", "{number} artificial records", len(records))
    factors = _range_text([record.scale_factor for record in records], "ratio")
    return (label, None, None, None, factors, _range_text([record.pga_g for record in records], "ground acceleration"))


def _range_text(values: list[float], dimension: str) -> Text:
    """Return the range of numbers; one number where they are alike as shown."""
    least, most = quantity(min(values), dimension, FIGURES), quantity(max(values), dimension, FIGURES)
    if most.value - least.value <= 5e-4 * most.value:
        return most
    return say("{least} to {most}", least=least, most=most)


def _requirements_of_basis(results: Results) -> tuple[RequirementResult, ...]:
    """Return the requirements of the code that belongs to the basis; none without records or basis."""
    code, motion = suite_code(results), results.ground_motion
    return () if motion is None else tuple(one for one in motion.requirements if one.code == code)


def _made_for_sentence(code: str) -> Text:
    """Say whose rules the suite was made to meet."""
    return say(
        "The suite was made to meet the rules of {code}, as far as they can be checked: the number of its records "
        "and their factors were adjusted for it, and records that break a rule by themselves were replaced.",
        code=Verbatim(code),
    )


def _lock_sentence(file: str) -> Text:
    """Say that the suite is locked."""
    return say(
        "The suite is locked: the records and their scale factors are those of {file}, whatever becomes of the "
        "mechanisms and the selection.",
        file=Verbatim(file),
    )


def _compliance(rules: tuple[RequirementResult, ...]) -> Iterator[Text]:
    code = Verbatim(rules[0].code)
    not_met, not_answered = (
        listing(Term(rule.what) for rule in rules if rule.verdict == verdict) for verdict in ("not met", "not answered")
    )
    if not_met.texts:
        yield say("The suite does not meet these requirements of {code}: {which}.", code=code, which=not_met)
    if not_answered.texts:
        yield say("These requirements of {code} could not be checked: {which}.", code=code, which=not_answered)
    if not not_met.texts and not not_answered.texts:
        yield say_count(
            "The suite meets the one requirement of {code} on suites.",
            "The suite meets all {number} requirements of {code} on suites.",
            len(rules),
            code=code,
        )


def _found_cell(rule: RequirementResult) -> doc.Cell:
    return None if rule.value is None else quantity(rule.value, DIMENSIONS.get(rule.unit, "ratio"))


def _limit_text(rule: RequirementResult) -> Text:
    limit = quantity(rule.limit, DIMENSIONS.get(rule.unit, "ratio"))
    return say("{sign} {limit}", sign=Verbatim(SIGNS[rule.sense]), limit=limit)


def _equivalent_periods_table(results: Results, motion: GroundMotionResult) -> doc.Table:
    """Tabulate the equivalent periods of the mechanisms."""
    known = {each.name for each in results.mechanisms}

    def title(name: str) -> Text:
        return numbered_title(results, name) if name in known else Verbatim(name)

    columns = (MECHANISM, doc.Column(say("Shortest"), "time"), doc.Column(say("Longest"), "time"))
    rows = tuple((title(one.mechanism), one.shortest_s, one.longest_s) for one in motion.equivalent_periods)
    caption = say(
        "Equivalent periods, used as T₁ in the clauses on records because a rocking body has no natural period: the "
        "period of equal work at half the overturning rotation (1/fₑ of ASCE 43-05 A.2), over both branches."
    )
    return doc.Table("equivalent-periods", caption, columns, rows, small=True)


def _selection_steps_table(motion: GroundMotionResult) -> doc.Table:
    """Tabulate the number of records left after each step of the selection."""
    steps = () if motion.selection is None else motion.selection.remaining
    rows = tuple((Term(one.step), one.number) for one in steps)
    columns = (doc.Column(say("Records")), doc.Column(say("Number")))
    return doc.Table("selection", say("Records left after each step of the selection."), columns, rows, small=True)


def _amplification_table(results: Results) -> doc.Table:
    """Tabulate the amplification factor of each record at each mechanism (as Mehrotra Table 8.9)."""
    raised = [m for m in results.mechanisms if m.amplification.height_m is not None and m.amplification.factors]
    factors = [{one.record: one.factor for one in m.amplification.factors} for m in raised]
    of_mechanisms = (doc.Column(numbered_title(results, m.name), "ratio") for m in raised)
    columns = (doc.Column(say("Record"), share=0.25), *of_mechanisms)
    rows: tuple[tuple[doc.Cell, ...], ...] = tuple(
        (Verbatim(r.id), *(of.get(r.id) for of in factors)) for r in (results.records if raised else ())
    )
    caption = say(
        "Scale factors for the amplification up to the base of each mechanism above the ground (as Mehrotra Table "
        "8.9): peak acceleration there over that of the ground."
    )
    return doc.Table("amplification", caption, columns, rows, small=True)


def _periods_text(rule: RequirementResult) -> Text | None:
    if rule.from_s is None or rule.to_s is None:
        return None
    return say("{low} to {high}", low=quantity(rule.from_s, "time", 3), high=quantity(rule.to_s, "time", 3))


def _remarks_text(rule: RequirementResult) -> Text:
    remarks = rule.remarks or map(Term, _nonempty((rule.remark,)))
    return Listing((*remarks, *map(Term, _nonempty((rule.caveat,)))), "")


def _nonempty(texts: Iterable[str]) -> list[str]:
    return [text for text in texts if text]


def _processing_steps(record: RecordResult) -> tuple[Text, ...]:
    """Return what was done to a record; lines of its file are verbatim, and older results hold the English alone."""
    texts = tuple(Verbatim(each) if isinstance(each, str) else each for each in record.processing)
    return texts or tuple(map(Term, record.trail))
