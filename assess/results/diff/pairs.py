"""Values of two runs, paired by key."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, TypeVar

from assess.results.mechanism import MechanismResult
from assess.results.run import Results

K = TypeVar("K")
V = TypeVar("V")


def pairs(before: Mapping[K, V], after: Mapping[K, V]) -> Iterator[tuple[K, V | None, V | None]]:
    """Yield each key with its value in either run, None where absent; keys of the first run come first."""
    for key in dict.fromkeys((*before, *after)):
        yield key, before.get(key), after.get(key)


def of_both(of: Callable[[V], Any], one: V | None, other: V | None) -> tuple[Any, Any]:
    """Return `of(value)` for both sides, None for a side that is missing."""
    return (None if one is None else of(one), None if other is None else of(other))


def common_mechanisms(before: Results, after: Results) -> Iterator[tuple[MechanismResult, MechanismResult]]:
    """Yield the mechanisms that both runs have, as pairs."""
    for _, one, other in pairs(mechanisms_by_name(before), mechanisms_by_name(after)):
        if one is not None and other is not None:
            yield one, other


def mechanisms_by_name(results: Results) -> dict[str, MechanismResult]:
    """Return the mechanisms of a run by name."""
    return {mechanism.name: mechanism for mechanism in results.mechanisms}
