"""Mechanisms of several runs as one table: for the terminal, as CSV and as JSON."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass, fields, replace

from assess.cli.tables.text_table import text_table
from assess.codes.verdict import Answer, Decision, MechanismVerdict
from assess.project.key_text import escape_text
from assess.results import MechanismResult, OscillatorResult, Results
from reports.render.csv import csv_lines

SEVERITY = (Decision.PASS, Decision.INCOMPLETE, Decision.FAIL)
NO_VERDICT = "no verdict"
NO_ROCKING = "0 (no rocking)"
HEADER = ("run", "mechanism", "kind", "verdict", "state", "decided by", "D/C", "index")
NUMBERS = ("holds up to [g]", "p [1/s]", "lambda [-]", "missing")


@dataclass(frozen=True)
class Row:
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


def rows_of(run: str, results: Results) -> Iterator[Row]:
    """Yield a row for each mechanism of a run."""
    found = results.verdict
    verdicts = {} if found is None else {one.mechanism: one for one in found.mechanisms}
    pga_g = None if found is None else found.action.pga_g
    yield from (_row(run, one, verdicts.get(one.name), pga_g) for one in results.mechanisms)


def _row(run: str, mechanism: MechanismResult, verdict: MechanismVerdict | None, pga_g: float | None) -> Row:
    side = _first_to_rock(mechanism)
    own = Row(
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


def table_text(rows: Sequence[Row]) -> str:
    """Write the rows rounded; one line where no run has a mechanism."""
    return text_table((*HEADER, *NUMBERS), [_cells(row) for row in rows]) if rows else "no mechanisms\n"


def _cells(row: Row) -> list[str]:
    texts = [row.run, row.mechanism, row.kind, row.verdict.replace("fail", "FAIL"), row.limit_state, row.procedure]
    numbers = (row.capacity_pga_g, row.p_per_s, row.uplift_multiplier)
    measure = f"{row.index} {_number(row.index_value)}".strip()
    ratio = NO_ROCKING if row.ratio == 0.0 else _number(row.ratio)
    shown = [ratio, measure, *map(_number, numbers), ", ".join(row.missing)]
    return [*map(escape_text, texts), *map(escape_text, shown)]


def _number(value: float | None) -> str:
    return "" if value is None else f"{value:.3g}"


def csv_text(rows: Sequence[Row]) -> str:
    """Write the rows at full precision, under their names in JSON, with the missing keys between semicolons."""
    names = [field.name for field in fields(Row)]
    lines = ([*(getattr(row, name) for name in names[:-1]), "; ".join(row.missing)] for row in rows)
    return csv_lines([names, *lines])


def json_text(rows: Sequence[Row]) -> str:
    """Write the rows as a list."""
    return json.dumps([asdict(row) for row in rows], ensure_ascii=False, allow_nan=False, indent=1) + "\n"
