"""The chapter on the site: the action and its parameters, what is combined, the records."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import pytest

from assess.results import GroundMotionResult, RequirementResult, ResolvedValue, Results
from reports.chapters import site, suite
from reports.document import OutcomeCell, Table
from reports.language.locale import Locale
from tests.support.letters import lines_of, prose
from tests.support.sample_results import with_project, with_verdict

EN = Locale()


def rule(verdict: Literal["met", "not met", "not answered"], *, code: str = "ASCE 43-05") -> RequirementResult:
    return RequirementResult(code, "2.4", "largest time step", 0.02, "<=", 0.01, "s", verdict, None, None, "", "")


def with_rules(results: Results, *rules: RequirementResult) -> Results:
    curve = (0.1, 0.2)
    motion = GroundMotionResult(0.1, 2.0, "given", (), curve, curve, curve, curve, 0.01, None, rules)
    return replace(results, ground_motion=motion)


def test_parameters_have_their_units_and_sources(results: Results) -> None:
    assert results.spectrum is not None
    project = {
        **results.project,
        "site.spectrum.s_ds": ResolvedValue(1.6377, True),
        "site.spectrum.s_d1": ResolvedValue(0.51975, True),
        "site.spectrum.damping": ResolvedValue(0.05, False),
        "report.sources.site.spectrum": ResolvedValue("literature: <b>a study</b>", True),
    }
    table = site.parameters_table(replace(results, project=project), results.spectrum)
    rows = {lines_of([row[0]]): lines_of(row[1:]) for row in table.rows}  # type: ignore[list-item, arg-type]  all are texts
    assert rows["S_DS, design, at short periods"] == "0.167 g\nliterature: <b>a study</b>"
    assert rows["S_D1, design, at 1 s"] == "0.053 g\nas above"
    assert rows["Damping ratio"] == "0.05\ndefault"
    assert "T_L, long-period transition" not in rows
    calculated = site.calculated_parameters_table(replace(results, project=project), results.spectrum)
    cells = [lines_of([cell]) for row in calculated.rows for cell in row]  # type: ignore[list-item]  all are texts
    assert cells[cells.index("T_L, long-period transition") + 1] == "6 s"
    assert {len(row) for row in calculated.rows} == {2 * site.PAIRS_IN_ROW}


def test_a_hazard_over_return_periods_is_tabulated_in_g(results: Results) -> None:
    assert not site.hazard_table(results).rows
    row = {"return_period": 475.0, "a_g": 1.5690640, "f_0": 2.45, "t_c_star": 0.33}
    project = {**results.project, "site.spectrum.hazard": ResolvedValue([row], True)}
    assert site.hazard_table(replace(results, project=project)).rows == ((475.0, pytest.approx(0.16), 2.45, 0.33),)
    named = {**results.project, "site.spectrum.hazard": ResolvedValue("design", False)}
    assert not site.hazard_table(replace(results, project=named)).rows


def test_no_spectrum_and_no_records_are_told(results: Results) -> None:
    bare = replace(results, spectrum=None, records=())
    assert [EN.text(section.title) for section in site.sections(bare)] == ["Site and action", "Combination of actions"]
    assert "The project gives no spectrum of the site." in prose(*site.sections(bare))


def test_the_combination_is_that_of_the_basis(results: Results) -> None:
    assert "ψ₂" not in prose(*site.sections(results))
    italian = with_verdict(results, basis="ntc2018")
    assert "Combination: E + G₁ + G₂ + P + Σ ψ₂ Q" in prose(*site.sections(italian))
    assert "NTC 2018, eq. 2.5.5" in prose(*site.sections(italian))


def test_vertical_motion_is_told_either_way(results: Results) -> None:
    assert "No vertical ground motion is applied." in prose(*site.sections(results))
    shaken = with_project(results, site__vertical_ratio=ResolvedValue(0.67, True))
    assert "vertical ground motion of 0.67 times the horizontal one" in prose(*site.sections(shaken))


def test_loads_that_are_alike_share_a_row(results: Results) -> None:
    wall, parapet = results.mechanisms
    both = replace(results, mechanisms=(replace(wall, loads=parapet.loads[:1]), parapet))
    rows = site.loads_table(both).rows
    assert [lines_of([row[0], row[1], row[2]]) for row in rows] == [  # type: ignore[list-item]  all are texts
        "floor <beam>\nM1 and M2\nweight and mass",
        "=cmd()\nM2\nforce",
    ]
    assert rows[1][4:] == (8250.5, -120.0)
    bare = replace(results, mechanisms=(wall,))
    assert not site.loads_table(bare).rows
    assert "The project gives no other loads" in prose(*site.sections(bare))
    block = replace(bare, mechanisms=(replace(wall, kind="equivalent-block"),))
    assert "The project gives no other loads" not in prose(*site.sections(block))
    assert "Loads on equivalent blocks are part of their rocking parameters" in prose(*site.sections(block))


def test_artificial_records_share_a_row_and_recorded_ones_do_not(results: Results) -> None:
    recorded = replace(results.records[0], path="a.AT2", event="Friuli", date="1976-05-06", component="NS")
    rows = suite.suite_records_table(replace(results, records=(*results.records, recorded))).rows
    assert len(rows) == 2
    assert lines_of([rows[0][1]]) == "Friuli 1976"  # type: ignore[list-item]  a text
    assert lines_of([rows[1][0]]) == "5 artificial records"  # type: ignore[list-item]  a text
    assert lines_of([rows[1][4]]) == "1.01 to 1.05"  # type: ignore[list-item]  a text


def test_the_suite_is_judged_by_the_rules_of_the_basis_alone(results: Results) -> None:
    met = with_rules(results, rule("met"), rule("not met", code="NTC 2018"))
    assert lines_of(suite.suite_sentences(met)).endswith("The suite meets the one requirement of ASCE 43-05 on suites.")
    missed = with_rules(results, rule("met"), rule("not met"))
    assert lines_of(suite.suite_sentences(missed)).endswith(
        "The suite does not meet these requirements of ASCE 43-05: largest time step."
    )
    silent = with_rules(results, rule("not answered"))
    assert "These requirements of ASCE 43-05 could not be checked: largest time step." in lines_of(
        suite.suite_sentences(silent)
    )
    table = suite.basis_requirements_table(missed)
    assert [row[-1].outcome for row in table.rows if isinstance(row[-1], OutcomeCell)] == ["pass", "fail"]
    assert lines_of([table.rows[0][3]]) == "≤ 0.01 s"  # type: ignore[list-item]  a text


def test_tables_have_as_many_cells_as_columns(results: Results) -> None:
    sections = site.sections(with_rules(results, rule("not answered")))
    tables = [block for section in sections for block in section.blocks if isinstance(block, Table)]
    assert {table.name for table in tables} == {"site", "calculated", "actions", "suite-rules"}
    assert all(len(row) == len(table.columns) for table in tables for row in table.rows)
