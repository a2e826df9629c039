"""Where the packages, the documents and real records are, in a checkout and where the wheel is what is tested."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

import assess

SOURCES = Path(assess.__file__).resolve().parents[1]
"""The folder of the four packages: the checkout, or site-packages."""
ROOT = Path(__file__).resolve().parents[2]
"""The folder of tests, documents and pyproject.toml."""
PACKAGES = ("assess", "records", "reports", "spectra")

REAL_RECORDS = Path(os.environ.get("ASSESS_RECORDS") or ROOT.parent / "shared" / "records")
"""Accelerograms of others, with their INDEX.csv, which may not be passed on."""
PEER = REAL_RECORDS / "peer_at2"
NO_RECORDS = "real records are not here: ../shared/records, or the folder that ASSESS_RECORDS names"
needs_real_records = pytest.mark.skipif(not (REAL_RECORDS / "INDEX.csv").exists(), reason=NO_RECORDS)


def place_of(path: str) -> Path:
    """Return the place of a path as documents write it, `assess/cli/analysis.py` or `docs/records.md`."""
    return (SOURCES if path.split("/")[0] in PACKAGES else ROOT) / path
