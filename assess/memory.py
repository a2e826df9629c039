"""What has been found of frozen objects, kept with them: studies build and run much again for each value they vary."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Sequence
from typing import Any, TypeVar

T = TypeVar("T")
_KEPT = "_found_of_it"
MOST = 1_000
"""Answers that are kept with an object, enough for the levels of some scans."""


def remember(objects: Sequence[object], asked: tuple[Hashable, ...], find: Callable[[], T], *, most: int = MOST) -> T:
    """Return what has been found of objects, found once as long as the first of them lives, and among the last.

    A copy, by `dataclasses.replace` for one, begins without it.

    Parameters
    ----------
    objects : at least one, frozen; they are known by identity
    asked : what is asked of them
    find : finds it
    most : answers that are kept; of a sample of a thousand cracks the last few
    """
    kept: dict[tuple[Hashable, ...], tuple[Sequence[object], Any]] = vars(objects[0]).setdefault(_KEPT, {})
    key = (*asked, *map(id, objects))
    found = kept.get(key)
    if found is None or any(one is not other for one, other in zip(found[0], objects, strict=True)):
        found = tuple(objects), find()
        for oldest in tuple(kept)[: max(0, len(kept) + 1 - most)]:
            kept.pop(oldest, None)
        kept[key] = found
    answer: T = found[1]
    return answer
