"""Compare every number, name, outcome, order and key of two sets of results; list the texts that changed.

Numbers are compared by their bits.
"""

from __future__ import annotations

import json
import re
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

TEXTS = frozenset({"text", "description", "remark", "label", "note", "source", "told", "title", "clause", "meaning"})
"""Keys whose values are words for people; what they hold may change, but not the numbers in it."""
NAMES = frozenset(
    {
        "verdict",
        "outcome",
        "limit_state",
        "name",
        "symbol",
        "code",
        "edition",
        "mechanism",
        "mechanisms",
        "load",
        "loads",
    }
    | {"procedure", "unit", "dimension", "event", "station", "where", "key", "case", "parameter", "reading", "role"}
)
"""Keys whose values are names or outcomes even where they are written with spaces: "not met", "tie 1"."""
OWN_SOURCES = ".program.sha256"
"""The digest of the program's own sources, which changes with every line of them."""
NUMBER = re.compile(r"\d+(?:\.\d+)?(?:e[+-]?\d+)?")


@dataclass(frozen=True)
class Difference:
    """Where two results differ, and whether only in words for people."""

    place: str
    before: Any
    after: Any
    words: bool


def differences(before: Any, after: Any, place: str = "", key: str = "") -> Iterator[Difference]:
    """Every leaf, key or length in which two trees of JSON differ; numbers are compared by their bits."""
    if isinstance(before, dict) and isinstance(after, dict):
        if list(before) != list(after):
            yield Difference(f"{place} (keys)", list(before), list(after), words=False)
        for name in before:
            if name in after and not f"{place}.{name}".endswith(OWN_SOURCES):
                yield from differences(before[name], after[name], f"{place}.{name}", name)
    elif isinstance(before, list) and isinstance(after, list):
        if len(before) != len(after):
            words = key not in NAMES and all(_sentence(each) for each in (*before, *after))
            yield Difference(f"{place} (length)", before, after, words=words)
        for number, (old, new) in enumerate(zip(before, after, strict=False)):
            yield from differences(old, new, f"{place}[{number}]", key)
    elif type(before) is not type(after) or repr(before) != repr(after):
        yield Difference(place, before, after, words=_reworded(before, after, key))


def _reworded(before: Any, after: Any, key: str) -> bool:
    """Whether one text for people says in other words what another said, with the same numbers."""
    if not (isinstance(before, str) and isinstance(after, str)) or key in NAMES:
        return False
    if key not in TEXTS and not _sentence(before):
        return False
    return sorted(NUMBER.findall(before)) == sorted(NUMBER.findall(after))


def _sentence(value: Any) -> bool:
    return isinstance(value, str) and " " in value


def compare(before: Path, after: Path) -> int:
    """Print what differs; 1 where it is more than words."""
    texts: Counter[tuple[str, str]] = Counter()
    projects = sorted(path.name for path in before.glob("*.json"))
    broken = 0
    for name in projects:
        if not (after / name).exists():
            sys.stdout.write(f"{name}: was not run\n")
            broken += 1
            continue
        for each in differences(json.loads((before / name).read_text()), json.loads((after / name).read_text())):
            if each.words:
                texts[str(each.before), str(each.after)] += 1
            else:
                broken += 1
                sys.stdout.write(f"{name}{each.place}: {str(each.before)[:160]!r} became {str(each.after)[:160]!r}\n")
    for (old, new), times in texts.most_common():
        sys.stdout.write(f"{times:6d} x  - {old}\n          + {new}\n")
    sys.stdout.write(f"{len(projects)} projects: {broken} differences, {len(texts)} texts changed\n")
    return 1 if broken else 0
