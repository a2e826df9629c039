"""The memory of the server while a crack is dragged as often as in an hour, and a socket reads along."""

from __future__ import annotations

import os
import sys
import threading
import time
from math import radians, sin
from pathlib import Path

import pytest

pytest.importorskip("viser", reason="needs viser: .venv/serve of the Makefile")

from assess.examples import copy_example
from assess.page.page import open_page
from assess.page.server import PageServer
from tests.unit.assess.page.test_server import cookie, dial

DRAGS = int(os.environ.get("ASSESS_DRAGS", "36000"))  # of an hour at 10 Hz
PAUSE = 0.01  # s from one to the next
PATIENCE = 120.0  # s
SAMPLES = 12
MOST_GROWN = 60.0  # MB from the second sample on; a message kept for each drag would be some GB


@pytest.mark.study
@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="reads /proc")
def test_memory_does_not_grow_with_dragging(tmp_path, capsys):
    sizes = []
    with open_page(copy_example("house", tmp_path / "house")) as page:
        assert page.wait(PATIENCE)
        picked = next(name for name in page.opened.rank() if page.opened.cut_of(name) is not None)
        page.pick(picked)
        cut = page.opened.cut_of(picked)
        assert cut is not None
        read, done = [0], threading.Event()
        reader = threading.Thread(target=read_all, args=(page.server, read, done), daemon=True)
        reader.start()
        begun = time.monotonic()
        for number in range(DRAGS):
            if number % (DRAGS // SAMPLES) == 0:
                sizes.append(resident())
            x, y, z = cut.point
            page._dragged((x, y, z + 0.5 + 0.4 * sin(0.05 * number)), radians(10.0 * sin(0.031 * number)), False)
            time.sleep(PAUSE)
        assert page.wait(PATIENCE)
        sizes.append(resident())
        done.set()
        reader.join(PATIENCE)
        took = time.monotonic() - begun
    with capsys.disabled():
        held = ", ".join(f"{each:.0f}" for each in sizes)
        sys.stdout.write(
            f"\n{DRAGS} drags in {took:.0f} s, {read[0] / 1e6:.1f} MB read by the socket; resident [MB]: {held}\n"
        )
    assert read[0] > 0
    assert sizes[-1] - sizes[1] < MOST_GROWN


def resident() -> float:
    """Return the memory that this process holds [MB]."""
    return int(Path("/proc/self/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6


def read_all(server: PageServer, read: list[int], done: threading.Event) -> None:
    """Read what the server sends to a browser, as the browser does."""
    with dial(server, cookie=cookie(server)) as socket:
        while not done.is_set():
            try:
                read[0] += len(socket.recv(timeout=1.0))
            except TimeoutError:
                continue
