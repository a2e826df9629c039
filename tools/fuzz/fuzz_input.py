"""What is run: the files and the command of a seed, and what was changed in one of its files."""

from __future__ import annotations

import base64
import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path


@dataclass(frozen=True)
class Edit:
    """`removed` bytes at `offset`, `lost`, become `inserted`; where: a label; what: old -> new, for a reader."""

    offset: int
    removed: int
    inserted: bytes
    where: str
    what: str
    lost: bytes = b""


@dataclass(frozen=True)
class FuzzInput:
    """A command on files in an empty folder.

    group : the class of inputs; files : content by relative path; target : the one that is mutated, "" for none;
    arguments : of `assess`, "{}" standing for the folder; edits : what was changed; shows : a file that the command
    writes and that is compared instead of what it prints
    """

    group: str
    name: str
    files: dict[str, bytes]
    target: str
    arguments: tuple[str, ...]
    edits: tuple[Edit, ...] = ()
    shows: str = ""

    @property
    def data(self) -> bytes:
        """The content of the target."""
        return self.files[self.target]

    def edited(self, edits: Sequence[Edit]) -> FuzzInput:
        """The same after `edits` of its target, the last in the file first, so that offsets stay true."""
        data = self.data
        edits = [replace(each, lost=self.data[each.offset : each.offset + each.removed]) for each in edits]
        for edit in sorted(edits, key=lambda each: -each.offset):
            data = data[: edit.offset] + edit.inserted + data[edit.offset + edit.removed :]
        return replace(self, files=self.files | {self.target: data}, edits=tuple(edits))


def rewritten(case: FuzzInput, data: bytes, *, where: str, what: str) -> tuple[Edit, ...]:
    """The edit that makes the target `data`: the smallest stretch that differs."""
    old = case.data
    start = _alike(old, data)
    end = _alike(old[start:][::-1], data[start:][::-1])
    return (Edit(start, len(old) - start - end, data[start : len(data) - end], where, what),)


def _alike(one: bytes, other: bytes) -> int:
    """How many bytes are the same up to the first that is not."""
    low, high = 0, min(len(one), len(other))
    while low < high:
        middle = (low + high + 1) // 2
        low, high = (middle, high) if one[:middle] == other[:middle] else (low, middle - 1)
    return low


def saved(case: FuzzInput, path: Path, **more: object) -> Path:
    """The case, whole, as a file of JSON, and beside it what is told of it."""
    plain = asdict(case)
    plain["files"] = {name: base64.b64encode(data).decode() for name, data in case.files.items()}
    for edit in plain["edits"]:
        edit |= {key: base64.b64encode(edit[key]).decode() for key in ("inserted", "lost")}
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(plain | more, indent=1), encoding="utf-8")
    return path


def reopened(path: Path) -> FuzzInput:
    """The case that `saved` wrote."""
    plain = json.loads(path.read_text(encoding="utf-8"))
    edits = tuple(
        Edit(**(each | {key: base64.b64decode(each[key]) for key in ("inserted", "lost")})) for each in plain["edits"]
    )
    files = {name: base64.b64decode(data) for name, data in plain["files"].items()}
    return FuzzInput(
        plain["group"], plain["name"], files, plain["target"], tuple(plain["arguments"]), edits, plain.get("shows", "")
    )
