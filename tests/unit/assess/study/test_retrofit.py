"""The search for least works: intervals of a share, three starts against the whole grid, records on two sides."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import product
from typing import Any

import numpy as np
import pytest
from scipy.stats import binom

from assess.errors import ProjectError
from assess.results.retrofit import Layout, Place, Reached, Target, Tolerance, pareto_front, proof_confidence
from assess.study.retrofit import (
    MOST_PROOFS,
    Measures,
    find_least,
    most_proofs,
    split_by_event,
    tolerances,
    upper_share,
)
from assess.study.retrofit_search import merit, search_grid
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


@dataclass(frozen=True)
class Drawn:
    """A layout without ties that is its own study, and whose records overturn as they were drawn."""

    layout: Layout
    has_ties: bool = False

    def study(self, tolerance: Tolerance) -> Any:
        return self.layout


class DrawnDesigns:
    """Layouts on one axis, the least first."""

    def __init__(self, number: int) -> None:
        self.sizes = (number,)

    def design(self, place: Place) -> Drawn:
        return Drawn(Layout(place, (float(place[0]),), float(place[0]), float(place[0])))


@pytest.mark.parametrize(("records", "reach", "most"), [(25, 0.1, 2), (34, 0.1, 5), (50, 0.05, 2), (60, 0.2, 10)])
@pytest.mark.parametrize("alike", [0.0, 0.5])
def test_the_share_of_the_layout_that_is_chosen_holds_at_84_in_100(
    records: int, reach: float, most: int, alike: float
) -> None:
    """Of twelve layouts that all exceed the share by a hair, one is chosen in 16 of 100 searches at most.

    alike : of the records, whose outcome all layouts share. Counted each at 84 %, they are chosen far more often.
    """
    rng, target, runs = np.random.default_rng(7), Target("probability", reach, rising=False), 2000
    assert most_proofs(records, reach, 12) == most
    chosen = {True: 0, False: 0}
    for _ in range(runs):
        drawn = rng.random((12, records))
        drawn[:, : round(alike * records)] = drawn[0, : round(alike * records)]
        overturned = (drawn < reach * 1.0001).sum(axis=1)
        for rule in chosen:

            def measured(layouts: Sequence[Any], confidence: float) -> list[Reached]:
                found = [int(overturned[each.place[0]]) for each in layouts]  # noqa: B023
                return [Reached(upper_share(n, records, confidence=confidence), n) for n in found]

            def proof(layouts: int) -> Any:
                return (partial(measured, confidence=proof_confidence(layouts if rule else 1)),) * 2  # noqa: B023

            measures = Measures(
                lambda layouts: [Reached(0.0) for _ in layouts],
                proof,
                partial(most_proofs, records, reach) if rule else lambda candidates: candidates,
                spread=True,
            )
            chosen[rule] += find_least(DrawnDesigns(12), target, measures).best is not None
    bound = 0.16 + 3.0 * np.sqrt(0.16 * 0.84 / runs)
    assert chosen[True] / runs <= bound
    assert chosen[False] / runs > bound


def test_of_as_many_layouts_as_may_be_proved_none_needs_a_record_that_overturns() -> None:
    """With one more, not even no record that overturns could show the share, by 1 - a^(1/n)."""
    for records, reach in ((25, 0.1), (34, 0.1), (50, 0.05), (13, 0.2)):
        most = most_proofs(records, reach, 1000)
        assert 1.0 - (0.16 / most) ** (1.0 / records) <= reach
        assert most == MOST_PROOFS or 1.0 - (0.16 / (most + 1)) ** (1.0 / records) > reach
    assert most_proofs(1000, 0.1, 3) == 3
    assert most_proofs(1000, 0.1, 0) == 1


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


def test_what_differs_by_rounding_is_no_progress() -> None:
    target = Target("index", 1.0, rising=True)
    numbers = [(1.0, 0.80935450122532), (2.0, 0.80935450122533), (3.0, 1.2), (3.0 + 1e-13, 1.1)]
    layouts = [
        Layout((place,), (float(place),), steel, steel, reached=Reached(value))
        for place, (steel, value) in enumerate(numbers)
    ]
    assert [each.place for each in pareto_front(layouts, target)] == [(0,), (2,)]
    assert min(layouts[2:], key=lambda each: merit(each, target)).place == (2,)
    assert [each.place for each in pareto_front(layouts, target, proved=layouts[3])] == [(0,), (3,)]
    assert [each.place for each in pareto_front(layouts, target, proved=layouts[1])] == [(0,), (1,), (2,)]


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
