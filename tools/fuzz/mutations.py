"""Batches of mutated cases: what a batch holds follows from the seed and from itself, whoever makes it and when."""

from __future__ import annotations

import zlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import count, islice
from random import Random

from tools.fuzz import byte_edits, container_edits
from tools.fuzz.fuzz_input import Edit, FuzzInput
from tools.fuzz.option_edits import option_cases
from tools.fuzz.tree_edits import json_edits, toml_edits

SIZE = 20  # cases in a batch, which hypothesis draws at once
SIZES = {"record": 4, "mesh": 4, "geometry": 4, "report": 4}  # of classes that have many seeds, or take long
AS_BYTES = 0.25  # of projects and results
RARELY = {"wall.step": 6}  # turns of which a seed takes one: its reader takes seconds


@dataclass(frozen=True)
class Batch:
    """Some mutated cases of one seed.

    group, name : of the unmutated case
    turn : counted in its class from 1
    """

    group: str
    name: str
    turn: int

    @property
    def size(self) -> int:
        """How many cases it has, or fewer where a small seed has no more."""
        return SIZES.get(self.group, SIZE)


def schedule(
    cases: Mapping[str, Sequence[FuzzInput]], *, shares: Mapping[str, int], seed: int, without: Sequence[str] = ()
) -> Iterator[Batch]:
    """Yield batches without end, the classes by their shares of inputs.

    Parameters
    ----------
    cases : the unmutated cases of each class
    shares : inputs of each class in a round
    seed : of the order of cases
    without : names of cases that are left out
    """
    streams = {group: _turns(group, cases[group], seed=seed, without=without) for group in cases}
    credit = dict.fromkeys(cases, 0)
    while True:
        for group, stream in streams.items():
            credit[group] += shares[group]
            while credit[group] > 0:
                batch = next(stream)
                credit[group] -= batch.size
                yield batch


def _turns(group: str, cases: Sequence[FuzzInput], *, seed: int, without: Sequence[str]) -> Iterator[Batch]:
    names = [case.name for case in cases if case.name not in without]
    for turn in count(1):
        for name in Random(f"{seed} {group} {turn}").sample(names, len(names)):
            if turn % RARELY.get(name, 1) == 0:
                yield Batch(group, name, turn)


def cases_of(batch: Batch, case: FuzzInput, *, seed: int) -> Iterator[FuzzInput]:
    """Yield the mutated cases of a batch.

    Parameters
    ----------
    batch : which of them
    case : its unmutated case
    seed : of the run
    """
    whose = f"{seed} {batch.group} {batch.name} {batch.turn}"
    return islice(_cases(Random(whose), case, start=zlib.crc32(whose.encode()), size=batch.size), batch.size)


def _cases(random: Random, case: FuzzInput, *, start: int, size: int) -> Iterator[FuzzInput]:
    if case.group == "options":
        yield from option_cases(case, start=start, count=size)
    elif case.target.endswith((".toml", ".json")):
        structured = toml_edits if case.target.endswith(".toml") else json_edits
        for edits in structured(case, start=start, count=size):
            if edits:
                yield case.edited(edits)
            if random.random() < AS_BYTES:
                yield case.edited(byte_edits.edits(random, case))
    else:
        for _ in range(size):
            edits = _of_bytes(random, case)
            if edits:
                yield case.edited(edits)


def _of_bytes(random: Random, case: FuzzInput) -> tuple[Edit, ...]:
    if case.data[:4] == b"PK\3\4":
        return container_edits.zip_edits(random, case)
    if case.data[:15] == b"SQLite format 3":
        return container_edits.sqlite_edits(random, case)
    return byte_edits.edits(random, case)
