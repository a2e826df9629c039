"""Blocks of results.json that are not compared in detail."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import asdict, fields, is_dataclass
from typing import Any

from assess.results.diff.change import Change, same
from assess.results.diff.pairs import common_mechanisms
from assess.results.run import Results

ELSEWHERE = {"schema_version", "program", "inputs", "warnings", "project", "mechanisms", "stamp"}


def others(before: Results, after: Results, *, tolerance: float) -> Iterator[Change]:
    """Yield one change that names the blocks of results.json not compared in detail that differ, if any do."""
    blocks = different_blocks(before, after, tolerance=tolerance)
    for one, other in common_mechanisms(before, after):
        blocks += [f"{name} of {one.name}" for name in different_blocks(one, other, tolerance=tolerance)]
    if blocks:
        yield Change("other", "", "blocks that differ", None, ", ".join(blocks))


def different_blocks(one: Any, other: Any, *, tolerance: float) -> list[str]:
    """Return the names of the fields that differ, except those compared elsewhere."""
    columns = ((each.name, getattr(one, each.name), getattr(other, each.name)) for each in fields(one))
    return [
        name
        for name, *ends in columns
        if name not in ELSEWHERE and ends[0] != ends[1] and not same(*map(plain, ends), tolerance=tolerance)
    ]


def plain(value: Any) -> Any:
    """Return the value with dicts in place of dataclasses."""
    if is_dataclass(value) and not isinstance(value, type):
        return asdict(value)
    return [plain(each) for each in value] if isinstance(value, list | tuple) else value
