"""Mechanisms found on the bodies of a project: what it states is known, what is added changes nothing else."""

import csv
from dataclasses import replace

import pytest

from assess.errors import ProjectError
from assess.project.build import build_to_decide
from assess.project.drawn_project import write_project
from assess.project.found_mechanisms import add_mechanisms, find_margins, find_mechanisms, find_overturning_pga
from assess.project.project_file import load
from assess.study.histories import rocking_case, run_levels
from assess.study.run import find_outcome
from assess.study.study import require_spectrum
from assess.study.suites import motions_of
from spectra.gravity import g
from tests.support.buildings import block, house, part_of
from tests.support.command import ended
from tests.support.drawings import obj_of
from tests.support.houses import House, Planted, prism, write_groups, write_ifc

HEAD = """\
# my house
title = "House"          # kept

[materials.stone]
density = "1900 kg/m^3"

[materials.timber]
density = "400 kg/m^3"

[bodies]
"""
TAIL = """
[mechanisms.mine]        # typed by hand
kind = "single-block"
blocks = ["Front_1"]
direction = [0, -1, 0]
sides = "one"
loads = [{ kind = "body", body = "Roof_1", role = "roof" }]
"""


@pytest.fixture
def file(tmp_path):
    parts = house(storeys=1).parts
    (tmp_path / "house.obj").write_text(obj_of(parts))
    names = [part.name.replace(" ", "_") for part in parts]
    bodies = [
        f'{name} = {{ material = "{"timber" if "Roof" in name else "stone"}", mesh = "house.obj", element = "{name}" }}'
        for name in names
    ]
    path = tmp_path / "project.toml"
    path.write_text(HEAD + "\n".join(bodies) + "\n" + TAIL)
    return path


def test_what_the_project_states_is_known(file) -> None:
    found = find_mechanisms(load(file))
    assert found.in_file == {"front-1-overturning": "mine"}
    assert {each.name for each in found.new} >= {"back-1-overturning", "left-1-overturning", "right-1-overturning"}
    assert found.structure.part("Roof_1").kind == "roof"
    assert found.structure.part("Front_1").density == 1900.0
    assert found.structure.part("Front_1").mass == pytest.approx(1900.0 * 9.0 * 0.5 * 3.0)


def test_added_tables_leave_the_rest_as_it_is(file) -> None:
    before = file.read_text()
    loaded = load(file)
    names = add_mechanisms(loaded, find_mechanisms(loaded))
    assert file.read_text().startswith(before)
    again = load(file)
    assert set(again.content.mechanisms) == {"mine", *names}
    assert not find_mechanisms(again).new


def test_what_is_added_answers_no_entry_that_stays_open(tmp_path) -> None:
    """A wall at the re-entrant corner of an L is not looked for: turning the others does not examine all walls."""
    parts = House(plan="L").parts()
    names = [part.name.replace(" ", "-").replace(".", "-") for part in parts]
    write_groups(tmp_path / "house.obj", [replace(part, name=name) for part, name in zip(parts, names, strict=True)])
    bodies = "\n".join(f'{name} = {{ material = "stone", mesh = "house.obj", element = "{name}" }}' for name in names)
    mine = '[mechanisms.mine]\nkind = "single-block"\nblocks = ["wall-0-at-0"]\ndirection = [0, -1, 0]\n'
    file = tmp_path / "project.toml"
    file.write_text(f'{HEAD}{bodies}\n{mine}[report]\nbuilding_type = "house"\n')
    add_mechanisms(load(file), find_mechanisms(load(file)))
    text = file.read_text(encoding="utf-8")
    assert "# simple-overturning: not examined in full: overturning of one storey: wall-2-at-0: above z = 0 m" in text
    added = {name: each for name, each in load(file).content.mechanisms.items() if name != "mine"}
    assert {each.examines for name, each in added.items() if name.endswith("overturning")} == {()}


def test_what_an_ifc_model_says_of_its_elements_is_kept(tmp_path) -> None:
    """A chimney that stands beside a house by itself looks as a pier does; nothing is added to a drawn project."""
    parts = (*House(top="gables").parts(), Planted("stack", "chimney", 0.6, prism((12.0, 2.0, 12.6, 2.6), 0.0, 7.0)))
    _, candidates = write_project([write_ifc(tmp_path / "house.ifc", parts)], tmp_path / "new")
    loaded = load(tmp_path / "new")
    found = find_mechanisms(loaded)
    assert found.structure.part("stack").kind == "chimney"
    assert {each.name for each in found.candidates} == {each.name for each in candidates}
    assert not found.new
    assert not add_mechanisms(loaded, found)


def test_a_mechanism_stated_in_another_way_as_weak_is_the_same(tmp_path) -> None:
    """A square chimney is as weak in four ways; which of them comes first is rounding."""
    write_project([write_ifc(tmp_path / "house.ifc", House(top="gables", chimney=True).parts())], tmp_path / "new")
    file = tmp_path / "new" / "project.toml"
    head, table = file.read_text(encoding="utf-8").split("[mechanisms.chimney-chimney]")
    found = find_mechanisms(load(file))
    way = next(each.definition for each in found.candidates if each.name == "chimney-chimney").towards
    given = f"direction = [{', '.join(f'{-x + 0.0:.10g}' for x in way)}]"
    lines = [given if line.startswith("direction") else line for line in table.split("[mechanisms.")[0].split("\n")]
    rest = "".join(f"[mechanisms.{each}" for each in table.split("[mechanisms.")[1:])
    file.write_text(f"{head}[mechanisms.chimney-chimney]" + "\n".join(lines) + rest, encoding="utf-8")
    assert find_mechanisms(load(file)).in_file["chimney-chimney"] == "chimney-chimney"


def test_an_inclined_crack_is_known_as_it_was_drawn(tmp_path) -> None:
    """A tower's crack is written rounded; one that begins 1 m higher is another."""
    tower = part_of("Tower", block((1.0 / 3, 10.1 / 3), (0.0, 3.3), (0.0, 14.3)), "tower")
    (tmp_path / "tower.obj").write_text(obj_of((tower,)))
    write_project([tmp_path / "tower.obj"], tmp_path / "new")
    file = tmp_path / "new" / "project.toml"
    loaded = load(file)
    assert find_mechanisms(loaded).in_file["tower-tower"] == "tower-tower"
    assert not add_mechanisms(loaded, find_mechanisms(loaded))
    height = loaded.content.mechanisms["tower-tower"].cut.point[2]
    text = file.read_text(encoding="utf-8")
    assert text.count(f", {height:.10g}], angle") == 1
    file.write_text(text.replace(f", {height:.10g}], angle", f", {height + 1.0:.10g}], angle"), encoding="utf-8")
    assert "tower-tower" not in find_mechanisms(load(file)).in_file


def test_a_name_that_is_taken_gets_a_number(file) -> None:
    file.write_text(file.read_text().replace("mechanisms.mine", "mechanisms.back-1-overturning"))
    loaded = load(file)
    assert "back-1-overturning-2" in add_mechanisms(loaded, find_mechanisms(loaded))


def test_a_file_that_changed_meanwhile_is_refused(file) -> None:
    loaded = load(file)
    found = find_mechanisms(loaded)
    file.write_text(file.read_text() + "# changed\n")
    after = file.read_bytes()
    with pytest.raises(ProjectError, match="has changed since it was read; nothing was written"):
        add_mechanisms(loaded, found)
    assert file.read_bytes() == after
    assert sorted(each.name for each in file.parent.iterdir()) == ["house.obj", "project.toml"]


def test_tables_that_cannot_be_added_are_refused(file) -> None:
    text = file.read_text()
    inline = text[: text.index("[mechanisms.mine]")]
    keys = 'kind = "single-block", blocks = ["Front_1"], direction = [0, -1, 0], sides = "one"'
    file.write_text("mechanisms = { mine = { " + keys + " } }\n" + inline)
    before = file.read_bytes()
    loaded = load(file)
    with pytest.raises(ProjectError, match="cannot be added, and nothing was written"):
        add_mechanisms(loaded, find_mechanisms(loaded))
    assert file.read_bytes() == before


SITE = """
[site.spectrum]
code = "ntc2018"
nominal_life = 50
use_class = "II"
soil = "B"
hazard = [
  { return_period = 50, a_g = "0.077 g", f_0 = 2.38, t_c_star = 0.28 },
  { return_period = 975, a_g = "0.240 g", f_0 = 2.39, t_c_star = 0.34 },
]

[procedures.ntc2018]
knowledge_level = "LC1"
"""


def test_by_the_basis_they_rank_by_the_pga_that_they_hold(file) -> None:
    """A run of the project with the tables finds the same."""
    file.write_text(file.read_text() + SITE)
    loaded = load(file)
    found = find_mechanisms(loaded)
    margins = find_margins(loaded, found, jobs=1)
    table = found.table(margins)
    assert list(table.margin.dropna()) == sorted(margins.values())
    assert margins["left-1-overturning"] < margins["front-1-overturning"]  # though its multiplier is higher
    assert "front-1-corner" in margins
    names = dict(zip(add_mechanisms(loaded, found), (each.name for each in found.new), strict=True))
    verdict = find_outcome(build_to_decide(load(file)))
    again = {each.mechanism: each.margin for each in verdict.mechanisms}
    assert {candidate: again[name] for name, candidate in names.items() if again[name] is not None} == pytest.approx(
        {candidate: margins[candidate] for candidate in names.values() if candidate in margins}
    )


def test_the_command_lists_writes_and_keeps_a_table(file, tmp_path, capsys) -> None:
    assert ended("mechanisms", file, "-o", tmp_path / "out", "--write") == 0
    said = capsys.readouterr().out
    assert "front-1-overturning" in said
    assert "mine" in said
    assert "mechanisms added" in said
    with (tmp_path / "out" / "mechanisms.csv").open(encoding="utf-8") as table:
        rows = list(csv.DictReader(table))
    assert [row["in_file"] for row in rows if row["name"] == "front-1-overturning"] == ["mine"]
    assert ended("mechanisms", file, "-o", tmp_path / "out", "--write") == 0
    assert "nothing to add" in capsys.readouterr().out


def test_by_the_suite_they_rank_by_the_pga_that_overturns_half_of_its_runs(file, capsys) -> None:
    """One step of the scan below, fewer than half of the records overturn it, and corners have no histories."""
    file.write_text(file.read_text() + SITE + '[records]\nsynthetic = { count = 4, duration = "8 s" }\n')
    loaded = load(file)
    found = find_mechanisms(loaded)
    pga = find_overturning_pga(loaded, found, jobs=2)
    assert pga["front-1-corner"] is None
    ranked = {name: value for name, value in pga.items() if value is not None}
    assert list(found.table(overturning=pga).overturning_pga_g.dropna()) == sorted(ranked.values())
    add_mechanisms(loaded, found)
    study = build_to_decide(load(file))
    spectrum, name = require_spectrum(study), "left-1-overturning"
    mechanism = next(each for each in study.mechanisms if each.name == name)
    motions = motions_of(study, spectrum)
    half, below = ranked[name] * g, ranked[name] * g / 1.025
    run = run_levels(
        rocking_case(study, mechanism, motions),
        motions, levels=(half, below), further=(), site_pga=spectrum.pga, threads=1, with_twins=False,
    )  # fmt: skip
    assert [suite.overturned >= 2 for suite in run.suites] == [True, False]
    assert ended("mechanisms", file, "--by", "pga") == 0
    said = capsys.readouterr().out
    assert "half overturn [g]" in said
    assert "no histories" in said
    assert said.index("left-1-overturning") < said.index("front-1-corner")


def test_without_a_site_there_is_no_suite_to_rank_by(file, capsys) -> None:
    assert ended("mechanisms", file, "--by", "pga") == 2
    assert "site.spectrum: missing" in capsys.readouterr().err
    assert ended("mechanisms", file, "--by", "pga", "--index") == 2
