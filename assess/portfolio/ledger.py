"""The ledger of a portfolio: the rows computed so far, in an SQLite file that outlives a kill at any moment.

One process writes it, the one that gives out the tasks. A row counts only under the identity of its job: with another
input, another program or other outputs asked for it is computed again.
"""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Iterable, Iterator
from contextlib import closing, contextmanager
from dataclasses import asdict
from pathlib import Path

from assess.errors import OutputError
from assess.portfolio.row import Row

APPLICATION = 0x41534C47  # marks the file as ours
VERSION = 1
PATIENCE = 60.0  # s, to wait for another process that writes


class Ledger:
    """An open ledger."""

    def __init__(self, connection: sqlite3.Connection, path: Path) -> None:
        self._connection = connection
        self.path = path

    def rows(self) -> Iterator[tuple[str, Row]]:
        """Yield every row with the identity of its job, in the order of keys."""
        for identity, text in self._connection.execute("SELECT identity, row FROM rows ORDER BY key"):
            yield identity, Row(**json.loads(text))

    def put(self, rows: Iterable[tuple[str, Row]]) -> None:
        """Write rows, each with the identity of its job; all of them are on the disk afterwards, or none."""
        with self._connection:
            self._connection.executemany(
                "INSERT OR REPLACE INTO rows VALUES (?, ?, ?)",
                [
                    (json.dumps(row.key), identity, json.dumps(asdict(row))) for identity, row in rows
                ],  # keys of any text
            )

    def clear(self) -> None:
        """Remove every row."""
        with self._connection:
            self._connection.execute("DELETE FROM rows")


@contextmanager
def open_ledger(path: Path) -> Iterator[Ledger]:
    """Open a ledger, made if absent; close it at the end.

    Raises
    ------
    OutputError : it cannot be written, is damaged, of a newer version, or no ledger
    """
    if path.is_symlink() or path.is_dir():
        raise OutputError(f"{path}: is no file of its own; move it away, or give another folder with -o")
    try:
        with closing(sqlite3.connect(path, timeout=PATIENCE)) as connection:
            _prepare(connection, path)
            yield Ledger(connection, path)
    except sqlite3.Error as error:
        raise OutputError(
            f"{path}: the ledger cannot be used ({error}); if the folder cannot be written give another with -o, and "
            "if the file is damaged delete it: its projects are then computed again"
        ) from None


def _prepare(connection: sqlite3.Connection, path: Path) -> None:
    """Make the table in an empty file; refuse a file that is newer or not ours."""
    connection.execute("PRAGMA journal_mode = DELETE")  # a log beside the file fails on disks of a network
    connection.execute("PRAGMA synchronous = FULL")
    application, version, tables = (
        int(connection.execute(query).fetchone()[0])
        for query in ("PRAGMA application_id", "PRAGMA user_version", "SELECT count(*) FROM sqlite_master")
    )
    if tables and application != APPLICATION:
        raise OutputError(f"{path}: not a ledger of a portfolio; move it away, or give another folder with -o")
    if version > VERSION:
        raise OutputError(
            f"{path}: a ledger of version {version}, made by a newer program; this one knows up to {VERSION}: use the "
            "newer program, or give another folder with -o"
        )
    if not tables:
        with connection:
            connection.execute("BEGIN")
            connection.execute("CREATE TABLE IF NOT EXISTS rows (key TEXT PRIMARY KEY, identity TEXT, row TEXT)")
            connection.execute(f"PRAGMA application_id = {APPLICATION}")
            connection.execute(f"PRAGMA user_version = {VERSION}")
