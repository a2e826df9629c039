"""`assess batch`: a table with a broken row, its outputs, its last lines, and its end by Ctrl-C."""

from __future__ import annotations

import csv
import json
import signal
from pathlib import Path
from unittest.mock import Mock

import pytest

import assess.verbs
from assess.geometry.solid import box
from assess.outputs.signals import Terminated
from tests.support.command import ended
from tests.support.mesh_files import gltf
from tests.support.projects import NTC, block, project_toml

TABLE = "id,title,bodies.wall.box.thickness\nthin,Thin,0.2\nThick,Thick,1.2\n../up,=1+1,thick\n"


@pytest.fixture
def street(tmp_path: Path) -> Path:
    site = {"limit_state": "SLV", "spectrum": NTC}
    one = {"synthetic": {"count": 1, "duration": "8 s"}}
    wall = project_toml(site=site, procedures={"ntc2018": {"knowledge_level": "LC3"}}, records=one)
    (tmp_path / "wall.toml").write_text(wall)
    (tmp_path / "street.csv").write_text(TABLE)
    return tmp_path


def test_a_table_is_ranked_and_each_project_has_its_results(street: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = street / "street-results"
    assert ended("batch", street / "street.csv", "--template", street / "wall.toml", "--no-report", "--jobs", 1) == 2
    said = capsys.readouterr()
    assert said.out.splitlines()[-1] == str(out / "ranked.html")
    assert said.out.startswith("3 projects: ")
    assert "1 broken" in said.out
    assert said.err == ""
    names = {path.name for path in out.iterdir()}
    assert {"ranked.html", "ranked.xlsx", "ranked.csv", "ledger.sqlite", "thin"} < names
    assert (out / "thin" / "results.json").is_file()
    assert not (out / "thin" / "report.pdf").exists()
    with (out / "ranked.csv").open(encoding="utf-8-sig", newline="") as file:
        text = file.read()
    assert len(list(csv.reader(text.splitlines()))) >= 4
    (street / "street.csv").write_text(TABLE.rpartition("../up")[0])
    arguments = ("batch", street / "street.csv", "--template", street / "wall.toml", "--no-report", "--jobs", 1)
    assert ended(*arguments, "--resume") in (0, 1, 3)
    assert "2 of 2 projects are done" in capsys.readouterr().err


def test_a_load_in_the_air_leaves_a_row_incomplete_and_says_so(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    load = {"kind": "mass", "mass": "500 kg", "at": [0.0, 0.0, 3.0], "seat": "0.15 m"}
    site = {"limit_state": "SLV", "spectrum": NTC}
    text = project_toml(
        site=site, procedures={"ntc2018": {"knowledge_level": "LC3"}}, mechanisms={"wall": block(loads=[load])}
    )
    (tmp_path / "wall.toml").write_text(text)
    (tmp_path / "t.csv").write_text("id,mechanisms.wall.loads.0.at.2\nin place,3.0\nlost,9.0\nlost too,9.5\n")
    arguments = ("batch", tmp_path / "t.csv", "--template", tmp_path / "wall.toml", "--rows-only", "--jobs", 1)
    ended(*arguments)
    said = capsys.readouterr().out
    with (tmp_path / "t-results" / "ranked.csv").open(encoding="utf-8-sig", newline="") as file:
        rows = {row["Project"]: row for row in csv.DictReader(file)}
    assert rows["lost"]["Outcome"] == "incomplete"
    assert "is in the air" in rows["lost"]["Reason"]
    assert "in the air" not in rows["in place"]["Reason"]
    assert f"\n  2 x {rows['lost']['Reason']}\n" in said


def test_another_buffer_of_a_gltf_is_computed_again(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    site = {"limit_state": "SLV", "spectrum": NTC}
    text = project_toml(
        site=site,
        bodies={"wall": {"material": "brick", "mesh": "m.gltf"}},
        mechanisms={"wall": block()},
        procedures={"ntc2018": {"knowledge_level": "LC3"}},
    )
    (tmp_path / "wall.toml").write_text(text)
    (tmp_path / "t.csv").write_text("id,title\na,Wall\n")
    for height in (4.0, 7.0):
        wall = box(thickness=0.5, length=2.0, height=height, base=(0.0, 0.0, 0.0), density=2000.0, name="wall")
        header, content = gltf(wall.vertices[:, [1, 2, 0]], wall.triangles, [{"mesh": 0, "name": "wall"}])
        header["buffers"][0]["uri"] = "m.bin"
        (tmp_path / "m.gltf").write_text(json.dumps(header))
        (tmp_path / "m.bin").write_bytes(content)
        ended("batch", tmp_path / "t.csv", "--template", tmp_path / "wall.toml", "--rows-only", "--jobs", 1, "--resume")
    assert "0 of 1 projects are done; 1 of other inputs" in capsys.readouterr().err


def test_what_is_asked_wrongly_is_one_line(street: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table, template = street / "street.csv", street / "wall.toml"
    for arguments, word in (
        ((table,), "--template"),
        ((table, "--template", template, "--shard", "3/2"), "--shard"),
        ((table, "--template", template, "--jobs", 1, "--scheduler", "tcp://127.0.0.1:9"), "--jobs"),
        ((street / "absent.csv", "--template", template), "absent.csv"),
        ((table, "--template", template, "-o", table), "is a file"),
    ):
        assert ended("batch", *arguments) == 2
        line = capsys.readouterr().err
        assert word in line
        assert line.count("\n") == 1


def test_ctrl_c_says_how_to_go_on(
    street: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(assess.verbs, "batch", Mock(side_effect=Terminated(signal.SIGINT)))
    assert ended("batch", street / "street.csv", "-o", street / "out") == 130
    assert capsys.readouterr().err.splitlines() == [
        f"assess: interrupted; what is done is kept in {street / 'out'}; go on with --resume",
    ]
