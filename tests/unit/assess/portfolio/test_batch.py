"""A portfolio comes to the same table whatever happens on the way."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import pytest

from assess.errors import AssessError, FullDiskError, HeldError, OutputError
from assess.outputs.lock import LOCK, hold_lock
from assess.portfolio.batch import BatchOptions, Portfolio, Shard, open_ledger
from assess.portfolio.executors import processes
from assess.portfolio.tasks import ProjectRow
from assess.results.provenance import describe_program
from tests.support.places import SOURCES
from tests.support.portfolios import assess, table, task

HOSTILE = ("../../up", "a\0b", "=cmd()", "CON", "Wall", "wall", "x" * 3000, "é", "\ud800", "'; DROP TABLE rows; --", "")


def rows_of(place: Path) -> list[str]:
    with open_ledger(place / "ledger.sqlite") as ledger:
        return [row.key for _, row in ledger.rows() if row]


def test_a_full_disk_ends_the_portfolio_which_goes_on_with_resume(tmp_path: Path) -> None:
    """It is no fault of a project: no row says that one is broken."""
    order, log = BatchOptions(tmp_path / "out", "rows", resume=True), tmp_path / "log"
    with pytest.raises(FullDiskError, match=r"no space is left.* what is done is kept, and --resume goes on"):
        assess([task("a", f"count {log}"), task("b", "full")], order)
    assert not (tmp_path / "out" / "ranked.csv").exists()
    found = assess([task("a", f"count {log}"), task("b")], order)
    assert {row.status for row in found.rows} == {"done"}
    assert log.read_text().split().count("a") <= 2


def test_a_ledger_on_a_full_disk_keeps_its_rows(tmp_path: Path) -> None:
    """A database that may have no more pages answers as one on a disk without space."""
    kept, large = ("a", ProjectRow("a", "", "", "done")), ("b", ProjectRow("b", "t" * 50_000, "", "done"))
    path = tmp_path / "l.sqlite"

    def fill() -> None:
        with open_ledger(path) as ledger:
            ledger.put([kept])
            ledger._connection.execute("PRAGMA max_page_count = 3")
            ledger.put([large])

    with pytest.raises(FullDiskError, match=r"l\.sqlite: no space is left on the disk"):
        fill()
    with open_ledger(path) as ledger:
        assert list(ledger.rows()) == [kept]


def test_reasons_are_counted_whatever_their_numbers(tmp_path: Path) -> None:
    rows = [
        ProjectRow("a", "", "", "done", "the load is 0.25 m in the air", outcome="incomplete"),
        ProjectRow("b", "", "", "broken", "no such file"),
        ProjectRow("c", "", "", "done", "the load is 1.5 m in the air", outcome="incomplete"),
        ProjectRow("d", "", "", "done", outcome="pass"),
    ]
    counted = Portfolio(tuple(rows), 0, None).count_reasons()
    assert counted == [("the load is 0.25 m in the air", 2), ("no such file", 1)]


def test_a_broken_project_is_a_row_and_stops_nothing(tmp_path: Path) -> None:
    doings = ("wrong", "bug", "missing", "held", "")
    found = assess([task(what or "well", what) for what in doings], BatchOptions(tmp_path))
    wrong, bug, missing, held, well = found.rows
    assert (wrong.status, wrong.exit_code) == ("broken", 2)
    assert wrong.reason == "walls[3]: no such wall; give one"
    assert bug.exit_code == 70
    assert bug.reason == "internal error: ZeroDivisionError: a bug (log: logs/bug.log)"
    assert "ZeroDivisionError" in (tmp_path / "logs" / "bug.log").read_text()
    assert missing.exit_code == 2
    assert missing.reason.startswith("records/x.AT2: No such file")
    assert (held.exit_code, held.reason) == (2, "another writes there")
    assert well.status == "done"
    assert found.exit_code == 70
    assert found.count()["broken"] == 4


@pytest.mark.parametrize(
    ("codes", "worst"), [((0, 3, 1), 1), ((0, 3), 3), ((0,), 0), ((1, 2, 0), 2), ((2, 70), 70), ((), 0)]
)
def test_the_exit_code_is_the_worst(codes: tuple[int, ...], worst: int, tmp_path: Path) -> None:
    found = assess([task("a")], BatchOptions(tmp_path))
    assert replace(found, rows=tuple(replace(found.rows[0], exit_code=code) for code in codes)).exit_code == worst


def test_what_is_done_is_kept_and_what_changed_or_was_broken_is_not(tmp_path: Path) -> None:
    log, said = tmp_path / "log", list[str]()
    tasks = [task(key, f"count {log}") for key in "abc"]
    order = BatchOptions(tmp_path / "out", resume=True)
    assess([*tasks, task("d", "wrong")], order)
    assert sorted(log.read_text().split()) == ["a", "b", "c"]
    log.write_text("")
    assess([tasks[0], replace(tasks[1], sha256="ff0000"), tasks[2], task("d", f"count {log}")], order, said=said)
    assert sorted(log.read_text().split()) == ["b", "d"]
    assert "2 of 4 projects are done; 1 of other inputs" in said[0]


def test_without_resume_all_is_computed_again_and_that_is_said(tmp_path: Path) -> None:
    log, said = tmp_path / "log", list[str]()
    for _ in range(2):
        assess([task("a", f"count {log}")], BatchOptions(tmp_path / "out"), said=said)
    assert log.read_text() == "a\na\n"
    assert len(said) == 1
    assert "has 1 of an earlier run, which are computed again" in said[0]


def test_another_version_or_other_outputs_make_rows_old(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    log = tmp_path / "log"
    order = BatchOptions(tmp_path / "out", "rows", resume=True)
    tasks = [task("a", f"count {log}")]
    assess(tasks, order)
    assess(tasks, replace(order, keep="report"))
    program = replace(describe_program(), sha256="another")
    for module in ("batch", "tasks"):
        monkeypatch.setattr(f"assess.portfolio.{module}.describe_program", lambda: program)
    assess(tasks, order)
    assert log.read_text() == "a\n" * 3


def test_a_worker_of_another_version_stops_the_batch(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    program = replace(describe_program(), sha256="another")
    monkeypatch.setattr("assess.portfolio.batch.describe_program", lambda: program)
    with pytest.raises(AssessError, match="a worker runs another version"):
        assess([task("a")], BatchOptions(tmp_path / "out"))


def test_any_text_is_a_key(tmp_path: Path) -> None:
    found = assess([task(key, "bug") for key in HOSTILE], BatchOptions(tmp_path / "out"))
    assert [row.key for row in found.rows] == list(HOSTILE)
    assert len(list((tmp_path / "out" / "logs").iterdir())) == len(HOSTILE)
    assert [path.name for path in tmp_path.iterdir()] == ["out"]


def test_two_projects_with_one_key_are_refused(tmp_path: Path) -> None:
    with pytest.raises(AssessError, match="the key of two projects"):
        assess([task("a"), task("a")], BatchOptions(tmp_path / "out"))
    assert not (tmp_path / "out").exists()


def test_shares_make_the_table_of_the_whole_when_the_last_ends(tmp_path: Path) -> None:
    tasks = [task(str(n)) for n in range(40)]
    whole = assess(tasks, BatchOptions(tmp_path / "whole"))
    shares = [assess(tasks, BatchOptions(tmp_path / "shares", shard=Shard(number, 3))) for number in (2, 1, 3)]
    assert [share.table is None for share in shares] == [True, True, False]
    assert [share.left for share in shares[1:]] == [40 - sum(len(share.rows) for share in shares[:2]), 0]
    assert table(tmp_path / "shares") == table(tmp_path / "whole")
    assert max(share.exit_code for share in shares) == whole.exit_code
    assert assess(tasks, BatchOptions(tmp_path / "shares", resume=True)).rows == whole.rows
    assert rows_of(tmp_path / "shares") == []  # all were known from the shares


def test_a_share_without_projects_is_done(tmp_path: Path) -> None:
    shares = [assess([task("a")], BatchOptions(tmp_path, shard=Shard(number, 3))) for number in (1, 2, 3)]
    assert sorted(len(share.rows) for share in shares) == [0, 0, 1]
    assert shares[2].table is not None


def test_files_of_the_user_are_refused_before_anything_is_computed(tmp_path: Path) -> None:
    (tmp_path / "ranked.csv").write_text("mine")
    with pytest.raises(OutputError, match=r"ranked\.csv"):
        assess([task("a", f"count {tmp_path / 'log'}")], BatchOptions(tmp_path))
    assert not (tmp_path / "log").exists()


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_a_folder_that_cannot_be_written_is_an_error(tmp_path: Path) -> None:
    tmp_path.chmod(0o500)
    try:
        with pytest.raises((OutputError, PermissionError)):
            assess([task("a")], BatchOptions(tmp_path / "out"))
    finally:
        tmp_path.chmod(0o700)


def test_a_file_is_no_folder(tmp_path: Path) -> None:
    (tmp_path / "out").write_text("mine")
    with pytest.raises(OutputError, match="is a file"):
        assess([task("a")], BatchOptions(tmp_path / "out"))


def test_two_batches_at_once_in_one_folder_are_refused_and_two_shares_are_not(tmp_path: Path) -> None:
    with hold_lock(tmp_path, command="assess batch", name=f"{LOCK}-ledger.sqlite"):
        with pytest.raises(HeldError, match="assess batch"):
            assess([task("a")], BatchOptions(tmp_path))
        assert assess([task("a")], BatchOptions(tmp_path, shard=Shard(1, 2))).left in (0, 1)


def test_outputs_that_were_removed_are_made_again(tmp_path: Path) -> None:
    log = tmp_path / "log"
    found = assess([task("a", f"count {log}")], BatchOptions(tmp_path / "out"))
    with open_ledger(tmp_path / "out" / "ledger.sqlite") as ledger:
        identity = next(identity for identity, _ in ledger.rows())
        ledger.put([(identity, replace(found.rows[0], results="a/results.json"))])
    assess([task("a", f"count {log}")], BatchOptions(tmp_path / "out", resume=True))
    assert log.read_text() == "a\na\n"


def test_a_project_that_ends_its_process_is_a_row_and_the_others_are_done(tmp_path: Path) -> None:
    tasks = [task(str(n)) for n in range(12)]
    tasks[5:5] = [task("fatal", "killed"), task("once", f"once {tmp_path / 'seen'}")]
    found = assess(tasks, BatchOptions(tmp_path / "out", "rows"), engine=processes(2))
    assert [row.key for row in found.rows] == [each.key for each in tasks]
    broken = [row for row in found.rows if row.status == "broken"]
    assert [row.key for row in broken] == ["fatal"]
    assert (broken[0].exit_code, "alone and twice" in broken[0].reason) == (70, True)


@pytest.mark.parametrize("after", [1, 7, 19])
def test_killed_and_resumed_it_comes_to_the_same_bytes(after: int, tmp_path: Path) -> None:
    number, place = 20, tmp_path / "out"
    tasks = [task(str(n), "sleep 0.04") for n in range(number)]
    command = [sys.executable, "-m", "tests.support.portfolios", str(place), str(number), "0.04"]
    with subprocess.Popen(command, cwd=SOURCES, env={**os.environ, "PYTHONPATH": str(SOURCES)}) as process:
        deadline = time.monotonic() + 60
        while time.monotonic() < deadline and not ((place / "ledger.sqlite").exists() and _count(place) >= after):
            time.sleep(0.005)
        process.send_signal(signal.SIGKILL)
    assert process.returncode in (-signal.SIGKILL, 0)  # 0: on a busy machine it may end before it is struck
    kept = len(rows_of(place))
    assert kept >= after
    said: list[str] = []
    assess(tasks, BatchOptions(place, "rows", resume=True), said=said)
    assert f"{kept} of {number} projects are done" in said[0]
    assess(tasks, BatchOptions(tmp_path / "whole", "rows"))
    assert table(place) == table(tmp_path / "whole")
    assert [path.name for path in place.iterdir() if path.name.startswith(".assess-partial")] == []


def _count(place: Path) -> int:
    try:
        return len(rows_of(place))
    except OutputError:  # its table is about to be made
        return 0
