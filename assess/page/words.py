"""What the panel of the page says, as HTML in which every text of a user is escaped."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape

from assess.codes.check import Check
from assess.codes.question import Missing
from assess.codes.verdict import (
    Decision,
    MechanismVerdict,
    action_text,
    building_index_text,
    index_of,
    least_index,
    margin_of,
    named_index_text,
    number_text,
    outcome_text,
    target_text,
)
from assess.model.candidates import Candidate
from assess.model.weakest_crack import WeakestCrack
from assess.project.evidence import meaning_of
from assess.project.opened import OpenedProject
from assess.project.trials import ShownMechanism, deciding_checks
from assess.results import OscillatorResult
from reports.chapters.key_plan import not_examined_text
from reports.chapters.verdict import PageList, headline, page_lists
from reports.language.locale import Locale

FIGURES = 4
WAITING = "not known yet"
STYLE = "margin:0.3em 0.9em;font-size:0.85em;overflow-wrap:anywhere"
CELL = "padding:0.1em 0.5em 0.1em 0;text-align:left;vertical-align:top;overflow-wrap:normal"
WARNS = "border-left:0.3em solid #d55e00;padding-left:0.5em"


def status(text: str) -> str:
    """Return a line on what the page is doing."""
    return f'<p role="status" aria-live="polite" style="{STYLE}">{escape(text)}</p>'


def fault(text: str) -> str:
    """Return a line on what was wrong, which stays until something else is done; nothing where nothing was."""
    return f'<p role="alert" style="{STYLE};{WARNS}"><b>{escape(text)}</b></p>' if text else ""


def building(opened: OpenedProject) -> str:
    """Return the verdict of the building and of what: conditions, replaced values, and what is not examined."""
    tried = len({key for setting in opened.edited.changes for key in setting})
    values = f"{tried} value{'s' * (tried != 1)} tried, not written" if tried else ""
    decision = opened.decision if opened.is_decided else None
    if decision is None:
        waits = "it is decided once what is tried rests" if tried else "it is decided when the page has been read"
        why = opened.why_undecided or waits if opened.has_site else "no [site]: multipliers alone; see “To complete it”"
        said = f"Building: <b>NOT KNOWN</b> ({escape(why)})" + (f"<br>{values}" if values else "")
        return f'<p style="{STYLE}">{said}</p>' + _found(opened) + _read(opened)
    found, results = decision.verdict, decision.results
    of = f"with what is tried: {values}" if tried else "as in the file"
    near = outcome_text(found.outcome, near=found.at_the_limit).upper()
    index = building_index_text(found)
    lines = [
        f"Building: <b>{escape(near)}</b> ({escape(of)})",
        escape(f"at {action_text(found.action)}, by {found.basis or 'no basis'}"),
        escape(f"index {index}, target {target_text(found) or 'not known'}; local mechanisms only") if index else "",
        escape(Locale().text(headline(found))),
    ]
    unexamined = not_examined_text(results)
    lists = "".join(_list(each, is_open=place == 0) for place, each in enumerate(page_lists(results, found)))
    left_out = "" if unexamined is None else _warning(f"Possible, not examined: {Locale().text(unexamined)}")
    return (
        f'<p style="{STYLE}">{"<br>".join(filter(None, lines))}</p>' + left_out + _found(opened) + lists + _read(opened)
    )


def option(name: str, opened: OpenedProject) -> str:
    """Return the entry of a mechanism in the list, with its number in the report."""
    shown = opened.outline(name)
    least = "" if shown.result is None or shown.fault else multiplier(shown.result.oscillator)
    verdict = shown.verdict if opened.is_decided else None
    outcome = "falls at rest" if shown.fault else verdict.outcome.value if verdict else ""
    index = "" if verdict is None else named_index_text(least_index(verdict))
    return " · ".join(each for each in (opened.heading(name), least, outcome, index) if each)


def option_found(each: Candidate) -> str:
    """Return the entry of a mechanism that the file does not have."""
    least = "" if each.multiplier is None else f" · {number_text(each.multiplier, FIGURES)}"
    return f"+ {each.title}{least} · found, not in the file"


def candidate(each: Candidate) -> str:
    """Return what was found of a mechanism that the file does not have."""
    rows = [("multiplier", "" if each.multiplier is None else number_text(each.multiplier, FIGURES))]
    rows += [("moves", ", ".join(each.parts)), ("carries", ", ".join(each.carries)), ("why", str(each.reason))]
    return _table(("", ""), [row for row in rows if row[1]])


def multiplier(found: OscillatorResult) -> str:
    """Return the multiplier at which it starts to rock."""
    known = found.uplift_multiplier
    return "no threshold" if known is None else number_text(known, FIGURES)


def mechanism(opened: OpenedProject, shown: ShownMechanism) -> str:
    """Return the numbers of a mechanism, and the answer of each method that may decide."""
    if shown.result is None or (shown.fault and not shown.as_typed):
        of = "" if shown.as_typed else f"{escape(_of_what(opened, shown))}<br>"
        said = f"<b>{escape(opened.heading(shown.name))}</b><br>{of}<b>{escape(shown.fault)}</b>"
        return f'<p style="{STYLE}">{said}</p>' + (_verdict(shown) if shown.verdict else "")
    found = shown.result.oscillator
    rows = [
        ("multiplier of uplift [-]", multiplier(found)),
        ("p [1/s]", number_text(found.p_eq_per_s, FIGURES)),
        ("mass [t]", number_text(found.mass_kg / 1000.0, FIGURES)),
        ("overturning rotation [rad]", number_text(found.overturning_rad, FIGURES)),
        ("restitution [-]", number_text(found.restitution, FIGURES)),
    ]
    title = escape(opened.heading(shown.name))
    fault = f"<br><b>{escape(shown.fault)}</b>" if shown.fault else ""
    said = f'<p style="{STYLE}"><b>{title}</b><br>{escape(_of_what(opened, shown))}{fault}</p>'
    warned = () if shown.mechanism is None else shown.mechanism.warnings
    doubts = "".join(_warning(each.text) for each in warned)
    return said + doubts + _table(("", ""), rows) + _methods(opened, shown) + _verdict(shown)


def missing_input(each: Missing) -> str:
    """Return what is missing for a verdict, with why and the sentence of the manual on it."""
    meaning = meaning_of(each.key)
    manual = f"<br><i>{escape(meaning)}</i>" if meaning else ""
    return f'<p style="{STYLE}"><b>{escape(each.key)}</b>: {escape(each.text)}{manual}</p>'


def weakest(found: WeakestCrack) -> str:
    """Return what is said of the weakest crack."""
    ends = f"; it is at an end of what is looked at ({', '.join(found.ends)}): a weaker one may lie beyond"
    alike = "; cracks as weak within 0.1 % reach from {:.2f} m to {:.2f} m".format(*found.tied or (0.0, 0.0))
    return (
        f"weakest crack: multiplier {number_text(found.multiplier, FIGURES)}, {100.0 * found.share:.3g} % of the mass "
        f"moves{ends if found.ends else ''}{alike if found.tied else ''}"
    )


def rise(before: float | None, after: float | None) -> str:
    """Return that a mechanism holds more of the action by a crack that starts to rock earlier; else nothing."""
    if before is None or after is None or after <= before:
        return ""
    held = f"it holds {number_text(after)} x the action in place of {number_text(before)} x"
    return f"{held}: the crack of least multiplier is not that of least index"


def links(paths: Iterable[tuple[str, str]]) -> str:
    """Return links to files of a run, each a path and a text."""
    made = " · ".join(f'<a href="{escape(path)}" target="_blank">{escape(text)}</a>' for path, text in paths)
    return f'<p style="{STYLE}">{made}</p>'


def _found(opened: OpenedProject) -> str:
    """Return a warning of mechanisms that were found and are not in the file; nothing where there are none."""
    proposed = opened.proposed
    known = [each.multiplier for each in proposed if each.multiplier is not None]
    if not proposed:
        return ""
    results = [opened.outline(name).result for name in opened.built_of.content.mechanisms]
    own = [each.oscillator.uplift_multiplier for each in results if each is not None]
    stronger = sum(each is not None and each > min(known) for each in own) if known else 0
    least = f"; the weakest has a multiplier of {number_text(min(known), FIGURES)}" if known else ""
    below = f", less than {stronger} of the {len(own)} of the file" if stronger else ""
    count = f"{len(proposed)} mechanism{'s' * (len(proposed) != 1)} found on the bodies and not in the file"
    return _warning(f"{count}: no part of this verdict{least}{below}")


def _read(opened: OpenedProject) -> str:
    """Return what was said when the model was read; nothing of a project that is not drawn from one."""
    points = "".join(f"<li>{escape(each)}</li>" for each in opened.remarks)
    title = f"<summary>Said when the model was read: {len(opened.remarks)}</summary>"
    return f'<details style="{STYLE}">{title}<ul>{points}</ul></details>' if points else ""


def _of_what(opened: OpenedProject, shown: ShownMechanism) -> str:
    """Return of which values the numbers of a mechanism are."""
    if shown.as_typed or opened.decision is None:
        waits = opened.has_site and not opened.why_undecided
        more = ": what a run decides by follows when it rests" if waits else ""
        return f"With the values as typed{more}."
    decided = opened.decision.decided.of.get(shown.name)
    case = None if decided is None else decided.case
    said = "As a run decides" + ("" if case is None else f", in the controlling case of {case.name}")
    replaced = "; ".join(f"{each.key}: {each.instead} for {each.value}" for each in opened.replacements(shown.name))
    return f"{said}, with values in place of those without a source: {replaced}." if replaced else f"{said}."


def _methods(opened: OpenedProject, shown: ShownMechanism) -> str:
    checks = deciding_checks(shown.checks, opened.study)
    absent = [each for each in opened.methods if not any(check.procedure == each for check in checks)]
    rest = "when it rests" if shown.as_typed and not opened.why_undecided else "not answered"
    rows = [_method(opened, each) for each in checks] + [(each, "", rest, "", "", "") for each in absent]
    return _table(("method", "state", "outcome", "D/C", "index", "holds"), rows) if rows else ""


def _method(opened: OpenedProject, check: Check) -> tuple[str, ...]:
    basis = opened.study.question.basis
    index, margin = None if basis is None else index_of(check, basis), margin_of(check)
    return (
        check.procedure,
        check.limit_state,
        check.verdict.value,
        "" if check.ratio is None else number_text(check.ratio),
        named_index_text(index),
        "" if margin is None else f"{number_text(margin)} x",
    )


def _verdict(shown: ShownMechanism) -> str:
    found = shown.verdict
    if found is None or (shown.as_typed and found.outcome == Decision.PASS):
        return f'<p style="{STYLE}">Verdict: {WAITING}</p>'
    margin = "" if found.margin is None else f", holds {number_text(found.margin)} x the action"
    of = " with the values as typed" if shown.as_typed else ""
    number = len(found.conditions)
    held = f", on {number} condition{'s' * (number != 1)}" if number else ""
    lines = "".join(f"<br>{escape(line)}" for line in _reasons(found))
    outcome = escape(found.outcome.value.upper())
    return f'<p style="{STYLE}">Verdict{of}: <b>{outcome}</b>{escape(margin)}{held}{lines}</p>'


def _reasons(found: MechanismVerdict) -> list[str]:
    """Return why answers do not pass, and on what the pass depends."""
    why = [each.reason.text for each in found.answers if each.outcome != Decision.PASS]
    return [*why, *(f"on condition: {each.text}" for each in found.conditions)]


def _warning(text: str) -> str:
    return f'<p style="{STYLE};{WARNS}">{escape(text)}</p>'


def _list(found: PageList, *, is_open: bool) -> str:
    """Return a list of page 1 of the report, which opens under its title."""
    if not found.points:
        return ""
    points = "".join(f"<li>{escape(Locale().text(each))}</li>" for each in found.points)
    title = escape(Locale().text(found.title))
    opening = " open" if is_open else ""
    return (
        f'<details{opening} style="{STYLE}"><summary>{title} {len(found.points)}</summary>'
        f'<ul style="margin:0;padding-left:1.2em">{points}</ul></details>'
    )


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    top = "".join(f'<th style="{CELL}">{escape(each)}</th>' for each in head)
    body = "".join(
        "<tr>" + "".join(f'<td style="{CELL}">{escape(cell)}</td>' for cell in row) + "</tr>" for row in rows
    )
    shown = f"<thead><tr>{top}</tr></thead>" if any(head) else ""
    return f'<table style="{STYLE};border-collapse:collapse">{shown}<tbody>{body}</tbody></table>'
