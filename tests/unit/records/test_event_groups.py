"""Recordings of one earthquake, and one motion in two files with other digits, against pairs known beforehand."""

from dataclasses import replace

import pytest

from records.candidates import Candidate, read_candidates
from records.formats.header import HeaderOverrides
from records.selection import event_groups, same_motion
from tests.support import candidates
from tests.support.places import REAL_RECORDS, needs_real_records


def candidate(number: int, *, event: str = "", digits: float = 0.0) -> Candidate:
    return candidates.candidate(number, event=event, digits=digits, path=f"{number} {digits}")


@pytest.mark.parametrize(
    ("digits", "same"), [(0.0, 1), (1e-6, 1), (1e-4, 1), (1e-3, 1), (3e-3, 1), (0.03, 0), (0.3, 0)]
)
def test_one_motion_is_told_though_its_digits_differ_and_another_processing_is_another(
    digits: float, same: int
) -> None:
    three = (candidate(1), candidate(2), candidate(1, digits=digits))
    assert [sorted(pair) for pair in same_motion([(one,) for one in three]).tolist()] == [[0, 2]] * same


@pytest.mark.parametrize("order", [(0, 1, 2), (2, 0, 1), (1, 2, 0)])
def test_a_copy_without_a_name_is_of_the_earthquake_of_the_motion(order: tuple[int, ...]) -> None:
    """Though another recording of that earthquake is known only by its name; in any order of the files."""
    three = [candidate(1, event="Petrolia"), candidate(1, digits=1e-4), candidate(2, event="Petrolia")]
    mixed = [(three[i],) for i in order]
    assert len(set(event_groups(mixed, one_per_event=True).tolist())) == 1
    assert len(set(event_groups(mixed, one_per_event=False).tolist())) == 2


def test_any_component_of_a_recording_tells() -> None:
    one, other, copy = candidate(1), candidate(2), replace(candidate(2), path="copy")
    assert same_motion([(one, other), (copy, candidate(3))]).tolist() == [[0, 1]]


def test_none_and_many() -> None:
    assert event_groups([], one_per_event=True).size == 0
    many = [(candidate(i),) for i in range(500)]
    assert len(set(event_groups([*many, *many[:100]], one_per_event=False).tolist())) == 500


@needs_real_records
def test_rio_dell_in_two_formats() -> None:
    """PEER AT2, and the same as FEMA P-695 has it, with a sample more; beside another record of the earthquake."""
    files = ["plain/SortedEQFile_(121321).txt", "peer_at2/RIO270.AT2", "peer_at2/CPM000.AT2", "peer_at2/Rinaldi228.AT2"]
    found = read_candidates([REAL_RECORDS / file for file in files], overrides=HeaderOverrides("g"))
    assert event_groups([(one,) for one in found], one_per_event=True).tolist() == [0, 0, 0, 1]
    assert event_groups([(one,) for one in found], one_per_event=False).tolist() == [0, 0, 1, 2]
