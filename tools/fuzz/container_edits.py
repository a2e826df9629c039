"""Edits inside containers: members of zip archives, pages and the header of SQLite files."""

from __future__ import annotations

import io
import sqlite3
import tempfile
import zipfile
from pathlib import Path
from random import Random

from tools.fuzz import byte_edits
from tools.fuzz.fuzz_input import Edit, FuzzInput, rewritten


def zip_edits(random: Random, case: FuzzInput) -> tuple[Edit, ...]:
    """Bytes of the archive, a member's content, or its members as a whole."""
    if random.random() < 0.25:
        return byte_edits.edits(random, case)
    with zipfile.ZipFile(io.BytesIO(case.data)) as archive:
        members = {name: archive.read(name) for name in archive.namelist()}
    name = random.choice(sorted(members))
    verb = random.choices(("content", "lost", "twice", "renamed", "elsewhere", "swollen"), weights=(20, 1, 2, 2, 2, 1))[
        0
    ]
    where, what = f"member {name}", verb
    listed = [(each, data) for each, data in members.items() if verb != "lost" or each != name]
    if verb == "content":
        inner = FuzzInput("", "", {name: members[name]}, name, ())
        (edit, *_) = byte_edits.edits(random, inner)
        listed = [(each, inner.edited((edit,)).data if each == name else data) for each, data in listed]
        where, what = f"{where} {edit.where}", edit.what
    elif verb == "twice":
        listed.append((name, members[name][: len(members[name]) // 2]))
    elif verb in ("renamed", "elsewhere"):
        new = name.upper() if verb == "renamed" else f"../../{name}"
        listed = [(new if each == name else each, data) for each, data in listed]
    elif verb == "swollen":
        listed.append(("padding.xml", b" " * 50_000_000))
    return rewritten(case, _zipped(listed), where=where, what=what)


def _zipped(members: list[tuple[str, bytes]]) -> bytes:
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in members:
            known = name in archive.namelist()
            info = zipfile.ZipInfo(f"{name}\x20"[:-1] if known else name)
            info.compress_type = zipfile.ZIP_DEFLATED
            if not known:
                archive.writestr(info, data)
    return made.getvalue()


def sqlite_edits(random: Random, case: FuzzInput) -> tuple[Edit, ...]:
    """Bytes of the pages, cells by SQL, versions, tables lost and added."""
    if random.random() < 0.5:
        return byte_edits.edits(random, case)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "c"
        path.write_bytes(case.data)
        connection = sqlite3.connect(path)
        try:
            where, what = _altered(random, connection)
            connection.commit()
        except sqlite3.Error as error:
            where, what = "nothing", str(error)
        finally:
            connection.close()
        return rewritten(case, path.read_bytes(), where=where, what=what)


def _altered(random: Random, connection: sqlite3.Connection) -> tuple[str, str]:
    tables = [name for (name,) in connection.execute("SELECT name FROM sqlite_master WHERE type = 'table'")]
    table = random.choice([name for name in tables if not name.startswith("sqlite_")])
    columns = [row[1] for row in connection.execute(f'PRAGMA table_info("{table}")')]
    verb = random.choices(("cell", "version", "drop", "rows", "column", "view"), weights=(20, 2, 1, 2, 1, 1))[0]
    column = random.choice(columns)
    if verb == "cell":
        value = random.choice(
            (
                None,
                0,
                -1,
                1e300,
                float("inf"),
                "x",
                "",
                b"\xff\xfe\x00",
                "\ud7ff",
                2**62,
                "../../x",
                b"\x00" * 1288,
                "{}",
                "[1]",
            )
        )
        (total,) = connection.execute(f'SELECT COUNT(*) FROM "{table}"').fetchone()
        at = random.randrange(max(total, 1))
        what = f"row {at}: {str(value)[:30]!r}"
        connection.execute(
            f'UPDATE "{table}" SET "{column}" = ? WHERE rowid = (SELECT rowid FROM "{table}" LIMIT 1 OFFSET {at})',
            (value,),
        )
        return f"{table}.{column}", what
    if verb == "version":
        number, name = random.choice((0, 1, 2, 3, 999, -1)), random.choice(("user_version", "application_id"))
        connection.execute(f"PRAGMA {name} = {number}")
        return name, str(number)
    statement = {
        "drop": f'DROP TABLE "{table}"',
        "rows": f'DELETE FROM "{table}" WHERE rowid % 2',
        "column": f'ALTER TABLE "{table}" RENAME COLUMN "{column}" TO "renamed"',
        "view": "CREATE TABLE extra (a, b)",
    }[verb]
    connection.execute(statement)
    return table, statement
