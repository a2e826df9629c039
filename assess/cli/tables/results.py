"""Runs beside each other: the mechanisms of several as one table, and the changes between two."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, fields, replace
from itertools import groupby
from typing import Any

from assess.cli.tables import on_one_line, text_table
from assess.codes.verdict import Answer, Decision, MechanismVerdict
from assess.messages.message import count_noun, escape_text
from assess.results import MechanismResult, OscillatorResult, Results
from assess.results.diff import Difference, DifferenceKind
from reports.render.table_text import csv_lines
from spectra.arrays import is_number

SEVERITY = (Decision.PASS, Decision.INCOMPLETE, Decision.FAIL)
NO_VERDICT = "no verdict"
NO_ROCKING = "0 (no rocking)"
HEADER = ("run", "mechanism", "kind", "verdict", "state", "decided by", "D/C", "index")
NUMBERS = ("holds up to [g]", "p [1/s]", "lambda [-]", "missing")
HEADINGS: Mapping[DifferenceKind, str] = {
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
SHA256 = re.compile("[0-9a-f]{64}")
SHA256_SHOWN = 12  # characters of a SHA-256 that tell files apart
FIELDS = ("kind", "where", "what", "unit", "before", "after", "relative")


@dataclass(frozen=True)
class MechanismRow:
    """One mechanism of a run; empty or None where it is not known.

    ratio : demand over capacity of the answer that decides; index : the code's measure of it, with its name
    capacity_pga_g : PGA up to which the mechanism holds [g]; missing : keys of the project file that would complete it
    """

    run: str
    mechanism: str
    kind: str
    verdict: str
    limit_state: str = ""
    procedure: str = ""
    ratio: float | None = None
    index: str = ""
    index_value: float | None = None
    capacity_pga_g: float | None = None
    p_per_s: float | None = None
    uplift_multiplier: float | None = None
    missing: tuple[str, ...] = ()


def mechanism_rows(run: str, results: Results) -> Iterator[MechanismRow]:
    """Yield a row for each mechanism of a run."""
    found = results.verdict
    verdicts = {} if found is None else {one.mechanism: one for one in found.mechanisms}
    pga_g = None if found is None else found.action.pga_g
    yield from (_mechanism_row(run, one, verdicts.get(one.name), pga_g) for one in results.mechanisms)


def mechanisms_table(rows: Sequence[MechanismRow]) -> str:
    """Write the rows rounded; one line where no run has a mechanism."""
    return text_table((*HEADER, *NUMBERS), [_mechanism_cells(row) for row in rows]) if rows else "no mechanisms\n"


def mechanisms_csv(rows: Sequence[MechanismRow]) -> str:
    """Write the rows at full precision, under their names in JSON, with the missing keys between semicolons."""
    names = [field.name for field in fields(MechanismRow)]
    lines = ([*(getattr(row, name) for name in names[:-1]), "; ".join(row.missing)] for row in rows)
    return csv_lines([names, *lines])


def mechanisms_json(rows: Sequence[MechanismRow]) -> str:
    """Write the rows as a list."""
    return json.dumps([asdict(row) for row in rows], ensure_ascii=False, allow_nan=False, indent=1) + "\n"


def changes_text(changes: Sequence[Difference]) -> str:
    """Write a table for each kind of change and their number; one line where there are none."""
    if not changes:
        return "no differences\n"
    tables = (
        TEXTS.get(kind, _changes_table)(kind, list(each)) for kind, each in groupby(changes, key=lambda each: each.kind)
    )
    return "\n".join(tables) + f"\n{count_noun(len(changes), 'difference')}\n"


def changes_csv(changes: Sequence[Difference]) -> str:
    """Write all changes as one table at full precision, with lists and tables as JSON."""
    rows = (
        (one.kind, one.where, one.what, one.unit, _plain(one.before), _plain(one.after), one.relative)
        for one in changes
    )
    return csv_lines([FIELDS, *rows])


def changes_json(changes: Sequence[Difference]) -> str:
    """Write all changes as a list, with the values before and after as in results.json."""
    plain = [{field: getattr(change, field) for field in FIELDS} for change in changes]
    return json.dumps(plain, ensure_ascii=False, allow_nan=False, indent=1) + "\n"


def _mechanism_row(
    run: str, mechanism: MechanismResult, verdict: MechanismVerdict | None, pga_g: float | None
) -> MechanismRow:
    side = _first_to_rock(mechanism)
    own = MechanismRow(
        run,
        mechanism.name,
        mechanism.kind,
        NO_VERDICT,
        p_per_s=side.p_eq_per_s,
        uplift_multiplier=side.uplift_multiplier,
    )
    if verdict is None:
        return own
    answer = max(verdict.answers, key=_weight, default=None)
    index = None if answer is None else answer.index
    return replace(
        own,
        verdict=verdict.outcome.value,
        limit_state="" if answer is None else answer.limit_state,
        procedure="" if answer is None else answer.procedure,
        ratio=None if answer is None else answer.ratio,
        index="" if index is None else index.name,
        index_value=None if index is None else index.value,
        capacity_pga_g=None if verdict.margin is None or pga_g is None else verdict.margin * pga_g,
        missing=tuple(each.key for each in verdict.missing),
    )


def _weight(answer: Answer) -> tuple[int, float]:
    return SEVERITY.index(answer.outcome), -math.inf if answer.ratio is None else answer.ratio


def _first_to_rock(mechanism: MechanismResult) -> OscillatorResult:
    """Return the side whose multiplier at rest is the least."""
    sides = [side for side in (mechanism.oscillator, mechanism.oscillator_negative) if side is not None]
    return min(sides, key=lambda side: math.inf if side.uplift_multiplier is None else side.uplift_multiplier)


def _mechanism_cells(row: MechanismRow) -> list[str]:
    texts = [row.run, row.mechanism, row.kind, row.verdict.replace("fail", "FAIL"), row.limit_state, row.procedure]
    numbers = (row.capacity_pga_g, row.p_per_s, row.uplift_multiplier)
    measure = f"{row.index} {_number(row.index_value)}".strip()
    ratio = NO_ROCKING if row.ratio == 0.0 else _number(row.ratio)
    shown = [ratio, measure, *map(_number, numbers), ", ".join(row.missing)]
    return [*map(escape_text, texts), *map(escape_text, shown)]


def _number(value: float | None) -> str:
    return "" if value is None else f"{value:.3g}"


def _changes_table(kind: DifferenceKind, changes: Sequence[Difference]) -> str:
    rows = [
        [
            on_one_line(change.where, LONGEST),
            change.what,
            *_both_sides(change),
            "" if change.relative is None else f"{change.relative:+.2%}",
        ]
        for change in changes
    ]
    return text_table([HEADINGS[kind], "", "before", "after", "change"], rows, widest=WIDEST)


def _lines(kind: DifferenceKind, changes: Sequence[Difference]) -> str:
    """Write texts that are too long for a table, each after the sign of its run."""
    lines = (
        f"{'+' if change.before is None else '-'} {escape_text(change.where)}: "
        f"{escape_text(change.after or change.before)}\n"
        for change in changes
    )
    return f"{HEADINGS[kind]}\n{''.join(lines)}"


def _names(kind: DifferenceKind, changes: Sequence[Difference]) -> str:
    """Write names alone, for changes that have no two sides."""
    return f"{HEADINGS[kind]}: {', '.join(escape_text(change.after) for change in changes)}\n"


TEXTS: Mapping[DifferenceKind, Callable[[DifferenceKind, Sequence[Difference]], str]] = {
    "warning": _lines,
    "other": _names,
}


def _both_sides(change: Difference) -> tuple[str, str]:
    """Shorten both sides of a change; texts that differ only beyond the cut are shown around that place."""
    before, after = (_shown(end, change.kind) for end in (change.before, change.after))
    pairs = enumerate(zip(before, after, strict=False))
    parts = next((place for place, (one, other) in pairs if one != other), min(len(before), len(after)))
    if parts + AROUND > LONGEST and max(len(before), len(after)) > LONGEST:
        before, after = (f"…{end[parts - AROUND :]}" for end in (before, after))
    return on_one_line(before, LONGEST), on_one_line(after, LONGEST)


def _shown(value: Any, kind: DifferenceKind) -> str:
    if value is None:
        return "-"
    if kind == "verdict" and isinstance(value, str):
        return WORDS.get(value, str(value))
    if kind == "input" or (kind == "suite" and SHA256.fullmatch(str(value))):
        return str(value)[:SHA256_SHOWN]
    return f"{value:.4g}" if is_number(value) else str(_plain(value))


def _plain(value: Any) -> Any:
    """Return a value on one line: numbers and texts unchanged."""
    return value if value is None or isinstance(value, int | float | str) else json.dumps(value, ensure_ascii=False)
