"""The list of assumptions: what is measured, taken from literature, assumed, given or a default."""

from __future__ import annotations

from dataclasses import replace

from assess.results import Resolved, Results
from reports.chapters import assumptions, inputs


def listed(results: Results, project: dict[str, Resolved]) -> list[tuple[object, ...]]:
    return [tuple(row) for row in assumptions.table(replace(results, project=project)).rows]


def test_the_longest_key_of_the_sources_holds(results: Results) -> None:
    rows = listed(
        results,
        {
            "materials.stone.density": Resolved(2100.0, True),
            "materials.stone.friction": Resolved(0.6, True),
            "materials.stonework.density": Resolved(1900.0, True),
            "report.sources.materials.stone": Resolved("assumed: by eye", True),
            "report.sources.materials.stone.density": Resolved("measured: three cores", True),
        },
    )
    assert rows == [
        ("materials.stone.density", 2100.0, "measured", "three cores", ""),
        ("materials.stone.friction", 0.6, "assumed", "by eye", ""),
        ("materials.stonework.density", 1900.0, assumptions.NOT_SAID, "", ""),
    ]


def test_mechanisms_alike_share_a_line(results: Results) -> None:
    names = [mechanism.name for mechanism in results.mechanisms]
    alike = {f"mechanisms.{name}.sides": Resolved("two", False) for name in names}
    other = {f"mechanisms.{names[0]}.restitution.positive": Resolved(0.9, True)}
    assert listed(results, alike | other) == [
        ("mechanisms.*.sides", "two", "default", "", "every mechanism"),
        ("mechanisms.*.restitution.positive", 0.9, assumptions.NOT_SAID, "", names[0]),
    ]


def test_what_is_absent_or_a_title_is_no_assumption(results: Results) -> None:
    absent = {"materials.stone.friction": Resolved(None, False), "title": Resolved("A tower", True)}
    assert listed(results, absent) == []


def test_a_long_list_of_tables_has_a_line_for_each_and_no_value_is_cut(results: Results) -> None:
    rows = [{"return_period": 30.0 + place, "a_g": 0.77472535, "f_0": None} for place in range(40)]
    found = replace(results, project={**results.project, "site.spectrum.hazard": Resolved(rows, True)})
    for table in (inputs.values(found), assumptions.table(found)):
        lines = {row[0]: row[1] for row in table.rows}
        assert lines["site.spectrum.hazard[40]"] == '{"return_period": 69.0, "a_g": 0.77472535}'
        assert "site.spectrum.hazard" not in lines
