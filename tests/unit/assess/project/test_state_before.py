"""The state before the works: matched by name, refused where its hazard is another, and the works that follow."""

from __future__ import annotations

import hashlib
import json
import shutil
from pathlib import Path

import pytest

import assess
from assess.errors import ProjectError
from assess.messages.message import Severity
from assess.outputs.manifest import RESULTS
from assess.project.build import build_to_decide
from assess.project.project_file import load
from assess.project.same_building import differences_since_before, works_shown
from assess.results import Input, ResolvedValue
from assess.results.before import state_of
from assess.results.json import dumps, loads
from assess.study.run import find_outcome
from tests.support.command import ended
from tests.support.facade import folder, variant, with_ties, write_listed
from tests.support.projects import replace_once

BEFORE = 'before = "project-results/results.json"'
WORKS = 'works = "improvement"'
SOURCES, BY_WORD = "[report.sources]", '"verdict.before" = "measured: own run of March (example)"'


def question_of(path: Path, **more):
    return build_to_decide(load(path, **more)).question


def test_the_state_before_is_that_of_its_own_results():
    before = state_of(loads((folder() / "project-results" / RESULTS).read_text(encoding="utf-8")))
    found = with_ties().before
    assert before is not None
    assert found is not None
    assert found.path == "project-results/results.json"
    assert (found.mechanisms, found.index, found.weakest) == (before.mechanisms, before.index, "facade")


def test_results_with_a_state_before_are_read_back_as_they_were_written():
    assert loads(dumps(with_ties())) == with_ties()


def test_the_target_is_a_tenth_above_the_index_before_and_the_weakest_is_another():
    results = with_ties()
    before, after = results.before, state_of(results)
    assert results.verdict is not None
    assert before is not None
    assert after is not None
    assert results.verdict.target == pytest.approx(before.of("facade").index.value + 0.10, rel=1e-12)
    assert (before.weakest, after.weakest) == ("facade", "gable")
    assert before.of("gable").index == after.of("gable").index  # nothing of it changed
    assert after.of("facade").capacity_pga_g > before.of("facade").capacity_pga_g
    assert before.of("facade").return_period_years < 475.0 < after.of("gable").return_period_years


def test_the_files_before_are_among_the_inputs_and_their_stamp_is_kept():
    results = with_ties()
    assert results.before is not None
    assert results.before.stamp
    assert "project-results/results.json" in {each.path for each in results.inputs}


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ('soil = "B"', 'soil = "C"', "soil of the spectrum: B there and C in this project"),
        ('topography = "T1"', 'topography = "T2"', "topography of the spectrum: T1 there and T2"),
        ('a_g = "0.188 g"', 'a_g = "0.189 g"', "a_g of the spectrum: 1.84302 there and 1.85282"),
        ('a_g = "0.325 g"', 'a_g = "0.326 g"', "site.spectrum.hazard[7].a_g in SI: 3.18716 there and 3.19697"),
        ("nominal_life = 50", "nominal_life = 100", "return period of the action [years]: 474.561 there and 949.122"),
        ('limit_state = "SLV"', 'limit_state = "SLC"', "limit states that decide: SLV there and SLC"),
        ('basis = "ntc2018"', 'basis = "dmi2008"', "basis: ntc2018 there and dmi2008"),
    ],
)
def test_a_state_by_another_hazard_is_refused_with_the_number_that_differs(old, new, told):
    with pytest.raises(ProjectError) as refused:
        question_of(variant("other-hazard", **{old: new}))
    assert told in str(refused.value)
    assert "verdict.before: project-results/results.json" in str(refused.value)


def test_another_density_is_no_other_hazard():
    path = variant("denser", **{'density = "2000 kg/m^3"': 'density = "2100 kg/m^3"'})
    assert question_of(path).before.indices["facade"] == with_ties().before.of("facade").index.value


def test_works_are_local_where_a_state_before_is_known_and_a_tie_is_new():
    unsaid = {WORKS: ""}
    assert question_of(variant("unsaid", **unsaid)).works == "local"
    assert question_of(variant("measured", **unsaid, **{BEFORE: "index_before = 0.5"})).works == "local"
    assert question_of(variant("alone", **unsaid, **{BEFORE: ""})).works == "none"
    assert question_of(folder() / "project.toml", before=folder() / "project-results" / RESULTS).works == "none"
    assert question_of(folder() / "with-ties.toml").works == "improvement"


def test_ties_that_were_there_before_are_not_new(tmp_path):
    old = tmp_path / RESULTS
    write_listed(old, dumps(with_ties()))
    assert question_of(variant("again", **{WORKS: ""}), before=old).works == "none"


def test_an_index_typed_beside_the_results_is_refused():
    with pytest.raises(ProjectError, match=r"index_before.*beside before"):
        load(variant("both", **{BEFORE: f"{BEFORE}\nindex_before = 0.5"}))


def test_results_named_at_the_door_win_over_those_of_the_file(tmp_path):
    other = tmp_path / "other.json"
    shutil.copy(folder() / "project-results" / RESULTS, other)
    project = assess.load(variant("elsewhere", **{BEFORE: ""}), before=other)
    assert project.content.verdict.before == other
    assert question_of(project.path, before=other).before.index == pytest.approx(with_ties().before.index.value)


def test_the_command_line_names_the_state_before(capsys, tmp_path):
    project = variant("by-option", **{BEFORE: ""})
    results = folder() / "project-results" / RESULTS
    assert ended("run", project, "--before", results, "--no-report", "-o", tmp_path / "out") == 0
    assert "before: fail, at most zeta_E 0.809; weakest: facade" in capsys.readouterr().out
    assert ended("run", project, "--before", tmp_path / "none.json", "-o", tmp_path / "out2") == 2


def test_results_whose_parts_do_not_fit_are_refused(tmp_path):
    tree = json.loads((folder() / "project-results" / RESULTS).read_text(encoding="utf-8"))
    tree["project"]["site.spectrum.hazard"]["value"] = 5
    (tmp_path / "odd.json").write_text(json.dumps(tree), encoding="utf-8")
    with pytest.raises(ProjectError, match=r"verdict\.before.*do not fit together"):
        question_of(folder() / "with-ties.toml", before=tmp_path / "odd.json")


def test_results_that_were_changed_since_they_were_written_are_refused(tmp_path):
    made = tmp_path / "facade"
    shutil.copytree(folder(), made)
    run = assess.load(made / "project.toml")
    assess.write_report(assess.Run(run, loads((made / "project-results" / RESULTS).read_text())), made / "whole")
    written = made / "whole" / RESULTS
    tree = json.loads(written.read_text(encoding="utf-8"))
    tree["verdict"]["mechanisms"][0]["answers"][0]["index"]["value"] = 0.1
    written.write_text(json.dumps(tree), encoding="utf-8")
    with pytest.raises(ProjectError, match="changed since it was written"):
        question_of(made / "with-ties.toml", before=written)


def test_results_that_no_list_vouches_for_carry_no_pass_without_a_source(tmp_path):
    alone = tmp_path / RESULTS
    shutil.copy(folder() / "project-results" / RESULTS, alone)
    open_, vouched = folder() / "with-ties.toml", variant("by-word", **{SOURCES: f"{SOURCES}\n{BY_WORD}"})
    found = find_outcome(build_to_decide(load(open_, before=alone)))
    assert (found.outcome, found.provisional) == ("incomplete", "incomplete")
    assert [(each.key, each.toml) for each in found.missing] == [("report.sources", '"verdict.before" = "measured: …"')]
    assert "keep the folder of that run together" in found.missing[0].text
    found = find_outcome(build_to_decide(load(vouched, before=alone)))
    assert found.outcome == "pass"
    assert "unlisted-by-source" in {each.key for each in found.conditions}
    assert find_outcome(build_to_decide(load(open_))).outcome == "pass"


@pytest.mark.parametrize("number", ["index", "capacity_pga_g", "safety_index"])
def test_results_whose_numbers_contradict_one_another_are_refused(tmp_path, number):
    """The index is the PGA at capacity over that of the action, so that either cannot be lowered alone."""
    tree = json.loads((folder() / "project-results" / RESULTS).read_text(encoding="utf-8"))
    if number == "index":
        tree["verdict"]["mechanisms"][0]["answers"][0]["index"]["value"] = 0.3
    for check in tree["mechanisms"][0]["checks"]:
        if number in check and check["role"] == "deciding":
            check[number] = 0.03
    write_listed(tmp_path / RESULTS, json.dumps(tree))
    with pytest.raises(ProjectError, match=r"index of facade: 0\.\d+ in its verdict and 0\.\d+ by its checks"):
        question_of(folder() / "with-ties.toml", before=tmp_path / RESULTS)


def test_the_example_and_the_condition_of_its_pass_name_its_two_ties():
    assert "the same wall with two ties" in (folder() / "project.toml").read_text(encoding="utf-8")
    (ends,) = (each.text for each in with_ties().verdict.conditions if each.key == "holds-to-its-end")
    assert ends.startswith("a pass is valid only if each of these acts in full")
    assert ends.endswith(": tie 1, tie 2")


def test_a_tie_is_the_works_and_no_other_value_differs():
    before, warnings = with_ties().before, with_ties().warnings
    assert [(each.key, each.where) for each in before.differences] == [
        ("tie-new", "mechanisms.facade.loads[1]"),
        ("tie-new", "mechanisms.facade.loads[2]"),
    ]
    assert set(before.differences) <= set(warnings)
    assert "same-building" not in {each.key for each in with_ties().verdict.conditions}


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("length = 0.50", "length = 0.55", "bodies.facade.length was 0.5 m there and is 0.55 m here"),
        ("[4.0, 6.5]", "[4.0, 6.4]", "bodies.facade.profile[3][2] was 6.5 m there and is 6.4 m here"),
        ('"2000 kg/m^3"', '"2100 kg/m^3"', "materials.stone.density was 2000 kg/m3 there and is 2100 kg/m3 here"),
        ('cut = "6.5 m"', 'cut = "6.6 m"', "mechanisms.gable.cut was 6.5 m there and is 6.6 m here"),
        ("storeys = 2", "storeys = 3", "building.storeys was 2 there and is 3 here"),
    ],
)
def test_a_state_before_of_another_wall_is_told_and_a_condition_of_a_pass(old, new, told):
    study = build_to_decide(load(variant("another-wall", **{old: new})))
    found = find_outcome(study)
    where = told.split(" was ")[0]
    assert ("differs-before", where) in {(each.key, each.where) for each in study.before.differences}
    assert [told in each.text for each in found.conditions if each.key == "same-building"] == [True]


STATED = 'sides = "one"              # floors and cross walls behind'
PUSH = '{ kind = "force", force = "10 kN", at = [0.0, -0.25, 6.0], direction = [0, -1, 0] }'
CEASED = "mechanisms.facade.loads[{}] (force) was there and is gone here"


def states_of_loads(tmp_path: Path, before: str, after: str) -> Path:
    """The wall alone in two states, each with its loads on the façade."""
    made = tmp_path / "facade"
    shutil.copytree(folder(), made)
    alone = (made / "project.toml").read_text(encoding="utf-8")
    first = made / "first.toml"
    first.write_text(replace_once(alone, STATED, f"{STATED}\nloads = [{before}]"), encoding="utf-8")
    (made / "first").mkdir()
    write_listed(made / "first" / RESULTS, dumps(assess.run(first).results))
    second = made / "second.toml"
    works = f'limit_state = "SLV"\n{WORKS}\nbefore = "first/{RESULTS}"'
    text = replace_once(alone, 'limit_state = "SLV"', works)
    second.write_text(replace_once(text, STATED, f"{STATED}\nloads = [{after}]"), encoding="utf-8")
    return second


@pytest.mark.parametrize(
    ("before", "after", "told"),
    [
        (PUSH, "", [CEASED.format(1)]),
        (f"{PUSH}, {PUSH}", PUSH, [CEASED.format(2)]),
        (PUSH, PUSH.replace("10 kN", "1 kN"), [CEASED.format(1), "mechanisms.facade.loads[1] (force) was not there"]),
        ("", PUSH.replace("[0, -1, 0]", "[0, 1, 0]"), ["mechanisms.facade.loads[1] (force) was not there and is here"]),
    ],
)
def test_a_load_of_one_state_alone_is_told_and_a_condition_of_a_pass(tmp_path, before, after, told):
    """A push typed into the state before lowers its index, and with it the target of the improvement."""
    results = assess.run(states_of_loads(tmp_path, before, after)).results
    assert results.verdict is not None
    assert results.before is not None
    (condition,) = (each.text for each in results.verdict.conditions if each.key == "same-building")
    assert [each for each in told if each not in condition] == []
    warned = {each.key for each in results.warnings if each.severity == Severity.WARNING}
    assert warned & {"load-gone", "load-new"}
    kinds = [each.split(" (")[1] for each in works_shown(results.before.differences)]
    assert len(kinds) == len(told)
    assert kinds[0] == ("force) gone" if "gone" in told[0] else "force) new")


def test_a_load_of_both_states_is_no_difference(tmp_path):
    found = assess.run(states_of_loads(tmp_path, PUSH, PUSH)).results
    assert found.before is not None
    assert found.before.differences == ()


def test_the_knowledge_of_the_building_is_a_value_of_it():
    level = {"[verdict]": '[procedures.ntc2018]\nknowledge_level = "LC3"\n\n[verdict]'}
    study = build_to_decide(load(variant("known", **level)))
    assert "procedures.ntc2018.knowledge_level" in {each.where for each in study.before.differences}


def test_a_body_that_is_drawn_after_alone_is_no_works(capsys, tmp_path):
    shelf = '[bodies.shelf]\nmaterial = "stone"\nbox = { thickness = 1, length = 1, height = 1, base = [9, 9, 0] }\n'
    project = variant("drawn", **{"[mechanisms.facade]": f"{shelf}\n[mechanisms.facade]"})
    assert ended("run", project, "--no-report", "-o", tmp_path / "out") == 0
    lines = capsys.readouterr().out.splitlines()
    ties = [f"mechanisms.facade.loads[{place}] (tie) new" for place in (1, 2)]
    assert f"works: {', '.join(ties)}" in lines
    assert "drawn only after: bodies.shelf" in lines


def test_a_wall_of_another_name_and_material_is_no_works():
    """Its mechanism has the same name, so that its index is that of the wall before."""
    other = {"[bodies.facade]": "[bodies.front]", 'blocks = ["facade"]': 'blocks = ["front"]'}
    study = build_to_decide(load(variant("renamed-wall", **other)))
    places = {each.where for each in study.before.differences if each.key == "differs-before"}
    assert {"bodies.facade.length", "bodies.front.length", "mechanisms.facade.blocks[1][1]"} <= places


def test_models_are_the_same_by_their_content(tmp_path):
    (tmp_path / "new.obj").write_text("v 0 0 0\n", encoding="utf-8")
    values = [{"bodies.a.mesh": ResolvedValue(name, given=True)} for name in ("old.obj", "new.obj")]
    (sha,) = (hashlib.sha256(b"v 0 0 0\n").hexdigest(),)
    for digest, keys in ((sha, []), ("0" * 64, ["bodies.a.mesh"])):
        found = differences_since_before(*values, inputs=(Input("old.obj", digest),), folder=tmp_path)
        assert [each.where for each in found] == keys


def test_what_is_no_results_file_is_refused(tmp_path):
    (tmp_path / "x.json").write_text("{}", encoding="utf-8")
    with pytest.raises(ProjectError, match=r"verdict\.before.*no schema_version"):
        question_of(folder() / "with-ties.toml", before=tmp_path / "x.json")
    with pytest.raises(ProjectError, match=r"verdict\.before.*no such file"):
        load(folder() / "with-ties.toml", before=tmp_path / "nowhere.json")


GABLE = '[mechanisms.gable]\nlabel = "Gable above the eaves"'


def test_a_mechanism_that_is_not_examined_any_more_leaves_an_improvement_open():
    """The index of the building would rise for want of its weakest mechanism."""
    renamed = {GABLE: GABLE.replace(".gable", ".top"), '"mechanisms.gable.cut"': '"mechanisms.top.cut"'}
    found = find_outcome(build_to_decide(load(variant("renamed", **renamed))))
    assert found.outcome == "incomplete"
    assert [(each.key, each.toml) for each in found.missing] == [("report.sources", '"verdict.before" = "measured: …"')]
    assert "gable of the state before the works: not examined here" in found.missing[0].text
    vouched = {"[report.sources]": '[report.sources]\n"verdict.before" = "measured: the gable was taken down"'}
    found = find_outcome(build_to_decide(load(variant("vouched", **renamed, **vouched))))
    assert found.outcome == "pass"
    assert "gone-by-source" in {each.key for each in found.conditions}
