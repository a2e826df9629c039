"""Projects below a folder, and those that the rows of a table make of a template."""

from __future__ import annotations

import json
from copy import deepcopy
from pathlib import Path

import pytest

from assess.errors import ProjectError
from assess.portfolio.projects import KeyColumn, Task, find_tasks, project_tree, read_template, row_fault
from assess.project.build import build
from assess.project.project_file import Project, load, load_tree
from assess.verbs import unit_fault
from tests.support.files import write_file
from tests.support.projects import block, project_toml

FORCE = {"kind": "force", "force": "2 kN", "direction": [1, 0, 0], "at": [0.0, 0.0, 3.0]}
TEMPLATE = project_toml(
    title="Street",
    bodies={"wall": {"material": "brick", "box": {"thickness": "0.60 m", "length": "3 m", "height": 4.0}}},
    mechanisms={"wall": block(loads=[FORCE])},
)
THICKNESS = "bodies.wall.box.thickness"


def table(folder: Path, text: str | bytes, *, template: str = TEMPLATE) -> tuple[Task, ...]:
    """Return the tasks of a table with this text."""
    return find_tasks(write_file(folder / "walls.csv", text), write_file(folder / "template.toml", template))


def project(task: Task) -> Project:
    return load_tree(project_tree(task), task.path, sha256=task.sha256)


def test_row_gives_the_project_that_the_file_with_its_values_gives(tmp_path: Path) -> None:
    (task,) = table(tmp_path, f"{THICKNESS},materials.brick.density,mechanisms.wall.loads.0.force\n0.45,1700,3 kN\n")
    text = TEMPLATE.replace('"0.60 m"', "0.45").replace("1800", "1700").replace("2 kN", "3 kN")
    (tmp_path / "one.toml").write_text(text)
    assert project(task).content == load(tmp_path / "one.toml").content
    assert project(task).sha256 == task.sha256


def test_a_row_leaves_the_template_to_the_others(tmp_path: Path) -> None:
    """What no cell changes is not copied: nothing that reads a project may write into its tables."""
    header = f"{THICKNESS},mechanisms.wall.loads.0.force,site.spectrum.t_l,title"
    first, second = table(tmp_path, f"{header}\n0.45,3 kN,7,One\n,,,\n" + '"","","",Two\n')
    before = deepcopy(read_template(first.path))
    assert project_tree(first)["bodies"]["wall"]["box"]["thickness"] == 0.45
    build(project(first))
    assert read_template(first.path) == before
    assert project_tree(second) == {**before, "title": "Two"}


@pytest.mark.parametrize("separator", [",", ";", "\t"])
@pytest.mark.parametrize("mark", [b"", b"\xef\xbb\xbf"])
def test_tables_of_spreadsheets_are_read(tmp_path: Path, separator: str, mark: bytes) -> None:
    lines = [["id", f"{THICKNESS} [cm]", "title"], ["Vía 1", "45", '"a ""house"", 2'], ["b", "", ""], ["", "", ""]]
    lines[1][2] = f'"a ""house""{separator} 2"'
    found = table(tmp_path, mark + "\r\n".join(map(separator.join, lines)).encode())
    assert [task.key for task in found] == ["Vía 1", "b"]
    assert [task.title for task in found] == [f'a "house"{separator} 2', "Street"]
    bodies = [project(task).content.bodies["wall"].box for task in found]  # type: ignore[union-attr]
    assert [body.thickness for body in bodies] == [pytest.approx(0.45), 0.60]


def test_rows_without_id_are_named_by_their_line(tmp_path: Path) -> None:
    found = table(tmp_path, f'title,{THICKNESS}\n"over\ntwo lines",0.5\n\n\nc,0.6\n')
    assert [(task.key, task.title) for task in found] == [("2", "over\ntwo lines"), ("6", "c")]


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("bodies.wall.box.tickness\n1\n", 'column "bodies.wall.box.tickness": not a key of the template; do you mean'),
        ("bodies.wall.box\n1\n", "a table or list of the template; name one of its values"),
        (f"{THICKNESS},{THICKNESS} [m]\n1,1\n", "stands there twice"),
        (f"{THICKNESS},,title\n1,1,1\n", "column 2: no name"),
        ("site.spectrum.code [m]\nec8\n", "takes no unit"),
        (f"{THICKNESS}\n", "no row below the header"),
        ("\n", "no header"),
        ("", "no header"),
        (f"id,{THICKNESS}\na,1\nb,1\na,2\n", 'lines 2 and 4: "a" twice'),
        (b"title\n\xe8\n", "not UTF-8"),
        ("title\n" + "x" * 200_000, "line 2: not a table in CSV (field larger than"),
        (f'id,{THICKNESS},title\na,0.5,"lbl\nb,0.2,x\nc,0.2,y\n', "line 2: not a table in CSV (unexp"),
        (f'id,{THICKNESS},title\na,0.5,x\nb,0.2,"y"z\n', "line 3: not a table in CSV"),
    ],
)
def test_header_that_cannot_be_used_is_one_line(tmp_path: Path, text: str, line: str) -> None:
    with pytest.raises(ProjectError, match=r"walls\.csv") as caught:
        table(tmp_path, text)
    assert line in str(caught.value)
    assert "\n" not in str(caught.value)


def test_nearest_key_is_named(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match=f'do you mean "{THICKNESS}"'):
        table(tmp_path, "bodies.wall.box.tickness\n1\n")


@pytest.mark.parametrize("template", ["", "title = ", "title = 'no mechanism'", "\x00"])
def test_template_that_is_no_project_is_one_line(tmp_path: Path, template: str) -> None:
    with pytest.raises(ProjectError, match=r"template\.toml"):
        table(tmp_path, "title\na\n", template=template)


@pytest.mark.parametrize(
    ("cells", "reason"),
    [
        ('"0,45",a', "0.45"),
        ('"0,45 m",a', "a decimal comma; write 0.45 m"),
        ("0.45,a,b", "3 cells below 2 columns; put a text"),
        ("0.45", "1 cell below 2 columns; write the missing"),
        ("thick,a", "thick"),
        ("-1,a", "greater than"),
        ("0.45 kg,a", "kg"),
        ("=1+1,a", "=1+1"),
        ("nan,a", "not a finite number"),
    ],
)
def test_row_with_a_wrong_value_breaks_alone(tmp_path: Path, cells: str, reason: str) -> None:
    good, broken, last = table(tmp_path, f"{THICKNESS},title\n0.5,a\n{cells}\n0.7,c\n")
    assert project(good).content.title == "a"
    assert project(last).content.title == "c"
    with pytest.raises(ProjectError) as caught:
        project(broken)
    said = row_fault(broken, str(caught.value))
    assert reason in said
    assert said.startswith(f"{tmp_path / 'walls.csv'}: line 3: ")
    assert "template.toml" not in said
    assert (f'column "{THICKNESS}"' in said) is not ("below" in said or "decimal" in said)
    assert "\n" not in said


def test_fault_of_a_row_names_its_id_and_the_column_as_the_table_writes_it(tmp_path: Path) -> None:
    column = "mechanisms.wall.loads.0.at.2"
    (broken,) = table(tmp_path, f"id,{column}\nV01,high\n")
    with pytest.raises(ProjectError, match=r"template\.toml: mechanisms\.wall\.loads\[1\]\.at\[3\]") as caught:
        project(broken)
    said = row_fault(broken, str(caught.value))
    assert said.startswith(f'{tmp_path / "walls.csv"}: line 2 ("V01"): column "{column}": "high": ')
    assert row_fault(broken, f"{broken.path}: site: wrong").endswith('line 2 ("V01"): with template.toml: site: wrong')


def test_trailing_empty_cells_keep_the_values_of_the_template(tmp_path: Path) -> None:
    (task,) = table(tmp_path, f"title,{THICKNESS},materials.brick.density\na,,\n")
    assert project(task).content.bodies["wall"].box.thickness == 0.60  # type: ignore[union-attr]


def test_unit_of_a_head_is_checked_by_the_key(tmp_path: Path) -> None:
    tables = read_template(write_file(tmp_path / "template.toml", TEMPLATE))
    for key, units, wrong in (
        (THICKNESS, ("m", "mm", "ft"), ("kg", "kg/m^3", "wide")),
        ("materials.brick.density", ("kg/m^3", "kN/m^3"), ("kg", "m")),
        ("mechanisms.wall.loads.0.force", ("kN", "lbf"), ("kg", "kN/m")),
    ):
        for unit in units:
            assert unit_fault(tmp_path / "template.toml", tables, KeyColumn(key, unit)) == ""
        for unit in wrong:
            assert f'"{unit}"' in unit_fault(tmp_path / "template.toml", tables, KeyColumn(key, unit))
    (tmp_path / "walls.csv").write_text(f"{THICKNESS} [kg]\n1\n2\n")
    with pytest.raises(ProjectError) as caught:
        find_tasks(tmp_path / "walls.csv", tmp_path / "template.toml", unit_fault)
    start = f'{tmp_path / "walls.csv"}: column "{THICKNESS} [kg]": "kg" is not a unit of length; '
    assert str(caught.value).startswith(start)


def test_text_stays_text_where_the_template_has_text(tmp_path: Path) -> None:
    (task,) = table(tmp_path, 'title\n"=HYPERLINK(""x"")"\n')
    assert project(task).content.title == '=HYPERLINK("x")'
    (task,) = table(tmp_path, "title\n12\n")
    assert project(task).content.title == "12"


def test_hash_follows_template_row_and_every_file_named(tmp_path: Path) -> None:
    template = TEMPLATE + '[records]\nfiles = ["records/*.csv", "more"]\n'
    for name in ("records", "more"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "a.csv").write_text("1")
    rows = f"{THICKNESS}\n0.5\n0.6\n"
    first = [task.sha256 for task in table(tmp_path, rows, template=template)]
    assert first == [task.sha256 for task in table(tmp_path, rows, template=template)]
    assert first[0] != first[1]
    row = [task.sha256 for task in table(tmp_path, rows.replace("0.6", "0.7"), template=template)]
    assert row[0] == first[0]
    assert row[1] != first[1]
    (tmp_path / "more" / "a.csv").write_text("2")
    folder = [task.sha256 for task in table(tmp_path, rows, template=template)]
    (tmp_path / "records" / "b.csv").write_text("1")
    pattern = [task.sha256 for task in table(tmp_path, rows, template=template)]
    changed = [task.sha256 for task in table(tmp_path, rows, template=template + "# changed")]
    assert len({first[0], folder[0], pattern[0], changed[0]}) == 4


def test_hash_follows_the_records_of_a_lock(tmp_path: Path) -> None:
    (tmp_path / "suite").mkdir()
    (tmp_path / "suite" / "a.csv").write_text("1")
    lock = tmp_path / "suite" / "records.lock.toml"
    lock.write_text('[target]\ncode = "ntc2018"\n[[records]]\nfile = "a.csv"\n')
    template = TEMPLATE + '[records]\nlock = "suite/records.lock.toml"\n'
    (first,) = table(tmp_path, f"{THICKNESS}\n0.5\n", template=template)
    (tmp_path / "suite" / "a.csv").write_text("2")
    (changed,) = table(tmp_path, f"{THICKNESS}\n0.5\n", template=template)
    lock.write_text("[[records")
    (broken,) = table(tmp_path, f"{THICKNESS}\n0.5\n", template=template)
    assert len({first.sha256, changed.sha256, broken.sha256}) == 3


def test_hash_follows_the_file_that_holds_the_mesh_of_a_gltf(tmp_path: Path) -> None:
    (tmp_path / "m.gltf").write_text('{"buffers": [{"byteLength": 3, "uri": "m.bin"}]}')
    template = project_toml(bodies={"wall": {"material": "brick", "mesh": "m.gltf"}}, mechanisms={"wall": block()})
    found = []
    for content in ("old", "new"):
        (tmp_path / "m.bin").write_text(content)
        found += table(tmp_path, "title\na\n", template=template)
    assert found[0].sha256 != found[1].sha256


@pytest.mark.parametrize("text", ["/", ".", "..", "~", "*", "a\0b", "x" * 300, "x" * 5000, "\ud800"])
def test_hostile_cell_names_no_file(tmp_path: Path, text: str) -> None:
    cell = text.encode("utf-8", "surrogatepass") if text == "\ud800" else text.encode()
    if text == "\ud800":
        with pytest.raises(ProjectError, match="not UTF-8"):
            table(tmp_path, b"title\n" + cell + b"\n")
    else:
        (task,) = table(tmp_path, b"title\n" + cell + b"\n")
        assert task.title == text
        assert len(task.content or "") < 6000


def test_folder_gives_its_projects_and_no_results(tmp_path: Path) -> None:
    for name in ("b/project.toml", "a.toml", "b/project-results/project.toml", ".hidden/project.toml"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(project_toml(title=name))
    (tmp_path / "pyproject.toml").write_text("[project]\nname = 'other'\n")
    (tmp_path / "c").mkdir()
    (tmp_path / "c" / "project.toml").write_text("broken [")
    found = find_tasks(tmp_path)
    assert [task.key for task in found] == ["a.toml", "b/project.toml", "c/project.toml"]
    assert [task.title for task in found] == ["a.toml", "b/project.toml", ""]
    assert all(task.content is None and task.path.is_absolute() for task in found)


def test_source_and_template_must_fit(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match="no project below it"):
        find_tasks(tmp_path)
    with pytest.raises(ProjectError, match="add --template"):
        find_tasks(tmp_path / "walls.csv")
    with pytest.raises(ProjectError, match="leave out --template"):
        find_tasks(tmp_path, tmp_path / "template.toml")
    with pytest.raises(ProjectError, match=r"template.toml: no such file"):
        find_tasks(tmp_path / "walls.csv", tmp_path / "template.toml")
    (tmp_path / "template.toml").write_text(TEMPLATE)
    with pytest.raises(ProjectError, match=r"walls.csv: cannot be read"):
        find_tasks(tmp_path / "walls.csv", tmp_path / "template.toml")


def test_content_of_a_task_is_its_row_alone(tmp_path: Path) -> None:
    (task,) = table(tmp_path, f"id,{THICKNESS} [cm],title\nx,45,\n")
    where = {"table": str(tmp_path / "walls.csv"), "line": 2}
    assert json.loads(task.content or "") == {**where, "cells": [[THICKNESS, "45", "cm"]]}
    (moved,) = table(tmp_path, f"id,{THICKNESS} [cm],title\n\nx,45,\n")
    assert moved.sha256 == task.sha256


def test_tasks_are_counted_while_they_are_found(tmp_path: Path) -> None:
    write_file(tmp_path / "template.toml", TEMPLATE)
    (tmp_path / "walls.csv").write_text("title\n" + "a\n" * 3)
    counted: list[int] = []
    find_tasks(tmp_path / "walls.csv", tmp_path / "template.toml", progress=counted.append)
    assert counted == [1, 2, 3]
