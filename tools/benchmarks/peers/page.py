"""The tables as Markdown, and their place in docs/speed.md."""

from __future__ import annotations

import os
import platform
from datetime import UTC, datetime
from importlib.metadata import version
from pathlib import Path

from tools.benchmarks.peers.installed import Peer
from tools.benchmarks.peers.measure import Row, Table

PAGE = Path(__file__).parents[3] / "docs/speed.md"
BEGIN, END = "<!-- measured: written by `make peers` -->", "<!-- end of what is measured -->"
LEAST = 1e-14
"""An error of rounding, which has no digits to print."""
APART = "\N{NO-BREAK SPACE}"  # between a number and its unit, in cells that are narrow
OURS = ("numpy", "scipy", "numba")


def write(text: str, page: Path = PAGE) -> None:
    """Put the measured part into the page, in place of the old one."""
    before, rest = page.read_text(encoding="utf-8").split(BEGIN)
    after = rest.split(END)[1]
    page.write_text(f"{before}{BEGIN}\n\n{text}\n{END}{after}", encoding="utf-8")


def measured(tables: list[Table], peers: list[Peer], *, seconds: float, command: str) -> str:
    """Return the machine, the programs and every table."""
    return "\n".join([machine(peers, seconds=seconds, command=command), *map(markdown, tables)])


def machine(peers: list[Peer], *, seconds: float, command: str) -> str:
    """Return the date, the machine, the versions, and what did not load with its reason."""
    loaded = [f"{peer.package} {peer.said}" for peer in peers if peer.module is not None]
    missing = [f"- Left out, as it does not load: {peer.package} ({peer.said})." for peer in peers if not peer.module]
    load = f", load {os.getloadavg()[0]:.1f} at the start" if hasattr(os, "getloadavg") else ""
    ours = ", ".join(f"{name} {version(name)}" for name in OURS)
    return "\n".join([
        f"- {datetime.now(tz=UTC):%d %B %Y}, `{command}`, {seconds:.0f} s in all.",
        f"- {processor()}, {os.cpu_count()} cores{load}; {platform.system()}, Python {platform.python_version()}.",
        f"- This program {version('rocking-assess')} with {ours}; beside it {', '.join(loaded)}.",
        *missing,
        "",
    ])  # fmt: skip


def processor() -> str:
    """Return the processor's name, as Linux says it."""
    file = Path("/proc/cpuinfo")
    lines = file.read_text(encoding="utf-8").splitlines() if file.is_file() else []
    names = [line.partition(":")[2].strip() for line in lines if line.startswith("model name")]
    return names[0] if names else platform.processor() or platform.machine()


def markdown(table: Table) -> str:
    """Return a table with what it asks and how its times grow."""
    head = ["program", "setting", "least", "median", "times ours", "n", *table.error_titles]
    lines = [
        f"## {table.title}", "", table.asked, "",
        "| " + " | ".join(head) + " |",
        "|---|---|" + "---:|" * (len(head) - 2),
        *(line(row, len(table.error_titles)) for row in table.rows), "",
        *(f"- {each}" for each in table.growth), "",
    ]  # fmt: skip
    return "\n".join(lines)


def line(row: Row, count: int) -> str:
    """Return a row; an error that there is none of, as a program stopped, is a dash."""
    errors = [percent(each) for each in row.errors]
    cells = [
        row.program.name, row.program.setting, duration(row.least), duration(row.middle), times(row.times_ours),
        str(row.rounds), *errors, *["—"] * (count - len(errors)),
    ]  # fmt: skip
    return "| " + " | ".join(cells) + " |"


def percent(error: float) -> str:
    """Return a relative error to two digits."""
    return f"{100 * error:.2g}{APART}%" if abs(error) > LEAST else f"<{APART}1e-12{APART}%"


def duration(seconds: float) -> str:
    """Return seconds to three digits in a unit that suits them."""
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g}{APART}{unit}"
    return f"{seconds * 1e9:.3g}{APART}ns"


def times(ratio: float) -> str:
    """Return a ratio to two digits."""
    return f"{float(f'{ratio:.2g}'):,.3g}" if ratio < 1000 else f"{float(f'{ratio:.2g}'):,.0f}"
