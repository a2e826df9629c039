"""The search for least works: intervals of a share, three starts against the whole grid, records on two sides."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from scipy.stats import binom

from assess.errors import ProjectError
from assess.results.retrofit import Layout, Place, Reached, Target, pareto_front
from assess.study.retrofit import split_by_event, tolerances, upper_share
from assess.study.retrofit_search import search_grid
from assess.study.study import ScaledRecord
from tests.support.motions import noise


@pytest.mark.parametrize(
    ("overturned", "confidence", "share"), [(0, 0.84, 0.036), (1, 0.84, 0.064), (0, 0.95, 0.058), (1, 0.95, 0.091)]
)
def test_upper_ends_of_shares_of_fifty_records(overturned: int, confidence: float, share: float) -> None:
    assert upper_share(overturned, 50, confidence=confidence) == pytest.approx(share, abs=5e-4)


@pytest.mark.parametrize("overturned", [0, 1, 7, 33])
def test_at_the_upper_end_so_few_are_as_rare_as_the_confidence_says(overturned: int) -> None:
    share = upper_share(overturned, 34)
    assert binom.cdf(overturned, 34, share) == pytest.approx(1.0 - 0.84, rel=1e-9)
    assert upper_share(34, 34) == 1.0


def examine(places: Sequence[Place]) -> list[Layout]:
    """Ties of a wall with an island: soft ones of little area hold it at one height alone, where others overturn it."""
    found = []
    for place in places:
        area, height = 100.0 + 2.0 * place[0], 3.0 + 0.05 * place[1]
        lever = np.sin(2.5 * height) + height
        value = area * lever / 1000.0 if area > 260.0 else 0.3 + area / 1000.0 * (abs(height - 5.0) < 0.3)
        steel = area * (10.0 + 0.1 * height)
        found.append(Layout(place, (area, height), steel, steel, None, Reached(float(value))))
    return found


@pytest.mark.parametrize("reach", [0.45, 0.8, 1.3, 1.9])
def test_three_starts_find_what_the_whole_grid_has(reach: float) -> None:
    target, sizes = Target("index", reach, rising=True), (150, 60)
    asked: list[Place] = []

    def counted(places: Sequence[Place]) -> list[Layout]:
        asked.extend(places)
        return examine(places)

    whole = examine(list(product(*map(range, sizes))))
    least = min(each.objective for each in whole if each.reached and target.holds(each.reached))
    known = search_grid(sizes, counted, target)
    found = min(each.objective for each in known.values() if each.reached and target.holds(each.reached))
    assert least <= found <= 1.01 * least
    assert len(asked) == len(set(asked)) < 1500


def test_a_small_grid_is_examined_whole() -> None:
    known = search_grid((20, 20), examine, Target("index", 1.0, rising=True))
    assert len(known) == 400


def test_none_of_the_front_takes_more_for_less() -> None:
    target = Target("index", 1.0, rising=True)
    layouts = examine([(a, h) for a in range(0, 150, 7) for h in range(0, 60, 11)])
    front = pareto_front(layouts, target)
    assert list(front) == sorted(front, key=lambda each: each.objective)
    for each in layouts:
        better = [f for f in front if f.objective <= each.objective and target.beyond(f) <= target.beyond(each)]
        assert better


def motions_of_events(events: Sequence[str]) -> list[ScaledRecord]:
    made = [replace(noise(seed, peak=3.0, npts=200), event=event) for seed, event in enumerate(events)]
    return [ScaledRecord(record, scaling=None) for record in made]  # type: ignore[arg-type]


def test_records_of_one_event_are_on_one_side() -> None:
    events = ["a", "A", "b", "b", "c", "", ""]
    seen, left = split_by_event(motions_of_events(events))
    assert (seen, left) == ([0, 1, 4, 6], [2, 3, 5])
    seen, left = split_by_event(motions_of_events([*"abcdefghij"]), 3)
    assert (seen, left) == ([0, 4, 9], [1, 2, 3, 5, 6, 7, 8])
    with pytest.raises(ProjectError, match="2 of 1 events"):
        split_by_event(motions_of_events(["a", "a"]))


def test_tolerances_are_all_corners_and_each_alone() -> None:
    every = tolerances()
    assert len(every) == len(set(every)) == 1 + 16 + 8
    assert {each.area for each in every[:3]} == {1.0, 0.9, 1.1}
