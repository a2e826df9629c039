"""What `assess run` prints: the verdict of each mechanism and of the building, its conditions, and what is missing."""

from __future__ import annotations

from assess.cli.description import warned
from assess.cli.text_table import text_table
from assess.codes.verdict import Answer, Decision, MechanismVerdict, Verdict
from assess.project.messages import printable
from assess.results import Results

CODES = {Decision.PASS: 0, Decision.FAIL: 1, Decision.INCOMPLETE: 3}
"""Exit codes of `assess run`."""
_WORDS = {Decision.PASS: "pass", Decision.FAIL: "FAIL", Decision.INCOMPLETE: "incomplete"}
_ABOUT = {"D/C": 1.0, "zeta_E": 1.0, "%NBS": 100.0}


def exit_code(results: Results) -> int:
    """The exit code of a run: incomplete where no verdict was asked."""
    return CODES[Decision.INCOMPLETE if results.verdict is None else results.verdict.outcome]


def summary(results: Results) -> str:
    """A line for each mechanism, the warnings, and the verdict with what it rests on and what is missing."""
    found = results.verdict
    if found is None:
        return f"{warned(results.warnings)}no verdict\n"
    rows = [row for one in found.mechanisms for row in _rows(one, found)]
    table = text_table(["mechanism", "verdict", "limit state", "decided by", "index", "holds up to", "why"], rows)
    return table + warned(results.warnings) + "".join(f"{line}\n" for line in _closing(found))


def _rows(one: MechanismVerdict, found: Verdict) -> list[list[str]]:
    holds = "" if one.margin is None else f"{one.margin * found.action.pga_g:.3g} g = {one.margin:.3g} x"
    first, *others = one.answers or (None,)
    rows = [[printable(one.mechanism), _word(one.outcome, near=one.at_the_limit), *_cells(first), holds, _why(first)]]
    return rows + [["", _word(each.outcome, near=each.at_the_limit), *_cells(each), "", _why(each)] for each in others]


def _word(outcome: Decision, *, near: bool) -> str:
    return _WORDS[outcome] + (" at the limit" if near and outcome != Decision.INCOMPLETE else "")


def _cells(answer: Answer | None) -> list[str]:
    if answer is None:
        return ["", "", ""]
    index = answer.index
    value = "" if index is None else f"{index.name} {index.value * _ABOUT[index.name]:.3g} {index.grade}".strip()
    return [answer.limit_state, answer.procedure, value]


def _why(answer: Answer | None) -> str:
    return "" if answer is None else printable(answer.reason.text)


def _closing(found: Verdict) -> list[str]:
    action = found.action
    state = ", ".join(found.limit_states) or "no limit state"
    lines = [f"basis: {found.edition or 'none'}; {state}; site's own PGA {action.pga_g:.3g} g"]
    lines += [f"on condition: {each.text}" for each in found.conditions]
    near = " at the limit" if found.at_the_limit and found.outcome != Decision.INCOMPLETE else ""
    lines.append(f"verdict: {_WORDS[found.outcome]}{near}")
    return lines + _missing(found)


def _missing(found: Verdict) -> list[str]:
    """What would complete the verdict: why, and a block of TOML to paste."""
    if found.outcome != Decision.INCOMPLETE or not found.missing:
        return []
    lines = [f"missing: {each.key}: {printable(each.text)}" for each in found.missing]
    if found.provisional is not None:
        lines.append(f"with the safe values the verdict would be: {_WORDS[found.provisional]}")
    return [*lines, "to complete it, add to the project file:", *toml_block(found)]


def toml_block(found: Verdict) -> list[str]:
    """The missing keys as TOML, by table."""
    tables: dict[str, list[str]] = {}
    for each in found.missing:
        if each.toml:
            tables.setdefault(each.key.rpartition(".")[0], []).append(each.toml)
    return [line for table, keys in tables.items() for line in (f"[{table}]", *keys)]
