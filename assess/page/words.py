"""What the panel of the page says, as HTML in which every text of a user is escaped."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape

from assess.codes.check import Check
from assess.codes.verdict import (
    MechanismVerdict,
    Verdict,
    action_text,
    index_of,
    margin_of,
    named_index_text,
    number_text,
    outcome_text,
)
from assess.model.candidates import Candidate
from assess.page.opened import OpenedProject, ShownMechanism, deciding_checks
from assess.results import OscillatorResult

FIGURES = 4
WAITING = "not known yet"


def status(text: str) -> str:
    """Return a line on what the page is doing, or what was wrong."""
    return f'<p role="status" aria-live="polite" style="{STYLE}">{escape(text)}</p>'


def building(found: Verdict | None, *, has_site: bool, changed: int) -> str:
    """Return the verdict of the building as the file has it, and how many values are tried beside."""
    if found is None:
        said = "being examined" if has_site else "no [site]: multipliers alone"
    else:
        near = outcome_text(found.outcome, near=found.at_the_limit)
        said = f"<b>{escape(near.upper())}</b> at {escape(action_text(found.action))}, by {escape(found.basis)}"
        if found.other_state is not None and found.state != "as-typed":
            said += "; values without a source are replaced"
    tried = f"<br>{changed} value{'s' * (changed != 1)} tried, not written" if changed else ""
    return f'<p style="{STYLE}">Building: {said}{tried}</p>'


def option(number: int, name: str, opened: OpenedProject, shown: ShownMechanism) -> str:
    """Return the entry of a mechanism in the list."""
    least = "" if shown.result is None else multiplier(shown.result.oscillator)
    outcome = shown.verdict.outcome.value if shown.verdict else "falls at rest" if shown.fault else ""
    label = opened.project.content.mechanisms[name].label or name
    return " · ".join(each for each in (f"{number}. {label}", least, outcome) if each)


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
    if shown.result is None:
        return f'<p style="{STYLE}"><b>{escape(shown.fault)}</b></p>'
    found = shown.result.oscillator
    rows = [
        ("multiplier of uplift [-]", multiplier(found)),
        ("p [1/s]", number_text(found.p_eq_per_s, FIGURES)),
        ("mass [t]", number_text(found.mass_kg / 1000.0, FIGURES)),
        ("overturning rotation [rad]", number_text(found.overturning_rad, FIGURES)),
        ("restitution [-]", number_text(found.restitution, FIGURES)),
    ]
    return _table(("", ""), rows) + _methods(opened, shown) + _verdict(shown.verdict)


def links(paths: Iterable[tuple[str, str]]) -> str:
    """Return links to files of a run, each a path and a text."""
    made = " · ".join(f'<a href="{escape(path)}" target="_blank">{escape(text)}</a>' for path, text in paths)
    return f'<p style="{STYLE}">{made}</p>'


STYLE = "margin:0.3em 0.9em;font-size:0.85em;overflow-wrap:anywhere"
CELL = "padding:0.1em 0.5em 0.1em 0;text-align:left;vertical-align:top;overflow-wrap:normal"


def _methods(opened: OpenedProject, shown: ShownMechanism) -> str:
    checks = deciding_checks(shown.checks, opened.study)
    absent = [each for each in opened.methods if not any(check.procedure == each for check in checks)]
    rows = [_method(opened, each) for each in checks] + [(each, "", "when it rests", "", "", "") for each in absent]
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


def _verdict(found: MechanismVerdict | None) -> str:
    if found is None:
        return f'<p style="{STYLE}">Verdict: {WAITING}</p>'
    margin = "" if found.margin is None else f", holds {number_text(found.margin)} x the action"
    why = "".join(f"<br>{escape(each.reason.text)}" for each in found.answers if each.outcome.value != "pass")
    return f'<p style="{STYLE}">Verdict: <b>{escape(found.outcome.value.upper())}</b>{escape(margin)}{why}</p>'


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    top = "".join(f'<th style="{CELL}">{escape(each)}</th>' for each in head)
    body = "".join(
        "<tr>" + "".join(f'<td style="{CELL}">{escape(cell)}</td>' for cell in row) + "</tr>" for row in rows
    )
    shown = f"<thead><tr>{top}</tr></thead>" if any(head) else ""
    return f'<table style="{STYLE};border-collapse:collapse">{shown}<tbody>{body}</tbody></table>'
