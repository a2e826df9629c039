"""Histories of a study: both polarities, their suites, and the scan over rising PGA."""

from __future__ import annotations

from dataclasses import replace
from math import inf, isinf

import numpy as np
import pytest

from assess.amplification import Unamplified, base_motion
from assess.codes.histories import draw_values, share_upright
from assess.dynamics.history import Jobs, peaks
from assess.oscillator import Oscillator, RockingBlock, plain_branch
from assess.study.histories import SCAN_STEP, run_histories, run_levels, scan_levels, with_governing_trace
from assess.study.level_peaks import TWIN_FACTORS, RockingCase, level_solver, suites_of, with_restitution_factor
from assess.study.study import ScaledRecord
from records.record import make_record
from records.scaling import Scaling

pytestmark = pytest.mark.usefixtures("all_twins")

PGA = 1.0  # of the target [m/s2]
ALONE = {"twin_ratios": (), "twin_times_s": (), "twin_impacts": ()}


LONG = np.minimum(1.0, 8.0 * np.hanning(2500))


def noise(seed: int, envelope: np.ndarray, factor: float = 1.0) -> ScaledRecord:
    smooth = np.convolve(np.random.default_rng(seed).normal(size=envelope.size), np.hanning(15), mode="same") * envelope
    return ScaledRecord(make_record(f"noise {seed}", smooth / np.abs(smooth).max(), 0.01), Scaling(factor, 0.0))


MOTIONS = tuple(noise(seed, np.hanning(900), 1.0 + 0.1 * seed) for seed in range(4))
ONE = plain_branch(RockingBlock(1.0, 2.0, 0.2, 16.0 / 3.0), restitution=0.9)
OTHER = plain_branch(RockingBlock(1.0, 2.0, 0.25, 16.0 / 3.0), restitution=0.9)
SYMMETRIC, UNLIKE = Oscillator(ONE, ONE, 1.0), Oscillator(ONE, OTHER, 1.0)


def rocking_case(oscillator: Oscillator) -> RockingCase:
    return RockingCase("m", oscillator, "exact", tuple(base_motion(Unamplified(), motion.record) for motion in MOTIONS))


def levels_of(oscillator: Oscillator, levels: tuple[float, ...], besides: tuple[float, ...] = ()):
    return run_levels(rocking_case(oscillator), MOTIONS, levels=levels, further=besides, site_pga=PGA, threads=1)


def test_a_body_that_is_the_same_both_ways_needs_one_polarity():
    """Two branches of the same numbers, which are run in both polarities, answer the same."""
    twice = Oscillator(ONE, replace(ONE), 1.0)
    assert SYMMETRIC.symmetric
    assert not twice.symmetric
    levels = (2.2, 3.0, 5.0, 9.0)
    assert levels_of(SYMMETRIC, levels) == levels_of(twice, levels)
    assert scan_levels(rocking_case(SYMMETRIC), MOTIONS, site_pga=PGA, threads=1) == scan_levels(
        rocking_case(twice), MOTIONS, site_pga=PGA, threads=1
    )


def test_of_the_range_of_a_rebound_the_worst_stands():
    """Half, once and one and a half times the rebound, each run by itself as a number that is given."""
    levels, factors = (2.5, 3.5, 5.0, 6.5), (1.0, 0.5, 1.5)
    one_sided = Oscillator(replace(ONE, restitution=0.4), None, 1.0)
    ranged = replace(rocking_case(one_sided), rebounds=factors)
    found = run_levels(ranged, MOTIONS, levels=levels, further=(4.0,), site_pga=PGA, threads=1)
    alone = {f: levels_of(Oscillator(replace(ONE, restitution=0.4 * f), None, 1.0), levels, (4.0,)) for f in factors}
    chosen = set()
    for i, histories in enumerate(found.histories):
        for j, one in enumerate(histories):
            cases = {f: each.histories[i][j] for f, each in alone.items()}
            worst = max(cases, key=lambda f: inf if cases[f].overturned else cases[f].max_rotation_ratio)
            assert replace(one, **ALONE) == replace(cases[worst], rebound=worst, **ALONE)
            each = zip(*(case.twin_ratios for case in cases.values()), strict=True)
            most = [inf if None in run else max(run) for run in each]
            assert [inf if run is None else run for run in one.twin_ratios] == pytest.approx(most, rel=1e-9)
            chosen.add(worst)
    assert len(chosen) > 1
    ratios = zip(*(each.further_suites[0].ratio for each in alone.values()), strict=True)
    assert found.further_suites[0].ratio == tuple(None if None in each else max(each) for each in ratios)
    for record in with_governing_trace(ranged, found.histories, MOTIONS)[-1]:
        if record.trace is not None and not record.overturned:
            assert max(record.trace.rotation_rad) == pytest.approx(record.max_rotation_rad, rel=1e-3)


def test_with_and_without_an_action_that_is_not_shown_to_last_the_worse_stands():
    """Both oscillators run by themselves; ratios are over the rotation that overturns the one without the action."""
    levels = (2.5, 3.0, 3.5, 6.0)
    both = replace(rocking_case(SYMMETRIC), others=(UNLIKE,))
    found = run_levels(both, MOTIONS, levels=levels, further=(), site_pga=PGA, threads=1)
    alone = [levels_of(each, levels).histories for each in (SYMMETRIC, UNLIKE)]
    chosen = set()
    for i, histories in enumerate(found.histories):
        for j, one in enumerate(histories):
            cases = [each[i][j] for each in alone]
            worst = [inf if c.overturned else abs(c.max_rotation_rad) / ONE.overturning for c in cases]
            assert one.variant == int(np.argmax(worst))
            assert one.overturned == isinf(max(worst))
            if not one.overturned:
                assert one.max_rotation_ratio == pytest.approx(max(worst), rel=1e-12)
            chosen.add(one.variant)
    assert chosen == {0, 1}


def test_a_rebound_is_never_above_one():
    assert with_restitution_factor(Oscillator(ONE, None, 1.0), 1.5).positive.restitution == 1.0
    assert with_restitution_factor(Oscillator(ONE, None, 1.0), 0.5).positive.restitution == 0.45


def test_of_two_polarities_the_worse_stands():
    levels = (2.5, 3.0, 3.5, 6.0)
    found = levels_of(UNLIKE, levels)
    assert {one.polarity for level in found.histories for one in level} == {1, -1}
    for level, histories in zip(levels, found.histories, strict=True):
        for number, (motion, one) in enumerate(zip(MOTIONS, histories, strict=True)):
            scale = level / PGA * motion.scaling.factor * np.array([1.0, -1.0])
            jobs = Jobs(np.zeros(2, dtype=np.int64), np.full(2, number), scale)
            both = peaks([UNLIKE], [each.record for each in MOTIONS], jobs, equation="exact")
            assert one.overturned == both.overturned.any()
            if not one.overturned:
                assert one.max_rotation_ratio == both.max_ratio.max()
                assert one.branch == ("negative" if both.max_rotation[both.max_ratio.argmax()] < 0.0 else "positive")


def test_suites_are_of_their_histories():
    found = levels_of(UNLIKE, (2.5, 3.5), besides=(3.0, 6.0))
    assert [suite.pga for suite in (*found.suites, *found.further_suites)] == [2.5, 3.5, 3.0, 6.0]
    for suite, histories in zip(found.suites, found.histories, strict=True):
        assert suite.ratio == tuple(one.max_rotation_ratio for one in histories)
        assert suite.branches == tuple(one.branch for one in histories)
        worst = max(histories, key=lambda one: inf if one.max_rotation_ratio is None else one.max_rotation_ratio)
        assert suite.branch == worst.branch
    assert found.further_suites == levels_of(UNLIKE, (3.0, 6.0)).suites


@pytest.mark.parametrize("body", [SYMMETRIC, UNLIKE], ids=["symmetric", "unlike"])
def test_the_scan_asks_level_by_level_and_ends_where_no_rule_can_hold(body):
    scan = scan_levels(rocking_case(body), MOTIONS, site_pga=PGA, threads=1)
    level = tuple(suite.pga for suite in scan)
    np.testing.assert_allclose(np.diff(np.log(level)), np.log(SCAN_STEP), rtol=1e-9)
    assert [share_upright(suite) < 0.16 for suite in scan] == [False] * (len(scan) - 1) + [True]
    assert scan[0].mean == 0.0  # short of uplift
    assert len(scan) > 40
    assert levels_of(body, level).suites == scan


@pytest.mark.parametrize("body", [SYMMETRIC, UNLIKE], ids=["symmetric", "unlike"])
def test_twins_that_a_scan_leaves_out_change_no_share(body):
    """With all twins at all levels, p of the rule of ASCE 43-05 is the same, and so is where the scan ends."""
    scan = scan_levels(rocking_case(body), MOTIONS, site_pga=PGA, threads=1)
    full = levels_of(body, tuple(suite.pga for suite in scan)).suites
    saved = sum(int((one.twins.ratio != other.twins.ratio).sum()) for one, other in zip(scan, full, strict=True))
    assert saved > 100
    for one, other in zip(scan, full, strict=True):
        holds = [(draw_values(each.runs.ratio).mean(axis=1) <= 0.5).mean() for each in (one, other)]
        assert holds[0] == pytest.approx(holds[1], abs=0.01)


def test_a_scan_runs_the_twins_of_records_that_hardly_rock():
    """Under 25 s of noise: a history of less than a tenth of overturning, with a twin of more than four times that."""
    side = plain_branch(RockingBlock(1.0, 2.0, 0.2, 16.0 / 3.0), restitution=0.98)
    motions = tuple(noise(seed, LONG) for seed in range(40, 60))
    base = tuple(base_motion(Unamplified(), motion.record) for motion in motions)
    scan = scan_levels(RockingCase("m", Oscillator(side, side, 1.0), "exact", base), motions, site_pga=PGA, threads=1)
    ratio = np.concatenate([suite.runs.ratio for suite in scan], axis=1)
    small = ratio[:, (ratio[0] > 0.0) & (ratio[0] < 0.1)]
    assert (small.max(axis=0) > np.maximum(4.0 * small[0], 0.1)).any()


def test_a_twin_is_the_same_record_with_its_pga_times_one_and_a_little():
    """Each twin run by itself, as a record scaled by its factor."""
    (histories,) = levels_of(UNLIKE, (3.5,)).histories
    for place, one in enumerate(histories):
        for factor, ratio in zip(TWIN_FACTORS, one.twin_ratios, strict=True):
            alone = levels_of(UNLIKE, (3.5 * factor,)).histories[0][place].max_rotation_ratio
            assert ratio == (None if alone is None else pytest.approx(alone, rel=1e-6))
    assert sorted(np.round(np.log10(np.abs(TWIN_FACTORS[1:] - 1.0)))) == [-6, -6, -5, -5, -4, -4, -3, -3]


@pytest.mark.parametrize(("restitution", "first"), [(0.95, 30), (0.98, 30)])
def test_a_chaotic_capacity_is_told_as_an_interval_that_covers_its_twins(restitution, first):
    """Bodies that lose little at impacts, under 25 s of noise: each twin of all records, scanned by itself."""
    side = plain_branch(RockingBlock(1.0, 2.0, 0.2, 16.0 / 3.0), restitution=restitution)
    motions = tuple(noise(seed, LONG) for seed in range(first, first + 5))
    base = tuple(base_motion(Unamplified(), motion.record) for motion in motions)
    case = RockingCase("m", Oscillator(side, side, 1.0), "exact", base)
    scan = scan_levels(case, motions, site_pga=PGA, threads=1)
    sure, low = (last_before(scan, share) for share in (0.84, 0.16))
    solve = level_solver(case, motions, site_pga=PGA, threads=1)
    ends = set()
    for factor in TWIN_FACTORS:
        means = [suite.mean for suite in suites_of(solve([suite.pga * factor for suite in scan], "none"))]
        ends.add(scan[next(n for n, mean in enumerate(means) if mean is None or mean > 0.5) - 1].pga)
    assert len(ends) > 1
    assert sure <= min(ends) <= max(ends) <= low


def last_before(scan, share: float) -> float:
    """The PGA before the first at which the mean is within half of overturning in less than a share of the draws."""
    holds = [(draw_values(suite.runs.ratio).mean(axis=1) <= 0.5).mean() for suite in scan]
    return scan[next(n for n, p in enumerate(holds) if p < share) - 1].pga


@pytest.mark.parametrize(
    "change", ["nothing", "oscillator", "equation", "rebounds", "record", "step", "factor", "target"]
)
def test_cases_that_share_what_is_solved_have_each_its_own_histories(change):
    """Of two cases that differ in one thing the second has what it has by itself, and of two alike the same objects."""
    case, motions, site_pga, solved = rocking_case(UNLIKE), list(MOTIONS), PGA, {}
    shared = level_solver(replace(case, solved=solved), motions, site_pga=PGA, threads=1)((3.0, 3.5), "all")
    first = case.base[0]
    record = first.record
    match change:
        case "oscillator":
            case = replace(case, oscillator=Oscillator(OTHER, ONE, 1.0))
        case "equation":
            case = replace(case, equation="linearised")
        case "rebounds":
            case = replace(case, rebounds=(1.0, 0.5))
        case "record":
            turned = replace(first, record=make_record(record.id, record.acceleration[::-1], record.dt))
            case = replace(case, base=(turned, *case.base[1:]))
        case "step":
            slower = replace(first, record=make_record(record.id, record.acceleration, 1.1 * record.dt))
            case = replace(case, base=(slower, *case.base[1:]))
        case "factor":
            motions[0] = replace(motions[0], scaling=Scaling(1.3, 0.0))
        case "target":
            site_pga = 1.1 * PGA
    found = level_solver(replace(case, solved=solved), motions, site_pga=site_pga, threads=1)((3.0, 3.5), "all")
    alone = level_solver(case, motions, site_pga=site_pga, threads=1)((3.0, 3.5), "all")
    assert (found is shared) == (change == "nothing")
    assert (change == "nothing") == np.array_equal(found.peaks.max_ratio, shared.peaks.max_ratio)
    np.testing.assert_array_equal(found.peaks.max_ratio, alone.peaks.max_ratio)


@pytest.mark.parametrize("body", [SYMMETRIC, UNLIKE], ids=["symmetric", "unlike"])
def test_any_number_of_threads_gives_the_same_digits(body):
    runs = [
        run_histories(
            rocking_case(body), MOTIONS, levels=(2.5, 4.0), further=(), site_pga=PGA, with_scan=True, threads=threads
        )
        for threads in (1, 2, 5)
    ]
    for other in runs[1:]:
        assert other == runs[0]
        for one, same in zip(runs[0].scan, other.scan, strict=True):
            assert one.twins.ratio.tobytes() == same.twins.ratio.tobytes()
