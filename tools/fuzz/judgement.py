"""What an answer is, beside that of the unmutated case."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from math import isclose, isfinite
from typing import Any

from tools.fuzz.answer import Answer

SAME, WARNED, RIGHT, SILENT, REFUSED = "same", "other, warned", "other, by right", "other, silent", "refused"
BUG, TRACEBACK, HANG, MEMORY, NOISE = "bug", "traceback", "hang", "memory", "noise"
OUTCOMES = (SAME, WARNED, RIGHT, SILENT, REFUSED, BUG, TRACEBACK, HANG, MEMORY, NOISE)
BROKEN = {BUG, TRACEBACK, HANG, MEMORY, NOISE}
TOLERANCE = 1e-9
REFUSAL = re.compile(r"assess: error: [^\n]+\n")
TOLD = re.compile(r"(assess: )?(warning|note)\b")  # lines on stderr
DRAWN = ".view."  # corners and triangles of pictures, whose order says nothing
TEXTS = {"warnings", "notices", "conditions", "missing", "mended", "problems", "unreadable", "why_not", "remarks"}
"""Keys of the JSON under which the program tells what it doubts."""


@dataclass(frozen=True)
class Judged:
    """An outcome; signature: what tells one fault from another; detail: for the reader."""

    outcome: str
    signature: str = ""
    detail: str = ""


def judged(found: Answer, usual: Answer) -> Judged:
    """The outcome of a mutated case, `usual` being the answer of its seed."""
    if found.code is None:
        return judged_dead(found.told)
    if "MemoryError" in found.told:
        return Judged(MEMORY, _signature(found.told), found.told)
    if "Traceback (most recent call last)" in found.out + found.err:
        return Judged(TRACEBACK, _signature(found.out + found.err), found.err[-1500:])
    if found.code not in (0, 1, 2, 3):
        return Judged(BUG, _signature(found.told) or f"code {found.code}", found.err[-300:] + found.told[-1500:])
    if found.code == 2 and not found.written:
        return _refusal(found)
    strange = [line for line in found.err.splitlines() if re.search(r"\w+Warning: ", line)]
    if strange:
        return Judged(NOISE, re.sub(r"\d+", "#", strange[0]), found.err[-1500:])
    if found.code == 2:  # of a portfolio: a row with its reason
        return Judged(REFUSED, detail=found.out[-300:])
    return _accepted(found, usual)


def judged_dead(told: str) -> Judged:
    """The outcome of a case whose process was killed or died; told: how."""
    return Judged(told if told in (HANG, MEMORY) else BUG, told, told)


def shown(found: Answer, before: str, after: str) -> Judged:
    """The outcome of a comparison of two files: a number that differs between them and is not shown is silent."""
    change = difference(before, after)
    if found.out.strip() != "[]":
        return Judged(WARNED, detail=found.out[:300])
    return Judged(SAME) if change is None or _slight(before, after) else Judged(SILENT, detail=change)


def _slight(before: str, after: str) -> bool:
    """Whether all numbers agree within the tolerance of `assess diff`."""
    old, new = _table(before), _table(after)
    return old.keys() == new.keys() and all(
        _close(old[key], new[key]) or _distance(old[key], new[key]) <= 1e-6 for key in old
    )


def _refusal(found: Answer) -> Judged:
    """A refusal in a line for each fault, at the end; anything else that ends with 2 is a bug."""
    lines = found.err.splitlines(keepends=True)
    number = found.err.count("assess: error: ")
    told = lines[len(lines) - number :]
    counted = number == 1 or (told and told[0].endswith(f" (and {number - 1} more)\n"))
    if not number or not counted or not all(map(REFUSAL.fullmatch, told)):
        return Judged(BUG, "a refusal that is not a line for each fault", found.err[-1500:])
    return Judged(REFUSED, detail=told[0].strip())


def _accepted(found: Answer, usual: Answer) -> Judged:
    if usual.code not in (0, 1, 3):
        return Judged(WARNED, detail="the seed itself is refused")
    change = difference(usual.out, found.out)
    if change is None and found.code == usual.code:
        return Judged(SAME)
    detail = change or f"code {usual.code} -> {found.code}"
    return Judged(
        WARNED if messages_of(found) - messages_of(usual) or found.code != usual.code else SILENT, detail=detail
    )


def messages_of(found: Answer) -> set[str]:
    """Warnings on stderr, among the lines printed, and in the JSON printed."""
    lines = {line for line in (found.err + found.out).splitlines() if TOLD.match(line)}
    return lines | set(_message_texts(_parsed(found.out)))


def _message_texts(tree: Any, inside: bool = False) -> Iterator[str]:
    if isinstance(tree, dict):
        for key, value in tree.items():
            yield from _message_texts(value, inside or key in TEXTS)
    elif isinstance(tree, list):
        for value in tree:
            yield from _message_texts(value, inside)
    elif inside and isinstance(tree, str):
        yield tree


def apart(before: str, after: str) -> list[str]:
    """The places at which two outputs have different numbers, or one of them has none."""
    old, new = _table(before), _table(after)
    return [key for key in {**old, **new} if key not in old or key not in new or not _close(old[key], new[key])]


def difference(before: str, after: str) -> str | None:
    """The number that differs most between two outputs, in words; None where all agree within the tolerance."""
    old, new = _table(before), _table(after)
    lost, more = sorted(old.keys() - new.keys()), sorted(new.keys() - old.keys())
    listed = f"{len(lost)} numbers gone {lost[:1]}, {len(more)} more {more[:1]}" if lost or more else ""
    far = [(key, old[key], new[key]) for key in old.keys() & new.keys() if not _close(old[key], new[key])]
    if not far:
        return listed or None
    key, one, other = max(sorted(far, key=str), key=lambda each: _distance(each[1], each[2]))
    return f"{key}: {one!r} -> {other!r} ({len(far)} of {len(old)} numbers); {listed}".removesuffix("; ")


@lru_cache(maxsize=16)
def _table(text: str) -> dict[str, Any]:
    """Numbers by their place; the same output is compared with many."""
    return dict(_numbers(_parsed(text)))


def _parsed(text: str) -> Any:
    try:
        return json.loads(text)
    except ValueError:
        return re.findall(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?|\bnan\b|\binf\b", text, re.IGNORECASE)


def _numbers(tree: Any, key: str = "") -> Iterator[tuple[str, Any]]:
    """Numbers, truths and absences by their place; numbers in plain text too."""
    if isinstance(tree, dict):
        for name, value in tree.items():
            yield from _numbers(value, f"{key}.{name}")
    elif isinstance(tree, list):
        for place, value in enumerate(tree):
            yield from _numbers(value, f"{key}[{place}]")
    elif not isinstance(tree, str):
        if DRAWN not in key:
            yield key, tree
    elif not key.startswith(".") and re.fullmatch(r"\[\d+\]", key):
        yield key, float(tree)


def _close(one: Any, other: Any) -> bool:
    if isinstance(one, float | int) and isinstance(other, float | int):
        return isclose(one, other, rel_tol=TOLERANCE, abs_tol=1e-15) or one == other
    return bool(one == other)


def _distance(one: Any, other: Any) -> float:
    if not (isinstance(one, float | int) and isinstance(other, float | int) and isfinite(one) and isfinite(other)):
        return float("inf")
    return abs(one - other) / max(abs(one), abs(other), 1e-300)


def _signature(told: str) -> str:
    """The kind of the last exception and the deepest line of our own in a traceback."""
    ours = re.findall(r'File "[^"]*/((?:assess|records|reports|spectra)/[^"]+)", line \d+, in (\w+)', told)
    kinds = re.findall(r"^(\w[\w.]*(?:Error|Exception|Warning|Interrupt|Exit|Overflow)?)(?::|$)", told, re.MULTILINE)
    where = f"{ours[-1][0]}:{ours[-1][1]}" if ours else "nowhere of ours"
    return f"{kinds[-1] if kinds else 'an exception'} in {where}" if told else ""
