"""Differences of what a run was made from: site, project, files, warnings and program."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import zip_longest
from operator import attrgetter
from typing import Any

from assess.results.diff.change import Change
from assess.results.diff.pairs import of_both, pairs
from assess.results.run import Results


def site(before: Results, after: Results) -> Iterator[Change]:
    """Compare the spectrum."""
    sides: list[dict[str, float | str]] = []
    for results in (before, after):
        one = results.spectrum
        known = {} if one is None else {"code": one.code, "pga_g": one.pga_g, "damping": one.damping, **one.parameters}
        sides.append(known)
    for what, first, second in pairs(*sides):
        yield Change("site", "spectrum", what, first, second)


def project(before: Results, after: Results) -> Iterator[Change]:
    """Compare every value of the project as used, in SI; tables and lists of tables entry by entry.

    A default is no change where the other run has no such key: an older version did not write the keys added since.
    """
    for key, one, other in pairs(before.project, after.project):
        if (one is None or other is None) and not any(each.given for each in (one, other) if each is not None):
            continue
        for entry, first, second in entries(key, *of_both(attrgetter("value"), one, other)):
            yield Change("project", "", entry, first, second)


def entries(key: str, one: Any, other: Any) -> Iterator[tuple[str, Any, Any]]:
    """Yield two values entry by entry, with their keys, as long as both are tables or lists of tables."""
    if isinstance(one, Mapping) and isinstance(other, Mapping):
        for name, first, second in pairs(one, other):
            yield from entries(f"{key}.{name}", first, second)
    elif is_list_of_tables(one) and is_list_of_tables(other):
        for place, (first, second) in enumerate(zip_longest(one, other), start=1):  # as sweeps count
            yield from entries(f"{key}[{place}]", first, second)
    else:
        yield key, without_absent_keys(one), without_absent_keys(other)


def is_list_of_tables(value: Any) -> bool:
    """Return whether a value is a list of tables only."""
    return isinstance(value, list | tuple) and all(isinstance(each, Mapping) for each in value)


def without_absent_keys(value: Any) -> Any:
    """Return the value; a table without the keys whose value is None."""
    return {key: each for key, each in value.items() if each is not None} if isinstance(value, Mapping) else value


def inputs(before: Results, after: Results) -> Iterator[Change]:
    """Compare the files read, by their SHA-256."""
    sides = [{each.path: each.sha256 for each in results.inputs} for results in (before, after)]
    for path, one, other in pairs(*sides):
        yield Change("input", path, "sha256", one, other)


def warnings(before: Results, after: Results) -> Iterator[Change]:
    """List the warnings that only one run has; one of the same words under another key is the same."""
    sides = [{(each.where, each.text): each.key for each in results.warnings} for results in (before, after)]
    for (where, text), one, other in pairs(*sides):
        yield Change("warning", where, one or other or "", text if one else None, text if other else None)


def program(before: Results, after: Results) -> Iterator[Change]:
    """Compare the versions of the program."""
    yield Change("program", before.program.name, "version", before.program.version, after.program.version)
