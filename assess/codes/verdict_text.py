"""A verdict in words, for the command line and the report. All text is English, in SI."""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Sequence

from assess.codes.verdict import Action, Decision, Index, Missing, Verdict
from assess.codes.verdict.question import SOURCES
from assess.messages.message import Message, Severity

AT_THE_LIMIT = " at the limit"
BEHIND = ("%NBS",)  # indices whose name stands behind their value
NAMED = ("materials", "mechanisms", "bodies")  # tables whose entries the user names
_BARE = re.compile(r"[A-Za-z0-9_-]+")


def outcome_text(outcome: Decision, *, near: bool) -> str:
    """Return the outcome in words: "fail", or "fail at the limit".

    Parameters
    ----------
    outcome : pass, fail or incomplete
    near : whether it is at the limit

    Returns
    -------
    str
    """
    return outcome.value + (AT_THE_LIMIT if near and outcome != Decision.INCOMPLETE else "")


def index_text(index: Index | None) -> str:
    """Return an index with its name and grade, as "zeta_E 0.83" or "45 %NBS, grade C"; empty where there is none."""
    if index is None:
        return ""
    value = figures(index.value, index.figures)
    said = f"{value} {index.name}" if index.name in BEHIND else f"{index.name} {value}"
    return f"{said}, grade {index.grade}" if index.grade else said


def building_index_text(verdict: Verdict) -> str:
    """Return the index of the building, which local mechanisms alone can only bound; empty where none is known."""
    if verdict.index is None:
        return ""
    bound = "at least" if verdict.index.name == "D/C" else "at most"
    return f"{bound} {index_text(verdict.index)}"


def target_text(verdict: Verdict) -> str:
    """Return the target that the index is compared with; empty where that is not known."""
    return "" if verdict.target is None else f"{verdict.target:.3g}"


def figures(value: float, number: int = 3) -> str:
    """Return a number to three figures, or as many as are asked for, with trailing zeros: 1.00 for one.

    Parameters
    ----------
    value : the number
    number : of figures
    """
    return f"{value:#.{number}g}".rstrip(".") if value else "0"


def action_text(action: Action) -> str:
    """Return the site's own action in words: PGA, limit state and return period as far as they are known."""
    known = [f"PGA {action.pga_g:.3g} g"]
    known += [f"stated for {action.limit_state}"] if action.limit_state else []
    known += ["each limit state by the hazard of the site"] if action.over_periods else []
    known += [f"return period {action.return_period_years:.0f} years"] if action.return_period_years else []
    return ", ".join(known)


def relevant_warnings(warnings: Sequence[Message]) -> tuple[Message, ...]:
    """Return the messages that bear on a verdict: all but notes."""
    return tuple(each for each in warnings if each.severity != Severity.NOTE)


def toml_lines(missing: Sequence[Missing], given: Collection[str]) -> tuple[str, ...]:
    """Return the missing keys as TOML to paste, table by table.

    Parameters
    ----------
    missing : the missing inputs
    given : keys that the project file gives, written with dots; a table that is already there is marked

    Returns
    -------
    tuple of str
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
    """Return the table that a missing key belongs to; for a line of the sources that is the key itself."""
    return key if key == SOURCES else key.rpartition(".")[0]


def _there(table: str, given: Collection[str]) -> str:
    """Return a remark for the heading of a table that the file has, or may have."""
    within = [key.removeprefix(f"{table}.") for key in given if key.startswith(f"{table}.")]
    own = bool(within) if table == SOURCES else any("." not in key for key in within)
    if own:
        return "  # in your file already: add below it"
    return "  # where this heading is in your file already, add below it" if within else ""


def heading(table: str) -> str:
    """Return the heading of a table of the project file, a name given by the user quoted where TOML needs it."""
    first, _, name = table.partition(".")
    plain = first not in NAMED or _BARE.fullmatch(name)
    return f"[{table}]" if plain else f"[{first}.{json.dumps(name, ensure_ascii=False)}]"
