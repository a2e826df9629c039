"""`assess retrofit`: what it prints and writes, its exit codes, and names that try to be something else."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import pytest

from tests.support.command import ended, ended_with
from tests.unit.assess.project.test_retrofit import AREA, COUNT, facade

ASKED = ("--target", "index", "--reach", "1", "--vary", f"{AREA} = 80..200 mm^2 by 40", "--vary", f"{COUNT}=3..4")


def test_it_prints_the_least_and_writes_the_project(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path, out = facade(tmp_path), tmp_path / "out"
    assert ended("retrofit", path, *ASKED, "-o", out, "--jobs", 1) == 0
    shown = capsys.readouterr().out
    assert "least that is proved:\n  mechanisms.facade.ties.area = " in shown
    assert "target: index >= 1, SLV, of what the works change: facade\n" in shown
    assert "verdict of the project with these works: pass; its index, the worst of all its mechanisms: " in shown
    assert shown.endswith(f"{out / 'project.toml'}\n")
    assert ended("check", out) == 0
    assert ended("retrofit", path, *ASKED, "-o", out, "--jobs", 1) == 0  # its own files may be replaced


def test_tables_for_programs(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = facade(tmp_path)
    assert ended("retrofit", path, *ASKED, "--csv") == 0
    rows = list(csv.DictReader(io.StringIO(capsys.readouterr().out)))
    assert ended("retrofit", path, *ASKED, "--json") == 0
    found = json.loads(capsys.readouterr().out)
    assert len(rows) == len(found["layouts"]) == 8
    assert found["proved"]
    assert float(rows[-1]["index"]) == found["layouts"][-1]["index"]


def test_exit_codes(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = facade(tmp_path)
    beyond = [*ASKED[:3], "50", *ASKED[4:]]
    assert ended("retrofit", path, *beyond) == 1
    assert "none is proved to reach the target" in capsys.readouterr().out
    assert ended("retrofit", path, *ASKED[:4], "--vary", f"{AREA}=30000..40000 mm^2") == 1
    assert "refused 8 x, the first as cannot be built: " in capsys.readouterr().out
    for extra, said in (
        (("--vary", "area"), "write KEY=VALUE"),
        (("--vary", f"{COUNT}=5"), "twice"),
        (("--price", "steel=much"), "write a price from 0, such as 4"),
    ):
        code, line = ended_with(capsys, "retrofit", path, *ASKED, *extra)
        assert code == 2
        assert said in line


def test_hostile_names_stay_names(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    name = "a.b]\\u0007=cmd"
    path = facade(
        tmp_path, ("[mechanisms.facade]", f'[mechanisms."{name}"]'), ("mechanisms.facade.loads[1]", "materials.stone")
    )
    told = name.replace("\\u0007", "\x07")
    code = ended("retrofit", path, *ASKED[:4], "--vary", f"mechanisms.{told}.ties.area = 80 mm^2")
    said = capsys.readouterr()
    assert code in (1, 2)
    assert "\x07" not in said.out + said.err


def test_prices_of_the_file_are_switched_off(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = facade(tmp_path, ("[records]", '[analysis.retrofit]\nprices = { tie = "300 EUR" }\n[records]'))
    for more, head in (((), "cost [EUR]"), (("--price", "none"), "steel [kg]")):
        assert ended("retrofit", path, *ASKED, *more) == 0
        assert f"\n{head}  " in capsys.readouterr().out
