"""Which silent differences are what the edit says: nothing else in the file could have told that it was made."""

from __future__ import annotations

import json
import re
from typing import Any

import numpy as np

from tools.fuzz.answer import Answer, Samples
from tools.fuzz.byte_edits import NUMBER, is_text
from tools.fuzz.fuzz_input import Edit, FuzzInput
from tools.fuzz.judgement import apart

FORMS = {"--csv", "--json", "--list", "--catalogue"}  # options that print something else, as asked
ONCE = re.compile(r"\[\d+\]\.(site|earthquake|epicentral_distance_km|measures|spectrum|pga_g|npts)\b")
"""What of `records list --json` a file says once, or follows from its samples."""


def rightly(case: FuzzInput, found: Answer, usual: Answer) -> bool:
    """Whether the answer to a mutated case is right, though another."""
    if case.group == "record":
        return _record(case, found, usual)
    if case.group == "options":
        return bool(FORMS & set(case.arguments))
    if case.group == "catalogue":  # of an older version: it is read again
        return {edit.where for edit in case.edits} == {"user_version"}
    return case.group == "results" and _unknown_keys(case)


def _record(case: FuzzInput, found: Answer, usual: Answer) -> bool:
    """Whether only those samples are others that the edits touch, and numbers that the header has once."""
    if len(found.samples) != len(usual.samples) or not found.samples:
        return False
    places = apart(usual.out, found.out)
    touched = sum(_touched(edit, text=is_text(case.data)) for edit in case.edits)
    pairs = zip(usual.samples, found.samples, strict=True)
    return all(ONCE.match(place) for place in places) and sum(_others(*pair) for pair in pairs) <= touched


def _touched(edit: Edit, *, text: bool) -> int:
    """How many numbers an edit can change, lose or add: those in it, and the one that it stands in."""
    if not text:
        return 2 + max(edit.removed, len(edit.inserted)) // 4
    return 1 + max(len(NUMBER.findall(data)) for data in (edit.lost, edit.inserted))


def _others(before: Samples, after: Samples) -> float:
    """How many samples are others, but for an offset of all of them; infinitely many at another step."""
    (dt, old), (step, new) = before, after
    if dt != step:
        return float("inf")
    if old.size == new.size:
        off = new - old
        return int(np.sum(np.abs(off - np.median(off)) > 1e-9 * np.abs(old).max()))
    size = min(old.size, new.size)
    ends = (_alike(old[:size], new[:size]), _alike(old[::-1][:size], new[::-1][:size]))
    return max(old.size, new.size) - min(sum(ends), size)


def _alike(old: Any, new: Any) -> int:
    """How many samples are the same up to the first that is not."""
    differ = np.flatnonzero(old != new)
    return int(differ[0]) if differ.size else int(old.size)


def _unknown_keys(case: FuzzInput) -> bool:
    """Whether a file of results has all it had, and more: keys that the program does not know."""
    old, new = (json.loads(case.files[name]) for name in ("a.json", "b.json"))
    return _holds(new, old)


def _holds(new: Any, old: Any) -> bool:
    if isinstance(old, dict) and isinstance(new, dict):
        return all(_holds(new[key], value) if key in new else _nothing(value) for key, value in old.items())
    if isinstance(old, list) and isinstance(new, list):
        return len(old) == len(new) and all(map(_holds, new, old))
    return bool(new == old or str(new).lower() == str(old).lower())


def _nothing(value: Any) -> bool:
    return value is None or value == [] or value == ""
