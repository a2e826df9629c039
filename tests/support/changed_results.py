"""Results of tests with something else in their verdict, their mechanisms or their project."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from assess.results import ResolvedValue, Results


def with_verdict(results: Results, **changes: Any) -> Results:
    """Return the results with these fields of their verdict."""
    assert results.verdict is not None
    return replace(results, verdict=replace(results.verdict, **changes))


def with_mechanisms(results: Results, **changes: Any) -> Results:
    """Return the results with these fields of every mechanism."""
    return replace(results, mechanisms=tuple(replace(each, **changes) for each in results.mechanisms))


def with_project(results: Results, *, instead: bool = False, **values: ResolvedValue) -> Results:
    """Return the results with these values of the project, beside or `instead` of its own; `__` is a dot of a key."""
    project = {key.replace("__", "."): value for key, value in values.items()}
    return replace(results, project=project if instead else {**results.project, **project})
