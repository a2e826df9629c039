"""Kill `assess batch` many times at random moments, resume it each time, and compare the table with one never killed.

python tools/kill/portfolio.py [KILLS] [SECONDS] [COPIES]: 20 kills if absent, each within SECONDS, 4 if absent, of the
start (every fourth) or of the first row that is written (the others), of COPIES of the example `street`, 15 if absent.
Between the first start and the last nothing of the portfolio is removed, so that every kill meets what the one before
it left. Ends with 1 where a byte differs.
"""

from __future__ import annotations

import contextlib
import csv
import random
import signal
import subprocess
import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory

NAMES = ("ranked.csv", "ranked.xlsx", "ranked.html")


def write_street(folder: Path, copies: int) -> Path:
    """Write the example with each façade several times, and return its table."""
    subprocess.run([sys.executable, "-m", "assess", "new", str(folder), "--example", "street"], check=True)
    table = folder / "street.csv"
    header, *rows = csv.reader(table.read_text(encoding="utf-8").splitlines())
    place = header.index("id")
    with table.open("w", encoding="utf-8", newline="") as file:
        many = ([*row[:place], f"{row[place]}-{n}", *row[place + 1 :]] for n in range(copies) for row in rows)
        csv.writer(file).writerows([header, *many])
    return table


def start(table: Path, place: Path, after: float | None, *, rows: bool = False) -> tuple[int, str]:
    """Run the portfolio until it ends, or until some seconds after its start or its first row: exit code, stderr."""
    command = [sys.executable, "-m", "assess", "batch", str(table), "--template", str(table.with_name("template.toml"))]
    ledger = place / "ledger.sqlite"
    before = changed(ledger)
    with subprocess.Popen(
        [*command, "-o", str(place), "--rows-only", "--resume"],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        while rows and process.poll() is None and changed(ledger) == before:
            time.sleep(0.01)
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(after)
        if process.poll() is None:
            process.send_signal(signal.SIGKILL)
        told = process.communicate()[1]
    return process.returncode, told


def changed(ledger: Path) -> int:
    """Return when a ledger was last written; 0 if it is absent."""
    return ledger.stat().st_mtime_ns if ledger.exists() else 0


def main(kills: int = 20, seconds: int = 4, copies: int = 15, seed: int = 1) -> int:
    """Kill, resume, compare, and print what each start found."""
    dice = random.Random(seed)
    with TemporaryDirectory(prefix="assess-portfolio-") as folder:
        killed, whole = Path(folder) / "killed", Path(folder) / "whole"
        table = write_street(Path(folder) / "street", copies)
        for number in range(kills):
            after = dice.uniform(0.0, seconds)
            code, told = start(table, killed, after, rows=number % 4 > 0)
            sys.stdout.write(f"{number + 1}: {after:.1f} s: ended with {code}; {told.strip()}\n")
            sys.stdout.flush()
        for place in (killed, whole):
            code, told = start(table, place, None)
            sys.stdout.write(f"{place.name}: ended with {code}; {told.strip()}\n")
        differ = [name for name in NAMES if (killed / name).read_bytes() != (whole / name).read_bytes()]
    sys.stdout.write(f"{kills} kills; {', '.join(differ) or 'no table'} differs\n")
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:4])))
