"""A plugin of pytest that keeps how long each test took and whether it passed: `-p tools.mutate.coverage_plugin`."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

SECONDS = "MUTATE_SECONDS"
taken: dict[str, float] = {}
failed: set[str] = set()


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    """Add up setup, call and teardown."""
    taken[report.nodeid] = taken.get(report.nodeid, 0.0) + report.duration
    if report.outcome != "passed":
        failed.add(report.nodeid)


def pytest_sessionfinish() -> None:
    """Write the seconds of tests that passed; with xdist the workers have nothing to say."""
    if "PYTEST_XDIST_WORKER" not in os.environ:
        path = Path(os.environ[SECONDS])
        known = json.loads(path.read_text()) if path.exists() else {}
        known |= {name: seconds for name, seconds in taken.items() if name not in failed}
        path.write_text(json.dumps(known, indent=0))
