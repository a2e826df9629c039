"""What a pass needs besides its numbers, and what the question of a project is."""

from __future__ import annotations

import tomllib
from dataclasses import replace

import numpy as np
import pytest

from assess.codes.question import SOURCES, Missing, merge_missing, methods_of, toml_lines
from assess.geometry.mesh import load_solid
from assess.geometry.solid import profile
from assess.project.build import build
from assess.project.project_file import load
from assess.project.question import facts_of, lowered_pga_conditions, near_fault_conditions, question_of
from assess.project.site_and_structure import site_in, spectrum_of
from assess.study.run import run_study
from spectra.registry import spectrum
from tests.support.mesh_files import obj
from tests.support.projects import NTC, block, lines, project_toml, published, wall
from tests.support.solids import cuboid

SITE = {"limit_state": "SLV", "return_period": 949, "spectrum": NTC}
EXCLUDED = 'disintegration = "excluded"'


def site(*, material="", direct="", of="wall", more="", tabled="", sources="") -> str:
    """A project at a site in Italy, with what a test adds to its tables."""
    return project_toml(
        f"[report.sources]\n{sources}",
        site=SITE,
        materials={"m": f"density = 1800\n{material}"},
        bodies={
            "wall": wall(0.6, 3.0, 6.0, material="m"),
            "roof": f'mass = "1000 kg"\ncentroid = [0.0, 6.1]\ninertia = "10 kg*m^2"\n{direct}',
        },
        mechanisms={
            "wall": lines(block(of, direction=[1, 0, 0]), more),
            "tabled": lines(published(), tabled),
        },
    )


def content(tmp_path, top="", **given):
    file = tmp_path / "project.toml"
    file.write_text(top + site(**given), encoding="utf-8")
    return load(file).content


def facts(tmp_path, name="wall", **given):
    of = content(tmp_path, **given)
    return facts_of(of, question_of(of, site_pga=1.0), (name,))[name]


def test_a_body_of_many_parts_is_one_block_only_where_somebody_vouches_for_it(tmp_path):
    """Twenty-one boxes in a row, a row of houses as well as a wall, are asked about; twenty are not."""
    for number, asked in ((20, 0), (21, 1)):
        row = [cuboid((2.0 * i, 0, 0), (2.0 * i + 1, 1, 3)) for i in range(number)]
        vertices = np.concatenate([each.vertices for each in row])
        triangles = np.concatenate([each.triangles + 8 * i for i, each in enumerate(row)])
        (tmp_path / "row.obj").write_bytes(obj(vertices, triangles))
        of = content(tmp_path)
        solid = load_solid(tmp_path / "row.obj", density=1800.0, name="wall")
        found = facts_of(of, question_of(of, site_pga=1.0), ("wall",), solids={"wall": solid})["wall"][0]
        assert sum(each.why[0].key == "missing-rigid-whole" for each in found) == asked
        vouched = content(tmp_path, sources='"bodies.wall" = "measured: survey of 2024, bonded throughout"')
        found = facts_of(vouched, question_of(vouched, site_pga=1.0), ("wall",), solids={"wall": solid})["wall"][0]
        assert not any(each.why[0].key == "missing-rigid-whole" for each in found)


def keys(found):
    return [each.key for each in found[0]]


@pytest.mark.parametrize(
    ("material", "sources", "missing"),
    [
        ("", "", ["materials.m.disintegration", "report.sources"]),
        ('disintegration = "possible"', "", ["materials.m.disintegration"]),
        (EXCLUDED, "", ["report.sources"]),
        (EXCLUDED, '"materials.m" = "assumed: it looks sound"', ["report.sources"]),
        (EXCLUDED, '"materials.m" = "measured: …, by whom and when"', ["report.sources"]),
        (EXCLUDED, '"materials.m" = "measured: ..."', ["report.sources"]),
        (EXCLUDED, '"materials.m.disintegration" = "measured: quality index"', []),
        (EXCLUDED, '"materials.m" = "measured: survey"', []),
    ],
)
def test_an_italian_pass_needs_sound_masonry_shown(tmp_path, material, sources, missing):
    assert keys(facts(tmp_path, material=material, sources=sources)) == missing


@pytest.mark.parametrize(
    ("procedures", "missing"),
    [
        (["ntc2018-nonlinear"], ["materials.m.disintegration", "report.sources"]),
        (["ec8-element", "dmi2008-linear"], ["materials.m.disintegration", "report.sources"]),
        (["ec8-element", "asce43-05-history"], []),
    ],
)
def test_premises_go_with_the_procedures_of_a_basis_of_the_engineer(tmp_path, procedures, missing):
    top = f'[verdict]\nbasis = "own"\nprocedures = {procedures}\nrule = "any"\nstatement = "ours"\n'
    of = content(tmp_path, top=top.replace("'", '"'))
    assert keys(facts_of(of, question_of(of, site_pga=1.0), ("wall",))["wall"]) == missing


@pytest.mark.parametrize(
    ("procedures", "rule", "conditions"),
    [
        (["sliding", "ec8-element"], "any", ["one-of-several"]),
        (["sliding", "ec8-element"], "all", []),
        (["sliding"], "any", ["sliding-alone"]),
        (["ec8-element"], "any", []),
    ],
)
def test_a_basis_of_the_engineer_says_what_its_pass_leaves_out(tmp_path, procedures, rule, conditions):
    top = f'[verdict]\nbasis = "own"\nprocedures = {procedures}\nrule = "{rule}"\nstatement = "ours"\n'
    of = content(tmp_path, top=top.replace("'", '"'))
    found = facts_of(of, question_of(of, site_pga=1.0), ("wall",))["wall"][1]
    assert [each.key for each in found if not each.key.startswith("premise-")] == conditions


def test_masonry_without_a_material_says_it_in_its_own_table(tmp_path):
    assert keys(facts(tmp_path, "tabled")) == ["mechanisms.tabled.disintegration", "report.sources"]
    assert keys(facts(tmp_path, of="roof")) == ["bodies.roof.disintegration", "report.sources"]
    shown = '"mechanisms.tabled.disintegration" = "literature: a table"'
    assert keys(facts(tmp_path, "tabled", tabled=EXCLUDED, sources=shown)) == []


def test_a_thrust_that_ties_are_said_to_take_is_a_condition(tmp_path):
    load = 'loads = [{ kind = "body", body = "roof", role = "roof", tied = true, at = [0.0, 6.0], bearing = true }]'
    conditions = facts(tmp_path, more=load)[1]
    assert [(each.key, each.values) for each in conditions] == [("thrust-is-tied", {"what": "roof"})]


def test_an_anchorage_that_is_computed_is_a_condition(tmp_path):
    plate = 'plate = { width = "0.3 m", height = "0.3 m" }'
    tie = f'kind = "tie", at = [0.2, 0, 5], anchor = [-9.8, 0, 5], length = "10 m", fracture_strain = 0.1, {plate}'
    bar = 'area = "314 mm^2", young_modulus = "210 GPa", yield_stress = "235 MPa"'
    conditions = facts(tmp_path, more=f"loads = [{{ {tie}, {bar} }}, {{ {tie.replace('0, 5]', '2, 5]')}, {bar} }}]")[1]
    told = [(each.key, each.values) for each in conditions]
    assert told == [("anchorage-computed", {"what": "tie 1, tie 2"}), ("units-slide", {"what": "tie 1, tie 2"})]
    units = tie.replace("height =", 'course = "0.15 m", overlap = "0.1 m", height =')
    conditions = facts(tmp_path, more=f"loads = [{{ {units}, {bar} }}]")[1]
    assert [each.key for each in conditions] == ["anchorage-computed"]


@pytest.mark.parametrize(
    ("more", "rise", "told"),
    [
        ("", 2.0, ["slope-as-beam"]),
        ("", 0.0, []),  # flat
        ('thrust = "1 kN"', 2.0, []),
        ("tied = true", 2.0, ["thrust-is-tied"]),
    ],
)
def test_a_slope_by_itself_passes_on_the_condition_that_its_upper_end_is_carried(tmp_path, more, rise, told):
    """Of a couple of rafters without a ridge beam, drawn as two slabs, each looks like a beam."""
    keys_of_load = ", ".join(each for each in ('kind = "body", body = "roof", role = "roof"', more) if each)
    of = content(tmp_path, more=f"loads = [{{ {keys_of_load} }}]")
    outline = [(0.0, 0.0), (4.0, rise), (4.0, rise + 0.2), (0.0, 0.2)]
    slab = profile(outline, length=5.0, density=500.0, name="roof")
    question = question_of(of, site_pga=1.0)
    for direction, expected in (((1, 0, 0), told), ((0, 1, 0), [key for key in told if key != "slope-as-beam"])):
        section = of.mechanisms["wall"].model_copy(update={"direction": direction})
        turned = of.model_copy(update={"mechanisms": {**of.mechanisms, "wall": section}})
        conditions = facts_of(turned, question, ("wall",), solids={"roof": slab})["wall"][1]
        assert [each.key for each in conditions if "slope" in each.key or "thrust" in each.key] == expected


def test_the_methods_that_may_decide_run_whatever_the_analysis_lists(tmp_path):
    of = content(tmp_path, top='[verdict]\nprocedures = ["ntc2018-history"]\n')
    assert methods_of(question_of(of, site_pga=1.0)) == ("ntc2018-history", "ntc2018-linear")


@pytest.mark.parametrize(("pga", "lowers"), [("", False), ('pga = "0.05 g"', True), ('pga = "0.4 g"', False)])
def test_a_pga_below_that_of_a_single_spectrum_is_a_condition_of_a_pass(tmp_path, pga, lowers):
    file = tmp_path / "project.toml"
    file.write_text(site().replace("[site]\n", f"[site]\n{pga}\n"), encoding="utf-8")
    of = load(file).content
    assert [each.key for each in lowered_pga_conditions(of, spectrum_of(site_in(of)))] == (
        ["pga-lowered"] if lowers else []
    )


def test_the_sources_of_several_materials_are_all_asked_for():
    asked = [Missing(SOURCES, "of a", '"materials.a.disintegration" = "x"'), Missing(SOURCES, "of b", '"b" = "x"')]
    lines = toml_lines(merge_missing(asked), ["report.language", "site.spectrum.code"])
    assert lines == ("[report.sources]", '"materials.a.disintegration" = "x"', '"b" = "x"')
    tomllib.loads("\n".join(lines))


def test_a_table_that_may_have_no_heading_of_its_own_is_marked_so():
    """`[site.spectrum]` alone has no `[site]`; a key right under it has."""
    asked = [Missing("site.limit_state", "why", 'limit_state = "ULS"')]
    remark = "[site]  # where this heading is in your file already, add below it"
    assert toml_lines(asked, ["site.spectrum.code"])[0] == remark
    assert toml_lines(asked, ["site.pga"])[0].endswith("# in your file already: add below it")


SURVEYED = '"mechanisms.wall.loads[1]" = "measured: survey"'


@pytest.mark.parametrize(("tied", "conditions"), [(False, []), (True, ["counts-at-rest"])])
def test_a_linear_pass_says_that_it_counts_ties_nobody_shows_to_last(tmp_path, tied, conditions):
    tie = 'sides = "one"\nloads = [{ kind = "tie", at = [-0.2, 5.8], anchor = [-6.0, 5.8], force = "20 kN" }]'
    file = tmp_path / "project.toml"
    given = {"more": tie, "sources": SURVEYED} if tied else {}
    file.write_text('[verdict]\nprocedures = ["ntc2018-linear"]\n' + site(**given), encoding="utf-8")
    study = build(load(file))
    spectrum = replace(study.spectrum, factor=0.1 * study.spectrum.factor)
    alone = replace(study, spectrum=spectrum, levels=(spectrum.pga,), procedures=("ntc2018-linear",))
    results = run_study(alone, jobs=1)
    checks = [c for c in results.mechanisms[0].checks if c.procedure == "ntc2018-linear" and c.limit_state == "SLV"]
    assert [each.key for each in checks[0].conditions] == conditions


def test_all_that_is_missing_is_listed_at_once(tmp_path):
    """Too few records, and the ground's motion upstairs: both keys in one run."""
    file = tmp_path / "project.toml"
    top = '[verdict]\nprocedures = ["ntc2018-history"]\n[building]\nground_elevation = -6.0\nuse_class = "II"\n'
    top += '[records]\nsynthetic = { count = 3, seed = 1, duration = "25 s" }\n'
    file.write_text(top + site(), encoding="utf-8")
    found = run_study(build(load(file)), jobs=1).verdict
    missing = {each.key for one in found.mechanisms if one.mechanism == "wall" for each in one.missing}
    assert {"mechanisms.wall.amplification", "records.synthetic", "materials.m.disintegration"} <= missing


def test_a_spectrum_of_ts_1170_5_passes_on_the_condition_that_no_fault_is_near() -> None:
    typed = spectrum("ts1170.5", pga_site=1.8, s_as=3.8, t_c=0.52, t_d=2.8)
    assert [each.key for each in near_fault_conditions(typed)] == ["premise-near-fault"]
    assert not [*near_fault_conditions(replace(typed, warnings=()))]
