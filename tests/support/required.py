"""What the environment must have: tests that would be skipped for want of it fail instead.

`ASSESS_REQUIRE=browser,cad` is for machines that are set up for it, where a skipped test would hide that they are not.
"""

from __future__ import annotations

from collections.abc import Mapping

import pytest

REASONS: Mapping[str, str] = {
    "browser": "needs chromium",
    "cad": "the extra '",
    "dask": "could not import 'distributed'",
    "records": "real records are not here",
}
"""By name: words of the reason for which tests are skipped where it is missing."""
REQUIRED = pytest.StashKey[tuple[str, ...]]()


def names_required(text: str) -> tuple[str, ...]:
    """Return the names in a list with commas.

    Raises
    ------
    pytest.UsageError : a name is not known
    """
    found = tuple(name.strip() for name in text.split(",") if name.strip())
    for name in found:
        if name not in REASONS:
            raise pytest.UsageError(f"ASSESS_REQUIRE={text}: {name} is not known; choose among {', '.join(REASONS)}")
    return found


def fail_if_required(report: pytest.TestReport | pytest.CollectReport, required: tuple[str, ...]) -> None:
    """Make a skip into a failure where it is for want of something `required`."""
    if report.skipped and not hasattr(report, "wasxfail") and isinstance(report.longrepr, tuple):
        reason = str(report.longrepr[2])
        for name in required:
            if REASONS[name] in reason:
                report.outcome = "failed"
                report.longrepr = f"{name} is required by ASSESS_REQUIRE: {reason}"
