"""The methods of the run: edition, part in the verdict, and what each compares."""

from __future__ import annotations

from collections.abc import Mapping

from assess.codes.check import Check, Family
from assess.codes.families import FAMILIES
from assess.results import Results
from reports.document import Column, Table
from reports.language.texts import Phrase, Term, Text, say
from reports.titles import procedure_title

MEASURES: Mapping[Family, Phrase] = {
    Family.DISPLACEMENT: say("displacement capacity with the spectral displacement at the secant period"),
    Family.LINEAR: say("acceleration that starts the motion with the spectrum reduced by q, not the rotation after it"),
    Family.ENERGY: say("rotation of an equivalent oscillator of equal work, damped by impacts, with the allowable one"),
    Family.PART: say("rotation capacity of the wall with the spectral rotation of a part at its floor"),
    Family.TABLE: say("ratio of height to thickness with the one allowed at the spectral ordinate at 1 s"),
    Family.ELEMENT: say("force that starts the motion with the force on a part at its floor, reduced by q_a"),
    Family.HISTORY: say("largest rotations under each record, impacts included, with the allowable ones"),
    Family.SLIDING: say("sliding displacement, without rocking, with the allowable one"),
    Family.FRICTION: say("friction needed until rocking starts with the friction there is"),
}
"""What the methods of each family compare."""


def table(results: Results) -> Table:
    """Tabulate the methods, those that decide first."""
    found: dict[str, list[Check]] = {}
    for check in (check for mechanism in results.mechanisms for check in mechanism.checks):
        found.setdefault(check.procedure, []).append(check)
    ordered = sorted(found.values(), key=lambda checks: not _decides(checks))
    rows = tuple(
        (procedure_title(each[0].procedure), Term(each[0].edition), part(each), _measure(each)) for each in ordered
    )
    columns = (
        Column(say("Method"), share=0.24),
        Column(say("Edition"), share=0.22),
        Column(say("Part in the verdict"), share=0.16),
        Column(say("Compares")),
    )
    muted = frozenset(place for place, each in enumerate(ordered) if not _decides(each))
    caption = say("Methods of this report, with the editions used.")
    return Table("methods", caption, columns, rows, muted, small=True)


def _decides(checks: list[Check]) -> bool:
    return any(check.role == "deciding" for check in checks)


def part(checks: list[Check]) -> Text:
    """Return what the answers of a method do for the verdict."""
    if _decides(checks):
        return say("decides")
    if all(check.reading == "thesis" for check in checks):
        return say("never decides: reading of the thesis")
    if all(check.informs for check in checks):
        return say("for information")
    return say("for comparison")


def _measure(checks: list[Check]) -> Text | None:
    family = FAMILIES.get(checks[0].procedure)
    return None if family is None else MEASURES[family]


def rules(results: Results) -> Table:
    """Tabulate the rules of the deciding code with their clauses."""
    found = () if results.verdict is None or results.verdict.basis == "own" else results.verdict.clauses
    columns = (Column(say("Rule of the verdict")), Column(say("Clause"), share=0.3))
    rows = tuple((Term(rule), Term(clause)) for rule, clause in found)
    return Table("rules", say("The rules that decide, and where the code states them."), columns, rows, small=True)
