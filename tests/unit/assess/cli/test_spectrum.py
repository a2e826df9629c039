"""`assess spectrum`: what it prints and draws, from a project and from options, and one line for bad input."""

import json
from dataclasses import fields
from pathlib import Path

import numpy as np
import pytest
from scipy.constants import g

from assess.project.build import build
from assess.project.project_file import load
from assess.results.json import dumps
from assess.study.run import run_study
from spectra.design_spectra import SPECTRA
from spectra.table import read_table
from tests.support.command import ended
from tests.support.projects import EC8, project_toml, published, tables_toml, write_project

PROJECT = tables_toml(
    site={"pga": "0.15 g", "spectrum": EC8 | {"damping": 0.08}},
    mechanisms={"quick": published(3.36, 0.34, 0.62, restitution=0.8)},
    records={"synthetic": {"count": 1, "duration": 8}},
    analysis={"procedures": ["asce43-05-spectrum"]},
)
OPTIONS = {
    "asce7-16": ["--s-s", "1.5 g", "--s-1", "0.6 g", "--site-class", "C", "--t-l", "8 s"],
    "ibc2009": ["--s-ds", "0.167 g", "--s-d1", "0.053 g", "--t-l", "6 s", "--hazard", "mce"],
    "ec8": ["--a-g", "0.25 g", "--ground-type", "E", "--type", "2", "--importance-factor", "1.2"],
    "nzs1170.5": ["--subsoil", "D", "--z", "0.3", "--return-period", "1000", "--near-fault-distance", "5 km"],
    "ts1170.5": ["--pga-site", "0.18 g", "--s-as", "0.38 g", "--t-c", "0.52 s", "--t-d", "2.8 s"],
    "ntc2018": ["--a-g", "2.5", "--f-0", "2.4", "--t-c-star", "0.3 s", "--soil", "C", "--topography", "T2"],
}
PGA = {  # by hand [g]: 0.4 x 2/3 x 1.2 x 1.5; 0.4 x 1.5 x 0.167; 0.25 x 1.6 x 1.2; 1.12 x 0.3 x 1.3; S_S S_T a_g
    "asce7-16": 0.48,
    "ibc2009": 0.1002,
    "ec8": 0.48,
    "nzs1170.5": 0.4368,
    "ts1170.5": 0.18,
    "ntc2018": 1.2 * (1.7 - 0.6 * 2.4 * 2.5 / g) * 2.5 / g,
}


@pytest.fixture
def project(tmp_path: Path) -> Path:
    return write_project(tmp_path, PROJECT, name="walls.toml")


def test_json_is_the_block_of_results(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("spectrum", project, "--json") == 0
    printed = json.loads(capsys.readouterr().out)
    assert printed == json.loads(dumps(run_study(build(load(project)), jobs=1)))["spectrum"]
    assert printed["pga_g"] == pytest.approx(0.15, rel=1e-12)
    assert printed["damping"] == 0.08
    assert printed["parameters"]["scale"] == pytest.approx(0.5, rel=1e-12)  # 0.15 g for a_g S = 0.3 g


@pytest.mark.parametrize("code", list(OPTIONS))
def test_every_code_by_its_options(code: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("spectrum", "--code", code, *OPTIONS[code], "--json") == 0
    printed = json.loads(capsys.readouterr().out)
    assert printed["code"] == code
    assert printed["pga_g"] == pytest.approx(PGA[code], rel=1e-9)


def test_the_table_shows_parameters_and_corners(capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("spectrum", "--code", "ec8", "--a-g", "0.25 g", "--ground-type", "B") == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "ec8: EN 1998-1:2004, 3.2.2.2, recommended values; damping 0.05, PGA 0.3 g"
    rows = [line.split() for line in lines]
    assert ["S,", "soil", "factor", "1.2", "-"] in rows
    assert ["0.15", "0.7500", "4.19"] in rows  # 0.75 x 9.80665 x (0.15 / 2 pi)^2 = 4.19 mm
    assert ["1", "0.3750", "93.15"] in rows


@pytest.mark.parametrize("code", list(OPTIONS))
def test_the_table_of_every_code_shows_its_parameters(code: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("spectrum", "--code", code, *OPTIONS[code]) == 0
    rows = [line.split() for line in capsys.readouterr().out.split("\n\n")[1].splitlines()]
    assert rows[0] == ["parameter", "value", "unit"]
    assert all(len(row) >= 3 for row in rows)
    words = [" ".join(row) for row in rows if row[0] == "hazard"]
    assert words == {"asce7-16": ["hazard design -"], "ibc2009": ["hazard maximum considered -"]}.get(code, [])


def test_csv_is_read_as_a_table(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("spectrum", "--code", "ec8", *OPTIONS["ec8"], "--csv") == 0
    (tmp_path / "own.csv").write_text(capsys.readouterr().out)
    table = read_table(tmp_path / "own.csv")
    assert table.acceleration([0.0, 10.0]) / g == pytest.approx([0.48, 0.48 * 2.5 * 0.25 * 1.2 / 100], rel=1e-12)
    assert ended("spectrum", "--code", "table", "--file", str(tmp_path / "own.csv"), "--csv") == 0
    again = np.loadtxt(capsys.readouterr().out.splitlines(), delimiter=",", skiprows=1)
    assert again[0] == pytest.approx([0.0, 0.48], rel=1e-12)


def test_pga_scales(capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("spectrum", "--code", "ec8", *OPTIONS["ec8"], "--pga", "0.12 g") == 0
    assert "PGA 0.12 g, ordinates scaled by 0.25" in capsys.readouterr().out


def test_vertical(capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("spectrum", "--code", "ec8", *OPTIONS["ec8"], "--vertical", "--json") == 0
    assert json.loads(capsys.readouterr().out)["pga_g"] == pytest.approx(0.45 * 0.30, rel=1e-12)


def test_a_site_that_needs_a_study_is_told_on_stderr(capsys: pytest.CaptureFixture[str]) -> None:
    options = [*OPTIONS["asce7-16"][:5], "D", *OPTIONS["asce7-16"][6:]]
    assert ended("spectrum", "--code", "asce7-16", *options, "--json") == 0
    captured = capsys.readouterr()
    assert "§11.4.8" in captured.err
    assert json.loads(captured.out)["parameters"]["f_v"] == pytest.approx(1.7, rel=1e-12)


@pytest.mark.parametrize(("ending", "start"), [("svg", b"<?xml"), ("pdf", b"%PDF"), ("PNG", b"\x89PNG")])
def test_figures_are_the_same_bytes_again(ending: str, start: bytes, tmp_path: Path) -> None:
    path = tmp_path / f"figure.{ending}"
    assert ended("spectrum", "--code", "ec8", *OPTIONS["ec8"], "-o", path) == 0
    first = path.read_bytes()
    assert first.startswith(start)
    assert ended("spectrum", "--code", "ec8", *OPTIONS["ec8"], "-o", path) == 0
    assert path.read_bytes() == first
    assert [each.name for each in tmp_path.iterdir()] == [path.name]


def test_help_names_every_code(capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("spectrum", "--help") == 0
    words = " ".join(capsys.readouterr().out.replace("\n", " ").split())
    assert all(code in words for code in SPECTRA)


EC8 = ["--code", "ec8", "--a-g", "0.25 g", "--ground-type", "B"]
WRONG = {
    "nothing": ([], "give a PROJECT, or --code"),
    "no parameters": (["--code", "ec8"], "--a-g: missing; reference peak ground acceleration"),
    "no unit": (["--code", "ec8", "--a-g", "0.25 h", "--ground-type", "B"], '--a-g: "0.25 h": "h" is not a unit'),
    "unknown code": (["--code", "ec9"], '--code: "ec9": not supported; write one of "asce7-05"'),
    "parameter of another code": ([*EC8, "--soil", "B"], '--soil: "B": unknown key'),
    "not a number": ([*EC8, "--importance-factor", "nan"], '--importance-factor: "nan": not a number'),
    "negative": (["--code", "ec8", "--a-g", "-1", "--ground-type", "B"], "--a-g: -1: must be greater than 0"),
    "line break": (["--code", "ec8", "--a-g", "1", "--ground-type", "B\n\x1b[2J"], "--ground-type: "),
    "special ground": (["--code", "ec8", "--a-g", "1", "--ground-type", "S1"], "3.1.2(4)P asks for a special study"),
    "both": (["walls.toml", "--a-g", "1"], "--a-g and PROJECT exclude each other"),
    "json and csv": ([*EC8, "--json", "--csv"], "--json and --csv exclude each other"),
    "figure of no kind": ([*EC8, "-o", "figure.doc"], "figure.doc: a figure is written as .svg, .pdf, .png"),
    "figure in no folder": ([*EC8, "-o", "/nowhere/figure.svg"], "/nowhere"),
    "no such file": (["--code", "table", "--file", "none.csv"], "no such file"),
    "no such project": (["none.toml"], "none.toml: no such file"),
    "no vertical": (["--code", "ibc2009", *OPTIONS["ibc2009"], "--vertical"], "ibc2009 has no vertical spectrum"),
    "bad pga": ([*EC8, "--pga", "0.1 s"], '--pga: "0.1 s": "s" is not a unit of acceleration'),
    "seconds for years": (
        ["--code", "nzs1170.5", "--subsoil", "D", "--z", "0.3", "--return-period", "5 s"],
        "write a duration like",
    ),
}


@pytest.mark.parametrize("case", WRONG)
def test_bad_input_is_one_line(case: str, capsys: pytest.CaptureFixture[str]) -> None:
    arguments, expected = WRONG[case]
    assert ended("spectrum", *arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.count("\n") == 1
    assert captured.err.startswith("assess: error: ")
    assert expected in captured.err


def test_a_project_without_a_site_says_so(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    project.write_text(PROJECT[PROJECT.index("[mechanisms") :], encoding="utf-8")
    assert ended("spectrum", project) == 2
    assert "site.spectrum: missing; add a table [site.spectrum]" in capsys.readouterr().err


@pytest.mark.parametrize(("code", "plateau", "corners"), [("ec8", 2.5, (0.05, 0.25)), ("asce7-16", 2.5, (0.1, 0.5))])
def test_corners_stand_among_the_ordinates(
    code: str, plateau: float, corners: tuple[float, float], capsys: pytest.CaptureFixture[str]
) -> None:
    """EN 1998-1 Table 3.3, ground E: T_B = 0.05, T_C = 0.25 s; ASCE 7-16: T_S = S_D1 / S_DS, T_0 = 0.2 T_S."""
    options = OPTIONS[code] if code == "ec8" else ["--s-ds", "1 g", "--s-d1", "0.5 g", "--t-l", "8 s"]
    assert ended("spectrum", "--code", code, *options, "--json") == 0
    found = json.loads(capsys.readouterr().out)
    period, ordinate = np.array(found["period_s"]), np.array(found["acceleration_g"])
    assert np.all(np.diff(period) > 0.0)
    for corner in corners:
        k = int(np.abs(period - corner).argmin())
        assert period[k] == pytest.approx(corner, rel=1e-12)
        assert ordinate[k] == pytest.approx(plateau * found["pga_g"], rel=1e-9)


def test_s_1_above_s_s_is_told(tmp_path: Path) -> None:
    path = tmp_path / "site.toml"
    site = {"code": "asce7-16", "s_s": "0.2 g", "s_1": "0.4 g", "site_class": "B", "t_l": "6 s"}
    path.write_text(project_toml(site={"spectrum": site}))
    assert any("exchanged" in notice.text for notice in build(load(path)).messages)


def test_what_no_site_has_is_told_on_stderr(capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("spectrum", "--code", "nzs1170.5", "--subsoil", "C", "--z", "0.55", "--r", "1.8", "--csv") == 0
    found = capsys.readouterr()
    assert "Z R = 0.55 × 1.8 = 0.99 is taken as 0.7" in found.err
    assert found.out.startswith("period [s],acceleration [g]")
    assert ended("spectrum", "--code", "nzs1170.5", "--subsoil", "C", "--z", "40", "--r", "1") == 2
    assert "z = 40" in capsys.readouterr().err


def test_a_number_that_was_rather_meant_in_g_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("spectrum", "--code", "ec8", "--a-g", "0.25", "--ground-type", "B") == 0
    assert '--a-g: 0.25 m/s2 is 0.0255 g; write "0.25 g"' in capsys.readouterr().err
    assert ended("spectrum", "--code", "ec8", "--a-g", "0.25 g", "--ground-type", "B") == 0
    assert capsys.readouterr().err == ""


def test_every_key_of_a_spectrum_is_an_option_but_those_of_a_hazard_over_return_periods() -> None:
    from inspect import signature

    from assess.cli.spectrum import NOT_KEYS
    from assess.cli.spectrum import spectrum as command
    from spectra.design_spectra import NtcOverYears

    ways = {way for of_code in SPECTRA.values() for way in of_code if not issubclass(way, NtcOverYears)}
    keys = {field.name for way in ways for field in fields(way)} | {"pga"}
    assert keys == set(signature(command).parameters) - {"context", *NOT_KEYS}
