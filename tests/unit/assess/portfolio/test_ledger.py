"""The ledger: rows as they were, in files that are ours."""

from __future__ import annotations

import sqlite3
from pathlib import Path

import pytest

from assess.errors import OutputError
from assess.portfolio.batch import LEDGER_VERSION, open_ledger
from assess.portfolio.tasks import ProjectRow

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
