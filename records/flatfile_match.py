"""Which row of a flatfile describes which record: by NGA number, else by a file name that one row alone has."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from assess.messages.message import Message, warning
from records.candidates import Candidate
from records.flatfile import COLUMNS, BadCell, Flatfile, Recording


@dataclass(frozen=True)
class FlatfileMatch:
    """How a flatfile matches the records: rows matched and not, records described, bad cells.

    warning : why no row matches, which columns are missing, or how many records have no row; None otherwise
    """

    matched: int
    unmatched: int
    records: int
    bad: tuple[BadCell, ...]
    warning: Message | None


def describe_candidates(candidates: Sequence[Candidate], recordings: Sequence[Recording]) -> tuple[Candidate, ...]:
    """Describe the candidates by a flatfile, whose values replace those of the record files.

    A recording is found by the NGA number in the name of the candidate's file, else by a file name that it alone has.

    Parameters
    ----------
    candidates : records of a catalogue or of files [n]
    recordings : of the flatfile

    Returns
    -------
    tuple of Candidate : in the same order [n]
    """
    found = _find_recordings(candidates, recordings)
    return tuple(one if by is None else _describe(one, by) for one, by in zip(candidates, found, strict=True))


def match_flatfile(candidates: Sequence[Candidate], flatfile: Flatfile) -> FlatfileMatch:
    """Count how many rows of a flatfile and candidates match.

    Parameters
    ----------
    candidates : records of a catalogue or of files
    flatfile : as read, with its bad cells
    """
    found = [by for by in _find_recordings(candidates, flatfile.recordings) if by is not None]
    matched = len({by.nga for by in found})
    said = _missing(flatfile.missing) or _absent(candidates, flatfile.recordings)
    said = said if found else _reason(candidates, flatfile.recordings)
    return FlatfileMatch(matched, len(flatfile.recordings) - matched, len(found), flatfile.bad, said)


def _find_recordings(candidates: Sequence[Candidate], recordings: Sequence[Recording]) -> list[Recording | None]:
    """Find the recording of each candidate; None where there is none."""
    by_number = {one.nga: one for one in recordings}
    by_file: dict[str, Recording | None] = {}
    for one in recordings:
        for file in one.files:
            by_file[file] = one if by_file.get(file, one) == one else None
    named = ((one, by_file.get(_file(one.path))) for one in candidates)
    return [
        by_number.get(one.nga or 0) or (by if by is not None and one.nga in (None, by.nga) else None)
        for one, by in named
    ]


def _missing(keys: Sequence[str]) -> Message | None:
    """Say which columns were not found; None if none is missing."""
    if not keys:
        return None
    known = "; ".join(f"{key}: {', '.join(COLUMNS[key])}" for key in keys)
    return warning("flatfile-columns-missing", keys=", ".join(keys), known=known)


def _absent(candidates: Sequence[Candidate], recordings: Sequence[Recording]) -> Message | None:
    """Say how many records have no row; None if all have one."""
    found = zip(candidates, _find_recordings(candidates, recordings), strict=True)
    alone = [one for one, by in found if by is None]
    if not alone:
        return None
    counts = {"total": str(len(candidates)), "count": str(len(alone))}
    return warning("flatfile-rows-absent", **counts, file=_file(alone[0].path))


def _reason(candidates: Sequence[Candidate], recordings: Sequence[Recording]) -> Message:
    """Say why no row matches a record."""
    if not candidates:
        return warning("flatfile-no-records")
    numbers = sorted(one.nga for one in candidates if one.nga is not None)
    first, last = min(one.nga for one in recordings), max(one.nga for one in recordings)
    if numbers:
        ends = {"first": numbers[0], "last": numbers[-1], "first_row": first, "last_row": last}
        return warning("flatfile-other-numbers", **{key: str(number) for key, number in ends.items()})
    names = sorted(file for one in recordings for file in one.files)
    example = names[0] if names else f"RSN{first}_….AT2"
    return warning("flatfile-no-numbers", file=_file(candidates[0].path), example=example)


def _file(path: str) -> str:
    return path.replace("\\", "/").rsplit("/", 1)[-1].lower()


def _describe(one: Candidate, by: Recording) -> Candidate:
    return replace(
        one,
        nga=by.nga,
        event=by.event or one.event,
        station=by.station or one.station,
        date=one.date if one.date[:4] == by.year else by.year or one.date,
        magnitude=one.magnitude if by.magnitude is None else by.magnitude,
        distance=one.distance if by.distance is None else by.distance,
        vs30=one.vs30 if by.vs30 is None else by.vs30,
    )
