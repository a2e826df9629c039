"""A command is stopped before each of its steps on the disk: the folder has all of the old files, or all of the new."""

import json
import signal
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from assess.errors import OutputError
from assess.messages.message import Message
from assess.outputs import writing
from assess.outputs.lock import LOCK
from assess.outputs.manifest import MANIFEST
from assess.outputs.writing import recover_for_reading
from tests.support.files import contents_of, write_files, write_output
from tests.support.stopped_writers import StoppedWriters, stopped_writers

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="processes are copied, and ended by signals")

FIRST = {"results.json": "1", "report.pdf": "1", "tables/old.csv": "1", "figures/a.svg": "same"}
SECOND = {"results.json": "2", "report.pdf": "2", "tables/new.csv": "2", "figures/a.svg": "same"}
MINE = {"mine.txt": "mine", "tables/mine.csv": "mine"}
STEPS = 60  # more than there are


@pytest.fixture(scope="module")
def writers() -> Iterator[StoppedWriters]:
    with stopped_writers() as started:
        yield started


def hidden(folder: Path) -> list[str]:
    return [path.name for path in folder.iterdir() if path.name.startswith(".assess") and path.name != MANIFEST]


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGTERM, signal.SIGINT], ids=["KILL", "TERM", "INT"])
def test_a_stop_at_any_step_loses_nothing(tmp_path: Path, writers: StoppedWriters, number: int) -> None:
    ends = set()
    for at in range(1, STEPS):
        out = tmp_path / f"{at}"
        write_files(out, MINE)
        write_output(out, FIRST)
        status = writers.write(out, SECOND, at=at, number=number)
        if number != signal.SIGKILL:  # it cleans up behind itself
            assert set(hidden(out)) <= {LOCK}
        told: list[Message] = []
        recover_for_reading(out, tell=told.append)  # a command that reads
        found = {name: text for name, text in contents_of(out).items() if "partial" not in name}
        assert found in ({**FIRST, **MINE}, {**SECOND, **MINE}), f"step {at}"
        assert len(told) <= 1
        ends.add(found["results.json"])
        write_output(out, SECOND)  # one that writes
        assert contents_of(out) == {**SECOND, **MINE}
        assert hidden(out) == []
        if status == 0:
            break
    else:
        pytest.fail("there are more steps")
    assert at > 20
    assert ends == {"1", "2"}
    assert len(list(tmp_path.iterdir())) == at  # nothing was left beside


def test_a_new_folder_of_a_run_that_was_killed_is_used_again(tmp_path: Path, writers: StoppedWriters) -> None:
    for at in range(1, STEPS):
        out = tmp_path / f"{at}" / "out"
        status = writers.write(out, FIRST, at=at, number=signal.SIGKILL)
        write_output(out, SECOND)
        assert contents_of(out) == SECOND
        assert hidden(out) == []
        if status == 0:
            break


def test_making_good_may_be_stopped_too(tmp_path: Path, writers: StoppedWriters) -> None:
    for at in range(1, STEPS, 3):
        out = tmp_path / f"{at}"
        write_output(out, FIRST)
        writers.write(out, SECOND, at=at, number=signal.SIGKILL)
        for again in (2, 5, 8):
            writers.write(out, SECOND, at=again, number=signal.SIGKILL)
        recover_for_reading(out, tell=lambda _: None)
        found = {name: text for name, text in contents_of(out).items() if "partial" not in name}
        assert found in (FIRST, SECOND)
        write_output(out, FIRST)
        assert contents_of(out) == FIRST


def left_half_way(folder: Path, writers: StoppedWriters) -> Path:
    """A folder in which a run was killed after two of its files were in place; its stage."""
    write_output(folder, FIRST)
    for at in range(1, STEPS):
        if writers.write(folder, SECOND, at=at, number=signal.SIGKILL) == 0:
            pytest.fail("it was never half-way")
        texts = {(folder / name).read_text() for name in ("results.json", "report.pdf")}
        if texts == {"1", "2"}:
            (stage,) = folder.glob(".assess-partial-*")
            return stage
        write_output(folder, FIRST)
    raise AssertionError


def test_what_came_since_into_the_place_of_a_file_stays_and_nothing_is_lost(
    tmp_path: Path, writers: StoppedWriters
) -> None:
    out, told = tmp_path / "out", list[Message]()
    left_half_way(out, writers)
    (out / "report.pdf").write_text("signed meanwhile")
    recover_for_reading(out, tell=told.append)
    assert [each.key for each in told] == ["writing-taken-back"]
    assert contents_of(out) == {**FIRST, "report.pdf": "signed meanwhile"}
    beside = contents_of(tmp_path / "out-new-1")
    assert beside.pop("old/report.pdf", "1") == "1"
    assert beside.items() <= {**SECOND, "report.pdf": "2"}.items()
    assert hidden(out) == []


@pytest.mark.parametrize(
    "damage", ["", "{", '{"format": 2, "moves": []}', '{"format": 1, "moves": [{"name": "../x"}]}']
)
def test_a_damaged_journal_is_undone(tmp_path: Path, writers: StoppedWriters, damage: str) -> None:
    out, told = tmp_path / "out", list[Message]()
    stage = left_half_way(out, writers)
    (stage / writing.JOURNAL).write_text(damage)
    recover_for_reading(out, tell=told.append)
    assert [each.key for each in told] == ["writing-taken-back"]
    assert contents_of(out) == FIRST
    write_output(out, SECOND)
    assert contents_of(out) == SECOND


def test_a_new_file_that_is_damaged_in_its_stage_is_not_put_in_place(tmp_path: Path, writers: StoppedWriters) -> None:
    out = tmp_path / "out"
    stage = left_half_way(out, writers)
    (stage / "made" / "tables" / "new.csv").write_text("flipped")
    recover_for_reading(out, tell=lambda _: None)
    assert contents_of(out) == FIRST
    assert contents_of(tmp_path / "out-new-1")["tables/new.csv"] == "flipped"


def test_a_journal_cannot_lead_out_of_its_folder(tmp_path: Path) -> None:
    out = tmp_path / "out"
    journal = '{"format": 1, "moves": [{"name": "../precious", "new": null, "old": null}]}'
    write_files(tmp_path, {"precious": "x", "out/.assess-partial-x/journal.json": journal})
    recover_for_reading(out, tell=lambda _: None)
    assert contents_of(tmp_path) == {"precious": "x"}


def test_a_folder_that_is_read_is_not_written_where_nobody_was_stopped(tmp_path: Path) -> None:
    write_files(tmp_path, {".assess-partial-x/made/half": "x"})
    before = sorted(tmp_path.rglob("*"))
    recover_for_reading(tmp_path, tell=lambda _: pytest.fail("told"))
    recover_for_reading(tmp_path / "absent", tell=lambda _: pytest.fail("told"))
    assert sorted(tmp_path.rglob("*")) == before
    with pytest.raises(OutputError):
        write_output(tmp_path / ".assess-partial-x" / "made" / "half", FIRST)


def test_a_journal_does_not_reach_through_links(tmp_path: Path) -> None:
    """As in a folder that came from elsewhere."""
    out, home = tmp_path / "out", tmp_path / "home"
    stage = out / ".assess-partial-1"
    write_files(stage, {"old/tables/key": "theirs"})
    (stage / "made").mkdir()
    home.mkdir()
    (out / "tables").symlink_to(home)
    for moves in ([{"name": "tables/key", "new": None, "old": "x"}], "damaged"):
        (stage / "journal.json").write_text(json.dumps({"format": 1, "moves": moves}))
        with pytest.raises(OutputError, match="tables: is a link, which leads out of"):
            recover_for_reading(out, tell=lambda _: None)
    assert not list(home.iterdir())
