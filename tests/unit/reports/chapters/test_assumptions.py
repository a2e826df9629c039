"""Each value has the source that the project states for it, and nothing assumed is hidden."""

from __future__ import annotations

from dataclasses import replace

from assess.results import ResolvedValue, Results
from reports.chapters import assumptions, site
from reports.language.texts import Reference, say
from reports.language.value_names import PARAMETER_NAMES
from tests.support.letters import letters, lines, rows
from tests.support.sample_results import with_mechanisms, with_project


def given(value: object, kind: str = "") -> ResolvedValue:
    return ResolvedValue(value, True, {"": kind} if kind else {})


def test_the_longest_key_of_the_sources_counts(results: Results) -> None:
    made = with_project(
        results,
        instead=True,
        materials__stone__density=given(2000.0, "density"),
        materials__stone__friction=given(0.6),
        report__sources__materials__stone=given("literature: handbook"),
        report__sources__materials__stone__friction=given("assumed: as usual"),
    )
    stated = {
        key: assumptions.value_source(made, key, made.project[key])
        for key in ("materials.stone.density", "materials.stone.friction")
    }
    assert stated["materials.stone.density"] == assumptions.ValueSource("literature", "handbook")
    assert stated["materials.stone.friction"] == assumptions.ValueSource("assumed", "as usual")
    assert ["stone: friction", "0.6", "assumed: as usual", "–"] in rows(assumptions.assumptions_table(made))
    assert ["stone: all properties", "literature", "handbook", "–"] in rows(assumptions.sources_table(made))


def test_a_key_does_not_cover_another_that_begins_alike(results: Results) -> None:
    made = with_project(
        results,
        instead=True,
        materials__stone2__friction=given(0.6),
        report__sources__materials__stone=given("measured: core"),
    )
    found = assumptions.value_source(made, "materials.stone2.friction", made.project["materials.stone2.friction"])
    assert found.kind == assumptions.UNSTATED
    assert "The project states no source for: stone2: friction." in lines(assumptions.sections(made))


def test_defaults_follow_what_the_engineer_assumed_in_grey(results: Results) -> None:
    made = with_project(
        results,
        instead=True,
        site__vertical_ratio=ResolvedValue(0.0, False),
        building__storeys=given(4),
        report__sources__building__storeys=given("assumed: by its windows"),
    )
    table = assumptions.assumptions_table(made)
    assert [row[0] for row in rows(table)] == ["Number of storeys", "Vertical over horizontal spectrum"]
    assert table.muted == {1}


def test_a_value_of_several_mechanisms_has_one_row(results: Results) -> None:
    keys = [f"mechanisms.{each.name}.interface.model" for each in results.mechanisms]
    made = replace(results, project=dict.fromkeys(keys, ResolvedValue("rigid", False)))
    assert rows(assumptions.assumptions_table(made)) == [
        ["Model of the joints", "rigid", "default of the program", "all mechanisms"]
    ]


def test_defaults_of_a_code_that_answered_nothing_do_not_matter(results: Results) -> None:
    made = with_project(
        results,
        instead=True,
        procedures__nzsee2017__masonry=ResolvedValue("rubble", False),
        procedures__dmi2008__confidence_factor=ResolvedValue(1.0, False),
    )
    assert [row[0] for row in rows(assumptions.assumptions_table(made))] == ["Confidence factor"]


def test_materials_are_in_words_without_empty_columns(results: Results) -> None:
    made = with_project(
        results,
        instead=True,
        materials__stone__density=given(2240.0, "density"),
        materials__stone__young_modulus=given(6.89e9, "stress"),
        materials__stone__friction=ResolvedValue(None, False),
    )
    table = assumptions.materials_table(made)
    assert rows(table) == [["stone", "2240 kg/m³", "6.89 GPa"]]
    assert [letters(column.label) for column in table.columns] == ["Material", "Density", "Young’s modulus E"]


def test_the_quality_of_the_masonry_is_told(results: Results) -> None:
    made = with_project(results, instead=True, masonry_quality=given("squared stone\n"))
    assert "Quality of the masonry: squared stone" in lines(assumptions.sections(made))


def test_a_project_that_assumes_nothing_says_so(results: Results) -> None:
    assert any(
        "No value is marked as assumed" in line
        for line in lines(assumptions.sections(with_project(results, instead=True)))
    )


HAZARD = [{"return_period": years, "a_g": 1.0, "f_0": 2.4, "t_c_star": 0.3} for years in (30.0, 475.0, 2475.0)]


def test_a_list_of_tables_is_one_row(results: Results) -> None:
    source = given("assumed: like the next town")
    made = with_project(
        results, instead=True, site__spectrum__hazard=given(HAZARD), report__sources__site__spectrum__hazard=source
    )
    ((name, where, stated, _),) = assumptions.assumptions_table(made).rows
    assert [name, where] == [PARAMETER_NAMES["hazard"][0], say("see {table}", table=Reference("Table", "hazard"))]
    assert letters(stated) == "assumed: like the next town"
    assert site.hazard_table(made).rows


def test_loads_that_no_table_shows_are_counted(results: Results) -> None:
    bare = with_mechanisms(results, loads=())
    key = f"mechanisms.{results.mechanisms[0].name}.loads"
    project = {key: given([{"kind": "mass"}]), f"report.sources.{key}": given("assumed: as usual")}
    assert rows(assumptions.assumptions_table(replace(bare, project=project))) == [
        ["Loads", "1 set of values", "assumed: as usual", "M1"]
    ]


def test_a_list_of_tables_that_no_table_shows_is_counted(results: Results) -> None:
    made = with_project(
        results,
        instead=True,
        site__layers=given([{"depth": 1.0}] * 2),
        report__sources__site=given("assumed: as there"),
    )
    assert rows(assumptions.assumptions_table(made)) == [["layers", "2 sets of values", "assumed: as there", "–"]]


def test_a_parameter_of_the_spectrum_has_its_name(results: Results) -> None:
    source = given("assumed: by the map")
    made = with_project(
        results, instead=True, site__spectrum__soil=given("B"), report__sources__site__spectrum__soil=source
    )
    assert rows(assumptions.assumptions_table(made)) == [["subsoil category", "B", "assumed: by the map", "–"]]
