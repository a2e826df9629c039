"""Page 1: the verdict, its basis and conditions, what is missing, and each mechanism by the methods that answer."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from assess.codes.check import Check, Outcome, Reason
from assess.codes.histories import ratio_figures
from assess.codes.verdict import Decision, MechanismVerdict, State, Verdict, relevant_warnings
from assess.messages.message import Message, Quantity
from assess.results import MechanismResult, Results, SpectrumResult
from reports import governing
from reports.chapters import cells
from reports.chapters.front_matter import use_class_of
from reports.chapters.key_plan import not_examined_text
from reports.document import NOTHING, Banner, Block, BulletList, Cell, Column, Facts, OutcomeCell, Prose, Section, Table
from reports.language.texts import (
    Paragraph,
    Phrase,
    Term,
    Text,
    Verbatim,
    count,
    listing,
    quantity,
    say,
    say_count,
    with_figures,
)
from reports.language.value_names import key_words, parameter_rows
from reports.mechanisms import mechanism_list, numbered_title, procedure_title
from reports.project_values import split_key

MAX_POINTS = 4  # points of a list; page 1 holds no more

LIMIT_STATES: Mapping[str, Phrase] = {
    "SLV": say("SLV (life safety)"),
    "SLC": say("SLC (collapse prevention)"),
    "SLD": say("SLD (damage limitation)"),
    "SLO": say("SLO (operation)"),
    "ULS": say("ULS (ultimate limit state)"),
    "DBE": say("DBE (design basis earthquake)"),
    "LS": say("LS (life safety)"),
    "CP": say("CP (collapse prevention)"),
    "NCR": say("NCR (near collapse)"),
}

ESSENTIAL: Mapping[str, Phrase] = {
    "soil": say("subsoil category {value}"),
    "ground_type": say("ground type {value}"),
    "site_class": say("site class {value}"),
    "subsoil": say("site subsoil class {value}"),
    "topography": say("topographic category {value}"),
    "a_g": say("a_g = {value} on rock"),
    "s": say("S = {value}"),
    "s_ds": say("S_DS = {value}"),
    "s_d1": say("S_D1 = {value}"),
}
"""The parameters of the spectrum that page 1 shows."""


def sections(results: Results) -> list[Section]:
    """Return the first page."""
    verdict = results.verdict
    if verdict is None:
        words = say("These results hold no verdict: they were made by an older version of the program.")
        return [Section(say("Verdict"), 0, (Prose((words,)),))]
    held, helping, missing, warned = map(_short_list, page_lists(results, verdict))
    blocks: list[Block] = [
        Banner(
            verdict.outcome.value, headline(verdict), verdict.at_the_limit and verdict.outcome != Decision.INCOMPLETE
        ),
        Facts(tuple(_basis_facts(results, verdict))),
        *held,
        *helping,
        *missing,
        *(cells.provisional_outcome(verdict) if missing else ()),
        *warned,
        matrix(results, verdict),
    ]
    return [Section(say("Verdict"), 0, tuple(blocks))]


@dataclass(frozen=True)
class PageList:
    """A list of page 1. title, full_title : there and where all of it is shown; most : points that page 1 shows."""

    title: Text
    full_title: Text
    points: Sequence[Text]
    most: int = MAX_POINTS

    @property
    def is_shortened(self) -> bool:
        """Whether page 1 shows only the first points: a single one more has room."""
        return len(self.points) > self.most + 1


def page_lists(results: Results, verdict: Verdict) -> tuple[PageList, ...]:
    """Return the lists of page 1: conditions, what the verdict hangs on, what is missing, warnings.

    Parameters
    ----------
    results : of a run
    verdict : its verdict
    """
    is_open = verdict.outcome == Decision.INCOMPLETE
    lists = (
        PageList(
            say("The verdict is subject to these conditions:"),
            say("All conditions of the verdict:"),
            conditions(results, verdict),
        ),
        PageList(_hangs_on(verdict), _hangs_on(verdict), cells.override_texts(results, verdict)),
        PageList(
            say("What is missing:"),
            say("All that is missing:"),
            cells.missing_texts(results, verdict) if is_open else [],
        ),
    )
    shown = sum(min(len(each.points), MAX_POINTS + 1) for each in lists)
    warned = PageList(
        say("Warnings that bear on the verdict:"),
        say("All warnings that bear on the verdict:"),
        warnings(results),
        max(2, 2 * MAX_POINTS - shown),
    )
    return (*lists, warned)


def headline(verdict: Verdict) -> Text:
    """Return the meaning of the verdict in one sentence."""
    pga = quantity(verdict.action.pga_g, "ground acceleration", 3)
    if verdict.outcome == Decision.PASS:
        return _all_hold(verdict, pga)
    if verdict.outcome == Decision.FAIL:
        return _some_fail(verdict, pga)
    if not verdict.basis:
        return say("No code is named that decides: the results of all methods are for comparison only.")
    return _some_are_open(verdict, pga)


def _hangs_on(verdict: Verdict) -> Text:
    """Return the title of the values that help: what the verdict hangs on, or what was not believed."""
    if verdict.state == State.REPLACED:
        return say("It decides what holds without the values that no source vouches for; each alone:")
    return say("The verdict hangs on these values:")


def conditions(results: Results, verdict: Verdict) -> list[Text]:
    """Return on what the verdict depends: what is still to be shown, and what the project vouches for."""
    return [
        *cells.condition_texts(results, verdict.conditions),
        *(cells.stated_premises(results) if verdict.basis else ()),
    ]


def action_text(results: Results, verdict: Verdict) -> Text:
    """Return the site's own action: PGA, limit state, return period and class of use as far as they are known."""
    action = verdict.action
    known: list[Text] = [say("PGA {pga}", pga=quantity(action.pga_g, "ground acceleration", 3))]
    if action.limit_state and action.over_periods:
        state = Verbatim(action.limit_state)
        known.append(say("for {limit_state} from the hazard of the site over return periods", limit_state=state))
    elif action.limit_state:
        known.append(say("stated for {limit_state}", limit_state=Verbatim(action.limit_state)))
    if action.return_period_years:
        known.append(say("return period {years}", years=quantity(action.return_period_years, "return period", 3)))
    elif action.limit_state:
        known.append(say("return period not stated"))
    if use_class_of(results):
        known.append(say("class of use {name}", name=Verbatim(use_class_of(results))))
    return listing(known, "")


def warnings(results: Results) -> list[Text]:
    """Return the warnings of the run and the remarks of the checks that decide, each once with where it holds."""
    found: dict[tuple[str, str], list[Message]] = {}
    for each in (*relevant_warnings(results.warnings), *_remarks(results)):
        found.setdefault((each.key, each.text), []).append(each)
    return [_placed(results, same) for same in found.values()]


ZETA = "zeta_E"
ZETA_DEFINITION = say("ζ_E is the PGA at capacity over the PGA required, both as a_g S at the ground (NTC 2018, 8.3).")
LEAST_RATIO = 0.001  # ratio that is written as a number
MAX_COLUMNS = 8  # columns that can be read on a page
MAX_ROWS = 8  # mechanisms up to which a row has two lines


@dataclass(frozen=True)
class MethodColumn:
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


def matrix(results: Results, verdict: Verdict) -> Table:
    """Tabulate mechanism by answer: the deciding one in the colour of its outcome, the others in grey."""
    has_index = verdict.index is not None and verdict.index.name != cells.DEMAND_CAPACITY
    shown, folded = _split_methods(_answering_methods(results), verdict, MAX_COLUMNS - 3 - has_index)
    is_long = len(verdict.mechanisms) > MAX_ROWS
    columns = [Column(say("Mechanism"), share=0.37 if is_long else 0.2), Column(say("Verdict"))]
    columns += [Column(say("Holds up to PGA"))]
    columns += [Column(cells.index_symbol(verdict.index.name))] if has_index and verdict.index is not None else []
    columns += [Column(say("D/C, {method}", method=method.title)) for method in shown]
    columns += [Column(say("Largest D/C of the other methods"))] if folded else []
    rows = []
    for one in verdict.mechanisms:
        mechanism = next((each for each in results.mechanisms if each.name == one.mechanism), None)  # None: it falls
        rows.append(
            (
                numbered_title(results, one.mechanism),
                OutcomeCell(one.outcome.value, cells.outcome_text(one.outcome, near=one.at_the_limit)),
                _held_text(one, verdict, has_index=has_index),
                *((_index_cell(one),) if has_index else ()),
                *(mechanism and _method_cell(results, mechanism, one, method) for method in shown),
                *((mechanism and _least_favourable_cell(results, mechanism, folded),) if folded else ()),
            )
        )
    return Table("verdict", _matrix_caption(verdict), tuple(columns), tuple(rows), small=True)


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
        return cells.SLIDES if check.reason.key == Reason.SLIDES_INSTEAD else say("no rocking")
    if check.ratio < LEAST_RATIO:
        return say("below {least}", least=quantity(LEAST_RATIO))
    return quantity(check.ratio, figures=ratio_figures(check, most=3))


def _all_hold(verdict: Verdict, pga: Quantity) -> Text:
    """Return that the action is borne, or that share of it which is the target."""
    target = cells.target_text(verdict)
    if cells.has_reduced_target(verdict) and target is not None:
        return say_count(
            "The one mechanism examined reaches the target at the site’s own action, PGA {pga}: {target}.",
            "All {number} mechanisms examined reach the target at the site’s own action, PGA {pga}: {target}.",
            len(verdict.mechanisms),
            pga=pga,
            target=target,
        )
    return say_count(
        "The one mechanism examined holds at the site’s own action, PGA {pga}.",
        "All {number} mechanisms examined hold at the site’s own action, PGA {pga}.",
        len(verdict.mechanisms),
        pga=pga,
    )


def _some_fail(verdict: Verdict, pga: Quantity) -> Text:
    every = len(verdict.mechanisms)
    if every == 1:
        return say("The one mechanism examined fails at the site’s own action, PGA {pga}.", pga=pga)
    return say_count(
        "{number} of {every} mechanisms examined fails at the site’s own action, PGA {pga}.",
        "{number} of {every} mechanisms examined fail at the site’s own action, PGA {pga}.",
        sum(one.outcome == Decision.FAIL for one in verdict.mechanisms),
        every=count(every),
        pga=pga,
    )


def _some_are_open(verdict: Verdict, pga: Quantity) -> Text:
    every = len(verdict.mechanisms)
    if every == 1:
        return say("The one mechanism examined has no deciding answer at the site’s own action, PGA {pga}.", pga=pga)
    return say_count(
        "{number} of {every} mechanisms examined has no deciding answer at the site’s own action, PGA {pga}.",
        "{number} of {every} mechanisms examined have no deciding answer at the site’s own action, PGA {pga}.",
        sum(one.outcome == Decision.INCOMPLETE for one in verdict.mechanisms),
        every=count(every),
        pga=pga,
    )


def _basis_facts(results: Results, verdict: Verdict) -> Iterator[tuple[Text, Text]]:
    """Yield what the verdict is based on: code, limit state, action, methods, target and index."""
    yield say("Code"), _code(results, verdict)
    if verdict.limit_states and verdict.basis != cells.OWN_BASIS:
        states = listing(LIMIT_STATES.get(state, Verbatim(state)) for state in verdict.limit_states)
        yield say("Limit state"), states
    yield say("Site’s own action"), action_text(results, verdict)
    if results.spectrum is not None:
        yield say("Spectrum"), _spectrum_text(results.spectrum)
    if verdict.methods:
        yield say("Methods that may decide"), listing(map(procedure_title, verdict.methods))
    known = cells.knowledge_text(results)
    if known is not None:
        yield say("Knowledge level"), known
    yield from _measures(results, verdict)
    left = not_examined_text(results)
    if left is not None:
        yield say("Possible, not examined"), left


def _measures(results: Results, verdict: Verdict) -> Iterator[tuple[Text, Text]]:
    """Yield target, index and least margin, as far as they are known."""
    target, index, least = cells.target_text(verdict), cells.building_index_text(verdict), cells.least_margin(verdict)
    works = cells.works_text(results)
    if target is not None:
        yield say("Target"), target if works is None else say("{target} ({works})", target=target, works=works)
    elif works is not None:
        yield say("Target"), say("none known ({works})", works=works)
    if index is not None:
        yield say("Index of the building"), say("{index}; local mechanisms only", index=index)
    if results.before is not None and results.before.index is not None:
        yield say("Index before the works"), say("at most {index}", index=cells.index_text(results.before.index))
    if least is not None:
        margin = cells.margin_text(least, verdict.action) or NOTHING
        title = numbered_title(results, least.mechanism)
        yield say("Least margin"), say("{mechanism} holds up to a PGA of {margin}", mechanism=title, margin=margin)


def _code(results: Results, verdict: Verdict) -> Text:
    """Return the edition of the code with its national annex; of a basis of its own the user's statement."""
    if not verdict.basis:
        return say("none named")
    if verdict.basis == cells.OWN_BASIS:
        return Verbatim(verdict.clauses[0][0])
    annex, edition = results.report.national_annex, Term(verdict.edition)
    if not annex:
        return edition
    return say("{edition}, national annex: {annex}", edition=edition, annex=Verbatim(annex))


def _spectrum_text(spectrum: SpectrumResult) -> Text:
    """Return the clause of the spectrum with the parameters that an authority looks for first."""
    rows = dict(zip(spectrum.parameters, parameter_rows(spectrum.parameters), strict=True))
    known = [(phrase.english, rows[key][1]) for key, phrase in ESSENTIAL.items() if key in rows]
    return listing(
        [Term(spectrum.clause), *(Phrase(words, {"value": with_figures(value, 3)}) for words, value in known)], ""
    )


def _remarks(results: Results) -> Iterator[Message]:
    for mechanism in results.mechanisms:
        deciding = (check for check in mechanism.checks if check.role == "deciding")
        for each in (remark for check in deciding for remark in check.remarks):
            yield replace(each, where=f"mechanisms.{mechanism.name}")


def _placed(results: Results, same: Sequence[Message]) -> Text:
    """Return a message with the mechanisms or the keys of the project file that it concerns."""
    owners = [_owner(results, each.where) for each in same]
    if all(owners):
        return say("{places}: {message}", places=mechanism_list(results, owners), message=same[0])
    keys = dict.fromkeys(key_words(each.where) for each in same if "." in each.where)
    return say("{places}: {message}", places=listing(keys), message=same[0]) if keys else same[0]


def _owner(results: Results, where: str) -> str:
    """Return the mechanism that a message is about, by its name or its key; empty for none."""
    named = any(where == each.name for each in results.mechanisms)
    return where if named else split_key(results, where)[0]


def _short_list(shown: PageList) -> list[Block]:
    """Return a list under its title; of a long one the first points, and how many there are besides."""
    if not shown.points:
        return []
    if not shown.is_shortened:
        return [Prose((shown.title,)), BulletList(tuple(shown.points))]
    rest = say_count(
        "and {number} other, under Scope and limits",
        "and {number} others, under Scope and limits",
        len(shown.points) - shown.most,
    )
    return [Prose((shown.title,)), BulletList((*shown.points[: shown.most], rest))]


def _matrix_caption(verdict: Verdict) -> Text:
    """Return the caption of the matrix."""
    if not verdict.basis:
        return say(
            "Demand over capacity (D/C) of each mechanism at the site’s own action, by each method, for comparison."
        )
    words = say(
        "Each mechanism at the site’s own action: verdict, the PGA up to which it holds by the deciding method, and "
        "demand over capacity (D/C). The deciding answer is coloured; the others, in grey, are for comparison."
    )
    return words if cells.index_name(verdict) != ZETA else Paragraph((words, ZETA_DEFINITION))


def _answering_methods(results: Results) -> list[MethodColumn]:
    """Return the methods that answer for some mechanism at the site's own action, in order of appearance."""
    checks = [check for mechanism in results.mechanisms for check in governing.code_checks_at_site(results, mechanism)]
    answered = [check for check in checks if check.verdict not in governing.UNANSWERED or check.role == "deciding"]
    pairs = dict.fromkeys((check.procedure, check.limit_state) for check in answered)
    procedures = [procedure for procedure, _ in pairs]
    return [MethodColumn(procedure, state, procedures.count(procedure) > 1) for procedure, state in pairs]


def _split_methods(
    every: Sequence[MethodColumn], verdict: Verdict, most: int
) -> tuple[list[MethodColumn], list[MethodColumn]]:
    """Return the methods with a column of their own, those that may decide first, and those that share one."""
    ranked = sorted(every, key=lambda method: _method_rank(method, verdict))
    if len(ranked) <= most:
        return ranked, []
    return ranked[: most - 1], ranked[most - 1 :]


def _method_rank(method: MethodColumn, verdict: Verdict) -> int:
    decides = any(answer.procedure == method.procedure for one in verdict.mechanisms for answer in one.answers)
    if decides:
        return 0
    if method.procedure in verdict.methods:
        return 1
    return 2 if method.procedure.startswith(f"{verdict.basis}-") else 3


def _held_text(mechanism_verdict: MechanismVerdict, verdict: Verdict, *, has_index: bool) -> Text | None:
    """Return up to which PGA a mechanism holds, with the factor on the site's own where no index beside it has that."""
    if mechanism_verdict.margin is None or not has_index:
        return cells.margin_text(mechanism_verdict, verdict.action)
    return cells.capacity_pga_text(mechanism_verdict, mechanism_verdict.margin, verdict.action)


def _method_cell(
    results: Results, mechanism: MechanismResult, mechanism_verdict: MechanismVerdict, method: MethodColumn
) -> Cell:
    """Return the answer of one method; None where the method does not apply to the mechanism."""
    checks = [check for check in governing.code_checks_at_site(results, mechanism) if _is_by(check, method)]
    found = next((check for check in checks if check.role == "deciding"), None) or governing.worst_check(tuple(checks))
    if found is None or found.verdict == Outcome.NOT_APPLICABLE:
        return None
    if found.role == "deciding":
        return OutcomeCell(cells.outcome_cell(found, mechanism_verdict.answers).outcome, ratio_text(found))
    return OutcomeCell("comparison", ratio_text(found))


def _is_by(check: Check, method: MethodColumn) -> bool:
    return check.procedure == method.procedure and check.limit_state == method.limit_state


def _least_favourable_cell(results: Results, mechanism: MechanismResult, folded: Sequence[MethodColumn]) -> Cell:
    """Return the least favourable answer of several methods with its title; None where none of them applies."""
    pairs = [
        (check, method)
        for method in folded
        for check in governing.code_checks_at_site(results, mechanism)
        if _is_by(check, method)
    ]
    answered = [(check, method) for check, method in pairs if check.verdict not in governing.UNANSWERED]
    if not answered:
        return None
    check, method = max(answered, key=lambda pair: governing.severity(pair[0]))
    return OutcomeCell("comparison", say("{ratio} ({method})", ratio=ratio_text(check), method=method.title))


def _index_cell(mechanism_verdict: MechanismVerdict) -> Cell:
    """Return the least index of the deciding answers, with its grade if there are grades."""
    found = [answer.index for answer in mechanism_verdict.answers if answer.index is not None]
    if not found:
        return None
    least = min(found, key=lambda index: index.value)
    value = quantity(least.value, figures=least.figures)
    return say("{value}, grade {grade}", value=value, grade=Verbatim(least.grade)) if least.grade else value
