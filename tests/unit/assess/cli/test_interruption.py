"""Ctrl-C in real processes: exit code 130, one line on what stands, nothing half-written, no process left."""

from __future__ import annotations

import shutil
import signal
from pathlib import Path

import pytest

from tests.support.command import Interrupted, ended, interrupt
from tests.support.projects import write_blocks

pytestmark = pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="processes are counted in /proc")

COMMANDS = {
    "run": ("run", "PROJECT", "-o", "OUT"),
    "batch": ("batch", "FOLDER", "-o", "OUT", "--no-report"),
    "envelope": ("envelope", "PROJECT", "-o", "OUT"),
    "fragility": ("fragility", "PROJECT", "-o", "OUT"),
    "index": ("records", "index", "RECORDS", "--catalogue", "CATALOGUE"),
    "report": ("report", "RESULTS", "-o", "OUT"),
    "verify": ("verify", "-o", "OUT"),
}
STANDS = {
    "run": "nothing was written into ",
    "batch": "go on with --resume",
    "index": "the next run goes on from there",
    "report": "nothing was written into ",
}
STAGES = {
    "run": ("rocking histories", "tables"),
    "batch": ("projects",),
    "envelope": ("overturning envelopes", "tables"),
    "fragility": ("rocking histories", "fragility curves", "tables"),
    "index": ("records",),
    "report": ("tables",),
    "verify": ("cases", "annex"),
}
NOTHING = "nothing was written"
PULSES = {
    "amplitude": {"from": "0 g", "to": "4 g", "count": 120},
    "frequency": {"from": "0.4 Hz", "to": "9 Hz", "count": 150},
}


def interrupted(name: str, project: Path, out: Path, *, at: str, after: float = 0.0, group: bool = True) -> Interrupted:
    """Interrupt one of the commands; the places in its arguments are below `out`."""
    places = {
        "PROJECT": project,
        "FOLDER": project.parent.parent,
        "OUT": out / "made",
        "RECORDS": project.parent / "records",
        "CATALOGUE": out / "catalogue.sqlite",
        "RESULTS": project.parent / "project-results" / "results.json",
    }
    arguments = [places.get(word, word) for word in COMMANDS[name]]
    more = () if name == "report" else ("--jobs", 2)
    return interrupt(*arguments, *more, at=at, after=after, group=group)


@pytest.mark.parametrize(("name", "at"), [("run", "rocking histories"), ("index", "records")], ids=["run", "index"])
def test_ctrl_c_ends_a_command_and_its_workers(name: str, at: str, tmp_path: Path) -> None:
    project = write_blocks(tmp_path / "in" / "one", records=40 if name == "index" else 2, mechanisms=12, pulses=PULSES)
    out = tmp_path / "out"
    out.mkdir()
    found = interrupted(name, project, out, at=at)
    assert found.left == (), found
    assert found.code == 130, found
    assert "Traceback" not in found.screen
    assert found.line.startswith("assess: interrupted; "), found
    assert STANDS.get(name, NOTHING) in found.line
    if name not in ("batch", "index"):
        assert list(out.iterdir()) == []
    assert name != "index" or found.workers > 2


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A project with its results, among copies of it."""
    project = write_blocks(tmp_path_factory.mktemp("whole") / "one", records=24, mechanisms=10, pulses=PULSES)
    for number in range(4):
        shutil.copytree(project.parent, project.parent.with_name(f"copy-{number}"))
    assert ended("run", "-q", project, "--no-report") in (0, 1, 3)
    return project


@pytest.mark.study
@pytest.mark.parametrize("group", [True, False], ids=["group", "alone"])
@pytest.mark.parametrize("after", [0.0, 0.3])
@pytest.mark.parametrize(
    ("name", "at"),
    [(name, "") for name in COMMANDS] + [(name, at) for name, stages in STAGES.items() for at in stages],
    ids=lambda word: word or "start",
)
def test_ctrl_c_at_any_moment(name: str, at: str, after: float, group: bool, whole: Path, tmp_path: Path) -> None:
    found = interrupted(name, whole, tmp_path, at=at, after=after if at else 4.0 * after + 0.5, group=group)
    assert found.left == (), found
    made = sorted(path.name for path in tmp_path.glob("made/*"))
    if found.code != 130:  # it had done its work, or Python was ending
        assert found.code in (0, 1, 3, -signal.SIGINT), found
    elif name == "index":
        assert ended("records", "index", whole.parent / "records", "--catalogue", tmp_path / "catalogue.sqlite") == 0
    elif name == "batch":
        assert ended("batch", whole.parent.parent, "-o", tmp_path / "made", "--resume", "--no-report") in (0, 1, 3)
    else:
        assert made == [], found
    if found.code == 130:
        assert "Traceback" not in found.screen
        assert found.line.startswith("assess: interrupted"), found
