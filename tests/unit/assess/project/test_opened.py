"""What is said of a project that is open is what a run says, and what is written is what a run reads."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import assess
from assess.errors import AssessError, ProjectError
from assess.examples import copy_example
from assess.project.opened import OpenedProject
from assess.project.trials import ShownMechanism, deciding_checks
from assess.results import MechanismResult
from assess.study.mechanism_results import parameters
from tests.support.projects import NTC, block, project_toml, wall


def opened_project(folder: Path, *more: str, **tables) -> OpenedProject:
    path = folder / "project.toml"
    path.write_text(project_toml(*more, **tables), encoding="utf-8")
    return OpenedProject(path)


def write(opened: OpenedProject) -> str:
    """Write what is tried, as the page does."""
    said = opened.write()
    opened.refresh()
    return said


def undo(opened: OpenedProject) -> str:
    """Take the last step back, as the page does."""
    said = opened.edited.undo()
    if opened.edited.project is not opened.built_of:
        opened.refresh()
    return said


@pytest.fixture
def opened(tmp_path) -> OpenedProject:
    """A wall that is cut at 1 m, on an Italian site."""
    return opened_project(
        tmp_path,
        site={"spectrum": NTC, "limit_state": "SLV"},
        mechanisms={"wall": block(cut="1 m", direction=[1, 0, 0], sides="two")},
    )


@pytest.mark.parametrize("sourced", [True, False])
def test_everything_shown_is_that_of_a_run(tmp_path, sourced):
    """To the bit, for a building with ties, floors and a gable; also where the front falls without what has no source.

    The gable then decides without its straps, beside a front of which nothing but that it falls is shown.
    """
    path = copy_example("house", tmp_path / "house")
    text = path.read_text(encoding="utf-8")
    path.write_text(text if sourced else re.sub(r'(?m)^"mechanisms\..*\n', "", text), encoding="utf-8")
    opened = OpenedProject(path)
    opened.find_outcome()
    run = assess.run(path)
    assert run.verdict is not None
    assert opened.verdict is not None
    assert opened.verdict.outcome == run.verdict.outcome
    of_run = {each.mechanism: each for each in run.verdict.mechanisms}
    for result in run.results.mechanisms:
        shown, decided = opened.examine(result.name), of_run[result.name]
        assert shown.verdict is not None
        assert (shown.verdict.outcome, shown.verdict.margin) == (decided.outcome, decided.margin)
        found, told = (
            [(each.procedure, each.ratio, each.index and each.index.value) for each in one.answers]
            for one in (shown.verdict, decided)
        )
        assert found == told
        if sourced or result.name == "gable":
            assert not shown.fault
            assert_same(shown, result)
        else:
            assert shown.fault.startswith("falls at rest")
            assert shown.checks == ()
            assert decided.margin == 0.0
            assert [each.key for each in run.results.warnings if each.where == "mechanisms.front"][
                -1
            ] == "falls-replaced"
    tied = parameters(opened.study)[1].oscillator.uplift_multiplier
    assert (opened.examine("gable").result.oscillator.uplift_multiplier < 0.5 * tied) is not sourced


def assert_same(shown: ShownMechanism, result: MechanismResult) -> None:
    """Parameters, curve and checks by spectra are the same to the bit."""
    assert shown.result is not None
    assert (shown.result.oscillator, shown.result.curve) == (result.oscillator, result.curve)
    asked = {each.procedure for each in shown.checks}
    told = [each for each in result.checks if each.procedure in asked]
    assert [(each.ratio, each.capacity_pga_g) for each in shown.checks] == [
        (each.ratio, each.capacity_pga_g) for each in told
    ]


@pytest.mark.parametrize("swept", [False, True])
def test_what_is_tried_is_decided_as_a_run_decides_once_it_is_written(tmp_path, swept):
    """To the bit: the stiffness of a joint without a source, which a run replaces, and a thickness that is swept."""
    more = '[analysis.sweep]\nkey = "bodies.wall.box.thickness"\nvalues = [0.55, 0.6, 0.65]' if swept else ""
    opened = opened_project(
        tmp_path,
        more,
        site={"spectrum": NTC, "limit_state": "SLV"},
        materials={"brick": {"density": 1800, "disintegration": "excluded"}},
        report={"sources": {"materials.brick.disintegration": "measured: survey of 2025"}},
        mechanisms={
            "wall": block(
                cut="0.2 m",
                direction=[1, 0, 0],
                sides="one",
                interface={"model": "flexible", "stiffness": "50 GPa/m", "strength": "inf"},
            )
        },
    )
    opened.move_cut("wall", (0.0, 0.0, 0.27), 0.1)
    typed = opened.examine("wall")
    assert typed.as_typed
    assert opened.find_outcome() is not None
    shown = opened.examine("wall")
    assert not shown.as_typed
    assert opened.verdict.overrides
    assert typed.verdict.margin != shown.verdict.margin
    opened.write()
    run = assess.run(opened.edited.project.path)
    assert run.verdict.state == opened.verdict.state == "unsourced-replaced"
    assert_same(shown, run.results.mechanisms[0])
    decided = run.verdict.mechanisms[0]
    assert (shown.verdict.outcome, shown.verdict.margin) == (decided.outcome, decided.margin)
    assert shown.verdict.conditions == decided.conditions
    assert [(each.key, each.instead) for each in opened.verdict.overrides] == [
        (each.key, each.instead) for each in run.verdict.overrides
    ]
    assert (opened.decision.decided.of["wall"].case is not None) is swept


def test_a_project_that_can_no_longer_be_assessed_is_not_written(opened):
    before = opened.edited.project.path.read_bytes()
    opened.move_cut("wall", (0.0, 0.0, 9.0), 0.0)
    with pytest.raises(AssessError, match="misses the body"):
        opened.write()
    assert opened.edited.project.path.read_bytes() == before
    assert opened.edited.can_undo


def test_what_is_not_changed_of_a_crack_stays_as_it_was_written(tmp_path):
    """The point of an inclined crack, in feet, where the angle alone is another; and a level one as it is typed."""
    opened = opened_project(
        tmp_path,
        mechanisms={
            "wall": block(cut={"point": [0.3, 0, "4.12345 ft"], "angle": "20 deg"}, direction=[1, 0, 0], sides="two")
        },
    )
    cut = opened.cut_of("wall")
    opened.move_cut("wall", cut.point, 0.5)
    (tried,) = opened.edited.changes
    assert tried == {("mechanisms", "wall", "cut"): {"point": [0.3, 0, "4.12345 ft"], "angle": "28.65 deg"}}
    assert opened.cut_of("wall").point == cut.point
    opened.move_cut("wall", (*cut.point[:2], 1.5), 0.5)
    assert opened.edited.changes[-1]["mechanisms", "wall", "cut"]["point"] == [0.3, 0, 1.5]


def test_the_weakest_crack_is_tried_and_is_weaker(opened):
    """By hand: of a wall on a level crack the highest part is the strongest, so the foot or an incline is weaker."""
    found = opened.find_weakest_crack("wall", bool)
    opened.move_cut("wall", found.cut.point, found.cut.angle)
    multiplier = opened.examine("wall").result.oscillator.uplift_multiplier
    assert multiplier == pytest.approx(found.multiplier, rel=2e-3)
    assert multiplier <= 0.6 / 4.0 * (1 + 1e-6)


@pytest.mark.parametrize("angle", [0.0, 0.35])
def test_a_crack_that_is_tried_and_written_is_that_of_a_run(opened, angle):
    cut = opened.cut_of("wall")
    assert (cut.point[2], cut.angle) == (1.0, 0.0)
    opened.move_cut("wall", (0.3, 0.0, 1.23456), angle)
    tried = opened.examine("wall")
    assert not tried.fault
    assert write(opened) == "written into project.toml"
    run = assess.run(opened.edited.project.path)
    assert_same(tried, run.results.mechanisms[0])
    assert tried.verdict.margin == run.verdict.mechanisms[0].margin
    assert opened.edited.changes == ()
    assert opened.cut_of("wall").angle == pytest.approx(angle, abs=1e-4)


def test_the_multiplier_of_a_crack_is_that_of_the_wall_above_it(opened):
    """By hand: a rigid wall of thickness t and height h above its crack rocks at t / h."""
    for elevation in (0.5, 2.0, 3.0):
        opened.move_cut("wall", (0.0, 0.0, elevation), 0.0)
        found = opened.examine("wall").result.oscillator.uplift_multiplier
        assert found == pytest.approx(0.6 / (4.0 - elevation), rel=1e-9)


def test_a_crack_that_misses_says_so(opened):
    opened.move_cut("wall", (0.0, 0.0, 9.0), 0.0)
    assert "misses the body" in opened.examine("wall").fault


def test_what_falls_at_rest_says_so(tmp_path):
    """A wall that is drawn leaning beyond its foot; and one that a crack leaves so."""
    leaning = {"material": "brick", "profile": [[0, 0], [0.5, 0], [1.5, 3], [1.0, 3]], "length": 2}
    opened = opened_project(
        tmp_path, bodies={"wall": leaning}, mechanisms={"wall": block(direction=[1, 0, 0], sides="one")}
    )
    assert opened.examine("wall").fault.startswith("falls at rest")
    opened.edited.change({("materials", "brick", "density"): 1900})
    assert "falling" in opened.examine("wall").fault


def test_a_drag_is_one_change_and_undo_takes_it_back(opened):
    for number in range(5):
        opened.move_cut("wall", (0.0, 0.0, 1.0 + 0.1 * number), 0.0, goes_on=number > 0)
    (density,) = (each for each in opened.numbers("wall") if each.path[-1] == "density")
    assert density.unit == "kg/m^3"
    opened.edited.change({density.path: density.file_value(2000.0)})
    assert len(opened.edited.changes) == 2
    heavier = opened.examine("wall").result.oscillator.mass_kg
    assert undo(opened) == "taken back"
    assert heavier / opened.examine("wall").result.oscillator.mass_kg == pytest.approx(2000.0 / 1800.0)
    undo(opened)
    assert opened.edited.changes == ()
    assert undo(opened) == "nothing to take back"


def test_writing_keeps_the_comments_and_can_be_undone(opened):
    path = opened.edited.project.path
    path.write_text("# by hand\n" + path.read_text(encoding="utf-8"), encoding="utf-8")
    opened.read()
    before = path.read_bytes()
    opened.move_cut("wall", (0.0, 0.0, 1.5), 0.0)
    write(opened)
    assert path.read_text(encoding="utf-8").startswith("# by hand\n")
    assert '"1.5 m"' in path.read_text(encoding="utf-8")
    assert undo(opened) == "the file is as it was before"
    assert path.read_bytes() == before
    assert opened.cut_of("wall").point[2] == 1.0


def test_a_file_that_changed_meanwhile_is_left_alone(opened):
    path = opened.edited.project.path
    opened.move_cut("wall", (0.0, 0.0, 1.5), 0.0)
    other = path.read_bytes() + b"# by another\n"
    path.write_bytes(other)
    with pytest.raises(ProjectError, match="has changed since it was read; nothing was written: press “Read again”"):
        write(opened)
    assert path.read_bytes() == other
    assert len(opened.edited.changes) == 1
    opened.read()
    opened.move_cut("wall", (0.0, 0.0, 1.5), 0.0)
    write(opened)
    path.write_bytes(other + b"# and again\n")
    with pytest.raises(ProjectError, match="has changed"):
        undo(opened)
    assert path.read_bytes() == other + b"# and again\n"


def test_what_is_missing_is_tried_as_the_line_that_a_run_prints(tmp_path):
    opened = opened_project(
        tmp_path,
        site={"spectrum": NTC},
        mechanisms={"wall": block(direction=[1, 0, 0], sides="two")},
    )
    missing = {each.key: each for each in opened.find_outcome().missing}
    entry = missing["site.limit_state"]
    assert entry.toml == 'limit_state = "SLV"'
    opened.edited.add_lines(entry, entry.toml)
    write(opened)
    assert "site.limit_state" not in {each.key for each in opened.find_outcome().missing}
    with pytest.raises(ProjectError, match=r"site.limit_state: .*write it as the example shows"):
        opened.edited.add_lines(entry, "limit_state = SLV")
    with pytest.raises(ProjectError, match=r"materials.brick.density: these lines are for site.limit_state alone"):
        opened.edited.add_lines(entry, 'limit_state = "SLV"\n[materials.brick]\ndensity = 900')


def test_a_source_that_its_value_outlived_is_said(opened):
    density = ("materials", "brick", "density")
    opened.edited.change({("report", "sources"): {"materials.brick.density": "measured: cores"}})
    write(opened)
    assert opened.edited.outlived == ""
    opened.edited.change({density: "1500 kg/m^3"})
    said = "its source vouched for the value before: materials.brick.density (measured: cores)"
    assert opened.edited.outlived == said
    opened.edited.change({("report", "sources"): {"materials.brick.density": "measured: new cores"}})
    assert opened.edited.outlived == ""


def test_cracks_as_weak_as_the_weakest_are_told(tmp_path):
    """A triangle is similar to its part above any level crack: no elevation is weaker than another."""
    triangle = {"material": "brick", "profile": [[0, 0], [1, 0], [0.5, 4]], "length": 2}
    opened = opened_project(
        tmp_path, bodies={"wall": triangle}, mechanisms={"wall": block(cut="1 m", direction=[1, 0, 0], sides="one")}
    )
    low, high = opened.find_weakest_crack("wall", bool).tied
    assert high - low > 1.0


def test_found_mechanisms_are_added_and_taken_back(tmp_path):
    path = copy_example("house", tmp_path / "house")
    opened = OpenedProject(path)
    assert {each.kind for each in opened.parts()} == {"body"}
    opened.find_others()
    assert {each.kind for each in opened.parts()} >= {"wall", "floor", "roof"}
    before, found = path.read_bytes(), len(opened.proposed)
    assert found > 1
    assert opened.add_found() == f"{found} added to project.toml"
    opened.refresh()
    opened.find_others()
    assert (len(opened.edited.project.content.mechanisms), len(opened.proposed)) == (2 + found, 0)
    undo(opened)
    assert path.read_bytes() == before


def test_the_worst_stands_first(tmp_path):
    opened = opened_project(
        tmp_path,
        site={"spectrum": NTC, "limit_state": "SLV"},
        bodies={"thick": wall(2.0), "thin": wall(0.2, base=[9, 0, 0])},
        mechanisms={name: block(name, direction=[1, 0, 0], sides="two") for name in ("thick", "thin")},
    )
    assert opened.rank() == ("thin", "thick")
    opened.find_outcome()
    assert opened.rank() == ("thin", "thick")
    for name in opened.rank():
        checks = deciding_checks(opened.examine(name).checks, opened.study)
        assert {each.procedure for each in checks} == set(opened.methods) == {"ntc2018-linear", "ntc2018-nonlinear"}


def test_without_a_site_there_are_multipliers_alone(tmp_path):
    opened = opened_project(tmp_path, site=None)
    assert opened.find_outcome() is None
    shown = opened.examine("wall")
    assert (shown.checks, shown.verdict) == ((), None)
    assert shown.result.oscillator.uplift_multiplier == pytest.approx(0.6 / 4.0)


def test_without_a_site_its_lines_are_missing_and_their_dots_are_no_values(tmp_path):
    opened = opened_project(tmp_path, site=None)
    (site,) = opened.missing
    assert site.key == "site.spectrum"
    with pytest.raises(ProjectError, match="…"):
        opened.edited.add_lines(site, site.toml)
    assert not opened.edited.changes
    filled = site.toml.replace('"… g"', '"0.2 g"').replace('"… s"', '"0.3 s"').replace('f_0 = "…"', "f_0 = 2.4")
    opened.edited.add_lines(site, filled.replace("…", "B"))
    write(opened)
    assert opened.has_site
    assert opened.find_outcome() is not None


def test_sources_of_what_is_replaced_are_missing_as_lines_whose_dots_vouch_for_nothing(tmp_path):
    building = {"height": "12 m", "storeys": 3, "ground_elevation": 0}
    opened = opened_project(
        tmp_path,
        site={"spectrum": NTC, "limit_state": "SLV"},
        building=building,
        mechanisms={"wall": block(cut="3 m", direction=[1, 0, 0], sides="two")},
    )
    line = '"building.height" = "measured: …"'
    opened.find_outcome()
    assert [each.key for each in opened.replacements("wall")] == ["building.height"]
    assert line in [each.toml for each in opened.missing]
    entry = next(each for each in opened.missing if each.toml == line)
    for source, still in (("measured: …", True), ("measured: survey, 3 June 2024", False)):
        opened.edited.add_lines(entry, line.replace("measured: …", source))
        opened.find_outcome()
        assert (line in [each.toml for each in opened.missing]) is still
