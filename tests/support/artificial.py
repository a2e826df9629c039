"""Artificial records are made once in a process of the tests: dozens of projects ask for the same few suites."""

from __future__ import annotations

from records import synthetic
from records.record import Record
from records.synthetic import HarmonicBasis, TargetOrdinates

make_artificial = synthetic._make_artificial


def make_artificial_once() -> None:
    """Recall a record of the same target, recipe, seed and number instead of making it again."""
    made: dict[object, Record] = {}

    def recall(target: TargetOrdinates, basis: HarmonicBasis, code: str, seed: int, index: int) -> Record:
        ordinates = target.period.tobytes(), target.ordinate.tobytes(), target.pga
        key = ordinates, basis.duration, basis.dt, code, seed, index
        if key not in made:
            made[key] = make_artificial(target, basis, code, seed, index)
        return made[key]

    synthetic._make_artificial = recall
