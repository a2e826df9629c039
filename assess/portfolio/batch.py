"""A portfolio assessed: its projects computed, each once, and their rows written as one ranked table.

The ledger keeps the rows computed so far in an SQLite file that outlives a kill at any moment. One process writes it,
the one that gives out the tasks. A row counts only under the identity of its job: with another input, another program
or other outputs it is computed again. It counts only as it was written: its seal is the SHA-256 of its text. Several
commands can divide a portfolio into shards, each with a ledger of its own.
"""

from __future__ import annotations

import hashlib
import json
import re
import sqlite3
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from dataclasses import asdict, dataclass
from pathlib import Path

from assess.errors import AssessError, FullDiskError, OutputError
from assess.outputs import manifest
from assess.outputs.lock import LOCK, hold_lock
from assess.outputs.writing import make_folder, output_folder, refuse_obstacles
from assess.portfolio.executors import Engine, compute_all
from assess.portfolio.projects import Task
from assess.portfolio.tasks import Job, Keep, ProjectRow, Runner
from assess.results.provenance import describe_program

COMMAND = "assess batch"
TABLE = "ranked.html"
WANTED = (TABLE, "ranked.xlsx", "ranked.csv")
WORST_CODES = (70, 2, 1, 3, 0)
"""Exit codes, the worst first."""
_NUMBERS = re.compile(r"[0-9]+(\.[0-9]+)?")
_SHARD = re.compile(r"([0-9]{1,6})/([0-9]{1,6})")
LEDGER_PATTERNS = ("ledger.sqlite", "ledger-*-of-*.sqlite")
"""Patterns of the names of ledgers."""
LEDGER_APPLICATION = 0x41534C47  # marks the file as ours
LEDGER_VERSION = 2  # 1 had no seals
WAIT_FOR_WRITER = 60.0  # s, to wait for another process that writes
TableWriter = Callable[[Sequence[ProjectRow], Path], object]
"""Writes the ranked table of rows into a folder."""


@dataclass(frozen=True)
class Shard:
    """One of `count` shares, by its number from 1. A project belongs to a share by the hash of its key alone."""

    number: int = 1
    count: int = 1

    def holds(self, key: str) -> bool:
        """Return whether the project of a key is of this share."""
        place = hashlib.sha256(key.encode("utf-8", "surrogatepass")).digest()[:8]
        return int.from_bytes(place) % self.count == self.number - 1

    @property
    def ledger(self) -> str:
        """The name of its ledger."""
        return "ledger.sqlite" if self.count == 1 else f"ledger-{self.number}-of-{self.count}.sqlite"


WHOLE = Shard()


def parse_shard(text: str) -> Shard:
    """Return the share that "i/n" names; raise AssessError for what names none."""
    found = _SHARD.fullmatch(text)
    if found is None or not 1 <= int(found[1]) <= int(found[2]):
        raise AssessError(f"--shard {text!r:.40}: give i/n, such as 1/8, with i from 1 to n")
    return Shard(int(found[1]), int(found[2]))


@dataclass(frozen=True)
class BatchOptions:
    """What a batch computes and writes, and where.

    place : folder of the outputs
    keep : what is written of each project
    shard : the share of the projects to be computed here
    resume : whether rows that are done are kept
    """

    place: Path
    keep: Keep = "report"
    shard: Shard = WHOLE
    resume: bool = False


@dataclass(frozen=True)
class Portfolio:
    """What a portfolio came to.

    rows : of this share, in the order of the projects
    left : number of projects of other shares that are not done yet; there is no table before they are
    table : the ranked table as a page; None while projects are left
    """

    rows: tuple[ProjectRow, ...]
    left: int
    table: Path | None

    @property
    def exit_code(self) -> int:
        """The worst exit code of its projects; 0 for a share without any."""
        found = {row.exit_code for row in self.rows}
        return next((code for code in WORST_CODES if code in found), 0)

    def count_reasons(self) -> Sequence[tuple[str, int]]:
        """Return why projects are incomplete or broken, the most frequent first, and of how many each is the reason.

        Reasons that differ in their numbers alone count as one, in the words of the first.
        """
        alike: dict[str, list[str]] = {}
        for row in self.rows:
            if row.reason:
                alike.setdefault(_NUMBERS.sub("0", row.reason), []).append(row.reason)
        return sorted(((each[0], len(each)) for each in alike.values()), key=lambda each: -each[1])

    def count(self) -> Mapping[str, int]:
        """Return how many are broken, and how many came to each outcome."""
        return Counter("broken" if row.status == "broken" else row.outcome or "no verdict" for row in self.rows)


def no_progress(done: int, total: int) -> None:
    """Show nothing."""


def run_batch(
    tasks: Sequence[Task],
    options: BatchOptions,
    *,
    runner: Runner,
    engine: Engine,
    write: TableWriter,
    tell: Callable[[str], None],
    progress: Callable[[int, int], None] = no_progress,
) -> Portfolio:
    """Assess the projects of a portfolio that are not done, and write the ranked table once all are.

    The table depends on the rows alone: not on interruptions, on the number of workers, or on where they are.

    Parameters
    ----------
    tasks : the whole portfolio, the same for every share
    options : what it computes and writes, and where
    runner : assesses one project, in a worker
    engine : opens the executor
    write : writes the ranked table
    tell : called with a line about what is found in the folder
    progress : called with the number of projects that are done, and of all of this share

    Raises
    ------
    AssessError : if two projects have one key, the folder cannot be written, or the executor is lost
    """
    program = describe_program().sha256
    jobs = {task.key: Job(task, options.place.absolute(), options.keep, program) for task in tasks}
    if len(jobs) < len(tasks):
        twice = next(key for key, number in Counter(task.key for task in tasks).items() if number > 1)
        raise AssessError(f"{twice!r:.100}: the key of two projects; give each its own")
    mine = [job for key, job in jobs.items() if options.shard.holds(key)]
    try:
        with _own_ledger(options) as ledger:
            done = _rows_to_keep(jobs, mine, ledger, options, tell)
            left = [job for job in mine if job.task.key not in done]
            _compute(left, len(mine), runner, engine, ledger, progress)
    except FullDiskError as error:
        raise FullDiskError(f"{error}; what is done is kept, and --resume goes on with it") from None
    rows = _known_rows(jobs, options)
    own = tuple(rows[job.task.key] for job in mine)
    if len(rows) < len(jobs):
        return Portfolio(own, len(jobs) - len(rows), None)
    with output_folder(
        options.place, command=COMMAND, owner=manifest.PORTFOLIO, expected=WANTED, patient=True
    ) as stage:
        write([rows[key] for key in jobs], stage)
    return Portfolio(own, 0, options.place / TABLE)


class Ledger:
    """An open ledger."""

    def __init__(self, connection: sqlite3.Connection, path: Path) -> None:
        self._connection = connection
        self.path = path

    def rows(self) -> Iterator[tuple[str, ProjectRow | None]]:
        """Yield each identity with its row, None for a row that is not as it was written, in the order of keys."""
        found = self._connection.execute("SELECT key, identity, row, seal FROM rows ORDER BY key")
        for key, identity, text, seal in found:
            yield _text_of(identity), _row_as_written(key, identity, text, seal)

    def put(self, rows: Iterable[tuple[str, ProjectRow]]) -> None:
        """Write rows, each with the identity of its job; all of them are on the disk afterwards, or none."""
        written = [(json.dumps(row.key), identity, json.dumps(asdict(row))) for identity, row in rows]
        with self._connection:
            self._connection.executemany(
                "INSERT OR REPLACE INTO rows (key, identity, row, seal) VALUES (?, ?, ?, ?)",
                [(*texts, _seal(*(each.encode() for each in texts))) for texts in written],
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
    OutputError : it cannot be written, is damaged, of a newer version, or no ledger; FullDiskError : no space is left
    """
    if path.is_symlink() or path.is_dir():
        raise OutputError(f"{path}: is no file of its own; move it away, or give another folder with -o")
    try:
        with closing(sqlite3.connect(path, timeout=WAIT_FOR_WRITER)) as connection:
            _prepare_ledger(connection, path)
            connection.text_factory = bytes  # whatever stands in it, a row that is not ours stops nothing
            yield Ledger(connection, path)
    except sqlite3.Error as error:
        if getattr(error, "sqlite_errorcode", None) == sqlite3.SQLITE_FULL:
            raise FullDiskError(f"{path}: no space is left on the disk; make room, or write elsewhere") from None
        raise OutputError(
            f"{path}: the ledger cannot be used ({error}); if the folder cannot be written give another with -o, and "
            "if the file is damaged delete it: its projects are then computed again"
        ) from None


@contextmanager
def _own_ledger(options: BatchOptions) -> Iterator[Ledger]:
    """Open the ledger of the share, which no other command may use meanwhile."""
    with make_folder(options.place):
        refuse_obstacles(options.place, manifest.read(options.place), manifest.PORTFOLIO, WANTED)
        name = options.shard.ledger
        with (
            hold_lock(options.place, command=COMMAND, name=f"{LOCK}-{name}"),
            open_ledger(options.place / name) as ledger,
        ):
            yield ledger


def _rows_to_keep(
    jobs: Mapping[str, Job], mine: Sequence[Job], ledger: Ledger, options: BatchOptions, tell: Callable[[str], None]
) -> Mapping[str, ProjectRow]:
    """Return the rows of this share that need not be computed; without `resume` begin the ledger anew."""
    found = sum(1 for _ in ledger.rows())
    if not options.resume:
        if found:
            tell(f"{ledger.path}: has {found} of an earlier run, which are computed again; --resume keeps what is done")
        ledger.clear()
        return {}
    known = _known_rows(jobs, options)
    done = {job.task.key: known[job.task.key] for job in mine if job.task.key in known}
    done = {key: row for key, row in done.items() if row.status == "done" and _has_outputs(row, options.place)}
    if found or done:
        own = {job.identity for job in jobs.values()}
        rows = [row for identity, row in ledger.rows() if identity in own]
        changed, edited = found - len(rows), rows.count(None)
        more = f"; {changed} of other inputs, options or versions of the program are not used" if changed else ""
        if edited:
            more += f"; {edited} changed in the ledger since they were written are computed again"
        tell(f"{ledger.path}: {len(done)} of {len(mine)} projects are done{more}")
    return done


def _has_outputs(row: ProjectRow, place: Path) -> bool:
    """Return whether the outputs that a row links to are still there."""
    return all((place / link).is_file() for link in (row.results, row.report) if link)


def _compute(
    left: Sequence[Job],
    total: int,
    runner: Runner,
    engine: Engine,
    ledger: Ledger,
    progress: Callable[[int, int], None],
) -> None:
    """Compute jobs, and enter their rows as they come."""
    done = total - len(left)
    progress(done, total)

    def keep(rows: Sequence[tuple[Job, ProjectRow]]) -> None:
        nonlocal done
        ledger.put([(job.identity, row) for job, row in rows])
        done += len(rows)
        progress(done, total)

    compute_all(left, total=len(left), runner=runner, engine=engine, keep=keep)


def _known_rows(jobs: Mapping[str, Job], options: BatchOptions) -> dict[str, ProjectRow]:
    """Return the rows of all ledgers of the folder, by key; of several of one project the first that is done."""
    names = {path.name for pattern in LEDGER_PATTERNS for path in options.place.glob(pattern)}
    known: dict[str, ProjectRow] = {}
    for name in sorted(names, key=lambda name: (name != options.shard.ledger, name)):
        with open_ledger(options.place / name) as ledger:
            for identity, row in ledger.rows():
                if row is None or row.key not in jobs or jobs[row.key].identity != identity:
                    continue
                if row.key not in known or known[row.key].status == "broken":
                    known[row.key] = row
    return known


def _text_of(found: object) -> str:
    return found.decode("utf-8", "replace") if isinstance(found, bytes) else ""


def _row_as_written(key: object, identity: object, text: object, seal: object) -> ProjectRow | None:
    """Return the row of the texts of the ledger; None unless they are those that were written."""
    if not (isinstance(key, bytes) and isinstance(identity, bytes) and isinstance(text, bytes)):
        return None
    if seal != _seal(key, identity, text).encode():
        return None
    try:
        return ProjectRow(**json.loads(text))
    except (ValueError, TypeError, RecursionError):
        return None


def _seal(*texts: bytes) -> str:
    """Return the SHA-256 of texts, each with its length."""
    return hashlib.sha256(b"".join(b"%d %b" % (len(text), text) for text in texts)).hexdigest()


def _prepare_ledger(connection: sqlite3.Connection, path: Path) -> None:
    """Make the table in an empty file; refuse a file that is newer or not ours."""
    connection.execute("PRAGMA journal_mode = DELETE")  # a log beside the file fails on disks of a network
    connection.execute("PRAGMA synchronous = FULL")
    connection.execute("BEGIN")  # one state of the file, which another process may be making
    application, version, tables = (
        int(connection.execute(query).fetchone()[0])
        for query in ("PRAGMA application_id", "PRAGMA user_version", "SELECT count(*) FROM sqlite_master")
    )
    connection.execute("COMMIT")
    if tables and application != LEDGER_APPLICATION:
        raise OutputError(f"{path}: not a ledger of a portfolio; move it away, or give another folder with -o")
    if version > LEDGER_VERSION:
        raise OutputError(
            f"{path}: a ledger of version {version}, made by a newer program; this one knows up to {LEDGER_VERSION}: "
            "use the newer program, or give another folder with -o"
        )
    if not tables:
        with connection:
            connection.execute("BEGIN")
            columns = "key TEXT PRIMARY KEY, identity TEXT, row TEXT, seal TEXT"
            connection.execute(f"CREATE TABLE IF NOT EXISTS rows ({columns})")
            connection.execute(f"PRAGMA application_id = {LEDGER_APPLICATION}")
            connection.execute(f"PRAGMA user_version = {LEDGER_VERSION}")
    elif version < LEDGER_VERSION:
        with connection:
            connection.execute("BEGIN IMMEDIATE")
            if "seal" not in {column[1] for column in connection.execute("PRAGMA table_info(rows)")}:
                connection.execute("ALTER TABLE rows ADD COLUMN seal TEXT")
            connection.execute(f"PRAGMA user_version = {LEDGER_VERSION}")
