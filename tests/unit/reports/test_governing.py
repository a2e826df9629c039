"""Which result is shown where one stands for many."""

from __future__ import annotations

from dataclasses import replace
from math import pi, sqrt

import pytest
from scipy.constants import g

from assess.codes.check import Outcome, Reason, reason_message
from assess.results import ComparisonRow, ResolvedValue, Results
from reports import governing
from reports.chapters import data_tables
from reports.chapters.cells import BEYOND, OVERTURNED
from reports.chapters.mechanism_verdict import governing_steps
from reports.language.locale import Locale
from reports.render.table_text import equations_line
from tests.support.examples import example_results


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


def test_signed_pages_show_other_codes_where_the_project_lists_its_procedures() -> None:
    church = example_results("chiesa")  # lists none
    every = {check.procedure for each in church.mechanisms for check in each.checks}
    shown = governing.by_own_code(church)
    assert {name for name in every if name.startswith("asce43")}
    assert {check.procedure for each in shown.mechanisms for check in each.checks} == {
        name for name in every if name.startswith("ntc2018")
    }
    listed = replace(church, project={**church.project, "analysis.procedures": ResolvedValue(tuple(every), True)})
    assert governing.by_own_code(listed) is listed
    assert governing.by_own_code(replace(church, verdict=None)).verdict is None


def test_every_step_prints_what_no_step_before_it_gives() -> None:
    """gamma psi by NTC 2018, C7.2.10, from the storeys, the height and that of the building alone."""
    church = example_results("chiesa")
    (line,) = governing_steps(church, church.mechanisms[0])
    steps = {each.split(" = ")[0]: each for each in equations_line(line.steps, Locale(), str).split("; ")}
    shown, _, given = steps["γψ"].partition(" [")
    storeys, place, height = (float(each.split(" = ")[1]) for each in given.rstrip("]").split(", "))
    assert float(shown.split(" = ")[-1]) == pytest.approx(3 * storeys * place / ((2 * storeys + 1) * height), rel=2e-3)
    assert "[" not in steps["a(d_SLV)"]  # of λ, e* and FC, which stand before it


def test_the_number_that_decides_is_redone_from_what_the_page_prints() -> None:
    """By NTC 2018, C8.7.1.2.1.8: from d, a(d), FC and the ordinate alone, to the figures printed."""
    church = example_results("chiesa")
    for mechanism in church.mechanisms[:3]:
        (line,) = governing_steps(church, mechanism)
        steps = (each.partition(" [")[0].split(" = ") for each in equations_line(line.steps, Locale(), str).split("; "))
        shown = {parts[0]: parts[-1] for parts in steps}
        value = {symbol: float(text.split()[0].split("\N{NO-BREAK SPACE}")[0]) for symbol, text in shown.items()}
        assert value["a0*"] == pytest.approx(value["α0"] * g / (value["e*"] * value["FC"]), rel=2e-3)
        assert value["a(d_SLV)"] == pytest.approx(value["λ"] * g / (value["e*"] * value["FC"]), rel=2e-3)
        period = 1.68 * pi * sqrt(value["d_SLV"] / value["a(d_SLV)"])
        assert value["T_SLV"] == pytest.approx(period, rel=2e-3)
        demand = value["S_e(T)"] * (value["T"] / (2 * pi)) ** 2
        assert value["S_De(T)"] == pytest.approx(demand, rel=2e-3)
        assert value["D / d_SLV"] == pytest.approx(
            max(value["S_De(T)"], value.get("d(T_SLV, Z)", 0.0)) / value["d_SLV"], rel=2e-3
        )
