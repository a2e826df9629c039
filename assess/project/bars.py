"""Ties that several mechanisms state: one bar by its ends, which is varied, changed and paid once."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import Any, NamedTuple

from assess.loads.load import TieLoad, share_ends
from assess.project.key_errors import KeyPath
from assess.project.sections.content import Content


class StatedTie(NamedTuple):
    """A tie as a mechanism states it, with its place among the loads there, from 0."""

    mechanism: str
    place: int
    load: TieLoad

    @property
    def path(self) -> KeyPath:
        """Its key."""
        return ("mechanisms", self.mechanism, "loads", self.place)


Bar = tuple[StatedTie, ...]
"""A tie with all that state it, no mechanism twice."""


def bars_of(content: Content, names: Collection[str] | None = None) -> list[Bar]:
    """Return every bar, the mechanism that states it first at its head.

    Parameters
    ----------
    content : of the project
    names : of mechanisms of which one states it, which then come before others; None for all
    """
    found: list[Bar] = []
    first = list(content.mechanisms) if names is None else [name for name in content.mechanisms if name in names]
    for name in (*first, *(other for other in content.mechanisms if other not in first)):
        for tie in _ties_of(content, name):
            place = next((number for number, bar in enumerate(found) if _is_of(tie, bar)), None)
            if place is not None:
                found[place] = (*found[place], tie)
            elif name in first:
                found.append((tie,))
    return found


def with_bars(setting: Mapping[KeyPath, Any], content: Content) -> dict[KeyPath, Any]:
    """Return values by their keys, those of a tie also in the other mechanisms that state the same bar.

    Parameters
    ----------
    setting : values by their keys; what it sets itself stays
    content : of the project
    """
    followed = {path: value for own, value in setting.items() for path in same_bar(own, content)}
    return {**setting, **{path: value for path, value in followed.items() if path not in setting}}


def same_bar(path: KeyPath, content: Content) -> tuple[KeyPath, ...]:
    """Return where other mechanisms state the same of the same bar; nothing for a key that is of no tie.

    Parameters
    ----------
    path : of a key of a tie, or of the tie
    content : of the project
    """
    if path[0] != "mechanisms" or len(path) < 4 or path[2] != "loads":
        return ()
    bar = next((bar for bar in bars_of(content, (str(path[1]),)) if any(each.path == path[:4] for each in bar)), ())
    return tuple((*each.path, *path[4:]) for each in bar if each.path != path[:4])


def _is_of(tie: StatedTie, bar: Bar) -> bool:
    in_space = len(tie.load.at) == 3 and all(each.mechanism != tie.mechanism for each in bar)
    return in_space and share_ends(tie.load, bar[0].load)


def _ties_of(content: Content, name: str) -> Iterator[StatedTie]:
    for place, load in enumerate(getattr(content.mechanisms[name], "loads", ())):
        if load.kind == "tie":
            yield StatedTie(name, place, load)
