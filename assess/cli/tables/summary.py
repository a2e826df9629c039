"""What `assess run` prints: the deciding answer for each mechanism, and the verdict with its conditions."""

from __future__ import annotations

from collections.abc import Iterator
from textwrap import wrap

from assess.cli.tables.text_table import on_one_line, text_table
from assess.cli.tables.uncertainty import uncertainty_lines
from assess.codes.standing_figures import interval_figures
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
from assess.results import ReportMatter, Results

CODES = {Decision.PASS: 0, Decision.FAIL: 1, Decision.INCOMPLETE: 3}
"""Exit codes of `assess run`."""
PROVISIONAL = "with all of this given, and with safe values where they exist, the verdict would be: "
HEADER = ("verdict", "state", "decided by", "index", "holds up to")
WIDE, LEAST = 100, 16  # characters of a line, and of the name of a mechanism


def exit_code(results: Results) -> int:
    """Return the exit code of a run; a run without a verdict counts as incomplete."""
    return CODES[Decision.INCOMPLETE if results.verdict is None else results.verdict.outcome]


def summary(results: Results) -> str:
    """Write a line for each mechanism and limit state, why they do not pass, and the verdict with its conditions."""
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
        *_verdict(found, results.report),
        *(f"condition: {each.text}" for each in found.conditions),
        *(f"warning: {each.where}: {each.text}" for each in told),
        *dict.fromkeys(_remarks(results)),
        *uncertainty_lines(results.uncertainty),
        *_missing(found),
    ]
    return _table(found, pairs) + "".join(map(_wrap, lines)) + "".join(f"{line}\n" for line in _toml(found, results))


def _remarks(results: Results) -> Iterator[str]:
    """Yield what is remarked on the checks that decide, such as a failure at a lower level than the site's."""
    for one in results.mechanisms:
        for check in one.checks:
            if check.role == "deciding":
                yield from (f"warning: mechanisms.{one.name}: {each.text}" for each in check.remarks)


def _table(found: Verdict, pairs: list[tuple[MechanismVerdict, Answer]]) -> str:
    """Write the deciding answers within the line width; names get the width that the numbers leave."""
    rows = [_cells(one, answer, found) for one, answer in pairs]
    taken = sum(max(len(row[place]) for row in (HEADER, *rows)) + 2 for place in range(len(HEADER)))
    room = max(LEAST, WIDE - taken)
    names = [on_one_line(escape_text(one.mechanism), room) for one, _ in pairs]
    return text_table(["mechanism", *HEADER], [[name, *row] for name, row in zip(names, rows, strict=True)])


def _cells(one: MechanismVerdict, answer: Answer, found: Verdict) -> tuple[str, ...]:
    holds = "" if one.margin is None else _holds(one.margin, one.margin_most, found.action.pga_g)
    outcome = answer.outcome if len(one.answers) > 1 else one.outcome
    said = _emphasise(outcome_text(outcome, near=answer.at_the_limit))
    return (said, answer.limit_state, answer.procedure, index_text(answer.index).replace(", grade", ""), holds)


def _holds(margin: float, most: float | None, pga_g: float) -> str:
    """Write up to which PGA a mechanism holds: of histories whose numerical spread leaves a range, both ends."""
    if most is None:
        return f"{figures(margin * pga_g)} g = {figures(margin)} x"
    shown = interval_figures(margin * pga_g, most * pga_g)
    return f"{figures(margin * pga_g, shown)} to {figures(most * pga_g, shown)} g"


def _emphasise(outcome: str) -> str:
    """Return an outcome with its failure in capitals."""
    return outcome.replace("fail", "FAIL")


def _reasons(found: Verdict) -> Iterator[str]:
    """Yield why mechanisms do not pass, each reason once with its mechanisms."""
    names: dict[str, dict[str, None]] = {}
    for one in found.mechanisms:
        for answer in one.answers:
            if answer.outcome != Decision.PASS:
                names.setdefault(answer.reason.text, {})[on_one_line(one.mechanism, 40)] = None
    yield from (f"{', '.join(of)}: {text}" for text, of in names.items())


def _verdict(found: Verdict, report: ReportMatter) -> Iterator[str]:
    states = ", ".join(found.limit_states) or "no limit state"
    said = _emphasise(outcome_text(found.outcome, near=found.at_the_limit))
    yield f"verdict: {said}"
    yield f"basis: {found.edition or 'none'}; {states}; site's own action: {action_text(found.action)}"
    if index := building_index_text(found):
        yield f"index: {index}, target {target_text(found) or 'not known'}; local mechanisms only{_unexamined(report)}"


def _unexamined(report: ReportMatter) -> str:
    """Say what else bounds the index: how many mechanisms the building can have that were not examined."""
    if not report.building_type:
        return "; possible mechanisms not listed (report.building_type)"
    number = len(report.not_examined)
    return f"; {number} possible mechanism{'' if number == 1 else 's'} not examined" if number else ""


def _missing(found: Verdict) -> Iterator[str]:
    """Yield what would complete the verdict, and the verdict that the safe values would give."""
    if found.outcome != Decision.INCOMPLETE:
        return
    yield from (f"missing: {each.key}: {each.text}" for each in found.missing)
    if found.provisional in (Decision.PASS, Decision.FAIL):
        yield f"{PROVISIONAL}{_emphasise(found.provisional.value)}"


def _toml(found: Verdict, results: Results) -> list[str]:
    """Return the TOML lines that complete the verdict."""
    given = [key for key, each in results.project.items() if each.given]
    lines = toml_lines(found.missing, given) if found.outcome == Decision.INCOMPLETE else ()
    return (
        ["to complete it, add the following to the project file with your own values:", *map(escape_text, lines)]
        if lines
        else []
    )


def _wrap(line: str) -> str:
    """Wrap a line to the width of the terminal."""
    return "\n".join(wrap(escape_text(line), WIDE, subsequent_indent="  ") or [""]) + "\n"
