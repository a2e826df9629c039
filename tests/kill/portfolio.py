"""Kill `assess batch` many times at random moments, resume it each time, and compare the table with one never killed.

python tests/kill/portfolio.py TABLE.csv TEMPLATE.toml [KILLS] [SECONDS]: 20 kills if absent, each within SECONDS of the
start, 30 if absent. Between the first start and the last nothing of the portfolio is removed, so that every kill meets
what the one before it left. Ends with 1 where a byte differs.
"""

from __future__ import annotations

import contextlib
import random
import signal
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

NAMES = ("ranked.csv", "ranked.xlsx", "ranked.html")


def start(table: str, template: str, place: Path, after: float | None) -> tuple[int, str]:
    """Run the portfolio, killed after some seconds unless it has ended: exit code and stderr."""
    command = [sys.executable, "-m", "assess", "batch", table, "--template", template, "-o", str(place)]
    with subprocess.Popen(
        [*command, "--rows-only", "--resume"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True
    ) as process:
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.wait(after)
        if process.poll() is None:
            process.send_signal(signal.SIGKILL)
        return process.returncode if process.returncode is not None else process.wait(), process.communicate()[1]


def main(table: str, template: str, kills: str = "20", seconds: str = "30", seed: int = 1) -> int:
    """Kill, resume, compare, and print what each start found."""
    dice = random.Random(seed)
    with TemporaryDirectory(prefix="assess-portfolio-") as folder:
        killed, whole = Path(folder) / "killed", Path(folder) / "whole"
        for number in range(int(kills)):
            after = dice.uniform(0.2, float(seconds))
            code, told = start(table, template, killed, after)
            sys.stdout.write(f"{number + 1}: {after:.1f} s: ended with {code}; {told.strip()}\n")
            sys.stdout.flush()
        for place in (killed, whole):
            code, told = start(table, template, place, None)
            sys.stdout.write(f"{place.name}: ended with {code}; {told.strip()}\n")
        differ = [name for name in NAMES if (killed / name).read_bytes() != (whole / name).read_bytes()]
    sys.stdout.write(f"{kills} kills; {', '.join(differ) or 'no table'} differs\n")
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:5]))
