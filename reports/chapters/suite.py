"""The records of the suite, and what the rules of the basis require of them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from assess.messages.message import DIMENSIONS
from assess.results import RecordResult, RequirementResult, Results
from reports.document import NOTHING, Cell, Column, Graded, Outcome, Table
from reports.figures.suite import CODES
from reports.language.texts import Phrase, Term, Text, Verbatim, listing, quantity, say, say_count

MET: Mapping[str, tuple[Outcome, Phrase]] = {
    "met": ("pass", say("met")),
    "not met": ("fail", say("not met")),
    "not answered": ("incomplete", say("not answered")),
}
SIGNS: Mapping[str, str] = {">=": "≥", "<=": "≤"}
FIGURES = 3


def records(results: Results) -> Table:
    """Tabulate the records as scaled, all artificial ones in one row; no rows where there are no others."""
    columns = (
        Column(say("Record")),
        Column(say("Event")),
        Column(say("Station")),
        Column(say("Component")),
        Column(say("Scale factor")),
        Column(say("PGA, scaled")),
    )
    if all(not record.path for record in results.records):
        return Table("suite-records", NOTHING, (), ())
    recorded = tuple(record for record in results.records if record.path)
    artificial = tuple(record for record in results.records if not record.path)
    rows = tuple(map(_row, recorded)) + ((_artificial_row(artificial),) if artificial else ())
    return Table("suite-records", say("Records, as scaled to the spectrum of the site."), columns, rows, small=True)


def _row(record: RecordResult) -> tuple[Cell, ...]:
    texts = (record.id, event_name(record), record.station, record.component)
    scaled = (quantity(record.scale_factor), quantity(record.pga_g, "ground acceleration", FIGURES))
    return (*(Verbatim(text) if text else None for text in texts), *scaled)


def _artificial_row(records: tuple[RecordResult, ...]) -> tuple[Cell, ...]:
    label = say_count("{number} artificial record", "{number} artificial records", len(records))
    factors = _span([record.scale_factor for record in records], "ratio")
    return (label, None, None, None, factors, _span([record.pga_g for record in records], "ground acceleration"))


def _span(values: list[float], dimension: str) -> Text:
    """Return the range of numbers; one number where they are alike as shown."""
    least, most = quantity(min(values), dimension, FIGURES), quantity(max(values), dimension, FIGURES)
    if most.value - least.value <= 5e-4 * most.value:
        return most
    return say("{least} to {most}", least=least, most=most)


def event_name(record: RecordResult) -> str:
    """Return the earthquake with its year, where that is known and not part of its name."""
    year = record.date[:4]
    return record.event if year in record.event else f"{record.event} {year}".strip()


def of_basis(results: Results) -> tuple[RequirementResult, ...]:
    """Return the requirements of the code that belongs to the basis; none without records or basis."""
    code = "" if results.verdict is None else CODES.get(results.verdict.basis, "")
    motion = results.ground_motion
    return () if motion is None else tuple(one for one in motion.requirements if one.code == code)


def complies(results: Results) -> bool:
    """Return whether the suite meets every requirement of the code that belongs to the basis."""
    return all(rule.verdict == "met" for rule in of_basis(results))


def sentences(results: Results) -> Iterator[Text]:
    """Yield over which periods the suite was fitted, and whether it meets the rules of the basis."""
    motion, rules = results.ground_motion, of_basis(results)
    if results.records and all(not record.path for record in results.records):
        yield say_count(
            "The suite has {number} artificial record, of PGA {pga} as scaled to the spectrum of the site.",
            "The suite has {number} artificial records, of PGA {pga} as scaled to the spectrum of the site.",
            len(results.records),
            pga=_span([record.pga_g for record in results.records], "ground acceleration"),
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
        yield lock_sentence(motion.lock)
    if rules:
        yield from _compliance(rules)


def made_for_sentence(code: str) -> Text:
    """Say whose rules the suite was made to meet."""
    return say(
        "The suite was made to meet the rules of {code}, as far as they can be checked: the number of its records "
        "and their factors were adjusted for it, and records that break a rule by themselves were replaced.",
        code=Verbatim(code),
    )


def lock_sentence(file: str) -> Text:
    """Say that the suite is locked."""
    return say(
        "The suite is locked: the records and their scale factors are those of {file}, whatever becomes of the "
        "mechanisms and the selection.",
        file=Verbatim(file),
    )


def _compliance(rules: tuple[RequirementResult, ...]) -> Iterator[Text]:
    code = Verbatim(rules[0].code)
    missed, silent = (
        listing(Term(rule.what) for rule in rules if rule.verdict == verdict) for verdict in ("not met", "not answered")
    )
    if missed.texts:
        yield say("The suite does not meet these requirements of {code}: {which}.", code=code, which=missed)
    if silent.texts:
        yield say("These requirements of {code} could not be checked: {which}.", code=code, which=silent)
    if not missed.texts and not silent.texts:
        yield say_count(
            "The suite meets the one requirement of {code} on suites.",
            "The suite meets all {number} requirements of {code} on suites.",
            len(rules),
            code=code,
        )


def requirements(results: Results) -> Table:
    """Tabulate the requirements of the code that belongs to the basis."""
    columns = (
        Column(say("Requirement")),
        Column(say("Clause")),
        Column(say("Found")),
        Column(say("Limit")),
        Column(say("Outcome")),
    )
    rules = of_basis(results)
    caption = say("The suite against the rules of {code}.", code=Verbatim(rules[0].code if rules else ""))
    return Table("suite-rules", caption, columns, tuple(map(_rule_row, rules)), small=True)


def _rule_row(rule: RequirementResult) -> tuple[Cell, ...]:
    colour, word = MET[rule.verdict]
    return (Term(rule.what), Term(rule.clause), *found_and_limit(rule), Graded(colour, word))


def found_and_limit(rule: RequirementResult) -> tuple[Cell, Cell]:
    """Return what was found of a requirement, and its limit."""
    dimension = DIMENSIONS.get(rule.unit, "ratio")
    found = None if rule.value is None else quantity(rule.value, dimension)
    return found, say("{sign} {limit}", sign=Verbatim(SIGNS[rule.sense]), limit=quantity(rule.limit, dimension))
