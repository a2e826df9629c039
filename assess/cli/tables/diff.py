"""The changes between two runs as tables for the terminal, as CSV and as JSON."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping, Sequence
from itertools import groupby
from typing import Any

from assess.cli.tables.text_table import on_one_line, text_table
from assess.messages.plural import count_noun
from assess.project.key_text import escape_text
from assess.results.diff import Change, Kind, is_number
from reports.render.csv import csv_lines

HEADINGS: Mapping[Kind, str] = {
    "verdict": "verdicts",
    "mechanism": "mechanisms",
    "capacity": "PGA [g]",
    "ratio": "demand over capacity",
    "envelope": "overturning envelopes",
    "history": "time histories",
    "parameter": "rocking parameters (SI)",
    "sweep": "parametric studies",
    "sensitivity": "sensitivity",
    "uncertainty": "uncertainty",
    "other": "other blocks of results.json that differ",
    "suite": "suite of records",
    "site": "site",
    "project": "project (SI)",
    "input": "files",
    "warning": "warnings",
    "program": "program",
}
WORDS = {
    "fail": "FAIL",
    "fail at the limit": "FAIL at the limit",
    "not-answered": "not answered",
    "not-applicable": "n/a",
}
"""Verdicts and outcomes, as `assess run` prints them."""
LONGEST, WIDEST = 40, 100  # characters of names and values, and of what they are of
AROUND = 12  # characters that are shown of what two long texts have in common
HASHED = re.compile("[0-9a-f]{64}")
HASH = 12  # characters of a SHA-256 that tell files apart
FIELDS = ("kind", "where", "what", "unit", "before", "after", "relative")


def changes_text(changes: Sequence[Change]) -> str:
    """Write a table for each kind of change and their number; one line where there are none."""
    if not changes:
        return "no differences\n"
    tables = (TEXTS.get(kind, _table)(kind, list(each)) for kind, each in groupby(changes, key=lambda each: each.kind))
    return "\n".join(tables) + f"\n{count_noun(len(changes), 'difference')}\n"


def csv_text(changes: Sequence[Change]) -> str:
    """Write all changes as one table at full precision, with lists and tables as JSON."""
    rows = (
        (one.kind, one.where, one.what, one.unit, _plain(one.before), _plain(one.after), one.relative)
        for one in changes
    )
    return csv_lines([FIELDS, *rows])


def json_text(changes: Sequence[Change]) -> str:
    """Write all changes as a list, with the values before and after as in results.json."""
    plain = [{field: getattr(change, field) for field in FIELDS} for change in changes]
    return json.dumps(plain, ensure_ascii=False, allow_nan=False, indent=1) + "\n"


def _table(kind: Kind, changes: Sequence[Change]) -> str:
    rows = [[on_one_line(change.where, LONGEST), change.what, *_both_sides(change), _by(change)] for change in changes]
    return text_table([HEADINGS[kind], "", "before", "after", "change"], rows, widest=WIDEST)


def _lines(kind: Kind, changes: Sequence[Change]) -> str:
    """Write texts that are too long for a table, each after the sign of its run."""
    lines = (
        f"{'+' if change.before is None else '-'} {escape_text(change.where)}: "
        f"{escape_text(change.after or change.before)}\n"
        for change in changes
    )
    return f"{HEADINGS[kind]}\n{''.join(lines)}"


def _names(kind: Kind, changes: Sequence[Change]) -> str:
    """Write names alone, for changes that have no two sides."""
    return f"{HEADINGS[kind]}: {', '.join(escape_text(change.after) for change in changes)}\n"


TEXTS: Mapping[Kind, Callable[[Kind, Sequence[Change]], str]] = {"warning": _lines, "other": _names}


def _both_sides(change: Change) -> tuple[str, str]:
    """Shorten both sides of a change; texts that differ only beyond the cut are shown around that place."""
    before, after = (_shown(end, change.kind) for end in (change.before, change.after))
    pairs = enumerate(zip(before, after, strict=False))
    parts = next((place for place, (one, other) in pairs if one != other), min(len(before), len(after)))
    if parts + AROUND > LONGEST and max(len(before), len(after)) > LONGEST:
        before, after = (f"…{end[parts - AROUND :]}" for end in (before, after))
    return on_one_line(before, LONGEST), on_one_line(after, LONGEST)


def _shown(value: Any, kind: Kind) -> str:
    if value is None:
        return "-"
    if kind == "verdict" and isinstance(value, str):
        return WORDS.get(value, str(value))
    if kind == "input" or (kind == "suite" and HASHED.fullmatch(str(value))):
        return str(value)[:HASH]
    return f"{value:.4g}" if is_number(value) else str(_plain(value))


def _by(change: Change) -> str:
    return "" if change.relative is None else f"{change.relative:+.2%}"


def _plain(value: Any) -> Any:
    """Return a value on one line: numbers and texts unchanged."""
    return value if value is None or isinstance(value, int | float | str) else json.dumps(value, ensure_ascii=False)
