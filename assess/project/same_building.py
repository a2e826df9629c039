"""Whether the state before the works is of the same building: every value of both projects that differs.

New ties are works. So may be any load that is gone, replaced or new, and as a load typed into one state alone would
raise the index without works, each is named in the condition of a pass, as a value that differs is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain
from pathlib import Path
from typing import Any

from assess.messages.message import (
    UNITS,
    Message,
    Quantity,
    Severity,
    Term,
    Value,
    list_values,
    message,
    warning,
    whole_number,
)
from assess.project.key_errors import value_text
from assess.results import Input, ResolvedValue
from assess.results.diff import TOLERANCE, same
from assess.results.provenance import file_sha256

Values = Mapping[str, ResolvedValue]
DIFFERS = "differs-before"
LOAD_GONE, LOAD_NEW, TIE_NEW = "load-gone", "load-new", "tie-new"
LOADS_THAT_DIFFER = {LOAD_GONE: "gone-there", LOAD_NEW: "new-here"}
"""Loads that one state alone has, with what the condition of a pass says of each."""
WORKS = {TIE_NEW: "new", LOAD_NEW: "new", LOAD_GONE: "gone"}
DRAWN_HERE = "only-here"
NAMED_BY_USERS = ("bodies", "materials", "mechanisms")
WHOLE = ("building", "site", "procedures", "records")
TABLES = (*NAMED_BY_USERS, *WHOLE, "verdict", "analysis")
BESIDE = ("verdict.procedures", "verdict.rule", "verdict.survey_tolerance", "analysis.equation")
"""Keys that an index depends on, of tables that are not compared as a whole."""
TIE = "tie"  # kind of the loads that are ties
WORDS = ("label", "examines")  # keys of a mechanism that change no number
SHOWN = 3  # differences that the condition of a pass names
DIGITS = 12  # of a SHA-256, as it is shown


def differences_since_before(
    before: Values, here: Values, *, inputs: Sequence[Input], folder: Path
) -> tuple[Message, ...]:
    """Return a warning for each value or load that differs, and a note for each new tie, and body that one state has.

    Parameters
    ----------
    before, here : the values of both projects
    inputs : files of the state before, with their SHA-256: a model is the same by that, and not by its name
    folder : of the project
    """
    digests = {each.path: each.sha256 for each in inputs}
    sides = (_by_digest(before, digests.get), _by_digest(here, lambda path: file_sha256(folder / path)))
    walls = set(chain.from_iterable(_walls(before, here)))
    values: list[Message] = []
    loads: list[Message] = []
    drawn: list[Message] = []
    tables = dict.fromkeys(_table(key) for key in chain(*sides) if _table(key))
    for table in sorted(tables, key=lambda table: TABLES.index(table.split(".")[0])):
        one, other = ({key: each for key, each in side.items() if _table(key) == table} for side in sides)
        if (one and other) or table in walls or table in TABLES:
            values += _value_differences(one, other)
            loads += _load_differences(f"{table}.loads", one, other)
        elif not table.startswith("mechanisms."):
            drawn.append(message("only-before" if one else DRAWN_HERE, where=table))
    return *values, *loads, *drawn


def works_shown(differences: Sequence[Message]) -> Iterator[str]:
    """Yield each load that one state alone has, with its kind and whether it is new or gone."""
    for each in differences:
        if each.key in WORKS:
            yield f"{each.where} ({each.values['kind']}) {WORKS[each.key]}"


def same_building_conditions(differences: Sequence[Message]) -> Iterator[Message]:
    """Yield the condition that the state before is of the same building, where values or loads of it differ.

    Every load is named; of the values the first.
    """
    shown: list[Value] = [
        message(LOADS_THAT_DIFFER[each.key], {**each.values, "key": each.where})
        for each in differences
        if each.key in LOADS_THAT_DIFFER
    ]
    found = [each for each in differences if each.key == DIFFERS]
    shown += [message("differs-there", {**each.values, "key": each.where}) for each in found[:SHOWN]]
    if len(found) > SHOWN:
        shown.append(message("differs-more", {"number": whole_number(len(found) - SHOWN)}))
    if shown:
        yield message("same-building", {"differences": list_values(*shown)}, severity=Severity.WARNING)


def _table(key: str) -> str:
    """Return the table that a key is in, by its name where users name it; empty where no index depends on it."""
    first, *rest = key.split(".")
    if first in NAMED_BY_USERS and rest:
        return f"{first}.{rest[0]}"
    return first if first in WHOLE or key in BESIDE else ""


def _walls(before: Values, here: Values) -> Iterator[Sequence[str]]:
    """Yield the tables of the bodies, with their materials, that move in the mechanisms of both states."""
    for key in (key for key in before if key.endswith(".blocks") and key in here):
        for values in (before, here):
            for body in chain.from_iterable(values[key].value or ()):
                material = values.get(f"bodies.{body}.material")
                yield f"bodies.{body}", "" if material is None else f"materials.{material.value}"


def _value_differences(before: Values, here: Values) -> Iterator[Message]:
    """Yield the values of a table that differ; a default that neither project states follows from the others."""
    for key in dict.fromkeys((*before, *here)):
        sides = (before.get(key), here.get(key))
        words = key.startswith("mechanisms.") and key.split(".")[2:] and key.split(".")[2] in (*WORDS, "loads")
        if words or not any(each.given for each in sides if each is not None):
            continue
        dimensions = next((each.dimensions for each in sides if each is not None and each.dimensions), {})
        for place, way, one, other in _entries(key, "", *(None if each is None else each.value for each in sides)):
            unit = dimensions.get(way, dimensions.get("", "ratio"))
            yield warning(DIFFERS, place, before=_shown(one, unit), here=_shown(other, unit))


def _entries(key: str, way: str, one: Any, other: Any) -> Iterator[tuple[str, str, Any, Any]]:
    """Yield what differs of two values, entry by entry: its key, the way to it from the first, and both."""
    if same(one, other, tolerance=TOLERANCE):
        return
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        for name in dict.fromkeys((*one, *other)):
            yield from _entries(f"{key}.{name}", f"{way}.{name}".strip("."), one.get(name), other.get(name))
    elif isinstance(one, list | tuple) and isinstance(other, list | tuple) and len(one) == len(other):
        for place, (first, second) in enumerate(zip(one, other, strict=True)):
            yield from _entries(f"{key}[{place + 1}]", f"{way}.{place}".strip("."), first, second)
    else:
        yield key, way, one, other


def _load_differences(key: str, before: Values, here: Values) -> Iterator[Message]:
    """Yield the loads and ties that one state alone has; of several alike each counts."""
    old, new = (list(() if key not in side else side[key].value or ()) for side in (before, here))
    left, added = list(range(len(old))), []
    for place, load in enumerate(new):
        kept = next((each for each in left if same(old[each], load, tolerance=TOLERANCE)), None)
        if kept is None:
            added.append(place)
        else:
            left.remove(kept)
    for place in left:
        yield warning(LOAD_GONE, f"{key}[{place + 1}]", kind=old[place]["kind"])
    for place in added:
        kind, where = new[place]["kind"], f"{key}[{place + 1}]"
        yield message(TIE_NEW, {"kind": kind}, where=where) if kind == TIE else warning(LOAD_NEW, where, kind=kind)


def _by_digest(values: Values, digest: Callable[[str], str | None]) -> Values:
    """Return values with the SHA-256 of each model in place of its name, where that is known."""
    found = {key: digest(str(each.value)) for key, each in values.items() if key.endswith(".mesh")}
    known = {key: replace(values[key], value=f"SHA-256 {sha[:DIGITS]}") for key, sha in found.items() if sha}
    return {**values, **known}


def _shown(value: Any, dimension: str) -> Value:
    if value is None:
        return Term("none")
    if isinstance(value, int | float) and not isinstance(value, bool):
        return Quantity(float(value), dimension if dimension in UNITS else "ratio")
    return value if isinstance(value, str) else value_text(value)
