"""The command line from outside: exit codes, one line for bad input, help at once, outputs whole or not at all."""

import hashlib
import json
import subprocess
import sys
from pathlib import Path
from unittest.mock import Mock

import pytest

from assess.errors import MechanismError
from assess.examples import EXAMPLES, source
from records.errors import RecordError
from spectra.errors import SpectrumError
from tests.support.command import ended
from tests.support.projects import ASCE7, project_toml, tables_toml, wall

COMMANDS = ("new", "check", "run", "parameters", "spectrum", "geometry", "report", "diff", "schema")
SITE = tables_toml(site={"spectrum": ASCE7})
WALL = project_toml(site=None, bodies={"wall": wall(height="4 m")})


def snapshot(folder: Path) -> dict[str, str]:
    return {
        str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else "folder"
        for path in folder.rglob("*")
    }


HEAVY = {
    "numpy",
    "scipy",
    "numba",
    "pandas",
    "matplotlib",
    "pydantic",
    "pint",
    "reportlab",
    "shapely",
    "trimesh",
    "obspy",
}


@pytest.mark.parametrize(
    "arguments", [["--help"], ["run", "--help"], ["spectrum", "--help"], ["records", "convert", "--help"]]
)
def test_help_loads_nothing_heavy(arguments: list[str]) -> None:
    """What it then takes is measured by tools/benchmarks/bench_growth.py."""
    told = "import atexit, sys; atexit.register(lambda: print(*sys.modules, file=sys.stderr))"
    program = f"{told}; from assess.cli import main; main()"
    done = subprocess.run([sys.executable, "-c", program, *arguments], capture_output=True, text=True, check=True)
    assert not {name.split(".")[0] for name in done.stderr.split()} & HEAVY


def test_a_command_loads_what_it_needs(tmp_path: Path) -> None:
    """A rigid wall has splines but no joints and no histories; a schema has neither."""
    told = "import atexit, sys; atexit.register(lambda: print(*sys.modules, file=sys.stderr))"
    program = f"{told}; from assess.cli import main; main()"
    project = tmp_path / "project.toml"
    project.write_text(WALL, encoding="utf-8")
    for arguments, unneeded in (
        (["schema"], {"numba", "matplotlib", "scipy.interpolate", "scipy.optimize", "scipy.spatial", "scipy.sparse"}),
        (["parameters", str(project)], {"numba", "matplotlib", "reportlab"}),
    ):
        done = subprocess.run([sys.executable, "-c", program, *arguments], capture_output=True, text=True, check=True)
        assert not set(done.stderr.split()) & unneeded, arguments


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_has_help(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended(command, "--help") == 0
    assert f"Usage: assess {command}" in capsys.readouterr().out


def test_python_finds_the_command_by_the_packages_name() -> None:
    done = subprocess.run([sys.executable, "-m", "assess", "--version"], capture_output=True, text=True, check=True)
    assert done.stdout.startswith("assess ")


def test_version(capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("--version") == 0
    assert capsys.readouterr().out.startswith("assess 0.")


@pytest.mark.parametrize(
    "arguments", [["nonsense"], ["run"], ["run", "x", "--jobs", "0"], ["new"], ["check", "--x"], ["check"]]
)
def test_wrong_usage_ends_with_2(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert ended(*arguments) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("assess: error: ")
    assert captured.err.endswith("--help`\n")
    assert captured.err.count("\n") == 1


def test_no_command_prints_the_help(capsys: pytest.CaptureFixture[str]) -> None:
    assert ended() == 2
    assert "Commands:" in capsys.readouterr().out


def test_examples_are_listed(capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("new", "--list") == 0
    assert [line.split()[0] for line in capsys.readouterr().out.splitlines()] == list(EXAMPLES)


def test_a_project_begins_with_the_smallest_wall(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("new", str(tmp_path / "wall")) == 0
    file = tmp_path / "wall" / "project.toml"
    assert capsys.readouterr().out == f"{file}\n"
    assert file.read_text(encoding="utf-8").endswith(
        (source("single_wall") / "project.toml").read_text(encoding="utf-8")
    )


def test_schema_is_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert ended("schema") == 0
    assert json.loads(capsys.readouterr().out)["additionalProperties"] is False


BAD_PROJECTS: dict[str, str | bytes] = {
    "unknown key": SITE + WALL + "[sight]\n",
    "wrong dimension": SITE + WALL.replace('"4 m"', '"4 s"'),
    "nan": SITE + WALL.replace('"4 m"', "nan"),
    "negative thickness": SITE + WALL.replace("0.6", "-0.6"),
    "duplicate names": SITE + WALL + "[bodies.wall]\nmass = 1\n",
    "unknown code": SITE.replace("asce7-16", "uniform") + WALL,
    "no records": SITE + WALL + '[records]\nfiles = ["*.AT2"]\n',
    "empty record": SITE + WALL + '[records]\nfiles = ["empty.AT2"]\n',
    "junk record": SITE + WALL + '[records]\nfiles = ["junk.AT2"]\n',
    "junk mesh": SITE + WALL.replace("box = {", 'mesh = "junk.stl" #'),
    "missing mesh": SITE + WALL.replace("box = {", 'mesh = "missing.stl" #'),
    "junk spectrum": WALL + '[site.spectrum]\ncode = "table"\nfile = "junk.csv"\n',
    "hinge outside": SITE + WALL + "direction = [1, 0, 0]\nhinges = { A = [-50, 0, 0] }\n",
    "binary junk": bytes(range(256)) * 9,
    "empty file": "",
}


@pytest.mark.parametrize("command", ["check", "run", "parameters"])
@pytest.mark.parametrize("case", BAD_PROJECTS)
def test_bad_input_is_a_line_for_each_fault_and_leaves_nothing(
    case: str, command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    content = BAD_PROJECTS[case]
    path = tmp_path / "project.toml"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    for name in ("junk.AT2", "junk.stl", "junk.csv"):
        (tmp_path / name).write_bytes(bytes(range(256)) * 3)
    (tmp_path / "empty.AT2").write_bytes(b"")
    before = snapshot(tmp_path)
    assert ended(command, path) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    first, *others = captured.err.splitlines()
    assert all(line.startswith("assess: error: ") for line in (first, *others))
    assert first.endswith(f" (and {len(others)} more)") or not others
    assert "Traceback" not in captured.err
    assert snapshot(tmp_path) == before


@pytest.mark.parametrize("command", ["check", "run", "parameters", "report"])
@pytest.mark.parametrize("path", ["missing", "", "folder"])
def test_missing_input_is_one_line(command: str, path: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "folder").mkdir()
    assert ended(command, tmp_path / path) == 2
    assert capsys.readouterr().err.count("\n") == 1
    assert snapshot(tmp_path) == {"folder": "folder"}


def test_error_in_its_own_process_has_no_traceback(tmp_path: Path) -> None:
    """The installed entry point, with a hostile file name."""
    bad = tmp_path / "a\nb\x1b[31m.toml"
    bad.write_text("[[[")
    done = subprocess.run(
        [sys.executable, "-c", "from assess.cli import main; main()", "run", str(bad)], capture_output=True, text=True
    )
    assert done.returncode == 2
    assert done.stdout == ""
    assert done.stderr.startswith("assess: error: ")
    assert done.stderr.count("\n") == 1
    assert "\x1b" not in done.stderr


@pytest.mark.parametrize(
    "error", [MechanismError("m: x"), RecordError("m: x"), SpectrumError("m: x"), OSError(13, "m: x")]
)
def test_errors_of_the_user_end_with_2(
    error: Exception, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("assess.project.build.build", Mock(side_effect=error))
    assert ended("check", source("single_wall")) == 2
    assert capsys.readouterr().err.startswith("assess: error: m: x")


def test_bug_ends_with_70_and_a_log(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr("assess.project.build.build", Mock(side_effect=ZeroDivisionError("a\nbug")))
    assert ended("check", source("single_wall")) == 70
    err = capsys.readouterr().err
    assert err.startswith("assess: internal error: ZeroDivisionError: a bug (log: ")
    assert err.count("\n") == 1
    log = Path(err.rpartition("(log: ")[2].rstrip(")\n"))
    assert "Traceback" in log.read_text()
    log.unlink()


def test_interrupt_ends_with_130(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("assess.project.build.build", Mock(side_effect=KeyboardInterrupt()))
    assert ended("check", source("single_wall")) == 130
