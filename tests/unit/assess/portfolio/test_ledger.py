"""The ledger: rows as they were, in files that are ours, and rows that someone changed, which count for nothing."""

from __future__ import annotations

import json
import sqlite3
from dataclasses import asdict
from pathlib import Path

import pytest

from assess.errors import OutputError
from assess.portfolio.batch import LEDGER_VERSION, BatchOptions, open_ledger
from assess.portfolio.tasks import ProjectRow
from tests.support.portfolios import assess, table, task

WALL = ProjectRow("wall", "Great House", "12ab", "done", outcome="fail", margin=0.1 + 0.2, missing=2, exit_code=1)
HOSTILE = ProjectRow("'; DROP TABLE rows; --\ud800\0", "=1+1", "", "broken", reason="no\u2028line")


def test_rows_come_back_as_they_were(tmp_path: Path) -> None:
    with open_ledger(tmp_path / "l.sqlite") as ledger:
        ledger.put([("a", WALL), ("b", HOSTILE)])
    with open_ledger(tmp_path / "l.sqlite") as ledger:
        assert sorted(ledger.rows()) == [("a", WALL), ("b", HOSTILE)]
        ledger.put([("c", WALL)])
        assert sorted(ledger.rows()) == [("b", HOSTILE), ("c", WALL)]
        ledger.clear()
        assert list(ledger.rows()) == []


def test_a_newer_ledger_is_refused(tmp_path: Path) -> None:
    with open_ledger(tmp_path / "l.sqlite"):
        pass
    connection = sqlite3.connect(tmp_path / "l.sqlite")
    connection.execute(f"PRAGMA user_version = {LEDGER_VERSION + 1}")
    connection.close()
    with pytest.raises(OutputError, match="newer program"), open_ledger(tmp_path / "l.sqlite"):
        pass


def test_files_of_others_stay_as_they_are(tmp_path: Path) -> None:
    other, text = tmp_path / "other.sqlite", tmp_path / "text.sqlite"
    connection = sqlite3.connect(other)
    connection.execute("CREATE TABLE rows (mine TEXT)")
    connection.commit()
    connection.close()
    text.write_text("notes of a user, long enough for a header of a database" * 9)
    (tmp_path / "link.sqlite").symlink_to(text)
    for path in (other, text, tmp_path / "link.sqlite", tmp_path):
        before = path.read_bytes() if path.is_file() else b""
        with pytest.raises(OutputError, match=path.name), open_ledger(path):
            pass
        assert not path.is_file() or path.read_bytes() == before


EDITS = (
    "row = '{'",
    "row = '{}'",
    "row = '[]'",
    "row = 'null'",
    "row = NULL",
    "row = 7",
    "row = x'00ff80'",
    "row = json_set(row, '$.unknown', 1)",
    "row = json_set(row, '$.margin', 'five')",
    "row = json_set(row, '$.outcome', 'perhaps')",
    "row = json_set(row, '$.outcome', 'pass', '$.margin', 5.0, '$.exit_code', 0)",
    "row = json_set(row, '$.key', 'b')",
    "row = replace(row, '\"margin\": ', '\"margin\": 1')",
    "row = cast(x'ff' || row as text)",
    "key = 7",
    "key = x'ff'",
    "key = NULL",
    "seal = NULL",
    "seal = x'ff'",
    "seal = upper(seal)",
)


@pytest.mark.parametrize("edit", EDITS)
def test_a_row_that_someone_changed_is_computed_again_and_that_is_said(edit: str, tmp_path: Path) -> None:
    log, said, order = tmp_path / "log", list[str](), BatchOptions(tmp_path / "out", "rows", resume=True)
    tasks = [task(key, f"count {log}") for key in "ab"]
    assess(tasks, order)
    as_computed = table(tmp_path / "out")
    _execute(tmp_path / "out" / "ledger.sqlite", f"UPDATE rows SET {edit} WHERE key = '\"a\"'")
    log.write_text("")
    assess(tasks, order, said=said)
    assert log.read_text().split() == ["a"]
    assert "1 of 2 projects are done; 1 changed in the ledger since they were written" in said[0]
    assert table(tmp_path / "out") == as_computed


@pytest.mark.parametrize("identity", ["NULL", "7", "x'ff'", "'another'"])
def test_a_row_of_another_identity_is_of_other_inputs(identity: str, tmp_path: Path) -> None:
    log, said, order = tmp_path / "log", list[str](), BatchOptions(tmp_path / "out", "rows", resume=True)
    assess([task("a", f"count {log}")], order)
    _execute(tmp_path / "out" / "ledger.sqlite", f"UPDATE rows SET identity = {identity}")
    assess([task("a", f"count {log}")], order, said=said)
    assert log.read_text() == "a\na\n"
    assert "0 of 1 projects are done; 1 of other inputs" in said[0]


def test_a_ledger_of_the_version_without_seals_is_begun_anew(tmp_path: Path) -> None:
    path, text = tmp_path / "l.sqlite", json.dumps(asdict(WALL))
    with open_ledger(path) as ledger:
        ledger.put([("a", WALL)])
    for each in ("ALTER TABLE rows DROP COLUMN seal", "PRAGMA user_version = 1"):
        _execute(path, each)
    with open_ledger(path) as ledger:
        assert list(ledger.rows()) == [("a", None)]
        ledger.put([("a", WALL)])
        assert list(ledger.rows()) == [("a", WALL)]
    assert text in path.read_bytes().decode("latin-1")


def _execute(path: Path, statement: str) -> None:
    connection = sqlite3.connect(path)
    with connection:
        connection.execute(statement)
    connection.close()
