"""Suites against all suites there are, against records chosen one by one, and against their limits."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest

from records.candidates import PERIODS, sequence_number
from records.errors import RecordError
from records.scaling import band, truncate_band
from records.selection import (
    CandidateFilters,
    Pool,
    SuiteCriteria,
    best_suite,
    exchanged_suite,
    exhaustive_suite,
    greedy_suite,
    passes,
    select,
)
from spectra.table import table_spectrum
from tests.support.candidates import TARGET, candidate

BAND = band(0.2, 2.0)


def pool(seed: int, n: int, groups: int) -> Pool:
    rng = np.random.default_rng(seed)
    ratio = np.exp(rng.normal(0.0, 0.5, (n, 12)))
    return Pool(ratio, np.full(12, 1 / 12), np.arange(n) % groups, (np.log(ratio) ** 2).mean(axis=1))


def least(pool: Pool, count: int) -> float:
    """By plain loops over all suites."""
    return min(
        float(pool.misfit(pool.ratio[list(suite)].mean(axis=0)))
        for suite in combinations(range(pool.mse.size), count)
        if len(set(pool.group[list(suite)])) == count
    )


@pytest.mark.parametrize("seed", range(12))
def test_a_small_catalogue_gives_the_best_of_all_suites(seed: int) -> None:
    of = pool(seed, 12, 9)
    chosen, before = best_suite(of, 4)
    found = float(of.misfit(of.ratio[chosen].mean(axis=0)))
    assert found == pytest.approx(least(of, 4), rel=1e-12)
    assert found <= before * (1 + 1e-12)
    assert len(set(of.group[chosen])) == 4
    assert exhaustive_suite(of, 4) == chosen


@pytest.mark.parametrize("seed", range(12))
def test_exchanges_never_make_a_greedy_suite_worse_and_mostly_reach_the_best(seed: int) -> None:
    of = pool(seed, 14, 14)
    first = greedy_suite(of, 4)
    misfit = [float(of.misfit(of.ratio[suite].mean(axis=0))) for suite in (first, exchanged_suite(of, first))]
    assert misfit[1] <= misfit[0]
    assert misfit[1] <= 2.5 * least(of, 4)  # one exchange at a time may stop at a local optimum


def test_a_record_of_the_targets_own_shape_is_found_and_its_factor_is_exact() -> None:
    like = replace(candidate(3), spectrum=0.25 * TARGET.acceleration(PERIODS))
    others = [candidate(number) for number in range(5, 40)]
    found = select([*others, like], TARGET, SuiteCriteria(1, BAND, fit="each"))
    (choice,) = found.choices
    assert choice.components == (like,)
    assert choice.factor == pytest.approx(4.0, rel=1e-12)
    assert choice.mse == pytest.approx(0.0, abs=1e-20)
    assert found.misfit == pytest.approx(0.0, abs=1e-20)


def test_each_record_is_the_best_of_its_earthquake() -> None:
    many = [candidate(number, event=f"quake {number % 6}") for number in range(60)]
    found = select(many, TARGET, SuiteCriteria(6, BAND, fit="each"))
    assert {choice.components[0].earthquake for choice in found.choices} == {f"quake{n}" for n in range(6)}
    alone = [select([one], TARGET, SuiteCriteria(1, BAND)).choices[0] for one in many]
    for choice in found.choices:
        same = [other.mse for other in alone if other.components[0].event == choice.components[0].event]
        assert choice.mse == pytest.approx(min(same), rel=1e-12)


def test_components_of_a_recording_keep_one_factor() -> None:
    pairs = [
        replace(candidate(number, component=c, seed=1000 * number + int(c)), station=f"s{number}", event=f"e{number}")
        for number in range(8)
        for c in ("000", "090")
    ]
    up = replace(candidate(1, component="UP"), station="s1", event="e1")
    found = select([*pairs, up], TARGET, SuiteCriteria(3, BAND, components="together"))
    for choice in found.choices:
        first, second = choice.components
        assert first.station == second.station
        logarithm = 0.5 * np.interp(np.log(BAND.period), np.log(PERIODS), np.log(first.spectrum * second.spectrum))
        ratio = np.log(TARGET.acceleration(BAND.period)) - logarithm
        expected = np.exp(np.average(ratio, weights=BAND.weight))
        assert choice.factor == pytest.approx(expected, rel=1e-12)


def test_weights_move_the_factor_to_where_they_are() -> None:
    tilted = replace(candidate(0), spectrum=TARGET.acceleration(PERIODS) * PERIODS)
    at_one = band(0.2, 2.0, weights=[(0.2, 0.0), (0.94, 0.0), (1.0, 1.0), (1.06, 0.0)])
    choice = select([tilted], TARGET, SuiteCriteria(1, at_one)).choices[0]
    assert choice.factor == pytest.approx(1.0, rel=0.01)  # by equal weights 1.58
    assert at_one.weight.max() == 1.0


@pytest.mark.parametrize(
    ("filters", "expected"),
    [
        (CandidateFilters(magnitude=(6.0, 7.0)), {1, 2, 4, 5}),
        (CandidateFilters(distance=(2e4, 3e4)), {1, 2}),
        (CandidateFilters(vs30=(0.0, 1e4)), {0, 2, 4}),
        (CandidateFilters(events=("EVENT 1", "t 5")), {1, 5}),
        (CandidateFilters(duration=(11.0, 20.0)), set()),
    ],
)
def test_filters_keep_what_is_within_both_ends_and_drop_what_is_not_known(
    filters: CandidateFilters, expected: set[int]
) -> None:
    assert {number for number in range(6) if passes(candidate(number), filters)} == expected


def test_scale_limits_and_too_few_records_are_told_with_numbers() -> None:
    many = [candidate(number) for number in range(20)]
    inside = select(many, TARGET, SuiteCriteria(2, BAND, scale_limits=(0.5, 2.0)))
    assert all(0.5 <= choice.factor <= 2.0 for choice in inside.choices)
    with pytest.raises(RecordError, match="21 records wanted; there are 20 components, 20 horizontal at"):
        select(many, TARGET, SuiteCriteria(21, BAND))
    with pytest.raises(RecordError, match="0 within the limits"):
        select(many, TARGET, SuiteCriteria(1, BAND, scale_limits=(1e-9, 2e-9)))


def test_scaling_to_pga_and_as_recorded() -> None:
    many = [candidate(number) for number in range(20)]
    for choice in select(many, TARGET, SuiteCriteria(5, BAND, scale_to="pga")).choices:
        assert choice.factor * choice.components[0].measures["pga"] == pytest.approx(TARGET.pga, rel=1e-12)
    assert {choice.factor for choice in select(many, TARGET, SuiteCriteria(5, BAND, scale_to="none")).choices} == {1.0}


def test_the_order_of_the_catalogue_does_not_matter() -> None:
    many = [candidate(number) for number in range(300)]
    first, again = (select(order, TARGET, SuiteCriteria(7, BAND)) for order in (many, many[::-1]))
    assert {choice.components[0].id for choice in first.choices} == {
        choice.components[0].id for choice in again.choices
    }
    assert first.misfit <= (first.greedy or 0.0)


def test_seven_of_a_thousand_rows_fit_closely() -> None:
    many = [candidate(number) for number in range(1000)]
    assert select(many, TARGET, SuiteCriteria(7, BAND)).misfit < 1e-3


@pytest.mark.parametrize("ends", [(2.0, 0.2), (0.001, 1.0), (0.2, 50.0), (float("nan"), 1.0), (0.1011, 0.1012)])
def test_a_range_of_periods_that_is_none_is_refused(ends: tuple[float, float]) -> None:
    with pytest.raises(RecordError, match="periods"):
        band(*ends)


@pytest.mark.parametrize("weights", [[(0.2, -1.0)], [(0.2, 0.0)], [(1.0, 1.0), (0.5, 1.0)], [(float("nan"), 1.0)]])
def test_weights_that_are_none_are_refused(weights: list[tuple[float, float]]) -> None:
    with pytest.raises(RecordError, match="weights"):
        band(0.2, 2.0, weights=weights)


@pytest.mark.parametrize(
    ("low", "high"), [(0.15, 1.7), (0.2, 2.0), (0.0101, 9.9), (0.01, 10.0), (0.49, 0.52), (0.1, 0.1)]
)
def test_the_band_reaches_from_end_to_end(low: float, high: float) -> None:
    """Between them, half a step and more away, the catalogue's periods; all count alike, as PEER's error has them."""
    found, step = band(low, high), np.log(PERIODS[1] / PERIODS[0])
    assert found.ends == pytest.approx((low, high), rel=1e-12)
    assert set(found.period[1:-1]) <= set(PERIODS)
    gaps = np.diff(np.log(found.period)) / step
    assert np.all((gaps >= 0.5) & (gaps <= 1.5))
    np.testing.assert_array_equal(found.weight, 1.0)
    assert found.nodes[0] <= low * (1 + 1e-12)
    assert found.nodes[-1] >= high * (1 - 1e-12)


def test_between_periods_of_the_catalogue_a_band_has_those_alone() -> None:
    on = band(float(PERIODS[40]), float(PERIODS[80]))
    np.testing.assert_array_equal(on.period, PERIODS[40:81])
    np.testing.assert_array_equal(on.nodes, on.period)


@pytest.mark.parametrize("high", [1.69, 1.7, 1.72, 1.75, 1.77])
def test_a_factor_over_any_band_is_centred_in_it(high: float) -> None:
    """A tilted spectrum against a flat target: by the mean of ln T over the band; to half a step at each end of 44."""
    flat = table_spectrum(np.array([0.0, 10.0]), np.array([1.0, 1.0]))
    (choice,) = select([replace(candidate(0), spectrum=PERIODS)], flat, SuiteCriteria(1, band(0.15, high))).choices
    assert choice.factor == pytest.approx(1 / np.sqrt(0.15 * high), rel=0.015)


@pytest.mark.parametrize(("end", "step"), [(0.15, -1), (1.75, 1)])
def test_what_moves_beyond_an_end_of_the_band_moves_the_fit(end: float, step: int) -> None:
    """A peak at the catalogue's next period outside weighs by how near the end is to it in ln T."""
    flat = replace(candidate(0), spectrum=TARGET.acceleration(PERIODS))
    outside = int(np.searchsorted(PERIODS, end)) + (step - 1) // 2
    peaked = replace(flat, spectrum=np.where(np.arange(121) == outside, np.e, 1.0) * flat.spectrum)
    over = band(0.15, 1.75)
    factors = [select([one], TARGET, SuiteCriteria(1, over)).choices[0].factor for one in (flat, peaked)]
    inside = PERIODS[outside - step]
    share = np.log(inside / end) / np.log(inside / PERIODS[outside])
    assert np.log(factors[0] / factors[1]) == pytest.approx(share / over.period.size, rel=1e-9)
    assert share > 0.4


def test_a_spectrum_that_ends_early_cuts_the_band() -> None:
    assert truncate_band(BAND, 1.0).period[-1] == pytest.approx(1.0)
    assert truncate_band(BAND, 2.0).ends == (0.2, 2.0)
    with pytest.raises(RecordError, match="extend its table"):
        truncate_band(BAND, 0.1)


def test_one_earthquake_by_several_names_is_known_by_its_day() -> None:
    old, new = (
        replace(candidate(n), event=name, date="1940-05-19") for n, name in ((1, "IMPERIAL VALLEY"), (2, "IV-02"))
    )
    assert old.earthquake == new.earthquake
    assert replace(old, date="1940").earthquake == "imperialvalley 1940"
    assert replace(old, date="", event="").earthquake == "file 1.AT2"
    with pytest.raises(RecordError, match="1 of different earthquakes"):
        select([old, new], TARGET, SuiteCriteria(2, BAND))
    assert len(select([old, new], TARGET, SuiteCriteria(2, BAND, one_per_event=False)).choices) == 2


def test_what_stands_in_the_ground_or_a_structure_is_not_chosen() -> None:
    many = [replace(candidate(n), place="borehole" if n else "") for n in range(4)]
    assert [one.components[0].id for one in select(many, TARGET, SuiteCriteria(1, BAND)).choices] == ["0"]


def test_sequence_numbers_of_peer_names() -> None:
    assert sequence_number("a/RSN57_SFERN_ORR021.AT2") == 57
    assert sequence_number("RSN/A-ELC180.AT2") is None
    assert sequence_number("RSN" + "9" * 400 + "_x.AT2") is None


def test_one_motion_in_two_files_is_taken_once() -> None:
    """Whatever the files say of event and station, and scaled: the shape of the spectrum tells."""
    one = candidate(1)
    again = replace(one, path="copy.csv", event="", station="", spectrum=3.0 * one.spectrum, measures={"pga": 1.0})
    for one_per_event in (True, False):
        with pytest.raises(RecordError, match="1 "):
            select([one, again], TARGET, SuiteCriteria(2, BAND, one_per_event=one_per_event))
    assert len(select([one, again, candidate(2)], TARGET, SuiteCriteria(2, BAND)).choices) == 2
