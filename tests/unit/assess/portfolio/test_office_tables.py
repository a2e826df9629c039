"""The table of an office as it is: its own headings, units and decimal commas, in CSV or a workbook."""

from __future__ import annotations

import csv
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZipFile

import pytest
from openpyxl import Workbook, load_workbook

from assess.errors import ProjectError
from assess.portfolio import tables as table_files
from assess.portfolio.projects import Task, find_tasks, project_tree, row_fault
from assess.portfolio.tables import point_for_comma
from assess.portfolio.tasks import ProjectRow
from assess.project.placement import elevation_at
from assess.project.project_file import load, load_tree
from assess.verbs import unit_fault
from reports.portfolio import write_ranking
from tests.support.files import write_file
from tests.support.projects import block, project_toml

MAPPED = """
[columns]
"Codice" = "id"
"Indirizzo" = "title"
"Spessore [cm]" = "bodies.wall.box.thickness"
"Altezza" = "bodies.wall.box.height [m]"
"Densità" = "materials.brick.density [kg/m^3]"
"Spinta [kN]" = "mechanisms.wall.loads.0.force"
"Proprietà" = "carry"
"""
PUSH = {"kind": "force", "force": "2 kN", "direction": [1, 0, 0], "at": [0.0, 0.0, 3.0]}
WALL = {"wall": {"material": "brick", "box": {"thickness": "0.60 m", "length": "3 m", "height": 4.0}}}
PLAIN = project_toml(bodies=WALL, mechanisms={"wall": block(loads=[PUSH])})
HEADER = ["Codice", "Indirizzo", "Spessore [cm]", "Altezza", "Densità", "Spinta [kN]", "Proprietà"]
ROW = ["V01", "Via dei Mulini 1, Bevagna", "62,5", "3,85", "1800", "2,1", '=HYPERLINK("http://x")']


def tasks_of(folder: Path, rows: list[list[str]], *, template: str = PLAIN + MAPPED) -> tuple[Task, ...]:
    lines = "\n".join(";".join('"' + cell.replace('"', '""') + '"' for cell in row) for row in rows)
    return find_tasks(write_file(folder / "t.csv", lines), write_file(folder / "t.toml", template), unit_fault)


def test_an_italian_table_needs_at_most_eight_lines(tmp_path: Path) -> None:
    assert len(MAPPED.strip().splitlines()) <= 8
    (task,) = tasks_of(tmp_path, [HEADER, ROW])
    content = load_tree(project_tree(task), task.path, sha256=task.sha256).content
    box = content.bodies["wall"].box  # type: ignore[union-attr]
    assert (task.key, task.title) == ("V01", "Via dei Mulini 1, Bevagna")
    assert (box.thickness, box.height) == pytest.approx((0.625, 3.85), rel=1e-12)
    assert content.materials["brick"].density == pytest.approx(1800.0)
    assert project_tree(task)["mechanisms"]["wall"]["loads"][0]["force"] == "2.1 kN"
    assert [heading for heading, _ in task.carried] == HEADER[2:]
    assert load(tmp_path / "t.toml").content.columns["Codice"] == "id"  # the template itself is a project


def test_what_is_carried_stands_beside_the_margin_and_is_no_formula(tmp_path: Path) -> None:
    (task,) = tasks_of(tmp_path, [[*HEADER[:-1], "Proprietà"], ROW])
    row = ProjectRow(task.key, task.title, task.sha256, "done", outcome="fail", margin=0.5, carried=task.carried)
    evil = ProjectRow("V02", "", "", "done", outcome="fail", margin=0.7, carried=(("=1+1", "+2"),))
    write_ranking([row, evil], tmp_path)
    with (tmp_path / "ranked.csv").open(encoding="utf-8", newline="") as file:
        header, first, *_ = csv.reader(file)
    at = header.index("Spessore [cm]")
    assert header[at - 1] == "Margin [-]"
    assert first[at : at + 2] == ["62,5", "3,85"]
    assert not any(cell.startswith(("=", "+")) for cell in (*header, *first))
    sheet = load_workbook(tmp_path / "ranked.xlsx").active
    assert {cell.data_type for row in sheet.iter_rows() for cell in row} <= {"s", "n", "inlineStr"}


def test_all_wrong_columns_are_told_at_once(tmp_path: Path) -> None:
    with pytest.raises(ProjectError) as caught:
        tasks_of(tmp_path, [["Codice", "Spessore [kg]", "Altitudine", ""], ["a", "1", "2", "3"]])
    with pytest.raises(ProjectError) as other:
        tasks_of(tmp_path, [["Codice", "Larghezza", "", "Spessore [cm]"], ["a", "1", "2", "3"]])
    for error, words in (
        (caught, ('"Altitudine": not a key', 'columns."Indirizzo": no such heading', 'columns."Spessore [cm]"')),
        (other, ('"Larghezza": not a key', "column 3: no name")),
    ):
        assert all(each in str(error.value) for each in words)
        assert "\n" not in str(error.value)


def test_others_are_carried_where_the_template_says_so(tmp_path: Path) -> None:
    template = PLAIN + '\n[columns]\n"*" = "carry"\n'
    (task,) = tasks_of(tmp_path, [["id", "title", "Note"], ["a", "b", "c"]], template=template)
    assert (task.key, task.title, task.carried) == ("a", "b", (("Note", "c"),))


def test_a_faulty_cell_is_told_by_its_heading(tmp_path: Path) -> None:
    (task,) = tasks_of(tmp_path, [HEADER, [*ROW[:2], "-1", *ROW[3:]]])
    with pytest.raises(ProjectError) as caught:
        load_tree(project_tree(task), task.path, sha256=task.sha256)
    assert 'line 2 ("V01"): column "Spessore [cm]": ' in row_fault(task, str(caught.value))


@pytest.mark.parametrize(
    ("text", "read"), [("0,55", "0.55"), ("-1,5 m", "-1.5 m"), ("3", "3"), ("0.550", "0.550"), ("12.5", "12.5")]
)
def test_decimal_commas(text: str, read: str) -> None:
    assert point_for_comma(text) == read


@pytest.mark.parametrize("text", ["1.250", "1.250,5", "1,250,000", "12.500 kg", "1,250.5"])
def test_what_may_part_thousands_is_refused(text: str) -> None:
    with pytest.raises(ProjectError, match="thousands"):
        point_for_comma(text)


def test_a_workbook_is_read_as_the_table_it_shows(tmp_path: Path) -> None:
    book, numbers = Workbook(), [62.5, 3.85, 1800, 2.1]
    book.active.append(HEADER)
    book.active.append([*ROW[:2], *numbers, "Comune"])
    book.save(tmp_path / "t.xlsx")
    (by_csv,) = tasks_of(tmp_path, [HEADER, [*ROW[:-1], "Comune"]])
    (by_book,) = find_tasks(tmp_path / "t.xlsx", tmp_path / "t.toml", unit_fault)
    assert project_tree(by_book) == project_tree(by_csv)
    assert dict(by_book.carried)["Spessore [cm]"] == "62.5"


def test_a_workbook_that_is_none_or_swells_is_one_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write_file(tmp_path / "t.toml", PLAIN)
    (tmp_path / "t.xlsx").write_bytes(b"no workbook")
    with pytest.raises(ProjectError, match="no workbook that can be read"):
        find_tasks(tmp_path / "t.xlsx", tmp_path / "t.toml")
    monkeypatch.setattr(table_files, "MOST_UNZIPPED", 1_000_000)
    with ZipFile(tmp_path / "t.xlsx", "w", ZIP_DEFLATED) as archive:
        archive.writestr("xl/worksheets/sheet1.xml", b" " * 2_000_000)
    with pytest.raises(ProjectError, match="unzipped it is larger than 1 MB"):
        find_tasks(tmp_path / "t.xlsx", tmp_path / "t.toml")


def test_loads_follow_the_height_of_their_wall(tmp_path: Path) -> None:
    """Walls of 3 and 5 m on a plinth of 0.5 m: top at 3.5 m, unless a cell says 4.2 m; a quarter at 1.25 and 1.75 m."""
    raised = {"wall": {**WALL["wall"], "box": {**WALL["wall"]["box"], "base": [0.0, 0.0, "50 cm"]}}}  # type: ignore[dict-item]
    text = project_toml(bodies=raised, mechanisms={"wall": block(loads=[PUSH, PUSH])})
    text += '\n[columns]\n"mechanisms.wall.loads.0.at.2" = "top"\n'
    rows = [["id", "bodies.wall.box.height", "mechanisms.wall.loads.1.at.2"], ["a", "3", "25 %"], ["b", "5,0 m", "25%"]]
    rows[0].append("mechanisms.wall.loads.0.at.2")
    rows[1:] = [[*row, cell] for row, cell in zip(rows[1:], ("", "4,2"), strict=True)]
    lines = "\n".join(";".join(row) for row in rows)
    files = write_file(tmp_path / "t.csv", lines), write_file(tmp_path / "t.toml", text)
    found = [project_tree(task) for task in find_tasks(*files, unit_fault, place_load=elevation_at)]
    heights = [[load["at"][2] for load in tree["mechanisms"]["wall"]["loads"]] for tree in found]
    assert heights == [["3.5 m", "1.25 m"], [4.2, "1.75 m"]]


def test_a_share_of_what_has_no_height_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match="is for the elevation of a load"):
        tasks_of(tmp_path, [["id"], ["a"]], template=PLAIN + '\n[columns]\n"mechanisms.wall.loads.0.at.0" = "top"\n')
    with pytest.raises(ProjectError, match="needs its bodies as box or profile"):
        elevation_at({"mechanisms": {"w": {"blocks": [["a"]]}}, "bodies": {"a": {"mesh": "a.stl"}}}, "w", 1.0)
