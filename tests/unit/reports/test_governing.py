"""Which result is shown where one stands for many."""

from __future__ import annotations

from dataclasses import replace

from assess.codes.check import Outcome, Reason, reason_message
from assess.results import ComparisonRow, Results
from reports import governing
from reports.chapters import data_tables
from reports.chapters.cells import BEYOND, OVERTURNED


def test_overturning_stands_before_every_ratio(results: Results) -> None:
    worst = governing.worst_check(results.mechanisms[1].checks)
    assert worst is not None
    assert (worst.procedure, worst.level_pga_g, worst.demand) == ("asce43-05-history", 0.45, None)


def test_one_check_stands_for_each_procedure(results: Results) -> None:
    for mechanism in results.mechanisms:
        found = governing.worst_per_procedure(mechanism.checks)
        assert len(found) == 5
        assert {check.level_pga_g for check in found if check.verdict != Outcome.NOT_ANSWERED} == {0.45}


def test_the_sites_own_action_is_apart_from_the_levels_of_the_study(results: Results) -> None:
    assert governing.site_pga(results) == 0.067
    assert {check.level_pga_g for check in governing.checks_at_site(results, results.mechanisms[0])} == {0.067}
    assert governing.other_levels(results) == (0.2, 0.45)
    assert governing.other_levels(replace(results, verdict=None)) == (0.067, 0.2, 0.45)


def test_the_overturning_history_governs(results: Results) -> None:
    found = governing.governing_history(results.mechanisms[1])
    assert found is not None
    assert found[0].overturned
    bare = replace(results.mechanisms[1], histories=())
    assert governing.governing_history(bare) is None


def test_what_lies_beyond_the_spectrum_is_not_said_to_overturn(results: Results) -> None:
    """The check fails where its spectrum ends: every place that shows it says so."""
    first, *others = results.mechanisms
    worst = replace(
        first.checks[0],
        level_pga_g=9.0,
        demand=None,
        ratio=None,
        verdict=Outcome.FAIL,
        reason=reason_message(Reason.BEYOND_SPECTRUM),
    )
    row = ComparisonRow(first.name, 9.0, worst.procedure, None, 0.5, None)
    one = replace(first, checks=(*first.checks, worst))
    made = replace(results, mechanisms=(one, *others), comparison=(*results.comparison, row))
    assert not governing.is_overturned(worst)
    lines = (
        next(line for line in data_tables.checks_table(made).rows if line[1] == 9.0),
        next(line for line in data_tables.comparison_table(made).rows if line[1] == 9.0),
    )
    assert all(BEYOND in line and OVERTURNED not in line for line in lines)


def test_damage_is_no_collapse_where_a_procedure_knows_both(results: Results) -> None:
    check = results.mechanisms[0].checks[0]
    damage = replace(check, procedure="ntc2018-linear", limit_state="SLD", capacity_pga_g=0.1)
    life = replace(check, procedure="ntc2018-linear", limit_state="SLV", capacity_pga_g=0.3)
    assert governing.capacities((damage, life)) == {"ntc2018-linear": 0.3}
    assert governing.capacities((damage,)) == {"ntc2018-linear": 0.1}


def test_a_method_that_does_not_apply_has_no_capacity(results: Results) -> None:
    checks = tuple(replace(check, capacity_pga_g=0.2) for check in results.mechanisms[0].checks)
    name = checks[0].procedure
    assert governing.capacities(checks)[name] == 0.2
    silent = tuple(
        replace(check, verdict=Outcome.NOT_APPLICABLE) if check.procedure == name else check for check in checks
    )
    assert name not in governing.capacities(silent)
