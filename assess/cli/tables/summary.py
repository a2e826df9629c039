"""What `assess run` prints: the answer that decides each mechanism, and the verdict with what it rests on."""

from __future__ import annotations

from collections.abc import Iterator
from textwrap import wrap

from assess.cli.tables.text_table import on_one_line, text_table
from assess.codes.verdict import Answer, Decision, MechanismVerdict, Verdict
from assess.codes.verdict_text import (
    action_text,
    building_index_text,
    figures,
    index_text,
    outcome_text,
    relevant_warnings,
    target_text,
    toml_lines,
)
from assess.project.key_text import escape_text
from assess.results import Results

CODES = {Decision.PASS: 0, Decision.FAIL: 1, Decision.INCOMPLETE: 3}
"""Exit codes of `assess run`."""
PROVISIONAL = "were all this given, with the safe value where there is one, the verdict would be: "
HEADER = ("verdict", "state", "decided by", "index", "holds up to")
WIDE, LEAST = 100, 16  # characters of a line, and of the name of a mechanism


def exit_code(results: Results) -> int:
    """The exit code of a run: incomplete where no verdict was asked."""
    return CODES[Decision.INCOMPLETE if results.verdict is None else results.verdict.outcome]


def summary(results: Results) -> str:
    """A line for each mechanism and limit state, why they do not pass, and the verdict with what it rests on."""
    found = results.verdict
    if found is None:
        return "no verdict\n"
    pairs = [(one, answer) for one in found.mechanisms for answer in one.answers]
    told = relevant_warnings(results.warnings)
    notes = [each for each in results.warnings if each not in told]
    lines = [
        *_reasons(found),
        *(f"note: {each.where}: {each.text}" for each in notes),
        "",
        *_verdict(found),
        *(f"on condition: {each.text}" for each in found.conditions),
        *(f"warning: {each.where}: {each.text}" for each in told),
        *_missing(found),
    ]
    return _table(found, pairs) + "".join(map(_folded, lines)) + "".join(f"{line}\n" for line in _toml(found, results))


def _table(found: Verdict, pairs: list[tuple[MechanismVerdict, Answer]]) -> str:
    """The answers that decide, as wide as a line; names get what the numbers leave."""
    rows = [_cells(one, answer, found) for one, answer in pairs]
    taken = sum(max(len(row[place]) for row in (HEADER, *rows)) + 2 for place in range(len(HEADER)))
    room = max(LEAST, WIDE - taken)
    names = [on_one_line(escape_text(one.mechanism), room) for one, _ in pairs]
    return text_table(["mechanism", *HEADER], [[name, *row] for name, row in zip(names, rows, strict=True)])


def _cells(one: MechanismVerdict, answer: Answer, found: Verdict) -> tuple[str, ...]:
    holds = "" if one.margin is None else f"{figures(one.margin * found.action.pga_g)} g = {figures(one.margin)} x"
    outcome = answer.outcome if len(one.answers) > 1 else one.outcome
    said = _loud(outcome_text(outcome, near=answer.at_the_limit))
    return (said, answer.limit_state, answer.procedure, index_text(answer.index).replace(", grade", ""), holds)


def _loud(outcome: str) -> str:
    """An outcome with its failure in capitals."""
    return outcome.replace("fail", "FAIL")


def _reasons(found: Verdict) -> Iterator[str]:
    """Why mechanisms do not pass, each reason once with the mechanisms that it is of."""
    names: dict[str, dict[str, None]] = {}
    for one in found.mechanisms:
        for answer in one.answers:
            if answer.outcome != Decision.PASS:
                names.setdefault(answer.reason.text, {})[on_one_line(one.mechanism, 40)] = None
    yield from (f"{', '.join(of)}: {text}" for text, of in names.items())


def _verdict(found: Verdict) -> Iterator[str]:
    states = ", ".join(found.limit_states) or "no limit state"
    said = _loud(outcome_text(found.outcome, near=found.at_the_limit))
    yield f"verdict: {said}"
    yield f"basis: {found.edition or 'none'}; {states}; site's own action: {action_text(found.action)}"
    if index := building_index_text(found):
        yield f"index: {index}, target {target_text(found) or 'not known'}; local mechanisms only"


def _missing(found: Verdict) -> Iterator[str]:
    """What would complete the verdict, and what it would be with the safe values."""
    if found.outcome != Decision.INCOMPLETE:
        return
    yield from (f"missing: {each.key}: {each.text}" for each in found.missing)
    if found.provisional in (Decision.PASS, Decision.FAIL):
        yield f"{PROVISIONAL}{_loud(found.provisional.value)}"


def _toml(found: Verdict, results: Results) -> list[str]:
    """The block of TOML that completes the verdict."""
    given = [key for key, each in results.project.items() if each.given]
    lines = toml_lines(found.missing, given) if found.outcome == Decision.INCOMPLETE else ()
    return ["to complete it, add to the project file, with your own values:", *map(escape_text, lines)] if lines else []


def _folded(line: str) -> str:
    """A line of the text in as many lines of the terminal as it takes."""
    return "\n".join(wrap(escape_text(line), WIDE, subsequent_indent="  ") or [""]) + "\n"
