"""The matrix of page 1: each mechanism by the method that decides it, and beside it what the others answer."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from assess.codes.check import Check, Outcome
from assess.codes.standing_figures import ratio_figures
from assess.codes.verdict import MechanismVerdict, Verdict
from assess.results import MechanismResult, Results
from reports import governing
from reports.chapters.cells import outcome_cell
from reports.chapters.index_text import RATIO, index_name, margin_text, outcome_text, symbol
from reports.document import Cell, Column, Graded, Table
from reports.language.texts import Paragraph, Text, Verbatim, quantity, say
from reports.titles import numbered_title, procedure_title

ZETA = "zeta_E"
DEFINITION = say("ζ_E is the PGA at capacity over the PGA required, both as a_g S at the ground (NTC 2018, 8.3).")
LEAST = 0.001  # ratio that is written as a number
WIDTH = 8  # columns that can be read on a page


@dataclass(frozen=True)
class Method:
    """A method as a column: procedure, and limit state where the procedure has several."""

    procedure: str
    limit_state: str
    several: bool = False

    @property
    def title(self) -> Text:
        """The heading of the column."""
        name = procedure_title(self.procedure)
        if not self.several:
            return name
        return say("{procedure}, {limit_state}", procedure=name, limit_state=Verbatim(self.limit_state))


def table(results: Results, found: Verdict) -> Table:
    """Tabulate mechanism by answer: the deciding one in the colour of its outcome, the others in grey."""
    has_index = found.index is not None and found.index.name != RATIO
    shown, folded = split_methods(methods(results), found, WIDTH - 3 - has_index)
    columns = [Column(say("Mechanism"), share=0.2), Column(say("Verdict")), Column(say("Holds up to PGA"))]
    columns += [Column(symbol(found.index.name))] if has_index and found.index is not None else []
    columns += [Column(say("D/C, {method}", method=method.title)) for method in shown]
    columns += [Column(say("Largest D/C of the other methods"))] if folded else []
    rows = []
    for one in found.mechanisms:
        mechanism = next(each for each in results.mechanisms if each.name == one.mechanism)
        rows.append(
            (
                numbered_title(results, one.mechanism),
                Graded(one.outcome.value, outcome_text(one.outcome, near=one.at_the_limit)),
                margin_text(one, found.action),
                *((_index_cell(one),) if has_index else ()),
                *(cell(results, mechanism, one, method) for method in shown),
                *((largest(results, mechanism, folded),) if folded else ()),
            )
        )
    return Table("verdict", caption(found), tuple(columns), tuple(rows), small=True)


def caption(found: Verdict) -> Text:
    """Return the caption of the matrix."""
    if not found.basis:
        return say(
            "Demand over capacity (D/C) of each mechanism at the site’s own action, by each method, for comparison."
        )
    words = say(
        "Each mechanism at the site’s own action: verdict, the PGA up to which it holds by the deciding method, and "
        "demand over capacity (D/C). The deciding answer is coloured; the others, in grey, are for comparison."
    )
    return words if index_name(found) != ZETA else Paragraph((words, DEFINITION))


def methods(results: Results) -> list[Method]:
    """Return the methods that answer for some mechanism at the site's own action, in order of appearance."""
    checks = [check for mechanism in results.mechanisms for check in site_checks(results, mechanism)]
    answered = [check for check in checks if check.verdict not in governing.SILENT or check.role == "deciding"]
    pairs = dict.fromkeys((check.procedure, check.limit_state) for check in answered)
    procedures = [procedure for procedure, _ in pairs]
    return [Method(procedure, state, procedures.count(procedure) > 1) for procedure, state in pairs]


def site_checks(results: Results, mechanism: MechanismResult) -> tuple[Check, ...]:
    """Return the checks of a mechanism by the letter of a code at the site's own action."""
    return governing.code_checks(governing.at_site(results, mechanism))


def split_methods(every: Sequence[Method], found: Verdict, most: int) -> tuple[list[Method], list[Method]]:
    """Return the methods with a column of their own, those that may decide first, and those that share one."""
    ranked = sorted(every, key=lambda method: _rank(method, found))
    if len(ranked) <= most:
        return ranked, []
    return ranked[: most - 1], ranked[most - 1 :]


def _rank(method: Method, found: Verdict) -> int:
    decides = any(answer.procedure == method.procedure for one in found.mechanisms for answer in one.answers)
    if decides:
        return 0
    if method.procedure in found.methods:
        return 1
    return 2 if method.procedure.startswith(f"{found.basis}-") else 3


def cell(results: Results, mechanism: MechanismResult, one: MechanismVerdict, method: Method) -> Cell:
    """Return the answer of one method; None where the method does not apply to the mechanism."""
    checks = [check for check in site_checks(results, mechanism) if _is_by(check, method)]
    found = next((check for check in checks if check.role == "deciding"), None) or governing.worst(tuple(checks))
    if found is None or found.verdict == Outcome.NOT_APPLICABLE:
        return None
    if found.role == "deciding":
        return Graded(outcome_cell(found, one.answers).outcome, ratio_text(found))
    return Graded("comparison", ratio_text(found))


def _is_by(check: Check, method: Method) -> bool:
    return check.procedure == method.procedure and check.limit_state == method.limit_state


def ratio_text(check: Check) -> Text:
    """Return demand over capacity, or why there is no number."""
    if check.verdict == Outcome.NOT_ANSWERED:
        return say("not answered")
    if check.unbounded == "overturned":
        return say("overturns")
    if check.unbounded:
        return say("beyond the spectrum")
    if check.ratio is None:
        return say("fail") if check.verdict == Outcome.FAIL else say("pass")
    if check.ratio == 0.0:
        return say("no rocking")
    if check.ratio < LEAST:
        return say("below {least}", least=quantity(LEAST))
    return quantity(check.ratio, figures=ratio_figures(check, most=3))


def largest(results: Results, mechanism: MechanismResult, folded: Sequence[Method]) -> Cell:
    """Return the least favourable answer of several methods with its title; None where none of them applies."""
    pairs = [(check, method) for method in folded for check in site_checks(results, mechanism) if _is_by(check, method)]
    answered = [(check, method) for check, method in pairs if check.verdict not in governing.SILENT]
    if not answered:
        return None
    check, method = max(answered, key=lambda pair: governing.severity(pair[0]))
    return Graded("comparison", say("{ratio} ({method})", ratio=ratio_text(check), method=method.title))


def _index_cell(one: MechanismVerdict) -> Cell:
    """Return the least index of the deciding answers, with its grade if there are grades."""
    found = [answer.index for answer in one.answers if answer.index is not None]
    if not found:
        return None
    least = min(found, key=lambda index: index.value)
    value = quantity(least.value, figures=least.figures)
    return say("{value}, grade {grade}", value=value, grade=Verbatim(least.grade)) if least.grade else value
