"""Page 1: the verdict, its basis and conditions, what is missing, and the answer of each mechanism."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from assess.codes.verdict import Decision, Verdict
from assess.codes.verdict_text import relevant_warnings
from assess.messages.message import Message, Quantity
from assess.results import Results, SpectrumResult
from reports.chapters import missing_inputs, premises, verdict_matrix
from reports.chapters.checklist import not_examined_text
from reports.chapters.front_matter import use_class_of
from reports.chapters.index_text import (
    OWN,
    building_index_text,
    is_lowered,
    least_margin,
    margin_text,
    target_text,
)
from reports.chapters.mechanism_keys import split_key
from reports.chapters.mechanism_list import mechanism_list
from reports.document import NOTHING, Banner, Block, Facts, Items, Prose, Section
from reports.language.spectrum_parameters import parameter_rows
from reports.language.texts import (
    Phrase,
    Term,
    Text,
    Verbatim,
    count,
    listing,
    names,
    quantity,
    say,
    say_count,
)
from reports.project_text import project_text
from reports.titles import numbered_title, procedure_title

MANY = 6  # points of a list; page 1 holds no more
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
WORKS: Mapping[str, Phrase] = {
    "repair": say("local repair"),
    "improvement": say("improvement"),
    "upgrading": say("upgrading"),
}


def sections(results: Results) -> list[Section]:
    """Return the first page."""
    found = results.verdict
    if found is None:
        words = say("These results hold no verdict: they were made by an older version of the program.")
        return [Section(say("Verdict"), 0, (Prose((words,)),))]
    blocks: list[Block] = [
        Banner(found.outcome.value, headline(found), found.at_the_limit and found.outcome != Decision.INCOMPLETE),
        Facts(tuple(basis(results, found))),
        *short_list(say("The verdict is subject to these conditions:"), conditions(results, found)),
        *_missing(found, results),
        *short_list(say("Warnings that bear on the verdict:"), warnings(results)),
        verdict_matrix.table(results, found),
    ]
    return [Section(say("Verdict"), 0, tuple(blocks))]


def headline(found: Verdict) -> Text:
    """Return the meaning of the verdict in one sentence."""
    pga = quantity(found.action.pga_g, "ground acceleration", 3)
    if found.outcome == Decision.PASS:
        return _all_hold(found, pga)
    if found.outcome == Decision.FAIL:
        return _some_fail(found, pga)
    if not found.basis:
        return say("No code is named that decides: the results of all methods are for comparison only.")
    return _some_are_open(found, pga)


def _all_hold(found: Verdict, pga: Quantity) -> Text:
    """Return that the action is borne, or that share of it which is the target."""
    target = target_text(found)
    if is_lowered(found) and target is not None:
        return say_count(
            "The one mechanism examined reaches the target at the site’s own action, PGA {pga}: {target}.",
            "All {number} mechanisms examined reach the target at the site’s own action, PGA {pga}: {target}.",
            len(found.mechanisms),
            pga=pga,
            target=target,
        )
    return say_count(
        "The one mechanism examined holds at the site’s own action, PGA {pga}.",
        "All {number} mechanisms examined hold at the site’s own action, PGA {pga}.",
        len(found.mechanisms),
        pga=pga,
    )


def _some_fail(found: Verdict, pga: Quantity) -> Text:
    every = len(found.mechanisms)
    if every == 1:
        return say("The one mechanism examined fails at the site’s own action, PGA {pga}.", pga=pga)
    return say_count(
        "{number} of {every} mechanisms examined fails at the site’s own action, PGA {pga}.",
        "{number} of {every} mechanisms examined fail at the site’s own action, PGA {pga}.",
        sum(one.outcome == Decision.FAIL for one in found.mechanisms),
        every=count(every),
        pga=pga,
    )


def _some_are_open(found: Verdict, pga: Quantity) -> Text:
    every = len(found.mechanisms)
    if every == 1:
        return say("The one mechanism examined has no deciding answer at the site’s own action, PGA {pga}.", pga=pga)
    return say_count(
        "{number} of {every} mechanisms examined has no deciding answer at the site’s own action, PGA {pga}.",
        "{number} of {every} mechanisms examined have no deciding answer at the site’s own action, PGA {pga}.",
        sum(one.outcome == Decision.INCOMPLETE for one in found.mechanisms),
        every=count(every),
        pga=pga,
    )


def conditions(results: Results, found: Verdict) -> list[Text]:
    """Return on what the verdict depends: what is still to be shown, and what the project vouches for."""
    return [*found.conditions, *(premises.premises(results) if found.basis else ())]


def basis(results: Results, found: Verdict) -> Iterator[tuple[Text, Text]]:
    """Yield what the verdict is based on: code, limit state, action, methods, target and index."""
    yield say("Code"), _code(results, found)
    if found.limit_states and found.basis != OWN:
        states = listing(LIMIT_STATES.get(state, Verbatim(state)) for state in found.limit_states)
        yield say("Limit state"), states
    yield say("Site’s own action"), action_text(results, found)
    if results.spectrum is not None:
        yield say("Spectrum"), spectrum_text(results.spectrum)
    if found.methods:
        yield say("Methods that may decide"), listing(map(procedure_title, found.methods))
    known = premises.knowledge(results)
    if known is not None:
        yield say("Knowledge level"), known
    yield from _measures(results, found)
    left = not_examined_text(results)
    if left is not None:
        yield say("Possible, not examined"), left


def _measures(results: Results, found: Verdict) -> Iterator[tuple[Text, Text]]:
    """Yield target, index and least margin, as far as they are known."""
    target, index, least = target_text(found), building_index_text(found), least_margin(found)
    if target is not None:
        yield say("Target"), _with_works(results, target)
    if index is not None:
        yield say("Index of the building"), say("{index}; local mechanisms only", index=index)
    if least is not None:
        margin = margin_text(least, found.action) or NOTHING
        title = numbered_title(results, least.mechanism)
        yield say("Least margin"), say("{mechanism} holds up to a PGA of {margin}", mechanism=title, margin=margin)


def _code(results: Results, found: Verdict) -> Text:
    """Return the edition of the code with its national annex; of a basis of its own the user's statement."""
    if not found.basis:
        return say("none named")
    if found.basis == OWN:
        return Verbatim(found.clauses[0][0])
    annex, edition = results.report.national_annex, Term(found.edition)
    if not annex:
        return edition
    return say("{edition}, national annex: {annex}", edition=edition, annex=Verbatim(annex))


def action_text(results: Results, found: Verdict) -> Text:
    """Return the site's own action: PGA, limit state, return period and class of use as far as they are known."""
    action = found.action
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


def spectrum_text(spectrum: SpectrumResult) -> Text:
    """Return the clause of the spectrum with the parameters that an authority looks for first."""
    rows = dict(zip(spectrum.parameters, parameter_rows(spectrum.parameters), strict=True))
    known = [(phrase.english, rows[key][1]) for key, phrase in ESSENTIAL.items() if key in rows]
    return listing([Term(spectrum.clause), *(Phrase(words, {"value": _short(value)}) for words, value in known)], "")


def _short(value: Text) -> Text:
    return replace(value, figures=3) if isinstance(value, Quantity) else value


def _with_works(results: Results, target: Text) -> Text:
    works = WORKS.get(project_text(results, "verdict.works"))
    return target if works is None else say("{target} ({works})", target=target, works=works)


def _missing(found: Verdict, results: Results) -> list[Block]:
    """Return what would complete the verdict, as lines to paste, and what it would be with the safe values."""
    if found.outcome != Decision.INCOMPLETE or not found.missing:
        return []
    blocks = short_list(say("What is missing:"), missing_inputs.missing_texts(results, found))
    if missing_inputs.fits_page_1(results, found):
        blocks += missing_inputs.paste(results, found)
    else:
        blocks += [Prose((say("The lines that complete the project file are listed under Recommendations."),))]
    return [*blocks, *missing_inputs.provisional(found)]


def warnings(results: Results) -> list[Text]:
    """Return the warnings of the run and the remarks of the checks that decide, each once with where it holds."""
    found: dict[tuple[str, str], list[Message]] = {}
    for each in (*relevant_warnings(results.warnings), *_remarks(results)):
        found.setdefault((each.key, each.text), []).append(each)
    return [_placed(results, same) for same in found.values()]


def _remarks(results: Results) -> Iterator[Message]:
    for mechanism in results.mechanisms:
        deciding = (check for check in mechanism.checks if check.role == "deciding")
        for each in (remark for check in deciding for remark in check.remarks):
            yield Message(each.key, each.severity, f"mechanisms.{mechanism.name}", each.text, each.values)


def _placed(results: Results, same: Sequence[Message]) -> Text:
    """Return a message with the mechanisms or the keys of the project file that it concerns."""
    owners = [_owner(results, each.where) for each in same]
    if all(owners):
        return say("{places}: {message}", places=mechanism_list(results, owners), message=same[0])
    keys = [each.where for each in same if "." in each.where]
    return say("{places}: {message}", places=names(keys), message=same[0]) if keys else same[0]


def _owner(results: Results, where: str) -> str:
    """Return the mechanism that a message is about, by its name or its key; empty for none."""
    named = any(where == each.name for each in results.mechanisms)
    return where if named else split_key(results, where)[0]


def is_shortened(points: Sequence[Text]) -> bool:
    """Return whether page 1 shows only the first of these points."""
    return len(points) > MANY + 1


def short_list(title: Text, points: Sequence[Text]) -> list[Block]:
    """Return a list under its title; of a long one the first points, and how many there are besides."""
    if not points:
        return []
    if not is_shortened(points):
        return [Prose((title,)), Items(tuple(points))]
    rest = say_count(
        "and {number} other, under Scope and limits",
        "and {number} others, under Scope and limits",
        len(points) - MANY,
    )
    return [Prose((title,)), Items((*points[:MANY], rest))]
