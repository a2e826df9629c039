"""A project file under edit: steps, texts that stay, sources beside what is missing."""

from __future__ import annotations

import pytest

from assess.codes.question import Missing
from assess.errors import ProjectError
from assess.project.edited import EditedProject
from assess.project.evidence import every_key, meaning_of
from tests.support.projects import block, project_toml

LIMIT_STATE = Missing("site.limit_state", "why", 'limit_state = "SLV"')


@pytest.fixture
def edited(tmp_path) -> EditedProject:
    path = tmp_path / "project.toml"
    path.write_text("# by hand\n" + project_toml(mechanisms={"wall": block(cut="1 m", sides="two")}), encoding="utf-8")
    return EditedProject(path)


def test_each_change_is_a_step_but_one_that_goes_on(edited):
    key = ("materials", "brick", "density")
    for value, goes_on in ((1900, False), (2000, True), (2100, False)):
        edited.change({key: value}, goes_on=goes_on)
    assert [each[key] for each in edited.changes] == [2000, 2100]
    assert edited.undo() == "taken back"
    assert edited.tried_project().content.materials["brick"].density == 2000.0


def test_every_step_makes_a_revision(edited):
    seen = {edited.revision}
    for act in (
        lambda: edited.change({("title",): "A"}),
        edited.undo,
        lambda: edited.change({("title",): "A"}),
        edited.write,
    ):
        act()
        assert edited.revision not in seen
        seen.add(edited.revision)


def test_what_is_missing_is_written_with_its_source(edited):
    edited.add_lines(LIMIT_STATE, LIMIT_STATE.toml, source="measured: client's brief")
    edited.write()
    report = edited.project.content.report
    assert edited.project.content.site.limit_state == "SLV"
    assert report.source_of("site.limit_state") == "measured: client's brief"
    assert edited.project.path.read_text(encoding="utf-8").startswith("# by hand\n")


def test_found_mechanisms_are_not_added_over_what_is_tried(edited):
    assert edited.add_found(None) == "nothing to add"


def test_a_line_may_begin_a_table_and_name_no_unknown_key(edited):
    edited.add_lines(Missing("building.height", "why", "height = …"), 'height = "9 m"')
    assert edited.tried_project().content.building.height == 9.0
    with pytest.raises(ProjectError, match=r"disintegraton: these lines are for materials.brick.disintegration alone"):
        edited.add_lines(Missing("materials.brick.disintegration", "why", "a = …"), 'disintegraton = "excluded"')


def test_a_line_that_is_no_toml_is_refused(edited):
    with pytest.raises(ProjectError, match="write it as the example shows"):
        edited.add_lines(LIMIT_STATE, "limit_state = SLV")
    with pytest.raises(ProjectError, match=r"begin with .measured., .literature., .assumed."):
        edited.add_lines(LIMIT_STATE, LIMIT_STATE.toml, source="my word")
    assert not edited.can_undo


def test_the_sentence_of_the_manual_is_found_for_keys_of_any_depth():
    assert meaning_of("site.limit_state")
    assert meaning_of("mechanisms.any name.cut")
    assert meaning_of("mechanisms.wall.loads[2].force")
    assert meaning_of("materials.brick.disintegration").startswith("whether the masonry may fall apart")
    assert meaning_of("no.such.key") == ""


def test_most_keys_have_a_sentence():
    keys = [each.path.replace("NAME", "x") for each in every_key() if not each.path.startswith("KEY")]
    assert sum(bool(meaning_of(each)) for each in keys) > 0.95 * len(keys)


def test_front_matter_that_cannot_be_read_is_not_tried(edited):
    edited.state_front("author", "A. Rossi")
    edited.state_front("author", "A. Rossi, engineer")
    with pytest.raises(ProjectError, match=r"report\.author"):
        edited.state_front("author", "A.\nRossi")
    assert edited.changes == ({("report", "author"): "A. Rossi, engineer"},)
