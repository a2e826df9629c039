"""The stream of mutated cases of a class, the same for the same seed."""

from __future__ import annotations

import zlib
from collections.abc import Iterator
from random import Random

from tests.fuzz import byte_edits, container_edits
from tests.fuzz.case import Case
from tests.fuzz.option_edits import option_cases
from tests.fuzz.tree_edits import json_edits, toml_edits

BATCH = 25  # cases drawn by hypothesis at once
AS_BYTES = 0.25  # of projects and results


def mutations(cases: tuple[Case, ...], *, seed: int) -> Iterator[tuple[Case, Case]]:
    """Pairs of an unmutated case and a mutated one, without end: a batch of each case in turn."""
    random = Random(f"{seed} {cases[0].group}")
    turn = 0
    while True:
        turn += 1
        for case in random.sample(cases, len(cases)):
            for made in _batch(random, case, start=zlib.crc32(f"{seed} {case.name} {turn}".encode())):
                yield case, made


def _batch(random: Random, case: Case, *, start: int) -> Iterator[Case]:
    if case.group == "options":
        yield from option_cases(case, start=start, count=BATCH)
    elif case.target.endswith((".toml", ".json")):
        structured = toml_edits if case.target.endswith(".toml") else json_edits
        for edits in structured(case, start=start, count=BATCH):
            if edits:
                yield case.edited(edits)
            if random.random() < AS_BYTES:
                yield case.edited(byte_edits.edits(random, case))
    else:
        for _ in range(4 if case.group in ("record", "mesh", "geometry") else BATCH):
            edits = _of_bytes(random, case)
            if edits:
                yield case.edited(edits)


def _of_bytes(random: Random, case: Case) -> tuple:  # type: ignore[type-arg]
    if case.data[:4] == b"PK\3\4":
        return container_edits.zip_edits(random, case)
    if case.data[:15] == b"SQLite format 3":
        return container_edits.sqlite_edits(random, case)
    return byte_edits.edits(random, case)
