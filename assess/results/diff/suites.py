"""Differences of the suites of records: the lock, the records, their files and their scale factors."""

from __future__ import annotations

from collections.abc import Iterator

from assess.results.diff.change import Change
from assess.results.diff.pairs import of_both, pairs
from assess.results.run import Results
from assess.results.site import RecordResult


def suites(before: Results, after: Results) -> Iterator[Change]:
    """Compare which records the suites have, then file, SHA-256 and scale factor of each record."""
    yield Change("suite", "", "lock", _lock(before), _lock(after))
    sides = [{record.id: record for record in results.records} for results in (before, after)]
    if set(sides[0]) != set(sides[1]):
        yield Change("suite", "", "records", *of_both(lambda side: ", ".join(side) or None, *sides))
    hashes = [{each.path: each.sha256 for each in results.inputs} for results in (before, after)]
    for id, one, other in pairs(*sides):
        where = f"record {id}"
        if one is not None and other is not None:
            yield Change("suite", where, "file", one.path or None, other.path or None)
            yield Change("suite", where, "sha256", hashes[0].get(one.path), hashes[1].get(other.path))
            yield Change("suite", where, "made as", _made(one), _made(other))
        yield Change("suite", where, "scale factor", *of_both(lambda each: each.scale_factor, one, other))


def _lock(results: Results) -> str | None:
    motion = results.ground_motion
    return None if motion is None else motion.lock or None


def _made(record: RecordResult) -> str | None:
    """Return how an artificial record was made; None of recorded ones."""
    return None if record.path or not record.trail else record.trail[0]
