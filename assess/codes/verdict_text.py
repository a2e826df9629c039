"""A verdict in words: what the command line and the report both print of it. All text is English, in SI."""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Sequence

from assess.codes.verdict import Action, Decision, Index, MechanismVerdict, Missing, Verdict
from assess.codes.verdict.question import SOURCES
from assess.messages.message import Message, Severity

AT_THE_LIMIT = " at the limit"
BEHIND = ("%NBS",)  # indices whose name stands behind their value
NAMED = ("materials", "mechanisms", "bodies")  # tables whose entries the user names
_BARE = re.compile(r"[A-Za-z0-9_-]+")


def outcome_text(outcome: Decision, *, near: bool) -> str:
    """The outcome, and whether it lies at the limit: "fail at the limit"."""
    return outcome.value + (AT_THE_LIMIT if near and outcome != Decision.INCOMPLETE else "")


def index_text(index: Index | None) -> str:
    """An index with its name and grade: "zeta_E 0.83", "45 %NBS, grade C"; empty where there is none."""
    if index is None:
        return ""
    value = figures(index.value)
    said = f"{value} {index.name}" if index.name in BEHIND else f"{index.name} {value}"
    return f"{said}, grade {index.grade}" if index.grade else said


def building_index_text(verdict: Verdict) -> str:
    """The index of the building, which local mechanisms alone can only bound; empty where none is known."""
    if verdict.index is None:
        return ""
    bound = "at least" if verdict.index.name == "D/C" else "at most"
    return f"{bound} {index_text(verdict.index)}"


def target_text(verdict: Verdict) -> str:
    """What the index is compared with; empty where that is not known."""
    return "" if verdict.target is None else f"{verdict.target:.3g}"


def figures(value: float) -> str:
    """A number to three figures, all of them written: 1.00 for one."""
    return f"{value:#.3g}".rstrip(".") if value else "0"


def action_text(action: Action) -> str:
    """The site's own action: PGA, limit state and return period as far as they are known."""
    known = [f"PGA {action.pga_g:.3g} g"]
    known += [f"stated for {action.limit_state}"] if action.limit_state else []
    known += ["each limit state by the hazard of the site"] if action.over_periods else []
    known += [f"return period {action.return_period_years:.0f} years"] if action.return_period_years else []
    return ", ".join(known)


def margin_text(one: MechanismVerdict, action: Action) -> str:
    """Up to which PGA a mechanism holds: "0.18 g = 2.7 x the site's"; empty where that is not known."""
    return "" if one.margin is None else f"{figures(one.margin * action.pga_g)} g = {figures(one.margin)} x the site's"


def relevant_warnings(warnings: Sequence[Message]) -> tuple[Message, ...]:
    """The warnings that bear on a verdict: all but notes."""
    return tuple(each for each in warnings if each.severity != Severity.NOTE)


def toml_lines(missing: Sequence[Missing], given: Collection[str]) -> tuple[str, ...]:
    """The missing keys as TOML to paste, table by table.

    given : keys that the project file gives, written with dots; a table that stands there already is marked
    """
    tables: dict[str, list[str]] = {}
    for each in missing:
        if each.toml:
            tables.setdefault(table_of(each.key), []).append(each.toml)
    lines: list[str] = []
    for table, keys in tables.items():
        lines += [heading(table) + _there(table, given), *(line for key in keys for line in key.splitlines())]
    return tuple(lines)


def table_of(key: str) -> str:
    """The table that a missing key stands in; for a line of the sources that is the key itself."""
    return key if key == SOURCES else key.rpartition(".")[0]


def _there(table: str, given: Collection[str]) -> str:
    """A remark to the heading of a table that the file has, or may have where only tables within it are known."""
    within = [key.removeprefix(f"{table}.") for key in given if key.startswith(f"{table}.")]
    own = bool(within) if table == SOURCES else any("." not in key for key in within)
    if own:
        return "  # in your file already: add below it"
    return "  # where this heading is in your file already, add below it" if within else ""


def heading(table: str) -> str:
    """The heading of a table of the project file, its own name quoted where TOML wants that."""
    first, _, name = table.partition(".")
    plain = first not in NAMED or _BARE.fullmatch(name)
    return f"[{table}]" if plain else f"[{first}.{json.dumps(name, ensure_ascii=False)}]"
