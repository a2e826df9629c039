"""Results that commands read again: damaged, edited, or left half-way by a run that was stopped."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any
from unittest.mock import Mock

import pytest

from tests.support.command import ended
from tests.support.projects import block, project_toml

PROJECT = project_toml(
    mechanisms={
        "wall": block(restitution=0.5, interface={"model": "flexible", "stiffness": "1 GPa/m", "strength": "2 MPa"})
    },
    analysis={
        "procedures": ["asce43-05-spectrum"],
        "pulses": {
            "shape": "sine",
            "frequency": {"from": "1 Hz", "to": "4 Hz", "count": 3},
            "amplitude": {"from": "0 g", "to": "2 g", "count": 4},
        },
        "sweep": {"key": "bodies.wall.box.height", "values": [4.0, 5.0]},
    },
)


@pytest.fixture(scope="module")
def outputs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("read")
    (folder / "wall.toml").write_text(PROJECT)
    assert ended("run", folder / "wall.toml", "-o", folder / "out", "--no-report", "--jobs", "1") in (0, 1, 3)
    return folder / "out"


@pytest.fixture
def results(outputs: Path, tmp_path: Path) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((outputs / "results.json").read_text())
    return found


COLUMNS: dict[str, tuple[str | int, ...]] = {
    "spectrum": ("spectrum", "acceleration_g"),
    "record": ("records", 0, "spectrum", "period_s"),
    "motion": ("ground_motion", "mean_g"),
    "curve": ("mechanisms", 0, "curve", "positive", "displacement_m"),
    "pga curve": ("mechanisms", 0, "checks", 0, "pga_curve", "pga_g"),
    "envelope": ("mechanisms", 0, "envelope", "lower_bound_g"),
    "envelope row": ("mechanisms", 0, "envelope", "overturned", 1),
    "envelope rows": ("mechanisms", 0, "envelope", "overturned"),
    "critical": ("critical", "mechanism"),
    "sweep": ("sweeps", 0, "outcome"),
    "view": ("mechanisms", 0, "view", "block_of"),
    "corner": ("mechanisms", 0, "view", "vertices"),
    "drawing": ("mechanisms", 0, "drawing", "block_of"),
    "displaced": ("mechanisms", 0, "drawing", "displaced", "block_of"),
    "simpler": ("mechanisms", 0, "interface_curves", "rigid", "restoring_n_m"),
}


def refused(path: Path, capsys: pytest.CaptureFixture[str], *words: str) -> None:
    """`report` and `diff` tell what is wrong in one line that names the file, and end with 2."""
    for arguments in (("report", path, "-o", path.parent / "again"), ("diff", path, path)):
        assert ended(*arguments) == 2, arguments
        err = capsys.readouterr().err
        assert err.startswith(f"assess: error: {path}: ")
        assert err.count("\n") == 1
        assert len(err) < 700
        assert all(word in err for word in words), err
    assert not (path.parent / "again").exists()


@pytest.mark.parametrize("column", COLUMNS)
def test_columns_of_unequal_length_are_refused(
    column: str, results: dict[str, Any], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    steps = COLUMNS[column]
    if column in ("drawing", "displaced"):
        results["mechanisms"][0]["drawing"]["block_of"].append(0)
        results["mechanisms"][0]["drawing"]["displaced"]["block_of"].append(0)
    else:
        column: Any = results
        for step in steps:
            column = column[step]
        assert len(column) > 1
        column.pop()
    path = tmp_path / "results.json"
    path.write_text(json.dumps(results))
    refused(path, capsys, str(steps[0]))


DAMAGE: dict[str, Callable[[str], str | bytes]] = {
    "empty": lambda _: "",
    "cut": lambda text: text[: len(text) // 2],
    "deep": lambda _: '{"project": ' + "[" * 100_000 + "]" * 100_000 + "}",
    "deep value": lambda t: t.replace('"given": false', '"given": false, "value": ' + "[" * 5000 + "]" * 5000, 1),
    "not UTF-8": lambda text: text.encode()[:50] + b"\xff" + text.encode()[50:],
    "a mark before it": lambda text: b"\xef\xbb\xbf" + text.encode("utf-16"),
    "nan": lambda text: text.replace('"dt_s": 0.', '"dt_s": NaN, "x": 0.', 1),
    "infinite": lambda text: text.replace('"dt_s": 0.', '"dt_s": 1e999, "x": 0.', 1),
    "long number": lambda text: text.replace('"schema_version": 2', f'"schema_version": {"2" * 5000}', 1),
    "list": lambda _: "[]",
    "number": lambda _: "7",
    "text for a number": lambda text: text.replace('"dt_s": 0.', '"dt_s": "x", "y": 0.', 1),
    "list for an object": lambda text: text.replace('"spectrum": {', '"spectrum": [], "x": {', 1),
    "no mechanisms": lambda text: text.replace('"mechanisms": [', '"mechanism": [', 1),
    "zeros": lambda text: b"\0" * len(text),
}


@pytest.mark.parametrize("damage", DAMAGE)
def test_damaged_results_are_refused(
    damage: str, outputs: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    changed = DAMAGE[damage]((outputs / "results.json").read_text())
    path = tmp_path / "results.json"
    path.write_bytes(changed if isinstance(changed, bytes) else changed.encode())
    refused(path, capsys)


def test_results_that_are_too_large_are_not_read(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "results.json"
    with path.open("wb") as file:
        file.truncate(1_000_000_000)
    refused(path, capsys, "1000 MB are more than the 500 MB that results may have")


@pytest.mark.skipif(sys.platform == "win32", reason="there are no pipes with a name")
def test_what_is_no_file_is_not_waited_for(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    os.mkfifo(tmp_path / "results.json")
    refused(tmp_path / "results.json", capsys, "not a regular file")


def test_what_does_not_fit_together_is_the_results_fault(
    results: dict[str, Any], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Names that nothing has: no list of rules has them all."""
    results["mechanisms"][0]["interfaces"][0] = {}
    path = tmp_path / "results.json"
    path.write_text(json.dumps(results))
    assert ended("report", path, "-o", tmp_path / "again") == 2
    assert f"{path}: its parts do not fit together (KeyError" in capsys.readouterr().err


def test_a_mistake_of_the_program_is_not_blamed_on_results_as_they_were_written(
    outputs: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:

    monkeypatch.setattr("assess.results.diff.differences", Mock(side_effect=ZeroDivisionError("a mistake")))
    assert ended("diff", outputs, outputs) == 70
    Path(capsys.readouterr().err.rpartition("(log: ")[2].rstrip(")\n")).unlink()


def test_edited_results_are_doubted_and_their_report_says_so(
    outputs: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    here, seen = tmp_path / "out", []
    assert ended("report", outputs / "results.json", "-o", here) == 0
    assert capsys.readouterr().err == ""
    text = (here / "results.json").read_text()
    (here / "results.json").write_text(text.replace('"warnings": [', '"warnings":  [', 1))
    assert ended("diff", here, outputs) == 0
    told = capsys.readouterr()
    assert told.err == (
        f"assess: warning: {here / 'results.json'}: these results have been changed since the program wrote "
        "them, so their numbers cannot be trusted; run the project again\n"
    )
    assert "their numbers cannot be trusted" in told.out
    monkeypatch.setattr("reports.assessment.write_all", lambda found, stage, **_: seen.append(found) or stage / "x")
    assert ended("report", here / "results.json") == 0
    assert [each.key for each in seen[0].warnings].count("results-changed") == 1
