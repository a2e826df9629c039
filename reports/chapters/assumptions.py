"""The assumptions: each value with its source, measured, taken from literature, assumed, or a default."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from assess.messages.plural import count_noun
from assess.results import Resolved, Results
from reports.chapters import check_tables
from reports.document import Block, Cell, Column, Section, Table, Text, nonempty
from reports.language.lettering import truncate
from reports.language.numerals import entries

SOURCES = "report.sources."
LEFT_OUT = ("format", "title", "engineer", "checker", "reference", "client", "date", "notes", "report", "bodies")
OWN = (
    "kind",
    "blocks",
    "label",
    "cut",
    "hinges",
    "hinges_negative",
)  # the definition of a mechanism, not an assumption
ASKED = ("analysis.levels", "analysis.procedures", "analysis.pulses", "analysis.sweep", "analysis.sensitivity")
NOT_SAID = "given"
SHORT, MANY = 24, 4  # characters of a name and names in a list


@dataclass
class _Row:
    """One value and the names it holds for."""

    key: str
    value: Cell
    source: str
    note: str
    names: list[str] = field(default_factory=list)


def section(results: Results) -> Section:
    """Return the chapter: the values with their sources, the rules of the basis, and the procedures."""
    introduction = (
        "Each value is measured, taken from literature or assumed, as the project file states under "
        "report.sources; given, without a source; or a default of the program. A key with * applies to "
        "the mechanisms that are named. All other values of the project file are listed in the annex."
    )
    blocks: tuple[Block, ...] = (Text((introduction,)), table(results))
    procedures = check_tables.procedures(results)
    return Section("Assumptions", 0, (*blocks, *nonempty(rules(results)), *nonempty(procedures)))


def rules(results: Results) -> Table:
    """Return the rules of the deciding basis, with their clauses, as a table."""
    columns = (Column("Rule"), Column("Clause"))
    rows = () if results.verdict is None else results.verdict.clauses
    return Table("basis-rules", "The rules of the basis, and the clauses they come from.", columns, rows)


def table(results: Results) -> Table:
    """Tabulate every value that a result rests on; values shared by several mechanisms have one line."""
    columns = (
        Column("Key", kind="given"),
        Column("Value (SI)", kind="given"),
        Column("Source"),
        Column("Remark"),
        Column("For"),
    )
    every = len(results.mechanisms)
    rows = list(_rows(results))
    cells = tuple((row.key, row.value, row.source, row.note, _held(row.names, every)) for row in rows)
    muted = frozenset(place for place, row in enumerate(rows) if row.source == "default")
    return Table("assumed", "Assumptions and the sources of values; defaults are grey.", columns, cells, muted)


def _rows(results: Results) -> Iterator[_Row]:
    sources = {key[len(SOURCES) :]: str(each.value) for key, each in results.project.items() if key.startswith(SOURCES)}
    found: dict[tuple[str, str, str, str], _Row] = {}
    for key, value in results.project.items():
        written, name = _without_name(key)
        if value.value in (None, [], {}, "") or _left_out(written):
            continue
        source, note = _source(key, value, sources)
        for entry, cell in entries(written, value.value):
            row = _Row(entry, cell, source, note)
            found.setdefault((entry, str(cell), source, note), row).names += [name] if name else []
    yield from found.values()


def _without_name(key: str) -> tuple[str, str]:
    """Return a key of a mechanism with * for its name, and the name."""
    table, _, rest = key.partition(".")
    name, _, last = rest.partition(".")
    return (f"mechanisms.*.{last}", name) if table == "mechanisms" and last else (key, "")


def _left_out(key: str) -> bool:
    first, _, rest = key.partition(".")
    if key.startswith(ASKED):
        return True
    return first in LEFT_OUT or (first == "mechanisms" and rest.partition(".")[2].partition(".")[0] in OWN)


def _source(key: str, value: Resolved, sources: dict[str, str]) -> tuple[str, str]:
    """Return the kind of source and its words, of the longest key of the sources that `key` begins with."""
    known = [start for start in sources if key == start or key.startswith(f"{start}.")]
    if known:
        kind, _, words = sources[max(known, key=len)].partition(":")
        return kind.strip(), words.strip()
    return (NOT_SAID if value.given else "default"), ""


def _held(names: list[str], every: int) -> str:
    """Return the names that a value applies to, as a cell."""
    if not names:
        return ""
    if len(names) == every:
        return "every mechanism" if every > 1 else truncate(names[0], SHORT)
    short, more = [truncate(name, SHORT) for name in names[:MANY]], len(names) - MANY
    return ", ".join(short) + (f" and {count_noun(more, 'other')}" if more > 0 else "")
